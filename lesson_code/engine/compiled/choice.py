"""Whether a run is worth compiling: its work in plain Python against the time of a compiler."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from lesson_code.engine.compiled.library import is_kept, why_no_compiler

WORTH_LOADING = 2.0
"""s of work in plain Python above which it pays to load a stored program, which takes half a
second. With less work the gain would go unnoticed."""

WORTH_COMPILING = 30.0
"""s of work in plain Python above which it pays to compile a program, which takes about 10 s."""


class Choice(NamedTuple):
    """Whether a run is compiled, and why."""

    compiled: bool
    reason: str

    @property
    def code(self) -> str:
        """What runs, in words."""
        return "compiled" if self.compiled else "plain Python"


def choose(
    asked: bool | None, seconds: float, program: Callable[[], str], never: str = ""
) -> Choice:
    """Return whether to compile a program.

    Parameters
    ----------
    asked : bool or None
        What the user has asked for; None lets the amount of work decide.
    seconds : float
        About how long plain Python would work.
    program : callable
        Returns the source; called only where the decision depends on it.
    never : str
        Why this run cannot be compiled, in words; "" when it can.

    Raises
    ------
    ValueError
        It was asked for, and cannot be done.

    Examples
    --------
    >>> choose(None, 0.1, lambda: "")
    Choice(compiled=False, reason='a small run')
    """
    if asked is None:
        return _by_work(seconds, program, never)
    if asked and (reason := never or why_no_compiler()):
        raise ValueError(f"compiled must be False or None here: {reason}")
    return Choice(asked, "asked for")


def _by_work(seconds: float, program: Callable[[], str], never: str) -> Choice:
    """Return the choice that the work suggests."""
    if seconds < WORTH_LOADING:
        return Choice(False, "a small run")
    if reason := never or why_no_compiler():
        return Choice(False, reason)
    if seconds >= WORTH_COMPILING or is_kept(program()):
        return Choice(True, "a large run")
    return Choice(False, "a run too small to wait for a compiler")
