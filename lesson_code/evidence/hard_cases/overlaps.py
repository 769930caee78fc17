"""Hard cases: bodies that overlap or have no room. Position correction must not add speed."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import fastest, free, largest
from lesson_code.evidence.scenes.events import box
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, level_ground
from lesson_code.geometry.shapes import Circle, Polygon

THEME = "Overlaps"


def overlapped_pyramid() -> Scene:
    """Return four rows of boxes, each a quarter in the one below."""
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=1,
            position=(column - (4 - row) / 2, 0.375 + 0.75 * row),
            material=Material(0.0, 0.5),
        )
        for row in range(4)
        for column in range(4 - row)
    ]
    return Scene([level_ground(), *boxes], gravity=(0, -GRAVITY))


def launch_speed(trial: Trial) -> float:
    """Return the greatest upward speed in 2 s, m/s."""
    return max(float(trial.run(2.0).velocities[:, 1:, 1].max()), 0.0)


def discs_in_one_place(count: int = 10, restitution: float = 0.0) -> Scene:
    """Return equal discs with one centre, at rest, without gravity."""
    dull = Material(restitution)
    return Scene(Body(Circle(0.5), mass=1, position=(0, 3), material=dull) for _ in range(count))


def still_overlapping(trial: Trial) -> float:
    """Return the deepest overlap after 5 s, m; or the greatest speed ever, m/s, if that is more."""
    run = trial.run(5.0)
    return max(float(run.max_penetration[-1]), fastest(run))


def elastic_overlap(depth: float = 0.2) -> Scene:
    """Return two overlapping elastic discs of 1 kg and 1000 kg, at rest."""
    smooth = Material(restitution=1.0)
    return Scene(
        [
            Body(Circle(0.5), mass=1, material=smooth),
            Body(Circle(0.5), mass=1000, position=(1 - depth, 0), material=smooth),
        ]
    )


def speed_from_overlap(trial: Trial) -> float:
    """Return the greatest speed in 5 s, m/s."""
    return fastest(trial.run(5.0))


def crowded_box(side: int = 12) -> Scene:
    """Return discs at rest in a box that is a fifth too small for them."""
    room = 0.9 * side
    places = (np.arange(side) + 0.5) * (room / side)
    discs = [
        Body(Circle(0.5), mass=1, position=(x, y), material=Material(0.0))
        for x in places.tolist()
        for y in places.tolist()
    ]
    return Scene([*box(room, room, Material(0.0)), *discs])


def thrown_out(trial: Trial) -> float:
    """Return the greatest speed in 3 s, m/s; infinite if a disc has left the box."""
    run = trial.run(3.0)
    places = run.positions[-1, free(run.scene)]
    inside = bool(((places > 0) & (places < 0.9 * 12)).all())
    return fastest(run) if inside else float("inf")


def squeezed() -> Scene:
    """Return a ball between two blocks that close in at 1 m/s until they squeeze it."""
    blocks = [
        Body(Polygon.box(1, 2), position=(-1.5 * side, 0), velocity=(side, 0))
        for side in (1.0, -1.0)
    ]
    return Scene([*blocks, Body(Circle(0.5), mass=1)])


def squeezed_speed(trial: Trial) -> float:
    """Return the greatest speed of the ball in 0.9 s, m/s: the walls' 1 m/s is the most."""
    return fastest(trial.run(0.9))


def spinning_hit() -> Scene:
    """Return two rough discs that spin, and meet off centre."""
    rough = Material(0.5, 0.8)
    return Scene(
        [
            Body(Circle(0.5), mass=1, angular_velocity=8.0, material=rough),
            Body(
                Circle(0.5),
                mass=2,
                position=(1.5, 0.2),
                velocity=(-1, 0),
                angular_velocity=3.0,
                material=rough,
            ),
        ]
    )


def change_of_angular_momentum(trial: Trial) -> float:
    """Return the largest relative change of the angular momentum in a second."""
    run = trial.run(1.0)
    return largest(run.angular_momentum / run.angular_momentum[0] - 1)


CASES = (
    HardCase(
        name="overlap-recovery",
        theme=THEME,
        title="A pyramid whose boxes stand a quarter in each other",
        why="An overlap undone by force is a spring let go.",
        law="Undoing an overlap gives no speed.",
        scene=overlapped_pyramid,
        measure=launch_speed,
        unit="m/s",
        bound=0.5,
        reason="less than bodies get that fall by 13 mm",
    ),
    HardCase(
        name="coincident",
        theme=THEME,
        title="Ten discs in one place",
        why="There is no direction from a centre to itself.",
        law="They part, and none gets any speed.",
        scene=discs_in_one_place,
        measure=still_overlapping,
        unit="m",
        bound=1e-2,
        reason="a hundredth of a disc",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="elastic-overlap",
        theme=THEME,
        title="Two elastic discs, 1 kg and 1000 kg, a fifth in each other",
        why="Restitution must not see the speed at which an overlap is undone.",
        law="What has no energy gets none.",
        scene=elastic_overlap,
        measure=speed_from_overlap,
        unit="m/s",
        bound=1e-12,
        reason="rounding",
    ),
    HardCase(
        name="crowded",
        theme=THEME,
        title="144 discs in a box that is a fifth too small",
        why="There is no way to lie without overlap, and each step tries again.",
        law="No disc gets out, and none gets any speed.",
        scene=crowded_box,
        measure=thrown_out,
        unit="m/s",
        bound=1e-6,
        reason="a millimetre in a quarter of an hour",
    ),
    HardCase(
        name="squeezed",
        theme=THEME,
        title="A ball between two walls that close until there is no room",
        why="No impulse is right: whatever helps at one wall is wrong at the other.",
        law="The ball is nowhere faster than the walls.",
        scene=squeezed,
        measure=squeezed_speed,
        unit="m/s",
        bound=1.0 + 1e-9,
        reason="the walls' speed",
    ),
    HardCase(
        name="angular-momentum",
        theme=THEME,
        title="Two rough spinning discs meet",
        why="A step finds them in each other, and friction acts at two points, one on each rim.",
        law="Angular momentum is kept; pymunk's changes by overlap times jt.",
        scene=spinning_hit,
        measure=change_of_angular_momentum,
        unit="",
        bound=1e-12,
        reason="rounding",
        failed_by=("naive", "pymunk", "box2d"),
    ),
)
