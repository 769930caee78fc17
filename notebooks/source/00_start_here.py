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
# A pool ball hits another one that lies still. The first slows down, the second speeds up, and
# the two changes fit each other exactly. This course is about that moment: how a program finds it,
# how it computes what happens, and how you know that the answer is right.
#
# **After this notebook you will be able to**
#
# 1. name the stages that every collision goes through in a program, in their order;
# 2. use the four vector operations that the rest of the course needs;
# 3. answer a prediction, fill a gap, read a check and hand in an exercise.
#
# **You need** a little Python (functions, lists) and the idea of a vector as an arrow. **Time:**
# about 40 minutes with the questions; it runs in a few seconds.

# %% tags=["plumbing"]
import numpy as np

from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import CheckFailedError, check
from lesson_code.formulas import reflect
from lesson_code.formulas.arithmetic import cross, dot, perpendicular
from lesson_code.view.browser.lab import lab
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import diagrams, style

# %% [markdown]
# Before you see a result, this course asks what you expect. Commit to an answer, even a guess: you
# will remember what surprised you. Then the result opens below. You can also open it without an
# answer.

# %%
predict("00-sum")

# %% tags=["answer"]
# the collision lab
lab()

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The sum of mass times velocity, as vectors: the **momentum**. Try it. Drag a disc, or the tip of
# its velocity, at the other one and press Run. Give one of them more mass, or lower the elasticity:
# speeds and energy change, and the momentum stays, until a disc hits a wall. The engine that you
# will read in this course moves the discs.

# %% [markdown]
# ## 1 Every collision goes through one pipeline
#
# Games and robot simulators look different, but in each time step nearly all of them do the same
# three things, in this order:
#
# - **Detection** finds out who touches whom. The *broad phase* quickly rejects pairs that are far
#   apart. The *narrow phase* looks closely at the others: where do they touch, in which direction
#   (the *normal*), and how deep do they overlap?
# - **Resolution** decides what happens. It calculates an *impulse* from velocities and masses,
#   moves overlapping bodies apart (*position correction*) and updates every velocity.
# - **Post-processing** lets the rest of the program react: *callbacks*, *effects* such as a
#   flash, *sound*.
#
# Chapters 01 to 03 are about the box with the thick frame: the impulse.

# %% tags=["plumbing"]
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
# The simplest body is a ball. To move it you need three things: its **position**, its **velocity**
# and its **radius**. To make it collide you also need its **mass**. In each small time step `dt`
# the position changes by velocity times `dt`. If that puts the ball below the floor, you have to
# set it back onto the floor. This is called a *floor clamp*, and chapter 03 shows why it is not
# enough on its own.
#
# Here is your first gap. `y` is the height of the ball's centre, and the floor is at height 0.
# Replace the three dots by what the height should be (Python's `max` helps), and run the cell. If
# you leave the dots, the notebook goes on with our line. The line with `@gap` hands your function
# to the notebook; leave it as it is.


# %%
@gap("00-clamp")
def onto_the_floor(y, radius):
    return ...


# %%
position, velocity, radius = np.array([0.0, 2.0]), np.array([1.5, -3.0]), 0.5
dt = 0.1
position = position + velocity * dt
check("one step moves the ball by v dt", position, (0.15, 1.7), tolerance=1e-12)
check("the ball is above the floor, and stays", onto_the_floor(position[1], radius), 1.7, 1e-12)
y, heights = position[1], []
for _ in range(6):
    y = onto_the_floor(y + velocity[1] * dt, radius)
    heights.append(round(float(y), 3))
print("the next six steps:", heights)
check("it falls by 0.3 m a step, until it lies on the floor", y, 0.5)

# %% [markdown]
# ## 3 Vectors in a page
#
# You can do all of chapters 01 to 03 with four operations. A vector has two components, x and y,
# and in the code it is an array of two numbers.
#
# **Length.** The length of (x, y) is the square root of x² + y².
#
# **Normalise.** A vector divided by its own length has length 1. It keeps only the direction.
# Such a vector is called a *unit vector*. The zero vector has no direction and cannot be
# normalised. Write it; `np.hypot(*v)` is the length of `v`:


# %%
@gap("00-direction")
def direction(v):
    return ...


# %%
v = np.array([3.0, -4.0])
check("the length of (3, -4)", np.hypot(*v), 5.0)
check("its direction", direction(v), (0.6, -0.8), tolerance=1e-15)
check("the direction has length 1", np.hypot(*direction(v)), 1.0, tolerance=1e-15)

# %% [markdown]
# **Dot product.** `dot(a, b)` is a_x b_x + a_y b_y. It answers a question that you will ask all the
# time: *is b in front of a, beside it or behind it?* Positive means in front, zero means at a right
# angle, negative means behind. If `a` has length 1, the dot product is also how far `b` reaches
# along `a`.

# %%
looking = np.array([1.0, 0.0])
check("in front", dot(looking, (2.0, 1.0)) > 0, True)
check("at a right angle", dot(looking, (0.0, 1.0)), 0.0)
check("behind", dot(looking, (-2.0, 1.0)) < 0, True)

# %% [markdown]
# In the figure below the thick bar is the dot product of two unit vectors: how far b reaches along
# a. It is 1 where both point the same way, and 0 at a right angle.

# %%
predict("00-half-way")

# %% tags=["answer"]
# drag the tip of b round the circle
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
normal = direction(np.array([3.0, 4.0]))
tangent = perpendicular(normal)
check("the tangent of (0.6, 0.8)", tangent, (-0.8, 0.6), tolerance=1e-15)
check("normal and tangent are at a right angle", dot(normal, tangent), 0.0, tolerance=1e-15)
check("the tangent lies counter-clockwise", cross(normal, tangent), 1.0, tolerance=1e-15)

# %% [markdown]
# ## 4 Up is up, except on a screen
#
# In physics y grows upward. On a computer screen y grows *downward*: the top left corner is (0, 0).
# This course uses metres and y up everywhere. The pygame programs flip the picture in a single
# place, just before they draw. The billiards exercise of chapter 03 is the one exception: it speaks
# pixels and y down, and says so.
#
# The mirror formula of chapter 03 works both ways. Here a ball falls on the floor and comes back
# up, first with y up, then with y down:

# %%
check("y up: falling at 4, floor with normal (0, 1)", reflect((3, -4), (0, 1)), (3, 4))
check("y down: falling at 4, floor with normal (0, -1)", reflect((3, 4), (0, -1)), (3, -4))

# %% [markdown]
# ## 5 A check says what was claimed, measured and expected
#
# You have seen some checks above. Each prints one line: the claim, what the code gave, what it
# should give, and how far apart the two may be. The expected value never comes from the code under
# test. It comes from algebra, from a conservation law, or from *pymunk*, a physics engine that we
# did not write.
#
# A false claim stops the notebook. Here is one, caught so that you can look at it:

# %%
try:
    check("a ball keeps its speed when it slows down", measured=2.0, expected=3.0, tolerance=0.5)
except CheckFailedError as failure:
    print(failure)

# %% [markdown]
# ## 6 Break it on purpose: `if time:`
#
# You learn most from code that fails. So every chapter breaks something, and the faults are real:
# we found them in a web lesson from which this course grew.
#
# That lesson had a function that returned the *time* until two balls meet, or `None` if they
# never do. The code that used it asked `if time:`.

# %%
predict("00-falsy")


# %% tags=["answer"]
# three times, and what two questions make of them
def is_a_hit_wrong(time):
    return bool(time)


def is_a_hit(time):
    return time is not None


for time in (0.5, None, 0.0):
    print(
        f"time {time}: `if time` says {is_a_hit_wrong(time)}, `is not None` says {is_a_hit(time)}"
    )

# %% [markdown]
# In this course "no contact" and "no impact" are always `None`, and code always asks `is not None`.
# There is a second trap of this kind: `nan` ("not a number"), which a broken calculation leaves
# behind.

# %%
predict("00-nan")

# %% tags=["answer"]
# two comparisons with nan
error = float("nan")
print("error > 1e-9  says 'wrong':", error > 1e-9)
print("error <= 1e-9 says 'right':", error <= 1e-9)

# %% [markdown]
# ## 7 How the workbook is used
#
# - **Two tracks.** The core track is notebooks 00 to 07 and 11, about 7 hours, and about 6 more for
#   their exercises. The advanced track, 08 to 10, is about 2 hours: what accuracy costs, what
#   breaks an engine, and what a scene can do without. The minutes at the head of each notebook are
#   counted: 100 words a minute, three minutes for each function that you write and each figure that
#   you move, and one for each question. Count ten for each task of an exercise.
# - **Notebooks** (folder `notebooks`) tell the story, ask you what you expect, and leave two or
#   three lines for you to write. Run them from top to bottom, change numbers, run them again. A
#   bar with three points hides imports and drawing: click it to see them.
# - **Exercises** (folder `exercises`) are yours to write. Each task is a function with an empty
#   body. The cell below it checks your answer and gives points. It draws new numbers every time,
#   so an answer cannot be learned by heart. If your answer matches a known mistake, you get a
#   hint.
# - **Quizzes** stand at the end of each chapter. In a terminal, `workbook quiz` asks the same
#   questions. Chapters 05 and 07 come in parts: 05 and 05b, then 07, 07b and 07c.
# - `workbook watch 01` stays beside an exercise and checks it whenever you save;
#   `workbook grade exercises/01_one_dimension.ipynb` marks it as your instructor will. Your code
#   runs in a process of its own.
# - `workbook play billiards` opens the program that chapter 03 leads to.
#
# ## 8 Quiz

# %%
show_quiz("00")

# %% [markdown]
# ## 9 Key takeaways
#
# - Detection, resolution, post-processing: every step, in this order.
# - The dot product says in front, beside or behind, and how far.
# - A normal is a unit vector, and the tangent is the normal turned by a right angle.
# - "None" is not 0.0: ask `is not None`. And write every check so that nan fails it.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** vector operations against numbers worked by hand. **Not checked:** anything
# about collisions yet.
#
# **Do now:** open `workbook play simulator` and launch some balls. The challenges that the course
# leads to begin with [the cradle](../exercises/cradle.py); `workbook watch cradle` checks it
# whenever you save. **Next:** [01 One
# dimension](01_one_dimension.ipynb). Two carts on a track, and the law behind every collision.
#
# **Sources.** The pipeline is the usual one of real-time engines: Ericson, *Real-Time Collision
# Detection* (2005), chapters 1 and 7; Millington, *Game Physics Engine Development* (2010),
# chapter 3.
