"""The flags: which effects a program reckons with. What a scene does not call for is left out.

A flag is known before the run. Plain Python looks at it; from a compiled program the linker has
removed it, and the branch that it closes. Each file in this folder that is named after an effect
brings a flag of that name; :mod:`lesson_code.engine.effects.choice` works out which are set.
"""

from __future__ import annotations

import pkgutil
from collections import namedtuple
from pathlib import Path
from typing import TYPE_CHECKING

NO_EFFECTS = {"choice", "facts", "flags", "flights", "next_contact", "question"}
"""The modules of this folder that are not effects."""

FOUND = (module.name for module in pkgutil.iter_modules([str(Path(__file__).parent)]))

NAMES = tuple(sorted(set(FOUND) - NO_EFFECTS))
"""The names of all effects."""


DEFAULTS = [name != "sleeping" for name in NAMES]
"""All but sleeping, which is the only one that may change the last bits of a result."""


class Effects(namedtuple("Effects", NAMES, defaults=DEFAULTS)):  # type: ignore[misc]
    """What a run has to reckon with: True or False for each effect."""

    __slots__ = ()

    if TYPE_CHECKING:

        def __init__(self, **flags: bool) -> None: ...
        def __getattr__(self, name: str) -> bool: ...
        def _replace(self, **flags: bool) -> Effects: ...


EVERY_EFFECT = Effects()
"""The effects that a stage includes by default."""
