"""The conventions printed in the README, each asserted once."""

import math

import numpy as np
import pytest

from lesson_code.formulas import (
    bounce,
    collide_1d,
    friction_impulse,
    normal_impulse,
    reflect,
)
from lesson_code.formulas.arithmetic import cross, perpendicular
from lesson_code.geometry import circle_against_segment
from lesson_code.programs import billiards_table


def test_normal_of_a_wall_points_to_the_ball() -> None:
    """A floor below a ball has the normal (0, 1), y up, and a ball coming down is turned."""
    contact = circle_against_segment((0.0, 0.4), 0.5, (-1.0, 0.0), (1.0, 0.0))
    assert contact is not None
    normal, _ = contact
    assert normal.tolist() == [0.0, 1.0]
    assert bounce((0.0, -2.0), normal, 1.0).tolist() == [0.0, 2.0]


def test_billiards_alone_has_y_down() -> None:
    """On the billiard table the top wall pushes towards larger y."""
    [(name, normal, _)] = billiards_table.wall_contacts((300.0, 5.0))
    assert (name, normal.tolist()) == ("top", [0.0, 1.0])


def test_cross_and_perpendicular_turn_counter_clockwise() -> None:
    """cross(a, b) is positive when b lies counter-clockwise of a."""
    x_axis = np.array([1.0, 0.0])
    assert cross(x_axis, perpendicular(x_axis)) == 1.0


@pytest.mark.parametrize("vn", [-3.0, 0.0, 3.0])
def test_normal_impulse_is_never_negative(vn: float) -> None:
    """A contact can push, but not pull."""
    assert normal_impulse(vn, 2.0, 0.5) >= 0.0


def test_friction_impulse_acts_against_the_sliding() -> None:
    """Friction has the opposite sign of the tangent velocity."""
    assert friction_impulse(2.0, 1.0, 0.5, 1.0) < 0.0 < friction_impulse(-2.0, 1.0, 0.5, 1.0)


def test_restitution_has_no_velocity_threshold() -> None:
    """A ball at a micrometre a second bounces like any other."""
    assert bounce((0.0, -1e-6), (0.0, 1.0), 1.0)[1] == 1e-6


def test_touching_is_not_overlapping() -> None:
    """A ball at exactly its radius has no contact; a hair nearer it has one, of depth > 0."""
    at = [circle_against_segment((0.0, y), 0.5, (-1.0, 0.0), (1.0, 0.0)) for y in (0.5, 0.5 - 1e-9)]
    assert at[0] is None
    assert at[1] is not None
    assert at[1][1] > 0.0


def test_normal_must_be_unit_within_1e_9() -> None:
    """A normal of length 1 + 1e-10 passes; 1 + 1e-8 is refused, and the length is named."""
    reflect((1.0, -1.0), (0.0, 1.0 + 1e-10))
    with pytest.raises(ValueError, match=r"normal must be a unit vector .*1\.00000001"):
        reflect((1.0, -1.0), (0.0, 1.0 + 1e-8))


def test_infinite_mass_is_exact() -> None:
    """A body of infinite mass keeps its velocity to the last bit."""
    assert collide_1d(math.inf, 0.1, 3.0, -0.7, 0.3)[0] == 0.1


def test_no_contact_is_none() -> None:
    """No contact is None, never 0.0 or False."""
    assert circle_against_segment((0.0, 9.0), 0.5, (-1.0, 0.0), (1.0, 0.0)) is None
    assert billiards_table.bumper_contact((50.0, 350.0)) is None


def test_inputs_are_never_changed() -> None:
    """A formula leaves the arrays it is given as they were."""
    velocity, normal = np.array([3.0, -4.0]), np.array([0.0, 1.0])
    bounce(velocity, normal, 0.5, 0.2)
    assert (velocity.tolist(), normal.tolist()) == ([3.0, -4.0], [0.0, 1.0])


def test_bad_input_names_argument_rule_and_value() -> None:
    """A wrong value is a ValueError that says which, why and what; a non-number a TypeError."""
    with pytest.raises(ValueError, match=r"^m1 must be > 0 kg, got -1$"):
        collide_1d(-1, 0, 1, 0, 0.5)
    with pytest.raises(TypeError, match="m1"):
        collide_1d("heavy", 0, 1, 0, 0.5)
