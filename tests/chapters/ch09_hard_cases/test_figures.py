"""Pictures of the hard cases: a mark for every result, on the right side of the bound."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch09_hard_cases import figures as case_plots
from lesson_code.evidence.hard_cases import Comparison, Outcome
from lesson_code.view.matplotlib import style

VALUES = {"ours": (0.0, 1e-13), "pymunk": (0.5, math.nan), "box2d": (math.inf, 1e-10)}
"""For two cases whose bound is 1e-12."""


def measured() -> Comparison:
    """Return a comparison of three solvers in two cases."""
    return Comparison(
        tuple(
            Outcome(case, solver, values[n], 1e-12)
            for n, case in enumerate(("kane", "rebound"))
            for solver, values in VALUES.items()
        )
    )


def marks(solver: str) -> Any:
    """Return where a solver's marks stand, shape (K, 2)."""
    _, ax = style.figure()
    case_plots.over_the_bounds(ax, measured())
    label = case_plots.MARKS[solver][2]
    (found,) = [line for line in ax.lines if line.get_label() == label]
    return np.asarray(found.get_xydata())


def test_held_is_left_of_the_line_and_over_is_right_of_it() -> None:
    """A tenth of the bound is one power of ten under it; zero is at the left edge."""
    np.testing.assert_allclose(marks("ours"), [(case_plots.LEFT, 0), (-1, 1)])
    np.testing.assert_allclose(marks("box2d"), [(case_plots.RIGHT, 0), (2, 1)])


def test_no_result_is_no_mark() -> None:
    """What came to no end is not drawn as if it were zero."""
    np.testing.assert_allclose(marks("pymunk"), [(math.log10(0.5e12), 0)])


def test_solver_that_took_no_part_has_no_marks() -> None:
    """Nor does it stand in the legend."""
    _, ax = style.figure()
    case_plots.over_the_bounds(ax, measured())
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["Box2D", "pymunk", "ours"]


@pytest.mark.parametrize(("excess", "power"), [(1.0, 0.0), (1e-3, -3.0), (1e99, case_plots.RIGHT)])
def test_powers_of_ten_stay_in_the_picture(excess: float, power: float) -> None:
    """A thousandth is -3; what is too large for the picture stands at its edge."""
    assert case_plots.powers_of_ten(excess) == pytest.approx(power)
