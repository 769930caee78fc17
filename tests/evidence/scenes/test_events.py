"""The scenes of chapter 07: what stands where, and what the solvers make of them."""

from __future__ import annotations

import numpy as np
import pytest

from lesson_code import Circle, Scene, Segment, simulate
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.reference.closed_forms import rest_time
from lesson_code.reference.event_closed_forms import block_collisions, escape_fraction

ROUNDING = 1e-12
"""m or s: some dozen roundings of numbers of size 1 to 10."""

BALLS = 100


@pytest.mark.parametrize("speed", [8.0, 10.0, 30.0, 100.0])
def test_balls_at_wall_have_all_phases_so_that_pymunk_obeys_the_law(speed: float) -> None:
    """The fraction that passes is the law's, to one ball."""
    scene = exact_scenes.balls_at_wall(speed, count=BALLS, dt=1 / 60)
    run = simulate(scene, 1 / speed + 0.1, solver="pymunk", sample="end")
    law = escape_fraction(speed, 1 / 60, 0.1, 0.1)
    assert exact_scenes.share_beyond(run) == pytest.approx(law, abs=1 / BALLS)


@pytest.mark.parametrize("speed", [1.0, 1e3, 1e6])
def test_balls_at_wall_never_pass_the_exact_solver(speed: float) -> None:
    """All of them are hit once by a wall of 1 mm, and fly back as fast as they came."""
    scene = exact_scenes.balls_at_wall(speed, count=5, dt=1 / 60, thickness=0.001)
    run = simulate(scene, 2 / speed + 1 / 60, solver="exact", sample="end")
    assert exact_scenes.share_beyond(run) == 0
    assert len(run.contacts) == 5
    np.testing.assert_array_equal(run.velocities[-1, 1:], [(-speed, 0.0)] * 5)


def test_balls_at_wall_do_not_touch_each_other_or_the_wall() -> None:
    """They start before the wall, one and a half widths apart."""
    scene = exact_scenes.balls_at_wall(10.0, count=5, dt=0.1, radius=0.5, thickness=1.0)
    places = np.array([ball.position for ball in scene.bodies[1:]])
    assert (places[:, 0] <= -(0.5 + 1.0 / 2)).all()
    assert np.diff(places[:, 1]) == pytest.approx([1.5] * 4, abs=ROUNDING)


@pytest.mark.parametrize("turning", [5.0, 20.0, 40.0])
def test_turning_rod_misses_by_the_same_law_in_pymunk_and_never_in_ours(turning: float) -> None:
    """The fraction that is passed over is that of a ball at a wall, at the speed of the rod there.

    The way is an arc and no line, which changes the fraction by less than a ball in forty.
    """
    law = escape_fraction(turning * exact_scenes.ROD_ARM, 1 / 60, 0.1, 0.1)
    for solver, expected in (("pymunk", law), ("sequential", 0.0)):
        missed = 0
        for ball in range(40):
            scene = exact_scenes.turning_rod(turning, phase=(ball + 0.5) / 40, dt=1 / 60)
            run = simulate(scene, 0.6 / turning + 2 / 60, solver=solver, sample="end")
            missed += not run.velocities[-1, 1].any()
        assert missed / 40 == pytest.approx(expected, abs=1 / 40)


@pytest.mark.parametrize("ratio", [1.0, 2.0, 9.0, 100.0, 2500.0])
def test_two_blocks_collide_as_often_as_the_closed_form_says(ratio: float) -> None:
    """With the wall and with each other, until nothing meets any more."""
    run = simulate(exact_scenes.two_blocks(ratio), 1e4, solver="exact", sample="end")
    assert len(run.contacts) == block_collisions(ratio)
    assert run.kinetic_energy[-1] == pytest.approx(run.kinetic_energy[0], rel=ROUNDING)


def test_ball_in_a_box_is_where_the_closed_form_has_it() -> None:
    """For 10 s exactly; stepped, it is off by more than a decimetre."""
    times = np.linspace(0, 10, 21)
    scene = exact_scenes.ball_in_a_box()
    exact = simulate(scene, 10, solver="exact", sample=times)
    assert exact_scenes.error_in_the_box(exact) == pytest.approx(np.zeros(21), abs=ROUNDING)
    stepped = simulate(scene, 10, sample=times, solver="sequential")
    assert exact_scenes.error_in_the_box(stepped).max() > 0.1


@pytest.mark.parametrize("restitution", [0.2, 0.8])
def test_bouncing_to_rest_rests_when_it_should(restitution: float) -> None:
    """At the sum of a geometric series; afterwards it lies on the floor."""
    scene = exact_scenes.bouncing_to_rest(restitution, height=2.0)
    run = simulate(scene, 10, solver="exact")
    rest = rest_time(2.0, restitution, exact_scenes.GRAVITY)
    assert run.contacts.time[-1] == pytest.approx(rest, abs=ROUNDING)
    assert run.positions[-1, 1] == pytest.approx((0, 0.5), abs=ROUNDING)


def test_turned_back_is_the_same_scene_with_opposite_motion() -> None:
    """Shapes, masses, materials and gravity are kept; places are the last ones."""
    scene = exact_scenes.bouncing_to_rest(1.0)
    run = simulate(scene, 0.7, solver="sequential")
    back = exact_scenes.turned_back(run)
    assert back.gravity == scene.gravity
    for before, after, place, velocity in zip(
        scene.bodies, back.bodies, run.positions[-1], run.velocities[-1], strict=True
    ):
        assert (after.shape, after.mass, after.material) == (
            before.shape,
            before.mass,
            before.material,
        )
        np.testing.assert_array_equal(after.position, place)
        np.testing.assert_array_equal(after.velocity, -velocity)


def test_error_after_return_is_the_distance_of_the_farthest_body() -> None:
    """An elastic ball comes back to where it was let go, and one that lost energy does not."""
    for restitution, near in ((1.0, True), (0.5, False)):
        run = simulate(exact_scenes.bouncing_to_rest(restitution), 0.7, solver="exact")
        back = simulate(exact_scenes.turned_back(run), 0.7, solver="exact")
        error = exact_scenes.error_after_return(run, back)
        assert (error < ROUNDING) is near
        expected = abs(back.positions[-1, 1, 1] - run.positions[0, 1, 1])
        assert error == pytest.approx(expected, abs=ROUNDING)


def test_box_closes_round_its_room() -> None:
    """A ball started anywhere in it, in any direction, stays inside."""
    walls = exact_scenes.box(2.0, 1.0)
    assert [type(wall.shape) for wall in walls] == [Segment] * exact_scenes.WALLS
    for way in ((3.0, 0.7), (-2.0, 5.0), (1.0, -1.0)):
        start = exact_scenes.ball_in_a_box().bodies[-1]
        ball = type(start)(
            Circle(0.1), mass=1.0, position=(1, 0.5), velocity=way, material=start.material
        )
        run = simulate(Scene([*walls, ball]), 5.0, solver="exact")
        x, y = run.positions[:, -1].T
        assert x.min() >= 0.1 - ROUNDING
        assert x.max() <= 1.9 + ROUNDING
        assert y.min() >= 0.1 - ROUNDING
        assert y.max() <= 0.9 + ROUNDING
