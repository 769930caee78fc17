"""Times of impact against roots of 50 digits, pymunk's sweep of a circle, and shapely's distance.

===========================  ===============================================================
reference                    how it finds the answer
===========================  ===============================================================
mpmath, 50 digits            all roots of the polynomial and of its slope, sorted: the impact is
                             the first at or after which the squared distance falls below 0
pymunk (Munk2D)              ``Shape.segment_query`` with a radius: a circle that moves straight
shapely (GEOS)               distance and intersects, at 1,000 times of the motion
===========================  ===============================================================

pymunk's query of a segment misjudges a circle that starts beyond an end and nearer to the segment's
line than the circle's reach: it may miss the round end and report the side, later. Those cases are
counted and compared with shapely instead.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pymunk
import pytest
import shapely

from lesson_code.geometry import Circle, Polygon, Segment, Shape, collide, time_of_impact
from lesson_code.geometry.advancement import TOLERANCE
from lesson_code.geometry.impact_times import (
    circle_impact_time,
    circle_outline_impact_time,
    line_impact_time,
)
from lesson_code.geometry.nearest_feature import nearest_feature
from lesson_code.geometry.rows import Corner, place
from lesson_code.geometry.separation import RelativePose, separation_rows

# mpmath 1.4 wants the lowest power first and `asc=True`, which mpmath 1.3 does not know.
pytestmark = pytest.mark.filterwarnings("ignore:Descending:DeprecationWarning")

SEED = 20_240_704
EXACT = mpmath.mp.clone()
EXACT.dps = 50

TIME = 1e-12
"""s: what is promised for shapes of some metres at some metres a second."""

PLACE = 1e-15
"""Of the lengths involved: some roundings. A time of impact cannot be better than this, divided by
the speed at which the surfaces close; at grazing they close slowly. Measured: 1.4e-16 at most."""

FRACTION = 1e-13
"""Of the sweep, for pymunk's answer; measured: 1.3e-14 at most."""

DISTANCE = 1e-14
"""m, for the distance of shapes up to 6 m across, up to 10 m apart; measured: 2.7e-15 at most."""

State = tuple[float, ...]
Pose = tuple[float, float, float]


def first_fall(coefficients: list[Any]) -> Any:
    """Return the first time at which a polynomial, highest power first, is <= 0 and falls; or None.

    The polynomial is a gap or its square. Its roots and those of its slope cut time into pieces
    without a change of sign; so it is enough to look in the middle of each.
    """
    while len(coefficients) > 1 and coefficients[0] == 0:
        coefficients = coefficients[1:]
    slope = [c * (len(coefficients) - 1 - k) for k, c in enumerate(coefficients[:-1])]
    times = sorted([EXACT.mpf(0), *positive_roots(coefficients), *positive_roots(slope)])
    for k, start in enumerate(times):
        end = times[k + 1] if k + 1 < len(times) else 2 * start + 1
        falls = EXACT.polyval(slope or [0], (start + end) / 2) < 0
        if falls and EXACT.polyval(coefficients, start) < EXACT.mpf("1e-35"):
            return start
    return None


def positive_roots(coefficients: list[Any]) -> list[Any]:
    """Return the real roots > 0 of a polynomial: by a square root, or by mpmath's polyroots."""
    if len(coefficients) == 3:
        a, b, c = coefficients
        square = b * b - 4 * a * c
        root = EXACT.sqrt(max(square, 0))
        real = [(-b - root) / (2 * a), (-b + root) / (2 * a)] if square > 0 else []
    elif len(coefficients) > 1:
        roots = EXACT.polyroots(coefficients, maxsteps=200, extraprec=150)
        real = [r.real for r in roots if abs(r.imag) < EXACT.mpf("1e-30") * (1 + abs(r))]
    else:
        real = []
    return [root for root in real if root > 0]


def circle_polynomial(state: State, reach: float) -> list[Any]:
    """Return the coefficients of the squared distance of two centres, less reach squared."""
    dx, dy, vx, vy, ax, ay, r = (EXACT.mpf(x) for x in (*state, reach))
    return [
        (ax * ax + ay * ay) / 4,
        vx * ax + vy * ay,
        vx * vx + vy * vy + dx * ax + dy * ay,
        2 * (dx * vx + dy * vy),
        dx * dx + dy * dy - r * r,
    ]


def allowed(state: State, reach: float, time: Any) -> float:
    """Return by how much a time may be off: the rounding of places over the closing speed."""
    dx, dy, vx, vy, ax, ay, t = (EXACT.mpf(x) for x in (*state, time))
    px, py, ux, uy = (
        dx + vx * t + ax * t**2 / 2,
        dy + vy * t + ay * t**2 / 2,
        vx + ax * t,
        vy + ay * t,
    )
    lengths = abs(dx) + abs(dy) + reach + t * (abs(vx) + abs(vy)) + t**2 * (abs(ax) + abs(ay))
    closing = abs(px * ux + py * uy) / EXACT.sqrt(px * px + py * py)
    return float(PLACE * (lengths / closing + t)) if closing > 0 else math.inf


def random_states(count: int, falling: bool) -> list[tuple[State, float]]:
    """Return motions of some metres and metres a second that pass near a disc, and its radius."""
    rng = np.random.default_rng([SEED, count])
    cases = []
    for k in range(count):
        reach, duration = float(10 ** rng.uniform(-1.5, 0.5)), rng.uniform(0.3, 4)
        d = rng.uniform(-1, 1, 2) * 10 ** rng.uniform(-1, 1.3)
        a = rng.uniform(-4, 4, 2) if k % 2 else np.array((0.0, -9.81))
        a *= falling
        target = rng.uniform(-1.2, 1.2, 2) * reach
        v = (target - d) / duration - a * duration / 2
        cases.append(((*d.tolist(), *v.tolist(), *a.tolist()), reach))
    return cases


@pytest.mark.parametrize(
    ("count", "falling", "fewest"),
    [
        pytest.param(5_000, False, 2_500, id="straight"),
        pytest.param(200, True, 100, id="parabola"),
    ],
)
def test_circle_time_is_the_root_of_50_digits(count: int, falling: bool, fewest: int) -> None:
    """Hit or miss is decided as by 50 digits, and the time is theirs to 1e-12 s."""
    hits = 0
    for state, reach in random_states(count, falling):
        measured = circle_impact_time(*state, reach)
        expected = first_fall(circle_polynomial(state, reach))
        assert (measured == math.inf) == (expected is None)
        if expected is not None:
            error = abs(float(measured - expected))
            assert error < TIME
            assert error <= allowed(state, reach, expected) or measured == 0
            hits += measured > 0
    assert hits > fewest


def test_circle_time_near_grazing_is_as_good_as_the_places() -> None:
    """The nearer to grazing, the slower the surfaces close, and the less a time can be known.

    Passing at reach (1 - g) the centres close at the speed times sqrt(2 g): for g = 1e-14 a
    rounding of the places moves the impact by 7 million times as much. No hit is lost for g down to
    1e-13, and none invented for -g.
    """
    rng = np.random.default_rng(SEED)
    for _ in range(1_000):
        reach, distance, angle = 10 ** rng.uniform(-1, 1), rng.uniform(2, 5), rng.uniform(-4, 4)
        short = 10 ** rng.uniform(-14, -2)
        for share, hits in ((1 - short, True), (1 + short, False)):
            c, s = math.cos(angle), math.sin(angle)
            x, y = distance * reach, share * reach
            state = (c * x - s * y, s * x + c * y, -c, -s, 0.0, 0.0)
            measured = circle_impact_time(*state, reach)
            expected = first_fall(circle_polynomial(state, reach))
            if short > 1e-13:  # else a rounding of the places decides
                assert (measured < math.inf) == (expected is not None) == hits
            if expected is not None and measured < math.inf:
                assert abs(float(measured - expected)) <= allowed(state, reach, expected)


@pytest.mark.parametrize("scale", [1e-6, 1e-3, 1e3, 1e6])
def test_circle_time_any_scale_has_all_its_digits(scale: float) -> None:
    """Speeds from 1e-6 to 1e6 m/s: the relative error stays that of the places."""
    for (dx, dy, vx, vy, *_), reach in random_states(300, False):
        state = (dx, dy, scale * vx, scale * vy, 0.0, 0.0)
        measured = circle_impact_time(*state, reach)
        expected = first_fall(circle_polynomial(state, reach))
        assert (measured == math.inf) == (expected is None)
        if expected:
            assert abs(float(measured - expected)) <= allowed(state, reach, expected)


def test_line_time_is_the_root_of_50_digits() -> None:
    """3,000 heights, speeds and accelerations of either sign."""
    rng = np.random.default_rng(SEED)
    hits = 0
    for gap, v, a in rng.uniform((-0.5, -5, -10), (5, 5, 10), (3_000, 3)).tolist():
        measured = line_impact_time(gap, v, a)
        expected = first_fall([EXACT.mpf(a) / 2, EXACT.mpf(v), EXACT.mpf(gap)])
        assert (measured == math.inf) == (expected is None)
        if expected is not None:
            closing = abs(v + a * float(expected))
            lengths = abs(gap) + abs(v) * measured + abs(a) * measured**2
            error = abs(float(measured - expected))
            assert error <= PLACE * (lengths / closing if closing else 0.0) + PLACE
            hits += measured > 0
    assert hits > 1_000


def random_polygon(rng: np.random.Generator) -> Polygon:
    """Return a convex polygon of 3 to 8 corners on an ellipse, 0.2 to 6 m across."""
    steps = rng.uniform(0.3, 1, rng.integers(3, 9))
    angles = 2 * np.pi * np.cumsum(steps) / steps.sum()
    width, height = 10 ** rng.uniform(-1, 0.5, 2)
    return Polygon(np.stack((width * np.cos(angles), height * np.sin(angles)), axis=1))


def random_shape(rng: np.random.Generator, kind: str) -> Shape:
    """Return a random shape of a kind, up to 6 m across."""
    if kind == "polygon":
        return random_polygon(rng)
    if kind == "circle":
        return Circle(10 ** rng.uniform(-1, 0.5))
    start, end = rng.uniform(-2, 2, (2, 2))
    return Segment(start, end, rng.uniform(0.01, 0.5) if kind == "capsule" else 0.0)


KINDS = ["circle", "polygon", "line", "capsule"]


@pytest.mark.parametrize("kind", KINDS[1:])
@pytest.mark.parametrize("gravity", [0.0, -2.0], ids=["straight", "parabola"])
def test_outline_time_is_the_root_of_50_digits(kind: str, gravity: float) -> None:
    """With exact normals and corners, the gap at the time of impact is 0 to a rounding.

    One step of Newton's method, of 50 digits, says by how much the time is off.
    """
    rng = np.random.default_rng([SEED, *kind.encode()])
    hits = {True: 0, False: 0}
    for _ in range(600):
        shape, radius = random_shape(rng, kind), float(10 ** rng.uniform(-1, 0))
        corners: list[Corner] = []
        body = place(shape.outline, shape.rounding, (0.0, 0.0, 0.0), corners)
        d = rng.uniform(-6, 6, 2).tolist()
        state = (*d, *(rng.uniform(-1, 1, 2) - d).tolist(), 0.0, gravity)
        time, feature = circle_outline_impact_time(corners, body, *state, radius)
        if not 0 < time < math.inf or nearest_feature(corners, body, *d)[0] < radius + body.radius:
            continue
        gap, closing = exact_gap(corners, feature, state, time)
        error = float((gap - EXACT.mpf(radius) - EXACT.mpf(shape.rounding)) / closing)
        assert abs(error) < max(TIME, 10 * PLACE / float(closing))
        hits[feature >= 0] += 1
    assert min(hits.values()) > 50


def exact_gap(corners: list[Corner], feature: int, state: State, time: float) -> tuple[Any, Any]:
    """Return distance and closing speed of a centre and a face or corner, to 50 digits."""
    dx, dy, vx, vy, ax, ay, t = (EXACT.mpf(x) for x in (*state, time))
    px, py, ux, uy = (
        dx + vx * t + ax * t**2 / 2,
        dy + vy * t + ay * t**2 / 2,
        vx + ax * t,
        vy + ay * t,
    )
    c = corners[feature if feature >= 0 else -1 - feature]
    rx, ry = px - EXACT.mpf(c.x), py - EXACT.mpf(c.y)
    if feature >= 0:
        end = corners[(feature + 1) % len(corners)]
        ex, ey = EXACT.mpf(end.x) - EXACT.mpf(c.x), EXACT.mpf(end.y) - EXACT.mpf(c.y)
        length = EXACT.sqrt(ex * ex + ey * ey)
        nx, ny = ey / length, -ex / length
    else:
        length = EXACT.sqrt(rx * rx + ry * ry)
        nx, ny = rx / length, ry / length
    return rx * nx + ry * ny, -(ux * nx + uy * ny)


def in_world(shape: Shape, pose: Pose) -> Any:
    """Return the corners of a polygon or segment, or the centre of a circle, in the world."""
    x, y, angle = pose
    c, s = math.cos(angle), math.sin(angle)
    return np.array(shape.outline or [(0.0, 0.0)]) @ np.array([[c, s], [-s, c]]) + (x, y)


def in_pymunk(shape: Shape, pose: Pose) -> pymunk.Shape:
    """Return a shape of pymunk at its place."""
    body = pymunk.Body(1, 1)
    body.position, body.angle = pose[:2], pose[2]
    made: pymunk.Shape
    if isinstance(shape, Circle):
        made = pymunk.Circle(body, shape.radius)
    elif isinstance(shape, Polygon):
        made = pymunk.Poly(body, shape.vertices)
    else:
        made = pymunk.Segment(body, shape.start, shape.end, shape.radius)
    made.cache_bb()
    return made


def starts_beyond_an_end(shape: Shape, pose: Pose, start: Any, radius: float) -> bool:
    """Return whether a circle starts nearer to a segment's line than its reach."""
    if not isinstance(shape, Segment):
        return False
    a, b = in_world(shape, pose)
    along, away = (b - a) / np.linalg.norm(b - a), start - a
    return bool(abs(along[0] * away[1] - along[1] * away[0]) < radius + shape.radius)


@pytest.mark.parametrize("kind", KINDS)
def test_circle_against_any_shape_meets_when_pymunk_says(kind: str) -> None:
    """Of 2,500 straight sweeps the same ones hit, after the same fraction of the way."""
    rng = np.random.default_rng([SEED, *kind.encode()])
    hits = 0
    for _ in range(2_500):
        shape, radius = random_shape(rng, kind), float(10 ** rng.uniform(-1.5, 0))
        pose = tuple(rng.uniform((-2, -2, -4), (2, 2, 4)).tolist())
        start = rng.uniform(-6, 6, 2)
        velocity = rng.uniform(-10, 10, 2)
        if collide(shape, pose, Circle(radius), (*start, 0)) is not None:
            continue  # pymunk reports a start inside as a hit, whichever way it goes
        if starts_beyond_an_end(shape, pose, start, radius):
            continue
        found = in_pymunk(shape, pose).segment_query(tuple(start), tuple(start + velocity), radius)
        is_hit = found is not None and found.shape is not None
        still, moving = (0, 0, 0), (*velocity, 3)
        time = time_of_impact(shape, pose, still, Circle(radius), (*start, 0), moving, 1)
        assert (time is not None) == is_hit
        if time is not None and found is not None:
            assert time == pytest.approx(found.alpha, abs=FRACTION)
            hits += 1
    assert hits > 150


def test_circle_beyond_the_end_of_a_segment_meets_it_when_shapely_says() -> None:
    """There pymunk is late in some cases; just before our time the two are apart, after it not."""
    rng = np.random.default_rng(SEED)
    late = hits = 0
    for _ in range(4_000):
        shape, radius = random_shape(rng, "capsule"), float(10 ** rng.uniform(-1, 0))
        start = rng.uniform(-6, 6, 2)
        velocity = rng.uniform(-2, 2, 2) - start
        pose, ball = (0.0, 0.0, 0.0), Circle(radius)
        if not starts_beyond_an_end(shape, pose, start, radius):
            continue
        if collide(shape, pose, ball, (*start, 0)) is not None:
            continue
        time = time_of_impact(shape, pose, pose, ball, (*start, 0), (*velocity, 0), 1)
        if time is None:
            continue
        line = shapely.LineString(in_world(shape, pose))
        distances = [
            line.distance(shapely.Point(start + velocity * t)) - radius - shape.rounding
            for t in np.linspace(0, time, 50)[1:]
        ]
        assert min(distances[:-1]) > 0
        assert distances[-1] == pytest.approx(0, abs=DISTANCE)
        found = in_pymunk(shape, pose).segment_query(tuple(start), tuple(start + velocity), radius)
        late += found is None or found.shape is None or found.alpha > time + FRACTION
        hits += 1
    assert hits > 100
    assert late > 0  # when this fails pymunk has been mended, and the exception above can go


def geometry_at(shape: Shape, poses: Any) -> Any:
    """Return a shape of shapely for each row (x, y, angle), without its rounding."""
    x, y, angle = poses.T
    c, s = np.cos(angle), np.sin(angle)
    local = np.array(shape.outline or [(0.0, 0.0)])
    px = c[:, None] * local[:, 0] - s[:, None] * local[:, 1] + x[:, None]
    py = s[:, None] * local[:, 0] + c[:, None] * local[:, 1] + y[:, None]
    points = np.stack((px, py), axis=2)
    if len(local) == 1:
        return shapely.points(points[:, 0])
    return shapely.linestrings(points) if len(local) == 2 else shapely.polygons(points)


def distances(
    shape_a: Shape, pose_a: Any, move_a: Any, shape_b: Shape, pose_b: Any, move_b: Any, times: Any
) -> Any:
    """Return shapely's distance of two moving shapes at many times; <= 0 where they overlap."""
    a = geometry_at(shape_a, np.array(pose_a) + np.outer(times, move_a))
    b = geometry_at(shape_b, np.array(pose_b) + np.outer(times, move_b))
    return shapely.distance(a, b) - shape_a.rounding - shape_b.rounding


@pytest.mark.parametrize("kind_a", KINDS)
@pytest.mark.parametrize("kind_b", KINDS)
def test_distance_of_any_two_kinds_is_shapely_s(kind_a: str, kind_b: str) -> None:
    """Edge to edge, corner to edge and corner to corner, rounded or not, in any order."""
    rng = np.random.default_rng([SEED, *kind_a.encode(), *kind_b.encode()])
    apart = 0
    for _ in range(250):
        a, b = random_shape(rng, kind_a), random_shape(rng, kind_b)
        poses = rng.uniform((-4, -4, -4), (4, 4, 4), (2, 3)).tolist()
        corners: list[Corner] = []
        rows = [
            place(shape.outline, shape.rounding, tuple(pose), corners)
            for shape, pose in zip((a, b), poses, strict=True)
        ]
        at = RelativePose(
            rows[1].x - rows[0].x, rows[1].y - rows[0].y, *(f(p[2]) for p in poses for f in TURN)
        )
        measured, nx, ny = separation_rows(corners, *rows, at)
        assert math.hypot(nx, ny) == pytest.approx(1, abs=DISTANCE)
        cores = measured + a.rounding + b.rounding
        expected = distances(a, poses[0], (0, 0, 0), b, poses[1], (0, 0, 0), np.zeros(1))[0]
        assert max(cores, 0) - a.rounding - b.rounding == pytest.approx(expected, abs=DISTANCE)
        apart += cores > 0
    assert apart > 100


TURN = (math.cos, math.sin)

SAMPLES = 1_000
"""In 2 s; turning at up to 30 rad/s a corner 3 m out moves by 0.18 m between two of them."""

HAIR = 1e-9
"""s: enough to overlap. At 0.1 m/s shapes close the tolerance, some 1e-12 m, in 1e-11 s."""


@pytest.mark.parametrize("fastest", [0.0, 3.0, 30.0], ids=["not turning", "3 rad/s", "30 rad/s"])
def test_moving_outlines_meet_when_shapely_says(fastest: float) -> None:
    """Before the time no sample overlaps; at it they touch; a hair later they overlap.

    Where no impact is found, no sample overlaps.
    """
    rng = np.random.default_rng([SEED, int(fastest)])
    hits = 0
    for _ in range(200):
        a, b = (random_shape(rng, rng.choice(KINDS[1:])) for _ in range(2))
        poses = rng.uniform((-5, -5, -4), (5, 5, 4), (2, 3))
        moves = rng.uniform((-1, -1, -fastest), (1, 1, fastest), (2, 3))
        moves[:, :2] -= poses[:, :2]  # after 1 s both are near the origin

        def gap(times: Any, a: Shape = a, b: Shape = b, p: Any = poses, m: Any = moves) -> Any:
            return distances(a, p[0], m[0], b, p[1], m[1], np.asarray(times))

        if gap([0.0])[0] <= 0:
            continue
        time = time_of_impact(a, poses[0], moves[0], b, poses[1], moves[1], 2)
        if time is None:
            assert (gap(np.linspace(0, 2, SAMPLES)) > 0).all()
            continue
        hits += 1
        assert (gap(np.linspace(0, time, SAMPLES)[:-1]) > 0).all()
        sizes = a.bounding_radius + b.bounding_radius
        assert gap([time])[0] == pytest.approx(0, abs=1.1 * TOLERANCE * sizes)
        assert gap([time + HAIR])[0] <= 0
    assert hits > 100
