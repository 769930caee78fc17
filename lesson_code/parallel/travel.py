"""How functions, tasks and results travel between processes: as bytes, by pickle.

Functions and classes travel by name. So another process must be able to import them, which it
cannot where they stand in a notebook's cell or in the script that is running.
"""

from __future__ import annotations

import functools
import io
import pickle
import traceback
from collections.abc import Callable
from types import FunctionType
from typing import Any

from lesson_code.parallel.outcome import Outcome

CANNOT_TRAVEL = (pickle.PicklingError, AttributeError, TypeError)
"""What pickle raises for what it cannot write, depending on the kind of thing."""


def pack(what: str, thing: Any) -> bytes:
    """Return a thing as bytes, or refuse what another process could not make of them again.

    Parameters
    ----------
    what : str
        What the thing is called in the error.
    thing : object
        Anything that can be pickled.

    Raises
    ------
    TypeError
        It cannot be pickled, or stands in ``__main__``.

    Examples
    --------
    >>> unpack(pack("pair", (1, 0.5)))
    (1, 0.5)
    """
    into = io.BytesIO()
    try:
        _Pickler(into, protocol=pickle.HIGHEST_PROTOCOL).dump(thing)
    except CANNOT_TRAVEL as error:
        raise TypeError(
            f"{what} cannot travel to another process: {error}. Put functions and classes into a "
            "module of their own and import them, or give workers=1"
        ) from None
    return into.getvalue()


def unpack(packed: bytes) -> Any:
    """Return what was packed, by this program in another process."""
    return pickle.loads(packed)  # noqa: S301 - our own bytes, through our own pipe


def perform(function: Callable[[Any], Any], task: Any) -> tuple[Any, Exception | None]:
    """Return what a function made of a task, and the error that it raised, if any."""
    try:
        return function(task), None
    except SystemExit as left:
        return None, RuntimeError(f"it called sys.exit({left.code!r})")
    except Exception as error:
        return None, error


def perform_packed(function: bytes, task: bytes) -> bytes:
    """Return, packed, what a packed function made of a packed task, and the error."""
    try:
        result, error = perform(_function(function), unpack(task))
        if error is None:
            return pack("the result", (result, None))
    except Exception as failure:
        error = failure
    return pack("the error", (None, _able_to_travel(error)))


def outcome_of(index: int, name: str, reply: bytes) -> Outcome:
    """Return what became of a task, from what :func:`perform_packed` has said of it."""
    result, error = unpack(reply)
    return Outcome(index, name, result) if error is None else Outcome.failed(index, name, error)


@functools.lru_cache(maxsize=1)
def _function(packed: bytes) -> Callable[[Any], Any]:
    """Return a function; the one that a worker does all its tasks with is unpacked once."""
    function: Callable[[Any], Any] = unpack(packed)
    return function


def _able_to_travel(error: Exception) -> Exception:
    """Return an error that arrives as it was sent, with its traceback as a note."""
    told = "".join(traceback.format_exception(error)).rstrip()
    try:
        unpack(pack("the error", error))
    except Exception:  # an error may be built in any way
        error = RuntimeError(f"{type(error).__name__}: {error}")
    error.add_note(f"In the worker:\n{told}")
    return error


class _Pickler(pickle.Pickler):
    """A pickler that refuses what stands in the running script: workers do not run it again."""

    def reducer_override(self, thing: Any) -> Any:
        """Refuse a function or class of ``__main__``; leave the rest to pickle."""
        if isinstance(thing, FunctionType | type) and thing.__module__ == "__main__":
            raise TypeError(f"{thing.__qualname__} stands in __main__, which no worker imports")
        return NotImplemented
