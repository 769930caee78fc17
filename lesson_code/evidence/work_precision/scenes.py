"""The scenes in which accuracy is measured: each has an answer that no solver under test has given.

==================  ==========================================================================
scene               where its answer comes from
==================  ==========================================================================
ball in a box       mirror images, worked out in fractions
drop                the flights of a bouncing ball, a geometric series
slide to roll       constant friction, then rolling
pi blocks           a point reflected in a wedge
gas                 the exact solver; and for that one, the way back to the start
stack of 20         nothing moves
heavy on light      nothing moves
==================  ==========================================================================

The first five are swept over the length of the step: there an error has an order. The last two are
swept over how a number of sweeps is split into sub-steps and iterations.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np

from lesson_code.engine.core.constants import FINE_SLOP
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes.gas import DIAMETER, disc_gas
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, sliding_disc
from lesson_code.evidence.scenes.speed import stack
from lesson_code.reference.closed_forms import bouncing_ball
from lesson_code.reference.event_closed_forms import blocks_at
from lesson_code.reference.rigid_body_closed_forms import rolling_begins
from lesson_code.simulation import simulate

BOUNCE, DROP_HEIGHT = 0.8, 1.0
"""Restitution, and m: of the ball that is dropped."""

SLIDING, ROUGHNESS = 3.0, 0.2
"""m/s at the start, and friction coefficient: the disc slides for half a second."""

MASS_RATIO = 100.0
"""Of the pi blocks: 31 collisions."""

GAS_SIDE, GAS_COVERED, GAS_SEED = 5, 0.3, 1
"""25 discs in a box; the share that they cover; what draws their velocities."""

STACKED = 20
"""Boxes in the stack: pymunk's default of 10 sweeps lets it fall, 100 hold it."""

LOAD = 1000.0
"""kg, on a box of 1 kg."""

SIZE = 1.0
"""m: the side of a box, in the stack and under the load."""


@dataclass(frozen=True)
class PrecisionScene:
    """A scene with a known answer.

    Attributes
    ----------
    name : str
        What it is called in results, on the command line and in figures.
    scene : Scene
        The bodies.
    duration : float
        s.
    times : tuple of float
        When the error is looked at, s; the last is the end.
    error : callable
        Takes a run with states at those times; returns its error, >= 0.
    norm : str
        What that error is, with its unit.
    swept : "dt" or "sweeps"
        What the settings of a line differ in.
    worthless : float
        An error of this size or more means that there is no answer.
    failure : str
        The kind of failure in that case, in a word or two.
    own_slop : bool
        Whether pymunk keeps its own slop of 0.1 m, which suits it where bodies bounce. Where they
        rest it is given ours: with its own, bodies of 1 m sink in by a tenth.
    """

    name: str
    scene: Scene
    duration: float
    times: tuple[float, ...]
    error: Callable[[Run], float]
    norm: str
    swept: Literal["dt", "sweeps"]
    worthless: float
    failure: str
    own_slop: bool = True


def tenths(duration: float) -> tuple[float, ...]:
    """Return the times at which an error is looked at: every tenth of a second.

    >>> tenths(0.3)
    (0.1, 0.2, 0.3)
    """
    return tuple(n / 10 for n in range(1, round(10 * duration) + 1))


def ball_in_box() -> PrecisionScene:
    """Return a ball that bounces ten times in a box, for 10 s."""
    return PrecisionScene(
        "ball in a box",
        exact_scenes.ball_in_a_box(),
        10.0,
        tenths(10.0),
        lambda run: float(exact_scenes.error_in_the_box(run).max()),
        "largest distance from where it should be, m",
        "dt",
        worthless=1.5,
        failure="lost",
    )


def drop() -> PrecisionScene:
    """Return a ball that falls from 1 m and bounces for 2 s, each time with 0.8 of its speed.

    The floor leaves the restitution to the ball: so pymunk's product can be 0.8 to the last bit.
    """
    given = exact_scenes.bouncing_to_rest(BOUNCE, DROP_HEIGHT)
    floor, ball = given.bodies
    return PrecisionScene(
        "drop",
        Scene([replace(floor, material=Material()), ball], gravity=given.gravity),
        2.0,
        tenths(2.0),
        _error_of_height,
        "largest error of the height, m",
        "dt",
        worthless=DROP_HEIGHT,
        failure="lost",
    )


def slide_to_roll() -> PrecisionScene:
    """Return a disc that slides on a rough floor until it rolls, for 1 s."""
    return PrecisionScene(
        "slide to roll",
        sliding_disc(SLIDING, ROUGHNESS),
        1.0,
        tenths(1.0),
        _error_of_way,
        "largest error along the floor, m",
        "dt",
        worthless=SIZE,
        failure="lost",
        own_slop=False,
    )


def pi_blocks() -> PrecisionScene:
    """Return two blocks, 1 : 100, that collide with each other and a wall 31 times."""
    return PrecisionScene(
        "pi blocks",
        exact_scenes.two_blocks(MASS_RATIO),
        5.0,
        tenths(5.0),
        _error_of_blocks,
        "largest distance of a block from where it should be, m",
        "dt",
        worthless=1.0,
        failure="lost",
    )


def gas() -> PrecisionScene:
    """Return a gas of 25 discs for 1 s: too short for chaos."""
    return PrecisionScene(
        "gas",
        disc_gas(GAS_SIDE, GAS_COVERED, seed=GAS_SEED),
        1.0,
        tenths(1.0),
        _error_of_gas,
        "farthest disc from where it should be, m",
        "dt",
        worthless=DIAMETER,
        failure="lost",
    )


def stack_of_20() -> PrecisionScene:
    """Return twenty boxes on each other, which should stand still for 5 s."""
    return PrecisionScene(
        "stack of 20",
        pressed(stack(STACKED).scene),
        5.0,
        tenths(5.0),
        _farthest_from_start,
        "largest distance of a box from its place, m",
        "sweeps",
        worthless=SIZE / 2,
        failure="fell",
        own_slop=False,
    )


def heavy_on_light() -> PrecisionScene:
    """Return a box of 1,000 kg on one of 1 kg, which should stand still for 5 s."""
    ground, below, above = stack(2).scene.bodies
    heavy = Body(above.shape, mass=LOAD, position=above.position, material=above.material)
    return PrecisionScene(
        "heavy on light",
        pressed(Scene([ground, below, heavy], gravity=(0, -GRAVITY))),
        5.0,
        tenths(5.0),
        _farthest_from_start,
        "largest distance of a box from its place, m",
        "sweeps",
        worthless=SIZE / 2,
        failure="fell",
        own_slop=False,
    )


def pressed(scene: Scene) -> Scene:
    """Return a pile whose bodies overlap so little that no solver corrects it.

    Bodies that only touch have no contact yet: each would fall until it overlaps the one below, the
    topmost for as many steps as there are bodies. The measurement would show that fall instead of
    the solver.
    """
    ground, *bodies = scene.bodies
    lowered = [
        replace(body, position=(body.position[0], body.position[1] - n * FINE_SLOP * SIZE))
        for n, body in enumerate(bodies, start=1)
    ]
    return Scene([ground, *lowered], gravity=scene.gravity)


@functools.cache
def scenes() -> dict[str, PrecisionScene]:
    """Return all scenes by their names."""
    made = (
        ball_in_box(),
        drop(),
        slide_to_roll(),
        gas(),
        pi_blocks(),
        stack_of_20(),
        heavy_on_light(),
    )
    return {scene.name: scene for scene in made}


# Errors


def _error_of_height(run: Run) -> float:
    """Return the largest error of a bouncing ball's height above the floor, m."""
    there = bouncing_ball(run.times, DROP_HEIGHT, BOUNCE, exact_scenes.GRAVITY)
    return float(np.abs(run.positions[:, 1, 1] - 0.5 - there).max())


def _error_of_way(run: Run) -> float:
    """Return the largest error of the way that the sliding disc has made along the floor, m."""
    rolling = rolling_begins(SLIDING, 0.0, 1.0, 0.5, ROUGHNESS, GRAVITY)
    sliding = np.minimum(run.times, rolling.time)
    there = SLIDING * sliding - ROUGHNESS * GRAVITY / 2 * sliding**2
    there += rolling.velocity * (run.times - sliding)
    return float(np.abs(run.positions[:, 1, 0] - there).max())


def _error_of_blocks(run: Run) -> float:
    """Return how far the farther of two blocks is from where it should be, m."""
    gaps = np.array([1, 3]) * exact_scenes.BLOCK_RADIUS  # from a centre to the wall, all pressed
    first, second = (
        run.scene.bodies[n].position[0] - gap for n, gap in zip((1, 2), gaps, strict=True)
    )
    there = [blocks_at(time, MASS_RATIO, first, second) for time in run.times.tolist()]
    return float(np.abs(run.positions[:, 1:, 0] - gaps - there).max())


def _error_of_gas(run: Run) -> float:
    """Return how far the farthest disc is from where it should be, m."""
    if run.plan.solver == "exact":
        return _error_of_return(run)
    return float(np.hypot(*np.moveaxis(run.positions - _places_of_gas(), -1, 0)).max())


def _error_of_return(run: Run) -> float:
    """Return how far from its start a disc is after an exact run and its way back, m."""
    duration = float(run.times[-1])
    back = simulate(exact_scenes.turned_back(run), duration, solver="exact", sample="end")
    start = [body.position for body in run.scene.bodies]
    return float(np.hypot(*(back.positions[-1] - start).T).max())


@functools.cache
def _places_of_gas() -> Any:
    """Return where the discs of the gas are when their error is looked at, by the exact solver."""
    given = gas()
    return simulate(given.scene, given.duration, solver="exact", sample=given.times).positions


def _farthest_from_start(run: Run) -> float:
    """Return the largest distance of a body from its start at any time, m."""
    start = [body.position for body in run.scene.bodies]
    return float(np.hypot(*np.moveaxis(run.positions - np.array(start), -1, 0)).max())
