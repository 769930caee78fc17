"""The contact problem of an island, solved all at once: which contacts open, stick or slide.

An impulse x at the contacts changes their velocities by K x. Wanted are impulses with

    w = b + K x
    jn >= 0,    wn >= 0,    jn wn = 0                          a contact pushes, or it opens
    abs(jt) <= mu jn,  wt = 0   or   jt = +-mu jn against wt   it sticks, or it slides

Method: block principal pivoting. Guess the case of every contact; then x is the answer of linear
equations. Change the case of every contact that it does not fit, and solve again, until all fit. If
the number of misfits does not fall in a few rounds, only the last of them changes, and after so
many rounds Lemke's method (``lemke``) takes over, which ends always. Last comes the softened
problem, for what has no answer at all (a body between two walls that close).

Two corners of a face that both stick, or a box on three posts, leave the loads undecided: K is
singular. Taken is the load with the least sum of squares, as if every contact were an equally
stiff spring: the limit of K + s I for s -> 0. So an even load comes out even.

==========  ==========================================================  =====
symbol      meaning                                                     unit
==========  ==========================================================  =====
m           number of contacts                                          -
x           impulses, first the m normal ones, then the m tangential    N s
b           velocities without x, those along the normals less what     m/s
            they have to reach; in the same order
K           velocities from impulses, 2m by 2m, symmetric               1/kg
mu          friction coefficient of each contact                        -
==========  ==========================================================  =====

References
----------
Cottle, Pang and Stone, The Linear Complementarity Problem (1992), chapters 3 and 4. Judice and
Pires, A block principal pivoting algorithm for large-scale strictly monotone linear
complementarity problems (1994): the rule that falls back to one change at a time.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.lemke import lemke

Floats: TypeAlias = NDArray[np.float64]
Cases: TypeAlias = NDArray[np.int64]

BACKWARD, STICK, FORWARD, OPEN = -1, 0, 1, 2
"""What a contact does; where it slides, the number is the sign of its friction impulse."""

SPRING = 1e-8
"""Of the mean of K's diagonal: what is added to it to make the equations solvable. The error that
it makes is taken out again; the smaller it is, the more does rounding show in how posts share a load."""

SOFT = 1e-3
"""The same for a problem without an answer: bodies give way by a thousandth of the velocity."""

SOLVED = 1e-12
"""Of the largest velocity in b: the complementarity error that is as good as none."""

ENOUGH = 1e-7
"""Of the same: the error that is left where contacts on the brink of opening or sliding have
been given the wrong case. No other method is tried for it; the next step starts anew."""

ROUNDING = 1e-14
"""Of the largest term in K x: what rounding leaves of velocities that cancel."""

ROUNDS, PATIENCE = 60, 4
"""Rounds of pivoting; rounds without fewer misfits after which one case changes at a time."""

MUCH_BETTER = 0.1
"""Of the softened answer's error: an answer that is not exact must be so much nearer to it. Where
there is none, the other methods find impulses that are as wrong, and a million times as large."""

MOST_FOR_LEMKE = 300
"""Contacts of an island for which Lemke's method is tried; with more it takes seconds."""

REFINEMENTS = 40
"""Times that the error of the spring is taken out; two or three are usual."""

CENTRES = 4
"""Times that the pivoting begins anew around an answer that is nearly right."""


class Problem(NamedTuple):
    """A contact problem: K, b and mu."""

    compliance: Floats  # K, shape (2m, 2m), 1/kg
    velocity: Floats  # b, shape (2m,), m/s
    friction: Floats  # mu, shape (m,)


class Answer(NamedTuple):
    """Impulses, and how well they solve the problem."""

    impulses: Floats
    """Shape (2m,), N s."""
    error: float
    """What is left of the complementarity conditions, m/s; 0 is exact."""
    method: str
    """"open" (no contact is needed), "one" (closed form), "pivoting", "lemke" or "softened"."""


def solve_contacts(problem: Problem) -> Answer:
    """Return the impulses of all contacts of an island.

    Parameters
    ----------
    problem : Problem
        K must come from bodies of which one at each contact can be moved.

    Returns
    -------
    Answer
        The impulses. Unless the method is "softened" they are exact but for rounding.

    Examples
    --------
    A box lands on two corners, 1 m apart from its middle; each corner carries half:

    >>> k = np.array([[2.0, 1.0, 0, 0], [1.0, 2.0, 0, 0], [0, 0, 1.0, 1.0], [0, 0, 1.0, 1.0]])
    >>> b = np.array([-3.0, -3.0, 0, 0])
    >>> answer = solve_contacts(Problem(k, b, friction=np.array([0.0, 0.0])))
    >>> answer.impulses.round(12).tolist(), answer.method
    ([1.0, 1.0, 0.0, 0.0], 'pivoting')
    """
    m = len(problem.friction)
    if not (problem.velocity[:m] < 0.0).any():
        return Answer(np.zeros(2 * m), 0.0, "open")
    if m == 1:
        single = _one_contact(problem)
        if single is not None:
            return Answer(single, complementarity_error(problem, single), "one")
    best = _by_pivoting(problem, _guess(problem))
    if not _is_solved(problem, best) and m <= MOST_FOR_LEMKE:
        best = min(best, _by_lemke(problem), key=_error)
    if _is_solved(problem, best):
        return best
    softened = _softened(problem)
    return best if best.error < MUCH_BETTER * softened.error else softened


def complementarity_error(problem: Problem, x: Floats) -> float:
    """Return how far impulses are from solving a contact problem, m/s.

    jn = max(jn - wn / knn, 0),   jt = clamp(jt - wt / ktt, -mu jn, mu jn)

    hold if and only if all conditions do; the error is the largest fault, as a velocity.

    >>> ball = Problem(np.diag([2.0, 6.0]), np.array([-2.0, 0.0]), np.array([0.0]))
    >>> complementarity_error(ball, np.array([1.0, 0.0]))
    0.0
    >>> complementarity_error(ball, np.array([0.75, 0.0]))
    0.5
    """
    m = len(problem.friction)
    own = np.diag(problem.compliance)
    wanted = x - (problem.velocity + problem.compliance @ x) / own
    limit = problem.friction * np.maximum(x[:m], 0.0)
    normal = x[:m] - np.maximum(wanted[:m], 0.0)
    tangent = x[m:] - np.clip(wanted[m:], -limit, limit)
    return float(np.abs(np.concatenate((normal, tangent)) * own).max(initial=0.0))


def _error(answer: Answer) -> float:
    """Return how far an answer is from solving its problem, m/s."""
    return answer.error


def _is_solved(problem: Problem, answer: Answer) -> bool:
    """Return whether so little is left of the error that no other method is worth trying."""
    return answer.error <= max(
        ENOUGH * float(np.abs(problem.velocity).max()), _tolerance(problem, answer.impulses)
    )


def _tolerance(problem: Problem, x: Floats) -> float:
    """Return the error at which impulses count as exact, m/s."""
    terms = np.abs(problem.compliance) @ np.abs(x)
    return float(SOLVED * np.abs(problem.velocity).max() + ROUNDING * terms.max())


def _one_contact(problem: Problem) -> Floats | None:
    """Return the impulses of a single contact that approaches, in closed form."""
    (knn, knt), (_, ktt) = problem.compliance.tolist()
    bn, bt = problem.velocity.tolist()
    mu = float(problem.friction[0])
    determinant = knn * ktt - knt * knt
    if mu > 0.0 and determinant > 0.0:
        jn, jt = (knt * bt - ktt * bn) / determinant, (knt * bn - knn * bt) / determinant
        if abs(jt) <= mu * jn:
            return np.array([jn, jt])
    for edge in (mu, -mu):
        yields = knn + edge * knt
        jn = -bn / yields if yields > 0.0 else 0.0
        if jn > 0.0 and edge * (bt + (knt + ktt * edge) * jn) <= 0.0:
            return np.array([jn, edge * jn])
    return None  # rounding has left no case


def _guess(problem: Problem) -> Cases:
    """Return the first guess: what does not part sticks."""
    m = len(problem.friction)
    still = SOLVED * np.abs(problem.velocity).max()
    return _without_friction(problem, np.where(problem.velocity[:m] > still, OPEN, STICK))


def _without_friction(problem: Problem, cases: Cases) -> Cases:
    """Return the cases with contacts without friction sliding: their friction is mu jn = 0."""
    smooth: Cases = np.where((cases != OPEN) & (problem.friction == 0.0), FORWARD, cases)
    return smooth


def _by_pivoting(problem: Problem, cases: Cases) -> Answer:
    """Return the answer by block principal pivoting, the error of the spring taken out."""
    m = len(problem.friction)
    centre = np.zeros(2 * m)
    best = Answer(centre, complementarity_error(problem, centre), "pivoting")
    for _ in range(CENTRES):
        cases, fits = _pivot(problem, cases, centre)
        centre = _legal(problem, _solve_cases(problem, cases, centre, REFINEMENTS))
        error = complementarity_error(problem, centre)
        gained = error < 0.5 * best.error
        best = Answer(centre, error, "pivoting") if error < best.error else best
        if best.error <= _tolerance(problem, best.impulses) or not (fits and gained):
            break
    return best


def _pivot(problem: Problem, cases: Cases, centre: Floats) -> tuple[Cases, bool]:
    """Change cases until all of them fit the problem with springs; return whether they do."""
    fewest, patience = len(cases) + 1, PATIENCE
    for _ in range(ROUNDS + len(cases)):
        x = _solve_cases(problem, cases, centre)
        fitting = _fitting_cases(problem, cases, x, centre)
        misfits = np.flatnonzero(fitting != cases)
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


def _solve_cases(problem: Problem, cases: Cases, centre: Floats, refinements: int = 0) -> Floats:
    """Return the impulses that make the equations of all cases true.

    Unknown are jn of what is closed and jt of what sticks; jt = +-mu jn of what slides. Each
    refinement moves the springs' resting place to the last answer, and their force vanishes.
    """
    k, b, mu = problem
    m = len(mu)
    closed, sticks = np.flatnonzero(cases != OPEN), np.flatnonzero(cases == STICK)
    edge = cases[closed] * mu[closed]
    rows = np.concatenate((closed, m + sticks))
    columns = np.hstack((k[:, closed] + k[:, m + closed] * edge, k[:, m + sticks]))
    spring = SPRING * float(np.trace(k)) / (2 * m)
    equations = columns[rows]
    sprung = equations + spring * np.eye(len(rows))
    y = np.concatenate((centre[closed], centre[m + sticks]))
    fault = np.inf
    for _ in range(1 + refinements):
        missing = b[rows] + equations @ y
        if not np.abs(missing).max(initial=0.0) < 0.9 * fault:
            break
        fault = float(np.abs(missing).max(initial=0.0))
        y = y - _solution(sprung, missing)
    x = np.zeros(2 * m)
    x[closed] = y[: len(closed)]
    x[m + closed] = edge * y[: len(closed)]
    x[m + sticks] = y[len(closed) :]
    return x


def _solution(matrix: Floats, right: Floats) -> Floats:
    """Return the solution of linear equations; where chance has made them singular, the nearest."""
    try:
        return np.linalg.solve(matrix, right)
    except np.linalg.LinAlgError:
        nearest: Floats = np.linalg.lstsq(matrix, right)[0]
        return nearest


def _fitting_cases(problem: Problem, cases: Cases, x: Floats, centre: Floats) -> Cases:
    """Return the case that each contact should have had, to judge by impulses and velocities."""
    k, b, mu = problem
    m = len(mu)
    w = b + k @ x + SPRING * float(np.trace(k)) / (2 * m) * (x - centre)
    own = np.diag(k)
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
    return _without_friction(problem, fitting)


def _legal(problem: Problem, x: Floats) -> Floats:
    """Return impulses without what rounding has made of zeros and limits: no pull, no excess."""
    m = len(problem.friction)
    jn = np.maximum(x[:m], 0.0)
    limit = problem.friction * jn
    return np.concatenate((jn, np.clip(x[m:], -limit, limit)))


def _by_lemke(problem: Problem) -> Answer:
    """Return the answer by Lemke's method, improved by pivoting from its cases."""
    x = _lemke_impulses(problem)
    if x is None:
        zero = np.zeros(2 * len(problem.friction))
        return Answer(zero, complementarity_error(problem, zero), "lemke")
    x = _legal(problem, x)
    found = Answer(x, complementarity_error(problem, x), "lemke")
    improved = _by_pivoting(problem, _cases_of(problem, x))
    return improved._replace(method="lemke") if improved.error < found.error else found


def _cases_of(problem: Problem, x: Floats) -> Cases:
    """Return the cases that impulses belong to."""
    m = len(problem.friction)
    near = 1e-9 * np.abs(x).max(initial=0.0)
    limit = problem.friction * x[:m] - near
    cases = np.where(x[m:] >= limit, FORWARD, np.where(x[m:] <= -limit, BACKWARD, STICK))
    return _without_friction(problem, np.where(x[:m] <= near, OPEN, cases))


def _lemke_impulses(problem: Problem) -> Floats | None:
    """Return impulses from the linear complementarity problem of Anitescu and Potra.

    Friction is the difference of two impulses, forwards and backwards; a slack, which is the
    sliding speed, holds their sum to mu jn. With springs its matrix is strictly copositive, and
    Lemke's method ends with an answer whatever b is.

    References
    ----------
    Anitescu and Potra, Formulating dynamic multi-rigid-body contact problems with friction as
    solvable linear complementarity problems (1997).
    """
    k, b, mu = problem
    m = len(mu)
    rough = np.flatnonzero(mu > 0.0)
    r = len(rough)
    tangents = np.zeros((2 * m, r))
    tangents[m + rough, np.arange(r)] = 1.0
    basis = np.hstack((np.eye(2 * m)[:, :m], tangents, -tangents))  # x = basis z
    size = m + 3 * r
    matrix = np.zeros((size, size))
    matrix[: m + 2 * r, : m + 2 * r] = basis.T @ k @ basis
    slack = np.arange(m + 2 * r, size)
    forwards, backwards = np.arange(m, m + r), np.arange(m + r, m + 2 * r)
    matrix[slack, rough] = mu[rough]
    for side in (forwards, backwards):
        matrix[slack, side] = -1.0
        matrix[side, slack] = 1.0
    matrix += SPRING * float(np.trace(k)) / (2 * m) * np.eye(size)
    z = lemke(matrix, np.concatenate((basis.T @ b, np.zeros(r))))
    return None if z is None else np.asarray(basis @ z[: m + 2 * r])


def _softened(problem: Problem) -> Answer:
    """Return the answer of a problem in which every contact gives way a little."""
    k = problem.compliance
    soft = k + SOFT * float(np.trace(k)) / len(k) * np.eye(len(k))
    yielding = problem._replace(compliance=soft)
    x = _by_pivoting(yielding, _guess(yielding)).impulses
    return Answer(x, complementarity_error(problem, x), "softened")


