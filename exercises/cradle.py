"""Newton's cradle: k balls in, k balls out.

What to do
    Write the three functions below. Their docstrings say exactly what they take and return. The
    constants are given.
How to run it
    ``python exercises/cradle.py`` opens a cradle that *your* third function moves; until it is
    written, nothing moves.
How to check it
    ``workbook grade exercises/cradle.py``

Conventions: kilograms, metres and seconds. The balls hang side by side in a row, number 0 at the
left. Velocities, angles and rates are positive to the right. Lists of numbers come as NumPy arrays;
do not change the ones you are given.
"""

import numpy as np

GRAVITY = 9.81
SLOWEST = 1e-12  # m/s: an approach that is slower than this is rounding, and no collision


def collide_row(masses, velocities, restitution):
    """Task C.1: return the velocities of a row of balls after all their collisions.

    Neighbours that approach by more than SLOWEST collide, as in chapter 01. Always take the
    leftmost such pair; go on until no pair approaches.

    Parameters
    ----------
    masses, velocities : ndarray, shape (N,)
        kg and m/s.
    restitution : float
        Of each pair.

    Returns
    -------
    array_like, shape (N,)
        m/s.

    Examples
    --------
    >>> collide_row(np.ones(3), np.array([2.0, 0.0, 0.0]), 1.0).tolist()
    [0.0, 0.0, 2.0]
    """
    raise NotImplementedError("Task C.1: collide_row")


def swing_step(angle, rate, length, dt):
    """Task C.2: return angle and rate of a ball on a string after one step.

    First the rate changes by the pull of gravity at the angle as it is; then the angle by the
    *new* rate. The pull is -g / length sin(angle).

    Parameters
    ----------
    angle, rate : float
        rad from the vertical, and rad/s.
    length, dt : float
        m and s.

    Returns
    -------
    (angle, rate)
        rad and rad/s.

    Examples
    --------
    >>> swing_step(0.0, 1.0, 2.0, 0.1)
    (0.1, 1.0)
    """
    raise NotImplementedError("Task C.2: swing_step")


def cradle(angles, rates, length, dt, steps):
    """Task C.3: return angles and rates of a cradle after `steps` steps.

    All balls are equal and elastic, and just touch at rest. So two neighbours touch when the left
    one's angle is the larger, or both are equal. In each step:

    1. Every ball swings, as in C.2.
    2. While there are neighbours that touch and approach (the left one's rate is the larger), the
       leftmost such pair swaps its rates.

    Parameters
    ----------
    angles, rates : ndarray, shape (N,)
        rad and rad/s.
    length, dt : float
        m and s.
    steps : float
        A whole number >= 0.

    Returns
    -------
    (angles, rates)
        Two arrays of shape (N,).

    Examples
    --------
    >>> angles, rates = cradle(np.zeros(2), np.array([1.0, 0.0]), 9.81, 0.001, 1)
    >>> rates.tolist()
    [0.0, 1.0]
    """
    raise NotImplementedError("Task C.3: cradle")


if __name__ == "__main__":
    from lesson_code.chapters.cradle.own_world import CRADLE
    from lesson_code.view.pygame.frame import play

    play(CRADLE, settings={"move": cradle})
