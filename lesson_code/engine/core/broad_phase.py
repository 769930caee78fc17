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
from typing import Protocol, TypeAlias

from lesson_code.engine.core.constants import (
    LAST_CELL,
    LEAST_MARGIN,
    MOST_MARGIN,
    PAIRS_ANYWAY,
    PAIRS_PER_BODY,
    SLOT_RATIO,
    STEPS_AHEAD,
)
from lesson_code.engine.core.rows import BodyRow, BoxRow, IndexRow, PairRow, PlaceRow, State, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.formulas.arithmetic import clamp

Sides: TypeAlias = tuple[float, float, float, float]


class Boxed(Protocol):
    """The fields of a row with a bounding box; it may have more."""

    min_x: float
    min_y: float
    max_x: float
    max_y: float


class Grid(Protocol):
    """The fields that locate a slot of the grid; a row may have more."""

    slot_count: int
    row_stride: int


def box_of(world: World, body: BodyRow, effects: Effects = EVERY_EFFECT) -> Sides:
    """Return the sides of the box around a body: left, low, right, high."""
    left, right, low, high = 0.0, 0.0, 0.0, 0.0
    if effects.outlines:
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
    return (
        body.x + left - body.radius,
        body.y + low - body.radius,
        body.x + right + body.radius,
        body.y + high + body.radius,
    )


def bound(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Draw a box around every body, with a margin to move in for those that can be pushed."""
    way = longest_way(world)
    for body in world.bodies:
        left, low, right, high = box_of(world, body, effects)
        margin = 0.0
        if body.inv_m > 0.0:
            margin = clamp(
                STEPS_AHEAD * way, LEAST_MARGIN * body.min_width, MOST_MARGIN * body.min_width
            )
        body.min_x, body.max_x = left - margin, right + margin
        body.min_y, body.max_y = low - margin, high + margin


def longest_way(world: World) -> float:
    """Return how far the fastest of the bodies that can be pushed moves in a step, m."""
    most = 0.0
    for body in world.bodies:
        if body.inv_m > 0.0:
            most = max(most, body.vx * body.vx + body.vy * body.vy)
    return math.sqrt(most) * world.state.dt


def has_left_box(world: World, effects: Effects = EVERY_EFFECT) -> bool:
    """Return whether any body has left the box that was drawn around it."""
    for body in world.bodies:
        if effects.sleeping and body.is_asleep:
            continue
        left, low, right, high = box_of(world, body, effects)
        if left < body.min_x or right > body.max_x or low < body.min_y or high > body.max_y:
            return True
    return False


def all_pairs(world: World) -> int:
    """Compare every body with every later one."""
    bodies = world.bodies
    count = 0
    for i in range(len(bodies)):
        for j in range(i + 1, len(bodies)):
            is_pair = may_touch(bodies[i], bodies[j])
            count = put_pair(world.pairs, count, i, j, is_pair)
        if count > most_pairs(len(bodies)):
            break
    return count


def sweep_and_prune(world: World) -> int:
    """Walk along x, and compare each body with those whose boxes have begun and not yet ended.

    References
    ----------
    Cohen et al., I-COLLIDE (1995), section 4: sweep and prune. Bodies move little in a step, so
    the order of the last one is almost right, and an insertion sort repairs it in about N moves.
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
            is_pair = may_touch(bodies[i], bodies[j])
            count = put_pair(world.pairs, count, i, j, is_pair)
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

    No box in the grid is wider than a cell, so bodies two cells apart cannot touch. The boxes are
    sorted by cell. Each is compared with those after it in its own cell and the next, and with
    those in the three cells above: so each pair comes up once. Larger bodies (floors, walls) stay
    outside and are compared with all.

    References
    ----------
    Teschner et al., Optimized Spatial Hashing for Collision Detection (2003), section 3.
    """
    state = world.state
    find_cells(world)
    sort_boxes(world)
    count = 0
    for k in range(state.box_count):
        x, y = world.boxes[k].cell_x, world.boxes[k].cell_y
        count = pairs_in_row(world, k, k + 1, slot_of(state, x, y), x, y, 2, count)
        above = slot_of(state, x - 1, y + 1)
        count = pairs_in_row(world, k, world.slots[above].index, above, x - 1, y + 1, 3, count)
        if state.has_small_fixed:
            count = pairs_with_fixed(world, world.boxes[k].body, count)
        if count > most_pairs(len(world.bodies)):
            return count
    return sort_pairs(world, pairs_of_large(world, count))


def find_cells(world: World) -> None:
    """Find the cell of each body's box, and chain the bodies in it that nothing can push."""
    state, slots = world.state, world.fixed_slots
    state.has_small_fixed = False
    for slot in slots:
        slot.index = -1
    for i in range(len(world.bodies)):
        body, place = world.bodies[i], world.places[i]
        place.is_large = max(body.max_x - body.min_x, body.max_y - body.min_y) > state.cell_size
        if not place.is_large:
            place.cell_x = cell_of(state, body.min_x)
            place.cell_y = cell_of(state, body.min_y)
            if body.inv_m == 0.0:
                slot = slots[slot_of(state, place.cell_x, place.cell_y)]
                place.next_in_cell = slot.index
                slot.index = i
                state.has_small_fixed = True


def cell_of(state: State, side: float) -> int:
    """Return the number of the column or row of cells in which a side lies.

    Everything beyond the last cell counts as part of that cell: neighbours stay neighbours.
    """
    number: int = math.floor(clamp(side / state.cell_size, -LAST_CELL, LAST_CELL))
    return number


def sort_boxes(world: World) -> None:
    """Sort the boxes of the bodies that can be pushed by slot; the large ones are left out.

    A counting sort: count the boxes in each slot, find where each slot ends, then put each box
    before the last one of its slot. At the end a slot holds the index at which its boxes begin.
    """
    state, slots = world.state, world.slots
    for slot in slots:
        slot.index = 0
    for i in range(len(world.bodies)):
        place = world.places[i]
        if world.bodies[i].inv_m > 0.0 and not place.is_large:
            slots[slot_of(state, place.cell_x, place.cell_y)].index += 1
    end = 0
    for slot in slots:
        end += slot.index
        slot.index = end
    state.box_count = end
    for i in range(len(world.bodies) - 1, -1, -1):
        place = world.places[i]
        if world.bodies[i].inv_m > 0.0 and not place.is_large:
            slot = slots[slot_of(state, place.cell_x, place.cell_y)]
            slot.index -= 1
            write_box(world.boxes[slot.index], world.bodies[i], place, i)


def write_box(box: BoxRow, body: BodyRow, place: PlaceRow, i: int) -> None:
    """Write down the box of body i."""
    box.min_x, box.max_x, box.min_y, box.max_y = body.min_x, body.max_x, body.min_y, body.max_y
    box.cell_x, box.cell_y, box.body = place.cell_x, place.cell_y, i


def slot_of(grid: Grid, cell_x: int, cell_y: int) -> int:
    """Return the slot of a cell; the number of slots is a power of two.

    Cells side by side have slots side by side, and those above are a golden part of all slots
    away: that keeps the cells that share a slot as far apart as can be.
    """
    return (cell_x + cell_y * grid.row_stride) & (grid.slot_count - 1)


def slots_for(bodies: int) -> int:
    """Return the number of slots of a grid for N bodies: at least 2 N."""
    slots = 4
    while slots <= 2 * bodies + 3:
        slots *= 2
    return slots


def row_stride_for(slots: int) -> int:
    """Return how many slots a cell is from the one above it."""
    return int(SLOT_RATIO * slots) | 1


def pairs_in_row(
    world: World, k: int, begin: int, slot: int, x: int, y: int, width: int, count: int
) -> int:
    """Compare box k with those in a row of cells, from x on, that begin at a place and a slot.

    The slots of a row stand side by side; after the last slot comes the first.
    """
    slots, behind = world.slots, slot + width - world.state.slot_count
    if behind <= 0:
        return pairs_among(world, k, begin, slots[slot + width].index, x, y, width, count)
    count = pairs_among(world, k, begin, world.state.box_count, x, y, width, count)
    return pairs_among(world, k, 0, slots[behind].index, x, y, width, count)


def pairs_among(
    world: World, k: int, begin: int, end: int, x: int, y: int, width: int, count: int
) -> int:
    """Compare box k with some of the boxes, those that lie in a row of cells."""
    box = world.boxes[k]
    for n in range(begin, end):
        other = world.boxes[n]
        in_row = (other.cell_y == y) & (x <= other.cell_x) & (other.cell_x < x + width)
        is_pair = in_row & boxes_overlap(box, other)
        count = put_pair(world.pairs, count, box.body, other.body, is_pair)
    return count


def pairs_with_fixed(world: World, i: int, count: int) -> int:
    """Compare a body in the grid with those around it that nothing can push."""
    state, bodies, places = world.state, world.bodies, world.places
    for x in range(places[i].cell_x - 1, places[i].cell_x + 2):
        for y in range(places[i].cell_y - 1, places[i].cell_y + 2):
            j = world.fixed_slots[slot_of(state, x, y)].index
            while j >= 0:
                is_here = places[j].cell_x == x and places[j].cell_y == y
                is_pair = is_here and boxes_overlap(bodies[i], bodies[j])
                count = put_pair(world.pairs, count, i, j, is_pair)
                j = places[j].next_in_cell
    return count


def pairs_of_large(world: World, count: int) -> int:
    """Compare each large body with every other; two large ones only once."""
    bodies, places = world.bodies, world.places
    for i in range(len(bodies)):
        if not places[i].is_large:
            continue
        for j in range(len(bodies)):
            once = j > i or not places[j].is_large
            is_pair = j != i and once and may_touch(bodies[i], bodies[j])
            count = put_pair(world.pairs, count, i, j, is_pair)
        if count > most_pairs(len(bodies)):
            break
    return count


def may_touch(a: BodyRow, b: BodyRow) -> bool:
    """Return whether two boxes overlap, and one of the bodies can be pushed."""
    return boxes_overlap(a, b) and (a.inv_m > 0.0 or b.inv_m > 0.0)


def boxes_overlap(a: Boxed, b: Boxed) -> bool:
    """Return whether two boxes share a point."""
    share_x = (a.min_x <= b.max_x) & (b.min_x <= a.max_x)
    return share_x & (a.min_y <= b.max_y) & (b.min_y <= a.max_y)


def most_pairs(bodies: int) -> int:
    """Return the number of candidate pairs above which a scene of N bodies is refused."""
    return PAIRS_PER_BODY * bodies + PAIRS_ANYWAY


def put_pair(pairs: list[PairRow], count: int, a: int, b: int, is_pair: bool) -> int:
    """Write two bodies where the next pair belongs, if there is room; return the count with it.

    If they are not a pair they do not count, and the next two overwrite them. Writing is cheaper
    than deciding: a processor that mispredicts a branch has to begin again.
    """
    if count < len(pairs):
        pairs[count].a = min(a, b)
        pairs[count].b = max(a, b)
    return count + is_pair


def sort_pairs(world: World, count: int) -> int:
    """Sort the pairs by a, then by b, unless some are missing; return how many there are.

    Two counting sorts, the less important key first. Each takes time in proportion to pairs and
    bodies, and keeps the order of equals.
    """
    if count > len(world.pairs):
        return count
    counting_sort(world.places, world.pairs, world.sorted_pairs, count, by_b=True)
    counting_sort(world.places, world.sorted_pairs, world.pairs, count, by_b=False)
    return count


def counting_sort(
    places: list[PlaceRow], pairs: list[PairRow], target: list[PairRow], count: int, by_b: bool
) -> None:
    """Write pairs into a target, sorted by one of their two bodies; equals keep their order."""
    tally(places, pairs, count, by_b)
    for k in range(count):
        pair = pairs[k]
        place = places[pair.b if by_b else pair.a]
        target[place.tally].a = pair.a
        target[place.tally].b = pair.b
        place.tally += 1


def tally(places: list[PlaceRow], pairs: list[PairRow], count: int, by_b: bool) -> None:
    """Set each body's tally to where its pairs begin when they are sorted by one of the two."""
    for place in places:
        place.tally = 0
    for k in range(count):
        place = places[pairs[k].b if by_b else pairs[k].a]
        place.tally += 1
    start = 0
    for place in places:
        pairs_here = place.tally
        place.tally = start
        start += pairs_here
