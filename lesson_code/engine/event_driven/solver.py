"""The event-driven solver at work on one scene: its tables, its errors, its record of impulses.

The events themselves are in :mod:`lesson_code.engine.event_driven.loop`.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import (
    Choice,
    as_arrays,
    as_numbers,
    choose,
    compiled_function,
    link,
)
from lesson_code.engine.core.capacity import longer
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import EVENT_NUMBERS, STATE_NUMBERS
from lesson_code.engine.core.rows import ImpulseRow
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.choice import choose_effects, flags_of, names_used
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.event_driven.constants import (
    EVENT_SECONDS,
    EVENTS_A_CALL,
    MOST_AHEAD,
    RECORD_ROWS,
)
from lesson_code.engine.event_driven.loop import (
    COLLISION,
    NO_END,
    NO_ORDER,
    PAUSE,
    RECORD_FULL,
    Recorder,
    advance_until,
    note_impulse,
)
from lesson_code.engine.event_driven.motion import place_at, turning_at, velocity_at
from lesson_code.engine.event_driven.tables import tables_of
from lesson_code.geometry.shapes import Circle


@cache
def program(effects: Effects, record: Recorder | None) -> str:
    """Return the source of the program that the loop is compiled as."""
    return link(advance_until, effects=effects, record=record)


ANGLE = 2
"""Where the angle stands in a state."""


class ExactSolver:
    """A scene at work in the event-driven solver.

    Parameters
    ----------
    scene : Scene
        Discs, and obstacles that do not turn; see :func:`why_not`.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    keep_impulses : bool
        Whether every impulse is written down.
    compiled : bool or None
        Whether the stages run as compiled code. They do the same to the last bit. None: they begin
        as plain Python, and are compiled if the work ahead repays it.
    duration : float
        s, how long the run will be, for that decision; ``math.inf``: until nothing happens.
    effects : mapping, optional
        Effects to force on or to leave out, by name; see :mod:`lesson_code.engine.effects.choice`.

    stops_at_tie : bool
        Whether to give up where two collisions of one disc come at the same time. They are else
        played one after the other, in an order that rounding decides.

    Attributes
    ----------
    tables : Tables
        Lists of rows or, when compiled, arrays of records.
    choice : Choice
        Whether they are compiled, and why.
    effects : tuple of EffectChoice
        What it reckons with, and why.
    collisions : int
        So far.

    Raises
    ------
    ValueError
        The scene holds what the solver cannot do, or cannot be compiled as was asked; or effects
        are asked for that it lacks.
    RuntimeError
        Two collisions of a disc come at the same time, and the run is to stop there.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        combine: MixingRule,
        keep_impulses: bool = True,
        compiled: bool | None = False,
        duration: float = math.inf,
        effects: Mapping[str, bool] | None = None,
        stops_at_tie: bool = False,
    ) -> None:
        reason = why_not(scene)
        if reason:
            raise ValueError(f"the exact solver cannot take this scene: {reason}")
        self.scene = scene
        wanted = effects if keep_impulses else {**(effects or {}), "impulse_record": False}
        question = Question(scene, "exact", duration=duration, combine=combine)
        self.effects = choose_effects(question, wanted)
        used = names_used(self.effects)
        self._flags = flags_of(self.effects)
        record = note_impulse if "impulse_record" in used else None
        self.tables = tables_of(scene, combine, "broad_phase" in used)
        self.tables.state.stops_at_tie = stops_at_tie
        self.collisions = 0
        self._events: list[NDArray[np.float64]] = []
        self._program = partial(program, self._flags, record)
        self._advance: Callable[[Any], int] = partial(
            advance_until, effects=self._flags, record=record
        )
        self._asked, self._duration = compiled, duration
        self._events_done = 0
        self.choice = Choice(False, "a small run")
        self._choose(len(self.tables.discs) * MOST_AHEAD)
        self.advance(-1.0)  # no event yet, but all are predicted

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run so far, with the reason for the choice of this solver."""
        choice = self.choice
        program = self._program
        return Plan("exact", reason, choice.code, choice.reason, self.effects, program=program)

    def next_collision(self, until: float) -> float | None:
        """Go on to the next collision, and return its time, s; None: there is none until then."""
        stopped_by = self._run(until, stops_at_collision=True)
        return float(self.tables.state.now) if stopped_by == COLLISION else None

    def advance(self, until: float) -> None:
        """Go on until a time, s.

        Raises
        ------
        ValueError
            The plan holds only for the duration of the run, and the time is later.
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
        states[free] = self._disc_states(states[free, ANGLE], time)
        return states

    def events(self) -> NDArray[np.float64]:
        """Return the impulses so far, shape (K, 10)."""
        self._take_impulses()
        self._events = [np.concatenate([np.empty((0, EVENT_NUMBERS)), *self._events])]
        return self._events[0]

    def _disc_states(self, angles: NDArray[np.float64], time: float) -> NDArray[np.float64]:
        """Return the states of all discs, from their angles at the start.

        The formulas serve one disc, and columns of many.
        """
        discs: Any = self.tables.discs
        if isinstance(discs, np.ndarray):
            columns = self._disc_state(discs.view(np.recarray), angles, time)
            return np.column_stack(np.broadcast_arrays(*columns))
        rows = [self._disc_state(*disc, time) for disc in zip(discs, angles, strict=True)]
        return np.array(rows).reshape(-1, STATE_NUMBERS)

    def _disc_state(self, disc: Any, angle: Any, time: float) -> Any:
        """Return the state of a disc."""
        (x, y), (vx, vy) = place_at(disc, time, self._flags), velocity_at(disc, time, self._flags)
        w: Any = 0.0
        if self._flags.rotation:
            angle, w = turning_at(disc, time, self._flags)
        return x, y, angle, vx, vy, w

    def _run(self, until: float, *, stops_at_collision: bool) -> int:
        """Go on until a time or the next collision, and return which of them came first."""
        if until > self._duration and not self._flags.collisions:
            raise ValueError(
                f"until must be <= {self._duration} s: later bodies may meet, got {until}"
            )
        state = self.tables.state
        state.until = min(until, sys.float_info.max)  # not to the events that never happen
        state.stops_at_collision = stops_at_collision
        while True:
            stopped_by = self._advance(self.tables)
            self.collisions += int(state.collisions)
            state.collisions = 0
            if stopped_by == NO_END:
                raise RuntimeError(
                    f"the exact solver finds no end of the collisions at {state.now} s: the discs "
                    'lie in a pile; solver="sequential" can hold it'
                )
            if stopped_by == NO_ORDER:
                raise RuntimeError(
                    f"the exact solver finds no order of two collisions of a disc at {state.now} s"
                )
            if stopped_by == RECORD_FULL:
                self._take_impulses()
                self._make_room()
            elif stopped_by == PAUSE:
                self._look_ahead()
                state = self.tables.state
            else:
                return stopped_by

    def _look_ahead(self) -> None:
        """Estimate the work that is left, and choose again whether to compile it.

        It is as much as in the time so far, but no more than :data:`MOST_AHEAD` times what is done:
        many a run comes to rest.
        """
        state = self.tables.state
        self._events_done += EVENTS_A_CALL
        state.events_left = EVENTS_A_CALL
        left = max(self._duration - state.now, 0.0)
        ahead = min(left / state.now, MOST_AHEAD) if state.now > 0.0 else MOST_AHEAD
        self._choose(self._events_done * ahead)

    def _choose(self, events: float) -> None:
        """Compile what is still plain Python if so many events repay it, or if it was asked for."""
        if self.choice.compiled or self._asked is False:
            return
        self.choice = choose(self._asked, events * EVENT_SECONDS, self._program)
        if self.choice.compiled:
            source = self._program()
            self.tables = as_arrays(self.tables, source + self._reading())
            self._advance = compiled_function(source, "advance_until")

    def _reading(self) -> str:
        """Return the source of what the states are read by: its fields are kept, too."""
        formulas = [place_at, velocity_at, *([turning_at] if self._flags.rotation else [])]
        return "".join(link(formula, effects=self._flags) for formula in formulas)

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
