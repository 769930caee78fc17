"""A gas of hard discs in a box."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.scenes.events import ELASTIC, WALLS, box
from lesson_code.formulas.validation import one_number, positive

DIAMETER, MASS, ENERGY = 1.0, 1.0, 1.0
"""m, kg, J: of a disc; the energy is the mean one at the start, and so for ever."""


def disc_gas(side: int, covered: float, *, seed: int) -> Scene:
    """Return equal discs in a square box, in rows and columns at the start, with random velocities.

    The momentum of all is zero. The velocities are drawn without sine or cosine, whose last
    digits differ from machine to machine.

    Parameters
    ----------
    side : int
        Discs in a row, and rows, >= 2.
    covered : float
        Share of the box that discs cover, > 0 and < pi/4.
    seed : int
        Draws the velocities.

    Raises
    ------
    ValueError
        So many rows cannot cover that share.

    Examples
    --------
    >>> gas = disc_gas(8, covered=0.3, seed=1)
    >>> len(gas.bodies) - WALLS
    64
    """
    return gas_of(side * side, covered, seed=seed)


def gas_of(count: int, covered: float, *, seed: int) -> Scene:
    """Return a gas of any number of discs; the last row may be shorter.

    Parameters
    ----------
    count : int
        Discs, >= 2.
    covered : float
        Share of the box that discs cover, > 0, and so small that rows and columns fit.
    seed : int
        Draws the velocities.

    Raises
    ------
    ValueError
        So many rows cannot cover that share.

    Examples
    --------
    >>> len(gas_of(10, covered=0.3, seed=1).bodies) - WALLS
    10
    """
    share = one_number("covered", covered, positive)
    length = math.sqrt(count) * DIAMETER * math.sqrt(math.pi / 4 / share)
    side = math.ceil(math.sqrt(count))
    if not (count >= 2 and length > side * DIAMETER):
        raise ValueError(
            f"covered must be so small that rows of {side} fit, and the discs at least 2, "
            f"got {covered} and {count}"
        )
    places = ((np.arange(side) + 0.5) * (length / side)).tolist()
    v = np.random.default_rng(seed).uniform(-1, 1, (count, 2))
    v -= v.mean(axis=0)
    v *= math.sqrt(2 * ENERGY / MASS * len(v) / (v * v).sum())
    return Scene.of_discs(
        [(x, y) for x in places for y in places][:count],
        v,
        radius=DIAMETER / 2,
        mass=MASS,
        material=ELASTIC,
        obstacles=box(length, length),
    )


def hits_a_disc(run: Run) -> float:
    """Return how many other discs each disc has hit in a run, on average."""
    between_discs = int(np.count_nonzero(run.contacts.body_a >= WALLS))
    return 2 * between_discs / (len(run.scene.bodies) - WALLS)
