"""Hard cases: fast bodies. A step can jump over a contact, which its end does not show."""

from __future__ import annotations

from functools import partial

import numpy as np

from lesson_code.engine.core.scene import Body, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import largest
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.geometry.shapes import Circle, Polygon, Segment

THEME = "Fast bodies"

DT = 1 / 60
"""s."""

SPEEDS = (1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6)
"""m/s."""

TURNINGS = (2.0, 5.0, 10.0, 20.0, 40.0, 100.0)
"""rad/s."""


def through_wall(trial: Trial) -> float:
    """Return the largest share of the balls that get through a wall, over all speeds."""
    worst = 0.0
    for speed in SPEEDS:
        scene = exact_scenes.balls_at_wall(speed, count=20, dt=DT, thickness=0.01)
        run = trial.run(1 / speed + 0.1, scene, sample="end")
        worst = max(worst, exact_scenes.share_beyond(run))
    return worst


def passed_by_rod(trial: Trial) -> float:
    """Return the largest share of the balls that a turning rod misses, over all rates."""
    worst = 0.0
    for turning in TURNINGS:
        missed = 0
        for phase in ((np.arange(10) + 0.5) / 10).tolist():
            scene = exact_scenes.turning_rod(turning, phase=phase, dt=DT)
            run = trial.run(0.6 / turning + 2 * DT, scene, sample="end")
            missed += not run.velocities[-1, 1].any()
        worst = max(worst, missed / 10)
    return worst


def ball_at_plate(speed: float, phase: float = 0.5) -> Scene:
    """Return a free plate of 1 kg, 1 cm thick, and a ball of 1 kg on its way to it; elastic."""
    plate = Body(Polygon.box(0.01, 2), mass=1, material=exact_scenes.ELASTIC)
    ball = Body(
        Circle(0.1),
        mass=1,
        position=(-0.2 - phase * speed * DT, 0),
        velocity=(speed, 0),
        material=exact_scenes.ELASTIC,
    )
    return Scene([plate, ball])


def plate_error(trial: Trial) -> float:
    """Return the largest relative error of both velocities, which should be exchanged."""
    worst = 0.0
    for speed in (10.0, 100.0, 1e3):
        for phase in (0.1, 0.3, 0.5, 0.7, 0.9):
            run = trial.run(0.2, ball_at_plate(speed, phase), sample="end")
            found = run.velocities[-1, :, 0] / speed
            worst = max(worst, largest(found - [1.0, 0.0]))
    return worst


def ball_in_cage(speed: float = 1e4) -> Scene:
    """Return an elastic ball in a closed box of 4 m by 3 m; its walls have no thickness."""
    ball = Body(
        Circle(0.25),
        mass=1,
        position=(1.1, 0.9),
        velocity=(0.8 * speed, 0.6 * speed),
        material=exact_scenes.ELASTIC,
    )
    return Scene([*exact_scenes.box(4.0, 3.0), ball])


def out_of_cage(trial: Trial) -> float:
    """Return how far outside the box the ball gets in a second, m."""
    places = trial.run(1.0).positions[:, 4]
    beyond = np.maximum(-places, places - [4.0, 3.0])
    return max(largest(np.maximum(beyond, 0.0)), 0.0)


def shot_at_tower() -> Scene:
    """Return a pile of three boxes, and a small ball that falls on it at 200 m/s."""
    boxes = [Body(Polygon.box(1, 1), mass=1, position=(0, 0.5 + n)) for n in range(3)]
    ball = Body(Circle(0.2), mass=0.01, position=(0, 30), velocity=(0, -200))
    return Scene([Body(Segment((-50, 0), (50, 0))), *boxes, ball], gravity=(0, -10))


def below_the_top(trial: Trial) -> float:
    """Return how far the ball has sunk below the top of the pile in half a second, m."""
    heights = trial.run(0.5).positions[:, 4, 1]
    return max(3.0 - float(heights.min()), 0.0)


CASES = (
    HardCase(
        name="tunnelling",
        theme=THEME,
        title="Balls from 1 to 1,000,000 m/s at a wall of 1 cm",
        why="A step ends before the wall, and the next one ends behind it.",
        law="pymunk: the part 1 - (r + th/2) / (v dt) gets through; nothing should.",
        scene=partial(exact_scenes.balls_at_wall, 100.0, count=20, dt=DT, thickness=0.01),
        measure=through_wall,
        unit="",
        bound=0.0,
        reason="a wall is a wall",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="turning-rods",
        theme=THEME,
        title="Rods that turn at 2 to 100 rad/s sweep over a ball",
        why="The rod's middle stands still; only its ends are fast.",
        law="A ball in the way of a rod is hit.",
        scene=partial(exact_scenes.turning_rod, 20.0, phase=0.5, dt=DT),
        measure=passed_by_rod,
        unit="",
        bound=0.0,
        reason="a ball in the way is in the way",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="free-plate",
        theme=THEME,
        title="A ball at 10 to 1,000 m/s hits a free plate of 1 cm",
        why="Both bodies move; an engine that looks out for walls alone misses the plate.",
        law="Equal masses, e = 1: they change velocities.",
        scene=partial(ball_at_plate, 100.0),
        measure=plate_error,
        unit="",
        bound=1e-9,
        reason="rounding of the place at which the ball meets the plate",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="cage",
        theme=THEME,
        title="A ball at 10,000 m/s in a box of 4 m by 3 m, 1 s",
        why="Nearly 5,000 bounces, and one missed is the last.",
        law="What is inside stays inside.",
        scene=ball_in_cage,
        measure=out_of_cage,
        unit="m",
        bound=0.0,
        reason="its centre is never beyond a wall",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="shot-at-tower",
        theme=THEME,
        title="A ball of 10 g falls on three boxes at 200 m/s",
        why="It moves by 3.3 m in a step: through all three.",
        law="What is on top stays on top.",
        scene=shot_at_tower,
        measure=below_the_top,
        unit="m",
        bound=0.1,
        reason="half of the ball's radius: the pile gives a little",
        failed_by=("naive", "pymunk"),
    ),
)
