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
    of_a: Integers  # the place of each row's body a among the bodies, shape (2m,)
    of_b: Integers
    on_a: Floats  # G in the columns of body a, shape (2m, 3)
    on_b: Floats
    inverse_masses: Floats  # W, shape (n, 3)
    delassus: Floats  # K, shape (2m, 2m), 1/kg
    scale: Floats  # of the impulses at each contact, kg^(1/2), shape (m,)
    friction: Floats  # mu, shape (m,)


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
    of_a = np.array([place[c.a] for c in contacts] * 2)
    of_b = np.array([place[c.b] for c in contacts] * 2)
    on_a, on_b = _directions(contacts, world.bodies)
    delassus = _delassus(of_a, of_b, on_a, on_b, w)
    m = len(contacts)
    scale = 1.0 / np.sqrt(w[of_a[:m], 0] + w[of_b[:m], 0])
    friction = np.array([c.friction for c in contacts])
    return Island(contacts, bodies, of_a, of_b, on_a, on_b, w, delassus, scale, friction)


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
    u: Floats = (island.on_a * v[island.of_a] + island.on_b * v[island.of_b]).sum(axis=1)
    return u


def changes_of(island: Island, x: Floats) -> list[list[float]]:
    """Return W G^T x: the changes of vx, vy, w of every body."""
    count, impulses = len(island.bodies), x[:, np.newaxis]
    of = np.concatenate((island.of_a, island.of_b))
    parts = np.concatenate((island.on_a * impulses, island.on_b * impulses)).T
    received = np.array([np.bincount(of, part, count) for part in parts]).T
    changes: list[list[float]] = (island.inverse_masses * received).tolist()
    return changes


def _directions(contacts: Sequence[ContactRow], bodies: Sequence[BodyRow]) -> tuple[Floats, Floats]:
    """Return the rows of G in the columns of body a, and of body b.

    The normal of a disc goes through its centre: it has no lever arm, not even a rounding error.
    """
    m = len(contacts)
    nx, ny, ax, ay, bx, by = np.array(
        [(c.nx, c.ny, c.ax, c.ay, c.bx, c.by) for c in contacts], dtype=float
    ).T
    on_a, on_b = np.empty((2 * m, 3)), np.empty((2 * m, 3))
    for rows, d in ((slice(m), (nx, ny)), (slice(m, 2 * m), (-ny, nx))):
        on_b[rows, 0], on_b[rows, 1], on_b[rows, 2] = *d, cross((bx, by), d)
        on_a[rows, 2] = -cross((ax, ay), d)
    on_a[:, :2] = -on_b[:, :2]
    for k, c in enumerate(contacts):
        if bodies[c.a].corner_count == 0:
            on_a[k, 2] = -0.0
        if bodies[c.b].corner_count == 0:
            on_b[k, 2] = 0.0
    return on_a, on_b


def _delassus(of_a: Integers, of_b: Integers, on_a: Floats, on_b: Floats, w: Floats) -> Floats:
    """Return K: each body that can be pushed couples all the rows that it has a part in."""
    size = len(of_a)
    k, of, on = np.zeros((size, size)), np.concatenate((of_a, of_b)), np.concatenate((on_a, on_b))
    for body in np.nonzero(w.any(axis=1))[0]:
        parts = np.nonzero(of == body)[0]
        own, rows = on[parts], parts % size
        k[rows[:, np.newaxis], rows] += (own * w[body]) @ own.T
    return k
