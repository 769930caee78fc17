# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 07b From event to event
#
# In notebook 07 one step of ten seconds was as good as 600 short ones. So why have steps at all?
# Here you go from collision to collision. You count the hits of two blocks and find a number that
# you know, follow a ball through infinitely many bounces in four seconds, and let a film of 64
# discs run backwards to its first picture.
#
# **After this notebook you will be able to**
#
# 1. simulate from collision to collision, without any time step;
# 2. hold such a simulation to answers that are known exactly, after any number of collisions;
# 3. say for how many collisions you can trust the place of each disc in a gas, and why no longer.
#
# **You need** notebook 07. **Time:** about 20 minutes to read and to write two lines, a few seconds
# to run.

# %% tags=["plumbing"]

import numpy as np

from lesson_code import simulate
from lesson_code.chapters.ch07_time_of_impact import figures, scenes
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict
from lesson_code.evidence import check, check_bound
from lesson_code.evidence.scenes import events
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.reference import closed_forms, event_closed_forms
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 8 Between two collisions there is nothing to compute
#
# Between two collisions every disc moves in a way that you can write down: a straight line, or with
# gravity a parabola. So an **event-driven** simulation goes from one collision to the next:
#
# 1. For every disc, predict its next event: the earliest of all its times of impact.
# 2. Take the earliest event of all. (A *heap* is a list that keeps its least entry in front.)
# 3. Move the discs that take part to that time, and let them bounce.
# 4. Their other predictions no longer hold, so make new ones. All other discs fly on as predicted.
#
# `solver="exact"` does this. `sample` says at which times you want to see the state; with `None`
# they are the events themselves.

# %%
scene = scenes.three_balls_and_a_post()
run = simulate(scene, 2.0, solver="exact")
for t, a, b in zip(run.contacts.time, run.contacts.body_a, run.contacts.body_b, strict=True):
    print(f"{t:.6f} s: body {a} and body {b}")

# %%
run = simulate(scene, 6.0, solver="exact", sample=np.linspace(0, 6, 181))
check("energy kept, J", run.kinetic_energy - run.kinetic_energy[0], 0, tolerance=1e-12)
check("deepest overlap in any state, m", run.max_penetration, 0, tolerance=1e-12)
animate(
    run,
    "Three balls in a box with a round post in the middle. They bounce off the walls, off the post "
    "and off each other.",
    still=1.0,
)

# %% [markdown]
# No step, so no tunnelling either, at any speed. And no overlap, so nothing to push apart.

# %%
for speed in (1.0, 1e3, 1e6):
    scene = events.balls_at_wall(speed, count=10, dt=1 / 60, thickness=0.001)
    run = simulate(scene, 2 / speed + 1 / 60, solver="exact", sample="end")
    check(f"{speed:9,.0f} m/s: balls through a wall of 1 mm", events.share_beyond(run), 0)

# %% [markdown]
# ## 9 Two blocks and a wall
#
# Two blocks slide on ice before a wall. The inner one, of 1 kg, is at rest; the outer one, of M kg,
# comes towards it. All is elastic. The inner block bounces to and fro between the wall and the
# outer block, until the outer block has turned round and is the faster one.

# %%
predict("07-pi")

# %% tags=["answer"]
# the collisions, counted
for digits in range(5):
    run = simulate(events.two_blocks(100.0**digits), 1e5, solver="exact", sample="end")
    predicted = event_closed_forms.block_collisions(100.0**digits)
    check(f"M = 100^{digits}: collisions", len(run.contacts), predicted)
    energy = run.kinetic_energy[-1] / run.kinetic_energy[0]
    check("   energy left", energy, 1, tolerance=1e-10)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# These are the digits of pi. Galperin's reason is a picture. Take $\sqrt{m_1}\,x_1$ and
# $\sqrt{m_2}\,x_2$ as the coordinates of *one* point. The two sides of a wedge with the angle
# $\theta$, where $\tan\theta = 1/\sqrt{M}$, are "the inner block is at the wall" and "the blocks
# touch". A collision is a reflection there. Instead of the way, mirror the *wedge*, again and
# again: then the way is a straight line, and it crosses a side at each multiple of $\theta$ below
# $\pi$.

# %% tags=["plumbing"]
fig, ax = style.figure(width=8, height=3.6)
figures.unfolded_wedge(ax, mass_ratio=9)
show(
    fig,
    "Rays from one point, at equal angles, full and dotted in turn. A straight line from right to "
    "left crosses nine of them: the nine collisions for a mass ratio of 9.",
)

# %% [markdown]
# So you need no simulation to count. How often does a line cross the sides of the wedge for a mass
# ratio M? Write it. `math.atan` gives the angle, and a multiple that is exactly $\pi$ does not
# count: there the line is parallel to the side.


# %%
@gap("07-crossings")
def crossings(mass_ratio):
    return ...


# %%
check("as many as in the picture", crossings(9.0), 9)
for mass_ratio in (1.0, 2.0, 50.0, 123_456.0):
    run = simulate(events.two_blocks(mass_ratio), 1e5, solver="exact", sample="end")
    check(f"M = {mass_ratio:,.0f}: collisions", len(run.contacts), crossings(mass_ratio))

# %% [markdown]
# For M = $100^k$ the angle is nearly $10^{-k}$, and $\pi/10^{-k}$ has the digits of pi. A stepped
# engine has a hard time here: the inner block gets faster and faster, in a narrower and narrower
# gap. For M = $100^3$ it reaches a thousand times the speed at which the outer one came, in a
# gap of a millimetre.

# %%
million = events.two_blocks(100.0**3)
for rate in (60, 2400):
    run = simulate(million, 10.0, dt=1 / rate, solver="pymunk", sample="end")
    side = "behind" if run.positions[-1, 1, 0] < 0 else "before"
    print(f"pymunk, {rate:4} steps a second: {len(run.contacts)} of 3141, ends {side} the wall")

# %% tags=["plumbing"]
run = simulate(events.two_blocks(100.0), 5.0, solver="exact")
edges = run.positions[:, :, 0] - np.array([0, 0.5, 1.5])  # blocks drawn without their width
fig, ax = style.figure(width=7, height=3)
named = {"inner block": (run.times, edges[:, 1]), "outer block, 100 kg": (run.times, edges[:, 2])}
plots.curves(ax, named, "time, s", "distance from the wall, m")
show(
    fig,
    "Distance from the wall over time. The outer block comes, slows down, turns round at a tenth "
    "of a metre and leaves. The inner one zigzags between it and the wall, fastest in the middle.",
)

# %% [markdown]
# ## 10 A ball in a box, for ever
#
# A bounce off a wall is a mirror image. Instead of the ball, mirror the *box*: then the ball flies
# straight on, through a wallpaper of mirrored boxes. Where it is after any time is a
# multiplication and a fold.

# %% tags=["plumbing"]
start, velocity = np.array(events.BALL_START), np.array(events.BALL_VELOCITY)
radius, box = events.BALL_RADIUS, np.array(events.BOX)
fig, ax = style.figure(width=9, height=4.4)
room = box - 2 * radius  # what the ball's centre can reach
figures.unfolded_box(ax, start - radius, velocity, room, time=6.0)
show(
    fig,
    "A box with the zigzag way of a ball, and the same way unfolded: a straight line through the "
    "mirror images of the box, which lie beside it and above it.",
)

# %% [markdown]
# Write the fold, for one direction. In the box the ball can be from 0 to `room`. Without walls it
# would be at `x`: far beyond, or below 0. Where is it? The wallpaper repeats after 2 `room`. In
# Python `x % p` moves x by whole multiples of p to a place from 0 to p, also from below 0.


# %%
@gap("07-fold")
def fold(x, room):
    return ...


# %% [markdown]
# So there is an answer to compare with, after any number of bounces. In the checks it is worked out
# in fractions, without rounding.

# %%
scene = events.ball_in_a_box()
for duration in (10, 100, 1000):
    run = simulate(scene, duration, solver="exact", sample=np.linspace(0, duration, 101))
    off = events.error_in_the_box(run)
    check(f"exact, {duration} s, {len(run.contacts)} bounces: error, m", off, 0, 1e-13 * duration)
ways = start - radius + 1000 * velocity
folded = [fold(x, size) for x, size in zip(ways, room, strict=True)]
check("your fold, after 1000 s, m", np.add(folded, radius), run.positions[-1, -1], 1e-10)

# %%
rates, errors = np.array([30, 60, 120, 240, 480, 960, 1920]), []
for rate in rates.tolist():
    run = simulate(scene, 10, dt=1 / rate, solver="pymunk", sample=np.linspace(0, 10, 101))
    errors.append(events.error_in_the_box(run).max())
    print(f"pymunk, {rate:4} steps a second: off by up to {errors[-1]:.3f} m in 10 s")

# %% [markdown]
# Each impact comes late by a part of a step, and the ball never makes up for it. If you halve the
# step, you roughly halve the error: ten times the accuracy costs ten times the work. The exact
# solver computes ten collisions, and only rounding is left of its error.
#
# ## 11 Backwards in time
#
# Newton's laws do not know which way time runs. Turn every velocity round, and a film of balls
# runs backwards, to the very state in which it began. This is a hard test for a simulation: let 64
# discs in a box run for a while, turn them round, and let them run for the same time again.

# %%
predict("07-back")

# %% tags=["answer"]
# there and back again
gas, returns = gas_scenes.disc_gas(8, covered=0.5, seed=1), []
for duration in np.arange(0.5, 7.0, 0.5):
    run = simulate(gas, duration, solver="exact", sample="end")
    back = simulate(events.turned_back(run), duration, solver="exact", sample="end")
    returns.append((gas_scenes.hits_a_disc(run), events.error_after_return(run, back)))
hits, off = np.transpose(returns)
check("up to 9 collisions a disc: back within, m", off[hits <= 9], 0, tolerance=1e-9)
lost = off[hits > 42].min().round(1)  # chaos: no further digit is the same everywhere
check_bound("beyond 42 it is lost: off by at least, m", lost, at_least=1e-3)

# %% tags=["answer", "plumbing"]
# there and back again
fig, ax = style.figure(width=7, height=3.2)
plots.curves(ax, {"": (hits, off)}, "collisions of each disc with others", "farthest from start, m")
ax.set_yscale("log")
show(
    fig,
    "How far the farthest disc is from its start after the way back, over the number of "
    "collisions, on a logarithmic scale. From 1e-14 m it grows along a nearly straight line to "
    "some decimetres.",
)

# %% [markdown]
# So the discs of the following film do find their places again: on the way out they collide fewer
# than nine times each, on average.

# %%
seen = np.linspace(0, 1, 51)
out = simulate(gas, 1.0, solver="exact", sample=seen)
back = simulate(events.turned_back(out), 1.0, solver="exact", sample=seen)
print(f"{gas_scenes.hits_a_disc(out):.1f} collisions a disc")
animate(
    {"out": out, "back": back},
    "Two boxes with 64 discs. On the left they start in rows and columns and fly into disorder. On "
    "the right they start in that disorder, and end in rows and columns.",
    seconds=4,
    still=0.9,
)

# %% [markdown]
# A straight line on this scale is exponential growth. Discs are convex: two ways that differ a
# little before a hit differ more after it, here by a factor of about two for each hit. That is
# **chaos**. It is in the laws and not in the solver: with twice as many digits the line would
# start lower and be just as steep. So do not compare long runs of many discs place by place.
# Compare what is not chaotic: energy, momentum, pressure.
#
# ## 12 Infinitely many bounces in four seconds
#
# A ball is dropped from 1 m, with e = 0.8. You know from section 4 of chapter 02 that it bounces
# infinitely often, and yet lies still after 4.02 s (here g is 10 m/s²).
#
# A simulation that goes from event to event would never get there. It needs a **rule**: a ball that
# leaves the floor slower than $10^{-13}$ of the scene's speed rests. The bounces left out would
# have lasted less than $10^{-12}$ s.

# %%
times = np.linspace(0, 6, 601)
run = simulate(events.bouncing_to_rest(0.8), 6.0, solver="exact", sample=times)
rest = closed_forms.rest_time(height=1, restitution=0.8, gravity=10)
heights = closed_forms.bouncing_ball(times, height=1, restitution=0.8, gravity=10)
check("the last bounce, s", run.contacts.time[-1], rest, tolerance=1e-12)
check("its height at 601 times, m", run.positions[:, 1, 1] - 0.5, heights, tolerance=1e-12)
check("at rest from then on", run.velocities[times > rest, 1], 0)
print(len(run.contacts), "bounces were computed")

# %% tags=["plumbing"]
stepped = simulate(events.bouncing_to_rest(0.8), 6.0, solver="pymunk")
fig, ax = style.figure(width=7, height=3)
named = {"exact": (times, run.positions[:, 1, 1] - 0.5)}
named["pymunk, 60 steps a second"] = (stepped.times, stepped.positions[:, 1, 1] - 0.5)
plots.curves(ax, named, "time, s", "height above the floor, m")
ax.axvline(rest, color=style.GREY, linewidth=1, linestyle="-.")
show(
    fig,
    "Height of the ball over time. It bounces lower and faster, and lies still from 4.02 s on, "
    "which a vertical line marks. pymunk's ball dips a little into the floor at each bounce, and "
    "its later bounces are out of step.",
)

# %% [markdown]
# You can now simulate from collision to collision, and hold the result to answers that are known
# exactly. That is what the last two tasks of the exercise
# [07 Time of impact](../exercises/07_time_of_impact.ipynb) ask for. **Next:**
# [07c The gas](07c_the_gas.ipynb), where you measure what is not chaotic, and what exactness costs.
# It ends with the quiz of the chapter.
