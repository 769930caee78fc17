"""In words, how an answer differs from what was expected."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code.course.grading.difference import of_form, of_numbers


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
            "Two values were asked for: one row, and yours is a column. Shape it by .ravel().",
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
