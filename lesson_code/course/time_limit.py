"""Ends a call that takes too long, in the thread that made it: a student's loop may never end.

A thread of its own looks at the clock and makes the call raise. That works on Linux, macOS and
Windows alike, and costs a call two locks. What runs inside a function of C, such as a long
``time.sleep``, is ended only once it comes back to Python.
"""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable
from time import monotonic, sleep
from typing import Any

LOOK_SECONDS = 0.05
"""s: from one look at the clock to the next."""


class NoAnswerError(TimeoutError):
    """A call took longer than it may."""


class _OverTime(BaseException):
    """Raised inside a call; no ``except Exception`` of a student's stops it."""


class TimeLimit:
    """Bounds calls, one at a time.

    Parameters
    ----------
    seconds : float
        The time a call may take, s.

    Examples
    --------
    >>> TimeLimit(1.0).call(divmod, 7, 2)
    (3, 1)
    """

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._lock = threading.Lock()
        self._running: tuple[int, float] | None = None
        self._was_told = False
        self._watcher: threading.Thread | None = None

    def call(self, function: Callable[..., Any], *arguments: Any) -> Any:
        """Return what a function returns.

        Raises
        ------
        NoAnswerError
            It took longer than it may.
        """
        if self._watcher is None:
            self._watcher = threading.Thread(target=self._watch, daemon=True)
            self._watcher.start()
        try:
            self._running = threading.get_ident(), monotonic()
            try:
                return function(*arguments)
            finally:
                self._end()
        except _OverTime:
            self._end_for_certain()
        raise NoAnswerError(f"no answer within {self.seconds:g} s")

    def _end(self) -> None:
        """Note that the call is over; what it was told and has not heard, nobody will hear."""
        with self._lock:
            self._running = None
            if self._was_told:
                self._was_told = False
                _raise_in(threading.get_ident(), None)

    def _end_for_certain(self) -> None:
        """Note the same, even where the call is told once more meanwhile."""
        while True:
            try:
                return self._end()
            except _OverTime:
                continue

    def _watch(self) -> None:
        """Tell a call that takes too long to end; one that catches that is told again."""
        while True:
            sleep(LOOK_SECONDS)
            with self._lock:
                if self._running is not None:
                    thread, start = self._running
                    if monotonic() - start > self.seconds:
                        self._was_told = True
                        _raise_in(thread, _OverTime)


def _raise_in(thread: int, error: type[BaseException] | None) -> None:
    """Let a thread raise an error as soon as it runs Python; None takes that back."""
    wanted = None if error is None else ctypes.py_object(error)
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), wanted)
