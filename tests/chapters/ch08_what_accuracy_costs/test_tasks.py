"""The tasks of chapter 08: what they expect, what they draw, and what they say."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from random import Random
from typing import Any

import numpy as np
import pytest

from lesson_code.chapters.ch08_what_accuracy_costs import tasks
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments

ROUNDING = 1e-12
"""A few dozen operations on numbers of order 1."""

CLEAR = 1e-4
"""Answers may be off by 1e-9."""

STREAMS = [Random(seed) for seed in range(100)]  # noqa: S311 - not for secrets

largest_error = task_by_id("8.1").expected
observed_order = task_by_id("8.2").expected
fit_power = task_by_id("8.3").expected
best_split = task_by_id("8.4").expected
cheapest = task_by_id("8.5").expected

TABLE = np.array([(1, 100, 0.06), (10, 10, 0.005), (100, 1, math.inf), (20, 10, 0.001)])
COSTS = np.array([(4.0, 0.03), (2.0, math.inf), (9.0, 0.001), (3.0, 0.05)])


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


# What is expected, by hand


def test_norm_expected_is_worked_by_hand() -> None:
    """3 m and 4 m across make 5 m, in the middle of the way."""
    right = np.array([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)])
    off = np.array([(0.0, 1.0), (3.0, -4.0), (0.0, 0.0)])
    assert largest_error(right + off, right) == pytest.approx(5, abs=ROUNDING)


@pytest.mark.parametrize(
    ("given", "order"),
    [
        ((0.1, 8.0, 0.05, 4.0), 1.0),
        ((0.1, 9.0, 0.1 / 3, 1.0), 2.0),
        ((0.05, 4.0, 0.1, 8.0), 1.0),
        ((0.1, 1.0, 0.05, 2.0), -1.0),
        ((0.1, 1.0, 0.05, 1.0), 0.0),
    ],
)
def test_order_expected_is_worked_by_hand(given: Arguments, order: float) -> None:
    """E1/E2 = (dt1/dt2)^p."""
    assert observed_order(*given) == pytest.approx(order, abs=ROUNDING)


def test_fit_expected_is_worked_by_hand() -> None:
    """Errors 3 dt^2; and of 2, 1/2, 2 times dt the slope stays 1: the middle one shifts all."""
    steps = np.array([0.4, 0.2, 0.1])
    assert fit_power(steps, 3 * steps**2) == pytest.approx((2, 3), rel=1e-9)
    order, factor = fit_power(steps, np.array([2, 0.5, 2]) * steps)
    assert order == pytest.approx(1, rel=1e-9)
    assert factor == pytest.approx(2 ** (1 / 3), rel=1e-9)


@pytest.mark.parametrize(
    ("sweeps", "split"), [(100.0, (10.0, 10.0)), (200.0, (20.0, 10.0)), (7.0, None)]
)
def test_split_expected_is_worked_by_hand(sweeps: float, split: Any) -> None:
    """The least error of equal work; what has fallen is no answer."""
    assert best_split(TABLE, sweeps) == split
    assert best_split(TABLE[2:3], 100.0) is None


@pytest.mark.parametrize(
    ("allowed", "row"), [(0.1, 3), (0.05, 3), (0.04, 0), (0.03, 0), (0.01, 2), (1e-4, None)]
)
def test_cheapest_expected_is_worked_by_hand(allowed: float, row: int | None) -> None:
    """The fastest of those that are good enough, an error of just so much included."""
    assert cheapest(COSTS, allowed) == row


# What is drawn


def test_drawn_tracks_are_worst_in_the_middle() -> None:
    """No other norm gives the same number: not the last place, not one coordinate, not the mean."""
    for places, right in drawn(tasks.small_errors) + drawn(tasks.one_large_error):
        off = np.array(places) - np.array(right)
        distances = np.hypot(*off.T)
        assert int(distances.argmax()) == 3
        assert distances[-1] < 0.8 * distances[3]
        assert np.abs(off).max() < 0.95 * distances[3]


def test_drawn_orders_are_no_whole_numbers_and_steps_differ() -> None:
    """Nobody is right by guessing 1 or 2, or by taking a half for granted."""
    for cases in (tasks.halved, tasks.shortened, tasks.the_other_way_round):
        for given in drawn(cases):
            order = observed_order(*given)
            assert 0.55 < order < 2.45
            assert abs(order - 1) > 0.05
    assert all(observed_order(*given) < 0 for given in drawn(tasks.not_converging))


def test_drawn_scatter_tells_a_fit_from_two_points() -> None:
    """First and last alone give another order, by far more than an answer may be off."""
    for steps, errors in drawn(tasks.scattered):
        ends = math.log(errors[0] / errors[-1]) / math.log(steps[0] / steps[-1])
        assert abs(ends - fit_power(np.array(steps), np.array(errors))[0]) > CLEAR


def test_drawn_tables_have_one_best_row() -> None:
    """Of equal work, with the best inside or at an end as the criterion says."""
    for cases, inside in ((tasks.optimum_inside, True), (tasks.optimum_at_an_end, False)):
        for table, sweeps in drawn(cases):
            substeps, iterations = best_split(np.array(table), sweeps)
            assert substeps * iterations == sweeps
            assert (1 < substeps < sweeps) is inside
    splits = [best_split(np.array(table), sweeps) for table, sweeps in drawn(tasks.all_fell)]
    found = [split is not None for split in splits]
    assert found == [False, False, False, True] * (len(found) // 4)


def test_drawn_costs_have_a_clear_answer() -> None:
    """The cheapest good row is neither the first, nor the most accurate, nor the fastest of all."""
    for table, allowed in drawn(tasks.one_is_cheapest) + drawn(tasks.just_allowed):
        row = cheapest(np.array(table), allowed)
        assert row is not None
        assert row != int(np.argmin([error for _, error in table]))
        assert row != int(np.argmin([time for time, _ in table]))
    rows = [cheapest(np.array(t), allowed) for t, allowed in drawn(tasks.with_failures)]
    assert [row is None for row in rows] == [False, True] * (len(rows) // 2)


# What is said


def test_messages_say_why() -> None:
    """Each says in numbers what is wrong with an answer."""
    assert tasks.distances((((3, 4),), ((0, 0),)), 7.0) == "Distances, m: (5,)."
    given: Arguments = (0.1, 8.0, 0.05, 4.0)
    assert tasks.predicted(given, 2.0) == ("With your order the second error would be 2; it is 4.")
    assert tasks.predicted(given, 1e9) == ""
    rows = tuple(map(tuple, TABLE.tolist()))
    assert tasks.sweeps_of_the_rows((rows, 200.0), None) == (
        "Rows of 200 sweeps: 20 x 10: 0.001 m."
    )
    assert tasks.rows_that_are_good_enough((tuple(COSTS.tolist()), 0.01), 0) == (
        "Good enough: row 2: 9 ms."
    )
