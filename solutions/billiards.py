"""Cushion-bounce billiards: one ball, four walls and one bumper, all through the same bounce.

What to do
    Write the five functions below, in their order; each uses the ones before it. Their
    docstrings say exactly what they take and return. The constants are given.
How to run it
    ``python exercises/billiards.py`` opens the table with *your* physics in it. Drag from the
    ball to launch it; V shows its velocity, N the normals.
How to check it
    ``workbook grade exercises/billiards.py``

Conventions: pixels and seconds, x to the right and **y down**, as on the screen; (0, 0) is the
corner at the top left. Positions are those of the ball's centre. Vectors are NumPy arrays of
shape (2,); do not change the ones you are given. A normal is a unit vector that points from the
wall to the ball. `depth` is how far the ball overlaps a wall, in pixels. Touching is not
overlapping: a contact has depth > 0.
"""

import numpy as np

WIDTH, HEIGHT = 600.0, 400.0
RADIUS = 12.0
RESTITUTION = 0.95
TIME_STEP = 1 / 60

# Inward unit normals. y points down, so the top wall pushes towards +y.
NORMALS = {
    "top": np.array([0.0, 1.0]),
    "bottom": np.array([0.0, -1.0]),
    "left": np.array([1.0, 0.0]),
    "right": np.array([-1.0, 0.0]),
}

# The bumper is a capsule: all points within HALF_THICKNESS of the segment from START to END.
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def wall_contacts(position):
    """Task B.1: return every wall that the ball overlaps; in a corner there are two.

    Parameters
    ----------
    position : ndarray, shape (2,)
        Centre of the ball, px, y down.

    Returns
    -------
    list of (name, normal, depth)
        Always in the order top, bottom, left, right: the wall's name, its inward unit normal
        (from NORMALS), and the overlap in px. Only walls with depth > 0. A ball whose centre is
        already outside the table overlaps too, and its depth is greater than RADIUS.

    Examples
    --------
    >>> [(name, float(depth)) for name, normal, depth in wall_contacts(np.array([5.0, 390.0]))]
    [('bottom', 2.0), ('left', 7.0)]
    """
    x, y = position
    depths = {
        "top": RADIUS - y,
        "bottom": y - (HEIGHT - RADIUS),
        "left": RADIUS - x,
        "right": x - (WIDTH - RADIUS),
    }
    return [(name, NORMALS[name], depth) for name, depth in depths.items() if depth > 0]


def bumper_contact(position):
    """Task B.2: return how the ball overlaps the bumper, or None.

    The point of the segment from BUMPER_START to BUMPER_END that is closest to the ball decides.
    Both sides of the bumper push, and so do its round ends.

    Parameters
    ----------
    position : ndarray, shape (2,)
        Centre of the ball, px, y down. It never lies exactly on the segment.

    Returns
    -------
    (normal, depth) or None
        The unit normal from the closest point to the ball, shape (2,), and the overlap in px,
        > 0. None if the ball does not overlap the bumper.

    Examples
    --------
    Left of the upper end, 15 px from it: 12 + 8 - 15 = 5 px too near.

    >>> normal, depth = bumper_contact(np.array([245.0, 160.0]))
    >>> normal.tolist(), float(depth)
    ([-1.0, 0.0], 5.0)
    """
    along = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    closest = BUMPER_START + min(max(part, 0.0), 1.0) * along
    offset = position - closest
    distance = np.hypot(*offset)
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    return (offset / distance, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    """Task B.3: return position and velocity after one contact.

    1. Separate first: push the ball out along the normal until it just touches.
    2. Bounce, but only if the ball moves into the wall. RESTITUTION acts on the part of the
       velocity along the normal; the part along the wall is kept.

    Parameters
    ----------
    position, velocity : ndarray, shape (2,)
        px and px/s, y down.
    normal : ndarray, shape (2,)
        Unit normal from the wall to the ball.
    depth : float
        Overlap, px, > 0.

    Returns
    -------
    (position, velocity)
        Two new arrays of shape (2,).

    Examples
    --------
    >>> position, velocity = np.array([5.0, 200.0]), np.array([-100.0, 30.0])
    >>> position, velocity = resolve(position, velocity, np.array([1.0, 0.0]), 7.0)
    >>> position.tolist(), velocity.tolist()
    ([12.0, 200.0], [95.0, 30.0])
    """
    position = position + depth * normal
    approach = np.dot(velocity, normal)
    if approach < 0:
        velocity = velocity - (1 + RESTITUTION) * approach * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    """Task B.4: return the ball after one step.

    1. Move the ball by velocity times dt.
    2. Resolve the bumper's contact, if there is one.
    3. Resolve the contacts with the walls, found at the position after 2, in their order. In a
       corner both are resolved.

    Parameters
    ----------
    position, velocity : ndarray, shape (2,)
        px and px/s, y down.
    dt : float
        Length of the step, s.

    Returns
    -------
    (position, velocity, hits)
        Two arrays of shape (2,), and a list of names, "bumper" or a wall's, in the order in
        which they were resolved. A name is a hit only if the ball was moving into that wall when
        its turn came.

    Examples
    --------
    >>> position, velocity, hits = step(np.array([20.0, 200.0]), np.array([-600.0, 0.0]))
    >>> position.tolist(), velocity.tolist(), hits
    ([12.0, 200.0], [570.0, 0.0], ['left'])
    """
    position = position + velocity * dt
    hits = []
    contact = bumper_contact(position)
    if contact is not None:
        normal, depth = contact
        if np.dot(velocity, normal) < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, normal, depth)
    for name, normal, depth in wall_contacts(position):
        if np.dot(velocity, normal) < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


def advance(position, velocity, elapsed):
    """Task B.5: return the ball after the elapsed time, in whole steps of TIME_STEP.

    Make as many steps of exactly TIME_STEP as fit into the elapsed time, and return the time
    that is left over; the window adds it to its next frame. Sums of floats are not exact, so a
    time that lacks less than a billionth of a step counts as the whole step: 1.0 s is 60 steps.

    Parameters
    ----------
    position, velocity : ndarray, shape (2,)
        px and px/s, y down.
    elapsed : float
        s, >= 0.

    Returns
    -------
    (position, velocity, hits, left_over)
        As for `step`, with the hits of all steps in one list, in order; then the rest of the
        time in s, >= 0. A last step that rounding has made a hair too short counts as a step.

    Examples
    --------
    >>> ball = np.array([300.0, 80.0]), np.array([60.0, 0.0])
    >>> position, velocity, hits, left_over = advance(*ball, 0.11)
    >>> position.round(9).tolist(), hits, round(left_over, 9)
    ([306.0, 80.0], [], 0.01)
    """
    steps = int(elapsed / TIME_STEP + 1e-9)
    hits = []
    for _ in range(steps):
        position, velocity, new_hits = step(position, velocity, TIME_STEP)
        hits += new_hits
    return position, velocity, hits, max(0.0, elapsed - steps * TIME_STEP)


if __name__ == "__main__":
    from lesson_code.chapters.billiards.game import PROGRAM
    from lesson_code.view.pygame.frame import play

    play(PROGRAM, settings={"advance": advance})
