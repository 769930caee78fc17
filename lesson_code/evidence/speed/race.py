"""A race: every engine makes the same steps of the same scene, in turns, in one process.

    1 each engine warms up; our first step loads or compiles a program
    2 in turns, each makes a batch of steps: many in one call, timed
    3 after each batch: how deep the bodies overlap, and their energy

A scene that does not last, such as a stack, is built and warmed up anew before each batch.
"""

from __future__ import annotations

import gc
import statistics
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np

from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.engines import Engine
from lesson_code.evidence.scenes.speed import SpeedScene
from lesson_code.evidence.speed.engines import OURS, PEERS, engines_for, start
from lesson_code.evidence.speed.quality import Gauge, Quality, Reading, worse_in
from lesson_code.evidence.speed.targets import target_of
from lesson_code.evidence.timing import Seconds, steps_of_a_batch, timed
from lesson_code.reference.pymunk_reference import PymunkStepper

BODY_STEPS, FEWEST_STEPS = 2_000_000, 100
"""Of the warm-up: no more bodies times steps, but this many steps at least.

A pile begins as it is built: one of 100,000 discs has come to rest in ours after some 60 steps.
"""

BATCH_SECONDS = 0.02
"""s: our sequential solver works about as long in a batch, unless that is too many steps."""

MOST_STEPS, LEAST_STEPS = 2_000, 2
"""Of a batch."""

LOOKED_AT = 700
"""Bodies of a gas that the ends of a batch show at least: few have few contacts, and the deepest of
them is a draw. With a smaller gas there are more batches."""

SHORT_BATCH_REPEATS = 3
"""Times as many batches where they have to be short, because the scene does not last."""


@dataclass(frozen=True)
class Timing:
    """The results of one engine in a scene; medians of the batches."""

    engine: str
    seconds: float  # for a step, by the clock on the wall
    cpu_seconds: float  # for a step, of the processor
    quality: Quality
    contacts_per_body: float  # points, for each body that can move
    bytes_per_body: float | None  # of all tables; None for engines that are not ours
    first_call: float  # s: its first step, with loading or compiling a program

    @property
    def compared(self) -> float:
        """The time that is compared, s a step."""
        return Seconds(self.seconds, self.cpu_seconds).worked


@dataclass(frozen=True)
class Ratio:
    """How many times longer a peer takes, in what we are worse, and what is wanted."""

    derived: ClassVar = ("reached",)

    scene: str
    ours: str
    peer: str
    ratio: float
    worse: tuple[str, ...]
    wanted: float | None

    @property
    def reached(self) -> bool | None:
        """Whether the target is reached at equal quality; None: there is none."""
        return None if self.wanted is None else self.ratio >= self.wanted and not self.worse


@dataclass(frozen=True)
class Race:
    """The results of all engines in a scene, ours first."""

    derived: ClassVar = ("ratios",)

    key: str  # of the scene, for the command line
    name: str  # in words
    bodies: int  # that can move
    steps: int  # of a batch
    batches: int
    engines: tuple[Timing, ...]

    @property
    def kind(self) -> str:
        """The scene without its size, as in "gas"."""
        return self.key.split("-")[0]

    def timing(self, engine: str) -> Timing | None:
        """Return what an engine did; "pymunk" is the faster of its two; None: it did not run."""
        found = [t for t in self.engines if t.engine.split(",")[0] == engine]
        return min(found, key=lambda timing: timing.compared, default=None)

    def ratio(self, ours: str, peer: str) -> Ratio | None:
        """Return how one of ours compares with a peer; None: one of the two did not run."""
        mine, theirs = self.timing(ours), self.timing(peer)
        if mine is None or theirs is None:
            return None
        worse = worse_in(mine.quality, theirs.quality)
        wanted = target_of(self.key, ours, peer)
        return Ratio(self.key, ours, peer, theirs.compared / mine.compared, worse, wanted)

    @property
    def ratios(self) -> list[Ratio]:
        """Each of ours against each peer."""
        found = [self.ratio(ours, peer) for ours in OURS for peer in PEERS]
        return [ratio for ratio in found if ratio is not None]


@dataclass
class _Runner:
    """One engine in a race, and what has been measured so far."""

    name: str
    engine: Engine
    first_call: float
    times: list[Seconds] = field(default_factory=list)
    readings: list[Reading] = field(default_factory=list)


def run_race(key: str, speed_scene: SpeedScene, repeats: int) -> Race:
    """Run all engines that can take a scene, in batches: `repeats` of them.

    There are several times as many where the scene does not last, or is a small gas.
    """
    gauge, lasts = Gauge(speed_scene.scene), speed_scene.lasts is None
    runners = [_warmed_up(name, speed_scene) for name in engines_for(speed_scene)]
    trial = runners[0] if lasts else _warmed_up(runners[0].name, speed_scene)
    most = speed_scene.lasts or MOST_STEPS
    steps = steps_of_a_batch(trial.engine, BATCH_SECONDS, most, LEAST_STEPS)
    batches = repeats * _batches_a_repeat(speed_scene)
    gc.collect()
    gc.freeze()  # else each look for what can be thrown away takes longer than a batch
    for _ in range(batches):
        for runner in runners:
            if not lasts:
                runner.engine = _warmed_up(runner.name, speed_scene).engine
            runner.times.append(timed(lambda r=runner: r.engine.advance(steps)))  # type: ignore[misc]
        for runner in runners:
            runner.readings.append(gauge.read(runner.engine.states()))
    gc.unfreeze()
    bodies = sum(not body.is_static for body in speed_scene.scene.bodies)
    engines = tuple(_timing(runner, gauge, bodies, steps) for runner in runners)
    return Race(key, speed_scene.name, bodies, steps, batches, engines)


def warm_up_of(speed_scene: SpeedScene) -> int:
    """Return the steps that each engine makes before the measurement."""
    bodies = len(speed_scene.scene.bodies)
    return min(speed_scene.warm_up, max(FEWEST_STEPS, BODY_STEPS // bodies))


def _warmed_up(name: str, speed_scene: SpeedScene) -> _Runner:
    engine = start(name, speed_scene)
    first_call = timed(lambda: engine.advance(1)).wall
    engine.advance(warm_up_of(speed_scene) - 1)
    return _Runner(name, engine, first_call)


def _batches_a_repeat(speed_scene: SpeedScene) -> int:
    if speed_scene.lasts is not None:
        return SHORT_BATCH_REPEATS
    is_gas = not any(speed_scene.scene.gravity)
    return max(1, LOOKED_AT // len(speed_scene.scene.bodies)) if is_gas else 1


def _timing(runner: _Runner, gauge: Gauge, bodies: int, steps: int) -> Timing:
    """Return the medians of what has been measured, and prepare the engine to be thrown away."""
    size = bytes_of(runner.engine)
    if isinstance(runner.engine, PymunkStepper):
        runner.engine.forget_contacts()  # else it takes long to be thrown away
    return Timing(
        engine=runner.name,
        seconds=statistics.median(taken.wall for taken in runner.times) / steps,
        cpu_seconds=statistics.median(taken.cpu for taken in runner.times) / steps,
        quality=gauge.quality(runner.readings),
        contacts_per_body=statistics.median(r.contacts for r in runner.readings) / bodies,
        bytes_per_body=None if size is None else size / bodies,
        first_call=runner.first_call,
    )


def bytes_of(engine: Engine) -> int | None:
    """Return the size of all tables of one of our engines; None where they are no arrays."""
    if isinstance(engine, EngineStepper):
        return sum(np.asarray(table).nbytes for table in engine.world)
    return None
