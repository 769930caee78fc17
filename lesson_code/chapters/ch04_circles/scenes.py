"""The scenes of chapter 04: a table full of balls, random pairs, a hit of three balls."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes.discs import CUSHIONS, LENGTH, WIDTH, cushions, pool_ball
from lesson_code.formulas.smooth_pair import smooth_impulse
from lesson_code.geometry import Circle
from lesson_code.simulation import simulate


def scattered_balls(restitution: float, *, speed: float = 2.0, seed: int = 4) -> Scene:
    """Return a table with 32 balls all over it, each moving its own way.

    The directions are drawn without sine or cosine, whose last digits differ from machine to
    machine: in a second of hits that would grow into another game.

    Parameters
    ----------
    restitution : float
        Of balls and cushions, 0 to 1.
    speed : float
        Of each ball, m/s.
    seed : int
        Draws the directions.

    Examples
    --------
    >>> len(scattered_balls(1.0).bodies)
    36
    """
    material = Material(restitution=restitution)
    ways = np.random.default_rng(seed).uniform(-1, 1, (32, 2)).tolist()
    places = [
        (x, y)
        for x in np.linspace(-0.42, 0.42, 8) * LENGTH
        for y in np.linspace(-0.36, 0.36, 4) * WIDTH
    ]
    balls = [
        pool_ball(place, _of_length(speed, x, y), material)
        for place, (x, y) in zip(places, ways, strict=True)
    ]
    return Scene([*cushions(material), *balls])


def balls_on_table(run: Run) -> Any:
    """Return how many of a table's balls have their centre between the cushions, shape (F,).

    Examples
    --------
    >>> from lesson_code import simulate
    >>> balls_on_table(simulate(scattered_balls(0.95), duration=0.0)).tolist()
    [32]
    """
    x, y = np.moveaxis(np.abs(run.positions[:, CUSHIONS:]), -1, 0)
    return ((x < LENGTH / 2) & (y < WIDTH / 2)).sum(axis=1)


@dataclass(frozen=True)
class Pairs:
    """Pairs of discs, each on its way to an overlap of a millimetre after one step.

    Attributes
    ----------
    masses, radii : ndarray, shape (2, N)
        Of the first and the second discs, kg and m.
    restitution : ndarray, shape (N,)
        Of each pair, 0 to 1.
    positions, velocities : ndarray, shape (2, N, 2)
        Before the step, m and m/s.
    """

    masses: NDArray[np.float64]
    radii: NDArray[np.float64]
    restitution: NDArray[np.float64]
    positions: NDArray[np.float64]
    velocities: NDArray[np.float64]

    dt = 1e-3
    """Length of the step, s."""

    def after_one_step(self, solver: str) -> Any:
        """Return the velocities that a solver finds in one step, shape (N, 2, 2)."""
        return np.array([self._after(pair, solver) for pair in range(len(self.restitution))])

    def _after(self, pair: int, solver: str) -> Any:
        material = Material(restitution=self.restitution[pair])
        bodies = [
            Body(
                Circle(self.radii[disc, pair]),
                mass=self.masses[disc, pair],
                position=self.positions[disc, pair],
                velocity=self.velocities[disc, pair],
                material=material,
            )
            for disc in (0, 1)
        ]
        run = simulate(Scene(bodies), self.dt, solver=solver, dt=self.dt, sample="end")
        return run.velocities[-1]

    def by_formula(self, *, moved: bool) -> Any:
        """Return the velocities after the impulse along the normal, shape (N, 2, 2).

        Parameters
        ----------
        moved : bool
            Whether the normal is that of the positions after the step, or before it.
        """
        (v1, v2), (m1, m2) = self.velocities, self.masses
        p1, p2 = self.positions + self.velocities * self.dt if moved else self.positions
        n = (p2 - p1) / np.hypot(*(p2 - p1).T)[:, np.newaxis]
        impulse = smooth_impulse(v1, m1, v2, m2, n, self.restitution)
        after = v1 - impulse / m1[:, np.newaxis], v2 + impulse / m2[:, np.newaxis]
        return np.stack(after, axis=1)


def random_pairs(count: int, seed: int) -> Pairs:
    """Return pairs of discs of 1 g to 1,000 kg and 0.1 to 10 m that move at up to 5 m/s each way.

    Examples
    --------
    >>> random_pairs(3, seed=4).masses.shape
    (2, 3)
    """
    rng = np.random.default_rng(seed)
    m, r = 10 ** rng.uniform(-3, 3, (2, count)), 10 ** rng.uniform(-1, 1, (2, count))
    v, e = rng.uniform(-5, 5, (2, count, 2)), rng.uniform(0, 1, count)
    way = rng.uniform(0, 2 * np.pi, count)
    moved = rng.uniform(-1, 1, (2, count, 2))
    moved[1] = moved[0] + ((r[0] + r[1] - 1e-3) * (np.cos(way), np.sin(way))).T
    return Pairs(m, r, e, moved - v * Pairs.dt, v)


def sideways_speeds(scene: Scene, solver: str, rounds: Iterable[int]) -> Any:
    """Return how fast the first body moves along y after one step, for each number of iterations.

    The step is so short that nothing moves in it.

    Parameters
    ----------
    scene : Scene
        Discs in touch that approach.
    solver : str
        The solver's name.
    rounds : iterable of int
        Numbers of iterations.

    Examples
    --------
    >>> from lesson_code.evidence.scenes.discs import cue_between_two
    >>> first, second = sideways_speeds(cue_between_two(upper_first=True), "sequential", [1, 2])
    >>> float(round(second / first, 6))  # cos(60 degrees) / 2, squared
    0.0625
    """
    runs = [simulate(scene, 1e-9, dt=1e-9, solver=solver, iterations=n) for n in rounds]
    return np.array([abs(run.velocities[-1, 0, 1]) for run in runs])


def _of_length(length: float, x: float, y: float) -> tuple[float, float]:
    """Return the vector of a length that points the way of (x, y)."""
    factor = length / math.sqrt(x * x + y * y)
    return factor * x, factor * y
