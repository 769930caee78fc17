"""A ball on a floor, stepped in time: the smallest loop in which a bounce can go wrong."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.formulas.validation import non_negative, positive, unit_interval

Bounce: TypeAlias = Callable[[Any, Any, float], Any]
"""Takes velocity, normal and restitution; returns the velocity after."""

UP = np.array([0.0, 1.0])


def drop_in_steps(
    bounce: Bounce,
    *,
    height: float,
    restitution: float,
    duration: float,
    gravity: float = 9.81,
    dt: float = 1 / 60,
    push_out: bool = True,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the heights of a ball dropped on a floor, computed in time steps.

    Each step: the velocity takes up gravity, the position moves on, and a ball found below the
    floor is given to `bounce`.

    Parameters
    ----------
    bounce : callable
        The rule under test, right or wrong: takes velocity, normal and restitution.
    height : float
        Height of the drop, m, > 0.
    restitution : float
        0 to 1.
    duration : float
        s, >= 0; whole steps are made.
    gravity : float
        m/s^2, > 0, downward.
    dt : float
        Time step, s, > 0.
    push_out : bool
        Whether a ball found below the floor is set back onto it.

    Returns
    -------
    (times, heights) : ndarray, shape (F,) each
        s and m, the start included.

    Raises
    ------
    ValueError
        A number is out of its range.
    """
    positive("height", height)
    unit_interval("restitution", restitution)
    positive("gravity", gravity)
    steps = round(non_negative("duration", duration) / positive("dt", dt))
    heights = np.empty(steps + 1)
    heights[0] = y = height
    velocity = np.zeros(2)
    for step in range(1, steps + 1):
        velocity = velocity - gravity * dt * UP
        y += velocity[1] * dt
        if y < 0:
            velocity = np.asarray(bounce(velocity, UP, restitution))
            y = 0.0 if push_out else y
        heights[step] = y
    return dt * np.arange(steps + 1), heights
