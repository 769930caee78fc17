"""Piles that have to hold: what each engine needs for that, and how long it takes.

More iterations, or more sub-steps, carry a load further down and take longer: an engine may be
faster only because it lets a pile sink. So for each engine we look for the smallest setting in a
short list with which the pile holds to the end. With these settings the engines are timed in turns,
at equal quality.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.scenes.speed import SpeedScene, pyramid, stack
from lesson_code.evidence.speed.engines import SETTINGS, engines_for, start
from lesson_code.evidence.speed.quality import Gauge, states_of
from lesson_code.evidence.timing import in_turns, timed

ITERATIONS = (3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 60)
SUBSTEPS = (2, 3, 4, 5, 6, 8, 12, 16)
"""The settings to try, the cheapest first."""

LAST_SECOND, LOOKS = 1.0, 10
"""s, and how often the pile is looked at in the last second of a run; it must hold each time."""

HELD_UP = 2 * SLOP
"""Of the smaller body's width: no overlap of a pyramid may be deeper.

Pymunk with its 10 iterations just holds one of 50 rows so; the slop is left alone by all engines.
"""


@dataclass(frozen=True)
class Pile:
    """A pile, and the criteria for holding it."""

    key: str  # for the command line
    name: str  # in words
    build: Callable[[], SpeedScene]
    duration: float  # s, simulated
    farthest: float  # in a body's width: no body may be further from its place at the start
    deepest: float = math.inf  # in the smaller body's width: no overlap may be deeper

    def holds(self, scene: Scene, states: NDArray[np.float64], overlap: float) -> bool:
        """Return whether the pile holds in a state, shape (N, 6), with its deepest overlap.

        >>> scene = stack(3).scene
        >>> PILES["standing"].holds(scene, states_of(scene), overlap=0.0)
        True
        """
        moved = np.abs(states[:, :2] - states_of(scene)[:, :2])
        widths = np.array([body.shape.min_width for body in scene.bodies])
        in_place = (moved.max(axis=1) < self.farthest * widths).all()
        return bool(in_place) and overlap <= self.deepest


def _pyramid(rows: int) -> Pile:
    """Return a pyramid, which takes ten seconds to settle."""
    name = f"a pyramid of {rows} rows for 11 s, no overlap beyond {HELD_UP:g}"
    return Pile(f"held-{rows}", name, partial(pyramid, rows), 11.0, farthest=1.0, deepest=HELD_UP)


STANDING = Pile("standing", "a free stack of 20 for 60 s", partial(stack, 20), 60.0, farthest=0.5)

PILES = {pile.key: pile for pile in (STANDING, _pyramid(20), _pyramid(50))}
"""The piles that have to hold."""


@dataclass(frozen=True)
class Held:
    """The setting with which one engine holds a pile."""

    engine: str
    setting: int  # iterations, or sub-steps; the most that are tried if none holds
    held: bool  # to the end
    overlap: float  # the deepest in the last second, in the smaller body's width
    seconds: float  # for all steps: median


@dataclass(frozen=True)
class PileRace:
    """The settings with which all engines hold one pile."""

    key: str
    name: str
    rows: tuple[Held, ...]

    def least(self, *engines: str) -> float | None:
        """Return the least time of some engines that hold the pile, s; None: none of them does."""
        held = [row for row in self.rows if row.held and row.engine.split(",")[0] in engines]
        return min((row.seconds for row in held), default=None)

    def ratio(self, peer: str) -> float | None:
        """Return a peer's least time over ours; None: one of the two did not hold the pile."""
        ours, theirs = self.least("sequential", "substep"), self.least(peer)
        return theirs / ours if ours and theirs else None


class Attempt(NamedTuple):
    """How a pile did with a setting: whether it held, its deepest overlap, and the time, s."""

    setting: int
    held: bool
    overlap: float
    seconds: float


def race_with_pile(pile: Pile, repeats: int) -> PileRace:
    """Return the setting with which each engine holds a pile, and how long that takes."""
    found = {name: _least(pile, name) for name in engines_for(pile.build())}
    jobs = {name: partial(_time, pile, name, attempt.setting) for name, attempt in found.items()}
    times = in_turns(jobs, repeats)
    rows = [
        Held(name, attempt.setting, attempt.held, attempt.overlap, statistics.median(times[name]))
        for name, attempt in found.items()
    ]
    return PileRace(pile.key, pile.name, tuple(rows))


def _least(pile: Pile, name: str) -> Attempt:
    """Return the attempt with the cheapest setting that holds the pile, else with the dearest."""
    settings = SUBSTEPS if name in SETTINGS else ITERATIONS
    attempts = (_attempt(pile, name, setting) for setting in settings)
    return next(attempt for attempt in attempts if attempt.held or attempt.setting == settings[-1])


def _time(pile: Pile, name: str, setting: int) -> float:
    return _attempt(pile, name, setting).seconds


def _attempt(pile: Pile, name: str, setting: int) -> Attempt:
    """Run a pile to its end, and look at it in the last second."""
    speed_scene = pile.build()
    scene, gauge = speed_scene.scene, Gauge(speed_scene.scene)
    engine = start(name, speed_scene, setting)
    engine.advance(1)  # loads or compiles the program
    part = round(min(LAST_SECOND, pile.duration / 2) / speed_scene.dt) // LOOKS
    before = round(pile.duration / speed_scene.dt) - 1 - part * LOOKS
    seconds = timed(lambda: engine.advance(before)).worked
    held, deepest = True, 0.0
    for _ in range(LOOKS):
        seconds += timed(lambda: engine.advance(part)).worked
        states = engine.states()
        overlap = gauge.read(states).depth
        deepest = max(deepest, overlap)
        held = held and pile.holds(scene, states, overlap)
    return Attempt(setting, held, deepest, seconds)
