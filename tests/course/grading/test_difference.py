"""In words, how an answer differs from what was expected."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code.course.grading.difference import of_form, of_given, of_numbers


@pytest.mark.parametrize(
    ("got", "expected", "said"),
    [
        (None, 1.0, "One number was asked for; is a return missing?"),
        (None, [1.0, 2.0], "Two values were asked for; is a return missing?"),
        (None, True, "True or False was asked for; is a return missing?"),
        (None, None, ""),
        (2.0, None, "There is nothing to return here: None was asked for."),
        (2.0, [1.0, 2.0, 3.0], "Three values were asked for."),
        ([2.0], 1.0, "One number was asked for."),
        ([1.0], [1.0, 2.0], "Two values were asked for, and there is one."),
        ([], [1.0], "One value was asked for, and there are none."),
        ([1.0] * 12, [1.0] * 9, "9 values were asked for, and there are 12."),
        ([[1.0], 2.0], [1.0, 2.0], "There is a tuple where one number was asked for."),
        ([1.0, 2.0], [[1.0, 2.0], 2.0], "There is one value where two values were asked for."),
        ([[1.0, 2.0, 3.0]], [[1.0, 2.0]], "Two values were asked for, and there are three."),
        ([1.0, [2.0, 3.0]], [5.0, [6.0, 7.0]], ""),
        (
            [[1.0], [2.0]],
            [1.0, 2.0],
            "Two values were asked for: one row, and yours is a column. np.ravel(...) helps.",
        ),
    ],
)
def test_form_of_an_answer_is_said_where_it_differs(got: Any, expected: Any, said: str) -> None:
    """How many values there are and should be, and nothing where the form is right."""
    assert of_form(got, expected) == said


@pytest.mark.parametrize(
    ("got", "expected", "said"),
    [
        ([2.0, -1.0], [-2.0, 1.0], "That is minus what was expected."),
        (3.0, 1.5, "That is twice what was expected."),
        ([1.0, [0.5]], [2.0, [1.0]], "That is half of what was expected."),
        ([2.0, 1.0], [1.0, 2.0], "That is the right answer in another order."),
        (math.nan, 1.0, "nan is no number: it comes of 0/0, or of inf - inf."),
        ([math.inf, 1.0], [2.0, 1.0], "inf is beyond all numbers: something was divided by zero."),
        ([1.0, 5.0], [1.0, 2.0], ""),
        ([-0.6, 0.6], [0.6, -0.6], "That is minus what was expected."),
        ([0.6, 0.6], [0.6, -0.6], "The second is minus what was expected; all else is right."),
        (
            [[1.0, 2.0], 3.0],
            [[1.0, 2.0], 1.5],
            "The second is twice what was expected; all else is right.",
        ),
        (0.33, 0.3300123, "That is right to 4 digits. Is something rounded?"),
        (
            float(np.float32(1 / 3)),
            1 / 3,
            "That is right to the 7 digits of a float32. Use float64, which Python's float is.",
        ),
        (0.0, 1.0, ""),
        ([0.0, 0.0], [0.0, 1.0], ""),
        ("left", 1.0, ""),
        ([True, 1.0], [False, 1.0], ""),
    ],
)
def test_numbers_of_an_answer_are_compared_as_a_whole(got: Any, expected: Any, said: str) -> None:
    """A sign, a factor or an order is named only if it holds of the whole answer."""
    assert of_numbers(got, expected) == said


@pytest.mark.parametrize(
    ("got", "expected", "said"),
    [
        ([[0.0, 1.0], 3.83], [[1.0, 0.0], 3.83], ""),
        ([1.0, 0.0], [0.0, 1.0], ""),
        ([0.0, 0.0, 2.0], [2.0, 0.0, 0.0], "That is the right answer in another order."),
    ],
)
def test_normal_turned_by_a_right_angle_is_in_no_other_order(
    got: Any, expected: Any, said: str
) -> None:
    """0 and 1 stand in so many answers that where they stand tells nothing of an order."""
    assert of_numbers(got, expected) == said


def test_values_that_came_in_are_named() -> None:
    """Of what is returned as it came in the names are said, and of what may be another, nothing."""
    given = {"m1": 2.0, "v1": 3.0, "m2": 2.0, "v2": -1.5, "normal": [1.0, 0.0]}
    assert of_given([3.0, -1.5], [-1.5, 3.0], given) == "That is v1 and v2 as they came in."
    assert of_given(3.0, 1.0, given) == "That is v1 as it came in."
    for got in (2.0, [3.0, 2.0], [3.0, 3.0], [1.0, 0.0], [3.0, 5.0], [-1.5, 3.0], None, "v1"):
        assert of_given(got, [-1.5, 3.0], given) == ""


def test_part_whose_form_differs_is_said_to_be_which() -> None:
    """Of two lists that are exchanged, the first is named as the one that is too short."""
    said = "In the first: two values were asked for, and there are none."
    assert of_form([[], [1.0, 2.0]], [[1.0, 2.0], []]) == said
