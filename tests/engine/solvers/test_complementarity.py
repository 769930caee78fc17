"""The contact problem: by hand, against exact fractions, closed forms, and its own conditions."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code.engine.solvers import complementarity
from lesson_code.engine.solvers.complementarity import least_error, solve_contacts
from lesson_code.engine.solvers.contact_problem import (
    BACKWARD,
    FORWARD,
    OPEN,
    STICK,
    Answer,
    Problem,
    complementarity_error,
)
from lesson_code.engine.solvers.pivoting import by_pivoting, first_guess
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction

EXACT = 1e-11
"""m/s, of velocities of some m/s and masses of some kg: a few dozen equations, two refinements."""

EVEN = 1e-6
"""Of the load: the springs, 1e-8 of the delassus, leave rounding of 1e-7 in how it is shared."""

NEARLY = 1e-6
"""m/s: `ENOUGH`, for contacts on the brink between two cases."""

seeds = st.integers(0, 10**9)


def examples(count: int) -> settings:
    """Return settings for problems made from a seed; no shrinking, for no seed is a simpler one."""
    return settings(max_examples=share(count), phases=[Phase.explicit, Phase.generate])


def some_problem(rng: np.random.Generator, contacts: int, bodies: int, digits: int) -> Problem:
    """Return random contacts between bodies and the ground, in numbers of so many binary digits."""

    def number(low: float, high: float) -> float:
        return round(rng.uniform(low, high) * 2**digits) / 2**digits

    m = contacts
    g = np.zeros((2 * m, 3 * bodies))
    for k in range(m):
        a, b = rng.choice(np.arange(-1, bodies), 2, replace=False)
        n = [(1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.6, 0.8), (-0.8, 0.6)][rng.integers(5)]
        for body, sign in ((a, -1.0), (b, 1.0)):
            if body >= 0:
                x, y = number(-1, 1), number(-1, 1)
                for row, (ux, uy) in ((k, n), (m + k, (-n[1], n[0]))):
                    g[row, 3 * body : 3 * body + 3] = sign * np.array((ux, uy, x * uy - y * ux))
    w = np.array([(i, i, 4 * i) for i in 2.0 ** rng.integers(-2, 3, bodies)]).ravel()
    v = np.array([number(-2, 2) for _ in range(3 * bodies)])
    mu = np.array([number(0, 1.5) for _ in range(m)])
    return Problem((g * w) @ g.T, g @ v, mu)


# By hand

ONE = {
    "a ball that parts": ((2.0, 0.0, 6.0), (1.0, 3.0), 0.5, (0.0, 0.0)),
    "a ball on ice": ((2.0, 0.0, 6.0), (-4.0, 3.0), 0.0, (2.0, 0.0)),
    "a ball that sticks": ((2.0, 0.0, 6.0), (-4.0, 3.0), 0.5, (2.0, -0.5)),
    "a ball that slides": ((2.0, 0.0, 6.0), (-4.0, 9.0), 0.25, (2.0, -0.5)),
    "a ball that slides back": ((2.0, 0.0, 6.0), (-4.0, -9.0), 0.25, (2.0, 0.5)),
    "a corner that sticks": ((2.0, 1.0, 1.0), (-1.0, 0.0), 2.0, (1.0, -1.0)),
    "a corner that slides": ((2.0, 1.0, 1.0), (-1.0, 0.0), 0.5, (2 / 3, -1 / 3)),
}


@pytest.mark.parametrize(("k", "b", "mu", "j"), ONE.values(), ids=ONE)
def test_impulse_of_one_contact_worked_by_hand_is_found(
    k: tuple[float, float, float], b: tuple[float, float], mu: float, j: tuple[float, float]
) -> None:
    """Two equations, or one and the edge of the cone."""
    knn, knt, ktt = k
    problem = Problem(np.array([[knn, knt], [knt, ktt]]), np.array(b), np.array([mu]))
    np.testing.assert_allclose(solve_contacts(problem).impulses, j, atol=EXACT)


@examples(200)
@given(seed=seeds, e=st.floats(0, 1), mu=st.floats(0, 3))
def test_impulse_of_one_contact_is_the_closed_form(seed: int, e: float, mu: float) -> None:
    """Sticking, sliding and jamming, as the reference has it from its own formulas."""
    rng = np.random.default_rng(seed)
    bodies = [
        Struck(i, i * s, rng.normal(size=2), rng.normal(), rng.uniform(-1, 1, 2))
        for i, s in zip(10 ** rng.uniform(-1, 1, 2), rng.uniform(1, 20, 2), strict=True)
    ]
    impact = impact_with_friction(*bodies, normal=(0, 1), restitution=e, friction=mu)
    assume(impact.kind != "parts")
    k, u = np.zeros((2, 2)), np.zeros(2)
    for body, sign in zip(bodies, (-1, 1), strict=True):
        x, y = body.arm
        rows = np.array([(0, 1, x), (1, 0, -y)])  # n = (0, 1); along x, and -x is the tangent
        rows[1] *= -1
        k += (rows * (body.inverse_mass, body.inverse_mass, body.inverse_inertia)) @ rows.T
        u += sign * rows @ (*body.velocity, body.angular_velocity)
    answer = solve_contacts(Problem(k, np.array([(1 + e) * u[0], u[1]]), np.array([mu])))
    expected = impact.normal_impulse, impact.tangent_impulse
    np.testing.assert_allclose(answer.impulses, expected, rtol=EXACT, atol=EXACT)


# Against exact fractions


def exact_answers(problem: Problem) -> list[list[Fraction]]:
    """Return the velocities w of all answers: try every case of every contact, in fractions."""
    k = [[Fraction(float(x)) for x in row] for row in problem.delassus]
    b = [Fraction(float(x)) for x in problem.velocity]
    mu = [Fraction(float(x)) for x in problem.friction]
    m = len(mu)
    found = []
    for cases in itertools.product((OPEN, STICK, FORWARD, BACKWARD), repeat=m):
        x = _exact_impulses(k, b, mu, cases)
        if x is None:
            continue
        w = [b[i] + sum(k[i][j] * x[j] for j in range(2 * m)) for i in range(2 * m)]
        if all(_fits(cases[i], x[i], x[m + i], w[i], w[m + i], mu[i]) for i in range(m)):
            found.append(w)
    return found


def _exact_impulses(k: Any, b: Any, mu: Any, cases: Any) -> list[Fraction] | None:
    """Return the impulses of given cases by Gauss's elimination; None where they are undecided."""
    m = len(mu)
    columns, rows = [], []
    for i, case in enumerate(cases):
        if case != OPEN:
            slope = case * mu[i] if case != STICK else Fraction(0)
            columns.append({i: Fraction(1), m + i: slope})
            rows.append(i)
            if case == STICK:
                columns.append({m + i: Fraction(1)})
                rows.append(m + i)
    table = [[sum(k[r][j] * f for j, f in c.items()) for c in columns] + [-b[r]] for r in rows]
    y = _eliminated(table)
    if y is None:
        return None
    x = [Fraction(0)] * (2 * m)
    for value, column in zip(y, columns, strict=True):
        for j, factor in column.items():
            x[j] += factor * value
    return x


def _eliminated(table: list[list[Fraction]]) -> list[Fraction] | None:
    """Solve linear equations exactly."""
    n = len(table)
    for i in range(n):
        pivot = next((r for r in range(i, n) if table[r][i] != 0), None)
        if pivot is None:
            return None
        table[i], table[pivot] = table[pivot], table[i]
        table[i] = [x / table[i][i] for x in table[i]]
        for r in range(n):
            if r != i:
                table[r] = [x - table[r][i] * y for x, y in zip(table[r], table[i], strict=True)]
    return [row[n] for row in table]


def _fits(case: int, jn: Fraction, jt: Fraction, wn: Fraction, wt: Fraction, mu: Fraction) -> bool:
    """Return whether a contact's case is consistent."""
    if case == OPEN:
        return wn >= 0
    return jn >= 0 and (abs(jt) <= mu * jn if case == STICK else case * wt <= 0)


@examples(60)
@given(seed=seeds, contacts=st.integers(1, 3))
def test_velocities_of_a_few_contacts_are_one_of_the_exact_answers(
    seed: int, contacts: int
) -> None:
    """All 4^m cases in fractions: what the solver gives is an answer, and none is missed."""
    rng = np.random.default_rng(seed)
    problem = some_problem(rng, contacts, int(rng.integers(1, 4)), digits=6)
    answers = exact_answers(problem)
    assume(answers)
    answer = solve_contacts(problem)
    assert answer.error <= NEARLY
    w = problem.velocity + problem.delassus @ answer.impulses
    nearest = min(float(np.abs(w - np.array(x, dtype=float)).max()) for x in answers)
    assert nearest <= NEARLY or len(answers) > 1


@examples(60)
@given(seed=seeds, contacts=st.integers(1, 4))
def test_velocities_without_friction_are_the_only_exact_answer(seed: int, contacts: int) -> None:
    """K is symmetric and not negative: whoever carries the load, the velocities are the same."""
    rng = np.random.default_rng(seed)
    problem = some_problem(rng, contacts, int(rng.integers(1, 4)), digits=6)
    problem = replace(problem, friction=np.zeros(contacts))
    answers = exact_answers(problem)
    assume(answers)
    answer = solve_contacts(problem)
    w = problem.velocity + problem.delassus @ answer.impulses
    np.testing.assert_allclose(
        w[:contacts], np.array(answers[0], dtype=float)[:contacts], atol=EXACT
    )


# Many contacts


@examples(40)
@given(seed=seeds, contacts=st.integers(5, 40))
def test_conditions_of_many_contacts_are_met(seed: int, contacts: int) -> None:
    """No pull, no approach, no friction beyond the cone or along the sliding."""
    rng = np.random.default_rng(seed)
    problem = some_problem(rng, contacts, contacts // 2 + 2, digits=30)
    answer = solve_contacts(problem)
    m, x = contacts, answer.impulses
    w = problem.velocity + problem.delassus @ x
    limit = problem.friction * x[:m]
    assert x[:m].min() >= 0
    assert (np.abs(x[m:]) <= limit).all()
    assume(answer.method != "softened")
    assert w[:m].min() >= -NEARLY
    assert np.abs(x[:m] * w[:m]).max() <= NEARLY * (1 + x.max())
    slack = limit - np.abs(x[m:])
    assert np.abs(w[m:] * slack).max() <= NEARLY * (1 + x.max())
    assert (w[m:] * x[m:]).max() <= NEARLY * (1 + x.max())


@pytest.mark.parametrize("contacts", [2, 3, 4, 7])
def test_load_on_equal_contacts_is_even(contacts: int) -> None:
    """A block that falls on posts, evenly spaced about its middle: each carries the same."""
    place = np.linspace(-1, 1, contacts)
    g = np.vstack(
        (
            np.column_stack((np.zeros(contacts), np.ones(contacts), place)),
            np.column_stack((-np.ones(contacts), np.zeros(contacts), np.full(contacts, 0.5))),
        )
    )
    k = (g * (1.0, 1.0, 3.0)) @ g.T
    problem = Problem(k, g @ (0.0, -1.0, 0.0), np.full(contacts, 0.5))
    x = solve_contacts(problem).impulses
    np.testing.assert_allclose(x[:contacts], 1 / contacts, rtol=EVEN)
    np.testing.assert_allclose(x[contacts:], 0, atol=EVEN)


def test_load_beside_the_middle_falls_off_in_a_line() -> None:
    """The least sum of squares is that of springs: 3 posts at -1, 0, 1 under a load at 1/3.

    Sum 1 and moment 1/3: 1/3 + p/2 with p = -1/3, 0, 1/3.
    """
    place = np.array([-1.0, 0.0, 1.0])
    g = np.column_stack((np.ones(3), place))
    k = np.zeros((6, 6))
    k[:3, :3] = g @ np.diag([1.0, 2.0]) @ g.T
    k[3:, 3:] = np.eye(3)
    b = np.concatenate((-g @ (1.0, 2 / 3), np.zeros(3)))
    x = solve_contacts(Problem(k, b, np.zeros(3))).impulses
    np.testing.assert_allclose(x[:3], (1 / 6, 1 / 3, 1 / 2), rtol=EVEN)


def test_problem_without_an_answer_is_softened() -> None:
    """A ball between two walls that close: nobody can win; the ball stays in the middle."""
    k = np.array([[1.0, -1.0, 0, 0], [-1.0, 1.0, 0, 0], [0, 0, 3.0, 3.0], [0, 0, 3.0, 3.0]])
    answer = solve_contacts(Problem(k, np.array([-1.0, -1.0, 0, 0]), np.zeros(2)))
    assert answer.method == "softened"
    assert math.isfinite(answer.impulses.sum())
    assert answer.impulses[0] == pytest.approx(answer.impulses[1])
    assert answer.error == pytest.approx(1.0)


@examples(100)
@given(
    seed=seeds,
    closing=st.floats(1e-6, 1e3),
    mass=st.floats(1e-3, 1e3),
    mu=st.floats(0, 2),
    others=st.integers(0, 3),
)
def test_least_error_of_a_ball_between_closing_walls_is_half_of_what_they_close(
    seed: int, closing: float, mass: float, mu: float, others: int
) -> None:
    """At best each wall closes by half, whatever else happens; no answer does better."""
    k = np.array([[1.0, -1.0, 0, 0], [-1.0, 1.0, 0, 0], [0, 0, 3.0, 3.0], [0, 0, 3.0, 3.0]]) / mass
    rng = np.random.default_rng(seed)
    apart = np.concatenate((np.arange(2, 2 + others), np.arange(4 + others, 4 + 2 * others)))
    of_walls = np.array([0, 1, 2 + others, 3 + others])
    whole = np.zeros((4 + 2 * others, 4 + 2 * others))
    whole[np.ix_(of_walls, of_walls)] = k
    whole[apart, apart] = 1.0 / mass
    b = np.zeros(len(whole))
    left = rng.uniform(0, 1)
    b[:2] = -closing * left, -closing * (1 - left)
    b[apart] = closing * rng.uniform(-1, 1, 2 * others)
    problem = Problem(whole, b, np.full(2 + others, mu), np.full(2 + others, math.sqrt(mass)))
    answer = solve_contacts(problem)
    assert answer.method == "softened"
    alike, d = problem.scaled()
    least = least_error(alike, by_pivoting(alike, first_guess(alike, None)).impulses)
    assert least == pytest.approx(d[0] * closing / 2, rel=1e-9)
    assert complementarity_error(alike, answer.impulses / d) >= least * (1 - 1e-9)


@examples(60)
@given(seed=seeds, contacts=st.integers(1, 3))
def test_least_error_is_none_where_an_answer_exists(seed: int, contacts: int) -> None:
    """No attempt proves the contrary, however wrong it is."""
    rng = np.random.default_rng(seed)
    problem = some_problem(rng, contacts, int(rng.integers(1, 3)), digits=6)
    assume(exact_answers(problem))
    for size in (0.0, 1.0, 1e6):
        assert least_error(problem, size * rng.normal(size=2 * contacts)) == 0


def test_lemke_takes_over_where_pivoting_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    """With pivoting forbidden the answer is the same."""
    problem = some_problem(np.random.default_rng(4), 12, 8, digits=30)
    expected = solve_contacts(problem)
    assert expected.method == "pivoting"

    def fail(problem: Problem, cases: Any, spring: float = 0.0) -> Answer:
        zero = np.zeros(2 * len(problem.friction))
        return Answer(zero, complementarity_error(problem, zero), "pivoting")

    monkeypatch.setattr(complementarity, "by_pivoting", fail)
    answer = solve_contacts(problem)
    assert answer.method == "lemke"
    w = problem.velocity + problem.delassus @ answer.impulses
    expected_w = problem.velocity + problem.delassus @ expected.impulses
    np.testing.assert_allclose(w, expected_w, atol=NEARLY)
