"""What runs in a page's Python, run here: cells, and the check of one task."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

from lesson_code.course.site.in_page import NotHere, checked

SWAPS = "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n"


def said_to(*sources: str) -> Any:
    """Return what is said to the last of some cells, as an answer to task 1.1."""
    cells = [[f"your cell {number}", source] for number, source in enumerate(sources, start=2)]
    return json.loads(checked(json.dumps(cells), "1.1", "elastic_1d"))


def test_marks_are_those_of_a_check_cell() -> None:
    """Points, reason and hint; nothing is printed."""
    said = said_to(SWAPS)
    assert said["lines"][0] == "1.1 elastic_1d: 1/4 points"
    assert any("Only equal masses exchange velocities." in line for line in said["lines"])
    assert said["printed"] == ""


def test_cells_before_are_run_and_only_the_last_one_is_heard() -> None:
    """A helper of an earlier cell can be called; what that cell prints is not shown."""
    helper = "def swapped(a, b):\n    return b, a\nprint('before')"
    answer = "def elastic_1d(m1, v1, m2, v2):\n    return swapped(v1, v2)\nprint('after')\n1 + 1"
    said = said_to(helper, answer)
    assert said["lines"][0] == "1.1 elastic_1d: 1/4 points"
    assert said["printed"] == "after\n2\n"


@pytest.mark.parametrize(
    "fault", ["1 / 0", "def elastic_1d(", "raise SystemExit", "import nowhere"]
)
def test_cell_that_fails_says_where(fault: str) -> None:
    """The reader's own lines and none of ours; the answer before it is checked all the same."""
    said = said_to(SWAPS, fault)
    assert said["printed"].rstrip().splitlines()[-1]
    assert "in_page" not in said["printed"]
    assert said["lines"][0] == "1.1 elastic_1d: 1/4 points"


def test_missing_function_is_named() -> None:
    """In the words of the grader."""
    assert said_to("x = 1")["lines"] == ["1.1 elastic_1d: there is no function named elastic_1d"]


def test_numpy_is_missed_where_it_is_used() -> None:
    """Its import passes, as exercises begin with it; Python's own questions have their answer."""
    numpy = NotHere("numpy")
    assert not hasattr(numpy, "__path__")
    with pytest.raises(ImportError, match="NumPy is not in this page"):
        numpy.array([1.0])
    assert np.array([1.0])  # and the real one is untouched
