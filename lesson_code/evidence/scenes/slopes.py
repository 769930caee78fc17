"""A body on a rough slope, to be compared with closed forms: it rolls, slides, stays or tips.

A slope is a floor on which gravity is tilted. So the floor is left level, and gravity is tilted:
x points down the slope, y away from it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.formulas import friction_impulse
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.formulas.validation import finite, one_number
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.simulation import simulate

FrictionRule: TypeAlias = Callable[[float, float, float, float], float]
"""Takes vt, m/s, jn, N s, the friction coefficient and k, 1/kg; returns jt, N s."""

GRAVITY = 9.81
"""m/s^2."""

HALF_LENGTH = 100.0
"""m: of the slope; far more than a body slides in some seconds."""

TIPPED = 0.2
"""rad: a box that is turned so far does not come back; one that stands turns by less than 1e-3."""

STICKS = 2.0
"""A friction coefficient at which nothing slides on a slope below 63 degrees."""


def on_slope(
    shape: Circle | Polygon,
    degrees: float,
    friction: float,
    *,
    solver: str = "sequential",
    iterations: int = 10,
    duration: float = 1.0,
) -> Run:
    """Return the run of a body of 1 kg that is let go on a slope.

    Parameters
    ----------
    shape : Circle or Polygon
        It begins to touch the slope with its lowest point or edge.
    degrees : float
        How steep the slope is, from the horizontal.
    friction : float
        Friction coefficient of body and slope, >= 0; the restitution is 0.
    solver, iterations
        As :func:`lesson_code.simulate` takes them.
    duration : float
        s, >= 0.

    Returns
    -------
    Run
        Body 0 is the one on the slope; x points down the slope.

    Examples
    --------
    >>> run = on_slope(Circle(0.5), degrees=30, friction=0.0)
    >>> round(float(run.velocities[-1, 0, 0]), 9)
    4.905
    """
    theta = np.radians(one_number("degrees", degrees, finite))
    lowest = -shape.radius if isinstance(shape, Circle) else min(y for _, y in shape.outline)
    surface = Material(restitution=0.0, friction=friction)
    body = Body(shape, position=(0.0, -lowest), mass=1.0, material=surface)
    slope = Body(Segment((-HALF_LENGTH, 0), (HALF_LENGTH, 0)))
    scene = Scene([body, slope], gravity=(GRAVITY * np.sin(theta), -GRAVITY * np.cos(theta)))
    return simulate(scene, duration, solver=solver, iterations=iterations)


def acceleration(
    shape: Circle | Polygon, degrees: float, friction: float, solver: str = "sequential"
) -> float:
    """Return how fast a body that is let go on a slope speeds up, m/s^2, over 1 s.

    >>> round(acceleration(Circle(0.5), degrees=30, friction=1.0), 9)
    3.27
    """
    return float(on_slope(shape, degrees, friction, solver=solver).velocities[-1, 0, 0])


def tipping_angle(
    width: float,
    height: float,
    *,
    solver: str = "sequential",
    iterations: int = 10,
    within: float = 0.01,
) -> float:
    """Return on how steep a slope a box tips over that cannot slide, in degrees.

    The interval from 1 to 60 degrees is halved until it is shorter than `within`; each time a
    box is watched for 3 s.

    >>> round(tipping_angle(1.0, 1.0, iterations=50, within=0.1))
    45
    """
    w, h = width / 2, height / 2
    box = Polygon([(-w, -h), (w, -h), (w, h), (-w, h)])
    stands, tips = 1.0, 60.0
    while tips - stands > within:
        middle = (stands + tips) / 2
        run = on_slope(box, middle, STICKS, solver=solver, iterations=iterations, duration=3.0)
        if abs(run.angles[-1, 0]) > TIPPED:
            tips = middle
        else:
            stands = middle
    return tips


def block_in_steps(
    rule: FrictionRule, degrees: float, friction: float, *, duration: float, dt: float = 1 / 240
) -> float:
    """Return how far a block of 1 kg slides down a slope, stepped with a friction rule, m.

    v += g sin(theta) dt,   v += jt / m with jn = m g cos(theta) dt,   x += v dt

    The smallest loop in which a friction rule can go wrong: a block that cannot turn, at rest at
    the start.

    Parameters
    ----------
    rule : callable
        Takes vt, jn, friction and k = 1/m, and returns jt: the rule of the exercise, or a wrong
        model of it.
    degrees : float
        How steep the slope is.
    friction : float
        Friction coefficient, >= 0.
    duration, dt : float
        s; so many whole steps are made.

    Examples
    --------
    >>> round(block_in_steps(coulomb, 30, 0.0, duration=2.0), 2)
    9.83
    >>> block_in_steps(coulomb, 30, 1.0, duration=2.0)
    0.0
    """
    theta = np.radians(one_number("degrees", degrees, finite))
    x = v = 0.0
    for _ in range(whole_parts(duration, dt)):
        v += GRAVITY * np.sin(theta) * dt
        v += rule(v, GRAVITY * np.cos(theta) * dt, friction, 1.0)
        x += v * dt
    return float(x)


def coulomb(vt: float, jn: float, friction: float, k: float) -> float:
    """Return the friction impulse of a contact that yields by k, 1/kg: the exercise's form.

    >>> coulomb(vt=3.0, jn=4.0, friction=0.5, k=0.5)
    -2.0
    """
    return float(friction_impulse(vt, 1 / k, friction, jn))
