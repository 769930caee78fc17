"""A pool table full of balls that all move, and how many of them stay on it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Material, Scene
from lesson_code.evidence.scenes.discs import CUSHIONS, LENGTH, WIDTH, cushions, pool_ball


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


def _of_length(length: float, x: float, y: float) -> tuple[float, float]:
    """Return the vector of a length that points the way of (x, y)."""
    factor = length / math.sqrt(x * x + y * y)
    return factor * x, factor * y
