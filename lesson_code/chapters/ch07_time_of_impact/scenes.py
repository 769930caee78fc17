"""What can be measured in a gas of hard discs: its pressure, and its collisions.

Near a wall a gas is not as it is inside: a disc there is pushed from one side only, so that discs
gather at the walls. Pressure and collisions are therefore taken from the middle of the box.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.evidence.scenes.events import WALLS
from lesson_code.evidence.scenes.gas import DIAMETER, ENERGY

MARGIN = 3.5
"""m: so far from the walls begins the middle. Up to a covered share of 0.4 the discs there know
nothing of the walls, to a part in a hundred."""


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
        A run of a gas that has been sampled at even times.
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
