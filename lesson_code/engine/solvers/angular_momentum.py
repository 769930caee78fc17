"""Angular momentum where bodies are pushed apart: a way that is not moved with a velocity.

A push moves bodies by s and leaves their velocities v as they are. It keeps the centre of mass of
an island where it is, but the sum of m s x v is gained by the angular momentum, though nothing has
turned the island. So the island is turned back: as a rigid body about its centre of mass, by

    omega = -(sum of m s x v) / (sum of m r^2)

Two bodies that are pushed apart thus go around each other the more slowly, as a skater does who
stretches out the arms.
"""

from __future__ import annotations

import numpy as np

from lesson_code.engine.core.islands import Floats, Island, changes_of


def keep_angular_momentum(island: Island, pushes: Floats, duration: float) -> None:
    """Turn an island back by what pushes have added to its angular momentum.

    Parameters
    ----------
    island : Island
        The pushes are in its pseudo-velocities already. Nothing is done to one that touches a body
        that nothing can push: that takes up any angular momentum.
    pushes : ndarray, shape (2m,)
        N s.
    duration : float
        s, for which the pseudo-velocities act.
    """
    if any(body.inv_m == 0.0 for body in island.bodies):
        return
    mass = np.array([1.0 / body.inv_m for body in island.bodies])
    shift = duration * np.array(changes_of(island, pushes))[:, :2]
    v = np.array([(body.vx, body.vy) for body in island.bodies])
    moved = np.array(
        [(body.vx + body.pseudo_vx, body.vy + body.pseudo_vy) for body in island.bodies]
    )
    place = np.array([(body.x, body.y) for body in island.bodies]) + duration * moved
    r = place - mass @ place / mass.sum()
    inertia = float(mass @ (r * r).sum(axis=1))
    if inertia > 0.0:
        gained = float(mass @ (shift[:, 0] * v[:, 1] - shift[:, 1] * v[:, 0]))
        omega = -gained / inertia
        for body, (rx, ry) in zip(island.bodies, r.tolist(), strict=True):
            body.vx -= omega * ry
            body.vy += omega * rx
            body.pseudo_vx += omega * ry
            body.pseudo_vy -= omega * rx
