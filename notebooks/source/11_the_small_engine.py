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
# In notebook 00 there was a diagram with empty boxes. Since then you have written what belongs
# into them, one function at a time. This chapter puts them together: into an engine of a page, for
# all shapes, with spin and friction. Then it is compared with the workbook's engine, and taken to
# where it breaks.
#
# **After this notebook you will be able to**
#
# 1. write a whole physics step, and say what each of its lines is there for;
# 2. test an engine against another one, against a closed form and against the laws;
# 3. say what your engine cannot do, why, and what would help.
#
# **You need** notebooks 00 to 07, and better all. **Time:** about 40 minutes to read, fifteen
# seconds to run.

# %%
import inspect

import numpy as np

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment, simulate
from lesson_code.chapters.ch08_what_accuracy_costs import figures
from lesson_code.course.quiz.notebook import show_quiz
from lesson_code.engine import small_engine
from lesson_code.engine.small_engine import simulate_small
from lesson_code.evidence import check, work_precision
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.evidence.scenes import events, rigid_bodies
from lesson_code.view import listing
from lesson_code.view.browser.interactive import Slider, explore
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import diagrams, scene_plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 The pipeline, with your functions in it
#
# Here is the diagram of notebook 00 again. What is written in the boxes now are functions that you
# have written.

# %%
yours = {
    "broad phase": "near_pairs",
    "narrow phase": "circle_contact  mtv  clip\ncircle_against_polygon",
    "impulse calculation": "hit  friction_impulse\ncollide_1d  bounce",
    "position correction": "separate",
    "velocity update": "contact_velocity\nresolve_circles",
    "callbacks": "(yours to add)",
    "effects": "(yours to add)",
    "sound": "(yours to add)",
}

# %%
fig, ax = style.figure(width=9.5, height=4.2)
diagrams.pipeline(ax, functions=yours)
show(
    fig,
    "The pipeline again, with functions in its boxes. Broad phase: near_pairs. Narrow phase: "
    "circle_contact, mtv, clip, circle_against_polygon. Impulse calculation: hit, "
    "friction_impulse, collide_1d, bounce. Position correction: separate. Velocity update: "
    "contact_velocity, resolve_circles. Callbacks, effects and sound: yours to add.",
)

# %% [markdown]
# The tasks: `collide_1d` 2.2, `bounce` 3.2, `circle_contact` 4.1, `resolve_circles` 4.2, `separate`
# 4.3, `contact_velocity` 5.2, `friction_impulse` 5.4, `mtv` 6.4, `clip` 6.5,
# `circle_against_polygon` 6.6. New in this chapter's exercise: `near_pairs`, `hit`, and
# `step_discs`, which is a whole step.
#
# ## 2 A step
#
# The module `lesson_code.engine.small_engine` is such an engine. It calls the formulas of the
# chapters, and takes no stage from the workbook's own engine. This is its step:

# %%
program = inspect.getsource(small_engine)
print(listing.listing(program, "step", "move", "pairs_near"))

# %% [markdown]
# First all bodies move, then gravity acts. Then, pair by pair: are they near (broad phase), do they
# overlap (narrow phase), then hit them (impulse) and move them apart (position correction). And
# this is the hit. **Find in it:** the effective mass, the gate, and Coulomb's clamp.

# %%
print(listing.listing(program, "hit", "_approach", "push", "separate"))

# %% [markdown]
# The gate and the clamp are inside `normal_impulse` and `friction_impulse`: an impulse along the
# normal is never negative, and friction is at most mu times it. All the rest is bookkeeping. So
# how good is it?
#
# ## 3 One hit, to the last digits
#
# Rough discs that spin hit turned boxes, at random places, with random e and mu. The small engine
# and the workbook's share the formulas and the shapes, and no line of the step.

# %%
worst = 0.0
for scene in small_engine.random_hits(40, seed=1):
    theirs = simulate(scene, 0.2, solver="sequential", iterations=1)
    hit_at = np.searchsorted(theirs.times, theirs.contacts.time[0])
    small = simulate_small(scene, 0.2)
    for field in ("velocities", "angular_velocities"):
        apart = getattr(small, field)[hit_at] - getattr(theirs, field)[hit_at]
        worst = max(worst, np.abs(apart).max())
check("40 hits, all velocities after: largest difference", worst, 0.0, tolerance=1e-12)

# %% [markdown]
# ## 4 Many hits: what a step costs
#
# A ball in a box, without friction: chapter 07 has its path in closed form. **Predict:** how does
# the small engine's error change when the step is halved?

# %%
times, rates = np.linspace(0, 10, 101), [30, 60, 120, 240, 480, 960]
ball = events.ball_in_a_box()
errors = []
for rate in rates:
    path = simulate_small(ball, 10, dt=1 / rate, sample=times)
    errors.append(float(events.error_in_the_box(path).max()))
steps = [1 / rate for rate in rates]
fit = work_precision.fit_order(steps, errors)
print(f"order {fit}")
check("first order", fit.order, 1, tolerance=0.3)

# %%
fig, ax = style.figure(width=7, height=3.2)
label = "small engine"
figures.errors_over_steps(ax, steps, {label: errors}, {label: fit})
show(
    fig,
    "Error of the small engine over the length of the step, both in powers of ten. Six dots fall "
    "about a straight line of slope 1.",
)

# %% [markdown]
# It is the order of pymunk and of the workbook's stepped solver (chapter 08), and for the same
# reason: a hit is seen at the end of the step in which it happens.
#
# ## 5 All together
#
# The lesson that this course grew out of ended with a demo: five circles, a triangle and a square
# in a room. Here it is, by the small engine. In the picture everything hits everything.

# %%
rubber = Material(restitution=0.9, friction=0.3)
walls = events.box(8.0, 6.0, rubber)
triangle = Polygon([(-0.7, -0.5), (0.7, -0.5), (0.0, 0.8)])
starts = [(1, 1), (3, 1.5), (5, 1), (7, 2), (1.5, 4)]
ways = [(2, 1), (-1, 2), (1, 2), (-2, -1), (2, -2)]
discs = [
    Body(Circle(0.3 + 0.05 * n), mass=1.0 + n, position=p, velocity=v, material=rubber)
    for n, (p, v) in enumerate(zip(starts, ways, strict=True))
]
others = [
    Body(triangle, mass=2.0, position=(4, 4), velocity=(-1, -1), material=rubber),
    Body(Polygon.box(1, 1), mass=3.0, position=(6.5, 4.5), angular_velocity=1.5, material=rubber),
]
demo = Scene([*walls, *discs, *others])

# %%
room = simulate_small(demo, 3.0)
animate(
    room,
    "Five circles, a triangle and a square fly about in a room, hit each other and the walls, and "
    "begin to turn.",
    velocities=True,
    still=2.0,
)

# %%
energy = room.kinetic_energy
check("no body has left the room", bool(np.all((room.positions[:, 4:] > 0).all())), True)
check("energy was lost, and none was gained", bool(energy[-1] < energy[0] == energy.max()), True)

# %% [markdown]
# Move the sliders: a disc that spins is thrown onto a rough floor.


# %%
def draw_throw(restitution, friction, spin):
    surface = Material(restitution, friction)
    floor = Body(Segment((-3, 0), (9, 0)), material=surface)
    thrown = {"position": (0, 2), "velocity": (1.5, 0), "angular_velocity": spin}
    disc = Body(Circle(0.3), mass=1.0, material=surface, **thrown)
    run = simulate_small(Scene([floor, disc], gravity=(0, -9.81)), 2.5)
    fig, ax = style.figure(width=7, height=3)
    scene_plots.scene(ax, run, around=(-2, 6, -0.3, 2.5))
    scene_plots.trails(ax, run)
    return fig


# %%
explore(
    draw_throw,
    "The path of a disc that is thrown to the right with backspin: at the first bounce it "
    "turns round, and then it hops back to the left, a little lower each time. The sliders change "
    "restitution, friction and spin.",
    restitution=Slider("restitution", 0, 1, 0.8),
    friction=Slider("friction", 0, 1, 0.4),
    spin=Slider("spin, rad/s", -30, 30, 15, step=1),
)

# %% [markdown]
# ## 6 Break it on purpose: where a page is not enough
#
# Every engine has an edge. **Predict** for each of these three scenes what the small engine makes
# of it, and why.

# %%
hard = Material(restitution=1.0)
fast = Body(Circle(0.1), mass=1.0, position=(-1, 0), velocity=(40, 0), material=hard)
edges = {
    "a tower of five boxes": (rigid_bodies.box_stack(5), 2.0),
    "a fast ball and a thin wall": (Scene([Body(Segment((0, -1), (0, 1))), fast]), 0.1),
    "a pool break": (disc_scenes.rack_break(0.95), 1.0),
}
both = {}
for name, (scene, seconds) in edges.items():
    both[name] = simulate_small(scene, seconds), simulate(scene, seconds)

# %%
tower = both["a tower of five boxes"]
animate(
    {"small engine": tower[0], "workbook": tower[1]},
    "Two towers of five boxes. The small engine's trembles and falls apart. The workbook's stands.",
    around=(-4, 4, -0.3, 5.5),
    still=2.0,
)
moved = [bool(np.abs(r.positions[-1] - r.positions[0]).max() > 0.1) for r in tower]
check("a box has moved by more than 10 cm: small, workbook", moved, [True, False])

# %%
shot = both["a fast ball and a thin wall"]
through = [bool(r.positions[-1, 1, 0] > 0) for r in shot]
check("the ball is behind the wall: small, workbook", through, [True, False])
broken = both["a pool break"]
kept = [float(run.kinetic_energy[-1] / run.kinetic_energy[0]) for run in broken]
check("both have lost energy", [part < 0.9 for part in kept], [True, True])
check("and not the same", abs(kept[0] - kept[1]) > 0.05, True)

# %% [markdown]
# - **The tower.** A contact is visited once, and each visit disturbs the next one. The weight of
#   the top does not get to the floor. What helps: sweeps (chapter 06), remembered impulses, or all
#   contacts at once (chapter 09).
# - **The fast ball.** It is before the wall at the end of one step and behind it at the end of the
#   next. What helps: the time of impact (chapter 07).
# - **The pool break.** Both lose energy, as e = 0.95 says, but not the same. In the small engine
#   many balls of the rack are hit within one step, in the order of their numbers. The exact solver
#   hits each of them at its own time. What helps: shorter steps, or none (chapters 07 and 08).
#
# ## 7 What the workbook's engine adds
#
# It has the same stages, and for each edge a chapter:
#
# - contacts that last: two points for polygons, sweeps, memory, slop (06);
# - exact times of impact, and no step at all where discs fly freely (07);
# - a choice of methods, whose price is known (08);
# - all contacts of an island at once, and laws that cannot make energy (09);
# - and nothing of it where the scene does not call for it (10).

# %%
for name, (_, theirs) in both.items():
    print(f"{name}: {theirs.plan.solver}; {theirs.plan.reason}")

# %% [markdown]
# ## 8 Eight rules, and what happens without them
#
# - **Ask whether they part.** A pair that separates is not hit, or it is pulled back together and
#   sticks (04).
# - **Undo the overlap, and leave velocities alone.** Or an overlap turns into speed (04).
# - **Share by inverse mass.** The heavier moves less, and what is static not at all. Half and half
#   moves the floor (04).
# - **Use unit normals.** A normal of length 2 makes an impulse four times too large (03).
# - **Make steps of one length.** Collect the time that has passed, and make as many whole steps as
#   fit in. Or a slow computer plays another game, and resting things jump (03, 09).
# - **Keep e between 0 and 1.** Beyond it every bounce makes energy (02).
# - **Give coincident centres a normal.** Or a division by zero ends the game (04).
# - **Make steps short against sizes,** or look for the time of impact. Or fast things pass through
#   walls (07).
#
# ## 9 Quiz

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
# - A wall **reflects**: the normal part turns round, the tangent part stays. Only who moves into
#   the wall is turned (03).
# - Two dimensions are one dimension along the **normal**, and friction along the tangent (04).
# - A contact beside the centre turns bodies. The **effective mass** knows by how much they yield;
#   friction is at most mu jn, and stops sliding but never turns it round (05).
# - Convex shapes overlap unless some **axis** separates them, and the axis with the least overlap
#   is the way out (06).

# %% [markdown]
# - Between collisions everything is known. So a **time of impact** is a root, and exact (07).
# - An error is a number. Half the step, half the error, is what stepping gives; what more costs can
#   be measured (08).
# - What is **hard** is what is far apart: masses, sizes, speeds. Say the law and the bound first,
#   then measure (09).
# - What a scene does not call for can be left out, and nothing changes, **bit for bit** (10).
# - And in every chapter: an answer is right when something *else* says so. A conservation law, a
#   closed form, another engine.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** 40 hits against the workbook's engine, to 1e-12; the order of the error against
# a closed form; that nobody leaves the room; and that the small engine breaks where it was said to.
#
# **Limits.** The small engine compares all pairs, and checks each argument of each formula in each
# call. It is made to be read; for a hundred bodies use `simulate`.
#
# **Do now:** the exercise [11 The small engine](../exercises/11_the_small_engine.ipynb): three
# tasks, twelve points. **Next:** something of your own. `workbook play billiards` is a program made
# of these functions, and [its exercise](../exercises/billiards.py) lets you write it. Then joints,
# ropes and soft bodies: each is one more condition on velocities, and is solved as a contact is. In
# three dimensions the moment of inertia becomes a matrix, and little else changes.
#
# **Sources.** Catto, box2d-lite: an engine of a few pages, to read next. Ericson, *Real-Time
# Collision Detection* (2005), for detection; Millington, *Game Physics Engine Development* (2010),
# for the whole; Coumans, *Exploring MLCP solvers and Featherstone*, Game Developers Conference
# 2014, for joints.
