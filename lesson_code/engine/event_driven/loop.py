"""The loop of the event-driven solver: from event to event, with no time step between them.

    1 the disc whose event comes first lives on to it
    2 the event happens: a hit, a border of a cell, the end of sliding
    3 the events of all discs whose motion has changed are foretold anew

A disc knows only its own next event. If its partner's motion has changed since it was foretold,
the event is stale: it is thrown away, and the disc's next event is foretold anew.

References
----------
Rapaport, The Event Scheduling Problem in Molecular Dynamic Simulation (1980). Lubachevsky, How to
Simulate Billiards and Similar Systems (1991): one event a disc. Bannerman, Strobl, Formella and
Poeschel, Stable Algorithm for Event Detection in Event-Driven Particle Dynamics (2014): an overlap
that closes is an event now.
"""

from __future__ import annotations

from lesson_code.engine.event_driven.cells import cross_border
from lesson_code.engine.event_driven.collisions import collide_discs, collide_obstacle, leave_face
from lesson_code.engine.event_driven.constants import MOST_EVENTS_AT_ONCE
from lesson_code.engine.event_driven.foretelling import foretell
from lesson_code.engine.event_driven.motion import move_to
from lesson_code.engine.event_driven.rows import CELL, DISC, END, GRIP, OBSTACLE, DiscRow, Tables
from lesson_code.engine.event_driven.support import slide_or_roll, stop_sliding

TIME_REACHED, COLLISION, PAUSE, RECORD_FULL, NO_END = range(5)
"""What stops the loop: nothing is left to do, a collision where that was asked for, so many events
that the driver is to have a look, no room for an impulse, or events without end at one instant."""


def advance_until(tables: Tables) -> int:
    """Let all events up to the time `until` happen, and return what has stopped that.

    The next call goes on where this one has stopped.
    """
    state = tables.state
    if not state.has_begun:
        begin(tables)
    while next_time(tables) <= state.until:
        if state.events_left == 0:
            return PAUSE
        if state.keeps_impulses and state.impulse_count == len(tables.impulses):
            return RECORD_FULL
        is_hit = next_event(tables)
        state.events_left -= 1
        if has_no_end(tables):
            return NO_END
        if is_hit and state.stops_at_collision:
            return COLLISION
    return TIME_REACHED


def begin(tables: Tables) -> None:
    """Foretell the first event of every disc."""
    for i in range(len(tables.discs)):
        foretell(tables, i)
    tables.state.has_begun = True


def has_no_end(tables: Tables) -> bool:
    """Return whether more events have happened at once than any scene needs."""
    state = tables.state
    most = MOST_EVENTS_AT_ONCE * len(tables.discs)
    return state.events_at_once > most or state.events_in_piles > most


def next_time(tables: Tables) -> float:
    """Return the time of the next event, s; ``math.inf`` when there is none."""
    return tables.queue[1].time


def next_event(tables: Tables) -> bool:
    """Let the next event happen, and return whether it was a collision."""
    i, state = tables.queue[1].disc, tables.state
    disc = tables.discs[i]
    count_event(tables, disc)
    state.now = max(state.now, disc.event_time)
    move_to(disc, state.now)
    is_hit = happen(tables, i)
    foretell(tables, i)
    state.collisions += is_hit
    return is_hit


def count_event(tables: Tables, disc: DiscRow) -> None:
    """Count the events that happen at once, and those of discs in piles within one hop."""
    state = tables.state
    if disc.event_time > state.now:
        state.events_at_once = 0
    state.events_at_once += 1
    if disc.event_time - state.window_start > state.window:
        state.window_start, state.events_in_piles = disc.event_time, 0
    if disc.event_kind == DISC or disc.event_time - disc.met <= state.pile_time:
        state.events_in_piles += 1


def happen(tables: Tables, i: int) -> bool:
    """Let the event of a disc happen, and return whether it was a collision."""
    disc = tables.discs[i]
    kind, partner = disc.event_kind, disc.partner
    if kind == DISC:
        if tables.discs[partner].changes != disc.partner_changes:
            return False  # stale: the partner has gone another way
        collide_discs(tables, i, partner)
        note_impulse(tables, max(i, partner))
        foretell(tables, partner)
    elif kind == OBSTACLE:
        collide_obstacle(tables, i, partner, disc.feature)
        note_impulse(tables, i)
    elif kind == CELL:
        cross_border(tables, i, disc.feature)
    elif kind == GRIP:
        stop_sliding(tables, disc)
        slide_or_roll(tables, disc)
        disc.changes += 1
    elif kind == END:
        leave_face(tables, disc)
    return kind in (DISC, OBSTACLE)


def note_impulse(tables: Tables, i: int) -> None:
    """Write down the impulse of the collision that has just happened; disc i is its body b."""
    state, c, disc = tables.state, tables.contact, tables.discs[i]
    if not state.keeps_impulses or c.normal_impulse == 0.0:
        return
    sign = 1.0 if c.a < c.b else -1.0
    row = tables.impulses[state.impulse_count]
    row.time, row.a, row.b = state.now, min(c.a, c.b), max(c.a, c.b)
    row.x, row.y, row.nx, row.ny = disc.x + c.bx, disc.y + c.by, sign * c.nx, sign * c.ny
    row.normal_impulse, row.tangent_impulse = c.normal_impulse, c.tangent_impulse
    state.impulse_count += 1
