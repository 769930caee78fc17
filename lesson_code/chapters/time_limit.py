"""What a player writes may never end. Then it is interrupted, so that the game goes on.

A thread looks at the clock now and then, and raises an exception in the thread that waits. Only
what runs as Python is ended so: a call of a library that does not return keeps the program waiting.
"""

from __future__ import annotations

import ctypes
import threading
import time
from collections.abc import Callable
from functools import cache
from typing import Any

LOOK = 0.05
"""s, from one look at the clock to the next."""

AGAIN = 0.5
"""s of the processor, after which an interruption that a bare ``except`` has caught is repeated."""

NEVER = 1e300
"""s."""


class _Interruption(BaseException):
    """Is raised in a call that has had its time; what catches every Exception does not catch it."""


def call(seconds: float, function: Callable[..., Any], *arguments: Any) -> Any:
    """Return what a function gives.

    Raises
    ------
    TimeoutError
        It has taken more than so many seconds of the processor.
    """
    clock = _clock()
    clock.begin(seconds)
    try:
        try:
            answer = function(*arguments)
        except _Interruption:
            raise
        except BaseException:
            clock.end()
            raise
        clock.end()
        return answer
    except _Interruption:
        clock.forget()
        raise TimeoutError(f"has not ended within {seconds:g} s") from None


class _Clock(threading.Thread):
    """Interrupts the call that is under way when its time is up; one at a time."""

    def __init__(self) -> None:
        super().__init__(daemon=True)
        self._lock = threading.Lock()
        self._caller = ctypes.c_ulong(0)
        self._ends = NEVER
        self._has_raised = False

    def begin(self, seconds: float) -> None:
        """Give the thread that asks so much time, from now on."""
        with self._lock:
            self._caller = ctypes.c_ulong(threading.get_ident())
            self._ends = time.process_time() + seconds
            self._has_raised = False

    def end(self) -> None:
        """Let the call be. What has been raised at the last moment arrives in here.

        It cannot be taken back: CPython 3.11 then looks for it at every call, for ever.
        """
        self.forget()
        last = time.monotonic() + LOOK
        while self._has_raised and time.monotonic() < last:
            pass

    def forget(self) -> None:
        """Raise nothing from now on."""
        with self._lock:
            self._ends = NEVER

    def run(self) -> None:
        """Look at the clock for ever."""
        while True:
            time.sleep(LOOK)
            with self._lock:
                if time.process_time() > self._ends:
                    self._has_raised = True
                    self._ends = time.process_time() + AGAIN
                    ctypes.pythonapi.PyThreadState_SetAsyncExc(
                        self._caller, ctypes.py_object(_Interruption)
                    )


@cache
def _clock() -> _Clock:
    """Return the clock of this process."""
    clock = _Clock()
    clock.start()
    return clock
