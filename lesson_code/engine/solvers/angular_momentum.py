"""Angular momentum where bodies are pushed apart: a way that is not moved with a velocity.

A push moves bodies by s and leaves their velocities v as they are. It keeps the centre of mass of
an island where it is, but the sum of m s x v is gained by the angular momentum, though nothing has
turned the island. So the island is turned back: as a rigid body about its centre of mass, by

    omega = -(sum of m s x v) / (sum of m r^2)

Two bodies that are pushed apart thus go around each other the more slowly, as a skater does who
stretches out the arms. Rods that slide on one another may be turned back the way they go round, and
gain energy. Then what they have of motion about their centre of mass is slowed as well, spins
included, and turned by so much more that the angular momentum is right and no energy comes.
"""

from __future__ import annotations

import numpy as np

from lesson_code.engine.core.islands import Floats, Island, changes_of
from lesson_code.formulas.arithmetic import cross

NEARLY_ONE_BODY = 1e-6
"""Of an island that turns as one body: what is nearer to that would be changed a thousandfold."""


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
        gained = float(mass @ cross(shift.T, v.T))
        omega = -gained / inertia
        change = np.column_stack((-omega * r[:, 1], omega * r[:, 0], np.zeros(len(r))))
        if omega * float(mass @ cross(r.T, v.T)) + omega * omega * inertia / 2.0 > 0.0:
            change = _without_gain(island, mass, r, v, gained, change)
        for body, (vx, vy, w) in zip(island.bodies, change.tolist(), strict=True):
            body.vx += vx
            body.vy += vy
            body.w += w
            body.pseudo_vx -= vx
            body.pseudo_vy -= vy
            body.pseudo_w -= w


def _without_gain(
    island: Island, mass: Floats, r: Floats, v: Floats, gained: float, otherwise: Floats
) -> Floats:
    """Return changes of velocities and spins, shape (N, 3), that take back an angular momentum.

    They are a turn and a part of the motion about the centre of mass, so that the energy stays.
    Where all turns as one body, there is no such pair.
    """
    inertias = np.array([1.0 / body.inv_i if body.inv_i > 0.0 else 0.0 for body in island.bodies])
    spins = np.array([body.w if body.inv_i > 0.0 else 0.0 for body in island.bodies])
    weight = np.column_stack((mass, mass, inertias))
    turn: Floats = np.column_stack((-r[:, 1], r[:, 0], inertias > 0.0))
    motion: Floats = np.column_stack((v - mass @ v / mass.sum(), spins))
    of_turn, of_both, of_motion = (
        float((weight * p * q).sum()) for p, q in ((turn, turn), (turn, motion), (motion, motion))
    )
    rest = of_turn * of_motion - of_both * of_both
    if rest <= NEARLY_ONE_BODY * of_turn * of_motion:
        return otherwise
    return (of_both * motion - of_motion * turn) * (gained / rest)
