# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 03: reflection
#
# Three functions to write, twelve points. Read notebook [03](../notebooks/03_reflection.ipynb)
# first. After it comes the billiard table, in `exercises/billiards.py`.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own. Formulas from `lesson_code` do not count:
#   imports of it are left out when your work is graded.
# - `workbook grade exercises/03_reflection.ipynb` marks the whole file.
#
# Positions, velocities and normals are NumPy arrays of two numbers. A normal has length 1 and
# points inward: from the wall to the ball. You may return an array, a list or a tuple.

# %%
import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 3.1 The mirror (4 points)
#
# Return the mirror image R of the incoming velocity at a wall.


# %% tags=["task"]
def reflect(incident, normal):
    """Return the mirror image of `incident` at a wall with unit normal `normal`."""
    return incident - 2 * np.dot(incident, normal) * normal


# %% tags=["check", "nbval-check-output"]
check_task("3.1", reflect)

# %% [markdown] tags=["solution"]
# **Why.** The normal part (I . N) N is removed twice: once to stop it, once to send it back.

# %% [markdown]
# ## Task 3.2 The bounce (4 points)
#
# Return the velocity after a bounce with restitution. The wall is smooth: it leaves the part
# along the wall alone. A ball that is already leaving keeps its velocity.


# %% tags=["task"]
def bounce(velocity, normal, restitution):
    """Return the velocity after a bounce off a smooth wall."""
    v_n = np.dot(velocity, normal)
    if v_n >= 0:
        return velocity
    return velocity - (1 + restitution) * v_n * normal


# %% tags=["check", "nbval-check-output"]
check_task("3.2", bounce)

# %% [markdown] tags=["solution"]
# **Why.** Only the normal part changes, from v_n to -e v_n: that is a change of -(1 + e) v_n. The
# gate v_n < 0 comes first.

# %% [markdown]
# ## Task 3.3 Separate first (4 points)
#
# The ball was found inside a wall, by a depth. Return the pair (position, velocity) after it was
# moved out and, if it was coming in, bounced.


# %% tags=["task"]
def resolve_wall(position, velocity, normal, depth, restitution):
    """Return (position, velocity) of a ball that overlaps a wall by `depth`."""
    return position + depth * normal, bounce(velocity, normal, restitution)


# %% tags=["check", "nbval-check-output"]
check_task("3.3", resolve_wall)

# %% [markdown] tags=["solution"]
# **Why.** The ball is put back whichever way it moves. Its velocity changes only behind the gate.
