"""The conventions of the handbook, each asserted once."""

import math

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.chapters.billiards import rules as billiards_table
from lesson_code.formulas import (
    bounce,
    collide_1d,
    friction_impulse,
    normal_impulse,
    reflect,
)
from lesson_code.formulas.arithmetic import cross, perpendicular
from lesson_code.geometry import circle_against_segment


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


def head_on(first: Material, second: Material, combine: str = "workbook") -> float:
    """Return separation over approach of two equal discs that meet at 1 m/s."""
    scene = Scene(
        [
            Body(Circle(1), mass=1.0, velocity=(1, 0), position=(-1.01, 0), material=first),
            Body(Circle(1), mass=1.0, position=(1, 0), material=second),
        ]
    )
    before, after = simulate(scene, 0.5, combine=combine).velocities[[0, -1], :, 0]
    return float((after[1] - after[0]) / (before[0] - before[1]))


def test_pairs_restitution_is_the_smaller_unless_another_rule_is_named() -> None:
    """0.5 and 0.8: the smaller; pymunk's product; Box2D's larger."""
    one, other = Material(restitution=0.5), Material(restitution=0.8)
    assert head_on(one, other) == pytest.approx(0.5)
    assert head_on(one, other, combine="pymunk") == pytest.approx(0.4)
    assert head_on(one, other, combine="box2d") == pytest.approx(0.8)


def test_coefficient_left_open_is_the_other_bodys_or_none() -> None:
    """A material that says nothing leaves it to the other; two that say nothing make 0."""
    assert head_on(Material(), Material(restitution=0.5)) == pytest.approx(0.5)
    assert head_on(Material(), Material()) == pytest.approx(0.0)


def test_pairs_friction_is_the_geometric_mean() -> None:
    """0.2 and 0.8 make 0.4: that share of the weight slows a sliding box."""
    box = Body(
        Polygon.box(1, 1),
        position=(0, 0.5),
        velocity=(9, 0),
        mass=1.0,
        material=Material(0.0, 0.2),
    )
    floor = Body(Segment((-50, 0), (50, 0)), material=Material(0.0, 0.8))
    run = simulate(Scene([box, floor], gravity=(0, -10)), 1.0)
    assert run.velocities[-1, 0, 0] == pytest.approx(9 - 0.4 * 10)


def test_impulse_acts_on_b_along_the_normal_and_on_a_against_it() -> None:
    """The normal goes from a to b; b gains j n, a loses it; j is never negative."""
    left = Body(Circle(1), mass=1.0, velocity=(1, 0), position=(-1.01, 0))
    right = Body(Circle(1), mass=1.0, position=(1, 0))
    run = simulate(Scene([left, right]), 0.5)
    gained = run.velocities[-1] - run.velocities[0]
    j = run.contacts.normal_impulse.sum()
    assert run.contacts.normal[0].tolist() == [1.0, 0.0]
    assert (run.contacts.normal_impulse >= 0).all()
    assert gained.tolist() == [[-j, 0.0], [j, 0.0]]


def test_body_without_a_mass_is_static_and_keeps_its_velocity() -> None:
    """Nothing pushes it; a velocity that it was given stays."""
    wall = Body(Segment((0, -5), (0, 5)), velocity=(2, 0))
    ball = Body(Circle(1), position=(2, 0), mass=1.0)
    run = simulate(Scene([wall, ball], gravity=(0, -10)), 1.0)
    assert run.velocities[-1, 0].tolist() == [2.0, 0.0]


def test_polygon_stands_with_its_centroid_at_its_position() -> None:
    """Where the vertices were written down does not matter."""
    here, there = Polygon([(0, 0), (3, 0), (0, 3)]), Polygon([(10, 7), (13, 7), (10, 10)])
    assert np.array(here.vertices) == pytest.approx(np.array(there.vertices))
    assert np.mean(here.vertices, axis=0) == pytest.approx([0, 0])


def test_coincident_centres_have_the_normal_along_x() -> None:
    """Two discs in one place are pushed apart along (1, 0), the second to the right."""
    run = simulate(Scene([Body(Circle(1), mass=1.0), Body(Circle(1), mass=1.0)]), 1.0)
    assert run.positions[-1, 0, 0] < 0 < run.positions[-1, 1, 0]
    assert run.positions[-1, :, 1].tolist() == [0.0, 0.0]
