# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 05: spin and friction
#
# Five functions to write, twenty points. Read notebook
# [05](../notebooks/05_spin_and_friction.ipynb) first. The last function puts the others to work.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own. Formulas from `lesson_code` do not count:
#   imports of it are left out when your work is graded.
# - `workbook grade exercises/05_spin_and_friction.ipynb` marks the whole file.
#
# Velocities, levers, normals and vertices are NumPy arrays; y points up, and angles and spins
# count counter-clockwise. You may return arrays, lists or tuples. `cross` is given: NumPy's own
# is for vectors in space.

# %%
import numpy as np

from lesson_code.course.grading import check_task


def cross(a, b):
    """Return a_x b_y - a_y b_x: how far b turns counter-clockwise from a."""
    return a[0] * b[1] - a[1] * b[0]


# %% [markdown]
# ## Task 5.1 The moment of inertia (4 points)
#
# Return the moment of inertia, in kg m², of a flat polygon about its own **centroid**. Its mass
# is spread evenly. `vertices` has shape (N, 2). The vertices go round in either order, the
# polygon may lie anywhere, and a vertex may be one too many, in the middle of an edge.


# %% tags=["task"]
def moment_of_inertia(mass, vertices):
    """Return the moment of inertia of a polygon about its centroid."""
    p, q = vertices, np.roll(vertices, -1, axis=0)
    weights = cross(p.T, q.T) / np.sum(cross(p.T, q.T))
    centroid = weights @ (p + q) / 3
    about_origin = weights @ np.sum(p * p + p * q + q * q, axis=1) / 6
    return mass * (about_origin - np.dot(centroid, centroid))


# %% tags=["check", "nbval-check-output"]
check_task("5.1", moment_of_inertia)

# %% [markdown] tags=["solution"]
# **Why.** Each edge makes a triangle with the origin. Its area, with a sign, is the weight. The
# signs cancel in the ratio, so either way round will do, and an extra vertex only splits one
# triangle into two. The parallel axis theorem moves the axis from the origin to the centroid.

# %% [markdown]
# ## Task 5.2 The velocity of the contact point (3 points)
#
# Return the velocity of the point at `r` from the centre of a body. The centre moves with
# velocity `v`, and the body turns with angular velocity `w`.


# %% tags=["task"]
def contact_velocity(v, w, r):
    """Return the velocity, m/s, of the point at `r` of a body that moves and turns."""
    return v + w * np.array([-r[1], r[0]])


# %% tags=["check", "nbval-check-output"]
check_task("5.2", contact_velocity)

# %% [markdown] tags=["solution"]
# **Why.** Turning carries the point along a circle: at right angles to r, with speed |w| |r|. For
# w > 0 that is r turned counter-clockwise, (-r_y, r_x).

# %% [markdown]
# ## Task 5.3 How far two bodies give way (4 points)
#
# Two bodies touch. Their masses are `m_a` and `m_b`, their moments of inertia `i_a` and `i_b`,
# and `r_a` and `r_b` lead from their centres to the contact. Return k, in 1/kg: by how much the
# relative velocity at the contact changes, along the unit vector `direction`, for each N s
# between the bodies along it. The ground has mass and moment of inertia `inf`.


# %% tags=["task"]
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    """Return k = 1 / effective mass of two bodies at their contact along `direction`."""
    arm_a, arm_b = cross(r_a, direction), cross(r_b, direction)
    return 1 / m_a + 1 / m_b + arm_a**2 / i_a + arm_b**2 / i_b


# %% tags=["check", "nbval-check-output"]
check_task("5.3", inverse_effective_mass)

# %% [markdown] tags=["solution"]
# **Why.** The lever arm counts twice: 1 N s makes an angular velocity (r x n)/I, and that makes a
# velocity of (r x n)²/I along n at the contact.

# %% [markdown]
# ## Task 5.4 Friction with Coulomb's limit (4 points)
#
# A contact slides with the relative velocity `vt`. It is pressed together by the normal impulse
# `jn`. Return the impulse of friction along the tangent, in N s. It stops the sliding if it can,
# but is never larger than `friction * jn`, either way. `k` is the k of task 5.3, along the
# tangent.


# %% tags=["task"]
def friction_impulse(vt, jn, friction, k):
    """Return the tangent impulse, N s, of dry friction."""
    limit = friction * jn
    return max(-limit, min(-vt / k, limit))


# %% tags=["check", "nbval-check-output"]
check_task("5.4", friction_impulse)

# %% [markdown] tags=["solution"]
# **Why.** An impulse j changes the sliding by k j, so -vt / k would stop it. If that is more than
# the surfaces can give, they give all they can, and the rest of the sliding stays.

# %% [markdown]
# ## Task 5.5 A spinning disc hits a wall (5 points)
#
# A solid disc of the given radius hits a rough wall. The wall's unit normal points to the disc.
# Return the pair (velocity, angular velocity) after the hit. A disc that is already leaving keeps
# both. The mass makes no difference: take 1 kg, so that the moment of inertia is radius² / 2.


# %% tags=["task"]
def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    """Return (velocity, w) of a solid disc after it has hit a rough wall."""
    lever, tangent = -radius * normal, np.array([-normal[1], normal[0]])
    v = contact_velocity(velocity, w, lever)
    if np.dot(v, normal) >= 0:
        return velocity, w
    inertia = radius**2 / 2
    ground = (np.inf, np.inf, lever)  # any lever will do
    jn = -(1 + restitution) * np.dot(v, normal)
    k = inverse_effective_mass(1, inertia, lever, *ground, tangent)
    impulse = jn * normal + friction_impulse(np.dot(v, tangent), jn, friction, k) * tangent
    return velocity + impulse, w + cross(lever, impulse) / inertia


# %% tags=["check", "nbval-check-output"]
check_task("5.5", bounce_with_spin)

# %% [markdown] tags=["solution"]
# **Why.** The normal impulse points at the centre and cannot turn the disc, so along the normal
# the disc shows its mass. Along the tangent it gives way three times as much: k = 1 + radius² /
# inertia = 3. The torque is lever cross impulse; the other way round, the slip would grow.
