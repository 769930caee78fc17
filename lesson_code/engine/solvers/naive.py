"""The lesson's first attempt at resolving contacts, faults included, kept to be shown failing.

It looks right, and for two free discs of equal mass that meet once it is. What is wrong with it:

- the normal goes from centre to centre, also for polygons and walls;
- each body is pushed out by half of the overlap, whatever the masses;
- a pair that already parts is left in its overlap;
- bodies in one place are left there, because they have no direction from centre to centre;
- no friction, and no spin;
- one pass: what one contact corrects, the next may spoil, and nobody looks again.
"""

from __future__ import annotations

import math

from lesson_code.engine.core.pipeline import SolverStages
from lesson_code.engine.core.rows import BodyRow, ContactRow, World
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects


def prepare(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Prepare nothing."""


def warm_start(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Remember nothing."""


def solve(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Visit every pair once, as if it were alone in the world."""
    for k in range(world.state.contact_count):
        c = world.contacts[k]
        second_point = k > 0 and world.contacts[k - 1].a == c.a and world.contacts[k - 1].b == c.b
        if not second_point:
            resolve(c, world.bodies[c.a], world.bodies[c.b])


def resolve(c: ContactRow, a: BodyRow, b: BodyRow) -> None:
    """Bounce two bodies off each other along the line of their centres, and push them apart."""
    dx, dy = b.x - a.x, b.y - a.y
    distance = math.sqrt(dx * dx + dy * dy)
    if distance == 0.0:
        return
    nx, ny = dx / distance, dy / distance
    c.nx, c.ny = nx, ny
    vn = (b.vx - a.vx) * nx + (b.vy - a.vy) * ny
    if vn >= 0.0:
        return
    j = -(1 + c.restitution) * vn / (a.inv_m + b.inv_m)
    c.normal_impulse = j
    a.vx -= j * a.inv_m * nx
    a.vy -= j * a.inv_m * ny
    b.vx += j * b.inv_m * nx
    b.vy += j * b.inv_m * ny
    shift_if_free(a, -c.penetration / 2 * nx, -c.penetration / 2 * ny)
    shift_if_free(b, c.penetration / 2 * nx, c.penetration / 2 * ny)


def shift_if_free(body: BodyRow, dx: float, dy: float) -> None:
    """Move a body that can be pushed."""
    if body.inv_m > 0.0:
        body.x += dx
        body.y += dy


def has_overlap_to_undo(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Look for none: each pair has been pushed apart when it was visited."""
    return False


def correct(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Correct nothing."""


def store(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Remember nothing."""


SOLVER = Solver(
    name="naive",
    stages=SolverStages(prepare, warm_start, solve, has_overlap_to_undo, correct, store),
    has_one_sweep=True,
    lacks={
        "friction": "the naive solver knows none",
        "continuous": "the naive solver looks for no fast bodies",
        "warm_starting": "the naive solver remembers nothing",
        "position_correction": "the naive solver shifts each pair as it visits it",
        "sleeping": "the naive solver brings nothing to rest",
    },
)
