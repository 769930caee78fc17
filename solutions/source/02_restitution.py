# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 02: restitution
#
# Four functions to write, thirteen points. Read notebook [02](../notebooks/02_restitution.ipynb)
# first.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own. Formulas from `lesson_code` do not count:
#   imports of it are left out when your work is graded.
# - `workbook grade exercises/02_restitution.ipynb` marks the whole file.
#
# Masses are in kg, velocities in m/s and positive to the right, heights in m, times in s. A
# restitution lies between 0 and 1.

# %%
from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 2.1 Measure a restitution (3 points)
#
# Four velocities were measured, before and after a collision, with v1 > v2 before it. Return the
# restitution they show.


# %% tags=["task"]
def restitution_1d(v1, v2, v1_after, v2_after):
    """Return e: speed of separation over speed of approach."""
    return (v2_after - v1_after) / (v1 - v2)


# %% tags=["check", "nbval-check-output"]
check_task("2.1", restitution_1d)

# %% [markdown] tags=["solution"]
# **Why.** Before, body 1 is the faster one: the approach is v1 - v2. After, body 2 is: the
# separation is v2' - v1'.

# %% [markdown]
# ## Task 2.2 A collision with restitution (4 points)
#
# Return both velocities after a collision with restitution e. Your function must be right for e =
# 0 and e = 1 too.


# %% tags=["task"]
def collide_1d(m1, v1, m2, v2, restitution):
    """Return (v1', v2') after a collision with the given restitution."""
    v_centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v_centre - restitution * (v1 - v_centre), v_centre - restitution * (v2 - v_centre)


# %% tags=["check", "nbval-check-output"]
check_task("2.2", collide_1d)

# %% [markdown] tags=["solution"]
# **Why.** Seen from the centre of mass, each velocity is turned round and multiplied by e.

# %% [markdown]
# ## Task 2.3 Heights of a bouncing ball (3 points)
#
# A ball is dropped from a height. Return a list of the heights it reaches after its 1st, 2nd, ...
# bounce, `count` of them.


# %% tags=["task"]
def bounce_heights(height, restitution, count):
    """Return the heights, m, after each of the first `count` bounces."""
    return [height * restitution ** (2 * n) for n in range(1, count + 1)]


# %% tags=["check", "nbval-check-output"]
check_task("2.3", bounce_heights)

# %% [markdown] tags=["solution"]
# **Why.** The speed comes back by the factor e, and the height a ball reaches grows with the
# square of its speed.

# %% [markdown]
# ## Task 2.4 The end of the bouncing (3 points)
#
# A ball is dropped from a height onto a floor, with restitution e < 1. Return the time from the
# drop until it lies still.


# %% tags=["task"]
def rest_time(height, restitution, gravity):
    """Return the time, s, after which a dropped ball is at rest; gravity in m/s^2."""
    first_fall = (2 * height / gravity) ** 0.5
    return first_fall * (1 + restitution) / (1 - restitution)


# %% tags=["check", "nbval-check-output"]
check_task("2.4", rest_time)

# %% [markdown] tags=["solution"]
# **Why.** One fall, and then flights up and down that each last e times as long as the one
# before: t0 + 2 t0 (e + e² + ...) = t0 (1 + 2 e/(1 - e)) = t0 (1 + e)/(1 - e).
