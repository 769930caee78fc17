"""One claim, what was measured, what was expected, and how far apart they may be."""

from __future__ import annotations

import math
import numbers
from typing import Any

import numpy as np

from lesson_code.formulas.validation import non_negative


class CheckFailedError(AssertionError):
    """The measurement contradicts the claim; the error stops the notebook."""


def check(claim: str, measured: Any, expected: Any, tolerance: float = 0.0) -> None:
    """Compare a measurement with an answer from elsewhere, and print one line.

    The claim holds when ``|measured - expected| <= tolerance`` for every number in them.

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
        The largest difference allowed, in the unit of `measured`, >= 0 and finite. Zero means
        exactly.

    Raises
    ------
    CheckFailedError
        The claim is false; the message ends with how far off it is. nan never agrees with
        anything.
    ValueError
        `tolerance` is negative, infinite or nan.

    Examples
    --------
    >>> check("momentum is kept", measured=0.1 + 0.2, expected=0.3, tolerance=1e-12)
    ok    momentum is kept: 0.3, expected 0.3 within 1e-12
    >>> check("it rises", measured=2.0, expected=1.0, tolerance=0.5)
    Traceback (most recent call last):
        ...
    lesson_code.evidence.check.CheckFailedError: FALSE it rises: 2, expected 1 within 0.5 (off by 1)
    """
    tolerance = float(non_negative("tolerance", tolerance))
    fault = _fault(measured, expected, tolerance)
    line = _agreement(claim, measured, expected, tolerance) if not fault else ""
    line = line or (
        f"{claim}: {_written(measured, tolerance)}, expected {_written(expected, tolerance)}"
        f"{f' within {tolerance:g}' if tolerance else ''}"
    )
    if fault:
        raise CheckFailedError(f"FALSE {line} ({fault})")
    print(f"ok    {line}")  # noqa: T201 - the line in the notebook is what this is for


def check_bound(
    claim: str, measured: Any, *, at_least: float = -math.inf, at_most: float = math.inf
) -> None:
    """Compare a measurement with a bound, and print one line with the measurement.

    Parameters
    ----------
    claim : str
        The sentence that is being checked.
    measured : number or array_like
        What the code under test gave; every number in it must keep the bounds.
    at_least, at_most : float
        The bounds, in the unit of `measured`.

    Raises
    ------
    CheckFailedError
        The claim is false, or a number is nan.
    ValueError
        There is no bound, or no number.

    Examples
    --------
    >>> check_bound("it stays below the floor, m", -0.251, at_most=0)
    ok    it stays below the floor, m: -0.25, at most 0
    >>> check_bound("all but a few", [250, 180, 610], at_least=200)
    Traceback (most recent call last):
        ...
    lesson_code.evidence.check.CheckFailedError: FALSE all but a few: 180 to 610, at least 200
    """
    numbers_measured = np.asarray(measured, dtype=float)
    wanted = [
        f"at {name} {bound:g}"
        for name, bound in (("least", at_least), ("most", at_most))
        if math.isfinite(bound)
    ]
    if not wanted or numbers_measured.size == 0:
        raise ValueError(f"a bound and a number must be given, got {wanted} and {measured!r}")
    low, high = numbers_measured.min(), numbers_measured.max()
    noise = NOISE * abs(at_most) if math.isfinite(at_most) else 0.0
    ends = [f"under {noise:g}" if abs(end) < noise else _two_digits(end) for end in (low, high)]
    line = f"{claim}: {' to '.join(dict.fromkeys(ends))}, {' and '.join(wanted)}"
    if not at_least <= low <= high <= at_most:
        raise CheckFailedError(f"FALSE {line}")
    print(f"ok    {line}")  # noqa: T201 - the line in the notebook is what this is for


def _two_digits(value: float) -> str:
    """Return a whole number in full, and any other to two digits."""
    return f"{value:.0f}" if value.is_integer() else f"{value:.2g}"


NOISE = 1e-3
"""Of the tolerance: errors below are not told apart, since rounding differs between machines."""


def _agreement(claim: str, measured: Any, expected: Any, tolerance: float) -> str:
    """Return the line for many numbers that agree: how far off the worst is, to a power of ten."""
    if not _is_numeric(measured) or np.size(measured) <= MOST_NUMBERS_WRITTEN:
        return ""
    if tolerance == 0:
        wanted = _written(expected, tolerance) if np.size(expected) == 1 else "as many"
        return f"{claim}: {np.size(measured)} numbers, expected {wanted}: none is off at all"
    worst = max(float(_apart(measured, expected).max()), NOISE * tolerance)
    bound = min(10.0 ** math.ceil(math.log10(worst) - 1e-9), tolerance)
    wanted = _written(expected, tolerance) if np.size(expected) == 1 else "as many"
    return (
        f"{claim}: {np.size(measured)} numbers, expected {wanted} within {tolerance:g}: "
        f"none is off by more than {bound:g}"
    )


def _apart(measured: Any, expected: Any) -> Any:
    """Return the differences between numbers."""
    m, x = np.asarray(measured), np.asarray(expected)
    # Python's own numbers do not wrap round, as small integers in an array do.
    with np.errstate(over="ignore", invalid="ignore"):
        differences = np.abs(m.astype(object) - x.astype(object))
    return np.where(m == x, 0.0, differences).astype(float)


def _fault(measured: Any, expected: Any, tolerance: float) -> str:
    """Return why the two disagree, or "" if they agree."""
    if not (_is_numeric(measured) and _is_numeric(expected)):
        return "" if _same(measured, expected) else "not the same"
    m, x = np.asarray(measured), np.asarray(expected)
    if m.shape != x.shape and (x.ndim > 0 or m.size == 0):
        return f"shape {m.shape}, not {x.shape}"
    apart = _apart(m, x)
    agree = m == x if tolerance == 0 else apart <= tolerance
    return "" if np.all(agree) else f"off by {apart.max():.3g}"


def _same(measured: Any, expected: Any) -> bool:
    """Return whether two answers that are not numbers are equal and of one kind."""
    m, x = _plain(measured), _plain(expected)
    return type(m) is type(x) and bool(m == x)


def _plain(value: Any) -> Any:
    """Convert NumPy values to Python's own: np.True_ to True, an array of texts to a list."""
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else value


def _is_numeric(value: Any) -> bool:
    """Return whether `value` is a real number or a regular array of them; a bool is neither."""
    if isinstance(value, bool | np.bool_):
        return False
    try:
        array = np.asarray(value)
    except ValueError:
        return False
    if array.dtype == object:  # Fractions, or integers of any length
        return all(isinstance(item, numbers.Real) for item in array.flat)
    return array.dtype.kind in "biuf"


MOST_NUMBERS_WRITTEN = 6
"""Of a longer array only the range is written: a line has no room for more."""


def _written(value: Any, tolerance: float) -> str:
    """Return `value` as text that is the same on every machine: no digit below the tolerance."""
    if not _is_numeric(value):
        return str(_plain(value))
    array = np.asarray(value)
    if array.size > MOST_NUMBERS_WRITTEN:
        low, high = (_number(_plain(end), tolerance) for end in (array.min(), array.max()))
        span = low if low == high else f"{low} to {high}"
        return f"{array.size} numbers, {span}"
    written = [_number(item, tolerance) for item in array.ravel().tolist()]
    return written[0] if array.ndim == 0 else f"({', '.join(written)})"


def _number(value: Any, tolerance: float) -> str:
    """Return an integer in full and any other number to six digits, none below the tolerance."""
    places = -math.floor(math.log10(tolerance)) if tolerance else None
    if isinstance(value, int):
        return str(value if places is None else round(value, places))
    number = float(value)
    if places is not None and math.isfinite(number):
        number = round(number, places)
    return f"{number + 0.0:.6g}"
