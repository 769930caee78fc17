"""The distance of two outlines: faces, corners, ends, overlap; at any angle without a table."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Circle, Polygon, Segment, Shape, collide
from lesson_code.geometry.rows import Corner, Placed, place
from lesson_code.geometry.separation import (
    RelativePose,
    best_face,
    farthest,
    seen_from_b,
    seen_turned,
    separation_rows,
    shortest_to_edge,
)

FEW_ROUNDINGS = 1e-14
"""Of lengths of size 1 to 10: some dozen operations, rounded to 1e-16 each."""

Pose = tuple[float, float, float]

BOX = Polygon.box(2, 2)
LINE = Segment((-1, 0), (1, 0))
PLANK = Segment((-1, 0), (1, 0), 0.5)
DISC = Circle(0.5)


def rows(
    shape_a: Shape, pose_a: Pose, shape_b: Shape, pose_b: Pose
) -> tuple[list[Corner], Placed, Placed, RelativePose]:
    """Return two shapes as rows whose table is not turned, and where they are."""
    corners: list[Corner] = []
    a = place(shape_a.outline, shape_a.rounding, (0.0, 0.0, 0.0), corners)
    b = place(shape_b.outline, shape_b.rounding, (0.0, 0.0, 0.0), corners)
    turns = [f(pose[2]) for pose in (pose_a, pose_b) for f in (math.cos, math.sin)]
    return corners, a, b, RelativePose(pose_b[0] - pose_a[0], pose_b[1] - pose_a[1], *turns)


@pytest.mark.parametrize(
    ("shape_a", "shape_b", "pose_b", "distance", "normal"),
    [
        pytest.param(BOX, BOX, (5, 1.5, 0), 3, (1, 0), id="boxes, face to face"),
        pytest.param(BOX, BOX, (5, 6, 0), 5, (0.6, 0.8), id="boxes, corner to corner"),
        pytest.param(BOX, BOX, (1.5, 0, 0), -0.5, (1, 0), id="boxes, overlapping"),
        pytest.param(BOX, BOX, (2, 0.5, 0), 0, (1, 0), id="boxes, touching"),
        pytest.param(BOX, BOX, (4, 0, math.pi / 4), 3 - 2**0.5, (1, 0), id="boxes, face to corner"),
        pytest.param(BOX, DISC, (5, 6, 0), 6.403124237 - 0.5, None, id="box corner and disc"),
        pytest.param(BOX, DISC, (-3, 0.5, 0), 1.5, (-1, 0), id="box face and disc"),
        pytest.param(BOX, DISC, (0.5, 0, 0), -1, (1, 0), id="disc's centre in a box"),
        pytest.param(DISC, DISC, (3, 4, 0), 4, (0.6, 0.8), id="discs"),
        pytest.param(DISC, DISC, (0, 0, 0), -1, (1, 0), id="discs, coincident"),
        pytest.param(LINE, LINE, (5, 0, 0), 3, (1, 0), id="lines, end to end"),
        pytest.param(LINE, LINE, (5, 4, 0), 5, (0.6, 0.8), id="lines, parallel, apart along both"),
        pytest.param(LINE, LINE, (0, 3, math.pi / 2), 2, (0, 1), id="lines, end to side"),
        pytest.param(LINE, LINE, (0.5, 0, math.pi / 2), -0.5, (1, 0), id="lines, crossing"),
        pytest.param(PLANK, PLANK, (6, 3, 0), 4, (0.8, 0.6), id="planks, end to end"),
        pytest.param(PLANK, LINE, (0, 3, 0), 2.5, (0, 1), id="plank and line, parallel"),
        pytest.param(PLANK, DISC, (0, 0, 0), -1, (0, 1), id="disc on a plank's middle"),
    ],
)
def test_separation_hand_worked(
    shape_a: Shape,
    shape_b: Shape,
    pose_b: Pose,
    distance: float,
    normal: tuple[float, float] | None,
) -> None:
    """A at the origin, B where the distance is a whole number or a 3-4-5 triangle."""
    corners, a, b, at = rows(shape_a, (0, 0, 0), shape_b, pose_b)
    if normal is None:  # from the corner (1, 1) to (5, 6)
        distance, normal = math.hypot(4, 5) - 0.5, (4 / math.hypot(4, 5), 5 / math.hypot(4, 5))
    measured, nx, ny = separation_rows(corners, a, b, at)
    assert measured == pytest.approx(distance, abs=FEW_ROUNDINGS)
    assert (nx, ny) == pytest.approx(normal, abs=FEW_ROUNDINGS)


shapes = st.sampled_from([BOX, LINE, PLANK, DISC, Polygon.regular(5, 1.3), Segment((0, 0), (2, 1))])
poses = st.tuples(*[st.floats(-4, 4)] * 3)


@given(shapes, poses, shapes, poses)
def test_separation_swapped_is_the_same_along_the_opposite_normal(
    shape_a: Shape, pose_a: Pose, shape_b: Shape, pose_b: Pose
) -> None:
    """Which body is called A does not matter. Equally good faces may give another normal."""
    there = separation_rows(*rows(shape_a, pose_a, shape_b, pose_b))
    back = separation_rows(*rows(shape_b, pose_b, shape_a, pose_a))
    assert there[0] == pytest.approx(back[0], abs=FEW_ROUNDINGS)
    assert math.hypot(*there[1:]) == pytest.approx(1, abs=FEW_ROUNDINGS)


@given(shapes, poses, shapes, poses)
def test_separation_negative_is_minus_the_penetration(
    shape_a: Shape, pose_a: Pose, shape_b: Shape, pose_b: Pose
) -> None:
    """Its sign is that of the narrow phase, and its size that of the deepest contact."""
    distance, _, _ = separation_rows(*rows(shape_a, pose_a, shape_b, pose_b))
    contact = collide(shape_a, pose_a, shape_b, pose_b)
    if contact is None:
        assert distance > -FEW_ROUNDINGS
    else:
        assert max(contact.penetrations) == pytest.approx(-distance, abs=FEW_ROUNDINGS)


@given(shapes, poses, shapes, poses)
def test_separation_moving_by_it_makes_the_shapes_touch(
    shape_a: Shape, pose_a: Pose, shape_b: Shape, pose_b: Pose
) -> None:
    """B moved by the distance against the normal touches A, from in or out of it."""
    distance, nx, ny = separation_rows(*rows(shape_a, pose_a, shape_b, pose_b))
    moved = (pose_b[0] - distance * nx, pose_b[1] - distance * ny, pose_b[2])
    after, _, _ = separation_rows(*rows(shape_a, pose_a, shape_b, moved))
    assert after == pytest.approx(0, abs=FEW_ROUNDINGS)


def test_best_face_of_a_circle_is_none() -> None:
    """It has no faces, and no gap along them."""
    corners, a, b, at = rows(DISC, (0, 0, 0), BOX, (3, 0, 0))
    assert best_face(corners, a, b, at) == (-math.inf, -1)


def test_seen_from_b_twice_is_as_before() -> None:
    """Exchanging the bodies is its own inverse."""
    at = RelativePose(3.0, 1.0, 0.6, 0.8, 1.0, 0.0)
    assert seen_from_b(at) == (-3.0, -1.0, 1.0, 0.0, 0.6, 0.8)
    assert seen_from_b(seen_from_b(at)) == at


def test_farthest_corner_is_found_in_the_bodys_own_frame() -> None:
    """A box of 4 by 2, lying on its side, reaches 2 m up: its own x is up now."""
    corners, a, _, _ = rows(Polygon.box(4, 2), (0, 0, 0), DISC, (0, 0, 0))
    assert farthest(corners, a, *seen_turned(0.0, 1.0, 0.0, 1.0)) == 2.0


def test_shortest_to_edge_is_the_shorter_of_two() -> None:
    """To the edge from (0, 0) to (4, 0): from beyond its end, and from above."""
    edge = (0.0, 0.0, 4.0, 0.0)
    assert shortest_to_edge(7.0, 4.0, 1.0, 4.5, *edge) == (0.0, -4.5)
    assert shortest_to_edge(7.0, 4.0, 1.0, 5.5, *edge) == (-3.0, -4.0)
