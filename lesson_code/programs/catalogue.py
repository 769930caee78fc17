"""The programs by name; none is loaded before it is played."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from lesson_code.programs.game import Program

SUMMARIES = {
    "simulator": "Launch balls, and watch momentum and energy: elastic, partial, inelastic.",
    "demo": "Circles, a triangle and a square in a box: everything of the course at once.",
    "billiards": "One ball, four cushions, a bumper at 45 degrees.",
    "pool": "A cue that gives spin, cushions with friction, six pockets.",
    "cradle": "Newton's cradle: k balls in, k balls out, for 1 to 9 balls.",
    "breakout": "Bricks, a paddle that decides the angle, five levels.",
    "dominoes": "A chain that branches: on along the floor, and up onto a shelf.",
    "asteroids": "Varying masses that burst, thrust and recoil, and a ledger of momentum.",
    "soft_body": "Rings of masses and springs that deform where they collide.",
}
"""Name and a sentence, of every program."""


def load(name: str) -> Program:
    """Return a program.

    Raises
    ------
    ValueError
        There is none of that name.
    """
    if name not in SUMMARIES:
        raise ValueError(f"program must be one of {', '.join(SUMMARIES)}, got {name!r}")
    program: Program = importlib.import_module(f"lesson_code.programs.{name}").PROGRAM
    return program
