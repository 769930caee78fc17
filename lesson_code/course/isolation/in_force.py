"""What stands between student code and this machine, in the words of a report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal, TypeAlias

Level: TypeAlias = Literal["full", "limits", "none"]

LEVELS: tuple[Level, ...] = ("none", "limits", "full")
"""From the least to the most. Full: no file, no network and no process of this machine is within
reach, and nothing outlives the submission. Limits: time, memory and file size are bounded."""


class IsolationError(ValueError):
    """There is less isolation to be had than was asked for; the message says why."""


@dataclass(frozen=True)
class InForce:
    """The isolation a submission was graded in: its level, the rung that gave it, and of what."""

    level: Level
    rung: str
    details: tuple[str, ...]

    def __str__(self) -> str:
        return f"{self.level} ({'; '.join(self.details)})"

    def as_dict(self) -> dict[str, Any]:
        """Return the isolation as a JSON object."""
        return {"level": self.level, "rung": self.rung, "details": list(self.details)}


def require_level(level: str) -> Level:
    """Return a level.

    Raises
    ------
    ValueError
        There is no such level.
    """
    for known in LEVELS:
        if level == known:
            return known
    raise ValueError(f"isolation must be full, limits or none, got {level!r}")
