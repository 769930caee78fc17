"""Right answers, each written in an unusual way: hard cases."""


def tower_forces(masses, gravity):
    """Each box is at rest: the force from below less that from above is its weight."""
    import numpy as np
    count = len(masses)
    balance = np.eye(count) - np.eye(count, k=1)
    return np.linalg.solve(balance, np.asarray(masses) * gravity)


def sweeps_needed(light, heavy, left):
    """With more digits the school's logarithm is good enough."""
    from decimal import ROUND_CEILING, Decimal, localcontext
    with localcontext() as context:
        context.prec = 40
        part = Decimal(heavy) / (Decimal(heavy) + Decimal(light))
        return (Decimal(left).ln() / part.ln()).to_integral_value(ROUND_CEILING)


def sliding_impulse(vn, vt, knn, knt, friction):
    """Seen from the other side a slide to the left is one to the right."""
    if vt < 0:
        vt, knt = (-vt, -knt)
    if vn < 0 and friction * knt >= knn:
        return None
    return max(-vn, 0.0) / (knn - friction * knt) if vn < 0 else 0


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    """A vector is a complex number, and a torque the imaginary part of a product."""
    v, r, j = (complex(*velocity), complex(*arm), complex(*impulse))
    energies = [mass * abs(v + s * j / mass) ** 2 + inertia * (w + s * (r.conjugate() * j).imag / inertia) ** 2 for s in (0, 1)]
    return energies[1] / energies[0]


def one_by_one(masses, velocities):
    """In the space of all velocities a strike is a mirror: its normal is the pair's."""
    import numpy as np
    pairs = np.diff(np.eye(len(masses)), axis=0)
    v = np.array(velocities, dtype=float)
    while np.min(pairs @ v) < -1e-09:
        g = pairs[np.argmin(pairs @ v)]
        v = v - 2 * (g @ v) / (g @ (g / masses)) * (g / masses)
    return v
