# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 11: the small engine
#
# Six functions to write, twenty-two points. Read notebook
# [11](../notebooks/11_the_small_engine.ipynb) first. The first three join the functions of the
# earlier exercises: who is near, a hit of any two bodies, and a whole step. The last three are what
# a player notices: an event, a light and a sound. Notebook 11 reads this file, and runs its engine
# with what you have written here and in the exercises before.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/11_the_small_engine.ipynb` marks the whole file.
#
# All is in SI units, y grows upwards, and angles are counter-clockwise. Vectors and tables are
# NumPy arrays.

# %%
from itertools import combinations

import numpy as np

from lesson_code.course.grading import check_task


def cross(a, b):
    """Return the cross product of two vectors in the plane: a number."""
    return a[0] * b[1] - a[1] * b[0]


# %% [markdown]
# ## Task 11.1 Who is near? (3 points)
#
# Each row of `boxes` is a box around a body: left, right, low, high. Return the pairs (i, j), i <
# j, of those that share a point, as a list in any order. Any number of boxes may come.


# %% tags=["task"]
def near_pairs(boxes):
    """Return the pairs (i, j), i < j, of boxes that share a point."""
    found = []
    for i, j in combinations(range(len(boxes)), 2):
        (left, right, low, high), (other_left, other_right, other_low, other_high) = boxes[[i, j]]
        along_x = left <= other_right and other_left <= right
        along_y = low <= other_high and other_low <= high
        if along_x and along_y:
            found.append((i, j))
    return found


# %% tags=["check", "nbval-check-output"]
check_task("11.1", near_pairs)

# %% [markdown] tags=["solution"]
# **Why.** It is the separating axis test of chapter 06, with the axes x and y alone: two intervals
# overlap if each begins before the other one ends. Do not look for corners inside the other box:
# two planks that make a cross have none. This compares all pairs, N (N - 1)/2 of them. If the boxes
# are sorted by their left sides, each need only be compared with those that have not ended yet.

# %% [markdown]
# ## Task 11.2 A hit of any two bodies (5 points)
#
# The bodies `a` and `b` are arrays of five numbers: mass, moment of inertia, vx, vy, angular
# velocity. They touch at a point; `arm_a` and `arm_b` lead to it from their centres of mass, and
# `normal` is the unit normal there, from a to b. Return their velocities and angular velocities
# after the hit: (v_a, w_a, v_b, w_b). A wall's mass and moment of inertia are `math.inf`.
#
# - First an impulse along the normal lets them part at `restitution` times the approach. Bodies
#   that part already are left alone.
# - Then friction acts on the sliding that there is *after* that, and stops it as far as mu times
#   the normal impulse can. The tangent is the normal, turned by +90 degrees.


# %% tags=["task"]
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    """Return (v_a, w_a, v_b, w_b) after a hit with spin and friction."""
    (m_a, i_a, *v_a, w_a), (m_b, i_b, *v_b, w_b) = a, b
    low, high = 0, np.inf
    for n, e in ((normal, restitution), (np.array([-normal[1], normal[0]]), 0)):
        x_a, x_b = cross(arm_a, n), cross(arm_b, n)
        u = np.dot(v_b, n) + w_b * x_b - np.dot(v_a, n) - w_a * x_a
        m_eff = 1 / (1 / m_a + 1 / m_b + x_a**2 / i_a + x_b**2 / i_b)
        j = np.clip(-(1 + e) * u * m_eff, low, high)
        low, high = -friction * j, friction * j
        v_a, w_a = v_a - j / m_a * n, w_a - j / i_a * x_a
        v_b, w_b = v_b + j / m_b * n, w_b + j / i_b * x_b
    return v_a, w_a, v_b, w_b


# %% tags=["check", "nbval-check-output"]
check_task("11.2", hit)

# %% [markdown] tags=["solution"]
# **Why.** The velocity of a contact point along n is v . n + w (r x n): task 5.2, seen along one
# direction. Normal impulse and friction differ only in the direction, the e and the clamp, so one
# loop does both. Chapters 01 to 05 are all in it: set both levers and mu to 0, and it is
# `collide_1d`; give a an infinite mass, and it is `bounce`.

# %% [markdown]
# ## Task 11.3 A whole step (4 points)
#
# Smooth discs move in a room with the sides `room`, its lower left corner at the origin. Return
# (positions, velocities) after a step of `dt`, in this order:
#
# 1. every disc moves by the velocity it has, and then gravity changes the velocity;
# 2. each pair i < j, in the order (0, 1), (0, 2), ..., (1, 2), ..., that overlaps where the pairs
#    before have left it: if the two approach, they bounce with `restitution`, as smooth discs do;
#    and they are moved apart along the normal, the lighter one farther, until they touch;
# 3. each disc that is beyond a wall is put back to touch it; if it moves outwards, that part of
#    its velocity is turned round and multiplied by `restitution`.
#
# No two discs have the same centre.


# %% tags=["task"]
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    """Return (positions, velocities) of smooth discs in a room after a step."""
    p, v = positions + velocities * dt, velocities + gravity * dt
    for i, j in combinations(range(len(p)), 2):
        distance = np.hypot(*(p[j] - p[i]))
        depth = radii[i] + radii[j] - distance
        if depth > 0:
            n, m_eff = (p[j] - p[i]) / distance, 1 / (1 / masses[i] + 1 / masses[j])
            jn = max(-(1 + restitution) * m_eff * np.dot(v[j] - v[i], n), 0)
            for body, push in ((i, -n / masses[i]), (j, n / masses[j])):
                p[body] += depth * m_eff * push
                v[body] += jn * push
    inside = np.clip(p, radii[:, None], room - radii[:, None])
    v = np.where((p - inside) * v > 0, -restitution * v, v)
    return inside, v


# %% tags=["check", "nbval-check-output"]
check_task("11.3", step_discs)

# %% [markdown] tags=["solution"]
# **Why.** Each gate and each share avoids a fault of an earlier chapter: a pair that parts is not
# hit, the wall does not catch a disc that comes back, the heavy disc hardly gives way. The order
# matters, too. Walls come last, so that no pair pushes a disc out of the room.
#
# Now call it six hundred times, and draw the discs. It is an engine.

# %% [markdown]
# ## Task 11.4 Who began to touch? (3 points)
#
# A game wants to know when a ball *begins* to touch the goal, not that it still does. `before` and
# `now` are the pairs of numbers (i, j), i < j, that touched in the last step and that touch in this
# one. Return two lists of pairs: those that have begun to touch, and those that have parted. Any
# order will do. Either table may be empty: `np.array([])`.


# %% tags=["task"]
def touch_changes(before, now):
    """Return (begun, parted): pairs that touch now and not before, and the reverse."""
    earlier, later = {tuple(pair) for pair in before}, {tuple(pair) for pair in now}
    return list(later - earlier), list(earlier - later)


# %% tags=["check", "nbval-check-output"]
check_task("11.4", touch_changes)

# %% [markdown] tags=["solution"]
# **Why.** A callback belongs to a pair, not to a body: the ball that lies on the floor can still
# begin to touch the goal. A pair in both sets goes on touching, which is no news.

# %% [markdown]
# ## Task 11.5 A light that fades (3 points)
#
# Each body has a brightness between 0 and 1. A body that was `hit` in this step (1, and not 0)
# shines at 1. Any other fades: when a `half_life` has passed, half of its light is left. That must
# not depend on how long the steps `dt` are. Return the brightness of all bodies after the step.


# %% tags=["task"]
def glow(brightness, hit, dt, half_life):
    """Return the brightness of all bodies after a step of `dt`."""
    return np.where(hit, 1.0, brightness * 0.5 ** (dt / half_life))


# %% tags=["check", "nbval-check-output"]
check_task("11.5", glow)

# %% [markdown] tags=["solution"]
# **Why.** Two steps of dt leave the same as one of 2 dt, since the factors multiply and the
# exponents add up. No other rule does that: a fixed amount or a fixed factor for each step makes
# the light last longer on a slow computer.

# %% [markdown]
# ## Task 11.6 The sound of an impact (4 points)
#
# A struck body rings and dies away. Return `count` samples of its sound, `rate` of them in a
# second; the first is at time 0. At time t the sound is `loudness` times sin(2 pi f t), where f is
# the `frequency`, and it has halved after each `half_life`. Samples cannot tell a tone of half the
# rate or more from a lower one. Such a tone is silent: return zeros.


# %% tags=["task"]
def knock(loudness, frequency, half_life, rate, count):
    """Return samples of a tone that dies away, shape (count,)."""
    t = np.arange(count) / rate
    tone = np.sin(2 * np.pi * frequency * t) * (frequency < rate / 2)
    return loudness * 0.5 ** (t / half_life) * tone


# %% tags=["check", "nbval-check-output"]
check_task("11.6", knock)

# %% [markdown] tags=["solution"]
# **Why.** The sine begins at 0, as the body does before the blow; a cosine would begin with a jump,
# and a jump is heard as a click. Above half of the rate there is less than one sample for each
# swing up or down, and a lower tone goes through the very same samples. It is called aliasing.
