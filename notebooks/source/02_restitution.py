# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 02 Restitution
#
# A superball dropped on stone comes back almost to your hand. A lump of clay stays where it
# falls. One number tells them apart.
#
# **After this notebook you will be able to**
#
# 1. measure the restitution of a collision from four velocities, and compute what it costs in
#    energy;
# 2. predict how high a ball bounces, and how long it goes on bouncing;
# 3. say what a time-stepping engine makes of a bouncing ball, and how wrong it is.
#
# **You need** notebook 01. **Time:** about 40 minutes to read, a few seconds to run.

# %%
import numpy as np

from lesson_code.chapters.ch02_restitution import wrong_answers as wrong
from lesson_code.chapters.ch02_restitution.stepped_ball import drop_in_steps
from lesson_code.chapters.ch03_reflection import wrong_answers as wrong_bounce
from lesson_code.course.quiz.notebook import show_quiz
from lesson_code.evidence import check
from lesson_code.formulas import bounce, collide_1d, energy_lost_1d, restitution_1d
from lesson_code.reference.closed_forms import bounce_heights, bouncing_ball, rest_time
from lesson_code.reference.pymunk_reference import drop_onto_floor
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

# %% [markdown]
# ## 1 Restitution is a ratio of speeds
#
# Before they meet, two bodies approach each other with speed $v_1 - v_2$. Afterwards they part
# with speed $v_2' - v_1'$. Newton found that for two given bodies the ratio hardly depends on how
# fast they meet:
#
# $$e = \frac{v_2' - v_1'}{v_1 - v_2}$$
#
# Note the order: *separation* is second minus first, *approach* is first minus second. Both are
# positive numbers in a real collision. e is 1 when nothing is lost and 0 when the bodies stick.

# %%
check("approach 4 m/s, separation 2 m/s", restitution_1d(3, -1, -1, 1), 0.5)
v1_after, v2_after = collide_1d(1.0, 3.0, 2.0, -1.0, restitution=0.7)
check("the restitution put in comes out", restitution_1d(3, -1, v1_after, v2_after), 0.7, 1e-12)

# %% [markdown]
# The velocities of one body alone do not tell e. Below, the same e = 0.5 gives the first body
# quite different velocities, depending on the masses.

# %%
for mass_2 in (0.5, 1.0, 2.0, 8.0):
    v1_after, v2_after = collide_1d(1, 2, mass_2, 0, restitution=0.5)
    print(f"m2 = {mass_2} kg: v1' = {v1_after:+.3f}, v2' = {v2_after:+.3f}, ", end="")
    print(f"separation {v2_after - v1_after:.3f} m/s")

# %% [markdown]
# ## 2 Only the energy of the approach can be lost
#
# The centre of mass moves on unchanged and keeps its kinetic energy. What can be turned into heat
# is the energy of the *relative* motion, $\frac12 m_r (v_1 - v_2)^2$, with the reduced mass $m_r
# = m_1 m_2/(m_1 + m_2)$. Speeds shrink by e, energies by e²:
#
# $$\text{energy lost} = \tfrac12\, m_r\,(1 - e^2)\,(v_1 - v_2)^2$$
#
# **Predict:** a collision has e = 0.7. Is the part of the relative energy that survives nearer to
# 0.7 or to 0.5?

# %%
lost = energy_lost_1d(m1=1, v1=2, m2=3, v2=-1, restitution=0.7)
before = (1 * 2**2 + 3 * 1**2) / 2
v1_after, v2_after = collide_1d(1, 2, 3, -1, restitution=0.7)
after = (1 * v1_after**2 + 3 * v2_after**2) / 2
check("energy before minus energy after", before - after, lost, tolerance=1e-12)
check("worked by hand: 1/2 · 3/4 · 0.51 · 9 J", lost, 1.72125, tolerance=1e-12)

# %%
e = np.linspace(0, 1, 101)
fig, ax = style.figure(width=6, height=3.4)
named = {"part of the relative energy kept: e²": (e, e**2), "part of the speed kept: e": (e, e)}
plots.curves(ax, named, "restitution e", "part kept")
show(
    fig,
    "Two curves over restitution from 0 to 1: the speed kept is e, a straight line; the energy "
    "kept is e squared, below it.",
)

# %% [markdown]
# ## 3 A dropped ball rises to e² of its height, every time
#
# A ball that falls from height h reaches the floor with speed $\sqrt{2gh}$. It leaves with e
# times that speed, so it rises to e²h. The next bounce starts from there. After n bounces the
# height is
#
# $$h_n = e^{2n} h.$$

# %%
heights = bounce_heights(height=1.0, restitution=0.8, count=5)
print("heights after each bounce, m:", np.round(heights, 4))
check("the first bounce", heights[0], 0.64, tolerance=1e-12)
check("the fifth bounce", heights[4], 0.8**10, tolerance=1e-12)

# %% [markdown]
# Read the other way, two heights tell e: it is the root of their ratio. So a ruler is enough to
# measure restitution. **Predict:** a ball is dropped from 1 m and comes back to 0.25 m. What is
# e? How high must it come back for e = 0.9? Then drag the two balls, or type the heights.

# %%
live(
    "ch02_restitution/read_e",
    "A ball is dropped from 1 m and comes back to 0.64 m. Beside it, two arrows: it hits the floor "
    "at 4.43 m/s and leaves it at 3.54 m/s, so e = 0.8. You can drag both heights, or set them.",
)

# %% [markdown]
# ## 4 Infinitely many bounces end in finite time
#
# The first fall takes $t_0 = \sqrt{2h/g}$. Each flight up and down after it takes $2 t_0 e, 2 t_0
# e^2, \dots$ The times shrink so fast that all of them together are finite:
#
# $$T = t_0 + 2 t_0 (e + e^2 + e^3 + \dots) = \sqrt{\frac{2h}{g}}\;\frac{1 + e}{1 - e}$$
#
# At time T the ball has made infinitely many bounces, and lies still. This is called the *Zeno*
# ball, after the philosopher of the paradox of Achilles and the tortoise. A program that waits
# for "the last bounce" waits for ever.

# %%
t0 = np.sqrt(2 * 1.0 / 9.81)
flights = 2 * t0 * 0.8 ** np.arange(1, 200)
check("the sum of 199 flights", t0 + flights.sum(), rest_time(1.0, 0.8, 9.81), tolerance=1e-12)
check("the same with g = 10 m/s²", rest_time(1.0, 0.8, 10.0), np.sqrt(0.2) * 9, tolerance=1e-12)

# %% [markdown]
# Change e and watch the time of rest. **Predict:** by how much does T grow from e = 0.8 to e = 0.9?
# And what becomes of T when the ball is dropped from a quarter of the height?

# %%
live(
    "ch02_restitution/bounce_heights",
    "Height of a ball over time, dropped from 1 m with e = 0.8: ever lower arcs, at rest from "
    "4.06 s. You can change e, and drag the place where the ball is dropped or set its height.",
)

# %% [markdown]
# ## 5 An engine that steps through time gets it nearly right
#
# Engines do not know the formula above. They move everything by a small step `dt`, look who
# overlaps, and apply an impulse. A ball is then always found a little *after* it has touched the
# floor. pymunk, at its usual 1/60 s, gives this:

# %%
times, stepped = drop_onto_floor(height=1.0, restitution=0.8, duration=4.5, dt=1 / 60, gravity=9.81)
fig, ax = style.figure(width=8, height=3.4)
closed_form = bouncing_ball(times, 1.0, 0.8, 9.81)
named = {"closed form": (times, closed_form), "pymunk, dt = 1/60 s": (times, stepped)}
plots.curves(ax, named, "time, s", "height, m")
show(
    fig,
    "The closed form and pymunk at 1/60 s: the same arcs at first, pymunk's drift away from "
    "bounce to bounce.",
)

# %% [markdown]
# What is wrong is above all the moment of each bounce: it comes late, by up to one step. So the
# error shrinks in proportion to `dt`: ten times smaller steps, about ten times smaller error, for
# ten times the work.

# %%
errors = {}
for dt in (1 / 60, 1 / 600, 1 / 6000):
    times, stepped = drop_onto_floor(height=1.0, restitution=0.8, duration=1.5, dt=dt, gravity=9.81)
    errors[dt] = np.abs(stepped - bouncing_ball(times, 1.0, 0.8, 9.81)).mean()
    print(f"dt = 1/{1 / dt:.0f} s: mean error {errors[dt]:.4f} m")
order = np.log10(errors[1 / 60] / errors[1 / 6000]) / 2
check("the error shrinks like dt to the power", order, 1.0, tolerance=0.2)

# %% [markdown]
# ## 6 Break it on purpose: a ball that climbs
#
# This is the doubled impulse of chapter 01, now at a floor, in a small stepping loop of our own.
# `drop_in_steps` takes the bounce rule as an argument, so we can give it the right one or a wrong
# one. **Predict** with e = 0.8: does the ball still come to rest?

# %%
drop = {"height": 1.0, "restitution": 0.8, "duration": 2.0, "dt": 1 / 600}
paths = {
    "right": drop_in_steps(bounce, **drop),
    "impulse doubled": drop_in_steps(wrong_bounce.doubled_impulse, **drop),
}
fig, ax = style.figure(width=8, height=3.4)
plots.curves(ax, paths, "time, s", "height, m")
show(
    fig,
    "Dropped from 1 m with e = 0.8: with the right rule the ball bounces lower and lower, with "
    "the doubled impulse it shoots up to over 6 m.",
)

# %%
speed_after = wrong_bounce.doubled_impulse(np.array([0.0, -1.0]), np.array([0.0, 1.0]), 0.8)[1]
check("each bounce multiplies the energy by", speed_after**2, 6.76, tolerance=1e-12)
check("the right factor is", bounce((0, -1), (0, 1), 0.8)[1] ** 2, 0.64, tolerance=1e-12)

# %% [markdown]
# A quieter fault: e taken for an *energy* ratio. The ball still comes to rest, nothing explodes,
# and a careless eye sees nothing. A measurement does:

# %%
v1_after, v2_after = wrong.energy_restitution(1.0, 2.0, 3.0, -1.0, 0.25)
measured = restitution_1d(2, -1, v1_after, v2_after)
print(f"asked for e = 0.25, measured e = {measured:.3f}")
check("it is the square root of what was asked for", measured, 0.25**0.5, tolerance=1e-12)

# %% [markdown]
# ## 7 No threshold unless you ask for one
#
# Some engines cut restitution off below a certain speed, so that things come to rest sooner. A
# slow ball then does not bounce at all. pymunk has no such threshold, and neither has this
# course. A ball at 0.9 m/s with e = 1 comes back at 0.9 m/s:

# %%
check("a slow ball bounces too", bounce((0, -0.9), (0, 1), restitution=1)[1], 0.9, tolerance=1e-15)

# %% [markdown]
# ## 8 Quiz

# %%
show_quiz("02")

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** restitution and energy against numbers worked by hand; heights and time of
# rest against their series; pymunk's error against the closed form, which shrinks in proportion
# to the step.
#
# **Limits.** In reality e falls a little as the impact gets faster, and a ball that spins or
# slides needs friction too (chapter 05).
#
# **Do now:** the exercise [02 Restitution](../exercises/02_restitution.ipynb): four tasks,
# thirteen points. **Next:** [03 Reflection](03_reflection.ipynb).
#
# **Sources.** Newton, *Principia* (1687), scholium to the laws of motion (the ratio of speeds).
# Goldsmith, *Impact* (1960), on measured restitution.
