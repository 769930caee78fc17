"""One impact with spin and friction: the laws it has to obey, and the ways it may be found."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.reference.contact_closed_forms import (
    Struck,
    disc_impact,
    impact_with_friction,
)

ROUNDING = 1e-12
"""Of the largest numbers of a case: some forty roundings, and a determinant that may be a tenth
of its parts. Measured over 10,000: 2e-16."""

EXACT = 1e-14
"""Relative: a few roundings."""

CONVERGED = 1e-9
"""Of the impulses; 1,000 sweeps that each leave at most 0.9 of the error leave nothing."""

LARGEST = 100.0
"""m/s: no velocity of the random cases, before or after, is larger."""

speeds = st.floats(-10, 10).map(lambda x: round(x, 6))
vectors = st.tuples(speeds, speeds).map(np.array)
arms = st.tuples(st.floats(-1, 1), st.floats(-1, 1)).map(np.array)
angles = st.floats(-math.pi, math.pi)
bodies = st.builds(Struck, st.floats(0.2, 5), st.floats(0.2, 5), vectors, speeds, arms)


class Case(NamedTuple):
    """The arguments of an impact."""

    a: Struck
    b: Struck
    normal: Any
    e: float
    mu: float


normals = angles.map(lambda angle: np.array([math.cos(angle), math.sin(angle)]))
cases = st.builds(Case, bodies, bodies, normals, st.floats(0, 1), st.floats(0, 5))


def cross(a: Any, b: Any) -> float:
    """Return a_x b_y - a_y b_x."""
    return float(a[0] * b[1] - a[1] * b[0])


def axes(c: Case) -> tuple[Any, Any]:
    """Return n and t."""
    return c.normal, np.array([-c.normal[1], c.normal[0]])


def matrix(c: Case) -> Any:
    """Return [[knn, knt], [knt, ktt]] from the lever arms: the sum of (r x p)(r x q)/I, and 1/m."""
    arms = [np.array([cross(x.arm, axis) for axis in axes(c)]) for x in (c.a, c.b)]
    turning = c.a.inverse_inertia * np.outer(arms[0], arms[0])
    turning += c.b.inverse_inertia * np.outer(arms[1], arms[1])
    return (c.a.inverse_mass + c.b.inverse_mass) * np.eye(2) + turning


def touching(c: Case, velocities: Any, spins: Any) -> Any:
    """Return un and ut, for given velocities of both bodies."""
    on_a, on_b = (
        v + w * np.array([-x.arm[1], x.arm[0]])
        for x, v, w in zip((c.a, c.b), velocities, spins, strict=True)
    )
    return np.array([axis @ (on_b - on_a) for axis in axes(c)])


def before(c: Case) -> Any:
    """Return un and ut before."""
    return touching(c, (c.a.velocity, c.b.velocity), (c.a.angular_velocity, c.b.angular_velocity))


def energy(c: Case, velocities: Any, spins: Any) -> float:
    """Return the kinetic energy, J, of bodies that can be moved and turned."""
    return sum(
        float(v @ v) / x.inverse_mass / 2 + float(w) ** 2 / x.inverse_inertia / 2
        for x, v, w in zip((c.a, c.b), velocities, spins, strict=True)
    )


def energy_ratio(c: Case) -> float:
    """Return the kinetic energy after, in units of that before."""
    impact = impact_with_friction(*c)
    start = (c.a.velocity, c.b.velocity), (c.a.angular_velocity, c.b.angular_velocity)
    return energy(c, impact.velocities, impact.angular_velocities) / energy(c, *start)


def sweeps(c: Case, count: int) -> list[tuple[float, float]]:
    """Return (jn, jt) after each sweep of a solver that treats un and ut in turn."""
    (knn, knt), (_, ktt) = matrix(c).tolist()
    un, ut = before(c).tolist()
    jn, jt, history = 0.0, 0.0, []
    for _ in range(count):
        jn = max(-((1 + c.e) * un + knt * jt) / knn, 0.0)
        jt = min(max(-(ut + knt * jn) / ktt, -c.mu * jn), c.mu * jn)
        history.append((jn, jt))
    return history


def floor() -> Struck:
    """Return what nothing moves."""
    return Struck(0.0, 0.0, np.zeros(2), 0.0, np.zeros(2))


def rod(slope: float, velocity: tuple[float, float], e: float, mu: float) -> Case:
    """Return a thin rod of 1 kg and 2 m (I = 1/3) whose lower, right end meets the floor."""
    arm = np.array([1.0, -slope]) / math.hypot(1, slope)
    return Case(
        floor(), Struck(1.0, 3.0, np.array(velocity), 0.0, arm), np.array([0.0, 1.0]), e, mu
    )


@given(cases)
def test_impact_keeps_momentum_and_angular_momentum(c: Case) -> None:
    """What A loses B gains; I w - r x m v of each body, about the touching point, stays."""
    impact = impact_with_friction(*c)
    gains = []
    for i, x in enumerate((c.a, c.b)):
        gain = (impact.velocities[i] - x.velocity) / x.inverse_mass
        turn = (impact.angular_velocities[i] - x.angular_velocity) / x.inverse_inertia
        assert turn == pytest.approx(cross(x.arm, gain), abs=ROUNDING * LARGEST)
        gains.append(gain)
    np.testing.assert_allclose(gains[0] + gains[1], 0, rtol=0, atol=ROUNDING * LARGEST)
    j = np.array([impact.normal_impulse, impact.tangent_impulse]) @ axes(c)
    np.testing.assert_allclose(gains[1], j, rtol=0, atol=ROUNDING * LARGEST)


@given(cases)
def test_impact_obeys_newton_and_coulomb(c: Case) -> None:
    """By Newton un' = -e un; by Coulomb ut' = 0, or friction is full and acts against ut'."""
    impact = impact_with_friction(*c)
    un, ut = touching(c, impact.velocities, impact.angular_velocities)
    jn, jt = impact.normal_impulse, impact.tangent_impulse
    if before(c)[0] >= 0:
        assert (impact.kind, jn, jt) == ("parts", 0, 0)
        return
    assert un == pytest.approx(-c.e * before(c)[0], abs=ROUNDING * LARGEST)
    assert jn > 0
    assert abs(jt) <= c.mu * jn * (1 + EXACT)
    if impact.kind == "sticks":
        assert ut == pytest.approx(0, abs=ROUNDING * LARGEST)
    else:
        assert impact.kind == "slides"
        assert abs(jt) == pytest.approx(c.mu * jn, rel=EXACT)
        assert math.copysign(1, jt) * ut <= ROUNDING * LARGEST


@given(cases)
def test_impact_has_exactly_one_answer(c: Case) -> None:
    """Of sticking and the two ways of sliding just one agrees with itself, and it is ours."""
    k, (un, ut) = matrix(c), before(c)
    assume(un < -1e-3)
    stick = np.linalg.solve(k, (-(1 + c.e) * un, -ut))
    margins, found = [c.mu * stick[0] - abs(stick[1])], []
    if margins[0] >= 0:
        found.append(("sticks", stick[0]))
    for jt_per_jn in (-c.mu, c.mu):
        change_un, change_ut = k @ (1.0, jt_per_jn)
        jn = -(1 + c.e) * un / change_un
        margins += [change_un, jt_per_jn * (ut + change_ut * jn)]
        if change_un > 0 and margins[-1] < 0:
            found.append(("slides", jn))
    assume(min(map(abs, margins)) > 1e-6)  # next to an edge, rounding decides
    [(kind, jn)] = found
    impact = impact_with_friction(*c)
    assert impact.kind == kind
    assert impact.normal_impulse == pytest.approx(jn, rel=LARGEST * ROUNDING)


@given(cases)
def test_impact_without_restitution_or_friction_gains_no_energy(c: Case) -> None:
    """Not with e = 0, whatever mu; with mu = 0 it loses 1/2 (1 - e^2) un^2 / knn."""
    start = (c.a.velocity, c.b.velocity), (c.a.angular_velocity, c.b.angular_velocity)
    plastic = impact_with_friction(*c._replace(e=0.0))
    smooth = impact_with_friction(*c._replace(mu=0.0))
    had, error = energy(c, *start), ROUNDING * LARGEST**2
    assert energy(c, plastic.velocities, plastic.angular_velocities) <= had + error
    lost = (1 - c.e**2) * min(before(c)[0], 0.0) ** 2 / matrix(c)[0, 0] / 2
    has = energy(c, smooth.velocities, smooth.angular_velocities)
    assert has == pytest.approx(had - lost, abs=error)


def transformed(x: Struck, how: Any, spin: float, drift: Any) -> Struck:
    """Return a body turned or mirrored by the matrix `how`, seen from what moves at -drift."""
    return Struck(
        x.inverse_mass,
        x.inverse_inertia,
        how @ x.velocity + drift,
        spin * x.angular_velocity,
        how @ x.arm,
    )


@given(cases, angles, vectors)
def test_impact_seen_from_elsewhere_is_the_same_impact(c: Case, turn: float, drift: Any) -> None:
    """A and B swapped; turned, or in a mirror, and seen from a train: velocities follow."""
    assume(abs(before(c)[0]) > 1e-6)
    impact, error = impact_with_friction(*c), ROUNDING * LARGEST
    cos, sin = math.cos(turn), math.sin(turn)
    rotation, mirror = np.array([[cos, -sin], [sin, cos]]), np.diag([-1.0, 1.0])
    for how, spin in ((rotation, 1), (mirror, -1)):
        a, b = (transformed(x, how, spin, drift) for x in (c.a, c.b))
        normal = how @ c.normal / np.hypot(*(how @ c.normal))
        other = impact_with_friction(a, b, normal, c.e, c.mu)
        expected = impact.velocities @ how.T + drift
        np.testing.assert_allclose(other.velocities, expected, rtol=0, atol=error)
        turning = spin * impact.angular_velocities
        np.testing.assert_allclose(other.angular_velocities, turning, rtol=0, atol=error)
    swapped = impact_with_friction(c.b, c.a, -c.normal, c.e, c.mu)
    np.testing.assert_allclose(swapped.velocities[::-1], impact.velocities, rtol=0, atol=error)


@given(cases)
def test_impact_is_what_sweeps_converge_to_where_they_do(c: Case) -> None:
    """A thousand sweeps end at it if mu abs(knt)/knn < 0.9 and knt^2 < 0.9 knn ktt."""
    k = matrix(c)
    assume(before(c)[0] < 0)
    assume(c.mu * abs(k[0, 1]) < 0.9 * k[0, 0])
    assume(k[0, 1] ** 2 < 0.9 * k[0, 0] * k[1, 1])
    impact = impact_with_friction(*c)
    ours = impact.normal_impulse, impact.tangent_impulse
    np.testing.assert_allclose(sweeps(c, 1000)[-1], ours, rtol=0, atol=CONVERGED * LARGEST)


@pytest.mark.parametrize(("mu", "converges"), [(1.66, True), (1.68, False), (2.0, False)])
def test_sliding_impact_is_out_of_reach_of_sweeps_if_mu_knt_exceeds_knn(
    mu: float, converges: bool
) -> None:
    """A rod at 45 degrees has knn = 5/2 and knt = -3/2, so that the limit is mu = 5/3.

    It is drawn along fast, its end behind. Friction then adds to knn, and nothing is wrong with
    the impact: jn = (1 + e)/(knn + mu abs(knt)). But what each visit leaves to the next is
    mu knt/knn of it, and beyond the limit that never dies down.
    """
    c = rod(slope=1.0, velocity=(-20.0, -1.0), e=0.0, mu=mu)
    np.testing.assert_allclose(matrix(c), [[2.5, -1.5], [-1.5, 2.5]], rtol=EXACT)
    impact = impact_with_friction(*c)
    jn = 1 / (2.5 + 1.5 * mu)
    assert impact.kind == "slides"
    assert impact.normal_impulse == pytest.approx(jn, rel=EXACT)
    errors = [abs(found - jn) for found, _ in sweeps(c, 10_000)[-2:]]
    assert (max(errors) < CONVERGED) == converges
    assert converges or max(errors) > 0.3 * jn


def test_painleve_rod_pushed_against_its_end_is_brought_to_a_stop() -> None:
    """At slope 2 sliding towards the end has no answer beyond mu = 4/3, so that it sticks.

    knn = 1 + 3/5 and knt = -6/5: a push with full friction, knn - mu abs(knt), would not stop
    the approach. However fast it slides, it is stopped at once; below 4/3 it slides on.
    """
    jammed = impact_with_friction(*rod(slope=2.0, velocity=(50.0, -1.0), e=0.0, mu=1.34))
    sliding = impact_with_friction(*rod(slope=2.0, velocity=(50.0, -1.0), e=0.0, mu=0.5))
    assert (jammed.kind, sliding.kind) == ("sticks", "slides")
    assert sliding.normal_impulse == pytest.approx(1 / (1.6 - 0.5 * 1.2), rel=EXACT)
    after = jammed.velocities[1] @ jammed.velocities[1] + jammed.angular_velocities[1] ** 2 / 3
    assert after < 50.0**2 + 1


def test_impact_by_newtons_rule_can_gain_energy_with_friction() -> None:
    """A rod at 45 degrees at (-1/2, -1) m/s, e = 1, mu = 1/2, leaves with 1.175 of its energy.

    It sticks: jn = 17/16 and jt = 7/16 N s make 47/64 J of 5/8 J. Newton's rule asks for all of
    the approach back, and friction, which turns the rod, has helped to pay.
    """
    c = rod(slope=1.0, velocity=(-0.5, -1.0), e=1.0, mu=0.5)
    impact = impact_with_friction(*c)
    v, w = impact.velocities[1], impact.angular_velocities[1]
    impulses = impact.normal_impulse, impact.tangent_impulse
    assert impact.kind == "sticks"
    assert impulses == pytest.approx((17 / 16, 7 / 16), rel=EXACT)
    assert v @ v / 2 + w * w / 6 == pytest.approx(47 / 64, rel=EXACT)


def test_impact_of_random_bodies_gains_energy_now_and_then() -> None:
    """Of 4,000 pairs with e = 1 and mu up to 1 that meet, 263 leave with up to 1.203 times as much.

    Kinetic energy is therefore no check of a solver that uses Newton's rule with friction.
    """
    rng = np.random.default_rng(15)

    def body() -> Struck:
        inv_m, inv_i, w = rng.uniform((0.2, 0.2, -10), (5, 5, 10)).tolist()
        return Struck(inv_m, inv_i, rng.uniform(-10, 10, 2), w, rng.uniform(-1, 1, 2))

    ratios: list[float] = []
    while len(ratios) < 4000:
        turn = rng.uniform(-np.pi, np.pi)
        normal = np.array([np.cos(turn), np.sin(turn)])
        c = Case(body(), body(), normal, 1.0, rng.uniform(0, 1))
        if before(c)[0] < 0:
            ratios.append(energy_ratio(c))
    gained = sum(ratio > 1 + EXACT * LARGEST for ratio in ratios)
    assert (gained, round(max(ratios), 3)) == (263, 1.203)


def test_impact_that_does_not_approach_changes_nothing() -> None:
    """Parting, and at rest to each other: velocities stay to the last bit, as new arrays."""
    a = Struck(1.0, 1.0, np.array([0.1, 0.7]), 0.3, np.array([0.0, 0.0]))
    for vx in (0.1, 3.0):
        b = Struck(2.0, 1.0, np.array([vx, -0.2]), -0.3, np.array([0.0, 0.0]))
        for form in (impact_with_friction, disc_impact):
            impact = form(a, b, np.array([1.0, 0.0]), 1.0, 1.0)
            assert (impact.kind, impact.normal_impulse, impact.tangent_impulse) == ("parts", 0, 0)
            np.testing.assert_array_equal(impact.velocities, (a.velocity, b.velocity))
            np.testing.assert_array_equal(impact.angular_velocities, (0.3, -0.3))
            assert not np.shares_memory(impact.velocities, a.velocity)


@given(cases, st.floats(0.1, 2), st.floats(0.1, 2))
def test_disc_impact_is_the_impact_with_arms_along_the_normal(
    c: Case, radius_a: float, radius_b: float
) -> None:
    """Normal and tangent one by one, or both equations together: for two discs it is the same."""
    c = c._replace(
        a=c.a._replace(arm=radius_a * c.normal), b=c.b._replace(arm=-radius_b * c.normal)
    )
    together, one_by_one = impact_with_friction(*c), disc_impact(*c)
    for found, expected in zip(one_by_one[1:], together[1:], strict=True):
        np.testing.assert_allclose(found, expected, rtol=0, atol=ROUNDING * LARGEST)


def test_disc_impact_on_the_floor_turns_sliding_into_spin() -> None:
    """A disc meets the floor at (3, -4) with e = 1: 1 N s makes v_x' = 2 = -w' r, as if it rolled.

    With mu = 1/10 friction has only 0.8 N s, which make v_x' = 2.2 and w' = -1.6.
    """
    disc = Struck(1.0, 2.0, np.array([3.0, -4.0]), 0.0, np.array([0.0, -1.0]))  # I = m r^2/2
    grip = disc_impact(floor(), disc, (0, 1), 1.0, 1.0)
    slip = disc_impact(floor(), disc, (0, 1), 1.0, 0.1)
    assert (grip.kind, slip.kind) == ("sticks", "slides")
    np.testing.assert_allclose(grip.velocities[1], (2, 4), rtol=EXACT)
    np.testing.assert_allclose(slip.velocities[1], (2.2, 4), rtol=EXACT)
    turning = grip.angular_velocities[1], slip.angular_velocities[1]
    np.testing.assert_allclose(turning, (-2, -1.6), rtol=EXACT)


FREE = Struck(1.0, 1.0, (1, 0), 0.0, (0.5, 0))
BAD_BODIES = {
    "inverse_mass": (-1.0, r"a.inverse_mass must be >= 0 and finite, got -1.0"),
    "inverse_inertia": (math.inf, r"a.inverse_inertia must be >= 0 and finite, got inf"),
    "velocity": ((1, 2, 3), r"a.velocity must have shape"),
    "angular_velocity": (math.nan, r"a.angular_velocity must be finite, got nan"),
    "arm": ((math.nan, 0), r"a.arm must be finite, got nan at index"),
}


@pytest.mark.parametrize("form", [impact_with_friction, disc_impact])
@pytest.mark.parametrize(("field", "bad"), BAD_BODIES.items(), ids=BAD_BODIES)
def test_impact_of_a_bad_body_is_refused_by_name(
    form: Any, field: str, bad: tuple[Any, str]
) -> None:
    """The error says body, field, rule and value."""
    with pytest.raises(ValueError, match=bad[1]):
        form(FREE._replace(**{field: bad[0]}), FREE, (1, 0), 0.5, 0.5)


@pytest.mark.parametrize("form", [impact_with_friction, disc_impact])
@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"normal": (1, 1)}, "normal must be a unit vector .*got length 1.41"),
        ({"normal": [(1, 0), (0, 1)]}, "normal must have shape"),
        ({"restitution": 1.5}, "restitution must be between 0 and 1, got 1.5"),
        ({"friction": -0.5}, "friction must be >= 0 and finite, got -0.5"),
        ({"a": floor(), "b": floor()}, "a and b must not both have the inverse mass 0"),
    ],
    ids=["not unit", "two normals", "restitution", "friction", "two floors"],
)
def test_impact_of_bad_numbers_is_refused_by_name(
    form: Any, changed: dict[str, Any], message: str
) -> None:
    """The error says argument, rule and value."""
    good = {"a": FREE, "b": FREE, "normal": (1, 0), "restitution": 0.5, "friction": 0.5}
    with pytest.raises(ValueError, match=message):
        form(**good | changed)


def test_disc_impact_beside_the_centre_is_refused() -> None:
    """With an arm across the normal, normal and tangent are coupled; where nothing turns, not."""
    beside = FREE._replace(arm=(0.5, 0.1))
    with pytest.raises(ValueError, match=r"b\.arm must lie along the normal, got"):
        disc_impact(FREE, beside, (1, 0), 0.5, 0.5)
    assert disc_impact(FREE, beside._replace(inverse_inertia=0.0), (1, 0), 0.5, 0.5).kind == "parts"
