"""The parent's side of the wall: asks a child, and trusts only plain values.

What is expected never crosses the wall. No result, a result of another form, a crash or silence is
a :class:`CallOutcome` that says so, and earns nothing.
"""

from __future__ import annotations

import json
from itertools import count
from types import TracebackType
from typing import TYPE_CHECKING, Any

from lesson_code.course.grading.task import Arguments
from lesson_code.course.isolation.call_outcome import CallOutcome, call_outcome, one_line
from lesson_code.course.isolation.channel import Channel
from lesson_code.course.isolation.limits import Limits
from lesson_code.course.isolation.rungs import Children

if TYPE_CHECKING:
    from lesson_code.course.grading.submission import Unit


class StudentProcess:
    """A child process that holds one submission and answers calls to its functions.

    After a call that hangs or kills the child, the next call gets a new child.
    """

    def __init__(
        self, units: tuple[Unit, ...], children: Children, limits: Limits | None = None
    ) -> None:
        self._units = units
        self._children = children
        self._limits = limits or Limits()
        self._channel: Channel | None = None
        self._numbers = count(1)
        self._load_failed: CallOutcome | None = None
        self._is_loaded = False
        self._is_shortened = False
        self.load_errors: list[str] = []

    def __enter__(self) -> StudentProcess:
        self._start()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._end()

    def call(self, function: str, arguments: Arguments) -> CallOutcome:
        """Return what came of calling a function of the submission."""
        if self._channel is None and self._load_failed is None:
            self._start()
        if self._load_failed is not None:
            return self._load_failed
        request = {"call": function, "arguments": arguments}
        reply = self._ask(request, self._limits.seconds_a_call)
        return reply if isinstance(reply, CallOutcome) else call_outcome(reply)

    def _start(self) -> None:
        """Start a child and load the submission into it."""
        self._channel = self._children.start()
        reply = self._ask(
            {"load": [unit.as_request() for unit in self._units]}, self._limits.seconds_to_load
        )
        if isinstance(reply, CallOutcome) and reply.kind == "timeout" and not self._is_shortened:
            self._shorten()
            self._start()
        elif isinstance(reply, CallOutcome):
            self._load_failed = CallOutcome(reply.kind, text=f"{reply.text}, while it was loaded")
        elif not self._is_loaded:  # a second child could tell what the first was called with
            self._is_loaded = True
            errors = reply.get("loaded")
            lines = errors if isinstance(errors, list) else []
            self.load_errors += [one_line(line) for line in lines if isinstance(line, str)]

    def _shorten(self) -> None:
        """Keep only the units that stand before the statements that do not finish."""
        self._is_shortened = True
        self._channel = self._children.start()
        done: list[Unit] = []
        for part in [part for unit in self._units for part in unit.parts]:
            reply = self._ask({"load": [part.as_request()]}, self._limits.seconds_to_load)
            if isinstance(reply, CallOutcome):
                self._units = tuple(done)
                self.load_errors.append(
                    f"{part.name}: {reply.text}; it is left out, and so is all that follows"
                )
                return
            done.append(part)
        self._end()

    def _ask(self, request: dict[str, Any], seconds: float) -> dict[str, Any] | CallOutcome:
        """Return the child's reply, or what kept it from replying."""
        assert self._channel is not None  # noqa: S101 - _start has made it
        number = next(self._numbers)
        asked = json.dumps(request | {"number": number}).encode() + b"\n"
        line = self._channel.ask(asked, seconds)
        reply = None if line is None else _object_in(line)
        if reply is not None and reply.get("number") == number:
            return reply
        self._end()
        if line is None:
            return CallOutcome("timeout", text=f"it did not finish within {seconds:g} s")
        if reply is not None:
            return CallOutcome(
                "crashed", text="it wrote where only the grader's own lines may stand"
            )
        return CallOutcome("crashed", text="it ended the process, or used more than it may")

    def _end(self) -> None:
        """End the child and everything it has started."""
        if self._channel is not None:
            self._channel.close()
            self._channel = None
            self._children.end()


def _object_in(line: bytes) -> dict[str, Any] | None:
    """Return the JSON object in a line, which may hold anything, or None."""
    try:
        value = json.loads(line)
    except (ValueError, RecursionError, MemoryError):
        return None
    return value if isinstance(value, dict) else None
