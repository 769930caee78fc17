"""Hard cases: steps whose length changes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers.choice import solvers_for
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.loads import tower
from lesson_code.evidence.hard_cases.measures import largest
from lesson_code.geometry.shapes import Circle, Segment

THEME = "Steps that change"

DT = 1 / 60
"""s."""

RATIOS = (1.5, 2.6, 2.7, 5.0, 10.0)
"""Ratios of two alternating step lengths. pymunk's limit is 2.618, the golden ratio squared."""


def single_steps(scene: Scene, solver: str) -> tuple[Callable[[float], None], Callable[[], Any]]:
    """Return a function that makes one step of any length, and one that returns the states."""
    settings: dict[str, Any] = {
        "dt": DT,
        "iterations": 10,
        "substeps": 1,
        "combine": MixingRule(),
        "keep_impulses": False,
    }
    if solver == "pymunk":
        from lesson_code.reference.pymunk_reference import PymunkStepper

        theirs = PymunkStepper(scene, **settings)
        return theirs.space.step, theirs.states
    if solver == "box2d":
        from lesson_code.reference.box2d_reference.scene_run import SUBSTEPS, Box2DStepper

        other = Box2DStepper(scene, dt=DT, combine=MixingRule())
        return lambda dt: other.world.step(dt, SUBSTEPS), other.states
    if solver == "auto":
        choices = solvers_for(Question(scene, dt=DT), asked={})
        solver = next(choice.solver for choice in choices if our_solvers()[choice.solver].stages)
    ours = EngineStepper(scene, solver=solver, **settings)

    def step(dt: float) -> None:
        ours.world.state.whole = dt
        ours.advance(1)

    return step, ours.states


def heights_in_jumping_steps(scene: Scene, solver: str, ratio: float, steps: int = 120) -> Any:
    """Return y of every body after each step, the steps being dt and ratio dt in turn."""
    step, states = single_steps(scene, solver)
    heights = [states()[:, 1]]
    for n in range(steps):
        step(DT * (ratio if n % 2 else 1.0))
        heights.append(states()[:, 1])
    return np.array(heights)


def resting_disc() -> Scene:
    """Return a disc that rests on a floor."""
    floor = Body(Segment((-5, 0), (5, 0)))
    return Scene([floor, Body(Circle(0.5), mass=1, position=(0, 0.5 - 4e-4))], gravity=(0, -10))


def moved_by_jumps(trial: Trial) -> float:
    """Return the largest vertical displacement of any body, over all ratios, m."""
    worst = 0.0
    for ratio in RATIOS:
        for scene in (resting_disc(), tower((1.0,) * 3)):
            heights = heights_in_jumping_steps(scene, trial.solver, ratio)
            worst = max(worst, largest(heights - heights[0]))
            if not np.isfinite(worst):
                return worst
    return worst


def moved_by_hitch(trial: Trial) -> float:
    """Return how far a tower of three moves in one step of a quarter of a second, m."""
    step, states = single_steps(tower((1.0,) * 3), trial.solver)
    start = states()
    for n in range(120):
        step(0.25 if n == 30 else DT)
    return largest(states()[:, :2] - start[:, :2])


CASES = (
    HardCase(
        name="dt-jumps",
        theme=THEME,
        title="Steps of dt and up to 10 dt in turn, things at rest",
        why="Impulses kept from a short step are far too small, or too large, for a long one.",
        law="What rests, rests, however the time is cut.",
        scene=resting_disc,
        measure=moved_by_jumps,
        unit="m",
        bound=1e-9,
        reason="rounding of 120 steps",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="hitch",
        theme=THEME,
        title="One step of a quarter of a second, a tower of 3",
        why="The machine was busy; now fifteen steps' worth of gravity comes at once.",
        law="What rests, rests, however the time is cut.",
        scene=partial(tower, (1.0,) * 3),
        measure=moved_by_hitch,
        unit="m",
        bound=1e-9,
        reason="rounding of 120 steps",
        failed_by=("naive",),
    ),
)
