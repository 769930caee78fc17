"""The figures of chapter 04: discs stand where the numbers say, and can be told apart."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle
from matplotlib.text import Annotation

from lesson_code.chapters.ch04_circles import figures as circle_plots
from lesson_code.view.matplotlib import style

READABLE: Any = Callable[[Figure], None]


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


def discs(ax: Axes, *, filled: bool) -> list[tuple[tuple[float, float], float, str]]:
    """Return centre, radius and hatch of each filled disc, or of each outline."""
    return [
        (tuple(map(float, patch.center)), float(patch.radius), patch.get_hatch() or "")
        for patch in ax.patches
        if isinstance(patch, Circle) and patch.get_fill() is filled
    ]


def arrows(ax: Axes) -> list[tuple[Any, Any, str, bool]]:
    """Return tail, vector, colour and whether it is dashed, of each arrow."""
    found = [text for text in ax.texts if isinstance(text, Annotation) and text.arrow_patch]
    return [
        (
            np.round(arrow.xyann, 9).tolist(),
            np.round(np.subtract(arrow.xy, arrow.xyann), 9).tolist(),
            to_hex(arrow.arrow_patch.get_edgecolor()).upper(),
            arrow.arrow_patch.get_linestyle() != "solid",
        )
        for arrow in found
    ]


def words(ax: Axes) -> dict[str, Annotation]:
    """Return the annotations with words, by their words."""
    return {text.get_text(): text for text in ax.texts if text.get_text()}


# two_discs


def test_two_discs_have_their_centres_and_radii_and_a_second_cue(ax: Axes) -> None:
    """Each disc stands where it should; the second one is hatched."""
    assert circle_plots.two_discs(ax, (1, 2), 0.5, np.array([-1.0, 0.0]), 2.0) is ax
    assert discs(ax, filled=True) == [((1, 2), 0.5, ""), ((-1, 0), 2.0, "///")]
    assert [tuple(line.get_xydata()[0]) for line in ax.lines] == [(1, 2), (-1, 0)]
    assert ax.get_aspect() == 1


def test_two_discs_are_wholly_in_view(ax: Axes) -> None:
    """The axes reach to the rims."""
    circle_plots.two_discs(ax, (1, 2), 0.5, (-1, 0), 2.0)
    (left, right), (low, high) = ax.get_xlim(), ax.get_ylim()
    assert left <= -3
    assert right >= 1.5
    assert low <= -2
    assert high >= 2.5


def test_two_discs_have_their_numbers_inside_off_the_line_of_centres(ax: Axes) -> None:
    """What is drawn along the line of centres does not strike the numbers out."""
    circle_plots.two_discs(ax, (0, 0), 1.0, (5, 0), 2.0)
    assert words(ax)["1"].xy == pytest.approx((0, 0.65))
    assert words(ax)["2"].xy == pytest.approx((5, 1.3))


def test_numbers_keep_clear_of_arrows(ax: Axes) -> None:
    """With an arrow upward from disc 1, its number stands below the centre."""
    circle_plots.two_discs(ax, (0, 0), 1.0, (5, 0), 2.0, arrows=([(0.0, 3.0)], [(0.0, -1.0)]))
    assert words(ax)["1"].xy == pytest.approx((0, -0.65))
    assert words(ax)["2"].xy == pytest.approx((5, 1.3))


def test_two_discs_on_one_centre_have_numbers_too(ax: Axes) -> None:
    """Without a line of centres the numbers stand upward."""
    circle_plots.two_discs(ax, (3, 4), 1.0, (3, 4), 2.0)
    assert words(ax)["1"].xy == pytest.approx((3, 4.65))
    assert words(ax)["2"].xy == pytest.approx((3, 5.3))


def test_outlines_are_dotted_and_nothing_else(ax: Axes) -> None:
    """Where the discs were is drawn without filling, centre or number."""
    circle_plots.two_discs(ax, (1, 2), 0.5, (-1, 0), 2.0, outline=True)
    assert discs(ax, filled=False) == [((1, 2), 0.5, ""), ((-1, 0), 2.0, "")]
    assert {patch.get_linestyle() for patch in ax.patches} == {":"}
    assert not words(ax)
    assert not ax.lines


# overlap


def test_overlap_shows_the_normal_and_the_depth_between_the_rims(ax: Axes) -> None:
    """The thick line goes from the rim of disc 1 back to the rim of disc 2."""
    n = np.array([0.6, 0.8])
    assert circle_plots.overlap(ax, (0, 0), 2.5, 5 * n, 3.5, n, 1.0) is ax
    (depth,) = [line.get_xydata() for line in ax.lines if line.get_linewidth() == 4]
    np.testing.assert_allclose(depth, [2.5 * n, 1.5 * n])
    assert arrows(ax) == [([0, 0], [0.6, 0.8], style.INK.upper(), False)]
    assert {"n", "depth", "1", "2"} == set(words(ax))


# hit


def test_hit_shows_the_discs_in_touch_at_the_origin(ax: Axes) -> None:
    """The rims meet at (0, 0), and the tangent is drawn through it."""
    n = (0.6, 0.8)
    assert circle_plots.hit(ax, n, (0.5, 2.0), [(1, 0), (0, 0)], [(0, 1), (2, 2)]) is ax
    (c1, r1, _), (c2, r2, _) = discs(ax, filled=True)
    assert (c1, r1, r2) == (pytest.approx((-0.3, -0.4)), 0.5, 2.0)
    assert c2 == pytest.approx((1.2, 1.6))
    tangent = ax.lines[-1].get_xydata()
    assert tangent.sum(axis=0) == pytest.approx([0, 0])
    assert (tangent[1] - tangent[0]) @ n == pytest.approx(0)


def test_hit_arrows_come_in_dashed_and_leave_solid(ax: Axes) -> None:
    """An arrow is as long as the way made in the given time; it ends or starts at the centre."""
    circle_plots.hit(ax, (1, 0), (1.0, 1.0), [(4, 2), (0, 0)], [(0, 2), (4, 0)], seconds=0.5)
    assert arrows(ax) == [
        ([-3, -1], [2, 1], style.FIRST, True),
        ([-1, 0], [0, 1], style.FIRST, False),
        ([1, 0], [2, 0], style.SECOND, False),
    ]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["before", "after"]


def test_hit_arrows_are_wholly_in_view(ax: Axes) -> None:
    """A fast disc's arrow is not cut off."""
    circle_plots.hit(ax, (1, 0), (1.0, 1.0), [(20, 0), (0, 0)], [(0, 0), (0, -30)], seconds=0.5)
    assert ax.get_xlim()[0] <= -11
    assert ax.get_ylim()[0] <= -15


# rows_of_bars


def test_bars_stand_side_by_side_with_their_values(ax: Axes) -> None:
    """Two cases of two bodies: bars left and right of each body's place, hatched differently."""
    circle_plots.rows_of_bars(ax, {"a": [1, -2], "b": [3, 4]}, ["x", "y"], "velocity, m/s")
    bars = [patch for patch in ax.patches if isinstance(patch, Rectangle)]
    middles = [round(bar.get_x() + bar.get_width() / 2, 9) for bar in bars]
    assert middles == [-0.2, 0.8, 0.2, 1.2]
    assert [bar.get_height() for bar in bars] == [1, -2, 3, 4]
    assert [bar.get_hatch() for bar in bars] == ["", "", "///", "///"]
    assert [label.get_text() for label in ax.get_xticklabels()] == ["x", "y"]
    assert ax.get_ylabel() == "velocity, m/s"


def test_more_bars_than_styles_are_refused(ax: Axes) -> None:
    """A fourth case would look like the first."""
    with pytest.raises(ValueError, match="named must hold at most 3 cases, got 4"):
        circle_plots.rows_of_bars(ax, {name: [1] for name in "abcd"}, ["x"], "y")


# The figures as they are used


def test_figures_can_be_read(assert_texts_are_clear: READABLE) -> None:
    """Nothing overlaps and nothing is cut off."""
    figure, (left, middle, right) = style.figure(3, width=13, height=4)
    circle_plots.overlap(left, (0, 0), 2.5, (3, 4), 3.5, (0.6, 0.8), 1.0)
    circle_plots.hit(middle, (0.8, 0.6), (0.5, 0.8), [(3, 0), (-1, 0)], [(-1, 1), (1, 1)])
    circle_plots.rows_of_bars(
        right, {"one": [0, 1], "two": [1, 0], "three": [2, 2]}, ["1", "2"], "m/s"
    )
    assert_texts_are_clear(figure)
