# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 10 Only what the scene needs
#
# Your phone draws a game sixty times a second, and its battery pays for all that the engine works
# out, needed or not. In this chapter you guess what a scene needs before the engine tells you. Then
# you put your guess to a hard test: you compare results bit by bit.
#
# **After this notebook you will be able to**
#
# 1. say of a scene which effects it calls for, and why;
# 2. prove that an effect is superfluous, to the last bit, and find one that only looks so;
# 3. say what leaving it out saves.
#
# **You need** notebooks 00 to 07. **Time:** about 40 minutes to read, to guess and to write two
# lines, with the appendices; ten seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, Polygon, simulate
from lesson_code.chapters.ch10_only_what_the_scene_needs import plan_figures, scenes
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.engine.effects.continuous import fastest_way
from lesson_code.evidence import check
from lesson_code.evidence.chaos import displaced
from lesson_code.evidence.effect_costs import stored

# %% tags=["plumbing"]
from lesson_code.evidence.scenes import discs, rigid_bodies
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.evidence.speed.whole_runs import WholeRuns
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 Guess the plan
#
# An **effect** is something that an engine can work out or leave out: gravity, friction, rotation.
# Each one costs time. You can often tell before anything moves which ones a scene needs.

# %%
predict("10-gas")

# %% tags=["answer"]
# the plan of the gas
gas = gas_scenes.disc_gas(4, covered=0.3, seed=1)
run = simulate(gas, 3.0, solver="sequential")
print(run.plan)

# %% [markdown]
# This is a **plan**: a verdict on each effect, with its reason. The engine makes it before the
# first step, from masses, coefficients and velocities.
#
# Now you. Change the guess for each scene below, and run the cell until every score is 6 of 6. It
# does not say which of the six are right:
#
# - `gravity`, `friction` (two bodies rub), `restitution` (something bounces);
# - `rotation` (something turns), `manifolds` (two bodies touch at two points, as boxes do);
# - `continuous` (a body may get so fast that a step carries it through another one).

# %%
slope = rigid_bodies.disc_on_incline(0.3, 0.2)  # rough, restitution 0
pool = discs.rack_break(0.95)  # smooth balls seen from above, a fast cue ball
tower = rigid_bodies.box_stack(5)  # rough boxes on a floor, restitution 0

print("a disc down a slope:", scenes.score({"gravity", "restitution"}, slope))
print("a break at pool:    ", scenes.score({"restitution", "friction"}, pool))
print("a tower of boxes:   ", scenes.score({"gravity"}, tower))

# %%
predict("10-needs-most")

# %% tags=["plumbing", "answer"]
# the plans of all of them
planned = {
    "two discs,\nside by side": scenes.side_by_side(),
    "smooth\ngas": gas,
    "break\nat pool": pool,
    "disc down\na slope": slope,
    "tower of\nfive boxes": tower,
}
fig, ax = style.figure(width=8, height=5.2)
plan_figures.plans(
    ax, {name: simulate(s, 2.0, solver="sequential").plan for name, s in planned.items()}
)
show(
    fig,
    "A table of sixteen effects and five scenes; a full dot is an effect that is simulated, a ring "
    "one that is left out. Two discs side by side need nothing. The gas needs seven effects, the "
    "break eight, the slope ten and the tower eleven.",
)

# %% [markdown]
# The engine puts a program together from each plan. What the plan leaves out is not skipped there;
# it is not in the program at all.

# %%
for switched_on in (False, True):
    plan = simulate(gas, 1 / 60, solver="sequential", effects={"friction": switched_on}).plan
    is_there = "friction_impulse" in plan.source()
    check(f"friction {switched_on}: its function is there", is_there, switched_on)

# %% [markdown]
# ## 2 Behind each guess stands a rule about pairs
#
# Why can a smooth disc do without rotation? Every impulse on it goes through its centre and turns
# nothing. Most reasons in a plan are of this kind: the effect would only add 0 or multiply by 1.
#
# Many rules ask about *pairs*: a material belongs to one body, but a contact has two. Its e is the
# smaller of theirs. Its mu is their geometric mean, which is 0 as soon as one of them is 0. Write
# it:


# %%
@gap("10-pair")
def friction_of_pair(mu_a, mu_b):
    return ...


# %%
check("a rough disc on ice", friction_of_pair(0.6, 0.0), 0.0)
check("rubber on wood", friction_of_pair(0.9, 0.4), 0.6, tolerance=1e-12)

# %%
predict("10-smooth-box")

# %% tags=["answer"]
# the verdicts
for title, shape, mu in (
    ("a rough disc on a smooth floor", Circle(0.5), 0.6),
    ("a smooth box on a smooth floor", Polygon.box(1, 1), 0.0),
):
    print(f"{title}: by your line, the mu of the pair is {friction_of_pair(mu, 0.0):g}")
    print(scenes.verdicts(scenes.thrown(shape, mu), "friction", "rotation"))

# %% [markdown]
# ## 3 Put the plan to the test, bit by bit
#
# The plan of the pool break leaves friction out. Do not believe it: run the break with friction
# switched on and switched off, and compare bit by bit.

# %%
predict("10-same-bits")

# %% tags=["answer"]
# with the effect and without
scene, effect = pool, "friction"

on, off = (simulate(scene, 2.0, solver="sequential", effects={effect: x}) for x in (True, False))
print(f"{effect} on or off: {scenes.bits_apart(on, off)} of {scenes.bits_of(on):,} bits differ")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Not a single bit. A computer rounds, but some operations it never rounds: adding 0, multiplying by
# 1 or by 0. A superfluous effect does nothing else to a body.

# %% tags=["answer"]
# two operations that are never rounded
v, lever, w = 0.1, 0.7, 0.0
check("v + w r is v where w = 0", v + w * lever == v, True)
check("damping at the rate 0 multiplies by", np.exp(-0.0 * 0.016), 1.0)

# %% [markdown]
# Does this count see anything? Push one body aside by less than the width of a proton:

# %%
nudged = simulate(displaced(scene, -1, (1e-15, 0)), 2.0, solver="sequential")
print(f"one body nudged: {scenes.bits_apart(nudged, off):,} bits differ")

# %% [markdown]
# Now prove an effect of your choice superfluous: change scene and effect in the cell that counts
# the bits.
#
# Now a harder question. The rubber ball below has mu = 0.8 and e = 0.8. Which effects change its
# path on ice, on asphalt, on sand? Guess before you choose the ground. Then drop it straight down
# on asphalt (0 m/s along x): what does friction do now? And what does a second ball change on ice?

# %%
live(
    "ch10_only_what_the_scene_needs/left_out",
    "A rubber ball bounces on ice towards a wall; dotted, its path without restitution, along the "
    "ice. A list says that without friction, rotation or the watch for fast bodies not one bit "
    "changes. The velocity can be dragged; ground, balls and spin can be changed.",
)

# %% [markdown]
# Straight down on asphalt the plan calls for friction, and yet not one bit changes without it. That
# error costs only time; the other one would make the result *wrong*. So a rule must be
# **conservative**: it has to prove "not needed", and need not prove "needed".
#
# ## 4 Break it on purpose: switch off the watch for fast bodies
#
# A body that moves by more than half its width in a step may jump through a wall (chapter 07). The
# effect `continuous` watches for that. In the next scene nothing is so fast. May you switch it off?

# %%
predict("10-light-ball")

# %% tags=["answer"]
# three solvers
hit = scenes.heavy_on_light()
shot = {name: simulate(hit, 0.33, solver=name) for name in ("naive", "pymunk", "sequential")}
places = {name: (r.times, r.positions[:, 2, 0]) for name, r in shot.items()}

# %% tags=["answer", "plumbing"]
# three solvers
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, places, "time, s", "x of the light ball, m")
ax.axhline(1.45, color=style.GREY, linewidth=1, linestyle="-.")
ax.text(0.0, 1.48, "wall", color=style.GREY, fontsize=9)
show(
    fig,
    "The light ball lies still until 0.12 s and then flies off at 8 m/s. At 0.3 s it reaches the "
    "wall. In the naive solver and in pymunk it flies through; in ours it turns back.",
)

# %% tags=["answer"]
# three solvers
behind = {name: bool(r.positions[-1, 2, 0] > 1.45) for name, r in shot.items()}
check("behind the wall", list(behind.values()), [True, True, False])

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The light ball leaves with nearly twice the heavy one's speed (chapter 01), makes 13 cm in a step,
# and jumps the wall between two looks.

# %% [markdown]
# Our engine refuses to leave the effect out:

# %%
try:
    simulate(hit, 0.33, solver="sequential", effects={"continuous": False})
except ValueError as refused:
    print(refused)

# %% [markdown]
# ## 5 How fast can a body become?
#
# How does it know before the hit? Impacts change speeds. But where there is no gravity, no driven
# wall and no corner that rubs (chapter 09), the *energy* of all bodies never grows. At worst the
# lightest body gets all of it. How fast is it then?


# %%
@gap("10-fastest")
def fastest(energy, lightest):
    return ...


# %% [markdown]
# Here all bodies together have 800 J, and the lightest has 0.01 kg. The rule compares your bound,
# times 1.5 to be safe, with half the width of the thinnest body.

# %%
way, _ = fastest_way(hit, dt=1 / 60)
check("your bound, m in a step", fastest(800, 0.01) / 60, way, tolerance=1e-12)

# %% [markdown]
# With gravity there is no such bound, and the engine always watches.
#
# ## 6 What it saves, and what you wait for
#
# How much time does a superfluous effect cost? The times are stored, since they differ in each run;
# `workbook measure effects` takes them on your machine.

# %%
predict("10-worth")

# %% tags=["answer"]
# the stored result
for cost in stored().in_code("compiled"):
    if cost.effect in ("gravity", "restitution", "friction", "all effects"):
        ratio = cost.forced / cost.left_out
        print(f"{cost.effect:11} {ratio:.2f} times the time ({cost.difference})")
pymunk = stored().of("friction", "pymunk")
print(f"pymunk's time with mu and without: {pymunk.needed / pymunk.left_out:.2f} to 1")

# %% [markdown]
# A ratio below 1 tells you how well such times can be measured. pymunk has one program for all
# scenes, and works out friction even where every mu is 0.
#
# But you wait for more than steps: for Python, the import, the plan. So look at whole runs of a
# gas, from the start of Python to the result. Ours finds the machine code that an earlier run has
# kept. (Where none is kept, a program with every effect is used, which comes with the workbook: to
# compile the plan's own takes half a minute, and saves what the lines "all effects" above say.)

# %%
predict("10-from-how-many")

# %% tags=["answer"]
# the stored result, in seconds of one core
runs = WholeRuns.stored()
for count in (10, 100, 1_000, 10_000, 100_000):
    ours, theirs = (runs.of(f"run-gas-{count}", who) for who in ("ours, kept", "pymunk"))
    print(f"{ours.scene:20}: ours {ours.cpu:6.3f} s, pymunk {theirs.cpu:6.3f} s")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# With ten discs nearly all of the time is the start, and the smaller program wins: pymunk. It stays
# ahead up to 1,000 discs. From 10,000 on the collisions decide, and ours goes from one to the next.

# %% [markdown]
# `workbook measure speed` takes these times on your machine, for piles too, and for Box2D.
#
# ## 7 Quiz
#
# The last question is about section 9.

# %%
show_quiz("10")

# %% [markdown]
# ## Key takeaways
#
# - What a scene needs follows from pairs of coefficients, from shapes, from the energy.
# - "Superfluous" means that not one bit changes, with the effect or without.
# - A rule has to be conservative. To call for too much costs time; to call for too little is wrong.
# - A slow body may be fast after the next impact; the energy bounds how fast.
#
# ## 8 Appendix: can two flights meet?
#
# A cheap rule puts a **box** around each flight. If two boxes share no point, their discs cannot
# meet. If they share a part, the discs may still pass it at different times, and the rule calls for
# collisions all the same: it errs on the harmless side.
#
# ## 9 Appendix: islands that sleep
#
# The engine works out the contacts of a body at rest, to learn that nothing happens. So it lets
# bodies **sleep**, an island at a time. An **island** is a set of bodies that hang together by
# contacts. Static bodies join none: a floor passes no push on. An island sleeps when all its bodies
# have been still for a second. A body that is awake and touches it wakes all of it.

# %%
towers = scenes.three_towers()
rest = simulate(towers, 8.0, solver="sequential")
times, asleep = scenes.asleep_in_time(towers, 8.0)
for second in (0.5, 3.0, 8.0):
    print(f"asleep after {second} s: {asleep[np.searchsorted(times, second - 1e-9)].sum()} of 9")
animate(
    rest,
    "Three towers of three boxes. A disc rolls in from the left and hits the first one. Its boxes "
    "move a little, and the disc stays beside it.",
    around=(-9, 6, -0.3, 4),
    still=4.2,
)

# %% [markdown]
# The hit wakes one tower. Sleep alone does change bits: a body at rest keeps a rounding error of
# what gravity gives it in a step, and sleep takes that away. Nobody can see it:

# %%
awake = simulate(towers, 8.0, solver="sequential", effects={"sleeping": False})
check("with and without sleep, m", rest.positions, awake.positions, tolerance=1e-6)

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** friction in the pool break, to the last bit; the bound on speed; sleep, to a
# millionth of a metre. The tests check every effect in many drawn scenes, in plain Python and
# compiled.
#
# **Do now:** the exercise [10 Only what the scene
# needs](../exercises/10_only_what_the_scene_needs.ipynb): five tasks, twenty points; for the last
# two read sections 8 and 9. `workbook watch` checks it whenever you save. `workbook play simulator`
# shows the plan of what you build in it; the challenge [soft_body](../exercises/soft_body.py) is a
# body that bends. **Next:** [11 The small engine](11_the_small_engine.ipynb): all that you have
# written, put together.
#
# **Sources.** Catto, *Island sleeping* and *Continuous collision*, documentation of Box2D v3.
# Goldberg, *What every computer scientist should know about floating-point arithmetic*, ACM
# Computing Surveys 23 (1991), 5: which operations are exact.
