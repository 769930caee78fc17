"""Dominoes: when one topples, what that takes, and a row in which each falls in its turn.

What to do
    Write the three functions below. Their docstrings say exactly what they take and return. The
    constants are given.
How to run it
    ``python exercises/dominoes.py`` opens a row that *your* third function moves; until it is
    written, nothing moves.
How to check it
    ``workbook grade exercises/dominoes.py``

Conventions: metres, seconds and radians. Angles are measured from upright, positive towards the
next domino; rates likewise. Lists of numbers come as NumPy arrays; do not change the ones you are
given.
"""

import math

import numpy as np

GRAVITY = 9.81


def tipping_angle(width, height):
    """Task D.1: return how far a domino can lean before it falls.

    It turns about one of its lower edges. It falls when its centre is above that edge.

    Parameters
    ----------
    width, height : float
        m.

    Returns
    -------
    float
        rad.

    Examples
    --------
    >>> round(math.degrees(tipping_angle(1.0, 1.0)), 9)
    45.0
    """
    raise NotImplementedError("Task D.1: tipping_angle")


def toppling_rate(width, height):
    """Task D.2: return the least angular velocity at which a standing domino topples.

    Its energy of rotation about a lower edge must lift its centre to the highest point of its
    way, right above that edge. About it the moment of inertia is m (width^2 + height^2) / 3.

    Parameters
    ----------
    width, height : float
        m.

    Returns
    -------
    float
        rad/s, > 0.

    Examples
    --------
    >>> round(toppling_rate(0.1, 0.6), 3)
    0.811
    """
    raise NotImplementedError("Task D.2: toppling_rate")


def chain(angles, rates, height, spacing, dt, steps):
    """Task D.3: return angles and rates of a row of thin dominoes after `steps` steps.

    In each step:

    1. Each turns about its foot: its rate grows by 3 g / (2 height) sin(angle) dt, then its angle
       by the new rate times dt.
    2. From the first to the last but one, each with the rates that the one before has left: a
       domino that leans by more than asin(spacing / height) touches the next one. If it turns
       faster than that one, both go on with the mean of their rates.
    3. What leans by more than 90 degrees lies: its angle is pi / 2 and its rate 0.

    Parameters
    ----------
    angles, rates : ndarray, shape (N,)
        rad and rad/s.
    height, spacing : float
        m; the spacing is the smaller.
    dt : float
        s.
    steps : float
        A whole number >= 0.

    Returns
    -------
    (angles, rates)
        Two arrays of shape (N,).

    Examples
    --------
    >>> angles, rates = chain(np.zeros(2), np.array([1.0, 0.0]), 1.0, 0.5, 0.1, 1)
    >>> angles.tolist(), rates.tolist()
    ([0.1, 0.0], [1.0, 0.0])
    """
    raise NotImplementedError("Task D.3: chain")


if __name__ == "__main__":
    from lesson_code.chapters.dominoes.own_world import DOMINOES
    from lesson_code.view.pygame.frame import play

    play(DOMINOES, settings={"move": chain})
