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
# works out, needed or not. Chapter by chapter our engine has learned more: spin, friction, corners,
# fast bodies, loads. Smooth discs pay for friction, a handful of balls pays for a grid. Here you
# guess what a scene needs, look at the engine's plan, and prove that the rest may go.
#
# **After this notebook you will be able to**
#
# 1. say of a scene which effects it calls for, and give the reason for each;
# 2. prove that what is left out changes nothing, not even the last digit;
# 3. say what leaving it out saves, and where it saves nothing.
#
# **You need** notebooks 00 to 07. **Time:** about 45 minutes to read and to write two lines,
# ten seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Callbacks, Circle, Polygon, simulate
from lesson_code.chapters.ch10_only_what_the_scene_needs import figures, plan_figures, scenes
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.engine.effects.choice import OPTIONAL
from lesson_code.engine.effects.collisions import can_meet
from lesson_code.engine.effects.continuous import fastest_way
from lesson_code.evidence import check
from lesson_code.evidence.effect_costs import stored
from lesson_code.evidence.hard_cases import loads

# %% tags=["plumbing"]
from lesson_code.evidence.scenes import discs, events, rigid_bodies
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.evidence.speed.whole_runs import WholeRuns
from lesson_code.view import listing
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 A scene has a plan
#
# An **effect** is something that a simulation may or may not reckon with: gravity, friction, bodies
# that turn, bodies that bounce. It costs time wherever it is reckoned with. It changes something
# only where it is there.

# %%
predict("10-gas")

# %% tags=["answer"]
# the plan of the gas
gas = gas_scenes.disc_gas(4, covered=0.3, seed=1)
run = simulate(gas, 3.0, solver="sequential")
print(run.plan)

# %% [markdown]
# Each row is a rule, applied to this scene, with its verdict and its reason. The engine found them
# before the first step, from masses, coefficients and velocities. Nobody had to say "this scene
# has no friction".
#
# The same for some other scenes:

# %% tags=["plumbing"]
planned = {
    "two discs,\nside by side": scenes.side_by_side(),
    "smooth\ngas": gas,
    "drop on\na floor": events.bouncing_to_rest(0.8),
    "disc down\na slope": rigid_bodies.disc_on_incline(0.3, 0.2),
    "pool\nbreak": discs.rack_break(0.95),
    "tower of\nfive boxes": rigid_bodies.box_stack(5),
}
plans = {name: simulate(s, 2.0, solver="sequential").plan for name, s in planned.items()}

# %% tags=["plumbing"]
fig, ax = style.figure(width=8, height=5.2)
plan_figures.plans(ax, plans)
show(
    fig,
    "A table with a row for each of sixteen effects and a column for each of six scenes; a full "
    "dot is an effect that is simulated, a small ring one that is left out. Two discs side by side "
    "need nothing at all. The others need between seven and eleven of the sixteen, and no two "
    "need the same.",
)

# %% [markdown]
# ## 2 This is all your scene needs
#
# A plan is more than a list. The program is *put together* from it: what is left out is not
# skipped, it is **not there**. `run.plan.source()` is the program that is left over. Here is how
# it treats a contact, once for the smooth gas, and once for the same gas with friction and
# rotation forced on.

# %%
small = run.plan.source()
print(listing.listing(small, "solve_central", "central_velocity"))

# %%
forced = {"friction": True, "rotation": True}
more = simulate(gas, 3.0, solver="sequential", effects=forced).plan.source()
print(listing.listing(more, "solve_contact", "tangent_velocity"))

# %% [markdown]
# In the smooth gas there is no `vt`, no lever arm, no angular velocity. There is not even an `if`
# that asks for them, and so nothing that would have to be asked again at each contact. That is the
# reason to decide *before* the run.
#
# How much is left of the program, scene by scene?

# %% tags=["plumbing"]
lines = {name: listing.lines_of_code(plan.source()) for name, plan in plans.items()}
fig, ax = style.figure(width=8, height=3)
ax.bar(list(lines), list(lines.values()), color=style.BLUE)
ax.set_ylabel("lines of program that are left")
ax.tick_params(axis="x", labelsize=8)
show(
    fig,
    "Bars: the lines of the program that each of the six scenes leaves over. The shortest, of two "
    "discs side by side, is some tens of lines. The smooth gas has several hundred; the pool break "
    "and the tower of boxes have the most.",
)

# %% [markdown]
# The pool break is the longest, though it has no friction. In it a ball was fast, and the lines
# that split a step at an impact were added when it was first seen. What changes while a scene runs
# may change the program.

# %% [markdown]
# ## 3 A rule for each effect
#
# Each rule says when an effect is called for, and why nothing is lost without it otherwise.
#
# - **gravity, damping:** if it is not zero. Else it would add 0, or multiply by 1.
# - **friction:** if a pair has mu > 0. Else its impulse, at most mu jn, is 0.
# - **restitution:** if a pair has e > 0. Else the velocity to reach, e times the approach, is 0.
# - **rotation:** if a body turns, has corners, or is a disc that rubs. Else no impulse has a lever
#   arm.
# - **outlines:** if a body has corners. **Manifolds:** if two such bodies can meet. A circle
#   touches at one point.
# - **internal_edges:** if two bodies are static. One alone has no seam.
# - **continuous:** if a body may move by half its width in a step. A slower one cannot jump over
#   anything.
# - **collisions:** if two bodies can meet. **Warm starting** and **position correction** go with
#   them, in every solver that makes steps.
# - **callbacks:** if the scene has some. Else nobody would hear them.

# %% [markdown]
# Most of them need a *pair*. Material belongs to a body, but a contact has two. Its e is the
# smaller of the two. Its mu is a mean of both that is 0 if one of them is: write it.


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
# **Two effects are savings.** The broad phase finds the same pairs as comparing all of them, and
# sleep stops nothing that moves. They are asked another question: do they pay? Below 24 bodies all
# pairs are compared as fast as a grid is kept.
#
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
# This is a bound for all times, from the first state alone. It counts the energy only: walls may
# take up momentum. Without walls the momentum stays as well, and the lowest bound is smaller. The
# rule multiplies it by 1.5, for rounding, and compares. In the gas:

# %%
way, room = fastest_way(gas, dt=1 / 60)
bound = fastest(run.kinetic_energy[0], min(body.mass for body in gas.bodies if body.mass))
check("your bound, in a step", bound / 60, way, tolerance=1e-12)
long = simulate(gas, 10.0, solver="sequential")
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
# The lighter the small ball, the steeper the line, though it is at rest. Gravity gives energy, so
# there the bound says nothing, and fast bodies are watched for.
#
# ## 5 A rule may err to one side only
#
# Two discs fly. Can they meet? The exact answer is that of chapter 07, and it costs something for
# each pair. A cheaper one: put a **box** around each flight. Boxes that share no point belong to
# discs that do not meet.

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
# at different times. That is an error, and a harmless one. The scene pays for something it does not
# need. The other error would make the result *wrong*. So a rule must be **conservative**: "not
# needed" has to be proven, "needed" need not.
#
# ## 6 Proof: the same bits
#
# Now put the claim to the test: force each effect on that the gas does not call for, one after the
# other.

# %%
predict("10-same-bits")

# %% tags=["answer"]
# each effect forced on
fields = ("positions", "velocities", "angles", "angular_velocities")
for name in long.plan.left_out:
    other = simulate(gas, 10.0, solver="sequential", effects={name: True})
    same = [getattr(long, f).tobytes() == getattr(other, f).tobytes() for f in fields]
    check(f"{name} forced on: the same bits", same, [True] * 4)

# %% [markdown]
# Not "nearly the same": the same zeros and ones, in each state of all discs. A tolerance would
# not do. Chapter 07 has shown that a gas makes of a millionth of a millionth another gas in a few
# dozen collisions. What changes the last digit changes everything, only later.
#
# **Why can it be exact?** Floating-point numbers are rounded, but some operations never are:
# adding 0, multiplying by 1 or by 0. All that an unneeded effect does is of that kind.

# %%
v, lever, w = 0.1, 0.7, 0.0
check("v + w r is v where w = 0", v + w * lever == v, True)
check("damping at the rate 0 multiplies by", np.exp(-0.0 * 0.016), 1.0)
check("but to add and take away again may round", (v + 0.2) - 0.2 == v, False)

# %% [markdown]
# The last line is a warning. An effect that adds something and takes it away again would not be
# nothing, even if on paper it is.
#
# Now take effects away yourself. Two discs fly, bounce and roll; each row says what becomes of the
# scene without one effect. The floor is rough, the discs are smooth: which effects can go? Then
# make the discs rough, give disc 1 a spin, throw it faster: which is needed from when on?

# %%
live(
    "ch10_only_what_the_scene_needs/left_out",
    "A disc is thrown at another one that lies on a floor; both paths are drawn. A list says how "
    "far apart the paths are without each of five effects: without gravity or restitution by "
    "metres; without friction, rotation or the watch for fast bodies no bit changes. The velocity "
    "can be dragged; gravity, restitution, friction and spin can be changed.",
)

# %% [markdown]
# ## 7 What is needed cannot be left out
#
# You may overrule the plan, since rules may be too careful. But to leave out what the scene needs
# would give a wrong result without a word. So it is refused, by name and with the reason.

# %%
for scene, name in ((scenes.thrown(Circle(0.5), 0.6, on=0.6), "friction"), (gas, "restitution")):
    try:
        simulate(scene, 1.0, solver="sequential", effects={name: False})
    except ValueError as refused:
        print(refused)

# %% [markdown]
# Three may go although they are called for, because no state of the run depends on them: the
# broad phase, sleep, and the record of impulses.

# %%
fewer = simulate(gas, 10.0, solver="sequential", effects=dict.fromkeys(OPTIONAL, False))
check("without all three: positions", fewer.positions, long.positions)
check("and no impulses were written down", len(fewer.contacts.time), 0)

# %% [markdown]
# ## 8 When the scene changes
#
# A plan looks at the scene as it is at the start. A **callback** is a function of yours that the
# engine calls when bodies begin to touch, touch or part: the third box of the pipeline. It may
# change the scene. One that may set the mu or the e of a pair makes the rules careful from the
# start, since nobody knows what it will set. One that switches gravity on is another case: the run
# is planned anew, from the bodies as they are at that moment.

# %%
predict("10-callback")


# %% tags=["answer"]
# a callback that switches gravity on
def switch_on(touch):
    """Let things fall from the first touch on."""
    touch.gravity = (0, -10)


switched = scenes.two_that_meet(Callbacks(post_solve=switch_on))
fallen = simulate(switched, 3.0, solver="sequential")
print(*fallen.plan.changes, sep="\n")

# %% [markdown]
# ## 9 Break it on purpose: a rule that looks at the start
#
# Why so careful about speed? A simpler rule would be: *nobody moves by more than half its width
# in a step now, so nobody has to be watched.* See where that leads.

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
# ## 10 Islands that sleep
#
# What has come to rest costs as much as what moves: its contacts are found and its impulses are
# computed, to learn that nothing happens. So an engine lets it **sleep**.
#
# An **island** is a set of bodies that can be pushed and hang together by contacts. Static bodies
# do not join islands: a floor carries no push on. If all bodies of an island have been still for a
# second, the island sleeps. It is not moved, and its contacts are neither sought nor solved. A body
# that is awake and touches one of it wakes all of it.

# %% tags=["plumbing"]
towers = scenes.three_towers()
times, asleep = scenes.asleep_in_time(towers, 8.0)
fig, ax = style.figure(width=7, height=2.6)
ax.step(times, asleep.sum(axis=1), where="post", color=style.BLUE)
ax.set(xlabel="time, s", ylabel="bodies asleep", ylim=(0, 10))
show(
    fig,
    "Number of sleeping bodies over time: none for the first second, then nine. At four seconds a "
    "disc hits the first tower, and six sleep on.",
)

# %%
rest = simulate(towers, 8.0, solver="sequential")
animate(
    rest,
    "Three towers of three boxes stand on a floor. A disc rolls in from the left and hits the "
    "first tower. Its boxes move a little, and the disc stays beside it.",
    around=(-9, 6, -0.3, 4),
    still=4.2,
)

# %% [markdown]
# The two other towers slept on. **Is the result the same?** Sleep is the one effect for which the
# claim is weaker. A body at rest is not quite at rest: its velocity is a rounding error of what
# gravity gives in a step. What sleeps does not even have that. So the bits differ, and the claim
# is: by less than one can see, or measure.

# %%
awake = simulate(towers, 8.0, solver="sequential", effects={"sleeping": False})
check("with and without sleep, m", rest.positions, awake.positions, tolerance=1e-6)

# %% [markdown]
# Without gravity nothing sleeps, so there it is bit for bit again; the gas of section 6 had sleep
# forced on, too.
#
# ## 11 The solver is chosen by rules, too
#
# `solver="auto"` asks the same kind of questions. Discs that fly freely, two at a time: the exact
# solver needs no step at all. Few bodies: all contacts together are solved at once. Heavy on light
# among many: sub-steps. All else is swept.

# %%
choices = {
    "a smooth gas": gas,
    "a ball that bounces": events.bouncing_to_rest(0.8),
    "1,000,000 kg on 1 kg": loads.tower((1.0, 1e6)),
    "a pyramid of 210 boxes": rigid_bodies.box_pyramid(20),
}
for title, scene in choices.items():
    chosen = simulate(scene, 1 / 60).plan
    print(f"{title}: {chosen.solver}; {chosen.reason}")

# %% [markdown]
# ## 12 What it saves, and what pymunk pays
#
# Times are not measured here: they would differ in each run. `workbook measure effects` measures
# them on your machine; this is a stored result. For each effect there are two scenes that differ
# as little as they can. One needs the effect. The other one is run as planned, without it, and
# once more with the effect forced on.

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
friction = costs.of("friction", "plain Python")
print(f"friction, {friction.difference}: calls in a step of what only friction needs")
print(f"   needed {friction.calls_needed:.0f}, left out {friction.calls_left_out:.0f}")
print(f"   forced on and left out, time: {friction.forced / friction.left_out:.2f} to 1")
pymunk = costs.of("friction", "pymunk")
print(f"   pymunk, with mu and without, time: {pymunk.needed / pymunk.left_out:.2f} to 1")
for limit in costs.limits:
    print(f"{limit.what}: {limit.value:.3g}, wanted {limit.wanted}")

# %% [markdown]
# **Read it with care.** What is done once in a step and for each body, like gravity, is worth
# nearly nothing. What is done for each contact in each sweep is worth more: friction. And most is
# worth what keeps whole contacts from being looked at: sleep, and in large scenes the broad phase.
# All of the small ones together count too, as the second of the limits says. Where nothing is
# saved no harm is done: the scene is looked at once, before the first step.
#
# pymunk has one program for all scenes. It can let bodies sleep, if told to, and it calls nobody if
# nobody listens. It has no way to leave out friction: where every mu is 0 it works out the friction
# of each contact all the same, and finds 0.

# %% [markdown]
# ## 13 What you wait for
#
# Steps are not everything. A user waits for Python, for the import, for the plan, perhaps
# for a compiler, and only then for the steps. `workbook measure speed` takes the time of whole
# processes, each written as a user of that engine would write it. This too is a stored result.
# "Ours" finds machine code that an earlier run has kept, and "nothing kept" does not. The gases are
# elastic discs in a box; the piles are rough ones that fall into it.

# %%
predict("10-from-how-many")

# %% tags=["answer"]
# the stored result
print(WholeRuns.stored().as_text(100))

# %% [markdown]
# **Read it with care.** With ten discs nearly all of the time is the start: the smaller program
# wins, and that is pymunk. A second call in the same process, as in a notebook, no longer pays for
# that. The more bodies, the more it is the steps that count, and then it pays to have left out what
# the scene does not need. Where a row of the last table says NO, the target is not reached.

# %% [markdown]
# ## 14 Quiz

# %%
show_quiz("10")

# %% [markdown]
# ## Key takeaways
#
# - An effect costs time wherever it is reckoned with, and changes something only where it is there.
# - What a scene needs can be worked out before the run: from pairs of coefficients, from shapes,
#   from the energy, from the boxes around flights.
# - A rule has to be conservative. To call for too much costs time; to call for too little is wrong.
# - "Nothing changes" means the same bits. It can be proven, by forcing the effect on.
# - What is decided before the run need not be asked in the innermost loop.
# - A body at rest may sleep, if its whole island is at rest; static bodies join nothing.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** for each effect that a gas does not need, that forcing it on leaves all bits as
# they are; that leaving out a needed one is refused; the bound on speed from the energy; and sleep
# against the same run awake, to a millionth of a metre. The tests do the same for many random
# scenes, in plain Python and compiled.
#
# **Limits.** The rules look at the scene as it is at the start, so callbacks make them careful: one
# that may set mu calls for friction. With gravity the energy bounds no speed. And in a scene that
# needs everything nothing is saved.
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
