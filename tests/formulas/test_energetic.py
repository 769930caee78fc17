"""The energetic law of restitution: its closed cases, an integration in small steps, its energy."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.formulas.energetic import energetic_impulse

ROUNDING = 1e-12
"""Of the largest number in an impact: four phases of a dozen operations each; close to where
knt^2 = knn ktt some digits cancel."""

GROWTH = 1e-13
"""Of the energy at the contact before the impact: rounding."""

STEPS = 4000
"""Small steps of the normal impulse in the integration that nothing is known of beforehand."""

COARSE = 4e-3
"""Of the largest impulse: each event of the integration is late by one of its steps at most."""

IMPACTS = 15_000
"""Random frictional impacts, all of which must lose energy."""

approaches = st.floats(-5, -0.1)
slidings = st.floats(-5, 5)
restitutions = st.floats(0, 1)
frictions = st.floats(0, 3)
responses = st.tuples(st.floats(0.5, 5), st.floats(-0.95, 0.95), st.floats(0.5, 5)).map(
    lambda k: (k[0], k[1] * math.sqrt(k[0] * k[2]), k[2])
)


def energy_gain(
    u: tuple[float, float], k: tuple[float, float, float], j: tuple[float, float]
) -> float:
    """Return what an impulse brings, u . j + j K j / 2, of the energy u K^-1 u / 2 before."""
    (vn, vt), (knn, knt, ktt), (jn, jt) = u, k, j
    before = (ktt * vn * vn - 2 * knt * vn * vt + knn * vt * vt) / (knn * ktt - knt * knt) / 2
    gain = vn * jn + vt * jt + (knn * jn * jn + 2 * knt * jn * jt + ktt * jt * jt) / 2
    return gain / before


@given(vn=approaches, vt=slidings, k=responses, e=restitutions)
def test_impulse_without_friction_is_newtons(
    vn: float, vt: float, k: tuple[float, float, float], e: float
) -> None:
    """Work given back is e^2 of the work taken; along one line both laws say the same."""
    jn, jt = energetic_impulse(vn, vt, *k, e, 0.0)
    assert jn == pytest.approx(-(1 + e) * vn / k[0], rel=ROUNDING)
    assert jt == 0.0


@given(vn=approaches, vt=slidings, k=responses, e=restitutions, mu=frictions)
def test_impulse_where_nothing_couples_is_newtons(
    vn: float, vt: float, k: tuple[float, float, float], e: float, mu: float
) -> None:
    """With knt = 0 (a disc) jn = -(1 + e) vn / knn, and jt = -vt / ktt up to mu jn."""
    knn, _, ktt = k
    jn, jt = energetic_impulse(vn, vt, knn, 0.0, ktt, e, mu)
    right = -(1 + e) * vn / knn
    assert jn == pytest.approx(right, rel=ROUNDING)
    assert jt == pytest.approx(min(max(-vt / ktt, -mu * right), mu * right), abs=ROUNDING * 100)


@given(vn=approaches, k=responses, e=restitutions, more=st.floats(0, 1))
def test_impulse_that_sticks_from_the_start_has_its_own_mass(
    vn: float, k: tuple[float, float, float], e: float, more: float
) -> None:
    """With vt = 0, mu >= abs(knt)/ktt: jn = -(1 + e) vn / (knn - knt^2 / ktt), jt = -knt/ktt jn."""
    knn, knt, ktt = k
    jn, jt = energetic_impulse(vn, 0.0, knn, knt, ktt, e, abs(knt) / ktt * (1 + 1e-12) + more)
    assert jn == pytest.approx(-(1 + e) * vn / (knn - knt * knt / ktt), rel=1e2 * ROUNDING)
    assert jt == pytest.approx(-knt / ktt * jn, rel=1e2 * ROUNDING, abs=ROUNDING)


def test_impulse_worked_by_hand_turns_the_sliding_round() -> None:
    """Given knn = 2, knt = ktt = 1, mu = 1/2, vn = -2, vt = -1/2, e = 1.

    Sliding back (vt < 0, friction forwards): dvn/dp = 5/2, dvt/dp = 3/2, so vt = 0 at p = 1/3,
    where vn = -7/6. Holding takes 1 > mu: it slides on forwards, dvn/dp = 3/2, dvt/dp = 1/2. The
    approach ends after 7/9 more. Work taken: (2 + 7/6) / 2 / 3 + 7/6 * 7/18 = 53/54.
    Given back: 3/4 p^2 = 53/54, p = sqrt(106/81).
    """
    taken = Fraction(19, 36) + Fraction(49, 108)
    assert taken == Fraction(53, 54)
    back = math.sqrt(106) / 9
    jn, jt = energetic_impulse(-2.0, -0.5, 2.0, 1.0, 1.0, 1.0, 0.5)
    assert jn == pytest.approx(1 / 3 + 7 / 9 + back, rel=ROUNDING)
    assert jt == pytest.approx(1 / 6 - (7 / 9 + back) / 2, rel=ROUNDING)


def in_small_steps(
    vn: float, vt: float, k: tuple[float, float, float], e: float, mu: float
) -> tuple[float, float]:
    """Follow an impact in small steps of p, each with the friction that stops vt, or fails."""
    knn, knt, ktt = k
    dp = -2 * vn / (knn - knt * knt / ktt) / STEPS
    jn = jt = work = 0.0
    least = 0.0
    while vn < 0 or work < (1 - e * e) * least:
        rub = min(max(-(vt + knt * dp) / ktt, -mu * dp), mu * dp)
        next_vn = vn + knn * dp + knt * rub
        work += (vn + next_vn) / 2 * dp
        least = min(least, work)
        vn, vt = next_vn, vt + knt * dp + ktt * rub
        jn, jt = jn + dp, jt + rub
    return jn, jt


@given(vn=approaches, vt=slidings, k=responses, e=restitutions, mu=st.floats(0, 1.5))
def test_impulse_of_any_impact_is_that_of_small_steps(
    vn: float, vt: float, k: tuple[float, float, float], e: float, mu: float
) -> None:
    """An integration that knows nothing of phases comes to the same impulse."""
    assume(abs(k[1]) < 0.8 * math.sqrt(k[0] * k[2]))
    jn, jt = energetic_impulse(vn, vt, *k, e, mu)
    # jammed impacts take a longer impulse than the steps are made for
    assume(jn < -8 * vn / (k[0] - k[1] ** 2 / k[2]))
    expected = in_small_steps(vn, vt, k, e, mu)
    assert (jn, jt) == pytest.approx(expected, abs=COARSE * max(jn, abs(vt) / k[2]))


def test_energy_of_15000_random_impacts_never_rises() -> None:
    """Masses over four decades, arms of any direction, mu up to 2: no gain, and friction holds."""
    rng = np.random.default_rng(20260)
    worst = -math.inf
    for _ in range(IMPACTS):
        inverse_mass = 10 ** rng.uniform(-2, 2)
        spin = inverse_mass * 10 ** rng.uniform(0, 2)
        x, y = rng.uniform(-1, 1, 2)
        k = (inverse_mass + x * x * spin, -x * y * spin, inverse_mass + y * y * spin)
        u = (-abs(rng.normal()), rng.normal())
        e, mu = rng.uniform(0, 1), rng.uniform(0, 2)
        j = energetic_impulse(*u, *k, e, mu)
        assert abs(j[1]) <= mu * j[0] * (1 + ROUNDING)
        worst = max(worst, energy_gain(u, k, j))
    assert worst <= GROWTH


@given(vn=approaches, vt=slidings, k=responses, e=restitutions, mu=frictions)
def test_impact_ends_with_parting(
    vn: float, vt: float, k: tuple[float, float, float], e: float, mu: float
) -> None:
    """However it slides, jams or turns round: in the end the bodies do not approach."""
    jn, jt = energetic_impulse(vn, vt, *k, e, mu)
    assert vn + k[0] * jn + k[1] * jt >= -ROUNDING * 1e3


def test_impact_that_jams_first_stops_the_sliding() -> None:
    """Where knn < mu knt: while it slides, friction presses the bodies together (Painleve).

    knn = 1, knt = 0.9, ktt = 1, mu = 2, vn = -1, vt = 1, e = 0: it slides until vt = 1 - 1.1 p
    is 0, at p = 10/11; there vn = -1 - 0.8 p = -19/11. Sticking, vn rises with 1 - 0.81 = 0.19.
    """
    jn, jt = energetic_impulse(-1.0, 1.0, 1.0, 0.9, 1.0, 0.0, 2.0)
    more = 19 / 11 / 0.19
    assert jn == pytest.approx(10 / 11 + more, rel=ROUNDING)
    assert jt == pytest.approx(-20 / 11 - 0.9 * more, rel=ROUNDING)


@pytest.mark.parametrize("vn", [0.0, 2.0])
def test_impulse_of_what_does_not_approach_is_none(vn: float) -> None:
    """Nothing happens to bodies that part."""
    assert energetic_impulse(vn, 1.0, 1.0, 0.2, 1.0, 0.5, 0.5) == (0.0, 0.0)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"knt": 1.0}, r"knt must satisfy knt\^2 < knn ktt = 1.0, got 1.0"),
        ({"knn": 0.0}, "knn must be > 0 and finite, got 0.0"),
        ({"friction": -1.0}, "friction must be >= 0 and finite, got -1.0"),
        ({"restitution": 1.5}, "restitution must be between 0 and 1, got 1.5"),
        ({"vn": np.array([-1.0, -2.0])}, "vn must be one number"),
    ],
)
def test_argument_out_of_range_is_refused(change: dict[str, float], message: str) -> None:
    """The error names the argument, the rule and the value."""
    right = {"vn": -1.0, "vt": 0.0, "knn": 1.0, "knt": 0.0, "ktt": 1.0}
    with pytest.raises(ValueError, match=message):
        energetic_impulse(**(right | {"restitution": 0.5, "friction": 0.5} | change))
