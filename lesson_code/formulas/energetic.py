"""The energetic law of restitution: one frictional impact that never gains energy.

Newton's e compares velocities. With friction and a blow beside the centre of mass the sliding
may stop or turn round in the middle of the impact, and an impact by Newton's rule can then end
with more energy than it began with. Stronge's e compares work: of what the normal force takes
while it stops the approach, it gives back the part e^2.

During the impact the normal impulse p grows from 0 to jn. Velocities are straight lines in p as
long as the sliding keeps its direction,

    sliding   dvn/dp = knn - mu s knt,     dvt/dp = knt - mu s ktt,    s = sign(vt)
    sticking  dvn/dp = knn - knt^2 / ktt,  dvt/dp = 0

and the work of the normal force is the area under vn over p.

========  =================================================================  =====
symbol    meaning                                                            unit
========  =================================================================  =====
vn, vt    relative velocity at the contact, along normal and tangent         m/s
knn, ktt  change of vn by an impulse of 1 along the normal, of vt along      1/kg
          the tangent
knt       change of vt by 1 along the normal, and of vn by 1 along the       1/kg
          tangent
mu, e     friction coefficient, coefficient of restitution                   -
jn, jt    impulse along normal and tangent in total                          N s
========  =================================================================  =====

References
----------
Stronge, Impact Mechanics (2000): the energetic coefficient of restitution. Bhatt and Koechling,
Partitioning the parameter space according to different behaviors during three-dimensional impacts
(1995), for the flow of the sliding during an impact.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

from lesson_code.formulas.validation import (
    finite,
    formula,
    non_negative,
    one_number,
    positive,
    unit_interval,
)

Two: TypeAlias = tuple[float, float]


def _can_yield(values: dict[str, Any]) -> None:
    """Refuse arrays, and a response that no two bodies have: knt^2 must be less than knn ktt."""
    for name, value in values.items():
        one_number(name, value)
    knn, knt, ktt = (float(values[name]) for name in ("knn", "knt", "ktt"))
    if not knt * knt < knn * ktt:
        raise ValueError(f"knt must satisfy knt^2 < knn ktt = {knn * ktt}, got {knt}")


@formula(
    together=_can_yield,
    vn=finite,
    vt=finite,
    knn=positive,
    knt=finite,
    ktt=positive,
    restitution=unit_interval,
    friction=non_negative,
)
def energetic_impulse(
    vn: float, vt: float, knn: float, knt: float, ktt: float, restitution: float, friction: float
) -> Two:
    """Return the impulse of one impact with friction by the energetic law of restitution.

    work(compression) = integral of vn dp until vn = 0,
    jn is where        work(restitution) = -e^2 work(compression)

    The impact is followed from event to event: the sliding stops, or turns round; the approach
    ends; the work is given back. Between two of them vn and vt are straight lines in p.

    Parameters
    ----------
    vn, vt : float
        Relative velocity of B's touching point along normal and tangent, m/s; vn < 0 approaches.
    knn, knt, ktt : float
        Response of the contact, 1/kg; knn, ktt > 0 and knt^2 < knn ktt.
    restitution : float
        e, 0 to 1.
    friction : float
        mu, >= 0.

    Returns
    -------
    (jn, jt) : tuple of float
        Impulse on B along normal and tangent, N s; abs(jt) <= mu jn. Zero if vn >= 0.

    Raises
    ------
    ValueError
        A number is out of range or not finite.

    References
    ----------
    Stronge, Impact Mechanics (2000).

    Examples
    --------
    Without friction it is Newton's rule, (1 + e) times what stops the approach:

    >>> energetic_impulse(
    ...     vn=-2.0, vt=1.0, knn=1.0, knt=0.0, ktt=3.0, restitution=0.5, friction=0.0
    ... )
    (3.0, 0.0)

    Slow sliding on a rough surface stops during the impact; jt = -vt / ktt:

    >>> energetic_impulse(
    ...     vn=-2.0, vt=0.75, knn=1.0, knt=0.0, ktt=3.0, restitution=0.5, friction=1.0
    ... )
    (3.0, -0.25)
    """
    if not vn < 0.0:
        return 0.0, 0.0
    stop_n, stop_t, vt, taken = stop_approach(vn, vt, knn, knt, ktt, friction)
    back_n, back_t = give_back(restitution * restitution * taken, vt, knn, knt, ktt, friction)
    return stop_n + back_n, stop_t + back_t


PHASES = 4
"""Sliding, then sticking or sliding back: two phases are enough before the approach has ended, and
two after it. Twice as many, for a phase that rounding leaves to be finished."""


def stop_approach(
    vn: float, vt: float, knn: float, knt: float, ktt: float, friction: float
) -> tuple[float, float, float, float]:
    """Return jn, jt and vt when the approach has ended, and the work that it has cost, J.

    >>> stop_approach(vn=-2.0, vt=1.0, knn=1.0, knt=0.0, ktt=3.0, friction=0.0)
    (2.0, 0.0, 1.0, 2.0)
    """
    jn, jt, taken = 0.0, 0.0, 0.0
    for _ in range(PHASES):
        rub, rate, rate_t = rates(vt, knn, knt, ktt, friction)
        turn = impulse_to_turn(vt, rate_t)
        end = -vn / rate if rate > 0.0 else math.inf
        p = min(turn, end)
        jn, jt, taken = jn + p, jt + rub * p, taken - (vn + rate * p / 2) * p
        vn, vt = vn + rate * p, 0.0 if p == turn else vt + rate_t * p
        if end <= turn:
            break
    return jn, jt, vt, taken


def give_back(
    work: float, vt: float, knn: float, knt: float, ktt: float, friction: float
) -> tuple[float, float]:
    """Return jn and jt of the rest of the impact, in which the normal force does so much work.

    >>> give_back(work=2.0, vt=1.0, knn=1.0, knt=0.0, ktt=3.0, friction=0.0)
    (2.0, 0.0)
    """
    jn, jt, vn = 0.0, 0.0, 0.0
    for _ in range(PHASES):
        rub, rate, rate_t = rates(vt, knn, knt, ktt, friction)
        turn = impulse_to_turn(vt, rate_t)
        end = impulse_for_work(vn, rate, work)
        p = min(turn, end)
        jn, jt, work = jn + p, jt + rub * p, work - (vn + rate * p / 2) * p
        vn, vt = vn + rate * p, 0.0 if p == turn else vt + rate_t * p
        if end <= turn:
            break
    return jn, jt


def rates(
    vt: float, knn: float, knt: float, ktt: float, friction: float
) -> tuple[float, float, float]:
    """Return djt/dp, dvn/dp and dvt/dp.

    Sliding, friction is -mu or mu; sticking, it is what keeps vt at 0, if friction can do that.

    >>> rates(vt=1.0, knn=1.0, knt=0.75, ktt=3.0, friction=0.5)
    (-0.5, 0.625, -0.75)
    >>> rates(vt=0.0, knn=1.0, knt=0.75, ktt=3.0, friction=0.5)
    (-0.25, 0.8125, 0.0)
    """
    holding = -knt / ktt
    if vt == 0.0 and abs(holding) <= friction:
        return holding, knn + holding * knt, 0.0
    rub = math.copysign(friction, -vt if vt != 0.0 else holding)
    return rub, knn + rub * knt, knt + rub * ktt


def impulse_to_turn(vt: float, rate: float) -> float:
    """Return the normal impulse that brings vt to 0; infinite if it never comes there.

    >>> impulse_to_turn(vt=1.0, rate=-2.0), impulse_to_turn(vt=1.0, rate=2.0)
    (0.5, inf)
    """
    return -vt / rate if vt * rate < 0.0 else math.inf


def impulse_for_work(vn: float, rate: float, work: float) -> float:
    """Return the impulse p in which the normal force does a given work.

    vn p + rate p^2 / 2 = work

    >>> impulse_for_work(vn=1.0, rate=2.0, work=2.0)
    1.0
    """
    return 2 * work / (vn + math.sqrt(vn * vn + 2 * rate * work)) if work > 0.0 else 0.0
