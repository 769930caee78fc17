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
# Drop a superball on stone, and it comes back almost to your hand. Drop a lump of clay, and it
# stays where it falls. One number tells them apart, and you can measure it with a ruler.
#
# **After this notebook you will be able to**
#
# 1. measure the restitution of a collision from four velocities, and compute what it costs in
#    energy;
# 2. predict how high a ball bounces, and how long it goes on bouncing;
# 3. say what a time-stepping engine makes of a bouncing ball, and how wrong it is.
#
# **You need** notebook 01. **Time:** about 40 minutes with the questions; it runs in a few
# seconds.

# %% tags=["plumbing"]
import numpy as np

from lesson_code.chapters.ch02_restitution import figures
from lesson_code.chapters.ch02_restitution import wrong_answers as wrong
from lesson_code.chapters.ch02_restitution.stepped_ball import drop_in_steps
from lesson_code.chapters.ch03_reflection import wrong_answers as wrong_bounce
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.formulas import bounce, collide_1d, energy_lost_1d
from lesson_code.reference.closed_forms import bounce_heights, bouncing_ball
from lesson_code.reference.pymunk_reference import drop_onto_floor
from lesson_code.view.browser.live import live

# %% [markdown]
# ## 1 Restitution is a ratio of speeds
#
# Before they meet, two bodies approach each other with the speed $v_1 - v_2$. Afterwards they part
# with the speed $v_2' - v_1'$. Newton found that for two given bodies the ratio hardly depends on
# how fast they meet: separation over approach, the **restitution** e. In a real collision neither
# speed is negative. e is 1 when nothing is lost and 0 when the bodies stick. Write it:


# %%
@gap("02-restitution")
def restitution(v1, v2, v1_after, v2_after):
    return ...


# %%
check("approach 4 m/s, separation 2 m/s", restitution(3, -1, -1, 1), 0.5)
v1_after, v2_after = collide_1d(1.0, 3.0, 2.0, -1.0, restitution=0.7)
check("the restitution put in comes out", restitution(3, -1, v1_after, v2_after), 0.7, 1e-12)

# %% [markdown]
# $$e = \frac{v_2' - v_1'}{v_1 - v_2}$$
#
# Note the order: *separation* is second minus first, *approach* is first minus second.
#
# The velocity of one body alone does not tell you e. In each line below e is 0.5, but the second
# body has a different mass each time, and so the first body does something different:

# %%
for mass_2 in (0.5, 1.0, 2.0, 8.0):
    v1_after, v2_after = collide_1d(1, 2, mass_2, 0, restitution=0.5)
    print(f"m2 = {mass_2} kg: v1' = {v1_after:+.3f}, v2' = {v2_after:+.3f}, ", end="")
    print(f"separation {v2_after - v1_after:.3f} m/s")

# %% [markdown]
# ## 2 Only the energy of the approach can be lost
#
# The centre of mass moves on as before and keeps its kinetic energy. Only the energy of the
# *relative* motion can turn into heat: $\frac12 m_r (v_1 - v_2)^2$, with the reduced mass $m_r =
# m_1 m_2/(m_1 + m_2)$.

# %%
predict("02-energy-kept")

# %% tags=["answer"]
# what is kept of speed and energy
lost = energy_lost_1d(m1=1, v1=2, m2=3, v2=-1, restitution=0.7)
relative = 1 / 2 * 3 / 4 * (2 - -1) ** 2
check("the part of the relative energy kept", 1 - lost / relative, 0.49, tolerance=1e-12)
figures.speed_and_energy_kept()

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Speeds shrink by e, and energies by e²:
#
# $$\text{energy lost} = \tfrac12\, m_r\,(1 - e^2)\,(v_1 - v_2)^2$$

# %% [markdown]
# Compare that loss with the energies of the two carts, before and after:

# %%
before = (1 * 2**2 + 3 * 1**2) / 2
v1_after, v2_after = collide_1d(1, 2, 3, -1, restitution=0.7)
after = (1 * v1_after**2 + 3 * v2_after**2) / 2
check("energy before minus energy after", before - after, lost, tolerance=1e-12)
check("worked by hand: 1/2 · 3/4 · 0.51 · 9 J", lost, 1.72125, tolerance=1e-12)

# %% [markdown]
# ## 3 A dropped ball rises to e² of its height, every time
#
# A ball that falls from the height h reaches the floor with the speed $\sqrt{2gh}$. It leaves
# with e times that speed, so it rises to e²h. The next bounce starts from there. Write the height
# after any number of bounces:


# %%
@gap("02-height")
def height_after(height, e, bounces):
    return ...


# %%
print("after each bounce, m:", [round(height_after(1.0, 0.8, n), 4) for n in (1, 2, 3, 4, 5)])
check("the first bounce", height_after(1.0, 0.8, 1), 0.64, tolerance=1e-12)
check(
    "the fifth, bounce by bounce", height_after(1.0, 0.8, 5), bounce_heights(1.0, 0.8, 5)[4], 1e-12
)

# %% [markdown]
# Read it the other way round, and two heights tell you e.

# %%
predict("02-ruler")

# %% tags=["answer"]
# two heights, and the restitution they show
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
# $$T = t_0 + 2 t_0 (e + e^2 + e^3 + \dots) \qquad e + e^2 + e^3 + \dots = \frac{e}{1 - e}$$
#
# At the time T the ball has made infinitely many bounces, and lies still. It is called the *Zeno*
# ball, after the philosopher whose Achilles never catches the tortoise. A program that waits for
# the last bounce waits for ever. Write T:


# %%
@gap("02-rest")
def rest_time(height, restitution, gravity):
    return ...


# %%
t0 = np.sqrt(2 * 1.0 / 9.81)
flights = 2 * t0 * 0.8 ** np.arange(1, 200)
check("the sum of 199 flights", t0 + flights.sum(), rest_time(1.0, 0.8, 9.81), tolerance=1e-12)
check("the same with g = 10 m/s²", rest_time(1.0, 0.8, 10.0), np.sqrt(0.2) * 9, tolerance=1e-12)

# %% [markdown]
# In short, T is the first fall times one factor:
#
# $$T = \sqrt{\frac{2h}{g}}\;\frac{1 + e}{1 - e}$$

# %%
predict("02-longer")

# %% tags=["answer"]
# the time of rest, with e = 0.8 and e = 0.9
print(f"T = {rest_time(1.0, 0.8, 9.81):.2f} s and {rest_time(1.0, 0.9, 9.81):.2f} s")
live(
    "ch02_restitution/bounce_heights",
    "Height of a ball over time, dropped from 1 m with e = 0.8: ever lower arcs, at rest from "
    "4.06 s. You can change e, and drag the place where the ball is dropped or set its height.",
)

# %% [markdown]
# ## 5 An engine steps through time
#
# The arcs above come from a **closed form**: a formula that gives the place at any time, at once.
# Most engines have none. They move everything by a small step `dt`, look who overlaps, and apply an
# impulse. So they always find the ball a little *after* it has touched the floor. This is pymunk,
# at its usual 1/60 s:

# %%
times, stepped = drop_onto_floor(height=1.0, restitution=0.8, duration=4.5, dt=1 / 60, gravity=9.81)
closed_form = bouncing_ball(times, 1.0, 0.8, 9.81)

# %% tags=["plumbing"]
figures.heights(
    {"closed form": (times, closed_form), "pymunk, dt = 1/60 s": (times, stepped)},
    "The closed form and pymunk at 1/60 s: the same arcs at first, pymunk's drift away from "
    "bounce to bounce.",
)

# %% [markdown]
# From bounce to bounce pymunk's ball falls further behind. How much would a shorter step help?

# %%
predict("02-steps")

# %% tags=["answer"]
# the error at three time steps
errors = {}
for dt in (1 / 60, 1 / 600, 1 / 6000):
    times, stepped = drop_onto_floor(height=1.0, restitution=0.8, duration=1.5, dt=dt, gravity=9.81)
    errors[dt] = np.abs(stepped - bouncing_ball(times, 1.0, 0.8, 9.81)).mean()
    print(f"dt = 1/{1 / dt:.0f} s: mean error {errors[dt]:.4f} m")
order = np.log10(errors[1 / 60] / errors[1 / 6000]) / 2  # the step shrinks by 10 to the power 2
check("the error shrinks like dt to the power", order, 1.0, tolerance=0.2)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# About ten times smaller. Each bounce comes at the wrong moment: it is late, by up to one step.

# %% [markdown]
# ## 6 Break it on purpose: the doubled impulse on a ball
#
# Take the doubled impulse of chapter 01 and put it into a small stepping loop of our own.
# `drop_in_steps` takes the bounce rule as an argument, so you can give it the right one or a
# wrong one.

# %%
predict("02-climbs")

# %% tags=["answer"]
# the right rule and the doubled impulse, dropped from 1 m
drop = {"height": 1.0, "restitution": 0.8, "duration": 2.0, "dt": 1 / 600}
paths = {
    "right": drop_in_steps(bounce, **drop),
    "impulse doubled": drop_in_steps(wrong_bounce.doubled_impulse, **drop),
}
figures.heights(
    paths,
    "Dropped from 1 m with e = 0.8: with the right rule the ball bounces lower and lower, with "
    "the doubled impulse it shoots up to over 6 m.",
)

# %% tags=["answer"]
# the factor of the energy at each bounce
speed_after = wrong_bounce.doubled_impulse(np.array([0.0, -1.0]), np.array([0.0, 1.0]), 0.8)[1]
check("each bounce multiplies the energy by", speed_after**2, 6.76, tolerance=1e-12)
check("the right factor is", bounce((0, -1), (0, 1), 0.8)[1] ** 2, 0.64, tolerance=1e-12)

# %% [markdown]
# The doubled impulse acts like an e of 2.6. In the functions of this course e must lie between 0
# and 1, because any larger one makes energy at every bounce:

# %%
try:
    bounce((0, -1), (0, 1), restitution=2.6)
except ValueError as error:
    print(error)

# %% [markdown]
# Other faults are quieter. Suppose somebody takes e for an *energy* ratio: the ball still comes to
# rest, nothing explodes, and you see nothing wrong. But your own `restitution` finds it:

# %%
v1_after, v2_after = wrong.energy_restitution(1.0, 2.0, 3.0, -1.0, 0.25)
measured = restitution(2, -1, v1_after, v2_after)
print(f"asked for e = 0.25, measured e = {measured:.3f}")
check("it is the square root of what was asked for", measured, 0.25**0.5, tolerance=1e-12)

# %% [markdown]
# ## 7 A slow ball bounces, too
#
# Some engines set e to 0 below a certain speed, so that things come to rest sooner. In such an
# engine a slow ball does not bounce at all. pymunk has no such threshold, and this course has none
# either. A ball at 0.9 m/s with e = 1 comes back at 0.9 m/s:

# %%
check("a slow ball bounces too", bounce((0, -0.9), (0, 1), restitution=1)[1], 0.9, tolerance=1e-15)

# %% [markdown]
# ## 8 Quiz

# %%
show_quiz("02")

# %% [markdown]
# ## 9 Key takeaways
#
# - e is the speed of separation over the speed of approach. It belongs to the pair.
# - Speeds shrink by e, and energies and heights by e².
# - A bouncing ball makes infinitely many bounces and rests after a finite time.
# - An engine that steps in time bounces late, by up to a step: its error shrinks in proportion to
#   the step.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** restitution and energy against numbers worked by hand; heights and time of
# rest against their series; pymunk's error against the closed form, which shrinks in proportion
# to the step.
#
# **Limits.** Real balls lose a little more the faster they hit, so e falls as the impact gets
# faster. A ball that spins or slides needs friction too (chapter 05).
#
# **Do now:** the exercise [02 Restitution](../exercises/02_restitution.ipynb): four tasks,
# thirteen points. In a terminal, `workbook watch 02` runs it again whenever you save. In
# `workbook play demo` the arrow keys change the restitution of everything on the screen; the
# challenge that lives on it is [exercises/breakout.py](../exercises/breakout.py). **Next:** [03
# Reflection](03_reflection.ipynb).
#
# **Sources.** Newton, *Principia* (1687), scholium to the laws of motion (the ratio of speeds).
# Goldsmith, *Impact* (1960), on measured restitution.
