"""What chapter 05 looks at: impacts with spin and friction, rolling, and rough slopes.

The body on the slope rolls, slides, stays or tips, and is compared with closed forms.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes.slopes import GRAVITY, STICKS, TIPPED, body_on_slope
from lesson_code.evidence.scenes.spinning_discs import (
    Disc,
    difference,
    hit,
    normal_between,
    random_impacts,
    scene_of,
)
from lesson_code.formulas import contact_velocity, friction_impulse
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.formulas.validation import Vector, finite, one_number
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.simulation import simulate

FrictionRule: TypeAlias = Callable[[float, float, float, float], float]
"""Takes vt, m/s, jn, N s, the friction coefficient and k, 1/kg; returns jt, N s."""


def on_slope(
    shape: Circle | Polygon,
    degrees: float,
    friction: float,
    *,
    solver: str = "sequential",
    iterations: int = 10,
    duration: float = 1.0,
    mass: float = 1.0,
) -> Run:
    """Return the run of a body that is let go on a slope; it is body 1.

    Parameters
    ----------
    shape, degrees, friction, mass
        As :func:`lesson_code.evidence.scenes.slopes.body_on_slope` takes them.
    solver, iterations, duration
        As :func:`lesson_code.simulate` takes them.

    Examples
    --------
    >>> run = on_slope(Circle(0.5), degrees=30, friction=0.0)
    >>> round(float(run.velocities[-1, 1, 0]), 9)
    4.905
    """
    scene = body_on_slope(shape, degrees, friction, mass=mass)
    return simulate(scene, duration, solver=solver, iterations=iterations)


def acceleration(
    shape: Circle | Polygon,
    degrees: float,
    friction: float,
    solver: str = "sequential",
    mass: float = 1.0,
) -> float:
    """Return how fast a body that is let go on a slope speeds up, m/s^2, over 1 s.

    >>> round(acceleration(Circle(0.5), degrees=30, friction=1.0), 9)
    3.27
    """
    run = on_slope(shape, degrees, friction, solver=solver, mass=mass)
    return float(run.velocities[-1, 1, 0])


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
        if abs(run.angles[-1, 1]) > TIPPED:
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
        s; whole steps are made.

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


def hit_wall(disc: Disc, normal: Vector, restitution: float, friction: float) -> Disc:
    """Return a disc after it has hit a rough wall whose unit normal points to it.

    The wall is a body of infinite mass; its size and place make no difference.

    >>> disc = Disc(1.0, 0.5, np.array([0.0, 0.5]), np.array([3.0, -4.0]))
    >>> disc = hit_wall(disc, np.array([0.0, 1.0]), restitution=0.5, friction=1.0)
    >>> disc.velocity, disc.angular_velocity
    (array([2., 2.]), -4.0)
    """
    wall = Disc(math.inf, 1.0, np.zeros(2), np.zeros(2))
    return hit(wall, disc, normal, restitution, friction)[1]


def bounce_with_spin(
    velocity: Vector,
    angular_velocity: float,
    radius: float,
    normal: Vector,
    restitution: float,
    friction: float,
) -> tuple[Any, float]:
    """Return velocity and angular velocity of a solid disc after it has hit a rough wall.

    This is :func:`hit_wall` in numbers, as the exercise asks for it. The mass makes no
    difference.

    >>> bounce_with_spin(np.array([3.0, -4.0]), 0.0, 0.5, np.array([0.0, 1.0]), 0.5, 1.0)
    (array([2., 2.]), -4.0)
    """
    disc = Disc(1.0, radius, np.zeros(2), velocity, angular_velocity)
    after = hit_wall(disc, normal, restitution, friction)
    return after.velocity, after.angular_velocity


def ball_hits_rod(arm: float, solver: str = "sequential") -> Run:
    """Return the run of a ball that flies up at 1 m/s into a level rod, `arm` m from its centre.

    Both have 1 kg, the rod is 2 m long, and nothing is lost. The ball is body 0.
    """
    elastic = Material(restitution=1.0)
    rod = Body(Segment((-1, 0), (1, 0)), mass=1.0, material=elastic)
    ball = Body(Circle(0.1), position=(arm, -0.7), velocity=(0, 1), mass=1.0, material=elastic)
    return simulate(Scene([ball, rod]), duration=2.5, solver=solver)


def thrown_with_backspin() -> Run:
    """Return the run of a rubber ball that is thrown to the right with 120 rad/s of backspin."""
    rubber = Material(restitution=0.8, friction=0.5)
    ground = Body(Segment((-20, 0), (20, 0)), material=rubber)
    thrown: dict[str, Any] = {"position": (0, 1.05), "velocity": (2, 0), "angular_velocity": 120}
    ball = Body(Circle(0.05), mass=1.0, material=rubber, **thrown)
    return simulate(Scene([ball, ground], gravity=(0, -9.81)), 2.5, dt=1 / 240, solver="sequential")


def worst_difference_from_pymunk(count: int, dt: float) -> tuple[float, float]:
    """Return how far the formulas are from pymunk's step, in parts of the fastest speed.

    The first figure is that at the positions to which pymunk has moved the discs, the second that
    at the positions where its step began; each is the worst of `count` random pairs.
    """
    at_moved, at_start = [], []
    for a, b, e, mu in random_impacts(count, seed=5):
        before = a.moved(-dt), b.moved(-dt)
        run = simulate(scene_of(*before, e, mu), dt, dt=dt, solver="pymunk", sample="end")
        at_moved.append(difference(hit(a, b, normal_between(a, b), e, mu), run))
        at_start.append(difference(hit(a, b, normal_between(*before), e, mu), run))
    return max(at_moved), max(at_start)


def set_down_sliding(k: float, solver: str) -> Run:
    """Return the run of a round body that is set down on a rough floor at 3 m/s; I = k m r^2."""
    floor = Body(Segment((-50, 0), (50, 0)))  # it names no friction of its own: the body's counts
    start: dict[str, Any] = {"position": (0, 0.499), "velocity": (3, 0)}  # 1 mm deep: they touch
    body = Body(Circle(0.5), mass=1.0, inertia=k * 0.25, material=Material(friction=0.3), **start)
    return simulate(Scene([body, floor], gravity=(0, -9.81)), duration=1.0, solver=solver)


def energy_kept_by_leaning_rod(sliding: float, solver: str) -> float:
    """Return the energy after over that before, of a rod that hits a rough floor with its end.

    It leans at 45 degrees, comes down at 1 m/s and slides at `sliding` m/s; e = 0.9 and mu = 1, by
    Newton's rule.
    """
    surface = Material(restitution=0.9, friction=1.0)
    lean: dict[str, Any] = {"angle": math.pi / 4, "position": (0, math.sqrt(0.5) + 5e-4)}
    rod = Body(Segment((-1, 0), (1, 0)), mass=1.0, velocity=(sliding, -1), material=surface, **lean)
    scene = Scene([rod, Body(Segment((-9, 0), (9, 0)))])
    run = simulate(scene, duration=0.002, dt=0.001, solver=solver, iterations=100)
    return float(run.kinetic_energy[-1] / run.kinetic_energy[0])


def sliding_over_bounces(rule: Callable[..., Any], count: int = 5) -> tuple[Any, list[float]]:
    """Return the numbers of bounces, and the sliding at the floor after each, m/s.

    A disc without spin comes at (3, -4) m/s, loses nothing (e = 1), and falls back each time;
    mu = 0.3.
    """
    velocity, w, sliding = np.array([3.0, -4.0]), 0.0, [3.0]
    up = np.array([0.0, 1.0])
    for _ in range(count):
        velocity, w = rule(velocity, w, 0.5, up, 1.0, 0.3)
        sliding.append(float(contact_velocity(velocity, w, -0.5 * up)[0]))
        velocity = velocity * (1, -1)
    return np.arange(count + 1), sliding
