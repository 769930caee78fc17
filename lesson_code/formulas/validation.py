"""The door of every formula: what an argument may be, and what is said when it is not.

A formula is written once, as arithmetic on plain numbers. :func:`formula` puts a checked door
in front of it: the public function refuses bad input with an error that names the argument, the
rule and the value, broadcasts over arrays, and then runs the very lines that are written below
the decorator. Code that has already checked its numbers calls :func:`equation` of the formula
and skips the door.
"""

from __future__ import annotations

import functools
import inspect
import math
import numbers
from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar, cast

import numpy as np

Number: TypeAlias = Any
"""An int, float, Fraction or array of floats: arithmetic is all a formula asks of it."""

Vector: TypeAlias = Any
"""Shape (..., 2) at the door; inside an equation the two components come first: (2, ...)."""

Rule: TypeAlias = Callable[[str, Any], Any]
"""Takes an argument's name and value; returns the value, or raises an error that names it."""

Relation: TypeAlias = Callable[[dict[str, Any]], None]
"""Takes all the arguments by name; raises an error when they do not fit each other."""

F = TypeVar("F", bound=Callable[..., Any])

UNIT_LENGTH_TOLERANCE = 1e-9
"""How far a normal's length may be from 1: far above rounding (1e-16), far below a mistake."""

FLATNESS = 1e-12
"""A polygon fills more than this part of the square around it, or its corners are on one line:
far above what rounding makes of a line (1e-16), far below any plate."""


def finite(name: str, value: Any) -> Any:
    """Return `value`, a real number or an array of them, none of them nan or infinite."""
    return _require(name, value, lambda x: abs(x) < math.inf, "finite")


def mass(name: str, value: Any) -> Any:
    """Return `value`, a mass in kg: greater than zero; ``math.inf`` means immovable."""
    return _require(name, value, lambda m: m > 0, "> 0 kg")


def moment_of_inertia(name: str, value: Any) -> Any:
    """Return `value`, in kg m^2: greater than zero; ``math.inf`` means it never turns."""
    return _require(name, value, lambda i: i > 0, "> 0 kg m^2")


def positive(name: str, value: Any) -> Any:
    """Return `value`: greater than zero and finite."""
    return _require(name, value, lambda x: (x > 0) & (x < math.inf), "> 0 and finite")


def non_negative(name: str, value: Any) -> Any:
    """Return `value`: zero or greater, and finite."""
    return _require(name, value, lambda x: (x >= 0) & (x < math.inf), ">= 0 and finite")


def unit_interval(name: str, value: Any) -> Any:
    """Return `value`: between 0 and 1, both included."""
    return _require(name, value, lambda x: (x >= 0) & (x <= 1), "between 0 and 1")


def vector(name: str, value: Any) -> Any:
    """Return `value` as a float array of shape (..., 2), every component finite."""
    array = np.asarray(finite(name, value), dtype=float)
    if array.ndim == 0 or array.shape[-1] != 2:
        raise ValueError(f"{name} must have shape (..., 2), got shape {array.shape}")
    return array


def one_vector(name: str, value: Any) -> Any:
    """Return `value` as a float array of shape (2,), or raise a ValueError that names it.

    >>> one_vector("point", (1, 2))
    array([1., 2.])
    """
    array = vector(name, value)
    if array.shape != (2,):
        raise ValueError(f"{name} must have shape (2,), got shape {array.shape}")
    return array


def one_number(name: str, value: Any, rule: Rule = finite) -> float:
    """Return `value` as a float that satisfies `rule`, or raise an error that names it.

    >>> one_number("dt", 2, positive)
    2.0
    """
    checked = rule(name, value)
    if type(checked) is float:
        return checked
    if np.ndim(checked):
        raise ValueError(f"{name} must be one number, got shape {np.shape(checked)}")
    return float(checked)


def unit_vector(name: str, value: Any) -> Any:
    """Return `value` as a float array of shape (..., 2), every vector of length 1."""
    array = vector(name, value)
    lengths = np.hypot(array[..., 0], array[..., 1])
    _require(
        name,
        lengths,
        lambda length: np.abs(length - 1) <= UNIT_LENGTH_TOLERANCE,
        f"a unit vector (length 1 within {UNIT_LENGTH_TOLERANCE:g})",
        got="length ",
    )
    return array


def polygon_vertices(name: str, value: Any) -> Any:
    """Return `value` as a float array of shape (N, 2), N >= 3: corners that enclose an area.

    >>> polygon_vertices("vertices", [(0, 0), (2, 0), (0, 1)]).shape
    (3, 2)
    """
    array = np.asarray(finite(name, value), dtype=float)
    if array.ndim != 2 or array.shape[0] < 3 or array.shape[1] != 2:
        raise ValueError(f"{name} must have shape (N, 2), N >= 3, got shape {array.shape}")
    x, y = (array - array[0]).T
    area = abs(np.dot(x[:-1], y[1:]) - np.dot(y[:-1], x[1:])) / 2
    square = max(x.max() - x.min(), y.max() - y.min()) ** 2
    if not area > FLATNESS * square:
        raise ValueError(f"{name} must have an area > 0 m^2, not lie on a line, got {area:g}")
    return array


def not_both_immovable(values: dict[str, Any]) -> None:
    """Refuse m1 and m2 both infinite: of two immovable bodies neither can yield."""
    if np.any(np.isinf(_as_float(values["m1"])) & np.isinf(_as_float(values["m2"]))):
        raise ValueError("m1 and m2 must not both be infinite: one of them has to yield, got inf")


VECTOR_RULES = (vector, unit_vector)


def formula(
    *, returns_vector: bool = False, together: Relation | None = None, **rules: Rule
) -> Callable[[F], F]:
    """Put a checked door in front of an equation.

    Parameters
    ----------
    returns_vector : bool
        Whether the equation returns vectors, components first.
    together : Relation, optional
        A rule that several arguments must satisfy together.
    **rules : Rule
        For each argument of the equation the rule it must satisfy.

    Returns
    -------
    callable
        A decorator. The decorated function takes numbers or arrays that broadcast together;
        vectors have shape (..., 2), and a polygon's corners come as a list. :func:`equation` gives
        back what was decorated, and ``rules`` stay beside it.
    """

    def decorate(written: F) -> F:
        signature = inspect.signature(written)
        if set(signature.parameters) != set(rules):
            raise TypeError(f"{written.__name__}: every argument needs one rule")
        vectors = {name for name, rule in rules.items() if rule in VECTOR_RULES}
        polygons = {name for name, rule in rules.items() if rule is polygon_vertices}

        # Overflow has a right answer here: m2/m1 may be inf, and 1 / (1 + inf) is then 0.
        @functools.wraps(written)
        @np.errstate(over="ignore")
        def checked(*args: Any, **kwargs: Any) -> Any:
            bound = signature.bind(*args, **kwargs)
            bound.apply_defaults()
            values = {name: rules[name](name, value) for name, value in bound.arguments.items()}
            corners = {name: values.pop(name).tolist() for name in polygons}
            batch = _common_shape(values, vectors)
            if together is not None:
                together(values)
            if batch or vectors:  # beside arrays a Fraction cannot stay exact
                values = {name: _as_float(value) for name, value in values.items()}
            for name in vectors:
                values[name] = np.moveaxis(np.broadcast_to(values[name], (*batch, 2)), -1, 0)
            result = written(**values, **corners)
            return np.moveaxis(result, 0, -1) if returns_vector else result

        checked.rules = rules  # type: ignore[attr-defined]
        return cast(F, checked)

    return decorate


def equation(checked: F) -> F:
    """Return the equation behind a formula's door: the same lines, no checks."""
    return cast(F, inspect.unwrap(checked))


def _common_shape(values: dict[str, Any], vectors: set[str]) -> tuple[int, ...]:
    """Return the shape all arguments broadcast to, the component axis of vectors left out."""
    shapes = {
        name: np.shape(value)[:-1] if name in vectors else np.shape(value)
        for name, value in values.items()
    }
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        listed = ", ".join(f"{name} {shape}" for name, shape in shapes.items())
        raise ValueError(f"arguments must have shapes that broadcast, got {listed}") from None


def _require(
    name: str, value: Any, holds: Callable[[Any], Any], rule: str, *, got: str = ""
) -> Any:
    """Return `value` if `holds` is true of every number in it, else raise a ValueError.

    No rule holds for nan. A float, which most values are, is looked at first: a scene of 10,000
    bodies asks 80,000 times.
    """
    if type(value) is float and holds(value):
        return value
    if isinstance(value, np.generic):
        value = value.item()  # it would keep its width: np.uint8(1) - np.uint8(3) is 254
    if isinstance(value, numbers.Real):
        try:
            number = float(value)
        except OverflowError:
            raise _too_large(name) from None
        if math.isnan(number) or not holds(number):
            raise ValueError(f"{name} must be {rule}, got {got}{value}")
        return value
    array = _real_array(name, value)
    wrong = np.isnan(array) | ~holds(array)
    if wrong.any():
        index = tuple(int(i) for i in np.argwhere(wrong)[0])
        place = f" at index {index}" if index else ""
        raise ValueError(f"{name} must be {rule}, got {got}{array[index]}{place}")
    return array


def _real_array(name: str, value: Any) -> Any:
    """Return `value` as an array of floats, or raise an error that names the argument."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name} must be a regular array, got rows of unequal length") from None
    if array.dtype.kind not in "biufO" or (array.dtype == object and not _all_real(array)):
        raise TypeError(f"{name} must be a real number or an array of them, got {value!r}")
    try:
        return array.astype(float)
    except OverflowError:
        raise _too_large(name) from None


def _too_large(name: str) -> ValueError:
    """Return the error for an exact number that no float can hold."""
    return ValueError(f"{name} must be finite, got a number over 1e308")


def _as_float(value: Any) -> Any:
    """Return numbers that may be Fractions as floats, which NumPy can look into."""
    return np.asarray(value, dtype=float)


def _all_real(array: Any) -> bool:
    """Return whether an array of objects holds only real numbers (Fractions, say)."""
    return all(isinstance(item, numbers.Real) for item in array.flat)
