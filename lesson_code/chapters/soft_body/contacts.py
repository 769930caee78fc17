"""Contacts of soft rings: each mass against the skin of every other ring, against ledges and walls.

A ring's skin runs from mass to mass, so that nothing slips in between two of them, however far
apart they are pulled. A contact with the skin pushes the two masses at the ends of that piece, each
by its share, and the mass that touches it by the opposite: momentum is kept.

    gap + h un >= 0,   jn >= 0        un, ut: velocity of the mass relative to the skin
    abs(jt) <= mu jn                  and against ut

No contact closes faster than its gap allows, so that nothing enters anything; nothing bounces.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.formulas.arithmetic import dot

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]

SWEEPS = 10
"""Over all contacts at once, in each of which a mass shares its impulses among its contacts."""

MARGIN = 0.02
"""m: contacts are seen so far ahead, and as far as the fastest mass moves in a step."""

PUSHED_OUT = 0.5
"""Of an overlap, which only a mass that is added or a wall behind it can bring about, in a step."""


class Ledge(NamedTuple):
    """A thick line with round ends that nothing moves, m."""

    start: tuple[float, float]
    end: tuple[float, float]
    radius: float


class Contacts(NamedTuple):
    """Masses that may touch something within a step; K rows."""

    masses: Ints
    """(K, 3): the mass, and those at the ends of a piece of skin."""
    shares: Floats
    """(K, 3): 1, and minus the shares of the ends; 0 for what cannot be pushed."""
    normals: Floats
    """(K, 2), unit, towards the mass."""
    gaps: Floats
    """(K,), m; < 0 where they overlap."""


class Walls(NamedTuple):
    """The velocities that the walls of a room allow each mass in a step, (N, 2), m/s."""

    slowest: Floats
    fastest: Floats


class Skins:
    """Rings of equally many masses, and ledges among them.

    Parameters
    ----------
    masses : int
        In each ring.
    radius : float
        m: half the thickness of the skin, and the radius of a mass.
    ledges : sequence of Ledge
        What cannot be moved.
    """

    def __init__(self, masses: int, radius: float, ledges: tuple[Ledge, ...]) -> None:
        self._ring, self._radius, self._ledges = masses, radius, ledges
        self._tips = np.array([end for ledge in ledges for end in ledge[:2]]).reshape(-1, 2)
        self._thick = np.array([ledge.radius for ledge in ledges for _ in range(2)])

    def contacts(self, p: Floats, reach: float) -> Contacts:
        """Return the contacts that are nearer than a reach, m, for masses at p, (N, 2)."""
        found = [self._with_rings(p, reach)]
        found += [self._with_ledge(p, ledge, reach) for ledge in self._ledges]
        return Contacts(*(np.concatenate(column) for column in zip(*found, strict=True)))

    def gaps(self, p: Floats) -> Floats:
        """Return how far each mass, and each end of a ledge, is from each ring's skin, m.

        Shape (N + ends, rings); infinite for a mass and its own ring.
        """
        return self._nearest(p)[0]

    def _nearest(self, p: Floats) -> tuple[Floats, Ints, Floats, Floats]:
        """Return gap, piece of skin, place along it and normal, of each point and each ring."""
        rings, m = len(p) // self._ring, self._ring
        following = np.roll(p.reshape(rings, m, 2), -1, axis=1).reshape(-1, 2)
        points = np.concatenate((p, self._tips))
        x, y = (points[:, None, axis] - p[None, :, axis] for axis in (0, 1))
        ex, ey = (following - p).T
        along = np.clip((x * ex + y * ey) / np.maximum(ex * ex + ey * ey, 1e-12), 0.0, 1.0)
        cx, cy = x - along * ex, y - along * ey
        squares = (cx * cx + cy * cy).reshape(-1, rings, m)
        flat = squares.argmin(axis=2) + m * np.arange(rings)
        n = np.arange(len(points))[:, None]
        crosses = ((y < 0) != (y < ey)) & (x < ex * y / np.where(ey == 0, 1.0, ey))
        inside = crosses.reshape(-1, rings, m).sum(axis=2) % 2 == 1
        distance = np.sqrt(squares.reshape(len(points), -1)[n, flat])
        sign = np.where(inside, -1.0, 1.0)
        safe = np.where(distance > 1e-9, distance, 1.0)
        normal = np.stack((cx[n, flat], cy[n, flat]), axis=-1) * (sign / safe)[..., None]
        thick = np.concatenate((np.full(len(p), self._radius), self._thick))
        gap = sign * distance - self._radius - thick[:, None]
        own = np.arange(len(p))
        gap[own, own // m] = np.inf
        gap[distance <= 1e-9] = np.inf  # on the very line: no side; the next step has one
        return gap, flat, along[n, flat], normal

    def _with_rings(self, p: Floats, reach: float) -> Contacts:
        """Return the contacts of masses and ledges' ends with rings."""
        gap, piece, along, normal = self._nearest(p)
        point, ring = np.nonzero(gap < reach)
        pieces, t = piece[point, ring], along[point, ring]
        last = pieces % self._ring == self._ring - 1
        ends = np.where(last, pieces - self._ring + 1, pieces + 1)
        is_mass = point < len(p)
        masses = np.stack((np.where(is_mass, point, 0), pieces, ends), axis=1)
        shares = np.stack((is_mass.astype(float), t - 1.0, -t), axis=1)
        return Contacts(masses, shares, normal[point, ring], gap[point, ring])

    def _with_ledge(self, p: Floats, ledge: Ledge, reach: float) -> Contacts:
        """Return the contacts of masses with a ledge."""
        start, way = np.array(ledge.start), np.subtract(ledge.end, ledge.start)
        along = np.clip((p - start) @ way / (way @ way), 0.0, 1.0)
        away = p - start - along[:, None] * way
        distance = np.maximum(np.hypot(away[:, 0], away[:, 1]), 1e-9)
        gap = distance - ledge.radius - self._radius
        near = np.flatnonzero(gap < reach)
        masses = np.zeros((len(near), 3), dtype=np.int64)
        masses[:, 0] = near
        shares = np.zeros((len(near), 3))
        shares[:, 0] = 1.0
        return Contacts(masses, shares, away[near] / distance[near, None], gap[near])


def resolve(
    contacts: Contacts, v: Floats, walls: Walls, mass: float, friction: float, h: float
) -> Floats:
    """Change velocities v, (N, 2), so that nothing enters anything in a step h; return jn, (K,)."""
    masses, shares, n, gaps = contacts
    t, parts = np.stack((-n[:, 1], n[:, 0]), axis=1), shares[..., None]
    counts = np.zeros(len(v))
    np.add.at(counts, masses, (shares != 0.0).astype(float))
    busiest = np.where(shares != 0.0, counts[masses], 1.0).max(axis=1)
    gain = mass / (shares**2).sum(axis=1) / busiest
    allowed = np.maximum(gaps, 0.0) / h
    jn, jt, stopped = np.zeros(len(gaps)), np.zeros(len(gaps)), np.zeros_like(v)
    for _ in range(SWEEPS):
        moving = parts * v[masses]
        u = moving[:, 0] + moving[:, 1] + moving[:, 2]
        new_n = np.maximum(jn - gain * (dot(u.T, n.T) + allowed), 0.0)
        limit = friction * new_n
        new_t = np.minimum(np.maximum(jt - gain * dot(u.T, t.T), -limit), limit)
        push = (new_n - jn)[:, None] * n + (new_t - jt)[:, None] * t
        np.add.at(v, masses, parts * push[:, None] / mass)
        jn, jt = new_n, new_t
        kept = np.minimum(np.maximum(v, walls.slowest), walls.fastest)
        lost = np.abs(kept - v)
        stopped += lost
        v[:] = kept
        if not (push.any() or lost.any()):
            break  # no further sweep would change anything
    along = np.maximum(np.abs(v) - friction * stopped[:, ::-1], 0.0)
    v[:] = np.where(stopped[:, ::-1] > 0.0, np.copysign(along, v), v)
    return jn


def walls_at(p: Floats, size: tuple[float, float], radius: float, h: float) -> Walls:
    """Return what the walls of a room from (0, 0) allow in a step, for masses at p, (N, 2)."""
    return Walls(
        np.minimum((radius - p) / h, 0.0), np.maximum((np.array(size) - radius - p) / h, 0.0)
    )


def push_out(contacts: Contacts, p: Floats) -> None:
    """Move masses that overlap something apart, by a share of the overlap."""
    masses, shares, normals, gaps = contacts
    size = PUSHED_OUT * np.maximum(-gaps, 0.0) / (shares**2).sum(axis=1)
    np.add.at(p, masses, shares[..., None] * (size[:, None] * normals)[:, None])
