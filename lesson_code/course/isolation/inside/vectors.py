"""Vectors of numbers: NumPy's arrays; in a page, where there is no NumPy, a class with their sums.

Whatever marks answers works on numbers and plain lists. Only these few lines know NumPy.
"""

from __future__ import annotations

import contextlib
import operator
from collections.abc import Callable, Iterable, Sequence
from importlib import import_module
from typing import Any

try:
    np: Any = import_module("numpy")
except ModuleNotFoundError:  # Python in a page comes without packages
    np = None


class Vector(tuple[Any, ...]):
    """Numbers, or vectors, that are added and multiplied one by one, as NumPy does.

    >>> v = Vector((3.0, 4.0))
    >>> 2 * v - (1, 1), v @ v
    (Vector(5.0, 7.0), 25.0)

    Rows of them, too.

    >>> rows = Vector((Vector((3.0, 4.0)), Vector((1.0, 0.0))))
    >>> rows - (1, 1), rows @ v
    (Vector(Vector(2.0, 3.0), Vector(0.0, -1.0)), Vector(25.0, 3.0))
    """

    __slots__ = ()

    def _each(self, other: Any, do: Callable[[Any, Any], Any]) -> Vector:
        if _has_rows(self) and isinstance(other, list | tuple) and not _has_rows(other):
            return Vector(row._each(other, do) for row in self)
        if _has_rows(other) and not _has_rows(self):
            return Vector(self._each(row, do) for row in other)
        if isinstance(other, list | tuple):
            return Vector(do(a, b) for a, b in zip(self, other, strict=True))
        return Vector(do(a, other) for a in self)

    def __add__(self, other: Any) -> Vector:
        return self._each(other, operator.add)

    def __sub__(self, other: Any) -> Vector:
        return self._each(other, operator.sub)

    def __mul__(self, other: Any) -> Vector:
        return self._each(other, operator.mul)

    def __truediv__(self, other: Any) -> Vector:
        return self._each(other, operator.truediv)

    def __pow__(self, other: Any) -> Vector:
        return self._each(other, operator.pow)

    def __rsub__(self, other: Any) -> Vector:
        return self._each(other, lambda a, b: b - a)

    def __rtruediv__(self, other: Any) -> Vector:
        return self._each(other, lambda a, b: b / a)

    __radd__, __rmul__ = __add__, __mul__

    def __matmul__(self, other: Any) -> Any:
        if _has_rows(self):
            return Vector(row @ other for row in self)
        return sum(a * b for a, b in zip(self, other, strict=True))

    def __rmatmul__(self, other: Any) -> Any:
        return self @ other

    def __neg__(self) -> Vector:
        return Vector(-a for a in self)

    def __abs__(self) -> Vector:
        return Vector(abs(a) for a in self)

    def __getattr__(self, name: str) -> Any:
        raise AttributeError(f"a vector has no {name} where NumPy is missing")

    def tolist(self) -> list[Any]:
        """Return the numbers as a list."""
        return [a.tolist() if isinstance(a, Vector) else a for a in self]

    def __repr__(self) -> str:
        return f"Vector({', '.join(map(repr, self))})"


def _has_rows(value: Any) -> bool:
    """Return whether a value is a list of vectors."""
    return isinstance(value, list | tuple) and bool(value) and isinstance(value[0], list | tuple)


def vector(values: Any) -> Any:
    """Return numbers, or rows of them, as a vector of their own."""
    if np is not None:
        return np.array(values, dtype=float)
    return Vector(map(vector, values)) if isinstance(values, list | tuple) else float(values)


def is_vector(value: Any) -> bool:
    """Return whether a value is what :func:`vector` makes of a list."""
    kind: type = Vector if np is None else np.ndarray
    return isinstance(value, kind)


def is_array_of_floats(value: Any) -> bool:
    """Return whether a value is NumPy's own array of floats: of no class made from it."""
    return np is not None and type(value) is np.ndarray and value.dtype == float


def is_matrix(value: Any) -> bool:
    """Return whether a value is NumPy's matrix, which has two dimensions whatever is cut of it."""
    return np is not None and isinstance(value, np.matrix)


def shape_of(value: Any) -> tuple[int, ...]:
    """Return how many values stand in each direction of a vector, or of rows; () of a number.

    >>> shape_of([(1.0, 2.0), (3.0, 4.0)]), shape_of(2.0)
    ((2, 2), ())
    """
    if np is not None:
        return tuple(np.shape(value))
    if not isinstance(value, list | tuple):
        return ()
    return (len(value), *(shape_of(value[0]) if value else ()))


def unwarned(**how: Any) -> contextlib.AbstractContextManager[Any]:
    """Keep NumPy from warning of what sums end in; `how` says what to do of which instead."""
    return contextlib.nullcontext() if np is None else np.errstate(**(how or {"all": "ignore"}))


def numbers(values: Iterable[float], count: int) -> Sequence[float]:
    """Return a count of numbers so that :func:`places_near` finds some of them soon."""
    made: Sequence[float] = list(values) if np is None else np.fromiter(values, float, count)
    return made


def places_near(found: Sequence[float], number: float, reach: float) -> Iterable[int]:
    """Return at which places there is a number that is no further than a reach from another.

    >>> [int(place) for place in places_near(numbers([1.0, 2.0, 1.5], 3), 1.2, 0.5)]
    [0, 2]
    """
    if np is None:
        return [place for place, other in enumerate(found) if abs(other - number) <= reach]
    with unwarned():
        places: Iterable[int] = np.flatnonzero(np.abs(np.subtract(found, number)) <= reach)
    return places


def used_modules() -> list[Any]:
    """Return what of NumPy stands in this process."""
    return [] if np is None else [np]
