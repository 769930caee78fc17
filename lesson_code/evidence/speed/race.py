"""A race: every engine makes the same steps of the same scene, in turns, in one process.

    1 our engine makes the steps of the warm-up that are too many for the others (a large gas)
    2 each engine makes the rest of the warm-up itself; our first steps load or compile a program
    3 in turns, each makes a batch of steps: many in one call, timed; what follows is not timed
    4 after each batch: how deep the bodies stand in each other, and their energy

So a disturbance of the machine meets all engines alike. A scene that does not last, such as a
stack, is built and warmed up anew before each batch.
"""

from __future__ import annotations

import gc
import math
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace

from lesson_code.engine.core.scene import Scene, scene_at
from lesson_code.evidence.scenes.speed import SpeedScene
from lesson_code.evidence.speed.clock import CPU_CLOCK_IS_FINE
from lesson_code.evidence.speed.engines import (
    PYMUNK,
    Build,
    Engine,
    builder,
    bytes_of,
    engines_for,
    let_go,
)
from lesson_code.evidence.speed.quality import (
    Gauge,
    Reading,
    energy_to_lift,
    states_of,
)
from lesson_code.evidence.speed.statistics import Quality, worse_in

BODY_STEPS, FEWEST_STEPS = 2_000_000, 100
"""Of the warm-up, that each engine makes itself: bodies times steps, but so many steps at least.

A pile begins as it is built: one of 100,000 discs has come to rest in ours after some 60 steps.
"""

TRIED_STEPS = 40
"""Steps of ours that show how long one takes, and how large the tables become."""

BATCH_SECONDS = 0.02
"""s: our sequential solver works at least so long in a batch, unless that is too many steps."""

MOST_STEPS, LEAST_STEPS = 2_000, 2
"""Of a batch."""

LOOKED_AT = 700
"""Bodies of a gas that the ends of a batch show at least: few have few contacts, and the deepest of
them is a draw. With a smaller gas there are more batches."""

SHORT_BATCH_REPEATS = 3
"""Times as many batches where they have to be short, because the scene does not last."""


@dataclass(frozen=True)
class Timing:
    """What one engine did in a scene.

    Attributes
    ----------
    engine : str
        Its name.
    seconds, cpu_seconds : float
        For a step: median of the batches, by the clock and of the processor.
    quality : Quality
        Overlap and energy.
    contacts_per_body : float
        Contact points at the end, for each body that can move.
    bytes_per_body : float or None
        Of all tables; None for engines that are not ours.
    first_call : float
        s: its first step, with loading or compiling a program.
    """

    engine: str
    seconds: float
    cpu_seconds: float
    quality: Quality
    contacts_per_body: float
    bytes_per_body: float | None
    first_call: float

    @property
    def compared(self) -> float:
        """The time that is compared, s a step: by the clock that others do not disturb."""
        return self.cpu_seconds if CPU_CLOCK_IS_FINE else self.seconds


@dataclass(frozen=True)
class Race:
    """What all engines did in a scene.

    Attributes
    ----------
    key, name : str
        Of the scene: for the command line, and in words.
    bodies : int
        That can move.
    steps, batches : int
        Steps of a batch, and how many batches there were.
    timings : tuple of Timing
        Ours first.
    """

    key: str
    name: str
    bodies: int
    steps: int
    batches: int
    timings: tuple[Timing, ...]

    def timing(self, engine: str) -> Timing | None:
        """Return what an engine did; "pymunk" is the faster of its two; None: it did not run."""
        names = PYMUNK if engine == "pymunk" else (engine,)
        found = [timing for timing in self.timings if timing.engine in names]
        return min(found, key=lambda timing: timing.compared, default=None)

    def ratio(self, ours: str, peer: str) -> float | None:
        """Return how many times longer a peer takes; None: one of the two did not run."""
        mine, theirs = self.timing(ours), self.timing(peer)
        return theirs.compared / mine.compared if mine and theirs else None

    def worse(self, ours: str, peer: str) -> tuple[str, ...]:
        """Return in what our quality is worse than a peer's."""
        mine, theirs = self.timing(ours), self.timing(peer)
        return worse_in(mine.quality, theirs.quality) if mine and theirs else ()


@dataclass
class _Runner:
    """One engine in a race, and what has been measured of it so far."""

    name: str
    build: Build
    engine: Engine
    first_call: float
    seconds: list[float] = field(default_factory=list)
    cpu_seconds: list[float] = field(default_factory=list)
    readings: list[Reading] = field(default_factory=list)


def run_race(
    key: str,
    speed_scene: SpeedScene,
    repeats: int,
    told: Callable[[str], None] = lambda _: None,
) -> Race:
    """Let all engines that can take a scene make batches of steps in turns.

    Parameters
    ----------
    key : str
        A name for the scene, such as "gas-100".
    speed_scene : SpeedScene
        The scene.
    repeats : int
        Batches, >= 1; several times as many where the scene does not last, or is a small gas.
    told : callable
        Hears what is being done.
    """
    told(f"{speed_scene.name}: head start")
    speed_scene, own_steps = with_head_start(speed_scene)
    scene, gauge = speed_scene.scene, Gauge(speed_scene.scene)
    runners = []
    for name, build in engines_for(speed_scene).items():
        told(f"{speed_scene.name}: {name} warms up")
        runners.append(_warmed_up(name, build, own_steps))
    steps = _steps_of_a_batch(speed_scene, runners[0], own_steps)
    gc.freeze()  # else each look for what can be thrown away takes longer than a batch
    batches = repeats * _draws_for(speed_scene)
    for batch in range(batches):
        told(f"{speed_scene.name}: batch {batch + 1} of {batches}")
        for runner in runners:
            if speed_scene.lasts is not None:
                runner.engine = _started(runner.build, own_steps)
            _run_batch(runner, steps)
        for runner in runners:
            runner.readings.append(gauge.read(runner.engine.states()))
    gc.unfreeze()
    for runner in runners:
        let_go(runner.engine)
    bodies = sum(not body.is_static for body in scene.bodies)
    started = gauge.energy(states_of(scene))
    timings = tuple(_timing(runner, scene, bodies, started) for runner in runners)
    return Race(key, speed_scene.name, bodies, steps, batches, timings)


def with_head_start(speed_scene: SpeedScene) -> tuple[SpeedScene, int]:
    """Return a scene that our engine has advanced, and the steps that each engine makes itself.

    Our engine advances a large gas. A pile begins as it is built: handed over, it would have lost
    the impulses that carry it, and all of it would sink at once.
    """
    bodies = len(speed_scene.scene.bodies)
    own = min(speed_scene.warm_up, max(FEWEST_STEPS, BODY_STEPS // bodies))
    ahead = speed_scene.warm_up - own
    if ahead == 0 or any(speed_scene.scene.gravity):
        return speed_scene, own
    engine = builder("sequential", speed_scene)()
    engine.advance(ahead)
    return replace(speed_scene, scene=scene_at(speed_scene.scene, engine.states())), own


def _draws_for(speed_scene: SpeedScene) -> int:
    """Return how many times as many batches a scene needs."""
    if speed_scene.lasts is not None:
        return SHORT_BATCH_REPEATS
    is_gas = not any(speed_scene.scene.gravity)
    return max(1, LOOKED_AT // len(speed_scene.scene.bodies)) if is_gas else 1


def _started(build: Build, steps: int) -> Engine:
    """Return an engine that has made its warm-up."""
    engine = build()
    engine.advance(steps)
    return engine


def _warmed_up(name: str, build: Build, steps: int) -> _Runner:
    """Return an engine that has made its warm-up, and what its first step took."""
    engine = build()
    start = time.perf_counter()
    engine.advance(1)
    first_call = time.perf_counter() - start
    engine.advance(steps - 1)
    return _Runner(name, build, engine, first_call)


def _steps_of_a_batch(speed_scene: SpeedScene, runner: _Runner, own_steps: int) -> int:
    """Return how many steps a batch has: enough to be timed in our engine."""
    most = MOST_STEPS if speed_scene.lasts is None else speed_scene.lasts
    engine = runner.engine if speed_scene.lasts is None else _started(runner.build, own_steps)
    tried = min(most, TRIED_STEPS)
    start = time.perf_counter()
    engine.advance(tried)
    step = (time.perf_counter() - start) / tried
    return min(most, max(LEAST_STEPS, math.ceil(BATCH_SECONDS / step)))


def _run_batch(runner: _Runner, steps: int) -> None:
    """Let an engine make a batch of steps, and take the time."""
    gc.collect()
    gc.disable()
    cpu, start = time.process_time(), time.perf_counter()
    runner.engine.advance(steps)
    end, cpu_end = time.perf_counter(), time.process_time()
    gc.enable()
    runner.seconds.append((end - start) / steps)
    runner.cpu_seconds.append((cpu_end - cpu) / steps)


def _timing(runner: _Runner, scene: Scene, bodies: int, started: float) -> Timing:
    """Return medians of what has been measured."""
    size = bytes_of(runner.engine)
    energies = [reading.energy for reading in runner.readings]
    contacts = statistics.median(reading.contacts for reading in runner.readings)
    overlap = statistics.median(reading.depth for reading in runner.readings)
    return Timing(
        engine=runner.name,
        seconds=statistics.median(runner.seconds),
        cpu_seconds=statistics.median(runner.cpu_seconds),
        quality=_quality(overlap, energies, started, energy_to_lift(scene)),
        contacts_per_body=contacts / bodies,
        bytes_per_body=None if size is None else size / bodies,
        first_call=runner.first_call,
    )


def _quality(overlap: float, energies: list[float], started: float, lift: float) -> Quality:
    """Return a quality: a gas must keep its energy, a pile must have none of motion."""
    if lift == 0.0:
        return Quality(overlap, abs(energies[-1] / started - 1), "drift")
    return Quality(overlap, statistics.median(energies) / lift, "left")
