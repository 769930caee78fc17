"""The tasks of chapter 09: what they expect, what they draw, and the faults they are about."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch09_hard_cases import tasks
from lesson_code.chapters.ch09_hard_cases import wrong_answers as wrong
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import ANSWER_TOLERANCE, Arguments
from lesson_code.formulas.smooth_pair import smooth_impulse
from lesson_code.reference import impact_closed_forms as closed
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction
from lesson_code.reference.rigid_body_closed_forms import stack_forces

ROUNDING = 1e-12
"""The numbers below are of order 1 to 100, and each is the result of a dozen operations."""

STREAMS = [Random(seed) for seed in range(100)]  # noqa: S311 - not for secrets

tower_forces = task_by_id("9.1").expected
sweeps_needed = task_by_id("9.2").expected
sliding_impulse = task_by_id("9.3").expected
energy_ratio = task_by_id("9.4").expected
one_by_one = task_by_id("9.5").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


# What is expected


def test_tower_forces_expected_are_the_closed_form() -> None:
    """3 kg on 2 kg on 1 kg, g = 10 m/s^2: 60 N, 50 N, 30 N."""
    assert tower_forces((1.0, 2.0, 3.0), 10.0).tolist() == [60, 50, 30]
    np.testing.assert_allclose(
        tower_forces((4.0, 0.5, 7.0), 9.81), stack_forces([4.0, 0.5, 7.0], 9.81), rtol=ROUNDING
    )


@pytest.mark.parametrize(
    ("light", "heavy", "left", "count"), [(1, 1, 0.5, 1), (1, 3, 0.75, 1), (1, 3, 0.5, 3)]
)
def test_sweeps_expected_are_the_least_that_do(
    light: int, heavy: int, left: float, count: int
) -> None:
    """In fractions: one sweep less is too few."""
    part = Fraction(heavy, heavy + light)
    assert part**count <= Fraction(left) < part ** (count - 1)
    assert sweeps_needed(light, heavy, left) == count


def test_sliding_impulse_expected_is_that_of_a_rod_in_the_closed_form() -> None:
    """A rod at 45 degrees that slides on through the impact: knn = 5/2, knt = -3/2, mu = 0.2."""
    arm = (-math.sqrt(0.5), -math.sqrt(0.5))
    rod = Struck(1.0, 3.0, (1.0, -0.01), 0.0, arm)
    right = impact_with_friction(Struck(0, 0, (0, 0), 0, (0, 0)), rod, (0, 1), 0.0, 0.2)
    assert right.kind == "slides"
    # With n = (0, 1) the tangent is (-1, 0): vt and knt change their signs together.
    for way in (1, -1):
        found = sliding_impulse(-0.01, -1.0 * way, 2.5, 1.5 * way, 0.2)
        assert found == pytest.approx(right.normal_impulse, abs=ROUNDING)


def test_sliding_impulse_expected_knows_the_limit_cycle_and_the_jam() -> None:
    """With mu = 2: drawn, 1e-3/5.5 N s; pushed, none."""
    assert sliding_impulse(-1e-3, 1.0, 2.5, -1.5, 2.0) == pytest.approx(1e-3 / 5.5, abs=ROUNDING)
    assert sliding_impulse(-1e-3, 1.0, 2.5, 1.5, 2.0) is None
    assert sliding_impulse(1e-3, 1.0, 2.5, 1.5, 2.0) == 0.0


def test_energy_ratio_expected_by_hand() -> None:
    """2 kg, 1 kg m^2, 1 m/s along x; a blow of 2 N s up at 1 m to the right: 1 J, then 1+1+2 J."""
    ratio = energy_ratio(2.0, 1.0, (1.0, 0.0), 0.0, (1.0, 0.0), (0.0, 2.0))
    assert ratio == pytest.approx((1 + 1 + 2) / 1, abs=ROUNDING)


@pytest.mark.parametrize("moving", [1, 2, 3, 4])
def test_one_by_one_expected_of_equal_balls_is_as_many_out_as_in(moving: int) -> None:
    """For one ball the closed form says so, too."""
    v = one_by_one((1.0,) * 5, (1.0,) * moving + (0.0,) * (5 - moving))
    assert v.tolist() == [0.0] * (5 - moving) + [1.0] * moving
    if moving == 1:
        np.testing.assert_allclose(v, closed.cradle_one_by_one(5, 1.0), atol=ROUNDING)


def test_one_by_one_expected_of_two_balls_is_the_impulse_of_a_pair() -> None:
    """Masses 1 and 3 kg, head-on: the law of chapter 01."""
    j = smooth_impulse((2.0, 0.0), 1.0, (-1.0, 0.0), 3.0, (1.0, 0.0), restitution=1.0)
    v = one_by_one((1.0, 3.0), (2.0, -1.0))
    change = abs(float(j[0]))
    np.testing.assert_allclose(v, [2.0 - change, -1.0 + change / 3], atol=ROUNDING)


# What is drawn


def test_drawn_rows_keep_momentum_and_energy_and_end_quiet() -> None:
    """Whatever is drawn: the three things that a row of elastic balls has to do."""
    for cases in (tasks.equal_balls, tasks.from_the_other_side, tasks.unequal_balls):
        for masses, velocities in drawn(cases):
            m, u = np.array(masses), np.array(velocities)
            v = one_by_one(masses, velocities)
            assert m @ v == pytest.approx(m @ u, abs=1e-9)
            assert m @ v**2 == pytest.approx(m @ u**2, abs=1e-9)
            assert np.diff(v).min() >= -tasks.QUIET


def test_drawn_tips_jam_and_slide_as_they_should() -> None:
    """Of the jammed ones every other has no answer; of the others all have one."""
    answers = [sliding_impulse(*given) for given in drawn(tasks.jammed)]
    assert [answer is None for answer in answers] == [True, False] * (len(answers) // 2)
    for given in drawn(tasks.lifted_or_pressed):
        jn, (vn, vt, knn, knt, mu) = sliding_impulse(*given), given
        assert jn is not None
        assert vn + knn * jn - mu * math.copysign(1, vt) * knt * jn == pytest.approx(0, abs=1e-9)


def test_drawn_loads_of_a_billion_tell_the_digits() -> None:
    """The logarithm of M/(M + m) is off by more than an answer may be."""
    for given in drawn(tasks.huge_loads):
        assert abs(wrong.digits_lost(*given) / sweeps_needed(*given) - 1) > 1e-9


def test_drawn_blows_beside_the_centre_turn_the_body() -> None:
    """Who leaves the spin as it was, or turns it the other way, is found out."""
    for given in drawn(tasks.beside_the_centre):
        mass, inertia, velocity, w, arm, impulse = given
        arrays: Any = (mass, inertia, np.array(velocity), w, np.array(arm), np.array(impulse))
        right = energy_ratio(*given)
        for model in (wrong.spin_stays, wrong.turns_the_other_way, wrong.torque_of_lengths):
            assert abs(model(*arrays) - right) > 10 * ANSWER_TOLERANCE * right


# What is said


def test_messages_say_why() -> None:
    """Each says in numbers what is wrong with an answer."""
    assert "60 N" in tasks.sum_of_weights(((1.0, 2.0, 3.0), 10.0), None)
    assert "0.5 of the approach is left" in tasks.left_after((1.0, 1.0, 0.1), 1)
    assert tasks.left_after((1.0, 1.0, 0.1), None) == ""
    assert "vn = -1 m/s" in tasks.velocity_of_the_tip((-2.0, 1.0, 1.0, 0.0, 0.5), 1.0)
    assert tasks.velocity_of_the_tip((-2.0, 1.0, 1.0, 0.0, 0.5), None) == ""
    told = tasks.momentum_and_energy(((1.0, 1.0), (1.0, 0.0)), (0.5, 0.5))
    assert told == "Momentum 1 kg m/s before and 1 after; energy 0.5 J and 0.25 J."
    assert tasks.momentum_and_energy(((1.0, 1.0), (1.0, 0.0)), 3.0) == ""
