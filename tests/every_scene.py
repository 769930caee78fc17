"""Every builder of scenes in `evidence`, and scenes with what they leave out."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.chapters.ch04_circles.scenes import scattered_balls
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes import speed as speed_scenes
from lesson_code.evidence.scenes.gas import disc_gas, gas_of
from lesson_code.evidence.scenes.spinning_discs import Disc, scene_of

DT = 1 / 60


def mixed_heap() -> Scene:
    """Return discs, boxes and rods that fall into a pit, turned and turning, with damping."""
    rng = np.random.default_rng(3)
    walls = [Segment((-2, 0), (2, 0)), Segment((-2, 0), (-2, 20)), Segment((2, 0), (2, 20))]
    shapes = (Circle(0.3), Polygon.box(0.6, 0.4), Segment((-0.3, 0), (0.3, 0), radius=0.1))
    bodies = [
        Body(
            shapes[n % 3], mass=1 + n % 2, position=(n % 4 - 1.5, 0.5 + n // 4),
            angle=rng.uniform(-3, 3), angular_velocity=rng.uniform(-9, 9),
            velocity=rng.uniform(-3, 3, 2), material=Material(0.1 * (n % 5), 0.2 * (n % 4)),
        )
        for n in range(27)
    ]  # fmt: skip
    return Scene([*map(Body, walls), *bodies], gravity=(0.5, -10), damping=0.2)


def many_boxes(seed: int = 1) -> Scene:
    """Return boxes in rows on a floor and a belt, some turned, and discs on them.

    So many are sorted by colour and visited in lanes, several on one body that nothing can push. On
    turned boxes one point of a manifold opens, on others both carry.
    """
    rng = np.random.default_rng(seed)
    rough = Material(0, 0.5)
    belt = Body(Polygon.box(5, 1), position=(5.5, -0.5), velocity=(-1, 0), material=rough)
    boxes = [
        Body(
            Polygon.box(rng.uniform(0.5, 0.95), 0.6), mass=rng.uniform(1, 9),
            position=(column, 0.3 + 0.595 * row), angle=rng.choice([0.0, 0.0, rng.normal(0, 0.02)]),
            velocity=rng.normal(0, 0.5, 2), angular_velocity=rng.normal(0, 0.5),
            material=Material(rng.choice([0.0, 0.5]), rng.uniform(0, 1)),
        )
        for row in range(5)
        for column in range(9)
    ]  # fmt: skip
    discs = [Body(Circle(0.4), mass=1, position=(0.9 * k, 3.4)) for k in range(9)]
    floor = Body(Polygon.box(9, 1), position=(-1.5, -0.5), material=rough)
    return Scene([floor, belt, *boxes, *discs], gravity=(0.5, -10), damping=0.1)


def moving_walls() -> Scene:
    """Return a bat that comes, a roller that turns, a saw that does both, and balls between."""
    bats = [
        Body(Polygon.box(0.5, 4), position=(-2, 0), velocity=(1.5, 0)),
        Body(Circle(0.7), position=(0, -2), angular_velocity=5, material=Material(0.2, 0.9)),
        Body(Polygon.regular(5, 0.8), position=(2, 0), velocity=(-0.5, 0), angular_velocity=-3),
    ]
    balls = [Body(Circle(0.3), mass=1, position=(0.7 * k - 1, 0.1 * k)) for k in range(4)]
    return Scene([*bats, *balls], gravity=(0, -5))


def fast_mix() -> Scene:
    """Return balls, boxes and rods that fly and turn so fast that steps are split at impacts."""
    rng = np.random.default_rng(11)
    walls = exact_scenes.box(8, 8)
    shapes = (Circle(0.1), Polygon.box(0.3, 0.1), Segment((-0.2, 0), (0.2, 0), radius=0.02))
    bodies = [
        Body(
            shapes[n % 3], mass=1, position=(1 + n % 4 * 2, 1 + n // 4 * 2),
            velocity=rng.uniform(-60, 60, 2), angular_velocity=rng.uniform(-60, 60),
            material=Material(0.8, 0.3),
        )
        for n in range(12)
    ]  # fmt: skip
    return Scene([*walls, *bodies])


def spinning_pair() -> Scene:
    """Return two discs that hit each other with spin and friction."""
    a = Disc(2.0, 0.5, np.array([-0.6, 0.0]), np.array([2.0, 0.3]), 4.0)
    b = Disc(1.0, 0.7, np.array([0.65, 0.1]), np.array([-1.0, 0.0]), -7.0)
    return scene_of(a, b, 0.6, 0.4)


def turned_back() -> Scene:
    """Return balls that a plain run has left flying, with their velocities turned round."""
    run = simulate(scattered_balls(1.0), 1.0, solver="exact")
    return exact_scenes.turned_back(run)


SCENES: dict[str, Callable[[], Scene]] = {
    "no bodies": Scene,
    "one body": lambda: Scene([Body(Circle(1), mass=1, velocity=(1, 2))], gravity=(0, -10)),
    "static bodies alone": lambda: Scene([Body(Circle(1)), Body(Circle(1), velocity=(1, 0))]),
    "damping alone": lambda: Scene([Body(Polygon.box(1, 2), mass=1, velocity=(9, 1))], damping=0.7),
    "disc gas": lambda: disc_gas(5, 0.3, seed=1),
    "dense gas": lambda: gas_of(30, 0.6, seed=2),
    "row of discs": lambda: disc_scenes.row_of_discs(5, 0.01),
    "cue between two": lambda: disc_scenes.cue_between_two(upper_first=True),
    "scattered balls": lambda: scattered_balls(0.9),
    "rack break": lambda: disc_scenes.rack_break(0.95),
    "balls at a wall": lambda: exact_scenes.balls_at_wall(60.0, count=8, dt=DT),
    "turning rod": lambda: exact_scenes.turning_rod(20.0, phase=0.4, dt=DT),
    "two blocks": lambda: exact_scenes.two_blocks(100.0),
    "ball in a box": exact_scenes.ball_in_a_box,
    "bouncing to rest": lambda: exact_scenes.bouncing_to_rest(0.5),
    "turned back": turned_back,
    "spinning pair": spinning_pair,
    "box on incline": lambda: scenes.box_on_incline(0.3, 0.2),
    "disc on incline": lambda: scenes.disc_on_incline(0.4, 0.5),
    "sliding disc": lambda: scenes.sliding_disc(3.0, 0.3),
    "disc in wedge": lambda: scenes.disc_in_wedge(0.5, 0.7),
    "ball on plank": lambda: scenes.ball_on_plank(0.6),
    "box landing flat": lambda: scenes.box_landing_flat(1, 3, 2.0, 0.5),
    "box stack": lambda: scenes.box_stack(6),
    "box pyramid": lambda: scenes.box_pyramid(6),
    "speed: gas": lambda: speed_scenes.gas(40).scene,
    "speed: dense gas": lambda: speed_scenes.dense_gas(30).scene,
    "speed: settled discs": lambda: speed_scenes.settled_discs(50).scene,
    "speed: stack": lambda: speed_scenes.stack(8).scene,
    "speed: pyramid": lambda: speed_scenes.pyramid(4).scene,
    "speed: bin": lambda: speed_scenes.bin_of_shapes(24).scene,
    "mixed heap": mixed_heap,
    "many boxes": many_boxes,
    "moving walls": moving_walls,
    "fast mix": fast_mix,
}
"""By name; they are built anew at each call."""
