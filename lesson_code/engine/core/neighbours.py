"""Which bodies of a scene have a neighbour at the start, found for all of them at once by NumPy.

The broad phase of the engine's steps visits one body after the other, as machine code or in plain
Python. Before a run there is one question only, and arrays answer it for 10,000 bodies in the time
in which plain Python would look at a few hundred.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.broad_phase import most_pairs
from lesson_code.engine.core.columns import Flags, Floats
from lesson_code.engine.core.constants import LAST_CELL
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import cell_size_for, outlined_bodies

Indices: TypeAlias = NDArray[np.int64]

LEFT, LOW, RIGHT, HIGH = range(4)
"""The sides of a box."""

CELLS_IN_ROW = 4 * int(LAST_CELL)
"""Cell numbers in a row of the grid: so many more than there are that the end of a row is no
neighbour of the next one's start."""


def has_neighbour(scene: Scene, margin: float) -> Flags:
    """Return whether each body's box overlaps another's, where one of the two can be pushed.

    The boxes of bodies that can be pushed have a margin of so many widths. Where there are too many
    pairs to look at, all bodies count as having a neighbour.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene
    >>> discs = [Body(Circle(1), mass=1.0, position=(x, 0)) for x in (0, 2, 5)]
    >>> has_neighbour(Scene(discs), margin=0.05).tolist()
    [True, True, False]
    """
    sides, is_free = sides_of(*outlined_bodies(scene), margin), scene.columns.is_free
    with np.errstate(over="ignore", invalid="ignore"):  # a box may reach to infinity
        pairs = _candidate_pairs(sides, cell_size_for(scene.columns))
    if pairs is None:
        return np.ones(len(is_free), dtype=bool)
    a, b = pairs
    meets = (a != b) & (is_free[a] | is_free[b])
    for lower, upper in ((LEFT, RIGHT), (LOW, HIGH)):
        meets &= (sides[lower, a] <= sides[upper, b]) & (sides[lower, b] <= sides[upper, a])
    found = np.zeros(len(is_free), dtype=bool)
    found[a[meets]] = found[b[meets]] = True
    return found


def sides_of(bodies: Any, corners: Any, margin: float = 0.0) -> Floats:
    """Return left, low, right and high of the boxes around all bodies, shape (4, N), m.

    The tables are arrays. Those of bodies that can be pushed have a margin of so many widths.
    """
    sides = np.zeros((4, len(bodies)))
    cornered = bodies["corner_count"] > 0
    first = bodies["first_corner"][cornered]
    if first.size:
        sides[LEFT, cornered] = np.minimum.reduceat(corners["x"], first)
        sides[LOW, cornered] = np.minimum.reduceat(corners["y"], first)
        sides[RIGHT, cornered] = np.maximum.reduceat(corners["x"], first)
        sides[HIGH, cornered] = np.maximum.reduceat(corners["y"], first)
    x, y, radius = bodies["x"], bodies["y"], bodies["radius"]
    is_free = bodies["inv_m"] > 0.0
    way = margin * np.where(is_free, bodies["min_width"], 0.0)
    sides[LEFT], sides[RIGHT] = x + sides[LEFT] - radius - way, x + sides[RIGHT] + radius + way
    sides[LOW], sides[HIGH] = y + sides[LOW] - radius - way, y + sides[HIGH] + radius + way
    return sides


def _candidate_pairs(sides: Floats, size: float) -> tuple[Indices, Indices] | None:
    """Return pairs of boxes among which are all that overlap; None: there are too many.

    A box is in the cell of its lower left corner. It can only overlap those in the eight cells
    around it; one that is larger than a cell is paired with every other.
    """
    count = sides.shape[1]
    is_large = (sides[RIGHT] - sides[LEFT] > size) | (sides[HIGH] - sides[LOW] > size)
    small, large = np.flatnonzero(~is_large), np.flatnonzero(is_large)
    column, row = np.clip(np.floor(sides[[LEFT, LOW]][:, small] / size), -LAST_CELL, LAST_CELL)
    cells = row.astype(np.int64) * CELLS_IN_ROW + column.astype(np.int64)
    order = np.argsort(cells, kind="stable")
    small, cells = small[order], cells[order]
    above = cells + CELLS_IN_ROW
    # The later ones in the same cell and the next; those in the three cells above.
    begins = np.concatenate([np.arange(len(small)) + 1, np.searchsorted(cells, above - 1)])
    ends = np.searchsorted(cells, np.concatenate([cells + 1, above + 1]), side="right")
    numbers = ends - begins
    total = int(numbers.sum())
    if total + len(large) * count > most_pairs(count):
        return None
    places = np.arange(total) + np.repeat(begins - np.cumsum(numbers) + numbers, numbers)
    a = np.concatenate([np.repeat(np.tile(small, 2), numbers), np.repeat(large, count)])
    b = np.concatenate([small[places], np.tile(np.arange(count), len(large))])
    return a, b
