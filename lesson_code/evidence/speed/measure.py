"""What is measured, in parts that can be chosen by name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

from lesson_code.evidence.scenes import speed as speed_scenes
from lesson_code.evidence.scenes.speed import SIZES, SpeedScene
from lesson_code.evidence.speed.engines import refuse_without_compiler
from lesson_code.evidence.speed.few_bodies import STEPS_A_SECOND, measure_few_bodies
from lesson_code.evidence.speed.piles import PILES, Pile, race_with_pile
from lesson_code.evidence.speed.processes import measure_memory, measure_start
from lesson_code.evidence.speed.race import run_race
from lesson_code.evidence.speed.report import Speed

REPEATS, QUICK_REPEATS = 7, 3

KEYS: dict[Callable[[int], SpeedScene], str] = {
    speed_scenes.gas: "gas",
    speed_scenes.dense_gas: "dense",
    speed_scenes.settled_discs: "settled",
    speed_scenes.stack: "stack",
    speed_scenes.pyramid: "pyramid",
    speed_scenes.bin_of_shapes: "bin",
}
"""What a scene is called on the command line; its size follows, as in "gas-100"."""

QUICK = ("gas-10", "gas-100", "gas-1000", "settled-100", "settled-1000", "stack-10", "pyramid-10")
"""Scenes that take a second or so each."""

ALL_MEMORY, QUICK_MEMORY = 100_000, 10_000
"""Discs whose memory is measured."""

QUICK_RATES = STEPS_A_SECOND[:-2]
"""Of pymunk in scenes of few bodies."""

BASE_SECONDS, SECONDS_PER_BODY = 3.0, 1e-3
"""s, roughly: a scene takes so long; the progress bar needs no more."""

PILE_SECONDS = 60.0
"""s, roughly: what a pile takes."""

Told = Callable[[str], None]


class Part(NamedTuple):
    """Something that is measured by itself."""

    key: str
    cost: float  # s, roughly
    measure: Callable[[Told], Any]


def parts(repeats: int, *, quick: bool = False) -> list[Part]:
    """Return all parts, in the order in which they are measured."""
    scenes = [
        _scene_part(build, size, repeats)
        for build, sizes in SIZES.items()
        for size in sizes
        if not quick or f"{KEYS[build]}-{size}" in QUICK
    ]
    rates = QUICK_RATES if quick else STEPS_A_SECOND
    discs = QUICK_MEMORY if quick else ALL_MEMORY
    piles = [_pile_part(pile, repeats) for pile in (PILES[:1] if quick else PILES)]
    return [
        *scenes,
        *piles,
        Part("few_bodies", 5.0 if quick else 60.0, lambda t: measure_few_bodies(repeats, rates, t)),
        Part("memory", 5.0 if quick else 30.0, lambda told: measure_memory(discs, told)),
        Part("start", 5.0 if quick else 30.0, lambda _: measure_start(repeats, cold=not quick)),
    ]


def chosen(offered: Sequence[Part], only: Sequence[str]) -> list[Part]:
    """Return the parts that are asked for by name, or by the beginning of a name; all for none.

    Raises
    ------
    ValueError
        A name fits no part.

    Examples
    --------
    >>> [part.key for part in chosen(parts(7), ["stack", "memory"])]
    ['stack-10', 'stack-20', 'memory']
    """
    for name in only:
        if not any(_fits(part.key, name) for part in offered):
            keys = ", ".join(part.key for part in offered)
            raise ValueError(f"only must name some of {keys}, got {name!r}")
    return [part for part in offered if not only or any(_fits(part.key, n) for n in only)]


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
        Whether to leave out what takes long.
    only : sequence of str
        Names of scenes and parts, such as "gas-100", "gas" or "memory"; all if there are none.
    told : callable
        Hears what is being done, and what share of all is done.

    Raises
    ------
    ValueError
        A name fits no part, or there are no repeats.
    RuntimeError
        Nothing can be compiled here.
    """
    refuse_without_compiler()
    count = (QUICK_REPEATS if quick else REPEATS) if repeats is None else repeats
    if count < 1:
        raise ValueError(f"repeats must be >= 1, got {count}")
    wanted = chosen(parts(count, quick=quick), only)
    whole, done = sum(part.cost for part in wanted), 0.0
    found: dict[str, Any] = {}
    for part in wanted:
        tell = partial(_tell, told, done / whole)
        tell(part.key)
        found[part.key] = part.measure(tell)
        done += part.cost
    told("done", 1.0)
    others = {key: found.pop(key) for key in OTHERS if key in found}
    piles = tuple(found.pop(pile.key) for pile in PILES if pile.key in found)
    return Speed(count, races=tuple(found.values()), piles=piles, **others)


OTHERS = ("few_bodies", "memory", "start")
"""Parts that are measured once."""


def _tell(told: Callable[[str, float], None], share: float, what: str) -> None:
    """Say what is being done, and what share of all is done."""
    told(what, share)


def _scene_part(build: Callable[[int], SpeedScene], size: int, repeats: int) -> Part:
    """Return the part of one scene."""
    key = f"{KEYS[build]}-{size}"
    cost = BASE_SECONDS + SECONDS_PER_BODY * size
    return Part(key, cost, lambda told: run_race(key, build(size), repeats, told))


def _pile_part(pile: Pile, repeats: int) -> Part:
    """Return the part of one pile that has to hold."""
    return Part(pile.key, PILE_SECONDS, lambda told: race_with_pile(pile, repeats, told))


def _fits(key: str, name: str) -> bool:
    """Return whether a part has a name, or one that begins with it."""
    return key == name or key.startswith(f"{name}-")
