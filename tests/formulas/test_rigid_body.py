import math
from fractions import Fraction

import numpy as np
import pytest
import shapely
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.formulas import (
    contact_velocity,
    disc_inertia,
    polygon_area,
    polygon_centroid,
    polygon_inertia,
)
from lesson_code.formulas.validation import equation

ROUNDING = 1e-13
"""Relative: some thirty products and sums, whose parts are up to 50 times the result."""

SHAPELY_ERROR = 1e-14
"""Of polygons of about 1 m: a few dozen roundings; measured: 1.1e-15."""

EXACT = 1e-15
"""Relative: one or two roundings. The corners are whole metres, which no distance rounds."""

lengths = st.floats(1e-2, 1e2)
components = st.floats(-100, 100, allow_subnormal=False)
points = st.tuples(components, components).map(np.array)
angles = st.floats(-math.pi, math.pi)

SQUARE = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float)
TRIANGLE = np.array([(0, -20), (20, 20), (-20, 20)], dtype=float)


@st.composite
def polygons(draw):
    """Return corners (N, 2) of a star around the origin: simple, but seldom convex."""
    count = draw(st.integers(3, 8))
    radii = np.array(draw(st.lists(st.floats(0.5, 2), min_size=count, max_size=count)))
    turns = (np.arange(count) + 0.1) / count * 2 * np.pi
    return radii[:, np.newaxis] * np.stack((np.cos(turns), np.sin(turns)), axis=-1)


def turned(vertices, angle):
    """Return corners turned about the origin, counter-clockwise."""
    c, s = math.cos(angle), math.sin(angle)
    return vertices @ np.array([[c, s], [-s, c]])


def with_midpoints(vertices):
    """Return the same polygon with a further corner in the middle of every edge."""
    middles = (vertices + np.roll(vertices, -1, axis=0)) / 2
    return np.stack((vertices, middles), axis=1).reshape(-1, 2)


def vertex_mass_inertia(mass, vertices):
    """Return m/n sum of r.r: all the mass in the corners, as the source lesson had it."""
    return mass * np.square(vertices).sum(axis=1).mean()


# v + w (-r_y, r_x)
VELOCITY = {
    "no turning": (((3, 4), 0, (5, 6)), (3, 4)),
    "the centre itself": (((3, 4), 7, (0, 0)), (3, 4)),
    "counter-clockwise, right of the centre: up": (((0, 0), 2, (3, 0)), (0, 6)),
    "counter-clockwise, above the centre: left": (((0, 0), 2, (0, 3)), (-6, 0)),
    "both": (((1, -2), -2, (3, 4)), (9, -8)),
}


@pytest.mark.parametrize(("arguments", "velocity"), VELOCITY.values(), ids=VELOCITY)
def test_contact_velocity_worked_by_hand_is_found(arguments, velocity) -> None:
    """Counter-clockwise is positive, with y up."""
    np.testing.assert_array_equal(contact_velocity(*arguments), velocity)


@given(points, st.floats(-10, 10), points, st.floats(1e-5, 1e-4))
def test_contact_velocity_is_the_rate_at_which_the_point_moves(v, w, r, dt) -> None:
    """From half a step before to half a step after: v dt, and r turned by w dt."""
    ahead, behind = turned(r, w * dt / 2), turned(r, -w * dt / 2)
    rate = v + (ahead - behind) / dt
    # The chord is shorter than the arc by (w dt)^2/24; the difference loses eps/dt of r.
    error = np.hypot(*r) * (abs(w) * (w * dt) ** 2 / 24 + 1e-15 / dt) + 1e-13 * np.hypot(*v)
    np.testing.assert_allclose(contact_velocity(v, w, r), rate, rtol=0, atol=error + 1e-300)


@given(points, st.floats(-10, 10), points, points)
def test_contact_velocity_keeps_the_distance_of_two_points_of_a_body(v, w, r, s) -> None:
    """A body is rigid: along the line between two of its points they move alike."""
    relative = contact_velocity(v, w, r) - contact_velocity(v, w, s)
    size = np.hypot(*v) + abs(w) * (np.hypot(*r) + np.hypot(*s))
    stretching = relative @ (r - s)
    assert abs(stretching) <= ROUNDING * size * (np.hypot(*r) + np.hypot(*s))


def test_contact_velocity_of_many_points_broadcasts() -> None:
    """One body, four corners: one velocity, one w and offsets (4, 2)."""
    velocities = contact_velocity((1.0, 0.0), 2.0, SQUARE)
    np.testing.assert_array_equal(velocities, [(3, -2), (3, 2), (-1, 2), (-1, -2)])


def test_contact_velocity_equation_takes_and_gives_plain_numbers() -> None:
    """The lines behind the door need no array, so that a solver can run them as they are."""
    assert equation(contact_velocity)((1.0, -2.0), -2.0, (3.0, 4.0)) == (9.0, -8.0)


# vertices, area, centroid, inertia of 6 kg about the centroid
SHAPES = {
    "square of 2 m": (SQUARE, 4, (0, 0), 4),  # m (2^2 + 2^2)/12
    "box of 1 m x 3 m": (((2, 1), (3, 1), (3, 4), (2, 4)), 3, (2.5, 2.5), 5),  # m (1 + 9)/12
    "right triangle": (((0, 0), (3, 0), (0, 6)), 9, (1, 2), 15),  # m (3^2 + 6^2)/18
    "clockwise": (((0, 0), (0, 6), (3, 0)), 9, (1, 2), 15),
    # An L of three unit squares at (0, 0), (1, 0), (0, 1), 2 kg each: centroid (1/3, 1/3),
    # inertia 3 x 2/6 + 2 (2/9 + 5/9 + 5/9)
    "concave L": (
        ((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)),
        3,
        (5 / 6, 5 / 6),
        1 + 8 / 3,
    ),
    "corners on an edge": (((0, 0), (1, 0), (2, 0), (3, 0), (0, 6)), 9, (1, 2), 15),
    "a corner twice": (((0, 0), (3, 0), (3, 0), (0, 6)), 9, (1, 2), 15),
}


@pytest.mark.parametrize(("vertices", "area", "centroid", "inertia"), SHAPES.values(), ids=SHAPES)
def test_polygon_worked_by_hand_has_area_centroid_and_inertia(
    vertices, area, centroid, inertia
) -> None:
    """Textbook shapes; the L by adding up three squares."""
    assert polygon_area(vertices) == pytest.approx(area, rel=ROUNDING)
    np.testing.assert_allclose(polygon_centroid(vertices), centroid, rtol=0, atol=ROUNDING)
    assert polygon_inertia(6, vertices) == pytest.approx(inertia, rel=ROUNDING)


@given(polygons(), points, st.integers(0, 7), st.booleans(), st.booleans(), angles)
def test_polygon_described_otherwise_is_the_same_body(
    vertices, origin, first, backwards, extra, angle
) -> None:
    """Order, first corner, origin, direction of the axes and further corners are no physics."""
    other = turned(np.roll(vertices, first, axis=0), angle) + origin
    other = with_midpoints(other) if extra else other
    other = other[::-1] if backwards else other
    # Corners at 100 m are rounded to 1e-14 m, of which areas and inertias feel some parts.
    rounded = pytest.approx(1, rel=100 * ROUNDING)
    assert polygon_area(other) / polygon_area(vertices) == rounded
    assert polygon_inertia(1, other) / polygon_inertia(1, vertices) == rounded
    moved = turned(polygon_centroid(vertices), angle) + origin
    np.testing.assert_allclose(polygon_centroid(other), moved, rtol=0, atol=100 * ROUNDING)


@given(polygons(), lengths, st.floats(1e-3, 1e3))
def test_polygon_enlarged_scales_by_its_dimensions(vertices, k, mass) -> None:
    """Area is m^2, the centroid m, the inertia kg m^2."""
    larger = k * vertices
    scaled = pytest.approx(1, rel=ROUNDING)
    assert polygon_area(larger) / (k**2 * polygon_area(vertices)) == scaled
    assert polygon_inertia(mass, larger) / (mass * k**2 * polygon_inertia(1, vertices)) == scaled
    np.testing.assert_allclose(
        polygon_centroid(larger), k * polygon_centroid(vertices), rtol=0, atol=ROUNDING * k
    )


@given(polygons())
def test_polygon_cut_in_two_adds_up_by_the_parallel_axis_theorem(vertices) -> None:
    """Area and m c add up; I = I_1 + m_1 d_1^2 + I_2 + m_2 d_2^2, d from the common centroid.

    The cut goes from the first corner to the origin, around which the polygon is a star, and on
    to another corner.
    """
    cut, centre = len(vertices) // 2, np.zeros((1, 2))
    parts = [
        np.concatenate((centre, vertices[: cut + 1])),
        np.concatenate((centre, vertices[cut:], vertices[:1])),
    ]
    areas = np.array([polygon_area(part) for part in parts])
    centroids = np.array([polygon_centroid(part) for part in parts])
    common = areas @ centroids / areas.sum()
    inertia = sum(
        polygon_inertia(area, part) + area * np.square(centroid - common).sum()
        for area, part, centroid in zip(areas, parts, centroids, strict=True)
    )
    assert areas.sum() == pytest.approx(polygon_area(vertices), rel=ROUNDING)
    np.testing.assert_allclose(polygon_centroid(vertices), common, rtol=0, atol=ROUNDING)
    assert polygon_inertia(polygon_area(vertices), vertices) == pytest.approx(inertia, rel=ROUNDING)


@given(points, points, points)
def test_polygon_inertia_of_any_triangle_is_a_twelfth_of_its_corners(a, b, c) -> None:
    """Seen from the centroid, a triangular plate has I = m/12 (a.a + b.b + c.c)."""
    corners = np.array([a, b, c])
    twice_area = abs(np.linalg.det([b - a, c - a]))
    assume(twice_area > 0.01 * np.square([b - a, c - a, c - b]).sum())  # no sliver, no line
    seen = corners - corners.mean(axis=0)
    expected = np.square(seen).sum() / 12
    assert polygon_inertia(1, corners) == pytest.approx(expected, rel=100 * ROUNDING)


def test_polygon_with_many_corners_becomes_a_disc() -> None:
    """With n corners it lacks the part 2 pi^2/(3 n^2) of the disc's area, and of its inertia.

    A = n/2 r^2 sin(2 pi/n) and I = m r^2/6 (2 + cos(2 pi/n)), to the second order.
    """
    n, r = 1000, 0.5
    turns = np.arange(n) * 2 * np.pi / n
    corners = r * np.stack((np.cos(turns), np.sin(turns)), axis=-1)
    lacking = 2 * np.pi**2 / 3 / n**2
    assert polygon_area(corners) == pytest.approx(np.pi * r**2 * (1 - lacking), rel=1e-10)
    assert polygon_inertia(3.0, corners) == pytest.approx(
        disc_inertia(3.0, r) * (1 - lacking), rel=1e-10
    )


def test_disc_inertia_is_the_sum_of_its_rings() -> None:
    """Rings of width dr at r weigh 2 r dr/R^2 of the mass each, all of it at r: I = m R^2/2."""
    mass, radius, count = 4.0, 0.5, 1000
    dr = radius / count
    r = (np.arange(count) + 0.5) * dr
    rings = mass * 2 * r * dr / radius**2
    lacking = 1 / (2 * count**2)  # of the rule of midpoints, for a sum of cubes
    assert (rings * r**2).sum() == pytest.approx(
        disc_inertia(mass, radius) * (1 - lacking), rel=ROUNDING
    )


def test_disc_inertia_of_fractions_is_exact() -> None:
    """No digit is lost in Fractions."""
    inertia = disc_inertia(Fraction(4, 3), Fraction(1, 2))
    assert (inertia, type(inertia)) == (Fraction(1, 6), Fraction)


def test_inertia_of_an_infinite_mass_is_infinite() -> None:
    """What cannot be moved cannot be turned."""
    assert polygon_inertia(math.inf, SQUARE) == math.inf
    assert disc_inertia(math.inf, 1.0) == math.inf


@pytest.mark.parametrize("distance", [1e3, 1e6, 1e9])
def test_polygon_far_from_the_origin_loses_no_digit(distance) -> None:
    """Corners are seen from one of them first.

    Seen from the origin, the products of a square of 4 m^2 at 1e9 m are near 1e18 and leave 0 of
    its area.
    """
    far = SQUARE + np.array((distance, -distance))
    assert polygon_area(far) == pytest.approx(4, rel=EXACT)
    assert polygon_inertia(6, far) == pytest.approx(4, rel=EXACT)
    np.testing.assert_allclose(polygon_centroid(far), (distance, -distance), rtol=EXACT)


def test_polygon_area_and_centroid_of_random_stars_are_shapelys() -> None:
    """1,542 polygons of 3 to 12 corners, in either order."""
    rng, compared = np.random.default_rng(15), 0
    for _ in range(2000):
        count = rng.integers(3, 13)
        turns = np.sort(rng.uniform(0, 2 * np.pi, count))
        if np.diff(turns, append=turns[0] + 2 * np.pi).max() > 3:
            continue  # the centre lies outside, so that the edges may cross
        radii = rng.uniform(0.1, 2, count)
        corners = np.stack((radii * np.cos(turns), radii * np.sin(turns)), axis=-1)
        corners = corners[:: rng.choice([-1, 1])] + rng.uniform(-1, 1, 2)
        theirs = shapely.Polygon(corners)
        assert polygon_area(corners) == pytest.approx(theirs.area, rel=SHAPELY_ERROR)
        centroid = (theirs.centroid.x, theirs.centroid.y)
        np.testing.assert_allclose(polygon_centroid(corners), centroid, rtol=0, atol=SHAPELY_ERROR)
        compared += 1
    assert compared == 1542


@pytest.mark.parametrize(
    ("vertices", "ratio"),
    [
        pytest.param(SQUARE, 3, id="square"),
        pytest.param(with_midpoints(SQUARE), 2.25, id="the same square with 4 further corners"),
        pytest.param(TRIANGLE, 30 / 7, id="triangle about the middle of its box"),
        pytest.param(TRIANGLE - TRIANGLE.mean(axis=0), 4, id="triangle about its centroid"),
    ],
)
def test_inertia_with_all_mass_in_the_corners_is_too_large(vertices, ratio) -> None:
    """Fault 15 of the source: the square is 3 times, the triangle 4.29 times too hard to turn.

    A further corner on an edge changes its answer and no plate. Part of the triangle's ratio is
    fault 16: the origin that the source turned it about is not its centroid.
    """
    measured = vertex_mass_inertia(6.0, vertices) / polygon_inertia(6.0, vertices)
    assert measured == pytest.approx(ratio, rel=ROUNDING)


def test_centroid_of_a_triangle_is_not_the_middle_of_its_box() -> None:
    """Fault 16 of the source: its triangle turned about a point 6.67 from the centroid."""
    np.testing.assert_allclose(polygon_centroid(TRIANGLE), (0, 20 / 3), rtol=0, atol=ROUNDING)


def test_centroid_is_not_the_mean_of_the_corners() -> None:
    """A further corner pulls the mean towards it, and leaves the plate where it was."""
    corners = np.array([(0, 0), (2, 0), (2, 2), (1, 2), (0, 2)], dtype=float)
    np.testing.assert_array_equal(polygon_centroid(corners), (1, 1))
    np.testing.assert_array_equal(corners.mean(axis=0), (1, 1.2))
