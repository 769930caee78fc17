"""Hard cases: loads and towers. Each sweep carries a force up or down by one body."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import (
    drift,
    fastest,
    largest,
    pair_forces,
    relative_errors,
    way_of,
)
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.geometry.shapes import Polygon, Segment
from lesson_code.reference.rigid_body_closed_forms import stack_forces

THEME = "Loads and towers"

SUNK = 4e-4
"""m: initial overlap of bodies of 1 m, so that they touch from the start. Every engine here
tolerates that much."""

DT = 1 / 60
"""s."""

LOAD = 1e6
"""kg, on a box of 1 kg."""

NOT_SEEN = 1e-3
"""m: a thousandth of the size of a body, too small to see."""

NO_DRIFT = "a thousandth of a box; what comes further in this time does not stand"


def tower(
    masses: Sequence[float],
    *,
    restitution: float = 0.0,
    friction: float = 0.5,
    aside: float = 0.0,
    at: float = 0.0,
) -> Scene:
    """Return boxes of 1 m, one on the other, on a floor.

    Parameters
    ----------
    masses : sequence of float
        From the lowest box up, kg.
    restitution, friction : float
        Of all.
    aside : float
        How far every other box is shifted to the right, and the rest to the left, m.
    at : float
        Both coordinates of the middle of the floor, m.

    Examples
    --------
    >>> [body.mass for body in tower([1.0, 2.0]).bodies]
    [None, 1.0, 2.0]
    """
    surface = Material(restitution, friction)
    half = scenes.HALF_LENGTH
    floor = Body(Segment((-half, 0), (half, 0)), position=(at, at), material=surface)
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=mass,
            position=(at + (aside if n % 2 else -aside), at + 0.5 + n - (n + 1) * SUNK),
            material=surface,
        )
        for n, mass in enumerate(masses)
    ]
    return Scene([floor, *boxes], gravity=(0, -scenes.GRAVITY))


def sinks(trial: Trial) -> float:
    """Return the deepest overlap after 10 s, or how far the load has moved if that is more, m."""
    run = trial.run(10.0, sample="end")
    return max(float(run.max_penetration[-1]), way_of(run))


def force_errors(trial: Trial) -> float:
    """Return the relative error of the forces under the boxes of a tower after a second."""
    run = trial.run(1.0)
    forces = pair_forces(run, DT)
    masses = [body.mass for body in trial.scene.bodies[1:]]
    measured = [forces.get((n, n + 1), 0.0) for n in range(len(masses))]
    return relative_errors(measured, stack_forces(masses, scenes.GRAVITY))


def jitter(trial: Trial) -> float:
    """Return the greatest speed in the second after 10 s, m/s."""
    return fastest(trial.run(11.0, sample=np.linspace(10, 11, 61)))


def pyramid() -> Scene:
    """Return eight rows of boxes, each one shorter than the one below."""
    scene = scenes.box_pyramid(8)
    floor, *boxes = scene.bodies
    lowered = [
        Body(
            box.shape,
            mass=box.mass,
            position=(box.position[0], box.position[1] - (round(box.position[1] + 0.5)) * SUNK),
            material=box.material,
        )
        for box in boxes
    ]
    return Scene([floor, *lowered], gravity=scene.gravity)


def energy_gained(trial: Trial) -> float:
    """Return the largest kinetic energy in 10 s of a scene that starts at rest, J."""
    return largest(trial.run(10.0).kinetic_energy)


CASES = (
    HardCase(
        name="heavy-load",
        theme=THEME,
        title="1,000,000 kg on a box of 1 kg, 10 s",
        why="A sweep of impulses takes a millionth of the load's velocity, and no more.",
        law="What stands stands.",
        scene=partial(tower, (1.0, LOAD)),
        measure=sinks,
        unit="m",
        bound=NOT_SEEN,
        reason="a thousandth of the size of a box",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="heavy-load-force",
        theme=THEME,
        title="The forces under 1,000,000 kg and 1 kg",
        why="A velocity of the light box that is rounding is a force of 1e-8 of the load.",
        law="N = the weight of all that stands above",
        scene=partial(tower, (1.0, LOAD)),
        measure=force_errors,
        unit="",
        bound=1e-8,
        reason="rounding, 1e-14, times the ratio of the masses",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="doubling-tower",
        theme=THEME,
        title="A tower of 10, each box twice as heavy as the one below, 10 s",
        why="Every contact has the heavier body on top, and needs the answer of all the others.",
        law="What stands stands.",
        scene=partial(tower, tuple(2.0**n for n in range(10))),
        measure=drift(10.0),
        unit="m",
        bound=NOT_SEEN,
        reason=NO_DRIFT,
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="tower-20",
        theme=THEME,
        title="A tower of 20 boxes, 10 s",
        why="The weight of the top has to get down through 20 contacts in each step.",
        law="What stands stands.",
        scene=partial(tower, (1.0,) * 20),
        measure=drift(10.0),
        unit="m",
        bound=NOT_SEEN,
        reason=NO_DRIFT,
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="crooked-tower",
        theme=THEME,
        title="A tower of 15 boxes, 1 cm left and right in turn, 10 s",
        why="Each box stands askew, so an error of the forces tips it.",
        law="What stands stands: each centre is well above the box below.",
        scene=partial(tower, (1.0,) * 15, aside=0.01),
        measure=drift(10.0),
        unit="m",
        bound=NOT_SEEN,
        reason=NO_DRIFT,
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="tower-40",
        theme=THEME,
        title="A tower of 40 boxes, 60 s",
        why="What drifts by a thousandth of a millimetre in a step is 4 mm off after a minute.",
        law="What stands stands.",
        scene=partial(tower, (1.0,) * 40),
        measure=drift(60.0),
        unit="m",
        bound=NOT_SEEN,
        reason=NO_DRIFT,
        failed_by=("naive", "pymunk", "box2d"),
        is_long=True,
    ),
    HardCase(
        name="tower-40-forces",
        theme=THEME,
        title="The force under each of 40 boxes",
        why="The lowest contact carries forty times what the highest does.",
        law="N = the weight of all that stands above",
        scene=partial(tower, (1.0,) * 40),
        measure=force_errors,
        unit="",
        bound=1e-8,
        reason="rounding of linear equations with 160 unknowns, 1e-12, and some room",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="pyramid",
        theme=THEME,
        title="A pyramid of 8 rows, 5 s",
        why="36 boxes with 128 points of contact, each of which depends on all others.",
        law="What stands stands.",
        scene=pyramid,
        measure=drift(5.0),
        unit="m",
        bound=NOT_SEEN,
        reason=NO_DRIFT,
        failed_by=("naive",),
    ),
    HardCase(
        name="jitter",
        theme=THEME,
        title="A tower of 10 after 10 s: is it at rest?",
        why="Contacts that open and close in turn make a tower tremble for ever.",
        law="At rest all speeds are 0.",
        scene=partial(tower, (1.0,) * 10),
        measure=jitter,
        unit="m/s",
        bound=1e-9,
        reason="a millimetre in eleven days",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="elastic-tower",
        theme=THEME,
        title="A tower of 5 elastic boxes at rest, 10 s",
        why="With e = 1 any error of a velocity is given back in full, for ever.",
        law="What has no energy gets none.",
        scene=partial(tower, (1.0,) * 5, restitution=1.0),
        measure=energy_gained,
        unit="J",
        bound=1e-12,
        reason="a speed of 1e-6 m/s of one box",
        failed_by=("naive", "pymunk"),
    ),
)
