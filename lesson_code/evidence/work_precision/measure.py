"""The measurement: errors first, with the work beside them, then times, in turns.

Errors are the same wherever they are computed: processes or a cluster may share them. Times are
taken in this process alone. The first run of each point is a warm-up, whose time counts only where
a run is so long that there is no second. Making the tables is not timed.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any, TypeAlias

from rich.progress import track

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.measurement import chosen, four_digits, machine, repeats_of
from lesson_code.evidence.timing import in_turns, timed
from lesson_code.evidence.work_precision.counting import Work, work_of
from lesson_code.evidence.work_precision.methods import (
    COMPILED,
    METHODS,
    PLAIN,
    Method,
    Setting,
    exact_solver,
    methods_here,
    sampled,
    stepper,
)
from lesson_code.evidence.work_precision.result import Point, WorkPrecision
from lesson_code.evidence.work_precision.scenes import PrecisionScene, scenes
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.parallel import map_tasks

IN_A_ROW = 2
"""Runs of a point in its turn: the first brings its code back into the processor's caches, which
other methods have used in between. That costs 0.1 ms, as much as the shortest runs."""

LONG, ONCE = 0.1, 2.0
"""s: a point that takes longer is timed in one round, or is not run a second time at all. What is
done once in a run does not matter beside that."""

TOO_LONG_IN_PYTHON = 2.0
"""s: a longer run is skipped in plain Python if it also runs compiled."""

VISIT, TEST = 4e-6, 12e-6
"""s, about, of plain Python: for a visit to a contact, and for the test of a pair."""

QUICK = {"dt": 4, "sweeps": 2}
"""Settings of a line in a quick measurement, the coarsest, by what is swept."""

HURRY = 0.1
"""Of :data:`LONG` and :data:`ONCE`, in a quick measurement."""

Task: TypeAlias = tuple[str, str, Setting, bool]
"""Scene, method, setting, and whether it is compiled."""

Found: TypeAlias = tuple[float, str, Work]
"""Error, failure and work."""


def measure_accuracy(
    only: Sequence[str] = (),
    *,
    quick: bool = False,
    repeats: int | None = None,
    workers: int | None = 1,
    cluster: str | None = None,
    progress: bool = False,
) -> WorkPrecision:
    """Measure error, time and work of all methods.

    Parameters
    ----------
    only : sequence of str
        Names of scenes, or the beginnings of names; all where there is none.
    quick : bool
        Whether to measure the coarsest settings alone, and without a compiler.
    repeats : int, optional
        Rounds in which each point is timed, >= 1, 7 unless given; of each the shortest time counts.
        A long run is timed in one.
    workers, cluster
        As :func:`lesson_code.parallel.map_tasks` takes them, for the errors alone.
    progress : bool
        Whether bars are drawn on standard error.

    Raises
    ------
    ValueError
        A name begins no scene's, or `repeats` is not >= 1.
    """
    count = repeats_of(repeats, quick=False)
    wanted = [scenes()[name] for name in chosen(scenes(), only, str.startswith)]
    compiles = not why_no_compiler() and not quick
    tasks = list(_tasks(wanted, quick, compiles))
    found = map_tasks(
        find_error,
        tasks,
        workers=workers,
        cluster=cluster,
        names=[f"{name}, {method}, {setting}" for name, method, setting, _ in tasks],
        progress="errors" if progress else None,
    )
    points = [
        point
        for task, what in zip(tasks, found, strict=True)
        for point in _points(task, what, compiles)
    ]
    groups = [[p for p in points if p.scene == name] for name in _names(points)]
    patience = HURRY if quick else 1.0
    shown = track(groups, "times", transient=True) if progress else groups
    done = [p for group in shown for p in with_times(group, count, patience)]
    return WorkPrecision(count, machine(), tuple(done))


def _names(points: Iterable[Point]) -> list[str]:
    return list(dict.fromkeys(point.scene for point in points))


def find_error(task: Task) -> Found:
    """Return error, failure and work of a method at a setting."""
    name, method_name, setting, compiled = task
    scene, method = scenes()[name], METHODS[method_name]
    try:
        run = sampled(scene, method, setting, compiled=compiled)
    except ValueError:
        return math.nan, "refused", Work()
    except (FloatingPointError, RuntimeError):
        return math.nan, scene.failure, Work()
    error = scene.error(run)
    work = work_of(scene, method, setting, compiled=compiled)
    return error, "" if error < scene.worthless else scene.failure, work


def _tasks(wanted: Iterable[PrecisionScene], quick: bool, compiles: bool) -> Iterable[Task]:
    """Yield the combinations to measure."""
    for scene in wanted:
        for method in methods_here():
            compiled = compiles and COMPILED in method.codes
            settings = list(method.settings(scene))
            for setting in settings[: QUICK[scene.swept] if quick else None]:
                yield scene.name, method.name, setting, compiled


def _points(task: Task, found: Found, compiles: bool) -> Iterable[Point]:
    """Yield a point for each code that a method's setting is to be timed in."""
    name, method, setting, _ = task
    error, failure, work = found
    for code in METHODS[method].codes:
        too_long = work.contact_solves * VISIT + work.pair_tests * TEST > TOO_LONG_IN_PYTHON
        spared = code == PLAIN and compiles and COMPILED in METHODS[method].codes and too_long
        if not spared and (compiles or code != COMPILED):
            yield Point(
                *(name, method, code, setting.dt, setting.iterations, setting.substeps),
                *(error, math.nan, work.contact_solves, work.pair_tests, failure),
            )


# Times


def with_times(points: Sequence[Point], repeats: int, patience: float = 1.0) -> list[Point]:
    """Return points with their times: the shortest of some runs, which they make in turns."""
    runs = {n: _prepared(p) for n, p in enumerate(points) if math.isfinite(p.error)}
    times = in_turns(runs, 1)  # a program is loaded here, for one
    again = {n: _in_a_row(run) for n, run in runs.items() if times[n][0] <= patience * ONCE}
    times |= in_turns(again, repeats, patience=patience * LONG)
    shortest = {n: min(taken) for n, taken in times.items()}
    return [
        replace(p, seconds=four_digits(shortest.get(n, math.nan))) for n, p in enumerate(points)
    ]


def _in_a_row(run: Callable[[], float]) -> Callable[[], float]:
    return lambda: min(run() for _ in range(IN_A_ROW))


def _prepared(point: Point) -> Callable[[], float]:
    """Return a function that makes a point's run from the start, and returns its time, s."""
    scene, method, setting = scenes()[point.scene], METHODS[point.method], point.setting
    if method.name == "exact":  # its predictions at the start are a part of its work
        return lambda: timed(lambda: exact_solver(scene).advance(scene.duration)).wall
    steps = whole_parts(scene.duration, setting.dt)
    begin = stepper_at_the_start(scene, method, setting, compiled=point.code == COMPILED)

    def run() -> float:
        made = begin()
        try:
            return timed(lambda: made.advance(steps)).wall
        except FloatingPointError:
            return math.nan

    return run


def stepper_at_the_start(
    scene: PrecisionScene, method: Method, setting: Setting, *, compiled: bool
) -> Callable[[], Any]:
    """Return a function that gives a fresh solver each time; our program is linked once."""
    first = stepper(scene, method, setting, compiled=compiled)
    if not isinstance(first, EngineStepper):
        return lambda: stepper(scene, method, setting, compiled=compiled)

    def again() -> EngineStepper:
        twin = copy.copy(first)
        twin.world = copy.deepcopy(first.world)
        return twin

    return again
