"""Families of steps: long ones, short ones, and steps whose length changes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers.choice import solvers_for
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.hard_cases.loads import STANDS, tower
from lesson_code.evidence.hard_cases.measures import (
    DT,
    NO_DRIFT,
    NOT_SEEN,
    SUNK,
    energy_above,
    gain,
    largest,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.rods import NO_GAIN, thrown_rod
from lesson_code.evidence.hard_cases.trial import OURS, Trial, family
from lesson_code.evidence.scenes import slopes
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference import rigid_body_closed_forms as closed

THEME = "Steps"

RESTS = "What rests, rests, however the time is cut."


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
    if solver == OURS:
        choices = solvers_for(Question(scene, dt=DT), asked={})
        solver = next(c.solver for c in choices if our_solvers()[c.solver].run_scene is None)
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


def resting_disc(gap: float = -SUNK) -> Scene:
    """Return a disc that rests on a floor."""
    floor = Body(Segment((-5, 0), (5, 0)))
    return Scene([floor, Body(Circle(0.5), mass=1, position=(0, 0.5 + gap))], gravity=(0, -10))


@family(
    THEME,
    why="Impulses kept from a short step are far too small, or too large, for a long one.",
    law=RESTS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def steps_in_turn(draw: Draw, trial: Trial) -> float:
    """Steps of dt and 1 to 10 dt in turn: a disc, or a tower of 1 to 5, at rest."""
    ratio, count = draw.log_uniform("ratio", 1.0, 10.0), draw.integer("count", 0, 5)
    gap = start_gap(draw, max(count, 1))
    scene = tower((1.0,) * count, gap=gap) if count else resting_disc(gap)
    heights = heights_in_jumping_steps(scene, trial.engine, ratio)
    return largest(heights - heights[0]) / max(count, 1)


@family(
    THEME,
    why="No step is like the one before, and nothing kept from it fits.",
    law=RESTS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def random_steps(draw: Draw, trial: Trial) -> float:
    """Steps of any length from 1 to 100 ms: a tower of 1 to 5 at rest."""
    count = draw.integer("count", 1, 5)
    lengths = np.random.default_rng(draw.integer("lengths", 0, 10**6)).uniform(-3, -1, 200)
    step, states = single_steps(tower((1.0,) * count, gap=start_gap(draw, count)), trial.engine)
    start = states()
    for power in lengths.tolist():
        step(10.0**power)
    moved = states() - start
    return max(largest(moved[:, 0]), largest(moved[:, 1]) / count)


@family(
    THEME,
    why="The machine was busy; now many steps' worth of gravity comes at once.",
    law=RESTS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def hitch(draw: Draw, trial: Trial) -> float:
    """One step of 0.05 to 0.5 s among those of 1/60 s: a tower of 1 to 5 at rest."""
    count, late = draw.integer("count", 1, 5), draw.uniform("hitch", 0.05, 0.5)
    when = draw.integer("when", 0, 60)
    step, states = single_steps(tower((1.0,) * count, gap=start_gap(draw, count)), trial.engine)
    start = states()
    for n in range(120):
        step(late if n == when else DT)
    moved = states() - start
    return max(largest(moved[:, 0]), largest(moved[:, 1]) / count)


@family(
    THEME,
    why="Gravity of a long step is a long fall; impulses of a short one are small numbers.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def tower_at_any_step(draw: Draw, trial: Trial) -> float:
    """A tower of 1 to 8 boxes in steps of 1 to 100 ms, 3 s."""
    count, dt = draw.integer("count", 1, 8), draw.log_uniform("dt", 1e-3, 0.1)
    return unrest(trial.run(tower((1.0,) * count, gap=start_gap(draw, count)), 3.0, dt=dt))


@family(
    THEME,
    why="In a long step a thin rod turns far, and falls deep.",
    law=NO_GAIN,
    unit="",
    bound=1e-9,
    reason="rounding of some hundred impacts",
)
def rod_at_any_step(draw: Draw, trial: Trial) -> float:
    """A rod of 1:2 to 1:1000 is thrown at a floor, e = 0, steps of 1 to 100 ms: gain of energy."""
    scene = thrown_rod(draw, Material(0.0, draw.uniform("friction", 0.0, 1.0)))
    dt = draw.log_uniform("dt", 1e-3, 0.1)
    return gain(energy_above(trial.run(scene, 1.5, sample=None, dt=dt)))


@family(
    THEME,
    why="The speed that gravity gives in a step must not depend on how many there are.",
    law="a = g (sin - mu cos), or 0",
    unit="m/s",
    bound=1e-8,
    reason="rounding of up to a thousand steps",
)
def slope_at_any_step(draw: Draw, trial: Trial) -> float:
    """A box on a slope for a second, in 10 to 1000 steps: error of its speed."""
    degrees, mu = draw.uniform("degrees", 5.0, 30.0), draw.uniform("friction", 0.0, 0.6)
    dt = 1.0 / draw.integer("steps", 10, 1000)
    scene = slopes.body_on_slope(Polygon.box(1, 0.5), degrees, mu, sunk=-start_gap(draw))
    expected = max(closed.slide_down(np.radians(degrees), mu, slopes.GRAVITY), 0.0)
    return abs(float(trial.run(scene, 1.0, dt=dt).velocities[-1, 1, 0]) - expected)
