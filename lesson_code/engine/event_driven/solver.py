"""The event-driven solver at work on one scene: its tables, its errors, its record of impulses.

What happens in it is told by :mod:`lesson_code.engine.event_driven.loop`.
"""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.combination import Combination
from lesson_code.engine.compiled import as_arrays, as_numbers, compiled_function, link
from lesson_code.engine.event_driven.constants import EVENTS_A_CALL, RECORD_ROWS
from lesson_code.engine.event_driven.loop import (
    COLLISION,
    NO_END,
    PAUSE,
    RECORD_FULL,
    advance_until,
)
from lesson_code.engine.event_driven.motion import place_at, turning_at, velocity_at
from lesson_code.engine.event_driven.tables import tables_of
from lesson_code.engine.recording import EVENT_NUMBERS, STATE_NUMBERS
from lesson_code.engine.room import longer
from lesson_code.engine.rows import ImpulseRow
from lesson_code.engine.scene import Body, Scene
from lesson_code.geometry.shapes import Circle


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
    compiled : bool
        Whether the stages run as compiled code. They do the same to the last bit.

    Attributes
    ----------
    tables : Tables
        Lists of rows or, when compiled, arrays of records.
    collisions : int
        So far.

    Raises
    ------
    ValueError
        The scene holds what the solver cannot do.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        combine: Combination,
        keep_impulses: bool = True,
        compiled: bool = False,
    ) -> None:
        reason = why_not(scene)
        if reason:
            raise ValueError(f"the exact solver cannot take this scene: {reason}")
        self.scene = scene
        self.tables = tables_of(scene, combine)
        self.tables.state.keeps_impulses = keep_impulses
        self.collisions = 0
        self._events: list[NDArray[np.float64]] = []
        self._advance: Any = advance_until
        if compiled:
            self.compile()
        self.advance(-1.0)  # no event yet, but all are foretold

    def compile(self) -> None:
        """Go on as compiled code from here."""
        self.tables = as_arrays(self.tables)
        self._advance = compiled_function(link(advance_until), "advance_until")

    def next_collision(self, until: float) -> float | None:
        """Go on to the next collision, and return its time, s; None: there is none until then."""
        stopped_by = self._run(until, stops_at_collision=True)
        return float(self.tables.state.now) if stopped_by == COLLISION else None

    def advance(self, until: float) -> None:
        """Go on until a time, s.

        Raises
        ------
        RuntimeError
            The collisions at one instant have no end.
        """
        self._run(until, stops_at_collision=False)

    def states(self, time: float) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body at a time after the last event, s.

        The shape is (N, 6).
        """
        bodies = self.scene.bodies
        states = np.array([_state_unpushed(body, time) for body in bodies], dtype=float)
        states = states.reshape(-1, STATE_NUMBERS)
        free = [n for n, body in enumerate(bodies) if not body.is_static]
        states[free] = _disc_states(self.tables.discs, time)
        return states

    def events(self) -> NDArray[np.float64]:
        """Return the impulses so far, shape (K, 10)."""
        self._take_impulses()
        self._events = [np.concatenate([np.empty((0, EVENT_NUMBERS)), *self._events])]
        return self._events[0]

    def _run(self, until: float, *, stops_at_collision: bool) -> int:
        """Go on until a time or the next collision, and return which of them came first."""
        state = self.tables.state
        state.until = min(until, sys.float_info.max)  # not to the events that never happen
        state.stops_at_collision = stops_at_collision
        while True:
            state.events_left = EVENTS_A_CALL
            stopped_by = int(self._advance(self.tables))
            self.collisions += int(state.collisions)
            state.collisions = 0
            if stopped_by == NO_END:
                raise RuntimeError(
                    f"the exact solver finds no end of the collisions at {state.now} s: the discs "
                    'lie in a pile; solver="sequential" can hold it'
                )
            if stopped_by == RECORD_FULL:
                self._take_impulses()
                self._make_room()
            elif stopped_by != PAUSE:
                return stopped_by

    def _take_impulses(self) -> None:
        """Take the impulses out of their table."""
        state = self.tables.state
        if state.impulse_count > 0:
            self._events.append(as_numbers(self.tables.impulses[: state.impulse_count]))
            state.impulse_count = 0

    def _make_room(self) -> None:
        """Lengthen the table of impulses, up to what is worth emptying at once."""
        table = self.tables.impulses
        rows = min(2 * len(table) + 1, RECORD_ROWS)
        self.tables = self.tables._replace(impulses=longer(table, rows, ImpulseRow))


def _disc_states(discs: Any, time: float) -> NDArray[np.float64]:
    """Return the states of all discs; the formulas serve one disc, and columns of many."""
    if isinstance(discs, np.ndarray):
        return np.column_stack(_disc_state(discs.view(np.recarray), time))
    return np.array([_disc_state(disc, time) for disc in discs]).reshape(-1, STATE_NUMBERS)


def _disc_state(disc: Any, time: float) -> Any:
    """Return the state of a disc."""
    (x, y), (vx, vy) = place_at(disc, time), velocity_at(disc, time)
    angle, w = turning_at(disc, time)
    return x, y, angle, vx, vy, w


def _state_unpushed(body: Body, time: float) -> tuple[float, ...]:
    """Return the state of a body that nothing pushes."""
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
