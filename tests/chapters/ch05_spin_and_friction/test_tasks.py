"""The tasks of chapter 05: what they expect, what they draw, and the faults they are about."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch05_spin_and_friction import tasks
from lesson_code.chapters.ch05_spin_and_friction import wrong_answers as wrong
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments

ROUNDING = 1e-12
"""The numbers below are of order 1 to 1000, and each is the result of a dozen operations."""

STREAMS = [Random(seed) for seed in range(200)]  # noqa: S311 - not for secrets

SQUARE = np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])
"""Side 2 m: its moment of inertia is m (2^2 + 2^2)/12 = 2/3 m."""

SLIDING_IN = (np.array([3.0, -4.0]), 0.0, 0.5, np.array([0.0, 1.0]), 0.5)
"""A disc of 0.5 m without spin on a floor, and the restitution: jn = 6 N s a kg, slip -3 m/s."""

moment_of_inertia = task_by_id("5.1").expected
contact_velocity = task_by_id("5.2").expected
inverse_effective_mass = task_by_id("5.3").expected
friction_impulse = task_by_id("5.4").expected
bounce_with_spin = task_by_id("5.5").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


def about_the_contact(velocity: Any, w: float, radius: float, normal: Any) -> float:
    """Return the angular momentum of a disc of 1 kg about the point where it meets a wall."""
    r = radius * np.asarray(normal)
    return float(r[0] * velocity[1] - r[1] * velocity[0] + radius**2 / 2 * w)


def slip(velocity: Any, w: float, radius: float, normal: Any) -> float:
    """Return how fast a disc's rim slides along the normal turned by +90 degrees, m/s."""
    return float(normal[0] * velocity[1] - normal[1] * velocity[0] - w * radius)


# What is expected, by hand


@pytest.mark.parametrize("shift", [(0, 0), (10, -7)])
@pytest.mark.parametrize("order", [1, -1])
def test_inertia_expected_of_a_square_is_the_same_wherever_and_in_either_order(
    shift: tuple[float, float], order: int
) -> None:
    """3 kg and a side of 2 m make 2 kg m^2; so they do with a vertex too many."""
    placed = (SQUARE + shift)[::order]
    for vertices in (placed, np.insert(placed, 1, (placed[0] + placed[1]) / 2, axis=0)):
        assert moment_of_inertia(3.0, vertices) == pytest.approx(2.0, abs=ROUNDING)


def test_contact_velocity_expected_is_worked_by_hand() -> None:
    """At r = (2, 1) and w = 3 the spin adds (-3, 6)."""
    v = contact_velocity(np.array([1.0, 1.0]), 3.0, np.array([2.0, 1.0]))
    assert v.tolist() == [-2.0, 7.0]


def test_inverse_effective_mass_expected_is_worked_by_hand() -> None:
    """Lever arms 2 m and -3 m: 1/2 + 1/4 + 4/8 + 9/9 = 2.25 per kg; the ground adds nothing."""
    n, r_a, r_b = np.array([0.0, 1.0]), np.array([2.0, 5.0]), np.array([-3.0, -5.0])
    assert inverse_effective_mass(2.0, 8.0, r_a, 4.0, 9.0, r_b, n) == pytest.approx(2.25)
    assert inverse_effective_mass(2.0, 8.0, r_a, math.inf, math.inf, r_b, n) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("vt", "friction", "jt"),
    [(3.0, 0.5, -2.0), (-3.0, 0.5, 2.0), (3.0, 2.0, -6.0), (0.0, 0.5, 0.0), (3.0, 0.0, 0.0)],
)
def test_friction_expected_stops_or_meets_its_limit(vt: float, friction: float, jt: float) -> None:
    """With k = 1/2 the sliding of 3 m/s takes 6 N s; with jn = 4 the limit is 4 mu."""
    assert friction_impulse(vt, 4.0, friction, 0.5) == pytest.approx(jt, abs=ROUNDING)


def test_bounce_expected_is_worked_by_hand() -> None:
    """With jn = 6 the slip of -3 takes jt = 1: v' = (3 - 1, 2), w' = -2 jt / r = -4; it rolls.

    With mu = 0.1 the limit is 0.6: v' = (3 - 0.6, 2) and w' = -2.4.
    """
    for friction, v, w in ((1.0, (2.0, 2.0), -4.0), (0.1, (2.4, 2.0), -2.4)):
        after = bounce_with_spin(*SLIDING_IN, friction)
        assert after[0] == pytest.approx(v, abs=ROUNDING)
        assert after[1] == pytest.approx(w, abs=ROUNDING)
    assert slip(*bounce_with_spin(*SLIDING_IN, 1.0), 0.5, (0, 1)) == pytest.approx(0, abs=ROUNDING)


@pytest.mark.parametrize("cases", [tasks.rough_walls, tasks.smooth_walls, tasks.leaving_discs])
def test_bounce_expected_keeps_the_angular_momentum_about_the_contact(
    cases: Callable[[Random], Iterable[Arguments]],
) -> None:
    """Whatever acts at the contact has no lever arm about it."""
    for velocity, w, radius, normal, restitution, friction in drawn(cases):
        v, n = np.array(velocity), np.array(normal)
        after = bounce_with_spin(v, w, radius, n, restitution, friction)
        kept = about_the_contact(velocity, w, radius, normal)
        assert about_the_contact(*after, radius, normal) == pytest.approx(kept, abs=ROUNDING)


# What is drawn


def test_drawn_polygons_are_convex_and_go_round_as_they_say() -> None:
    """All corners turn one way: left, or right where the order is said to be clockwise."""
    for cases, way in ((tasks.polygons_elsewhere, 1), (tasks.polygons_clockwise, -1)):
        for _, vertices in drawn(cases):
            edges = np.roll(vertices, -1, axis=0) - np.array(vertices)
            x, y = np.roll(edges, -1, axis=0).T
            assert min(way * (edges[:, 0] * y - edges[:, 1] * x)) > 0


def test_drawn_vertex_too_many_lies_on_an_edge() -> None:
    """Without it the polygon is the same."""
    for mass, vertices in drawn(tasks.polygons_with_a_vertex_too_many):
        first, middle, second = np.array(vertices[:3])
        assert middle == pytest.approx((first + second) / 2, abs=ROUNDING)
        without = moment_of_inertia(mass, np.delete(vertices, 1, axis=0))
        assert moment_of_inertia(mass, np.array(vertices)) == pytest.approx(without)


def test_drawn_central_hits_have_no_lever_arm_and_the_others_have() -> None:
    """Along the normal both levers lie, or neither."""
    for cases, central in ((tasks.central_hits, True), (tasks.hits_off_centre, False)):
        for _, _, r_a, _, _, r_b, n in drawn(cases):
            arms = [abs(r[0] * n[1] - r[1] * n[0]) for r in (r_a, r_b)]
            assert max(arms) < ROUNDING if central else min(arms) > 0.4


def test_drawn_contacts_grip_slip_and_creep_as_they_say() -> None:
    """Friction is below its limit, far beyond it, or hardly needed; either way round.

    Where it grips, vt is more than mu jn: that is no impulse, and tells nothing without k.
    """
    assert all(abs(vt) > mu * jn for vt, jn, mu, _ in drawn(tasks.gripping))
    for cases, low, high in ((tasks.gripping, 0.7, 0.95), (tasks.slipping, 1.3, math.inf)):
        needed = [vt / k / (friction * jn) for vt, jn, friction, k in drawn(cases)]
        assert all(low < abs(share) < high for share in needed)
        assert {np.sign(share) for share in needed} == {1, -1}
    assert all(abs(vt) < 0.01 for vt, *_ in drawn(tasks.creeping))
    assert {np.sign(vt) for vt, *_ in drawn(tasks.creeping)} == {1, 0, -1}


def test_drawn_discs_grip_slip_and_leave_as_they_say() -> None:
    """Far from the limit of friction, far beyond it, and with a velocity along the normal."""
    for cases, low, high in ((tasks.rough_walls, 0.0, 0.5), (tasks.smooth_walls, 2.0, math.inf)):
        for velocity, w, radius, normal, restitution, friction in drawn(cases):
            limit = -friction * (1 + restitution) * np.dot(velocity, normal)
            assert low < abs(slip(velocity, w, radius, normal)) / 3 / limit < high
    away = [np.dot(velocity, n) for velocity, _, _, n, *_ in drawn(tasks.leaving_discs)]
    assert min(away[::2]) > 0.5
    assert 0 < min(away[1::2]) < max(away[1::2]) < 0.1


# The faults


def test_vertex_masses_are_three_times_too_much_for_a_square_and_four_for_a_triangle() -> None:
    """Any rectangle, any triangle; and a redundant vertex changes the number."""
    assert wrong.vertex_masses(3.0, SQUARE) == pytest.approx(3 * 2.0)
    triangle = np.array([(0.0, 0.0), (3.0, 0.0), (1.0, 2.0)])
    right = moment_of_inertia(1.0, triangle)
    assert wrong.vertex_masses(1.0, triangle) == pytest.approx(4 * right)
    five = np.insert(SQUARE, 1, (0.0, -1.0), axis=0)
    assert wrong.vertex_masses(3.0, five) == pytest.approx(5.28)


def test_torque_with_the_wrong_sign_makes_slip_and_angular_momentum() -> None:
    """The slip grows by a third instead of vanishing, and angular momentum comes from nothing."""
    after = wrong.torque_with_the_wrong_sign(*SLIDING_IN, 1.0)
    assert slip(*after, 0.5, (0, 1)) == pytest.approx(4 / 3 * -3, abs=ROUNDING)
    assert about_the_contact(*after, 0.5, (0, 1)) == pytest.approx(-1.5 + 1.0, abs=ROUNDING)


def test_rim_as_heavy_as_the_disc_turns_the_slip_round() -> None:
    """The impulse that would stop a disc that cannot turn is three times too much."""
    after = wrong.rim_as_heavy_as_the_disc(*SLIDING_IN, 1.0)
    assert slip(*after, 0.5, (0, 1)) == pytest.approx(2 * 3, abs=ROUNDING)


def test_dead_band_jumps_where_friction_is_continuous() -> None:
    """Below 10 mm/s nothing, above it everything; the right one goes through 0 in a line."""
    below, above = (wrong.dead_band(vt, 4.0, 0.5, 0.01) for vt in (0.0099, 0.0101))
    assert (below, above) == (0.0, pytest.approx(-1.01))
    assert friction_impulse(0.0099, 4.0, 0.5, 0.01) == pytest.approx(-0.99)
