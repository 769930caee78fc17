"""The tasks of chapter 04: what they expect, what they draw, and the faults they are about."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters import draws
from lesson_code.chapters.ch04_circles import tasks as circles
from lesson_code.chapters.ch04_circles import wrong_answers as wrong
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments
from lesson_code.geometry import Circle, collide

ROUNDING = 1e-12
"""The numbers below are of order 1 to 1000, and each is the result of a dozen operations."""

ROUNDED_TO_CENTIMETRES = 0.01
"""m: drawn positions have two decimals, so a drawn distance may be off by so much."""

STREAMS = [Random(seed) for seed in range(200)]  # noqa: S311 - not for secrets

HEAD_ON = (np.array([2.0, 0.0]), 1.0, np.array([-2.0, 0.0]), 1.0, np.array([1.0, 0.0]))
"""v1, m1, v2, m2 and normal of a head-on hit of equal masses, its momentum zero."""

circle_contact = task_by_id("4.1").expected
resolve_circles = task_by_id("4.2").expected
separate = task_by_id("4.3").expected
resolve_overlap = task_by_id("4.4").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


def vectors(values: Iterable[Any]) -> list[Any]:
    """Return tuples as arrays, as a student's function gets them."""
    return [np.array(value) if isinstance(value, tuple) else value for value in values]


# What is expected, by hand


@pytest.mark.parametrize(
    ("circles_given", "normal", "depth"),
    [
        pytest.param(((1, 2), 2, (4, 6), 3.5), (0.6, 0.8), 0.5, id="3-4-5"),
        pytest.param(((4, 6), 3.5, (1, 2), 2), (-0.6, -0.8), 0.5, id="3-4-5, order turned round"),
        pytest.param(((0, 0), 3, (1, 0), 1), (1, 0), 3, id="one inside the other"),
        pytest.param(((7, -3), 1, (7, -3), 2), (1, 0), 3, id="the same centre"),
    ],
)
def test_contact_expected_is_worked_by_hand(
    circles_given: Arguments, normal: draws.Vector, depth: float
) -> None:
    """The normal is the unit vector from centre to centre, the depth r1 + r2 - d."""
    got_normal, got_depth = circle_contact(*vectors(circles_given))
    assert got_normal == pytest.approx(normal, abs=ROUNDING)
    assert got_depth == pytest.approx(depth, abs=ROUNDING)


@pytest.mark.parametrize("gap", [0.0, 1e-9, 1.0])
def test_contact_expected_is_none_without_overlap(gap: float) -> None:
    """Touching is not overlapping."""
    assert circle_contact(*vectors(((0.0, 0.0), 1.0, (3.0 + gap, 0.0), 2.0))) is None


def test_contact_expected_is_that_of_the_engine() -> None:
    """The narrow phase finds the same contacts, in all the circles that the task draws."""
    for cases in (circles.overlapping, circles.near_each_other, circles.on_the_same_centre):
        for p1, r1, p2, r2 in drawn(cases):
            expected = circle_contact(*vectors((p1, r1, p2, r2)))
            manifold = collide(Circle(r1), (*p1, 0.0), Circle(r2), (*p2, 0.0))
            assert (manifold is None) is (expected is None)
            if manifold is not None:
                assert manifold.normal == pytest.approx(expected[0], abs=ROUNDING)
                assert manifold.penetrations == pytest.approx([expected[1]], abs=ROUNDING)


def test_hit_expected_is_worked_by_hand() -> None:
    """1 kg at 2 m/s meets 3 kg at -1 m/s along (0.6, 0.8) with e = 0.7, each with a tangent part.

    Along the normal V = -1/4, so v1' = -1/4 - 0.7 (2 + 1/4) = -1.825 and v2' = 0.275.
    """
    n, t = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
    w1, w2 = resolve_circles(2 * n + 5 * t, 1.0, -1 * n - 7 * t, 3.0, n, 0.7)
    assert w1 == pytest.approx(-1.825 * n + 5 * t, abs=ROUNDING)
    assert w2 == pytest.approx(0.275 * n - 7 * t, abs=ROUNDING)


def test_hit_expected_leaves_a_separating_pair_alone() -> None:
    """Not a bit of a velocity changes."""
    v1, v2, n = np.array([-1.3, 0.7]), np.array([2.1, -0.9]), np.array([0.6, 0.8])
    w1, w2 = resolve_circles(v1, 1.0, v2, 3.0, n, 0.7)
    assert (w1.tolist(), w2.tolist()) == (v1.tolist(), v2.tolist())


@pytest.mark.parametrize(
    ("m1", "m2", "way_1", "way_2"),
    [(1, 1, 2.5, 2.5), (1, 3, 3.75, 1.25), (1, 999, 4.995, 0.005), (math.inf, 2, 0, 5)],
)
def test_way_apart_expected_is_in_inverse_proportion_to_mass(
    m1: float, m2: float, way_1: float, way_2: float
) -> None:
    """The ways add up to the depth of 5, and m1 way_1 = m2 way_2; what is fixed stays."""
    n = np.array([0.6, 0.8])
    for a, b, order in ((m1, m2, 1), (m2, m1, -1)):
        ways = (way_1, way_2)[::order]
        q1, q2 = separate(np.zeros(2), a, np.zeros(2), b, n, 5.0)
        assert q1 == pytest.approx(-ways[0] * n, abs=ROUNDING)
        assert q2 == pytest.approx(ways[1] * n, abs=ROUNDING)


def test_overlap_expected_is_separated_whether_or_not_it_is_bounced() -> None:
    """A fixed circle and one of 2 kg: the free one moves all the way, and bounces if it comes."""
    given = [np.zeros(2), np.zeros(2), math.inf, np.array([1.0, 0.0]), np.array([-4.0, 3.0]), 2.0]
    n = np.array([1.0, 0.0])
    q1, w1, q2, w2 = resolve_overlap(*given, n, 0.5, 0.5)
    assert [q1, w1, q2, w2] == [pytest.approx(v) for v in ((0, 0), (0, 0), (1.5, 0), (2, 3))]
    given[4] = np.array([4.0, 3.0])
    q1, w1, q2, w2 = resolve_overlap(*given, n, 0.5, 0.5)
    assert [q1, w1, q2, w2] == [pytest.approx(v) for v in ((0, 0), (0, 0), (1.5, 0), (4, 3))]


# What is drawn


def test_drawn_overlaps_are_deep_oblique_and_of_unequal_radii() -> None:
    """No wrong model is right by luck: depth, direction and radii are far from special."""
    for p1, r1, p2, r2 in drawn(circles.overlapping):
        x, y = np.abs(np.subtract(p2, p1))
        assert r1 + r2 - math.hypot(x, y) > 0.1 * (r1 + r2) - 2 * ROUNDED_TO_CENTIMETRES
        assert math.hypot(x, y) ** 2 > r1 + r2 + 0.1
        assert min(x, y, abs(x - y)) > 0.2
        assert max(r1, r2) > 1.4 * min(r1, r2)


def test_drawn_misses_are_of_circles_whose_boxes_overlap() -> None:
    """The first pair of "near each other" is told from a hit by the diagonal alone."""
    pairs = drawn(circles.near_each_other)
    for (p1, r1, p2, r2), meets in zip(
        pairs, [False, True, True, True, True] * len(STREAMS), strict=True
    ):
        assert (math.dist(p1, p2) < r1 + r2 - 0.04) is meets
        assert (math.dist(p1, p2) > r1 + r2 + 0.04) is not meets
        assert max(np.abs(np.subtract(p2, p1))) < r1 + r2 - 0.04


def test_drawn_touching_circles_touch_exactly() -> None:
    """In exact arithmetic the gaps are 0, 1/1024 and -1/1024 m, so that rounding has no say."""
    gaps = [Fraction(0), Fraction(1, 1024), Fraction(-1, 1024)] * len(STREAMS)
    for (p1, r1, p2, r2), gap in zip(drawn(circles.just_touching), gaps, strict=True):
        x, y = (Fraction(b) - Fraction(a) for a, b in zip(p1, p2, strict=True))
        assert x * x + y * y == (Fraction(r1) + Fraction(r2) + gap) ** 2
        assert min(r1, r2) > 0


def test_drawn_circles_on_one_centre_are_on_one_centre() -> None:
    """The centres are equal to the last bit in one case; in the next a direction is left."""
    pairs = drawn(circles.on_the_same_centre)
    apart = [math.dist(p1, p2) for p1, _, p2, _ in pairs]
    assert apart[0::3] == [0.0] * len(STREAMS)
    assert apart[1::3] == [5 * circles.NEARLY] * len(STREAMS)
    for p1, r1, p2, r2 in pairs[2::3]:
        assert p1[0] == p2[0]
        assert 0.7 * (r1 + r2) < math.dist(p1, p2) < 0.95 * (r1 + r2)


SLOWEST = 0.01
"""m/s: that of draws.creep."""


@pytest.mark.parametrize(
    ("cases", "sign"),
    [(circles.approaching, -1), (circles.separating, 1), (circles.without_loss, -1)],
)
def test_drawn_hits_approach_or_separate_and_both_circles_move(
    cases: Callable[[Random], Iterable[Arguments]], sign: int
) -> None:
    """Both circles move, also across the normal, and one is heavier."""
    for v1, m1, v2, m2, n, _ in drawn(cases):
        assert sign * np.dot(np.subtract(v2, v1), n) > SLOWEST - ROUNDING
        assert math.hypot(*n) == pytest.approx(1, abs=ROUNDING)
        assert min(abs(np.dot(v, (-n[1], n[0]))) for v in (v1, v2)) > 0
        assert max(m1, m2) > 1.4 * min(m1, m2)


def test_drawn_hits_are_head_on_or_not() -> None:
    """1 catches up with 2, then 2 with 1, and then they hardly approach."""
    pairs = [(np.dot(v1, n), np.dot(v2, n)) for v1, _, v2, _, n, _ in drawn(circles.approaching)]
    assert all(0 < after < before for before, after in pairs[::3])
    assert all(after < before < 0 for before, after in pairs[1::3])
    assert all(before - after < 0.1 for before, after in pairs[2::3])


def test_drawn_restitutions_without_loss_are_the_limits() -> None:
    """The criterion is about e = 1 and e = 0."""
    assert {arguments[-1] for arguments in drawn(circles.without_loss)} == {0.0, 1.0}


def test_drawn_overlaps_have_the_masses_their_names_say() -> None:
    """Equal; then the heavier first and last; then the fixed one first and last."""
    assert all(m1 == m2 for _, m1, _, m2, _, _ in drawn(circles.of_equal_masses))
    unequal = [m1 / m2 for _, m1, _, m2, _, _ in drawn(circles.of_unequal_masses)]
    assert all(ratio < 0.7 for ratio in unequal[::2])
    assert all(ratio > 1.4 for ratio in unequal[1::2])
    for cases, first, second in ((circles.one_fixed, 1, 3), (circles.against_a_fixed_one, 2, 5)):
        fixed = [(math.isinf(a[first]), math.isinf(a[second])) for a in drawn(cases)]
        assert fixed == [(True, False), (False, True)] * len(STREAMS)


@pytest.mark.parametrize(
    ("cases", "sign"),
    [
        (circles.overlapping_and_approaching, -1),
        (circles.overlapping_but_separating, 1),
        (circles.against_a_fixed_one, -1),
    ],
)
def test_drawn_pairs_approach_or_separate_and_what_is_fixed_is_at_rest(
    cases: Callable[[Random], Iterable[Arguments]], sign: int
) -> None:
    """A fixed circle that moved would have no momentum to speak of."""
    for _, v1, m1, _, v2, m2, n, depth, restitution in drawn(cases):
        assert sign * np.dot(np.subtract(v2, v1), n) > SLOWEST - ROUNDING
        assert not (math.isinf(m1) and any(v1))
        assert not (math.isinf(m2) and any(v2))
        assert depth >= 0.1
        assert 0.3 <= restitution <= 0.8


# The faults


@pytest.mark.parametrize(("e", "growth"), [(0.0, 1), (0.5, 4), (0.8, 6.76), (1.0, 9)])
def test_doubled_impulse_multiplies_the_energy_and_keeps_momentum(e: float, growth: float) -> None:
    """Head on with equal masses the speed becomes (1 + 2e) times what it was, not e times."""
    w1, w2 = wrong.doubled_impulse(*HEAD_ON, e)
    assert w1 + w2 == pytest.approx([0, 0], abs=ROUNDING)
    assert (w1 @ w1 + w2 @ w2) / 8 == pytest.approx(growth, abs=ROUNDING)
    right_1, right_2 = resolve_circles(*HEAD_ON, e)
    assert (right_1 @ right_1 + right_2 @ right_2) / 8 == pytest.approx(e**2, abs=ROUNDING)


def test_one_dimension_on_each_axis_keeps_momentum_and_energy_but_not_the_tangent() -> None:
    """Both laws are blind to it; a grazing ball comes back the way it came."""
    v1, n = np.array([3.0, 0.1]), np.array([0.0, 1.0])
    w1, w2 = wrong.one_dimension_on_each_axis(v1, 1.0, np.zeros(2), 1.0, n, 1.0)
    assert w1 + w2 == pytest.approx(v1, abs=ROUNDING)
    assert w1 @ w1 + w2 @ w2 == pytest.approx(v1 @ v1, abs=ROUNDING)
    assert w1 == pytest.approx([0, 0], abs=ROUNDING)
    assert resolve_circles(v1, 1.0, np.zeros(2), 1.0, n, 1.0)[0] == pytest.approx([3, 0])


def test_half_each_moves_the_centre_of_mass_and_a_fixed_circle() -> None:
    """1 kg and 999 kg both move 2.5 of 5 m; so does a circle that cannot move."""
    for m2 in (999.0, math.inf):
        q1, q2 = wrong.half_each(np.zeros(2), 1.0, np.zeros(2), m2, np.array([1.0, 0.0]), 5.0)
        assert (q1[0], q2[0]) == (-2.5, 2.5)


def test_returns_before_separating_leaves_the_overlap() -> None:
    """A pair that parts slowly stays where it is found, inside each other."""
    v2, n = np.array([0.01, 0.0]), np.array([1.0, 0.0])
    given = (np.zeros(2), np.zeros(2), 1.0, np.array([1.5, 0.0]), v2, 1.0, n, 0.5, 0.5)
    q1, _, q2, _ = wrong.returns_before_separating(*given)
    assert q2[0] - q1[0] == 1.5
    q1, _, q2, _ = resolve_overlap(*given)
    assert q2[0] - q1[0] == 2.0
