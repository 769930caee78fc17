"""The parts of the speed measurement, which can be chosen by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from lesson_code.evidence.measurement import chosen, machine, repeats_of
from lesson_code.evidence.scenes.speed import SIZES, scene_named
from lesson_code.evidence.speed.engines import refuse_without_compiler
from lesson_code.evidence.speed.few_bodies import STEPS_A_SECOND, measure_few_bodies
from lesson_code.evidence.speed.piles import PILES, PileRace, race_with_pile
from lesson_code.evidence.speed.processes import measure_memory, measure_start
from lesson_code.evidence.speed.race import Race, run_race
from lesson_code.evidence.speed.report import Speed

QUICK = ("gas-10", "gas-100", "gas-1000", "settled-100", "settled-1000", "stack-10", "pyramid-10")
"""Scenes that take a second or so each."""

QUICK_PILES = ("standing",)

ALL_MEMORY, QUICK_MEMORY = 100_000, 10_000
"""Discs whose memory is measured."""

QUICK_RATES = STEPS_A_SECOND[:-2]
"""Of pymunk in scenes of few bodies."""


def parts(repeats: int, *, quick: bool = False) -> dict[str, Callable[[], Any]]:
    """Return the function that measures each part, by name, in the order of measurement."""
    scenes = QUICK if quick else [f"{kind}-{n}" for kind, sizes in SIZES.items() for n in sizes]
    piles = QUICK_PILES if quick else PILES
    rates = QUICK_RATES if quick else STEPS_A_SECOND
    return {
        **{key: partial(_race, key, repeats) for key in scenes},
        **{key: partial(race_with_pile, PILES[key], repeats) for key in piles},
        "few_bodies": partial(measure_few_bodies, repeats, rates),
        "memory": partial(measure_memory, QUICK_MEMORY if quick else ALL_MEMORY),
        "start": partial(measure_start, repeats, cold=not quick),
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
        Batches of each engine in each scene, >= 1; 7 unless given, 3 if it has to be quick.
    quick : bool
        Whether to leave out the long measurements.
    only : sequence of str
        Names of scenes and parts, such as "gas-100", "gas" or "memory"; all if there are none.
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
    return Speed(
        machine=machine(),
        repeats=count,
        scenes=tuple(race for race in found.values() if isinstance(race, Race)),
        piles=tuple(race for race in found.values() if isinstance(race, PileRace)),
        few_bodies=found.get("few_bodies", ()),
        memory=found.get("memory"),
        start=found.get("start"),
    )
