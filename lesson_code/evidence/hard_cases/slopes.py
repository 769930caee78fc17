"""Families of floors, slopes and seams, where friction has closed forms."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.balance import BESIDE, stay_or_go
from lesson_code.evidence.hard_cases.measures import DT, HAIR, largest, sideways, start_gap, way_of
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes import slopes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.reference import rigid_body_closed_forms as closed

THEME = "Floors and slopes"

DROP = 0.01
"""m: a body that slides over internal edges lands first, so that it sinks in a little."""

STEPS_ROUND = "rounding of some hundred steps"


def pieces(friction: float = 0.0, length: float = 1.0, count: int = 93) -> list[Body]:
    """Return a floor of segments, end to end."""
    surface = Material(0.0, friction)
    first = Segment((0, 0), (length, 0))
    return [Body(first, position=((n - 3) * length, 0), material=surface) for n in range(count)]


def slider_on_pieces(
    shape: Shape, height: float, speed: float, drop: float = DROP, length: float = 1.0
) -> Scene:
    """Return a smooth body that lands on a floor of pieces, and slides; it is the last body."""
    body = Body(
        shape, mass=1, position=(0.3, height + drop), velocity=(speed, 0), material=Material(0.0)
    )
    return Scene([*pieces(length=length), body], gravity=(0, -scenes.GRAVITY))


def beside(draw: Draw, limit: float) -> tuple[float, bool]:
    """Return a friction a little above or below its limit, and whether it is above."""
    off, above = draw.log_uniform("beside", *BESIDE), draw.choice("above", (1, 0))
    return limit * (1 + off if above else 1 - off), bool(above)


@family(
    THEME,
    why="A ten-thousandth of mu decides between sliding and rest.",
    law="a = g (sin - mu cos), or 0",
    unit="m/s",
    bound=1e-8,
    reason=STEPS_ROUND,
)
def box_on_slope(draw: Draw, trial: Trial) -> float:
    """A box on any slope, with a friction beside the critical one: its speed after a second."""
    degrees, width = draw.uniform("degrees", 5, 50), draw.uniform("width", 0.5, 3.0)
    theta = math.radians(degrees)
    mu, _ = beside(draw, math.tan(theta))
    height = width * min(1.0, 0.8 / math.tan(theta))  # too low to tip
    scene = slopes.body_on_slope(Polygon.box(width, height), degrees, mu, sunk=-start_gap(draw))
    expected = max(closed.slide_down(theta, mu, slopes.GRAVITY), 0.0)
    return abs(float(trial.run(scene, 1.0).velocities[-1, 1, 0]) - expected)


@family(
    THEME,
    why="Friction holds by a hair, and in 1200 steps a little slip adds up.",
    law="mu > tan: it stays.",
    unit="m",
    bound=1e-8,
    reason="rounding of 1200 steps",
)
def creep_on_slope(draw: Draw, trial: Trial) -> float:
    """A box or a stack of two on a slope that is a little too rough to slide, 20 s."""
    degrees = draw.uniform("degrees", 5, 20)
    off, count = draw.log_uniform("beside", *BESIDE), draw.integer("count", 1, 2)
    mu = math.tan(math.radians(degrees)) * (1 + off)
    slope, box = slopes.body_on_slope(Polygon.box(1, 1), degrees, mu).bodies
    boxes = [
        Body(box.shape, mass=1, position=(0, 0.5 + n), material=box.material) for n in range(count)
    ]
    theta = math.radians(degrees)
    gravity = (slopes.GRAVITY * math.sin(theta), -slopes.GRAVITY * math.cos(theta))
    return sideways(trial.run(Scene([slope, *boxes], gravity=gravity), 20.0))


@family(
    THEME,
    why="A ten-thousandth of mu decides between slipping and rolling.",
    law="a = 2/3 g sin, or g (sin - mu cos)",
    unit="m/s",
    bound=1e-8,
    reason=STEPS_ROUND,
)
def disc_on_slope(draw: Draw, trial: Trial) -> float:
    """A disc on any slope, with a friction beside the one that makes it roll: its speed at 1 s."""
    degrees, radius = draw.uniform("degrees", 2, 70), draw.log_uniform("radius", 0.05, 5.0)
    theta = math.radians(degrees)
    mu, _ = beside(draw, closed.friction_to_roll(theta, 0.5))
    scene = slopes.body_on_slope(Circle(radius), degrees, mu, sunk=-start_gap(draw))
    expected, _ = closed.roll_down(theta, 0.5, mu, slopes.GRAVITY)
    return abs(float(trial.run(scene, 1.0).velocities[-1, 1, 0]) - expected)


@family(
    THEME,
    why="Near the limit one corner carries nearly all.",
    law="A box that cannot slide tips over from atan(w / h) on.",
    unit="m",
    bound=1e-3,
    reason="a thousandth of the box's height; what tips moves further",
)
def tipping_box(draw: Draw, trial: Trial) -> float:
    """A box of any shape on a slope on either side of its tipping angle, 5 s."""
    width, stays = draw.uniform("width", 0.1, 0.6), draw.choice("stays", (1, 0))
    limit = math.degrees(closed.tipping_angle(width, 1.0))
    off = draw.log_uniform("beside", 1e-3, 0.1)
    degrees = limit * (1 - off if stays else 1 + off)
    scene = slopes.body_on_slope(
        Polygon.box(width, 1), degrees, slopes.STICKS, sunk=-start_gap(draw, most=HAIR)
    )
    return stay_or_go(bool(stays), way_of(trial.run(scene, 5.0)))


@family(
    THEME,
    why="Friction has to stop exactly when the slip is 0, and not one step later.",
    law="v' = v / (1 + I / (m r^2)), slip 0",
    unit="m/s",
    bound=1e-8,
    reason=STEPS_ROUND,
)
def slide_to_roll(draw: Draw, trial: Trial) -> float:
    """A round body of any moment of inertia slides until it rolls: final speed, and slip."""
    ratio, speed = draw.uniform("inertia_ratio", 0.1, 1.0), draw.uniform("speed", 0.5, 8.0)
    friction = draw.uniform("friction", 0.3, 1.0)
    run = trial.run(scenes.sliding_disc(speed, friction, ratio), 4.0)
    vx, w = float(run.velocities[-1, 1, 0]), float(run.angular_velocities[-1, 1])
    return max(abs(vx - speed / (1 + ratio)), abs(vx + w))


@family(
    THEME,
    why="The step in which the body stops has to take only what is left.",
    law="It comes to rest after v^2 / (2 mu g).",
    unit="",
    bound=1.0,
    reason="in units of v dt: a stepped engine knows when it begins and ends to within a step",
)
def slide_to_rest(draw: Draw, trial: Trial) -> float:
    """A flat box slides on a rough floor until it rests: error of the distance."""
    speed, mu = draw.uniform("speed", 0.5, 10.0), draw.uniform("friction", 0.1, 1.0)
    box = Body(
        Polygon.box(2.0, 0.5),
        mass=draw.log_uniform("mass", 1e-3, 1e3),
        position=(0, 0.25 + start_gap(draw, most=HAIR)),
        velocity=(speed, 0),
        material=Material(0.0, mu),
    )
    stop = speed / (mu * scenes.GRAVITY)
    run = trial.run(Scene([scenes.level_ground(), box], gravity=(0, -scenes.GRAVITY)), stop + 1.0)
    error = abs(float(run.positions[-1, 1, 0]) - speed * stop / 2) / (speed * DT)
    return error if largest(run.velocities[-1, 1]) < 1e-6 else math.inf


@family(
    THEME,
    why="It sinks in a little, and then meets the end of the next piece.",
    law="Without friction vx is constant.",
    unit="m/s",
    bound=1e-9,
    reason="rounding of places up to 40 m, in 240 steps",
)
def seams_under_disc_or_box(draw: Draw, trial: Trial) -> float:
    """A smooth disc or box slides over the seams of a floor at 1 to 10 m/s, 4 s."""
    shapes: dict[str, Shape] = {"disc": Circle(0.5), "box": Polygon.box(1, 1)}
    shape = shapes[draw.choice("shape", ("disc", "box"))]
    speed = draw.uniform("speed", 1.0, 10.0)
    drop = draw.choice("drop", (0.0, draw.log_uniform("drop_by", 1e-6, 0.1)))
    scene = slider_on_pieces(shape, 0.5, speed, drop, draw.uniform("length", 0.5, 2.0))
    return largest(trial.run(scene, 4.0).velocities[-1, -1] - np.array([speed, 0.0]))


@family(
    THEME,
    why="At a seam it touches two pieces, and friction acts on both.",
    law="v = -w r, and both constant",
    unit="m/s",
    bound=1e-9,
    reason="rounding of places up to 24 m, in 240 steps",
)
def seams_under_wheel(draw: Draw, trial: Trial) -> float:
    """A rough disc rolls over the seams of a floor, 4 s."""
    speed, radius = draw.uniform("speed", 1.0, 6.0), draw.uniform("radius", 0.2, 1.0)
    mu, length = draw.uniform("friction", 0.1, 1.0), draw.uniform("length", 0.5, 2.0)
    disc = Body(
        Circle(radius),
        mass=1,
        position=(0.3, radius + draw.choice("drop", (0.0, DROP))),
        velocity=(speed, 0),
        angular_velocity=-speed / radius,
        material=Material(0.0, mu),
    )
    scene = Scene([*pieces(mu, length), disc], gravity=(0, -scenes.GRAVITY))
    run = trial.run(scene, 4.0)
    spin = run.angular_velocities[-1, -1] * radius
    return largest([*(run.velocities[-1, -1] - [speed, 0.0]), spin + speed])


@family(
    THEME,
    why="Each box slides on another, which slides itself: every contact has its own cone.",
    law="Below the friction that holds it, the upper box slides with a = mu g; above, with it.",
    unit="m/s",
    bound=1e-8,
    reason=STEPS_ROUND,
)
def box_on_moving_plank(draw: Draw, trial: Trial) -> float:
    """A box lies on a plank that slides on a smooth floor: both speeds after half a second."""
    speed, mu = draw.uniform("speed", 0.2, 4.0), draw.uniform("friction", 0.05, 1.0)
    box_mass, plank_mass = draw.log_uniform("box", 1e-2, 1e2), draw.log_uniform("plank", 1e-2, 1e2)
    gap, smooth, rough = start_gap(draw, 2), Material(0.0, 0.0), Material(0.0, mu)
    floor = Body(Segment((-100, 0), (100, 0)), material=smooth)
    plank = Body(
        Polygon.box(12, 0.5), mass=plank_mass, position=(0, 0.25 + gap), velocity=(speed, 0),
        material=rough,
    )  # fmt: skip
    box = Body(Polygon.box(2, 0.5), mass=box_mass, position=(0, 0.75 + 2 * gap), material=rough)
    scene = Scene([floor, plank, box], gravity=(0, -scenes.GRAVITY))
    return largest(
        trial.run(scene, 0.5).velocities[-1, 1:, 0] - _after(speed, mu, box_mass, plank_mass)
    )


def _after(speed: float, mu: float, box: float, plank: float) -> list[float]:
    """Return the speeds of plank and box after half a second of friction between them, m/s."""
    common = speed * plank / (plank + box)
    force, time = mu * box * scenes.GRAVITY, 0.5
    if force * time / box >= common:
        return [common, common]
    return [speed - force * time / plank, force * time / box]
