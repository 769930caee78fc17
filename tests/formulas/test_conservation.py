import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.formulas import angular_momentum, kinetic_energy, momentum

ROUNDING = 1e-13
"""Of the sum of sizes: ten bodies add up with a few dozen roundings of 1e-16."""

masses = st.floats(1e-3, 1e3)
components = st.floats(-1e3, 1e3, allow_subnormal=False)
vectors = st.tuples(components, components)
bodies = st.lists(st.tuples(masses, vectors, vectors), min_size=1, max_size=10)
"""Each body: mass, position, velocity."""


def columns(drawn):
    """Return masses (N,), positions (N, 2) and velocities (N, 2) of bodies."""
    m, r, v = zip(*drawn, strict=True)
    return np.array(m), np.array(r), np.array(v)


def size(m, r, v):
    """Return what no sum of m (r x v) over the bodies can exceed."""
    return (m * np.hypot(*r.T) * np.hypot(*v.T)).sum()


TWO = {"masses": [1, 2], "velocities": [(3, 0), (0, -1)]}
SPINS = {"inertias": [2, 4], "angular_velocities": [3, -1]}


def test_momentum_worked_by_hand_is_found() -> None:
    """1 (3, 0) + 2 (0, -1) = (3, -2)."""
    np.testing.assert_array_equal(momentum(**TWO), [3, -2])


def test_kinetic_energy_worked_by_hand_is_found() -> None:
    """1/2 1 9 + 1/2 2 1 = 5.5; spin adds 1/2 2 9 + 1/2 4 1 = 11."""
    assert kinetic_energy(**TWO) == 5.5
    assert kinetic_energy(**TWO, **SPINS) == 16.5


def test_angular_momentum_worked_by_hand_is_found() -> None:
    """1 (0, 2) x (3, 0) = -6 and 2 (1, 0) x (0, -1) = -2; spin adds 2 3 - 4 1 = 2."""
    assert angular_momentum(positions=[(0, 2), (1, 0)], **TWO) == -8
    assert angular_momentum(positions=[(0, 2), (1, 0)], **TWO, **SPINS) == -6


def test_angular_momentum_about_another_point_worked_by_hand_is_found() -> None:
    """About (1, 2): (-1, 0) x (3, 0) = 0 and 2 (0, -2) x (0, -1) = 0."""
    assert angular_momentum(positions=[(0, 2), (1, 0)], **TWO, about=(1, 2)) == 0


def test_angular_momentum_is_positive_counter_clockwise() -> None:
    """On the right and going up is counter-clockwise, with y up."""
    assert angular_momentum(1, (1, 0), (0, 1)) == 1
    assert angular_momentum(1, (1, 0), (0, -1)) == -1


@given(bodies)
def test_sums_equal_the_sums_in_fractions(drawn) -> None:
    """Each sum agrees with the same sum of exact fractions, one body after the other."""
    m, r, v = columns(drawn)
    exact = [[Fraction(float(x)) for x in (a, *b, *c)] for a, b, c in zip(m, r, v, strict=True)]
    px, py = sum(a * vx for a, _, _, vx, _ in exact), sum(a * vy for a, _, _, _, vy in exact)
    energy = sum(a * (vx**2 + vy**2) / 2 for a, _, _, vx, vy in exact)
    spin = sum(a * (x * vy - y * vx) for a, x, y, vx, vy in exact)
    largest = (m[:, None] * np.abs(v)).sum()
    np.testing.assert_allclose(
        momentum(m, v), [float(px), float(py)], rtol=0, atol=ROUNDING * largest
    )
    assert kinetic_energy(m, v) == pytest.approx(float(energy), rel=ROUNDING)
    assert angular_momentum(m, r, v) == pytest.approx(
        float(spin), rel=0, abs=ROUNDING * size(m, r, v)
    )


@given(bodies, vectors)
def test_momentum_seen_from_a_moving_train_is_shifted_by_mass_times_velocity(drawn, shift) -> None:
    """An observer who moves with -u sees p + M u (Galileo)."""
    m, _, v = columns(drawn)
    atol = ROUNDING * m.sum() * (np.abs(v).max() + math.hypot(*shift))
    np.testing.assert_allclose(
        momentum(m, v + shift), momentum(m, v) + m.sum() * np.array(shift), rtol=0, atol=atol
    )


@given(bodies, vectors)
def test_kinetic_energy_is_that_of_the_centre_and_that_about_it(drawn, shift) -> None:
    """E' = E + p . u + 1/2 M u^2 for an observer who moves with -u (Koenig)."""
    m, _, v = columns(drawn)
    u = np.array(shift)
    expected = kinetic_energy(m, v) + momentum(m, v) @ u + m.sum() * (u @ u) / 2
    atol = ROUNDING * m.sum() * (np.hypot(*v.T).max() + math.hypot(*shift)) ** 2
    np.testing.assert_allclose(kinetic_energy(m, v + u), expected, rtol=0, atol=atol)


@given(bodies, vectors)
def test_angular_momentum_about_another_point_differs_by_the_lever_arm(drawn, point) -> None:
    """L about a = L about the origin - a x p."""
    m, r, v = columns(drawn)
    p = momentum(m, v)
    expected = angular_momentum(m, r, v) - (point[0] * p[1] - point[1] * p[0])
    atol = ROUNDING * (size(m, r, v) + math.hypot(*point) * (m * np.hypot(*v.T)).sum())
    np.testing.assert_allclose(angular_momentum(m, r, v, about=point), expected, rtol=0, atol=atol)


@given(bodies, st.floats(-math.pi, math.pi))
def test_sums_of_a_rotated_scene_turn_with_it(drawn, angle) -> None:
    """Momentum turns, energy and angular momentum stay."""
    m, r, v = columns(drawn)
    c, s = math.cos(angle), math.sin(angle)
    turn = np.array([[c, s], [-s, c]])
    atol = ROUNDING * (m * np.hypot(*v.T)).sum()
    np.testing.assert_allclose(momentum(m, v @ turn), momentum(m, v) @ turn, rtol=0, atol=atol)
    assert kinetic_energy(m, v @ turn) == pytest.approx(kinetic_energy(m, v), rel=ROUNDING)
    assert angular_momentum(m, r @ turn, v @ turn) == pytest.approx(
        angular_momentum(m, r, v), rel=0, abs=ROUNDING * size(m, r, v)
    )


@given(bodies)
def test_sums_seen_in_a_mirror_are_mirrored_bit_for_bit(drawn) -> None:
    """With left and right exchanged, momentum is mirrored and angular momentum reversed."""
    m, r, v = columns(drawn)
    mirror = np.array([-1.0, 1.0])
    np.testing.assert_array_equal(momentum(m, mirror * v), mirror * momentum(m, v))
    assert kinetic_energy(m, mirror * v) == kinetic_energy(m, v)
    assert angular_momentum(m, mirror * r, mirror * v) == -angular_momentum(m, r, v)


def test_sums_of_frames_are_one_for_each_frame() -> None:
    """Velocities (F, N, 2) give momentum (F, 2), energy (F,) and angular momentum (F,)."""
    frames = np.array([[(3, 0), (0, -1)], [(0, 0), (0, 0)], [(1, 1), (1, 1)]])
    places = np.array([[(0, 2), (1, 0)], [(5, 5), (5, 5)], [(1, 0), (0, 1)]])
    np.testing.assert_array_equal(momentum([1, 2], frames), [(3, -2), (0, 0), (3, 3)])
    np.testing.assert_array_equal(kinetic_energy([1, 2], frames), [5.5, 0, 3])
    np.testing.assert_array_equal(angular_momentum([1, 2], places, frames), [-8, 0, -1])


def test_spin_of_frames_is_one_for_each_body_and_frame() -> None:
    """Angular velocities (F, N) with inertias (N,): 1/2 2 9 + 1/2 4 1, and 1/2 2 4."""
    still, w = np.zeros((2, 2, 2)), [(3, -1), (2, 0)]
    np.testing.assert_array_equal(kinetic_energy([1, 2], still, [2, 4], w), [11, 4])
    np.testing.assert_array_equal(angular_momentum([1, 2], still, still, [2, 4], w), [2, 4])


def test_sums_of_one_body_may_be_given_as_number_and_vector() -> None:
    """A number and a vector (2,) are one body."""
    np.testing.assert_array_equal(momentum(2, (3, 4)), [6, 8])
    assert kinetic_energy(2, (3, 4), 2, 3) == 34  # 25 + 9
    assert angular_momentum(2, (1, 0), (3, 4), 2, 3) == 14  # 8 + 6


def test_sums_with_one_mass_for_all_bodies_count_each_body() -> None:
    """A single mass, or inertia, stands for every body."""
    np.testing.assert_array_equal(momentum(2, [(1, 0), (0, 1), (1, 1)]), [4, 4])
    assert kinetic_energy(2, [(1, 0), (0, 1), (1, 1)], 2, 1) == 7  # 4 + 3


def test_sums_of_no_bodies_are_zero() -> None:
    """An empty scene has no momentum and no energy."""
    nobody = np.zeros((0, 2))
    np.testing.assert_array_equal(momentum([], nobody), [0, 0])
    assert kinetic_energy([], nobody) == 0
    assert angular_momentum([], nobody, nobody) == 0


def test_sums_leave_out_a_body_of_infinite_mass_at_rest() -> None:
    """The ground adds nothing, and no nan (inf times 0)."""
    m, r, v = [math.inf, 2], [(9, 9), (1, 0)], [(0, 0), (0, 3)]
    np.testing.assert_array_equal(momentum(m, v), [0, 6])
    assert kinetic_energy(m, v) == 9
    assert angular_momentum(m, r, v) == 6


@pytest.mark.parametrize("velocity", [(1, 0), (0, -1e-300)])
def test_sums_refuse_a_body_of_infinite_mass_that_moves(velocity) -> None:
    """Its momentum would be infinite: the error names the argument and the value."""
    for call in (
        lambda: momentum([1, math.inf], [(0, 0), velocity]),
        lambda: kinetic_energy([1, math.inf], [(0, 0), velocity]),
        lambda: angular_momentum([1, math.inf], [(0, 0), (0, 0)], [(0, 0), velocity]),
    ):
        with pytest.raises(ValueError, match="masses must be finite for bodies that move, got inf"):
            call()


def test_sums_of_extreme_masses_are_finite_and_right() -> None:
    """1e300 kg and 1e-300 kg are masses like any other."""
    np.testing.assert_array_equal(momentum([1e300, 1e-300], [(2, 0), (0, 2)]), [2e300, 2e-300])
    assert kinetic_energy([1e300], [(2, 0)]) == 2e300
    assert kinetic_energy([1e-300], [(2, 0)]) == 2e-300


MISFITS = {
    "three masses": ("masses", (3,), lambda: momentum([1, 2, 3], [(1, 0), (0, 1)])),
    "two masses, one body": ("masses", (2,), lambda: momentum([1, 2], (1, 0))),
    "masses as a column": ("masses", (2, 1), lambda: momentum([[1], [2]], [(1, 0), (0, 1)])),
    "three inertias, one body": ("inertias", (3,), lambda: kinetic_energy(2, (3, 0), [1, 1, 1], 1)),
    "three spins, one body": (
        "angular_velocities",
        (3,),
        lambda: kinetic_energy(2, (3, 0), 1, [1, 1, 1]),
    ),
    "three inertias, two bodies": (
        "inertias",
        (3,),
        lambda: kinetic_energy(2, [(3, 0), (3, 0)], [1, 1, 1], 1),
    ),
    "two positions, one body": (
        "positions",
        (2, 2),
        lambda: angular_momentum(1, [(1, 0), (2, 0)], [(0, 1)]),
    ),
    "a point for each body": (
        "about",
        (2, 2),
        lambda: angular_momentum(1, [(1, 0)] * 2, [(0, 1)] * 2, about=[(1, 0), (2, 0)]),
    ),
}


@pytest.mark.parametrize(("argument", "shape", "call"), MISFITS.values(), ids=MISFITS)
def test_sums_refuse_shapes_that_count_other_bodies(argument, shape, call) -> None:
    """No body is counted twice by broadcasting: the velocities say how many there are."""
    with pytest.raises(ValueError) as caught:  # noqa: PT011 - the message is asserted below
        call()
    message = str(caught.value)
    assert message.startswith(f"{argument} must have shape ")
    assert message.endswith(f"got shape {shape}")
