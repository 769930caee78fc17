"""Compiling in a process of its own, which a run can wait for, or leave to itself.

The process is told its program, and keeps the machine code in the library. Its standard input is
the thread that it hangs on. When that is cut, because whoever has started it has ended or was
killed, it ends too. If it is told to finish first, it has :data:`FINISH_SECONDS` more. No file is
left half written.
"""

from __future__ import annotations

import gc
import os
import pickle
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path
from typing import IO

from lesson_code.engine.compiled import library, ready_made
from lesson_code.engine.compiled.loader import Entry, linked
from lesson_code.engine.compiled.program import Program

FINISH_SECONDS = 30.0
"""s, that a process has to finish when nobody waits for it any more; a program takes 5 to 30 s."""

NICENESS = 5
"""By how much a process in the background gives way to others, as `nice` counts. By Linux's weights
it gets about a third of their share, and with 10 a tenth."""

FINISH = b"finish"
"""The word that a process finishes upon."""

LENGTH = 8
"""Bytes, in which the process is told how long its program is."""

HOUSE = Path(__file__).parents[3]
"""Where the package lies."""


class Compiling:
    """A process that compiles a program.

    Parameters
    ----------
    program : Program
        What is compiled. If another process is at it already, this one waits for that.
    in_background : bool
        Whether it gives way to all other processes.

    Raises
    ------
    OSError
        No process can be started here.
    """

    def __init__(self, program: Program, *, in_background: bool) -> None:
        self.program, self._began = program, time.perf_counter()
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115 - `leave` closes it
        self._process = subprocess.Popen(  # noqa: S603 - our own module
            [sys.executable, "-P", "-c", f"from {__name__} import main; main()"],
            stdin=subprocess.PIPE,
            stdout=subprocess.DEVNULL,
            stderr=self._errors,
            env=os.environ | {"PYTHONPATH": os.pathsep.join([str(HOUSE), *filter(None, sys.path)])},
            process_group=0,  # Ctrl-C is for the run, which then cuts the thread
        )
        niceness = NICENESS if in_background else 0
        told = pickle.dumps((library.place_to_write(), program, niceness))
        with suppress(OSError):  # it has ended by itself, and `wait` tells why
            self._input.write(len(told).to_bytes(LENGTH) + told)
            self._input.flush()

    @property
    def seconds(self) -> float:
        """For how long it has been at work, s."""
        return time.perf_counter() - self._began

    def is_over(self) -> bool:
        """Return whether it has ended, well or not."""
        return self._process.poll() is not None

    def wait(self) -> str:
        """Wait until it has ended, and return what it has said about an error.

        An interrupted wait ends it.
        """
        try:
            self._process.wait()
            self._errors.seek(0)
            return self._errors.read().decode(errors="replace")
        finally:
            self.leave(to_finish=False)

    def leave(self, *, to_finish: bool) -> None:
        """Let it end: now, or after it has finished."""
        with suppress(OSError):  # it has ended by itself
            if to_finish:
                self._input.write(FINISH)
        with suppress(OSError):
            self._input.close()
        self._errors.close()
        threading.Thread(target=self._process.wait, daemon=True).start()  # else it stays a zombie

    @property
    def _input(self) -> IO[bytes]:
        """The thread that it hangs on."""
        if self._process.stdin is None:  # pragma: no cover - it was asked for
            raise OSError("the process must have an input")
        return self._process.stdin


def compiled(program: Program) -> Entry:
    """Return a program's machine code: what is kept, or can be had now.

    Raises
    ------
    RuntimeError
        It cannot be compiled: it holds what Numba does not take, or no process can be started.
    """
    if (entry := ready_made.load(program)) is not None:
        return entry
    error = Compiling(program, in_background=False).wait()
    if (entry := library.load(program)) is None:
        raise RuntimeError(f"the program cannot be compiled here:\n{error}")
    return entry


def compiled_here(program: Program) -> Entry:
    """Return a program's machine code, compiled in this process where it is not kept.

    Of many programs each takes a second less than in :func:`compiled`: Numba is imported once.

    Raises
    ------
    numba.core.errors.NumbaError
        It holds what Numba does not compile.
    """
    if (entry := ready_made.load(program)) is None:
        from lesson_code.engine.compiled.machine_code import object_file

        library.keep(library.place_to_write(), program, linked(object_file(program)))
        entry = library.load(program)
        assert entry is not None  # noqa: S101 - it has just been kept
    return entry


def main() -> None:
    """Compile the program that stands at the input."""
    told = _read(int.from_bytes(_read(LENGTH)))
    place, program, niceness = pickle.loads(told)  # noqa: S301 - from our own process
    writing = threading.Lock()
    threading.Thread(target=_end_with_the_thread, args=(writing,), daemon=True).start()
    if hasattr(os, "nice"):
        os.nice(niceness)
    with library.claimed(place, program):
        if ready_made.load(program) is not None:
            return
        from lesson_code.engine.compiled.machine_code import object_file

        gc.disable()  # it ends soon, and a fifth of its time would go into looking for garbage
        made = object_file(program)
        with writing:
            library.keep(place, program, linked(made))


def _end_with_the_thread(writing: threading.Lock) -> None:
    """End this process when its input is cut: at once, or when the time to finish is over."""
    if _read(len(FINISH)) == FINISH:
        time.sleep(FINISH_SECONDS)
    with writing:
        os._exit(1)


def _read(size: int) -> bytes:
    """Return so many bytes of the input, or fewer if it is cut."""
    words = b""
    while len(words) < size and (more := os.read(sys.stdin.fileno(), size - len(words))):
        words += more
    return words
