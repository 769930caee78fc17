"""Machine code at work: what it is called with, what it returns, what it refuses."""

from __future__ import annotations

import math

import numpy as np
import pytest
from small_program import SOURCE, Numbers, numbers, small_program

from lesson_code.engine.compiled import program_of
from lesson_code.engine.compiled.compiler import compiled

pytest.importorskip("numba")


def test_entry_changes_its_tables_and_returns_a_number() -> None:
    """Records and rows of tables, in place."""
    tables = numbers(4.0, 2.0)
    assert compiled(small_program())(tables) == 3.0
    assert (tables.total.half, tables.total.count) == (3.0, 2)


def test_entry_takes_the_tables_that_it_is_given_each_time() -> None:
    """Tables move when they grow."""
    entry = compiled(small_program())
    first, longer = numbers(4.0), numbers(4.0, 2.0)
    assert [entry(tables) for tables in (first, longer, first)] == [2.0, 3.0, 4.0]


def test_entry_takes_a_table_without_rows() -> None:
    """There is nothing to add up."""
    assert compiled(small_program())(numbers()) == 0.0


def test_division_by_zero_is_what_numpy_makes_of_it() -> None:
    """No exception: a compiled program has none, and plain code never divides by 0."""
    source = SOURCE.replace("SHARE * x", "SHARE / x")
    assert compiled(small_program(source))(numbers(0.0)) == math.inf


def test_entry_that_returns_nothing_returns_zero() -> None:
    """Such as a stage of the engine."""
    source = SOURCE.replace("Numbers) -> float", "Numbers) -> None").replace(
        "return total.half", ""
    )
    tables = numbers(4.0)
    assert compiled(small_program(source))(tables) == 0.0
    assert tables.total.half == 2.0


def test_tables_of_another_layout_are_refused() -> None:
    """Machine code would write anywhere."""
    other = numbers(4.0)._replace(items=np.zeros(1, [("other", float)]))
    with pytest.raises(TypeError, match=r"items must have records of .*value.*, got .*other"):
        compiled(small_program())(other)


def test_program_that_numba_does_not_take_says_why() -> None:
    """The error is that of the other process."""
    source = SOURCE.replace("SHARE * x", "open(x)")
    with pytest.raises(RuntimeError, match=r"(?s)cannot be compiled here.*open"):
        compiled(program_of(source, "entry", Numbers))
