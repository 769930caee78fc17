"""A soft body: a ring of masses and springs that keeps its area and comes to rest.

What to do
    Write the four functions below, in their order; the last one uses the others. Their docstrings
    say exactly what they take and return. The constants are given.
How to run it
    ``python exercises/soft_body.py`` opens a ring that *your* fourth function moves; until it is
    written, nothing moves.
How to check it
    ``workbook grade exercises/soft_body.py``

Conventions: kilograms, metres, newtons and seconds, y up. A ring is an array of shape (N, 2) with
its masses in order, counter-clockwise; the last one is tied to the first. Do not change the arrays
you are given.
"""

import numpy as np

MASS = 0.1  # kg, of each mass
STIFFNESS, DAMPING = 300.0, 10.0  # N/m and N s/m, of each spring
PRESSURE = 800.0  # N/m
GRIP = 0.98  # of the velocity along the floor: what a step leaves to a mass on it
AIR = 1.5  # 1/s: what the air takes of every velocity
GRAVITY = 9.81  # m/s^2
TIME_STEP = 1 / 600  # s


def ring_area(positions):
    """Task S.1: return the area inside a ring.

    Parameters
    ----------
    positions : ndarray, shape (N, 2)
        m.

    Returns
    -------
    float
        m^2; positive counter-clockwise, negative clockwise.

    Examples
    --------
    >>> float(ring_area(np.array([[0.0, 0.0], [2.0, 0.0], [2.0, 3.0], [0.0, 3.0]])))
    6.0
    """
    following = np.roll(positions, -1, axis=0)
    return np.sum(positions[:, 0] * following[:, 1] - following[:, 0] * positions[:, 1]) / 2


def ring_forces(positions, velocities, length, stiffness, damping):
    """Task S.2: return the forces of the springs in a ring.

    Each mass is tied to the next one by a damped spring. With u the unit vector from a mass to the
    next, the spring pulls the mass along u by

        stiffness * (distance - length) + damping * (v_next - v) . u

    and the next one by as much the other way.

    Parameters
    ----------
    positions, velocities : ndarray, shape (N, 2)
        m and m/s.
    length : float
        m, of each spring at rest.
    stiffness, damping : float
        N/m and N s/m.

    Returns
    -------
    array_like, shape (N, 2)
        N.

    Examples
    --------
    >>> square = np.array([[0.0, 0.0], [3.0, 0.0], [3.0, 3.0], [0.0, 3.0]])
    >>> ring_forces(square, np.zeros((4, 2)), 2.0, 5.0, 0.0)[0].tolist()
    [5.0, 5.0]
    """
    along = np.roll(positions, -1, axis=0) - positions
    distance = np.hypot(along[:, 0], along[:, 1])
    u = along / distance[:, None]
    faster = np.sum((np.roll(velocities, -1, axis=0) - velocities) * u, axis=1)
    pull = (stiffness * (distance - length) + damping * faster)[:, None] * u
    return pull - np.roll(pull, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    """Task S.3: return the forces of a gas inside a ring.

    The pressure is stiffness * (area / (area now) - 1), and may be negative. It pushes each edge
    outward, at right angles, by pressure times the edge's length; half of that acts on each of
    its two masses.

    Parameters
    ----------
    positions : ndarray, shape (N, 2)
        m, counter-clockwise, so the area now is > 0.
    area : float
        m^2, at rest.
    stiffness : float
        N/m.

    Returns
    -------
    array_like, shape (N, 2)
        N.

    Examples
    --------
    >>> square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    >>> pressure_forces(square, 2.0, 4.0)[2].tolist()
    [2.0, 2.0]
    """
    pressure = stiffness * (area / ring_area(positions) - 1)
    along = np.roll(positions, -1, axis=0) - positions
    push = pressure * np.column_stack([along[:, 1], -along[:, 0]])
    return (push + np.roll(push, 1, axis=0)) / 2


def drop(positions, velocities, length, area, steps):
    """Task S.4: return a ring above a floor at y = 0 after `steps` steps of TIME_STEP.

    In each step:

    1. F: springs (STIFFNESS, DAMPING) and gas (PRESSURE), from positions and velocities as they
       are.
    2. v' = v + (F / MASS - AIR v + g) TIME_STEP, with g = (0, -GRAVITY); x' = x + v' TIME_STEP.
    3. A mass with y < 0 is put at y = 0; if its vy is negative it becomes 0; its vx is multiplied
       by GRIP.

    Parameters
    ----------
    positions, velocities : ndarray, shape (N, 2)
        m and m/s.
    length, area : float
        m and m^2, at rest.
    steps : float
        A whole number >= 0.

    Returns
    -------
    (positions, velocities)
        Two arrays of shape (N, 2).

    Examples
    --------
    >>> ring = np.array([[1.0, 5.0], [0.0, 6.0], [-1.0, 5.0], [0.0, 4.0]])
    >>> positions, velocities = drop(ring, np.zeros((4, 2)), 2**0.5, 2.0, 1)
    >>> velocities[:, 1].round(5).tolist()
    [-0.01635, -0.01635, -0.01635, -0.01635]
    """
    weight = np.array([0.0, -GRAVITY])
    for _ in range(int(steps)):
        forces = ring_forces(positions, velocities, length, STIFFNESS, DAMPING)
        forces = forces + pressure_forces(positions, area, PRESSURE)
        velocities = velocities + (forces / MASS - AIR * velocities + weight) * TIME_STEP
        positions = positions + velocities * TIME_STEP
        below = positions[:, 1] < 0
        positions[below, 1] = 0.0
        velocities[below, 1] = np.maximum(velocities[below, 1], 0.0)
        velocities[below, 0] *= GRIP
    return positions, velocities


if __name__ == "__main__":
    from lesson_code.chapters.soft_body.own_world import SOFT_BODY
    from lesson_code.view.pygame.frame import play

    play(SOFT_BODY, settings={"move": drop})
