"""The figures of chapter 05: what is drawn stands where the numbers say, and can be read."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.patches import Circle, Polygon
from matplotlib.text import Annotation

from lesson_code.chapters.ch05_spin_and_friction import figures as friction_plots
from lesson_code.view.matplotlib import style

BOX = [(0.0, 0.0), (1.5, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)]


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


def arrows(ax: Axes) -> list[tuple[Any, Any]]:
    """Return tail and vector of each arrow, rounded."""
    found = [text for text in ax.texts if isinstance(text, Annotation) and text.arrow_patch]
    return [
        (
            tuple((np.round(arrow.xyann, 9) + 0.0).tolist()),
            tuple((np.round(np.subtract(arrow.xy, arrow.xyann), 9) + 0.0).tolist()),
        )
        for arrow in found
    ]


def data(ax: Axes) -> list[list[list[float]]]:
    """Return the points of each line."""
    return [line.get_xydata().tolist() for line in ax.lines]


# point_velocities


def test_rolling_disc_has_an_arrow_everywhere_but_at_the_lowest_point(ax: Axes) -> None:
    """Four points of the rim: none below, the double one above; then the centre's own."""
    assert friction_plots.point_velocities(ax, (3, 0), -6.0, 0.5, longest=3.0, count=4) is ax
    assert arrows(ax) == [
        ((0.5, 0.0), (0.5, -0.5)),
        ((0.0, 0.5), (1.0, 0.0)),
        ((-0.5, 0.0), (0.5, 0.5)),
        ((0.0, 0.0), (0.5, 0.0)),
    ]


def test_disc_at_rest_has_no_arrows(ax: Axes) -> None:
    """A head without a shaft would show a direction that is not there."""
    friction_plots.point_velocities(ax, (0, 0), 0.0, 0.5, longest=1.0)
    assert arrows(ax) == []
    (rim,) = ax.patches
    assert isinstance(rim, Circle)
    assert (rim.center, rim.radius) == ((0, 0), 0.5)


@pytest.mark.parametrize(("v", "w"), [((3, 0), 0), ((0, 0), -6), ((3, 0), -6)])
def test_every_arrow_of_chapter_05s_discs_lies_within_the_limits(
    ax: Axes, v: tuple[float, float], w: float
) -> None:
    """Also that of the highest point of the rolling disc."""
    friction_plots.point_velocities(ax, v, w, radius=0.5, longest=5.0)
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    for tail, vector in arrows(ax):
        x, y = np.add(tail, vector)
        assert left <= x <= right
        assert bottom <= y <= top


# fan_of_triangles


def test_fan_has_a_line_from_the_centre_to_every_vertex(ax: Axes) -> None:
    """Five triangles for five vertices, also where one of them is redundant."""
    assert friction_plots.fan_of_triangles(ax, BOX, (1.5, 1.0)) is ax
    *spokes, vertices, centre = data(ax)
    assert spokes == [[[1.5, 1.0], list(corner)] for corner in BOX]
    assert vertices == [list(corner) for corner in BOX]
    assert centre == [[1.5, 1.0]]
    assert isinstance(ax.patches[0], Polygon)
    assert ax.get_aspect() == 1


# measured_on_curves


def test_measured_points_differ_in_colour_and_marker_and_from_the_curve(ax: Axes) -> None:
    """Two engines and a closed form: three looks, all named, points not joined by lines."""
    named, measured = {"exact": ([0, 1], [0, 1])}, {"ours": ([0], [0]), "pymunk": ([1], [1])}
    assert friction_plots.measured_on_curves(ax, named, measured, "x", "y") is ax
    curve, ours, theirs = ax.lines
    assert [line.get_linestyle() for line in ax.lines] == ["-", "None", "None"]
    assert len({line.get_color() for line in ax.lines}) == 3
    assert ours.get_marker() != theirs.get_marker()
    assert curve.get_xydata().tolist() == [[0, 0], [1, 1]]
    names = [text.get_text() for text in ax.get_legend().get_texts()]
    assert names == ["exact", "ours", "pymunk"]


def test_more_sets_of_points_than_markers_are_refused(ax: Axes) -> None:
    """A third could not be told apart; the error says how many there may be."""
    with pytest.raises(ValueError, match="at most 2 sets, got 3"):
        friction_plots.measured_on_curves(ax, {}, dict.fromkeys("abc", ([0], [0])), "x", "y")
    assert not ax.lines
