"""Continuous detection: nothing passes through anything, and slow scenes are left alone."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.constants import MOST_IMPACTS, SLOP
from lesson_code.engine.effects import continuous
from lesson_code.engine.effects.continuous import fastest_way

BALL = Material(1.0, 0.0)

SOLVERS = ["sequential", "substep"]

SPEEDS = [1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6]
"""m/s; at 1/60 s the fastest moves by 17 km in a step."""


def ball(radius: float, **state: Any) -> Body:
    """Return an elastic, smooth ball of 1 kg."""
    return Body(Circle(radius), mass=1.0, material=BALL, **state)


def room(half: float = 1.0) -> list[Body]:
    """Return four walls without thickness."""
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    return [Body(Segment(a, b)) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("speed", SPEEDS)
@pytest.mark.parametrize("thickness", [0.001, 0.03, 1.0])
@pytest.mark.parametrize("radius", [0.001, 0.1])
def test_ball_never_passes_through_a_wall(
    speed: float, thickness: float, radius: float, solver: str
) -> None:
    """From 1 to 1e6 m/s, walls from 1 mm to 1 m, several places in the step: it always bounces."""
    rng = np.random.default_rng(seed=1)
    for _ in range(3):
        thrown = ball(
            radius,
            position=(-1 - rng.uniform(0, 0.5), rng.uniform(-0.5, 0.5)),
            velocity=(speed, speed * rng.uniform(-0.2, 0.2)),
        )
        scene = Scene([Body(Polygon.box(thickness, 4)), thrown])
        run = simulate(scene, 2.5 / speed + 0.05, sample="end", solver=solver)
        assert run.positions[-1, 1, 0] < 0
        assert run.velocities[-1, 1, 0] == pytest.approx(-speed, rel=1e-9)


@pytest.mark.parametrize("solver", [*SOLVERS, "direct"])
@pytest.mark.parametrize("overlap", [1e-9, 1e-6, 1e-3])
@pytest.mark.parametrize("speed", [20.0, 1e4])
def test_fast_ball_that_overlaps_already_is_sent_back(
    speed: float, overlap: float, solver: str
) -> None:
    """It begins in the brick by a little and would be behind it after the first step."""
    brick = Body(Polygon.box(0.74, 0.24), material=BALL)
    thrown = ball(0.12, position=(0.0, overlap - 0.24), velocity=(0.0, speed))
    run = simulate(Scene([brick, thrown]), 0.1, solver=solver)
    assert run.velocities[-1, 1, 1] == pytest.approx(-speed)
    assert run.positions[1:, 1, 1].max() < -0.24 + overlap


def test_fast_ball_that_rolls_on_a_floor_is_not_stopped_by_it() -> None:
    """It overlaps the floor in every step, but does not move into it: no step is split."""
    floor = Body(Segment((-10.0, 0.0), (1000.0, 0.0)), material=BALL)
    rolling = ball(0.1, position=(0.0, 0.0995), velocity=(100.0, 0.0))
    run = simulate(Scene([floor, rolling], gravity=(0.0, -10.0)), 1.0, solver="sequential")
    assert run.positions[-1, 1, 0] == pytest.approx(100.0)


def test_pymunks_ball_passes_through_a_thin_wall() -> None:
    """The same throw at 100 m/s: pymunk looks every 1.7 m."""
    scene = Scene([Body(Polygon.box(0.03, 4)), ball(0.1, position=(-1.2, 0), velocity=(100, 0))])
    assert simulate(scene, 0.1, solver="pymunk").positions[-1, 1, 0] > 0
    assert simulate(scene, 0.1, solver="sequential").positions[-1, 1, 0] < 0


LATE = "steps there were more than 64 impacts"


@pytest.mark.filterwarnings(f"ignore:.*{LATE}:RuntimeWarning")
@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("speed", [10.0, 1e3, 1e6])
def test_ball_stays_in_its_room_with_its_energy(speed: float, solver: str) -> None:
    """Several impacts in one step, and more than the limit: it never leaves the room."""
    scene = Scene([*room(), ball(0.05, velocity=(speed, 0.7 * speed))])
    run = simulate(scene, 0.5, solver=solver)
    assert np.abs(run.positions[:, 4]).max() <= 0.95 + SLOP * 0.1
    assert run.kinetic_energy == pytest.approx(run.kinetic_energy[0], rel=1e-12)


@pytest.mark.parametrize("solver", [*SOLVERS, "direct"])
def test_run_warns_where_bodies_had_to_wait(solver: str) -> None:
    """Else nobody would know that time stood still for them; the line is the caller's."""
    box = Body(Polygon.box(0.1, 0.1), mass=1.0, material=BALL, velocity=(2e3, 0))
    with pytest.warns(RuntimeWarning, match=f"in 6 of 6 {LATE}") as told:
        simulate(Scene([*room(0.2), box]), 0.1, solver=solver)
    assert [one.filename for one in told] == [__file__]


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("seed", range(share(6)))
def test_planks_that_fall_beside_one_another_come_to_lie_or_stand(seed: int, solver: str) -> None:
    """A tip that rubs along the floor holds nobody up in the air, or askew.

    In one scene of eight a plank comes to stand, by all solvers once the steps are small. It is
    then no further from upright than where it would tip over.
    """
    rng = np.random.default_rng(seed)
    thickness, rough = 10 ** rng.uniform(-1.7, -1), Material(0.0, rng.uniform(0.3, 1.0))
    planks = [
        Body(
            Polygon.box(1, thickness),
            mass=1.0,
            material=rough,
            position=(5.0 * n, rng.uniform(1, 3)),
            angle=rng.uniform(0, math.pi),
            velocity=(rng.uniform(-1, 1), 0),
            angular_velocity=rng.uniform(-3, 3),
        )
        for n in range(25)
    ]
    floor = Body(Segment((-500, 0), (500, 0)), material=rough)
    run = simulate(Scene([floor, *planks], gravity=(0, -9.81)), 4.0, solver=solver)
    heights, angles = run.positions[-1, 1:, 1], run.angles[-1, 1:]
    across, up = np.abs(np.cos(angles)), np.abs(np.sin(angles))
    assert heights == pytest.approx((up + thickness * across) / 2, abs=0.05 * thickness)
    assert np.all((up < 0.05 * thickness) | (across < math.sin(math.atan(thickness))))
    assert run.energy.max() < 1.02 * run.energy[0]


@pytest.mark.parametrize("seed", range(share(60)))
def test_nobody_passes_a_ceiling_from_which_gravity_draws_it_back(seed: int) -> None:
    """In a part of a step that is cut short it rises faster than was foreseen for the whole."""
    rng = np.random.default_rng(seed)
    rod, box = Segment((-0.5, 0), (0.5, 0), radius=0.025), Polygon.box(1, 0.2)
    speed, spin = (60 * 10 ** rng.uniform(-1, most) for most in (1, 1.5))
    thrown = Body(
        (rod, box, Polygon.regular(5, 0.5))[seed % 3],
        mass=1.0,
        material=Material(rng.uniform(0, 1)),
        position=(0, -0.8 - rng.uniform(0, speed / 60)),
        angle=rng.uniform(0, 6),
        velocity=(0, speed),
        angular_velocity=spin,
    )
    ceiling = Body(Segment((-1e4, 0), (1e4, 0)), material=Material(1.0))
    gravity = speed * 10 ** rng.uniform(0, 1.8)
    run = simulate(Scene([ceiling, thrown], gravity=(0, -gravity)), 0.1)
    assert run.positions[:, 1, 1].max() < 0.0


def test_step_is_finished_after_the_impact() -> None:
    """The ball is back where a step without a stop at the wall would have brought it."""
    scene = Scene([*room(), ball(0.05, position=(0, 0.3), velocity=(40, 0))])
    run = simulate(scene, 1 / 60, solver="sequential")
    way = 40 / 60  # to 0.667 m: no impact in this step
    assert run.positions[-1, 4, 0] == pytest.approx(way)
    run = simulate(scene, 2 / 60, solver="sequential")
    back = 2 * 0.95 - 2 * way
    assert run.positions[-1, 4, 0] == pytest.approx(back, abs=2 * SLOP * 0.1)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("spin", [2.0, 10.0, 40.0, 200.0])
def test_turning_rod_misses_no_ball(spin: float, solver: str) -> None:
    """A thin rod sweeps over a ball: at every speed of turning it hits."""
    rod = Body(Segment((-2, 0), (2, 0)), angular_velocity=spin, mass=100.0)
    for place in np.arange(0.3, 1.4, 0.11).tolist():
        target = ball(0.1, position=(1.5 * math.cos(place), 1.5 * math.sin(place)))
        run = simulate(Scene([rod, target]), math.pi / spin + 0.05, solver=solver)
        assert len(run.contacts) > 0


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("speed", [100.0, 1e4, 1e6])
def test_fast_ball_misses_no_moving_plate(speed: float, solver: str) -> None:
    """Both can be pushed, and momentum is kept."""
    plate = Body(Polygon.box(0.01, 1), mass=1.0, velocity=(-3, 0), material=BALL)
    for start in (-1.0, -1.37, -1.74):
        run = simulate(
            Scene([plate, ball(0.01, position=(start, 0), velocity=(speed, 0))]), 0.1, solver=solver
        )
        assert len(run.contacts) > 0
        assert run.momentum[-1] == pytest.approx(run.momentum[0], rel=1e-12)


def test_fast_wall_sweeps_up_a_slow_ball() -> None:
    """What matters is how fast the two approach, not which of them is fast."""
    wall = Body(Segment((0, -1), (0, 1)), velocity=(300, 0))
    run = simulate(Scene([wall, ball(0.1, position=(7, 0))]), 0.1, solver="sequential")
    assert run.velocities[-1, 1, 0] == pytest.approx(600)


def test_slow_scene_is_never_split(monkeypatch: pytest.MonkeyPatch) -> None:
    """Below half of a width in a step no impact time is ever computed."""

    def never(*arguments: object) -> float:
        raise AssertionError("an impact time was computed")

    monkeypatch.setattr(continuous, "time_to_impact", never)
    run = simulate(Scene([*room(), ball(0.1, velocity=(5.9, 0))]), 1.0, solver="sequential")
    assert len(run.contacts) > 0


@pytest.mark.filterwarnings(f"ignore:.*{LATE}:RuntimeWarning")
def test_fast_body_waits_after_many_impacts_in_one_step() -> None:
    """It loses time, but neither speed nor its place in the room."""
    scene = Scene([*room(), ball(0.05, velocity=(1e6, 0))])
    run = simulate(scene, 1 / 60, solver="sequential")
    assert len(run.contacts) == MOST_IMPACTS
    assert abs(run.velocities[-1, 4, 0]) == pytest.approx(1e6)


def impacts_of(run: Run) -> list[float]:
    """Return the times of a run's impulses, s."""
    times: list[float] = run.contacts.time.tolist()
    return times


def test_impact_is_written_down_at_its_own_time() -> None:
    """Not at the end of the step, but when it happened, up to the slop."""
    scene = Scene([*room(), ball(0.05, velocity=(100, 0))])
    first = impacts_of(simulate(scene, 1 / 60, solver="sequential"))[0]
    assert first == pytest.approx(0.95 / 100, abs=SLOP * 0.1 / 100)


@pytest.mark.parametrize("solver", SOLVERS)
def test_resting_bodies_stay_at_rest_while_a_step_is_split(solver: str) -> None:
    """Remembered impulses are scaled to the length of the part: a stack does not jump."""
    stack = [Body(Polygon.box(1, 1), position=(3, -4.5 + n), mass=1.0) for n in range(3)]
    scene = Scene([*room(5.0), *stack], gravity=(0, -10))
    fast = ball(0.05, position=(-2, 3), velocity=(0, 500))
    calm = simulate(scene, 3.0, solver=solver)
    shaken = simulate(Scene([*scene.bodies, fast], gravity=(0, -10)), 3.0, solver=solver)
    assert np.abs(calm.velocities[-1, 4:7]).max() < 1e-9
    assert shaken.positions[-1, 4:7] == pytest.approx(calm.positions[-1, 4:7], abs=1e-2)


# The greatest speed

ROUNDING = 1e-12
"""Relative: sums of a few squares and a root."""

SLOWEST_LOSS = 1e-9
"""Relative: what rounding may add to the greatest speed of a run."""


def disc(x: float = 0.0, **rest: Any) -> Body:
    """Return a disc of 1 kg and radius 1/2 m."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, 0.0)}
    return Body(Circle(0.5), **(given | rest))


def test_fastest_way_gives_all_energy_to_the_lightest_body() -> None:
    """By hand: 1/2 (4)(3^2) = 18 J make 6 m/s of 1 kg."""
    bodies = disc(0, mass=4.0, velocity=(0, 3)), disc(9, mass=1.0)
    way, room = fastest_way(Scene(bodies), 0.1)
    assert way == pytest.approx(0.6, rel=ROUNDING)
    assert room == 0.5


def test_fastest_way_of_a_body_with_corners_is_that_of_its_farthest_point() -> None:
    """By hand: a rod of 12 kg and 2 m, I = 4; 6 J: v^2 = 2 E (1/m + r^2/I) = 12 (1/12 + 1/4)."""
    rod = Body(Segment((-1, 0), (1, 0)), mass=12.0, inertia=4.0, velocity=(1, 0))
    way, room = fastest_way(Scene([rod]), 1.0)
    assert way == pytest.approx(2.0, rel=ROUNDING)
    assert room == 0.0  # a line has no width: it is always watched


def test_fastest_way_leaves_out_bodies_that_cannot_be_pushed() -> None:
    """They have no energy to give, and their width does not matter."""
    alone = fastest_way(Scene([disc(velocity=(2, 0))]), 0.1)
    wall = Body(Segment((-9, 0), (9, 0)))
    assert fastest_way(Scene([disc(velocity=(2, 0)), wall]), 0.1) == alone
    assert fastest_way(Scene([wall]), 0.1) == (0.0, math.inf)


def test_fastest_way_of_a_body_that_never_turns_has_no_energy_of_spin() -> None:
    """With an infinite inertia a spin would have an infinite energy; it is no number."""
    stiff = disc(inertia=math.inf, velocity=(3, 0))
    assert fastest_way(Scene([stiff]), 1.0)[0] == pytest.approx(3.0, rel=ROUNDING)


@settings(max_examples=share(40), phases=[Phase.explicit, Phase.generate])
@given(st.integers(0, 10**9))
def test_no_body_is_ever_faster_than_the_bound(seed: int) -> None:
    """Discs with e = 1 that hit each other for a second, of masses up to 100 to 1."""
    rng = np.random.default_rng(seed)
    discs = [
        Body(
            Circle(0.5),
            mass=10.0 ** rng.uniform(-1, 1),
            position=(1.2 * n, 0.0),
            velocity=(rng.uniform(-3, 3), rng.uniform(-3, 3)),
        )
        for n in range(5)
    ]
    scene = Scene(discs)
    run = simulate(scene, 1.0, solver="sequential", combine="workbook")
    fastest = float(np.max(np.linalg.norm(run.velocities, axis=2)))
    assert fastest <= fastest_way(scene, 1.0)[0] * (1 + SLOWEST_LOSS)
