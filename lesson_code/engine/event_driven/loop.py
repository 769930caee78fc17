"""The loop of the event-driven solver: from event to event, with no time step between them.

    1 the disc whose event comes first lives on to it
    2 the event happens: a hit, the end of sliding
    3 the events of all discs whose motion has changed are predicted anew

A disc knows only its own next event. If its partner's motion has changed since it was predicted,
the event is stale: it is thrown away, and the disc's next event is predicted anew. Where a disc
comes to a border of its cell before that, it goes on as it does, and looks into the new cells.

What the scene does not call for is not in the loop (`effects`), nor the record unless it is kept.

References
----------
Rapaport, The Event Scheduling Problem in Molecular Dynamic Simulation (1980). Lubachevsky, How to
Simulate Billiards and Similar Systems (1991): one event a disc. Bannerman, Strobl, Formella and
Poeschel, Stable Algorithm for Event Detection in Event-Driven Particle Dynamics (2014): an overlap
that closes is an event now.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.event_driven.cells import cross_border
from lesson_code.engine.event_driven.collisions import collide_discs, collide_obstacle, leave_face
from lesson_code.engine.event_driven.constants import LONG_AGO, MOST_EVENTS_AT_ONCE, TIE_TIME
from lesson_code.engine.event_driven.event_prediction import predict, predict_beyond
from lesson_code.engine.event_driven.motion import move_to, place_at, turning_at, velocity_at
from lesson_code.engine.event_driven.rows import DISC, END, GRIP, OBSTACLE, DiscRow, Tables
from lesson_code.engine.event_driven.support import slide_or_roll, stop_sliding

Recorder: TypeAlias = Callable[[Tables, int], None]
"""Writes down the impulse of the collision that has just happened; a disc is its body b."""

TIME_REACHED, COLLISION, PAUSE, RECORD_FULL, NO_END, NO_ORDER = range(6)
"""What stops the loop: nothing is left to do, a collision where that was asked for, so many events
that the driver is to have a look, no room for an impulse, events without end at one instant, or two
collisions of one disc at the same time where that was asked for."""


def advance(tables: Tables, effects: Effects = EVERY_EFFECT, record: Recorder | None = None) -> int:
    """Process all events up to the time `until`, and return why the loop stopped.

    The states at the moments before that are noted. The next call resumes where this one stopped.
    """
    state = tables.state
    while state.moments_done < state.moments:
        moment = tables.moments[state.moments_done].time
        stopped_by = advance_until(tables, moment, effects, record)
        if stopped_by != TIME_REACHED:
            return stopped_by
        note_frame(tables, moment, effects)
        state.moments_done += 1
    return advance_until(tables, state.until, effects, record)


def advance_until(tables: Tables, until: float, effects: Effects, record: Recorder | None) -> int:
    """Process all events up to a time, s, and return why the loop stopped."""
    if not effects.collisions:
        return TIME_REACHED
    state = tables.state
    if not state.has_begun:
        begin(tables, effects)
    while next_time(tables) <= until:
        if state.events_left == 0:
            return PAUSE
        if record is not None and state.impulse_count == len(tables.impulses):
            return RECORD_FULL
        is_hit = next_event(tables, effects, record)
        state.events_left -= 1
        if has_no_end(tables, effects):
            return NO_END
        if state.stops_at_tie and state.ties > 0:
            return NO_ORDER
        if is_hit and state.stops_at_collision:
            return COLLISION
    return TIME_REACHED


def begin(tables: Tables, effects: Effects = EVERY_EFFECT) -> None:
    """Predict the first event of every disc."""
    for i in range(len(tables.discs)):
        predict(tables, i, effects)
    tables.state.has_begun = True


def has_no_end(tables: Tables, effects: Effects) -> bool:
    """Return whether more events have happened at once than any scene needs."""
    state = tables.state
    most = MOST_EVENTS_AT_ONCE * len(tables.discs)
    if effects.gravity and state.events_in_piles > most:
        return True
    return state.events_at_once > most


def next_time(tables: Tables) -> float:
    """Return the time of the next event, s; ``math.inf`` when there is none."""
    return tables.queue[1].time


def next_event(
    tables: Tables, effects: Effects = EVERY_EFFECT, record: Recorder | None = None
) -> bool:
    """Process the next event, and return whether it was a collision."""
    i, time, state = tables.queue[1].disc, next_time(tables), tables.state
    disc = tables.discs[i]
    count_event(tables, time)
    state.now = max(state.now, time)
    if disc.border_time <= disc.event_time:
        cross_border(tables, i, disc.border_side)
        predict_beyond(tables, i, disc.border_side, effects)
        return False
    if effects.gravity:
        count_event_in_piles(tables, disc)
    is_hit = happen(tables, i, effects, record)
    predict(tables, i, effects)
    state.collisions += is_hit
    return is_hit


def count_event(tables: Tables, time: float) -> None:
    """Count the events that happen at once."""
    state = tables.state
    if time > state.now:
        state.events_at_once = 0
    state.events_at_once += 1


def count_event_in_piles(tables: Tables, disc: DiscRow) -> None:
    """Count the events of discs in piles within one hop."""
    state = tables.state
    if disc.event_time - state.window_start > state.window:
        state.window_start, state.events_in_piles = disc.event_time, 0
    if disc.event_kind == DISC or disc.event_time - disc.met <= state.pile_time:
        state.events_in_piles += 1


def happen(tables: Tables, i: int, effects: Effects, record: Recorder | None) -> bool:
    """Process the event of a disc, and return whether it was a collision."""
    disc = tables.discs[i]
    kind, partner = disc.event_kind, disc.partner
    if kind == DISC:
        other = tables.discs[partner]
        if other.changes != disc.partner_changes:
            return False  # stale: the partner's motion has changed
        tables.state.ties += is_tie(disc.time, other.time, disc.event_time)
        collide_discs(tables, i, partner, effects)
        predict(tables, partner, effects)
    elif kind == OBSTACLE:
        collide_obstacle(tables, i, partner, disc.feature, effects)
    elif effects.gravity:
        go_on_along_face(tables, disc, effects)
        return False
    if record is not None:
        record(tables, max(i, partner) if kind == DISC else i)
    return True


def is_tie(a: float, b: float, now: float) -> bool:
    """Return whether of two discs that collide now one has just collided, and the other has not.

    Their last collisions were at the times a and b, s. Where both have just collided, discs hit
    each other ever faster, and their order is known.
    """
    same = TIE_TIME * now
    return now - max(a, b) <= same and now - min(a, b) > LONG_AGO * same


def go_on_along_face(tables: Tables, disc: DiscRow, effects: Effects) -> None:
    """Let a disc stop sliding, or leave the face that it rests on."""
    move_to(disc, tables.state.now, effects)
    if effects.friction and disc.event_kind == GRIP:
        stop_sliding(tables, disc, effects)
        slide_or_roll(tables, disc, effects)
        disc.changes += 1
    elif disc.event_kind == END:
        leave_face(tables, disc, effects)


def note_frame(tables: Tables, time: float, effects: Effects) -> None:
    """Note the states of all discs at a time, each in the row of its body."""
    state = tables.state
    for i in range(len(tables.discs)):
        disc = tables.discs[i]
        k = state.frame_rows + disc.body
        place, velocity = tables.positions[k], tables.velocities[k]
        place.x, place.y = place_at(disc, time, effects)
        velocity.x, velocity.y = velocity_at(disc, time, effects)
        if effects.rotation:
            tables.angles[k].value, tables.spins[k].value = turning_at(disc, time, effects)
    state.frame_rows += len(tables.discs) + len(tables.obstacles)


def note_impulse(tables: Tables, i: int) -> None:
    """Write down the impulse of the collision that has just happened; disc i is its body b."""
    state, c, disc = tables.state, tables.contact, tables.discs[i]
    if c.normal_impulse == 0.0:
        return
    sign = 1.0 if c.a < c.b else -1.0
    row = tables.impulses[state.impulse_count]
    row.time, row.a, row.b = state.now, min(c.a, c.b), max(c.a, c.b)
    row.x, row.y = disc.x - c.nx * disc.radius, disc.y - c.ny * disc.radius
    row.nx, row.ny = sign * c.nx, sign * c.ny
    row.normal_impulse, row.tangent_impulse = c.normal_impulse, c.tangent_impulse
    row.penetration = 0.0
    state.impulse_count += 1
