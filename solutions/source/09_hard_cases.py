# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 09: hard cases
#
# Five functions to write, twenty points. Read notebook [09](../notebooks/09_hard_cases.ipynb)
# first. Each function answers a question that an engine has to ask.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/09_hard_cases.ipynb` marks the whole file.
#
# All is in SI units. `masses`, `velocities`, `velocity`, `arm` and `impulse` are NumPy arrays.

# %%
import math

import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 9.1 The forces in a tower (3 points)
#
# Boxes stand on each other, at rest. `masses` names them from the lowest up. Return the force in
# the contact under each box, in the same order, in N.


# %% tags=["task"]
def tower_forces(masses, gravity):
    """Return the force under each box of a tower, from the lowest up."""
    return np.array([sum(masses[n:]) * gravity for n in range(len(masses))])


# %% tags=["check", "nbval-check-output"]
check_task("9.1", tower_forces)

# %% [markdown] tags=["solution"]
# **Why.** Cut the tower below a box. All that is above the cut is at rest, so the cut carries its
# whole weight. Whatever an engine computes, this is what it has to find.

# %% [markdown]
# ## Task 9.2 How many sweeps? (4 points)
#
# A load of the mass `heavy` comes down on a box of the mass `light`, which stands on the floor.
# Each sweep of sequential impulses leaves the part M/(M + m) of the load's approach. Return the
# smallest whole number of sweeps after which no more than the part `left` is left, 0 < left < 1.
# The load may be a billion times as heavy as the box: a loop over the sweeps takes too long then.


# %% tags=["task"]
def sweeps_needed(light, heavy, left):
    """Return the smallest number of sweeps after which a part `left` or less is left."""
    return math.ceil(-math.log(left) / math.log1p(light / heavy))


# %% tags=["check", "nbval-check-output"]
check_task("9.2", sweeps_needed)

# %% [markdown] tags=["solution"]
# **Why.** After n sweeps (M/(M + m))^n is left. The logarithm turns that into n times
# ln(M/(M + m)) = -ln(1 + m/M). For m/M = 1e-9 the number 1 + 1e-9 keeps only seven digits of the
# 1e-9; `log1p` takes 1e-9 itself and loses none.

# %% [markdown]
# ## Task 9.3 A tip that slides (5 points)
#
# The tip of a rod slides over a floor. `vn` is its velocity across the floor, negative if it
# approaches; `vt` is its velocity along the floor, and not 0. An impulse jn across the floor
# changes vn by knn jn. Friction adds an impulse jt along the floor, which changes vn by knt jt.
#
# The tip slides during the whole impact: abs(jt) = mu jn, against the sliding. Return the jn
# after which vn = 0. A tip that does not approach needs none: 0.0. If no jn > 0 does it, return
# `None`: the tip jams.


# %% tags=["task"]
def sliding_impulse(vn, vt, knn, knt, friction):
    """Return the normal impulse that stops the approach of a sliding tip, 0.0, or None."""
    if vn >= 0:
        return 0.0
    rub = -friction if vt > 0 else friction  # jt over jn
    yields = knn + rub * knt
    return -vn / yields if yields > 0 else None


# %% tags=["check", "nbval-check-output"]
check_task("9.3", sliding_impulse)

# %% [markdown] tags=["solution"]
# **Why.** With jt = -mu sign(vt) jn the tip ends with vn + (knn - mu sign(vt) knt) jn = 0. If
# friction lifts the tip, less jn is needed. If it presses the tip down, more; and if it presses
# harder than jn lifts, none is enough. That is Painleve's paradox. Then the tip cannot slide on:
# it stops.

# %% [markdown]
# ## Task 9.4 Has the blow made energy? (4 points)
#
# A body of the mass `mass` and the moment of inertia `inertia` moves with `velocity` and spins
# with `w`, counter-clockwise. It receives `impulse`, a vector, at `arm` from its centre of mass.
# Return its kinetic energy after the blow over that before it.


# %% tags=["task"]
def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    """Return the kinetic energy after a blow over the kinetic energy before it."""
    after = velocity + impulse / mass
    w_after = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    before = mass * (velocity @ velocity) + inertia * w**2
    return (mass * (after @ after) + inertia * w_after**2) / before


# %% tags=["check", "nbval-check-output"]
check_task("9.4", energy_ratio)

# %% [markdown] tags=["solution"]
# **Why.** The impulse changes the velocity by J/m, and its torque changes the spin by (r x J)/I.
# Both motions hold energy. If an impact law gives you a J for which the ratio is more than 1,
# though nothing is there that could do work, the law is wrong for that impact.

# %% [markdown]
# ## Task 9.5 One after the other (4 points)
#
# Elastic balls lie in a row, each in touch with the next. `masses` and `velocities` name them from
# left to right; a positive velocity goes to the right. They strike pair by pair: always the pair
# that approaches fastest, until no pair approaches any more. Return the velocities after all that.
#
# Slower than 1e-9 m/s is no approach.


# %% tags=["task"]
def one_by_one(masses, velocities):
    """Return the velocities of balls in a row after all their strikes."""
    v = np.array(velocities, dtype=float)
    while True:
        approach = v[:-1] - v[1:]
        k = int(np.argmax(approach))
        if approach[k] <= 1e-9:
            return v
        m1, m2 = masses[k], masses[k + 1]
        centre = (m1 * v[k] + m2 * v[k + 1]) / (m1 + m2)
        v[k], v[k + 1] = 2 * centre - v[k], 2 * centre - v[k + 1]


# %% tags=["check", "nbval-check-output"]
check_task("9.5", one_by_one)

# %% [markdown] tags=["solution"]
# **Why.** Seen from the centre of mass of a pair an elastic strike turns both velocities round.
# Equal balls just change velocities, so the strikes sort them: as many leave on one side as have
# come from the other. It is not the only answer that keeps momentum and energy. How the balls touch
# decides which one you see.
