"""Measurements that need fresh processes: imports, first compiled runs, memory."""

from __future__ import annotations

import gc
import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.engine.core.mixing import MIXING_RULES, MixingRule
from lesson_code.evidence.scenes.speed import SpeedScene, gas
from lesson_code.evidence.speed.engines import start
from lesson_code.evidence.speed.race import bytes_of
from lesson_code.evidence.timing import timed
from lesson_code.reference.scene_mapping import own_values, refuse_heap

HEAVY = ("numba", "matplotlib", "pygame", "pymunk")
"""Modules that should load only when they are used."""

FIRST_STEPS = 40
"""After which the tables are as large as they become."""

IMPORT = f"""
import sys, time
start = time.perf_counter()
import lesson_code.simulation
print(time.perf_counter() - start)
print(*[m for m in {HEAVY} if m in sys.modules])
"""

FIRST_RUN = """
from lesson_code import simulate
from lesson_code.evidence.scenes.gas import disc_gas
simulate(disc_gas(10, 0.3, seed=1), 1.0, compiled=True)
"""

MEMORY = """
from lesson_code.evidence.speed.processes import resident_growth
print(resident_growth({count}))
"""


@dataclass(frozen=True)
class Start:
    """How long it takes until something runs, s; median where it is done more than once."""

    importing: float  # `import lesson_code.simulation`, in a fresh process
    loaded: tuple[str, ...]  # which of the heavy modules that has loaded: none is meant to be
    cold: float | None  # a process that runs 100 discs compiled, with nothing kept
    kept: float | None  # the same with the programs that are kept; None: not measured


@dataclass(frozen=True)
class Memory:
    """Memory for a gas, bytes a body."""

    bodies: int
    ours: float  # all our tables
    pymunk: float | None  # what the process grows by; None: the system does not tell


def measure_start(repeats: int, *, cold: bool = True) -> Start:
    """Measure imports, and first compiled runs unless that is not wanted: it takes ten seconds."""
    _output(IMPORT)  # writes the byte code
    told = [_output(IMPORT).split() for _ in range(repeats)]
    importing = statistics.median(float(seconds) for seconds, *_ in told)
    loaded = tuple(told[-1][1:])
    if not cold:
        return Start(importing, loaded, None, None)
    with tempfile.TemporaryDirectory() as folder:
        kept = {FOLDER_VARIABLE: folder}
        first, *later = (timed(lambda: _output(FIRST_RUN, kept)).wall for _ in range(1 + repeats))
    return Start(importing, loaded, first, statistics.median(later))


def measure_memory(count: int) -> Memory:
    """Measure the memory for a gas of `count` discs."""
    engine = start("sequential", gas(count))
    engine.advance(FIRST_STEPS)
    growth = json.loads(_output(MEMORY.format(count=count)))
    theirs = None if growth is None else growth / count
    return Memory(count, (bytes_of(engine) or 0) / count, theirs)


def resident_growth(count: int) -> str:
    """Return by how many bytes pymunk makes this process grow with a gas, as JSON.

    Objects that our own code needs to pass the scene on are created and deleted beforehand.
    """
    scene = gas(count)
    refuse_heap(scene.scene)
    own_values(scene.scene.bodies, MixingRule(), MIXING_RULES["pymunk"])
    before = _resident()
    space = _running_space(scene)
    after = _resident()
    del space
    return json.dumps(None if before is None or after is None else after - before)


def _running_space(scene: SpeedScene) -> Any:
    """Return pymunk's space after some steps, and none of our own lists around it."""
    engine: Any = start("pymunk, tree", scene)
    engine.advance(FIRST_STEPS)
    return engine.space


def _resident() -> int | None:
    """Return how much memory this process has, bytes; None where the system does not tell."""
    gc.collect()
    file = Path("/proc/self/statm")
    if not file.exists():
        return None
    return int(file.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def _output(code: str, more: Mapping[str, str] | None = None) -> str:
    """Return what some code prints in a process of its own, which may write byte code.

    Without byte code every start would parse and compile all modules again.
    """
    told = {key: value for key, value in os.environ.items() if key != "PYTHONDONTWRITEBYTECODE"}
    done = subprocess.run(  # noqa: S603
        [sys.executable, "-c", code],
        capture_output=True,
        text=True,
        check=True,
        env=told | dict(more or {}),
    )
    return done.stdout.strip()
