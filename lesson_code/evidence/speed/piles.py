"""Piles that have to hold: what each engine needs for that, and how long it takes.

More iterations, or more sub-steps, carry a load further down and take longer: an engine may be
faster only because it lets a pile sink. So for each the fewest of a short list are looked for with
which the pile holds to the end. With these the engines are timed, in turns: at equal quality.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.scenes.speed import SpeedScene, pyramid, stack
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.engines import Engine, builder, engines_for
from lesson_code.evidence.speed.quality import Gauge, states_of

ITERATIONS = (3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 60)
SUBSTEPS = (2, 3, 4, 5, 6, 8, 12, 16)
"""What is tried, the cheapest first."""

LAST_SECOND, LOOKS = 1.0, 10
"""s: in the last second of a run the pile is looked at so often, and must hold each time."""

HELD_UP = 2 * SLOP
"""Of the smaller body's width: no overlap of a pyramid may be deeper.

Pymunk with its 10 iterations just holds one of 50 rows so; the slop is left alone by all engines.
"""


@dataclass(frozen=True)
class Pile:
    """A pile, and what holding means for it.

    Attributes
    ----------
    key, name : str
        For the command line, and in words.
    build : callable
        Makes the scene.
    duration : float
        s, simulated.
    farthest : float
        Of a body's width: no body may be further from its place at the start.
    deepest : float
        Of the smaller body's width: no overlap may be deeper.
    """

    key: str
    name: str
    build: Callable[[], SpeedScene]
    duration: float
    farthest: float
    deepest: float = math.inf

    def holds(self, scene: Scene, states: NDArray[np.float64], overlap: float) -> bool:
        """Return whether the pile holds in a state, shape (N, 6), with its deepest overlap.

        >>> scene = stack(3).scene
        >>> PILES[0].holds(scene, states_of(scene), overlap=0.0)
        True
        """
        moved = np.abs(states[:, :2] - states_of(scene)[:, :2])
        widths = np.array([body.shape.extent for body in scene.bodies])
        in_place = (moved.max(axis=1) < self.farthest * widths).all()
        return bool(in_place) and overlap <= self.deepest


PILES = (
    Pile("standing", "a free stack of 20 for 60 s", lambda: stack(20), 60.0, farthest=0.5),
    *[
        Pile(
            f"held-{rows}",
            f"a pyramid of {rows} rows for 11 s, no overlap beyond {HELD_UP:g}",
            lambda rows=rows: pyramid(rows),  # type: ignore[misc]
            11.0,
            farthest=1.0,
            deepest=HELD_UP,
        )
        for rows in (20, 50)
    ],
)
"""What has to hold. A pyramid takes ten seconds to settle."""


@dataclass(frozen=True)
class Held:
    """What one engine needs for a pile that holds.

    Attributes
    ----------
    engine : str
        Its name.
    setting : int
        Iterations, for "substep" sub-steps; the most that were tried if the pile held with none.
    held : bool
        Whether the pile held to the end.
    overlap : float
        The deepest in the last second, as a share of the smaller body's width.
    seconds : float
        For all steps: median.
    """

    engine: str
    setting: int
    held: bool
    overlap: float
    seconds: float


@dataclass(frozen=True)
class PileRace:
    """What all engines need for one pile."""

    key: str
    name: str
    rows: tuple[Held, ...]

    def ratio(self, peer: str) -> float | None:
        """Return a peer's least time over ours; None: one of the two did not hold the pile."""
        held = [row for row in self.rows if row.held]
        ours = [row.seconds for row in held if row.engine in ("sequential", "substep")]
        theirs = [row.seconds for row in held if row.engine.startswith(peer)]
        return min(theirs) / min(ours) if ours and theirs else None


@dataclass
class _Trial:
    """An engine with the setting that is timed."""

    engine: str
    setting: int
    held: bool
    overlap: float
    seconds: list[float] = field(default_factory=list)


def race_with_pile(
    pile: Pile, repeats: int, told: Callable[[str], None] = lambda _: None
) -> PileRace:
    """Return what lets a pile hold in each engine, and how long that takes.

    Parameters
    ----------
    pile : Pile
        What has to hold.
    repeats : int
        How often each is timed, >= 1.
    told : callable
        Hears what is being done.
    """
    trials = []
    for name in engines_for(pile.build()):
        told(f"{pile.name}: what {name} needs")
        trials.append(_least(pile, name))
    for repeat in range(repeats):
        told(f"{pile.name}: {repeat + 1} of {repeats}")
        for trial in trials:
            trial.seconds.append(_run(pile, trial.engine, trial.setting)[2])
    rows = [
        Held(t.engine, t.setting, t.held, t.overlap, statistics.median(t.seconds)) for t in trials
    ]
    return PileRace(pile.key, pile.name, tuple(rows))


def _least(pile: Pile, name: str) -> _Trial:
    """Return an engine with the cheapest setting with which a pile holds."""
    held, overlap, setting = False, math.inf, 0
    for setting in SUBSTEPS if name == "substep" else ITERATIONS:
        held, overlap, _ = _run(pile, name, setting)
        if held:
            break
    return _Trial(name, setting, held, overlap)


def _run(pile: Pile, name: str, setting: int) -> tuple[bool, float, float]:
    """Return whether a pile holds, its deepest overlap, and the time that the steps take, s."""
    speed_scene = pile.build()
    scene, gauge = speed_scene.scene, Gauge(speed_scene.scene)
    engine = _built(speed_scene, name, setting)
    engine.advance(1)  # loads or compiles the program
    last = round(min(LAST_SECOND, pile.duration / 2) / speed_scene.dt)
    looks = [last // LOOKS] * LOOKS
    seconds = _seconds(engine, round(pile.duration / speed_scene.dt) - 1 - sum(looks))
    held, deepest = True, 0.0
    for steps in looks:
        seconds += _seconds(engine, steps)
        states = engine.states()
        overlap = gauge.read(states).depth
        deepest = max(deepest, overlap)
        held = held and pile.holds(scene, states, overlap)
    return held, deepest, seconds


def _seconds(engine: Engine, steps: int) -> float:
    """Return how long an engine works on so many steps, s."""
    start = worked_seconds()
    engine.advance(steps)
    return worked_seconds() - start


def _built(speed_scene: SpeedScene, name: str, setting: int) -> Engine:
    """Return an engine with its iterations or sub-steps."""
    if name == "substep":
        return builder(name, speed_scene, substeps=setting)()
    return builder(name, speed_scene, iterations=setting)()
