"""Area, centroid and inertia against pymunk's own, for random convex polygons and discs."""

from __future__ import annotations

from typing import Any

import numpy as np
import pymunk
import pytest
from numpy.typing import NDArray

from lesson_code.formulas import disc_inertia, polygon_area, polygon_centroid, polygon_inertia

SEED = 20_240_515

ERROR = 1e-14
"""Relative, and in m for places: polygons of about 1 m. Measured over 3,000: 4.3e-15."""

Array = NDArray[np.float64]


def convex(rng: np.random.Generator) -> Array:
    """Return 3 to 10 corners on an ellipse, counter-clockwise, none of them redundant."""
    count = int(rng.integers(3, 11))
    turns = (np.arange(count) + rng.uniform(-0.3, 0.3, count)) / count * 2 * np.pi
    axes = rng.uniform(0.2, 2, 2)
    corners: Array = axes * np.stack((np.cos(turns), np.sin(turns)), axis=-1)
    return corners


def pairs(vertices: Array) -> list[tuple[float, float]]:
    """Return corners as pymunk takes them."""
    return [(float(x), float(y)) for x, y in vertices]


@pytest.fixture
def rng() -> Any:
    """Random numbers, the same in every run."""
    return np.random.default_rng(SEED)


def test_moment_for_poly_is_about_the_origin_not_the_centroid(rng: np.random.Generator) -> None:
    """A convention of pymunk: it is for corners around their centroid, and does not put them there.

    For others it gives I + m c.c, Steiner's theorem.
    """
    for _ in range(200):
        vertices, mass = convex(rng) + rng.uniform(-2, 2, 2), float(rng.uniform(0.1, 10))
        c = polygon_centroid(vertices)
        about_origin = polygon_inertia(mass, vertices) + mass * c @ c
        theirs = pymunk.moment_for_poly(mass, pairs(vertices))
        assert about_origin == pytest.approx(theirs, rel=ERROR)


def test_polygon_inertia_is_pymunks_about_the_centroid(rng: np.random.Generator) -> None:
    """500 polygons, corners in either order."""
    for _ in range(500):
        vertices, mass = convex(rng)[:: rng.choice([-1, 1])], float(rng.uniform(0.1, 10))
        around_centroid = pairs(vertices - polygon_centroid(vertices))
        theirs = pymunk.moment_for_poly(mass, around_centroid)
        assert polygon_inertia(mass, vertices) == pytest.approx(theirs, rel=ERROR)


def test_polygon_area_and_centroid_are_those_of_a_pymunk_shape(rng: np.random.Generator) -> None:
    """500 polygons; a pymunk.Poly has an area and a centre of gravity."""
    for _ in range(500):
        vertices = convex(rng) + rng.uniform(-2, 2, 2)
        shape = pymunk.Poly(pymunk.Body(), pairs(vertices))
        shape.density = 1.0
        assert polygon_area(vertices) == pytest.approx(shape.area, rel=ERROR)
        np.testing.assert_allclose(
            polygon_centroid(vertices), shape.center_of_gravity, rtol=0, atol=ERROR
        )


def test_body_inertia_of_a_pymunk_shape_with_density_is_ours(rng: np.random.Generator) -> None:
    """A pymunk body that takes its mass from its shape turns about the shape's centroid too."""
    for _ in range(100):
        vertices = convex(rng) + rng.uniform(-2, 2, 2)
        body, space = pymunk.Body(), pymunk.Space()
        shape = pymunk.Poly(body, pairs(vertices))
        shape.density = 2.5
        space.add(body, shape)
        mass = 2.5 * polygon_area(vertices)
        assert body.mass == pytest.approx(mass, rel=ERROR)
        assert body.moment == pytest.approx(polygon_inertia(mass, vertices), rel=ERROR)


def test_disc_inertia_is_pymunks_circle_without_a_hole(rng: np.random.Generator) -> None:
    """moment_for_circle has an inner radius; with 0 it is a disc."""
    for mass, radius in rng.uniform(0.1, 10, (200, 2)):
        theirs = pymunk.moment_for_circle(float(mass), 0.0, float(radius))
        assert disc_inertia(float(mass), float(radius)) == pytest.approx(theirs, rel=ERROR)


@pytest.mark.parametrize(("distance", "area"), [(1e3, 4.0), (1e6, 4.0), (1e8, 0.0)])
def test_polygon_far_away_keeps_digits_that_pymunk_loses(distance: float, area: float) -> None:
    """A square of 4 m^2: at 1e8 m pymunk's has no area, no mass and an infinite centre."""
    far = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=float) + distance
    shape = pymunk.Poly(pymunk.Body(), pairs(far))
    assert (polygon_area(far), polygon_inertia(6.0, far)) == (4.0, 4.0)
    assert polygon_centroid(far).tolist() == [distance, distance]
    assert shape.area == area
    assert np.isfinite(shape.center_of_gravity).all() == (area > 0)
