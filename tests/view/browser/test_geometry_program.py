"""Two shapes as a page looks at them: what the doors of `geometry` say, with what lies between."""

from __future__ import annotations

import math

import numpy as np
import pytest
import tiers

from lesson_code.geometry import Circle, Polygon, Segment, Shape, collide, time_of_impact
from lesson_code.geometry.rows import Corner, ManifoldRow
from lesson_code.geometry.sat import TIE
from lesson_code.view.browser.programs.geometry import (
    AxisRow,
    FoundRow,
    Pair,
    ShapeRow,
    look,
    look_ahead,
)

SHAPES: list[Shape] = [
    Polygon.box(1.0, 0.6),
    Polygon([(0, 0), (1.5, 0.2), (0.4, 1.1)]),
    Polygon.regular(7, 0.7),
    Segment((-0.5, 0), (0.5, 0), radius=0.1),
    Segment((0, 0), (0.3, 1)),
    Circle(0.4),
]

ROUNDING = 10 * TIE
"""Of the lengths: a face as good as the best may be taken, and shadows start from A's position
where the search starts from the edge."""


def row_of(
    shape: Shape, pose: tuple[float, ...], velocity: tuple[float, ...], corners: list[Corner]
) -> ShapeRow:
    """Return what a page sets for a shape, and append its corners."""
    first = len(corners)
    corners += [Corner(x, y) for x, y in shape.outline]
    x, y, angle = pose
    vx, vy, w = velocity
    reach = {"radius": shape.rounding, "bounding_radius": shape.bounding_radius}
    moves = {"x": x, "y": y, "angle": angle, "vx": vx, "vy": vy, "w": w}
    return ShapeRow(**moves, **reach, first_corner=first, corner_count=len(corners) - first)


@pytest.mark.parametrize("seed", range(tiers.share(300)))
def test_pair_is_seen_as_the_doors_of_geometry_see_it(seed: int) -> None:
    """The manifold of `collide`, the time of `time_of_impact`, the axes of the least overlap."""
    rng = np.random.default_rng(seed)
    shapes = [SHAPES[k] for k in rng.integers(len(SHAPES), size=2)]
    poses = [tuple(pose) for pose in rng.normal(size=(2, 3)).tolist()]
    velocities = [tuple(v) for v in (rng.normal(size=(2, 3)) * rng.integers(2, size=3)).tolist()]
    corners: list[Corner] = []
    a, b = (row_of(*each, corners) for each in zip(shapes, poses, velocities, strict=True))
    rows = [ManifoldRow() for _ in range(3)]
    pair = Pair(corners, a, b, [AxisRow() for _ in corners], FoundRow(duration=3.0), *rows)
    look(pair)
    look_ahead(pair)

    expected = collide(shapes[0], poses[0], shapes[1], poses[1])
    found, m = pair.found, pair.manifold
    assert m.count == (0 if expected is None else len(expected.points))
    if expected is not None:
        assert [m.nx, m.ny] == expected.normal.tolist()
        assert [m.penetration0, m.penetration1][: m.count] == expected.penetrations.tolist()
    moving = [part for each in zip(shapes, poses, velocities, strict=True) for part in each]
    time = time_of_impact(*moving, 3.0)
    assert found.time == (math.inf if time is None else time)

    if a.corner_count and b.corner_count:
        least = min(axis.overlap for axis in pair.axes)
        rounding = ROUNDING * (1.0 + sum(map(abs, poses[0] + poses[1])))
        if found.overlap + a.radius + b.radius > 0.0:  # else the search ended at the first gap
            assert found.overlap == pytest.approx(least, abs=rounding)
        else:
            assert least <= found.overlap + rounding
        if m.count == 2:
            both = pair.measured
            assert (m.penetration0, m.penetration1) == (both.penetration0, both.penetration1)
        assert pair.cut.count == pair.measured.count >= m.count
