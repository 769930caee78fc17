"""The measurement: errors first, work beside them, then times, in turns.

Errors are the same wherever they are computed: they may be shared out over processes or a cluster.
Times are taken in this process alone, one after the other: one run of every point, then the next
run of every point, so that a busy moment of the machine strikes all alike. The first run of each
is a warm-up, whose time counts only where one run is so long that there is no second. What is left
out of the time is the making of the tables; the exact solver's forecast at the start is part of its
work.
"""

from __future__ import annotations

import copy
import importlib.metadata
import math
import platform
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from time import perf_counter
from typing import Any, TypeAlias

from rich.progress import track

from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.work_precision.counting import Work, work_of
from lesson_code.evidence.work_precision.methods import (
    COMPILED,
    METHODS,
    PLAIN,
    Method,
    Setting,
    can_compile,
    exact_solver,
    methods_here,
    sampled,
    stepper,
)
from lesson_code.evidence.work_precision.result import Point, WorkPrecision
from lesson_code.evidence.work_precision.scenes import PrecisionScene, scenes
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.parallel import map_tasks

REPEATS = 7
"""Runs of each point that are timed; the shortest counts."""

LONG = 0.5
"""s: after so much time spent on it, a point is not run again."""

IN_A_ROW = 2
"""Runs of a point in its turn: the first brings its code back into the processor's caches, which
the others have used meanwhile. That costs 0.1 ms, as much as the shortest runs."""

ONCE = 2.0
"""s: what takes longer is run a single time. Nothing that is done once matters beside that."""

TOO_LONG_IN_PYTHON = 2.0
"""s: what would take longer is not run in plain Python, where there is compiled code too."""

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
    repeats: int = REPEATS,
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
    repeats : int
        Timed runs of each point, >= 1; fewer for those that take long.
    workers, cluster
        As :func:`lesson_code.parallel.map_tasks` takes them, for the errors alone.
    progress : bool
        Whether bars are drawn on standard error.

    Raises
    ------
    ValueError
        A name begins no scene's, or `repeats` is not >= 1.
    """
    if repeats < 1:
        raise ValueError(f"repeats must be >= 1, got {repeats}")
    compiles = can_compile() and not quick
    tasks = list(_tasks(chosen(only), quick, compiles))
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
    timed: list[Point] = []
    for name in dict.fromkeys(point.scene for point in points):
        group = [p for p in points if p.scene == name]
        timed += in_turns(group, repeats, progress, patience=HURRY if quick else 1.0)
    return WorkPrecision(tuple(timed), repeats, machine())


def chosen(only: Sequence[str]) -> list[PrecisionScene]:
    """Return the scenes whose names begin so; all where nothing is said.

    Raises
    ------
    ValueError
        A name begins no scene's.
    """
    for name in only:
        if not any(known.startswith(name) for known in scenes()):
            raise ValueError(f"scene must be one of {', '.join(scenes())}, got {name!r}")
    begins = tuple(only) or ("",)
    return [scene for name, scene in scenes().items() if name.startswith(begins)]


def find_error(task: Task) -> Found:
    """Return error, failure and work of a method at a setting."""
    name, method_name, setting, compiled = task
    scene, method = scenes()[name], METHODS[method_name]
    try:
        run = sampled(scene, method, setting, compiled=compiled)
    except ValueError:
        return math.inf, "refused", Work()
    except (FloatingPointError, RuntimeError):
        return math.inf, scene.failure, Work()
    error = scene.error(run)
    work = work_of(scene, method, setting, compiled=compiled)
    return error, "" if error < scene.worthless else scene.failure, work


def machine() -> dict[str, str]:
    """Return what the measurement was made on."""
    names = ("numpy", "numba", "pymunk", "Box2D")
    return {
        "python": platform.python_version(),
        "system": sys.platform,
        "processor": platform.machine(),
        **{name.lower(): _version(name) for name in names},
    }


def _version(name: str) -> str:
    """Return the version of a package, or that there is none."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return "not installed"


def _tasks(wanted: Iterable[PrecisionScene], quick: bool, compiles: bool) -> Iterable[Task]:
    """Yield what there is to be found out."""
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


def in_turns(
    points: Sequence[Point], repeats: int, progress: bool = False, patience: float = 1.0
) -> list[Point]:
    """Return points with their times: the shortest of some runs, one or two of each in turn."""
    runs = {n: _prepared(p) for n, p in enumerate(points) if math.isfinite(p.error)}
    first = {n: run() for n, run in runs.items()}  # a program is loaded here, for one
    best = {n: taken if taken > patience * ONCE else math.inf for n, taken in first.items()}
    spent = {n: 0.0 if math.isinf(best[n]) else math.inf for n in runs}
    rounds = range(repeats)
    for _ in track(rounds, points[0].scene, transient=True) if progress else rounds:
        for n, run in runs.items():
            if spent[n] < patience * LONG:
                taken = [run() for _ in range(IN_A_ROW)]
                best[n], spent[n] = min(best[n], *taken), spent[n] + sum(taken)
    return [replace(p, seconds=best.get(n, math.nan)) for n, p in enumerate(points)]


def _prepared(point: Point) -> Callable[[], float]:
    """Return a function that makes a point's run from the start, and returns its time, s."""
    scene, method, setting = scenes()[point.scene], METHODS[point.method], point.setting
    if method.name == "exact":
        return lambda: _time_of_exact(scene)
    steps = whole_parts(scene.duration, setting.dt)
    begin = stepper_at_the_start(scene, method, setting, compiled=point.code == COMPILED)

    def run() -> float:
        made = begin()
        start = perf_counter()
        try:
            made.advance(steps)
        except FloatingPointError:
            return math.inf
        return perf_counter() - start

    return run


def _time_of_exact(scene: PrecisionScene) -> float:
    """Return the time of an exact run, its forecasts at the start included, s."""
    start = perf_counter()
    exact_solver(scene).advance(scene.duration)
    return perf_counter() - start


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
