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

AGAIN_SECONDS = 0.2
"""s: then a call that has caught what it was told is told again."""


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
        """Return what a function returns; a call inside of a call counts as a part of that one.

        Raises
        ------
        NoAnswerError
            It took longer than it may.
        """
        if self._running is not None:
            return function(*arguments)
        if self._watcher is None:
            self._watcher = threading.Thread(target=self._watch, daemon=True)
            self._watcher.start()
        try:
            self._begin()
            try:
                answer = function(*arguments)
            except _OverTime:
                raise
            except BaseException:
                self._end()
                raise
            self._end()
            return answer
        except _OverTime:
            self._forget()
        raise NoAnswerError(f"no answer within {self.seconds:g} s")

    def _begin(self) -> None:
        """Note that a call begins."""
        with self._lock:
            self._running, self._was_told = (threading.get_ident(), monotonic()), False

    def _end(self) -> None:
        """Note that the call is over; what it is told at the last moment arrives in here.

        It cannot be taken back: CPython 3.11 then looks for it at every call, and a function that a
        profiler follows hangs.
        """
        self._forget()
        last = monotonic() + LOOK_SECONDS
        while self._was_told and monotonic() < last:
            pass

    def _forget(self) -> None:
        """Tell nobody anything from now on."""
        with self._lock:
            self._running = None

    def _watch(self) -> None:
        """Tell a call that takes too long to end; one that catches that is told again, later."""
        while True:
            sleep(LOOK_SECONDS)
            with self._lock:
                if self._running is not None:
                    thread, start = self._running
                    if monotonic() - start > self.seconds:
                        self._running = thread, monotonic() - self.seconds + AGAIN_SECONDS
                        self._was_told = True
                        ctypes.pythonapi.PyThreadState_SetAsyncExc(
                            ctypes.c_ulong(thread), ctypes.py_object(_OverTime)
                        )
