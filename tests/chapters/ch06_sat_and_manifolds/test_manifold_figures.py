"""Figures of the manifold: edges, points and ways out are those that `collide` finds."""

from __future__ import annotations

import pytest
from matplotlib.patches import Circle as CirclePatch

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.chapters.ch06_sat_and_manifolds import manifold_figures as manifold_plots
from lesson_code.geometry import collide
from lesson_code.view.matplotlib import style

FLOOR, BOX = Polygon.box(3, 1), Polygon.box(2, 1)
TILTED = (1.3, 0.85, 0.22)

ROUNDING = 1e-12
"""m: one turn and a few sums."""


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
