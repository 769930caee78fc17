"""Laws that every pair of shapes obeys, awkward shapes, and the door of `collide`."""

from __future__ import annotations

import itertools
import math
from typing import Any

import numpy as np
import pytest

from lesson_code.geometry import Circle, Manifold, Polygon, Segment, Shape, collide
from lesson_code.geometry.manifold import collide_rows
from lesson_code.geometry.rows import Corner, ManifoldRow, Placed, place

ROUNDING = 1e-12
"""Coordinates are at most 10; a corner's direction is read off distances down to 0.01 m."""

SEED = 20_240_607
PAIRS = 100
"""Random pairs for each two kinds of shapes."""

KINDS = ["circle", "polygon", "line", "capsule"]
TWO_KINDS = list(itertools.product(KINDS, KINDS))
Pose = tuple[float, float, float]


def random_shape(kind: str, rng: np.random.Generator) -> Shape:
    """Return a random shape of size 1."""
    if kind == "circle":
        return Circle(rng.uniform(0.2, 1.5))
    if kind == "polygon":
        angles = (
            2 * np.pi * np.cumsum(steps := rng.uniform(0.3, 1, rng.integers(3, 8))) / steps.sum()
        )
        return Polygon(np.stack((1.5 * np.cos(angles), rng.uniform(0.3, 1.5) * np.sin(angles)), 1))
    half = rng.uniform(0.2, 1.5)
    return Segment((-half, 0), (half, 0), 0 if kind == "line" else rng.uniform(0.05, 0.5))


def random_pairs(kind_a: str, kind_b: str) -> list[tuple[Shape, Pose, Shape, Pose]]:
    """Return pairs of shapes at random places, of which about a half overlap."""
    rng = np.random.default_rng([SEED, KINDS.index(kind_a), KINDS.index(kind_b)])
    return [
        (
            random_shape(kind_a, rng),
            tuple(rng.uniform((-1, -1, -4), (1, 1, 4)).tolist()),
            random_shape(kind_b, rng),
            tuple(rng.uniform((-1, -1, -4), (1, 1, 4)).tolist()),
        )
        for _ in range(PAIRS)
    ]


def rows_of(
    shape_a: Shape, pose_a: Pose, shape_b: Shape, pose_b: Pose
) -> tuple[Placed, Placed, ManifoldRow]:
    """Return both bodies and the manifold that the narrow phase fills."""
    corners: list[Corner] = []
    a = place(shape_a.outline, shape_a.rounding, pose_a, corners)
    b = place(shape_b.outline, shape_b.rounding, pose_b, corners)
    m = ManifoldRow()
    collide_rows(corners, a, b, m)
    return a, b, m


def offsets(m: ManifoldRow) -> list[tuple[float, float, float, float, float]]:
    """Return the points in use as (ax, ay, bx, by, penetration)."""
    both = [
        (m.ax0, m.ay0, m.bx0, m.by0, m.penetration0),
        (m.ax1, m.ay1, m.bx1, m.by1, m.penetration1),
    ]
    return both[: m.count]


def points_of(contact: Manifold) -> Any:
    """Return the points of a contact as rows (x, y, penetration), sorted along x."""
    rows = np.column_stack((contact.points, contact.penetrations))
    return rows[np.argsort(rows[:, 0].round(9))]


def assert_same(first: Manifold | None, second: Manifold | None) -> None:
    """Fail unless two contacts have the same normal, points and penetrations."""
    assert (first is None) == (second is None)
    if first is not None and second is not None:
        np.testing.assert_allclose(first.normal, second.normal, atol=ROUNDING)
        np.testing.assert_allclose(points_of(first), points_of(second), atol=ROUNDING)


def changed(contact: Manifold | None, matrix: Any, shift: Any) -> Manifold | None:
    """Return a contact after the whole plane was turned or mirrored, and shifted."""
    if contact is None:
        return None
    return Manifold(
        contact.normal @ matrix.T,
        contact.points @ matrix.T + shift,
        contact.penetrations,
        contact.features,
    )


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_points_are_on_both_surfaces(kind_a: str, kind_b: str) -> None:
    """For every point  position_A + a = position_B + b + penetration n,  n is unit, depth > 0."""
    hits = 0
    for pair in random_pairs(kind_a, kind_b):
        a, b, m = rows_of(*pair)
        for ax, ay, bx, by, penetration in offsets(m):
            hits += 1
            assert a.x + ax == pytest.approx(b.x + bx + penetration * m.nx, abs=ROUNDING)
            assert a.y + ay == pytest.approx(b.y + by + penetration * m.ny, abs=ROUNDING)
            assert math.hypot(m.nx, m.ny) == pytest.approx(1, abs=ROUNDING)
            assert penetration > 0
    assert hits > PAIRS / 5


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_pushed_apart_by_its_depth_only_touches(kind_a: str, kind_b: str) -> None:
    """B moved along the normal by the deepest penetration is free; by 0.99 of it, it is not."""
    for shape_a, pose_a, shape_b, (x, y, angle) in random_pairs(kind_a, kind_b):
        contact = collide(shape_a, pose_a, shape_b, (x, y, angle))
        if contact is not None:
            way = max(contact.penetrations) * contact.normal
            left = collide(shape_a, pose_a, shape_b, (x + way[0], y + way[1], angle))
            assert left is None or max(left.penetrations) < ROUNDING
            almost = (x + 0.99 * way[0], y + 0.99 * way[1], angle)
            assert collide(shape_a, pose_a, shape_b, almost) is not None


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_swapped_has_the_opposite_normal(kind_a: str, kind_b: str) -> None:
    """What A sees of B is what B sees of A, from the other side."""
    for shape_a, pose_a, shape_b, pose_b in random_pairs(kind_a, kind_b):
        back = collide(shape_b, pose_b, shape_a, pose_a)
        if back is not None:
            back = Manifold(-back.normal, back.points, back.penetrations, back.features)
        assert_same(collide(shape_a, pose_a, shape_b, pose_b), back)


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_turned_and_shifted_turns_and_shifts(kind_a: str, kind_b: str) -> None:
    """The plane has no preferred direction and no preferred place."""
    rng = np.random.default_rng(SEED)
    for shape_a, pose_a, shape_b, pose_b in random_pairs(kind_a, kind_b):
        angle, shift = rng.uniform(-3, 3), rng.uniform(-5, 5, 2)
        matrix = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        turned_a, turned_b = (
            (*(matrix @ pose[:2] + shift), pose[2] + angle) for pose in (pose_a, pose_b)
        )
        there = collide(shape_a, turned_a, shape_b, turned_b)
        assert_same(changed(collide(shape_a, pose_a, shape_b, pose_b), matrix, shift), there)


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_mirrored_is_mirrored(kind_a: str, kind_b: str) -> None:
    """Left and right are alike: y turned into -y everywhere."""
    mirror = np.diag([1.0, -1.0])
    for shape_a, (xa, ya, angle_a), shape_b, (xb, yb, angle_b) in random_pairs(kind_a, kind_b):
        here = collide(shape_a, (xa, ya, angle_a), shape_b, (xb, yb, angle_b))
        there = collide(
            mirrored(shape_a), (xa, -ya, -angle_a), mirrored(shape_b), (xb, -yb, -angle_b)
        )
        assert_same(changed(here, mirror, 0), there)


def mirrored(shape: Shape) -> Shape:
    """Return a shape with y turned into -y; circles and the segments here are their own image."""
    if isinstance(shape, Polygon):
        return Polygon([(x, -y) for x, y in shape.vertices])
    return shape


@pytest.mark.parametrize(("kind_a", "kind_b"), TWO_KINDS)
def test_manifold_far_from_the_origin_has_the_same_bits(kind_a: str, kind_b: str) -> None:
    """A million metres away nothing is lost: only the distance of the bodies enters.

    Positions are multiples of 2^-30 and the shift is 2^20, so that they are exact in both places.
    """
    for shape_a, pose_a, shape_b, pose_b in random_pairs(kind_a, kind_b):
        near = [
            (*(math.ldexp(round(math.ldexp(c, 30)), -30) for c in p[:2]), p[2])
            for p in (pose_a, pose_b)
        ]
        far = [(x + 2.0**20, y - 2.0**20, angle) for x, y, angle in near]
        assert (
            rows_of(shape_a, near[0], shape_b, near[1])[2]
            == rows_of(shape_a, far[0], shape_b, far[1])[2]
        )


AWKWARD = {
    "thin": Polygon.box(1, 1e-6),
    "tiny": Polygon.box(1e-6, 1e-6),
    "huge": Polygon.box(1e6, 1e6),
    "many corners": Polygon.regular(64, 1.0),
    "needle": Polygon([(0, 0), (1, 0), (1, 1e-9)]),
    "nearly parallel sides": Polygon([(0, 0), (1, 0), (1, 1), (0, 1 + 1e-9)]),
    "short line": Segment((0, 0), (1e-9, 0)),
    "long line": Segment((-1e6, 0), (1e6, 0)),
    "line": Segment((-1, 0), (1, 0)),
    "thinnest capsule": Segment((-1, 0), (1, 0), 1e-12),
    "thick capsule": Segment((-1e-9, 0), (1e-9, 0), 1.0),
    "tiny circle": Circle(1e-6),
    "huge circle": Circle(1e6),
}
AWKWARD_POSES: list[Pose] = [
    (0, 0, 0),
    (0, 0, 1e-9),
    (0, 0, math.pi / 2),
    (0.5, 0, 0),
    (0.5, 0.5, math.pi / 4),
    (0, 1e-12, 1e-15),
]


@pytest.mark.parametrize("name_a", AWKWARD)
@pytest.mark.parametrize("name_b", AWKWARD)
def test_manifold_of_awkward_shapes_is_sane(name_a: str, name_b: str) -> None:
    """Coincident, nested, crossing, thin, tiny, huge: finite numbers, and a way apart."""
    shape_a, shape_b = AWKWARD[name_a], AWKWARD[name_b]
    rounding = 1e-14 * (shape_a.bounding_radius + shape_b.bounding_radius)
    for x, y, angle in AWKWARD_POSES:
        a, b, m = rows_of(shape_a, (0, 0, 0), shape_b, (x, y, angle))
        if m.count == 0:
            continue
        assert math.hypot(m.nx, m.ny) == pytest.approx(1, abs=ROUNDING)
        for ax, ay, bx, by, penetration in offsets(m):
            assert penetration > 0
            assert ax - bx - (b.x - a.x) == pytest.approx(penetration * m.nx, abs=rounding)
            assert ay - by - (b.y - a.y) == pytest.approx(penetration * m.ny, abs=rounding)
        depth = max(point[4] for point in offsets(m))
        apart = (x + depth * m.nx, y + depth * m.ny, angle)
        _, _, left = rows_of(shape_a, (0, 0, 0), shape_b, apart)
        assert all(point[4] < rounding for point in offsets(left))


def test_manifold_row_used_again_forgets_the_last_contact() -> None:
    """The narrow phase has one row for all pairs: after a miss it says so."""
    ball, m = Placed(radius=1.0), ManifoldRow()
    collide_rows([], ball, Placed(x=1.0, radius=1.0), m)
    assert m.count == 1
    collide_rows([], ball, Placed(x=9.0, radius=1.0), m)
    assert m.count == 0


def test_manifold_points_are_midway_between_the_surfaces() -> None:
    """The box's bottom is at -0.25, the floor's surface at 0: the points are at -0.125."""
    contact = collide(Polygon.box(8, 2), (0, -1, 0), Polygon.box(2, 2), (1, 0.75, 0))
    assert contact is not None
    assert contact.points[:, 1].tolist() == [-0.125, -0.125]
    assert contact.points.shape == (2, 2)
    assert len(contact.features) == len(contact.penetrations) == 2


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        (
            {"shape_a": [(0, 0), (1, 0), (0, 1)]},
            TypeError,
            "shape_a must be a Circle, Polygon or Seg",
        ),
        ({"shape_b": None}, TypeError, "shape_b must be a Circle, Polygon or Segment, got None"),
        ({"pose_a": (0, 0)}, ValueError, r"pose_a must be \(x, y, angle\), got shape \(2,\)"),
        ({"pose_b": (0, math.nan, 0)}, ValueError, "pose_b must be finite, got nan at index"),
        ({"pose_b": (math.inf, 0, 0)}, ValueError, "pose_b must be finite, got inf at index"),
        ({"pose_a": ("left", 0, 0)}, TypeError, "pose_a must be a real number or an array of them"),
    ],
)
def test_collide_bad_input_is_refused_by_name(
    wrong: dict[str, Any], error: type[Exception], message: str
) -> None:
    """Each argument is checked at the door; the error says argument, rule and value."""
    good: dict[str, Any] = {
        "shape_a": Circle(1),
        "pose_a": (0, 0, 0),
        "shape_b": Circle(1),
        "pose_b": (1, 0, 0),
    }
    with pytest.raises(error, match=message):
        collide(**(good | wrong))
