"""The figures of the chapters: what is drawn stands where the numbers say, and can be read."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

from lesson_code.formulas import elastic_1d
from lesson_code.view.matplotlib import plots, style

BEFORE = ["before", "after an elastic collision"]
READABLE: Any = Callable[[Figure], None]


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


def arrows(ax: Axes) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    """Return tail and vector of each arrow, rounded."""
    found = [text for text in ax.texts if isinstance(text, Annotation) and text.arrow_patch]
    return [
        (
            tuple(np.round(arrow.xyann, 9).tolist()),
            tuple(np.round(np.subtract(arrow.xy, arrow.xyann), 9).tolist()),
        )
        for arrow in found
    ]


def words(ax: Axes) -> list[str]:
    """Return the words in some axes."""
    return [text.get_text() for text in ax.texts if text.get_text()]


def bars(ax: Axes) -> list[tuple[float, float, float, str]]:
    """Return centre, foot, height and hatch of each bar."""
    return [
        (
            round(bar.get_x() + bar.get_width() / 2, 9),
            bar.get_y(),
            bar.get_height(),
            bar.get_hatch() or "",
        )
        for bar in ax.patches
        if isinstance(bar, Rectangle)
    ]


# arrow


def test_arrow_goes_from_its_tail_by_its_vector(ax: Axes) -> None:
    """The tip is the tail plus the vector."""
    assert plots.arrow(ax, (1, 2), np.array([3.0, -4.0]), "v", style.BLUE) is ax
    assert arrows(ax) == [((1, 2), (3, -4))]


def test_arrow_reaches_its_tip_without_a_gap(ax: Axes) -> None:
    """A vector of length 1 is drawn 1 long: matplotlib would leave a gap at both ends."""
    plots.arrow(ax, (0, 0), (1, 0), "", style.BLUE)
    patch = ax.texts[0].arrow_patch  # type: ignore[attr-defined]
    assert (patch.shrinkA, patch.shrinkB) == (0, 0)


def test_arrow_has_its_name_at_its_tip_in_its_colour(ax: Axes) -> None:
    """The name stands beside the tip by so many points."""
    plots.arrow(ax, (1, 2), (3, 4), "v", style.GREEN, beside=(10, -8))
    name = ax.texts[-1]
    assert isinstance(name, Annotation)
    assert (name.get_text(), name.xy, name.xyann) == ("v", (4, 6), (10, -8))
    assert name.get_color() == style.GREEN


def test_arrow_without_a_name_writes_nothing(ax: Axes) -> None:
    """An empty label is no label."""
    plots.arrow(ax, (0, 0), (1, 1), "", style.BLUE)
    assert words(ax) == []


@pytest.mark.parametrize("dashed", [False, True])
def test_dashes_are_the_second_cue(ax: Axes, dashed: bool) -> None:
    """Two arrows can be told apart without colour."""
    plots.arrow(ax, (0, 0), (1, 1), "", style.BLUE, dashed=dashed)
    line = ax.texts[0].arrow_patch.get_linestyle()  # type: ignore[attr-defined]
    assert (line != "solid") is dashed


def test_zero_vector_has_no_arrow_but_keeps_its_name(ax: Axes) -> None:
    """A head without a shaft would show a direction that is not there."""
    plots.arrow(ax, (1, 2), (0.0, 0.0), "v", style.BLUE)
    assert arrows(ax) == []
    assert words(ax) == ["v"]


# before_and_after


def test_values_of_one_sign_are_stacked_and_the_total_is_their_sum(ax: Axes) -> None:
    """Body 2 stands on body 1: 2 and 1.5 J reach to 3.5 J, before left and after right."""
    assert plots.before_and_after(ax, ["elastic"], [(2, 1.5)], [(3, 0.5)], "energy, J") is ax
    assert bars(ax) == [
        (-0.2, 0, 2, ""),
        (-0.2, 2, 1.5, "///"),
        (0.2, 0, 3, ""),
        (0.2, 3, 0.5, "///"),
    ]
    totals = [line.get_ydata()[0] for line in ax.lines if len(set(line.get_xdata())) == 2]
    assert totals[:2] == [3.5, 3.5]
    assert ax.get_ylabel() == "energy, J"


def test_values_of_opposite_sign_grow_apart_from_zero(ax: Axes) -> None:
    """Momenta 2 and -3 are drawn up and down, and the total at -1."""
    plots.before_and_after(ax, ["case"], [(2, -3)], [(-1, 0)], "momentum, kg m/s")
    assert bars(ax)[:2] == [(-0.2, 0, 2, ""), (-0.2, 0, -3, "///")]
    assert [line.get_ydata()[0] for line in ax.lines[:2]] == [-1, -1]


def test_two_negative_values_are_stacked_downward(ax: Axes) -> None:
    """Momenta -1 and -2 reach to -3."""
    plots.before_and_after(ax, ["case"], [(-1, -2)], [(0, -3)], "momentum, kg m/s")
    assert bars(ax) == [
        (-0.2, 0, -1, ""),
        (-0.2, -1, -2, "///"),
        (0.2, 0, 0, ""),
        (0.2, 0, -3, "///"),
    ]


def test_cases_are_named_in_order_with_before_and_after(ax: Axes) -> None:
    """Each case has its place on the axis, and says which bar is which."""
    plots.before_and_after(ax, ["right", "wrong"], [(1, 1)] * 2, [(1, 1)] * 2, "J")
    assert ax.get_xticks().tolist() == [0, 1]
    assert [t.get_text() for t in ax.get_xticklabels()] == [
        "right\nbefore | after",
        "wrong\nbefore | after",
    ]


def test_bodies_and_total_are_named_in_the_legend(ax: Axes) -> None:
    """The legend shows the hatching, the cue beside colour."""
    plots.before_and_after(ax, ["case"], [(1, 1)], [(1, 1)], "J")
    legend = ax.get_legend()
    assert [text.get_text() for text in legend.get_texts()] == ["body 1", "body 2", "total"]
    assert legend.get_patches()[1].get_hatch() == "///"


def test_cases_of_unequal_number_are_refused(ax: Axes) -> None:
    """Every case needs a before and an after."""
    with pytest.raises(ValueError, match="zip"):
        plots.before_and_after(ax, ["case"], [(1, 1)], [], "J")


THREE_CASES = ["right", "impulse doubled", "always swaps"]


@pytest.mark.parametrize(
    ("names", "before", "after"),
    [
        (["elastic"], [(2, -3)], [(-2.5, 1.5)]),
        (["e = 1", "e = 0.5", "e = 0"], [(2, 1.5)] * 3, [(3, 0.5), (1, 1), (0.1, 0.2)]),
        (THREE_CASES, [(2, -3)] * 3, [(-2.5, 1.5), (-7, 6), (-1, 6)]),
        (THREE_CASES, [(2e-9, 1e-9)] * 3, [(1e-9, 2e-9)] * 3),
        (THREE_CASES, [(2e6, 0)] * 3, [(0, -2e6)] * 3),
    ],
)
def test_no_word_of_before_and_after_is_cut_or_written_over_another(
    assert_texts_are_clear: READABLE, names: list[str], before: Any, after: Any
) -> None:
    """Two of them side by side, as in chapter 01, with several cases and sizes."""
    figure, (left, right) = style.figure(2, width=10.5, height=3.6)
    plots.before_and_after(left, names, before, after, "momentum, kg m/s")
    plots.before_and_after(right, names, before, after, "energy, J")
    left.get_legend().remove()
    assert_texts_are_clear(figure)


# carts


def test_cart_arrows_are_all_to_one_scale(ax: Axes) -> None:
    """The fastest cart of all rows has the longest arrow, 1.6; the others are in proportion."""
    assert plots.carts(ax, 1, [(2, -1), (-2.5, 0.5)], 3, BEFORE) is ax
    assert [vector for _, vector in arrows(ax)] == [(1.28, 0), (-0.64, 0), (-1.6, 0), (0.32, 0)]


def test_cart_at_rest_has_no_arrow(ax: Axes) -> None:
    """A cart at 0 m/s, or at a rounding error of it, stands still, and says +0.00."""
    plots.carts(ax, 1, [(2, 0), (-1e-17, 2)], 1, BEFORE)
    assert len(arrows(ax)) == 2
    assert words(ax).count("+0.00 m/s") == 2
    assert "-0.00 m/s" not in words(ax)


def test_all_carts_at_rest_are_drawn(ax: Axes) -> None:
    """Nothing is divided by a fastest speed of zero."""
    plots.carts(ax, 1, [(0, 0)], 1, ["at rest"])
    assert arrows(ax) == []


@pytest.mark.parametrize(("m1", "m2"), [(1, 3), (3, 1), (1, 1), (0.2, 5)])
def test_area_of_a_cart_grows_with_its_mass(ax: Axes, m1: float, m2: float) -> None:
    """Three times the mass is three times the area; the larger one is 0.8 wide."""
    plots.carts(ax, m1, [(1, -1)], m2, ["before"])
    cart_1, cart_2 = (patch for patch in ax.patches if isinstance(patch, Rectangle))
    areas = [cart.get_width() * cart.get_height() for cart in (cart_1, cart_2)]
    assert areas[1] / areas[0] == pytest.approx(m2 / m1)
    assert max(areas) == pytest.approx(0.64)


def test_cart_2_is_hatched_in_white_on_its_colour(ax: Axes) -> None:
    """The cue beside colour can be seen: hatching in the cart's own colour could not."""
    plots.carts(ax, 1, [(1, -1)], 1, ["before"])
    cart_1, cart_2 = (patch for patch in ax.patches if isinstance(patch, Rectangle))
    assert (cart_1.get_hatch() or "", cart_2.get_hatch()) == ("", "///")
    assert to_hex(cart_2.get_facecolor()) == style.SECOND.lower()
    assert to_hex(cart_2.get_edgecolor()) == "#ffffff"


def test_carts_stand_on_their_track_row_by_row_from_the_top(ax: Axes) -> None:
    """Row after row goes down, each named at its left, and all within the limits."""
    plots.carts(ax, 1, [(1, -1), (0, 0), (-1, 1)], 1, ["one", "two", "three"])
    feet = [patch.get_y() for patch in ax.patches if isinstance(patch, Rectangle)]
    assert feet == [0, 0, -1.5, -1.5, -3, -3]
    names = {t.get_text(): t.get_position() for t in ax.texts}
    assert names["one"][1] > names["two"][1] > names["three"][1] > ax.get_ylim()[0]
    assert ax.get_aspect() == 1


SPEEDS = (-3.0, -0.6, 0.0, 1.5)


@pytest.mark.parametrize("mass_2", [0.2, 1.0, 1.6, 5.0])
def test_no_word_of_carts_is_cut_or_written_over_another(
    assert_texts_are_clear: READABLE, mass_2: float
) -> None:
    """For light and heavy carts, slow and fast, and with chapter 01's longest name of a row."""
    for velocity_2 in SPEEDS:
        figure, ax = style.figure(width=6.4, height=3.6)
        before = (2.0, velocity_2)
        plots.carts(ax, 1, [before, elastic_1d(1, 2, mass_2, velocity_2)], mass_2, BEFORE)
        assert_texts_are_clear(figure)


@pytest.mark.parametrize(("m1", "m2"), [*product((0.2, 1, 5), repeat=2)])
def test_no_arrow_of_carts_runs_through_a_word(
    texts_of: Callable[..., dict[Any, Any]], m1: float, m2: float
) -> None:
    """Arrows in either direction leave the names of rows, carts and speeds alone."""
    figure, ax = style.figure(width=6.4, height=3.6)
    plots.carts(ax, m1, [(3, -3), (-3, 3)], m2, BEFORE)
    boxes = texts_of(figure)
    drawn = [text.arrow_patch for text in ax.texts if getattr(text, "arrow_patch", None)]
    assert len(drawn) == 4
    for patch in drawn:
        shaft = patch.get_window_extent()
        assert [t.get_text() for t, box in boxes.items() if box.overlaps(shaft)] == []


# path and curves


def test_path_goes_through_all_positions_with_a_dot_at_the_start(ax: Axes) -> None:
    """The dot says where it began: a path alone has no direction."""
    positions = [(0, 0), (1, 2), (3, 1)]
    assert plots.path(ax, positions, "ball", style.BLUE) is ax
    line, dot = ax.lines
    assert line.get_xydata().tolist() == [[0, 0], [1, 2], [3, 1]]
    assert (line.get_label(), line.get_linestyle()) == ("ball", "-")
    assert (dot.get_xydata().tolist(), dot.get_marker()) == ([[0, 0]], "o")
    assert ax.get_aspect() == 1


def test_dashed_path_is_dashed(ax: Axes) -> None:
    """Two paths can be told apart without colour."""
    plots.path(ax, np.zeros((2, 2)), "wrong", style.VERMILION, dashed=True)
    assert ax.lines[0].get_linestyle() == "--"


def test_curves_differ_in_colour_and_in_line(ax: Axes) -> None:
    """Up to three curves, each told apart twice, named in a legend."""
    named = {name: ([0, 1], [0, k]) for k, name in enumerate(("a", "b", "c"))}
    assert plots.curves(ax, named, "time, s", "height, m") is ax
    assert len({line.get_color() for line in ax.lines}) == 3
    assert len({line.get_linestyle() for line in ax.lines}) == 3
    assert [line.get_ydata().tolist() for line in ax.lines] == [[0, 0], [0, 1], [0, 2]]
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["a", "b", "c"]
    assert (ax.get_xlabel(), ax.get_ylabel()) == ("time, s", "height, m")


def test_single_curve_without_a_name_has_no_legend(ax: Axes) -> None:
    """What is alone needs no name."""
    plots.curves(ax, {"": ([0, 1], [0, 1])}, "x", "y")
    assert ax.get_legend() is None


def test_more_curves_than_styles_are_refused(ax: Axes) -> None:
    """A fourth curve could not be told apart; the error says how many there may be."""
    with pytest.raises(ValueError, match="at most 3 curves, got 4"):
        plots.curves(ax, {name: ([0], [0]) for name in "abcd"}, "x", "y")
    assert not ax.lines
