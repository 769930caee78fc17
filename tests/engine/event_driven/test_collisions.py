"""Collisions: single impacts, and how a series of them ends."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Run, Scene, Segment, simulate
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven.constants import HOP
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes import rigid_bodies as scenes

ROUNDING = 1e-12
"""A handful of impacts, each right to 1e-16 of numbers near 1."""

COLLAPSED = 1e-8
"""Of the speed: discs that approach slower than SLOW = 1e-9 of it go on together."""

HOPPING = 2e-4
"""Of a radius: how high a disc in a pile hops, at 2 HOP; its energy is (1e-2)^2 of a fall's."""

ELASTIC = Material(1.0)


def ball(**values: Any) -> Body:
    """Return a ball of 0.5 m and 1 kg, elastic unless it is said."""
    return Body(Circle(0.5), **({"mass": 1.0, "material": ELASTIC} | values))


def exact(bodies: list[Body], duration: float, gravity: float = 0.0) -> Run:
    """Let the exact solver run; gravity in m/s^2 downwards."""
    return simulate(Scene(bodies, (0, -gravity)), duration, solver="exact")


def held(scene: Scene, until: float) -> ExactSolver:
    """Return a solver at some time, s."""
    solver = ExactSolver(scene, combine=mixing_rule("workbook"))
    solver.advance(until)
    return solver


# Obstacles


def test_ball_on_a_wall_that_comes_gains_twice_its_speed() -> None:
    """From -1 m/s to 1 + 2 u."""
    wall = Body(Segment((0, -5), (0, 5)), velocity=(0.5, 0), material=ELASTIC)
    run = exact([wall, ball(position=(3, 0), velocity=(-1, 0))], 5.0)
    assert run.contacts.time.tolist() == pytest.approx([2.5 / 1.5])
    assert run.velocities[-1, 1].tolist() == pytest.approx([2.0, 0.0], rel=ROUNDING)
    assert run.positions[-1, 0, 0] == pytest.approx(2.5)


def test_ball_between_a_wall_and_one_that_comes_keeps_speed_times_room() -> None:
    """Each hit adds 2 u. From v (L1 - L2) / u = L1 + L2 follows that (v - u) L stays as it is."""
    u = 0.01
    walls = [
        Body(Segment((-0.5, -5), (-0.5, 5)), material=ELASTIC),
        Body(Segment((10.5, -5), (10.5, 5)), velocity=(-u, 0), material=ELASTIC),
    ]
    run = exact([*walls, ball(position=(1, 0), velocity=(3, 0))], 500.0)
    times = run.contacts.time[run.contacts.body_a == 1]
    speeds, rooms = 3 + 2 * u * np.arange(1, len(times) + 1), 10 - u * times
    assert len(times) > 100
    np.testing.assert_allclose((speeds - u) * rooms, (speeds[0] - u) * rooms[0], rtol=ROUNDING)
    assert abs(run.velocities[-1, 2, 0]) == pytest.approx(speeds[-1], rel=ROUNDING)


def test_ball_on_the_end_of_a_wall_is_mirrored_at_the_corner() -> None:
    """The normal leads from the end to the centre: 30 degrees from the way it came."""
    run = exact(
        [
            Body(Segment((-4, 0), (0, 0)), material=ELASTIC),
            ball(position=(0.25, 2), velocity=(0, -1)),
        ],
        4.0,
    )
    n = np.array([0.5, math.sqrt(3) / 2])
    expected = np.array([0, -1]) + 2 * n[1] * n
    np.testing.assert_allclose(run.velocities[-1, 1], expected, rtol=ROUNDING)
    np.testing.assert_allclose(run.contacts.normal[0], n, rtol=ROUNDING)
    np.testing.assert_allclose(run.contacts.point[0], 0, atol=ROUNDING)


def test_ball_on_a_round_post_bounces_off_its_top() -> None:
    """Under gravity, from 5 m above, with e = 1/2: up again at half of 10 m/s."""
    post = Body(Circle(1.0), material=Material(0.5))
    run = exact([post, ball(position=(0, 6.5))], 1.25, gravity=10.0)
    assert run.contacts.time.tolist() == [1.0]
    assert run.velocities[-1, 1].tolist() == pytest.approx([0.0, 2.5])


def test_coincident_discs_that_meet_have_the_normal_along_x() -> None:
    """As everywhere in the workbook; then they part as any two discs."""
    run = exact([ball(), ball(velocity=(-1, 0), position=(1e-300, 0))], 1.0)
    assert np.isfinite(run.positions).all()
    assert run.momentum[-1].tolist() == [-1.0, 0.0]


def test_impulse_acts_on_the_later_body_of_a_pair() -> None:
    """In the order of the scene, whichever disc's event it was."""
    bodies = [ball(position=(2, 0), velocity=(-1, 0), mass=2.0), ball(velocity=(1, 0))]
    run = exact(bodies, 1.0)
    hit = run.contacts
    assert (hit.body_a.tolist(), hit.body_b.tolist()) == ([0], [1])
    assert hit.normal.tolist() == [[-1.0, 0.0]]
    assert hit.normal_impulse.tolist() == pytest.approx([2 * 2 * 2 / 3])
    assert hit.point.tolist() == [[pytest.approx(1.0), 0.0]]


def test_wall_that_comes_after_the_disc_in_the_scene_is_body_b() -> None:
    """Then the impulse is turned round: it is what the wall receives."""
    wall = Body(Segment((-5, 0), (5, 0)), material=ELASTIC)
    run = exact([ball(position=(0, 1), velocity=(0, -1)), wall], 1.0)
    assert (run.contacts.body_a.tolist(), run.contacts.body_b.tolist()) == ([0], [1])
    assert run.contacts.normal.tolist() == [[0.0, -1.0]]
    assert run.contacts.normal_impulse.tolist() == pytest.approx([2.0])


# Inelastic collapse


@pytest.mark.parametrize("restitution", [0.0, 0.05, 0.07])
def test_three_discs_below_the_threshold_collapse_into_one_motion(restitution: float) -> None:
    """With e < 7 - 4 sqrt(3) they collide infinitely often; the rule ends it, momentum is kept."""
    discs = [
        ball(position=(x, 0), velocity=(v, 0), material=Material(restitution))
        for x, v in ((0, 1), (1.1, 0), (2.2, 0))
    ]
    run = exact(discs, 10.0)
    assert 3 <= len(run.contacts) <= 100
    np.testing.assert_allclose(run.velocities[-1, :, 0], 1 / 3, atol=COLLAPSED)
    np.testing.assert_allclose(run.momentum[-1], [1, 0], atol=ROUNDING)
    np.testing.assert_allclose(np.diff(run.positions[-1, :, 0]), 1, atol=10 * COLLAPSED)
    assert run.max_penetration.max() <= ROUNDING


def test_three_discs_above_the_threshold_part_after_some_collisions() -> None:
    """With e = 0.08 they need ten, and leave in the order of their speeds."""
    discs = [
        ball(position=(x, 0), velocity=(v, 0), material=Material(0.08))
        for x, v in ((0, 1), (1.1, 0), (2.2, 0))
    ]
    run = exact(discs, 1000.0)
    speeds = run.velocities[-1, :, 0]
    assert len(run.contacts) == 10
    assert speeds[0] < speeds[1] < speeds[2]


def test_gas_that_loses_all_energy_in_each_impact_clusters_and_goes_on() -> None:
    """Sixteen discs with e = 0 between walls: series within series of impacts, all with an end."""
    rng = np.random.default_rng(1)
    material = Material(0.0)
    discs = [
        ball(position=(0.8 + 1.4 * (k % 4), 0.8 + 1.4 * (k // 4)), velocity=v, material=material)
        for k, v in enumerate(rng.uniform(-1, 1, (16, 2)))
    ]
    run = exact([*exact_scenes.box(6.0, 6.0, material), *discs], 5.0)
    assert (np.diff(run.energy) <= ROUNDING).all()
    assert run.max_penetration[-1] <= COLLAPSED
    assert run.energy[-1] < 0.5 * run.energy[0]


# Wedges


@pytest.mark.parametrize(
    ("left", "right"), [(math.pi / 4, math.pi / 4), (0.3, 1.0)], ids=["90 degrees", "uneven"]
)
@pytest.mark.parametrize(("restitution", "friction"), [(0.0, 0.5), (0.5, 0.0), (0.5, 0.3)])
def test_disc_that_falls_into_a_wedge_comes_to_rest_between_both_walls(
    left: float, right: float, restitution: float, friction: float
) -> None:
    """After infinitely many bounces, on one wall and on the other, in a finite time."""
    still = scenes.disc_in_wedge(left, right)
    walls, place = still.bodies[:2], still.bodies[2].position
    disc = Body(
        Circle(1.0),
        mass=1.0,
        position=(0.2, 4.0),
        angular_velocity=3.0,
        material=Material(restitution, friction),
    )
    solver = held(Scene([*walls, disc], (0, -10)), 60.0)
    state = solver.states(60.0)[2]
    assert solver.tables.discs[0].held
    assert state[:2] == pytest.approx(place, abs=1e-9)
    assert state[3:5].tolist() == [0.0, 0.0]
    assert solver.next_collision(1e9) is None


def test_disc_that_lies_in_a_wedge_stays_there() -> None:
    """From the start: it is laid down on both walls at once."""
    scene = scenes.disc_in_wedge(0.3, 1.0)
    solver = held(scene, 10.0)
    assert solver.tables.discs[0].held
    assert solver.states(10.0)[2][:2] == pytest.approx(scene.bodies[2].position, abs=ROUNDING)


def test_disc_that_is_held_is_knocked_off_by_another() -> None:
    """It is a disc like any other again."""
    wedge = scenes.disc_in_wedge(math.pi / 4, math.pi / 4)
    bullet = Body(Circle(0.5), mass=5.0, position=(-1, 8), velocity=(0, -20), material=ELASTIC)
    lying = Body(
        Circle(1.0), mass=1.0, position=wedge.bodies[2].position, material=Material(1.0, 0.0)
    )
    solver = held(Scene([*wedge.bodies[:2], lying, bullet], (0, -10)), 0.5)
    assert solver.states(0.5)[2][:2] != pytest.approx(lying.position, abs=0.1)


@pytest.mark.parametrize("height", [0.5, 0.5 + 1e-16, math.nextafter(0.5, 1)])
def test_elastic_ball_that_is_put_on_the_floor_rests(height: float) -> None:
    """Even where rounding has put it a last digit too high; else it would bounce for ever."""
    solver = held(Scene([Body(Segment((-5, 0), (5, 0))), ball(position=(0, height))], (0, -10)), 9)
    assert solver.collisions <= 2
    assert solver.tables.discs[0].support == 0
    assert solver.next_collision(1e9) is None


# Ends of a face


def test_disc_that_rolls_off_its_floor_falls_and_keeps_its_energy() -> None:
    """Fast, it leaves at once: past v^2 = g r nothing holds it to the corner."""
    floor = Body(Segment((-5, 0), (2, 0)))
    run = exact([floor, ball(position=(0, 0.5), velocity=(4, 0))], 2.0, gravity=10.0)
    assert run.positions[-1, 1, 0] == pytest.approx(8.0, abs=0.1)
    fall = 1.5
    assert run.positions[-1, 1, 1] == pytest.approx(0.5 - 5 * fall**2, rel=0.01)
    energy = run.energy[[0, -1]]
    assert energy[1] == pytest.approx(energy[0], rel=1e-4)


def test_disc_that_rolls_slowly_off_its_floor_turns_about_the_end() -> None:
    """It hops along the corner by less than a radius' ten-thousandth; then it falls."""
    floor = Body(Segment((-5, 0), (2, 0)))
    run = exact([floor, ball(position=(0, 0.5), velocity=(1, 0))], 3.0, gravity=10.0)
    assert run.positions[-1, 1, 1] < -1
    assert run.energy[-1] == pytest.approx(run.energy[0], rel=1e-3)
    assert run.max_penetration.max() <= ROUNDING


# Piles


def column(count: int, gap: float, restitution: float) -> Scene:
    """Return discs above each other, a gap below each."""
    material = Material(restitution)
    floor = Body(Segment((-5, 0), (5, 0)), material=material)
    discs = [ball(position=(0, 0.5 + k + gap * (k + 1)), material=material) for k in range(count)]
    return Scene([floor, *discs], (0, -10))


@pytest.mark.parametrize("gap", [0.0, 0.3])
def test_three_discs_on_each_other_stand_but_for_hops(gap: float) -> None:
    """The loop has an end: some thousand small hops a second, none of which can be seen."""
    solver = held(column(3, gap, 0.5), 2.0)
    heights = [state[1] for state in solver.states(2.0)[1:]]
    np.testing.assert_allclose(heights, [0.5, 1.5, 2.5], atol=3 * HOPPING)
    speeds = [abs(state[4]) for state in solver.states(2.0)[1:]]
    assert max(speeds) < 5 * HOP * math.sqrt(10 * 0.5)
    assert 1000 < solver.collisions < 50_000


def test_three_elastic_discs_on_each_other_bounce_for_ever() -> None:
    """Nothing is lost: the rules for piles do not touch e = 1."""
    run = simulate(column(3, 0.3, 1.0), 20.0, solver="exact")
    np.testing.assert_allclose(run.energy, run.energy[0], rtol=1e-10)
    assert len(run.contacts) > 100


def test_pile_of_very_different_masses_is_refused_and_says_what_to_do() -> None:
    """A heavy disc on a light one on a lighter one: stepping solves it, exact events do not."""
    discs = [ball(position=(0, 0.5 + k), mass=100.0**k, material=Material(0.0)) for k in range(3)]
    scene = Scene([Body(Segment((-5, 0), (5, 0))), *discs], (0, -10))
    with pytest.raises(RuntimeError, match='in a pile; solver="sequential" can hold it'):
        held(scene, 1.0)


def test_ball_that_drops_on_a_floor_that_moves_up_rests_on_it() -> None:
    """And rides on."""
    floor = Body(Segment((-5, 0), (5, 0)), velocity=(0, 0.3))
    run = exact([floor, ball(position=(0, 1), material=Material(0.0))], 5.0, gravity=10.0)
    assert run.positions[-1, 1].tolist() == pytest.approx([0.0, 2.0], abs=ROUNDING)
    assert run.velocities[-1, 1].tolist() == [0.0, 0.3]


def test_bouncing_ball_of_this_file_is_the_one_of_the_notebook() -> None:
    """A face holds what bounces slower than rounding, not sooner: 138 bounces at e = 0.8."""
    assert 100 < held(exact_scenes.bouncing_to_rest(0.8), 10.0).collisions < 200
