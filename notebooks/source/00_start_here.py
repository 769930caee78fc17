# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 00 Start here
#
# When two pool balls meet, something is handed over. One ball slows down, the other speeds up,
# and the two changes fit each other exactly. This course is about that moment: how to find it,
# how to compute what happens in it, and how to know that the answer is right.
#
# **After this notebook you will be able to**
#
# 1. name the stages that every collision goes through in a program, in their order;
# 2. use the four vector operations that the rest of the course needs;
# 3. read a check, answer a quiz question and hand in an exercise.
#
# **You need** a little Python (functions, lists) and the idea of a vector as an arrow. **Time:**
# about 30 minutes to read, a few seconds to run.

# %%
import numpy as np

from lesson_code.course.quiz.notebook import show_quiz
from lesson_code.evidence import CheckFailedError, check
from lesson_code.formulas import reflect
from lesson_code.formulas.arithmetic import cross, dot, perpendicular
from lesson_code.view.browser.lab import lab
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import diagrams, style

# %% [markdown]
# Begin with your hands: throw one disc at the other. Drag a disc, or the tip of its velocity, and
# press Run. The engine that you will read in this course moves them. Predict first: which sum is
# the same before and after the impact?

# %%
lab()

# %% [markdown]
# ## 1 Every collision goes through one pipeline
#
# A program that moves many bodies does the same things in every time step, and always in this
# order.
#
# - **Detection** finds out who touches whom. The *broad phase* quickly throws out pairs that are
#   far apart. The *narrow phase* looks closely at the pairs that are left, and finds where they
#   touch, in which direction (the *normal*) and how deep they overlap.
# - **Resolution** decides what happens. An *impulse* is calculated from velocities and masses,
#   bodies that overlap are moved apart (*position correction*), and every velocity is updated.
# - **Post-processing** lets the rest of the program react: *callbacks*, *effects* such as a
#   flash, *sound*.
#
# Chapters 01 to 03 are about the box with the thick frame: the impulse.

# %%
fig, ax = style.figure(width=9, height=2.9)
diagrams.pipeline(ax, marked=("impulse calculation",))
show(
    fig,
    "The pipeline. Detection: broad phase, narrow phase. Then resolution: impulse calculation, "
    "position correction, velocity update. Then post-processing: callbacks, effects, sound.",
)

# %% [markdown]
# ## 2 A moving thing is a position, a velocity and a size
#
# The simplest body is a ball. To move it we keep three things: its **position**, its **velocity**
# and its **radius**. To collide it we also need its **mass**. In each small time step `dt` the
# position changes by velocity times `dt`. If that puts the ball below the floor, it has to be set
# back onto it: this is called a *floor clamp*, and chapter 03 shows why it is not enough on its
# own.

# %%
position, velocity, radius = np.array([0.0, 2.0]), np.array([1.5, -3.0]), 0.5
dt = 0.1
position = position + velocity * dt
check("one step moves the ball by v dt", position, (0.15, 1.7), tolerance=1e-12)
check("the ball is above the floor by", position[1] - radius, 1.2, tolerance=1e-12)

# %% [markdown]
# ## 3 Vectors in a page
#
# A vector has two components, x and y. In the code it is an array of two numbers. Four operations
# are enough for chapters 01 to 03.
#
# **Length.** The length of (x, y) is the square root of x² + y².
#
# **Normalise.** A vector divided by its own length has length 1. It keeps only the direction.
# Such a vector is called a *unit vector*. The zero vector has no direction and cannot be
# normalised.

# %%
v = np.array([3.0, -4.0])
length = np.hypot(v[0], v[1])
direction = v / length
check("the length of (3, -4)", length, 5.0)
check("its direction", direction, (0.6, -0.8), tolerance=1e-15)
check("the direction has length 1", np.hypot(*direction), 1.0, tolerance=1e-15)

# %% [markdown]
# **Dot product.** `dot(a, b)` is a_x b_x + a_y b_y. It answers one question that we ask all the
# time: *is b in front of a, beside it or behind it?* Positive means in front, zero means at a
# right angle, negative means behind. If `b` has length 1, the dot product is also how far `a`
# reaches along `b`.

# %%
looking = np.array([1.0, 0.0])
check("in front", dot(looking, (2.0, 1.0)) > 0, True)
check("at a right angle", dot(looking, (0.0, 1.0)), 0.0)
check("behind", dot(looking, (-2.0, 1.0)) < 0, True)

# %% [markdown]
# Drag the tip of b round the circle. The thick bar is the dot product: how far b reaches along a.
# Before you do: at which angles does the dot product change its sign? Where is it largest?

# %%
live(
    "ch00_start_here/dot_product",
    "Two unit vectors a and b, 60 degrees apart. A thick bar along a, up to below the tip of b, is "
    "their dot product, 0.5: b is in front of a. Their cross product is 0.866: b lies "
    "counter-clockwise of a. You can drag the tip of b, or set its angle.",
)

# %% [markdown]
# **Perpendicular.** `perpendicular(a)` turns `a` by a right angle, counter-clockwise: (x, y)
# becomes (-y, x). If `n` is the normal of a wall, `perpendicular(n)` runs along the wall. We call
# it the *tangent*.
#
# The **cross product** of two plane vectors is one number, a_x b_y - a_y b_x. It is positive when
# `b` lies counter-clockwise of `a`. You will need it from chapter 05 on, when bodies spin.

# %%
normal = np.array([0.6, 0.8])
tangent = perpendicular(normal)
check("the tangent of (0.6, 0.8)", tangent, (-0.8, 0.6))
check("normal and tangent are at a right angle", dot(normal, tangent), 0.0)
check("the tangent lies counter-clockwise", cross(normal, tangent), 1.0, tolerance=1e-15)

# %% [markdown]
# ## 4 Up is up, except on a screen
#
# In physics y grows upward. On a computer screen y grows *downward*: the top left corner is (0,
# 0). This course uses metres and y up everywhere. The pygame programs turn the picture over in
# one single place, just before they draw. The billiards exercise of chapter 03 is the one
# exception: it speaks pixels and y down, and says so.
#
# The mirror formula of chapter 03 does not care. A ball that falls and one that rises are both
# turned round by a level wall:

# %%
check("y up: falling at 4, floor with normal (0, 1)", reflect((3, -4), (0, 1)), (3, 4))
check("y down: falling at 4, floor with normal (0, -1)", reflect((3, 4), (0, -1)), (3, -4))

# %% [markdown]
# ## 5 A check says what was claimed, measured and expected
#
# You have seen some checks above. Each prints one line: the claim, what the code gave, what it
# should give, and how far apart the two may be. What is expected always comes from somewhere else
# than the code under test: from algebra, from a conservation law, or from *pymunk*, a physics
# engine that we did not write.
#
# A false claim stops the notebook. Here is one, caught so that you can look at it:

# %%
try:
    check("a ball keeps its speed when it slows down", measured=2.0, expected=3.0, tolerance=0.5)
except CheckFailedError as failure:
    print(failure)

# %% [markdown]
# ## 6 Break it on purpose: when zero means no
#
# Every chapter breaks something. The faults are real: they stood in a lesson on the web that this
# course grew out of.
#
# That lesson had a function that returned the *time* until two balls meet, or `None` if they
# never do. The code that used it asked `if time:`. Two balls that touch right now meet at time
# 0.0. **Predict:** what does Python make of `if 0.0`?


# %%
def is_a_hit_wrong(time):
    return bool(time)


def is_a_hit(time):
    return time is not None


for time in (0.5, None, 0.0):
    print(
        f"time {time}: `if time` says {is_a_hit_wrong(time)}, `is not None` says {is_a_hit(time)}"
    )

# %% [markdown]
# The hit at time 0.0 is lost, and the balls pass through each other. In this course "no contact"
# and "no impact" are always `None`, and code always asks `is not None`.
#
# A second trap has the same shape. `nan` ("not a number") is what a broken calculation leaves
# behind. Every comparison with it is false. So `error > tolerance` does *not* notice it. Our
# checks ask the other way round, `error <= tolerance`, and nan fails.

# %%
error = float("nan")
print("error > 1e-9  says 'wrong':", error > 1e-9)
print("error <= 1e-9 says 'right':", error <= 1e-9)

# %% [markdown]
# ## 7 How the workbook is used
#
# - **Notebooks** (folder `notebooks`) tell the story. Run them from top to bottom, change
#   numbers, run them again.
# - **Exercises** (folder `exercises`) are yours to write. Each task is a function with an empty
#   body. The cell below it checks your answer and gives points. It draws new numbers every time,
#   so an answer cannot be learned by heart. If your answer matches a known mistake, you get a
#   hint.
# - **Quizzes** stand at the end of each notebook. In a terminal, `workbook quiz` asks the same
#   questions.
# - `workbook grade exercises/01_one_dimension.ipynb` marks a whole exercise. Your code runs in a
#   process of its own.
# - `workbook play billiards` opens the program that chapter 03 leads to.
#
# ## 8 Quiz

# %%
show_quiz("00")

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** vector operations against numbers worked by hand. **Not checked:** anything
# about collisions yet.
#
# **Next:** [01 One dimension](01_one_dimension.ipynb). Two carts on a track, and the law that
# decides everything.
#
# **Sources.** The pipeline is the usual one of real-time engines: Ericson, *Real-Time Collision
# Detection* (2005), chapters 1 and 7; Millington, *Game Physics Engine Development* (2010),
# chapter 3.
