"""The event-driven solver: from collision to collision, with no time step between them.

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

import math
from typing import TypeAlias

from lesson_code.engine.combination import Combination
from lesson_code.engine.event_driven.cells import cross_border
from lesson_code.engine.event_driven.collisions import collide_discs, collide_obstacle, leave_face
from lesson_code.engine.event_driven.constants import MOST_EVENTS_AT_ONCE
from lesson_code.engine.event_driven.foretelling import foretell
from lesson_code.engine.event_driven.motion import move_to, place_at, turning_at, velocity_at
from lesson_code.engine.event_driven.rows import (
    CELL,
    DISC,
    END,
    GRIP,
    OBSTACLE,
    DiscRow,
    Tables,
)
from lesson_code.engine.event_driven.support import slide_or_roll, stop_sliding
from lesson_code.engine.event_driven.tables import tables_of
from lesson_code.engine.recording import Event
from lesson_code.engine.scene import Body, Scene
from lesson_code.geometry.shapes import Circle

State: TypeAlias = tuple[float, float, float, float, float, float]
"""x, y, angle, vx, vy, w."""


def next_time(tables: Tables) -> float:
    """Return the time of the next event, s; ``math.inf`` when there is none."""
    return tables.discs[tables.queue[0].index].event_time if tables.queue else math.inf


def next_event(tables: Tables) -> bool:
    """Let the next event happen, and return whether it was a collision."""
    i, state = tables.queue[0].index, tables.state
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
        foretell(tables, partner)
    elif kind == OBSTACLE:
        collide_obstacle(tables, i, partner, disc.feature)
    elif kind == CELL:
        cross_border(tables, i, disc.feature)
    elif kind == GRIP:
        stop_sliding(tables, disc)
        slide_or_roll(tables, disc)
        disc.changes += 1
    elif kind == END:
        leave_face(tables, disc)
    return kind in (DISC, OBSTACLE)


class ExactSolver:
    """A scene at work in the event-driven solver.

    Parameters
    ----------
    scene : Scene
        Discs, and obstacles that do not turn; see :func:`why_not`.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    keep_impulses : bool
        Whether every impulse is written down.

    Raises
    ------
    ValueError
        The scene holds what the solver cannot do.
    """

    def __init__(self, scene: Scene, *, combine: Combination, keep_impulses: bool = True) -> None:
        reason = why_not(scene)
        if reason:
            raise ValueError(f"the exact solver cannot take this scene: {reason}")
        self.scene = scene
        self.tables = tables_of(scene, combine)
        self._keep_impulses = keep_impulses
        self._disc_of = {disc.body: i for i, disc in enumerate(self.tables.discs)}
        self._events: list[Event] = []
        for i in range(len(self.tables.discs)):
            foretell(self.tables, i)

    @property
    def collisions(self) -> int:
        """The number of collisions so far."""
        return self.tables.state.collisions

    def next_collision(self, until: float) -> float | None:
        """Go on to the next collision, and return its time, s; None: there is none until then."""
        while next_time(self.tables) <= until:
            is_hit = next_event(self.tables)
            self._refuse_endless_loop()
            if is_hit:
                if self._keep_impulses:
                    self._note_impulse()
                return self.tables.state.now
        return None

    def advance(self, until: float) -> None:
        """Go on until a time, s."""
        while self.next_collision(until) is not None:
            pass

    def states(self, time: float) -> list[State]:
        """Return x, y, angle, vx, vy, w of every body at a time after the last event, s."""
        moving = {disc.body: _disc_state(disc, time) for disc in self.tables.discs}
        return [
            moving[n] if n in moving else _obstacle_state(body, time)
            for n, body in enumerate(self.scene.bodies)
        ]

    def events(self) -> list[Event]:
        """Return the impulses so far."""
        return self._events

    def _note_impulse(self) -> None:
        """Write down the impulse of the collision that has just happened."""
        state, c = self.tables.state, self.tables.contact
        if c.normal_impulse == 0.0:
            return
        disc = self.tables.discs[self._disc_of[c.b]]
        x, y = disc.x + c.bx, disc.y + c.by
        a, b, sign = (c.a, c.b, 1.0) if c.a < c.b else (c.b, c.a, -1.0)
        self._events.append(
            (
                *(state.now, a, b, x, y, sign * c.nx, sign * c.ny),
                *(c.normal_impulse, c.tangent_impulse, 0.0),
            )
        )

    def _refuse_endless_loop(self) -> None:
        """Stop when too many events have happened at once."""
        state, discs = self.tables.state, len(self.tables.discs)
        if max(state.events_at_once, state.events_in_piles) > MOST_EVENTS_AT_ONCE * discs:
            raise RuntimeError(
                f"the exact solver finds no end of the collisions at {state.now} s: the discs lie "
                'in a pile; solver="sequential" can hold it'
            )


def _disc_state(disc: DiscRow, time: float) -> State:
    """Return the state of a disc."""
    x, y = place_at(disc, time)
    vx, vy = velocity_at(disc, time)
    angle, w = turning_at(disc, time)
    return x, y, angle, vx, vy, w


def _obstacle_state(body: Body, time: float) -> State:
    """Return the state of a body that nothing can push."""
    (x, y), (vx, vy) = body.position, body.velocity
    return x + vx * time, y + vy * time, body.angle, vx, vy, 0.0


def why_not(scene: Scene) -> str:
    """Return what keeps the exact solver from a scene, in words; "" when nothing does.

    >>> why_not(Scene([Body(Circle(1), mass=1.0)], damping=0.1))
    'damping has no closed form here'
    """
    if scene.damping > 0:
        return "damping has no closed form here"
    if scene.callbacks.wanted:
        return "it calls no callbacks"
    for n, body in enumerate(scene.bodies):
        if not body.is_static and not isinstance(body.shape, Circle):
            return f"body {n} can be pushed and is no circle"
        if body.is_static and body.angular_velocity != 0.0:
            return f"body {n} is static and turns"
    return ""
