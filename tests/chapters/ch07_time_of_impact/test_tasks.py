"""The tasks of chapter 07: what they expect, what they draw, and the faults they are about."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from decimal import Decimal, localcontext
from fractions import Fraction
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch07_time_of_impact import draws as flights
from lesson_code.chapters.ch07_time_of_impact import tasks
from lesson_code.chapters.ch07_time_of_impact import wrong_answers as wrong
from lesson_code.chapters.ch07_time_of_impact import wrong_answers_about_events as events
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import ANSWER_TOLERANCE, Arguments

ROUNDING = 1e-12
"""The numbers below are of order 1 to 10, each the result of a few dozen operations."""

CLEAR = 0.02
"""s: nothing that is drawn turns on less, so that no wrong model is right by luck."""

STREAMS = [Random(seed) for seed in range(100)]  # noqa: S311 - not for secrets

sweep_circles = task_by_id("7.1").expected
time_to_floor = task_by_id("7.2").expected
advance = task_by_id("7.3").expected
next_event = task_by_id("7.4").expected
pi_collisions = task_by_id("7.5").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


def arrays(values: Iterable[Any]) -> list[Any]:
    """Return tuples as arrays, as a student's function gets them."""
    return [np.array(value, float) if isinstance(value, tuple) else value for value in values]


def exact_roots(arguments: Arguments) -> tuple[float, float] | None:
    """Return both times at which two circles are in touch, from fifty digits, if they ever are."""
    p1, v1, r1, p2, v2, r2, _ = arguments
    with localcontext() as context:
        context.prec = 50
        d = [Decimal(b) - Decimal(a) for a, b in zip(p1, p2, strict=True)]
        v = [Decimal(b) - Decimal(a) for a, b in zip(v1, v2, strict=True)]
        a, b = v[0] ** 2 + v[1] ** 2, d[0] * v[0] + d[1] * v[1]
        inside = b * b - a * (d[0] ** 2 + d[1] ** 2 - (Decimal(r1) + Decimal(r2)) ** 2)
        if a == 0 or inside < 0:
            return None
        return float((-b - inside.sqrt()) / a), float((-b + inside.sqrt()) / a)


# What is expected, by hand


@pytest.mark.parametrize(
    ("given", "t"),
    [
        pytest.param(((0, 0), (3, 0), 2, (14, 3), (-2, 0), 3, 9), 2.0, id="across, 3-4-5"),
        pytest.param(((0, 0), (3, 0), 2, (14, 3), (-2, 0), 3, 2.1), 2.0, id="just in the step"),
        pytest.param(((0, 0), (3, 0), 2, (14, 3), (-2, 0), 3, 1.9), None, id="too late"),
        pytest.param(((0, 0), (3, 0), 2, (14, 6), (-2, 0), 3, 9), None, id="a miss"),
        pytest.param(((0, 0), (3, 0), 2, (14, 3), (3, 0), 3, 9), None, id="side by side"),
        pytest.param(((0, 0), (3, 0), 2, (3, 4), (2, 0), 3, 9), 0.0, id="touching, approaching"),
        pytest.param(((0, 0), (3, 0), 2, (3, 4), (4, 0), 3, 9), None, id="touching, parting"),
        pytest.param(((0, 0), (3, 0), 2, (1, 1), (0, 0), 3, 9), 0.0, id="overlapping, approaching"),
    ],
)
def test_sweep_expected_is_worked_by_hand(given: Arguments, t: float | None) -> None:
    """At the touch the centres are 5 m apart."""
    got = sweep_circles(*arrays(given))
    assert got == (None if t is None else pytest.approx(t, abs=ROUNDING))


@pytest.mark.parametrize(
    ("given", "t"),
    [
        pytest.param((5, 0, 10), 1.0, id="dropped"),
        pytest.param((15, 10, 10), 3.0, id="thrown up"),
        pytest.param((15, -10, 10), 1.0, id="thrown down"),
        pytest.param((0, 10, 10), 2.0, id="has just bounced"),
        pytest.param((0, -10, 10), 0.0, id="is about to bounce"),
        pytest.param((6, -2, 0), 3.0, id="without gravity"),
        pytest.param((6, 2, 0), None, id="without gravity, upwards"),
    ],
)
def test_floor_expected_is_worked_by_hand(given: Arguments, t: float | None) -> None:
    """H + v t - g t^2 / 2 = 0."""
    got = time_to_floor(*given)
    assert got == (None if t is None else pytest.approx(t, abs=ROUNDING))


def test_step_expected_is_worked_by_hand() -> None:
    """A room of 4 m by 2 m, e = 1/2: to the right wall in 1 s, back at 1 m/s; to the top in 2 s.

    Along x the ball is at 4 - 2.5 = 1.5 m after 3.5 s. Along y it starts 1 m below the top, gets
    there after 2 s at 0.5 m/s, and comes back at 0.25 m/s.
    """
    p, v = advance(np.array([2.0, 1.0]), np.array([2.0, 0.5]), np.array([4.0, 2.0]), 0.5, 3.5)
    assert p == pytest.approx([1.5, 2 - 1.5 * 0.25], abs=ROUNDING)
    assert v == pytest.approx([-1.0, -0.25], abs=ROUNDING)


def test_event_expected_is_worked_by_hand() -> None:
    """Three discs of 1 m on a line: 0 and 1 close 6 m at 1 m/s, 1 and 2 close 4 m at 2 m/s."""
    places, ways = np.array([(0, 0), (8, 0), (14, 0)]), np.array([(1, 0), (0, 0), (-2, 0)])
    assert next_event(places, ways, np.ones(3)) == (2.0, 1, 2)
    assert next_event(places, -ways, np.ones(3)) is None
    assert next_event(places[:1], ways[:1], np.ones(1)) is None


# What is drawn


@pytest.mark.parametrize("cases", [flights.hits, flights.late_hits, flights.misses])
def test_drawn_sweeps_agree_with_fifty_digits(
    cases: Callable[[Random], Iterable[Arguments]],
) -> None:
    """The expected time is the smaller root, where it lies in the step; else None."""
    for given in drawn(cases):
        roots, dt = exact_roots(given), given[-1]
        expected = sweep_circles(*arrays(given))
        if roots is not None and 0 <= roots[0] <= dt:
            assert expected == pytest.approx(roots[0], abs=ROUNDING)
        else:
            assert expected is None


def test_drawn_hits_are_inside_the_step_and_late_ones_outside() -> None:
    """Not at an end of it, and with a later root of their own."""
    for given in drawn(flights.hits):
        first, second = exact_roots(given) or (math.nan, math.nan)
        assert CLEAR < first < given[-1] - CLEAR
        assert second - first > CLEAR
    for place, given in enumerate(drawn(flights.late_hits)):
        first, _ = exact_roots(given) or (0.0, 0.0)
        assert given[-1] == math.inf if place % 3 == 2 else given[-1] < first - CLEAR


def test_drawn_grazes_lie_between_two_of_ten_samples() -> None:
    """The circles overlap for less than a tenth of the step, and for more than a hundredth."""
    for given in drawn(flights.fast_grazes):
        first, second = exact_roots(given) or (math.nan, math.nan)
        sample = given[-1] / flights.SAMPLES
        assert math.floor(first / sample) == math.floor(second / sample)
        assert second - first > 0.1 * sample
        assert sweep_circles(*arrays(given)) == pytest.approx(first, abs=ROUNDING)


def test_drawn_touching_circles_touch_exactly() -> None:
    """No rounding decides: in exact arithmetic the distance is r1 + r2."""
    for place, (p1, v1, r1, p2, v2, r2, _) in enumerate(drawn(flights.in_touch)):
        d = [Fraction(b) - Fraction(a) for a, b in zip(p1, p2, strict=True)]
        v = [Fraction(b) - Fraction(a) for a, b in zip(v1, v2, strict=True)]
        approaching = d[0] * v[0] + d[1] * v[1] < 0
        distance, reach = d[0] ** 2 + d[1] ** 2, (Fraction(r1) + Fraction(r2)) ** 2
        assert distance == reach if place % 4 >= 2 else distance < Fraction(9, 10) * reach
        assert approaching is (place % 2 == 0)


def test_drawn_falls_need_what_they_are_about() -> None:
    """Without gravity to speak of, the formula from school loses what the answer has to keep."""
    for given in drawn(tasks.nearly_weightless)[::6]:
        school = wrong.school_formula(*given)
        assert school is not None
        assert abs(school - time_to_floor(*given)) > 1e3 * ANSWER_TOLERANCE
    assert all(height > 0.9 for height, _, _ in drawn(tasks.thrown_down))
    assert {given[0] for given in drawn(tasks.at_the_floor)} == {0.0}


@pytest.mark.parametrize(
    ("cases", "counts"),
    [
        (tasks.without_an_impact, {0}),
        (tasks.with_one_impact, {1}),
        (tasks.with_several_impacts, {3, 8}),
    ],
)
def test_drawn_steps_have_as_many_impacts_as_they_say(
    cases: Callable[[Random], Iterable[Arguments]], counts: set[int]
) -> None:
    """Counted by flying each axis on its own in exact fractions."""
    found = {sum(map(impacts_on_axis, *axes(given))) for given in drawn(cases)}
    assert found == counts


def axes(given: Arguments) -> tuple[list[Any], ...]:
    """Return place, velocity and room of both axes, and restitution and step for each."""
    p, v, room, e, dt = given
    return list(p), list(v), list(room), [e, e], [dt, dt]


def impacts_on_axis(x: float, v: float, size: float, e: float, dt: float) -> int:
    """Return how often a ball between 0 and `size` meets an end in a time."""
    way, left, speed = Fraction(size) - Fraction(x) if v > 0 else Fraction(x), Fraction(dt), abs(v)
    count = 0
    while way / Fraction(speed) < left:
        left -= way / Fraction(speed)
        way, speed, count = Fraction(size), speed * e, count + 1
    return count


def test_drawn_starts_at_a_wall_are_on_it() -> None:
    """To the last bit; two of three move into it."""
    for place, (p, v, room, _, _) in enumerate(drawn(tasks.starting_at_a_wall)):
        assert p[0] == (room[0] if place % 3 == 1 else 0.0)
        assert (v[0] > 0) is (place % 3 != 0)


def test_drawn_crowds_are_no_matter_of_nearness_order_or_luck() -> None:
    """In the crowds the pair that meets first is not the nearest, nor the first in the list.

    Neither of its circles is the other's nearest. Its places are first and last, any, the last.
    """
    for place, given in enumerate(drawn(flights.crowds)):
        right, values = next_event(*arrays(given)), arrays(given)
        assert right is not None
        numbers = right[1:]
        assert numbers == ((0, 7), (1, 5), (6, 7))[place % 3]
        neighbours = events.only_neighbours(*values)
        assert neighbours is not None
        assert (neighbours[1:] == numbers) is (place % 3 == 2)
        for model in (events.the_nearest_pair, events.the_first_pair_found):
            assert model(*values) != right
        positions, _, radii = values
        for one, other in (numbers, numbers[::-1]):
            gaps = np.hypot(*(positions - positions[one]).T) - radii
            gaps[one] = math.inf
            assert np.argmin(gaps) != other
    late = [next_event(*arrays(g))[0] for g in drawn(flights.crowds_soon_and_late)[3::4]]
    assert 20 < min(late) <= max(late) < 50
    assert all(next_event(*arrays(g))[0] == 0.0 for g in drawn(flights.crowds_with_a_hit_now))
    parting = [next_event(*arrays(g)) is None for g in drawn(flights.crowds_that_part)]
    assert parting == [False, False, True, True] * (len(parting) // 4)


def test_drawn_ratios_are_clear_of_the_limits() -> None:
    """A count does not turn on the last digit, and four of five are not made of digits of pi."""
    ratios = [given[0] for given in drawn(tasks.any_ratio)]
    turns = [math.pi / math.atan(1 / math.sqrt(ratio)) % 1 for ratio in ratios]
    assert min(turns) > 0.1
    assert max(turns) < 0.9
    for place, ratio in enumerate(ratios):
        if place % 5 != 4:
            assert events.digits_of_pi(ratio) != pi_collisions(ratio)


# What is said


def test_messages_say_why() -> None:
    """Each says in numbers what is wrong with an answer."""
    given: Arguments = ((0, 0), (3, 0), 2, (14, 3), (-2, 0), 3, 9)
    assert "At your t the centres are 7.61577 m apart; r1 + r2 is 5 m." in (
        tasks.distance_at_the_answer(given, 1.4)
    )
    assert "come as near as 3 m" in tasks.distance_at_the_answer(given, None)
    assert "10 m above the floor" in tasks.height_at_the_answer((5, 10, 10), 1.0)
    assert tasks.height_at_the_answer((5, 10, 10), None) == ""
    step: Arguments = ((2, 1), (2, 0.5), (4, 2), 0.5, 3.5)
    assert tasks.impacts_in_the_step(step, None) == "Impacts in this step of 3.5 s: 1, 2."
    crowd: Arguments = (((0, 0), (8, 0)), ((1, 0), (0, 0)), (1, 1))
    assert tasks.what_all_pairs_do(crowd, None) == "Left alone, these meet: 0 and 1 at 6 s."


# The faults themselves, measured


def test_school_formula_loses_its_digits_to_weak_gravity() -> None:
    """A ball at 1 m that drifts down at 1 m/s: right after 1 s, by the formula up to 10 % off."""
    assert time_to_floor(1.0, -1.0, 1e-15) == pytest.approx(1, abs=ROUNDING)
    school = wrong.school_formula(1.0, -1.0, 1e-15)
    assert school is not None
    assert abs(school - 1) > 0.05


def test_ten_samples_see_nothing_of_a_fast_graze() -> None:
    """Circles that meet for three hundredths of a step."""
    given = arrays(((0.0, 0.0), (0.0, 0.0), 1.0, (-55.0, 0.0), (100.0, 0.0), 0.5, 1.0))
    assert sweep_circles(*given) == pytest.approx(0.535, abs=ROUNDING)
    assert wrong.ten_samples(*given) is None


def test_now_is_no_time_loses_the_pair_that_meets_now() -> None:
    """`if t` says of 0.0 that there is no hit."""
    places, ways = np.array([(0.0, 0.0), (2.0, 0.0)]), np.array([(1.0, 0.0), (0.0, 0.0)])
    assert next_event(places, ways, np.ones(2)) == (0.0, 0, 1)
    assert events.now_is_no_time(places, ways, np.ones(2)) is None
