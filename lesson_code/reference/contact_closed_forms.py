"""Reference: one impact of two rigid bodies with spin and friction, solved as two equations.

Nothing here uses the lesson's equations (only the rules for arguments are shared). Bodies A and
B, the unit normal n from A to B, the tangent t = (-n_y, n_x); impulses act on B as written, and
on A the other way round.

==========  =====================================================================  =====
symbol      meaning                                                                unit
==========  =====================================================================  =====
un, ut      relative velocity of the touching points along n and t, B less A;      m/s
            un < 0 is approach; un', ut' after the impact
jn, jt      impulse along n and t                                                  N s
knn, ktt    change of un by jn = 1, of ut by jt = 1                                1/kg
knt         change of un by jt = 1, and of ut by jn = 1                            1/kg
e, mu       restitution, friction coefficient                                      -
==========  =====================================================================  =====
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from lesson_code.formulas.validation import (
    Vector,
    non_negative,
    one_number,
    one_vector,
    unit_interval,
    unit_vector,
)

ALONG = 1e-9
"""An arm lies along the normal if it strays by less than this part of it."""


class Struck(NamedTuple):
    """A body at the moment of an impact."""

    inverse_mass: float
    """1/kg, >= 0; 0 for a body that cannot be moved."""
    inverse_inertia: float
    """1/(kg m^2), >= 0; 0 for a body that cannot be turned."""
    velocity: Vector
    """Of the centre of mass, m/s, shape (2,)."""
    angular_velocity: float
    """rad/s, counter-clockwise."""
    arm: Vector
    """From the centre of mass to the place where it is touched, m, shape (2,)."""


class Impact(NamedTuple):
    """The result of an impact."""

    kind: str
    """"parts" (no approach, no impulse), "sticks" (ut' = 0) or "slides"."""
    normal_impulse: float
    """jn, N s, >= 0."""
    tangent_impulse: float
    """jt, N s."""
    velocities: Any
    """After the impact, of A and B, m/s, shape (2, 2)."""
    angular_velocities: Any
    """After the impact, of A and B, rad/s, shape (2,)."""


def impact_with_friction(
    a: Struck, b: Struck, normal: Vector, restitution: float, friction: float
) -> Impact:
    """Return the impact of two bodies of any shape at one contact, by Newton's and Coulomb's rules.

    un' = un + knn jn + knt jt = -e un
    ut' = ut + knt jn + ktt jt            and either     ut' = 0 and abs(jt) <= mu jn  (sticks)
                                              or     jt = +-mu jn, against ut'         (slides)

    An off-centre impact turns the body, so that an impulse along n also changes ut, and friction
    changes un: the two are coupled by knt. One solves for sticking, which is two linear equations,
    and looks whether friction can do that; if not, jt is known but for jn.

    For an approach this has exactly one answer, whatever mu is, if one of the bodies can be
    moved. A solver that treats un and ut in turn finds a sliding one only if mu abs(knt) < knn.

    With e > 0 and mu > 0 the answer can have more kinetic energy than there was: that is a fault
    of Newton's rule, not of the solution.

    Parameters
    ----------
    a, b : Struck
        The bodies; at least one inverse mass must be > 0.
    normal : array_like, shape (2,)
        Unit normal from A to B.
    restitution : float
        e, 0 to 1.
    friction : float
        mu, >= 0.

    Returns
    -------
    Impact
        Kind, impulses, and both bodies' velocities after.

    Raises
    ------
    ValueError
        A number is not finite, an inverse is negative, neither body can be moved, the normal is
        not unit, the restitution lies outside [0, 1] or the friction is negative.

    References
    ----------
    Brach, Mechanical Impact Dynamics (1991): the planar impact of rigid bodies.
    Stronge, Impact Mechanics (2000): why Newton's rule may gain energy, and what to use instead.

    Examples
    --------
    A rod of 1 kg and 2 m (I = 1/3) lies along x and falls at 1 m/s; its right end meets the floor:

    >>> floor = Struck(0.0, 0.0, velocity=(0, 0), angular_velocity=0.0, arm=(0, 0))
    >>> rod = Struck(1.0, 3.0, velocity=(0, -1), angular_velocity=0.0, arm=(1, 0))
    >>> impact = impact_with_friction(floor, rod, normal=(0, 1), restitution=1.0, friction=0.5)
    >>> impact.kind, impact.normal_impulse, impact.velocities[1], impact.angular_velocities
    ('sticks', 0.5, array([ 0. , -0.5]), array([0. , 1.5]))
    """
    bodies = _movable(a, b)
    e, mu = _coefficients(restitution, friction)
    frame = _frame(normal)
    before = frame @ _relative_velocity(*bodies)
    if before[0] >= 0:
        return _after(bodies, frame, "parts", np.zeros(2))
    k = _response(bodies, frame)
    wanted = np.array([-(1 + e) * before[0], -before[1]])
    sticking = np.linalg.solve(k, wanted)
    if abs(sticking[1]) <= mu * sticking[0]:
        return _after(bodies, frame, "sticks", sticking)
    return _after(bodies, frame, "slides", _sliding(k, wanted, sticking, mu))


def disc_impact(
    a: Struck, b: Struck, normal: Vector, restitution: float, friction: float
) -> Impact:
    """Return the impact of two bodies whose contact lies in line with their centres.

    jn = -(1 + e) un / knn,   jt = -ut / ktt, but no larger than mu jn either way
    knn = 1/m_a + 1/m_b,   ktt = knn + r_a^2/I_a + r_b^2/I_b

    This covers two discs, and a disc on any surface that cannot turn: the arms lie along the
    normal, knt is 0, and normal and tangent are independent.

    Parameters
    ----------
    a, b, normal, restitution, friction
        As for :func:`impact_with_friction`; the arm of a body that can turn must lie along the
        normal.

    Returns
    -------
    Impact
        Kind, impulses, and both bodies' velocities after.

    Raises
    ------
    ValueError
        As for :func:`impact_with_friction`, or an arm does not lie along the normal.

    References
    ----------
    Brach, Mechanical Impact Dynamics (1991): the planar impact of rigid bodies.

    Examples
    --------
    Two discs of 2 kg and 1 m (I = 1); the first comes obliquely, and friction holds them:

    >>> a = Struck(0.5, 1.0, velocity=(2, 3), angular_velocity=0.0, arm=(1, 0))
    >>> b = Struck(0.5, 1.0, velocity=(0, 0), angular_velocity=0.0, arm=(-1, 0))
    >>> impact = disc_impact(a, b, normal=(1, 0), restitution=0.5, friction=1.0)
    >>> impact.kind, impact.normal_impulse, impact.tangent_impulse, impact.angular_velocities
    ('sticks', 3.0, 1.0, array([-1., -1.]))
    """
    bodies = _movable(a, b)
    e, mu = _coefficients(restitution, friction)
    frame = _frame(normal)
    un, ut = frame @ _relative_velocity(*bodies)
    knn = bodies[0].inverse_mass + bodies[1].inverse_mass
    ktt = knn + _turning("a", bodies[0], frame[0]) + _turning("b", bodies[1], frame[0])
    if un >= 0:
        return _after(bodies, frame, "parts", np.zeros(2))
    jn, stopping = -(1 + e) * un / knn, -ut / ktt
    jt = min(max(stopping, -mu * jn), mu * jn)
    return _after(bodies, frame, "sticks" if jt == stopping else "slides", np.array([jn, jt]))


def _sliding(k: Any, wanted: Any, sticking: Any, mu: float) -> Any:
    """Return the impulses at that edge of Coulomb's cone at which friction opposes ut'.

    It is the edge beyond which sticking would lie. At an edge where knn +- mu knt <= 0, a push
    with its friction would not stop the approach; then it is the other one.
    """
    forwards = sticking[1] > mu * sticking[0] and k[0, 0] + mu * k[0, 1] > 0
    edge = np.array([1.0, mu if forwards else -mu])
    return wanted[0] / (k[0] @ edge) * edge


def _response(bodies: tuple[Struck, Struck], frame: Any) -> Any:
    """Return [[knn, knt], [knt, ktt]]: what an impulse of 1 along n, and along t, changes."""
    a, b = (body._replace(velocity=np.zeros(2), angular_velocity=0.0) for body in bodies)
    changes = [_relative_velocity(_pushed(a, -along), _pushed(b, along)) for along in frame]
    return frame @ np.stack(changes, axis=-1)


def _after(bodies: tuple[Struck, Struck], frame: Any, kind: str, impulse: Any) -> Impact:
    """Return the impact in which B receives the impulse (jn, jt), and A the opposite one."""
    j = impulse @ frame
    a, b = _pushed(bodies[0], -j), _pushed(bodies[1], j)
    velocities = np.array([a.velocity, b.velocity])
    spins = np.array([a.angular_velocity, b.angular_velocity])
    return Impact(kind, float(impulse[0]), float(impulse[1]), velocities, spins)


def _pushed(body: Struck, j: Any) -> Struck:
    """Return the body as it moves after an impulse j, in N s, at its touching point."""
    torque = body.arm[0] * j[1] - body.arm[1] * j[0]
    return body._replace(
        velocity=body.velocity + body.inverse_mass * j,
        angular_velocity=body.angular_velocity + body.inverse_inertia * torque,
    )


def _relative_velocity(a: Struck, b: Struck) -> Any:
    """Return the velocity of B's touching point less that of A's, m/s, shape (2,)."""
    on_a, on_b = (
        body.velocity + body.angular_velocity * np.array([-body.arm[1], body.arm[0]])
        for body in (a, b)
    )
    return on_b - on_a


def _frame(normal: Vector) -> Any:
    """Return the checked unit normal and the tangent, as the rows of an array."""
    n = one_vector("normal", unit_vector("normal", normal))
    return np.array([n, (-n[1], n[0])])


def _coefficients(restitution: float, friction: float) -> tuple[float, float]:
    """Return checked e and mu."""
    e = one_number("restitution", restitution, unit_interval)
    return e, one_number("friction", friction, non_negative)


def _turning(name: str, body: Struck, normal: Any) -> float:
    """Return r^2/I of a body, or raise an error if its arm does not lie along the normal."""
    along = float(body.arm @ normal)
    if body.inverse_inertia > 0 and np.hypot(*(body.arm - along * normal)) > ALONG * abs(along):
        raise ValueError(f"{name}.arm must lie along the normal, got {body.arm}")
    return along**2 * body.inverse_inertia


def _movable(a: Struck, b: Struck) -> tuple[Struck, Struck]:
    """Return both bodies with checked numbers, or raise an error that names what is wrong."""
    bodies = _checked("a", a), _checked("b", b)
    if bodies[0].inverse_mass + bodies[1].inverse_mass == 0:
        raise ValueError("a and b must not both have the inverse mass 0: one of them has to yield")
    return bodies


def _checked(name: str, body: Struck) -> Struck:
    """Return a body with checked numbers, its vectors as arrays."""
    return Struck(
        one_number(f"{name}.inverse_mass", body.inverse_mass, non_negative),
        one_number(f"{name}.inverse_inertia", body.inverse_inertia, non_negative),
        one_vector(f"{name}.velocity", body.velocity),
        one_number(f"{name}.angular_velocity", body.angular_velocity),
        one_vector(f"{name}.arm", body.arm),
    )
