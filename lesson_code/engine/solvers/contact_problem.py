"""A contact problem, and what it means to solve it.

An impulse x at the contacts of an island changes their velocities by K x. Wanted are impulses with

    w = b + K x
    jn >= 0,    wn >= 0,    jn wn = 0                          a contact pushes, or it opens
    abs(jt) <= mu jn,  wt = 0   or   jt = +-mu jn against wt   it sticks, or it slides

==========  ==========================================================  =====
symbol      meaning                                                     unit
==========  ==========================================================  =====
m           number of contacts                                          -
x           impulses, first the m normal ones, then the m tangential    N s
b           velocities without x, those along the normals less what     m/s
            they have to reach; in the same order
K           velocities from impulses, 2m by 2m, symmetric               1/kg
mu          friction coefficient of each contact                        -
d           scale of each contact's impulses: x = d y                   kg^1/2
==========  ==========================================================  =====
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]
Cases: TypeAlias = NDArray[np.int64]

BACKWARD, STICK, FORWARD, OPEN, UNKNOWN = -1, 0, 1, 2, 3
"""What a contact does; where it slides, the number is the sign of its friction impulse. Of a
contact that is new nothing is known."""

SPRINGS = 1e-8, 1e-12
"""Of the mean of K's diagonal: what is added to it to make the equations solvable. The error that
it makes is taken out again; the smaller it is, the more shows rounding in how a load is shared.
The second is for masses so far apart that K itself is softer than the first."""

SOLVED = 1e-12
"""Of the largest velocity in b: the complementarity error that is as good as none."""

ENOUGH = 1e-7
"""Of the same: the error that is left where contacts on the brink of opening or sliding have
been given the wrong case. No other method is tried for it; the next step starts anew."""

RANK = 1e-13
"""Of the largest singular value: smaller ones are rounding errors of 0."""

ROUNDING = 1e-14
"""Of the largest term in K x: what rounding leaves of velocities that cancel."""


@dataclass(frozen=True, eq=False)
class Problem:
    """A contact problem: K, b and mu, and the scale in which its bodies are alike."""

    delassus: Floats  # K, shape (2m, 2m), 1/kg
    velocity: Floats  # b, shape (2m,), m/s
    friction: Floats  # mu, shape (m,)
    scale: Floats | None = None  # d, shape (m,), kg^1/2; None: 1 for all

    @cached_property
    def own(self) -> Floats:
        """The diagonal of K: the velocity that an impulse gives its own contact, 1/kg."""
        return self.delassus.diagonal()

    @cached_property
    def sizes(self) -> Floats:
        """The sizes of all numbers in K, 1/kg."""
        return np.abs(self.delassus)

    @cached_property
    def fastest(self) -> float:
        """The largest velocity in b, m/s."""
        return float(np.abs(self.velocity).max())

    def part(self, points: Cases) -> Problem:
        """Return the problem of some of the contacts, given by their places, shape (p,)."""
        both = np.concatenate((points, len(self.friction) + points))
        scale = None if self.scale is None else self.scale[points]
        k = self.delassus[both[:, np.newaxis], both]
        return Problem(k, self.velocity[both], self.friction[points], scale)

    def scaled(self) -> tuple[Problem, Floats]:
        """Return the problem for y, and d for all 2m impulses x = d y.

        Its K is D K D: about 1 on the diagonal, whether a contact is between grains or mountains.
        """
        d = np.ones_like(self.friction) if self.scale is None else self.scale
        both = np.concatenate((d, d))
        k = self.delassus * both * both[:, np.newaxis]
        return Problem(k, self.velocity * both, self.friction), both


class Answer(NamedTuple):
    """Impulses, and how well they solve the problem."""

    impulses: Floats
    """Shape (2m,), N s."""
    error: float
    """What is left of the complementarity conditions, m/s; 0 is exact."""
    method: str
    """"open" (no contact is needed), "one" (closed form), "pivoting", "lemke" or "softened"."""
    fits: bool = True
    """Whether the search for cases has come to its end; else it went in circles."""


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
    wanted = x - (problem.velocity + problem.delassus @ x) / problem.own
    limit = problem.friction * np.maximum(x[:m], 0.0)
    normal = x[:m] - np.maximum(wanted[:m], 0.0)
    tangent = x[m:] - np.minimum(np.maximum(wanted[m:], -limit), limit)
    return float(np.abs(np.concatenate((normal, tangent)) * problem.own).max(initial=0.0))


def tolerance(problem: Problem, x: Floats) -> float:
    """Return the error at which impulses count as exact, m/s."""
    terms = problem.sizes @ np.abs(x)
    return float(SOLVED * problem.fastest + ROUNDING * terms.max())


def spring_of(problem: Problem, share: float = SPRINGS[0]) -> float:
    """Return what is added to the diagonal of K, 1/kg: a share of its mean."""
    return share * float(problem.delassus.trace()) / len(problem.delassus)


def legal(problem: Problem, x: Floats) -> Floats:
    """Return impulses without what rounding has made of zeros and limits: no pull, no excess."""
    m = len(problem.friction)
    jn = np.maximum(x[:m], 0.0)
    limit = problem.friction * jn
    return np.concatenate((jn, np.minimum(np.maximum(x[m:], -limit), limit)))


def cases_of(friction: Floats, x: Floats) -> Cases:
    """Return the cases that impulses belong to."""
    m = len(friction)
    near = 1e-9 * np.abs(x).max(initial=0.0)
    limit = friction * x[:m] - near
    cases = np.where(x[m:] >= limit, FORWARD, np.where(x[m:] <= -limit, BACKWARD, STICK))
    return without_friction(friction, np.where(x[:m] <= near, OPEN, cases))


def without_friction(friction: Floats, cases: Cases) -> Cases:
    """Return the cases with contacts without friction sliding: their friction is mu jn = 0."""
    smooth: Cases = np.where((cases != OPEN) & (friction == 0.0), FORWARD, cases)
    return smooth
