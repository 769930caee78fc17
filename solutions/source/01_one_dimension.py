# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 01: one dimension
#
# Three functions to write, ten points. Read notebook [01](../notebooks/01_one_dimension.ipynb)
# first.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own. Formulas from `lesson_code` do not count:
#   imports of it are left out when your work is graded.
# - `workbook grade exercises/01_one_dimension.ipynb` marks the whole file.
#
# Masses are in kg and greater than zero, velocities in m/s and positive to the right. Body 1
# comes from the left.

# %%
from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 1.1 An elastic collision (4 points)
#
# No energy is lost. Return both velocities after the collision, of any two bodies.


# %% tags=["task"]
def elastic_1d(m1, v1, m2, v2):
    """Return (v1', v2') after an elastic collision of m1 at v1 with m2 at v2."""
    v_centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v_centre - v1, 2 * v_centre - v2


# %% tags=["check", "nbval-check-output"]
check_task("1.1", elastic_1d)

# %% [markdown] tags=["solution"]
# **Why.** Seen from the centre of mass, each velocity is turned round: v' - V = -(v - V). The
# textbook form, with (m1 - m2) v1 + 2 m2 v2 above m1 + m2, is the same thing written out.

# %% [markdown]
# ## Task 1.2 A perfectly inelastic collision (3 points)
#
# The bodies stick together. Return their common velocity twice, as the pair (v1', v2').


# %% tags=["task"]
def inelastic_1d(m1, v1, m2, v2):
    """Return (v1', v2') of two bodies that stick together: the same number twice."""
    v_centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v_centre, v_centre


# %% tags=["check", "nbval-check-output"]
check_task("1.2", inelastic_1d)

# %% [markdown] tags=["solution"]
# **Why.** The total momentum m1 v1 + m2 v2 is now carried by the total mass m1 + m2.

# %% [markdown]
# ## Task 1.3 The impulse of an elastic collision (3 points)
#
# Return the impulse J that body 2 receives, in N s. Body 2 goes from momentum m2 v2 to m2 v2 + J.
# Body 1 receives -J.


# %% tags=["task"]
def elastic_impulse_1d(m1, v1, m2, v2):
    """Return the impulse, N s, that body 2 receives in an elastic collision."""
    return 2 * (v1 - v2) / (1 / m1 + 1 / m2)


# %% tags=["check", "nbval-check-output"]
check_task("1.3", elastic_impulse_1d)

# %% [markdown] tags=["solution"]
# **Why.** An impulse J changes the approach v1 - v2 by J (1/m1 + 1/m2): each body yields by J/m.
# To turn the approach into an equally fast separation, it has to change by twice its own size.
