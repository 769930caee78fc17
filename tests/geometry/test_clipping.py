"""Polygons and segments against each other: no, one or two points, and their names."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from lesson_code.geometry import Manifold, Polygon, Segment, Shape, collide
from lesson_code.geometry.clipping import keep_overlapping, point_at
from lesson_code.geometry.rows import Corner, ManifoldRow, place
from lesson_code.geometry.sat import minimum_translation

ROUNDING = 1e-14
"""A dozen roundings of numbers of size 1 to 10."""

GAP = 1e-9
"""m: a gap or an overlap that is small, but a million times the rounding."""

BOX = Polygon.box(2, 2)
PLATFORM = Polygon.box(8, 2)
LINE = Segment((-4, 0), (4, 0))
CAPSULE = Segment((-1, 0), (1, 0), 0.5)


def by_place(contact: Manifold | None) -> list[list[float]]:
    """Return the points of a contact as (x, y, penetration), sorted along x."""
    assert contact is not None
    return sorted(
        [*p, d] for p, d in zip(contact.points.tolist(), contact.penetrations, strict=True)
    )


CASES = {
    "flat, side by side": (
        BOX,
        (0, 0, 0),
        BOX,
        (1, 1.75, 0),
        (0, 1),
        [(0, 0.875, 0.25), (1, 0.875, 0.25)],
    ),
    "flat on a platform": (
        PLATFORM,
        (0, -1, 0),
        BOX,
        (1, 0.75, 0),
        (0, 1),
        [(0, -0.125, 0.25), (2, -0.125, 0.25)],
    ),
    "overhanging it": (
        PLATFORM,
        (0, -1, 0),
        BOX,
        (4, 0.75, 0),
        (0, 1),
        [(3, -0.125, 0.25), (4, -0.125, 0.25)],
    ),
    "on its corner": (
        PLATFORM,
        (0, -1, 0),
        BOX,
        (1, math.sqrt(2) - 0.25, math.pi / 4),
        (0, 1),
        [(1, -0.125, 0.25)],
    ),
    "platform on a corner": (
        PLATFORM,
        (0, 1, 0),
        BOX,
        (1, 0.25 - math.sqrt(2), math.pi / 4),
        (0, -1),
        [(1, 0.125, 0.25)],
    ),
    "box on a line": (
        LINE,
        (0, 0, 0),
        BOX,
        (1, 0.75, 0),
        (0, 1),
        [(0, -0.125, 0.25), (2, -0.125, 0.25)],
    ),
    "box below a line": (
        LINE,
        (0, 0, 0),
        BOX,
        (1, -0.75, 0),
        (0, -1),
        [(0, 0.125, 0.25), (2, 0.125, 0.25)],
    ),
    "line turned over": (
        LINE,
        (0, 0, math.pi),
        BOX,
        (1, 0.75, 0),
        (0, 1),
        [(0, -0.125, 0.25), (2, -0.125, 0.25)],
    ),
    "line's end in a box": (LINE, (0, 0, 0), BOX, (4.75, 0.5, 0), (1, 0), [(3.875, 0, 0.25)]),
    "lines that cross": (
        LINE,
        (0, 0, 0),
        Segment((1, -3), (1, 0.5)),
        (0, 0, 0),
        (0, -1),
        [(1, 0.25, 0.5)],
    ),
    "box on a thick line": (
        Segment((-4, 0), (4, 0), 0.5),
        (0, 0, 0),
        BOX,
        (1, 1.25, 0),
        (0, 1),
        [(0, 0.375, 0.25), (2, 0.375, 0.25)],
    ),
    "overhanging a thick line": (
        Segment((-4, 0), (4, 0), 0.5),
        (0, 0, 0),
        BOX,
        (4.5, 1.25, 0),
        (0, 1),
        [(3.5, 0.375, 0.25), (4, 0.375, 0.25)],
    ),
    "box deep in a thick line": (
        Segment((-4, 0), (4, 0), 0.5),
        (0, 0, 0),
        BOX,
        (1, 0.75, 0),
        (0, 1),
        [(0, 0.125, 0.75), (2, 0.125, 0.75)],
    ),
    "capsules end to end": (CAPSULE, (0, 0, 0), CAPSULE, (2.75, 0, 0), (1, 0), [(1.375, 0, 0.25)]),
    "capsules side by side": (
        CAPSULE,
        (0, 0, 0),
        CAPSULE,
        (1, 0.75, 0),
        (0, 1),
        [(0, 0.375, 0.25), (1, 0.375, 0.25)],
    ),
    "capsules corner to corner": (
        CAPSULE,
        (0, 0, 0),
        CAPSULE,
        (2.45, 0.6, 0),
        (0.6, 0.8),
        [(1.225, 0.3, 0.25)],
    ),
    "capsules crossed like a T": (
        CAPSULE,
        (0, 0, 0),
        CAPSULE,
        (0.5, 1.75, math.pi / 2),
        (0, 1),
        [(0.5, 0.375, 0.25)],
    ),
    "capsule's end at a box's corner": (
        BOX,
        (0, 0, 0),
        CAPSULE,
        (1 + 0.24 + 1, 1 + 0.32, 0),
        (0.6, 0.8),
        [(0.97, 0.96, 0.1)],
    ),
}
"""Two shapes and their poses; normal; points as (x, y, penetration). Each from a sketch."""


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_contact_hand_worked(case: Any) -> None:
    """Normal, points midway between the surfaces, and penetrations, read off a sketch."""
    shape_a, pose_a, shape_b, pose_b, normal, points = case
    contact = collide(shape_a, pose_a, shape_b, pose_b)
    assert contact is not None
    assert contact.normal == pytest.approx(normal, abs=ROUNDING)
    np.testing.assert_allclose(by_place(contact), points, atol=ROUNDING)


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_contact_swapped_is_the_same_seen_from_the_other_side(case: Any) -> None:
    """A and B swapped: the opposite normal, the same points and penetrations."""
    shape_a, pose_a, shape_b, pose_b, normal, points = case
    contact = collide(shape_b, pose_b, shape_a, pose_a)
    assert contact is not None
    assert contact.normal == pytest.approx((-normal[0], -normal[1]), abs=ROUNDING)
    np.testing.assert_allclose(by_place(contact), points, atol=ROUNDING)


@pytest.mark.parametrize(
    ("gap", "hit"), [(0, False), (GAP, False), (-GAP, True)], ids=["touch", "apart", "overlap"]
)
@pytest.mark.parametrize(
    ("shape_a", "shape_b", "pose_b", "away"),
    [
        pytest.param(BOX, BOX, (0.5, 2, 0), (0, 1), id="side to side"),
        pytest.param(LINE, BOX, (0, 1, 0), (0, 1), id="box on a line"),
        pytest.param(CAPSULE, BOX, (0, 1.5, 0), (0, 1), id="box on a thick line"),
        pytest.param(CAPSULE, CAPSULE, (0.25, 1, 0), (0, 1), id="side by side"),
        pytest.param(CAPSULE, CAPSULE, (3, 0, 0), (1, 0), id="end to end"),
        pytest.param(CAPSULE, CAPSULE, (2.6, 0.8, 0), (0.6, 0.8), id="corner to corner"),
        pytest.param(BOX, CAPSULE, (2.3, 1.4, 0), (0.6, 0.8), id="end at a corner"),
    ],
)
def test_contact_near_miss_is_decided(
    shape_a: Shape, shape_b: Shape, pose_b: Any, away: Any, gap: float, hit: bool
) -> None:
    """Touching is no contact, nor is a nanometre of gap; a nanometre of overlap is one."""
    moved = (pose_b[0] + gap * away[0], pose_b[1] + gap * away[1], pose_b[2])
    contact = collide(shape_a, (0, 0, 0), shape_b, moved)
    if (
        gap == 0 and contact is not None
    ):  # places such as 2.6 are rounded, so that touch is not exact
        assert max(contact.penetrations) < ROUNDING
    else:
        assert (contact is not None) == hit
    if hit:
        assert contact is not None
        assert max(contact.penetrations) == pytest.approx(GAP, abs=ROUNDING)


@pytest.mark.parametrize(
    "other",
    [
        pytest.param(Segment((4, 0), (9, 0)), id="end to end"),
        pytest.param(Segment((7, 0), (9, 0)), id="apart on one line"),
        pytest.param(Segment((-1, 1), (2, 1)), id="parallel"),
    ],
)
def test_thin_lines_that_do_not_cross_have_no_contact(other: Segment) -> None:
    """Lines without thickness overlap only where they cross."""
    assert collide(LINE, (0, 0, 0), other, (0, 0, 0)) is None
    assert collide(LINE, (0, 0, 1e-16), other, (0, 0, 0)) is None


@pytest.mark.parametrize("gap", [1e-9, 0.5, 3.0])
def test_thin_lines_one_after_the_other_have_no_contact(gap: float) -> None:
    """In a hundred directions rounding lifts one line over the other; a gap is a gap."""
    for angle in np.linspace(-3, 3, 100):
        there = ((8 + gap) * math.cos(angle), (8 + gap) * math.sin(angle), angle)
        assert collide(LINE, (0, 0, angle), LINE, there) is None


def test_thin_lines_on_each_other_have_no_contact() -> None:
    """They share a stretch but not an area; no penetration is greater than zero."""
    assert collide(LINE, (0, 0, 0), Segment((-1, 0), (2, 0)), (0, 0, 0)) is None
    assert collide(LINE, (0, 0, 0), LINE, (0, 0, 0)) is None


@pytest.mark.parametrize("tilt", [0.05, -0.05])
def test_contact_tilted_box_is_deeper_at_its_lower_corner(tilt: float) -> None:
    """Both lower corners are in the floor, at the depths of the rotated corners (+-1, -1)."""
    contact = collide(PLATFORM, (0, -1, 0), BOX, (0, 0.9, tilt))
    corners = [
        (x * math.cos(tilt) + math.sin(tilt), x * math.sin(tilt) - math.cos(tilt)) for x in (-1, 1)
    ]
    expected = [(x, (0.9 + y) / 2, -0.9 - y) for x, y in corners]
    assert contact is not None
    np.testing.assert_allclose(by_place(contact), expected, atol=ROUNDING)


def test_contact_of_a_box_that_lies_flat_but_for_rounding_has_the_normal_of_the_floor() -> None:
    """The direction of a gap that is a rounding error says nothing: it points anywhere."""
    rng = np.random.default_rng(20)
    for _ in range(2000):
        length, size = 10 ** rng.uniform(0, 3), 10 ** rng.uniform(-2, 0)
        tilt, lift = rng.choice([-1, 1], 2) * 10 ** rng.uniform(-16, -11, 2)
        floor = Segment((-length, 0), (length, 0), radius=size / 1000)
        place = (rng.uniform(-0.5, 0.5) * length, size / 2 + lift, tilt)
        contact = collide(floor, (0, 0, 0), Polygon.box(size, size), place)
        assert contact is not None
        assert abs(contact.normal[0]) <= 2 * abs(tilt)  # the floor's or the box's own
        assert contact.penetrations == pytest.approx(size / 1000, abs=1e-10)


def test_contact_deepest_point_has_the_depth_of_the_overlap() -> None:
    """A corner 0.19 m through a side: cutting the edges does not change the depth."""
    contact = collide(BOX, (0, 0, 0), BOX, (2.2, 0, 0.6))
    low = min(2.2 + x * math.cos(0.6) - y * math.sin(0.6) for x in (-1, 1) for y in (-1, 1))
    assert contact is not None
    assert contact.normal.tolist() == [1, 0]
    assert contact.penetrations == pytest.approx([1 - low], abs=ROUNDING)


# Names of points


def test_features_of_two_points_differ() -> None:
    """Each point has a name of its own."""
    contact = collide(PLATFORM, (0, -1, 0), BOX, (0, 0.9, 0))
    assert contact is not None
    assert len(set(contact.features)) == 2


@pytest.mark.parametrize("other", [BOX, LINE, CAPSULE], ids=["box", "line", "capsule"])
def test_features_stay_while_a_box_slides_and_rocks(other: Shape) -> None:
    """The name goes with the corner, whichever body's edge rounding or rocking makes the better."""
    top = {BOX: 1.0, LINE: 0.0, CAPSULE: 0.5}[other]
    names = []
    for k, tilt in enumerate([0.0, 1e-16, -1e-16, 1e-9, -1e-9, 0.003, -0.003]):
        contact = collide(other, (0, 0, -tilt), BOX, (0.01 * k, top + 0.99, tilt))
        assert contact is not None
        order = np.argsort(contact.points[:, 0])
        names.append([contact.features[i] for i in order])
    assert names == [names[0]] * len(names)
    assert len(names[0]) == 2


def test_features_change_when_other_edges_meet() -> None:
    """A box turned by a right angle stands on another side: an old impulse is not its own."""
    names = [collide(PLATFORM, (0, -1, 0), BOX, (0, 0.9, k * math.pi / 2)) for k in range(4)]
    assert len({contact.features for contact in names if contact is not None}) == 4


def test_equal_faces_count_as_those_of_the_first_body() -> None:
    """Flat on each other, turned anyhow, rounding does not decide whose normal it is."""
    for angle, k in itertools.product(np.linspace(-3, 3, 50), (0.0, math.pi / 2, math.pi)):
        c, s = math.cos(angle), math.sin(angle)
        corners: list[Corner] = []
        a = place(BOX.outline, 0.0, (0.0, 0.0, angle), corners)
        b = place(BOX.outline, 0.0, (0.3 * c - 1.9 * s, 0.3 * s + 1.9 * c, angle + k), corners)
        overlap, nx, ny, edge, is_of_a = minimum_translation(corners, a, b)
        assert is_of_a
        assert edge == 2  # the top
        assert (overlap, nx, ny) == pytest.approx((0.1, -s, c), abs=ROUNDING)


# Points that rounding would move or take away


@pytest.mark.parametrize(
    ("s", "point"), [(-1, (2, 5)), (0, (2, 5)), (0.5, (3, 4.5)), (1, (4, 4)), (9, (4, 4))]
)
def test_point_beyond_an_edge_is_its_end(s: float, point: tuple[float, float]) -> None:
    """However little an edge extends along the tangent, no point is sought outside it."""
    assert point_at(s, Corner(x=2, y=5), 0.0, Corner(x=4, y=4), 1.0) == point


@pytest.mark.parametrize(
    ("penetrations", "count", "kept"),
    [
        pytest.param((0.25, 0.5), 2, [(0.25, 1), (0.5, 2)], id="both overlap"),
        pytest.param((0.25, -0.5), 2, [(0.25, 1)], id="first overlaps"),
        pytest.param((-0.25, 0.5), 2, [(0.5, 2)], id="second overlaps"),
        pytest.param((0.25, 0.5), 1, [(0.5, 2)], id="one place: the deeper"),
        pytest.param((0.0, -1e-17), 2, [(1e-17, 1)], id="both lost in rounding: the depth"),
    ],
)
def test_overlapping_points_are_kept(
    penetrations: tuple[float, float], count: int, kept: list[tuple[float, int]]
) -> None:
    """At least one point is kept of shapes that overlap, and always with penetration > 0."""
    m = ManifoldRow(count=count, feature0=1, feature1=2)
    m.penetration0, m.penetration1 = penetrations
    keep_overlapping(m, 1e-17)
    points = [(m.penetration0, m.feature0), (m.penetration1, m.feature1)]
    assert points[: m.count] == kept
