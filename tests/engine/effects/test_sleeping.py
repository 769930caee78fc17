"""Sleep: islands at rest cost nothing, wake when they are touched, and nobody can tell."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
import pytest

from lesson_code import (
    Body,
    Callbacks,
    Circle,
    Material,
    MixingRule,
    Polygon,
    Scene,
    Segment,
    simulate,
)
from lesson_code.engine.core import narrow_phase
from lesson_code.engine.core.constants import QUIET_TIME, STILL
from lesson_code.engine.stepper import EngineStepper

DT = 1 / 60
GRAVITY = 10.0

UNTOLD = 1e-9
"""m, rad, m/s and N s: what is still is slower than 1e-9 g dt = 1.7e-10 m/s and gets slower by a
tenth and more in each step, so that it goes less than 1e-11 m further; a hit may grow that."""

ROUNDING = 1e-12
"""Part: sums of some hundred impulses."""

AtWork: TypeAlias = Callable[..., EngineStepper]

ROUGH = Material(restitution=0.0, friction=0.5)


def floor(**motion: Any) -> Body:
    """Return a slab to stand on."""
    return Body(Polygon.box(60, 2), position=(0, -1), material=ROUGH, **motion)


def stack(x: float, count: int = 3) -> list[Body]:
    """Return boxes of 1 m on one another."""
    box = Polygon.box(1, 1)
    return [Body(box, mass=1, position=(x, 0.5 + k), material=ROUGH) for k in range(count)]


def shot() -> Body:
    """Return a ball that will hit the stack at x = 0 from the left after 4.3 s."""
    return Body(Circle(0.4), mass=0.5, position=(-12, 10), velocity=(2.6, 19.5), material=ROUGH)


@pytest.fixture(params=[("sequential", 10, 1), ("substep", 1, 4)], ids=lambda p: p[0])
def at_work(request: pytest.FixtureRequest) -> AtWork:
    """Return what puts an engine to work on bodies under gravity: each that we compile."""
    solver, iterations, substeps = request.param

    def made(*bodies: Body, sleeping: bool = True, **settings: Any) -> EngineStepper:
        usual = {"dt": DT, "iterations": iterations, "substeps": substeps, "duration": 100.0}
        return EngineStepper(
            Scene(bodies, gravity=(0, -GRAVITY)), solver=solver, combine=MixingRule(),
            effects={"sleeping": sleeping}, **(usual | settings),
        )  # fmt: skip

    return made


def asleep(stepper: EngineStepper) -> list[int]:
    """Return the bodies that sleep."""
    return [n for n, body in enumerate(stepper.world.bodies) if body.is_asleep]


def sorted_events(stepper: EngineStepper) -> Any:
    """Return the impulses in an order that does not hang on who slept: by time, pair and place."""
    events = stepper.events()
    return events[
        np.lexsort((events[:, 4], events[:, 3], events[:, 2], events[:, 1], events[:, 0]))
    ]


def test_run_with_sleep_is_the_run_without(at_work: AtWork) -> None:
    """States and impulses, before, during and after a ball knocks one of two sleeping stacks."""
    runs = [
        at_work(floor(), *stack(0), *stack(8), shot(), sleeping=sleeping)
        for sleeping in (True, False)
    ]
    slept: list[int] = []
    for _ in range(28):
        for run in runs:
            run.advance(15)
        slept.append(len(asleep(runs[0])))
        np.testing.assert_allclose(runs[0].states(), runs[1].states(), rtol=0, atol=UNTOLD)
    assert max(slept) == 6
    assert slept[-1] == 3
    ours, awake = map(sorted_events, runs)
    assert ours.shape == awake.shape
    np.testing.assert_allclose(ours, awake, rtol=0, atol=UNTOLD)


def test_island_sleeps_after_the_quiet_time_and_not_before(at_work: AtWork) -> None:
    """Its parts have to be still for so long, all of them."""
    run = at_work(floor(), *stack(0, 1))
    run.advance(int(QUIET_TIME / DT) - 1)
    assert asleep(run) == []
    run.advance(60)
    assert asleep(run) == [1]


def test_only_the_island_that_is_touched_wakes(at_work: AtWork) -> None:
    """The stack beside it sleeps on."""
    run = at_work(floor(), *stack(0), *stack(8), shot())
    run.advance(250)
    assert asleep(run) == [1, 2, 3, 4, 5, 6]
    run.advance(40)
    assert asleep(run) == [4, 5, 6]


def test_nothing_is_looked_at_while_everything_sleeps(
    at_work: AtWork, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No two shapes are compared, and no body moves; the record goes on."""
    run = at_work(floor(), *stack(0), *stack(8))
    run.advance(240)
    calls: list[Any] = []
    monkeypatch.setattr(narrow_phase, "touch", lambda *arguments: calls.append(arguments))
    before, count = run.states(), len(run.events())
    run.advance(50)
    assert calls == []
    assert run.states().tobytes() == before.tobytes()
    assert run.world.state.steps_done == 290
    assert len(run.events()) - count == 50 * 12


@pytest.mark.parametrize("solver", ["sequential", "substep"])
def test_record_goes_on_while_bodies_sleep(solver: str) -> None:
    """The floor carries m g t, second for second, asleep or not."""
    run = simulate(
        Scene([floor(), *stack(0)], gravity=(0, -GRAVITY)), 7.0,
        solver=solver, effects={"sleeping": True}, sample="end",
    )  # fmt: skip
    carried = run.contacts.normal_impulse[run.contacts.body_a == 0]
    times = run.contacts.time[run.contacts.body_a == 0]
    for second in range(2, 7):
        of_second = carried[(times > second + DT / 2) & (times < second + 1 + DT / 2)].sum()
        assert of_second == pytest.approx(3 * GRAVITY, rel=UNTOLD)


def test_stack_on_a_belt_that_moves_stays_awake(at_work: AtWork) -> None:
    """The floor slides through under it: nothing of that is at rest."""
    smooth = Material(restitution=0.0, friction=0.0)
    belt = Body(Polygon.box(90, 2), position=(0, -1), velocity=(0.1, 0), material=smooth)
    run = at_work(belt, *stack(0, 2))
    run.advance(300)
    assert abs(run.states()[1:, 3:]).max() < STILL * GRAVITY * DT
    assert asleep(run) == []


def test_sleeper_is_woken_by_a_wall_that_comes(at_work: AtWork) -> None:
    """A body that nothing can push, and that moves, wakes what it touches."""
    wall = Body(Polygon.box(1, 4), position=(-4, 2.01), velocity=(1, 0), material=ROUGH)
    run = at_work(floor(), *stack(0, 1), wall)
    run.advance(170)
    assert asleep(run) == [1]
    run.advance(40)
    assert asleep(run) == []
    assert run.states()[1, 0] > 0.1


def test_body_that_creeps_does_not_sleep(at_work: AtWork) -> None:
    """A disc that rolls at a tenth of a millimetre a second is not at rest."""
    creeping = {"velocity": (1e-4, 0), "angular_velocity": -1e-4 / 0.5}
    disc = Body(Circle(0.5), mass=1, position=(0, 0.5), material=ROUGH, **creeping)
    run = at_work(Body(Segment((-5, 0), (5, 0)), material=ROUGH), disc)
    run.advance(600)
    assert asleep(run) == []
    assert run.states()[1, 0] == pytest.approx(1e-3, rel=1e-6)


@pytest.mark.parametrize("at_work", [("sequential", 10, 1)], indirect=True)
def test_steps_may_have_another_length_when_the_island_wakes(at_work: AtWork) -> None:
    """What it remembers is a force: the impulses follow the length of the step.

    Springs follow it, too: they carry the same load at another depth, so they have to move.
    """
    runs = [at_work(floor(), *stack(0), shot(), sleeping=sleeping) for sleeping in (True, False)]
    for run in runs:
        run.advance(250)
        run.world.state.whole = DT / 2
        run.advance(120)
    assert asleep(runs[0]) == []
    np.testing.assert_allclose(runs[0].states(), runs[1].states(), rtol=0, atol=UNTOLD)


@pytest.mark.full
def test_compiled_run_sleeps_like_the_plain_one(at_work: AtWork) -> None:
    """The same bits, awake, asleep and woken."""
    pytest.importorskip("numba")
    bodies = floor(), *stack(0), *stack(8), shot()
    compiled, plain = (at_work(*bodies, compiled=compiled) for compiled in (True, False))
    for steps in (200, 50, 40, 130):
        compiled.advance(steps)
        plain.advance(steps)
        assert (compiled.states() + 0.0).tobytes() == (plain.states() + 0.0).tobytes()
        assert (compiled.events() + 0.0).tobytes() == (plain.events() + 0.0).tobytes()
        assert compiled.world.state.asleep_count == plain.world.state.asleep_count


def test_many_islands_fall_asleep_and_wake_in_any_order(at_work: AtWork) -> None:
    """Balls fall one after the other on stacks that have been asleep for different times."""
    balls = [
        Body(Circle(0.3), mass=0.2, position=(4 * k + 0.1, 60 + 40 * k), material=ROUGH)
        for k in range(4)
    ]
    bodies = floor(), *(box for k in range(4) for box in stack(4 * k)), *balls
    runs = [at_work(*bodies, sleeping=sleeping) for sleeping in (True, False)]
    slept: set[int] = set()
    for _ in range(50):
        for run in runs:
            run.advance(10)
        slept.add(len(asleep(runs[0])))
        np.testing.assert_allclose(runs[0].states(), runs[1].states(), rtol=0, atol=UNTOLD)
    assert len(slept) > 3


def test_scene_with_callbacks_is_refused_sleep() -> None:
    """They are to hear of every contact in every step."""
    scene = Scene([floor(), *stack(0)], (0, -GRAVITY), callbacks=Callbacks(begin=print))
    with pytest.raises(ValueError, match=r"effects\['sleeping'\] must not be True .*callbacks"):
        simulate(scene, 1.0, solver="sequential", effects={"sleeping": True})
