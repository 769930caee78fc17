"""A scene in which islands fall asleep, and one of them is woken."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.measures import SUNK
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, HALF_LENGTH
from lesson_code.formulas.validation import one_number, positive
from lesson_code.geometry.shapes import Circle, Polygon, Segment

DT = 1 / 60
"""s."""


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
