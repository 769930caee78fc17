"""Rules for impacts: cradles, drops and breaks, one by one or at once; energy by either law."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine.solvers import impact_rules
from lesson_code.engine.solvers.contact_problem import Problem
from lesson_code.engine.solvers.impact_rules import energy_gain, held_back, newton, one_by_one
from lesson_code.reference.impact_closed_forms import (
    break_shot,
    cradle_all_at_once,
    cradle_one_by_one,
    flat_landing,
    two_ball_drop,
)

ROUNDING = 1e-12
"""m/s: a few impacts of bodies at 1 m/s."""

GROWTH = 1e-12
"""Of the kinetic energy before an impact: rounding in sums of squares of velocities."""

OVERLAP = 1e-6
"""m: touching is no contact; this much is, and turns no normal by more than itself."""

PLACED = 1e-5
"""m/s: discs that overlap by OVERLAP stand so far from where the closed form has them."""

RULES = ["simultaneous", "sequential"]
LAWS = ["newton", "energetic"]

seeds = st.integers(0, 10**9)


def row_of_balls(velocities: Any, e: float = 1.0) -> Scene:
    """Return equal balls in a row, each just in the next."""
    return Scene(
        [
            Body(
                Circle(0.5),
                mass=1,
                position=(k * (1 - OVERLAP), 0),
                velocity=(float(v), 0),
                material=Material(e),
            )
            for k, v in enumerate(velocities)
        ]
    )


def struck(scene: Scene, **rules: str) -> Run:
    """Return what becomes of a scene in one short step."""
    return simulate(scene, 1e-6, dt=1e-6, solver="direct", **rules)


# Rows of balls


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("backwards", [False, True])
@pytest.mark.parametrize("count", [1, 2, 3, 4])
def test_cradle_in_sequence_lets_out_as_many_as_come_in(
    count: int, backwards: bool, law: str
) -> None:
    """1 to 4 of 5 balls come in from either side, and as many leave on the other."""
    before = np.array([1.0] * count + [0.0] * (5 - count))
    after = before[::-1]
    if backwards:
        before, after = -before[::-1], -after[::-1]
    run = struck(row_of_balls(before), impacts="sequential", restitution_law=law)
    np.testing.assert_allclose(run.velocities[-1, :, 0], after, atol=ROUNDING)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("count", range(2, 9))
def test_cradle_at_once_shares_the_velocity(count: int, law: str) -> None:
    """-(n - 2)/n and 2/n: Newton's rule at every contact at the same instant."""
    run = struck(row_of_balls([1.0, *[0.0] * (count - 1)]), restitution_law=law)
    expected = cradle_all_at_once(count, 1.0)
    np.testing.assert_allclose(run.velocities[-1, :, 0], expected, atol=ROUNDING)


def test_cradle_one_by_one_is_the_closed_form() -> None:
    """The last of any number leaves alone, with the whole velocity."""
    for count in range(2, 9):
        run = struck(row_of_balls([2.0] + [0.0] * (count - 1)), impacts="sequential")
        expected = cradle_one_by_one(count, 2.0)
        np.testing.assert_allclose(run.velocities[-1, :, 0], expected, atol=ROUNDING)


@pytest.mark.parametrize("ratio", [3.0, 10.0, 100.0])
def test_two_balls_dropped_in_sequence_throw_the_upper_one_up(ratio: float) -> None:
    """The lower one bounces first, and meets the upper one coming down: (3M - m)/(M + m)."""
    ball = Material(1.0)
    scene = Scene(
        [
            Body(Segment((-9, 0), (9, 0))),
            Body(
                Circle(0.5),
                mass=ratio,
                position=(0, 0.5 - OVERLAP),
                velocity=(0, -1),
                material=ball,
            ),
            Body(
                Circle(0.5),
                mass=1,
                position=(0, 1.5 - 2 * OVERLAP),
                velocity=(0, -1),
                material=ball,
            ),
        ]
    )
    run = struck(scene, impacts="sequential")
    expected = [float(v) for v in two_ball_drop(ratio, 1.0, 1.0)]
    np.testing.assert_allclose(run.velocities[-1, 1:, 1], expected, atol=ROUNDING)


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_break_at_once_is_symmetric(e: float) -> None:
    """A ball between two that touch: the closed form, which does not know who comes first."""
    side = (1 - OVERLAP) * np.array([math.cos(math.pi / 6), 0.5])
    bodies = [
        Body(Circle(0.5), mass=1, position=p, velocity=v, material=Material(e))
        for p, v in (((0, 0), (1, 0)), (side, (0, 0)), (side * (1, -1), (0, 0)))
    ]
    run = struck(Scene(bodies))
    expected = break_shot(1.0, e)
    np.testing.assert_allclose(run.velocities[-1], expected, atol=PLACED)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("width", "height"), [(1, 1), (1, 10), (1, 30), (10, 1)])
def test_flat_landing_is_exact(width: float, height: float, law: str, rule: str) -> None:
    """Both corners at once: e v up, and no turning, also of the tallest box."""
    material = Material(0.5, 0.5)
    box = Body(
        Polygon.box(width, height),
        mass=1,
        position=(0, height / 2 - OVERLAP),
        velocity=(0, -1),
        material=material,
    )
    scene = Scene([Body(Segment((-50, 0), (50, 0)), material=material), box])
    run = struck(scene, impacts=rule, restitution_law=law)
    up, turning = flat_landing(width, height, 1.0, 0.5)
    assert run.velocities[-1, 1].tolist() == pytest.approx([0.0, up], abs=ROUNDING)
    assert run.angular_velocities[-1, 1] == pytest.approx(turning, abs=ROUNDING)


def test_sequence_without_end_is_ended() -> None:
    """A ball of e = 0.05 between two heavy ones that close: infinitely many hits, all in one step.

    What approaches after so many is stopped: in the end nothing does, and momentum is kept.
    """
    bodies = [
        Body(Circle(0.5), mass=m, position=(x, 0), velocity=(v, 0), material=Material(0.05))
        for x, m, v in ((0, 50, 1), (1 - OVERLAP, 1, 0), (2 - 2 * OVERLAP, 50, -1))
    ]
    run = struck(Scene(bodies), impacts="sequential")
    v = run.velocities[-1, :, 0]
    assert np.diff(v).min() >= -ROUNDING
    assert 50 * v[0] + v[1] + 50 * v[2] == pytest.approx(0, abs=100 * ROUNDING)


def test_strikes_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """With one strike for each contact allowed, what is left is stopped without a bounce."""
    monkeypatch.setattr(impact_rules, "MOST_STRIKES", 0)
    run = struck(row_of_balls([1.0, 0.0]), impacts="sequential")
    np.testing.assert_allclose(run.velocities[-1, :, 0], 0.5, atol=ROUNDING)


# Energy


def rod(rng: np.random.Generator) -> Scene:
    """Return a rod whose tip meets a rough floor."""
    steep, length = rng.uniform(0.1, 1.5), rng.uniform(0.5, 3)
    material = Material(rng.uniform(0, 1), rng.uniform(0, 2))
    height = length / 2 * math.sin(steep)
    body = Body(
        Segment((-length / 2, 0), (length / 2, 0)),
        mass=rng.uniform(0.1, 10),
        position=(0, height - 1e-9),
        angle=steep,
        velocity=(rng.normal(), -abs(rng.normal())),
        angular_velocity=rng.normal(),
        material=material,
    )
    return Scene([Body(Segment((-9, 0), (9, 0)), material=material), body])


def gain(scene: Scene, **rules: str) -> float:
    """Return the part of its kinetic energy that an impact adds to a scene's."""
    run = simulate(scene, 1e-9, dt=1e-9, solver="direct", sample="end", **rules)
    return float(run.kinetic_energy[-1] / run.kinetic_energy[0] - 1)


def test_energy_of_a_falling_rod_grows_by_9_parts_in_16_by_newtons_rule() -> None:
    """Kane's paradox, worked by hand, and the energetic law beside it.

    A rod of 1 kg and 2 m (1/I = 3) at 45 degrees, v = (0, -sqrt 2), w = 3: its energy is 5/2. The
    tip moves at (3, -5)/sqrt 2 and is to leave the floor with (0, 5)/sqrt 2; that takes the
    impulse (7.5, 20.5)/(4 sqrt 2), well inside the cone of mu = 1. It brings, times the mean
    velocity of the tip, 45/32: 9/16 of what there was.
    """
    material = Material(1.0, 1.0)
    body = Body(
        Segment((-1, 0), (1, 0)),
        mass=1,
        position=(0, math.sqrt(0.5) - 1e-9),
        angle=math.pi / 4,
        velocity=(0, -math.sqrt(2)),
        angular_velocity=3.0,
        material=material,
    )
    scene = Scene([Body(Segment((-9, 0), (9, 0)), material=material), body])
    assert gain(scene, restitution_law="newton") == pytest.approx(
        9 / 16, abs=1e-7
    )  # the step turns the rod by 3e-9 rad
    assert gain(scene) <= GROWTH


@pytest.mark.parametrize("rule", RULES)
def test_energy_of_a_rod_never_rises_by_the_energetic_law(rule: str) -> None:
    """300 rods that hit a rough floor with a tip; Newton's rule adds energy to some of them."""
    rng = np.random.default_rng(3)
    scenes = [rod(rng) for _ in range(300)]
    assert max(gain(scene, impacts=rule, restitution_law="energetic") for scene in scenes) <= GROWTH
    assert max(gain(scene, impacts=rule, restitution_law="newton") for scene in scenes) > 1e-3


def crowd(seed: int) -> Scene:
    """Return a dozen boxes and discs heaped into one another, which fly about."""
    rng = np.random.default_rng(seed)
    bodies = []
    for k in range(12):
        shape = Circle(0.5) if rng.random() < 0.4 else Polygon.box(0.9, rng.uniform(0.4, 0.9))
        bodies.append(
            Body(
                shape,
                mass=rng.uniform(0.1, 5),
                position=np.array((k % 4 * 0.85, k // 4 * 0.7)) + rng.uniform(-0.05, 0.05, 2),
                angle=rng.uniform(-3, 3),
                velocity=rng.uniform(-2, 2, 2),
                angular_velocity=rng.uniform(-3, 3),
                material=Material(rng.uniform(0, 1), rng.uniform(0, 1.5)),
            )
        )
    return Scene(bodies)


@pytest.mark.parametrize("rule", RULES)
@settings(max_examples=share(25), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_energy_of_many_impacts_never_rises_by_the_energetic_law(rule: str, seed: int) -> None:
    """Two dozen contacts, each pair with its own restitution and friction."""
    assert gain(crowd(seed), impacts=rule, restitution_law="energetic") <= GROWTH


@settings(max_examples=share(50), phases=[Phase.explicit, Phase.generate])
@given(seed=seeds)
def test_impulses_held_back_gain_nothing_and_reach_as_far_as_that_allows(seed: int) -> None:
    """Where Newton's gain energy, those held back keep what there is; else they are the same."""
    rng = np.random.default_rng(seed)
    g = rng.normal(size=(4, 5))
    problem = Problem(g @ g.T, g @ rng.normal(size=5), rng.uniform(0, 2, 2))
    e = rng.uniform(0, 1, 2)
    x, free = held_back(problem, e), newton(problem, e)
    scale = abs(problem.velocity @ free) + 1
    if energy_gain(problem, free) > 1e-9 * scale:
        assert energy_gain(problem, x) == pytest.approx(0, abs=1e-9 * scale)
    else:
        np.testing.assert_allclose(x, free, atol=1e-6 * scale)


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("law", LAWS)
def test_momentum_of_many_impacts_is_kept(rule: str, law: str) -> None:
    """Whatever the rule: what one body receives another one gives."""
    run = struck(crowd(1), impacts=rule, restitution_law=law)
    np.testing.assert_allclose(run.momentum[-1], run.momentum[0], atol=100 * ROUNDING)


def test_one_by_one_leaves_what_is_quiet() -> None:
    """An approach at the quiet speed is no strike: it does not bounce."""
    problem = Problem(np.diag([1.0, 3.0]), np.array([-1e-9, 0.0]), np.zeros(1))
    x = one_by_one(problem, np.ones(1), [[0]], 1e-8, law=newton)
    assert x.tolist() == [0.0, 0.0]


# Gravity


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize("law", LAWS)
def test_ball_that_bounces_for_ever_keeps_its_height(rule: str, law: str) -> None:
    """Bodies follow their parabolas, and a bounce at e = 1 keeps their speed."""
    ball = Body(Circle(0.5), mass=1, position=(0, 1.5), material=Material(1.0))
    scene = Scene([Body(Segment((-9, 0), (9, 0))), ball], gravity=(0, -10))
    run = simulate(scene, 5.0, solver="direct", impacts=rule, restitution_law=law)
    v, y = run.velocities[:, 1, 1], run.positions[:, 1, 1]
    kept = v * v / 2 + 10 * y
    np.testing.assert_allclose(kept, kept[0], rtol=1e-12)
