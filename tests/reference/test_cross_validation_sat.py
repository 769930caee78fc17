"""Overlap, depth and contact points against two engines of others, and against a third way.

========================  ==================================================================
reference                 how it finds the answer
========================  ==================================================================
shapely (GEOS)            intersects: predicates that are exact in spite of rounding
pymunk (Munk2D)           GJK and EPA on the Minkowski difference: normal and contact points
Minkowski difference      all differences of corners, their convex hull by shapely, and the
                          origin's distance to its edge: a depth without any axis
========================  ==================================================================

pymunk, like shapely, calls exact touch a contact, and we do not; random pairs never just touch.
When pymunk's ``shapes_collide`` is given a polygon before a circle, say, it swaps the two inside
and returns distances of the wrong sign, so only their size is compared. Where a corner of one
rounded shape meets a corner of another it lists one point twice.
"""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pymunk
import pytest
import shapely
from tiers import share

from lesson_code.geometry import Circle, Manifold, Polygon, Segment, Shape, collide, mtv

PAIRS = share(20_000)
SEED = 20_240_611

DEPTH = 1e-12
"""m, for depths, of shapes up to 6 m across and 10 m apart; measured: 1.9e-15 at most."""

NORMAL = 1e-9
"""pymunk's normal at a circle is read off a distance that may be as short as 1e-6 m, with
coordinates rounded to 1e-16: 1e-10; the lesson's comes from the edge."""

MARGIN = 1e-12
"""m: pairs that are nearer than this to touching are undecided by rounding, and left out."""

Pose = tuple[float, float, float]
Placed = tuple[Shape, Pose]


def random_polygon(rng: np.random.Generator) -> Polygon:
    """Return a convex polygon of 3 to 8 corners on an ellipse, 0.2 to 6 m across."""
    steps = rng.uniform(0.3, 1, rng.integers(3, 9))
    angles = 2 * np.pi * np.cumsum(steps) / steps.sum()
    width, height = 10 ** rng.uniform(-1, 0.5, 2)
    return Polygon(np.stack((width * np.cos(angles), height * np.sin(angles)), axis=1))


def random_circle(rng: np.random.Generator) -> Circle:
    """Return a circle of 0.1 to 3 m radius."""
    return Circle(10 ** rng.uniform(-1, 0.5))


def random_line(rng: np.random.Generator) -> Segment:
    """Return a segment without thickness, up to 6 m long."""
    return Segment(rng.uniform(-2, 2, 2), rng.uniform(-2, 2, 2))


def random_capsule(rng: np.random.Generator) -> Segment:
    """Return a segment of up to 1 m thickness."""
    return Segment(rng.uniform(-2, 2, 2), rng.uniform(-2, 2, 2), rng.uniform(0.01, 0.5))


RANDOM = {
    "polygon": random_polygon,
    "circle": random_circle,
    "line": random_line,
    "capsule": random_capsule,
}


def random_pairs(kind_a: str, kind_b: str, count: int) -> list[tuple[Placed, Placed]]:
    """Return pairs of 500 random shapes a kind, at random places and angles."""
    rng = np.random.default_rng([SEED, *kind_a.encode(), *kind_b.encode()])
    pools = [[RANDOM[kind](rng) for _ in range(500)] for kind in (kind_a, kind_b)]
    shapes = rng.integers(0, 500, (count, 2)).tolist()
    poses = rng.uniform((-2, -2, -4), (2, 2, 4), (count, 2, 3)).tolist()
    return [
        ((pools[0][i], tuple(pose_a)), (pools[1][j], tuple(pose_b)))
        for (i, j), (pose_a, pose_b) in zip(shapes, poses, strict=True)
    ]


def in_world(placed: Placed) -> Any:
    """Return the corners of a polygon or segment, or the centre of a circle, in the world."""
    shape, (x, y, angle) = placed
    c, s = math.cos(angle), math.sin(angle)
    local = np.array(shape.outline or [(0.0, 0.0)])
    return local @ np.array([[c, s], [-s, c]]) + (x, y)


def in_pymunk(placed: Placed) -> pymunk.Shape:
    """Return a shape of pymunk at its place."""
    shape, (x, y, angle) = placed
    body = pymunk.Body(1, 1)
    body.position, body.angle = (x, y), angle
    made: pymunk.Shape
    if isinstance(shape, Circle):
        made = pymunk.Circle(body, shape.radius)
    elif isinstance(shape, Polygon):
        made = pymunk.Poly(body, shape.vertices)
    else:
        made = pymunk.Segment(body, shape.start, shape.end, shape.radius)
    made.cache_bb()  # shapes_collide looks at the place that was cached last
    return made


def pymunk_contact(a: Placed, b: Placed) -> tuple[Any, Any] | None:
    """Return pymunk's normal and its points as rows (ax, ay, bx, by, penetration), or None."""
    try:
        found = in_pymunk(a).shapes_collide(in_pymunk(b))
    except AssertionError:  # how pymunk says that there is no contact
        return None
    rows = np.array([(*p.point_a, *p.point_b, abs(p.distance)) for p in found.points])
    if len(rows) == 2 and np.abs(rows[0] - rows[1]).max() < MARGIN:
        rows = rows[:1]
    return np.array(found.normal), rows


def signed_depth(a: Placed, b: Placed) -> float:
    """Return how deep two shapes overlap, m; minus their distance when they are apart.

    The Minkowski difference of two outlines holds the origin when they overlap. The depth is then
    the origin's distance from its edge.
    """
    corners_a, corners_b = in_world(a), in_world(b)
    differences = (corners_a[:, None] - corners_b[None]).reshape(-1, 2)
    hull, origin = shapely.convex_hull(shapely.multipoints(differences)), shapely.Point(0, 0)
    reach = a[0].rounding + b[0].rounding
    if hull.contains(origin):
        return float(shapely.boundary(hull).distance(origin)) + reach
    return reach - float(hull.distance(origin))


def compare_points(contact: Manifold, expected: Any) -> float:
    """Return by how much midpoints and penetrations differ from pymunk's, in the better order."""
    ours = np.column_stack((contact.points, contact.penetrations))
    theirs = np.column_stack(((expected[:, :2] + expected[:, 2:4]) / 2, expected[:, 4]))
    return min(float(np.abs(ours - order).max()) for order in (theirs, theirs[::-1]))


@pytest.fixture(scope="module")
def polygon_pairs() -> list[tuple[Placed, Placed]]:
    """Return the 20,000 pairs of polygons."""
    return random_pairs("polygon", "polygon", PAIRS)


def test_overlap_of_polygons_is_decided_as_by_shapely_and_pymunk(
    polygon_pairs: list[tuple[Placed, Placed]],
) -> None:
    """In 20,000 random pairs there is not one disagreement about whether they overlap."""
    corners = [(in_world(a), in_world(b)) for a, b in polygon_pairs]
    ours = [mtv(a, b) is not None for a, b in corners]
    shapely_says = [shapely.intersects(*map(shapely.Polygon, pair)) for pair in corners]
    pymunk_says = [pymunk_contact(a, b) is not None for a, b in polygon_pairs]
    assert ours == shapely_says == pymunk_says
    assert 0.2 * PAIRS < sum(ours) < 0.8 * PAIRS


def test_depth_of_polygons_is_that_of_the_minkowski_difference(
    polygon_pairs: list[tuple[Placed, Placed]],
) -> None:
    """The least overlap along an axis is the origin's way out of the Minkowski difference."""
    worst = 0.0
    for a, b in polygon_pairs[:5_000]:
        found = mtv(in_world(a), in_world(b))
        if found is not None:
            worst = max(worst, abs(found[1] - signed_depth(a, b)))
    assert worst < DEPTH


def test_contact_of_polygons_is_pymunk_s(polygon_pairs: list[tuple[Placed, Placed]]) -> None:
    """Normal, number of points, places and penetrations are pymunk's; the deepest is the depth."""
    contained = 0
    for a, b in polygon_pairs[:10_000]:
        contact, expected = collide(*a, *b), pymunk_contact(a, b)
        if contact is None or expected is None:
            assert contact is expected is None
            continue
        np.testing.assert_allclose(contact.normal, expected[0], atol=DEPTH)
        assert len(contact.points) == len(expected[1])
        assert compare_points(contact, expected[1]) < DEPTH
        translation = mtv(in_world(a), in_world(b))
        assert translation is not None
        assert max(contact.penetrations) == pytest.approx(translation[1], abs=DEPTH)
        contained += translation[1] > min(a[0].min_width, b[0].min_width)
    assert contained > 500


def test_moving_by_the_translation_separates_for_shapely(
    polygon_pairs: list[tuple[Placed, Placed]],
) -> None:
    """Moved by the depth and a hair the polygons are disjoint; by a hair less they are not."""
    for a, b in polygon_pairs[:5_000]:
        corners_a, corners_b = in_world(a), in_world(b)
        found = mtv(corners_a, corners_b)
        if found is not None and found[1] > 2 * MARGIN:
            normal, depth = found
            for way, touches in ((depth + MARGIN, False), (depth - MARGIN, True)):
                there = shapely.Polygon(corners_b + way * normal)
                assert shapely.intersects(shapely.Polygon(corners_a), there) == touches


@pytest.mark.parametrize(("kind_a", "kind_b"), list(itertools.product(RANDOM, RANDOM))[1:])
def test_contact_of_any_two_kinds_is_pymunk_s(kind_a: str, kind_b: str) -> None:
    """Circles, polygons, thin and thick segments, in both orders: pymunk's contacts."""
    for a, b in random_pairs(kind_a, kind_b, 500):
        contact, expected = collide(*a, *b), pymunk_contact(a, b)
        assert (contact is None) == (expected is None)
        if contact is not None and expected is not None:
            np.testing.assert_allclose(contact.normal, expected[0], atol=NORMAL)
            assert len(contact.points) == len(expected[1])
            assert compare_points(contact, expected[1]) < NORMAL


@pytest.mark.parametrize(
    ("kind_a", "kind_b"), list(itertools.combinations_with_replacement(RANDOM, 2))
)
def test_depth_of_any_two_kinds_is_that_of_the_minkowski_difference(
    kind_a: str, kind_b: str
) -> None:
    """With rounding added the depth is still the shortest way out; apart, there is no contact."""
    for a, b in random_pairs(kind_a, kind_b, 300):
        depth, contact = signed_depth(a, b), collide(*a, *b)
        if contact is None:
            assert depth < DEPTH
        else:
            assert max(contact.penetrations) == pytest.approx(depth, abs=DEPTH)


def test_circle_centre_inside_a_polygon_leaves_as_in_pymunk() -> None:
    """1,000 circles whose centres are inside: the same side, the depth r + d."""
    inside = 0
    for polygon, (circle, _) in random_pairs("polygon", "circle", 1_000):
        weights = np.random.default_rng(inside).dirichlet(np.ones(len(polygon[0].outline)))
        centre = weights @ in_world(polygon)
        ball: Placed = (circle, (*centre.tolist(), 0.0))
        contact, expected = collide(*polygon, *ball), pymunk_contact(polygon, ball)
        assert contact is not None
        assert expected is not None
        np.testing.assert_allclose(contact.normal, expected[0], atol=NORMAL)
        boundary = shapely.Polygon(in_world(polygon)).exterior.distance(shapely.Point(centre))
        assert contact.penetrations == pytest.approx([circle.radius + boundary], abs=DEPTH)
        assert contact.penetrations == pytest.approx(expected[1][:, 4], abs=DEPTH)
        inside += 1
    assert inside == 1_000
