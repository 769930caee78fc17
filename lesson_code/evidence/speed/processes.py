"""What can only be measured in fresh processes: imports, first compiled runs, memory."""

from __future__ import annotations

import gc
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.engine.core.mixing import COMBINATIONS, Combination
from lesson_code.evidence.scenes.speed import gas
from lesson_code.evidence.speed.engines import PYMUNK, builder, bytes_of
from lesson_code.evidence.speed.race import TRIED_STEPS
from lesson_code.reference.pymunk_reference import PymunkStepper
from lesson_code.reference.scene_mapping import own_values, refuse_heap

HEAVY = ("numba", "matplotlib", "pygame", "pymunk")
"""Modules that are to be loaded only when they are used."""

IMPORT = """
import sys, time
start = time.perf_counter()
import lesson_code.simulation
print(time.perf_counter() - start)
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
    """How long it takes until something runs, s; median where it is done more than once.

    Attributes
    ----------
    importing : float
        `import lesson_code.simulation`, in a fresh process.
    loaded : tuple of str
        Which of the heavy modules that has loaded: none is meant to be.
    cold, kept : float or None
        A process from its start to its end that runs 100 discs compiled: with nothing kept, and
        with the programs that are kept. None: not measured.
    """

    importing: float
    loaded: tuple[str, ...]
    cold: float | None
    kept: float | None


@dataclass(frozen=True)
class Memory:
    """Memory for a gas.

    Attributes
    ----------
    bodies : int
        How many discs.
    ours : float
        All our tables, bytes a body.
    pymunk : float or None
        What pymunk makes the process grow by, resident, bytes a body. None: the system does not
        tell.
    """

    bodies: int
    ours: float
    pymunk: float | None


def measure_start(repeats: int, *, cold: bool = True) -> Start:
    """Measure imports, and first compiled runs.

    Parameters
    ----------
    repeats : int
        How often each is done, >= 1; a cold start only once.
    cold : bool
        Whether to compile a program with nothing kept, which takes some ten seconds.
    """
    code = IMPORT + f"print(*[m for m in {HEAVY} if m in sys.modules])"
    _output(code)  # writes the byte code
    lines = [_output(code).splitlines() for _ in range(repeats)]
    importing = statistics.median(float(line[0]) for line in lines)
    loaded = tuple(lines[-1][1].split()) if len(lines[-1]) > 1 else ()
    if not cold:
        return Start(importing, loaded, None, None)
    with tempfile.TemporaryDirectory() as folder:
        first, *later = (_seconds(FIRST_RUN, folder) for _ in range(1 + repeats))
    return Start(importing, loaded, first, statistics.median(later))


def measure_memory(count: int, told: Callable[[str], None] = lambda _: None) -> Memory:
    """Measure the memory for a gas of so many discs."""
    told(f"memory of {count:,} discs")
    engine = builder("sequential", gas(count))()
    engine.advance(TRIED_STEPS)
    growth = json.loads(_output(MEMORY.format(count=count)))
    theirs = None if growth is None else growth / count
    return Memory(count, (bytes_of(engine) or 0) / count, theirs)


def resident_growth(count: int) -> str:
    """Return by how many bytes pymunk makes this process grow with a gas, as JSON.

    What our own code needs to hand the scene over is made before and thrown away.
    """
    scene = gas(count)
    refuse_heap(scene.scene)
    own_values(scene.scene.bodies, Combination(), COMBINATIONS["pymunk"])
    before = _resident()
    space = _running_space(scene)
    after = _resident()
    del space
    return json.dumps(None if before is None or after is None else after - before)


def _running_space(scene: Any) -> Any:
    """Return pymunk's space after some steps, and none of our own lists around it."""
    engine = builder(PYMUNK[0], scene)()
    engine.advance(TRIED_STEPS)
    if not isinstance(engine, PymunkStepper):  # pragma: no cover - it was asked for
        raise TypeError("pymunk must run")
    return engine.space


def _resident() -> int | None:
    """Return how much memory this process has, bytes; None where the system does not tell."""
    gc.collect()
    file = Path("/proc/self/statm")
    if not file.exists():
        return None
    return int(file.read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def _output(code: str) -> str:
    """Return what some code prints in a process of its own."""
    done = subprocess.run(  # noqa: S603
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, env=_environment()
    )
    return done.stdout.strip()


def _seconds(code: str, folder: str) -> float:
    """Return how long a process lives that runs some code, its programs kept in a folder, s."""
    start = time.perf_counter()
    subprocess.run(  # noqa: S603
        [sys.executable, "-c", code], check=True, env=_environment() | {FOLDER_VARIABLE: folder}
    )
    return time.perf_counter() - start


def _environment() -> dict[str, str]:
    """Return this process's environment, but for the order to write no byte code.

    Where it stands every start would read and translate all modules anew.
    """
    return {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
