"""The parent's side of the wall: asks a child, and trusts only plain values.

What is expected never crosses the wall. No result, a result of another form, a crash or silence is
a :class:`CallOutcome` that says so, and earns nothing.
"""

from __future__ import annotations

import builtins
import json
import time
from collections import Counter, deque
from collections.abc import Callable, Mapping, Sequence
from itertools import count
from types import TracebackType
from typing import TYPE_CHECKING, Any, Protocol, TypeAlias

from lesson_code.course.grading.task import Arguments
from lesson_code.course.isolation.call_outcome import CallOutcome, call_outcome
from lesson_code.course.isolation.channel import Channel
from lesson_code.course.isolation.inside.answers import MOST_LOAD_ERRORS
from lesson_code.course.isolation.limits import PATIENCE, Limits
from lesson_code.course.isolation.rungs import Children

if TYPE_CHECKING:
    from lesson_code.course.grading.submission import Unit


LOOK = 0.05
"""Seconds. After a request that takes longer the child's processor time is asked for; one that
takes less is charged by the clock. It is also the shortest wait between two such questions."""

MOST_HANGS = 2
"""Calls of a function that may be cut off; after them it is called no more, so that it does not use
up the time of the submission's other functions."""

SECONDS_TOGETHER = 1.0
"""Of the processor, for all calls that are made in one go, before each is made by itself; those of
most chapters take some milliseconds."""

LARGEST_LOAN = 4_000
"""Bytes of a request for a value that is lent; arguments of a task's own calls have 800."""

ERRORS = frozenset(
    name
    for name, kind in vars(builtins).items()
    if isinstance(kind, type) and issubclass(kind, BaseException)
)
"""Python's own errors, by name."""


Request: TypeAlias = tuple[str, Arguments]
"""A call: a function, and its arguments."""


class Lender(Protocol):
    """Lends values of functions to a child, which never holds these functions."""

    @property
    def parameters(self) -> Mapping[str, Sequence[str]]:
        """The parameters of each function that is lent, by its name."""

    def reply(self, function: str, arguments: Any) -> dict[str, Any] | None:
        """Return the value of a call in the form of ``inside.answers``, or why there is none.

        None says that nothing more is lent.
        """


class StudentProcess:
    """A child process that holds one submission and answers calls to its functions.

    After a call that hangs or kills the child, the next call gets a new child. A call that is cut
    off is tried once more, in a child in which nothing else was called. Time is that of the
    processor; the clock ends only what sleeps, after `PATIENCE` times as long.
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
        self._is_used_up = False
        self._hangs: Counter[tuple[str, bool]] = Counter()
        self._used_before = 0.0  # s of the processor, by children that have ended
        self._used = 0.0  # and by the current one, as far as is known
        self._last = time.monotonic() + PATIENCE * self._limits.seconds_a_submission
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

    @property
    def was_cut_off(self) -> bool:
        """Whether it wanted more time than it may use: a busy machine may be the reason."""
        return self._is_shortened or self._is_used_up or any(self._hangs.values())

    def call(
        self, function: str, arguments: Arguments, lender: Lender | None = None
    ) -> CallOutcome:
        """Return what came of calling a function of the submission.

        With a lender, the values of some other functions come from there in place of the student's.
        """
        hangs = function, lender is not None
        if self._hangs[hangs] == MOST_HANGS:
            text = f"{function} was not called again: it did not finish in {MOST_HANGS} calls"
            return CallOutcome("not called", text=text)
        outcome = self._called(function, arguments, lender)
        if outcome.kind == "timeout" and not self._hangs[hangs]:
            outcome = self._called(function, arguments, lender)
        self._hangs[hangs] += outcome.kind == "timeout"
        return outcome

    def together(self, groups: Sequence[Sequence[Request]]) -> Callable[..., CallOutcome]:
        """Return a way to call the submission's functions for which some calls are made already.

        They are made in one go, and handed out to whoever calls in the same order. A group ends
        with the first call that neither returns nor raises. Where not all is answered, in
        `SECONDS_TOGETHER` and in the form agreed on, nothing of it counts, and each call is made by
        itself.

        Parameters
        ----------
        groups : sequence of sequences of (function, arguments)
            The calls.
        """
        made = deque(self._made_together(groups))

        def call(function: str, arguments: Arguments) -> CallOutcome:
            if made and made[0][0] == (function, arguments):
                return made.popleft()[1]
            made.clear()
            return self.call(function, arguments)

        return call

    def _made_together(
        self, groups: Sequence[Sequence[Request]]
    ) -> list[tuple[Request, CallOutcome]]:
        """Return calls that were made in one go, and what came of each; none if one failed."""
        if self._channel is None or self._load_failed is not None:
            return []
        seconds = min(SECONDS_TOGETHER, self._limits.seconds_a_call)
        reply = self._ask({"together": groups}, seconds)
        answers = None if isinstance(reply, CallOutcome) else reply.get("answers")
        match answers:
            case list() if len(answers) == len(groups) and all(map(_is_list_of_objects, answers)):
                return [
                    (request, call_outcome(answer))
                    for group, some in zip(groups, answers, strict=True)
                    for request, answer in zip(group, some, strict=False)
                ]
        if not isinstance(reply, CallOutcome):  # its own line: more may follow
            self._end()
        return []

    def _called(self, function: str, arguments: Arguments, lender: Lender | None) -> CallOutcome:
        """Return what came of one try of a call."""
        if self._channel is None and self._load_failed is None:
            self._start()
        if self._load_failed is not None:
            return self._load_failed
        request: dict[str, Any] = {"call": function, "arguments": arguments}
        if lender is not None:
            request["lent"] = {name: list(names) for name, names in lender.parameters.items()}
        reply = self._ask(request, self._limits.seconds_a_call, lender)
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
        elif isinstance(reply, CallOutcome) and reply.kind == "not called":
            self._load_failed = reply
        elif isinstance(reply, CallOutcome):
            self._load_failed = CallOutcome(reply.kind, text=f"{reply.text}, while it was loaded")
        elif not self._is_loaded:  # a second child could tell what the first was called with
            self._is_loaded = True
            errors = reply.get("loaded")
            told = errors[:MOST_LOAD_ERRORS] if isinstance(errors, list) else []
            self.load_errors += filter(None, map(self._load_error, told))

    def _load_error(self, told: Any) -> str | None:
        """Return in our own words what a child says went wrong: a known error, and its place.

        The words of the error itself may be anything that the code could read on its way.
        """
        match told:
            case [int() as place, int() as index, str() as kind] if 0 <= place < len(
                self._units
            ) and 0 <= index < len(self._units[place].lines):
                known = kind if kind in ERRORS else "an error of its own"
                return f"{known} ({self._units[place].place_of(index)})"
        return None

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

    def _ask(
        self, request: dict[str, Any], seconds: float, lender: Lender | None = None
    ) -> dict[str, Any] | CallOutcome:
        """Return the child's reply, or what kept it from replying."""
        assert self._channel is not None  # noqa: S101 - _start has made it
        number = next(self._numbers)
        asked = json.dumps(request | {"number": number}).encode() + b"\n"
        within, before = min(seconds, self._left()), self._used
        line = self._answered(self._channel, asked, within) if within > 0 else None
        reply = None if line is None else _object_in(line)
        while reply is not None and lender is not None and _borrows(reply, number, lender):
            is_short = len(line or b"") <= LARGEST_LOAN
            lent = lender.reply(reply["lend"], reply.get("arguments")) if is_short else None
            if lent is None:
                self._end()
                return CallOutcome("not called", text="it asked for too many values of ours")
            asked, left = json.dumps(lent).encode() + b"\n", self._left_of(within, before)
            line = self._answered(self._channel, asked, left) if left > 0 else None
            reply = None if line is None else _object_in(line)
        if reply is not None and reply.get("number") == number:
            return reply
        self._end()
        if line is None and within < seconds:
            self._is_used_up = True
            all_seconds = self._limits.seconds_a_submission
            text = f"the submission used up its {all_seconds} s of processor time"
            return CallOutcome("not called", text=text)
        if line is None:
            return CallOutcome("timeout", text=f"it did not finish within {seconds:g} s")
        if reply is not None:
            return CallOutcome(
                "crashed", text="it wrote where only the grader's own lines may stand"
            )
        return CallOutcome("crashed", text="it ended the process, or used more than it may")

    def _answered(self, channel: Channel, asked: bytes, seconds: float) -> bytes | None:
        """Return the child's next line; None once it has computed, or slept, for too long."""
        began, before = time.monotonic(), self._used
        last = min(began + PATIENCE * seconds, self._last)
        line = channel.ask(asked, seconds)
        while line is None:
            now = time.monotonic()
            left = seconds - (self._spent(before + now - began) - before)
            if left <= 0 or now >= last:
                break
            line = channel.ask(b"", min(max(left, LOOK), last - now))
        took = time.monotonic() - began
        self._used = before + took if took < LOOK else self._spent(before + took)
        return line

    def _spent(self, otherwise: float) -> float:
        """Return the child's processor time, s; where nobody can tell, something else."""
        spent = self._children.spent()
        return otherwise if spent is None else spent

    def _left_of(self, seconds: float, before: float) -> float:
        """Return what is left of some processor time that began when so much was used, s."""
        if self._used - before >= seconds:  # many short requests, charged by the clock
            self._used = self._spent(self._used)
        return seconds - (self._used - before)

    def _left(self) -> float:
        """Return the processor time that the submission has left, s."""
        most = self._limits.seconds_a_submission - self._used_before
        if self._used >= most:  # short requests were charged by the clock, which counts too much
            self._used = self._spent(self._used)
        return most - self._used

    def _end(self) -> None:
        """End the child and everything it has started."""
        if self._channel is not None:
            self._used_before += self._used
            self._used = 0.0
            self._channel.close()
            self._channel = None
            self._children.end()


def _borrows(reply: dict[str, Any], number: int, lender: Lender) -> bool:
    """Return whether a reply asks for a value that is lent."""
    name = reply.get("lend")
    return reply.get("number") == number and isinstance(name, str) and name in lender.parameters


def _is_list_of_objects(value: Any) -> bool:
    """Return whether a value is a list of JSON objects."""
    return isinstance(value, list) and all(isinstance(item, dict) for item in value)


def _object_in(line: bytes) -> dict[str, Any] | None:
    """Return the JSON object in a line, which may hold anything, or None."""
    try:
        value = json.loads(line)
    except (ValueError, RecursionError, MemoryError):
        return None
    return value if isinstance(value, dict) else None
