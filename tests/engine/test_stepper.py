"""The engine at work on a scene: solvers by name, broad phases that agree, a record of impulses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, MixingRule, Polygon, Scene, Segment
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.tables import BROAD_PHASES
from lesson_code.engine.stepper import EngineStepper


def engine(scene: Scene, **settings: Any) -> EngineStepper:
    """Return the engine at work, with the usual settings but for some."""
    usual = {"solver": "sequential", "dt": 1 / 60, "iterations": 10, "substeps": 1}
    return EngineStepper(scene, combine=MixingRule(), **(usual | settings))


def heap() -> Scene:
    """Return 30 bodies that fall into a pit."""
    rng = np.random.default_rng(3)
    walls = [Segment((-2, 0), (2, 0)), Segment((-2, 0), (-2, 20)), Segment((2, 0), (2, 20))]
    bodies = [
        Body(
            Circle(0.3) if n % 2 else Polygon.box(0.6, 0.4),
            mass=1, position=(n % 4 - 1.5, 0.5 + n // 4), angle=rng.uniform(-3, 3),
            material=Material(0.3, 0.5),
        )
        for n in range(30)
    ]  # fmt: skip
    return Scene([*(Body(wall) for wall in walls), *bodies], gravity=(0, -10))


def test_broad_phases_lead_to_the_same_bits() -> None:
    """The order of the contacts does not hang on how they were found."""
    states: dict[str, Any] = {}
    for name in BROAD_PHASES:
        stepper = engine(heap())
        stepper.pipeline = stepper.pipeline._replace(broad_phase=BROAD_PHASES[name])
        stepper.advance(60)
        states[name] = stepper.states().tobytes(), stepper.events().tobytes()
    assert states["sweep_and_prune"] == states["all_pairs"] == states["uniform_grid"]
    assert len(stepper.events()) > 500


def test_events_of_contacts_without_an_impulse_are_left_out() -> None:
    """Discs at rest overlap: there is a contact in every step, but nothing to tell of."""
    stepper = engine(Scene([Body(Circle(1), mass=1, position=(x, 0)) for x in (0, 1.9)]))
    stepper.advance(1)
    assert stepper.world.state.contact_count == 1
    assert stepper.events().shape == (0, 10)


def test_events_of_sub_steps_have_their_own_times() -> None:
    """A body that lies on the floor is held up in every part of a step."""
    scene = Scene(
        [Body(Segment((-5, 0), (5, 0))), Body(Circle(0.5), mass=1, position=(0, 0.499))],
        gravity=(0, -10),
    )
    stepper = engine(scene, dt=0.1, substeps=4)
    stepper.advance(1)
    assert stepper.events()[:, 0] == pytest.approx([0.025, 0.05, 0.075, 0.1])
    assert stepper.events()[:, 1:3].tolist() == [[0, 1]] * 4


def test_states_before_the_first_step_are_the_scenes() -> None:
    """x, y, angle, vx, vy, w of every body."""
    body = Body(Circle(1), mass=1, position=(1, 2), angle=3, velocity=(4, 5), angular_velocity=6)
    assert engine(Scene([body])).states().tolist() == [[1, 2, 3, 4, 5, 6]]


def test_plan_says_who_and_why() -> None:
    """One line for a reader."""
    plan = Plan("sequential", "asked for", "compiled", "a large run")
    assert str(plan) == "solver: sequential (asked for); compiled (a large run)"


def test_steps_beyond_the_planned_run_are_refused() -> None:
    """The discs would meet afterwards, so collisions are left out; the last step may be a part."""
    discs = [
        Body(Circle(1), mass=1, velocity=(1, 0)),
        Body(Circle(1), mass=1, position=(12, 0)),
    ]
    stepper = engine(Scene(discs), dt=0.1, duration=0.95)
    assert not stepper.pipeline.effects.collisions
    stepper.advance(9)
    stepper.advance(1)
    with pytest.raises(ValueError, match=r"planned for 9\.5 steps, got 11 in all"):
        stepper.advance(1)
