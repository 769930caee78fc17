"""A scene stepped by Box2D: each convention of ours arrives there as what it means.

What Box2D cannot be talked out of, its cap on spin, is shown with its figure.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.reference.box2d_reference import Box2DStepper
from lesson_code.reference.rigid_body_closed_forms import slide_to_roll

pyb2d3 = pytest.importorskip("pyb2d3", reason="Box2D is an extra: pip install 'pyb2d3>=0.11'")

SINGLE = 1e-5
"""Numbers up to 10 in single precision, 6e-7 each, over some 60 steps; seen 2e-6."""

SLOP = 0.005
"""m: B2_LINEAR_SLOP, the overlap that Box2D leaves alone."""

DT = 1 / 60


def run_of(scene: Scene, duration: float, **settings: Any) -> Run:
    """Return a scene's run in Box2D."""
    return simulate(scene, duration, solver="box2d", **settings)


def stepper(scene: Scene, combine: str = "workbook", **settings: Any) -> Box2DStepper:
    """Return Box2D at work on a scene, in steps of 1/60 s."""
    return Box2DStepper(scene, dt=DT, combine=mixing_rule(combine), **settings)


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


# The world


def test_settings_are_the_ones_that_are_said() -> None:
    """Nothing sleeps, for a sleeping scene costs nothing and shows nothing."""
    world = stepper(Scene()).world
    assert not world.sleeping_enabled
    assert world.continuous_enabled
    assert world.restitution_threshold == 0.0


def test_world_ends_with_its_stepper() -> None:
    """Box2D holds 128 of them: 300, one after the other, are no problem; as many at once are."""
    scene = ball_at_floor(1.0)
    for _ in range(300):
        stepper(scene).advance(1)
    with pytest.raises(RuntimeError, match="Box2D holds at most 128 worlds at once"):
        list(map(stepper, [scene] * 129))
    assert len(stepper(scene).states()) == 2


# Flight


def test_flight_is_symplectic_eulers_to_single_precision() -> None:
    """In sub-steps of h, height is v t - g t (t + h)/2: velocity first, then position.

    Each turns a body by atan(w h), for want of a sine.
    """
    ball = Body(Circle(0.5), mass=1.0, velocity=(3, 5), angular_velocity=2)
    run = run_of(Scene([ball], gravity=(0, -10)), 1.0)
    t, h = run.times, DT / 4
    assert run.positions[:, 0, 0] == pytest.approx(3 * t, abs=SINGLE)
    assert run.positions[:, 0, 1] == pytest.approx(5 * t - 5 * t * (t + h), abs=SINGLE)
    assert run.angles[:, 0] == pytest.approx(t / h * math.atan(2 * h), abs=SINGLE)


@pytest.mark.parametrize("sample", [None, "end"])
def test_angle_counts_whole_turns(sample: str | None) -> None:
    """Two bodies turn by 35 rad and -35 rad from angles beyond a turn; Box2D knows no turns."""
    bodies = [
        Body(Circle(0.5), position=(2 * w, 0), angle=w, mass=1.0, angular_velocity=w)
        for w in (7.0, -7.0)
    ]
    run = run_of(Scene(bodies), 5.0, sample=sample)
    turned = 1200 * math.atan(7 / 240)
    roundings = 1200 * 2 * 2**-24  # two in each sub-step
    assert run.angles[-1] == pytest.approx([7 + turned, -7 - turned], abs=roundings)


def test_turns_that_are_not_followed_are_lost() -> None:
    """Between two looks a second apart 7 rad are 7 - 2 pi, and nothing else changes."""
    scene = Scene([Body(Circle(0.5), mass=1.0, angular_velocity=7.0)])
    followed, lost = stepper(scene), stepper(scene, follow_turns=False)
    for engine in (followed, lost):
        engine.advance(60)
    difference = followed.states() - lost.states()
    assert difference[0] == pytest.approx([0, 0, 2 * math.pi, 0, 0, 0], abs=SINGLE)


def test_damping_rate_means_the_same_as_in_ours() -> None:
    """After 1 s at a rate of 0.7/s, the share exp(-0.7) of the speed and of the spin is left."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 0), angular_velocity=2)], damping=0.7)
    run = run_of(scene, 1.0)
    roundings = 240 * 2 * 2**-24  # two in each sub-step
    assert run.velocities[-1, 0, 0] == pytest.approx(3 * math.exp(-0.7), rel=roundings)
    assert run.angular_velocities[-1, 0] == pytest.approx(2 * math.exp(-0.7), rel=roundings)


def test_strong_damping_stops_at_once() -> None:
    """At a rate of 1e6/s nothing is left after a sub-step, and no number overflows."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 0))], damping=1e6)
    assert run_of(scene, DT).velocities[-1, 0, 0] == pytest.approx(0, abs=SINGLE)


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
    engine = stepper(Scene(bodies))
    made = [pyb2d3.Body(number) for number in engine.bodies.id_iter()]
    assert [body.mass for body in made] == [3.0, 3.0]
    assert [body.rotational_inertia() for body in made] == [7.0, 0.0]


def test_substeps_are_box2ds_own() -> None:
    """In flight, four of them in dt end where four steps of dt/4 with one do."""
    scene = Scene([Body(Circle(1), mass=1.0, velocity=(3, 5))], gravity=(0, -10))
    coarse = run_of(scene, 0.5, dt=1 / 20, substeps=4)
    fine = run_of(scene, 0.5, dt=1 / 80, substeps=1)
    assert coarse.positions[-1] == pytest.approx(fine.positions[-1], abs=SINGLE)
    as_usual = run_of(scene, 0.5, dt=1 / 20, iterations=50)
    np.testing.assert_array_equal(as_usual.positions, coarse.positions)


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


def test_contact_that_begins_anew_is_given_its_coefficients_again() -> None:
    """A ball of e = 0.5 between elastic walls: each bounce halves its speed, the smaller e's share.

    By Box2D's own rule, the larger, it would go on for ever.
    """
    walls = [Body(Segment((x, -1), (x, 1)), material=Material(1.0)) for x in (-2.0, 2.0)]
    ball = Body(Circle(0.5), mass=1.0, velocity=(100.0, 0.0), material=Material(0.5))
    run = run_of(Scene([*walls, ball]), 0.6)
    speeds = sorted(set(np.abs(run.velocities[:, 2, 0]).round(3)), reverse=True)
    assert speeds[:5] == pytest.approx([100.0, 50.0, 25.0, 12.5, 6.25], abs=100 * SINGLE)


@pytest.mark.parametrize("speed", [0.01, 0.1, 0.9, 3.0, 100.0])
def test_elastic_ball_bounces_at_any_speed(speed: float) -> None:
    """With e = 1 and no threshold: as fast as it came, however slowly that was."""
    run = run_of(ball_at_floor(speed), 1.5)
    assert run.velocities[-1, 1, 1] == pytest.approx(speed, rel=SINGLE)


def test_drop_rebounds_to_nearly_e_squared_of_its_height() -> None:
    """2 m, e = 0.8: 0.64 of the height, but for steps of 1/240 s and the stop at the surface."""
    ball = Body(Circle(0.5), position=(0, 2.5), mass=1.0, material=Material(0.8))
    scene = Scene([Body(Segment((-5, 0), (5, 0))), ball], gravity=(0, -10))
    run = run_of(scene, 1.6, dt=1 / 240)
    height = run.positions[:, 1, 1] - 0.5
    landing = int(np.argmin(height[: int(0.8 * 240)]))
    assert height[landing:].max() / 2 == pytest.approx(0.64, abs=0.01)


def test_spin_is_capped_and_speed_is_not() -> None:
    """An eighth of a turn a step, at 60 steps a second 15 pi rad/s, whatever the scene says."""
    run = run_of(Scene([Body(Circle(0.5), mass=1.0, velocity=(3000, 0), angular_velocity=100)]), 1)
    assert run.velocities[-1, 0, 0] == pytest.approx(3000, rel=1e-6)
    assert run.angular_velocities[-1, 0] == pytest.approx(15 * math.pi, rel=1e-6)


@pytest.mark.parametrize("shape", [Circle(0.2), Polygon.box(0.4, 0.4)], ids=["disc", "box"])
def test_fast_body_does_not_pass_through_a_thin_floor(shape: Circle | Polygon) -> None:
    """100 m/s at a floor without thickness, and at one of 0.2 m: it ends where contacts begin."""
    for floor, top in ((Segment((-9, 0), (9, 0)), 0.0), (Polygon.box(18, 0.2), 0.1)):
        body = Body(shape, position=(0, 3), velocity=(0, -100), mass=1.0)
        run = run_of(Scene([Body(floor), body]), 0.5, sample="end")
        assert run.positions[-1, 1, 1] == pytest.approx(top + 0.2, abs=4 * SLOP)


# Rest and friction


def test_stack_of_ten_boxes_sinks_as_its_springs_give_way() -> None:
    """Each of two points below a box is a spring of 30 Hz that carries half of the load.

    Of the mass m_eff = 1/(2/m + 2 r^2/I) = m/5 for two unit boxes, r = 1/2 and I = m/6: below
    nine boxes it gives way by 4.5 m g/(m_eff omega^2), 6.3 mm. None moves any more.
    """
    run = run_of(scenes.box_stack(10), 10.0, sample="end")
    sunk = run.positions[0, 1:, 1] - run.positions[-1, 1:, 1]
    springs = 4.5 * scenes.GRAVITY * 5 / (2 * math.pi * 30) ** 2
    assert np.diff(sunk).max() == pytest.approx(springs, rel=0.01)
    assert run.max_penetration[-1] == pytest.approx(springs, rel=0.01)
    assert np.abs(run.velocities[-1]).max() <= 1e-3 * scenes.GRAVITY


@pytest.mark.parametrize("inertia_ratio", [1 / 2, 1.0], ids=["disc", "hoop"])
def test_sliding_body_ends_rolling_at_the_closed_forms_speed(inertia_ratio: float) -> None:
    """2/3 of the speed for a disc, 1/2 for a hoop, to what friction gives in a sub-step."""
    run = run_of(scenes.sliding_disc(6.0, 0.3, inertia_ratio), 4.0, sample="end")
    velocity, spin = slide_to_roll(
        4.0, 6.0, 0.0, 1.0, inertia_ratio, friction=0.3, gravity=scenes.GRAVITY
    )
    friction_of_a_substep = 0.3 * scenes.GRAVITY * DT / 4
    assert run.velocities[-1, 1, 0] == pytest.approx(velocity, abs=friction_of_a_substep)
    assert run.angular_velocities[-1, 1] == pytest.approx(spin, abs=friction_of_a_substep)


@pytest.mark.parametrize("thickness", [0.02, 0.4])
@pytest.mark.parametrize("shape", [Circle(0.5), Polygon.box(1, 1)], ids=["disc", "box"])
def test_body_rests_on_a_thick_segment_at_its_surface(
    shape: Circle | Polygon, thickness: float
) -> None:
    """Half of the thickness above its middle line, less what its spring gives way."""
    floor = Body(Segment((-5, 0), (5, 0), radius=thickness / 2))
    body = Body(shape, position=(0, thickness / 2 + 0.51), mass=1.0)
    run = run_of(Scene([floor, body], gravity=(0, -10)), 3.0, sample="end")
    assert run.positions[-1, 1, 1] == pytest.approx(thickness / 2 + 0.5, abs=1e-4)


# Impulses


def test_run_has_no_impulses() -> None:
    """The binding tells none, so that nothing can be measured on them; momentum shows the blow."""
    run = run_of(ball_at_floor(3.0), 0.1)
    assert len(run.contacts) == 0
    assert run.momentum[-1] - run.momentum[0] == pytest.approx([0, 6], abs=SINGLE)


# The door


def test_simulate_takes_box2d_and_records_every_step() -> None:
    """A run like any other, and the same bits when it is made again."""
    scene = scenes.box_stack(2)
    first, second = (run_of(scene, 0.5, dt=0.125) for _ in range(2))
    assert first.times.tolist() == [0, 0.125, 0.25, 0.375, 0.5]
    assert str(first.plan) == "solver: box2d (asked for); C (Box2D's own)"
    assert first.positions.tobytes() == second.positions.tobytes()
    assert run_of(Scene(), 0.5).positions.shape == (31, 0, 2)


def test_heap_is_refused() -> None:
    """As for every solver."""
    with pytest.raises(ValueError, match="bodies must not be heaped into one another"):
        run_of(Scene([Body(Circle(0.5), mass=1)] * 10_000), 1.0)
