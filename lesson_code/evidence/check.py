"""One claim, what was measured, what was expected, and how far apart they may be."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


class CheckFailedError(AssertionError):
    """A claim that the measurement does not bear out; it stops the notebook."""


def check(claim: str, measured: Any, expected: Any, tolerance: float = 0.0) -> None:
    """Compare a measurement with an answer from elsewhere, and print one line.

    The claim holds when |measured - expected| <= tolerance for every number in them.

    Parameters
    ----------
    claim : str
        The sentence that is being checked.
    measured : number, bool, str, None or array_like
        What the code under test gave.
    expected : number, bool, str, None or array_like
        What algebra, a limit, a conservation law or another engine says; never the function
        under test. Shapes must be the same, or `expected` a single number for all.
    tolerance : float
        The largest difference allowed, in the unit of `measured`, >= 0. Zero means exactly.

    Raises
    ------
    CheckFailedError
        The claim is false. nan never agrees with anything.
    ValueError
        `tolerance` is negative or nan.

    Examples
    --------
    >>> check("momentum is kept", measured=0.1 + 0.2, expected=0.3, tolerance=1e-12)
    ok    momentum is kept: 0.3, expected 0.3 within 1e-12
    >>> check("the ball rises again", measured=2.0, expected=1.0, tolerance=0.5)
    Traceback (most recent call last):
        ...
    lesson_code.evidence.check.CheckFailedError: FALSE the ball rises again: 2, expected 1 within 0.5
    """
    if not tolerance >= 0:
        raise ValueError(f"tolerance must be >= 0, got {tolerance}")
    holds = _agree(measured, expected, tolerance)
    line = (
        f"{claim}: {_written(measured, tolerance)}, expected {_written(expected, tolerance)}"
        f"{f' within {tolerance:g}' if tolerance else ''}"
    )
    if not holds:
        raise CheckFailedError(f"FALSE {line}")
    print(f"ok    {line}")  # noqa: T201 - the line in the notebook is what this is for


def _agree(measured: Any, expected: Any, tolerance: float) -> bool:
    """Return whether every number agrees; anything but numbers must be equal."""
    if not (_is_numeric(measured) and _is_numeric(expected)):
        return type(measured) is type(expected) and bool(measured == expected)
    m, x = np.asarray(measured, dtype=float), np.asarray(expected, dtype=float)
    if x.shape not in ((), m.shape):
        return False
    # An infinite answer agrees with the same infinity; nan <= tolerance is False.
    with np.errstate(invalid="ignore"):
        return bool(np.all((m == x) | (np.abs(m - x) <= tolerance)))


def _is_numeric(value: Any) -> bool:
    """Return whether `value` is a number or an array of numbers, and no bool."""
    try:
        return np.asarray(value, dtype=float).dtype == float and not isinstance(
            value, bool | np.bool_ | str | None
        )
    except (TypeError, ValueError):
        return False


MOST_NUMBERS_WRITTEN = 6
"""A line has room for so many; of a longer array only its range is written."""


def _written(value: Any, tolerance: float) -> str:
    """Return `value` as text that is the same on every machine: no digit below the tolerance."""
    if not _is_numeric(value):
        return str(value)
    array = np.asarray(value, dtype=float)
    if array.size > MOST_NUMBERS_WRITTEN:
        low, high = _number(array.min(), tolerance), _number(array.max(), tolerance)
        span = low if low == high else f"{low} to {high}"
        return f"{array.size} numbers, {span}"
    numbers = [_number(item, tolerance) for item in array.flat]
    return numbers[0] if array.ndim == 0 else f"({', '.join(numbers)})"


def _number(value: float, tolerance: float) -> str:
    """Return a number to six digits, with rounding below the tolerance cleared away."""
    if not math.isfinite(value):
        return str(float(value))
    decimals = 15 if tolerance == 0 else max(0, math.ceil(-math.log10(tolerance)))
    return f"{round(float(value), decimals) + 0.0:.6g}"
