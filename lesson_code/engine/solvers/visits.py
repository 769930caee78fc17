"""The order of a sweep's visits, in which a processor need not wait.

Contacts side by side in the table share a body, and what one visit gives to it the next one reads:
a processor has to wait each time. So many contacts are visited in another order, few as they stand.

=========  ====================================================================================
contacts   order
=========  ====================================================================================
of boxes   colour after colour: contacts of one colour share no body that can be pushed
of discs   in strides: their visits are so short that finding colours would cost more
too many   in strides, part after part: colours would go through all memory again and again
=========  ====================================================================================

References
----------
Catto, SIMD Matters (Box2D, 2024): colours, there for the lanes of one instruction.
"""

from __future__ import annotations

from lesson_code.engine.compiled.lanes import LANES
from lesson_code.engine.core.constants import (
    FEWEST_FOR_ORDER,
    MOST_COLOURS,
    MOST_FOR_COLOURS,
    PART_OF_SWEEP,
    STRIDE,
)
from lesson_code.engine.core.rows import BodyRow, World
from lesson_code.engine.effects.flags import Effects


def order_visits(world: World, effects: Effects) -> None:
    """Write down which contacts a sweep visits, and when; the two of a manifold are one visit."""
    world.state.visit_count = world.state.lanes_of_two = world.state.lanes_of_one = 0
    if world.state.contact_count < FEWEST_FOR_ORDER:
        as_they_stand(world, effects)
    elif effects.manifolds and are_for_colours(world):
        by_colour(world, effects)
    else:
        in_strides(world, effects)


def are_for_colours(world: World) -> bool:
    """Return whether more than half of the contacts are solved two by two, and not too many."""
    blocks = 0
    for k in range(world.state.contact_count):
        blocks += world.contacts[k].is_block
    return blocks > world.state.contact_count // 4 and world.state.contact_count <= MOST_FOR_COLOURS


def as_they_stand(world: World, effects: Effects) -> None:
    """Visit the contacts in the order of their table."""
    for k in range(world.state.contact_count):
        visit_next(world, k, effects)


def in_strides(world: World, effects: Effects) -> None:
    """Visit the contacts in strides, part after part of the table."""
    count = world.state.contact_count
    for begin in range(0, count, PART_OF_SWEEP):
        for first in range(begin, begin + STRIDE):
            for k in range(first, min(begin + PART_OF_SWEEP, count), STRIDE):
                visit_next(world, k, effects)


def by_colour(world: World, effects: Effects) -> None:
    """Visit the contacts colour after colour, those of a colour in lanes; last what is left over.

    Each contact takes the first colour that its bodies do not have yet. The whole table is coloured
    at once: part by part, the rows of a pyramid hear too late what they have to bear.

    A counting sort: count the visits of each colour, find where those begin that fill all lanes,
    and put each visit there.
    """
    take_colours(world, effects)
    share_out_lanes(world)
    state = world.state
    state.visit_count = state.lanes_of_one
    for k in range(state.contact_count):
        if not is_second_of_block(world, k, effects):
            colour = world.colours[world.contacts[k].colour]
            if colour.left > 0:
                world.visits[colour.place].index = k
                colour.place += 1
                colour.left -= 1
            else:
                world.visits[state.visit_count].index = k
                state.visit_count += 1


def take_colours(world: World, effects: Effects) -> None:
    """Let each contact that is visited take a colour, and count them; single ones by themselves."""
    for colour in world.colours:
        colour.left = 0
    for body in world.bodies:
        body.colours = 0
    for k in range(world.state.contact_count):
        if not is_second_of_block(world, k, effects):
            c = world.contacts[k]
            c.colour = take_colour(world.bodies[c.a], world.bodies[c.b])
            if not c.is_block:
                c.colour += MOST_COLOURS
            world.colours[c.colour].left += 1


def share_out_lanes(world: World) -> None:
    """Find where the visits of each colour begin, as many as fill all lanes.

    Contacts of the last colour may share bodies, and are never visited at once.
    """
    place = 0
    for number, colour in enumerate(world.colours):
        is_last = number % MOST_COLOURS == MOST_COLOURS - 1
        colour.left = 0 if is_last else colour.left // LANES * LANES
        colour.place = place
        place += colour.left
        if number == MOST_COLOURS - 1:
            world.state.lanes_of_two = place
    world.state.lanes_of_one = place


def take_colour(a: BodyRow, b: BodyRow) -> int:
    """Return the first colour that two bodies do not have yet, and give it to them.

    What nothing can push has none. The last colour is for all that find no other.
    """
    taken = (a.colours if a.inv_m > 0.0 else 0) | (b.colours if b.inv_m > 0.0 else 0)
    colour = 0
    while colour < MOST_COLOURS - 1 and (taken >> colour) & 1:
        colour += 1
    a.colours |= 1 << colour
    b.colours |= 1 << colour
    return colour


def visit_next(world: World, k: int, effects: Effects) -> None:
    """Let a contact be visited next, unless it is visited with the one before it."""
    if not is_second_of_block(world, k, effects):
        world.visits[world.state.visit_count].index = k
        world.state.visit_count += 1


def is_second_of_block(world: World, k: int, effects: Effects) -> bool:
    """Return whether a contact is solved together with the one before it."""
    return effects.manifolds and k > 0 and world.contacts[k - 1].is_block
