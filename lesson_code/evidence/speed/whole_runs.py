"""What a user waits for: a fresh process, from its start over the import to the result.

The same scene, as numbers in a file, is run by :mod:`lesson_code.evidence.speed.user_program` with
each engine in turn, ours by the call that stands in the README. How long that takes depends on
whether the machine code of its program is kept from an earlier run, so both are measured. A second
call in the same process, as in a notebook, no longer pays for imports.
"""

from __future__ import annotations

import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from rich.table import Table

from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.evidence.engines import has_box2d
from lesson_code.evidence.measurement import (
    Limit,
    Measurement,
    at_most,
    digits,
    limits_table,
    table,
)
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import COVERED, falling_discs
from lesson_code.evidence.speed import user_program
from lesson_code.evidence.speed.targets import FEWEST_FOR_SECOND_CALL, WHOLE_RUNS
from lesson_code.geometry.shapes import Segment

resource: ModuleType | None
try:
    import resource
except ImportError:  # Windows tells no times of processes that have ended
    resource = None

PYMUNK, BOX2D, KEPT, FRESH = "pymunk", "Box2D v3", "ours, kept", "ours, nothing kept"
"""What a row is of."""

FIRST = {"pymunk": (PYMUNK, ""), "Box2D": (BOX2D, ""), "ours": (KEPT, "")}
FRESH_TIMES = {"nothing kept": (FRESH, ""), "wall": (FRESH, "wall")}
"""The columns: whose time, and which one, if not that of the table."""

LONG = 5.0
"""s: a process that takes longer is run once. Disturbances are a small part of so long a time."""

SCENES: dict[str, tuple[str, int, float]] = {
    "run-gas-10": ("gas", 10, 10.0),
    "run-gas-100": ("gas", 100, 10.0),
    "run-gas-1000": ("gas", 1_000, 10.0),
    "run-gas-10000": ("gas", 10_000, 5.0),
    "run-gas-100000": ("gas", 100_000, 1.0),
    "run-pile-30": ("pile", 30, 10.0),
    "run-pile-300": ("pile", 300, 10.0),
    "run-pile-3000": ("pile", 3_000, 5.0),
}
"""The scenes by their names on the command line: kind, discs, and the time simulated, s."""


@dataclass(frozen=True)
class RunTime:
    """How long one engine takes for one scene: medians, s.

    The time of the processor is that of the process and of all that it starts and waits for.
    """

    key: str  # of the scene, for the command line
    scene: str  # in words
    discs: int
    who: str
    cpu: float  # from the start of the process to its end
    wall: float
    second_cpu: float  # for another call in the same process; nan: not measured
    second_wall: float


@dataclass(frozen=True)
class WholeRuns(Measurement):
    """What all engines take for whole runs: a row for each scene and engine."""

    command = "measure speed"
    file = Path(__file__).with_name("stored.json")
    rows = {"times": RunTime}  # noqa: RUF012 - a class variable of the base
    derived = ("limits",)

    machine: dict[str, Any]
    times: tuple[RunTime, ...]

    def of(self, key: str, who: str) -> RunTime | None:
        """Return the row of a scene and an engine; None: it was not measured."""
        return next((row for row in self.times if (row.key, row.who) == (key, who)), None)

    @property
    def limits(self) -> list[Limit]:
        """What is wanted of ours, as a share of pymunk's time."""
        return list(self._limits())

    def _limits(self) -> Iterator[Limit]:
        for key in dict.fromkeys(row.key for row in self.times):
            ours, peer = self.of(key, KEPT), self.of(key, PYMUNK)
            if ours is None or peer is None:
                continue
            share, more = WHOLE_RUNS[key]
            most = three_digits(share * peer.cpu + more)
            yield at_most(f"{ours.scene}, kept, CPU s", ours.cpu, most)
            if ours.discs >= FEWEST_FOR_SECOND_CALL:
                what = f"{ours.scene}, second call, CPU s"
                yield at_most(what, ours.second_cpu, three_digits(peer.second_cpu))

    def tables(self) -> Iterator[Table]:
        """Yield the times of the first call and of the second, and what is wanted of them."""
        if self.times:
            yield self._table("From the start of Python to the result", "cpu", FIRST | FRESH_TIMES)
            yield self._table("Another call in the same process", "second_cpu", FIRST)
            yield limits_table(self.limits)

    def _table(self, title: str, time: str, engines: Mapping[str, tuple[str, str]]) -> Table:
        """Return the times of all scenes, and how many times as long the others take as ours."""

        def seconds(key: str, who: str, time: str) -> float:
            row = self.of(key, who)
            return math.nan if row is None else float(getattr(row, time))

        def cell(who: str, which: str) -> Callable[[str], str]:
            return lambda key: digits(seconds(key, who, which or time))

        def ratio(who: str) -> Callable[[str], str]:
            return lambda key: digits(seconds(key, who, time) / seconds(key, KEPT, time))

        names = {row.key: row.scene for row in self.times}
        columns = {
            "CPU time, s": names.__getitem__,
            **{heading: cell(*column) for heading, column in engines.items()},
            "pymunk/ours": ratio(PYMUNK),
            "Box2D/ours": ratio(BOX2D),
        }
        return table(title, columns, names)


class _Racer(NamedTuple):
    """A process to be timed: whose, the engine's name in the program, its folder, and its calls."""

    who: str
    engine: str
    folder: str
    calls: int


class _Seconds(NamedTuple):
    """How long a process took to the end of its first call, and its second call, s."""

    cpu: float
    wall: float
    second_cpu: float
    second_wall: float


def measure_whole_run(key: str, repeats: int) -> tuple[RunTime, ...]:
    """Measure one of the scenes: the engines in turn, several times unless that takes long."""
    kind, discs, seconds = SCENES[key]
    taken: dict[str, list[_Seconds]] = {}
    with tempfile.TemporaryDirectory() as place:
        scene = Path(place) / "scene.json"
        scene.write_text(json.dumps(numbers_of(kind, discs, seconds)), encoding="utf-8")
        _timed(_Racer(KEPT, "compiled", "kept", 1), scene)  # from now on its program is kept
        for turn in range(repeats):
            for racer in _racers(turn):
                before = taken.setdefault(racer.who, [])
                if not before or before[0].wall < LONG:
                    before.append(_timed(racer, scene))
    name = f"{kind} of {discs:,}, {seconds:g} s"
    return tuple(
        RunTime(key, name, discs, who, *map(_median, zip(*rows, strict=True)))
        for who, rows in taken.items()
    )


def numbers_of(kind: str, discs: int, seconds: float) -> dict[str, Any]:
    """Return a scene as numbers, which a program can give to any engine.

    >>> numbers_of("gas", 4, 1.0)["restitution"]
    1.0
    """
    scene = gas_of(discs, COVERED, seed=1) if kind == "gas" else falling_discs(discs)
    free = [body for body in scene.bodies if not body.is_static]
    walls = [body.shape for body in scene.bodies if isinstance(body.shape, Segment)]
    surface = free[0].material
    return {
        "places": [body.position for body in free],
        "velocities": [body.velocity for body in free],
        "walls": [(wall.start, wall.end) for wall in walls],
        "gravity": scene.gravity,
        "restitution": surface.restitution,
        "friction": surface.friction or 0.0,
        "seconds": seconds,
    }


def _racers(turn: int) -> list[_Racer]:
    """Return the processes of a turn; one of ours finds an empty folder each time."""
    others = [_Racer(PYMUNK, "pymunk", "kept", 2)]
    if has_box2d():
        others.append(_Racer(BOX2D, "box2d", "kept", 2))
    ours = [_Racer(KEPT, "ours", "kept", 2), _Racer(FRESH, "ours", f"empty-{turn}", 1)]
    return others + ours


def _timed(racer: _Racer, scene: Path) -> _Seconds:
    """Run a process, and return how long it took."""
    told = dict(os.environ, **{FOLDER_VARIABLE: str(scene.with_name(racer.folder))})
    told.pop("PYTHONDONTWRITEBYTECODE", None)  # else each start parses and compiles all modules
    command = [sys.executable, user_program.__file__, racer.engine, str(scene), str(racer.calls)]
    before, started = _cpu_of_children(), time.perf_counter()
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=told)  # noqa: S603
    wall, cpu = time.perf_counter() - started, _cpu_of_children() - before
    if racer.calls == 1:
        return _Seconds(cpu, wall, math.nan, math.nan)
    last = json.loads(done.stdout)
    return _Seconds(cpu - last["cpu"], wall - last["wall"], last["cpu"], last["wall"])


def _cpu_of_children() -> float:
    """Return the processor's time of all processes that this one has waited for, s.

    Theirs are in it, too. Where the system tells nothing it is the time on the wall.
    """
    if resource is None:
        return time.perf_counter()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return float(used.ru_utime + used.ru_stime)


def _median(seconds: tuple[float, ...]) -> float:
    """Return the median of some times, with the digits that they have."""
    return three_digits(statistics.median(seconds))


def three_digits(seconds: float) -> float:
    """Return a time with three digits: a process takes no more that could be measured again."""
    return float(f"{seconds:.3g}")
