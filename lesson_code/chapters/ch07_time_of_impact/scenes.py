"""What chapter 07 looks at: impacts of pairs, three balls and a post, and the middle of a gas.

Near a wall a gas is not as it is inside: a disc there is pushed from one side only, so that discs
gather at the walls. Pressure and collisions are therefore taken from the middle of the box.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from time import perf_counter

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes.events import WALLS, box, turning_rod
from lesson_code.evidence.scenes.gas import DIAMETER, ENERGY, disc_gas
from lesson_code.geometry import Circle
from lesson_code.simulation import simulate

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


def share_passed_over(turning: float, solver: str, phases: int = 40) -> float:
    """Return which part of the starts lets a rod that turns, rad/s, pass over a ball at rest."""
    missed = 0
    for phase in (np.arange(phases) + 0.5) / phases:
        scene = turning_rod(turning, phase=phase, dt=1 / 60)
        run = simulate(scene, 0.6 / turning + 2 / 60, solver=solver, sample="end")
        missed += not run.velocities[-1, 1].any()
    return missed / phases


def three_balls_and_a_post() -> Scene:
    """Return three smooth, elastic balls in a box with a round post; the post is body 4."""
    smooth = Material(restitution=1.0)
    post = Body(Circle(0.4), position=(2, 1.5), material=smooth)
    balls = [((0.8, 0.7), (1.5, 0.9)), ((3.2, 0.8), (-0.4, 1.9)), ((0.9, 2.3), (1.1, -0.3))]
    movers = [
        Body(Circle(0.3), mass=1.0, position=place, velocity=way, material=smooth)
        for place, way in balls
    ]
    return Scene([*box(4.0, 3.0), post, *movers])


def microseconds_a_collision(side: int, duration: float) -> tuple[float, int]:
    """Return how long the exact solver takes for a collision in a gas, us, and their number."""
    gas = disc_gas(side, covered=0.3, seed=1)
    begin = perf_counter()
    run = simulate(gas, duration, solver="exact", sample="end")
    collisions = len(run.contacts)
    return 1e6 * (perf_counter() - begin) / collisions, collisions
