"""Figures of the separating axis test: what they draw is what the test finds."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.patches import Polygon as Outline

from lesson_code.chapters.ch06_sat_and_manifolds import figures as sat_plots
from lesson_code.view.matplotlib import style

SQUARE = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)])
TRIANGLE = np.array([(1.5, 0.5), (4.0, 0.5), (4.0, 2.5)])

ROUNDING = 1e-12
"""m: a few operations on numbers of a few metres."""


def outlines(ax: object) -> list[np.ndarray]:
    """Return the corners of each polygon that is drawn, without the repeated first one."""
    return [p.get_xy()[:-1] for p in ax.patches if isinstance(p, Outline)]  # type: ignore[attr-defined]


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
