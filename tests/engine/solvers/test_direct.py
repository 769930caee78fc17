"""The direct solver: what sweeps cannot hold, and what every solver has to."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.core.constants import FINE_SLOP
from lesson_code.engine.core.islands import Island
from lesson_code.engine.solvers.direct import settle
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.overlaps import dropped_boxes
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction
from lesson_code.reference.rigid_body_closed_forms import (
    slide_down,
    stack_forces,
    tipping_angle,
    wedge_forces,
)

ROUNDING = 1e-12
"""m/s and N s, of some units: a few dozen operations and a solution of linear equations."""

QUIET = 1e-11
"""m/s: rounding of the impulses of a tall or heavy stack, over its lightest mass."""

LOADED = 1e-7
"""m/s, m: rounding of impulses of 2e5 N s, on 1 kg, and what 600 steps make of it."""

DT = 1 / 60
G = 10.0

SUNK = 4e-4
"""m: how deep bodies of 1 m are put into each other, so that they touch. Below the slop."""

SINKING = 1e-3
"""Of the size of a body: the overlap that may be left under a load of a million."""

DRIFT = 1e-3
"""m: how far a box of a stack may come in a minute."""

FAR = 1e-8
"""m: what an offset of 1e6 m may change. There a place is rounded to 1e-10 m."""

FORCE = 5e-14
"""Of a force, times the mass ratio: what a velocity of the light body that is rounding means as a
force on the heavy one."""

MIRRORED = 1e-10
"""m/s, rad/s: rounding, and what a dozen impacts make of it; the worst seen of 300 is 1.5e-12."""

LIMIT_CYCLE = 1e-8
"""Of the impulse: the step moves the tip by 1e-9 m, and turns its lever arm by as much."""


SQUEEZED = 1e-14
"""Of the energy, times the mass ratio; the worst seen is 1.4e-15."""


def floor(e: float | None = None, mu: float | None = None) -> Body:
    """Return a floor at y = 0."""
    return Body(Segment((-50, 0), (50, 0)), material=Material(e, mu))


def stack(
    masses: Any, e: float = 0.0, mu: float = 0.5, at: float = 0.0, sunk: float = SUNK
) -> Scene:
    """Return boxes of 1 m on a floor, one on the other."""
    ground = Body(Segment((-50, 0), (50, 0)), position=(at, at), material=Material(e, mu))
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=mass,
            position=(at, at + 0.5 + k - (k + 1) * sunk),
            material=Material(e, mu),
        )
        for k, mass in enumerate(masses)
    ]
    return Scene([ground, *boxes], gravity=(0, -G))


def direct(scene: Scene, duration: float, **settings: Any) -> Run:
    """Return a run by the direct solver."""
    return simulate(scene, duration, solver="direct", **settings)


def forces(run: Run) -> Any:
    """Return the normal forces in the last step, N, one for each contact point."""
    last = run.contacts.time == run.contacts.time[-1]
    return run.contacts.normal_impulse[last] / DT


# Loads


def test_load_of_a_million_on_a_box_sinks_less_than_a_thousandth() -> None:
    """1e6 kg on 1 kg, for 10 s: the overlap stays below 1e-3 of the size, and nothing moves."""
    run = direct(stack([1.0, 1e6], sunk=-1e-4), 10.0, sample=np.linspace(0, 10, 21))
    assert run.max_penetration[-1] < SINKING
    assert np.abs(run.velocities[-1]).max() < LOADED
    assert np.abs(run.positions[-1, :, 0]).max() < 10 * LOADED


@pytest.mark.parametrize("ratio", [1e3, 1e6, 1e9])
def test_force_under_a_heavy_load_is_its_weight(ratio: float) -> None:
    """(M + m) g on the floor, M g on the box, half of each at either corner."""
    masses = [1.0, ratio]
    run = direct(stack(masses), 1.0, sample="end")
    lower, upper = stack_forces(masses, G)
    np.testing.assert_allclose(forces(run), np.repeat((lower, upper), 2) / 2, rtol=FORCE * ratio)


def test_stack_of_40_does_not_drift_in_a_second() -> None:
    """Nor does it move: what the sweeps of a second do not reach is reached in each step."""
    run = direct(stack([1.0] * 40), 1.0, sample="end")
    np.testing.assert_allclose(run.positions[-1], run.positions[0], atol=QUIET)
    assert np.abs(run.velocities[-1]).max() < QUIET


@pytest.mark.full
def test_stack_of_40_drifts_less_than_a_millimetre_in_a_minute() -> None:
    """3600 steps of 80 contacts."""
    run = direct(stack([1.0] * 40), 60.0, sample="end")
    np.testing.assert_allclose(run.positions[-1], run.positions[0], atol=DRIFT)


def test_forces_in_a_stack_of_40_are_the_closed_form() -> None:
    """N g at the floor, down to g on top; each corner carries half."""
    run = direct(stack([1.0] * 40), 3 * DT, sample="end")
    expected = np.repeat(stack_forces([1.0] * 40, G), 2) / 2
    np.testing.assert_allclose(forces(run), expected, rtol=1e-8)


def test_load_on_six_points_is_even() -> None:
    """A beam on three posts of equal width: six corners, each with a sixth of the weight."""
    posts = [Body(Polygon.box(0.2, 1), position=(x, -0.5)) for x in (-1.9, 0.0, 1.9)]
    beam = Body(Polygon.box(4, 0.5), mass=6, position=(0, 0.25 - SUNK))
    run = direct(Scene([*posts, beam], gravity=(0, -G)), 5 * DT, sample="end")
    np.testing.assert_allclose(forces(run), G, rtol=1e-6)
    assert run.angular_velocities[-1, 3] == pytest.approx(0, abs=QUIET)


def test_forces_in_a_wedge_are_the_closed_form() -> None:
    """A disc between two smooth walls at 45 degrees: W / sqrt 2 each."""
    walls = [Body(Segment((0, 0), (x, 5))) for x in (-5, 5)]
    disc = Body(Circle(1), mass=1, position=(0, math.sqrt(2) - SUNK))
    run = direct(Scene([*walls, disc], gravity=(0, -G)), 0.5, sample="end")
    expected = wedge_forces(G, math.pi / 4, math.pi / 4)
    np.testing.assert_allclose(forces(run), expected, rtol=ROUNDING)


def on_a_slope(angle: float, box: Polygon, height: float, mu: float) -> Scene:
    """Return a box on level ground, with the pull of a slope."""
    body = Body(box, mass=1, position=(0, height / 2), material=Material(0.0, mu))
    return Scene([floor(0.0, mu), body], gravity=(-G * math.sin(angle), -G * math.cos(angle)))


@pytest.mark.parametrize("mu", [0.2, 0.57, 0.58, 0.9])
def test_box_on_a_slope_slides_as_the_closed_form(mu: float) -> None:
    """It is g (sin - mu cos), or not at all: tan 30 degrees = 0.57735."""
    angle = math.pi / 6
    run = direct(on_a_slope(angle, Polygon.box(1, 1), 1.0, mu), 1.0)
    expected = slide_down(angle, mu, G) * 1.0
    assert -run.velocities[-1, 1, 0] == pytest.approx(max(expected, 0.0), abs=1e-10)


def test_friction_stops_sliding_but_never_turns_it_round() -> None:
    """Whenever in a step a box stops on a plank that slides: after each step, whatever is drawn."""
    rng = np.random.default_rng(6)
    smooth = Body(Segment((-100, 0), (100, 0)), material=Material(0.0, 0.0))
    for _ in range(40):
        speed, mu, mass = rng.uniform(0.2, 2.0), rng.uniform(0.2, 1.0), 10 ** rng.uniform(-2, 2)
        rough = Material(0.0, mu)
        plank = Body(
            Polygon.box(12, 0.5),
            mass=1.0,
            position=(0, 0.25),
            velocity=(speed, 0),
            material=rough,
        )
        box = Body(Polygon.box(2, 0.5), mass=mass, position=(0, 0.75), material=rough)
        stopped = speed / (mu * G * (1 + mass))
        steps = math.ceil(stopped / DT) + 2
        times = DT * np.arange(steps + 1)
        scene = Scene([smooth, plank, box], gravity=(0, -G))
        run = simulate(scene, steps * DT, solver="direct", sample=times)
        slides = run.velocities[:, 1, 0] - run.velocities[:, 2, 0]
        assert slides == pytest.approx(
            np.maximum(speed - mu * G * (1 + mass) * times, 0.0), abs=1e-9
        )


@pytest.mark.parametrize(("beside", "tips"), [(-1e-4, False), (1e-4, True)])
def test_tall_box_tips_at_the_closed_form(beside: float, tips: bool) -> None:
    """w/h = 1/2: it stands up to atan(1/2), and no further."""
    angle = tipping_angle(0.5, 1.0) + beside
    run = direct(on_a_slope(angle, Polygon.box(0.5, 1.0), 1.0, 2.0), 1.0, sample="end")
    assert (abs(run.angles[-1, 1]) > 1e-6) == tips


# Friction that sweeps never solve


def rod(angle: float, vx: float, e: float = 0.0, mu: float = 2.0) -> Scene:
    """Return a rod of 1 kg and 2 m whose tip slides over the floor, and falls at 1e-3 m/s."""
    material = Material(e, mu)
    body = Body(
        Segment((-1, 0), (1, 0)),
        mass=1,
        position=(0, math.sin(angle) - 1e-9),
        angle=angle,
        velocity=(vx, -1e-3),
        material=material,
    )
    return Scene([floor(e, mu), body])


def test_friction_limit_cycle_is_none() -> None:
    """A rod is drawn over the floor, and sweeps swing for ever: mu knt > knn.

    Here knn = 5/2, knt = 3/2, mu = 2: jn = 1e-3 / (5/2 + 2 * 3/2), and the tip keeps its height.
    """
    run = direct(rod(math.pi / 4, 1.0), 1e-9, dt=1e-9)
    jn, jt = run.contacts.normal_impulse[0], run.contacts.tangent_impulse[0]
    assert jn == pytest.approx(1e-3 / 5.5, rel=LIMIT_CYCLE)
    assert jt == pytest.approx(2 * jn, rel=ROUNDING)
    tip = run.velocities[-1, 1, 1] - run.angular_velocities[-1, 1] * math.cos(math.pi / 4)
    assert tip == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("angle", [math.pi / 4, math.atan(2)])
@pytest.mark.parametrize("law", ["newton", "energetic"])
def test_jam_stops_the_tip_and_loses_energy(angle: float, law: str) -> None:
    """Painleve: pushed over the floor with mu = 2 the rod cannot slide. The tip stops."""
    run = direct(rod(angle, -1.0), 1e-9, dt=1e-9, restitution_law=law)
    arm = np.array([-math.cos(angle), -math.sin(angle)])
    tip = run.velocities[-1, 1] + run.angular_velocities[-1, 1] * np.array([-arm[1], arm[0]])
    np.testing.assert_allclose(tip, 0, atol=1e-9)  # the overlap is 1e-9 m
    ground = Struck(0.0, 0.0, (0, 0), 0.0, (0, 0))
    body = Struck(1.0, 3.0, (-1.0, -1e-3), 0.0, arm)
    expected = impact_with_friction(ground, body, (0, 1), 0.0, 2.0)
    assert expected.kind == "sticks"
    np.testing.assert_allclose(run.velocities[-1, 1], expected.velocities[1], atol=1e-8)
    assert run.kinetic_energy[-1] < run.kinetic_energy[0]


# Steps


@pytest.mark.parametrize("ratio", [1.5, 2.62, 5.0, 10.0])
def test_stack_at_rest_stays_at_rest_whatever_the_steps(ratio: float) -> None:
    """dt, ratio dt, dt, ...: the answer does not depend on the step before."""
    stepper = EngineStepper(
        stack([1.0] * 3), solver="direct", dt=DT, iterations=1, substeps=1, combine=MixingRule()
    )
    start = np.array(stepper.states())
    for k in range(120):
        stepper.world.state.whole = DT * (ratio if k % 2 else 1.0)
        stepper.advance(1)
    np.testing.assert_allclose(stepper.states(), start, atol=QUIET)


def test_second_call_of_a_stage_adds_nothing() -> None:
    """More iterations are wasted, but do no harm."""
    scene = stack([1.0, 2.0], e=0.3, sunk=1e-2)
    once, twice = (
        EngineStepper(scene, solver="direct", dt=DT, iterations=n, substeps=1, combine=MixingRule())
        for n in (1, 2)
    )
    for _ in range(30):
        once.advance(1)
        twice.advance(1)
    np.testing.assert_allclose(twice.states(), once.states(), atol=1e-9)


def test_iterations_mean_nothing() -> None:
    """simulate() makes one solution a step, whatever it is told."""
    runs = [direct(stack([1.0, 2.0]), 0.2, iterations=n) for n in (1, 10)]
    np.testing.assert_array_equal(runs[0].positions, runs[1].positions)


# Sizes, places, overlaps


@pytest.mark.parametrize("radius", [10.0, 0.05, 0.01, 1e-4])
def test_disc_rests_at_its_radius(radius: float) -> None:
    """Dropped from a metre: the slop is a part of its size, not of a metre."""
    disc = Body(Circle(radius), mass=1, position=(0, 1 + radius), material=Material(0.0, 0.5))
    run = direct(Scene([floor(), disc], gravity=(0, -G)), 3.0, sample="end")
    assert run.positions[-1, 1, 1] == pytest.approx(radius, rel=2.1 * FINE_SLOP)
    assert run.velocities[-1, 1].tolist() == pytest.approx([0, 0], abs=ROUNDING)


@pytest.mark.parametrize("offset", [1e3, 1e6])
def test_stack_far_from_the_origin_is_the_same(offset: float) -> None:
    """Contacts are kept as lever arms, never as places."""
    near, far = (direct(stack([1.0] * 5, at=at), 2.0, sample="end") for at in (0.0, offset))
    np.testing.assert_allclose(far.positions[-1] - offset, near.positions[-1], atol=FAR)
    np.testing.assert_allclose(far.velocities[-1], near.velocities[-1], atol=FAR)


def test_overlap_is_undone_without_speed() -> None:
    """A pyramid with a quarter of each box in the next: nothing is ever launched."""
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=1,
            position=((j - (4 - i) / 2) * 1.0, 0.375 + 0.75 * i),
            material=Material(0.0, 0.5),
        )
        for i in range(4)
        for j in range(4 - i)
    ]
    run = direct(Scene([floor(), *boxes], gravity=(0, -G)), 2.0)
    assert np.abs(run.velocities).max() < 0.5
    assert run.max_penetration[-1] < 2e-3


def test_ten_discs_in_one_place_come_apart() -> None:
    """Ten equal discs with one centre: pushed apart along x, and never thrown."""
    discs = [Body(Circle(0.5), mass=1, position=(0, 3)) for _ in range(10)]
    run = direct(Scene(discs), 2.0)
    assert np.abs(run.velocities).max() == 0.0
    assert np.diff(np.sort(run.positions[-1, :, 0])).min() > 0.99
    np.testing.assert_array_equal(run.positions[-1, :, 1], 3.0)


def test_bodies_wedged_in_one_another_by_friction_come_apart() -> None:
    """No push frees them while their friction holds: they give way a little, and come apart.

    The smallest part of a heap (bodies-in-one-place:80046) that stayed as it was for ever.
    """
    triangle, square = Polygon([(-0.5, -0.3), (0.5, -0.3), (0.0, 0.6)]), Polygon.box(1, 1)
    places = [
        (triangle, (-0.06, -0.12), 0.64),
        (triangle, (-0.14, -0.16), 1.88),
        (square, (-0.15, 0.03), 1.98),
        (triangle, (-0.17, 0.17), 3.02),
    ]
    rough = Material(restitution=0.0, friction=0.827)
    heap = [Body(s, mass=1, position=p, angle=angle, material=rough) for s, p, angle in places]
    run = direct(Scene(heap), 2.0)
    assert np.abs(run.velocities).max() == 0.0
    assert run.max_penetration[-1] < 2e-3


@settings(max_examples=share(20))
@example(places=247068, mu=0.7066369286289081, count=9)
@given(places=st.integers(0, 10**6), mu=st.floats(0.1, 1.0), count=st.integers(4, 10))
def test_what_is_taken_from_contacts_that_stick_costs_energy(
    places: int, mu: float, count: int
) -> None:
    """In a jam of boxes (dropped-into-each-other:14000082) it gave a box 168 m/s."""

    def energy(island: Island) -> float:
        motions = [(b.vx, b.vy, b.w, b.inv_m, b.inv_i) for b in island.bodies if b.inv_m > 0.0]
        return sum((vx * vx + vy * vy) / m + w * w / i for vx, vy, w, m, i in motions) / 2.0

    def settled(island: Island, quiet: float) -> None:
        before = energy(island)
        settle(island, quiet)
        assert energy(island) <= before * (1.0 + ROUNDING)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("lesson_code.engine.solvers.direct.settle", settled)
        direct(dropped_boxes(places, mu, count), 1.0)


def test_islands_without_an_exact_answer_are_counted() -> None:
    """A ball between walls that close has none; a stack has one in every step."""
    walls = [Body(Polygon.box(1, 2), position=(-0.9 * s, 0), velocity=(s, 0)) for s in (1.0, -1.0)]
    jammed = Scene([*walls, Body(Circle(0.5), mass=1)])
    for scene, count in ((jammed, 3), (stack([1.0] * 3), 0)):
        stepper = EngineStepper(
            scene, solver="direct", dt=1e-3, iterations=1, substeps=1, combine=MixingRule()
        )
        for _ in range(3):
            stepper.advance(1)
        assert stepper.world.state.softened == count


def test_ball_between_walls_that_close_stays_finite() -> None:
    """There is no answer: the ball is held by both, in the middle, and no number overflows."""
    walls = [Body(Polygon.box(1, 2), position=(-1.5 * s, 0), velocity=(s, 0)) for s in (1.0, -1.0)]
    run = direct(Scene([*walls, Body(Circle(0.5), mass=1)]), 0.9)
    np.testing.assert_allclose(run.positions[:, 2], 0, atol=1e-9)
    assert np.isfinite(run.contacts.normal_impulse).all()


# Bounces


@pytest.mark.parametrize("rule", ["simultaneous", "sequential"])
@pytest.mark.parametrize("law", ["newton", "energetic"])
@pytest.mark.parametrize("e", [0.5, 1.0])
def test_elastic_stack_at_rest_stays_at_rest(e: float, law: str, rule: str) -> None:
    """Five boxes that would bounce, but have no reason to."""
    scene = stack([1.0] * 5, e=e)
    run = direct(scene, 2.0, sample="end", impacts=rule, restitution_law=law)
    np.testing.assert_allclose(run.positions[-1], run.positions[0], atol=QUIET)


@pytest.mark.parametrize("rule", ["simultaneous", "sequential"])
def test_elastic_stack_that_falls_stays_bounded(rule: str) -> None:
    """Dropped by 1 to 5 cm, e = 1: in 5 s no energy comes that was not there.

    Allowed is what the steps themselves make: v g dt / 2 for each mass, both ways.
    """
    run = direct(stack([1.0] * 5, e=1.0, sunk=-0.01), 5.0, impacts=rule)
    speed = np.abs(run.velocities[0:, :, 1]).max()
    assert run.energy.max() - run.energy[0] < 5 * speed * G * DT
    assert speed < 5.0


@pytest.mark.filterwarnings("ignore:.*steps there were more than 64 impacts:RuntimeWarning")
@settings(max_examples=share(100), deadline=None)
@given(
    decades=st.floats(0, 8),
    speeds=st.tuples(st.floats(0.3, 2), st.floats(0.3, 2)),
    start=st.tuples(st.floats(-0.3, 0.3), st.floats(-1, 1)),
    aside=st.floats(-0.1, 0.1),
    is_box=st.booleans(),
)
def test_elastic_body_that_two_heavy_ones_squeeze_keeps_the_energy(
    decades: float,
    speeds: tuple[float, float],
    start: tuple[float, float],
    aside: float,
    is_box: bool,
) -> None:
    """It hits them some sqrt(M/m) times while they turn round, by the default call.

    Each of its hits rounds the velocities of the heavy bodies, and it moves with the difference.
    """
    smooth, ratio = Material(1.0, 0.0), 10**decades
    shapes = [Polygon.box(1, 1), Polygon.box(0.4, 0.4) if is_box else Circle(0.2), Circle(0.5)]
    masses = [ratio, 1.0, 2 * ratio]
    places = [(-1.5, aside), (start[0], 0.0), (1.5, -aside)]
    ways = [speeds[0], start[1], -speeds[1]]
    bodies = [
        Body(shape, mass=mass, position=place, velocity=(vx, 0), material=smooth)
        for shape, mass, place, vx in zip(shapes, masses, places, ways, strict=True)
    ]
    energy = simulate(Scene(bodies), 3.0, sample=None).kinetic_energy
    assert np.abs(energy / energy[0] - 1).max() <= ROUNDING + SQUEEZED * ratio


def tilted_plank(tilt: float, e: float, mu: float, vx: float, vy: float, w: float) -> Scene:
    """Return a plank that comes down on a rough floor with one corner a little lower."""
    rough = Material(restitution=e, friction=mu)
    plank = Body(
        Polygon.box(1.5, 0.3),
        mass=1.0,
        position=(0.0, 0.15 + 0.75 * math.sin(abs(tilt))),
        angle=tilt,
        velocity=(vx, -vy),
        angular_velocity=w,
        material=rough,
    )
    return Scene([Body(Segment((-9, 0), (9, 0)), material=rough), plank], gravity=(0, -G))


@settings(max_examples=share(150))
@given(
    st.floats(-9.0, -4.0),
    st.floats(0.0, 0.6),
    st.floats(0.05, 0.8),
    st.floats(-1.0, 1.0),
    st.floats(0.0, 0.3),
    st.floats(-1.0, 1.0),
)
def test_plank_on_two_corners_of_nearly_one_height_is_its_mirror_image(
    power: float, e: float, mu: float, vx: float, vy: float, w: float
) -> None:
    """Friction on both of them stops its sliding, and not its spin by the lever between them."""
    tilt = 10.0**power
    here = simulate(tilted_plank(tilt, e, mu, vx, vy, w), 0.2)
    there = simulate(tilted_plank(-tilt, e, mu, -vx, vy, -w), 0.2)
    assert np.abs(here.velocities[:, 1] - there.velocities[:, 1] * [-1, 1]).max() <= MIRRORED
    assert np.abs(here.angular_velocities + there.angular_velocities).max() <= MIRRORED


def balls_beside_a_plank(moves: float, times: list[float], e: float) -> Scene:
    """Return a plank on a floor that still moves, and balls that hit the floor after some times."""
    elastic = Material(restitution=e, friction=0.5)
    plank = Body(Polygon.box(1.5, 0.3), mass=1.0, position=(-4, 0.15), velocity=(0, -moves))
    balls = [
        Body(
            Circle(0.5),
            mass=1.0,
            position=(2.0 * n, 0.5 + time + G * time**2 / 2),
            velocity=(0.3, -1.0),
            material=elastic,
        )
        for n, time in enumerate(times)
    ]
    return Scene([Body(Segment((-9, 0), (9, 0)), material=elastic), plank, *balls], gravity=(0, -G))


@settings(max_examples=share(60))
@given(
    st.floats(-14.0, -8.0),
    st.lists(st.floats(2e-5, 3e-4), min_size=3, max_size=3),
    st.floats(0.1, 0.8),
)
def test_rounding_of_what_rests_changes_no_impact_elsewhere(
    power: float, between: list[float], e: float
) -> None:
    """Balls bounce when they touch, whether or not rounding has left a plank a speed."""
    times = np.cumsum(between).tolist()
    still, moving = (
        simulate(balls_beside_a_plank(moves, times, e), 2 * DT) for moves in (0.0, 10.0**power)
    )
    difference = np.abs(moving.positions[:, 2:] - still.positions[:, 2:]).max()
    assert difference <= ROUNDING


def test_box_that_falls_on_a_stack_does_not_pass_through() -> None:
    """Continuous detection is on: 1 m thick boxes, 200 m/s, 3.3 m in a step."""
    scene = stack([1.0] * 3)
    hammer = Body(Circle(0.2), mass=1e-2, position=(0, 30), velocity=(0, -200))
    run = direct(Scene([*scene.bodies, hammer], gravity=(0, -G)), 0.5)
    assert run.positions[:, 4, 1].min() > 2.9
