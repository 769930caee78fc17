"""The event-driven solver at work on one scene: its tables, its errors, its record of impulses.

The events themselves are in :mod:`lesson_code.engine.event_driven.loop`.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from copy import copy, deepcopy
from functools import cache, partial
from operator import attrgetter
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import (
    Code,
    Program,
    another,
    as_arrays,
    copy_of,
    full_rows,
    link,
    new_table,
    program_of,
)
from lesson_code.engine.compiled.loader import Entry
from lesson_code.engine.core.capacity import longer
from lesson_code.engine.core.frames import Frames, frames_at_once, given_back
from lesson_code.engine.core.impulse_table import ImpulseTable
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.rows import ImpulseRow
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.effects.choice import (
    choose_effects,
    flags_of,
    names_used,
    suit_any_scene,
)
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
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
    advance,
    note_impulse,
)
from lesson_code.engine.event_driven.motion import place_at, turning_at, velocity_at
from lesson_code.engine.event_driven.rows import DiscRow, MomentRow, Tables
from lesson_code.engine.event_driven.tables import exact_arrays_of
from lesson_code.engine.event_driven.work import events_expected


@cache
def source_of(effects: Effects, record: Recorder | None) -> str:
    """Return the source of the program that the loop is compiled as."""
    return link(advance, effects=effects, record=record)


def program_for_any_scene() -> Program:
    """Return the program with every effect, which comes ready-made."""
    return program_of(source_of(EVERY_EFFECT, note_impulse), "advance", Tables)


ANGLE = 2
"""Where the angle stands in a state."""

MOTION = ("time", "x", "y", "vx", "vy", "ax", "ay", "angle", "w", "alpha")
"""The fields of a disc that say where it is at a time."""

motion_of = attrgetter(*MOTION)
"""Returns them of a disc."""


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
        Whether the stages run as compiled code. They do the same to the last bit. None: where that
        saves time, perhaps from some event on; then :meth:`close` it when it is no longer needed.
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
        self.tables = exact_arrays_of(scene, combine, "broad_phase" in used)
        self.tables.state.stops_at_tie = stops_at_tie
        c = scene.columns
        self._start = np.column_stack([c.x, c.y, c.angle, c.vx, c.vy, np.zeros(len(c))])
        self._free, self._fixed = np.flatnonzero(c.is_free), np.flatnonzero(~c.is_free)
        self._movers = np.flatnonzero(c.is_moving[self._fixed])
        self.collisions = 0
        self._impulses = ImpulseTable()
        self._source = partial(source_of, self._flags, record)
        self._advance: Callable[[Any], float] = partial(advance, effects=self._flags, record=record)
        self._duration = duration
        self._code = Code(compiled)
        events = 0.0
        if self._flags.collisions:
            events = events_expected(scene, duration, has_grid=self._flags.broad_phase)
        seconds = events * EVENT_SECONDS
        self._change_to(self._code.begin(self.program, seconds, other=self.program_for_any))
        self.advance(-1.0)  # no event yet, but all are predicted

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run so far, with the reason for the choice of this solver."""
        return Plan("exact", reason, *self._code.choice, self.effects, program=self._source)

    def program(self) -> Program:
        """Return the program of the loop, as it is compiled."""
        return program_of(self._source(), "advance", Tables)

    def program_for_any(self) -> Program | None:
        """Return the program for any scene, if it does what this run asks for."""
        return program_for_any_scene() if suit_any_scene(self.effects) else None

    def compile(self) -> None:
        """Go on in machine code, with the same bits: at once if it is kept or came ready-made."""
        self._code.close()
        self._code = Code(None)
        if isinstance(self.tables.discs, list):
            now = f"t = {self.tables.state.now:.3g} s"
            self._change_to(self._code.begin(self.program, math.inf, now, self.program_for_any))

    def twin(self) -> ExactSolver:
        """Return a solver that goes on from here on its own; what is compiled serves both."""
        other = copy(self)
        other.tables, other._impulses = copy_of(self.tables), deepcopy(self._impulses)
        return other

    def close(self) -> None:
        """End the run: a process that still compiles for it ends too, unless it is nearly done."""
        self._code.close()

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
        states = np.empty_like(self._start)
        states[self._fixed] = self._obstacles_at(np.array([time]))[0]
        states[self._free] = self._disc_states(self._start[self._free, ANGLE], time)
        return states

    def note_frames(self, frames: Frames) -> None:
        """Go on to the times of some frames, which ascend; the program notes the states there."""
        first, last = 0, len(frames.times)
        rotation = self._flags.rotation
        while first < last:
            at_once = frames_at_once(len(self._start), is_plain=isinstance(self.tables.discs, list))
            block = slice(first, min(first + at_once, last))
            times = frames.times[block]
            if not rotation:
                frames.stay_turned(block, self._start[:, ANGLE], 0.0)
            self._keep_frames(times, frames, block)
            self.advance(times[-1])
            frames.take(block, self.tables, rotation=rotation)
            obstacles = self._obstacles_at(times)  # plain rows hold none
            frames.put(block, obstacles, self._fixed, rotation=rotation)
            frames.require_numbers(block, rotation=rotation)
            self.tables = given_back(self.tables)
            self.tables.state.moments = 0
            first = block.stop

    def _keep_frames(self, times: NDArray[np.float64], frames: Frames, block: slice) -> None:
        """Have the states of all discs noted at some times."""
        moments = new_table(MomentRow, len(times), time=times)
        tables = frames.lend(block, self.tables)._replace(moments=moments)
        self.tables = full_rows(tables) if isinstance(tables.discs, list) else tables
        state = self.tables.state
        state.moments, state.moments_done, state.frame_rows = len(times), 0, 0

    def _obstacles_at(self, times: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the states of the M obstacles at some times, shape (K, M, 6)."""
        start = self._start[self._fixed]
        states: NDArray[np.float64] = np.repeat(start[np.newaxis], len(times), axis=0)
        if self._movers.size:
            ways = states[:, self._movers, 3:5] * times[:, np.newaxis, np.newaxis]
            states[:, self._movers, 0:2] += ways
        return states

    def events(self) -> NDArray[np.float64]:
        """Return the impulses so far, shape (K, 10)."""
        return self.impulses().rows()

    def impulses(self) -> ImpulseTable:
        """Return the impulses so far, as they were written down."""
        self._take_impulses()
        return self._impulses

    def take_events(self) -> NDArray[np.float64]:
        """Return the impulses since they were last taken, shape (K, 10), and forget them."""
        events = self.events()
        self._impulses = ImpulseTable()
        return events

    def _disc_states(self, angles: NDArray[np.float64], time: float) -> NDArray[np.float64]:
        """Return the states of all discs, from their angles at the start.

        The formulas serve one disc, and columns of many with the same bits.
        """
        discs: Any = self.tables.discs
        columns = discs.view(np.recarray) if isinstance(discs, np.ndarray) else _columns_of(discs)
        with np.errstate(over="ignore", invalid="ignore"):  # refused by the recording
            return np.column_stack(np.broadcast_arrays(*self._disc_state(columns, angles, time)))

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
            stopped_by = int(self._advance(self.tables))
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
        """Go on in machine code if it is there now, and the work that is left repays it.

        That is as much as in the time so far, but no more than :data:`MOST_AHEAD` times what is
        done: many a run comes to rest.
        """
        state = self.tables.state
        state.events_left = EVENTS_A_CALL
        if isinstance(self.tables.discs, list):
            left = max(self._duration - state.now, 0.0)
            ahead = min(left / state.now, MOST_AHEAD) if state.now > 0.0 else MOST_AHEAD
            now = f"t = {state.now:.3g} s"
            self._change_to(self._code.look(self.program, ahead, now, self.program_for_any))

    def _change_to(self, entry: Entry | None) -> None:
        """Go on with machine code, if there is any, and else with rows."""
        if entry is None:
            self.tables = full_rows(self.tables)
            return
        self.tables = as_arrays(self.tables, entry.program.source)
        self._advance = entry

    def _take_impulses(self) -> None:
        """Take the impulses out of their table, and give the program another one."""
        state, full = self.tables.state, self.tables.impulses
        if state.impulse_count > 0:
            self._impulses.add(full[: state.impulse_count])
            self.tables = self.tables._replace(impulses=another(full))
            state.impulse_count = 0

    def _make_room(self) -> None:
        """Lengthen the table of impulses, up to what is worth emptying at once."""
        table = self.tables.impulses
        rows = min(2 * len(table) + 1, RECORD_ROWS)
        self.tables = self.tables._replace(impulses=longer(table, rows, ImpulseRow))


def _columns_of(discs: list[DiscRow]) -> SimpleNamespace:
    """Return the motion of many discs, each field as an array."""
    table = np.array([motion_of(disc) for disc in discs], dtype=float).reshape(-1, len(MOTION))
    return SimpleNamespace(**dict(zip(MOTION, table.T, strict=True)))


def why_not(scene: Scene) -> str:
    """Return what keeps the exact solver from a scene, in words; "" when nothing does.

    >>> from lesson_code import Body, Circle
    >>> why_not(Scene([Body(Circle(1), mass=1.0)], damping=0.1))
    'damping has no closed form here'
    """
    if scene.damping > 0:
        return "damping has no closed form here"
    if scene.callbacks.wanted:
        return "it calls no callbacks"
    free = scene.columns.is_free
    wrong = np.where(free, scene.columns.has_corners, scene.columns.w != 0.0)
    if not wrong.any():
        return ""
    n = int(wrong.argmax())
    return f"body {n} " + ("can be pushed and is no circle" if free[n] else "is static and turns")
