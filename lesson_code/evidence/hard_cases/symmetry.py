"""Families of worlds seen otherwise: size, place, direction and order, on which no law depends."""

from __future__ import annotations

import hashlib
import math
import subprocess
import sys
from dataclasses import replace
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.loads import tower
from lesson_code.evidence.hard_cases.measures import (
    NOT_SEEN,
    ROUNDING,
    angle_of,
    end_state,
    largest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

THEME = "Size, place, order"

SHORT = 0.7
"""s: how long falls are compared. Later, small differences in a landing change the motion."""

SAME_FALL = "rounding, and some room for what a landing makes of it"


def falling(draw: Draw) -> Scene:
    """Return a box, a disc and a plank beside one another that fall on a rough or smooth floor."""
    surface = Material(draw.uniform("restitution", 0.0, 0.5), draw.uniform("friction", 0.0, 0.8))
    shapes: list[Shape] = [Polygon.box(1, 1), Circle(0.4), Polygon.box(1.5, 0.3)]
    bodies = [
        Body(
            shape,
            mass=1,
            position=(3.0 * n, 1.0 + draw.uniform(f"height_{n}", 0.0, 0.5)),
            angle=angle_of(draw, f"angle_{n}", 5.0, 40.0),
            velocity=(draw.uniform(f"speed_{n}", -1.0, 1.0), 0.0),
            material=surface,
        )
        for n, shape in enumerate(shapes)
    ]
    floor = Body(Segment((-50, 0), (50, 0)), material=surface)
    return Scene([floor, *bodies], gravity=(0, -scenes.GRAVITY))


def scaled(scene: Scene, length: float, mass: float = 1.0) -> Scene:
    """Return a scene with all lengths, gravity included, and all masses times a factor."""
    bodies = [
        Body(
            larger(body.shape, length),
            mass=None if body.mass is None else body.mass * mass,
            position=(length * body.position[0], length * body.position[1]),
            velocity=(length * body.velocity[0], length * body.velocity[1]),
            angle=body.angle,
            angular_velocity=body.angular_velocity,
            material=body.material,
        )
        for body in scene.bodies
    ]
    return Scene(bodies, gravity=[length * g for g in scene.gravity])


def larger(shape: Shape, factor: float) -> Shape:
    """Return a shape times a factor."""
    if isinstance(shape, Circle):
        return Circle(factor * shape.radius)
    corners = [(factor * x, factor * y) for x, y in shape.outline]
    return Polygon(corners) if isinstance(shape, Polygon) else Segment(corners[0], corners[1])


def places(trial: Trial, scene: Scene) -> Any:
    """Return where all bodies are after a short fall, shape (N, 2)."""
    return trial.run(scene, SHORT).positions[-1]


@family(
    THEME,
    why="A length in a solver's constants makes a size special.",
    law="Lengths and gravity scaled alike: the same fall",
    unit="",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def scale(draw: Draw, trial: Trial) -> float:
    """A fall on a floor, a thousand times smaller to larger: difference in sizes."""
    scene, factor = falling(draw), draw.log_uniform("factor", 1e-3, 1e3)
    return largest(places(trial, scaled(scene, factor)) / factor - places(trial, scene))


@family(
    THEME,
    why="A mass in a solver's constants makes a weight special.",
    law="All masses scaled alike: the same fall",
    unit="m",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def mass_scale(draw: Draw, trial: Trial) -> float:
    """A fall on a floor, with masses a billion times smaller to larger: difference."""
    scene, factor = falling(draw), draw.log_uniform("factor", 1e-9, 1e9)
    return largest(places(trial, scaled(scene, 1.0, factor)) - places(trial, scene))


@family(
    THEME,
    why="A contact that is taken at the wrong time lies elsewhere on a moving floor.",
    law="Galilei: the laws are the same in a train.",
    unit="m",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def moving_frame(draw: Draw, trial: Trial) -> float:
    """A fall on a floor, seen from a train of up to 10 m/s: difference."""
    scene, speed = falling(draw), draw.uniform("train", -10.0, 10.0)
    bodies = [replace(b, velocity=(b.velocity[0] + speed, b.velocity[1])) for b in scene.bodies]
    seen = places(trial, Scene(bodies, gravity=scene.gravity))
    return largest(seen - [speed * SHORT, 0.0] - places(trial, scene))


@family(
    THEME,
    why="Boxes along the axes are treated apart in many a program.",
    law="The laws know no direction.",
    unit="m",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def turned_world(draw: Draw, trial: Trial) -> float:
    """A fall on a floor in a world turned by any angle: difference."""
    scene, angle = falling(draw), draw.uniform("turn", 0.0, 2 * math.pi)
    rotation = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
    bodies = [
        replace(
            body,
            position=tuple(rotation @ body.position),
            velocity=tuple(rotation @ body.velocity),
            angle=body.angle + angle,
        )
        for body in scene.bodies
    ]
    seen = places(trial, Scene(bodies, gravity=rotation @ scene.gravity))
    return largest(seen @ rotation - places(trial, scene))


@family(
    THEME,
    why="The body on the left is visited first, or the corner, or the wall.",
    law="The laws are the same in a mirror.",
    unit="m",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def mirrored_world(draw: Draw, trial: Trial) -> float:
    """A fall on a floor, and its mirror image: difference."""
    scene = falling(draw)
    bodies = [
        replace(
            body,
            position=(-body.position[0], body.position[1]),
            velocity=(-body.velocity[0], body.velocity[1]),
            angle=-body.angle,
        )
        for body in scene.bodies
    ]
    seen = places(trial, Scene(bodies, gravity=scene.gravity))
    return largest(seen * [-1, 1] - places(trial, scene))


@family(
    THEME,
    why="The box that is visited first gets more.",
    law="What begins as its mirror image stays so.",
    unit="m",
    bound=ROUNDING,
    reason=SAME_FALL,
)
def mirror_pyramid(draw: Draw, trial: Trial) -> float:
    """A pyramid of 2 to 6 rows that falls by 0 to 1 cm: left and right after 2 s."""
    rows, drop = draw.integer("rows", 2, 6), draw.choice("drop", (0.0, 1e-3, 1e-2))
    scene = scenes.box_pyramid(rows, gap=draw.uniform("between", 0.05, 0.4), overlap=-drop)
    final = trial.run(scene, 2.0).positions[-1, 1:]
    start = [(row, n) for row in range(rows) for n in range(rows - row)]
    partner = [start.index((row, rows - row - 1 - n)) for row, n in start]
    return largest(final[partner] * [-1, 1] - final)


@family(
    THEME,
    why="Sweeps go through a list, and the list is not physics.",
    law="The order of a list changes nothing.",
    unit="m",
    bound=ROUNDING,
    reason="rounding in another order",
)
def order_of_the_list(draw: Draw, trial: Trial) -> float:
    """A pyramid of 2 to 6 rows that falls by 0 to 1 cm, its boxes listed in any order, 2 s."""
    rows, drop = draw.integer("rows", 2, 6), draw.choice("drop", (0.0, 1e-3, 1e-2))
    floor, *boxes = scenes.box_pyramid(rows, overlap=-drop).bodies
    order = np.random.default_rng(draw.integer("order", 0, 10**6)).permutation(len(boxes))
    down = (0, -scenes.GRAVITY)
    listed = trial.run(Scene([floor, *boxes], gravity=down), 2.0).positions[-1, 1:]
    other = Scene([floor, *(boxes[n] for n in order)], gravity=down)
    return largest(trial.run(other, 2.0).positions[-1, 1:] - listed[order])


@family(
    THEME,
    why="At 1e6 m a place is rounded to 1e-10 m, and in single precision to 6 cm.",
    law="The laws are the same everywhere.",
    unit="m",
    bound=1e-8,
    reason="a hundred roundings of a place",
)
def far_from_the_origin(draw: Draw, trial: Trial) -> float:
    """A tower of 1 to 6 boxes, 1 to 1,000,000 m from the origin, 5 s: difference."""
    offset, count = draw.log_uniform("offset", 1.0, 1e6), draw.integer("count", 1, 6)
    runs = [trial.run(tower((1.0,) * count, at=at), 5.0) for at in (0.0, offset)]
    near, far = (run.positions[-1] for run in runs)
    return largest(far - offset - near)


@family(
    THEME,
    why="An overlap that is too small to see in a house is a whole grain of sand.",
    law="At rest the centre is one radius above the floor.",
    unit="",
    bound=NOT_SEEN,
    reason="a thousandth of the radius",
)
def disc_of_any_size(draw: Draw, trial: Trial) -> float:
    """A disc of 0.1 mm to 100 m is dropped from a metre: its height at rest, in radii."""
    radius = draw.log_uniform("radius", 1e-4, 100.0)
    disc = Body(Circle(radius), mass=1, position=(0, 1 + radius), material=Material(0.0, 0.5))
    floor = Body(Segment((-500, 0), (500, 0)))
    run = trial.run(Scene([floor, disc], gravity=(0, -scenes.GRAVITY)), 3.0)
    return abs(float(run.positions[-1, 1, 1]) / radius - 1)


def crowd(seed: int) -> Scene:
    """Return 30 rough discs that fall into a heap."""
    rng = np.random.default_rng(seed)
    surface = Material(0.5, 0.4)
    lines = [((-6, 0), (6, 0)), ((-6, 0), (-6, 40)), ((6, 0), (6, 40))]
    walls = [Body(Segment(start, end), material=surface) for start, end in lines]
    discs = [
        Body(
            Circle(float(rng.uniform(0.3, 0.6))),
            mass=1,
            position=(1.5 * (n % 6) - 3.75 + float(rng.uniform(-0.1, 0.1)), 1 + 1.4 * (n // 6)),
            material=surface,
        )
        for n in range(30)
    ]
    return Scene([*walls, *discs], gravity=(0, -scenes.GRAVITY))


def fingerprint(run: Run) -> str:
    """Return a hash of the last state, to the last bit."""
    return hashlib.sha256(np.ascontiguousarray(end_state(run)).tobytes()).hexdigest()


def heap_fingerprint(engine: str, seed: int) -> str:
    """Return the hash of a heap after a second and a half."""
    return fingerprint(Trial(engine).run(crowd(seed), 1.5))


@family(
    THEME,
    why="An order that hangs on memory addresses makes each run another one.",
    law="The same input gives the same bits.",
    unit="",
    bound=0.0,
    reason="bits are equal or not",
)
def same_bits(draw: Draw, trial: Trial) -> float:
    """30 discs fall into a heap: is it the same to the last bit in a fresh process?"""
    seed = draw.integer("heap", 0, 10**6)
    command = [sys.executable, "-W", "ignore", "-m", __name__, trial.engine, str(seed)]
    fresh = subprocess.run(command, capture_output=True, text=True, check=True)  # noqa: S603 - this very module
    return float(fresh.stdout.strip() != heap_fingerprint(trial.engine, seed))


if __name__ == "__main__":
    sys.stdout.write(heap_fingerprint(sys.argv[1], int(sys.argv[2])))
