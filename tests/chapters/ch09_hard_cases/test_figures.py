"""Pictures of the hard cases: a mark for every result, on the right side of the bound."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes

from lesson_code.chapters.ch09_hard_cases import figures as case_plots
from lesson_code.evidence.hard_cases import Comparison, Result, family_by_name
from lesson_code.view.matplotlib import style

NAMES = ("zeno", "rebounds")

BOUND = family_by_name("zeno").bound
"""Of both."""

WORST = {
    "ours": (0.0, BOUND / 10),
    "pymunk": (BOUND * 1e3, math.nan),
    "box2d": (math.inf, BOUND * 100),
}
HELD = {"ours": 4, "pymunk": 1, "box2d": 2}
"""Of 4 draws."""


def measured() -> Comparison:
    """Return a comparison of three engines in two families."""
    return Comparison(
        tuple(
            Result(name, engine, 4, HELD[engine], values[n], 0)
            for n, name in enumerate(NAMES)
            for engine, values in WORST.items()
        )
    )


def marks(draw: Callable[[Axes, Comparison], Axes], engine: str) -> Any:
    """Return where an engine's marks stand, shape (K, 2)."""
    _, ax = style.figure()
    draw(ax, measured())
    label = case_plots.MARKS[engine][2]
    (found,) = [line for line in ax.lines if line.get_label() == label]
    return np.asarray(found.get_xydata())


def test_held_is_left_of_the_line_and_over_is_right_of_it() -> None:
    """A tenth of the bound is one power of ten under it; zero is at the left edge."""
    assert family_by_name("rebounds").bound == BOUND
    found = marks(case_plots.over_the_bounds, "ours")
    np.testing.assert_allclose(found, [(case_plots.LEFT, 0), (-1, 1)])
    found = marks(case_plots.over_the_bounds, "box2d")
    np.testing.assert_allclose(found, [(case_plots.RIGHT, 0), (2, 1)])


def test_no_result_is_no_mark() -> None:
    """What came to no end is not drawn as if it were zero."""
    np.testing.assert_allclose(marks(case_plots.over_the_bounds, "pymunk"), [(3, 0)])


@pytest.mark.parametrize("engine", WORST)
def test_share_is_drawn_in_percent(engine: str) -> None:
    """Equal shares stand a little apart, so that no mark hides another."""
    found = marks(case_plots.shares_held, engine)
    np.testing.assert_allclose(found[:, 0], 100 * HELD[engine] / 4, atol=3)
    np.testing.assert_allclose(found[:, 1], [0, 1])


def test_engine_that_took_no_part_has_no_marks() -> None:
    """Nor does it stand in the legend."""
    _, ax = style.figure()
    case_plots.over_the_bounds(ax, measured())
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["Box2D", "pymunk", "ours"]


def test_themes_are_named_beside_the_rows() -> None:
    """Each once."""
    _, ax = style.figure()
    case_plots.shares_held(ax, measured())
    assert [text.get_text() for text in ax.texts] == ["Bounces"]


@pytest.mark.parametrize(
    ("value", "power"), [(1.0, 0.0), (1e-3, -3.0), (1e99, case_plots.RIGHT), (math.inf, 14.0)]
)
def test_powers_of_ten_stay_in_the_picture(value: float, power: float) -> None:
    """A thousandth is -3; what is too large for the picture stands at its edge."""
    assert case_plots.powers_of_ten(value, 1.0) == pytest.approx(power)
