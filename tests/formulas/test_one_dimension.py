from fractions import Fraction
from math import inf

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.formulas import collide_1d, elastic_1d, inelastic_1d, mass_fraction

ROUNDING = 16 * np.finfo(float).eps
"""A formula rounds about ten times, each by half an eps of the numbers that went in."""

UNDERFLOW = 1e-290
"""Products below this lose digits because a float cannot be smaller, whatever the formula."""

masses = st.floats(1e-6, 1e6)
velocities = st.floats(-1e3, 1e3)
restitutions = st.floats(0, 1)
pairs = st.tuples(masses, velocities, masses, velocities)
exact = st.fractions(-20, 20, max_denominator=12)
exact_masses = st.fractions(Fraction(1, 12), 20, max_denominator=12)
exact_pairs = st.tuples(exact_masses, exact, exact_masses, exact)
exact_restitutions = st.fractions(0, 1, max_denominator=12)


def textbook(m1, v1, m2, v2, e):
    """Return both velocities after from the form with one common denominator, exactly."""
    m1, v1, m2, v2, e = (Fraction(x) for x in (m1, v1, m2, v2, e))
    return (
        ((m1 - e * m2) * v1 + (1 + e) * m2 * v2) / (m1 + m2),
        ((m2 - e * m1) * v2 + (1 + e) * m1 * v1) / (m1 + m2),
    )


def near(scale):
    """Return the difference that rounding explains for numbers of this size."""
    return ROUNDING * float(scale) + UNDERFLOW


# Each row is worked with V = (m1 v1 + m2 v2) / (m1 + m2), then v' = V - e (v - V).
BY_HAND = {
    "equal masses swap": ((1, 3, 1, -1, 1), (-1, 3)),  # V = 1
    "equal masses, one at rest": ((2, 5, 2, 0, 1), (0, 5)),  # V = 2.5
    "heavy hits light": ((2, 3, 1, 0, 1), (1, 4)),  # V = 2
    "light hits heavy": ((1, 4, 3, 0, 1), (-2, 2)),  # V = 1
    "partly elastic": ((1, 2, 3, -2, 0.5), (-2.5, -0.5)),  # V = -1
    "partly elastic from behind": ((3, 4, 1, 0, 0.25), (2.75, 3.75)),  # V = 3
    "sticking": ((1, 3, 3, -1, 0), (0, 0)),  # V = 0
    "no approach": ((1, 2, 1, 2, 0.5), (2, 2)),  # V = 2
    "wall at rest, elastic": ((2, 3, inf, 0, 1), (-3, 0)),  # V = 0
    "wall at rest, e = 0.5": ((2, 3, inf, 0, 0.5), (-1.5, 0)),
    "wall that comes": ((2, 3, inf, -2, 1), (-7, -2)),  # V = -2
    "wall on the left": ((inf, 0, 5, -4, 0.25), (0, 1)),
}


@pytest.mark.parametrize(("arguments", "after"), BY_HAND.values(), ids=BY_HAND)
def test_velocities_worked_by_hand_are_found(arguments, after) -> None:
    """Velocities after are those worked through the centre of mass (Goldstein, sec. 3.11)."""
    assert collide_1d(*arguments) == after


@pytest.mark.parametrize(
    "arguments", [row for row, _ in BY_HAND.values() if row[4] == 1], ids=lambda row: str(row)
)
def test_elastic_velocities_worked_by_hand_are_found(arguments) -> None:
    """elastic_1d gives the rows of the table that have restitution 1."""
    after = next(after for row, after in BY_HAND.values() if row == arguments)
    assert elastic_1d(*arguments[:4]) == after


def test_inelastic_velocity_worked_by_hand_is_the_common_one() -> None:
    """1 kg at 3 m/s and 3 kg at 1 m/s stick together: 6 kg m/s over 4 kg is 1.5 m/s."""
    assert inelastic_1d(1, 3, 3, 1) == (1.5, 1.5)


@given(exact_pairs, exact_restitutions)
def test_velocities_of_fractions_equal_the_textbook_form_exactly(pair, e) -> None:
    """Our form through the centre of mass is the textbook's, digit for digit, in Fractions."""
    after = collide_1d(*pair, e)
    assert after == textbook(*pair, e)
    assert [type(v) for v in after] == [Fraction, Fraction]


@given(exact_pairs)
def test_velocities_of_fractions_at_the_two_limits_are_exact(pair) -> None:
    """elastic_1d is restitution 1 and inelastic_1d restitution 0, exactly, in Fractions."""
    assert elastic_1d(*pair) == textbook(*pair, 1)
    assert inelastic_1d(*pair) == textbook(*pair, 0)


@given(exact_pairs, exact_restitutions)
def test_momentum_of_fractions_is_kept_exactly(pair, e) -> None:
    """m1 v1 + m2 v2 is the same before and after (Newton's third law), with no rounding."""
    m1, v1, m2, v2 = pair
    u1, u2 = collide_1d(*pair, e)
    assert m1 * u1 + m2 * u2 == m1 * v1 + m2 * v2


@given(pairs, restitutions)
def test_velocities_of_floats_equal_the_textbook_form(pair, e) -> None:
    """Floats differ from the exact textbook form by rounding alone."""
    _, v1, _, v2 = pair
    assert collide_1d(*pair, e) == pytest.approx(
        [float(v) for v in textbook(*pair, e)], rel=0, abs=near(abs(v1) + abs(v2))
    )


@given(pairs, restitutions)
def test_momentum_is_kept(pair, e) -> None:
    """m1 v1 + m2 v2 is the same before and after (Newton's third law)."""
    m1, v1, m2, v2 = pair
    u1, u2 = collide_1d(*pair, e)
    scale = m1 * abs(v1) + m2 * abs(v2)
    assert m1 * u1 + m2 * u2 == pytest.approx(m1 * v1 + m2 * v2, rel=0, abs=near(scale))


@given(pairs)
def test_energy_of_an_elastic_collision_is_kept(pair) -> None:
    """Kinetic energy is the same before and after when e = 1, which is what elastic means."""
    m1, v1, m2, v2 = pair
    u1, u2 = elastic_1d(*pair)
    before = m1 * v1**2 + m2 * v2**2
    assert m1 * u1**2 + m2 * u2**2 == pytest.approx(before, rel=0, abs=near(before))


@given(pairs, restitutions)
def test_energy_never_grows(pair, e) -> None:
    """A passive collision adds no kinetic energy, at any restitution up to 1."""
    m1, v1, m2, v2 = pair
    u1, u2 = collide_1d(*pair, e)
    before = m1 * v1**2 + m2 * v2**2
    assert m1 * u1**2 + m2 * u2**2 <= before + near(before)


@given(pairs, restitutions)
def test_energy_loss_is_that_of_the_relative_motion(pair, e) -> None:
    """The loss is 1/2 m_r (1 - e^2) (v1 - v2)^2 (Goldstein, sec. 3.11)."""
    m1, v1, m2, v2 = pair
    u1, u2 = collide_1d(*pair, e)
    before, after = m1 * v1**2 / 2 + m2 * v2**2 / 2, m1 * u1**2 / 2 + m2 * u2**2 / 2
    loss = 0.5 * m1 * m2 / (m1 + m2) * (1 - e * e) * (v1 - v2) ** 2
    assert before - after == pytest.approx(loss, rel=0, abs=near(before))


@given(pairs, restitutions)
def test_relative_velocity_is_reversed_times_restitution(pair, e) -> None:
    """v2' - v1' = e (v1 - v2): Newton's law of restitution."""
    _, v1, _, v2 = pair
    u1, u2 = collide_1d(*pair, e)
    assert u2 - u1 == pytest.approx(e * (v1 - v2), rel=0, abs=near(abs(v1) + abs(v2)))


@given(pairs, restitutions)
def test_velocities_with_the_bodies_swapped_are_swapped_bit_for_bit(pair, e) -> None:
    """Which body is called the first does not matter, not even for the last bit."""
    m1, v1, m2, v2 = pair
    assert collide_1d(m2, v2, m1, v1, e) == collide_1d(m1, v1, m2, v2, e)[::-1]


@given(pairs, restitutions)
def test_velocities_seen_in_a_mirror_are_mirrored_bit_for_bit(pair, e) -> None:
    """With left and right exchanged the same collision happens, to the last bit."""
    m1, v1, m2, v2 = pair
    u1, u2 = collide_1d(m1, v1, m2, v2, e)
    assert collide_1d(m1, -v1, m2, -v2, e) == (-u1, -u2)


@given(pairs, restitutions, velocities)
def test_velocities_seen_from_a_moving_train_are_shifted(pair, e, shift) -> None:
    """Adding one velocity to both bodies adds it to both results (Galileo)."""
    m1, v1, m2, v2 = pair
    shifted = [u + shift for u in collide_1d(m1, v1, m2, v2, e)]
    scale = abs(v1) + abs(v2) + abs(shift)
    assert collide_1d(m1, v1 + shift, m2, v2 + shift, e) == pytest.approx(
        shifted, rel=0, abs=near(scale)
    )


@given(pairs, restitutions, st.integers(-20, 20))
def test_velocities_depend_on_the_ratio_of_masses_alone(pair, e, power) -> None:
    """Both masses in another unit (a power of two, so no rounding) change no bit."""
    m1, v1, m2, v2 = pair
    unit = 2.0**power
    assert collide_1d(unit * m1, v1, unit * m2, v2, e) == collide_1d(m1, v1, m2, v2, e)


@given(pairs)
def test_velocities_after_two_elastic_collisions_are_the_first_ones(pair) -> None:
    """An elastic collision runs backwards as well: colliding twice gives the start again."""
    m1, v1, m2, v2 = pair
    u1, u2 = elastic_1d(m1, v1, m2, v2)
    scale = 4 * (abs(v1) + abs(v2))  # the way back rounds numbers up to twice as large
    assert elastic_1d(m1, u1, m2, u2) == pytest.approx((v1, v2), rel=0, abs=near(scale))


@given(pairs)
def test_velocities_after_sticking_are_equal_bit_for_bit(pair) -> None:
    """Bodies that stick have one velocity, not two that differ in the last bit."""
    u1, u2 = inelastic_1d(*pair)
    assert u1 == u2


@given(masses, st.floats(allow_nan=False, allow_infinity=False))
def test_velocity_against_a_wall_is_reversed_exactly(m, v) -> None:
    """A wall (infinite mass) sends a ball back with -v, and does not move: no rounding."""
    assert elastic_1d(m, v, inf, 0.0) == (-v, 0.0)
    assert elastic_1d(inf, 0.0, m, v) == (0.0, -v)


@given(masses, velocities, velocities)
def test_velocity_sticking_to_a_moving_wall_is_exactly_the_walls(m, v, wall) -> None:
    """What sticks to an infinite mass moves with it: exactly (V, V)."""
    assert inelastic_1d(m, v, inf, wall) == (wall, wall)
    assert inelastic_1d(inf, wall, m, v) == (wall, wall)


@given(masses, velocities, velocities, restitutions)
def test_velocity_of_a_moving_wall_is_never_changed(m, v, wall, e) -> None:
    """An infinite mass keeps its velocity exactly, at any restitution."""
    assert collide_1d(m, v, inf, wall, e)[1] == wall
    assert collide_1d(inf, wall, m, v, e)[0] == wall


def test_velocities_of_fractions_against_a_wall_are_exact() -> None:
    """A Fraction beside ``math.inf`` loses no digit that a float could hold."""
    assert collide_1d(Fraction(1, 3), Fraction(3, 4), inf, 0, Fraction(1, 2)) == (-0.375, 0)


# At a mass ratio of 1e600 the heavy body is a wall and the light one is thrown ahead of it.
EXTREME = {
    "heavy hits light": ((1e300, 1.0, 1e-300, 0.0), (1.0, 2.0)),
    "light hits heavy": ((1e-300, 1.0, 1e300, 0.0), (-1.0, 0.0)),
    "both huge": ((1e300, 3.0, 1e300, -1.0), (-1.0, 3.0)),
    "both as large as floats go": ((1.7e308, 3.0, 1.7e308, -1.0), (-1.0, 3.0)),
    "both tiny": ((1e-300, 3.0, 1e-300, -1.0), (-1.0, 3.0)),
    "both the smallest floats": ((5e-324, 3.0, 5e-324, -1.0), (-1.0, 3.0)),
}


@pytest.mark.parametrize("kind", [float, np.float64, np.array, lambda x: [x]])
@pytest.mark.parametrize(("arguments", "after"), EXTREME.values(), ids=EXTREME)
def test_velocities_of_extreme_masses_are_finite_and_right(arguments, after, kind) -> None:
    """m1 + m2 and m1 v1 would overflow; the mass fraction does not, and warns of nothing."""
    u1, u2 = elastic_1d(*(kind(x) for x in arguments))
    assert (float(np.squeeze(u1)), float(np.squeeze(u2))) == after


@pytest.mark.parametrize(
    ("m1", "m2", "fraction"),
    [(3, 1, 0.75), (1, 1, 0.5), (inf, 1, 1), (1, inf, 0), (1e300, 1e-300, 1), (1e-300, 1e300, 0)],
)
def test_mass_fraction_worked_by_hand_is_found(m1, m2, fraction) -> None:
    """m1 / (m1 + m2), with its limits 0 and 1 exactly."""
    assert mass_fraction(m1, m2) == fraction


@given(exact_masses, exact_masses)
def test_mass_fractions_of_a_pair_add_up_to_one_exactly(m1, m2) -> None:
    """Both parts make the whole, exactly, in Fractions."""
    assert mass_fraction(m1, m2) == m1 / (m1 + m2)
    assert mass_fraction(m1, m2) + mass_fraction(m2, m1) == 1


def test_velocities_of_arrays_broadcast_one_collision_per_place() -> None:
    """Masses (3, 1) with velocities (4,) give all twelve collisions, each the textbook's."""
    m1 = np.array([[1.0], [2.0], [5.0]])
    v1 = np.array([3.0, 2.0, 0.0, -1.0])
    u1, u2 = collide_1d(m1, v1, 2, -2.0, 0.5)
    expected = [[textbook(m, v, 2, -2, 0.5) for v in v1] for m in m1[:, 0]]
    expected = np.array(expected, dtype=float)
    assert u1.shape == u2.shape == (3, 4)
    np.testing.assert_allclose(u1, expected[..., 0], rtol=0, atol=near(5))
    np.testing.assert_allclose(u2, expected[..., 1], rtol=0, atol=near(5))


def test_velocities_of_an_array_of_masses_may_hold_walls() -> None:
    """Infinite masses stand anywhere in an array, even on both sides, if never in one pair."""
    u1, u2 = collide_1d([1, inf, 1], [2, 0, 2], [inf, 1, 3], [0, 4, -2], [1, 0.5, 0.5])
    np.testing.assert_array_equal(u1, [-2, 0, -2.5])
    np.testing.assert_array_equal(u2, [0, -2, -0.5])


def test_velocities_of_arrays_beside_fractions_are_floats() -> None:
    """A Fraction beside an array becomes a float: no array of Python objects comes out."""
    u1, u2 = elastic_1d(Fraction(1, 2), np.array([3.0, 6.0]), 1, 0)
    assert u1.dtype == u2.dtype == float
    np.testing.assert_allclose(u1, [-1, -2], rtol=ROUNDING)
    np.testing.assert_allclose(u2, [2, 4], rtol=ROUNDING)
