"""Hard cases: size, place and order, on which physics, and so a result, does not depend."""

from __future__ import annotations

import hashlib
import math
import subprocess
import sys
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.loads import tower
from lesson_code.evidence.hard_cases.measures import end_state, largest
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

THEME = "Size, place, order"

RADII = (10.0, 1.0, 0.1, 0.05, 0.01, 1e-3)
"""m."""


def dropped_disc(radius: float = 0.01) -> Scene:
    """Return a disc that is dropped from a metre."""
    disc = Body(Circle(radius), mass=1, position=(0, 1 + radius), material=Material(0.0, 0.5))
    return Scene([Body(Segment((-5, 0), (5, 0))), disc], gravity=(0, -scenes.GRAVITY))


def rest_height_error(trial: Trial) -> float:
    """Return the largest relative error of a resting disc's height, over all radii."""
    worst = 0.0
    for radius in RADII:
        height = float(trial.run(3.0, dropped_disc(radius), sample="end").positions[-1, 1, 1])
        worst = max(worst, abs(height / radius - 1))
    return worst


def falling_shapes(size: float = 1.0) -> Scene:
    """Return a box, a disc and a plank that fall on a floor, all scaled by a factor.

    Gravity is scaled by the same factor, so that everything takes the same time.
    """
    surface = Material(0.3, 0.4)
    bodies: list[tuple[Shape, tuple[float, float], float]] = [
        (Polygon.box(size, size), (0.0, 1.5 * size), 0.3),
        (Circle(0.4 * size), (1.3 * size, 2.0 * size), 0.0),
        (Polygon.box(2.5 * size, 0.3 * size), (0.5 * size, 3.2 * size), 0.1),
    ]
    floor = Body(Segment((-50 * size, 0), (50 * size, 0)), material=surface)
    return Scene(
        [
            floor,
            *(
                Body(shape, mass=1, position=place, angle=angle, material=surface)
                for shape, place, angle in bodies
            ),
        ],
        gravity=(0, -scenes.GRAVITY * size),
    )


SHORT = 1.0
"""s: how long falls are compared. Later, small differences in a landing change the motion."""


def scale_error(trial: Trial) -> float:
    """Return how far the end of a fall changes at 1/1000 or 1000 times the size, in sizes."""
    right = trial.run(SHORT, sample="end").positions[-1]
    return max(
        largest(trial.run(SHORT, falling_shapes(size), sample="end").positions[-1] / size - right)
        for size in (1e-3, 1e3)
    )


OFFSET = 1e6
"""m, in both directions."""


def offset_error(trial: Trial) -> float:
    """Return how an offset from the origin changes a tower of 5 in 5 s: m, and m/s."""
    near = trial.run(5.0, sample="end")
    far = trial.run(5.0, tower((1.0,) * 5, at=OFFSET), sample="end")
    shift = np.array([OFFSET, OFFSET])
    return max(
        largest(far.positions[-1] - shift - near.positions[-1]),
        largest(far.velocities[-1] - near.velocities[-1]),
    )


TURN = 0.7
"""rad."""


def turned(scene: Scene, angle: float) -> Scene:
    """Return a scene with gravity and all bodies turned about the origin."""
    cos, sin = math.cos(angle), math.sin(angle)

    def turn(v: Any) -> tuple[float, float]:
        return (cos * v[0] - sin * v[1], sin * v[0] + cos * v[1])

    return Scene(
        [
            replace(
                body,
                position=turn(body.position),
                velocity=turn(body.velocity),
                angle=body.angle + angle,
            )
            for body in scene.bodies
        ],
        gravity=turn(scene.gravity),
    )


def turn_error(trial: Trial) -> float:
    """Return how far the end of a fall changes in a rotated world, m."""
    right = trial.run(SHORT, sample="end").positions[-1]
    found = trial.run(SHORT, turned(trial.scene, TURN), sample="end").positions[-1]
    cos, sin = math.cos(TURN), math.sin(TURN)
    return largest(found @ np.array([[cos, -sin], [sin, cos]]) - right)


FRAME = np.array([3.0, 0.0])
"""m/s: speed of the train from which the scene is seen."""


def moving(scene: Scene) -> Scene:
    """Return a scene as it is seen from a moving train: the floor moves, too."""
    return Scene(
        [replace(b, velocity=(b.velocity[0] + FRAME[0], b.velocity[1])) for b in scene.bodies],
        gravity=scene.gravity,
    )


def frame_error(trial: Trial) -> float:
    """Return how far the end of a fall changes when seen from a train, m."""
    right = trial.run(SHORT, sample="end").positions[-1]
    found = trial.run(SHORT, moving(trial.scene), sample="end").positions[-1]
    return largest(found - FRAME * SHORT - right)


def mirror_pyramid() -> Scene:
    """Return five rows of boxes that fall by a centimetre, mirror images of each other."""
    scene = scenes.box_pyramid(5)
    floor, *boxes = scene.bodies
    lifted = [replace(b, position=(b.position[0], 1.01 * b.position[1])) for b in boxes]
    return Scene([floor, *lifted], gravity=scene.gravity)


def asymmetry(trial: Trial) -> float:
    """Return how far a box is from the mirror image of its partner after 3 s, m."""
    final, start = trial.run(3.0, sample="end").positions[-1], trial.scene
    worst = 0.0
    for n, body in enumerate(start.bodies[1:], 1):
        x, y = body.position
        partner = next(
            k
            for k, other in enumerate(start.bodies[1:], 1)
            if abs(other.position[0] + x) < 1e-9 and abs(other.position[1] - y) < 1e-9
        )
        worst = max(worst, largest(final[n] * [-1, 1] - final[partner]))
    return worst


def order_error(trial: Trial) -> float:
    """Return how much the order of the bodies in the list changes a pyramid after 3 s, m."""
    floor, *boxes = trial.scene.bodies
    listed = trial.run(3.0, sample="end").positions[-1, 1:]
    backwards = Scene([floor, *boxes[::-1]], gravity=trial.scene.gravity)
    found = trial.run(3.0, backwards, sample="end").positions[-1, 1:]
    return largest(found[::-1] - listed)


def crowd() -> Scene:
    """Return 60 rough discs that fall into a heap."""
    rng = np.random.default_rng(7)
    surface = Material(0.5, 0.4)
    walls = [
        Body(Segment((-6, 0), (6, 0)), material=surface),
        Body(Segment((-6, 0), (-6, 40)), material=surface),
        Body(Segment((6, 0), (6, 40)), material=surface),
    ]
    places = [(1.5 * (n % 6) - 3.75, 1.0 + 1.4 * (n // 6)) for n in range(60)]
    discs = [
        Body(
            Circle(float(rng.uniform(0.3, 0.6))),
            mass=1,
            position=(x + float(rng.uniform(-0.1, 0.1)), y),
            material=surface,
        )
        for x, y in places
    ]
    return Scene([*walls, *discs], gravity=(0, -scenes.GRAVITY))


CROWD_SECONDS = 2.0
"""s."""


def fingerprint(run: Run) -> str:
    """Return a hash of the last state, to the last bit."""
    return hashlib.sha256(np.ascontiguousarray(end_state(run)).tobytes()).hexdigest()


def processes_differ(trial: Trial) -> float:
    """Return how many of two fresh processes differ from this one, by even a single bit."""
    here = fingerprint(trial.run(CROWD_SECONDS, sample="end"))
    command = [sys.executable, "-W", "ignore", "-m", __name__, repr(dict(trial.options))]
    others = [
        subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()  # noqa: S603 - this very module
        for _ in range(2)
    ]
    return float(sum(other != here for other in others))


def momentum_error(trial: Trial) -> float:
    """Return the relative change of momentum of free discs that collide for 5 s."""
    run = trial.run(5.0, sample="end")
    scale = float(np.sum(np.hypot(*run.velocities[0].T)))
    return largest(run.momentum[-1] - run.momentum[0]) / scale


def free_crowd() -> Scene:
    """Return 36 rough discs of 1 to 1000 kg without walls, all flying to the middle."""
    rng = np.random.default_rng(3)
    rough = Material(0.7, 0.5)
    places = [(1.2 * (n % 6) - 3.0, 1.2 * (n // 6) - 3.0) for n in range(36)]
    return Scene(
        Body(
            Circle(0.5),
            mass=float(10 ** rng.uniform(0, 3)),
            position=(x, y),
            velocity=(-x, -y),
            angular_velocity=float(rng.uniform(-5, 5)),
            material=rough,
        )
        for x, y in places
    )


CASES = (
    HardCase(
        name="small-discs",
        theme=THEME,
        title="Discs of 10 m to 1 mm, dropped from 1 m",
        why="An overlap that is too small to see in a house is a whole grain of sand.",
        law="At rest the centre is one radius above the floor.",
        scene=dropped_disc,
        measure=rest_height_error,
        unit="",
        bound=2e-3,
        reason="a thousandth of the width",
        failed_by=("pymunk", "box2d"),
    ),
    HardCase(
        name="scale",
        theme=THEME,
        title="The same fall, a thousand times smaller and larger",
        why="A length in a solver's constants makes a size special.",
        law="Lengths and gravity scaled alike: the same fall",
        scene=falling_shapes,
        measure=scale_error,
        unit="",
        bound=1e-9,
        reason="rounding, and some room for what a hit makes of it",
        failed_by=("pymunk", "box2d"),
    ),
    HardCase(
        name="far-away",
        theme=THEME,
        title="A tower of 5 at 1,000,000 m from the origin, 5 s",
        why="There a place is rounded to 1e-10 m, and single precision to 6 cm.",
        law="The laws are the same everywhere.",
        scene=partial(tower, (1.0,) * 5),
        measure=offset_error,
        unit="m",
        bound=1e-8,
        reason="a hundred roundings of a place",
        failed_by=("box2d",),
    ),
    HardCase(
        name="turned-world",
        theme=THEME,
        title="The same fall in a world that is turned by 0.7 rad",
        why="Boxes along the axes are treated apart in many a program.",
        law="The laws know no direction.",
        scene=falling_shapes,
        measure=turn_error,
        unit="m",
        bound=1e-9,
        reason="rounding, and some room for what a hit makes of it",
    ),
    HardCase(
        name="moving-frame",
        theme=THEME,
        title="The same fall, seen from a train",
        why="A contact that is taken at the wrong time lies elsewhere on a moving floor.",
        law="Galilei: the laws are the same in a train.",
        scene=falling_shapes,
        measure=frame_error,
        unit="m",
        bound=1e-9,
        reason="rounding, and some room for what a hit makes of it",
    ),
    HardCase(
        name="mirror",
        theme=THEME,
        title="A pyramid that falls by a centimetre: left and right",
        why="The body that is visited first gets more.",
        law="What begins as its mirror image stays so.",
        scene=mirror_pyramid,
        measure=asymmetry,
        unit="m",
        bound=1e-9,
        reason="rounding, and some room for what an impact makes of it",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="order",
        theme=THEME,
        title="A pyramid, its boxes listed backwards",
        why="Sweeps go through a list, and the list is not physics.",
        law="The order of a list changes nothing.",
        scene=partial(scenes.box_pyramid, 5),
        measure=order_error,
        unit="m",
        bound=1e-9,
        reason="rounding in another order",
        failed_by=("pymunk", "box2d"),
    ),
    HardCase(
        name="determinism",
        theme=THEME,
        title="60 discs fall into a heap, in three processes",
        why="An order that hangs on memory addresses makes each run another one.",
        law="The same input gives the same bits.",
        scene=crowd,
        measure=processes_differ,
        unit="",
        bound=0.0,
        reason="bits are equal or not",
    ),
    HardCase(
        name="momentum",
        theme=THEME,
        title="36 rough discs of 1 to 1000 kg meet in the middle",
        why="What one body gets, the other has to give, to the last digit.",
        law="Momentum is kept.",
        scene=free_crowd,
        measure=momentum_error,
        unit="",
        bound=1e-9,
        reason="rounding, for masses a thousand apart",
    ),
)


if __name__ == "__main__":
    import ast

    options = ast.literal_eval(sys.argv[1])
    sys.stdout.write(fingerprint(Trial(crowd(), options).run(CROWD_SECONDS, sample="end")))
