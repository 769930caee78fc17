"""Shapes: what they are made of, their areas, inertias and sizes, and what they refuse."""

from __future__ import annotations

import math
from dataclasses import FrozenInstanceError
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.geometry import Circle, Polygon, Segment, Shape

ROUNDING = 1e-14
"""A dozen roundings of numbers of size 1 to 10."""

QUADRATURE = 1e-12
"""Gauss-Legendre with 60 nodes integrates a smooth function to rounding."""

size = st.floats(0.01, 100)
TRIANGLE = [(0, 0), (6, 0), (0, 3)]


def test_polygon_is_seen_from_its_centroid() -> None:
    """A triangle's centroid is a third of the sum of its corners: here (2, 1)."""
    assert Polygon(TRIANGLE).vertices == ((-2.0, -1.0), (4.0, -1.0), (-2.0, 2.0))


@pytest.mark.parametrize("shift", [(0, 0), (5, -3), (1024, 4096)])
@pytest.mark.parametrize("order", [1, -1], ids=["counter-clockwise", "clockwise"])
def test_polygon_origin_and_order_do_not_matter(shift: tuple[int, int], order: int) -> None:
    """Where the origin lies and which way round the corners go makes no difference."""
    moved = [(x + shift[0], y + shift[1]) for x, y in TRIANGLE]
    assert set(Polygon(moved[::order]).vertices) == set(Polygon(TRIANGLE).vertices)


@given(
    st.lists(st.floats(-math.pi, math.pi), min_size=3, max_size=8, unique=True), st.floats(-9, 9)
)
def test_polygon_of_a_polygon_is_the_same(angles: list[float], x: float) -> None:
    """A centred outline is left as it is, to the last bit."""
    angles = sorted(angles)
    gaps = np.diff([*angles, angles[0] + 2 * math.pi])
    if gaps.min() > 0.01 and gaps.max() < 3:
        polygon = Polygon([(x + 2 * math.cos(a), math.sin(a)) for a in angles])
        assert Polygon(polygon.vertices) == polygon


def test_polygon_redundant_vertex_is_left_out() -> None:
    """A vertex in the middle of an edge makes no second axis and no second feature."""
    assert Polygon([(0, 0), (3, 0), (6, 0), (0, 3)]) == Polygon(TRIANGLE)


def test_polygon_vertices_of_the_caller_are_not_changed() -> None:
    """Inputs are never changed in place."""
    given_vertices = np.array(TRIANGLE, dtype=float)
    Polygon(given_vertices)
    np.testing.assert_array_equal(given_vertices, TRIANGLE)


def test_box_is_exactly_symmetric() -> None:
    """The centroid of 0.1 by 0.3 comes out as 1e-17; the corners are not moved by that."""
    assert Polygon.box(0.1, 0.3).vertices == (
        (-0.05, -0.15),
        (0.05, -0.15),
        (0.05, 0.15),
        (-0.05, 0.15),
    )


@pytest.mark.parametrize("sides", [3, 4, 5, 6, 17])
def test_regular_polygon_is_as_closed_forms_say(sides: int) -> None:
    """Area n/2 r^2 sin 2a, inertia r^2 (2 + cos 2a)/6, corners all at r; a = pi / n."""
    polygon, a = Polygon.regular(sides, 2.0), math.pi / sides
    assert polygon.area == pytest.approx(sides / 2 * 4 * math.sin(2 * a), abs=ROUNDING)
    assert polygon.inertia_per_mass == pytest.approx(4 * (2 + math.cos(2 * a)) / 6, abs=ROUNDING)
    assert [math.hypot(*v) for v in polygon.vertices] == pytest.approx([2.0] * sides, abs=ROUNDING)
    assert polygon.vertices[0] == pytest.approx((2.0, 0.0), abs=ROUNDING)


@given(width=size, height=size)
def test_box_inertia_is_a_twelfth_of_the_squares(width: float, height: float) -> None:
    """I/m = (w^2 + h^2)/12, area w h, smallest width the shorter side, reach the half diagonal."""
    box = Polygon.box(width, height)
    assert box.inertia_per_mass == pytest.approx((width**2 + height**2) / 12, rel=ROUNDING)
    assert box.area == pytest.approx(width * height, rel=ROUNDING)
    assert box.min_width == pytest.approx(min(width, height), rel=ROUNDING)
    assert box.bounding_radius == pytest.approx(math.hypot(width, height) / 2, rel=ROUNDING)


@pytest.mark.parametrize(
    ("polygon", "min_width"),
    [
        pytest.param(Polygon.regular(3, 1.0), 1.5, id="triangle: its height"),
        pytest.param(Polygon.regular(6, 1.0), math.sqrt(3), id="hexagon: across the flats"),
        pytest.param(Polygon([(0, 0), (3, 0), (0, 4)]), 2.4, id="3-4-5: its shortest height"),
    ],
)
def test_extent_of_a_polygon_is_its_smallest_width(polygon: Polygon, min_width: float) -> None:
    """The width is smallest with one edge against a wall."""
    assert polygon.min_width == pytest.approx(min_width, abs=ROUNDING)


def test_circle_is_as_closed_forms_say() -> None:
    """Area pi r^2, inertia r^2 / 2, diameter and radius."""
    circle = Circle(2)
    assert circle.area == pytest.approx(4 * math.pi, abs=ROUNDING)
    assert (circle.inertia_per_mass, circle.min_width, circle.bounding_radius) == (2.0, 4.0, 2.0)


def test_thin_segment_is_a_rod() -> None:
    """No area, L^2 / 12 about the middle; its ends stay where they were given."""
    rod = Segment((1, 2), (4, 6))
    assert (rod.area, rod.length, rod.centroid) == (0.0, 5.0, (2.5, 4.0))
    assert rod.inertia_per_mass == pytest.approx(25 / 12, abs=ROUNDING)
    assert (rod.min_width, rod.bounding_radius) == (5.0, math.hypot(4, 6))


@given(length=st.floats(0.01, 10), radius=st.floats(0.01, 10))
def test_thick_segment_inertia_is_the_integral(length: float, radius: float) -> None:
    """Area and inertia are those of the capsule, cut into strips and added up.

    The strip at the height y = r sin a has the half length h = L/2 + r cos a and adds
    2 (h^3/3 + y^2 h) dy to the second moment.
    """
    nodes, weights = np.polynomial.legendre.leggauss(60)
    a = nodes * math.pi / 2
    y, h = radius * np.sin(a), length / 2 + radius * np.cos(a)
    dy = weights * math.pi / 2 * radius * np.cos(a)
    area, second = np.sum(2 * h * dy), np.sum(2 * (h**3 / 3 + y**2 * h) * dy)
    capsule = Segment((-length / 2, 0), (length / 2, 0), radius)
    assert capsule.area == pytest.approx(area, rel=QUADRATURE)
    assert capsule.inertia_per_mass == pytest.approx(second / area, rel=QUADRATURE)


def test_thick_segment_reaches_beyond_its_ends() -> None:
    """Half the thickness is added on all sides; the thickness is the smallest width."""
    capsule = Segment((-3, 0), (0, 4), 0.5)
    assert (capsule.min_width, capsule.bounding_radius, capsule.rounding) == (1.0, 4.5, 0.5)


@pytest.mark.parametrize("shape", [Circle(1), Polygon.box(1, 2), Segment((0, 0), (1, 0))])
def test_shape_is_frozen_and_compared_by_value(shape: Shape) -> None:
    """A shape never changes; equal shapes are interchangeable, also as keys."""
    with pytest.raises(FrozenInstanceError):
        shape.radius = 2.0  # type: ignore[misc, union-attr]
    assert {shape: 1}[shape] == 1


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Circle(0), "radius must be > 0 and finite, got 0"),
        (lambda: Circle(-1), "radius must be > 0 and finite, got -1"),
        (lambda: Circle(math.nan), "radius must be > 0 and finite, got nan"),
        (lambda: Circle(math.inf), "radius must be > 0 and finite, got inf"),
        (lambda: Circle([1, 2]), r"radius must be one number, got shape \(2,\)"),  # type: ignore[arg-type]
        (lambda: Polygon([(0, 0), (4, 0), (1, 1), (0, 4)]), "vertices must be convex"),
        (lambda: Polygon.box(0, 1), "width must be > 0 and finite, got 0"),
        (lambda: Polygon.box(1, -1), "height must be > 0 and finite, got -1"),
        (lambda: Polygon.regular(2, 1), "sides must be a whole number >= 3, got 2"),
        (lambda: Polygon.regular(3.5, 1), "sides must be a whole number >= 3, got 3.5"),  # type: ignore[arg-type]
        (lambda: Polygon.regular(3, 0), "radius must be > 0 and finite, got 0"),
        (lambda: Segment((1, 2), (1, 2)), r"start and end must differ.*\[1.0, 2.0\] twice"),
        (lambda: Segment((1, 2), (1, math.nan)), "end must be finite, got nan"),
        (lambda: Segment((1, 2), (3, 4), -0.1), "radius must be >= 0 and finite, got -0.1"),
    ],
)
def test_shape_bad_input_is_refused_by_name(make: Any, message: str) -> None:
    """A shape that cannot be is a ValueError with argument, rule and value."""
    with pytest.raises(ValueError, match=message):
        make()
