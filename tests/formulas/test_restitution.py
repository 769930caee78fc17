from fractions import Fraction
from math import inf

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.formulas import energy_lost_1d, reduced_mass, restitution_1d

ROUNDING = 16 * np.finfo(float).eps
"""A formula rounds about ten times, each by half an eps of the numbers that went in."""

masses = st.floats(1e-6, 1e6)
exact = st.fractions(-20, 20, max_denominator=12)
exact_masses = st.fractions(Fraction(1, 12), 20, max_denominator=12)
exact_restitutions = st.fractions(0, 1, max_denominator=12)


def after_collision(m1, v1, m2, v2, e):
    """Return both velocities after, from the textbook's form with one common denominator."""
    return (
        ((m1 - e * m2) * v1 + (1 + e) * m2 * v2) / (m1 + m2),
        ((m2 - e * m1) * v2 + (1 + e) * m1 * v1) / (m1 + m2),
    )


# (v2' - v1') / (v1 - v2)
RATIOS = {
    "elastic, swapped velocities": ((3, -1, -1, 3), 1),  # 4 / 4
    "half of it": ((3, -1, -1, 1), 0.5),  # 2 / 4
    "sticking": ((3, -1, 1, 1), 0),  # 0 / 4
    "ball dropped on the floor": ((-4, 0, 3, 0), 0.75),  # -3 / -4
    "explosion, not clipped": ((1, 0, -1, 2), 3),  # 3 / 1
    "one passed through the other, not clipped": ((1, 0, 1, 0), -1),  # -1 / 1
}


@pytest.mark.parametrize(("velocities", "e"), RATIOS.values(), ids=RATIOS)
def test_restitution_worked_by_hand_is_found(velocities, e) -> None:
    """The ratio of separation to approach is found, and nothing is clipped."""
    assert restitution_1d(*velocities) == e


@given(exact_masses, exact, exact_masses, exact, exact_restitutions)
def test_restitution_of_a_collision_is_the_one_that_made_it(m1, v1, m2, v2, e) -> None:
    """From the textbook's velocities after, e comes back exactly, in Fractions."""
    assume(v1 != v2)
    measured = restitution_1d(v1, v2, *after_collision(m1, v1, m2, v2, e))
    assert measured == e
    assert type(measured) is Fraction


@given(exact, exact, exact, exact, exact)
def test_restitution_is_the_same_for_every_observer(v1, v2, u1, u2, shift) -> None:
    """A moving observer, a mirror and the other order of the bodies all see the same e."""
    assume(v1 != v2)
    e = (u2 - u1) / (v1 - v2)
    assert restitution_1d(v1 + shift, v2 + shift, u1 + shift, u2 + shift) == e
    assert restitution_1d(-v1, -v2, -u1, -u2) == e
    assert restitution_1d(v2, v1, u2, u1) == e


def test_restitution_of_arrays_is_one_for_each_place() -> None:
    """v1 of shape (3, 1) with v1' of shape (2,) gives six restitutions."""
    e = restitution_1d(np.array([[1.0], [2.0], [4.0]]), 0.0, np.array([0.0, -1.0]), 0.0)
    np.testing.assert_array_equal(e, [[0, 1], [0, 0.5], [0, 0.25]])


@pytest.mark.parametrize(
    ("v1", "v2", "shown"),
    [
        (2, 2, "2"),
        (2.0, 2, "2.0"),
        (Fraction(1, 2), 0.5, "1/2"),
        (-0.0, 0.0, "-0.0"),
        ([1, 2, 3], [3, 2, 1], "2.0"),
        ([[1], [2]], 2, "2.0"),
    ],
    ids=str,
)
def test_restitution_of_equal_velocities_is_refused(v1, v2, shown) -> None:
    """Bodies at rest to each other do not collide; 0 / 0 is an error that names both."""
    with pytest.raises(ValueError, match=rf"v1 and v2 must differ: .*, got {shown} twice$"):
        restitution_1d(v1, v2, 0, 0)


def test_restitution_of_the_closest_velocities_is_defined() -> None:
    """Neighbouring floats differ, so they have a restitution: only equality is refused."""
    v1, v2 = np.nextafter(1.0, 2.0), 1.0
    assert restitution_1d(v1, v2, v2, v1) == 1


# m1 m2 / (m1 + m2)
REDUCED = {
    "1 and 3": (1, 3, 0.75),
    "equal": (2, 2, 1),
    "3 and 6": (3, 6, 2),
    "a wall": (2, inf, 2),
    "a wall first": (inf, 2, 2),
    "product overflows": (1e300, 1e300, 5e299),
    "sum overflows": (1.6e308, 1.6e308, 0.8e308),
    "product underflows": (1e-300, 1e-300, 5e-301),
    "ratio overflows": (1e300, 1e-300, 1e-300),
}


@pytest.mark.parametrize(("m1", "m2", "expected"), REDUCED.values(), ids=REDUCED)
def test_reduced_mass_worked_by_hand_is_found(m1, m2, expected) -> None:
    """m1 m2 / (m1 + m2), where that form would overflow, underflow or be inf / inf too."""
    assert reduced_mass(m1, m2) == pytest.approx(expected, rel=ROUNDING)
    np.testing.assert_allclose(reduced_mass([m1, m1], m2), [expected] * 2, rtol=ROUNDING)


@given(exact_masses, exact_masses)
def test_reduced_mass_of_fractions_is_exact(m1, m2) -> None:
    """1/m_r = 1/m1 + 1/m2, exactly, in Fractions."""
    measured = reduced_mass(m1, m2)
    assert 1 / measured == 1 / m1 + 1 / m2
    assert type(measured) is Fraction


@given(masses, masses)
def test_reduced_mass_lies_between_half_the_lighter_mass_and_all_of_it(m1, m2) -> None:
    """The other's yielding at most halves the lighter mass; the order does not matter."""
    light = min(m1, m2)
    assert light / 2 <= reduced_mass(m1, m2) <= light
    assert reduced_mass(m1, m2) == reduced_mass(m2, m1)


# 1/2 m_r (1 - e^2) (v1 - v2)^2
LOSSES = {
    "partly elastic": ((1, 2, 3, -2, 0.5), 4.5),  # .5 x .75 x .75 x 16
    "sticking, equal masses lose half": ((2, 3, 2, 0, 0), 4.5),  # .5 x 1 x 1 x 9, of 9
    "elastic": ((1, 2, 3, -2, 1), 0),
    "no approach": ((1, 2, 3, 2, 0), 0),
    "against a wall": ((2, 3, inf, 0, 0), 9),  # all of .5 x 2 x 9
    "against a wall that comes": ((2, 1, inf, -2, 0.5), 6.75),  # .5 x 2 x .75 x 9
}


@pytest.mark.parametrize(("arguments", "loss"), LOSSES.values(), ids=LOSSES)
def test_energy_lost_worked_by_hand_is_found(arguments, loss) -> None:
    """The loss is that of the relative motion (Goldstein, sec. 3.11)."""
    assert energy_lost_1d(*arguments) == loss


@given(exact_masses, exact, exact_masses, exact, exact_restitutions)
def test_energy_lost_is_kinetic_energy_before_less_after(m1, v1, m2, v2, e) -> None:
    """The formula is what the textbook's velocities lose, exactly, in Fractions."""
    u1, u2 = after_collision(m1, v1, m2, v2, e)
    before, after = m1 * v1**2 + m2 * v2**2, m1 * u1**2 + m2 * u2**2
    assert energy_lost_1d(m1, v1, m2, v2, e) == (before - after) / 2


@given(masses, st.floats(-1e3, 1e3), masses, st.floats(-1e3, 1e3), st.floats(0, 1))
def test_energy_lost_is_never_negative_and_zero_when_elastic(m1, v1, m2, v2, e) -> None:
    """No restitution up to 1 makes energy, and e = 1 loses exactly none."""
    assert energy_lost_1d(m1, v1, m2, v2, e) >= 0
    assert energy_lost_1d(m1, v1, m2, v2, 1) == 0


@given(masses, st.floats(-1e3, 1e3), masses, st.floats(-1e3, 1e3), st.floats(0, 1))
def test_energy_lost_is_the_same_with_bodies_swapped_or_mirrored(m1, v1, m2, v2, e) -> None:
    """Heat has no direction: swap and mirror change no bit of it."""
    loss = energy_lost_1d(m1, v1, m2, v2, e)
    assert energy_lost_1d(m2, v2, m1, v1, e) == loss
    assert energy_lost_1d(m1, -v1, m2, -v2, e) == loss


def test_energy_lost_of_arrays_is_one_for_each_place() -> None:
    """Restitution (3,) with masses (2, 1): 1/2 m_r (1 - e^2) 16 for m_r = 0.75 and 0.5."""
    loss = energy_lost_1d(1.0, 2.0, np.array([[3.0], [1.0]]), -2.0, np.array([0.0, 0.5, 1.0]))
    np.testing.assert_allclose(loss, [[6, 4.5, 0], [4, 3, 0]], rtol=ROUNDING)
