"""The step in sub-steps: the order of its stages, and how it is split where something fast hits."""

from __future__ import annotations

from typing import Any

import pytest

from lesson_code import Body, Circle, Combination, Material, Scene, Segment
from lesson_code.engine import soft_step as stages
from lesson_code.engine.broad_phase import all_pairs
from lesson_code.engine.continuous import begin_step
from lesson_code.engine.soft_step import soft_step
from lesson_code.engine.stepper import SOLVERS
from lesson_code.engine.tables import world_of
from lesson_code.engine.world import ContactSolver


def test_stages_come_in_the_order_of_the_pipeline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Contacts and impacts once, then two sub-steps of springs, motion and relax pass."""
    called: list[str] = []

    class Listener:
        def before_impulses(self, _: Any) -> None:
            called.append("before_impulses")

        def after_impulses(self, _: Any) -> None:
            called.append("after_impulses")

    for name in ("move", "bound", "find_pairs", "find_contacts", "accelerate"):
        monkeypatch.setattr(stages, name, lambda *_, name=name: called.append(name))
    monkeypatch.setattr(stages, "part_to_impact", lambda *_: called.append("look ahead") or 0.1)
    solver = ContactSolver(
        **{name: lambda _, name=name: called.append(name) for name in ContactSolver._fields}
    )
    world = world_of(Scene(), dt=0.1, iterations=1, combine=Combination())
    world.state.substeps = 2
    begin_step(world, end=0.1)
    assert soft_step(world, all_pairs, solver, Listener())
    assert called == [
        *("bound", "find_pairs", "find_contacts", "before_impulses", "prepare", "look ahead"),
        *2 * ("accelerate", "warm_start", "solve", "move", "correct"),
        *("store", "after_impulses"),
    ]


def test_length_of_the_step_is_that_of_a_sub_step_only_meanwhile() -> None:
    """A ball of 50 m/s and a wall 0.25 m away: a part of 5 ms, and the rest of the step."""
    ball = Body(Circle(0.05), mass=1, velocity=(50, 0), material=Material(1))
    wall = Body(Segment((0.3, -1), (0.3, 1)))
    world = world_of(Scene([ball, wall]), dt=0.02, iterations=1, combine=Combination())
    world.state.substeps = 4
    begin_step(world, end=0.02)
    assert not soft_step(world, all_pairs, SOLVERS["substep"])
    assert (world.state.dt, world.state.dt_before) == (0.02, pytest.approx(0.005 / 4, rel=1e-2))
    assert world.state.left == pytest.approx(0.015, rel=1e-2)
    assert soft_step(world, all_pairs, SOLVERS["substep"])
    assert (world.state.dt, world.state.left, world.state.time) == (0.02, 0.0, 0.02)
    assert world.bodies[0].vx == pytest.approx(-50, rel=1e-12)
