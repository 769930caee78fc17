"""How often the functions that only one effect needs are called: not at all where it is left out.

They are counted while the engine runs in plain Python. Compiled code has no calls to count; there
the source of the program shows that they are not in it.
"""

from __future__ import annotations

import sys
from collections import Counter
from types import FrameType
from typing import Any

from lesson_code.engine.effects.choice import EFFECTS
from lesson_code.engine.stepper import EngineStepper

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
    return sum(counted[name] for name in EFFECTS[effect].functions) / steps
