"""Breakout: a paddle that decides the angle, and a ball that no brick lets through.

What to do
    Write the three functions below. Their docstrings say exactly what they take and return. The
    constants are given.
How to run it
    ``python exercises/breakout.py`` opens the game with *your* paddle in it; until it is written,
    every ball leaves straight up.
How to check it
    ``workbook grade exercises/breakout.py``

Conventions: metres and seconds, x to the right and y up. A brick is (x, y, width, height): its
lower left corner and its size. Vectors are NumPy arrays of shape (2,); do not change the ones you
are given. A normal is a unit vector from the brick to the ball.
"""

import math

import numpy as np

STEEPEST = math.radians(60)  # from the vertical: what the paddle's ends do
HORIZON = 1.0  # s


def paddle_bounce(offset, speed):
    """Task K.1: return the velocity of a ball that leaves the paddle.

    The angle from the vertical is offset times STEEPEST, to the right for an offset > 0, however
    the ball has come. An offset beyond -1 or 1 counts as -1 or 1.

    Parameters
    ----------
    offset : float
        Where it hits: -1 at the left end, 0 in the middle, 1 at the right end.
    speed : float
        m/s; the ball keeps it.

    Returns
    -------
    array_like, shape (2,)
        m/s.

    Examples
    --------
    >>> paddle_bounce(0.0, 5.0)
    (0.0, 5.0)
    """
    raise NotImplementedError("Task K.1: paddle_bounce")


def brick_impact(position, velocity, radius, box):
    """Task K.2: return when a ball first touches a brick, and the normal there.

    The ball's centre touches when it reaches the brick grown by the radius: a rectangle with
    round corners. That is four faces, each moved out by the radius, and four circles round the
    corners. Compute the time, do not sample it: no speed may be too high.

    Parameters
    ----------
    position, velocity : ndarray, shape (2,)
        Of the ball's centre, m and m/s. The ball is outside of the brick, and not in touch yet.
    radius : float
        m.
    box : ndarray, shape (4,)
        The brick: x, y, width, height, m.

    Returns
    -------
    (time, normal) or None
        s, at most HORIZON, and a unit vector of shape (2,). None: it does not come to that.

    Examples
    --------
    >>> ball = np.array([0.5, 0.0]), np.array([0.0, 4.0])
    >>> time, normal = brick_impact(*ball, 0.5, np.array([0.0, 2.5, 1.0, 1.0]))
    >>> float(time), normal.tolist()
    (0.5, [0.0, -1.0])
    """
    raise NotImplementedError("Task K.2: brick_impact")


def fly(position, velocity, radius, bricks, duration):
    """Task K.3: return a ball after a flight among bricks.

    The brick that is met first turns the ball (its velocity is reflected at the normal) and
    breaks: it is gone. Then the flight goes on with the time that is left. No two bricks are met at
    the same time.

    Parameters
    ----------
    position, velocity : ndarray, shape (2,)
        m and m/s.
    radius : float
        m.
    bricks : ndarray, shape (B, 4)
        m.
    duration : float
        s, at most HORIZON.

    Returns
    -------
    (position, velocity, broken)
        Two vectors of shape (2,), and a list of the places in `bricks` of those that broke, in
        the order in which they did.

    Examples
    --------
    >>> ball = np.array([0.5, 0.0]), np.array([0.0, 4.0])
    >>> position, velocity, broken = fly(*ball, 0.5, np.array([[0.0, 2.5, 1.0, 1.0]]), 1.0)
    >>> position.tolist(), velocity.tolist(), broken
    ([0.5, 0.0], [0.0, -4.0], [0])
    """
    raise NotImplementedError("Task K.3: fly")


if __name__ == "__main__":
    from lesson_code.chapters.breakout.game import PROGRAM, Rules
    from lesson_code.view.pygame.frame import play

    play(PROGRAM, settings={"rules": Rules(paddle_bounce)})
