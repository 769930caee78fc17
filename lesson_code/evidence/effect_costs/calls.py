"""How often the functions that only one effect needs are called: not at all where it is left out.

They are counted while the engine runs in plain Python. Compiled code has no calls to count; there
the source of the program shows that they are not in it.
"""

from __future__ import annotations

import sys
from collections import Counter
from types import FrameType
from typing import Any

from lesson_code.engine.stepper import EngineStepper

STAGES: dict[str, tuple[str, ...]] = {
    "collisions": ("find_pairs", "find_contacts", "prepare", "resolve"),
    "broad_phase": ("uniform_grid",),
    "outlines": ("collide_with_circle", "collide_rows"),
    "manifolds": ("collide_rows", "couple"),
    "seams": ("drop_seams",),
    "continuous": ("has_fast_body",),
    "restitution": ("set_bounces",),
    "friction": ("set_frame", "solve_contact", "couple_tangents", "friction_impulse"),
    "rotation": ("turn_on",),
    "gravity": ("fall",),
    "damping": ("damp",),
    "warm_starting": ("warm_start", "recall", "store"),
    "position_correction": ("has_overlap_to_undo", "correct"),
    "sleeping": ("let_sleep", "everything_sleeps"),
    "callbacks": ("before_impulses", "after_impulses"),
    "impulse_record": ("has_room_for_record", "record_impulses"),
}
"""The functions of the sequential solver's program that only one effect calls for."""

PACKAGE = "lesson_code."


def calls_of(engine: EngineStepper, steps: int) -> Counter[str]:
    """Return how often each function of the package is called while an engine makes some steps."""
    counted: Counter[str] = Counter()

    def count(frame: FrameType, event: str, _argument: Any) -> None:
        if event == "call" and str(frame.f_globals.get("__name__")).startswith(PACKAGE):
            counted[frame.f_code.co_name] += 1

    before = sys.getprofile()
    sys.setprofile(count)
    try:
        engine.advance(steps)
    finally:
        sys.setprofile(before)
    return counted


def calls_for(effect: str, engine: EngineStepper, steps: int) -> float:
    """Return how often a step calls the functions that only an effect needs."""
    counted = calls_of(engine, steps)
    return sum(counted[name] for name in STAGES[effect]) / steps
