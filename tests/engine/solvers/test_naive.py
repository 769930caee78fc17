"""The lesson's first attempt: right where it says so, and each of its faults with its figure."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate

ROUNDING = 1e-14
"""m and m/s: a dozen operations on numbers of about 1."""

DT = 0.01


def one_step(bodies: list[Body], solver: str = "naive") -> Run:
    """Return what one short step makes of some bodies."""
    return simulate(Scene(bodies), DT, dt=DT, solver=solver)


def discs(*rows: tuple[float | None, float, float], e: float = 1.0, mu: float = 0.0) -> list[Body]:
    """Return discs of 1 m on the x axis: mass, place after the step's motion, velocity."""
    return [
        Body(
            Circle(0.5), mass=mass, position=(x - v * DT, 0), velocity=(v, 0),
            material=Material(e, mu),
        )
        for mass, x, v in rows
    ]  # fmt: skip


def test_velocities_of_two_free_discs_are_right() -> None:
    """It looks right, and here it is: 1 kg at 2 m/s and 3 kg at -1 m/s, e = 0.7."""
    run = one_step(discs((1, 0, 2), (3, 0.99, -1), e=0.7))
    np.testing.assert_allclose(run.velocities[1, :, 0], [-1.825, 0.275], rtol=ROUNDING)
    assert run.contacts.normal_impulse == pytest.approx(3.825)


def test_places_of_unequal_masses_are_halved_all_the_same() -> None:
    """1 kg and 1000 kg overlap by 0.1 m: the heavy one is moved by 0.05 m, not by 0.0001 m.

    The centre of mass jumps by 0.0499 m, which no inner force can do.
    """
    run = one_step(discs((1, 0, 1), (1000, 0.9, 0)))
    np.testing.assert_allclose(run.positions[1, :, 0], [-0.05, 0.95], rtol=ROUNDING)
    shift = (1 * -0.05 + 1000 * 0.05) / 1001
    assert shift == pytest.approx(0.0499, abs=1e-4)


def test_places_beside_a_wall_are_pushed_by_half_only() -> None:
    """The wall cannot move its half, so half of the overlap stays."""
    wall, ball = discs((None, 0, 0), (1, 0.9, -1))
    assert one_step([wall, ball]).max_penetration[1] == pytest.approx(0.05)


def test_normal_of_a_wall_leads_from_centre_to_centre() -> None:
    """A ball falls straight down on a floor, 3 m beside its middle, and is thrown sideways.

    The line of centres is (3, 0.4) / 3.026: of (0, -1) m/s it turns round (0.991, 0.132) x -0.132,
    and leaves (0.262, -0.965), still downwards. Right is (0, 1).
    """
    floor = Body(Segment((-10, 0), (10, 0)))
    ball = Body(Circle(0.5), mass=1, position=(3, 0.4 + DT), velocity=(0, -1), material=Material(1))
    n = np.array([3, 0.4]) / np.hypot(3, 0.4)
    naive, right = one_step([floor, ball]), one_step([floor, ball], "sequential")
    np.testing.assert_allclose(naive.velocities[1, 1], [0, -1] + 2 * n[1] * n, rtol=ROUNDING)
    np.testing.assert_allclose(naive.velocities[1, 1], [0.262, -0.965], atol=5e-4)
    np.testing.assert_allclose(naive.contacts.normal, [n], rtol=ROUNDING)
    np.testing.assert_allclose(right.velocities[1, 1], [0, 1], atol=ROUNDING)


def test_spin_of_a_box_hit_off_its_centre_stays_zero() -> None:
    """A falling box lands on one corner and does not begin to turn; it should, at 1.2 rad/s."""
    floor = Body(Circle(0.5), position=(0.5, -0.5))
    box = Body(Polygon.box(1, 1), mass=1, position=(0, 0.49 + DT), velocity=(0, -1))
    naive, right = one_step([floor, box]), one_step([floor, box], "sequential")
    assert naive.angular_velocities[1, 1] == 0
    # the arm is 1/2 m, I = 1/6: jn = 1 / (1 + 1.5) = 0.4, w = -jn (-0.5) 6
    assert abs(right.angular_velocities[1, 1]) == pytest.approx(1.2, rel=1e-9)


def test_friction_is_not_there() -> None:
    """A spinning disc falls on another and neither takes nor gives any spin."""
    a, b = discs((1, 0, 1), (1, 0.99, 0), e=0.5, mu=1.0)
    spinning = Body(b.shape, mass=1, position=b.position, angular_velocity=10, material=b.material)
    naive, right = one_step([a, spinning]), one_step([a, spinning], "sequential")
    assert naive.angular_velocities[1].tolist() == [0, 10]
    assert not naive.contacts.tangent_impulse.any()
    assert right.angular_velocities[1, 0] != 0


def test_bodies_in_one_place_stay_there() -> None:
    """No line leads from a centre to itself: they fly on together, 1 m deep in each other."""
    run = simulate(Scene([Body(Circle(0.5), mass=1), Body(Circle(0.5), mass=1)]), 1, solver="naive")
    assert run.max_penetration.tolist() == [1.0] * 61
    assert not run.velocities.any()


def test_overlap_of_a_pair_at_rest_stays() -> None:
    """Who does not approach is not pushed apart either."""
    run = simulate(Scene(discs((1, 0, 0), (1, 0.8, 0))), 1, solver="naive")
    np.testing.assert_allclose(run.max_penetration, 0.2, rtol=1e-12)


def test_last_contact_of_a_row_spoils_the_first() -> None:
    """Three discs of 1 kg in a row, e = 0, both outer ones at 1 m/s: at rest they should be.

    One pass: the first pair shares (1/2, 1/2), the second then (-1/4, -1/4): still meeting.
    """
    row = discs((1, 0, 1), (1, 0.99, 0), (1, 1.98, -1), e=0.0)
    naive, right = one_step(row), one_step(row, "sequential")
    np.testing.assert_allclose(naive.velocities[1, :, 0], [0.5, -0.25, -0.25], rtol=ROUNDING)
    # ten sweeps: each leaves a quarter of what the one before left
    np.testing.assert_allclose(right.velocities[1, :, 0], 0, atol=0.25**9)


def test_box_on_a_floor_is_resolved_once_a_pair() -> None:
    """Two points of one pair are one collision: the impulse is that of the first, once."""
    floor, box = Body(Segment((-5, 0), (5, 0))), Polygon.box(1, 1)
    body = Body(box, mass=2, position=(0, 0.49 + DT), velocity=(0, -1), material=Material(1))
    run = one_step([floor, body])
    assert run.contacts.normal_impulse == pytest.approx(4)
    np.testing.assert_allclose(run.velocities[1, 1], [0, 1], atol=ROUNDING)


def test_iterations_do_not_help() -> None:
    """It makes one pass, whatever is asked for."""
    scene = Scene(discs((1, 0, 1), (1, 0.99, 0), (1, 1.98, -1), e=0.0))
    one, many = (simulate(scene, DT, dt=DT, solver="naive", iterations=n) for n in (1, 100))
    np.testing.assert_array_equal(one.velocities, many.velocities)
