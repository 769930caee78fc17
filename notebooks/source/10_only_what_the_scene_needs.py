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
# Your phone runs a game at sixty frames a second, and its battery pays for everything the engine
# works out, needed or not. Smooth discs pay for friction, a ball in flight pays for stacks. Here
# you guess what a scene needs before the engine tells you, and then you prove that the rest may go.
#
# **After this notebook you will be able to**
#
# 1. say of a scene which effects it calls for, and give the reason for each;
# 2. prove that what is left out changes nothing, not even the last digit;
# 3. say what leaving it out saves, and where it saves nothing.
#
# **You need** notebooks 00 to 07. **Time:** about 35 minutes to read, to guess and to write two
# lines; ten seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, Polygon, simulate
from lesson_code.chapters.ch10_only_what_the_scene_needs import figures, plan_figures, scenes
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.engine.effects.collisions import can_meet
from lesson_code.engine.effects.continuous import fastest_way
from lesson_code.evidence import check
from lesson_code.evidence.effect_costs import stored

# %% tags=["plumbing"]
from lesson_code.evidence.scenes import discs, rigid_bodies
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.evidence.speed.whole_runs import WholeRuns
from lesson_code.view import listing
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 Guess the plan
#
# An **effect** is something that a simulation may or may not reckon with: gravity, friction, bodies
# that turn, bodies that bounce. It costs time wherever the engine reckons with it. It changes
# something only where it is there.

# %%
predict("10-gas")

# %% tags=["answer"]
# the plan of the gas
gas = gas_scenes.disc_gas(4, covered=0.3, seed=1)
run = simulate(gas, 3.0, solver="sequential")
print(run.plan)

# %% [markdown]
# That is a **plan**. Each row is a rule, applied to this scene, with its verdict and its reason.
# The engine made it before the first step, from masses, coefficients and velocities. Nobody had to
# tell it that this scene has no friction.
#
# Now guess yourself. Write behind each scene the effects that it needs, out of these six:
#
# - `gravity`, `friction` between two bodies, `restitution` (something bounces);
# - `rotation` (something turns), `manifolds` (two bodies touch at two points, as boxes do);
# - `continuous` (something may be so fast that a step jumps over a body).
#
# You learn how many of the six are right, but not which. Run the cell again until you have them
# all.

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
    "A table with a row for each of sixteen effects and a column for each of five scenes; a full "
    "dot is an effect that is simulated, a small ring one that is left out. Two discs side by side "
    "need nothing at all. The gas needs seven effects, the break eight, the slope ten and the "
    "tower eleven.",
)

# %% [markdown]
# Whatever a plan leaves out is not skipped in the run, it is **not there**: the program is *put
# together* from the plan. Here is how it treats a contact of the smooth gas, and then a contact of
# the same gas with friction and rotation forced on.

# %%
print(listing.listing(run.plan.source(), "solve_central", "central_velocity"))

# %%
forced = {"friction": True, "rotation": True}
more = simulate(gas, 3.0, solver="sequential", effects=forced).plan.source()
print(listing.listing(more, "solve_contact", "tangent_velocity"))

# %% [markdown]
# In the smooth gas you find no `vt`, no lever arm, no angular velocity, and not even an `if` that
# asks for them. An `if` here would be asked at each contact, in each sweep, in each step. That is
# why the engine decides *before* the run.

# %% [markdown]
# ## 2 A rule asks about pairs
#
# Every plan gives its reasons, and each says the same in other words: here the effect would only
# add 0 or multiply by 1. Friction with mu = 0 has an impulse of at most 0. A blow through the
# centre of a disc has no lever arm, and turns nothing. Two effects are savings, and their rules ask
# whether they pay: the **broad phase** finds the same pairs as comparing all, and **sleep** stops
# nothing that moves.
#
# Most rules need a *pair*. Material belongs to a body, but a contact has two. Its e is the smaller
# of the two. Its mu is a mean of both that is 0 if one of them is. Write it:


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
for title, scene in {
    "a rough disc on a smooth floor": scenes.thrown(Circle(0.5), 0.6),
    "a rough disc on a rough floor": scenes.thrown(Circle(0.5), 0.6, on=0.6),
    "a smooth box on a smooth floor": scenes.thrown(Polygon.box(1, 1), 0.0),
}.items():
    print(title)
    print(scenes.verdicts(scene, "friction", "rotation"))

# %% [markdown]
# ## 3 Proof: the same bits
#
# A plan makes a claim: what it leaves out would change nothing. Put the claim to the test. Force
# each effect on that the gas does not call for, one after the other.

# %%
predict("10-same-bits")

# %% tags=["answer"]
# each effect forced on
fields = ("positions", "velocities", "angles", "angular_velocities")
long = simulate(gas, 10.0, solver="sequential")
for name in long.plan.left_out:
    other = simulate(gas, 10.0, solver="sequential", effects={name: True})
    same = [getattr(long, f).tobytes() == getattr(other, f).tobytes() for f in fields]
    check(f"{name} forced on: the same bits", same, [True] * 4)

# %% [markdown]
# The same zeros and ones, in each state of all discs. A tolerance would not do: in chapter 07 a
# millionth of a millionth made another gas within a few dozen collisions.
#
# **Why can it be exact?** A computer rounds numbers, but some operations it never rounds: adding 0,
# multiplying by 1 or by 0. An unneeded effect does nothing else.

# %%
v, lever, w = 0.1, 0.7, 0.0
check("v + w r is v where w = 0", v + w * lever == v, True)
check("damping at the rate 0 multiplies by", np.exp(-0.0 * 0.016), 1.0)
check("but to add and take away again may round", (v + 0.2) - 0.2 == v, False)

# %% [markdown]
# The last line is a warning. An effect that adds something and takes it away again changes bits,
# even if it is nothing on paper.
#
# Now take effects away yourself. Each row below says what becomes of two discs on a floor without
# one effect. Which can go? Then make the discs rough, give disc 1 a spin, throw it faster: from
# when on is each of them needed?

# %%
live(
    "ch10_only_what_the_scene_needs/left_out",
    "A disc is thrown at another one that lies on a floor; both paths are drawn. A list says how "
    "far apart the paths are without each of five effects: without gravity or restitution by "
    "metres; without friction, rotation or the watch for fast bodies no bit changes. The velocity "
    "can be dragged; gravity, restitution, friction and spin can be changed.",
)

# %% [markdown]
# Leave out what the scene needs, and you would get a wrong result without a word. So the engine
# refuses it, by name and with the reason.

# %%
for scene, name in ((scenes.thrown(Circle(0.5), 0.6, on=0.6), "friction"), (gas, "restitution")):
    try:
        simulate(scene, 1.0, solver="sequential", effects={name: False})
    except ValueError as refused:
        print(refused)

# %% [markdown]
# ## 4 How fast can a body become?
#
# An engine that looks at the ends of steps may lose a body that moves by more than half its width
# in a step (chapter 07). Watching for that costs time. **Is there a scene in which it cannot
# happen, whatever the impacts will be?** Speeds change at each impact. But without gravity, and
# without a wall that is driven from outside, the *energy* of all bodies never grows. (Chapter 09
# knows an exception: bounces at corners that rub. There the rule says "needed".) At worst the
# lightest body gets all of it. How fast is it then?


# %%
@gap("10-fastest")
def fastest(energy, lightest):
    return ...


# %% [markdown]
# This bound holds for all times, and you find it from the first state alone. (It counts the energy
# only, since walls may take up momentum.) The rule multiplies it by 1.5, for rounding, and compares
# it with the room. In the gas:

# %%
way, room = fastest_way(gas, dt=1 / 60)
bound = fastest(run.kinetic_energy[0], min(body.mass for body in gas.bodies if body.mass))
check("your bound, in a step", bound / 60, way, tolerance=1e-12)
speeds = np.hypot(*np.moveaxis(long.velocities, -1, 0))
print(f"bound {way:.4f} m in a step; fastest in 10 s {speeds.max() / 60:.4f} m; room {room} m")
check("energy after 10 s, parts", long.energy[-1] / long.energy[0], 1.0, tolerance=1e-3)
check("nobody was faster than the bound", bool(speeds.max() / 60 <= way), True)

# %%
live(
    "ch10_only_what_the_scene_needs/fastest",
    "A ball of 100 kg comes towards a small one of 1 kg at rest. Beside them, how far the small "
    "one may move in a step, over the length of the step: three straight lines from zero, the "
    "lowest after a hit, above it the bound by the energy, and highest the bound with its margin, "
    "which crosses the level line of half a width, 0.1 m, at 13 ms. Speed, mass and step can be "
    "changed.",
)

# %% [markdown]
# The lighter the small ball, the steeper its line, though it is at rest. Gravity gives energy, so
# with gravity the bound says nothing, and the engine watches for fast bodies.
#
# ## 5 Break it on purpose: a rule that looks at the start
#
# Why so careful? A simpler rule would be: *nobody moves by more than half its width in a step now,
# so nobody has to be watched.* See where that leads.

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
    "The light ball lies still until 0.12 s and then flies off at 8 m/s. At 0.3 s it reaches a "
    "wall. In the naive solver and in pymunk it flies on through the wall; in ours it turns back.",
)

# %% tags=["answer"]
# three solvers
behind = {name: bool(r.positions[-1, 2, 0] > 1.45) for name, r in shot.items()}
check("behind the wall", list(behind.values()), [True, True, False])
print(scenes.verdicts(hit, "continuous"))

# %% [markdown]
# ## 6 A rule may err to one side only
#
# Two discs fly. Can they meet? The exact answer of chapter 07 costs something for each pair. A
# cheaper one: put a **box** around each flight. If the boxes share no point, the discs do not meet.

# %% tags=["plumbing"]
pairs = {
    "boxes apart": scenes.two_flights({"position": (9, 2.5), "velocity": (-1, 2)}),
    "boxes that share a part": scenes.two_flights({"position": (6.5, 1.5), "velocity": (-4, 1)}),
}

# %% tags=["plumbing"]
fig, axes = style.figure(2, width=9, height=3.4)
for ax, (title, scene) in zip(axes, pairs.items(), strict=True):
    flown = simulate(scene, 1.2, solver="sequential", dt=1 / 240)
    plan_figures.flights(ax, flown)
    verdict = "may meet" if can_meet(scene, 1.2, 1 / 240) else "cannot meet"
    ax.set_title(f"{title}: {verdict}\ncontacts: {len(flown.contacts.time)}", fontsize=10)
show(
    fig,
    "Two pictures of two discs in flight, each with a box around it. On the left the boxes are "
    "apart, and nothing can meet. On the right they overlap, so the rule says that the discs may "
    "meet; but they pass each other.",
)

# %% [markdown]
# On the right the rule calls for collisions, and there are none: the discs are in the shared part
# at different times. That error is harmless. The scene pays for something it does not need. The
# other error would make the result *wrong*. So a rule must be **conservative**: it has to prove
# "not needed", and need not prove "needed".
#
# For the same reason a **callback**, a function of yours that the engine calls at a touch, makes
# rules careful: if yours may set the mu of a pair, the plan calls for friction from the start. If
# it switches gravity on in the middle of the run, the engine plans the rest anew.
#
# ## 7 Islands that sleep
#
# A body at rest costs as much as one that moves: the engine finds its contacts and computes their
# impulses, to learn that nothing happens. So let it **sleep**.
#
# An **island** is a set of bodies that can be pushed and hang together by contacts. Static bodies
# do not join islands: a floor passes no push on. If all bodies of an island have been still for a
# second, the island falls asleep: the engine no longer moves it, nor solves its contacts. A body
# that is awake and touches it wakes all of it.

# %%
towers = scenes.three_towers()
rest = simulate(towers, 8.0, solver="sequential")
times, asleep = scenes.asleep_in_time(towers, 8.0)
for second in (0.5, 3.0, 8.0):
    print(f"asleep after {second} s: {asleep[np.searchsorted(times, second - 1e-9)].sum()} of 9")
animate(
    rest,
    "Three towers of three boxes stand on a floor. A disc rolls in from the left and hits the "
    "first tower. Its boxes move a little, and the disc stays beside it.",
    around=(-9, 6, -0.3, 4),
    still=4.2,
)

# %% [markdown]
# The hit wakes one tower, and the two others sleep on. **Is the result the same?** For sleep alone
# the claim is weaker. A body at rest is not quite at rest: it has a rounding error of what gravity
# gives it in a step. What sleeps does not even have that. So the bits differ, by less than you can
# see or measure.

# %%
awake = simulate(towers, 8.0, solver="sequential", effects={"sleeping": False})
check("with and without sleep, m", rest.positions, awake.positions, tolerance=1e-6)

# %% [markdown]
# ## 8 What it saves, and what you wait for
#
# Times differ in each run, so you see stored ones; `workbook measure effects` takes them on your
# machine. For each effect there are two scenes that differ as little as they can. One needs the
# effect. The other one runs as planned, without it, and once more with the effect forced on.

# %%
predict("10-worth")

# %% tags=["answer"]
# the stored result
costs = stored()
show(
    figures.all_effects(costs),
    "A panel for our engine in each of its codes, and one for pymunk, with a row for each effect "
    "and the time of a step in powers of ten. In ours, bars join the times with an effect forced "
    "on and without it. They are long for collisions and friction, and short for gravity and "
    "damping. Sleeping stacks take a small part of the time of those that are awake. In pymunk "
    "the marks for friction lie on each other.",
)

# %% tags=["answer"]
# the stored result
ours, theirs = costs.of("friction", "plain Python"), costs.of("friction", "pymunk")
print(f"friction forced on and left out, our time: {ours.forced / ours.left_out:.2f} to 1")
print(f"with mu and without, pymunk's time: {theirs.needed / theirs.left_out:.2f} to 1")

# %% [markdown]
# What the engine does once a step for each body, like gravity, costs next to nothing. What it does
# for each contact in each sweep costs more: friction. Most is saved where it need not look at a
# contact at all: sleep. pymunk has one program for all scenes: where every mu is 0 it works out the
# friction of each contact all the same, and finds 0.
#
# You wait for more than steps: for Python, for the import, for the plan. `workbook measure speed`
# times whole processes. "Ours" finds machine code that an earlier run has kept, "nothing kept" does
# not. The gases are elastic discs in a box; the piles are rough ones that fall into it.

# %%
predict("10-from-how-many")

# %% tags=["answer"]
# the stored result
print(WholeRuns.stored().as_text(100))

# %% [markdown]
# With ten discs nearly all of the time is the start, and the smaller program wins: pymunk. The more
# bodies, the more it pays to have left something out. Where the last table says NO, we have not
# reached what we wanted.

# %% [markdown]
# ## 9 Quiz

# %%
show_quiz("10")

# %% [markdown]
# ## Key takeaways
#
# - An effect costs time wherever it is reckoned with, and changes something only where it is there.
# - You can work out before the run what a scene needs: from pairs of coefficients, from shapes,
#   from the energy, from the boxes around flights.
# - "Nothing changes" means the same bits. You prove it by forcing the effect on.
# - A rule has to be conservative. To call for too much costs time; to call for too little is wrong.
# - A body at rest may sleep, if its whole island is at rest; static bodies join nothing.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** for each effect that a gas does not need, that forcing it on leaves all bits as
# they are; that leaving out a needed one is refused; the bound on speed from the energy; and sleep
# against the same run awake, to a millionth of a metre. The tests do the same for many random
# scenes, in plain Python and compiled.
#
# **Limits.** With gravity the energy bounds no speed. In a scene that needs everything nothing is
# saved.
#
# **Do now:** the exercise [10 Only what the scene
# needs](../exercises/10_only_what_the_scene_needs.ipynb): five tasks, twenty points. `workbook
# watch` checks it whenever you save. `workbook play simulator` shows the plan of what you build in
# it. **Next:** [11 The small engine](11_the_small_engine.ipynb): all that you have written, put
# together.
#
# **Sources.** Catto, *Island sleeping* and *Continuous collision* in the documentation of Box2D
# v3: which bodies are watched, and which are left alone. Goldberg, *What every computer scientist
# should know about floating-point arithmetic*, ACM Computing Surveys 23 (1991), 5: which operations
# are exact.
