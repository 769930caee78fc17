from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.formulas.arithmetic import clamp, cross, dot, perpendicular

numbers = st.integers(-1000, 1000).map(float)
vectors = st.tuples(numbers, numbers).map(np.array)
"""Whole numbers, whose products floats hold exactly: the laws below need no tolerance."""


@pytest.mark.parametrize(
    ("a", "b", "dot_product", "cross_product"),
    [
        pytest.param((1, 0), (0, 1), 0, 1, id="b a quarter turn counter-clockwise"),
        pytest.param((0, 1), (1, 0), 0, -1, id="b a quarter turn clockwise"),
        pytest.param((3, 4), (3, 4), 25, 0, id="parallel"),
        pytest.param((3, 4), (-3, -4), -25, 0, id="opposite"),
        pytest.param((2, 3), (5, 7), 31, -1, id="10 + 21 and 14 - 15"),
        pytest.param((0, 0), (5, 7), 0, 0, id="zero"),
    ],
)
def test_products_worked_by_hand_are_found(a, b, dot_product, cross_product) -> None:
    """a_x b_x + a_y b_y and a_x b_y - a_y b_x."""
    assert dot(a, b) == dot_product
    assert cross(a, b) == cross_product


@given(vectors, vectors)
def test_products_of_swapped_vectors_keep_or_change_sign(a, b) -> None:
    """The dot product is symmetric, the cross product antisymmetric."""
    assert dot(a, b) == dot(b, a)
    assert cross(a, b) == -cross(b, a)


@given(vectors, vectors)
def test_products_together_obey_lagrange(a, b) -> None:
    """(a . b)^2 + (a x b)^2 = |a|^2 |b|^2: Lagrange's identity in the plane."""
    assert dot(a, b) ** 2 + cross(a, b) ** 2 == dot(a, a) * dot(b, b)


@given(vectors, vectors)
def test_perpendicular_is_a_quarter_turn_counter_clockwise(a, b) -> None:
    """It is as long, at a right angle, to the left; and a x b is its dot product with b."""
    turned = perpendicular(a)
    assert dot(turned, turned) == dot(a, a)
    assert dot(a, turned) == 0
    assert cross(a, turned) == dot(a, a)
    assert dot(turned, b) == cross(a, b)


@given(vectors)
def test_perpendicular_four_times_is_the_identity(a) -> None:
    """Four quarter turns are none; two are a half turn."""
    half = perpendicular(perpendicular(a))
    np.testing.assert_array_equal(half, -a)
    np.testing.assert_array_equal(perpendicular(perpendicular(half)), a)


def test_perpendicular_gives_the_velocity_of_a_point_on_a_spinning_body() -> None:
    """v_contact = v + w (-r_y, r_x): the rightmost point goes up when w is positive."""
    np.testing.assert_array_equal(3.0 * perpendicular(np.array([2.0, 0.0])), [0, 6])


def test_products_of_batches_are_one_for_each_vector() -> None:
    """Components come first: shape (2, 3) is three vectors."""
    a = np.array([[1.0, 0.0, 2.0], [0.0, 1.0, 3.0]])
    b = np.array([[0.0, 1.0, 5.0], [1.0, 0.0, 7.0]])
    np.testing.assert_array_equal(dot(a, b), [0, 0, 31])
    np.testing.assert_array_equal(cross(a, b), [1, -1, -1])
    np.testing.assert_array_equal(perpendicular(a), [[0, -1, -3], [1, 0, 2]])


def test_products_of_fractions_are_exact() -> None:
    """Arithmetic is all they ask of a number: 1/6 + 1/6 and 1/4 - 1/9."""
    a, b = (Fraction(1, 2), Fraction(1, 3)), (Fraction(1, 3), Fraction(1, 2))
    assert dot(a, b) == Fraction(1, 3)
    assert cross(a, b) == Fraction(5, 36)


@pytest.mark.parametrize(
    ("value", "clamped"),
    [(-3.0, -2.0), (-2.0, -2.0), (-1.5, -1.5), (0.0, 0.0), (1.5, 1.5), (2.0, 2.0), (3.0, 2.0)],
)
def test_clamp_inside_outside_and_at_the_ends_is_the_nearest_point(value, clamped) -> None:
    """The result is the point of [-2, 2] nearest to the value, for numbers and for arrays."""
    assert clamp(value, -2.0, 2.0) == clamped
    np.testing.assert_array_equal(clamp(np.array([value]), -2.0, 2.0), [clamped])
    np.testing.assert_array_equal(
        clamp(value, np.array([-2.0, -9.0]), np.array([2.0, 9.0])), [clamped, value]
    )


def test_clamp_changes_nothing_in_place() -> None:
    """An array that is clamped stays as it was."""
    values = np.array([-3.0, 3.0])
    clamp(values, -2.0, 2.0)
    np.testing.assert_array_equal(values, [-3, 3])
