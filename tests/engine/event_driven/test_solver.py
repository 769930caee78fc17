"""The event-driven solver as a whole: what it refuses, odd scenes, order and cost of events."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Callbacks, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver, event_prediction, why_not
from lesson_code.evidence.scenes.discs import rack_break
from lesson_code.evidence.scenes.gas import disc_gas

ROUNDING = 1e-12
"""A handful of impacts, each right to 1e-16 of numbers near 1."""

SAME_WORK = 0.2
"""How far the work for a collision may differ between 100 and 4,000 discs."""

ELASTIC = Material(1.0)
DISC = Circle(0.5)


def ball(**values: Any) -> Body:
    """Return an elastic ball of 1 kg."""
    return Body(DISC, **({"mass": 1.0, "material": ELASTIC} | values))


def solver_of(*bodies: Body, **settings: Any) -> ExactSolver:
    """Return a solver at work on some bodies."""
    return ExactSolver(Scene(bodies, **settings), combine=mixing_rule("workbook"))


# Scenes that it cannot take

REFUSED: dict[str, tuple[Scene, str]] = {
    "dynamic polygon": (
        Scene([ball(), Body(Polygon.box(1, 1), mass=1.0)]),
        "body 1 can be pushed and is no circle",
    ),
    "dynamic rod": (
        Scene([Body(Segment((-1, 0), (1, 0)), mass=1.0)]),
        "body 0 can be pushed and is no circle",
    ),
    "damping": (Scene([ball()], damping=0.1), "damping has no closed form here"),
    "callbacks": (Scene([ball()], callbacks=Callbacks(begin=print)), "it calls no callbacks"),
    "turning wall": (
        Scene([ball(), Body(Polygon.box(1, 1), angular_velocity=1.0)]),
        "body 1 is static and turns",
    ),
}


@pytest.mark.parametrize(("scene", "reason"), REFUSED.values(), ids=REFUSED)
def test_scene_that_the_solver_cannot_take_is_refused_by_name(scene: Scene, reason: str) -> None:
    """It says which body, and why."""
    assert why_not(scene) == reason
    with pytest.raises(ValueError, match=f"exact solver cannot take this scene: {reason}"):
        simulate(scene, 1.0, solver="exact")


def test_scene_of_discs_walls_and_gravity_is_taken() -> None:
    """Walls may move, not turn."""
    wall = Body(Segment((0, -5), (0, 5)), velocity=(1, 0))
    assert why_not(Scene([wall, ball(), Body(Polygon.box(1, 1))], gravity=(0, -10))) == ""


# Odd scenes


def left_alone() -> Iterator[Any]:
    """Yield scenes in which nothing ever happens, with names."""
    scenes: dict[str, tuple[Body, ...]] = {
        "no body": (),
        "no disc": (Body(Segment((0, 0), (1, 0))), Body(DISC)),
        "one disc": (ball(velocity=(1, 2)),),
        "zero velocity": (ball(), ball(position=(3, 0))),
        "touching, zero velocity": (ball(), ball(position=(1, 0))),
        "touching, equal velocities": (
            ball(velocity=(1, 0)),
            ball(position=(1, 0), velocity=(1, 0)),
        ),
        "equal velocities": (ball(velocity=(1, 1)), ball(position=(2, 0), velocity=(1, 1))),
        "touching and parting": (ball(velocity=(-1, 0)), ball(position=(1, 0), velocity=(1, 0))),
        "overlapping and parting": (
            ball(velocity=(-1, 0)),
            ball(position=(0.5, 0), velocity=(1, 0)),
        ),
        "grazing": (ball(velocity=(1, 0)), ball(position=(3, 1))),
        "grazing a wall": (
            Body(Segment((-9, 0), (9, 0))),
            ball(position=(0, 0.5), velocity=(1, 0)),
        ),
        "coincident": (ball(), ball()),
        "coincident and parting": (ball(velocity=(1, 0)), ball(velocity=(-1, 0))),
        "fifty in one place": (ball(),) * 50,
        "flying apart": tuple(
            ball(position=(2 * math.cos(k), 2 * math.sin(k)), velocity=(math.cos(k), math.sin(k)))
            for k in range(6)
        ),
    }
    for name, bodies in scenes.items():
        yield pytest.param(bodies, id=name)


@pytest.mark.parametrize("bodies", list(left_alone()))
def test_bodies_that_never_meet_fly_on_for_ever(bodies: tuple[Body, ...]) -> None:
    """A billion seconds at once: straight on, no impulse, no nan, no endless loop."""
    run = simulate(Scene(bodies), 1e9, solver="exact")
    assert run.times.tolist() == [0.0, 1e9]
    assert len(run.contacts) == 0
    assert run.velocities[1].tolist() == run.velocities[0].tolist()
    expected = run.positions[0] + 1e9 * run.velocities[0]
    assert run.positions[1].tolist() == expected.tolist()


def test_touching_discs_that_approach_collide_at_once() -> None:
    """At time 0, once: they swap their velocities."""
    run = simulate(
        Scene([ball(velocity=(1, 0)), ball(position=(1, 0), velocity=(-1, 0))]), 1.0, solver="exact"
    )
    assert run.contacts.time.tolist() == [0.0]
    assert run.velocities[-1].tolist() == [[-1.0, 0.0], [1.0, 0.0]]


def test_overlapping_discs_that_approach_collide_at_once() -> None:
    """An overlap that closes is an event now, not a past one."""
    run = simulate(
        Scene([ball(velocity=(1, 0)), ball(position=(0.5, 0), velocity=(-1, 0))]),
        1.0,
        solver="exact",
    )
    assert run.contacts.time.tolist() == [0.0]
    assert run.velocities[-1].tolist() == [[-1.0, 0.0], [1.0, 0.0]]


@pytest.mark.parametrize("shift", [-1e-9, 1e-9], ids=["just hit", "just missed"])
def test_discs_beside_a_grazing_hit_are_told_apart(shift: float) -> None:
    """A billionth of a metre to either side."""
    run = simulate(
        Scene([ball(velocity=(1, 0)), ball(position=(3, 1 + shift))]), 9.0, solver="exact"
    )
    assert len(run.contacts) == (shift < 0)
    assert np.isfinite(run.velocities).all()


@pytest.mark.parametrize("bodies", [(), (ball(velocity=(1, 0)),)], ids=["empty", "one disc"])
def test_run_of_no_time_has_one_frame(bodies: tuple[Body, ...]) -> None:
    """Where everything begins."""
    run = simulate(Scene(bodies), 0.0, solver="exact")
    assert run.times.tolist() == [0.0]
    assert run.positions.shape == (1, len(bodies), 2)


def test_static_bodies_that_overlap_leave_each_other_alone() -> None:
    """Walls that cross are how a corner is built."""
    walls = [Body(Segment((-5, 0), (5, 0))), Body(Segment((0, -5), (0, 5))), Body(DISC)]
    run = simulate(Scene(walls, gravity=(0, -10)), 1.0, solver="exact")
    assert len(run.contacts) == 0
    assert not run.positions.any()


EXTREMES: dict[str, tuple[Body, ...]] = {
    "1e150 m/s": (ball(velocity=(1e150, 0)), ball(position=(3, 0))),
    "1e300 kg on 1e-300 kg": (
        ball(mass=1e300, velocity=(1, 0)),
        ball(mass=1e-300, position=(3, 0)),
    ),
    "1e12 m away": (ball(position=(1e12, 0), velocity=(1, 0)), ball(position=(1e12 + 3, 0))),
    "1e-9 m small": (
        Body(Circle(1e-9), mass=1e-9, velocity=(1e-9, 0), material=ELASTIC),
        Body(Circle(1e-9), mass=1e-9, position=(4e-9, 0), material=ELASTIC),
    ),
}


@pytest.mark.parametrize("bodies", EXTREMES.values(), ids=EXTREMES)
def test_extreme_bodies_meet_once(bodies: tuple[Body, ...]) -> None:
    """Numbers, and never nan."""
    run = simulate(Scene(bodies), 10.0, solver="exact")
    assert np.isfinite(run.velocities).all()
    assert len(run.contacts) == 1


@pytest.mark.parametrize("speed", [1.0, 1e3, 1e6])
@pytest.mark.parametrize("thickness", [0.001, 1.0])
def test_ball_of_any_speed_is_stopped_by_a_wall_of_any_thickness(
    speed: float, thickness: float
) -> None:
    """There is no step to jump over it with."""
    wall = Body(Segment((0, -5), (0, 5), radius=thickness / 2), material=ELASTIC)
    run = simulate(
        Scene([wall, ball(position=(-100, 0), velocity=(speed, 0))]), 200 / speed, solver="exact"
    )
    assert run.contacts.time.tolist() == pytest.approx([(99.5 - thickness / 2) / speed])
    assert run.velocities[-1, 1].tolist() == [-speed, 0.0]


# Order of events


def test_events_at_the_same_time_happen_in_the_order_of_the_scene() -> None:
    """Two pairs that meet at 0.5 s: the one of the earlier disc first."""
    pairs = [ball(position=(x, y), velocity=(v, 0)) for y in (0, 5) for x, v in ((-1, 1), (1, -1))]
    run = simulate(Scene(pairs), 1.0, solver="exact")
    assert run.contacts.time.tolist() == [0.5, 0.5]
    assert run.contacts.body_a.tolist() == [0, 2]
    turned = simulate(Scene(pairs[2:] + pairs[:2]), 1.0, solver="exact")
    assert turned.positions[-1].tolist() == run.positions[-1, [2, 3, 0, 1]].tolist()


def test_break_shot_is_the_same_in_every_bit_when_it_is_run_again() -> None:
    """15 balls in a rack that touch almost at the same time."""
    scene = rack_break(0.95)
    first, second = (simulate(scene, 3.0, solver="exact") for _ in range(2))
    assert len(first.contacts) > 20
    assert first.positions.tobytes() == second.positions.tobytes()
    assert first.contacts.time.tobytes() == second.contacts.time.tobytes()


def test_ball_between_two_hits_them_one_after_the_other_in_the_scenes_order() -> None:
    """A cue ball that touches two at once: two events at one time, the earlier disc first."""
    height = math.sqrt(3) / 2
    cue = ball(position=(-3, 0), velocity=(1, 0))
    two = [ball(position=(height, y), velocity=(0, 0)) for y in (0.5, -0.5)]
    run = simulate(Scene([cue, *two]), 10.0, solver="exact")
    np.testing.assert_allclose(run.contacts.time[:2], 3.0, rtol=ROUNDING)
    np.testing.assert_allclose(run.momentum[-1], [1, 0], atol=ROUNDING)
    assert run.kinetic_energy[-1] == pytest.approx(0.5, rel=ROUNDING)
    assert run.contacts.body_b[0] == 1


def test_first_partner_is_the_first_disc_of_several_at_one_time() -> None:
    """However the grid happens to hold them: order is a rule, not an accident."""
    height = math.sqrt(3) / 2
    for sign in (1, -1):
        two = [ball(position=(height, sign * y)) for y in (0.5, -0.5)]
        solver = solver_of(*two, ball(position=(-3, 0), velocity=(1, 0)))
        assert solver.tables.discs[2].partner == 0


# Cost


def work_per_collision(side: int, monkeypatch: pytest.MonkeyPatch) -> float:
    """Return how many pairs of discs are looked at for a collision, in a gas of side^2 discs."""
    calls = 0
    look = event_prediction.hit_time

    def counting(*arguments: Any) -> float:
        nonlocal calls
        calls += 1
        return look(*arguments)

    solver = ExactSolver(
        disc_gas(side, 0.3, seed=1), combine=mixing_rule("workbook"), keep_impulses=False
    )
    wanted = 2 * side * side
    while solver.collisions < wanted // 2:  # the rows and columns of the start are gone
        solver.next_collision(math.inf)
    with monkeypatch.context() as patch:
        patch.setattr(event_prediction, "hit_time", counting)
        while solver.collisions < wanted:
            solver.next_collision(math.inf)
    return calls / (wanted - wanted // 2)


def test_work_for_a_collision_does_not_grow_with_the_number_of_discs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Pairs looked at for each collision, counted: the same for 100, 1,024 and 4,096 discs."""
    work = [work_per_collision(side, monkeypatch) for side in (10, 32, 64)]
    assert max(work) <= (1 + SAME_WORK) * min(work)


def test_collisions_and_impulses_are_counted_alike() -> None:
    """A gas in which every collision has an impulse; they need not be kept."""
    scene = disc_gas(4, 0.3, seed=1)
    kept = ExactSolver(scene, combine=mixing_rule("workbook"))
    other = ExactSolver(scene, combine=mixing_rule("workbook"), keep_impulses=False)
    for solver in (kept, other):
        solver.advance(5.0)
    assert len(kept.events()) == kept.collisions == other.collisions > 20
    assert len(other.events()) == 0
    assert kept.states(5.0).tolist() == other.states(5.0).tolist()


@pytest.mark.parametrize("count", [3, 2500], ids=["few times", "more than are noted at once"])
def test_obstacles_are_where_they_stand_and_move_at_any_given_times(count: int) -> None:
    """A post off the origin, a turned block and a wall that moves, while a disc bounces."""
    post = Body(Circle(0.4), position=(2.0, 1.5), angle=0.7, material=ELASTIC)
    block = Body(Polygon.box(1, 1), position=(-3.0, 0.2), angle=0.3, material=ELASTIC)
    wall = Body(Segment((5, -9), (5, 9)), velocity=(0.25, 0.0), material=ELASTIC)
    disc = Body(Circle(0.3), mass=1.0, velocity=(1.0, 0.8), material=ELASTIC)
    times = np.linspace(0.0, 2.0, count)
    run = simulate(Scene([post, block, disc, wall]), 2.0, solver="exact", sample=times)
    np.testing.assert_array_equal(run.positions[:, 0], np.tile((2.0, 1.5), (count, 1)))
    np.testing.assert_array_equal(run.positions[:, 1], np.tile((-3.0, 0.2), (count, 1)))
    np.testing.assert_array_equal(run.angles[:, :2], np.tile((0.7, 0.3), (count, 1)))
    np.testing.assert_array_equal(run.positions[:, 3, 0], 0.25 * times)
    np.testing.assert_array_equal(run.velocities[:, 3], np.tile((0.25, 0.0), (count, 1)))
    assert run.max_penetration.max() < ROUNDING
