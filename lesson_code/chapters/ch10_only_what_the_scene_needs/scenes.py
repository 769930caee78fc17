"""Chapter 10: scenes, what a guessed plan scores, bits that differ, and islands that sleep."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.effects.choice import choose_effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.measures import SUNK
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, HALF_LENGTH
from lesson_code.formulas.validation import one_number, positive
from lesson_code.geometry.shapes import Circle, Polygon, Segment

DT = 1 / 60
"""s."""


def side_by_side() -> Scene:
    """Return two smooth discs that fly side by side and meet nothing."""
    return Scene([Body(Circle(1), mass=1.0, position=(x, 0), velocity=(1, 0)) for x in (0, 5)])


def thrown(shape: Circle | Polygon, friction: float) -> Scene:
    """Return a body that comes down on a smooth floor, obliquely, without gravity."""
    floor = Body(Segment((-9, 0), (9, 0)), material=Material(0.5, 0.0))
    moving: dict[str, Any] = {"position": (0, 1.5), "velocity": (1, -1), "mass": 1.0}
    return Scene([floor, Body(shape, **moving, material=Material(0.5, friction))])


def heavy_on_light() -> Scene:
    """Return a thin wall, a heavy ball that comes at 4 m/s, and a light one at rest before it."""
    surface = Material(restitution=1.0, friction=0.0)
    heavy = Body(Circle(0.5), mass=100, position=(-1, 0), velocity=(4, 0), material=surface)
    light = Body(Circle(0.05), mass=0.01, material=surface)
    wall = Body(Segment((1.45, -1), (1.45, 1)), material=surface)
    return Scene([wall, heavy, light])


GUESSED = ("gravity", "friction", "restitution", "rotation", "manifolds", "continuous")
"""The effects that a reader guesses."""


def score(guess: Collection[str], scene: Scene) -> str:
    """Say how many of the effects in :data:`GUESSED` a guess has right, but not which.

    Parameters
    ----------
    guess : collection of str
        The effects that 2 s of the scene are said to call for.
    scene : Scene
        Is not run.

    Raises
    ------
    ValueError
        The guess names something else.

    Examples
    --------
    >>> score({"rotation"}, side_by_side())
    '5 of 6 right'
    """
    if other := sorted({*guess} - {*GUESSED}):
        raise ValueError(f"guess must name some of {', '.join(GUESSED)}, got {other[0]!r}")
    question = Question(scene, duration=2.0)
    used = {choice.name for choice in choose_effects(question) if choice.used}
    right = sum((name in guess) == (name in used) for name in GUESSED)
    return f"{right} of {len(GUESSED)} right"


STATES = ("positions", "velocities", "angles", "angular_velocities")
"""What a run says of its bodies at each time."""


def bits_of(run: Run) -> int:
    """Return how many bits all states of a run have."""
    return 8 * sum(int(getattr(run, name).nbytes) for name in STATES)


def bits_apart(run: Run, other: Run) -> int:
    """Return how many bits differ between the states of two runs.

    Raises
    ------
    ValueError
        They do not have as many states of as many bodies.
    """
    if run.positions.shape != other.positions.shape:
        shapes = f"{run.positions.shape} and {other.positions.shape}"
        raise ValueError(f"run and other must have positions of one shape, got {shapes}")
    pairs = ((getattr(run, name), getattr(other, name)) for name in STATES)
    numbers = ((np.ascontiguousarray(a), np.ascontiguousarray(b)) for a, b in pairs)
    return sum(
        int(np.bitwise_count(a.view(np.uint64) ^ b.view(np.uint64)).sum()) for a, b in numbers
    )


def verdicts(scene: Scene, *names: str) -> str:
    """Return what becomes of some effects in 2 s of a scene, and why, a line for each."""
    return "\n".join(
        f"   {choice.name}: {choice.verdict}; {choice.reason}"
        for choice in choose_effects(Question(scene, duration=2.0))
        if choice.name in names
    )


def three_towers() -> Scene:
    """Return three towers of three boxes each, and a disc that rolls up to the first at 4 m/s.

    Body 0 is the floor, and the disc is the last body.
    """
    surface = Material(restitution=0.0, friction=0.5)
    floor = Body(Segment((-HALF_LENGTH, 0), (HALF_LENGTH, 0)), material=surface)
    pitch = 1 - 2 * SUNK
    boxes = [
        Body(
            Polygon.box(1, 1),
            position=(x, 0.5 - SUNK + n * pitch),
            mass=1.0,
            material=surface,
        )
        for x in (-4, 0, 4)
        for n in range(3)
    ]
    disc = Body(Circle(0.4), position=(-16, 0.4), velocity=(4, 0), mass=1.0, material=surface)
    return Scene([floor, *boxes, disc], gravity=(0, -GRAVITY))


def asleep_in_time(scene: Scene, duration: float) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return the ends of all steps, s, shape (F,), and who sleeps then, shape (F, N).

    Parameters
    ----------
    scene : Scene
        Is run by the sequential solver, in steps of 1/60 s.
    duration : float
        s, > 0.
    """
    seconds = one_number("duration", duration, positive)
    stepper = EngineStepper(
        scene,
        solver="sequential",
        dt=DT,
        iterations=10,
        substeps=1,
        combine=MixingRule(),
        duration=seconds,
    )
    steps = round(seconds / DT)
    asleep = np.zeros((steps, len(scene.bodies)), dtype=bool)
    for row in asleep:
        stepper.advance(1)
        row[:] = [body.is_asleep for body in stepper.world.bodies]
    return np.array([DT * n for n in range(1, steps + 1)]), asleep
