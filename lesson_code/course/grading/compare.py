"""Whether an answer agrees with what was expected."""

from __future__ import annotations

from typing import Any

from lesson_code.course.grading.task import ANSWER_TOLERANCE

LONGEST_VALUE = 300
"""Characters of an answer that a message shows."""


def agrees(got: Any, expected: Any) -> bool:
    """Return whether two plain values are the same to the tolerance of answers.

    Shapes must be equal; None, text and truth values agree only with themselves; nan agrees
    with nothing.

    >>> agrees([3, 4.0], [3.0, 4.0]), agrees(float("nan"), 0.0), agrees(None, 0.0)
    (True, False, False)
    """
    if type(got) is not float or type(expected) is not float:  # most answers are floats
        if isinstance(expected, list):
            is_as_long = isinstance(got, list) and len(got) == len(expected)
            return is_as_long and all(map(agrees, got, expected))
        if expected is None or isinstance(expected, str | bool):
            return type(got) is type(expected) and bool(got == expected)
        if isinstance(got, bool) or not isinstance(got, int | float):
            return False
    # Written so that nan, which makes every comparison false, does not agree.
    return bool(abs(got - expected) <= ANSWER_TOLERANCE * max(1.0, abs(expected)))


def written(value: Any, digits: int = 6) -> str:
    """Return a plain value as a message shows it: six digits, tuples in round brackets.

    >>> written([1.0, [0.1 + 0.2, None, "left"]])
    "(1, (0.3, None, 'left'))"
    """
    if isinstance(value, list | tuple):
        items = ", ".join(written(item, digits) for item in value)
        return f"({items},)" if len(value) == 1 else f"({items})"
    return f"{value:.{digits}g}" if isinstance(value, float) else repr(value)


def told_apart(got: Any, expected: Any) -> tuple[str, str]:
    """Return two values as a message shows them, with more digits where six look the same.

    >>> told_apart([1.0, 2.00000003], [1.0, 2.0])
    ('(1, 2.00000003)', '(1, 2)')
    """
    texts = ((written(got, digits), written(expected, digits)) for digits in (6, 12))
    shown = next((pair for pair in texts if pair[0] != pair[1]), (repr(got), repr(expected)))
    return shortened(shown[0]), shortened(shown[1])


def shortened(text: str) -> str:
    """Return the beginning of a text that is too long for a message."""
    return text if len(text) <= LONGEST_VALUE else f"{text[:LONGEST_VALUE]}..."
