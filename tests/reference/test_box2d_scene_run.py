"""A scene stepped by Box2D: each convention of ours arrives there as what it means.

What Box2D cannot be talked out of, its threshold of bouncing and its cap on speed, is shown with
its figure.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.reference.box2d_reference import Box2DStepper, fixtures
from lesson_code.reference.rigid_body_closed_forms import slide_to_roll

Box2D = pytest.importorskip("Box2D", reason="Box2D is an extra: pip install 'Box2D>=2.3.10'")

SINGLE = 1e-5
"""Numbers up to 10 in single precision, 6e-7 each, over some 60 steps; seen 2e-6."""

SLOP = 0.005
"""m: b2_linearSlop, the overlap that Box2D leaves alone."""

DT = 1 / 60


def run_of(scene: Scene, duration: float, **settings: Any) -> Run:
    """Return a scene's run in Box2D."""
    return simulate(scene, duration, solver="box2d", **settings)


def stepper(scene: Scene, combine: str = "workbook", **settings: Any) -> Box2DStepper:
    """Return Box2D at work on a scene, in steps of 1/60 s."""
    usual = {"dt": DT, "iterations": 8, "substeps": 1, "combine": mixing_rule(combine)}
    return Box2DStepper(scene, **(usual | settings))


def ball_at_floor(speed: float, restitution: float = 1.0) -> Scene:
    """Return a floor, and a ball just above it that comes down at a speed; there is no gravity."""
    ball = Body(
        Circle(0.5),
        position=(0, 0.51),
        velocity=(0, -speed),
        mass=1.0,
        material=Material(restitution),
    )
    return Scene([Body(Segment((-9, 0), (9, 0))), ball])


def head_on(first: Material, second: Material) -> Scene:
    """Two equal discs of 1 kg; the first comes from the left at 4 m/s and meets the other."""
    return Scene(
        [
            Body(Circle(1), mass=1.0, velocity=(4, 0), position=(-1.01, 0), material=first),
            Body(Circle(1), mass=1.0, position=(1, 0), material=second),
        ]
    )


# The library


def test_constants_are_those_that_the_mapping_relies_on() -> None:
    """Slop, skin, corners, threshold and cap: another build of Box2D fails here first."""
    assert Box2D.b2_linearSlop == pytest.approx(SLOP)
    assert Box2D.b2PolygonShape(box=(1, 1)).radius == pytest.approx(fixtures.SKIN)
    assert Box2D.b2_maxPolygonVertices == fixtures.MOST_VERTICES
    assert (Box2D.b2_velocityThreshold, Box2D.b2_maxTranslation) == (1.0, 2.0)


def test_settings_are_the_ones_that_are_said() -> None:
    """Nothing sleeps, for a sleeping scene costs nothing and shows nothing."""
    world = stepper(Scene()).world
    assert not world.GetAllowSleeping()
    assert world.warmStarting
    assert world.continuousPhysics


# Flight


def test_flight_is_symplectic_eulers_to_single_precision() -> None:
    """Height is v t - g t (t + dt)/2: velocity first, then position; the spin stays."""
    ball = Body(Circle(0.5), mass=1.0, velocity=(3, 5), angular_velocity=2)
    run = run_of(Scene([ball], gravity=(0, -10)), 1.0)
    t = run.times
    assert run.positions[:, 0, 0] == pytest.approx(3 * t, abs=SINGLE)
    assert run.positions[:, 0, 1] == pytest.approx(5 * t - 5 * t * (t + DT), abs=SINGLE)
    assert run.angles[:, 0] == pytest.approx(2 * t, abs=SINGLE)


def test_damping_rate_means_the_same_as_in_ours() -> None:
    """After 1 s at a rate of 0.7/s, the share exp(-0.7) of the speed and of the spin is left."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 0), angular_velocity=2)], damping=0.7)
    run = run_of(scene, 1.0)
    assert run.velocities[-1, 0, 0] == pytest.approx(3 * math.exp(-0.7), abs=SINGLE)
    assert run.angular_velocities[-1, 0] == pytest.approx(2 * math.exp(-0.7), abs=SINGLE)


def test_static_body_with_a_velocity_keeps_it() -> None:
    """It is kinematic in Box2D: it pushes, and is not pushed."""
    wall = Body(Segment((0, -5), (0, 5)), velocity=(2, 0))
    ball = Body(Circle(1), position=(2, 0), mass=1.0, material=Material(1.0))
    run = run_of(Scene([wall, ball]), 1.0)
    assert run.velocities[-1, :, 0] == pytest.approx([2, 4], abs=SINGLE)


def test_mass_and_inertia_are_ours() -> None:
    """They are given to Box2D, not derived; what never turns has an inverse moment of 0."""
    box = Polygon.box(2, 1)
    bodies = [Body(box, mass=3.0, inertia=7.0), Body(box, mass=3.0, inertia=math.inf)]
    first, second = stepper(Scene(bodies)).bodies
    assert (first.mass, first.inertia) == (3.0, 7.0)
    assert (second.mass, second.inertia) == (3.0, 0.0)


def test_substeps_are_steps_of_a_part_of_dt() -> None:
    """Four sub-steps of dt/4 end where four steps of dt/4 do."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 5))], gravity=(0, -10))
    coarse, fine = run_of(scene, 0.5, dt=1 / 20, substeps=4), run_of(scene, 0.5, dt=1 / 80)
    np.testing.assert_array_equal(coarse.positions[-1], fine.positions[-1])


def test_advance_makes_many_steps_in_one_call() -> None:
    """And leaves the bodies where as many single steps do."""
    at_once, singly = stepper(scenes.box_stack(3)), stepper(scenes.box_stack(3))
    at_once.advance(30)
    for _ in range(30):
        singly.advance(1)
    assert at_once.states().tobytes() == singly.states().tobytes()


# Bounces


@pytest.mark.parametrize(
    ("combine", "restitution"), [("workbook", 0.4), ("pymunk", 0.32), ("box2d", 0.8)]
)
def test_restitution_of_a_pair_is_ours_not_box2ds_larger(combine: str, restitution: float) -> None:
    """0.4 and 0.8: the smaller, the product or the larger, as we ask; separation over approach."""
    run = run_of(head_on(Material(0.4), Material(0.8)), 0.5, combine=combine)
    v1, v2 = run.velocities[-1, :, 0]
    assert (v2 - v1) / 4 == pytest.approx(restitution, abs=SINGLE)


def test_box2ds_own_rule_is_used_without_a_callback() -> None:
    """Where the larger and the geometric mean are right for all pairs, nothing is called."""
    scene = head_on(Material(0.4, 0.5), Material(0.8, 0.25))
    assert not stepper(scene, combine="box2d").corrects_coefficients
    assert stepper(scene, combine="workbook").corrects_coefficients
    lean = stepper(scene, combine="box2d", keep_impulses=False)
    assert lean.world.contactListener is None


def test_contact_that_begins_anew_is_given_its_coefficients_again() -> None:
    """A ball of e = 0.5 between elastic walls: each bounce halves its speed, the smaller e's share.

    By Box2D's own rule, the larger, it would go on for ever.
    """
    walls = [Body(Segment((x, -1), (x, 1)), material=Material(1.0)) for x in (-2.0, 2.0)]
    ball = Body(Circle(0.5), mass=1.0, velocity=(100.0, 0.0), material=Material(0.5))
    run = run_of(Scene([*walls, ball]), 0.5)
    speeds = sorted(set(np.abs(run.velocities[:, 2, 0]).round(3)), reverse=True)
    assert speeds[:5] == pytest.approx([100.0, 50.0, 25.0, 12.5, 6.25], abs=100 * SINGLE)


@pytest.mark.parametrize(
    ("speed", "rebound"), [(0.9, 0.0), (0.999, 0.0), (1.001, 1.001), (3.0, 3.0)]
)
def test_elastic_ball_slower_than_the_threshold_does_not_bounce(
    speed: float, rebound: float
) -> None:
    """With e = 1: at 1 m/s Box2D's ball stops dead, or bounces in full. Ours always bounces."""
    scene = ball_at_floor(speed)
    assert run_of(scene, 0.5).velocities[-1, 1, 1] == pytest.approx(rebound, abs=SINGLE)
    assert simulate(scene, 0.5, solver="sequential").velocities[-1, 1, 1] == pytest.approx(
        speed, abs=SINGLE
    )


def test_drop_rebounds_to_nearly_e_squared_of_its_height() -> None:
    """2 m, e = 0.8: 0.64 of the height, but for steps of 1/240 s and the stop at the surface."""
    ball = Body(Circle(0.5), position=(0, 2.5), mass=1.0, material=Material(0.8))
    scene = Scene([Body(Segment((-5, 0), (5, 0))), ball], gravity=(0, -10))
    run = run_of(scene, 1.6, dt=1 / 240)
    height = run.positions[:, 1, 1] - 0.5
    landing = int(np.argmin(height[: int(0.8 * 240)]))
    assert height[landing:].max() / 2 == pytest.approx(0.64, abs=0.01)


def test_speed_is_capped_at_two_metres_a_step() -> None:
    """At 60 steps a second that is 120 m/s, whatever the scene says."""
    run = run_of(Scene([Body(Circle(0.5), mass=1.0, velocity=(300, 0))]), 1.0)
    assert run.velocities[-1, 0, 0] == pytest.approx(120, rel=1e-6)


@pytest.mark.parametrize("shape", [Circle(0.2), Polygon.box(0.4, 0.4)], ids=["disc", "box"])
def test_fast_body_does_not_pass_through_a_thin_floor(shape: Circle | Polygon) -> None:
    """100 m/s at a floor without thickness, and at one of 0.2 m: continuous detection is on."""
    for floor, top in ((Segment((-9, 0), (9, 0)), 0.0), (Polygon.box(18, 0.2), 0.1)):
        body = Body(shape, position=(0, 3), velocity=(0, -100), mass=1.0)
        run = run_of(Scene([Body(floor), body]), 0.5, sample="end")
        assert run.positions[-1, 1, 1] == pytest.approx(top + 0.2, abs=2 * SLOP)


# Rest and friction


def test_stack_of_ten_boxes_rests_within_its_slop() -> None:
    """After 10 s each box has sunk by no more than the slop, and none moves."""
    run = run_of(scenes.box_stack(10), 10.0, sample="end")
    sunk = run.positions[0, 1:, 1] - run.positions[-1, 1:, 1]
    assert (np.diff(sunk, prepend=0.0) <= SLOP + SINGLE).all()
    assert np.abs(run.velocities[-1]).max() <= SINGLE
    assert run.max_penetration[-1] <= SLOP + SINGLE


@pytest.mark.parametrize("inertia_ratio", [1 / 2, 1.0], ids=["disc", "hoop"])
def test_sliding_body_ends_rolling_at_the_closed_forms_speed(inertia_ratio: float) -> None:
    """2/3 of the speed for a disc, 1/2 for a hoop, to what single precision leaves."""
    run = run_of(scenes.sliding_disc(6.0, 0.3, inertia_ratio), 4.0, sample="end")
    velocity, spin = slide_to_roll(
        4.0, 6.0, 0.0, 1.0, inertia_ratio, friction=0.3, gravity=scenes.GRAVITY
    )
    assert run.velocities[-1, 1, 0] == pytest.approx(velocity, abs=SINGLE)
    assert run.angular_velocities[-1, 1] == pytest.approx(spin, abs=SINGLE)


@pytest.mark.parametrize("thickness", [0.02, 0.4], ids=["an edge", "a box with round ends"])
@pytest.mark.parametrize("shape", [Circle(0.5), Polygon.box(1, 1)], ids=["disc", "box"])
def test_body_rests_on_a_thick_segment_at_its_surface(
    shape: Circle | Polygon, thickness: float
) -> None:
    """Half of the thickness above its middle line, less the slop."""
    floor = Body(Segment((-5, 0), (5, 0), radius=thickness / 2))
    body = Body(shape, position=(0, thickness / 2 + 0.51), mass=1.0)
    run = run_of(Scene([floor, body], gravity=(0, -10)), 3.0, sample="end")
    assert run.positions[-1, 1, 1] == pytest.approx(thickness / 2 + 0.5 - SLOP, abs=1e-4)


# Impulses


def test_impulse_events_have_our_normal_and_our_sign() -> None:
    """The normal goes from a to b, the impulse is what b received, and momentum agrees with it."""
    floor = Body(Segment((-9, 0), (9, 0)))
    box = Body(
        Polygon.box(2, 1),
        position=(0, 0.51),
        velocity=(1, -2),
        mass=3.0,
        material=Material(0.5, 0.1),
    )
    for bodies in ([floor, box], [box, floor]):
        run = run_of(Scene(bodies), 0.1)
        events, up = run.contacts, 1 if bodies[1] is box else -1
        assert len(events) > 0
        assert (events.body_a == 0).all()
        assert events.normal == pytest.approx(np.tile([0, up], (len(events), 1)), abs=SINGLE)
        tangents = np.column_stack((-events.normal[:, 1], events.normal[:, 0]))
        received = (
            events.normal_impulse[:, None] * events.normal
            + events.tangent_impulse[:, None] * tangents
        ).sum(axis=0)
        gained = run.momentum[-1] - run.momentum[0]
        assert up * received == pytest.approx(gained, abs=SINGLE)


def test_run_without_impulses_is_the_same_run() -> None:
    """Writing them down changes nothing but the time it takes."""
    scene = scenes.box_pyramid(4)
    kept, lean = stepper(scene), stepper(scene, keep_impulses=False)
    for engine in (kept, lean):
        engine.advance(60)
    assert kept.states().tobytes() == lean.states().tobytes()
    assert len(kept.events()) > 0
    assert lean.events().shape == (0, 10)


# The door


def test_simulate_takes_box2d_and_records_every_step() -> None:
    """A run like any other, and the same bits when it is made again."""
    scene = scenes.box_stack(2)
    first, second = (run_of(scene, 0.5, dt=0.125) for _ in range(2))
    assert first.times.tolist() == [0, 0.125, 0.25, 0.375, 0.5]
    assert str(first.plan) == "solver: box2d (asked for); C++ (Box2D's own)"
    assert first.positions.tobytes() == second.positions.tobytes()
    assert run_of(Scene(), 0.5).positions.shape == (31, 0, 2)


def test_heap_is_refused() -> None:
    """As for every solver."""
    with pytest.raises(ValueError, match="bodies must not be heaped into one another"):
        run_of(Scene([Body(Circle(0.5), mass=1)] * 10_000), 1.0)
