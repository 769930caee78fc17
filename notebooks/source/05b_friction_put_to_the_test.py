# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 05b Friction put to the test
#
# A single wrong sign in the friction, and your program still runs. Would you notice? Here you learn
# to find such a line: slopes have answers that you can work out, and the laws tell you the rest, if
# you ask the right one.
#
# **After this notebook you will be able to**
#
# 1. say when a body on a slope rolls, stays or tips, and hold an engine to it;
# 2. say when you may claim that energy never grows;
# 3. find three faults of friction, each by the test that shows it.
#
# **You need** notebook 05. **Time:** about 30 minutes to read and to write two lines, a few seconds
# to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, Polygon
from lesson_code.chapters.ch05_spin_and_friction import figures, scenes
from lesson_code.chapters.ch05_spin_and_friction import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.evidence.scenes import slopes
from lesson_code.evidence.scenes.spinning_discs import Disc
from lesson_code.formulas import kinetic_energy
from lesson_code.reference import rigid_body_closed_forms
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

# %% [markdown]
# ## 8 Three slopes: roll or slip, stay or slide, stand or tip
#
# Put a body on a slope with the angle θ. What it does depends on its shape and on μ:
#
# - A **box** stays if $\mu \ge \tan\theta$. Otherwise it slides, and speeds up by $g(\sin\theta -
#   \mu \cos\theta)$.
# - A **round body** rolls down if friction can turn it fast enough. Then it speeds up by $g
#   \sin\theta/(1 + k)$; k = I/(m r²) is 1/2 for a disc and 1 for a hoop.
# - A **tall box** that cannot slide tips over when its centre of mass is no longer above its
#   base.
#
# How much friction does the round body need? Gravity pulls it down the slope with
# $m g \sin\theta$, and that is more than m times its acceleration: friction holds back the rest.
# At most it can give $\mu\, m g \cos\theta$. Write the smallest μ with which the body rolls;
# `slope` is in radians.


# %%
@gap("05-roll-down")
def friction_to_roll(slope, k):
    return ...


# %%
predict("05-heavier")

# %% tags=["answer"]
# slopes by the closed form and by two engines
roll_down, slide_down = rigid_body_closed_forms.roll_down, rigid_body_closed_forms.slide_down
box = Polygon([(-0.5, -0.25), (0.5, -0.25), (0.5, 0.25), (-0.5, 0.25)])
mu_disc, mu_box = np.linspace(0, 0.3, 16), np.linspace(0, 0.8, 17)
exact_disc = [roll_down(np.radians(20), 1 / 2, mu, slopes.GRAVITY)[0] for mu in mu_disc]
exact_box = [slide_down(np.radians(30), mu, slopes.GRAVITY) for mu in mu_box]
on_disc, on_box = {}, {}
for solver, tolerance in (("sequential", 1e-9), ("pymunk", 1e-3)):
    on_disc[solver] = [scenes.acceleration(Circle(0.5), 20, mu, solver) for mu in mu_disc]
    on_box[solver] = [scenes.acceleration(box, 30, mu, solver) for mu in mu_box]
    check(f"disc, {solver}", np.subtract(on_disc[solver], exact_disc), 0, tolerance=1e-9)
    check(f"box, {solver}", np.subtract(on_box[solver], exact_box), 0, tolerance)
heavy = scenes.acceleration(box, 30, mu_box[4], mass=10.0)
check("a box of ten times the mass, m/s²", heavy, exact_box[4], tolerance=1e-9)

# %% tags=["answer", "plumbing"]
# slopes by the closed form and by two engines
fig, (left, right) = style.figure(2, width=9.5, height=3.4)
left.axvline(friction_to_roll(np.radians(20), 1 / 2), color=style.GREY, linestyle="-.")
for ax, mu, exact, found, title in (
    (left, mu_disc, exact_disc, on_disc, "a disc at 20°"),
    (right, mu_box, exact_box, on_box, "a box at 30°"),
):
    measured = {
        "ours": (mu[::2], found["sequential"][::2]),
        "pymunk": (mu[1::2], found["pymunk"][1::2]),
    }
    labels = ("friction coefficient", "speeds up by, m/s²")
    figures.measured_on_curves(ax, {"closed form": (mu, exact)}, measured, *labels)
    ax.set(title=title, ylim=(-0.2, 5.5))

# %% tags=["answer", "plumbing"]
# slopes by the closed form and by two engines
show(
    fig,
    "How much a disc and a box speed up on a slope, over the friction coefficient. Both fall in a "
    "straight line at first. The disc's line ends at a friction of 0.12, at a vertical line: from "
    "there on it rolls, with 2.24 m/s². The box's line ends at 0.58, tan 30°: from there on it "
    "stays. The points of both engines lie on the lines.",
)

# %% [markdown]
# The vertical line is your μ. pymunk's box, at its usual 10 iterations, creeps at less than 0.1
# mm/s where it should stay.
#
# The third slope is a balance on an edge, and asks more of a solver. The box stands on two
# contacts, and what happens at one changes what the other needs. At which slope does a box tip?
# Write it, in radians:


# %%
@gap("05-tips")
def slope_to_tip(width, height):
    return ...


# %%
expected = np.degrees(slope_to_tip(0.5, 1.0))
for solver in ("sequential", "pymunk"):
    ten = scenes.tipping_angle(0.5, 1.0, solver=solver, iterations=10)
    print(f"{solver}, 10 sweeps over the contacts: off by {ten - expected:+.1f} degrees")
    fifty = scenes.tipping_angle(0.5, 1.0, solver=solver, iterations=50)
    check(f"{solver}, 50 sweeps", fifty, expected, tolerance=0.1)

# %% [markdown]
# A **sweep** is one round over all contacts. With ten of them our box tips a tenth of a degree
# early; with fifty both engines are right. Chapter 06 shows why two contacts need sweeps at all.
#
# ## 9 Two rules in one blow
#
# You know two rules that can only lose energy: e < 1, and friction. What happens if both act in the
# same blow, off centre?

# %%
predict("05-gain")

# %% tags=["answer"]
# the energy after over the energy before
for v_x in (0.0, 0.5, 1.0):
    for solver in ("sequential", "pymunk"):
        ratio = scenes.energy_kept_by_leaning_rod(v_x, solver)
        print(f"{solver:10}, sliding at {v_x} m/s: energy times {ratio:.3f}")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Yes: at 0.5 m/s it has eight per cent more. The floor's push turns the rod, and the tip swings to
# the left. Friction holds it, which turns the rod back and drives the tip into the floor. So the
# floor has to push harder, until the tip leaves with e times its approach, as Newton's rule
# demands. Both engines agree, so the fault is not in a program. It is in the rule.
#
# So this course claims "energy never grows" only where it is true: without friction, with e = 0, or
# with **Stronge's** rule, which compares energies and not velocities. `simulate(scene, T)` takes
# Stronge's wherever it solves contacts at once. Chapter 09 breaks Newton's rule in earnest.
#
# ## 10 Break it on purpose: three faults of friction
#
# All three stood in the web lesson that this course grew from.
#
# **The torque with the wrong sign.** A disc bounces on a rough floor without loss (e = 1). After
# each bounce it falls back as fast as it rose. The right rule stops the sliding in one bounce. Now
# swap lever and impulse in the torque.

# %%
predict("05-wrong-torque")

# %% tags=["answer"]
# the sliding after each bounce
rules = {
    "right": scenes.bounce_with_spin,
    "torque with the wrong sign": wrong.torque_with_the_wrong_sign,
    "as if it could not turn": wrong.rim_as_heavy_as_the_disc,
}
slidings = {name: scenes.sliding_over_bounces(rule) for name, rule in rules.items()}
for name, (_, sliding) in slidings.items():
    print(f"{name:27}", " ".join(f"{round(v, 2) + 0.0:+6.2f}" for v in sliding))

# %% tags=["answer", "plumbing"]
# the sliding after each bounce
fig, ax = style.figure(width=7.5, height=3.6)
plots.curves(ax, slidings, "bounces", "sliding at the floor, m/s")
for line in ax.lines:
    line.set_marker("o")
ax.legend(loc="upper left", frameon=False)
show(
    fig,
    "Sliding at the floor over five bounces. With the right rule it is 3 m/s at first and 0 from "
    "the first bounce on. With the wrong sign of the torque it grows with every bounce, to 11.9 "
    "m/s. With the other wrong model it changes its direction each time and does not die out.",
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# With the wrong sign it grows with every bounce. A second wrong model has the right sign, but stops
# the sliding as if the disc could not turn. It overshoots, again and again.

# %%
predict("05-which-law")

# %% tags=["answer"]
# energy and angular momentum after one bounce
up = np.array([0.0, 1.0])
start = np.array([3.0, -4.0]), 0.0, 0.5, up, 1.0, 0.3  # v, w, radius, normal, e, mu
for name in ("right", "torque with the wrong sign"):
    velocity, w = rules[name](*start)
    after = Disc(1.0, 0.5, 0.5 * up, velocity, w)
    energy = kinetic_energy(1.0, velocity, after.inertia, w)
    print(f"{name:27} energy 12.5 -> {energy:.1f} J, ", end="")
    print(f"angular momentum -1.5 -> {after.angular_momentum((0, 0)):+.1f} kg m²/s")

# %% [markdown]
# **No clamp, and a dead band.** Here are two wrong models of the friction impulse. The first always
# stops the sliding, so ice grips as well as rubber. The second saves itself the work for bodies at
# rest: it ignores any sliding below 0.01 m/s.

# %% tags=["plumbing"]
fig, axes = style.figure(2, width=9.5, height=3.4)
for ax, fastest, (name, rule) in zip(
    axes,
    (6.0, 0.03),
    (("no clamp", wrong.without_clamp), ("dead band", wrong.dead_band)),
    strict=True,
):
    v = np.linspace(-fastest, fastest, 1201)
    both = {"right": scenes.coulomb, name: rule}
    curves = {label: (v, [f(vt, 4.0, 0.5, 1.0) for vt in v]) for label, f in both.items()}
    plots.curves(ax, curves, "sliding before, m/s", "friction impulse, N s")

# %% tags=["plumbing"]
show(
    fig,
    "Friction impulse over the sliding. Left: the right rule is a ramp between two limits; without "
    "the clamp the line goes on for ever. Right, close to zero: the right rule is a straight line; "
    "the dead band is zero between -0.01 and 0.01 m/s and jumps there.",
)

# %% [markdown]
# What do they cost? Put a block on two slopes: a rough one of 5°, where it should stay, and an icy
# one of 30°, where it should be 224 m away after 10 s.

# %%
predict("05-dead-band")

# %% tags=["answer"]
# ten seconds on two slopes
rules = {"right": scenes.coulomb, "no clamp": wrong.without_clamp, "dead band": wrong.dead_band}
for name, rule in rules.items():
    rough = scenes.block_in_steps(rule, degrees=5, friction=0.5, duration=10)
    icy = scenes.block_in_steps(rule, degrees=30, friction=0.05, duration=10)
    print(f"{name:9}: {100 * rough:4.1f} cm down the rough slope, {icy:5.1f} m down the icy one")

# %% [markdown]
# Without the clamp, ice holds a block at 30°.
#
# ## 11 Quiz

# %%
show_quiz("05")

# %% [markdown]
# ## Key takeaways
#
# - A point of a body moves with the centre **and** around it: v + w (-r_y, r_x). What counts at a
#   contact is the difference of two such velocities.
# - Off centre a body gives way by turning, so its effective mass is smaller there.
# - Friction stops the sliding or fails at μ j_n. It never turns a sliding round.
# - About the contact the floor has no lever arm: that angular momentum is kept, and it notices a
#   wrong sign that the energy cannot see.
# - A body that slides on a rough floor ends up rolling, at v_0/(1 + k), whatever μ is.
# - Newton's e and Coulomb's μ together can make energy. Neither does so alone.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** in both parts of the chapter, whole impacts of 2,000 random pairs of discs
# against pymunk, to 1e-13 of the fastest speed; the angular momentum about the contact; rolling,
# slopes, tipping and the rod's end against closed forms, in our engine and in pymunk; your four
# lines on random numbers.
#
# **Limits.** Coulomb's rule is itself a rough picture of real surfaces: static and sliding
# friction are one number here, and nothing rubs against rolling. A real superball gives along the
# floor, too, and springs back: it can turn a sliding round.
#
# **Do now:** the exercise [05 Spin and friction](../exercises/05_spin_and_friction.ipynb): five
# tasks, twenty points. `workbook watch` checks it whenever you save. `workbook play pool` has
# cushions that turn spin into velocity, and [its challenge](../exercises/pool.py) lets you write
# the stroke. **Next:** [06 SAT and manifolds](06_sat_and_manifolds.ipynb), where polygons touch at
# two points.
#
# **Sources.** Coulomb, *Théorie des machines simples* (1785). Kane and Levinson, *Dynamics:
# Theory and Applications* (1985): the energy that Newton's rule can make. Stronge, *Impact
# Mechanics* (2000). Catto, *Iterative Dynamics with Temporal Coherence* (2005): the clamp in an
# engine.
