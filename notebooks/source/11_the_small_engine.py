# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 11 The small engine
#
# In notebook 00 you saw a diagram with empty boxes. Since then you have written what belongs in
# them, one function at a time. Here you put your functions together and run them: as an engine for
# all shapes, with spin and friction. Then you test it, break it, and give it a light and a sound.
#
# **After this notebook you will be able to**
#
# 1. write a whole physics step, and say what each of its lines is there for;
# 2. test an engine against another one, against a closed form and against the laws;
# 3. say what your engine cannot do, why, and what would help.
#
# **You need** notebooks 00 to 07, and your solved exercises 04, 05, 06 and 11; what you have not
# solved yet is lent. **Time:** about 40 minutes to read and to write two lines, fifteen seconds to
# run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Body, Circle, Material, Scene, Segment, simulate
from lesson_code.chapters.ch08_what_accuracy_costs import figures
from lesson_code.chapters.ch11_the_small_engine import after_impacts, near_places, own_engine
from lesson_code.chapters.ch11_the_small_engine.scenes import billiards, demo, pool_break
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.engine import small_engine

# %% tags=["plumbing"]
from lesson_code.evidence import check, check_bound, work_precision
from lesson_code.evidence.scenes import discs, events, rigid_bodies
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.listing import listing
from lesson_code.view.matplotlib import diagrams, plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 The pipeline, with your functions in it
#
# The next cell reads your exercises and takes out the functions that an engine needs. It tells
# you which of them are yours, and their marks. The workbook lends you what you have not written
# yet, so the engine runs in any case. Write it, save the exercise, and run this notebook again.

# %%
yours = own_engine.OwnEngine()
print(yours)

# %% [markdown]
# Here is the diagram of notebook 00 again. Functions in brackets are lent.

# %%
fig, ax = style.figure(width=9.5, height=4.6)
after = {"callbacks": "touch_changes", "effects": "glow", "sound": "knock"}
diagrams.pipeline(ax, functions=yours.boxes | after)
show(
    fig,
    "The pipeline again, with functions in its boxes. Broad phase: near_pairs. Narrow phase: "
    "circle_contact, circle_against_polygon, mtv, clip. Impulse calculation: hit, "
    "contact_velocity, inverse_effective_mass, friction_impulse. Position correction: separate. "
    "Velocity update: moment_of_inertia. Callbacks: touch_changes. Effects: glow. Sound: knock.",
)

# %% [markdown]
# `hit` (task 11.2) does a whole hit. Until you have written it, the engine makes one of your
# `contact_velocity`, `inverse_effective_mass` and `friction_impulse` from chapter 05. The functions
# of the last column come in section 8.
#
# ## 2 A step
#
# Something has to call your functions in the right order. Here it is: the module
# `lesson_code.engine.small_engine`. It takes no stage from the workbook's own engine.

# %%
print(listing(small_engine, "step", "move"))

# %% [markdown]
# All bodies move first, then gravity acts on them. The broad phase says which pairs are near. Then,
# pair by pair: do they overlap (narrow phase)? If so, they hit (impulse) and are moved apart
# (position correction). `parts` holds the four functions. With yours in it, it is your engine; the
# lesson's own are these. **Find in them:** the effective mass, the gate, and Coulomb's clamp.

# %%
print(listing(small_engine, "hit", "_approach", "push", "separate"))

# %% [markdown]
# The gate and the clamp are inside `normal_impulse` and `friction_impulse`: an impulse along the
# normal is never negative, and friction is at most mu times it. The rest is bookkeeping.
#
# ## 3 Who is near? Three ways, counted and timed
#
# How many pairs do N bodies make? Write it:


# %%
@gap("11-pairs-of")
def pairs_of(n):
    return ...


# %% [markdown]
# A thousand bodies make half a million pairs, and hardly any of them touch. A broad phase finds the
# few that may. Comparing **every pair** costs about N²/2. A **sweep** (not the one over contacts)
# sorts the bodies by their left ends, and compares each with those whose right end is still ahead:
# about N to the power 1.5 in a square. A **grid** looks only into neighbouring cells: about N.

# %%
counts = [100, 200, 400, 800, 1600]
crowds = [near_places.crowd(count) for count in counts]
every = [near_places.every_pair(places, 1.0)[0] for places in crowds]
compared = {}
for (name, way), power in zip(near_places.WAYS.items(), (2, 1.5, 1), strict=True):
    pairs, compared[name] = zip(*(way(places, 1.0) for places in crowds), strict=True)
    check(f"{name}: the same pairs", list(pairs) == every, True)
    order = work_precision.fit_order(counts, compared[name]).order
    check(f"{name}: comparisons grow like N to the power", order, power, tolerance=0.1)
check("every pair: as many as you say", compared["every pair"], [pairs_of(n) for n in counts])

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3.4)
plots.curves(ax, {n: (counts, c) for n, c in compared.items()}, "bodies", "comparisons")
ax.set_xscale("log")
ax.set_yscale("log")
show(
    fig,
    "Comparisons over the number of bodies, both in powers of ten: three straight lines. Every "
    "pair rises most steeply, the sweep less, the grid least.",
)

# %% [markdown]
# All three find the same pairs. A comparison is not all they do, though: sorting and cells cost
# time, too.

# %%
predict("11-few-bodies")

# %% tags=["nbval-ignore-output", "answer"]
# the clock
ways = near_places.WAYS | near_places.own_way(yours.functions["near_pairs"])
for count in (20, 200, 2000):
    places = near_places.crowd(count)
    took = {name: near_places.seconds(way, places) for name, way in ways.items()}
    for name, seconds in took.items():
        print(f"{count:5} bodies, {name:10}: {1e3 * seconds:8.2f} ms")
    ways = {name: way for name, way in ways.items() if took[name] < 0.05}
print(yours.functions["near_pairs"].line)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# So the workbook's engine compares every pair of few bodies, and takes a grid for many.

# %% [markdown]
# Your own `near_pairs` (task 11.1) may use any of these ways. Once you have written it, it is timed
# beside them, as "yours". If it takes more than 50 ms for 200 bodies, it is not tried with 2,000.
#
# ## 4 One hit, to the last digits
#
# Rough discs that spin hit turned boxes, at random places, with random e and mu. The small engine
# and the workbook's share the formulas and the shapes, and no line of the step.

# %%
worst = 0.0
for scene in small_engine.random_hits(40, seed=1):
    theirs = simulate(scene, 0.2, solver="sequential", iterations=1)
    hit_at = np.searchsorted(theirs.times, theirs.contacts.time[0])
    small = small_engine.simulate_small(scene, 0.2)
    for field in ("velocities", "angular_velocities"):
        apart = getattr(small, field)[hit_at] - getattr(theirs, field)[hit_at]
        worst = max(worst, np.abs(apart).max())
check("40 hits, all velocities after: largest difference", worst, 0.0, tolerance=1e-12)

# %% [markdown]
# ## 5 Many hits: what a step costs
#
# Chapter 07 has the path of a ball in a box in closed form. So you can say how wrong the small
# engine is, step by step.

# %%
predict("11-half-a-step")

# %% tags=["answer"]
# six steps, each half of the one before
times, rates = np.linspace(0, 10, 101), [30, 60, 120, 240, 480, 960]
ball = events.ball_in_a_box()
errors = []
for rate in rates:
    path = small_engine.simulate_small(ball, 10, dt=1 / rate, sample=times)
    errors.append(float(events.error_in_the_box(path).max()))
steps = [1 / rate for rate in rates]
fit = work_precision.fit_order(steps, errors)
print(f"order {fit}")
check("first order", fit.order, 1, tolerance=0.3)

# %% tags=["answer", "plumbing"]
# six steps, each half of the one before
fig, ax = style.figure(width=7, height=3.2)
label = "small engine"
figures.errors_over_steps(ax, steps, {label: errors}, {label: fit})
show(
    fig,
    "Error of the small engine over the length of the step, both in powers of ten. Six dots fall "
    "about a straight line of slope 1.",
)

# %% [markdown]
# Now you can say which error to expect at a step of `dt_2`, if you know that at `dt_1`. Write it:


# %%
@gap("11-error-at")
def error_at(dt_2, dt_1, error_1):
    return ...


# %%
expected = error_at(1 / 960, 1 / 30, errors[0])
print(f"at 1/960 s: {errors[-1]:.3f} m; you expected {expected:.3f} m")

# %% [markdown]
# ## 6 All together, with your functions
#
# The lesson that this course grew out of ended with a demo: five circles, a triangle and a square
# in a room, where everything hits everything. Your engine runs it here, and a pool break, and the
# first shot of the billiards. Their cushions are boxes, and the bumper of the billiards is a box
# between two discs, because your functions know circles and polygons.
#
# In every step the workbook answers the same questions for the very same bodies. For each of your
# functions you see the first answer that differs, and its time; then what is lent.

# %%
yours = own_engine.OwnEngine()
scenes = {"demo": (demo(), 3.0), "pool": (pool_break(), 2.0), "billiards": (billiards(), 4.0)}
mine, ours = {}, {}
for name, (scene, seconds) in scenes.items():
    mine[name] = yours.simulate(scene, seconds)
    ours[name] = small_engine.simulate_small(scene, seconds)
    apart = float(np.abs(mine[name].positions - ours[name].positions).max())
    same = "the same" if apart < 1e-6 else f"up to {apart:.3g} m apart"
    print(f"{name}, your engine and the lesson's: {same}\n{yours.report}\n")

# %%
animate(
    mine["demo"],
    "Five circles, a triangle and a square fly about in a room, hit each other and the walls, and "
    "begin to turn.",
    velocities=True,
    still=2.0,
)

# %%
animate(
    {"your pool": mine["pool"], "the lesson's": ours["pool"]},
    "Two pool tables. On each the cue ball flies into a triangle of fifteen balls, and they fly "
    "apart all over the table.",
    around=(-0.1, 2.64, -0.1, 1.37),
    still=0.5,
)

# %%
animate(
    mine["billiards"],
    "One ball on a table with a slanting bumper in its middle. It bounces off all four cushions, "
    "and then off an end of the bumper.",
    around=(-0.1, 3.1, -0.1, 2.1),
    velocities=True,
    still=3.8,
)

# %% [markdown]
# You can play on these two tables as well. `workbook play pool --with exercises` and
# `workbook play billiards --with exercises` open them with the rules that you have written in
# `exercises/pool.py` and `exercises/billiards.py`, and say of each function whose it is.
#
# To test the laws you need no second engine. With e = 0.9 and friction, energy can only go down.
# **Break it:** open exercise 04, let `separate` move both discs by the whole depth, save, and run
# this section again. Which line tells you first?

# %%
lesson = ours["demo"]
for who, run in (("yours", mine["demo"]), ("the lesson's", lesson)):
    energy = run.kinetic_energy
    steps_up = int(np.sum(np.diff(energy) > 1e-9 * energy[0]))
    inside = bool(np.all((run.positions[:, 4:] > 0).all()))
    print(
        f"{who}: energy {energy[0]:.1f} to {energy[-1]:.1f} J, rises in {steps_up} steps; ", end=""
    )
    print("nobody has left the room" if inside else "a body has left the room")
energy = lesson.kinetic_energy
check_bound("the lesson's loses energy, J", energy[0] - energy[-1], at_least=0)

# %% [markdown]
# Last, a disc that spins is thrown onto a rough floor. In the figure the workbook's engine runs,
# which can do so in a page. At the first bounce it gives the disc the same velocity and the same
# spin as the small engine: both call the same two formulas.

# %%
rough = Material(restitution=0.8, friction=0.4)
thrown = {"position": (0, 2), "velocity": (1.5, 0), "angular_velocity": 15}
disc = Body(Circle(0.3), mass=1.0, material=rough, **thrown)
throw = Scene([Body(Segment((-3, 0), (9, 0)), material=rough), disc], gravity=(0, -9.81))
ways = [
    small_engine.simulate_small(throw, 1.0, sample="end"),
    simulate(throw, 1.0, solver="sequential"),
]
speeds = [run.velocities[-1, 1, 0] for run in ways]
check("along the floor, m/s", *speeds, tolerance=1e-12)
check("spin, rad/s", *[run.angular_velocities[-1, 1] for run in ways], tolerance=1e-12)

# %%
live(
    "ch11_the_small_engine/throw",
    "The path of a disc that is thrown to the right with backspin: at the first bounce it turns "
    "round, and then it hops to the left, a little lower each time. The disc and its velocity can "
    "be dragged; restitution, friction and spin can be changed.",
)

# %% [markdown]
# ## 7 Break it on purpose: a tower, a fast ball, a rack
#
# So far each scene was kind to the small engine. Let it build a tower, stop a fast ball with a thin
# wall, and break a rack.

# %%
predict("11-edges")

# %% tags=["answer"]
# three scenes in both engines
hard = Material(restitution=1.0)
fast = Body(Circle(0.1), mass=1.0, position=(-1, 0), velocity=(40, 0), material=hard)
edges = {
    "a tower of five boxes": (rigid_bodies.box_stack(5), 2.0),
    "a fast ball and a thin wall": (Scene([Body(Segment((0, -1), (0, 1))), fast]), 0.1),
    "a pool break": (discs.rack_break(0.95), 1.0),
}
both = {}
for name, (scene, seconds) in edges.items():
    both[name] = small_engine.simulate_small(scene, seconds), simulate(scene, seconds)

# %% tags=["answer"]
# the tower
tower = both["a tower of five boxes"]
animate(
    {"small engine": tower[0], "workbook": tower[1]},
    "Two towers of five boxes. The small engine's trembles and falls apart. The workbook's stands.",
    around=(-4, 4, -0.3, 5.5),
    still=2.0,
)
moved = [bool(np.abs(r.positions[-1] - r.positions[0]).max() > 0.1) for r in tower]
check("a box has moved by more than 10 cm: small, workbook", moved, [True, False])

# %% tags=["answer"]
# the wall and the rack
shot = both["a fast ball and a thin wall"]
through = [bool(r.positions[-1, 1, 0] > 0) for r in shot]
check("the ball is behind the wall: small, workbook", through, [True, False])
broken = both["a pool break"]
kept = [float(run.kinetic_energy[-1] / run.kinetic_energy[0]) for run in broken]
check("both have lost energy", [part < 0.9 for part in kept], [True, True])
check("and not the same", abs(kept[0] - kept[1]) > 0.05, True)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
#
# - **The tower.** A contact is visited once, and each visit disturbs the next one. The weight of
#   the top does not get to the floor. What helps: sweeps (chapter 06), remembered impulses, or all
#   contacts at once (chapter 09).
# - **The fast ball.** It is before the wall at the end of one step and behind it at the end of the
#   next. What helps: the time of impact (chapter 07).
# - **The pool break.** Both lose energy, as e = 0.95 says, but not the same. In the small engine
#   many balls of the rack are hit within one step, in the order of their numbers. The workbook's
#   engine divides the step where balls meet, and lets all that touch act together. What helps:
#   shorter steps, or none (chapters 07 and 08).

# %% [markdown]
# ## 8 Callbacks, a light, and a sound
#
# The last column of the diagram changes no velocity. It tells the player what has happened. A
# **callback** fires when two bodies *begin* to touch, not as long as they do: that is
# `touch_changes`, task 11.4. An **effect** turns the event into light that fades alike for short
# and for long steps: `glow`, 11.5. And an impact **rings**, the louder the larger its impulse:
# `knock`, 11.6. Here the demo has gravity and a restitution of 0.4, so its bodies come to rest on
# the floor.

# %%
post = after_impacts.functions()
for function in post.values():
    print(function.line)
heard = simulate(demo(gravity=(0, -9.81), restitution=0.4), 3.0)
starts = [pair for pairs in after_impacts.begun(heard, post["touch_changes"]) for pair in pairs]
steps_in_touch = sum(len(pairs) for pairs in after_impacts.touches(heard))
print(f"{steps_in_touch} times a pair touches in a step, and {len(starts)} times it begins to")

# %%
bright = after_impacts.light(heard, post)
fig, ax = style.figure(width=7, height=2.6)
names = {f"disc {n}": (heard.times, bright[:, 3 + n]) for n in (1, 2)}
plots.curves(ax, names, "time, s", "brightness")
ax.set_ylim(-0.05, 1.4)
ax.legend(loc="upper left", ncols=2)
show(
    fig,
    "Brightness of two discs over three seconds. Each jumps to 1 where the disc is hit, and then "
    "fades.",
)

# %% [markdown]
# Here are the same three seconds to listen to. Each sound begins where a light does.

# %% tags=["nbval-ignore-output"]
after_impacts.play(
    heard, post, "Three seconds of the demo: a knock for each impact, the harder the louder."
)

# %% [markdown]
# ## 9 What the workbook's engine adds
#
# It has the same stages. For each failure that you have just seen, a chapter says what helps:
#
# - contacts that last: two points for polygons, sweeps, memory, slop (06);
# - exact times of impact, and no step at all where discs fly freely (07);
# - a choice of methods, whose price is known (08);
# - all contacts of an island at once, and laws that cannot make energy (09);
# - and none of these where the scene does not call for it (10).

# %%
for name, (_, theirs) in both.items():
    print(f"{name}: {theirs.plan.solver}; {theirs.plan.reason}")

# %% [markdown]
# ## 10 Eight rules, and what happens without them
#
# - **Ask whether they part.** A pair that separates is not hit, or it is pulled back together and
#   sticks (04).
# - **Undo the overlap, and leave velocities alone.** Or an overlap turns into speed (04).
# - **Share by inverse mass.** The heavier moves less, and what is static not at all. Half and half
#   moves the floor (04).
# - **Use unit normals.** With one of length 1.5 you take away 2.25 times what you mean to (03).
# - **Make steps of one length.** Collect the time that has passed, and make as many whole steps as
#   fit in. Or a slow computer plays another game, and resting things jump (09, section 8).
# - **Keep e between 0 and 1.** Beyond it every bounce makes energy (02).
# - **Give coincident centres a normal.** Or a division by zero ends the game (04).
# - **Make steps short against sizes,** or look for the time of impact. Or fast things pass through
#   walls (07).
#
# ## 11 Quiz

# %%
show_quiz("11")

# %% [markdown]
# ## Key takeaways
#
# The whole course on a page.
#
# - **Momentum** decides: what one body loses another gains. Equal impulses, opposite signs; the
#   change of velocity is J/m, so the heavy one moves less (01).
# - **Restitution** is a ratio of velocities along the normal. Energy goes with its square (02).
# - A wall **reflects**: the normal part turns round, the tangent part stays. Only a ball that
#   moves into the wall is turned round (03).
# - Two dimensions are one dimension along the **normal**, and friction along the tangent (04).
# - A contact beside the centre turns bodies. The **effective mass** says how much they yield;
#   friction is at most mu jn, and stops sliding but never turns it round (05).
# - Convex shapes overlap unless some **axis** separates them, and the axis with the least overlap
#   is the way out (06).

# %% [markdown]
# - Between collisions everything is known. So a **time of impact** is a root, and exact (07).
# - An error is a number. Half the step gives half the error; what a better method costs, you can
#   measure (08).
# - What is **hard** is what is far apart: masses, sizes, speeds. Say the law and the bound first,
#   then measure (09).
# - What a scene does not call for can be left out, and nothing changes, **bit for bit** (10).
# - And in every chapter: an answer is right when something *else* says so. A conservation law, a
#   closed form, another engine.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** 40 hits against the workbook's engine, to 1e-12; the order of the error against
# a closed form; how many pairs three broad phases compare; every answer of your functions against
# the workbook's; and that the small engine breaks where it was said to.
#
# **Limits.** The small engine compares all pairs, and checks each argument of each formula in each
# call. It is made to be read; for a hundred bodies use `simulate`.
#
# **Do now:** the exercise [11 The small engine](../exercises/11_the_small_engine.ipynb): six tasks,
# twenty-two points. `workbook watch` checks it whenever you save. `workbook play billiards` is a
# program made of these functions; its challenge,
# [exercises/billiards.py](../exercises/billiards.py), lets you write it. **Next:** something of
# your own. Then come joints, ropes and soft bodies: each is one more condition on velocities,
# solved as a contact is. In three dimensions the moment of inertia becomes a matrix, a contact has
# two tangents, and boxes meet in up to eight points.
#
# **Sources.** Catto, box2d-lite: an engine of a few pages, to read next. Ericson, *Real-Time
# Collision Detection* (2005), for detection; Millington, *Game Physics Engine Development* (2010),
# for the whole; Coumans, *Exploring MLCP solvers and Featherstone*, Game Developers Conference
# 2014, for joints.
