"""Block principal pivoting: whatever it begins with, it ends with cases that fit, or says so."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code.engine.solvers import pivoting
from lesson_code.engine.solvers.contact_problem import (
    OPEN,
    STICK,
    UNKNOWN,
    Cases,
    Problem,
    tolerance,
)
from lesson_code.engine.solvers.pivoting import ROUNDS, by_pivoting, first_guess

EXACT = 1e-9
"""m/s, of velocities of some m/s."""

seeds = st.integers(0, 10**9)


def smooth_problem(seed: int, contacts: int) -> Problem:
    """Return contacts without friction, fewer bodies' motions than contacts among them."""
    rng = np.random.default_rng(seed)
    g = rng.normal(size=(2 * contacts, contacts + 1))
    g[:contacts] = np.round(g[:contacts], 1)
    return Problem(g @ g.T, g @ rng.normal(size=contacts + 1), np.zeros(contacts))


@settings(max_examples=share(50), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds, contacts=st.integers(2, 30))
def test_velocities_do_not_depend_on_the_first_guess(seed: int, contacts: int) -> None:
    """All open, all closed, or anything: without friction there is one answer."""
    rng, problem = np.random.default_rng(seed), smooth_problem(seed, contacts)
    found = []
    for cases in (
        np.full(contacts, OPEN),
        np.full(contacts, STICK),
        rng.integers(OPEN - 1, OPEN + 1, contacts),
    ):
        answer = by_pivoting(problem, first_guess(problem, cases))
        assert answer.error <= max(tolerance(problem, answer.impulses), EXACT)
        found.append((problem.velocity + problem.delassus @ answer.impulses)[:contacts])
    np.testing.assert_allclose(found[1], found[0], atol=EXACT)
    np.testing.assert_allclose(found[2], found[0], atol=EXACT)


def test_first_guess_is_the_velocities_where_nothing_is_known() -> None:
    """What parts is open, what does not sticks; what is known of a contact comes first."""
    velocity = np.array([1.0, -1.0, 1.0, -1.0, 0, 0, 0, 0])
    problem = Problem(np.eye(8), velocity, np.ones(4))
    assert first_guess(problem, None).tolist() == [OPEN, STICK, OPEN, STICK]
    known = np.array([UNKNOWN, UNKNOWN, STICK, OPEN])
    assert first_guess(problem, known).tolist() == [OPEN, STICK, STICK, OPEN]


def test_contacts_that_are_one_are_no_obstacle() -> None:
    """Ten times the same contact: a tenth of the load on each."""
    m = 10
    k = np.zeros((2 * m, 2 * m))
    k[:m, :m] = 1.0
    k[m:, m:] = 3.0
    problem = Problem(k, np.concatenate((-np.ones(m), np.zeros(m))), np.full(m, 0.5))
    answer = by_pivoting(problem, first_guess(problem, None))
    np.testing.assert_allclose(answer.impulses[:m], 1 / m, rtol=1e-6)
    assert answer.error <= tolerance(problem, answer.impulses)


def test_circle_is_left_where_it_is_recognised(monkeypatch: pytest.MonkeyPatch) -> None:
    """A wedged body: its two contacts go from case to case and round again, one at a time.

    What the search ends with is what all of its rounds would have led to: one round more ends with
    the cases that come next in the circle.
    """
    k = np.array(
        [
            [2.4123, -0.0722, 1.236, 1.2371],
            [-0.0722, 1.8209, -0.8842, -0.8851],
            [1.236, -0.8842, 2.5002, 2.5012],
            [1.2371, -0.8851, 2.5012, 2.5021],
        ]
    )
    problem = Problem(k, np.array([-37.26, -10.63, -27.16, -27.17]), np.full(2, 0.56))
    seen: list[list[int]] = []
    solve_cases = pivoting._solve_cases

    def noted(problem: Problem, cases: Cases, *others: Any) -> Any:
        seen.append(cases.tolist())
        return solve_cases(problem, cases, *others)

    monkeypatch.setattr(pivoting, "_solve_cases", noted)
    ends, longest = [], 0
    for rounds in range(1, 60):
        seen.clear()
        monkeypatch.setattr(pivoting, "ROUNDS", rounds)
        assert not by_pivoting(problem, first_guess(problem, None)).fits
        ends.append(tuple(seen[-1]))
        longest = max(longest, len(seen))
    assert longest < ROUNDS
    circle = ends[longest:]
    follows = dict(pairwise(circle))
    assert len(follows) > 1
    assert all(follows[a] == b for a, b in pairwise(circle))
    before = ends[longest - len(follows) - 1 : longest]  # these rounds were made one by one
    assert all(follows[a] == b for a, b in pairwise(before))
