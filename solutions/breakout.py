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
    angle = max(-1.0, min(1.0, offset)) * STEEPEST
    return speed * math.sin(angle), speed * math.cos(angle)


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
    low, high = box[:2], box[:2] + box[2:]
    found = []
    for axis in (0, 1):
        for face, side in ((low, -1.0), (high, 1.0)):
            if velocity[axis] * side < 0:
                time = (face[axis] + side * radius - position[axis]) / velocity[axis]
                along = position[1 - axis] + velocity[1 - axis] * time
                if time >= 0 and low[1 - axis] <= along <= high[1 - axis]:
                    normal = np.zeros(2)
                    normal[axis] = side
                    found.append((time, normal))
    for corner in ((low[0], low[1]), (low[0], high[1]), (high[0], low[1]), (high[0], high[1])):
        offset = position - corner
        a = np.dot(velocity, velocity)
        b = np.dot(offset, velocity)
        under_root = b * b - a * (np.dot(offset, offset) - radius**2)
        if b < 0 and under_root >= 0:
            # Not (-b - root) / a: it loses all digits where the ball nearly touches already.
            time = (np.dot(offset, offset) - radius**2) / (-b + math.sqrt(under_root))
            if time >= 0:
                found.append((time, (offset + velocity * time) / radius))
    first = min(found, key=lambda hit: hit[0], default=None)
    return first if first is not None and first[0] <= HORIZON else None


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
    broken = []
    while True:
        first = None
        for k, brick in enumerate(bricks):
            hit = None if k in broken else brick_impact(position, velocity, radius, brick)
            if hit is not None and (first is None or hit[0] < first[1]):
                first = k, *hit
        if first is None or first[1] > duration:
            return position + velocity * duration, velocity, broken
        k, time, normal = first
        position = position + velocity * time
        velocity = velocity - 2 * np.dot(velocity, normal) * normal
        duration = duration - time
        broken.append(k)


if __name__ == "__main__":
    from lesson_code.chapters.breakout.game import PROGRAM, Rules
    from lesson_code.view.pygame.frame import play

    play(PROGRAM, settings={"rules": Rules(paddle_bounce)})
