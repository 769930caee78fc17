# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 04: circles
#
# Four functions to write, seventeen points. Read notebook [04](../notebooks/04_circles.ipynb)
# first. Together the four are a small collision engine for circles.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own. Formulas from `lesson_code` do not count:
#   imports of it are left out when your work is graded.
# - `workbook grade exercises/04_circles.ipynb` marks the whole file.
#
# Positions, velocities and normals are NumPy arrays of two numbers. The normal has length 1 and
# points from circle 1 to circle 2. Masses and radii are numbers. You may return vectors as arrays,
# lists or tuples.

# %%
import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 4.1 Who touches whom (5 points)
#
# Return the pair (normal, depth) of two circles that overlap, or `None` if they do not. Circles
# that only touch do not overlap. If both have the same centre, the normal is (1, 0).


# %% tags=["task"]
def circle_contact(p1, r1, p2, r2):
    """Return (normal, depth) of two overlapping circles, normal from 1 to 2; else None."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, r1 + r2 - distance


# %% tags=["check", "nbval-check-output"]
check_task("4.1", circle_contact)

# %% [markdown] tags=["solution"]
# **Why.** The centres of touching circles are exactly r1 + r2 apart. The depth is what the distance
# lacks. Without a direction between the centres any normal will do, as long as it is a unit vector
# and always the same.

# %% [markdown]
# ## Task 4.2 The impulse (4 points)
#
# The circles are smooth, so they push along the normal only. Return the pair (v1', v2') of
# velocities after. Circles that already separate keep their velocities.


# %% tags=["task"]
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    """Return (v1', v2') after a hit of smooth circles along `normal`, which points from 1 to 2."""
    vn = np.dot(v2 - v1, normal)
    if vn >= 0:
        return v1, v2
    impulse = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - impulse / m1 * normal, v2 + impulse / m2 * normal


# %% tags=["check", "nbval-check-output"]
check_task("4.2", resolve_circles)

# %% [markdown] tags=["solution"]
# **Why.** An impulse J changes the relative velocity along the normal by J (1/m1 + 1/m2). It has to
# go from vn to -e vn. The velocities across the normal are not touched at all.

# %% [markdown]
# ## Task 4.3 The way apart (4 points)
#
# Two circles overlap by a depth. Move them apart along the normal until they just touch, and return
# the pair (p1', p2') of their new positions. The lighter one moves further: the ways are
# in inverse proportion to the masses. A mass may be `math.inf`; that circle is fixed and does not
# move. (In Python, `1 / math.inf` is 0.0.) The two are never both fixed.


# %% tags=["task"]
def separate(p1, m1, p2, m2, normal, depth):
    """Return (p1', p2') after two overlapping circles were moved apart by `depth` in all."""
    push = depth / (1 / m1 + 1 / m2) * normal
    return p1 - push / m1, p2 + push / m2


# %% tags=["check", "nbval-check-output"]
check_task("4.3", separate)

# %% [markdown] tags=["solution"]
# **Why.** It is the formula of the impulse, with the depth in place of the change of velocity. So
# the centre of mass stays where it is.

# %% [markdown]
# ## Task 4.4 Separate first (4 points)
#
# Two circles were found to overlap. Return the four vectors (p1', v1', p2', v2') after they were
# moved apart and, if they approached, bounced. One of the masses may be `math.inf`; that circle is
# at rest. You may call your functions of tasks 4.2 and 4.3.


# %% tags=["task"]
def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    """Return (p1', v1', p2', v2') of two circles that overlap by `depth`."""
    p1, p2 = separate(p1, m1, p2, m2, normal, depth)
    v1, v2 = resolve_circles(v1, m1, v2, m2, normal, restitution)
    return p1, v1, p2, v2


# %% tags=["check", "nbval-check-output"]
check_task("4.4", resolve_overlap)

# %% [markdown] tags=["solution"]
# **Why.** Two questions, two answers. Do they overlap? Then they are moved apart. Do they also
# approach? Then they bounce. The gate belongs to the second question alone.
