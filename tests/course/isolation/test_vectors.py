"""Vectors without NumPy: the sums of NumPy's arrays, number for number."""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.isolation.inside import vectors
from lesson_code.course.isolation.inside.answers import arguments_from, plain
from lesson_code.course.isolation.inside.vectors import Vector

NUMBERS = st.floats(-1e6, 1e6).filter(lambda number: abs(number) > 1e-6)
PAIRS = st.tuples(NUMBERS, NUMBERS)
SUMS = [operator.add, operator.sub, operator.mul, operator.truediv]


@pytest.mark.parametrize("do", SUMS)
@given(a=PAIRS, b=PAIRS, number=NUMBERS)
def test_sums_of_vectors_and_numbers_are_those_of_numpy(
    do: Callable[[Any, Any], Any], a: tuple[float, float], b: tuple[float, float], number: float
) -> None:
    """Two vectors, a vector and a number either way, a vector and a tuple either way."""
    v, w = Vector(a), Vector(b)
    x, y = np.array(a), np.array(b)
    for ours, theirs in (
        (do(v, w), do(x, y)),
        (do(v, number), do(x, number)),
        (do(number, v), do(number, x)),
        (do(v, b), do(x, b)),
        (do(b, v), do(b, x)),
    ):
        assert isinstance(ours, Vector)
        assert ours == tuple(theirs.tolist())


@given(a=PAIRS, b=PAIRS)
def test_products_signs_and_powers_are_those_of_numpy(
    a: tuple[float, float], b: tuple[float, float]
) -> None:
    """The dot product of two vectors, of one and a tuple; minus, absolute value, square."""
    v, x = Vector(a), np.array(a)
    for other in (Vector(b), b):
        assert v @ other == pytest.approx(float(x @ np.array(b)), rel=1e-12, abs=1e-3)
    assert b @ v == v @ b
    assert (-v, abs(v), v**2) == tuple(tuple(each.tolist()) for each in (-x, abs(x), x**2))


def test_rows_are_vectors_of_vectors(monkeypatch: pytest.MonkeyPatch) -> None:
    """Vertices, as a task gives them, are moved by one vector only if that is said row by row."""
    monkeypatch.setattr(vectors, "np", None)
    [rows] = arguments_from([((1.0, 2.0), (3.0, 4.0))])
    assert (rows[1] - rows[0]).tolist() == [2.0, 2.0]
    assert plain(2 * rows) == [[2.0, 4.0], [6.0, 8.0]]


def test_lengths_that_differ_are_an_error() -> None:
    """As they are in NumPy."""
    with pytest.raises(ValueError, match="zip"):
        operator.add(Vector((1.0, 2.0)), (1.0, 2.0, 3.0))


def test_what_only_numpy_has_is_named() -> None:
    """The message says what is missing, and why."""
    with pytest.raises(AttributeError, match="no sum where NumPy is missing"):
        Vector((1.0, 2.0)).sum()


def test_without_numpy_places_are_found_all_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    """In the order of the numbers, with NumPy and without."""
    for np_here in (np, None):
        monkeypatch.setattr(vectors, "np", np_here)
        found = vectors.numbers(iter([1.0, float("nan"), 1.4, 2.0]), 4)
        assert [int(place) for place in vectors.places_near(found, 1.2, 0.25)] == [0, 2]
