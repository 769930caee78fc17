"""Answers of a reader's functions, in the forms that an engine can go on with."""

from __future__ import annotations

from typing import Any

import numpy as np

SAME = 1e-6
"""m, m/s, rad/s: two right ways to compute an answer differ by rounding, far below it."""


def vector(answer: Any) -> Any:
    """Return a vector, shape (2,)."""
    return _finite(np.asarray(answer, dtype=float).reshape(2))


def number(answer: Any) -> float:
    """Return a number."""
    return float(_finite(np.asarray(answer, dtype=float).reshape(())))


def positive_number(answer: Any) -> float:
    """Return a number > 0."""
    value = number(answer)
    if not value > 0:
        raise ValueError(f"it returned {value:g}, which is not > 0")
    return value


def pairs(answer: Any) -> set[tuple[int, int]]:
    """Return pairs of numbers (i, j), i < j."""
    found = {(int(i), int(j)) for i, j in answer}
    return {(min(pair), max(pair)) for pair in found if pair[0] != pair[1]}


def way_out(answer: Any) -> tuple[Any, float] | None:
    """Return (normal, depth), or None."""
    if answer is None:
        return None
    normal, depth = answer
    return vector(normal), number(depth)


def segment(answer: Any) -> tuple[Any, Any] | None:
    """Return (start, end), or None."""
    return None if answer is None else two_vectors(answer)


def two_vectors(answer: Any) -> tuple[Any, Any]:
    """Return two vectors."""
    first, second = answer
    return vector(first), vector(second)


def motions(answer: Any) -> tuple[Any, float, Any, float]:
    """Return (v_a, w_a, v_b, w_b)."""
    v_a, w_a, v_b, w_b = answer
    return vector(v_a), number(w_a), vector(v_b), number(w_b)


def are_near(one: Any, other: Any) -> bool:
    """Return whether two answers of one form are the same but for rounding."""
    if one is None or other is None:
        return one is other
    first, second = _numbers(one), _numbers(other)
    if first.shape != second.shape:
        return False
    return bool(np.all(np.abs(first - second) <= SAME * np.maximum(1, np.abs(second))))


def written(answer: Any) -> str:
    """Return an answer as a line has room for it.

    >>> written((np.array([0.0, 1.0]), 0.25))
    '(0, 1, 0.25)'
    """
    if answer is None:
        return "None"
    if isinstance(answer, set):
        return ", ".join(f"{i}-{j}" for i, j in sorted(answer)) or "no pairs"
    return "(" + ", ".join(f"{value + 0.0:.4g}" for value in _numbers(answer).tolist()) + ")"


def _numbers(answer: Any) -> Any:
    """Return all numbers of an answer in a row."""
    parts = answer if isinstance(answer, tuple) else (answer,)
    return np.hstack([np.zeros(0), *map(np.ravel, parts)])


def _finite(value: Any) -> Any:
    """Return a value whose numbers are all finite."""
    if not np.all(np.isfinite(value)):
        raise ValueError(f"it returned {value}, which is not finite")
    return value
