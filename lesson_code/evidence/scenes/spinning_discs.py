"""Discs that hit with spin and friction: one whole impact, put together from the formulas.

Chapter 05 reads these lines, and asks pymunk about many random pairs of discs. An engine first
moves the bodies and then resolves their contact, so an impact belongs to the *moved* positions.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.formulas import (
    angular_momentum,
    contact_velocity,
    disc_inertia,
    effective_mass,
    friction_impulse,
    normal_impulse,
)
from lesson_code.formulas.arithmetic import cross, dot, perpendicular
from lesson_code.formulas.validation import Vector
from lesson_code.geometry.shapes import Circle

OVERLAP = 1e-9
"""Of the sum of the radii, at a random impact: without an overlap an engine sees no contact."""

STEP = 1e-12
"""s: in it discs of a random impact come nearer by less than a tenth of their overlap. So it does
not matter whether an engine moves them before they collide, or after."""


@dataclass(frozen=True)
class Disc:
    """A solid disc that moves and spins.

    Attributes
    ----------
    mass, radius : float
        kg and m; ``math.inf`` kg for one that nothing can push or turn.
    position, velocity : ndarray, shape (2,)
        m and m/s.
    angular_velocity : float
        rad/s, counter-clockwise.
    """

    mass: float
    radius: float
    position: Any
    velocity: Any
    angular_velocity: float = 0.0

    @property
    def inertia(self) -> float:
        """Moment of inertia about the centre, kg m^2."""
        return float(disc_inertia(self.mass, self.radius))

    @property
    def fastest(self) -> float:
        """The highest speed that a point of the disc may have, m/s."""
        return float(np.hypot(*self.velocity) + abs(self.angular_velocity) * self.radius)

    def angular_momentum(self, about: Vector) -> float:
        """Return its angular momentum about a point, kg m^2/s, of its path and of its spin."""
        moving = (self.mass, self.position, self.velocity)
        return float(angular_momentum(*moving, self.inertia, self.angular_velocity, about))

    def moved(self, dt: float) -> Disc:
        """Return the disc a time dt later, or earlier where dt is negative."""
        return replace(self, position=self.position + self.velocity * dt)

    def pushed(self, impulse: Vector, lever: Vector) -> Disc:
        """Return the disc after an impulse, N s, that acts at `lever` from its centre."""
        return replace(
            self,
            velocity=self.velocity + impulse / self.mass,
            angular_velocity=self.angular_velocity + float(cross(lever, impulse)) / self.inertia,
        )


def hit(a: Disc, b: Disc, normal: Vector, restitution: float, friction: float) -> tuple[Disc, Disc]:
    """Return two discs after they have hit each other.

    Parameters
    ----------
    a, b : Disc
        The discs before; one may have an infinite mass.
    normal : ndarray, shape (2,)
        Unit normal from a to b, at the impact.
    restitution, friction : float
        Of the pair: 0 to 1, and >= 0.

    Returns
    -------
    (a, b) : tuple of Disc
        With the velocities after; discs that part already keep theirs.

    Examples
    --------
    A disc meets an equal one at rest; the grip is strong enough to stop the sliding.

    >>> a = Disc(1.0, 1.0, np.array([0.0, 0.0]), np.array([4.0, 3.0]))
    >>> b = Disc(1.0, 1.0, np.array([2.0, 0.0]), np.array([0.0, 0.0]))
    >>> a, b = hit(a, b, normal_between(a, b), restitution=1.0, friction=1.0)
    >>> a.velocity, a.angular_velocity, b.velocity, b.angular_velocity
    (array([0. , 2.5]), -1.0, array([4. , 0.5]), -1.0)
    """
    tangent = perpendicular(normal)
    r_a, r_b = a.radius * normal, -b.radius * normal
    v_a = contact_velocity(a.velocity, a.angular_velocity, r_a)
    v_b = contact_velocity(b.velocity, b.angular_velocity, r_b)
    inverses = (1 / a.mass, 1 / b.mass, 1 / a.inertia, 1 / b.inertia)
    m_eff_n = effective_mass(*inverses, cross(r_a, normal), cross(r_b, normal))
    m_eff_t = effective_mass(*inverses, cross(r_a, tangent), cross(r_b, tangent))
    jn = normal_impulse(dot(v_b - v_a, normal), m_eff_n, restitution)
    jt = friction_impulse(dot(v_b - v_a, tangent), m_eff_t, friction, jn)
    impulse = jn * normal + jt * tangent
    return a.pushed(-impulse, r_a), b.pushed(impulse, r_b)


def normal_between(a: Disc, b: Disc) -> Any:
    """Return the unit normal from a to b, shape (2,); their centres must differ."""
    to_b = b.position - a.position
    return to_b / np.hypot(*to_b)


def scene_of(a: Disc, b: Disc, restitution: float, friction: float) -> Scene:
    """Return two discs as a scene, without gravity, to be given to an engine."""
    surface = Material(restitution=restitution, friction=friction)
    return Scene(
        [
            Body(
                Circle(disc.radius),
                position=disc.position,
                velocity=disc.velocity,
                angular_velocity=disc.angular_velocity,
                mass=disc.mass,
                material=surface,
            )
            for disc in (a, b)
        ]
    )


def difference(discs: tuple[Disc, Disc], run: Run) -> float:
    """Return how far two discs are from the last state of a run, part of their fastest speed.

    The largest difference of a velocity, or of how fast a rim goes round.
    """
    apart = [
        max(
            float(np.hypot(*(disc.velocity - run.velocities[-1, i]))),
            float(abs(disc.angular_velocity - run.angular_velocities[-1, i])) * disc.radius,
        )
        for i, disc in enumerate(discs)
    ]
    return max(apart) / max(disc.fastest for disc in discs)


def random_impacts(count: int, seed: int) -> Iterator[tuple[Disc, Disc, float, float]]:
    """Yield discs at the moment of their impact, with the pair's restitution and friction.

    Masses lie between 1e-3 and 1e3 kg, radii between 0.1 and 10 m, velocities and those of the
    rim within 10 m/s, restitution and friction between 0 and 1. All pairs approach.
    """
    rng = np.random.default_rng(seed)
    for _ in range(count):
        turn, (r_a, r_b) = rng.uniform(0, 2 * np.pi), (10 ** rng.uniform(-1, 1, 2)).tolist()
        to_b = np.array([np.cos(turn), np.sin(turn)])
        v, approach = rng.uniform(-5, 5, 2), rng.uniform(0.1, 10)
        sliding = rng.uniform(-5, 5) * perpendicular(to_b)
        centre, distance = rng.uniform(-5, 5, 2), (1 - OVERLAP) * (r_a + r_b)
        a = _disc(rng, r_a, centre, v)
        b = _disc(rng, r_b, centre + distance * to_b, v - approach * to_b + sliding)
        yield a, b, float(rng.uniform(0, 1)), float(rng.uniform(0, 1))


def _disc(rng: np.random.Generator, radius: float, position: Any, velocity: Any) -> Disc:
    """Return a disc with a mass and a spin at random."""
    spin = float(rng.uniform(-10, 10)) / radius
    return Disc(float(10 ** rng.uniform(-3, 3)), radius, position, velocity, spin)
