"""The asteroid field: bursts, shots and collisions that keep the momentum.

What to do
    Write the three functions below. Their docstrings say exactly what they take and return.
How to run it
    ``python exercises/asteroids.py`` opens the field with *your* bursts and shots in it; the
    window says what is not written yet. The panel shows a sum that has to stay as it is.
How to check it
    ``workbook grade exercises/asteroids.py``

Conventions: kilograms, metres, seconds, radians counter-clockwise. Vectors are NumPy arrays of
shape (2,), many of them one array of shape (N, 2); do not change the ones you are given.
"""

import numpy as np


def split(velocity, masses, speed, heading):
    """Task A.1: return the velocities of the pieces of an asteroid that bursts.

    Seen from the asteroid, the pieces first fly apart at `speed`, in directions that are spread
    evenly round the circle: the first at `heading`, each following one a further 2 pi / N
    counter-clockwise. Their masses differ, so that this alone would change the momentum. Then the
    *same* velocity is taken from all of them, so that the total momentum is that of the asteroid.

    Parameters
    ----------
    velocity : ndarray, shape (2,)
        Of the asteroid, m/s.
    masses : ndarray, shape (N,)
        Of the pieces, kg; the asteroid had the mass of all of them.
    speed, heading : float
        m/s and rad.

    Returns
    -------
    array_like, shape (N, 2)
        m/s.

    Examples
    --------
    >>> split(np.array([1.0, 0.5]), np.ones(2), 2.0, 0.0).round(9).tolist()
    [[3.0, 0.5], [-1.0, 0.5]]
    """
    turns = heading + 2 * np.pi * np.arange(len(masses)) / len(masses)
    apart = speed * np.column_stack([np.cos(turns), np.sin(turns)])
    too_much = masses @ apart / np.sum(masses)
    return velocity + apart - too_much


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    """Task A.2: return the velocities of ship and shot after a shot.

    Ship and shot first move together. Afterwards the shot moves at `muzzle_speed` in the direction
    `heading` *as seen from the ship*, and the total momentum is what it was.

    Parameters
    ----------
    velocity : ndarray, shape (2,)
        Of both before, m/s.
    ship_mass, shot_mass : float
        kg; the ship's without the shot.
    muzzle_speed, heading : float
        m/s and rad.

    Returns
    -------
    (ship, shot)
        Two velocities of shape (2,), m/s.

    Examples
    --------
    >>> ship, shot = fire(np.array([0.0, 0.0]), 3.0, 1.0, 8.0, 0.0)
    >>> ship.tolist(), shot.tolist()
    ([-2.0, 0.0], [6.0, 0.0])
    """
    relative = muzzle_speed * np.array([np.cos(heading), np.sin(heading)])
    ship = velocity - shot_mass / (ship_mass + shot_mass) * relative
    return ship, ship + relative


def collide_all(positions, velocities, masses, radii, restitution):
    """Task A.3: return the velocities of a field of discs after all its collisions.

    Every pair that overlaps and approaches collides, without friction, as in chapter 04. Take the
    pairs in the order (0, 1), (0, 2), ..., (1, 2), ...; each finds the velocities that the ones
    before have left. Leave alone pairs whose centres coincide.

    Parameters
    ----------
    positions, velocities : ndarray, shape (N, 2)
        m and m/s.
    masses, radii : ndarray, shape (N,)
        kg and m.
    restitution : float
        Of each pair.

    Returns
    -------
    array_like, shape (N, 2)
        m/s.

    Examples
    --------
    >>> places, moving = np.array([[0.0, 0.0], [1.5, 0.0]]), np.array([[2.0, 0.0], [0.0, 0.0]])
    >>> collide_all(places, moving, np.ones(2), np.ones(2), 1.0).tolist()
    [[0.0, 0.0], [2.0, 0.0]]
    """
    velocities = velocities.copy()
    for a in range(len(masses)):
        for b in range(a + 1, len(masses)):
            offset = positions[b] - positions[a]
            distance = np.hypot(*offset)
            if distance == 0 or distance >= radii[a] + radii[b]:
                continue
            normal = offset / distance
            approach = np.dot(velocities[a] - velocities[b], normal)
            if approach > 0:
                impulse = (1 + restitution) * approach / (1 / masses[a] + 1 / masses[b])
                velocities[a] -= impulse / masses[a] * normal
                velocities[b] += impulse / masses[b] * normal
    return velocities


if __name__ == "__main__":
    from lesson_code.chapters.asteroids.game import PROGRAM, Rules
    from lesson_code.view.pygame.frame import play

    play(PROGRAM, settings={"rules": Rules(split, fire)})
