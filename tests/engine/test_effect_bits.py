"""An effect that a scene does not call for changes nothing: not a number, forced on or left out.

Each effect has a way to draw scenes that do not call for it, and that the plan leaves it out of
them is asserted. States and contacts are compared number for number, where -0.0 counts as 0.0:
0.0 times a negative number is -0.0, which nobody adds where the effect is left out.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.engine import stepper
from lesson_code.engine.compiled import link
from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.core.broad_phase import uniform_grid
from lesson_code.engine.core.constants import QUIET_TIME, REACH, SPEED_DOUBT, STILL
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.pipeline import Pipeline, SolverStages
from lesson_code.engine.core.step import rigid_part
from lesson_code.engine.effects.choice import EFFECTS, capabilities
from lesson_code.engine.effects.continuous import fastest_way
from lesson_code.engine.effects.flags import EVERY_EFFECT
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.effect_costs.calls import calls_of

SOLVERS = ["sequential", "substep", "direct", "naive"]

DURATION, STEPS, DT = 0.5, 30, 1 / 60
"""s: as long as most runs are, and 30 steps."""

LONG_ENOUGH = 2.0 * QUIET_TIME
"""s: what lies still falls asleep in it, and some of that is woken."""

BARELY = 0.999
"""Of the speed from which on a body is watched."""


seeds = st.integers(0, 10**9)


class Spared(NamedTuple):
    """A scene that does not call for an effect, and how it is run."""

    scene: Scene
    duration: float = DURATION
    along: dict[str, bool] = {}  # noqa: RUF012 - nobody writes to it


def shape_of(rng: np.random.Generator, *, cornered: bool) -> Any:
    """Return a circle, or a box, a triangle to hexagon or a rod of about 1 m."""
    kind = rng.integers(4) if cornered else 0
    size = rng.uniform(0.3, 0.55)
    if kind == 0:
        return Circle(size)
    if kind == 1:
        return Polygon.box(2 * size, size)
    if kind == 2:
        return Polygon.regular(int(rng.integers(3, 7)), size)
    return Segment((-size, 0), (size, 0), radius=0.2)


def crowd(
    seed: int,
    *,
    cornered: bool = True,
    cornered_walls: bool = True,
    walls: int = 3,
    gravity: bool = True,
    damping: bool = True,
    restitution: bool = True,
    friction: bool = True,
    turning: bool = True,
    speed: float = 4.0,
    walls_move: bool = True,
) -> Scene:
    """Return a random scene of bodies that press to its middle, so that many meet.

    What is named is drawn, and is not in the scene where it is False.
    """
    rng = np.random.default_rng(seed)
    surfaces = _surfaces(rng, restitution=restitution, friction=friction)
    bodies = []
    for n in range(int(rng.integers(2, 7))):
        place: Any = np.array([n % 3 - 1.0, n // 3 - 0.5]) * 1.15 + rng.uniform(-0.1, 0.1, 2)
        shape = shape_of(rng, cornered=cornered)
        turns = turning and rng.random() < 0.7
        may_turn = turning or (isinstance(shape, Circle) and not friction and n % 2 == 0)
        bodies.append(
            Body(
                shape,
                mass=rng.uniform(0.5, 2.0),
                inertia=None if may_turn else math.inf,
                position=place,
                angle=rng.uniform(-3, 3),
                velocity=thrown(rng, place, speed),
                angular_velocity=rng.uniform(-5, 5) if turns else 0.0,
                material=next(surfaces),
            )
        )
    moves = walls_move and rng.random() < 0.3
    for n in range(int(rng.integers(0, walls + 1))):
        shape = shape_of(rng, cornered=cornered_walls)
        bodies.insert(
            int(rng.integers(0, len(bodies) + 1)),
            Body(
                shape,
                position=(1.2 * (n - 1), -1.8 + 0.1 * n),
                velocity=(0.0, 0.5 if moves else 0.0),
                angular_velocity=1.0 if moves and turning else 0.0,
                material=next(surfaces),
            ),
        )
    return Scene(
        bodies,
        gravity=(rng.uniform(-1, 1), -10.0) if gravity and rng.random() < 0.7 else (0.0, -0.0),
        damping=rng.uniform(0.0, 1.0) if damping and rng.random() < 0.5 else 0.0,
    )


def thrown(rng: np.random.Generator, place: Any, speed: float) -> Any:
    """Return a velocity to the middle, more or less."""
    return -speed * place / 2 + speed / 4 * rng.uniform(-1, 1, 2)


def _surfaces(rng: np.random.Generator, *, restitution: bool, friction: bool) -> Iterator[Material]:
    """Yield materials; without an effect no pair has it, though a single body may ask for it.

    0.0 wins over all others by both rules; where one body asks, all others say 0.0.
    """
    one_asks = rng.random() < 0.5
    first = True
    while True:
        yield Material(
            _coefficient(rng, 1.0, drawn=restitution, zero=one_asks, asks=first),
            _coefficient(rng, 1.5, drawn=friction, zero=one_asks, asks=first),
        )
        first = False


def _coefficient(
    rng: np.random.Generator, most: float, *, drawn: bool, zero: bool, asks: bool
) -> float | None:
    """Return a coefficient: any, or one that makes no pair have the effect."""
    value = rng.uniform(0, most)
    if drawn:
        return value if rng.random() < 0.8 else None
    if zero:
        return value if asks else 0.0
    return 0.0 if rng.random() < 0.5 else None


def in_lanes(seed: int) -> Scene:
    """Return bodies that fly fast, each in a lane of its own, beside others that stand."""
    rng = np.random.default_rng(seed)
    bodies = []
    for n in range(int(rng.integers(2, 9))):
        stands = rng.random() < 0.3
        bodies.append(
            Body(
                shape_of(rng, cornered=True),
                mass=None if stands else rng.uniform(0.5, 2.0),
                position=(rng.uniform(-3, 3), 4.0 * n),
                velocity=(0.0, 0.0) if stands else (rng.uniform(-90, 90), rng.uniform(-1, 1)),
                angular_velocity=rng.uniform(-9, 9),
                material=Material(*rng.uniform(0, 1, 2)),
            )
        )
    return Scene(bodies, gravity=(rng.uniform(-9, 9), -3.0), damping=rng.choice([0.0, 0.5]))


def just_slow_enough(seed: int) -> Scene:
    """Return bodies as fast as they may be, all energy in one of them, without being watched."""
    scene = crowd(
        seed,
        gravity=False,
        damping=False,
        restitution=seed % 2 == 0,
        friction=seed % 2 == 1,  # both, and a bounce at a corner may gain speed
        walls_move=False,
    )
    way, room = fastest_way(scene, DT)
    return faster(scene, BARELY * room / (SPEED_DOUBT * way))


def faster(scene: Scene, times: float) -> Scene:
    """Return a scene in which all moves so many times as fast."""
    bodies = [
        replace(
            body,
            velocity=(times * body.velocity[0], times * body.velocity[1]),
            angular_velocity=times * body.angular_velocity,
        )
        for body in scene.bodies
    ]
    return Scene(bodies, scene.gravity, scene.damping)


def calm(seed: int) -> Scene:
    """Return bodies of which most lie still, one on the other, until the others come."""
    scene = crowd(seed, gravity=False)
    bodies = [
        replace(body, velocity=(0, 0), angular_velocity=0.0)
        if n % 3 and not body.is_static
        else body
        for n, body in enumerate(scene.bodies)
    ]
    return faster(Scene(bodies, damping=scene.damping), 0.3)


SPARED: dict[str, Callable[[int], Spared]] = {
    "collisions": lambda seed: Spared(in_lanes(seed)),
    "broad_phase": lambda seed: Spared(crowd(seed)),
    "outlines": lambda seed: Spared(crowd(seed, cornered=False, cornered_walls=False)),
    "manifolds": lambda seed: Spared(crowd(seed, cornered=False)),
    "internal_edges": lambda seed: Spared(crowd(seed, walls=1)),
    "continuous": lambda seed: Spared(just_slow_enough(seed)),
    "restitution": lambda seed: Spared(crowd(seed, restitution=False)),
    "friction": lambda seed: Spared(crowd(seed, friction=False)),
    "rotation": lambda seed: Spared(crowd(seed, turning=False, friction=seed % 2 == 0)),
    "gravity": lambda seed: Spared(crowd(seed, gravity=False)),
    "damping": lambda seed: Spared(crowd(seed, damping=False)),
    "warm_starting": lambda seed: Spared(in_lanes(seed), along={"collisions": True}),
    "position_correction": lambda seed: Spared(in_lanes(seed), along={"collisions": True}),
    "sleeping": lambda seed: Spared(calm(seed), LONG_ENOUGH),
    "callbacks": lambda seed: Spared(crowd(seed)),
}
"""For each effect scenes that do not call for it; the record of impulses is always called for."""

by_seed = settings(
    max_examples=share(30),
    phases=[Phase.explicit, Phase.generate],  # no seed is simpler than another
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


def solvers_of(effect: str) -> list[str]:
    """Return the solvers that can do with or without an effect.

    Where a body is watched as soon as it leaves its skin, what moves at all calls for continuous
    detection.
    """
    able = [s for s in SOLVERS if not any(effect in names for names in capabilities(s))]
    return [s for s in able if effect != "continuous" or our_solvers()[s].sight.reach == REACH]


def run_of(spared: Spared, solver: str, effects: dict[str, bool], **settings: Any) -> Run:
    """Return a plain run."""
    return simulate(
        spared.scene,
        spared.duration,
        solver=solver,
        effects=spared.along | effects,
        **{"compiled": False, **settings},
    )


def assert_same_numbers(mine: Run, its: Run) -> None:
    """All states and all contacts; -0.0 counts as 0.0."""
    for name in ("times", "positions", "velocities", "angles", "angular_velocities"):
        np.testing.assert_array_equal(getattr(mine, name), getattr(its, name), err_msg=name)
    for name, values in vars(mine.contacts).items():
        np.testing.assert_array_equal(values, getattr(its.contacts, name), err_msg=name)


@pytest.mark.one_in(9)
@pytest.mark.parametrize("effect", SPARED)
@by_seed
@given(seed=seeds, data=st.data())
def test_effect_that_is_not_called_for_changes_nothing(
    effect: str, seed: int, data: st.DataObject
) -> None:
    """Forced on, every state and every contact is what it is without; in every solver."""
    solver = data.draw(st.sampled_from(solvers_of(effect)))
    spared = SPARED[effect](seed)
    without = run_of(spared, solver, {})
    assert not without.plan.effect(effect).called_for, without.plan
    assert effect in without.plan.left_out
    forced = run_of(spared, solver, {effect: True})
    assert forced.plan.effect(effect).verdict == "forced"
    assert_same_numbers(forced, without)


@by_seed
@given(seed=seeds, effect=st.sampled_from(list(SPARED)), solver=st.sampled_from(SOLVERS))
def test_all_effects_that_are_not_called_for_together_change_nothing(
    seed: int, effect: str, solver: str
) -> None:
    """All that a solver has, forced on at once."""
    spared = SPARED[effect](seed)
    without = run_of(spared, solver, {})
    wanted = {name for name in without.plan.left_out if name in solvers_have(solver)}
    forced = run_of(spared, solver, dict.fromkeys(wanted, True))
    assert wanted <= set(forced.plan.used)
    assert_same_numbers(forced, without)


def solvers_have(solver: str) -> set[str]:
    """Return the effects that a solver has."""
    return set(EFFECTS) - set(our_solvers()[solver].lacks)


@by_seed
@given(seed=seeds, solver=st.sampled_from(SOLVERS))
def test_record_of_impulses_changes_no_state(seed: int, solver: str) -> None:
    """It is called for by every scene, and may be left out of any."""
    spared = Spared(crowd(seed))
    kept, left = (run_of(spared, solver, {"impulse_record": keep}) for keep in (True, False))
    assert len(left.contacts) == 0
    np.testing.assert_array_equal(kept.positions, left.positions)
    np.testing.assert_array_equal(kept.velocities, left.velocities)


@pytest.mark.one_in(9)
@pytest.mark.parametrize("effect", SPARED)
@settings(by_seed, max_examples=share(10))
@given(seed=seeds)
def test_stage_of_an_effect_that_is_left_out_is_never_called(effect: str, seed: int) -> None:
    """No call in a run; and the program that the plan leaves over does not name it."""
    scene, duration, along = SPARED[effect](seed)
    engine = at_work(scene, effects=along, duration=duration)
    called = calls_of(engine, STEPS)
    source = engine.plan("").source()
    for name in EFFECTS[effect].functions:
        assert called[name] == 0
        assert f"{name}(" not in source


@pytest.mark.parametrize("effect", SPARED)
def test_stage_of_an_effect_that_is_forced_on_is_in_the_program(effect: str) -> None:
    """So that the count of none means something."""
    scene, duration, along = SPARED[effect](1)
    engine = at_work(scene, effects={**along, effect: True}, duration=duration)
    source = engine.plan("").source()
    if effect == "callbacks":  # a listener is an object: no function of a program
        assert engine.pipeline.listener is not None
    else:
        assert any(f"def {name}(" in source for name in EFFECTS[effect].functions)


# Compiled


def at_work(scene: Scene, **settings: Any) -> EngineStepper:
    """Return the sequential solver at work."""
    usual = {"dt": DT, "iterations": 10, "substeps": 1, "combine": MixingRule()}
    return EngineStepper(scene, **{"solver": "sequential", **usual, **settings})


@pytest.fixture
def one_program_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every compiled run use one program, which has every effect: it takes 10 s to compile.

    Sleep is left as it is: there are two programs then.
    """
    monkeypatch.setattr(stepper, "link", link_all)


def link_all(function: Any, pipeline: Pipeline) -> str:
    """Return the program with every effect."""
    return linked(function, pipeline.solver, pipeline.effects.sleeping)


@functools.cache
def linked(function: Any, solver: SolverStages, sleeping: bool) -> str:
    """Return the same, once for each kind of run."""
    every = Pipeline(
        make_part=rigid_part,
        broad_phase=uniform_grid,
        solver=solver,
        effects=EVERY_EFFECT._replace(sleeping=sleeping),
    )
    return link(function, pipeline=every)


@pytest.mark.one_in(9)
@pytest.mark.skipif(bool(why_no_compiler()), reason="nothing can be compiled here")
@pytest.mark.usefixtures("one_program_for_all")
@pytest.mark.parametrize("effect", [effect for effect in SPARED if effect != "callbacks"])
@settings(by_seed, max_examples=share(10))
@given(seed=seeds)
def test_compiled_with_every_effect_is_plain_with_those_called_for(effect: str, seed: int) -> None:
    """A program that has all of them, compiled, against the one that the plan leaves over."""
    scene, duration, along = SPARED[effect](seed)
    plain = at_work(scene, effects=along, duration=duration)
    compiled = at_work(scene, effects={**along, effect: True}, duration=duration, compiled=True)
    assert effect not in plain.plan("").used
    assert compiled.plan("").effect(effect).verdict == "forced"
    for engine in (plain, compiled):
        engine.advance(round(duration / DT))
    np.testing.assert_array_equal(compiled.states(), plain.states())
    np.testing.assert_array_equal(compiled.events(), plain.events())


# Sleep


def elastic_blocks(seed: int) -> Scene:
    """Return blocks that stand on one another, and a ball that falls on them; e = 1, mu = 0."""
    rng = np.random.default_rng(seed)
    surface = Material(1.0, 0.0)
    blocks = [
        Body(Polygon.box(1, 1), mass=1.0, position=(3 * n, k + 0.5), material=surface)
        for n in range(3)
        for k in range(int(rng.integers(1, 4)))
    ]
    floor = Body(Polygon.box(20, 1), position=(0, -0.5), material=surface)
    height = rng.uniform(6, 9)
    ball = Body(Circle(0.3), mass=1.0, position=(0, height), material=surface)
    return Scene([floor, *blocks, ball], gravity=(0, -10))


@settings(by_seed, max_examples=share(8))
@given(seed=seeds)
def test_sleep_that_is_forced_on_changes_nothing_but_what_is_still(seed: int) -> None:
    """With gravity it stops what is as slow as STILL: rounding, which had moved a block by 1e-16 m.

    This is the one effect that is not equal to the last digit, and the one that is only a saving.
    """
    duration = 3.0
    spared = Spared(elastic_blocks(seed), duration)
    without, forced = (run_of(spared, "sequential", e) for e in ({}, {"sleeping": True}))
    assert "sleeping" in without.plan.left_out
    most = STILL * 10.0 * DT * duration
    np.testing.assert_allclose(forced.positions, without.positions, rtol=0, atol=most)
