"""Figures of the separating axis test: what they draw is what the test finds."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import Polygon as Outline

from lesson_code.chapters.ch06_sat_and_manifolds import figures as sat_plots
from lesson_code.chapters.ch06_sat_and_manifolds.figures import AxisShadows
from lesson_code.view.matplotlib import style

SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
TRIANGLE = np.array([(1.5, 0.5), (4.0, 0.5), (4.0, 2.5)])

ROUNDING = 1e-12
"""m: a few operations on numbers of a few metres."""


def outlines(ax: object) -> list[np.ndarray]:
    """Return the corners of each polygon that is drawn, without the repeated first one."""
    return [p.get_xy()[:-1] for p in ax.patches if isinstance(p, Outline)]  # type: ignore[attr-defined]


def test_shadows_parallel_edges_share_an_axis() -> None:
    """A square has two axes, a triangle three; each is named after its polygon."""
    found = sat_plots.shadows(SQUARE, TRIANGLE)
    assert [on.name for on in found] == ["A1", "A2", "B1", "B2", "B3"]


def test_shadows_hold_the_extreme_vertices() -> None:
    """On the axis of a square's right side a shadow is the range of x."""
    on = next(on for on in sat_plots.shadows(SQUARE, TRIANGLE) if abs(on.axis[0]) == 1.0)
    sign = float(on.axis[0])
    assert sorted(sign * end for end in on.a) == [0.0, 2.0]
    assert sorted(sign * end for end in on.b) == [1.5, 4.0]


@pytest.mark.parametrize(
    ("b", "depth", "words"),
    [
        ((1.5, 4.0), 0.5, "out after 0.50 m"),
        ((-3.0, 0.25), 0.25, "out after 0.25 m"),
        ((0.5, 0.75), 0.75, "out after 0.75 m"),
        ((2.0, 3.0), 0.0, "touching"),
        ((2.5, 3.0), -0.5, "gap of 0.50 m"),
        ((-3.0, -0.5), -0.5, "gap of 0.50 m"),
    ],
)
def test_depth_is_the_shorter_way_out(b: tuple[float, float], depth: float, words: str) -> None:
    """Partly inside on either side, wholly inside, touching, and apart on either side."""
    on = AxisShadows("A1", np.array([1.0, 0.0]), (0.0, 2.0), b)
    assert on.depth == depth
    assert sat_plots.way_out(on) == words


def test_shortest_prefers_the_widest_gap() -> None:
    """Where there is a gap, the axis that shows most of it decides."""
    found = sat_plots.shadows(SQUARE, np.add(TRIANGLE, (1.0, 0.0)))
    assert sat_plots.shortest(found).depth == pytest.approx(-0.5, abs=ROUNDING)


def test_pair_draws_both_polygons_with_a_second_cue() -> None:
    """Each polygon is filled and outlined; B is hatched and A is not."""
    _, ax = style.figure()
    sat_plots.pair(ax, SQUARE, TRIANGLE)
    assert [patch.get_hatch() for patch in ax.patches if patch.get_fill()] == ["", "///"]
    assert {text.get_text() for text in ax.texts} == {"A", "B"}
    assert ax.get_xlabel() == "x, m"


def test_translation_draws_b_where_it_only_touches() -> None:
    """The dashed outline is B moved out of A by the overlap in x, half a metre."""
    _, ax = style.figure()
    sat_plots.translation(ax, SQUARE, TRIANGLE)
    [moved] = outlines(ax)
    assert np.allclose(moved, np.add(TRIANGLE, (0.5, 0.0)), atol=ROUNDING)


def test_translation_of_polygons_apart_draws_nothing() -> None:
    """Where nothing overlaps, nothing is moved."""
    _, ax = style.figure()
    sat_plots.translation(ax, SQUARE, np.add(TRIANGLE, (9.0, 0.0)))
    assert outlines(ax) == []


@pytest.mark.parametrize("angle", range(0, 360, 30))
def test_shadows_beside_stand_clear_of_the_polygons(angle: int) -> None:
    """Whatever way the axis points, the shadows are as long as they should be and cross nothing."""
    n = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    across = np.array([n[1], -n[0]])
    _, ax = style.figure()
    sat_plots.shadows_beside(ax, SQUARE, TRIANGLE, n)
    thick = [line.get_xydata() for line in ax.lines if line.get_linewidth() == 5]
    for vertices, ends in zip((SQUARE, TRIANGLE), thick, strict=True):
        along = vertices @ n
        assert np.allclose(ends @ n, (along.min(), along.max()), atol=ROUNDING)
        assert (ends @ across).min() > max((v @ across).max() for v in (SQUARE, TRIANGLE))


def test_shadow_rows_the_axis_that_decides_is_bold() -> None:
    """Two bars a row, the name and number of the deciding axis in bold, and no other."""
    _, ax = style.figure()
    found = sat_plots.shadows(SQUARE, TRIANGLE)
    sat_plots.shadow_rows(ax, found)
    assert len(ax.patches) == 2 * len(found)
    bold = [label.get_text() for label in ax.get_yticklabels() if label.get_weight() == "bold"]
    assert bold == [sat_plots.shortest(found).name]
    assert [t.get_text() for t in ax.texts if t.get_weight() == "bold"] == ["out after 0.50 m"]


@pytest.mark.parametrize("shift", [(0.0, 0.0), (-1.2, -0.8), (2.0, 1.0)])
def test_texts_can_be_read(
    assert_texts_are_clear: Callable[[Figure], None], shift: tuple[float, float]
) -> None:
    """No name or number is cut off or runs into another one."""
    figure, (left, right) = style.figure(2, width=9.5, height=3.8)
    found = sat_plots.shadows(SQUARE, np.add(TRIANGLE, shift))
    decides = sat_plots.shortest(found)
    sat_plots.shadows_beside(left, SQUARE, np.add(TRIANGLE, shift), decides.axis, decides.name)
    sat_plots.shadow_rows(right, found)
    assert_texts_are_clear(figure)
