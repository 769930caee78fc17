"""Whether shapes that touch come nearer: resting, sliding, tilting and rolling bodies."""

from __future__ import annotations

import math

import pytest

from lesson_code.geometry import Circle, Polygon, Segment, Shape
from lesson_code.geometry.advancement import Moving, pose_at
from lesson_code.geometry.closing import fastest_rise, is_closing
from lesson_code.geometry.rows import Corner, corner_rows
from lesson_code.geometry.safe_time import motion_of
from lesson_code.geometry.separation import separation_rows

TOUCHING = 1e-12
"""m: gaps within this are equal."""

BOX = Polygon.box(2, 2)
FLOOR = Segment((-9, 0), (9, 0))
SHELF = Segment((-9, 0), (0.5, 0))
DISC = Circle(1)
STANDING = math.pi / 4, math.sqrt(2)
"""A box on its corner: angle, and height of its middle."""

State = tuple[float, float, float]


def closing(
    shape_a: Shape, pose_a: State, move_a: State, shape_b: Shape, pose_b: State, move_b: State
) -> bool:
    """Return whether two shapes come nearer."""
    corners: list[Corner] = []
    rows = []
    for shape, pose, velocity in ((shape_a, pose_a, move_a), (shape_b, pose_b, move_b)):
        first = len(corners)
        corners += corner_rows(shape.outline)
        rows.append(Moving(*pose, *velocity, shape.rounding, first, len(shape.outline)))
    a, b = rows
    at, motion = pose_at(a, b, 0.0), motion_of(corners, a, b)
    gap, nx, ny = separation_rows(corners, a, b, at)
    return is_closing(corners, a, b, at, motion, gap, nx, ny, TOUCHING)


@pytest.mark.parametrize(
    ("support", "shape", "pose", "velocity", "expected"),
    [
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, -1, 0), True, id="falling"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, 1, 0), False, id="lifting"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, 0, 0), False, id="resting"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (3, 0, 0), False, id="sliding"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (3, -1e-15, 0), False, id="sliding, but for rounding"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, 0, 1), True, id="turning into the floor"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, 0.9, 1), True, id="lifting, one corner sinks"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (0, 1.1, 1), False, id="lifting, no corner sinks"),
        pytest.param(FLOOR, BOX, (0, 1, 0), (1, 1, 1), False, id="tilting about a corner"),
        pytest.param(SHELF, BOX, (0, 1, 0), (0, 0.6, -1), False, id="beyond the edge it sinks"),
        pytest.param(SHELF, BOX, (0, 1, 0), (0, 0.4, -1), True, id="at the edge it sinks"),
        pytest.param(FLOOR, BOX, (0, STANDING[1], STANDING[0]), (0, 0, 1), False, id="on a tip"),
        pytest.param(FLOOR, BOX, (0, 0.9, 0), (0, -1, 0), True, id="overlapping, sinking"),
        pytest.param(FLOOR, BOX, (0, 0.9, 0), (0, 1, 0), False, id="overlapping, leaving"),
        pytest.param(FLOOR, DISC, (0, 1, 0), (1, 0, -1), False, id="disc, rolling"),
        pytest.param(FLOOR, DISC, (0, 1, 0), (0, -1e-9, 9), True, id="disc, sinking slowly"),
        pytest.param(BOX, BOX, (2, 2, 0), (-1, 1, 0), False, id="corners touch, sliding by"),
        pytest.param(BOX, BOX, (2, 2, 0), (-1, -1, 0), True, id="corners touch, meeting"),
        pytest.param(DISC, DISC, (0, 0, 0), (1, 0, 0), False, id="coincident, along the normal"),
        pytest.param(DISC, DISC, (0, 0, 0), (-1, 0, 0), True, id="coincident, against it"),
    ],
)
def test_closing_hand_worked(
    support: Shape, shape: Shape, pose: State, velocity: State, expected: bool
) -> None:
    """By the speeds of the points that touch, in either order of the bodies."""
    still = (0.0, 0.0, 0.0)
    assert closing(support, still, still, shape, pose, velocity) == expected
    if pose[:2] != (0, 0):  # A and B exchanged; for coincident circles the normal stays (1, 0)
        assert closing(shape, pose, velocity, support, still, still) == expected


def test_fastest_rise_counts_the_leading_corners_only() -> None:
    """Of a level rod that turns, the right end rises; of a tilted one only the high end counts."""
    rod = Moving(first_corner=0, corner_count=2)
    level, tilted = corner_rows([(1.0, 0.0), (-1.0, 0.0)]), corner_rows([(1.0, 0.0), (-1.0, 0.1)])
    assert fastest_rise(level, rod, 0.0, 1.0, 2.0, TOUCHING) == 2.0
    assert fastest_rise(tilted, rod, 0.0, 1.0, 2.0, TOUCHING) == -2.0
    assert fastest_rise([], Moving(), 0.0, 1.0, 2.0, TOUCHING) == 0.0
