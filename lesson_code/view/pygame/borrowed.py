"""A player's own rules in a program; the workbook lends those not written yet."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np


def lent(theirs: Callable[..., Any], ours: Callable[..., Any]) -> Callable[..., Any]:
    """Return a player's function, or ours while theirs is not written.

    As in a check, it is given vectors as NumPy arrays of its own.

    >>> def stub(x):
    ...     raise NotImplementedError
    >>> lent(stub, abs)(-1)
    1
    """
    if theirs is ours:
        return ours

    def either(*arguments: Any) -> Any:
        try:
            return theirs(*(_own(argument) for argument in arguments))
        except NotImplementedError:
            return ours(*arguments)

    return either


def _own(argument: Any) -> Any:
    """Return a vector as an array that belongs to nobody else, and a number as it is."""
    is_vector = isinstance(argument, list | tuple | np.ndarray)
    return np.array(argument, dtype=float) if is_vector else argument
