"""Soft contacts: springs of known sinking, impacts, gaps, and scenes that the sweeps alone lose."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from tiers import share

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.constants import BAUMGARTE_FACTOR, SLOP, SOFT_DAMPING, SOFT_FREQUENCY
from lesson_code.engine.core.contact_frame import missing_pseudo_velocity
from lesson_code.engine.core.rows import BodyRow, ContactRow
from lesson_code.engine.core.step import prepare_part
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.solvers.substep import soften, way_apart
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.collisions import any_surface
from lesson_code.evidence.hard_cases.heaps import poured
from lesson_code.evidence.hard_cases.parameters import Draw, seeded
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.reference.rigid_body_closed_forms import slide_down

ROUNDING = 1e-12
"""Of numbers near 1: some thousand operations."""

SETTLED = 1e-9
"""m and m/s: what is left of a spring's motion after so long."""

RESETTLING = 0.02
"""m/s: what a relax pass of one sweep leaves when three boxes sink to another depth."""

GAS = 1e-4
"""Of the energy, in 1,400 impacts: where discs meet in clusters, 20 sweeps do not find all of the
bounce; 4e-5 was seen."""

H = 1 / 240
"""s: a sub-step, of four in 1/60 s."""

OMEGA = 2 * math.pi * SOFT_FREQUENCY / H
"""rad/s."""

G = scenes.GRAVITY
GROUND = scenes.level_ground()


def soft(scene: Scene, duration: float, **settings: Any) -> Run:
    """Return a run of the solver with sub-steps."""
    return simulate(scene, duration, solver="substep", **settings)


def stepper_of(scene: Scene) -> EngineStepper:
    """Return the solver with sub-steps at work on a scene."""
    return EngineStepper(
        scene, solver="substep", dt=1 / 60, iterations=1, substeps=4, combine=MixingRule()
    )


def tower(masses: list[float], shift: float = 0.0) -> Scene:
    """Return boxes of 1 m on one another, by turns a little to the right and to the left."""
    rough = Material(0.0, 0.6)
    boxes = [
        Body(Polygon.box(1, 1), mass=m, position=(shift * (-1) ** n, 0.5 + n), material=rough)
        for n, m in enumerate(masses)
    ]
    return Scene([GROUND, *boxes], gravity=(0, -G))


# The spring


@pytest.mark.parametrize("mass", [1e-3, 1.0, 1e3])
def test_disc_at_rest_sinks_as_far_as_its_spring_needs_to_carry_it(mass: float) -> None:
    """M omega^2 x = m g: 0.07 mm, whatever the mass."""
    scene = Scene([GROUND, Body(Circle(0.5), mass=mass, position=(0, 0.5))], gravity=(0, -G))
    run = soft(scene, 5.0, sample="end")
    assert 0.5 - run.positions[-1, 1, 1] == pytest.approx(G / OMEGA**2, abs=SETTLED)
    assert run.velocities[-1, 1, 1] == pytest.approx(0, abs=ROUNDING)


def test_overlap_without_a_load_shrinks_as_a_damped_spring_in_implicit_steps() -> None:
    """From rest in each sub-step: x is multiplied by 1 - w^2 / (1 + 2 zeta w + w^2), w = omega h.

    The relax pass takes the speed back: the discs fall side by side, and none is faster.
    """
    overlap = 0.9 * SLOP * 2
    discs = [Body(Circle(1), mass=m, position=(x, 0)) for m, x in ((3, 0), (1, 2 - overlap))]
    run = soft(Scene(discs, gravity=(0, -G)), 0.5)
    w = OMEGA * H
    factor = 1 - w * w / (1 + 2 * SOFT_DAMPING * w + w * w)
    expected = overlap * factor ** (4 * np.arange(len(run.times)))
    np.testing.assert_allclose(run.max_penetration, expected, atol=ROUNDING)
    np.testing.assert_allclose(run.velocities[..., 0], 0, atol=ROUNDING)
    assert run.velocities[:, 0, 1].tolist() == run.velocities[:, 1, 1].tolist()


@pytest.mark.parametrize("ratio", [1, 10, 100, 300, 1000])
def test_heavy_box_on_a_light_one_sinks_by_the_springs_law_and_stays(ratio: float) -> None:
    """Two points, each of effective mass m / 2.5, carry the load at each face of the light box.

    k = 1/m + 0.5^2 / (m/6) = 2.5 / m: sinking 1.25 (1 + ratio) g / omega^2 at either face, but no
    more than a fortieth of the width into the floor, whose spring is made stiffer. At a ratio of
    1000, 0.11 m in all. The sequential solver's light box is crushed at that. A spring that is made
    stiffer follows its load, and settles later: to 1e-7 m/s.
    """
    run = soft(tower([1.0, ratio]), 20.0, sample="end")
    sinking, at_a_face = 1.5 - run.positions[-1, 2, 1], 1.25 * (1 + ratio) * G / OMEGA**2
    assert sinking == pytest.approx(at_a_face + min(at_a_face, 1 / 40), abs=1e-6)
    assert np.abs(run.velocities[-1]).max() <= (SETTLED if at_a_face < 1 / 40 else 1e-7)
    if ratio == 1000:
        crushed = simulate(
            tower([1.0, ratio]), 20.0, iterations=8, sample="end", solver="sequential"
        )
        assert crushed.positions[-1, 2, 1] < 0.6


# Impacts


def falling_ball(restitution: float, height: float = 1.0, **body: Any) -> Scene:
    """Return a smooth ball of 1 kg, its lowest point at a height above the ground, m."""
    ball = Body(
        Circle(0.5), mass=1, position=(0, 0.5 + height), material=Material(restitution), **body
    )
    return Scene([GROUND, ball], gravity=(0, -G))


@pytest.mark.parametrize("dt", [1 / 60, 1 / 240])
@pytest.mark.parametrize("height", [1.0, 1e-3])
def test_elastic_ball_keeps_its_height(height: float, dt: float) -> None:
    """For 60 s, from 1 m and from 1 mm: v^2/2 + g y is kept in flight and in bounces."""
    run = soft(falling_ball(1.0, height), 60.0, dt=dt)
    y, v = run.positions[:, 1, 1] - 0.5, run.velocities[:, 1, 1]
    kept = v * v / 2 + G * y
    assert (np.diff(np.sign(v)) > 0).sum() > 50
    np.testing.assert_allclose(kept, kept[0], rtol=ROUNDING)


@pytest.mark.parametrize("restitution", [0.3, 0.5, 0.8, 0.95])
def test_rebound_is_the_restitution_squared_but_for_a_step(restitution: float) -> None:
    """Of 1 m; the ball turns round where the step finds it, v dt low at the most."""
    run = soft(falling_ball(restitution), 1.3)
    v = run.velocities[:, 1, 1]
    up = int(np.argmax(v > 0))
    rebound = run.positions[up:, 1, 1].max() - 0.5
    assert rebound == pytest.approx(restitution**2, abs=math.sqrt(2 * G) / 60)
    assert v[up] == pytest.approx(-restitution * v[up - 1] - 4 * G * H, rel=ROUNDING)


@pytest.mark.parametrize("speed", [1e-6, 1e-3, 1.0])
@pytest.mark.parametrize("restitution", [0.0, 0.5, 1.0])
def test_impact_without_gravity_bounces_however_slow(speed: float, restitution: float) -> None:
    """A micrometre a second: there is no threshold but rounding."""
    scene = falling_ball(restitution, 0.01 * speed, velocity=(0.5 * speed, -speed))
    run = soft(Scene(scene.bodies), 0.5, sample="end")
    assert run.velocities[-1, 1] == pytest.approx([0.5 * speed, restitution * speed], rel=ROUNDING)


@pytest.mark.parametrize(("width", "height"), [(1, 1), (10, 1), (1, 10)])
@pytest.mark.parametrize("restitution", [0.0, 0.5])
def test_box_that_lands_flat_leaves_flat(width: float, height: float, restitution: float) -> None:
    """Its two points are solved together, as impacts and as springs: it does not turn."""
    run = soft(scenes.box_landing_flat(width, height, 1.0, restitution), 1.0)
    assert run.velocities[-1, 1, 1] == pytest.approx(restitution, abs=ROUNDING)
    np.testing.assert_allclose(run.angular_velocities[:, 1], 0, atol=ROUNDING)


def test_gas_of_elastic_discs_keeps_its_energy() -> None:
    """30 discs on half of the area for 10 s: never more than at first, and hardly less."""
    rng = np.random.default_rng(1)
    hard = Material(1.0, 0.0)
    corners = [(0, 0), (5, 0), (5, 5), (0, 5)]
    walls = [
        Body(Segment(p, q), material=hard)
        for p, q in zip(corners, corners[1:] + corners[:1], strict=True)
    ]
    discs = [
        Body(
            Circle(0.35), mass=1, position=((n % 6 + 0.5) * 5 / 6, (n // 6 + 0.5) * 5 / 6),
            velocity=rng.normal(0, 1, 2), material=hard,
        )
        for n in range(30)
    ]  # fmt: skip
    run = soft(Scene([*walls, *discs]), 10.0)
    assert len(run.contacts) > 1000
    assert run.kinetic_energy == pytest.approx(run.kinetic_energy[0], rel=GAS)


# Overlaps too deep for springs


def test_deep_overlap_is_pushed_out_without_speed() -> None:
    """A pair gets none at all; 20 % of what is beyond the slop is undone at the first step."""
    discs = [Body(Circle(1), mass=m, position=(x, 0)) for m, x in ((3, 0), (1, 1.9))]
    run = soft(Scene(discs), 2.0)
    slop = SLOP * 2
    pushed = 0.1 - BAUMGARTE_FACTOR * (0.1 - slop)
    assert run.max_penetration[1] == pytest.approx(pushed, abs=ROUNDING)
    assert run.max_penetration[-1] == pytest.approx(slop, rel=1e-6)
    np.testing.assert_allclose(run.velocities, 0, atol=ROUNDING)


def test_without_a_load_contacts_are_rigid() -> None:
    """A spring would give a speed to what it pushes apart; with a mover there may be a load."""
    discs = [Body(Circle(1), mass=1, position=(x, 0)) for x in (0, 1.99)]
    wall = Body(Segment((-9, -9), (-9, 9)), velocity=(1, 0))
    for scene, is_soft in ((Scene(discs), False), (Scene([*discs, wall]), True)):
        world = world_of(scene, 0.01, 1, MixingRule())
        world.state.omega = OMEGA
        c = ContactRow(a=0, b=1, nx=1.0, normal_mass=0.5, gap_origin=-2.0)
        soften(world, c)
        assert (c.softness > 0.0, c.soft_vn > 0.0) == (is_soft, is_soft)


def test_heap_that_begins_a_quarter_in_one_another_does_not_fly_apart() -> None:
    """15 boxes: none is ever faster than after a fall of 5 mm, and in the end none overlap.

    With springs alone the fastest has 11 m/s.
    """
    rough = Material(0.0, 0.6)
    boxes = [
        Body(
            Polygon.box(1, 1), mass=1, position=(0.75 * n + 0.375 * row, 0.375 + 0.75 * row),
            material=rough,
        )
        for row in range(5)
        for n in range(5 - row)
    ]  # fmt: skip
    run = soft(Scene([GROUND, *boxes], gravity=(0, -G)), 6.0)
    assert np.hypot(*np.moveaxis(run.velocities, -1, 0)).max() <= math.sqrt(2 * G * 0.005)
    assert run.max_penetration[0] > 0.2
    assert run.max_penetration[-1] < 1e-3


@pytest.mark.parametrize("seed", range(share(30)))
def test_pushes_of_a_column_go_on_until_they_miss_the_slop_at_the_most(seed: int) -> None:
    """What is above the lowest disc pushes it back in; 20 sweeps are enough for three discs."""
    draw = Draw(seeded("push", seed))
    size, count = draw.log_uniform("size", 0.01, 100), draw.integer("discs", 2, 3)
    apart = size * draw.uniform("distance", 0.3, 0.9)
    column = [
        Body(
            Circle(size / 2),
            mass=draw.log_uniform(f"mass {n}", 1, 3),
            position=(0, (n + 0.5) * apart),
        )
        for n in range(count)
    ]
    floor = Body(Segment((-2 * size, 0), (2 * size, 0)))
    stepper = stepper_of(Scene([*column, floor], gravity=(0, -G)))
    stepper.advance(1)  # now its tables are large enough
    world = stepper.world
    assert prepare_part(world, stepper.pipeline)
    contacts = world.contacts[: world.state.contact_count]
    missed = [
        -missing_pseudo_velocity(c, world.bodies[c.a], world.bodies[c.b]) * world.state.dt
        for c in contacts
    ]
    assert max(c.penetration for c in contacts) > 0.04 * size
    assert max(missed) <= SLOP * size


# Within the step


def test_gap_of_a_disc_does_not_change_as_it_rolls() -> None:
    """The points on its rim turn away, but the rim is round."""
    a, b = BodyRow(), BodyRow(x=1.0, y=0.5)
    c = ContactRow(ny=1.0, bx=0.0, by=-0.5)
    before = way_apart(c, a, b)
    b.angle, b.x = 0.7, 0.65
    assert way_apart(c, a, b) == before


def test_gap_of_a_corner_follows_its_motion_to_first_order() -> None:
    """A corner at (1, -0.5) from its centre rises by 1 rad times 1 m, and as much as the centre."""
    a, b = BodyRow(), BodyRow(y=0.5)
    c = ContactRow(ny=1.0, bx=1.0, by=-0.5)
    before = way_apart(c, a, b)
    b.angle, b.y = 1e-3, 0.502
    assert way_apart(c, a, b) - before == pytest.approx(0.001 + 0.002, rel=ROUNDING)


def test_gap_may_close_but_not_faster_than_within_the_sub_step() -> None:
    """1 cm in 1/100 s is 1 m/s of approach; what overlaps may not approach at all."""
    discs = [Body(Circle(1), mass=1, position=(x, 0)) for x in (0, 2)]
    world = world_of(Scene(discs, gravity=(0, -G)), 0.01, 1, MixingRule())
    world.state.omega = OMEGA
    c = ContactRow(a=0, b=1, nx=1.0, normal_mass=0.5)
    for overlap, vn in ((-0.01, -1.0), (0.01, 0.0)):
        c.gap_origin = -overlap - 2
        soften(world, c)
        assert c.target_vn == pytest.approx(vn, abs=ROUNDING)
    assert c.soft_vn > 0
    assert c.soft_mass < c.normal_mass


@pytest.mark.parametrize(("dt", "substeps"), [(1 / 160, 4), (1 / 20, 4), (1 / 60, 2), (1 / 60, 12)])
def test_stack_stays_where_it_is_when_the_step_or_its_parts_change(
    dt: float, substeps: int
) -> None:
    """Impulses are remembered as those of a sub-step, and scaled to the length of the next.

    What moves a little is the sinking, which goes with the square of the sub-step.
    """
    stepper = stepper_of(tower([1.0] * 3))
    stepper.advance(300)
    stepper.world.state.whole, stepper.world.state.substeps = dt, substeps
    stepper.advance(1)
    assert max(abs(number) for row in stepper.states() for number in row[3:]) <= RESETTLING
    assert stepper.world.state.dt_before == pytest.approx(dt / substeps)
    stepper.advance(300)
    assert max(abs(number) for row in stepper.states() for number in row[3:]) <= SETTLED


def test_impulses_of_a_step_are_those_of_all_its_sub_steps_and_impacts() -> None:
    """A ball that falls, bounces and comes to rest has received m g t, less what it has left."""
    run = soft(falling_ball(0.5), 4.0)
    received = run.contacts.normal_impulse.sum()
    assert received == pytest.approx(G * 4.0 + run.velocities[-1, 1, 1], rel=ROUNDING)
    last = run.contacts.normal_impulse[-1]
    assert last == pytest.approx(G / 60, rel=SETTLED)


@pytest.mark.parametrize("kind", [Circle(0.5), Polygon.box(1, 0.6)], ids=["disc", "box"])
def test_impulses_of_a_step_lie_in_the_coulomb_cone(kind: Any) -> None:
    """Each sub-step's do to the last bit, their sum but for rounding."""
    body = Body(
        kind, mass=1, position=(0, 1), velocity=(5, 0), angular_velocity=3,
        material=Material(0.4, 0.3),
    )  # fmt: skip
    floor = Body(Segment((-50, 0), (50, 0)), material=Material(0.4, 0.3))
    hits = soft(Scene([floor, body], gravity=(0, -G)), 3.0).contacts
    assert len(hits) > 50
    assert (np.abs(hits.tangent_impulse) <= 0.3 * hits.normal_impulse + ROUNDING).all()


# What it is for


@pytest.mark.one_in(2)
@pytest.mark.parametrize("count", [10, 20])
def test_tower_that_is_not_straight_stands_where_the_sequential_one_falls(count: int) -> None:
    """Boxes 1 cm off the line, by turns: after 20 s they lie as they were. Equal sweeps fail at 20.

    A tower of springs buckles slowly: it may have leaned over by as much as it was off the line.
    The springs give way by 1.25 g / omega^2 times the load in boxes.
    """
    run = soft(tower([1.0] * count, 0.01), 20.0, sample="end")
    moved = run.positions[-1, 1:] - run.positions[0, 1:]
    assert np.abs(moved[:, 0]).max() < 0.01
    loads = np.arange(count, 0, -1.0)
    faces = 1.25 * loads * np.where(np.arange(count) == 0, 1, 2) * G / OMEGA**2
    assert moved[-1, 1] == pytest.approx(-faces.sum(), rel=0.1)
    if count == 20:
        fallen = simulate(
            tower([1.0] * count, 0.01), 20.0, iterations=8, sample="end", solver="sequential"
        )
        assert fallen.positions[-1, count, 1] < count / 2


@pytest.mark.parametrize("seed", range(share(30)))
def test_stack_of_any_size_in_any_number_of_sub_steps_does_not_hop(seed: int) -> None:
    """It begins with faces that just touch: springs sink, and nothing rises or gains energy.

    A stack that falls freely for the first step hops by metres in 25 sub-steps and more.
    """
    draw = Draw(seeded("hop", seed))
    size, count = draw.log_uniform("size", 0.01, 100), draw.integer("boxes", 2, 30)
    surface = any_surface(draw)
    boxes = [
        Body(
            Polygon.box(size * draw.log_uniform(f"width {n}", 0.5, 2), size),
            mass=draw.log_uniform(f"mass {n}", 1, 3),
            position=(0, (n + 0.5) * size),
            material=surface,
        )
        for n in range(count)
    ]
    floor = Body(Segment((-2 * size, 0), (2 * size, 0)), material=surface)
    scene = Scene([*boxes, floor], gravity=(0, -G))
    run = soft(scene, 3.0, substeps=draw.integer("sub-steps", 4, 60))
    moved = (run.positions - run.positions[0])[:, :count] / size
    assert moved[..., 1].max() <= ROUNDING
    assert np.abs(moved[..., 0]).max() <= ROUNDING
    assert run.energy.max() <= run.energy[0] * (1 + ROUNDING)


def test_box_stands_on_a_slope_that_friction_just_holds() -> None:
    """Tan 30 degrees is 0.57735: at 0.578 it stands, at 0.577 it slides as the closed form says.

    In the impact that begins it, and in the springs' settling, friction lags by 1 cm/s.
    """
    slope = math.radians(30)
    standing, sliding = (
        soft(scenes.box_on_incline(slope, friction), 2.0, sample="end")
        for friction in (0.578, 0.577)
    )
    assert np.hypot(*standing.velocities[-1, 1]) <= 1e-8
    exact = 2 * slide_down(slope, 0.577, G)
    assert np.hypot(*sliding.velocities[-1, 1]) == pytest.approx(exact, abs=0.01)


def test_pyramid_comes_to_rest_with_overlaps_of_a_millimetre() -> None:
    """15 boxes in 5 rows: after 10 s they move no more, and have hardly moved sideways."""
    run = soft(scenes.box_pyramid(5), 10.0, sample="end")
    assert np.abs(run.velocities[-1]).max() <= SETTLED
    assert np.abs(run.positions[-1] - run.positions[0])[:, 0].max() < 5e-3
    assert run.max_penetration[-1] < 1e-3


def test_contacts_of_a_stack_carry_what_is_above_them() -> None:
    """In a whole step: the k-th from the top k m g dt, in two points."""
    run = soft(tower([2.0] * 6), 10.0)
    last = run.contacts.time > run.times[-1] - 1 / 120
    carried = np.bincount(
        run.contacts.body_b[last], weights=run.contacts.normal_impulse[last], minlength=7
    )
    expected = 2.0 * G / 60 * np.arange(6, 0, -1)
    assert carried[1:] == pytest.approx(expected, rel=1e-9)


# Heaps


@pytest.mark.parametrize("seed", range(share(12)))
def test_record_has_every_impulse_of_a_heap(seed: int) -> None:
    """What gravity gives and the walls take is the change of momentum: nobody waits, either."""
    draw = Draw(seeded("record", seed))
    scene, *_ = poured(draw, any_surface(draw))
    run = soft(scene, 1.5)
    hits, masses = run.contacts, np.array([body.mass or 0.0 for body in scene.bodies])
    along = hits.normal_impulse[:, None] * hits.normal
    across = hits.tangent_impulse[:, None] * np.column_stack(
        (-hits.normal[:, 1], hits.normal[:, 0])
    )
    by_walls = -(along + across)[hits.body_b >= np.count_nonzero(masses)].sum(axis=0)
    weight = masses.sum() * np.array(scene.gravity) * run.times[-1]
    gained = masses @ (run.velocities[-1] - run.velocities[0])
    np.testing.assert_allclose(gained, weight + by_walls, rtol=0, atol=1e-12 * abs(weight).max())


def test_last_step_of_a_run_may_be_short_and_throws_nobody_up() -> None:
    """Springs that follow its length would be far too stiff for the depth at which they lie."""
    for part in (0.5, 0.1, 1e-3, 1e-6):
        run = soft(tower([1.0, 5.0, 1.0]), 5.0 + part / 60, sample="end")
        assert np.abs(run.velocities[-1]).max() <= SETTLED
