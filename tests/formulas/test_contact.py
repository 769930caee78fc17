import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.formulas import (
    effective_mass,
    friction_impulse,
    normal_impulse,
    reduced_mass,
)

ROUNDING = 16 * np.finfo(float).eps
"""A formula rounds about ten times, each by half an eps of the numbers that went in."""

UNDERFLOW = 1e-290
"""Products below this lose digits because a float cannot be smaller, whatever the formula."""

velocities = st.floats(-1e3, 1e3)
masses = st.floats(1e-6, 1e6)
restitutions = st.floats(0, 1)
frictions = st.floats(0, 10)
impulses = st.floats(0, 1e6)
exact = st.fractions(-20, 20, max_denominator=12)
exact_positive = st.fractions(Fraction(1, 12), 20, max_denominator=12)


def near(scale):
    """Return the difference that rounding explains for numbers of this size."""
    return ROUNDING * scale + UNDERFLOW


# 1 / (inv_m_a + inv_m_b + ra_x_n^2 inv_i_a + rb_x_n^2 inv_i_b)
EFFECTIVE = {
    "two free masses": ((1, 3), 0.25),
    "one immovable": ((0.5, 0), 2),
    "a lever arm on one": ((1, 1, 0.5, 0, 2, 9), 0.25),  # 1 + 1 + 4 x .5
    "lever arms on both": ((1, 1, 0.5, 0.25, 2, 4), 0.125),  # 1 + 1 + 2 + 16 x .25
    "either side of the line": ((1, 1, 0.5, 0.25, -2, 4), 0.125),
    "hit at the centre": ((1, 1, 5, 7, 0, 0), 0.5),
    "a door, which can only turn": ((0, 0, 0.5, 0, 2, 0), 0.5),  # 4 x .5
    "end of a free rod": ((0, 1, 0, 3, 0, 1), 0.25),  # 1 kg of 2 m, I = 1/3: 1 + 3
}


@pytest.mark.parametrize(("arguments", "m_eff"), EFFECTIVE.values(), ids=EFFECTIVE)
def test_effective_mass_worked_by_hand_is_found(arguments, m_eff) -> None:
    """The inverse of what 1 N s changes, part by part (Mirtich and Canny, sec. 3)."""
    assert effective_mass(*arguments) == m_eff


arms = st.floats(-10, 10)
inverses = st.floats(1e-3, 1e3)


@given(inverses, inverses, inverses, inverses, arms, arms)
def test_effective_mass_is_impulse_over_the_change_of_velocity_it_makes(
    inv_m_a, inv_m_b, inv_i_a, inv_i_b, ra, rb
) -> None:
    """1 N s up at a place ra to the right of A's centre, and down at B's, body by body.

    B rises by inv_m_b and turns by rb inv_i_b; its point at rb rises by rb times that as well.
    """
    b_rises = inv_m_b + rb * (rb * inv_i_b)
    a_rises = -inv_m_a + ra * (-ra * inv_i_a)
    m_eff = effective_mass(inv_m_a, inv_m_b, inv_i_a, inv_i_b, ra, rb)
    assert m_eff * (b_rises - a_rises) == pytest.approx(1, rel=ROUNDING)


@given(inverses, inverses, inverses, inverses, arms, arms)
def test_effective_mass_with_bodies_swapped_or_mirrored_is_the_same(a, b, i_a, i_b, ra, rb) -> None:
    """A and B are names; a mirror turns both lever arms round: the same bits."""
    m_eff = effective_mass(a, b, i_a, i_b, ra, rb)
    assert (
        m_eff == effective_mass(b, a, i_b, i_a, rb, ra) == effective_mass(a, b, i_a, i_b, -ra, -rb)
    )


@given(masses, masses)
def test_effective_mass_without_lever_arms_is_the_reduced_mass(m1, m2) -> None:
    """Two bodies that do not turn show m1 m2 / (m1 + m2)."""
    expected = pytest.approx(reduced_mass(m1, m2), rel=ROUNDING)
    assert effective_mass(1 / m1, 1 / m2) == expected
    assert effective_mass(1 / m1, 1 / m2, 5.0, 7.0) == expected


@given(inverses, inverses, inverses, arms)
def test_effective_mass_is_never_raised_by_a_lever_arm(inv_m_a, inv_m_b, inv_i_a, ra) -> None:
    """A body that can turn away yields more, never less."""
    assert effective_mass(inv_m_a, inv_m_b, inv_i_a, 0, ra) <= effective_mass(inv_m_a, inv_m_b)


@given(exact_positive, exact_positive, exact_positive, exact)
def test_effective_mass_of_fractions_is_exact(inv_m_a, inv_m_b, inv_i_a, ra) -> None:
    """No digit is lost in Fractions, those left out included."""
    m_eff = effective_mass(inv_m_a, inv_m_b, inv_i_a, ra_x_n=ra)
    assert m_eff * (inv_m_a + inv_m_b + ra * ra * inv_i_a) == 1
    assert type(m_eff) is Fraction


@pytest.mark.parametrize(
    "neither_yields",
    [(0, 0), (0.0, 0.0, 0.0, 0.0, 1.0, 1.0), (0, 0, 2, 3, 0, 0), ([1, 0], [1, 0])],
    ids=["no turning", "no inverse inertia", "no lever arm", "one place of two"],
)
def test_effective_mass_of_two_bodies_that_cannot_yield_is_refused(neither_yields) -> None:
    """There is no impulse for a wall in a wall."""
    with pytest.raises(ValueError, match=r"inv_m_a and inv_m_b must not both be 0 .*got 0"):
        effective_mass(*neither_yields)


def test_effective_mass_of_arrays_has_one_contact_per_place() -> None:
    """A table of lever arms (3, 1) and of inverse masses (2,)."""
    m_eff = effective_mass(1.0, np.array([0.0, 1.0]), 0.5, ra_x_n=np.array([[0.0], [2.0], [-2.0]]))
    np.testing.assert_array_equal(m_eff, [[1, 1 / 2], [1 / 3, 1 / 4], [1 / 3, 1 / 4]])


def test_effective_mass_of_one_number_and_of_an_array_is_the_same_bit_for_bit() -> None:
    """A square is written r r: r**2 goes through pow in Python, which rounds some otherwise."""
    r = np.random.default_rng(1).normal(size=20_000)
    one_by_one = [effective_mass(0.3, 0.7, 1.1, ra_x_n=float(x)) for x in r]
    np.testing.assert_array_equal(effective_mass(0.3, 0.7, 1.1, ra_x_n=r), one_by_one)


# jn = accumulated - (1 + e) vn m_eff, or 0
NORMAL = {
    "partly elastic": ((-4, 0.5, 0.5), 3),  # 1.5 x 4 x .5
    "plastic only stops": ((-4, 0.5, 0), 2),  # 1 x 4 x .5
    "elastic is twice that": ((-4, 0.5, 1), 4),  # 2 x 4 x .5
    "separating": ((4, 0.5, 1), 0),
    "resting": ((0, 0.5, 1), 0),
    "some received, more needed": ((-4, 0.5, 0, 3), 5),  # 3 + 4 x .5
    "too much received": ((4, 0.5, 0, 3), 1),  # 3 - 4 x .5
    "takes back no more than was received": ((4, 0.5, 0, 1), 0),  # 1 - 4 x .5 < 0
    "nothing left to do": ((0, 0.5, 0, 3), 3),
}


@pytest.mark.parametrize(("arguments", "jn"), NORMAL.values(), ids=NORMAL)
def test_normal_impulse_worked_by_hand_is_found(arguments, jn) -> None:
    """-(1 + e) vn m_eff when the bodies approach, else nothing (Mirtich and Canny, sec. 3)."""
    assert normal_impulse(*arguments) == jn


@given(st.floats(-1e3, 0), masses, restitutions)
def test_normal_velocity_after_the_impulse_is_reversed_times_restitution(vn, m, e) -> None:
    """The impulse gives Newton's law of restitution: vn + jn / m_eff = -e vn."""
    after = vn + normal_impulse(vn, m, e) / m
    assert after == pytest.approx(-e * vn, rel=0, abs=near(abs(vn)))


@given(velocities, masses, restitutions)
def test_normal_impulse_only_pushes(vn, m, e) -> None:
    """A contact cannot pull: jn >= 0, and 0 exactly when the bodies do not approach."""
    jn = normal_impulse(vn, m, e)
    assert jn >= 0
    assert (jn == 0) == (vn >= 0 or vn * m == 0)


@given(velocities, masses, restitutions)
def test_normal_energy_after_the_impulse_is_the_part_e_squared(vn, m, e) -> None:
    """An approach leaves e^2 of its energy, a separation all of it."""
    after = vn + normal_impulse(vn, m, e) / m
    kept = e * e if vn < 0 else 1
    assert after**2 == pytest.approx(kept * vn**2, rel=0, abs=near(vn**2))


@given(exact, exact_positive, st.fractions(0, 1, max_denominator=12))
def test_normal_impulse_of_fractions_is_exact(vn, m, e) -> None:
    """No digit is lost in Fractions, on either side of the gate."""
    assert normal_impulse(vn, m, e) == max(0, -(1 + e) * vn * m)


@given(exact, exact_positive, exact_positive)
def test_normal_impulse_in_two_parts_is_the_impulse_in_one(vn, m, first) -> None:
    """What a contact gets in all does not depend on what it was given before, be it too much.

    This is what clamping the total, not the change, is for (Catto 2006).
    """
    vn_then = vn + first / m
    assert normal_impulse(vn_then, m, 0, accumulated=first) == normal_impulse(vn, m, 0)


@given(exact, exact_positive, st.fractions(0, 1, max_denominator=12))
def test_normal_impulse_visited_again_without_a_disturbance_stays(vn, m, e) -> None:
    """What vn means then is what is still wrong: vn now less the -e vn it should be."""
    jn = normal_impulse(vn, m, e)
    now, wanted = vn + jn / m, max(-e * vn, vn)
    assert normal_impulse(now - wanted, m, 0, accumulated=jn) == jn


def test_normal_impulse_visited_again_with_restitution_takes_the_bounce_back() -> None:
    """Restitution is of the approach before: asked for again, it treats the bounce as a fault.

    1 kg at -2 m/s with e = 1/2 bounces off at 1 m/s by 3 N s; a second call would make it 1.5.
    """
    jn = normal_impulse(vn=-2.0, m_eff=1.0, restitution=0.5)
    assert jn == 3
    assert normal_impulse(vn=1.0, m_eff=1.0, restitution=0.5, accumulated=jn) == 1.5


@pytest.mark.parametrize("zero", [0.0, -0.0])
def test_impulses_of_a_contact_at_rest_are_plus_zero(zero) -> None:
    """No impulse is 0.0, not -0.0, which would print as -0."""
    assert math.copysign(1, normal_impulse(zero, 0.5, 1.0)) == 1
    assert math.copysign(1, friction_impulse(zero, 0.5, 1.0, 2.0)) == 1


@pytest.mark.parametrize(
    ("e", "right", "doubled"),
    [(0, 0, 1), (0.5, 0.25, 4), (0.8, 0.64, 6.76), (1, 1, 9)],
    ids=lambda x: f"{x:g}",
)
def test_energy_of_a_head_on_pair_is_e_squared_of_it(e, right, doubled) -> None:
    """Two equal masses head-on keep e^2 of their energy; twice the impulse makes it (1 + 2e)^2.

    Fault 1 of the source lesson: it used 2 (1 + e), and energy grew 1, 4, 6.76, 9 times. In the
    demo that was a thousandfold in a minute. Momentum stays 0 either way and notices nothing.
    """
    jn = normal_impulse(vn=-2.0, m_eff=0.5, restitution=e)  # 1 kg at +1 m/s, 1 kg at -1 m/s
    ours = ((1 - jn) ** 2 + (-1 + jn) ** 2) / 2
    theirs = ((1 - 2 * jn) ** 2 + (-1 + 2 * jn) ** 2) / 2
    assert ours == pytest.approx(right, rel=0, abs=near(1))
    assert theirs == pytest.approx(doubled, rel=ROUNDING)


# jt = accumulated - vt m_eff_t, at most mu jn
FRICTION = {
    "sticks": ((2, 1, 1, 3), -2),  # limit 3
    "slides": ((2, 1, 0.5, 3), -1.5),  # limit 1.5
    "slides the other way": ((-2, 1, 0.5, 3), 1.5),
    "at the limit exactly": ((2, 1.5, 1, 3), -3),  # limit 3
    "no sliding": ((0, 1, 1, 3), 0),
    "no friction": ((2, 1, 0, 3), 0),
    "no pressing": ((2, 1, 1, 0), 0),
    "mu above 1 is legal": ((8, 1, 2, 3), -6),  # limit 6
    "some received, sticks": ((1, 1, 1, 3, -1), -2),  # -1 - 1, limit 3
    "some received, slides": ((2, 1, 0.5, 3, -1), -1.5),  # -1 - 2, limit 1.5
    "some received, the other way": ((-2, 1, 1, 3, -1), 1),  # -1 + 2, limit 3
    "pressing has become less": ((0, 1, 0.5, 1, -3), -0.5),  # -3, limit .5
}


@pytest.mark.parametrize(("arguments", "jt"), FRICTION.values(), ids=FRICTION)
def test_friction_impulse_worked_by_hand_is_found(arguments, jt) -> None:
    """The impulse that stops the sliding, clamped to mu jn (Catto 2005, sec. 4)."""
    assert friction_impulse(*arguments) == jt


@given(velocities, masses, frictions, impulses)
def test_friction_impulse_stays_in_coulombs_cone(vt, m, mu, jn) -> None:
    """abs(jt) <= mu jn, to the last bit."""
    assert abs(friction_impulse(vt, m, mu, jn)) <= mu * jn


@given(velocities, masses, frictions, impulses)
def test_friction_impulse_opposes_sliding_and_never_reverses_it(vt, m, mu, jn) -> None:
    """After it the sliding is slower or over, but never the other way (or faster)."""
    jt = friction_impulse(vt, m, mu, jn)
    assert jt * vt <= 0
    after = vt + jt / m
    assert abs(after) <= abs(vt)
    assert after * np.sign(vt) >= -near(abs(vt))


@given(velocities, masses, frictions, impulses)
def test_friction_impulse_sticks_inside_the_cone_and_slides_at_its_edge(vt, m, mu, jn) -> None:
    """Either the sliding stops or all that friction can give is given."""
    jt = friction_impulse(vt, m, mu, jn)
    stopped = abs(vt + jt / m) <= near(abs(vt))
    assert stopped or abs(jt) == mu * jn


@given(velocities, masses, frictions, impulses)
def test_friction_impulse_in_a_mirror_is_mirrored(vt, m, mu, jn) -> None:
    """Sliding the other way gives the opposite impulse, to the last bit."""
    assert friction_impulse(-vt, m, mu, jn) == -friction_impulse(vt, m, mu, jn)


@given(exact, exact_positive, exact_positive, exact_positive)
def test_friction_impulse_of_fractions_is_exact(vt, m, mu, jn) -> None:
    """No digit is lost in Fractions, sticking or sliding."""
    jt = friction_impulse(vt, m, mu, jn)
    assert jt == max(-mu * jn, min(-vt * m, mu * jn))
    assert type(jt) is Fraction


@given(exact, exact_positive, exact_positive, exact_positive, exact)
def test_friction_impulse_in_two_parts_is_the_impulse_in_one(vt, m, mu, jn, first) -> None:
    """What friction gives in all does not depend on what it gave before, be it too much."""
    vt_then = vt + first / m
    in_two = friction_impulse(vt_then, m, mu, jn, accumulated=first)
    assert in_two == friction_impulse(vt, m, mu, jn)


def test_friction_impulse_of_a_hard_hit_does_not_throw_the_disc_back() -> None:
    """Slow sliding under a hard hit stops; it is not thrown to -49 (fault 3 of the source).

    Two 1 kg discs meet at 100 m/s and slide at 1 m/s: jn = 50 for e = 0, and with spin (six
    parts of 1/m, of r^2/I = 2/m each) m_eff_t = 1/6. The first keeps 5/6; without the clamp's
    other half, jt = mu jn, it would have 1 - 50.
    """
    jn = normal_impulse(vn=-100.0, m_eff=0.5, restitution=0)
    jt = friction_impulse(vt=1.0, m_eff_t=1 / 6, friction=1.0, normal_impulse=jn)
    assert jn == 50
    assert 1 + jt == pytest.approx(5 / 6, rel=ROUNDING)


def test_friction_impulse_swept_through_zero_sliding_is_continuous() -> None:
    """There is no dead band: nearly no sliding needs nearly no friction (fault 4 of the source).

    The source left vt = .0099 alone and threw .0101 to -24.99. Ours changes by no more than
    m_eff_t times the change of vt, which is what continuous means here.
    """
    vt = np.linspace(-0.02, 0.02, 4001)
    jt = friction_impulse(vt, m_eff_t=0.5, friction=0.5, normal_impulse=50.0)
    assert np.abs(np.diff(jt)).max() <= 0.5 * np.diff(vt).max() + near(1)
    np.testing.assert_allclose(vt + jt / 0.5, 0, rtol=0, atol=near(1))


@given(velocities, velocities, masses, frictions, impulses)
def test_friction_impulse_changes_no_faster_than_sliding(vt, other, m, mu, jn) -> None:
    """Friction is continuous in vt everywhere, the edges of the cone included."""
    change = friction_impulse(vt, m, mu, jn) - friction_impulse(other, m, mu, jn)
    assert abs(change) <= m * abs(vt - other) + near(m * (abs(vt) + abs(other)))


def test_impulses_of_extreme_masses_are_finite_and_right() -> None:
    """1e300 kg and 1e-300 kg are masses like any other, alone and in arrays."""
    for m in (1e300, 1e-300):
        assert normal_impulse(-2.0, m, 0.5) == 3 * m
        assert friction_impulse(2.0, m, 1.0, 1.0) == -min(1.0, 2 * m)
    np.testing.assert_array_equal(
        friction_impulse([2.0, 2.0], [1e300, 1e-300], 1.0, 1.0), [-1, -2e-300]
    )


def test_friction_impulse_with_a_limit_beyond_floats_sticks() -> None:
    """The limit mu jn may overflow to inf, which is a limit like any other: no warning, no nan."""
    assert friction_impulse(2.0, 1.0, 1e200, 1e200) == -2
    np.testing.assert_array_equal(friction_impulse([2.0, -2.0], 1.0, 1e200, 1e200), [-2, 2])


def test_impulses_of_arrays_broadcast_one_contact_per_place() -> None:
    """Six contacts each: vn (3, 1) with restitution (2,), and vt (3, 1) with jn (2,)."""
    jn = normal_impulse(np.array([[-2.0], [0.0], [2.0]]), 1.0, np.array([0.0, 0.5]))
    np.testing.assert_array_equal(jn, [[2, 3], [0, 0], [0, 0]])
    jt = friction_impulse(np.array([[-2.0], [0.0], [4.0]]), 1.0, 0.5, np.array([2.0, 6.0]))
    np.testing.assert_array_equal(jt, [[1, 2], [0, 0], [-1, -3]])
