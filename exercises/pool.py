"""Pool: the rack, the cue's stroke, and a break that is as symmetric as the rack.

What to do
    Write the three functions below. Their docstrings say exactly what they take and return. The
    constants are given.
How to run it
    ``python exercises/pool.py`` opens the table with *your* rack and stroke in it; the window
    says what is not written yet. Drag back from the ball to strike it.
How to check it
    ``workbook grade exercises/pool.py``

Conventions: metres and seconds, x to the right and y up, seen from above. Spin is about the
vertical axis, rad/s, counter-clockwise. Vectors are NumPy arrays of shape (2,), many of them one
array of shape (N, 2); do not change the ones you are given.
"""

import numpy as np

ROWS = 5
TOUCHING = 2.001  # radii between the centres of two balls that touch, at most
ROUNDS = 20


def rack(apex, radius, gap):
    """Task P.1: return the centres of the 15 balls of a rack.

    Five rows, from the apex to the right; row 0 has one ball, row 4 has five. Neighbours, in a
    row and from row to row, are `gap` apart. Each row is centred on the apex's y, and is listed
    with y growing.

    Parameters
    ----------
    apex : ndarray, shape (2,)
        Centre of the first ball, m.
    radius, gap : float
        m.

    Returns
    -------
    array_like, shape (15, 2)
        m.

    Examples
    --------
    >>> np.round(rack(np.array([0.0, 0.0]), 0.5, 0.0), 3)[:3].tolist()
    [[0.0, 0.0], [0.866, -0.5], [0.866, 0.5]]
    """
    raise NotImplementedError("Task P.1: rack")


def strike(impulse, offset, mass, radius):
    """Task P.2: return velocity and spin of a ball at rest that a cue strikes.

    The ball is a solid sphere: I = 2/5 m r^2. The cue hits it `offset` to the left of its centre,
    as seen along the cue, and pushes in its own direction.

    Parameters
    ----------
    impulse : ndarray, shape (2,)
        N s.
    offset : float
        m; negative: to the right.
    mass, radius : float
        kg and m.

    Returns
    -------
    (velocity, spin)
        m/s, shape (2,), and rad/s, counter-clockwise.

    Examples
    --------
    >>> velocity, spin = strike(np.array([0.4, 0.0]), 0.25, 0.5, 1.0)
    >>> velocity.tolist(), float(spin)
    ([0.8, 0.0], -0.5)
    """
    raise NotImplementedError("Task P.2: strike")


def share_impact(positions, velocities, radius, restitution):
    """Task P.3: return the velocities of equal balls after an impact in which many touch.

    Make exactly ROUNDS rounds. In each one, from the velocities at its beginning:

    1. Find the pairs that touch (centres at most TOUCHING radii apart) and approach.
    2. For each ball, count how many of these pairs it is in.
    3. Each of them gets the impulse that it alone would need for its restitution, divided by the
       larger count of its two balls.

    Only when all impulses of the round are known do the velocities change. So no pair is before
    another, and what is symmetric stays so.

    Parameters
    ----------
    positions, velocities : ndarray, shape (N, 2)
        m and m/s.
    radius, restitution : float
        m; of every pair.

    Returns
    -------
    array_like, shape (N, 2)
        m/s.

    Examples
    --------
    >>> places, moving = np.array([[0.0, 0.0], [2.0, 0.0]]), np.array([[1.0, 0.0], [0.0, 0.0]])
    >>> share_impact(places, moving, 1.0, 1.0).tolist()
    [[0.0, 0.0], [1.0, 0.0]]
    """
    raise NotImplementedError("Task P.3: share_impact")


if __name__ == "__main__":
    from lesson_code.chapters.pool.game import PROGRAM, Rules
    from lesson_code.view.pygame.frame import play

    play(PROGRAM, settings={"rules": Rules(rack, strike)})
