"""Pictures of the hard cases: a mark for every theme, on the right side of the bound."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
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


def test_worst_family_of_a_theme_is_over_the_line() -> None:
    """Zero and a tenth of the bound: the tenth is worse. Infinity stands at the edge."""
    assert family_by_name("rebounds").bound == BOUND
    assert marks(case_plots.over_the_bounds, "ours")[:, 0].tolist() == pytest.approx([-1])
    assert marks(case_plots.over_the_bounds, "box2d")[:, 0].tolist() == [case_plots.RIGHT]


def test_family_without_a_result_is_left_out() -> None:
    """What came to no end is not drawn as if it were zero, nor does it hide the other family."""
    assert marks(case_plots.over_the_bounds, "pymunk")[:, 0].tolist() == pytest.approx([3])


@pytest.mark.parametrize("engine", WORST)
def test_share_of_a_theme_is_that_of_all_its_draws(engine: str) -> None:
    """Two families of 4 draws each: twice as many held, of 8."""
    (share,) = marks(case_plots.shares_held, engine)[:, 0]
    assert share == 100 * 2 * HELD[engine] / 8


def test_equal_figures_stand_apart() -> None:
    """No mark hides another, and all are within their theme's row."""
    heights = [marks(case_plots.shares_held, engine)[0, 1] for engine in WORST]
    assert np.diff(sorted(heights)).min() >= case_plots.APART - 1e-12
    assert np.abs(heights).max() < 0.5


def test_engine_that_took_no_part_has_no_marks() -> None:
    """Nor does it stand in the legend."""
    _, ax = style.figure()
    case_plots.over_the_bounds(ax, measured())
    legend = ax.get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["Box2D", "pymunk", "ours"]


def test_themes_name_the_rows_in_readable_letters() -> None:
    """Each once, with the number of its families, as large as the numbers at the axis or larger."""
    _, ax = style.figure()
    case_plots.shares_held(ax, measured())
    (row,), numbers = ax.get_yticklabels(), ax.get_xticklabels()
    assert row.get_text() == "Bounces (2)"
    assert row.get_fontsize() >= numbers[0].get_fontsize()


def test_least_held_is_the_family_with_the_fewest_held_draws() -> None:
    """One family of each theme, with all engines; of equal ones the first."""
    assert case_plots.least_held(measured()).names == NAMES[:1]
    worse = [replace(r, held=0) if r.family == NAMES[1] else r for r in measured().results]
    found = case_plots.least_held(Comparison(tuple(worse)))
    assert found.results == tuple(r for r in worse if r.family == NAMES[1])


@pytest.mark.parametrize(
    ("value", "power"), [(1.0, 0.0), (1e-3, -3.0), (1e99, case_plots.RIGHT), (math.inf, 14.0)]
)
def test_powers_of_ten_stay_in_the_picture(value: float, power: float) -> None:
    """A thousandth is -3; what is too large for the picture stands at its edge."""
    assert case_plots.powers_of_ten(value, 1.0) == pytest.approx(power)
