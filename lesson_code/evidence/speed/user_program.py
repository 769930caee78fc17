"""The program whose time counts: discs in a box, as a user of each engine writes them.

It is run as a file, in a process of its own, and imports nothing that a user would not import:

    python user_program.py ENGINE SCENE CALLS

ENGINE is the name of a function below, SCENE a file with the numbers of the scene as JSON. The
engine makes the scene, runs it and returns where its discs are in the end; CALLS times, as one
does in a notebook. The program prints one JSON object: where the middle of all discs is, and how
long the last call took, s.
"""

from __future__ import annotations

import json
import math
import os
import sys
import time
from typing import Any

STEPS_A_SECOND = 60

RADIUS, MASS = 0.5, 1.0
"""m and kg: of every disc."""


def ours(given: dict[str, Any], *, compiled: bool | None = None) -> Any:
    """Run a scene by the call that stands in the README."""
    from lesson_code import Body, Material, Scene, Segment, simulate

    surface = Material(restitution=given["restitution"], friction=given["friction"])
    scene = Scene.of_discs(
        given["places"],
        given["velocities"],
        radius=RADIUS,
        mass=MASS,
        material=surface,
        obstacles=[Body(Segment(*wall), material=surface) for wall in given["walls"]],
        gravity=given["gravity"],
    )
    run = simulate(scene, given["seconds"], compiled=compiled)
    return run.positions[-1, len(given["walls"]) :].tolist()


def compiled(given: dict[str, Any]) -> Any:
    """Run a scene by ours as machine code, which keeps the program for later."""
    return ours(given, compiled=True)


def pymunk(given: dict[str, Any]) -> Any:
    """Run a scene by pymunk; a pair's friction is the product of two."""
    import pymunk as engine

    space = engine.Space()
    space.gravity = given["gravity"]
    friction = math.sqrt(given["friction"])
    shapes: list[Any] = [
        engine.Segment(space.static_body, start, end, 0.0) for start, end in given["walls"]
    ]
    discs = []
    for place, velocity in zip(given["places"], given["velocities"], strict=True):
        body = engine.Body(MASS, engine.moment_for_circle(MASS, 0, RADIUS))
        body.position, body.velocity = place, velocity
        space.add(body)
        discs.append(body)
        shapes.append(engine.Circle(body, RADIUS))
    for shape in shapes:
        shape.elasticity, shape.friction = given["restitution"], friction
        space.add(shape)
    for _ in range(round(given["seconds"] * STEPS_A_SECOND)):
        space.step(1 / STEPS_A_SECOND)
    return [tuple(body.position) for body in discs]


def box2d(given: dict[str, Any]) -> Any:
    """Run a scene by Box2D v3, with the four sub-steps that its manual advises."""
    import pyb2d3 as engine

    world = engine.World(gravity=given["gravity"], restitution_threshold=0.0)
    surface = engine.surface_material(restitution=given["restitution"], friction=given["friction"])
    shape = engine.shape_def(material=surface, density=MASS / (math.pi * RADIUS**2))
    ground = world.create_body(type=engine.BodyType.STATIC)
    for start, end in given["walls"]:
        ground.create_segment_shape(shape, engine.segment(start, end))
    discs = []
    for place, velocity in zip(given["places"], given["velocities"], strict=True):
        body = world.create_body(
            type=engine.BodyType.DYNAMIC, position=place, linear_velocity=velocity
        )
        body.create_circle_shape(shape, engine.circle(radius=RADIUS))
        discs.append(body)
    for _ in range(round(given["seconds"] * STEPS_A_SECOND)):
        world.step(1 / STEPS_A_SECOND, 4)
    return [tuple(map(float, body.position)) for body in discs]


ENGINES = {run.__name__: run for run in (ours, compiled, pymunk, box2d)}


def clocks() -> tuple[float, float]:
    """Return the time on the wall, and of the processor for this process and its children, s."""
    used = os.times()
    return time.perf_counter(), time.process_time() + used.children_user + used.children_system


def with_tuples(read: dict[str, Any]) -> dict[str, Any]:
    """Return what was read with a tuple for each point, as a user writes them."""
    read["gravity"] = tuple(read["gravity"])
    for name in ("places", "velocities"):
        read[name] = [tuple(point) for point in read[name]]
    read["walls"] = [(tuple(start), tuple(end)) for start, end in read["walls"]]
    return read


def main(engine: str, file: str, calls: int) -> None:
    """Run a scene so many times, and print the result."""
    with open(file, encoding="utf-8") as opened:  # noqa: PTH123 - pathlib takes time to import
        given = json.load(opened, object_hook=with_tuples)
    for _ in range(calls):
        wall, cpu = clocks()
        places = ENGINES[engine](given)
    end_wall, end_cpu = clocks()
    middle = [sum(along) / len(places) for along in zip(*places, strict=True)]
    sys.stdout.write(json.dumps({"middle": middle, "wall": end_wall - wall, "cpu": end_cpu - cpu}))


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
