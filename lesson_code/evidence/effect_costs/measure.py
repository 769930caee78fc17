"""The measurement: the runs of a pair of scenes make batches of steps in turns, and are timed.

What disturbs the machine meets all runs of a pair alike, and what counts is the processor's time.
Our engine writes impulses down, as `simulate` does, unless that is the effect in question.
"""

from __future__ import annotations

import gc
import statistics
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

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
from lesson_code.evidence.effect_costs.runners import Runner, ours, pymunk_for, settings_of
from lesson_code.evidence.scenes.effects import (
    WARM_UP,
    EffectPair,
    billiards,
    gases,
    pairs,
)
from lesson_code.evidence.scenes.speed import DT
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.report import machine
from lesson_code.simulation import simulate

REPEATS, QUICK_REPEATS = 7, 3

BATCH_SECONDS, MOST_STEPS = 0.05, 2_000
"""s, about, that a batch takes, and steps that it has at the most."""

COUNTED_STEPS = 5
"""Steps whose calls are counted."""

NO_CODE = "callbacks"
"""What has no compiled form: callbacks are Python functions."""

BILLIARDS_DURATION = 2.0
"""s, of which the balls collide most of the time."""

PLANNED_OFTEN = 5
"""Times as many repeats for what takes milliseconds."""

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
        Hears what is being done, and what share of all is done.

    Raises
    ------
    ValueError
        There is no effect of that name, or there are no repeats.
    """
    count = (QUICK_REPEATS if quick else REPEATS) if repeats is None else repeats
    if count < 1:
        raise ValueError(f"repeats must be >= 1, got {count}")
    names = chosen(only)
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
    return EffectCosts(tuple(costs), few, count, machine())


BILLIARDS = "billiards"


def chosen(only: Sequence[str]) -> list[str]:
    """Return what is to be measured.

    Raises
    ------
    ValueError
        There is no effect of that name.
    """
    known = [*EFFECTS, ALL, BILLIARDS]
    for name in only:
        if name not in known:
            raise ValueError(f"only must name some of {', '.join(known)}; got {name!r}")
    return [name for name in known if not only or name in only]


def measure_pair(pair: EffectPair, codes: Sequence[str], repeats: int) -> list[EffectCost]:
    """Return what an effect costs: in each of our codes, and in pymunk."""
    counted = _counted(pair)
    rows = []
    for code in codes:
        compiled = code == COMPILED
        if compiled and pair.effect == NO_CODE:
            continue
        engines = {
            name: ours(scene, asked, compiled=compiled, duration=pair.duration)
            for name, (scene, asked) in settings_of(pair).items()
        }
        times = in_turns(engines, pair.warm_up, repeats)
        rows.append(EffectCost(pair.effect, code, pair.difference, **times, **counted))
    if pair.in_pymunk:
        times = in_turns(pymunk_for(pair), pair.warm_up, repeats)
        rows.append(EffectCost(pair.effect, PYMUNK, pair.difference, **times))
    return rows


def in_turns(engines: Mapping[str, Any], warm_up: int, repeats: int) -> dict[str, float]:
    """Return the time of a step of each engine, s: the median of batches that they make in turns.

    A batch takes equally long in all; how many steps that are is found in the warm-up. The scenes
    stay as they are: a gas goes on, and a pile rests.
    """
    runners = {name: Runner(engine) for name, engine in engines.items()}
    for runner in runners.values():
        runner.engine.advance(warm_up)
        runner.fit_batch(BATCH_SECONDS, MOST_STEPS)
    gc.collect()
    gc.disable()
    for _ in range(repeats):
        for runner in runners.values():
            runner.run_batch()
    gc.enable()
    return {name: statistics.median(runner.seconds) for name, runner in runners.items()}


def measure_billiards(repeats: int) -> FewBalls:
    """Return how long a scene of a few balls takes to plan, and to plan and run."""
    scene = billiards()
    question = Question(scene, "auto", DT, BILLIARDS_DURATION)
    planning, whole = [], []
    run = simulate(scene, BILLIARDS_DURATION, compiled=False)
    for _ in range(repeats):
        start = worked_seconds()
        choice = next(iter(solvers_for(question, asked={}, compiled=False)))
        choose_effects(Question(scene, choice.solver, DT, BILLIARDS_DURATION))
        middle = worked_seconds()
        run = simulate(scene, BILLIARDS_DURATION, compiled=False)
        planning.append(middle - start)
        whole.append(worked_seconds() - middle)
    return FewBalls(run.plan.solver, statistics.median(planning), statistics.median(whole))


def measure_all(name: str, code: str, repeats: int) -> EffectCost:
    """Return what a gas costs as it is planned, and with every effect forced on."""
    scene, compiled = gases()[name], code == COMPILED
    every = {effect: True for effect in EFFECTS if not (compiled and effect == NO_CODE)}
    engines = {
        "left_out": ours(scene, {}, compiled=compiled),
        "forced": ours(scene, every, compiled=compiled),
    }
    return EffectCost(ALL, code, name, **in_turns(engines, WARM_UP, repeats))


def _counted(pair: EffectPair) -> dict[str, float]:
    """Return the calls a step of the functions that only an effect needs, in plain Python."""
    return dict(_counts(pair))


def _counts(pair: EffectPair) -> Iterator[tuple[str, float]]:
    """Yield them by the field of the result."""
    for name, (scene, asked) in settings_of(pair).items():
        if name != "switched_off":
            engine = ours(scene, asked, compiled=False, duration=pair.duration)
            engine.advance(pair.warm_up)
            yield f"calls_{name}", calls_for(pair.effect, engine, COUNTED_STEPS)
