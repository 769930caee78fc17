"""The figure of what effects cost: every time stands where the numbers say."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lesson_code.chapters.ch10_only_what_the_scene_needs import figures as effect_plots
from lesson_code.evidence.effect_costs import EffectCost, EffectCosts, stored
from lesson_code.view.matplotlib import style

READABLE: Any = Callable[[Figure], None]

ROWS = (
    EffectCost("friction", "compiled", "", 5e-6, left_out=2e-6, forced=4e-6, calls_needed=1.0),
    EffectCost("sleeping", "compiled", "", 1e-6, 9e-6, 3e-6, 3e-6, calls_needed=1.0),
    EffectCost("all effects", "compiled", "a gas", left_out=2e-6, forced=3e-6),
    EffectCost("friction", "pymunk", "", 8e-6, left_out=7e-6),
)

RESULT = EffectCosts(repeats=7, machine={}, billiards=None, costs=ROWS)


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


def drawn(ax: Axes, name: str) -> list[tuple[float, float]]:
    """Return where the marks of one kind of time stand."""
    label = effect_plots.LOOKS[name]["label"]
    (line,) = (line for line in ax.lines if line.get_label() == label)
    points: Any = line.get_xydata()
    return [(round(float(x), 9), float(y)) for x, y in points]


def test_every_time_of_a_row_is_drawn_in_microseconds(ax: Axes) -> None:
    """What is not known is not drawn."""
    effect_plots.what_effects_cost(ax, RESULT, "compiled")
    assert drawn(ax, "needed") == [(5.0, 0.0), (1.0, 1.0)]
    assert drawn(ax, "switched_off") == [(9.0, 1.0)]
    assert drawn(ax, "left_out") == [(2.0, 0.0), (3.0, 1.0), (2.0, 2.0)]
    assert drawn(ax, "forced") == [(4.0, 0.0), (3.0, 1.0), (3.0, 2.0)]
    names = [text.get_text() for text in ax.get_yticklabels()]
    assert names == ["friction", "sleeping", "all: a gas"]
    assert ax.get_xlabel() == "time of a step, \u00b5s"


def test_first_stage_stands_on_top(ax: Axes) -> None:
    """As in the table."""
    effect_plots.what_effects_cost(ax, RESULT, "compiled")
    bottom, top = ax.get_ylim()
    assert bottom > top


def test_code_that_was_not_measured_is_refused(ax: Axes) -> None:
    """With those that were."""
    with pytest.raises(ValueError, match="code must be one of compiled, pymunk"):
        effect_plots.what_effects_cost(ax, RESULT, "plain Python")


def test_figure_of_all_has_a_panel_for_each_code_that_was_measured() -> None:
    """In the order in which they are listed."""
    figure = effect_plots.all_effects(RESULT)
    assert [ax.get_title() for ax in figure.axes] == ["compiled", "pymunk"]


def test_figure_of_the_stored_result_is_readable(assert_texts_are_clear: READABLE) -> None:
    """No text is cut, and none lies on another."""
    assert_texts_are_clear(effect_plots.all_effects(stored()))
