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

from typing import NamedTuple

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
    still = SOLVED * problem.fastest
    cases = np.where(problem.velocity[:m] > still, OPEN, STICK)
    if guess is not None:
        cases = np.where(guess == UNKNOWN, cases, guess)
    return without_friction(problem.friction, cases)


class Equations(NamedTuple):
    """The equations of all cases. Unknown are jn of what is closed and jt of what sticks."""

    cases: Cases  # shape (m,)
    closed: Cases  # places of the contacts that are
    tangents: Cases  # of the tangents of those that stick, among all 2m impulses
    edge: Floats  # jt / jn of what is closed: +-mu where it slides, else 0
    matrix: Floats  # velocities from what is unknown, 1/kg
    right: Floats  # velocities without it, m/s
    sprung: Floats  # the matrix with springs

    def unknown(self, x: Floats) -> Floats:
        """Return what is unknown out of the impulses of all contacts, shape (2m,)."""
        return np.concatenate((x[self.closed], x[self.tangents]))

    def impulses(self, y: Floats) -> Floats:
        """Return the impulses of all contacts that belong to what was unknown."""
        count, x = len(self.closed), np.zeros(2 * len(self.cases))
        x[self.closed] = y[:count]
        x[len(self.cases) + self.closed] = self.edge * y[:count]
        x[self.tangents] = y[count:]
        return x


def by_pivoting(problem: Problem, cases: Cases, spring: float = SPRINGS[0]) -> Answer:
    """Return the answer by block principal pivoting, the error of the spring taken out."""
    stiffness, m = spring_of(problem, spring), len(problem.friction)
    centre, approach = np.zeros(2 * m), -float(problem.velocity[:m].min())
    best, found = Answer(centre, max(approach, 0.0), "pivoting"), False
    for _ in range(CENTRES):
        equations, y, fits = _pivot(problem, cases, centre, stiffness)
        found, cases = found or fits, equations.cases
        exact = _without_springs(equations.matrix, equations.sprung, equations.right, y)
        centre = legal(problem, equations.impulses(exact))
        error = complementarity_error(problem, centre)
        gained = error < 0.5 * best.error
        best = Answer(centre, error, "pivoting") if error < best.error else best
        if best.error <= tolerance(problem, best.impulses) or not (fits and gained):
            break
    return best._replace(fits=found)


def _pivot(
    problem: Problem, cases: Cases, centre: Floats, stiffness: float
) -> tuple[Equations, Floats, bool]:
    """Change cases until all of them fit the problem with springs.

    Returns their equations, what was unknown in them, and whether all fit.
    """
    fewest, patience = len(cases) + 1, PATIENCE
    singly: list[bytes] = []  # the cases after each round since one changes at a time
    for left in reversed(range(ROUNDS)):
        equations, y = _solve_cases(problem, cases, centre, stiffness)
        fitting = _fitting_cases(problem, cases, equations.impulses(y), centre, stiffness)
        misfits = (fitting != cases).nonzero()[0]
        if len(misfits) == 0:
            return equations, y, True
        if len(misfits) < fewest:
            fewest, patience, singly = len(misfits), PATIENCE, []
        else:
            patience -= 1
        if patience >= 0:
            cases = fitting
        else:
            cases = cases.copy()
            cases[misfits[-1]] = fitting[misfits[-1]]
            singly.append(cases.tobytes())
            if (first := singly.index(singly[-1])) < len(singly) - 1:  # it goes round in a circle
                last = singly[first + left % (len(singly) - 1 - first)]
                cases = np.frombuffer(last, cases.dtype)
                break
    return *_solve_cases(problem, cases, centre, stiffness), False


def _solve_cases(
    problem: Problem, cases: Cases, centre: Floats, stiffness: float
) -> tuple[Equations, Floats]:
    """Return the equations of all cases, with springs around a centre, and what was unknown."""
    k, mu, m = problem.delassus, problem.friction, len(problem.friction)
    closed, tangents = (cases != OPEN).nonzero()[0], m + (cases == STICK).nonzero()[0]
    edge = cases[closed] * mu[closed]
    rows = np.concatenate((closed, tangents))
    of_rows = k[rows]
    matrix = np.empty((len(rows), len(rows)))
    matrix[:, : len(closed)] = of_rows[:, closed] + of_rows[:, m + closed] * edge
    matrix[:, len(closed) :] = of_rows[:, tangents]
    right, sprung = problem.velocity[rows], _with_springs(matrix, stiffness)
    equations = Equations(cases, closed, tangents, edge, matrix, right, sprung)
    start = equations.unknown(centre)
    return equations, start - _solution(sprung, right + matrix @ start)


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
    most = _largest(missing)
    for _ in range(REFINEMENTS):
        better = y - _solution(sprung, missing)
        left = b + equations @ better
        if not (most_left := _largest(left)) < 0.5 * most:
            break
        y, missing, most = better, left, most_left
    if most > ENOUGH * _largest(b):
        least = np.linalg.lstsq(equations, -b, rcond=RANK)[0].astype(float)
        if _largest(b + equations @ least) < most:
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


def _fitting_cases(
    problem: Problem, cases: Cases, x: Floats, centre: Floats, stiffness: float
) -> Cases:
    """Return the case that each contact should have had, to judge by impulses and velocities."""
    b, mu, own, m = problem.velocity, problem.friction, problem.own, len(problem.friction)
    w = b + problem.delassus @ x + stiffness * (x - centre)
    rounding = ROUNDING * (problem.sizes @ np.abs(x) + np.abs(b))
    w = np.where(np.abs(w) <= rounding, 0.0, w)
    ways = w / own
    is_open = cases == OPEN
    # One step of the projection whose fixed point is the answer; see complementarity_error.
    push = np.where(is_open, -ways[:m], x[:m])
    rub = np.where(cases == STICK, x[m:], x[m:] - ways[m:])
    limit = mu * np.maximum(push, 0.0) * (1.0 + ROUNDING)
    fitting = np.where(rub > limit, FORWARD, np.where(rub < -limit, BACKWARD, STICK))
    # What slides and is not drawn back keeps sliding; only wt against jt makes it stick.
    slides = (cases == FORWARD) | (cases == BACKWARD)
    fitting = np.where(slides, np.where(cases * w[m:] <= 0.0, cases, STICK), fitting)
    fitting = np.where(push <= np.where(is_open, 0.0, -rounding[:m] / own[:m]), OPEN, fitting)
    return without_friction(mu, fitting)
