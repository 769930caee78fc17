"""Block principal pivoting: guess the case of every contact, solve, and correct all wrong guesses.

With the cases given (open, stick, slide this way or that) the impulses are the answer of linear
equations. Then the case of every contact that does not fit its impulse and velocity changes, and
the equations are solved again, until all fit. If the number of misfits does not fall in a few
rounds, only the last of them changes from then on; and after so many rounds the search ends
without an answer.

Where K is singular, springs make the equations solvable: K + s I. Among the loads that do the same
they choose the one with the least sum of squares, as if every contact were an equally stiff spring.
What the springs yield is taken out again, with the cases as they are.

References
----------
Judice and Pires, A block principal pivoting algorithm for large-scale strictly monotone linear
complementarity problems (1994): the rule that falls back to one change at a time.
"""

from __future__ import annotations

import numpy as np

from lesson_code.engine.solvers.contact_problem import (
    BACKWARD,
    ENOUGH,
    FORWARD,
    OPEN,
    RANK,
    ROUNDING,
    SOLVED,
    SPRINGS,
    STICK,
    UNKNOWN,
    Answer,
    Cases,
    Floats,
    Problem,
    complementarity_error,
    legal,
    spring_of,
    tolerance,
    without_friction,
)

ROUNDS, PATIENCE = 20, 4
"""Rounds of pivoting; rounds without fewer misfits after which one case changes at a time.
Searches that succeed take a few rounds; Lemke's method costs as much as a few dozen."""

REFINEMENTS = 40
"""Times that the error of the spring is taken out; two or three are usual."""

CENTRES = 4
"""Times that the pivoting begins anew around an answer that is nearly right."""


def first_guess(problem: Problem, guess: Cases | None) -> Cases:
    """Return the first guess: where nothing better is known, what does not part sticks."""
    m = len(problem.friction)
    still = SOLVED * np.abs(problem.velocity).max()
    cases = np.where(problem.velocity[:m] > still, OPEN, STICK)
    if guess is not None:
        cases = np.where(guess == UNKNOWN, cases, guess)
    return without_friction(problem.friction, cases)


def by_pivoting(problem: Problem, cases: Cases) -> Answer:
    """Return the answer by block principal pivoting, the error of the spring taken out."""
    m = len(problem.friction)
    centre = np.zeros(2 * m)
    best, found = Answer(centre, complementarity_error(problem, centre), "pivoting"), False
    for _ in range(CENTRES):
        cases, fits = _pivot(problem, cases, centre)
        found = found or fits
        centre = legal(problem, _solve_cases(problem, cases, centre, exact=True))
        error = complementarity_error(problem, centre)
        gained = error < 0.5 * best.error
        best = Answer(centre, error, "pivoting") if error < best.error else best
        if best.error <= tolerance(problem, best.impulses) or not (fits and gained):
            break
    return best._replace(fits=found)


def _pivot(problem: Problem, cases: Cases, centre: Floats) -> tuple[Cases, bool]:
    """Change cases until all of them fit the problem with springs; return whether they do."""
    fewest, patience = len(cases) + 1, PATIENCE
    for _ in range(ROUNDS):
        x = _solve_cases(problem, cases, centre)
        fitting = _fitting_cases(problem, cases, x, centre)
        misfits = (fitting != cases).nonzero()[0]
        if len(misfits) == 0:
            return cases, True
        if len(misfits) < fewest:
            fewest, patience = len(misfits), PATIENCE
        else:
            patience -= 1
        if patience >= 0:
            cases = fitting
        else:
            cases = cases.copy()
            cases[misfits[-1]] = fitting[misfits[-1]]
    return cases, False


def _solve_cases(problem: Problem, cases: Cases, centre: Floats, *, exact: bool = False) -> Floats:
    """Return the impulses that make the equations of all cases true, with springs or without.

    Unknown are jn of what is closed and jt of what sticks; jt = +-mu jn of what slides.
    """
    k, b, mu = problem[:3]
    m = len(mu)
    closed, sticks = (cases != OPEN).nonzero()[0], (cases == STICK).nonzero()[0]
    edge = cases[closed] * mu[closed]
    rows = np.concatenate((closed, m + sticks))
    of_rows = k[rows]
    equations = np.empty((len(rows), len(rows)))
    equations[:, : len(closed)] = of_rows[:, closed] + of_rows[:, m + closed] * edge
    equations[:, len(closed) :] = of_rows[:, m + sticks]
    start = np.concatenate((centre[closed], centre[m + sticks]))
    sprung = _with_springs(equations, spring_of(problem))
    y = start - _solution(sprung, b[rows] + equations @ start)
    if exact:
        y = _without_springs(equations, sprung, b[rows], y)
    x = np.zeros(2 * m)
    x[closed] = y[: len(closed)]
    x[m + closed] = edge * y[: len(closed)]
    x[m + sticks] = y[len(closed) :]
    return x


def least_solution(equations: Floats, b: Floats) -> Floats:
    """Return the y with the least sum of squares that makes b + equations y as small as can be.

    The equations must have a scale in which their diagonal is about 1.
    """
    sprung = _with_springs(equations, SPRINGS[1])
    return _without_springs(equations, sprung, b, -_solution(sprung, b))


def _with_springs(equations: Floats, stiffness: float) -> Floats:
    """Return the equations with a spring at each contact, 1/kg on the diagonal."""
    sprung = equations.copy()
    sprung.flat[:: len(sprung) + 1] += stiffness
    return sprung


def _without_springs(equations: Floats, sprung: Floats, b: Floats, y: Floats) -> Floats:
    """Return what y becomes when the springs' resting place moves to y, again and again.

    Their force vanishes, quickly unless the masses are more than a million apart; then the load
    with the least sum of squares is found from the singular values, which takes far longer.
    """
    missing = b + equations @ y
    for _ in range(REFINEMENTS):
        better = y - _solution(sprung, missing)
        left = b + equations @ better
        if not _largest(left) < 0.5 * _largest(missing):
            break
        y, missing = better, left
    if _largest(missing) > ENOUGH * _largest(b):
        least = np.linalg.lstsq(equations, -b, rcond=RANK)[0].astype(float)
        if _largest(b + equations @ least) < _largest(missing):
            return least
    return y


def _largest(values: Floats) -> float:
    """Return the largest size of any number; 0 of none."""
    return float(np.abs(values).max(initial=0.0))


def _solution(matrix: Floats, right: Floats) -> Floats:
    """Return the solution of linear equations; where chance has made them singular, the nearest."""
    if len(right) == 1 and matrix[0, 0] != 0.0:
        alone: Floats = right / matrix[0]
        return alone
    try:
        solution: Floats = np.linalg.solve(matrix, right).astype(float)
    except np.linalg.LinAlgError:
        solution = np.linalg.lstsq(matrix, right)[0].astype(float)
    return solution


def _fitting_cases(problem: Problem, cases: Cases, x: Floats, centre: Floats) -> Cases:
    """Return the case that each contact should have had, to judge by impulses and velocities."""
    k, b, mu = problem[:3]
    m = len(mu)
    w = b + k @ x + spring_of(problem) * (x - centre)
    own = k.diagonal()
    rounding = ROUNDING * (np.abs(k) @ np.abs(x) + np.abs(b))
    jn, jt = x[:m], x[m:]
    wn = np.where(np.abs(w[:m]) <= rounding[:m], 0.0, w[:m])
    wt = np.where(np.abs(w[m:]) <= rounding[m:], 0.0, w[m:])
    # One step of the projection whose fixed point is the answer; see complementarity_error.
    push = np.where(cases == OPEN, -wn / own[:m], jn)
    rub = np.where(cases == STICK, jt, jt - wt / own[m:])
    limit = mu * np.maximum(push, 0.0) * (1.0 + ROUNDING)
    fitting = np.where(rub > limit, FORWARD, np.where(rub < -limit, BACKWARD, STICK))
    # What slides and is not drawn back keeps sliding; only wt against jt makes it stick.
    slides = (cases == FORWARD) | (cases == BACKWARD)
    fitting = np.where(slides, np.where(cases * wt <= 0.0, cases, STICK), fitting)
    fitting = np.where(push <= np.where(cases == OPEN, 0.0, -rounding[:m] / own[:m]), OPEN, fitting)
    return without_friction(problem.friction, fitting)
