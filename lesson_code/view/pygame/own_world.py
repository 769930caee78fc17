"""A world of a player's own: the engine has nothing to do, one function moves everything.

It is the workbook's or a player's with the same signature; a program turns time into steps and
what comes back into a picture.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.game import Game, numbers
from lesson_code.view.pygame.program import Readings

PARTS = 10
"""Of a step: a player's function makes this many at once; 600 in a second."""


class OwnWorld(Game):
    """A state that one function moves.

    Parameters
    ----------
    seed : int
        Nothing is drawn by lot here.
    move : callable
        Returns the state after a number of parts of a step; nothing moves while it is not written.
    """

    ours: Callable[..., Any]

    def __init__(self, seed: int = 0, move: Callable[..., Any] | None = None) -> None:
        self._move = self.ours if move is None else move
        super().__init__(seed)

    def reset(self) -> None:
        """Put the state back to its beginning."""
        self.time = 0.0
        self.state = self.start()

    def start(self) -> tuple[Any, Any]:
        """Return the state at the beginning."""
        raise NotImplementedError

    def step(self) -> None:
        """Let time pass."""
        first, second = self.moved(*self.state)
        self.state = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
        self.time += TIME_STEP

    def snapshot(self) -> NDArray[np.float64]:
        """Return both halves of the state."""
        return np.stack(self.state)

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        raise NotImplementedError

    def answered(self, first: Any, second: Any, *rest: Any) -> Any:
        """Return the state that the function makes of this one, or this one."""
        form = numbers(2, *np.shape(first))
        return self.ask(self._move, first, second, *rest, form=form, otherwise=(first, second))


def rate_readings(game: OwnWorld) -> Readings:
    """Return the time, and the largest angle and rate."""
    angles, rates = game.state
    return [
        ("time", f"{game.time:.1f} s"),
        ("largest angle", f"{math.degrees(abs(angles).max()):.1f} degrees"),
        ("largest rate", f"{abs(rates).max():.2f} rad/s"),
    ]
