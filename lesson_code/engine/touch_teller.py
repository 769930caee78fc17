"""Post-processing in a live world: tells callbacks of touches, from the impulses of a step.

The engine's own callbacks are called within a step, which machine code cannot do. These are called
after it, from what it has written down; so they hear the same in plain Python and in machine code.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.callbacks import Callbacks, Touch
from lesson_code.engine.core.mixing import RULES, UNSPECIFIED, Combination, combined
from lesson_code.engine.core.scene import Body

Pair: TypeAlias = tuple[int, int]
Rows: TypeAlias = list[list[float]]
"""The impulses of one pair, as :class:`LiveWorld.impulses` has them."""


class TouchTeller:
    """Follows which pairs touch, and calls callbacks in the order of the contacts.

    Parameters
    ----------
    callbacks : Callbacks
        What to call; `pre_solve` never is.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    """

    def __init__(self, callbacks: Callbacks, combine: Combination) -> None:
        self._call = callbacks
        self._combine = combine
        self._touching: dict[Pair, Rows] = {}

    def tell(self, time: float, impulses: NDArray[np.float64], bodies: Mapping[int, Body]) -> None:
        """Tell of one step: what has begun to touch, touches, and has parted."""
        if not self._call.wanted:
            return
        told = dict(bodies)  # a callback may take bodies away
        before, self._touching = self._touching, pairs_of(impulses, tuple(told))
        for pair, rows in self._touching.items():
            self._tell_pair(pair not in before, time, pair, rows, told)
        if self._call.separate is not None:
            for pair, rows in before.items():
                if pair not in self._touching and told.keys() >= set(pair):
                    self._call.separate(self._touch(time, pair, rows, told))

    def _tell_pair(
        self, begins: bool, time: float, pair: Pair, rows: Rows, bodies: Mapping[int, Body]
    ) -> None:
        """Tell of one pair that touches."""
        wants_begin = begins and self._call.begin is not None
        if not wants_begin and self._call.post_solve is None:
            return
        touch = self._touch(time, pair, rows, bodies)
        if begins and self._call.begin is not None:
            self._call.begin(touch)
        if self._call.post_solve is not None:
            self._call.post_solve(touch)

    def _touch(self, time: float, pair: Pair, rows: Rows, bodies: Mapping[int, Body]) -> Touch:
        """Return what a callback is told of one pair."""
        return Touch(
            time=time,
            body_a=pair[0],
            body_b=pair[1],
            normal=(rows[0][5], rows[0][6]),
            points=tuple((row[3], row[4]) for row in rows),
            penetration=max(row[9] for row in rows),
            restitution=_coefficient("restitution", self._combine.restitution, pair, bodies),
            friction=_coefficient("friction", self._combine.friction, pair, bodies),
            normal_impulse=sum(row[7] for row in rows),
            tangent_impulse=sum(row[8] for row in rows),
        )


def pairs_of(impulses: NDArray[np.float64], numbers: tuple[int, ...]) -> dict[Pair, Rows]:
    """Return the impulses of a step, pair by pair, in the order of the contacts.

    >>> rows = np.array([[0, 0, 1, 0, 0, 0, 1, 5.0, 0, 0]])
    >>> list(pairs_of(rows, (7, 9)))
    [(7, 9)]
    """
    pairs: dict[Pair, Rows] = {}
    for row in impulses.tolist():
        pairs.setdefault((numbers[int(row[1])], numbers[int(row[2])]), []).append(row)
    return pairs


def _coefficient(name: str, rule: str, pair: Pair, bodies: Mapping[int, Body]) -> float:
    """Return a pair's coefficient from those of its bodies."""
    a, b = (getattr(bodies[number].material, name) for number in pair)
    return combined(RULES[rule], UNSPECIFIED if a is None else a, UNSPECIFIED if b is None else b)
