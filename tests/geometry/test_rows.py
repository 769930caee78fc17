"""Rows: how a shape is laid into the tables, and how its outline turns with it."""

from __future__ import annotations

import math

import pytest

from lesson_code.geometry import Circle, Polygon, Segment
from lesson_code.geometry.rows import Corner, corner_rows, following, place, turn

ROUNDING = 1e-15
"""Two products of numbers up to 2 and their sum."""


def test_corner_rows_box_has_outward_normals() -> None:
    """Each corner carries the edge that begins there, counter-clockwise from the first."""
    rows = corner_rows(Polygon.box(4, 2).outline)
    assert [(c.x, c.y) for c in rows] == [(-2, -1), (2, -1), (2, 1), (-2, 1)]
    assert [(c.nx, c.ny) for c in rows] == [(0, -1), (1, 0), (0, 1), (-1, 0)]


def test_corner_rows_segment_has_two_opposite_normals() -> None:
    """A segment is an outline that goes there and back; its left side comes first."""
    rows = corner_rows(Segment((0, 0), (3, 0)).outline)
    assert [(c.x, c.y) for c in rows] == [(3, 0), (0, 0)]
    assert [(c.nx, c.ny) for c in rows] == [(0, 1), (0, -1)]


def test_place_several_shapes_fills_one_table() -> None:
    """Outlines stand one after the other; a circle has none."""
    corners: list[Corner] = []
    shapes = [Polygon.box(1, 1), Circle(0.5), Segment((0, 0), (1, 0), 0.25)]
    bodies = [place(s.outline, s.rounding, (0.0, 0.0, 0.0), corners) for s in shapes]
    assert [(b.first_corner, b.corner_count, b.radius) for b in bodies] == [
        (0, 4, 0.0),
        (4, 0, 0.5),
        (4, 2, 0.25),
    ]
    assert len(corners) == 6


def test_turn_quarter_turns_corners_and_normals() -> None:
    """By +90 degrees (x, y) goes to (-y, x); positions are not added."""
    corners: list[Corner] = []
    place(Polygon.box(4, 2).outline, 0.0, (100.0, 200.0, math.pi / 2), corners)
    assert (corners[0].x, corners[0].y) == pytest.approx((1, -2), abs=ROUNDING)
    assert (corners[0].nx, corners[0].ny) == pytest.approx((1, 0), abs=ROUNDING)


def test_turn_starts_from_the_unturned_outline_every_time() -> None:
    """A million turns would not wear an outline down: turned twice is turned once."""
    corners: list[Corner] = []
    body = place(Polygon.regular(5, 1.0).outline, 0.0, (0.0, 0.0, 0.7), corners)
    once = [(c.x, c.y, c.nx, c.ny) for c in corners]
    turn(corners, body)
    assert [(c.x, c.y, c.nx, c.ny) for c in corners] == once


def test_following_goes_round_its_own_body() -> None:
    """After the last corner of a body comes its first, not the next body's."""
    corners: list[Corner] = []
    place(Polygon.box(1, 1).outline, 0.0, (0.0, 0.0, 0.0), corners)
    triangle = place(Polygon.regular(3, 1.0).outline, 0.0, (0.0, 0.0, 0.0), corners)
    assert [following(triangle, k) for k in (4, 5, 6)] == [5, 6, 4]
