"""The event-driven solver against closed forms, and against the solvers that go in steps."""

from __future__ import annotations

import math
from contextlib import closing
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Scene, Segment, simulate
from lesson_code.chapters.ch07_time_of_impact.scenes import in_the_middle
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes import gas
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.evidence.scenes.spinning_discs import random_impacts, scene_of
from lesson_code.reference.closed_forms import bounce_times, bouncing_ball, rest_time
from lesson_code.reference.contact_closed_forms import Struck, disc_impact
from lesson_code.reference.event_closed_forms import (
    block_collisions,
    hard_disc_collision_rate,
    hard_disc_compressibility,
)
from lesson_code.reference.rigid_body_closed_forms import roll_down, slide_to_roll

ROUNDING = 1e-12
"""A handful of events, each right to 1e-16 of numbers near 1; 4e-15 was seen."""

BALL_IN_BOX = 1e-13
"""m, after 10 reflections in 10 s: each turns the last digit of a time into 1e-15 m."""

ZENO = 1e-12
"""s: 138 flights, each predicted to half the clock's last digit of 9e-16 s; and what is left of the
series when the ball is laid down: 2 v / (g (1 - e)) = 4e-13 s."""

LAID_DOWN = 3e-16
"""m: where the last flight ends, to a few of the last digits of 0.5 m; after that nothing moves."""

IMPACT = 1e-12
"""Of the fastest speed: masses of 1e-3 to 1e3 kg, one impact."""

PRESSURE, COLLISION_RATE = 0.005, 0.025
"""Of the figure. Henderson's formula is right to a few parts in a thousand, and so is Enskog's rate
with the same chi. Chance leaves 0.3 % in 250 s: 0.6 % was seen with another seed."""

SHORT = 1e-12
"""s: a step in which an impact's normal turns by no more than that in rad."""

DIGITS = {1: 3, 10**2: 31, 10**4: 314, 10**6: 3141, 10**8: 31415, 10**10: 314159}
MORE_DIGITS = {10**12: 3141592, 10**14: 31415926}


def collisions(scene: Scene, until: float) -> int:
    """Return how many collisions there are until a time, s, or until nothing happens any more."""
    settings: dict[str, Any] = {
        "combine": mixing_rule("workbook"),
        "keep_impulses": False,
        "compiled": None,
    }
    with closing(ExactSolver(scene, **settings)) as solver:
        solver.advance(until)
        return solver.collisions


# Digits of pi


@pytest.mark.parametrize(("mass_ratio", "digits"), DIGITS.items())
def test_collisions_of_two_blocks_and_a_wall_are_digits_of_pi(mass_ratio: int, digits: int) -> None:
    """For a mass ratio of 100^k, the first k + 1 of them; then nothing meets any more."""
    assert collisions(exact_scenes.two_blocks(mass_ratio), 1e9) == digits


@pytest.mark.full
@pytest.mark.parametrize(("mass_ratio", "digits"), MORE_DIGITS.items())
def test_more_collisions_of_two_blocks_are_more_digits_of_pi(mass_ratio: int, digits: int) -> None:
    """Up to 31,415,926: seconds where there is a compiler, else half an hour of plain Python."""
    assert collisions(exact_scenes.two_blocks(mass_ratio), 1e9) == digits


@pytest.mark.parametrize("mass_ratio", [0.3, 2.0, 7.0, 1234.5, 98765.4])
def test_collisions_of_two_blocks_of_any_masses_are_those_of_the_unfolded_wedge(
    mass_ratio: float,
) -> None:
    """Galperin's count, for masses that are no power of 100."""
    assert collisions(exact_scenes.two_blocks(mass_ratio), 1e9) == block_collisions(mass_ratio)


# A ball in a box


def test_ball_in_a_box_is_where_the_unfolded_path_ends() -> None:
    """After every collision in 10 s, to 1e-13 m."""
    run = simulate(exact_scenes.ball_in_a_box(), 10.0, solver="exact")
    assert len(run.contacts) == 10
    assert exact_scenes.error_in_the_box(run).max() <= BALL_IN_BOX


def test_ball_in_a_box_is_not_there_when_pymunk_steps_it() -> None:
    """With 60 steps a second it is 0.4 m away: each bounce is up to one step late."""
    run = simulate(exact_scenes.ball_in_a_box(), 10.0, solver="pymunk", dt=1 / 60)
    assert exact_scenes.error_in_the_box(run)[-1] > 1e-2


def test_ball_in_a_box_can_be_asked_at_any_time() -> None:
    """Between two events motion has a closed form: no state is interpolated."""
    times = np.random.default_rng(0).uniform(0, 10, 100)
    run = simulate(exact_scenes.ball_in_a_box(), 10.0, solver="exact", sample=times)
    assert run.times.tolist() == times.tolist()
    assert exact_scenes.error_in_the_box(run).max() <= BALL_IN_BOX


# A ball that bounces to rest


@pytest.mark.parametrize("restitution", [0.0, 0.3, 0.5, 0.8])
def test_bouncing_ball_rests_after_infinitely_many_bounces(restitution: float) -> None:
    """At sqrt(2 h / g) (1 + e) / (1 - e): 4.02492 s for e = 0.8; then nothing happens any more."""
    solver = ExactSolver(
        exact_scenes.bouncing_to_rest(restitution), combine=mixing_rule("workbook")
    )
    times = []
    while (time := solver.next_collision(1e9)) is not None:
        times.append(time)
    assert times[-1] == pytest.approx(rest_time(1.0, restitution, 10.0), abs=ZENO)
    assert solver.states(1e9)[1] == pytest.approx((0.0, 0.5, 0.0, 0.0, 0.0, 0.0), abs=LAID_DOWN)
    assert solver.states(1e9)[1].tolist() == solver.states(times[-1])[1].tolist()


@pytest.mark.parametrize("restitution", [0.9, 0.98, 0.99, 0.995])
def test_bouncing_ball_of_high_restitution_rests_too(restitution: float) -> None:
    """Its last bounces are shorter than the clock's last digit can tell."""
    solver = ExactSolver(
        exact_scenes.bouncing_to_rest(restitution), combine=mixing_rule("workbook")
    )
    expected = rest_time(1.0, restitution, 10.0)
    solver.advance(expected * (1 - 1e-8))
    assert solver.states(expected * (1 - 1e-8))[1][4] != 0.0
    solver.advance(1e9)
    assert solver.states(expected * (1 + 1e-9))[1].tolist() == [0.0, 0.5, 0.0, 0.0, 0.0, 0.0]


def test_bouncing_ball_bounces_and_flies_as_the_closed_form_says() -> None:
    """The times of the first bounces, and the height at any time."""
    scene = exact_scenes.bouncing_to_rest(0.8)
    times = np.linspace(0, 5, 101)
    run = simulate(scene, 5.0, solver="exact", sample=times)
    bounces = run.contacts.time[:20]
    np.testing.assert_allclose(bounces, bounce_times(1.0, 0.8, 20, 10.0), rtol=ROUNDING)
    heights = run.positions[:, 1, 1] - 0.5
    np.testing.assert_allclose(heights, bouncing_ball(times, 1.0, 0.8, 10.0), atol=ZENO)


# Impacts with friction and spin


def test_impact_of_two_spinning_discs_is_that_of_the_two_equations() -> None:
    """100 random pairs that stick or slide, masses from 1 g to 1 t."""
    kinds = set()
    for a, b, restitution, friction in random_impacts(100, seed=7):
        normal = (b.position - a.position) / np.hypot(*(b.position - a.position))
        struck = [
            Struck(1 / d.mass, 1 / d.inertia, d.velocity, d.angular_velocity, arm)
            for d, arm in ((a, a.radius * normal), (b, -b.radius * normal))
        ]
        expected = disc_impact(*struck, normal, restitution, friction)
        run = simulate(scene_of(a, b, restitution, friction), 1e-9, solver="exact")
        fastest = max(a.fastest, b.fastest)
        rims = (run.angular_velocities[-1] - expected.angular_velocities) * (a.radius, b.radius)
        assert np.abs(run.velocities[-1] - expected.velocities).max() <= IMPACT * fastest
        assert np.abs(rims).max() <= IMPACT * fastest
        kinds.add(expected.kind)
    assert kinds == {"sticks", "slides"}


def test_impact_of_a_spinning_disc_on_a_wall_is_that_of_the_two_equations() -> None:
    """A wall is a body whose inverse mass is 0; here it moves, too."""
    velocity, spin = np.array([2.0, -3.0]), 4.0
    wall_velocity = (0.5, 1.0)
    ball = Struck(0.5, 1 / 0.25, velocity, spin, np.array([0.0, -0.5]))
    wall = Struck(0.0, 0.0, np.array(wall_velocity), 0.0, np.array([0.0, 0.0]))
    expected = disc_impact(wall, ball, (0.0, 1.0), 0.6, 0.2)
    material = Material(0.6, 0.2)
    scene = Scene(
        [
            Body(Segment((-9, 0), (9, 0)), velocity=wall_velocity, material=material),
            Body(
                Circle(0.5),
                mass=2.0,
                position=(0, 1.5),
                velocity=velocity,
                angular_velocity=spin,
                material=material,
            ),
        ]
    )
    run = simulate(scene, 1.0, solver="exact")
    assert run.contacts.time.tolist() == pytest.approx([0.25], rel=ROUNDING)
    np.testing.assert_allclose(run.velocities[-1, 1], expected.velocities[1], rtol=ROUNDING)
    assert run.angular_velocities[-1, 1] == pytest.approx(expected.angular_velocities[1])
    assert run.contacts.normal_impulse.tolist() == pytest.approx([expected.normal_impulse])
    assert run.contacts.tangent_impulse.tolist() == pytest.approx([expected.tangent_impulse])


# Sliding and rolling


@pytest.mark.parametrize("inertia_ratio", [1 / 2, 1.0, math.inf], ids=["disc", "hoop", "no spin"])
def test_sliding_disc_rolls_in_the_end_at_the_closed_forms_speed(inertia_ratio: float) -> None:
    """2/3 of the speed for a disc, 1/2 for a hoop; one that cannot turn stops."""
    times = [0.2, 0.5, 1.0, 4.0]
    scene = scenes.sliding_disc(6.0, 0.3, inertia_ratio)
    run = simulate(scene, 4.0, solver="exact", sample=times)
    if math.isinf(inertia_ratio):
        velocity = np.maximum(6.0 - 0.3 * scenes.GRAVITY * np.array(times), 0.0)
        spin = np.zeros(4)
    else:
        velocity, spin = slide_to_roll(times, 6.0, 0.0, 1.0, inertia_ratio, 0.3, scenes.GRAVITY)
        assert velocity[-1] == pytest.approx(6.0 / (1 + inertia_ratio))
    np.testing.assert_allclose(run.velocities[:, 1, 0], velocity, atol=ROUNDING)
    np.testing.assert_allclose(run.angular_velocities[:, 1], spin, atol=ROUNDING)
    assert run.positions[:, 1, 1].tolist() == [1.0] * 4


@pytest.mark.parametrize("friction", [0.0, 0.05, 0.19, 0.1924, 0.1925, 0.5])
def test_disc_on_an_incline_rolls_or_slips_as_the_closed_form_says(friction: float) -> None:
    """It rolls from mu = tan(30 deg) / 3 = 0.19245 on."""
    angle = math.radians(30)
    acceleration, rim = roll_down(angle, 0.5, friction, scenes.GRAVITY)
    run = simulate(scenes.disc_on_incline(angle, friction), 2.0, solver="exact", sample=[1.0, 2.0])
    along = run.velocities[:, 1] @ (-math.cos(angle), -math.sin(angle))
    np.testing.assert_allclose(along, [acceleration, 2 * acceleration], rtol=ROUNDING)
    np.testing.assert_allclose(run.angular_velocities[:, 1], [rim, 2 * rim], rtol=ROUNDING)
    away = run.positions[:, 1] @ (-math.sin(angle), math.cos(angle))
    np.testing.assert_allclose(away, 1.0, rtol=ROUNDING)


def test_disc_thrown_with_backspin_slides_stops_and_comes_back() -> None:
    """It turns round while it slides: one closed form for all of it."""
    bodies = list(scenes.sliding_disc(1.0, 0.3).bodies)
    bodies[1] = Body(
        Circle(1.0),
        position=(0, 1),
        velocity=(1, 0),
        angular_velocity=10.0,
        mass=1.0,
        material=Material(0.0, 0.3),
    )
    times = [0.1, 1 / 3, 1.0, 3.0]
    run = simulate(Scene(bodies, (0, -scenes.GRAVITY)), 3.0, solver="exact", sample=times)
    velocity, spin = slide_to_roll(times, 1.0, 10.0, 1.0, 0.5, 0.3, scenes.GRAVITY)
    assert velocity[0] > 0 > velocity[-1]
    np.testing.assert_allclose(run.velocities[:, 1, 0], velocity, atol=ROUNDING)
    np.testing.assert_allclose(run.angular_velocities[:, 1], spin, atol=ROUNDING)


# A gas of hard discs


def deviations(side: int, covered: float, seconds: float, seed: int) -> tuple[float, float]:
    """Return how far pressure and collision rate are from the formulas, parts of one."""
    sample = np.linspace(0, seconds, 4 * math.ceil(seconds))
    run = simulate(gas.disc_gas(side, covered, seed=seed), seconds, solver="exact", sample=sample)
    seen = in_the_middle(run, since=10.0)
    rate = hard_disc_collision_rate(seen.covered, gas.DIAMETER, gas.MASS, gas.ENERGY)
    return (
        seen.compressibility / hard_disc_compressibility(seen.covered) - 1,
        seen.collision_rate / rate - 1,
    )


@pytest.mark.full
def test_disc_gas_presses_and_collides_as_henderson_and_enskog_say() -> None:
    """256 discs that cover 0.3 of the box: pressure within 0.5 %, collision rate within 2.5 %."""
    pressure, rate = deviations(16, 0.3, 250.0, seed=1)
    assert abs(pressure) <= PRESSURE
    assert abs(rate) <= COLLISION_RATE


@pytest.mark.full
@pytest.mark.parametrize("covered", [0.1, 0.2, 0.3, 0.4])
def test_disc_gas_of_any_density_presses_and_collides_as_the_formulas_say(covered: float) -> None:
    """256 discs, some hundred thousand collisions each; chance leaves 0.15 % of the pressure."""
    pressure, rate = deviations(16, covered, 1_800.0 / covered, seed=2)
    assert abs(pressure) <= PRESSURE
    assert abs(rate) <= COLLISION_RATE


# The solvers that go in steps


def three_balls() -> Scene:
    """Return three balls in a box with a rough floor, and gravity."""
    material = Material(0.8, 0.0)
    rows = ((1.0, (1, 2), (1.5, 0.3)), (2.0, (2.5, 1.2), (-1, 1)), (0.5, (3.2, 2.4), (-0.4, -1)))
    balls = [
        Body(Circle(0.3), mass=m, position=x, velocity=v, material=material) for m, x, v in rows
    ]
    return Scene([*exact_scenes.box(4.0, 3.0, material), *balls], gravity=(0, -9.81))


def difference(scene: Scene, duration: float, **settings: Any) -> float:
    """Return how far a run in steps ends from the exact one, m."""
    exact = simulate(scene, duration, solver="exact", sample="end")
    other = simulate(scene, duration, sample="end", **settings)
    return float(np.hypot(*(other.positions[-1] - exact.positions[-1]).T).max())


@pytest.mark.parametrize("solver", ["sequential", "pymunk"])
def test_run_in_ever_smaller_steps_comes_nearer_to_the_exact_one(solver: str) -> None:
    """Ten times as many steps, a ninth of the error: first order, for ours and for pymunk."""
    steps = [1 / 100, 1 / 1000, 1 / 10000]
    errors = [difference(three_balls(), 0.5, solver=solver, dt=dt) for dt in steps]
    assert errors[0] > 5 * errors[1] > 25 * errors[2]
    assert errors[2] < 1e-3


@pytest.mark.parametrize("solver", ["sequential", "pymunk"])
def test_impulses_of_one_impact_are_the_same_from_every_solver(solver: str) -> None:
    """Bodies, normal, normal and tangent impulse of an oblique impact with spin and friction."""
    material = Material(0.7, 0.3)
    scene = Scene(
        [
            Body(Circle(0.5), mass=3.0, velocity=(-1, 0), position=(0.9, 0), material=material),
            Body(Circle(0.5), mass=1.0, velocity=(2, 1), angular_velocity=5.0, material=material),
        ]
    )
    exact = simulate(scene, SHORT, solver="exact").contacts
    stepped = simulate(scene, SHORT, solver=solver, dt=SHORT).contacts
    assert (exact.body_a.tolist(), exact.body_b.tolist()) == ([0], [1])
    assert exact.normal.tolist() == [[-1.0, 0.0]]
    for name in ("body_a", "body_b", "normal", "normal_impulse", "tangent_impulse"):
        np.testing.assert_allclose(getattr(exact, name), getattr(stepped, name), atol=10 * SHORT)
