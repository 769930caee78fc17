"""The ledger of a game: momentum and energy after each step, and what became of them."""

from __future__ import annotations

import csv
from collections import deque
from pathlib import Path
from typing import NamedTuple

import numpy as np

from lesson_code.view.pygame.game import Game

MOST_ROWS = 216_000
"""Steps that are kept: an hour."""


class Row(NamedTuple):
    """What there is after a step.

    Attributes
    ----------
    time : float
        s.
    px, py : float
        kg m/s, momentum.
    angular : float
        kg m^2/s, angular momentum about the origin.
    moving, turning, height, other : float
        J: kinetic energy of motion and of rotation, energy of height and, where a game has
        springs, in those.
    given, lost : float
        J since the start: put in from outside between steps, and lost in steps; below 0 where
        more was gained.
    """

    time: float
    px: float
    py: float
    angular: float
    moving: float
    turning: float
    height: float
    other: float
    given: float
    lost: float

    @property
    def energy(self) -> float:
        """All of it, J."""
        return self.moving + self.turning + self.height + self.other


UNITS = ("s", "kg m/s", "kg m/s", "kg m^2/s", "J", "J", "J", "J", "J", "J")
"""Of the columns."""


class Ledger:
    """Rows, one a step.

    Parameters
    ----------
    game : Game
        Whose steps are noted.
    ground : float
        m: the height where the energy of height is 0.
    """

    def __init__(self, game: Game, ground: float = 0.0) -> None:
        self._game, self._ground = game, ground
        self.rows = deque([self._row(0.0, 0.0, 0.0)], maxlen=MOST_ROWS)

    @property
    def last(self) -> Row:
        """What there is now."""
        return self.rows[-1]

    def before_step(self) -> None:
        """Note what was put in or taken out from outside since the last step."""
        last = self.last
        now = self._row(last.time, last.given, last.lost)
        self.rows[-1] = now._replace(given=last.given + now.energy - last.energy)

    def after_step(self, dt: float) -> None:
        """Note a step."""
        last = self.last
        now = self._row(last.time + dt, last.given, last.lost)
        self.rows.append(now._replace(lost=last.lost + last.energy - now.energy))

    def forget(self, steps: int) -> None:
        """Go back by some steps."""
        for _ in range(min(steps, len(self.rows) - 1)):
            self.rows.pop()

    def write(self, path: str | Path) -> None:
        """Write all rows to a .csv file; its first line names quantities and units."""
        with Path(path).open("w", encoding="utf-8", newline="") as file:
            table = csv.writer(file)
            table.writerow(f"{name}, {unit}" for name, unit in zip(Row._fields, UNITS, strict=True))
            table.writerows(self.rows)

    @np.errstate(over="ignore", invalid="ignore")  # a student's ball may be anywhere
    def _row(self, time: float, given: float, lost: float) -> Row:
        """Return what there is now."""
        matter, gravity = self._game.matter(), self._game.gravity
        turning = matter.kinetic_energy - matter.motion
        height = -float(matter.mass @ ((matter.places - (0.0, self._ground)) @ gravity))
        energies = matter.motion, turning, height, self._game.stored_energy()
        return Row(time, *matter.momentum, matter.angular_momentum, *energies, given, lost)
