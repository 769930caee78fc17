"""The contact problem of an island, solved all at once.

Four ways, in this order; the answer of each is judged by its own complementarity error.

==============  ===========================================================================
`one`           a single contact: sticking is two equations, sliding one
`pivoting`      block principal pivoting: exact, and usually done in a few rounds
`lemke`         Lemke's method, where that has not come to an end; but for rounding it always
                does
`softened`      every contact gives way a little: for what has no answer at all, a body between
                two walls that close; `least_error` recognises that after the first attempt
==============  ===========================================================================

Two corners of a face that both stick, or a box on three posts, leave the loads undecided. Taken is
the load with the least sum of squares: an even load comes out even.

References
----------
Cottle, Pang and Stone, The Linear Complementarity Problem (1992), chapters 3 and 4.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from lesson_code.engine.solvers.contact_problem import (
    ENOUGH,
    RANK,
    SOLVED,
    SPRINGS,
    Answer,
    Cases,
    Floats,
    Problem,
    cases_of,
    complementarity_error,
    legal,
    spring_of,
    tolerance,
)
from lesson_code.engine.solvers.lemke import lemke
from lesson_code.engine.solvers.pivoting import by_pivoting, first_guess

SOFT = 1e-3
"""The same for a problem without an answer: bodies give way by a thousandth of the velocity."""

MUCH_BETTER = 0.1
"""Of the softened answer's error: an answer that is not exact must be so much nearer to it. Where
there is none, the other methods find impulses that are as wrong, and a million times as large."""

MOST_FOR_LEMKE = 300
"""Contacts of an island for which Lemke's method is tried; with more it takes seconds."""


def solve_contacts(problem: Problem, guess: Cases | None = None) -> Answer:
    """Return the impulses of all contacts of an island.

    Parameters
    ----------
    problem : Problem
        K must come from bodies of which one at each contact can be moved.
    guess : ndarray of int, shape (m,), optional
        The case that each contact may have; saves rounds where it is right, and else nothing.

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
    alike, d = problem.scaled()
    answer = _solve(alike, guess)
    return answer._replace(impulses=d * answer.impulses)


def _solve(problem: Problem, guess: Cases | None) -> Answer:
    """Return the answer for a problem whose K needs no scale, and in which something approaches."""
    m = len(problem.friction)
    if m == 1:
        single = _one_contact(problem)
        if single is not None:
            return Answer(single, complementarity_error(problem, single), "one")
    best, softened = Answer(np.zeros(2 * m), math.inf, ""), None
    for attempt, answer in enumerate(_answers(problem, guess)):
        best = min(best, answer, key=_error)
        if _is_solved(problem, best):
            return best
        if attempt == 0 and (least := least_error(problem, answer.impulses)):
            softened = _softened(problem)
            if least >= MUCH_BETTER * softened.error:
                return softened  # no method finds anything much better
    softened = softened or _softened(problem)
    return best if best.error < MUCH_BETTER * softened.error else softened


def _answers(problem: Problem, guess: Cases | None) -> Iterator[Answer]:
    """Yield the answers of one method after the other, the quickest first."""
    for spring in SPRINGS:
        answer = by_pivoting(problem, first_guess(problem, guess), spring)
        yield answer
        if not answer.fits:
            break
    if len(problem.friction) <= MOST_FOR_LEMKE:
        yield by_lemke(problem)


def _error(answer: Answer) -> float:
    """Return how far an answer is from solving its problem, m/s."""
    return answer.error


def _is_solved(problem: Problem, answer: Answer) -> bool:
    """Return whether so little is left of the error that no other method is worth trying."""
    return answer.error <= ENOUGH * problem.fastest or answer.error <= tolerance(
        problem, answer.impulses
    )


def least_error(problem: Problem, x: Floats) -> float:
    """Return what every answer of a problem leaves of approach at some contact, at least, m/s.

    Loads y >= 0 that move nothing, K y = 0, prove it: y.(b + K x) = y.b, whatever x is. Where y.b
    is negative some contact approaches, as on both sides of a body between two walls that close. As
    y is taken what least squares leave of approach at the contacts that push or approach after an
    attempt x. The result is 0 if that proves nothing.

    References
    ----------
    Cottle, Pang and Stone, The Linear Complementarity Problem (1992), section 2.7 (Farkas' lemma).
    """
    k, b, m = problem.delassus, problem.velocity, len(problem.friction)
    held = ((x[:m] > 0.0) | ((b + k @ x)[:m] < 0.0)).nonzero()[0]
    of_held = k[np.ix_(held, held)]
    left = b[held] + of_held @ np.linalg.lstsq(of_held, -b[held], rcond=RANK)[0]
    y = np.maximum(-left, 0.0)
    closing, load = -float(y @ b[held]), float(y.sum())
    moves = np.abs(k[:, held] @ y).max(initial=0.0)
    is_proof = closing > ENOUGH * load * np.abs(b).max() and moves <= SOLVED * load
    return closing / load if is_proof else 0.0


def _one_contact(problem: Problem) -> Floats | None:
    """Return the impulses of a single contact that approaches, in closed form."""
    (knn, knt), (_, ktt) = problem.delassus.tolist()
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


def by_lemke(problem: Problem) -> Answer:
    """Return the answer by Lemke's method, improved by pivoting from its cases."""
    x = _lemke_impulses(problem)
    if x is None:
        zero = np.zeros(2 * len(problem.friction))
        return Answer(zero, complementarity_error(problem, zero), "lemke")
    x = legal(problem, x)
    found = Answer(x, complementarity_error(problem, x), "lemke")
    improved = by_pivoting(problem, cases_of(problem.friction, x))
    return improved._replace(method="lemke") if improved.error < found.error else found


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
    k, b, mu = problem.delassus, problem.velocity, problem.friction
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
    matrix += spring_of(problem) * np.eye(size)
    z = lemke(matrix, np.concatenate((basis.T @ b, np.zeros(r))))
    return None if z is None else np.asarray(basis @ z[: m + 2 * r])


def _softened(problem: Problem) -> Answer:
    """Return the answer of a problem in which every contact gives way a little."""
    k = problem.delassus
    soft = k + SOFT * float(np.trace(k)) / len(k) * np.eye(len(k))
    yielding = replace(problem, delassus=soft)
    answer = by_pivoting(yielding, first_guess(yielding, None))
    if not _is_solved(yielding, answer) and len(problem.friction) <= MOST_FOR_LEMKE:
        answer = min(answer, by_lemke(yielding), key=_error)
    x = answer.impulses
    return Answer(x, complementarity_error(problem, x), "softened")
