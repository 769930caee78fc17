"""The parts of the speed measurement, which can be chosen by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from lesson_code.evidence.measurement import chosen, machine, repeats_of
from lesson_code.evidence.scenes.speed import SIZES, scene_named
from lesson_code.evidence.speed.engines import refuse_without_compiler
from lesson_code.evidence.speed.piles import PILES, PileRace, race_with_pile
from lesson_code.evidence.speed.race import Race, run_race
from lesson_code.evidence.speed.report import Speed
from lesson_code.evidence.speed.whole_runs import SCENES, WholeRuns, measure_whole_run

QUICK_RUNS = ("run-gas-10", "run-gas-100")
"""Whole runs of less than a second each."""

QUICK = ("gas-10", "gas-100", "gas-1000", "settled-100", "settled-1000", "stack-10", "pyramid-10")
"""Scenes that take a second or so each."""

QUICK_PILES = ("standing",)


def parts(repeats: int, *, quick: bool = False) -> dict[str, Callable[[], Any]]:
    """Return the function that measures each part, by name, in the order of measurement."""
    scenes = QUICK if quick else [f"{kind}-{n}" for kind, sizes in SIZES.items() for n in sizes]
    piles = QUICK_PILES if quick else PILES
    runs = QUICK_RUNS if quick else SCENES
    return {
        **{key: partial(measure_whole_run, key, repeats) for key in runs},
        **{key: partial(_race, key, repeats) for key in scenes},
        **{key: partial(race_with_pile, PILES[key], repeats) for key in piles},
    }


def _race(key: str, repeats: int) -> Race:
    return run_race(key, scene_named(key), repeats)


def fits(key: str, name: str) -> bool:
    """Return whether a part has a name, or one that begins with it: gas-10 is not gas-100."""
    return key == name or key.startswith(f"{name}-")


def measure_speed(
    *,
    repeats: int | None = None,
    quick: bool = False,
    only: Sequence[str] = (),
    told: Callable[[str, float], None] = lambda _what, _done: None,
) -> Speed:
    """Measure how fast the engines are.

    Parameters
    ----------
    repeats : int, optional
        Batches of each engine in each scene, and processes of each, >= 1; 7 unless given, 3 if it
        has to be quick.
    quick : bool
        Whether to leave out the long measurements.
    only : sequence of str
        Names of parts, such as "run", "gas-100" or "gas"; all if there are none.
    told : callable
        Called with the name of each part as it begins, and with the share that is done.

    Raises
    ------
    ValueError
        A name fits no part, or there are no repeats.
    RuntimeError
        Nothing can be compiled here.
    """
    refuse_without_compiler()
    count = repeats_of(repeats, quick=quick)
    offered = parts(count, quick=quick)
    wanted = chosen(offered, only, fits)
    found: dict[str, Any] = {}
    for n, key in enumerate(wanted):
        told(key, n / len(wanted))
        found[key] = offered[key]()
    told("done", 1.0)
    times = [row for key in wanted if key in SCENES for row in found[key]]
    return Speed(
        machine=machine(),
        repeats=count,
        whole_runs=WholeRuns(machine(), tuple(times)) if times else None,
        scenes=tuple(race for race in found.values() if isinstance(race, Race)),
        piles=tuple(race for race in found.values() if isinstance(race, PileRace)),
    )
