# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 07: time of impact
#
# Five functions to write, twenty-two points. Read notebook
# [07](../notebooks/07_time_of_impact.ipynb) first. With the last two you go from one collision to
# the next, without any time step; for them read [07b](../notebooks/07b_from_event_to_event.ipynb),
# too.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/07_time_of_impact.ipynb` marks the whole file.
#
# Positions and velocities are NumPy arrays of two numbers unless a task says otherwise. Times are
# in seconds from now. 0.0 is a time: now. `None` means never.

# %%
import math

import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 7.1 When two circles meet (6 points)
#
# Two circles move with constant velocities for a step dt. Return the time of their first touch,
# or `None` if they do not meet in the step.
#
# - Circles that touch or overlap at the start and approach each other meet now: 0.0.
# - Circles that part never meet, even if they overlap at the start.
# - Two circles may have the same velocity. dt may be `math.inf`.


# %% tags=["task"]
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    """Return the time from 0 to dt at which two circles first touch, or None."""
    d, v = p2 - p1, v2 - v1
    a, b, c = np.dot(v, v), np.dot(d, v), np.dot(d, d) - (r1 + r2) ** 2
    inside = b * b - a * c
    if b >= 0 or inside < 0:
        return None
    if c <= 0:
        return 0.0
    t = c / (-b + math.sqrt(inside))
    return t if t <= dt else None


# %% tags=["check", "nbval-check-output"]
check_task("7.1", sweep_circles)

# %% [markdown] tags=["solution"]
# **Why.** At the time t the centres are d + v t apart. They touch when the length of that is the
# sum of the radii: a t^2 + 2 b t + c = 0. A negative b means that they approach. The smaller
# root, (-b - sqrt(b^2 - a c)) / a, is the first touch. Written as c / (-b + sqrt(b^2 - a c)) it
# loses no digits, and never divides by zero: b is negative here.

# %% [markdown]
# ## Task 7.2 When a ball lands (4 points)
#
# A ball is `height` metres above the floor and moves with `velocity`, positive upwards. Gravity
# pulls it down. Return the time at which it next hits the floor, or `None` if it never does.
#
# - A ball on the floor that moves up has just bounced. Its next hit is still to come. One that
#   moves down hits now. No ball lies on the floor at rest.
# - On board a spaceship gravity may be as weak as 1e-15 m/s^2, or 0. Your time must be right to
#   nine digits there too.


# %% tags=["task"]
def time_to_floor(height, velocity, gravity):
    """Return the time until a ball next hits the floor, or None if it never does."""
    impact_speed = math.sqrt(velocity**2 + 2 * gravity * height)
    if velocity < 0:
        return 2 * height / (impact_speed - velocity)
    return (velocity + impact_speed) / gravity if gravity > 0 else None


# %% tags=["check", "nbval-check-output"]
check_task("7.2", time_to_floor)

# %% [markdown] tags=["solution"]
# **Why.** From energy, the ball lands with the speed w = sqrt(v^2 + 2 g h). Gravity has changed
# its velocity from v to -w by then, so t = (v + w) / g. For a ball thrown down v is negative, and
# v + w is the difference of two nearly equal numbers. Multiplied above and below by w - v it
# becomes 2 h / (w - v), where nothing is subtracted. That also holds for g = 0.

# %% [markdown]
# ## Task 7.3 The whole step (5 points)
#
# A ball flies in a room without gravity. Its centre p can be anywhere from (0, 0) to `room`. Let
# it move for the time dt and return (p', v'). When it meets a wall, the part of its velocity
# across the wall is turned round and multiplied by `restitution`; the other part stays. Then it
# goes on with the *rest* of the step, and may meet more walls. No part of the velocity is 0.


# %% tags=["task"]
def advance(p, v, room, restitution, dt):
    """Return (p', v') of a ball in a room after a step dt, with all the impacts in it."""
    left = dt
    while True:
        times = (np.where(v > 0, room, 0.0) - p) / v
        axis = np.argmin(times)
        if times[axis] >= left:
            return p + v * left, v
        p = p + v * times[axis]
        v = np.where(np.arange(2) == axis, -restitution * v, v)
        left = left - times[axis]


# %% tags=["check", "nbval-check-output"]
check_task("7.3", advance)

# %% [markdown] tags=["solution"]
# **Why.** The wall that counts on each axis is the one the ball flies to. The nearest impact in
# time comes first. After it the question is the same again, with less time left. A ball at a wall
# that moves into it gets the time 0.0, bounces, and loses no time.

# %% [markdown]
# ## Task 7.4 The next event (4 points)
#
# Several circles move with constant velocities. `positions` and `velocities` have the shape (N,
# 2), `radii` has N numbers. Return (t, i, j): which two circles meet first, and when. Circles are
# numbered from 0, and i < j. Return `None` if no two of them ever meet. No two pairs meet first at
# the same time.


# %% tags=["task"]
def next_event(positions, velocities, radii):
    """Return (t, i, j) of the two circles that meet first, i < j, or None."""
    events = []
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            one = positions[i], velocities[i], radii[i]
            t = sweep_circles(*one, positions[j], velocities[j], radii[j], math.inf)
            if t is not None:
                events.append((t, i, j))
    return min(events, default=None)


# %% tags=["check", "nbval-check-output"]
check_task("7.4", next_event)

# %% [markdown] tags=["solution"]
# **Why.** Between two events all circles fly straight on, so nothing can be missed. `is not None`
# matters: for a pair that meets now t is 0.0, and `if t` would lose it.

# %% [markdown]
# ## Task 7.5 Two blocks and a wall (3 points)
#
# Two blocks slide on ice, in front of a wall. The inner block of 1 kg is at rest. The outer one,
# of `mass_ratio` kg, comes towards it. All collisions are elastic, those with the wall too.
# Return the number of collisions until nothing collides any more, both kinds together.
#
# You need no times and no places: the collisions of the blocks and those with the wall take
# turns.


# %% tags=["task"]
def pi_collisions(mass_ratio):
    """Return how often two blocks and a wall collide in all."""
    inner, outer, count = 0.0, -1.0, 0
    while inner > outer:
        centre = (inner + mass_ratio * outer) / (1 + mass_ratio)
        inner, outer, count = 2 * centre - inner, 2 * centre - outer, count + 1
        if inner < 0:
            inner, count = -inner, count + 1
    return count


# %% tags=["check", "nbval-check-output"]
check_task("7.5", pi_collisions)

# %% [markdown] tags=["solution"]
# **Why.** Seen from the centre of mass an elastic collision turns both velocities round: v
# becomes 2 V - v. The blocks meet again as long as the inner one is faster. For the ratios 1,
# 100, 10000 the count is 3, 31, 314. Print it for 100**5: these are the digits of pi. For a ratio
# of 2 it is 5, and pi times the square root of 2 is 4.4.
