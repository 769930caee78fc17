"""Scenes of the demo, each with a question; the answer comes when everybody has seen it."""

from __future__ import annotations

from dataclasses import dataclass

from lesson_code.engine.core.scene import XY
from lesson_code.geometry.shapes import Circle, Polygon, Shape


@dataclass(frozen=True)
class Scene:
    """Bodies, e and mu of all, and what to think about before it is seen.

    Attributes
    ----------
    question, answer : str
        A line each.
    bodies : tuple of (shape, position, velocity)
        m and m/s.
    restitution, friction : float
        Of all bodies and walls.
    """

    question: str
    answer: str
    bodies: tuple[tuple[Shape, XY, XY], ...]
    restitution: float
    friction: float = 0.0


SCENES = {
    "1": Scene(
        "A wall at rest: does it change the momentum of the bodies, their energy, or both?",
        "The momentum at every impact; the energy only where e < 1, or where friction rubs.",
        (
            (Circle(0.30), (1.2, 4.8), (1.6, -0.7)),
            (Circle(0.40), (3.0, 4.6), (-0.9, 1.1)),
            (Circle(0.25), (5.0, 4.9), (1.2, 0.8)),
            (Circle(0.35), (6.6, 4.4), (-1.5, -0.4)),
            (Circle(0.20), (1.4, 2.6), (2.0, 1.5)),
            (Polygon.regular(3, 0.55), (3.4, 2.0), (0.8, 0.9)),
            (Polygon.box(0.8, 0.8), (6.0, 1.8), (-1.0, 0.6)),
        ),
        restitution=0.8,
        friction=0.2,
    ),
    "2": Scene(
        "A ball hits one of four times its mass, e = 1. Which of them is faster afterwards?",
        "The light one, backwards: -3/5 and 2/5 of the speed. (m1 - m2)/(m1 + m2), 2 m1/(m1 + m2)",
        ((Circle(0.3), (1.2, 3.0), (2.0, 0.0)), (Circle(0.6), (4.5, 3.0), (0.0, 0.0))),
        restitution=1.0,
    ),
    "3": Scene(
        "A ball hits the end of a plank at rest. Does the plank turn on the spot?",
        "No: J moves its centre by J/m wherever it acts, and turns it as well by r x J / I.",
        ((Circle(0.3), (1.2, 4.0), (2.0, 0.0)), (Polygon.box(0.3, 2.4), (4.0, 3.0), (0.0, 0.0))),
        restitution=1.0,
    ),
    "4": Scene(
        "Equal balls, one at rest, e = 0: what is left of the energy after they have met?",
        "Half: both go on at half the speed, 2 m (v/2)^2 / 2. Momentum is all there.",
        ((Circle(0.4), (1.2, 3.0), (2.0, 0.0)), (Circle(0.4), (4.0, 3.0), (0.0, 0.0))),
        restitution=0.0,
    ),
}
"""By key."""

ANSWER_STEPS = 240
"""Steps from the question to the answer."""
