"""The measurement: the runs of a pair of scenes make batches of steps in turns, and are timed.

A disturbance of the machine thus affects all runs of a pair alike, and only CPU time counts. Our
engine records impulses, as `simulate` does, unless recording is the effect in question.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.effects.choice import EFFECTS, choose_effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers.choice import solvers_for
from lesson_code.evidence.effect_costs.calls import calls_for
from lesson_code.evidence.effect_costs.result import (
    ALL,
    COMPILED,
    PLAIN,
    PYMUNK,
    EffectCost,
    EffectCosts,
    FewBalls,
)
from lesson_code.evidence.effect_costs.runners import ours, pymunk_for, settings_of
from lesson_code.evidence.measurement import chosen, four_digits, machine, repeats_of
from lesson_code.evidence.scenes.effects import (
    WARM_UP,
    EffectPair,
    billiards,
    gases,
    pairs,
)
from lesson_code.evidence.scenes.speed import DT
from lesson_code.evidence.timing import Advances, in_turns, steps_of_a_batch, timed
from lesson_code.simulation import simulate

BATCH_SECONDS, MOST_STEPS = 0.05, 2_000
"""Approximate duration of a batch, s, and its largest number of steps."""

COUNTED_STEPS = 5
"""Steps whose calls are counted."""

NO_CODE = "callbacks"
"""Effects without a compiled form: callbacks are Python functions."""

BILLIARDS_DURATION = 2.0
"""s; the balls collide during most of this time."""

PLANNED_OFTEN = 5
"""Factor on the repeats of a run that takes only milliseconds."""

BILLIARDS = "billiards"
"""The name of the scene of a few balls, beside those of the effects."""

Told = Callable[[str, float], None]


def measure_effects(
    only: Sequence[str] = (),
    *,
    quick: bool = False,
    repeats: int | None = None,
    told: Told = lambda _what, _done: None,
) -> EffectCosts:
    """Measure what each effect costs where it is needed, and what leaving it out saves elsewhere.

    Parameters
    ----------
    only : sequence of str
        Names of effects, "all effects" and "billiards" among them; all of them if there are none.
    quick : bool
        Whether to measure in plain Python and pymunk alone, and few times.
    repeats : int, optional
        Batches of each run, >= 1; 7 unless given, 3 if it has to be quick.
    told : callable
        Called with the name of each effect as it begins, and with the share that is done.

    Raises
    ------
    ValueError
        There is no effect of that name, or there are no repeats.
    """
    count = repeats_of(repeats, quick=quick)
    names = chosen([*EFFECTS, ALL, BILLIARDS], only)
    codes = [PLAIN] if quick or why_no_compiler() else [PLAIN, COMPILED]
    by_name = {pair.effect: pair for pair in pairs()}
    costs: list[EffectCost] = []
    few: FewBalls | None = None
    for n, name in enumerate(names):
        told(name, n / len(names))
        if name == BILLIARDS:
            few = measure_billiards(PLANNED_OFTEN * count)
        elif name == ALL:
            costs += [measure_all(gas, code, count) for gas in gases() for code in codes]
        else:
            costs += measure_pair(by_name[name], codes, count)
    told("done", 1.0)
    return EffectCosts(count, machine(), few, tuple(costs))


def measure_pair(pair: EffectPair, codes: Sequence[str], repeats: int) -> list[EffectCost]:
    """Return the cost of an effect in each of our codes and in pymunk."""
    counted = dict(_counted(pair))
    rows = []
    for code in codes:
        compiled = code == COMPILED
        if compiled and pair.effect == NO_CODE:
            continue
        engines = {
            name: ours(scene, asked, compiled=compiled, duration=pair.duration)
            for name, (scene, asked) in settings_of(pair).items()
        }
        times = step_times(engines, pair.warm_up, repeats)
        rows.append(EffectCost(pair.effect, code, pair.difference, **times, **counted))
    if pair.in_pymunk:
        times = step_times(pymunk_for(pair), pair.warm_up, repeats)
        rows.append(EffectCost(pair.effect, PYMUNK, pair.difference, **times))
    return rows


def step_times(engines: Mapping[str, Advances], warm_up: int, repeats: int) -> dict[str, float]:
    """Return the time of a step of each engine, s: the median of batches that they make in turns.

    A batch takes equally long for every engine; the warm-up finds the number of steps. The scenes
    do not change their character: a gas keeps moving, and a pile stays at rest.
    """
    batches = {}
    for name, engine in engines.items():
        engine.advance(warm_up)
        steps = steps_of_a_batch(engine, BATCH_SECONDS, MOST_STEPS)
        batches[name] = partial(_time_of_a_step, engine, steps)
    times = in_turns(batches, repeats)
    return {name: four_digits(statistics.median(taken)) for name, taken in times.items()}


def _time_of_a_step(engine: Advances, steps: int) -> float:
    return timed(lambda: engine.advance(steps)).worked / steps


def measure_billiards(repeats: int) -> FewBalls:
    """Return how long a scene of a few balls takes to plan, and to plan and run."""
    scene = billiards()
    question = Question(scene, "auto", DT, BILLIARDS_DURATION)

    def plan() -> None:
        choice = next(iter(solvers_for(question, asked={}, compiled=False)))
        choose_effects(Question(scene, choice.solver, DT, BILLIARDS_DURATION))

    run = partial(simulate, scene, BILLIARDS_DURATION, compiled=False)
    solver = run().plan.solver
    times = in_turns(
        {"plan": lambda: timed(plan).worked, "run": lambda: timed(run).worked}, repeats
    )
    return FewBalls(solver, statistics.median(times["plan"]), statistics.median(times["run"]))


def measure_all(name: str, code: str, repeats: int) -> EffectCost:
    """Return the cost of a gas as planned, and with every effect forced on."""
    scene, compiled = gases()[name], code == COMPILED
    every = {effect: True for effect in EFFECTS if not (compiled and effect == NO_CODE)}
    engines = {
        "left_out": ours(scene, {}, compiled=compiled),
        "forced": ours(scene, every, compiled=compiled),
    }
    return EffectCost(ALL, code, name, **step_times(engines, WARM_UP, repeats))


def _counted(pair: EffectPair) -> Iterator[tuple[str, float]]:
    """Yield, for each field of the result, the calls per step that only the effect needs."""
    for name, (scene, asked) in settings_of(pair).items():
        if name != "switched_off":
            engine = ours(scene, asked, compiled=False, duration=pair.duration)
            engine.advance(pair.warm_up)
            yield f"calls_{name}", calls_for(pair.effect, engine, COUNTED_STEPS)
