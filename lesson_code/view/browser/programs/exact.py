"""The exact solver, from event to event: discs, and obstacles that do not turn."""

from __future__ import annotations

from lesson_code.engine.compiled.webassembly import table_program
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.event_driven import loop
from lesson_code.engine.event_driven.constants import EVENTS_A_CALL, RECORD_ROWS
from lesson_code.engine.event_driven.rows import Tables

STOPS = ("TIME_REACHED", "COLLISION", "PAUSE", "RECORD_FULL", "NO_END", "NO_ORDER")
"""What stops the loop, by the names of its numbers."""

EVENTS = {
    "stops": {name: getattr(loop, name) for name in STOPS},
    "events_a_call": EVENTS_A_CALL,
    "record_rows": RECORD_ROWS,
}
"""What ``program.js`` has to know to go on where the loop has stopped."""

PROGRAM = table_program(
    Tables, loop.advance, effects=EVERY_EFFECT, record=loop.note_impulse
).telling(events=EVENTS)
