"""Agreement of answers: tolerance, shape, kind."""

from __future__ import annotations

import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.grading.compare import LONGEST_VALUE, agrees, told_apart, written
from lesson_code.course.grading.task import ANSWER_TOLERANCE

FINITE = st.floats(allow_nan=False, allow_infinity=False, width=32)
PLAIN = st.recursive(
    st.none() | st.booleans() | st.text(max_size=3) | FINITE, lambda x: st.lists(x, max_size=3)
)


@given(PLAIN)
def test_agrees_any_plain_value_with_itself(value: Any) -> None:
    """Whatever plain value is expected, that value is right."""
    assert agrees(value, value)


@given(FINITE)
def test_agrees_tolerance_is_relative_above_one_and_absolute_below(expected: float) -> None:
    """Half the tolerance away is right, twice the tolerance is not."""
    scale = ANSWER_TOLERANCE * max(1.0, abs(expected))
    assert agrees(expected + 0.5 * scale, expected)
    assert not agrees(expected + 2 * scale, expected)


@pytest.mark.parametrize("got", [math.nan, [math.nan], None, "1.0", True, [1.0], [], {}, math.inf])
def test_agrees_nothing_but_a_number_with_a_number(got: Any) -> None:
    """Nan, None, text, a truth value or a list is never right where 1.0 is expected."""
    assert not agrees(got, 1.0)


@pytest.mark.parametrize("expected", [0.0, math.nan, [math.nan], math.inf, None])
def test_agrees_nan_with_nothing(expected: Any) -> None:
    """Nan agrees with no number, and not with itself."""
    assert not agrees(math.nan, expected)


@pytest.mark.parametrize(
    ("got", "expected"),
    [
        (0.0, None),
        (False, None),
        ([], None),
        (1, True),
        (1.0, True),
        (None, False),
        ("Left", "left"),
        ("", None),
        (["l", "e"], "le"),
        (None, []),
        ("ab", ["a", "b"]),
        ({"a": 1}, [1]),
    ],
)
def test_agrees_kinds_are_not_mixed(got: Any, expected: Any) -> None:
    """None, truth values, text and lists agree only with their own kind."""
    assert not agrees(got, expected)


@pytest.mark.parametrize(
    "got", [[1.0], [1.0, 2.0, 3.0], [[1.0, 2.0]], [[1.0], [2.0]], [1.0, [2.0]], [1.0, None], []]
)
def test_agrees_other_shape_is_wrong(got: Any) -> None:
    """A pair of numbers is right only as a pair of numbers."""
    assert not agrees(got, [1.0, 2.0])


def test_agrees_integer_with_float() -> None:
    """An integer is as good as the float of the same value."""
    assert agrees([3, [4]], [3.0, [4.0]])


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.0, "1"),
        (1 / 3, "0.333333"),
        (-0.5, "-0.5"),
        (1e-12, "1e-12"),
        (math.nan, "nan"),
        (7, "7"),
        (None, "None"),
        ("left", "'left'"),
        ("a\n\x1b[2J\ud800", "'a\\n\\x1b[2J\\ud800'"),
        ((1.0, (2.0,)), "(1, (2,))"),
        ([], "()"),
    ],
)
def test_written_shows_six_digits_and_escapes_text(value: Any, text: str) -> None:
    """A message shows six digits, round brackets, and no raw control character."""
    assert written(value) == text


def test_told_apart_shows_the_digit_that_differs() -> None:
    """An answer that is wrong in the ninth digit does not look like the right one."""
    assert told_apart(1.00000001, 1.0) == ("1.00000001", "1")
    assert told_apart(1.0 + 1e-13, 1.0) == ("1.0000000000001", "1.0")


def test_told_apart_shortens_a_long_answer() -> None:
    """An answer of a thousand numbers does not fill the report."""
    shown, _ = told_apart([0.125] * 1000, 1.0)
    assert len(shown) == LONGEST_VALUE + 3
    assert shown.endswith("...")
