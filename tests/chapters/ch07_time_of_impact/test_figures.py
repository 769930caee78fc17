"""The figures of chapter 07: what is drawn stands where the numbers say, and can be read."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from lesson_code.chapters.ch07_time_of_impact import figures as impact_plots
from lesson_code.reference.closed_forms import ball_in_box
from lesson_code.reference.event_closed_forms import block_collisions
from lesson_code.view.matplotlib import style

READABLE: Any = Callable[[Figure], None]

ROUNDING = 1e-12
"""m: a few roundings of places of size 1 to 20."""


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure(width=9, height=2.6)[1]  # type: ignore[no-any-return]


def points(ax: Axes, marker: str) -> list[tuple[float, float]]:
    """Return what is drawn with a marker."""
    drawn = [np.array(line.get_data()).T for line in ax.lines if line.get_marker() == marker]
    return [(float(x), float(y)) for places in drawn for x, y in places]


# Two circles

GRAZE: tuple[Any, ...] = (np.array([-2.25, 0.8]), np.array([5.0, 0.0]), 1.0, 1.0, 10)
"""d, v, R, dt and samples: they touch at x = -0.6 and x = 0.6, at 0.33 s and 0.57 s."""


def test_seen_from_the_first_marks_both_touches_and_all_samples(ax: Axes) -> None:
    """3-4-5: at 0.8 m across, half a chord is 0.6 m."""
    impact_plots.seen_from_the_first(ax, *GRAZE)
    assert points(ax, "D") == [pytest.approx((-0.6, 0.8))]
    assert points(ax, "s") == [pytest.approx((0.6, 0.8))]
    assert [x for x, _ in points(ax, "o")] == pytest.approx(np.linspace(-2.25, 2.75, 11))


def test_distance_in_time_falls_and_rises_through_the_touches(ax: Axes) -> None:
    """At the touches it is R, at the samples what Pythagoras says."""
    impact_plots.distance_in_time(ax, *GRAZE)
    assert points(ax, "D") == [pytest.approx((0.33, 1.0))]
    assert points(ax, "s") == [pytest.approx((0.57, 1.0))]
    for t, distance in points(ax, "o"):
        assert distance == pytest.approx(math.hypot(-2.25 + 5 * t, 0.8))


def test_a_miss_has_no_touches(ax: Axes) -> None:
    """Circles that pass at more than R are drawn without marks."""
    d = np.array([-2.25, 1.2])
    impact_plots.seen_from_the_first(ax, d, *GRAZE[1:])
    assert points(ax, "D") == points(ax, "s") == []


def test_two_circles_can_be_read(assert_texts_are_clear: READABLE) -> None:
    """Both panels side by side, as the notebook has them."""
    figure, (left, right) = style.figure(2, width=10, height=3.2)
    impact_plots.seen_from_the_first(left, *GRAZE)
    impact_plots.distance_in_time(right, *GRAZE)
    assert_texts_are_clear(figure)


# unfolded


def test_unfolded_box_ends_where_the_closed_form_does(ax: Axes) -> None:
    """The folded way stays in the box, and ends at the place that fractions give."""
    start, velocity, room, time = (0.85, 0.65), (2.3, 1.1), (3.5, 2.5), 6.0
    impact_plots.unfolded_box(ax, start, velocity, room, time)
    straight, folded = (np.array(line.get_data()).T for line in ax.lines[:2])
    assert straight[-1] == pytest.approx([0.85 + 2.3 * 6, 0.65 + 1.1 * 6])
    assert (folded >= -ROUNDING).all()
    assert (folded <= np.array(room) + ROUNDING).all()
    ball = 0.25  # a radius: the closed form is about a ball, the figure about its centre
    there, _ = ball_in_box(np.add(start, ball), velocity, ball, 4.0, 3.0, time)
    assert folded[-1] == pytest.approx(there - ball, abs=ROUNDING)


def test_unfolded_box_has_an_image_for_each_room_on_the_way(ax: Axes) -> None:
    """The way crosses 4 walls to the right and 2 upwards: 5 by 3 rooms."""
    impact_plots.unfolded_box(ax, (0.85, 0.65), (2.3, 1.1), (3.5, 2.5), 6.0)
    assert len([p for p in ax.patches if isinstance(p, Rectangle)]) == 15


@pytest.mark.parametrize("ratio", [1.5, 4.5, 9.0, 20.0])
def test_unfolded_wedge_has_a_dot_for_each_collision(ax: Axes, ratio: float) -> None:
    """The line crosses as many rays as there are collisions, in order from right to left."""
    impact_plots.unfolded_wedge(ax, ratio)
    crossings = points(ax, "o")
    assert len(crossings) == block_collisions(ratio)
    assert [x for x, _ in crossings] == sorted((x for x, _ in crossings), reverse=True)
    theta = math.atan(1 / math.sqrt(ratio))
    for k, (x, y) in enumerate(crossings, start=1):
        assert math.atan2(y, x) == pytest.approx(k * theta)


def test_unfolded_wedge_can_be_read(assert_texts_are_clear: READABLE) -> None:
    """The numbers of the collisions stand apart."""
    figure, ax = style.figure(width=8, height=3.6)
    impact_plots.unfolded_wedge(ax, 9.0)
    assert_texts_are_clear(figure)
