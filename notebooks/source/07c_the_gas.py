# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 07c The gas
#
# A bicycle pump pushes back when you press it, because molecules hit its walls again and again.
# Here 144 discs do the same in a box. After a while nobody can say where one of them is, and yet
# you can predict their pressure to a few per cent. Then you see what such a simulation costs, and
# break the time of impact in two ways.
#
# **After this notebook you will be able to**
#
# 1. work out the pressure of a gas from the blows on its walls, and compare it with theory;
# 2. say what an exact simulation costs, and which scenes allow it;
# 3. recognise two faults in a time of impact by what they do.
#
# **You need** notebooks 07 and 07b. **Time:** about 25 minutes to read and to write two lines, a
# few seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, simulate
from lesson_code.chapters.ch07_time_of_impact import scenes
from lesson_code.chapters.ch07_time_of_impact import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.evidence.scenes import events, rigid_bodies
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.formulas.smooth_pair import smooth_impulse
from lesson_code.geometry import time_of_impact
from lesson_code.reference import event_closed_forms
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

# %% [markdown]
# ## 13 A gas
#
# Many discs that only collide are a gas. What a gas does on average is not chaotic, so you can
# compare it with theory. Begin with its **pressure**. Each disc that bounces off a wall hands it an
# impulse, and a thousand small blows feel like a steady push. In the plane a pressure is a force on
# each metre of wall, in N/m. Write it. `impulses` is an array of all the impulses that walls with a
# `length`, in m, have received within some `seconds`:


# %%
@gap("07-pressure")
def pressure(impulses, seconds, length):
    return ...


# %% [markdown]
# What should it be? A gas of points, N of them in the area A, would press with p A = N T, where T
# is the mean energy of one. Discs need room, and press more, by the factor Z. If they cover the
# part $\eta$ of the area, Henderson's formula says
#
# $$Z = \frac{p A}{N T} = \frac{1 + \eta^2/8}{(1 - \eta)^2}$$
#
# **Collisions:** Enskog's theory says how often a disc meets another one. Look at 144 discs in a
# box. N, A and the collisions are those of its middle, since near the walls a gas is denser. And no
# disc can touch a wall within half a metre, its radius, of a corner. You count about a thousand
# blows, so chance leaves an error of a few per cent. To halve it you need four times as many.

# %%
measured, pressures = [], []
for covered, duration in ((0.05, 150.0), (0.12, 100.0), (0.2, 80.0), (0.3, 60.0)):
    gas = gas_scenes.disc_gas(12, covered, seed=1)
    run = simulate(gas, duration, solver="exact", sample=np.arange(0, duration, 0.25))
    measured.append(scenes.in_the_middle(run, since=4.0))
    hits = run.contacts
    side = np.sqrt(144 * np.pi / 4 / covered)  # of the box: a disc covers pi/4 m²
    on_walls = (hits.body_a < events.WALLS) & (hits.time > 4.0)  # the walls are bodies 0 to 3
    blows = hits.normal_impulse[on_walls]
    pressures.append(pressure(blows, duration - 4.0, 4 * (side - 1.0)))

# %%
eta = np.array([m.covered for m in measured])
z = np.array(pressures) / (eta / (np.pi / 4) * gas_scenes.ENERGY)
rate = np.array([m.collision_rate for m in measured])
henderson = [event_closed_forms.hard_disc_compressibility(e) for e in eta]
enskog = [event_closed_forms.hard_disc_collision_rate(e, 1, 1, 1) for e in eta]
check("Z over Henderson's", z / henderson, 1, tolerance=0.08)
check("rate over Enskog's", rate / enskog, 1, tolerance=0.08)

# %% tags=["plumbing"]
shares = np.linspace(0, 0.36, 100)
fig, ax = style.figure(width=7, height=3.2)
law = [event_closed_forms.hard_disc_compressibility(e) for e in shares]
plots.curves(ax, {"Henderson": (shares, law)}, "part of the area covered", "p A / (N T)")
ax.plot(eta, z, "o", color=style.VERMILION, label="measured")
ax.legend(frameon=False)
show(
    fig,
    "Pressure over that of points, over the covered part of the area. It rises from 1 to 2.5. Four "
    "measured dots lie on Henderson's curve, but for their noise.",
)

# %% [markdown]
# ## 14 What it costs, and what it cannot do
#
# A stepped engine pays for every step, whether anything happens in it or not. The exact solver pays
# for every collision. (Chapter 08 sets both prices beside the errors.) What if there are many
# discs? A collision spoils the predictions of two discs only. And to predict the next event of a
# disc, the solver looks only at its neighbourhood: it divides the box into **cells**, and crossing
# into the next cell is an event too. So among a thousand discs a collision has no more neighbours
# to look at than among sixty. (The times are those of one machine; yours will differ.)

# %% tags=["nbval-ignore-output"]
for side, duration in ((8, 8.0), (16, 4.0), (32, 2.0)):
    each, collisions = scenes.microseconds_a_collision(side, duration)
    print(f"{side * side:5} discs: {collisions:5} collisions, {each:4.0f} µs each")

# %% [markdown]
# Why not do everything this way? Because it needs a formula for the motion between collisions, and
# few collisions. For a turning polygon there is no formula for the time of impact. A pile at rest
# has contacts all the time. And a ball on a ball, pressed on by gravity, would make infinitely many
# collisions; the solver lets it hop a little. It says no where it cannot help:

# %%
try:
    simulate(rigid_bodies.box_stack(3), 1.0, solver="exact")
except ValueError as error:
    print(error)

# %% [markdown]
# ## 15 Break it on purpose: two faults
#
# Both lie in the time of impact, the root of section 3.
#
# **The other root.** The quadratic has two roots. Take the two circles of section 3 again. They
# first touch after 2 s.

# %%
still = (0, 0, 0)
one, place_1, velocity_1 = Circle(2.0), (0, 0, 0), (3, 0, 0)  # the third numbers: angle, spin
two, place_2, velocity_2 = Circle(3.0), (14, 3, 0), (-2, 0, 0)

# %%
predict("07-later-root")

# %% tags=["answer"]
# both roots
p1, v1, p2, v2 = np.zeros(2), np.array([3.0, 0.0]), np.array([14.0, 3.0]), np.array([-2.0, 0.0])
first = time_of_impact(one, place_1, velocity_1, two, place_2, velocity_2, duration=10)
later = wrong.the_later_root(p1, v1, 2.0, p2, v2, 3.0, 10.0)
for name, t in (("first root", first), ("later root", later)):
    n = (p2 + v2 * t - p1 - v1 * t) / 5  # at both times the centres are r1 + r2 = 5 m apart
    j = np.hypot(*smooth_impulse(v1, 1.0, v2, 1.0, n, restitution=1.0))
    print(f"{name}: t = {t:.1f} s, vn = {(v2 - v1) @ n:+.1f} m/s, impulse {j:.1f} N s")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# A program without a gate would pull them back together.

# %% [markdown]
# **A time in the past.** Two circles that part have met before, if they flew like that for ever.
# The quadratic says when: at a t below 0. A program that asks only `t <= dt` lets it pass.

# %%
t = wrong.negative_time(p1, -v1, 2.0, p2, -v2, 3.0, 6.0)
print(f"they will meet in {t:.1f} s")
check("never", time_of_impact(one, place_1, (-3, 0, 0), two, place_2, (2, 0, 0), 6.0), None)

# %% [markdown]
# A program that goes "to the impact" then flies two circles *back* to where they were three seconds
# and more ago. An event-driven simulation gets stuck: the earliest event of all is in the past, and
# after it the same event comes again. So ask first: do they come nearer at all? Write the question.
# `d` is the way from circle 1 to circle 2, and `v` the velocity of 2 seen from 1; both are arrays.


# %%
@gap("07-nearer")
def come_nearer(d, v):
    return ...


# %% [markdown]
# This is b < 0. It turns away both faults: circles in the past, and those at the later root, which
# are on their way out. It also keeps you from 0/0 where they fly side by side.

# %%
d, v = p2 - p1, v2 - v1
check("two that will meet come nearer", come_nearer(d, v), True)
check("two that part do not", come_nearer(d, -v), False)
check("nor do they at the later root", come_nearer(d + v * later, v), False)
check("nor side by side", come_nearer(d, 0 * v), False)
t = wrong.negative_time(p1, -v1, 2.0, p2, -v2, 3.0, 6.0) if come_nearer(d, -v) else None
check("with your gate, those that part never meet", t, None)

# %% [markdown]
# ## 16 Quiz

# %%
show_quiz("07")

# %% [markdown]
# ## Key takeaways
#
# - A program that looks at the ends of steps misses the part 1 - (r + th/2)/(v dt) of fast balls.
#   Looking more often moves that border and costs time.
# - The time of impact of two circles is the smaller root of a quadratic, in the form that does not
#   subtract near numbers. "Never" is `None`, and "now" is 0.0.
# - Move to the impact, bounce, and go on with the rest of the step.
# - Where motion between collisions has a formula, steps are not needed at all: go from event to
#   event.
# - A gas of discs is chaotic. Compare what is not: energy, momentum, pressure, a law.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** in the three parts of the chapter, the law of tunnelling against pymunk at ten
# speeds; the law of lost hits against 16,000 pairs; times of impact by hand and to fifty digits;
# the digits of pi up to 31,415; a ball in a box for 1,000 s and the last bounce of a ball against
# closed forms; a gas that runs backwards, and one against Henderson's and Enskog's formulas.
#
# **Limits.** The exact solver takes discs and fixed walls only. A gas of discs is chaotic: after
# some forty-five collisions each, no simulation can say where a single disc is. And real bodies do
# not bounce at an instant: they are in touch for a thousandth of a second.
#
# **Do now:** the exercise [07 Time of impact](../exercises/07_time_of_impact.ipynb): five tasks,
# twenty-two points. `workbook watch` checks it whenever you save. `workbook play breakout` flies
# from impact to impact, and [its challenge](../exercises/breakout.py) lets you write the flight.
# **Next:** [08 What accuracy costs](08_what_accuracy_costs.ipynb): accuracy and time, weighed
# against each other.
#
# **Sources.** Ericson, *Real-Time Collision Detection* (2005), chapter 5: moving shapes. Galperin,
# *Playing pool with pi*, Regular and Chaotic Dynamics 8 (2003), 375. Alder and Wainwright, *Studies
# in Molecular Dynamics I*, Journal of Chemical Physics 31 (1959), 459: from event to event.
# Henderson, Molecular Physics 30 (1975), 971: hard discs. Bannerman and others, Computational
# Particle Mechanics 1 (2014), 191: what to do when discs overlap by rounding.
