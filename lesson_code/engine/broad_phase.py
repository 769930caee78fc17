"""Broad phase: which pairs of bodies might touch, found cheaply by the boxes around them.

Three ways to find the same candidate pairs, in the same order: a < b, sorted by a, then by b.
The order of contacts matters to the solver, so it may not depend on how the pairs were found.
Two bodies that nothing can push are never a pair.

=======================  ===========================  =====================================
way                      cost for N bodies            good for
=======================  ===========================  =====================================
``all_pairs``            N^2                          few bodies
``sweep_and_prune``      N, and the overlaps in x     bodies of very different sizes
``uniform_grid``         N, and the pairs nearby      many bodies of about one size
=======================  ===========================  =====================================

Each writes as many pairs as the table has room for, and returns how many there are: when the
table was too small, the caller makes room and asks again. When there are too many for any
memory, it stops counting.
"""

from __future__ import annotations

import math

from lesson_code.engine.constants import PAIRS_ANYWAY, PAIRS_PER_BODY
from lesson_code.engine.rows import BodyRow, IndexRow, PairRow, World


def bound(world: World) -> None:
    """Put a box around every body."""
    for body in world.bodies:
        left, right, low, high = 0.0, 0.0, 0.0, 0.0
        for k in range(body.corner_count):
            corner = world.corners[body.first_corner + k]
            if k == 0 or corner.x < left:
                left = corner.x
            if k == 0 or corner.x > right:
                right = corner.x
            if k == 0 or corner.y < low:
                low = corner.y
            if k == 0 or corner.y > high:
                high = corner.y
        body.min_x = body.x + left - body.radius
        body.max_x = body.x + right + body.radius
        body.min_y = body.y + low - body.radius
        body.max_y = body.y + high + body.radius


def all_pairs(world: World) -> int:
    """Compare every body with every later one."""
    bodies = world.bodies
    count = 0
    for i in range(len(bodies)):
        for j in range(i + 1, len(bodies)):
            if may_touch(bodies[i], bodies[j]):
                count = put_pair(world.pairs, count, i, j)
        if count > most_pairs(len(bodies)):
            break
    return count


def sweep_and_prune(world: World) -> int:
    """Walk along x, and compare each body with those whose boxes have begun and not yet ended.

    References
    ----------
    Cohen et al., I-COLLIDE (1995), section 4: sweep and prune. Bodies move little in a step, so
    the order of the last one is almost right, and an insertion sort mends it in about N moves.
    """
    bodies, order = world.bodies, world.order
    sort_along_x(bodies, order)
    count = 0
    for k in range(len(bodies)):
        i = order[k].index
        right = bodies[i].max_x
        n = k + 1
        while n < len(bodies) and bodies[order[n].index].min_x <= right:
            j = order[n].index
            if may_touch(bodies[i], bodies[j]):
                count = put_pair(world.pairs, count, min(i, j), max(i, j))
            n += 1
        if count > most_pairs(len(bodies)):
            break
    return sort_pairs(world, count)


def sort_along_x(bodies: list[BodyRow], order: list[IndexRow]) -> None:
    """Sort the bodies' numbers by the left sides of their boxes; insertion sort."""
    for k in range(1, len(order)):
        moving = order[k].index
        left = bodies[moving].min_x
        n = k - 1
        while n >= 0 and bodies[order[n].index].min_x > left:
            order[n + 1].index = order[n].index
            n -= 1
        order[n + 1].index = moving


def uniform_grid(world: World) -> int:
    """Put every body into the square cell of its box's lower left corner; compare neighbours.

    No box in the grid reaches beyond the next cell, so bodies two cells apart cannot touch. Larger
    bodies (floors, walls) stay outside and are compared with all. The cells are not stored;
    each falls into one of a fixed number of slots.

    References
    ----------
    Teschner et al., Optimized Spatial Hashing for Collision Detection (2003), section 3.
    """
    bodies, slots = world.bodies, world.slots
    fill_grid(world)
    count = 0
    for i in range(len(bodies)):
        if is_large(world, bodies[i]):
            count = pairs_of_large(world, i, count)
            continue
        if bodies[i].inv_m == 0.0:
            continue  # found by those that can be pushed: a wall of many bodies costs nothing
        for dx in range(-1, 2):
            for dy in range(-1, 2):
                cell_x, cell_y = bodies[i].cell_x + dx, bodies[i].cell_y + dy
                j = slots[slot_of(cell_x, cell_y, len(slots))].index
                while j >= 0:
                    # A slot may hold other cells too. Two that can be pushed both find their pair.
                    here = bodies[j].cell_x == cell_x and bodies[j].cell_y == cell_y
                    once = j > i or bodies[j].inv_m == 0.0
                    if once and here and may_touch(bodies[i], bodies[j]):
                        count = put_pair(world.pairs, count, min(i, j), max(i, j))
                    j = bodies[j].next_in_cell
        if count > most_pairs(len(bodies)):
            break
    return sort_pairs(world, count)


def fill_grid(world: World) -> None:
    """Chain the bodies of each slot, and leave out the large ones."""
    for slot in world.slots:
        slot.index = -1
    for i in range(len(world.bodies)):
        body = world.bodies[i]
        body.cell_x = math.floor(body.min_x / world.state.cell_size)
        body.cell_y = math.floor(body.min_y / world.state.cell_size)
        if not is_large(world, body):
            slot = world.slots[slot_of(body.cell_x, body.cell_y, len(world.slots))]
            body.next_in_cell = slot.index
            slot.index = i


def is_large(world: World, body: BodyRow) -> bool:
    """Return whether a body's box reaches beyond the cell next to its own."""
    last_x = math.floor(body.max_x / world.state.cell_size)
    last_y = math.floor(body.max_y / world.state.cell_size)
    return last_x > body.cell_x + 1 or last_y > body.cell_y + 1


def slot_of(cell_x: int, cell_y: int, slots: int) -> int:
    """Return the slot of a cell; two primes spread neighbours apart."""
    return (cell_x * 73856093 ^ cell_y * 19349663) % slots


def pairs_of_large(world: World, i: int, count: int) -> int:
    """Compare a large body with every other; two large ones only once."""
    bodies = world.bodies
    for j in range(len(bodies)):
        once = j > i or not is_large(world, bodies[j])
        if j != i and once and may_touch(bodies[i], bodies[j]):
            count = put_pair(world.pairs, count, min(i, j), max(i, j))
    return count


def may_touch(a: BodyRow, b: BodyRow) -> bool:
    """Return whether two boxes overlap, and one of the bodies can be pushed."""
    if a.inv_m == 0.0 and b.inv_m == 0.0:
        return False
    if a.min_x > b.max_x or b.min_x > a.max_x:
        return False
    return not (a.min_y > b.max_y or b.min_y > a.max_y)


def most_pairs(bodies: int) -> int:
    """Return how many candidate pairs are too many for so many bodies."""
    return PAIRS_PER_BODY * bodies + PAIRS_ANYWAY


def put_pair(pairs: list[PairRow], count: int, a: int, b: int) -> int:
    """Write a pair if there is room, and return the count with it."""
    if count < len(pairs):
        pairs[count].a = a
        pairs[count].b = b
    return count + 1


def sort_pairs(world: World, count: int) -> int:
    """Sort the pairs by a, then by b, unless some are missing; return how many there are.

    Two counting sorts, the less important key first. Each takes time in proportion to pairs and
    bodies, and keeps the order of equals.
    """
    if count > len(world.pairs):
        return count
    counting_sort(world.bodies, world.pairs, world.sorted_pairs, count, by_b=True)
    counting_sort(world.bodies, world.sorted_pairs, world.pairs, count, by_b=False)
    return count


def counting_sort(
    bodies: list[BodyRow], pairs: list[PairRow], target: list[PairRow], count: int, by_b: bool
) -> None:
    """Write pairs into a target, sorted by one of their two bodies; equals keep their order."""
    tally(bodies, pairs, count, by_b)
    for k in range(count):
        pair = pairs[k]
        body = bodies[pair.b if by_b else pair.a]
        target[body.tally].a = pair.a
        target[body.tally].b = pair.b
        body.tally += 1


def tally(bodies: list[BodyRow], pairs: list[PairRow], count: int, by_b: bool) -> None:
    """Set each body's tally to where its pairs begin when they are sorted by one of the two."""
    for body in bodies:
        body.tally = 0
    for k in range(count):
        body = bodies[pairs[k].b if by_b else pairs[k].a]
        body.tally += 1
    start = 0
    for body in bodies:
        pairs_here = body.tally
        body.tally = start
        start += pairs_here
