# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 10: only what the scene needs
#
# Five functions to write, twenty points. Read notebook
# [10](../notebooks/10_only_what_the_scene_needs.ipynb) first. Each function is a rule: it looks at
# a scene, before anything moves, and says what may be left out.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/10_only_what_the_scene_needs.ipynb` marks the whole file.
#
# All is in SI units. Vectors and tables are NumPy arrays. A body whose inverse mass is 0 is
# static: nothing can push or turn it.

# %%
import math
from itertools import combinations

import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# ## Task 10.1 The rule for friction (3 points)
#
# `inverse_masses` and `frictions` name the bodies of a scene. The coefficient of a pair is the
# geometric mean of its two: the square root of their product. Two static bodies never meet; all
# other pairs may. Return the largest coefficient of any pair that may meet, and 0.0 if there is no
# such pair. If it is 0, friction can be left out.


# %% tags=["task"]
def most_friction(inverse_masses, frictions):
    """Return the largest friction coefficient of any pair that may meet."""
    found = [0.0]
    for a, b in combinations(range(len(frictions)), 2):
        if inverse_masses[a] > 0 or inverse_masses[b] > 0:
            found.append(math.sqrt(frictions[a] * frictions[b]))
    return max(found)


# %% tags=["check", "nbval-check-output"]
check_task("10.1", most_friction)

# %% [markdown] tags=["solution"]
# **Why.** One rough body is not enough: with a smooth partner its pair has mu = 0. And a body is
# no pair with itself, nor is a floor with another floor. Each of these errors would call for
# friction where there is none. That costs time, and changes nothing. The other way round, a pair
# that is forgotten, would make the result wrong.

# %% [markdown]
# ## Task 10.2 The plan of a scene (5 points)
#
# Each row of `bodies` is a body: its inverse mass, its number of corners (0 for a disc), its e, its
# mu, and its angular velocity at the start. Any two bodies may meet, but for two static ones; there
# are two or more, and not all are static. `gravity` is a vector. Return a list with the names of
# the effects that the scene calls for, out of "friction", "gravity", "restitution" and "rotation",
# in any order.
#
# - A pair's e is the smaller of its two; its mu is the geometric mean.
# - A disc that nothing rubs is pushed through its centre only.
# - What spins at the start calls for rotation, even a smooth disc or a static body.


# %% tags=["task"]
def effects_called_for(bodies, gravity):
    """Return the names of the effects that a scene calls for."""
    pairs = [(a, b) for a, b in combinations(bodies, 2) if a[0] > 0 or b[0] > 0]
    rubs = any(a[3] * b[3] > 0 for a, b in pairs)
    bounces = any(min(a[2], b[2]) > 0 for a, b in pairs)
    turns = rubs or any(body[4] != 0 or (body[0] > 0 and body[1] > 0) for body in bodies)
    needed = {
        "friction": rubs,
        "gravity": np.any(gravity != 0),
        "restitution": bounces,
        "rotation": turns,
    }
    return [name for name in needed if needed[name]]


# %% tags=["check", "nbval-check-output"]
check_task("10.2", effects_called_for)

# %% [markdown] tags=["solution"]
# **Why.** Rotation is the rule with three parts. What turns goes on turning, a static body too.
# What has corners may be hit beside its centre. And a disc needs friction: without it every
# impulse goes through its centre. So one effect can call for another one.

# %% [markdown]
# ## Task 10.3 How far in a step? (4 points)
#
# Smooth discs fly between fixed walls, without gravity, and hit each other and the walls. No
# impact makes energy; the walls can take up momentum. `masses` are the discs' masses, `velocities`
# has a row for each. Return the largest way that any disc can ever move within a step of `dt`,
# whatever the impacts will be.


# %% tags=["task"]
def fastest_way(masses, velocities, dt):
    """Return the largest way, m, that any disc can ever move in a step."""
    twice_energy = np.sum(masses * np.sum(velocities**2, axis=1))
    return math.sqrt(twice_energy / min(masses)) * dt


# %% tags=["check", "nbval-check-output"]
check_task("10.3", fastest_way)

# %% [markdown] tags=["solution"]
# **Why.** At worst one body gets all the energy, and the lightest is fastest with it: v = sqrt(2
# E/m). If that is less than half of its width in a step, nobody can jump through anything, and
# nobody has to be watched. The speeds at the start say nothing of the kind: a light ball at rest
# leaves a heavy one with twice its speed.

# %% [markdown]
# ## Task 10.4 The box of a flight (4 points)
#
# A disc flies freely for the time `duration`: $x + v t + g t^2/2$. Return left, right, low and
# high of the smallest box that holds all of the disc all of the time. `gravity` is a vector; each
# of its parts may be 0.
#
# Two discs whose boxes share no point cannot meet in that time.


# %% tags=["task"]
def box_of_flight(position, velocity, radius, gravity, duration):
    """Return (left, right, low, high) of the smallest box around a disc's flight."""
    sides = []
    for x, v, g in zip(position, velocity, gravity, strict=True):
        times = [0, duration]
        if g != 0 and 0 < -v / g < duration:
            times.append(-v / g)
        places = [x + v * t + g * t**2 / 2 for t in times]
        sides += [min(places) - radius, max(places) + radius]
    return sides


# %% tags=["check", "nbval-check-output"]
check_task("10.4", box_of_flight)

# %% [markdown] tags=["solution"]
# **Why.** Along each axis the flight is a parabola or a straight line. Its extremes are at the
# start, at the end, or where the velocity v + g t is 0, if that is in between. Boxes that share a
# point prove nothing: the discs may be there at different times. The rule errs on the safe side.

# %% [markdown]
# ## Task 10.5 Who may sleep? (4 points)
#
# `still[n]` is 1 if body n has not moved for long enough. `touches[a, b]` and `touches[b, a]` are 1
# if the bodies a and b touch; none touches itself. Bodies that can be pushed and touch form an
# *island*, and so do all that lead from one to the next; static bodies join nothing. An island
# sleeps if all of its bodies are still. Return the numbers of the bodies that sleep, in any order.
# Static bodies are none of them.


# %% tags=["task"]
def bodies_asleep(inverse_masses, still, touches):
    """Return the numbers of the bodies whose whole island is still."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    spreading = [n for n in free if not still[n]]
    awake = set(spreading)
    while spreading:
        n = spreading.pop()
        reached = [k for k in free if touches[n, k] and k not in awake]
        awake.update(reached)
        spreading += reached
    return [n for n in free if n not in awake]


# %% tags=["check", "nbval-check-output"]
check_task("10.5", bodies_asleep)

# %% [markdown] tags=["solution"]
# **Why.** A push goes from body to body through contacts, so unrest spreads through a whole
# island. It ends at a static body, which carries no push on. If the floor joined its piles, one
# trembling box would keep a whole city awake.
