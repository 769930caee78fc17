"""Hard cases: simultaneous impacts of many bodies, whose outcome the laws leave open."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import STEP, TOUCH, largest, last_velocities
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.reference import impact_closed_forms as closed

THEME = "Many bodies at once"

SEQUENTIAL = {"solver": "auto", "impacts": "sequential"}


def cradle(moving: int, *, from_right: bool = False) -> Scene:
    """Return five elastic balls in touch; some of them come from one side at 1 m/s."""
    scene = disc_scenes.row_of_discs(5, -TOUCH)
    way = -1.0 if from_right else 1.0
    comes = range(5 - moving, 5) if from_right else range(moving)
    return Scene(
        replace(ball, velocity=(way if n in comes else 0.0, 0.0))
        for n, ball in enumerate(scene.bodies)
    )


def cradle_error(trial: Trial) -> float:
    """Return the largest error of a velocity over 1 to 4 balls, from both sides, m/s."""
    worst = 0.0
    for moving in range(1, 5):
        for from_right in (False, True):
            scene = cradle(moving, from_right=from_right)
            expected = [ball.velocity[0] for ball in reversed(scene.bodies)]
            found = last_velocities(trial, 0.1, scene)
            worst = max(worst, largest(found[:, 0] - expected))
    return worst


def cradle_at_once_error(trial: Trial) -> float:
    """Return the largest error of a velocity against Newton's rule for all at once, m/s."""
    found = last_velocities(trial, STEP)[:, 0]
    return largest(found - closed.cradle_all_at_once(5, 1.0))


def break_error(trial: Trial) -> float:
    """Return the largest error of a velocity, whichever ball the scene lists first, m/s."""
    cue, upper, lower = closed.break_shot(1.0, 1.0)
    worst = 0.0
    for first in (True, False):
        scene = disc_scenes.cue_between_two(upper_first=first)
        expected = [cue, upper, lower] if first else [cue, lower, upper]
        worst = max(worst, largest(last_velocities(trial, STEP, scene) - np.array(expected)))
    return worst


def two_balls(ratio: float = 10.0) -> Scene:
    """Return a heavy ball on the floor and a light one on it, both moving down at 1 m/s."""
    smooth = Material(restitution=1.0)
    falling: dict[str, Any] = {"velocity": (0, -1), "material": smooth}
    return Scene(
        [
            Body(Segment((-5, 0), (5, 0)), material=smooth),
            Body(Circle(0.5), mass=ratio, position=(0, 0.5 - TOUCH), **falling),
            Body(Circle(0.25), mass=1.0, position=(0, 1.25 - 2 * TOUCH), **falling),
        ]
    )


def two_ball_error(trial: Trial) -> float:
    """Return the largest error of both velocities, m/s."""
    expected = [float(v) for v in closed.two_ball_drop(10.0, 1.0, 1.0)]
    found = last_velocities(trial, STEP)[1:, 1]
    return largest(np.sort(found) - np.sort(expected))


def three_on_a_line() -> Scene:
    """Return three balls, e = 0.05: the outer two approach the one in the middle.

    Below e = 7 - 4 sqrt 3 such balls hit each other infinitely often in a finite time.
    """
    dull = Material(restitution=0.05)
    starts = [(-1.5, 1.0), (0.0, 0.0), (1.75, -1.0)]
    return Scene(
        Body(Circle(0.5), mass=1.0, position=(x, 0), velocity=(v, 0), material=dull)
        for x, v in starts
    )


def spread_of_speeds(trial: Trial) -> float:
    """Return the largest difference of two velocities after 3 s, m/s."""
    return float(np.ptp(last_velocities(trial, 3.0)[:, 0]))


CASES = (
    HardCase(
        name="cradle",
        theme=THEME,
        title="Newton's cradle: 1 to 4 balls, from both sides",
        why="Momentum and energy leave it open how five balls share; hard balls go one by one.",
        law="One after the other: as many leave as came",
        scene=partial(cradle, 1),
        measure=cradle_error,
        unit="m/s",
        bound=1e-6,
        reason="a sequence ends at a millionth of the first approach",
        ours=SEQUENTIAL,
        failed_by=("pymunk", "box2d"),
    ),
    HardCase(
        name="cradle-at-once",
        theme=THEME,
        title="The same with all contacts at the same instant",
        why="The other rule keeps momentum and energy too; an engine has to say which it has.",
        law="Newton's e in every contact: -3/5, and four times 2/5",
        scene=partial(cradle, 1),
        measure=cradle_at_once_error,
        unit="m/s",
        bound=1e-8,
        reason="the balls overlap by 1e-9 m",
        options={"dt": STEP},
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="break-shot",
        theme=THEME,
        title="A cue ball between two touching balls, in both orders",
        why="The ball that is visited first is given more.",
        law="Symmetry, momentum, energy: the cue comes back with 1/5",
        scene=partial(disc_scenes.cue_between_two, upper_first=True),
        measure=break_error,
        unit="m/s",
        bound=1e-8,
        reason="the balls overlap by 1e-9 m",
        options={"dt": STEP},
        failed_by=("naive",),
    ),
    HardCase(
        name="two-ball-drop",
        theme=THEME,
        title="A light ball on a heavy one, dropped together",
        why="The light one flies off only if the heavy one has bounced before they meet.",
        law="v' = (3 M - m) / (M + m) v = 29/11 v",
        scene=two_balls,
        measure=two_ball_error,
        unit="m/s",
        bound=1e-6,
        reason="a sequence ends at a millionth of the first approach",
        ours=SEQUENTIAL,
        options={"dt": STEP},
        failed_by=("pymunk", "box2d"),
    ),
    HardCase(
        name="collapse",
        theme=THEME,
        title="Three dull balls on a line, e = 0.05",
        why="Infinitely many hits in a finite time: going from hit to hit has no end.",
        law="e < 7 - 4 sqrt 3 = 0.0718: they end with one velocity",
        scene=three_on_a_line,
        measure=spread_of_speeds,
        unit="m/s",
        bound=1e-6,
        reason="a millionth of the speed that they came with",
        ours=SEQUENTIAL,
    ),
)
