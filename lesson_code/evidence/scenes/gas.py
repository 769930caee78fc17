"""A gas of hard discs in a box, and what can be measured in it: pressure, collisions.

Near a wall a gas is not as it is inside: a disc there is pushed from one side only, so that discs
gather at the walls. Pressure and collisions are therefore taken from the middle of the box.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.evidence.scenes.events import ELASTIC, WALLS, box
from lesson_code.formulas.validation import one_number, positive
from lesson_code.geometry.shapes import Circle

DIAMETER, MASS, ENERGY = 1.0, 1.0, 1.0
"""m, kg, J: of a disc; the energy is the mean one at the start, and so for ever."""

MARGIN = 3.5
"""m: so far from the walls begins the middle. Up to a covered share of 0.4 the discs there know
nothing of the walls, to a part in a hundred."""


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
    """Return a gas of any number of discs; where they fill no square, the last row is shorter.

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
    starts = zip([(x, y) for x in places for y in places][:count], v.tolist(), strict=True)
    shape = Circle(DIAMETER / 2)
    discs = [
        Body(shape, mass=MASS, position=place, velocity=way, material=ELASTIC)
        for place, way in starts
    ]
    return Scene([*box(length, length), *discs])


def hits_a_disc(run: Run) -> float:
    """Return how many other discs each disc has hit in a run, on average."""
    between_discs = int(np.count_nonzero(run.contacts.body_a >= WALLS))
    return 2 * between_discs / (len(run.scene.bodies) - WALLS)


@dataclass(frozen=True)
class Measured:
    """What was measured in the middle of the box.

    Attributes
    ----------
    covered : float
        Share of the middle that discs cover, on average.
    compressibility : float
        p A / (N T): how much more the discs press than points would.
    collision_rate : float
        Collisions of one disc in a second, 1/s.
    """

    covered: float
    compressibility: float
    collision_rate: float


def in_the_middle(run: Run, *, since: float = 0.0) -> Measured:
    """Return what is measured in the middle of a gas.

    p A = N T + 1/(2 t) sum of sigma J

    N is the mean number of discs in the middle, and the sum is over the collisions there: discs
    that meet hand the impulse J over a distance sigma at once. That is the part of the pressure
    which points do not have (Clausius' virial theorem).

    Parameters
    ----------
    run : Run
        A run of :func:`disc_gas` that has been sampled at even times.
    since : float
        s: what was before does not count, for the gas began in rows and columns.

    Raises
    ------
    ValueError
        The box has no middle.
    """
    length = max(y for _, y in run.scene.bodies[1].shape.outline)  # the wall at the top
    low, high = MARGIN * DIAMETER, length - MARGIN * DIAMETER
    if not low < high:
        raise ValueError(f"the box must be wider than {2 * MARGIN} diameters, got {length} m")
    places = run.positions[run.times >= since][:, WALLS:]
    number = float(np.mean(((places > low) & (places < high)).all(axis=2).sum(axis=1)))
    hits = run.contacts
    inside = ((hits.point > low) & (hits.point < high)).all(axis=1)
    counted = inside & (hits.body_a >= WALLS) & (hits.time >= since)
    seconds = float(run.times[-1]) - since
    virial = DIAMETER * float(hits.normal_impulse[counted].sum()) / (2 * seconds)
    return Measured(
        covered=number * math.pi * DIAMETER**2 / 4 / (high - low) ** 2,
        compressibility=1 + virial / (number * ENERGY),
        collision_rate=2 * float(np.count_nonzero(counted)) / seconds / number,
    )
