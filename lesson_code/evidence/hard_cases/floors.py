"""Hard cases: floors, slopes and internal edges, where friction has closed forms."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Measure, Trial
from lesson_code.evidence.hard_cases.measures import largest, way_of
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes import slopes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.reference import rigid_body_closed_forms as closed

THEME = "Floors and slopes"

SUNK = 4e-4
"""Of a body of 1 m: how deep it stands in the floor at the start."""

DROP = 0.01
"""m: a body that slides over internal edges lands first, so that it sinks in a little."""


def pieces(friction: float = 0.0) -> list[Body]:
    """Return a floor of segments of 1 m, end to end."""
    surface = Material(0.0, friction)
    return [Body(Segment((n, 0), (n + 1, 0)), material=surface) for n in range(-3, 90)]


def slider_on_pieces(shape: Shape, height: float, speed: float) -> Scene:
    """Return a smooth body that lands on a floor of pieces, and slides; it is the last body."""
    body = Body(
        shape, mass=1, position=(0.3, height + DROP), velocity=(speed, 0), material=Material(0.0)
    )
    return Scene([*pieces(), body], gravity=(0, -scenes.GRAVITY))


def change_of_speed(shape: Shape, height: float) -> Measure:
    """Return a measure: the largest change of the speed in 8 s, over five speeds, m/s."""

    def measure(trial: Trial) -> float:
        worst = 0.0
        for speed in (1.0, 3.0, 5.0, 7.0, 10.0):
            run = trial.run(8.0, slider_on_pieces(shape, height, speed), sample="end")
            worst = max(worst, largest(run.velocities[-1, -1] - np.array([speed, 0.0])))
        return worst

    return measure


def roller_on_pieces() -> Scene:
    """Return a rough disc that lands on, and rolls over, a floor of pieces."""
    disc = Body(
        Circle(0.5),
        mass=1,
        position=(0.3, 0.5 + DROP),
        velocity=(3, 0),
        angular_velocity=-6,
        material=Material(0.0, 0.8),
    )
    return Scene([*pieces(0.8), disc], gravity=(0, -scenes.GRAVITY))


def rolling_error(trial: Trial) -> float:
    """Return the change of velocity in 8 s, m/s."""
    run = trial.run(8.0, sample="end")
    return largest([*(run.velocities[-1, -1] - [3.0, 0.0]), run.angular_velocities[-1, -1] / 2 + 3])


INERTIA_RATIOS = (0.5, 0.4, 1.0)
"""I / (m r^2) of a disc, a sphere and a hoop."""


def slide_to_roll_error(trial: Trial) -> float:
    """Return the largest error of the final speed, or of slip, of disc, sphere and hoop, m/s."""
    worst = 0.0
    for ratio in INERTIA_RATIOS:
        run = trial.run(3.0, scenes.sliding_disc(6.0, 0.5, ratio), sample="end")
        vx, w = float(run.velocities[-1, 1, 0]), float(run.angular_velocities[-1, 1])
        worst = max(worst, abs(vx - 6.0 / (1 + ratio)), abs(vx + w))
    return worst


SLOPE = 30.0
"""degrees; tan = 0.57735."""

FRICTIONS = (0.0, 0.2, 0.5, 0.57, 0.5773, 0.5774, 0.58, 0.9)
"""On both sides of tan 30 degrees."""


on_slope = partial(slopes.body_on_slope, sunk=SUNK)
"""A body that touches a slope from the start."""


def velocity_on_slope(trial: Trial, scene: Scene) -> float:
    """Return the speed down a slope after a second, m/s."""
    return float(trial.run(1.0, scene, sample="end").velocities[-1, 1, 0])


def box_on_slope_error(trial: Trial) -> float:
    """Return the largest error of a box's speed after a second, over all frictions, m/s."""
    theta, worst = math.radians(SLOPE), 0.0
    for mu in FRICTIONS:
        expected = max(closed.slide_down(theta, mu, slopes.GRAVITY), 0.0)
        scene = on_slope(Polygon.box(1, 1), SLOPE, mu)
        worst = max(worst, abs(velocity_on_slope(trial, scene) - expected))
    return worst


def disc_on_slope_error(trial: Trial) -> float:
    """Return the largest error of a disc's speed after a second, over all frictions, m/s."""
    theta, worst = math.radians(20.0), 0.0
    for mu in (0.0, 0.05, 0.12, 0.1213, 0.1214, 0.5, 2.0):
        expected, _ = closed.roll_down(theta, 0.5, mu, slopes.GRAVITY)
        worst = max(
            worst, abs(velocity_on_slope(trial, on_slope(Circle(0.5), 20.0, mu)) - expected)
        )
    return worst


def tips(trial: Trial, degrees: float) -> bool:
    """Return whether a box of 0.5 m by 1 m that cannot slide tips over within 5 s."""
    run = trial.run(5.0, on_slope(Polygon.box(0.5, 1), degrees, slopes.STICKS), sample="end")
    return bool(abs(run.angles[-1, 1]) > slopes.TIPPED)


def tipping_error(trial: Trial) -> float:
    """Return the error of the angle at which a tall box tips, degrees."""
    stands, falls = 20.0, 30.0
    while falls - stands > 1e-4:
        middle = (stands + falls) / 2
        stands, falls = (stands, middle) if tips(trial, middle) else (middle, falls)
    return abs(falls - math.degrees(closed.tipping_angle(0.5, 1.0)))


def creep(trial: Trial) -> float:
    """Return how far a box has crept down a slope in a minute, on which it should stay, m."""
    return way_of(trial.run(60.0, sample="end"))


def case(**settings: Any) -> HardCase:
    """Return a case of this theme."""
    return HardCase(theme=THEME, **settings)


CASES = (
    case(
        name="seams-disc",
        title="A smooth disc slides over the seams of a floor, 1 to 10 m/s, 8 s",
        why="It sinks in a little, and then meets the end of the next piece.",
        law="Without friction vx is constant.",
        scene=partial(slider_on_pieces, Circle(0.5), 0.5, 5.0),
        measure=change_of_speed(Circle(0.5), 0.5),
        unit="m/s",
        bound=1e-9,
        reason="rounding of places up to 80 m, in 480 steps",
        failed_by=("naive", "pymunk"),
    ),
    case(
        name="seams-box",
        title="A smooth box slides over the seams of a floor, 1 to 10 m/s, 8 s",
        why="Its front corner meets the end of the next piece, and the box trips.",
        law="Without friction vx is constant.",
        scene=partial(slider_on_pieces, Polygon.box(1, 1), 0.5, 5.0),
        measure=change_of_speed(Polygon.box(1, 1), 0.5),
        unit="m/s",
        bound=1e-9,
        reason="rounding of places up to 80 m, in 480 steps",
        failed_by=("naive", "pymunk"),
    ),
    case(
        name="seams-rolling",
        title="A rough disc rolls over the seams of a floor, 8 s",
        why="At a seam it touches two pieces, and friction acts on both.",
        law="v = -w r, and both constant",
        scene=roller_on_pieces,
        measure=rolling_error,
        unit="m/s",
        bound=1e-9,
        reason="rounding of places up to 24 m, in 480 steps",
        failed_by=("naive", "pymunk"),
    ),
    case(
        name="slide-to-roll",
        title="Disc, sphere and hoop slide until they roll",
        why="Friction has to stop exactly when the slip is 0, and not one step later.",
        law="v' = v / (1 + I / (m r^2)), slip 0",
        scene=partial(scenes.sliding_disc, 6.0, 0.5),
        measure=slide_to_roll_error,
        unit="m/s",
        bound=1e-9,
        reason="rounding of 180 steps",
        failed_by=("naive", "box2d"),
    ),
    case(
        name="box-on-slope",
        title="A box on 30 degrees, eight frictions around tan 30",
        why="A ten-thousandth of mu decides between sliding and rest.",
        law="a = g (sin - mu cos), or 0",
        scene=partial(on_slope, Polygon.box(1, 1), SLOPE, 0.5),
        measure=box_on_slope_error,
        unit="m/s",
        bound=1e-9,
        reason="rounding of 60 steps",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    case(
        name="disc-on-slope",
        title="A disc on 20 degrees, seven frictions around tan 20 / 3",
        why="A ten-thousandth of mu decides between slipping and rolling.",
        law="a = 2/3 g sin, or g (sin - mu cos)",
        scene=partial(on_slope, Circle(0.5), 20.0, 0.12),
        measure=disc_on_slope_error,
        unit="m/s",
        bound=1e-9,
        reason="rounding of 60 steps",
        failed_by=("naive",),
    ),
    case(
        name="tipping",
        title="At which slope does a box of 0.5 m by 1 m tip over?",
        why="Near the limit one corner carries nearly all.",
        law="atan(w / h) = 26.565 degrees",
        scene=partial(on_slope, Polygon.box(0.5, 1), 26.0, slopes.STICKS),
        measure=tipping_error,
        unit="deg",
        bound=0.01,
        reason="so little over that angle a box falls in 2 s, and it is watched for 5 s",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    case(
        name="creep",
        title="A box on 30 degrees with mu = 0.6, 60 s",
        why="Friction holds by a hair, and in 3600 steps a little slip adds up.",
        law="tan 30 < mu: it stays.",
        scene=partial(on_slope, Polygon.box(1, 1), SLOPE, 0.6),
        measure=creep,
        unit="m",
        bound=1e-9,
        reason="rounding of 3600 steps",
        failed_by=("naive",),
    ),
)
