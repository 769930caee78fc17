"""The code that a run is made in: plain Python, machine code, or first the one and then the other.

Seconds decide. Machine code that is kept is used where plain Python would take longer than loading
it: that of the run's own program, or else of one for any scene. The latter comes ready-made, and is
used where plain Python would take longer than making machine code of it. Where no other program
will do, a run that is long enough begins in plain Python while another process compiles its own,
and goes on in machine code when that is there. All give the same bits.
"""

from __future__ import annotations

import time
import timeit
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from lesson_code.engine.compiled.program import Program

if TYPE_CHECKING:  # what a small run does not need is imported where it is used
    from lesson_code.engine.compiled.compiler import Compiling
    from lesson_code.engine.compiled.loader import Entry

# All seconds are those of the machine on which the workbook was made; see `slowness`.

LOAD_SECONDS = 0.02
"""s, to find a source and its machine code, to load that and to turn the tables into arrays. It is
half as much, but where no source is kept, linking takes five times as long."""

READY_MADE_SECONDS = 8e-6
"""s, for each character of its source: a run must be as long for a program that came ready-made.
To link it and to make machine code of it takes two thirds of that, but many a run comes to rest
earlier than was reckoned."""

COMPILE_SECONDS = 1.5e-4
"""s, to compile a program, for each character of its source."""

PART = 0.5
"""Of that: a run must be as long for another process to begin, and one that has come as far when
the run ends may finish. So what has been begun is rarely given up."""

LOOK_SECONDS = 0.25
"""s of work, after which a run in plain Python has another look at what lies ahead; then after
twice as many, and so on, for it has to link its program. While that is compiled, it looks so often.
"""

REFERENCE_SECONDS = 2.5e-5
"""s, that the loop of `slowness` takes there."""


Make: TypeAlias = Callable[[], Program]
MakeOther: TypeAlias = Callable[[], Program | None]


def no_other() -> None:
    """Return no other program that would do."""


class Choice(NamedTuple):
    """What a run is made in, in words, and why."""

    code: str
    reason: str


PLAIN, COMPILED = "plain Python", "compiled"


class Code:
    """The choice of one run, which may change on the way.

    Parameters
    ----------
    asked : bool or None
        What the user has asked for; None lets the amount of work decide.
    never : str
        Why this run cannot be compiled, in words; "" when it can.

    Attributes
    ----------
    choice : Choice
        What it is now.

    Raises
    ------
    ValueError
        Machine code was asked for, and cannot be had.
    """

    def __init__(self, asked: bool | None, never: str = "") -> None:
        if asked and never:
            raise ValueError(f"compiled must be False or None here: {never}")
        self._asked, self._never = asked, never
        self._began = self._looked = time.process_time()
        self._pause = LOOK_SECONDS
        self._compiling: Compiling | None = None
        self.choice = Choice(PLAIN, "a small run" if asked is None else "asked for")

    def begin(
        self, program: Make, seconds: float, now: str = "", other: MakeOther = no_other
    ) -> Entry | None:
        """Return machine code for a program, or None if plain Python is to run it.

        It is called again where a run needs another program.

        Parameters
        ----------
        program : callable
            Returns the program; called only where the decision depends on it.
        seconds : float
            About how long plain Python would work on the machine of the constants above.
        now : str
            How far the run has come, in words; "" at its start.
        other : callable
            Returns a program that does the same and more, or None: it will do where machine code of
            the first one is not kept.
        """
        if self._asked is None:
            return self._by_work(program, seconds * slowness(), now, other)
        if not self._asked:
            return None
        from lesson_code.engine.compiled import compiler, library

        made = program()
        if (entry := library.load(made)) is None and (reason := library.why_no_compiler()):
            raise ValueError(f"compiled must be False or None here: {reason}")
        self.choice = Choice(COMPILED, "asked for")
        return entry or compiler.compiled(made)

    @property
    def may_change(self) -> bool:
        """Whether a run in plain Python is to be looked at on the way."""
        return self._asked is None and not self._never

    def look(
        self, program: Make, ahead: float, now: str, other: MakeOther = no_other
    ) -> Entry | None:
        """Return machine code to go on with, or None if plain Python is to go on.

        Parameters
        ----------
        program : callable
            Returns the program.
        ahead : float
            How much is left, over what is done.
        now : str
            How far the run has come, in words.
        other : callable
            As for :meth:`begin`.
        """
        time_now = time.process_time()  # what else the machine does changes nothing
        if not self.may_change or time_now < self._looked + self._pause:
            return None
        self._looked = time_now
        if self._compiling is None:
            self._pause *= 2
            return self._by_work(program, (time_now - self._began) * ahead, now, other)
        if not self._compiling.is_over():
            return None
        from lesson_code.engine.compiled import library

        entry = library.load(self._compiling.program)
        self.close()
        if entry is None:
            self._never = "its program could not be compiled"
            self.choice = Choice(PLAIN, self._never)
            return None
        return self._take(entry, now, "it was compiled meanwhile")

    def close(self) -> None:
        """End the run: a process that compiles for it ends too, unless it is nearly done."""
        if self._compiling is not None:
            is_far = self._compiling.seconds > PART * compile_seconds(self._compiling.program)
            self._compiling.leave(to_finish=is_far)
            self._compiling = None

    def _by_work(self, program: Make, seconds: float, now: str, other: MakeOther) -> Entry | None:
        """Return machine code if it is kept or ready-made and pays; let it be made if that pays."""
        if seconds < load_seconds():
            return None
        reason = self._never
        if not reason:
            from lesson_code.engine.compiled import library, ready_made

            before = time.process_time()
            own = program()
            if (entry := library.load(own)) is not None:
                return self._take(entry, now, "its machine code was kept")
            more = other() or own
            if (entry := library.load(more)) is not None:
                return self._take(entry, now, "machine code for any scene was kept")
            if seconds > worth_finishing(more) and (entry := ready_made.finished(more)):
                return self._take(entry, now, "a program for any scene came ready-made")
            reason = self._compile_if_long(own, seconds)
            self._began += time.process_time() - before  # the run has done nothing meanwhile
        self.choice = Choice(PLAIN, reason)
        return None

    def _compile_if_long(self, program: Program, seconds: float) -> str:
        """Let another process compile a program if that pays; return why it is not used yet."""
        from lesson_code.engine.compiled import compiler, library

        self.close()
        if reason := library.why_no_compiler():
            self._never = reason
        elif seconds < PART * compile_seconds(program):
            return "a run too small to wait for a compiler"
        else:
            self._pause = LOOK_SECONDS
            try:
                self._compiling = compiler.Compiling(program, in_background=True)
            except OSError:
                self._never = "no process can be started to compile it"
            else:
                return "its machine code is still being made"
        return self._never

    def _take(self, entry: Entry, now: str, reason: str) -> Entry:
        """Note that machine code is used, from now on."""
        if self.choice.code == PLAIN:
            code = f"{PLAIN}, compiled from {now} on" if now else COMPILED
            self.choice = Choice(code, reason)
        return entry


def load_seconds() -> float:
    """Return about how long it takes to find and to load machine code that is kept, s."""
    return slowness() * LOAD_SECONDS


def worth_finishing(program: Program) -> float:
    """Return for how long a run a program that came ready-made is worth its machine code, s."""
    return slowness() * READY_MADE_SECONDS * len(program.source)


def compile_seconds(program: Program) -> float:
    """Return about how long it takes to compile a program, s."""
    return slowness() * COMPILE_SECONDS * len(program.source)


@cache
def slowness() -> float:
    """Return how much slower plain Python is here than where the constants were measured.

    It takes a tenth of a millisecond, once a process.
    """
    return min(timeit.repeat(_reference_loop, number=1, repeat=5)) / REFERENCE_SECONDS


@dataclass(slots=True)
class _Row:
    x: float = 0.0
    vx: float = 1.0


def _reference_loop() -> None:
    """Do what the engine does most: read fields of rows, reckon, and write them."""
    rows = [_Row() for _ in range(10)]
    for _ in range(100):
        for row in rows:
            row.x = row.x + 0.1 * row.vx
