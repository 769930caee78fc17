"""The figures of chapter 08: points stand where the numbers say, and failures are drawn."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lesson_code.chapters.ch08_what_accuracy_costs import figures as precision_plots
from lesson_code.evidence.work_precision import Point, WorkPrecision, fit_order
from lesson_code.evidence.work_precision.methods import METHODS
from lesson_code.view.matplotlib import style

READABLE: Any = Callable[[Figure], None]

BALL, PILE = "ball in a box", "stack of 20"


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure(width=9, height=3.6)[1]  # type: ignore[no-any-return]


def line(method: str = "pymunk", code: str = "C") -> list[Point]:
    """Return five points of the first order: 1 m and 1 ms at a tenth of a second."""
    steps = [0.1 / 2**n for n in range(5)]
    return [Point(BALL, method, code, dt, 10, 1, 10 * dt, 1e-4 / dt, 50) for dt in steps]


def result_of(*points: Point) -> WorkPrecision:
    """Return a made-up result."""
    return WorkPrecision(repeats=7, machine={}, points=points)


def drawn(ax: Axes, marker: str) -> list[tuple[float, float]]:
    """Return what is drawn with a marker."""
    lines = [drawn for drawn in ax.lines if drawn.get_marker() == marker]
    return [
        (float(x), float(y))
        for one in lines
        for x, y in zip(*map(list, one.get_data()), strict=True)  # type: ignore[arg-type]
    ]


def test_points_stand_at_their_time_and_error(ax: Axes) -> None:
    """Milliseconds to the right, metres upwards, both in powers of ten."""
    precision_plots.work_precision(ax, result_of(*line()), BALL)
    marks = drawn(ax, precision_plots.LOOKS["pymunk"][1])
    assert [x for x, _ in marks] == pytest.approx([p.milliseconds for p in line()])
    assert [y for _, y in marks] == pytest.approx([p.error for p in line()])
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log")


def test_fitted_order_is_drawn(ax: Axes) -> None:
    """A dotted line through the points of an exact power."""
    precision_plots.work_precision(ax, result_of(*line()), BALL)
    (fit,) = [one for one in ax.lines if one.get_linestyle() == ":"]
    assert list(fit.get_ydata()) == pytest.approx([p.error for p in line()])  # type: ignore[arg-type]


def test_failures_are_crosses_at_the_upper_edge(ax: Axes) -> None:
    """One at its time, and one that was never run at the left end."""
    fell = replace(line()[0], failure="lost", error=9.0)
    refused = Point(BALL, "naive", "Python", 0.1, 1, 1, math.nan, failure="refused")
    precision_plots.work_precision(ax, result_of(fell, refused, *line()[1:]), BALL)
    crosses = drawn(ax, "x")
    assert crosses == [(pytest.approx(1.0), precision_plots.EDGE), (0.03, precision_plots.EDGE)]


def test_rounding_stands_at_the_lower_edge_with_its_figure(ax: Axes) -> None:
    """An error of 5e-15 m does not press all others into one line."""
    exact = Point(BALL, "exact", "Python", 0.0, 1, 1, 5e-15, 1e-3, 10)
    precision_plots.work_precision(ax, result_of(*line(), exact), BALL)
    assert drawn(ax, "D") == [(1.0, precision_plots.ROUNDING_AT)]
    assert any("5e-15 m" in text.get_text() for text in ax.texts)
    assert ax.get_ylim()[0] > 1e-6


def test_split_of_sweeps_keeps_who_fell(ax: Axes) -> None:
    """Points over their sub-steps, and a cross for the one without an answer."""
    points = [
        Point(PILE, "pymunk", "C", 1 / 60, 100 // n, n, error, 1.0, failure=failure)
        for n, error, failure in ((1, 9.0, "fell"), (10, 0.002, ""), (100, 0.006, ""))
    ]
    precision_plots.split_of_sweeps(ax, result_of(*points), PILE, 100)
    assert drawn(ax, "P") == [(10.0, 0.002), (100.0, 0.006)]
    assert drawn(ax, "x") == [(1.0, precision_plots.EDGE)]


def test_methods_that_fail_at_one_split_have_a_cross_each(ax: Axes) -> None:
    """None hides the one of another method."""
    points = [
        Point(PILE, method, "C", 1 / 60, 100 // n, n, error, 1.0, failure=failure)
        for method in ("pymunk", "sequential")
        for n, error, failure in ((1, 9.0, "fell"), (10, 0.002, ""))
    ]
    precision_plots.split_of_sweeps(ax, result_of(*points), PILE, 100)
    assert len(set(drawn(ax, "x"))) == 2


def test_errors_over_steps_have_their_fit(ax: Axes) -> None:
    """Markers for what was measured, a line for what was fitted."""
    steps, errors = [0.1, 0.05, 0.025], [1.0, 0.5, 0.25]
    fits = {"pymunk": fit_order(steps, errors)}
    precision_plots.errors_over_steps(ax, steps, {"pymunk": errors}, fits)
    measured, fitted = ax.lines
    assert list(measured.get_ydata()) == errors  # type: ignore[arg-type]
    assert list(fitted.get_ydata()) == pytest.approx(errors)  # type: ignore[arg-type]


def test_every_method_has_a_look_of_its_own() -> None:
    """Two cues: neither a colour nor a marker is used twice."""
    assert set(precision_plots.LOOKS) == set(METHODS)
    for cue in zip(*precision_plots.LOOKS.values(), strict=True):
        assert len(set(cue)) == len(METHODS)


def test_figure_of_all_scenes_can_be_read(assert_texts_are_clear: READABLE) -> None:
    """A panel for each scene, the legend in the place after the last; nothing overlaps."""
    exact = Point(BALL, "exact", "Python", 0.0, 1, 1, 5e-15, 1e-3, 10)
    direct = Point(BALL, "direct", "Python", 0.1, 1, 1, 4e-16, 1.1e-3, 10)
    pile = [replace(p, scene="stack of 20") for p in line("sequential", "compiled")]
    figure = precision_plots.all_scenes(result_of(*line(), exact, direct, *pile))
    assert [ax.get_title() for ax in figure.axes] == [BALL, "stack of 20", "", ""]
    assert_texts_are_clear(figure)
