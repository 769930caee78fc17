"""Islands: contacts that disturb each other, and the matrix that says how.

Two contacts belong to one island if a body that can be pushed leads from one to the other. Static
bodies do not connect: two boxes on one floor know nothing of each other.

    u = G v            velocities at the contacts, first all along the normals, then the tangents
    v' = v + W G^T x   velocities of the bodies after impulses x at the contacts
    K = G W G^T        so that u' = u + K x

Row k of G holds, for a contact's direction d and lever arms r,  -d, -(r_a x d)  in the columns of
body a and  d, r_b x d  in those of body b; W holds the inverse masses and inertias. Only these six
numbers of a row are kept, and K is summed up body by body: most of it is 0.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.formulas.arithmetic import cross

Floats: TypeAlias = NDArray[np.float64]
Integers: TypeAlias = NDArray[np.int64]


class Island(NamedTuple):
    """An island of m contacts between n bodies."""

    contacts: list[ContactRow]
    bodies: list[BodyRow]
    of: Integers  # the place of each row's body a among the bodies, then of its b, shape (4m,)
    on: Floats  # G in the columns of these bodies, shape (4m, 3)
    columns: Integers  # the numbers of these columns, shape (12m,)
    inverse_masses: Floats  # W, shape (n, 3)
    delassus: Floats  # K, shape (2m, 2m), 1/kg
    scale: Floats  # of the impulses at each contact, kg^(1/2), shape (m,)
    friction: Floats  # mu, shape (m,)
    mass: float  # of what can be pushed, kg


def find_islands(world: World) -> None:
    """Set the first body of its island for every body that is awake."""
    bodies = world.bodies
    for i in range(len(bodies)):
        if not bodies[i].is_asleep:
            bodies[i].island, bodies[i].is_restless = i, False
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        if bodies[c.a].inv_m > 0.0 and bodies[c.b].inv_m > 0.0:
            first, second = first_of_island(bodies, c.a), first_of_island(bodies, c.b)
            bodies[max(first, second)].island = min(first, second)


def first_of_island(bodies: list[BodyRow], i: int) -> int:
    """Return the first body of an island; the way to it is made shorter for the next time."""
    while bodies[i].island != i:
        bodies[i].island = bodies[bodies[i].island].island
        i = bodies[i].island
    return i


def islands_of(world: World) -> list[Island]:
    """Return the islands, each with its contacts in the order of the contact table.

    A contact between two bodies that nothing can push is in none.
    """
    find_islands(world)
    bodies = world.bodies
    islands: dict[int, list[ContactRow]] = {}
    for c in world.contacts[: world.state.contact_count]:
        if bodies[c.a].inv_m > 0.0 or bodies[c.b].inv_m > 0.0:
            pushed = c.a if bodies[c.a].inv_m > 0.0 else c.b
            islands.setdefault(first_of_island(bodies, pushed), []).append(c)
    return [_island(world, contacts) for contacts in islands.values()]


def _island(world: World, contacts: list[ContactRow]) -> Island:
    """Return the matrices of an island."""
    numbers = sorted({number for c in contacts for number in (c.a, c.b)})
    place = {number: k for k, number in enumerate(numbers)}
    bodies = [world.bodies[number] for number in numbers]
    w = np.array([(body.inv_m, body.inv_m, body.inv_i) for body in bodies])
    of_a, of_b = [place[c.a] for c in contacts], [place[c.b] for c in contacts]
    of = np.array([*of_a, *of_a, *of_b, *of_b])
    on = _directions(contacts, world.bodies)
    scale = 1.0 / np.sqrt(w[of_a, 0] + w[of_b, 0])
    return Island(
        contacts,
        bodies,
        of,
        on,
        (3 * of[:, np.newaxis] + np.arange(3)).ravel(),
        w,
        _delassus(of, on, w),
        scale,
        np.array([c.friction for c in contacts]),
        sum(1.0 / body.inv_m for body in bodies if body.inv_m > 0.0),
    )


def velocities(island: Island) -> Floats:
    """Return the velocities at the contacts, shape (2m,), m/s; > 0 along the normal: parting."""
    return _at_contacts(island, np.array([(body.vx, body.vy, body.w) for body in island.bodies]))


def start_velocities(island: Island) -> Floats:
    """Return the same for the velocities at the start of the part of a step."""
    start = [(body.start_vx, body.start_vy, body.start_w) for body in island.bodies]
    return _at_contacts(island, np.array(start))


def pseudo_velocities(island: Island) -> Floats:
    """Return the same for the velocities of the position correction."""
    pushes = [(body.pseudo_vx, body.pseudo_vy, body.pseudo_w) for body in island.bodies]
    return _at_contacts(island, np.array(pushes))


def apply_impulses(island: Island, x: Floats) -> None:
    """Change the velocities of the bodies by impulses at all contacts, shape (2m,), N s."""
    for body, (vx, vy, w) in zip(island.bodies, changes_of(island, x), strict=True):
        body.vx += vx
        body.vy += vy
        body.w += w


def apply_pseudo_impulses(island: Island, x: Floats) -> None:
    """Change the velocities of the position correction likewise."""
    for body, (vx, vy, w) in zip(island.bodies, changes_of(island, x), strict=True):
        body.pseudo_vx += vx
        body.pseudo_vy += vy
        body.pseudo_w += w


def _at_contacts(island: Island, v: Floats) -> Floats:
    """Return G v."""
    of_a, of_b = (island.on * v[island.of]).reshape(2, -1, 3)
    u: Floats = (of_a + of_b).sum(axis=1)
    return u


def changes_of(island: Island, x: Floats) -> list[list[float]]:
    """Return W G^T x: the changes of vx, vy, w of every body."""
    parts = island.on * np.concatenate((x, x))[:, np.newaxis]
    w = island.inverse_masses
    received = np.bincount(island.columns, parts.ravel(), w.size).reshape(w.shape)
    changes: list[list[float]] = (w * received).tolist()
    return changes


def _directions(contacts: Sequence[ContactRow], bodies: Sequence[BodyRow]) -> Floats:
    """Return the rows of G in the columns of body a, then those in the columns of body b.

    The normal of a disc goes through its centre: it has no lever arm, not even a rounding error.
    """
    along_a, along_b, across_a, across_b = [], [], [], []
    for c in contacts:
        n, t, arm_a, arm_b = (c.nx, c.ny), (-c.ny, c.nx), (c.ax, c.ay), (c.bx, c.by)
        lever_a = cross(arm_a, n) if bodies[c.a].corner_count > 0 else 0.0
        lever_b = cross(arm_b, n) if bodies[c.b].corner_count > 0 else 0.0
        along_a.append((-c.nx, -c.ny, -lever_a))
        along_b.append((c.nx, c.ny, lever_b))
        across_a.append((c.ny, -c.nx, -cross(arm_a, t)))
        across_b.append((-c.ny, c.nx, cross(arm_b, t)))
    return np.array(along_a + across_a + along_b + across_b)


def _delassus(of: Integers, on: Floats, w: Floats) -> Floats:
    """Return K: each body that can be pushed couples all the rows that it has a part in."""
    size = len(of) // 2
    k = np.zeros((size, size))
    for body in np.flatnonzero(w.any(axis=1)).tolist():
        parts = (of == body).nonzero()[0]
        own, rows = on[parts], parts % size
        k[rows[:, np.newaxis], rows] += (own * w[body]) @ own.T
    return k
