"""The outcome of a call to a student's function: a plain value, or why there is none."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

from lesson_code.course.isolation.inside import answers

Kind: TypeAlias = Literal[
    "returned", "raised", "unusable", "missing", "not written", "timeout", "not called", "crashed"
]
KINDS_FROM_CHILD = ("returned", "raised", "unusable", "missing", "not written")

LONGEST_TEXT = 500
"""Characters of what a child says in words that are kept."""


@dataclass(frozen=True)
class CallOutcome:
    """The outcome of a call: a plain value, or the reason why there is none.

    `sets` are the levels of the value at which sets stood, 0 for the value itself.
    """

    kind: Kind
    value: Any = None
    text: str = ""
    sets: frozenset[int] = frozenset()


def call_outcome(reply: dict[str, Any]) -> CallOutcome:
    """Return what a reply says, if it says it in the form agreed on."""
    kind, text, sets = reply.get("kind"), reply.get("text", ""), reply.get("sets", [])
    try:
        are_levels = isinstance(sets, list) and all(isinstance(level, int) for level in sets)
        if kind in KINDS_FROM_CHILD and isinstance(text, str) and are_levels:
            value = answers.plain(reply.get("value"))
            return CallOutcome(kind, value, one_line(text), frozenset(sets))
    except (ValueError, OverflowError):
        pass
    return CallOutcome("crashed", text="the answer could not be read")


def one_line(text: str) -> str:
    """Return a student's words so that they can stand in a report and forge none of it."""
    shown = text[:LONGEST_TEXT]
    return "".join(character if character.isprintable() else " " for character in shown)
