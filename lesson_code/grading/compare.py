"""Whether an answer agrees with what was expected."""

from __future__ import annotations

from typing import Any

from lesson_code.grading.task import ANSWER_TOLERANCE


def agrees(got: Any, expected: Any) -> bool:
    """Return whether two plain values are the same to the tolerance of answers.

    Shapes must be equal; None, text and truth values agree only with themselves; nan agrees
    with nothing.

    >>> agrees([3, 4.0], [3.0, 4.0]), agrees(float("nan"), 0.0), agrees(None, 0.0)
    (True, False, False)
    """
    if isinstance(expected, list):
        return (
            isinstance(got, list)
            and len(got) == len(expected)
            and all(agrees(g, x) for g, x in zip(got, expected, strict=True))
        )
    if expected is None or isinstance(expected, str | bool):
        return type(got) is type(expected) and bool(got == expected)
    if isinstance(got, bool) or not isinstance(got, int | float):
        return False
    # Written so that nan, which makes every comparison false, does not agree.
    return bool(abs(got - expected) <= ANSWER_TOLERANCE * max(1.0, abs(expected)))


def written(value: Any) -> str:
    """Return a plain value as a message shows it: six digits, tuples in round brackets.

    >>> written([1.0, [0.1 + 0.2, None]])
    '(1, (0.3, None))'
    """
    if isinstance(value, list | tuple):
        return f"({', '.join(written(item) for item in value)})"
    return f"{value:.6g}" if isinstance(value, float) else str(value)
