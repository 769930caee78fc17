"""A ball on a floor, stepped in time: the smallest loop in which a bounce can go wrong."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.formulas.validation import (
    non_negative,
    one_number,
    one_vector,
    positive,
    unit_interval,
)

Bounce: TypeAlias = Callable[[Any, Any, float], Any]
"""Takes velocity, normal and restitution; returns the velocity after."""

Separation: TypeAlias = Callable[[Any, Any, float], Any]
"""Takes position, normal and depth; returns the position after."""

UP = np.array([0.0, 1.0])
UP.setflags(write=False)  # the rules under test are handed this very array


def moved_out(position: Any, normal: Any, depth: float) -> Any:
    """Return a position moved along the normal by the depth, m."""
    return position + depth * normal


def drop_in_steps(
    bounce: Bounce,
    *,
    height: float,
    restitution: float,
    duration: float,
    gravity: float = 9.81,
    dt: float = 1 / 60,
    separate: Separation | None = moved_out,
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
        s, >= 0; as many whole steps are made as fit in.
    gravity : float
        m/s^2, > 0, downward.
    dt : float
        Time step, s, > 0.
    separate : callable, optional
        Moves a ball out that was found below the floor: takes position, normal and depth. With
        None it stays where it was found.

    Returns
    -------
    (times, heights) : ndarray, shape (F,) each
        s and m, the start included.

    Raises
    ------
    ValueError
        A number is out of its range, or `bounce` or `separate` returns something that is no vector.
    TypeError
        An argument is no number, or more than one.

    Examples
    --------
    At 10 m/s^2 and 0.1 s a step, the velocity grows by 1 m/s in each, and so the ball falls by
    0.1, 0.2, 0.3, 0.4 m. One more step would take it below the floor: it is set back onto it.

    >>> from lesson_code.formulas import bounce
    >>> _, heights = drop_in_steps(
    ...     bounce, height=1.2, restitution=0, duration=0.6, gravity=10, dt=0.1
    ... )
    >>> heights.round(9)
    array([1.2, 1.1, 0.9, 0.6, 0.2, 0. , 0. ])
    """
    y = one_number("height", height, positive)
    e = one_number("restitution", restitution, unit_interval)
    g, dt = one_number("gravity", gravity, positive), one_number("dt", dt, positive)
    steps = whole_parts(one_number("duration", duration, non_negative), dt)
    times, heights = dt * np.arange(steps + 1.0), np.empty(steps + 1)
    heights[0] = y
    velocity = np.zeros(2)
    for step in range(1, steps + 1):
        velocity = velocity - g * dt * UP
        y += velocity[1] * dt
        if y < 0:
            velocity = one_vector("the velocity after a bounce", bounce(velocity, UP, e))
            if separate is not None:
                y = one_vector("the position moved out", separate(y * UP, UP, -y))[1]
        heights[step] = y
    return times, heights
