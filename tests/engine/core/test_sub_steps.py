"""The step in sub-steps: the order of its stages, and how it is split where something fast hits."""

from __future__ import annotations

from typing import Any

import pytest

from lesson_code import Body, Circle, Material, MixingRule, Scene, Segment
from lesson_code.engine.core import step as stages
from lesson_code.engine.core.broad_phase import all_pairs
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.pipeline import Pipeline, SolverStages
from lesson_code.engine.core.step import soft_part
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.solvers.substep import SOLVER

STAGES = (
    "find_pairs",
    "find_contacts",
    "has_capacity_for_record",
    "choose_part",
    "accelerate",
    "move",
    "record_impulses",
)
"""What a step calls besides its solver and its listener."""


class Noting:
    """Stages, solver and listener of an empty scene that write down when they are called."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, stop: str = "") -> None:
        self.called: list[str] = []
        for name in STAGES:
            monkeypatch.setattr(stages, name, self.stage(name, answer=name != stop))
        solver = SolverStages(*[self.stage(name) for name in SolverStages._fields])
        self.pipeline = Pipeline(soft_part, all_pairs, solver, self)
        self.world = world_of(Scene(), dt=0.1, iterations=1, combine=MixingRule())
        self.world.state.substeps = 2

    def stage(self, name: str, answer: bool = True) -> Any:
        """Return a stage that says that all is well, or that it is not."""

        def stage(*_: Any) -> bool:
            self.called.append(name)
            return answer

        return stage

    def before_impulses(self, _: Any) -> None:
        """Hear of the contacts."""
        self.called.append("before_impulses")

    def after_impulses(self, _: Any) -> None:
        """Hear of them again."""
        self.called.append("after_impulses")


def test_stages_come_in_the_order_of_the_pipeline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Contacts and impacts once, then two sub-steps of springs, motion and relax pass."""
    noting = Noting(monkeypatch)
    assert soft_part(noting.world, noting.pipeline)
    assert noting.called == [
        *("find_pairs", "find_contacts", "has_capacity_for_record", "before_impulses", "prepare"),
        "choose_part",
        *2 * ("accelerate", "warm_start", "solve", "move", "correct"),
        *("store", "after_impulses", "record_impulses"),
    ]


@pytest.mark.parametrize(
    ("stop", "prepared"),
    [("find_pairs", 0), ("find_contacts", 0), ("has_capacity_for_record", 0), ("choose_part", 1)],
)
def test_step_that_lacks_room_goes_on_where_it_stopped(
    monkeypatch: pytest.MonkeyPatch, stop: str, prepared: int
) -> None:
    """Impacts pass once, whatever is called again; nothing moves before all is found."""
    noting = Noting(monkeypatch, stop)
    assert not soft_part(noting.world, noting.pipeline)
    assert noting.called[-1] == stop
    assert noting.called.count("prepare") == noting.world.state.is_prepared == prepared
    monkeypatch.setattr(stages, stop, noting.stage(stop))
    assert soft_part(noting.world, noting.pipeline)
    assert [noting.called.count(name) for name in ("prepare", "before_impulses")] == [1, 1]
    assert not noting.world.state.is_prepared


def test_length_of_the_step_is_that_of_a_sub_step_only_meanwhile() -> None:
    """A ball of 50 m/s and a wall 0.25 m away: a part of 5 ms, and the rest of the step."""
    ball = Body(Circle(0.05), mass=1, velocity=(50, 0), material=Material(1))
    wall = Body(Segment((0.3, -1), (0.3, 1)))
    world = world_of(Scene([ball, wall]), dt=0.02, iterations=1, combine=MixingRule())
    world.state.substeps = 4
    world.state.left = 0.02
    pipeline = Pipeline(soft_part, all_pairs, SOLVER.stages_for({}))
    for left in (0.015, 0.0):
        while not soft_part(world, pipeline):
            world = add_capacity(world)
        assert world.state.dt_before == pytest.approx(world.state.dt / 4)
        world.state.left -= world.state.dt
        assert world.state.left == pytest.approx(left, rel=1e-2)
        assert world.state.time == pytest.approx(0.02 - left, rel=1e-2)
    assert (world.state.left, world.state.time) == (0.0, 0.02)
    assert world.bodies[0].vx == pytest.approx(-50, rel=1e-12)
