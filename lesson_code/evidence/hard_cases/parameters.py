"""The parameters of one trial, drawn by a seed."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TypeAlias, TypeVar

import numpy as np

Value: TypeAlias = float | int | str
"""A drawn parameter."""

Source: TypeAlias = Callable[[], float]
"""Returns a number from 0 to 1 at each call."""

Option = TypeVar("Option", bound=Value)


def seeded(name: str, seed: int) -> Source:
    """Return the random numbers that belong to a family and a seed.

    Parameters
    ----------
    name : str
        The family's: families with one seed draw different numbers.
    seed : int
        >= 0.

    Raises
    ------
    ValueError
        The seed is negative.

    Examples
    --------
    >>> seeded("a", 1)() == seeded("a", 1)() != seeded("b", 1)()
    True
    """
    if seed < 0:
        raise ValueError(f"seed must be >= 0, got {seed}")
    return np.random.default_rng([seed, *name.encode()]).random


class Draw:
    """Draws parameters, and remembers their names and values.

    Each comes from one number of the source, so that anything that yields numbers from 0 to 1 can
    choose the parameters: a seeded generator, or a search for the draw that fails.

    Parameters
    ----------
    source : callable
        Returns a number from 0 to 1 at each call.

    Attributes
    ----------
    values : dict of str to value
        What has been drawn so far, by name.

    Examples
    --------
    >>> draw = Draw(lambda: 0.5)
    >>> draw.uniform("speed", 1.0, 2.0), draw.integer("count", 2, 4), draw.values
    (1.5, 3, {'speed': 1.5, 'count': 3})
    """

    def __init__(self, source: Source) -> None:
        self._source = source
        self.values: dict[str, Value] = {}

    def uniform(self, name: str, low: float, high: float) -> float:
        """Draw a number evenly from `low` to `high`."""
        share = self._share(name, low, high)
        return self._keep(name, min(max(low + share * (high - low), low), high))

    def log_uniform(self, name: str, low: float, high: float) -> float:
        """Draw a number whose logarithm is even from that of `low` to that of `high`, both > 0."""
        if not low > 0.0:
            raise ValueError(f"low must be > 0 for {name}, got {low}")
        share = self._share(name, low, high)
        power = math.log(low) + share * (math.log(high) - math.log(low))
        return self._keep(name, min(max(math.exp(power), low), high))

    def integer(self, name: str, low: int, high: int) -> int:
        """Draw a whole number from `low` to `high`, both included."""
        share = self._share(name, low, high)
        return self._keep(name, min(low + int(share * (high - low + 1)), high))

    def choice(self, name: str, options: Sequence[Option]) -> Option:
        """Draw one of some options."""
        share = self._share(name, 0, len(options) - 1)
        return self._keep(name, options[min(int(share * len(options)), len(options) - 1)])

    def _share(self, name: str, low: float, high: float) -> float:
        if name in self.values:
            raise ValueError(f"name must be drawn once, got {name!r} again")
        if not low <= high:
            raise ValueError(f"low must be <= high for {name}, got {low} and {high}")
        return self._source()

    def _keep(self, name: str, value: Option) -> Option:
        self.values[name] = value
        return value
