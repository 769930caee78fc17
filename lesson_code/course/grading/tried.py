"""One call of a student's function: what was asked, what was expected, and what came."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from lesson_code.course.grading.compare import agrees
from lesson_code.course.grading.task import Arguments, Criterion, Part
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import plain
from lesson_code.course.isolation.inside.vectors import unwarned


@dataclass(frozen=True)
class TriedCall:
    """One call for a criterion: its arguments, what was expected, and what came."""

    criterion: Criterion
    arguments: Arguments
    expected: Any
    outcome: CallOutcome

    @cached_property
    def is_right(self) -> bool:
        """Whether the answer is right, in the part that is looked at."""
        return self.outcome.kind == "returned" and agrees(self.got, self.wanted)

    @cached_property
    def got(self) -> Any:
        """What the criterion looks at of the answer that came."""
        part = self.criterion.part
        return self.outcome.value if part is None else part_of(part, self.outcome.value)

    @cached_property
    def wanted(self) -> Any:
        """What the criterion looks at of the answer that was expected."""
        part = self.criterion.part
        return self.expected if part is None else plain(part(self.expected))


def part_of(part: Part, answer: Any) -> Any:
    """Return the part of an answer that is looked at; of an answer of another form, None."""
    return of_any_answer(lambda: plain(part(answer)), None)


def of_any_answer(look: Callable[[], Any], otherwise: Any) -> Any:
    """Return what a chapter's own code makes of an answer, or something else where it fails.

    Such code is written for answers of the form that was asked for. An answer may be anything:
    whatever that ends in is no error of the grader. What it warns of is kept back by `quietly`.

    >>> of_any_answer(lambda: 1e308**2, "beyond all floats")
    'beyond all floats'
    """
    try:
        return look()
    except Exception:  # another form can make it fail in any way
        return otherwise


@contextlib.contextmanager
def quietly() -> Iterator[None]:
    """Keep to ourselves what Python and NumPy warn of while any answers are looked at."""
    with unwarned(), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        yield
