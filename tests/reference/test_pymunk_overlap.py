"""pymunk's narrow phase as an independent judge of overlap, direction and depth."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code.chapters.ch06_sat_and_manifolds.scenes import random_polygon
from lesson_code.geometry import Circle, Polygon, collide, mtv
from lesson_code.reference.pymunk_reference.overlap import circle_overlap, polygon_overlap

SQUARE = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]

DEPTH_TOLERANCE = 1e-12
"""m: shapes of some metres; two ways of computing one number differ by rounding, about 1e-15."""

PAIRS = 3_000


@pytest.mark.parametrize(
    ("x", "normal", "depth"),
    [(3.5, (1, 0), 0.5), (-1.5, (-1, 0), 0.5), (2.5, (1, 0), 1.5), (0.25, (-1, 0), 1.25)],
    ids=["right", "left", "inside, right", "inside, left"],
)
def test_polygon_overlap_hand_worked(x: float, normal: tuple[int, int], depth: float) -> None:
    """A box of 1 m or 2 m by 1 m, at the side of a square of 4 m and inside it, half way up."""
    width = 1.0 if 0 <= x <= 3 else 2.0
    found = polygon_overlap(SQUARE, [(x, 1.5), (x + width, 1.5), (x + width, 2.5), (x, 2.5)])
    assert found is not None
    assert found[0].tolist() == list(normal)
    assert found[1] == depth


def test_overlap_touching_is_none() -> None:
    """Where pymunk sees a contact of depth 0, the workbook sees no overlap."""
    assert polygon_overlap(SQUARE, [(4, 0), (6, 0), (6, 2)]) is None
    assert circle_overlap(SQUARE, (5.0, 2.0), 1.0) is None


def test_overlap_apart_is_none() -> None:
    """Shapes whose boxes overlap but that are apart, and shapes far apart."""
    assert polygon_overlap([(0, 0), (4, 0), (0, 4)], [(4, 4), (2.5, 4), (4, 2.5)]) is None
    assert circle_overlap(SQUARE, (4.8, 4.8), 1.0) is None
    assert circle_overlap(SQUARE, (99, 0), 1.0) is None


def test_mtv_agrees_with_pymunk_on_random_pairs() -> None:
    """Whether two polygons overlap, and how deep: separating axes and pymunk say the same."""
    rng = np.random.default_rng(seed=6)
    overlapping = 0
    for _ in range(PAIRS):
        a, b = random_polygon(rng), random_polygon(rng, 1.5)
        ours, theirs = mtv(a, b), polygon_overlap(a, b)
        assert (ours is None) == (theirs is None)
        if ours is not None and theirs is not None:
            overlapping += 1
            assert ours[1] == pytest.approx(theirs[1], abs=DEPTH_TOLERANCE)
    assert PAIRS / 3 < overlapping < PAIRS * 9 / 10


def test_circle_against_polygon_agrees_with_pymunk_on_random_pairs() -> None:
    """Outside and inside: the same depth, and a circle moved by it is out for pymunk too."""
    rng = np.random.default_rng(seed=7)
    inside = outside = 0
    for _ in range(PAIRS):
        shape = Polygon(random_polygon(rng))
        centre, radius = rng.uniform(-1.3, 1.3, 2), rng.uniform(0.05, 0.6)
        manifold = collide(shape, (0, 0, 0), Circle(radius), (*centre, 0))
        theirs = circle_overlap(shape.vertices, centre, radius)
        assert (manifold is None) == (theirs is None)
        if manifold is not None and theirs is not None:
            depth = manifold.penetrations[0]
            inside += depth > radius
            outside += depth < radius
            assert depth == pytest.approx(theirs[1], abs=DEPTH_TOLERANCE)
            moved = centre + depth * manifold.normal
            pushed = circle_overlap(shape.vertices, moved, radius)
            assert pushed is None or pushed[1] <= DEPTH_TOLERANCE
    assert min(inside, outside) > PAIRS / 10
