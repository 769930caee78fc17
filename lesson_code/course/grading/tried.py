"""One call of a student's function: what was asked, what was expected, and what came."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from lesson_code.course.grading.compare import agrees
from lesson_code.course.grading.task import Arguments, Criterion, Part
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import plain


@dataclass(frozen=True)
class TriedCall:
    """One call for a criterion: its arguments, what was expected, and what came."""

    criterion: Criterion
    arguments: Arguments
    expected: Any
    outcome: CallOutcome

    @property
    def is_right(self) -> bool:
        """Whether the answer is right, in the part that is looked at."""
        return self.outcome.kind == "returned" and agrees(self.got, self.wanted)

    @property
    def got(self) -> Any:
        """What the criterion looks at of the answer that came."""
        part = self.criterion.part
        return self.outcome.value if part is None else part_of(part, self.outcome.value)

    @property
    def wanted(self) -> Any:
        """What the criterion looks at of the answer that was expected."""
        part = self.criterion.part
        return self.expected if part is None else plain(part(self.expected))


def part_of(part: Part, answer: Any) -> Any:
    """Return the part of an answer that is looked at; of an answer of another form, None."""
    try:
        return plain(part(answer))
    except (TypeError, ValueError, IndexError):
        return None
