"""Boxes that land on a corner: a rough impact in which normal and tangent act on each other.

A push at a corner, beside the centre of mass, also makes the corner slide; friction there also
lifts it or presses it down. So the normal impulse and the friction have to be found together.
An engine's sweeps approach that answer; the closed form states it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.formulas.energetic import energetic_impulse
from lesson_code.geometry.shapes import Polygon, Segment
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction
from lesson_code.simulation import simulate

STEP = 1e-12
"""s: an engine first moves the box for this time; then it is where the closed form has it. One that
lets bodies collide before it moves them finds it there, too, but for a few 1e-12 m."""

OVERLAP = 1e-9
"""Of the box's smaller side: without an overlap an engine sees no contact."""

STRONGEST = 0.9
"""Of the coupling, in random impacts: from 1 on, sweeps need not come to an end."""


@dataclass(frozen=True, eq=False)
class CornerImpact:
    """A box of 1 kg that meets a level floor with one corner.

    Attributes
    ----------
    scene : Scene
        The floor, and the box; no gravity.
    kind : str
        "sticks" or "slides", at the end of the impact.
    expected : ndarray, shape (3,)
        vx, vy, m/s, and w, rad/s, after the impact: the closed form by Newton's law.
    by_work : ndarray, shape (3,)
        The same by the energetic law, Stronge's.
    coupling : float
        mu abs(knt) / knn: how much friction changes what the normal impulse has to be.
    """

    scene: Scene
    kind: str
    expected: Any
    by_work: Any
    coupling: float


def corner_impact(
    width: float,
    height: float,
    angle: float,
    velocity: tuple[float, float],
    angular_velocity: float,
    restitution: float,
    friction: float,
) -> CornerImpact:
    """Return the impact of a box whose lowest corner is just in the floor.

    Parameters
    ----------
    width, height : float
        m.
    angle : float
        rad, counter-clockwise; no multiple of a right angle, so that one corner is the lowest.
    velocity : (float, float)
        Of the centre, m/s, downwards.
    angular_velocity : float
        rad/s.
    restitution, friction : float
        Of the pair.

    Examples
    --------
    A smooth square lands on its corner, which is right below the centre: it does not turn.

    >>> impact = corner_impact(1.0, 1.0, math.pi / 4, (0.0, -2.0), 0.0, 0.5, 0.0)
    >>> impact.expected.round(12) + 0.0
    array([0., 1., 0.])
    """
    surface = Material(restitution, friction)
    box, arm = box_on_corner(width, height, angle, velocity, angular_velocity, surface)
    floor = Body(Segment((-50, 0), (50, 0)), material=surface)
    inverse_inertia = 1 / box.shape.inertia_per_mass
    struck = Struck(1.0, inverse_inertia, velocity, angular_velocity, arm)
    impact = impact_with_friction(
        Struck(0.0, 0.0, (0, 0), 0.0, (0, 0)), struck, (0, 1), restitution, friction
    )
    after = np.array([*impact.velocities[1], impact.angular_velocities[1]])
    knn, knt = 1 + arm[0] ** 2 * inverse_inertia, -arm[0] * arm[1] * inverse_inertia
    ktt = 1 + arm[1] ** 2 * inverse_inertia
    vt, vn = velocity[0] - angular_velocity * arm[1], velocity[1] + angular_velocity * arm[0]
    jn, jt = energetic_impulse(vn, vt, knn, knt, ktt, restitution, friction)
    turned = (arm[0] * jn - arm[1] * jt) * inverse_inertia
    by_work = np.array([velocity[0] + jt, velocity[1] + jn, angular_velocity + turned])
    coupling = float(friction * abs(knt) / knn)
    return CornerImpact(Scene([floor, box]), impact.kind, after, by_work, coupling)


def box_on_corner(
    width: float,
    height: float,
    angle: float,
    velocity: tuple[float, float],
    angular_velocity: float,
    surface: Material,
) -> tuple[Body, Any]:
    """Return a box of 1 kg whose lowest corner is just in the floor after a step, and its arm.

    The arm leads from the centre to that corner, shape (2,), m. The arguments are those of
    :func:`corner_impact`.

    >>> box, arm = box_on_corner(1.0, 1.0, math.pi / 4, (0.0, 0.0), 0.0, Material())
    >>> arm.round(6) + 0.0
    array([ 0.      , -0.707107])
    """
    shape = Polygon.box(width, height)
    cos, sin = math.cos(angle), math.sin(angle)
    corners = np.array(shape.vertices) @ np.array([[cos, sin], [-sin, cos]])
    arm = corners[corners[:, 1].argmin()]
    lowered = -float(arm[1]) - OVERLAP * min(width, height)
    box = Body(
        shape,
        position=(-velocity[0] * STEP, lowered - velocity[1] * STEP),
        angle=angle - angular_velocity * STEP,
        velocity=velocity,
        angular_velocity=angular_velocity,
        mass=1.0,
        material=surface,
    )
    return box, arm


def random_corners(count: int, seed: int) -> Iterator[CornerImpact]:
    """Yield boxes from 0.1 to 3 m, turned, sliding and spinning, that meet a rough floor."""
    rng = np.random.default_rng(seed)
    found = 0
    while found < count:
        width, height = (10 ** rng.uniform(-1, 0.5, 2)).tolist()
        impact = corner_impact(
            width,
            height,
            angle=rng.uniform(0.2, 1.3),
            velocity=(rng.uniform(-3, 3), rng.uniform(-4, -1)),
            angular_velocity=rng.uniform(-2, 2),
            restitution=rng.uniform(0, 1),
            friction=rng.uniform(0, 1.5),
        )
        if impact.kind != "parts" and impact.coupling < STRONGEST:
            found += 1
            yield impact


def error(impact: CornerImpact, solver: str, iterations: int) -> float:
    """Return how far off a solver is after some sweeps, in parts of the largest velocity."""
    run = simulate(impact.scene, STEP, solver=solver, iterations=iterations, dt=STEP, sample="end")
    motion = np.column_stack((run.velocities[:, 1], run.angular_velocities[:, 1]))
    return float(np.abs(motion[-1] - impact.expected).max() / np.abs(motion).max())
