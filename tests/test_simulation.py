"""The door to every solver: its arguments, and what it makes of scenes that are not right."""

from __future__ import annotations

import copy
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from lesson_code import (
    Body,
    Callbacks,
    Circle,
    Material,
    MixingRule,
    Polygon,
    Run,
    Scene,
    Segment,
    simulate,
)
from lesson_code.simulation import NAMES

ROUNDING = 1e-14
"""m/s: one impact, a dozen operations."""

OURS = ("sequential", "substep", "naive")
STEPPERS = ("auto", *OURS, "pymunk")
DOUBLE = tuple(name for name in NAMES if name != "box2d")
"""The solvers that work in double precision, and are always there."""

DISC = Circle(0.5)


def head_on() -> Scene:
    """Return 1 kg at 2 m/s and 3 kg at -1 m/s, e = 0.7, half a metre apart."""
    rows = ((1, -0.75, 2), (3, 0.75, -1))
    return Scene(
        [
            Body(DISC, mass=m, position=(x, 0), velocity=(v, 0), material=Material(0.7))
            for m, x, v in rows
        ]
    )


def floor_and_ball(**ball: Any) -> Scene:
    """Return a floor, and a ball of 1 kg above it."""
    body = Body(DISC, **({"mass": 1.0, "position": (0, 2)} | ball))
    return Scene([Body(Segment((-9, 0), (9, 0))), body], gravity=(0, -9.81))


def is_finite(run: Run) -> bool:
    """Return whether a run holds only numbers."""
    arrays = run.positions, run.velocities, run.angles, run.angular_velocities
    impulses = run.contacts.point, run.contacts.normal_impulse, run.contacts.tangent_impulse
    return all(np.isfinite(array).all() for array in (*arrays, *impulses))


# The solvers


@pytest.mark.parametrize("solver", DOUBLE)
def test_impact_worked_by_hand_is_found_by_every_solver(solver: str) -> None:
    """-1.825 and 0.275 m/s, from momentum and Newton's rule."""
    run = simulate(head_on(), 1.0, solver=solver)
    np.testing.assert_allclose(run.velocities[-1, :, 0], [-1.825, 0.275], rtol=ROUNDING)
    assert run.contacts.normal_impulse.tolist() == pytest.approx([3.825])
    assert (run.contacts.body_a.tolist(), run.contacts.body_b.tolist()) == ([0], [1])


@pytest.mark.parametrize("solver", STEPPERS)
def test_run_of_every_stepper_has_a_frame_for_each_step(solver: str) -> None:
    """One kind of Run, whoever made it."""
    run = simulate(head_on(), 0.5, solver=solver, dt=0.125)
    assert run.times.tolist() == [0, 0.125, 0.25, 0.375, 0.5]
    assert run.positions.shape == (5, 2, 2)
    assert run.scene.bodies[1].mass == 3.0


def test_run_of_the_exact_solver_has_a_frame_for_each_collision() -> None:
    """They meet after 1/6 s: half a metre at 3 m/s. It makes no steps."""
    run = simulate(head_on(), 0.5, solver="exact", dt=0.125)
    assert run.times.tolist() == [0.0, pytest.approx(1 / 6), 0.5]
    assert run.positions.shape == (3, 2, 2)


@pytest.mark.parametrize("solver", DOUBLE)
def test_run_of_every_solver_has_the_frames_that_are_asked_for(solver: str) -> None:
    """Times between two steps or collisions are as good as any."""
    run = simulate(head_on(), 0.5, solver=solver, sample=[0.1, 0.4, 0.5])
    assert run.times.tolist() == [0.1, 0.4, 0.5]
    np.testing.assert_allclose(run.positions[0, :, 0], [-0.55, 0.65], rtol=ROUNDING)


def test_plan_says_which_solver_ran_and_why() -> None:
    """What "auto" chose, or what was asked for."""
    plans = {
        "auto": "direct (few bodies: all contacts are solved at once); plain Python (a small run)",
        "naive": "naive (asked for); plain Python (a small run)",
        "substep": "substep (asked for); plain Python (a small run)",
        "exact": "exact (asked for); plain Python (a small run)",
        "pymunk": "pymunk (asked for); C (pymunk's own)",
    }
    for solver, plan in plans.items():
        assert simulate(Scene(), 0, solver=solver).plan.headline == f"solver: {plan}"


def test_settings_that_are_exact_numbers_are_taken() -> None:
    """Fractions and NumPy's numbers are numbers."""
    plain = simulate(head_on(), 1.0, dt=1 / 64, iterations=8)
    other = simulate(head_on(), Fraction(1), dt=np.float64(1 / 64), iterations=np.int64(8))
    np.testing.assert_array_equal(other.positions, plain.positions)


def test_more_iterations_come_nearer() -> None:
    """Two balls pressed between a wall and a third: the rest that is left shrinks with sweeps."""
    rows = ((None, 0, 0), (1, 0.99, 0), (1, 1.98, 0), (1, 2.97, -1))
    bodies = [Body(DISC, mass=m, position=(x, 0), velocity=(v, 0)) for m, x, v in rows]
    speeds = [
        np.abs(simulate(Scene(bodies), 0.01, dt=0.01, iterations=n).velocities[-1]).max()
        for n in (1, 5, 20, 100)
    ]
    assert speeds == sorted(speeds, reverse=True)
    assert speeds[-1] < 1e-6 < speeds[0]


# Arguments

WRONG_VALUES: list[tuple[dict[str, Any], str]] = [
    ({"duration": -1}, "duration must be >= 0 and finite, got -1"),
    ({"duration": math.nan}, "duration must be >= 0 and finite, got nan"),
    ({"duration": math.inf}, "duration must be >= 0 and finite, got inf"),
    ({"duration": [1, 2]}, r"duration must be one number, got shape \(2,\)"),
    ({"dt": 0}, "dt must be > 0 and finite, got 0"),
    ({"dt": -0.1}, "dt must be > 0 and finite, got -0.1"),
    ({"dt": math.nan}, "dt must be > 0 and finite, got nan"),
    ({"dt": math.inf}, "dt must be > 0 and finite, got inf"),
    ({"iterations": 0}, "iterations must be > 0 and finite, got 0"),
    ({"iterations": -3}, "iterations must be > 0 and finite, got -3"),
    ({"iterations": 1.5}, "iterations must be a whole number, got 1.5"),
    ({"iterations": math.nan}, "iterations must be > 0 and finite, got nan"),
    ({"iterations": math.inf}, "iterations must be > 0 and finite, got inf"),
    ({"substeps": 0}, "substeps must be > 0 and finite, got 0"),
    ({"substeps": 2.5}, "substeps must be a whole number, got 2.5"),
    (
        {"solver": "fast"},
        "solver must be one of auto, direct, exact, naive, sequential, substep, box2d, pymunk, got "
        "'fast'",
    ),
    ({"solver": None}, "solver must be one of .*, sequential, substep, box2d, pymunk, got None"),
    ({"impacts": "both"}, "impacts must be one of simultaneous, sequential, got 'both'"),
    ({"impacts": "sequential"}, "impacts must be 'simultaneous' unless solver is 'direct', got"),
    ({"restitution_law": "poisson"}, "restitution_law must be one of energetic, newton, got 'poi"),
    ({"restitution_law": "energetic"}, "restitution_law must be 'newton' unless solver is 'direc"),
    ({"combine": "bullet"}, "combine must be one of workbook, pymunk, box2d or a MixingRule"),
    ({"combine": None}, "combine must be one of workbook, pymunk, box2d or a MixingRule"),
    ({"combine": ["min", "max"]}, "combine must be one of workbook, pymunk, box2d or a Mixing"),
    ({"sample": "all"}, "sample must be None, \"end\" or an array of times, got 'all'"),
    ({"sample": [0.5, 1.5]}, "sample must be <= duration = 1.0 s, got 1.5"),
    ({"sample": [-0.5]}, "sample must be >= 0 and finite, got -0.5"),
    ({"sample": [math.nan]}, "sample must be >= 0 and finite, got nan"),
    ({"sample": 0.5}, r"sample must have shape \(F,\), got shape \(\)"),
]

WRONG_KINDS: list[tuple[dict[str, Any], str]] = [
    ({"scene": None}, "scene must be a Scene, got None"),
    ({"scene": [Body(DISC)]}, r"scene must be a Scene, got \[Body"),
    ({"duration": "long"}, "duration must be a real number or an array of them, got 'long'"),
    ({"duration": None}, "duration must be a real number or an array of them, got None"),
    ({"dt": "1/60"}, "dt must be a real number or an array of them, got '1/60'"),
    ({"iterations": "fast"}, "iterations must be a real number or an array of them, got 'fast'"),
    ({"substeps": "few"}, "substeps must be a real number or an array of them, got 'few'"),
    ({"compiled": "yes"}, "compiled must be True, False or None, got 'yes'"),
    ({"compiled": 1}, "compiled must be True, False or None, got 1"),
    ({"sample": ["now"]}, "sample must be a real number or an array of them"),
]


@pytest.mark.parametrize("solver", ["sequential", "substep", "exact", "pymunk"])
@pytest.mark.parametrize(("wrong", "message"), WRONG_VALUES)
def test_argument_out_of_range_is_refused_by_name(
    wrong: dict[str, Any], message: str, solver: str
) -> None:
    """The error says which, why and what; pymunk, which would end the process, is never called."""
    arguments = {"scene": head_on(), "duration": 1.0, "solver": solver} | wrong
    with pytest.raises(ValueError, match=message):
        simulate(**arguments)


@pytest.mark.parametrize(("wrong", "message"), WRONG_KINDS)
def test_argument_of_another_kind_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """What is no number, and what is no scene, is a TypeError."""
    with pytest.raises(TypeError, match=message):
        simulate(**{"scene": head_on(), "duration": 1.0} | wrong)


def test_settings_are_given_by_name_only() -> None:
    """A third number without a name would be anybody's guess."""
    with pytest.raises(TypeError, match="positional"):
        simulate(head_on(), 1.0, 0.01)  # type: ignore[misc]


# The scene stays as it is


@pytest.mark.parametrize("solver", DOUBLE)
def test_scene_is_not_changed_by_a_run(solver: str) -> None:
    """And gives the same bits when it is run again."""
    scene = floor_and_ball()
    before = copy.deepcopy(scene)
    first, second = (simulate(scene, 1.0, solver=solver) for _ in range(2))
    assert scene == before
    assert first.scene is scene
    assert first.positions.tobytes() == second.positions.tobytes()
    assert len(first.contacts) > 0


# Scenes that are not right


@pytest.mark.parametrize("solver", DOUBLE)
@pytest.mark.parametrize("duration", [0, 0.5])
def test_empty_scene_runs_and_nothing_happens(solver: str, duration: float) -> None:
    """Frames without bodies, sums of 0, no impulses."""
    run = simulate(Scene(), duration, solver=solver)
    steps = 1 if solver == "exact" and duration > 0 else round(60 * duration)
    assert run.positions.shape == (1 + steps, 0, 2)
    assert not run.energy.any()
    assert len(run.contacts) == 0


@pytest.mark.parametrize("solver", DOUBLE)
def test_run_of_no_time_is_the_scene_itself(solver: str) -> None:
    """One frame: where everything begins."""
    run = simulate(head_on(), 0, solver=solver)
    assert run.times.tolist() == [0.0]
    assert run.positions.tolist() == [[[-0.75, 0.0], [0.75, 0.0]]]
    assert run.velocities.tolist() == [[[2.0, 0.0], [-1.0, 0.0]]]


@pytest.mark.parametrize("solver", OURS)
def test_static_bodies_that_overlap_leave_each_other_alone(solver: str) -> None:
    """Walls that cross are how a corner is built: no impulse, no motion, no depth."""
    walls = [
        Body(Segment((-5, 0), (5, 0))),
        Body(Segment((0, -5), (0, 5))),
        Body(Polygon.box(2, 2)),
        Body(DISC, velocity=(0.5, 0)),
    ]
    run = simulate(Scene(walls, gravity=(0, -9.81)), 1.0, solver=solver)
    assert not run.positions[:, :3].any()
    assert run.velocities[-1, 3].tolist() == [0.5, 0.0]
    assert len(run.contacts) == 0
    assert not run.max_penetration.any()


def test_many_static_bodies_in_one_place_cost_nothing() -> None:
    """10,000 of them, and a ball that lies on them: ten steps, done in no time."""
    walls = [Body(DISC) for _ in range(10_000)]
    ball = Body(DISC, mass=1, position=(20, 0))
    run = simulate(Scene([*walls, ball]), 0.1, sample="end")
    assert len(run.contacts) == 0


@pytest.mark.parametrize("solver", OURS)
def test_ten_thousand_bodies_in_one_place_are_refused(solver: str) -> None:
    """50 million pairs would fill the memory: it says so at once."""
    scene = Scene([Body(DISC, mass=1)] * 10_000)
    with pytest.raises(ValueError, match="bodies must not be heaped into one another: 10000 of"):
        simulate(scene, 1.0, solver=solver)
    assert len(simulate(scene, 0, solver=solver).times) == 1


def test_fifty_bodies_in_one_place_are_pushed_apart() -> None:
    """Unusual, but a scene: they leave in a row along x, with no speed out of nothing."""
    run = simulate(Scene([Body(DISC, mass=1)] * 50), 1.0, sample="end")
    assert is_finite(run)
    assert run.max_penetration[-1] < run.max_penetration[0] == 1.0
    assert np.ptp(run.positions[-1, :, 0]) > 1
    assert not run.positions[-1, :, 1].any()
    assert not run.velocities.any()


EXTREMES: dict[str, tuple[Body, ...]] = {
    "1e300 m/s": (Body(DISC, mass=1, velocity=(1e300, 0)), Body(DISC, mass=1, position=(3, 0))),
    "1e300 m/s, overlapping": (
        Body(DISC, mass=1, velocity=(1e300, 0)),
        Body(DISC, mass=1, position=(0.9, 0)),
    ),
    "1e300 m/s both ways": (
        Body(DISC, mass=1, velocity=(1e300, 1e300)),
        Body(DISC, mass=1, position=(0.9, 0), velocity=(-1e300, 1e300)),
    ),
    "1e300 rad/s": (
        Body(Polygon.box(1, 1), mass=1, angular_velocity=1e300),
        Body(DISC, mass=1, position=(0.9, 0)),
    ),
    "1e300 kg on 1e-300 kg": (
        Body(DISC, mass=1e300, velocity=(1, 0)),
        Body(DISC, mass=1e-300, position=(0.9, 0)),
    ),
    "1e12 m away": (
        Body(DISC, mass=1, position=(1e12, 0), velocity=(1, 0)),
        Body(DISC, mass=1, position=(1e12 + 0.9, 0)),
    ),
    "1e-9 m small": (
        Body(Circle(1e-9), mass=1e-9, velocity=(1e-9, 0)),
        Body(Circle(1e-9), mass=1e-9, position=(1.9e-9, 0)),
    ),
}


@pytest.mark.parametrize("solver", OURS)
@pytest.mark.parametrize("bodies", EXTREMES.values(), ids=EXTREMES)
def test_extreme_bodies_have_a_defined_result(bodies: tuple[Body, ...], solver: str) -> None:
    """Numbers, and never nan: floating point reaches that far."""
    assert is_finite(simulate(Scene(bodies), 0.5, solver=solver))


LOST: dict[str, tuple[Body, ...]] = {
    "1e308 m/s": (Body(DISC, mass=1, velocity=(1e308, 0)),),
    "1e308 rad/s": (Body(Polygon.box(1, 1), mass=1, angular_velocity=1e308),),
    "among many": (
        *(Body(DISC, mass=1, position=(3 * k, 0)) for k in range(1, 40)),
        Body(DISC, mass=1, velocity=(0, -1e308)),
    ),
    "1e-310 kg": (
        Body(DISC, mass=1e-310, velocity=(1, 0)),
        Body(DISC, mass=1, position=(0.9, 0)),
    ),
}


@pytest.mark.parametrize("solver", OURS)
@pytest.mark.parametrize("bodies", LOST.values(), ids=LOST)
def test_body_that_leaves_floating_point_is_a_clear_error(
    bodies: tuple[Body, ...], solver: str
) -> None:
    """It says which body; no overflow in a sine or in the grid, and no nan in the run."""
    with pytest.raises(FloatingPointError, match=r"body \d+ has left the range of floating point"):
        simulate(Scene(bodies), 5.0, solver=solver)


def test_ball_that_is_too_fast_passes_through_the_floor() -> None:
    """10 m in a step of 1/60 s: the naive solver's ball and pymunk's are gone, ours is not."""
    fast = floor_and_ball(velocity=(0, -600))
    for solver in ("naive", "pymunk"):
        assert simulate(fast, 0.1, solver=solver).positions[-1, 1, 1] < -10
    assert simulate(fast, 0.1).positions[-1, 1, 1] > 0


def test_callbacks_of_a_scene_are_called_by_our_solvers_alone() -> None:
    """They belong to our engine; the reference is run without them."""
    for solver, count in (("sequential", 1), ("naive", 1), ("pymunk", 0)):
        calls: list[Any] = []
        scene = Scene(head_on().bodies, callbacks=Callbacks(begin=calls.append))
        simulate(scene, 1.0, solver=solver)
        assert len(calls) == count


def test_combination_of_own_rules_is_used_by_every_solver() -> None:
    """Equal discs of e = 0.5 and 0.8 that meet at 1 m/s each: the mean is 0.65."""
    bodies = [
        Body(DISC, mass=1, position=(-v, 0), velocity=(v, 0), material=Material(e))
        for v, e in ((1, 0.5), (-1, 0.8))
    ]
    for solver in DOUBLE:
        run = simulate(Scene(bodies), 1.0, solver=solver, combine=MixingRule("mean", "min"))
        np.testing.assert_allclose(run.velocities[-1, :, 0], [-0.65, 0.65], rtol=ROUNDING)
