"""Figures of the manifold: edges, points and ways out are those that `collide` finds."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import Circle as CirclePatch

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.chapters.ch06_sat_and_manifolds import manifold_figures as manifold_plots
from lesson_code.geometry import collide
from lesson_code.view.matplotlib import style

FLOOR, BOX = Polygon.box(3, 1), Polygon.box(2, 1)
TILTED = (1.3, 0.85, 0.22)

ROUNDING = 1e-12
"""m: one turn and a few sums."""


@pytest.fixture
def steps() -> Figure:
    """Return the three pictures of a tilted box in a level one."""
    figure, axes = style.figure(3, width=11, height=2.7)
    manifold_plots.clipping(axes, FLOOR, (0, 0, 0), BOX, TILTED)
    return figure


def thick(figure: Figure, column: int) -> list[np.ndarray]:
    """Return the ends of the edges that are drawn thick in a picture."""
    return [line.get_xydata() for line in figure.axes[column].lines if line.get_linewidth() == 5]


def test_clipping_marks_the_edges_that_face_each_other(steps: Figure) -> None:
    """The level box's upper edge, whole, and the tilted box's lower edge, 2 m long."""
    reference, incident = thick(steps, 0)
    assert np.allclose(reference[:, 1], 0.5, atol=ROUNDING)
    assert np.ptp(reference[:, 0]) == pytest.approx(3.0, abs=ROUNDING)
    assert np.hypot(*np.diff(incident, axis=0)[0]) == pytest.approx(2.0, abs=ROUNDING)
    assert incident.mean(axis=0)[1] < TILTED[1]


def test_clipping_cuts_at_the_end_of_the_reference_edge(steps: Figure) -> None:
    """What is left of the incident edge ends at x = 1.5, where the level box ends."""
    _, kept = thick(steps, 1)
    assert kept[:, 0].max() == pytest.approx(1.5, abs=ROUNDING)


def test_clipping_draws_the_points_of_the_manifold(steps: Figure) -> None:
    """Points and penetrations are those that the engine would use."""
    manifold = collide(FLOOR, (0, 0, 0), BOX, TILTED)
    assert manifold is not None
    ax = steps.axes[2]
    assert np.allclose(ax.lines[0].get_xydata(), manifold.points, atol=ROUNDING)
    written = [text.get_text() for text in ax.texts]
    assert written == [f"{depth:.2f} m" for depth in manifold.penetrations]


def test_clipping_swapped_bodies_mark_the_same_edges(steps: Figure) -> None:
    """Whose edge is the reference edge does not depend on which body comes first."""
    other, axes = style.figure(3, width=11, height=2.7)
    manifold_plots.clipping(axes, BOX, TILTED, FLOOR, (0, 0, 0))
    for edge, same in zip(thick(steps, 0), thick(other, 0), strict=True):
        assert np.allclose(np.sort(edge, axis=0), np.sort(same, axis=0), atol=ROUNDING)


def test_clipping_texts_can_be_read(
    steps: Figure, assert_texts_are_clear: Callable[[Figure], None]
) -> None:
    """No title, name or number is cut off or runs into another one."""
    assert_texts_are_clear(steps)


def test_clipping_polygons_apart_are_refused() -> None:
    """Without an overlap there is nothing to clip."""
    _, axes = style.figure(3)
    with pytest.raises(ValueError, match="a and b must overlap"):
        manifold_plots.clipping(axes, FLOOR, (0, 0, 0), BOX, (9, 0, 0))


@pytest.mark.parametrize("first", [FLOOR, Segment((-2, 0), (2, 0), radius=0.1)])
def test_ways_out_lead_to_where_the_circle_only_touches(first: Polygon | Segment) -> None:
    """Each dashed circle touches the shape: a hair smaller it is out, a hair larger it is in."""
    places = [(0.3, 0.4), (1.6, 0.3), (-0.5, -0.3)]
    discs = [Body(Circle(0.4), position=place, mass=1) for place in places]
    _, ax = style.figure()
    manifold_plots.ways_out(ax, Scene([Body(first), *discs]))
    ghosts = [p for p in ax.patches if isinstance(p, CirclePatch) and p.get_linestyle() == "--"]
    assert len(ghosts) == len(places)
    for ghost in ghosts:
        pose = (*ghost.center, 0)
        assert collide(first, (0, 0, 0), Circle(0.4 - 1e-9), pose) is None
        assert collide(first, (0, 0, 0), Circle(0.4 + 1e-9), pose) is not None
        (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
        assert left < ghost.center[0] - 0.4 < ghost.center[0] + 0.4 < right
        assert bottom < ghost.center[1] - 0.4 < ghost.center[1] + 0.4 < top


def test_ways_out_a_circle_that_is_out_has_none() -> None:
    """Nothing is drawn for a circle that does not overlap."""
    _, ax = style.figure()
    manifold_plots.ways_out(ax, Scene([Body(FLOOR), Body(Circle(0.4), position=(0, 2), mass=1)]))
    assert not [p for p in ax.patches if p.get_linestyle() == "--"]
