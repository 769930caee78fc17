# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 04 Circles
#
# Two pool balls hardly ever meet head on, and everything that makes pool a game of skill lies in
# that. In this chapter you find the balls that touch, hand the impulse over in the right
# direction, and move overlapping balls apart. At the end an engine does this for all pairs, in
# every time step.
#
# **After this notebook you will be able to**
#
# 1. find out whether two discs overlap, in which direction and how deep;
# 2. compute both velocities after an oblique hit, and say why the formula of one dimension must
#    not be used on x and y apart;
# 3. move overlapping discs apart by their masses, and explain why rows of discs need more than
#    one look at each contact.
#
# **You need** notebooks 01 to 03. **Time:** about 70 minutes with the questions; it runs in
# about ten seconds.

# %% tags=["plumbing"]
import inspect
from math import inf

import numpy as np

from lesson_code import Body, Material, Scene, simulate
from lesson_code.chapters.ch04_circles import figures
from lesson_code.chapters.ch04_circles import scenes as table
from lesson_code.chapters.ch04_circles import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.formulas import angular_momentum, collide_1d, kinetic_energy, momentum
from lesson_code.formulas.arithmetic import dot, perpendicular
from lesson_code.formulas.smooth_pair import separating_push, smooth_impulse
from lesson_code.formulas.validation import equation
from lesson_code.geometry import Circle, collide
from lesson_code.reference.contact_closed_forms import Struck, disc_impact
from lesson_code.reference.impact_closed_forms import (
    break_shot,
    cradle_all_at_once,
    cradle_one_by_one,
)
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, scene_plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 Two discs overlap when their centres are nearer than r1 + r2
#
# Let d be the vector from centre 1 to centre 2. Discs that just touch have their centres exactly
# $r_1 + r_2$ apart. So they overlap if
#
# $$d \cdot d < (r_1 + r_2)^2.$$
#
# Both sides are squares: most pairs on a table are far apart, and this test throws them out
# without a square root. Write it. `d` is an array, and `dot` is there for you:


# %%
@gap("04-overlap")
def overlap(d, r1, r2):
    return ...


# %% [markdown]
# For a pair that overlaps you want two more things: the **normal** n, a unit vector from disc 1
# to disc 2, and the **depth**.
#
# $$n = \frac{d}{|d|} \qquad \text{depth} = r_1 + r_2 - |d|$$

# %%
p1, r1, p2, r2 = np.array([0.0, 0.0]), 2.5, np.array([3.0, 4.0]), 3.5
d = p2 - p1
check("25 is less than 36", overlap(d, r1, r2), True)
contact = collide(Circle(r1), (*p1, 0), Circle(r2), (*p2, 0))  # the third number is an angle
check("normal", contact.normal, (0.6, 0.8), tolerance=1e-15)
check("depth", contact.penetrations[0], 1)

# %% tags=["plumbing"]
fig, ax = style.figure(width=5.4, height=5)
figures.overlap(ax, p1, r1, p2, r2, contact.normal, contact.penetrations[0])
show(
    fig,
    "Two overlapping discs. The normal n points from the centre of disc 1 towards the centre of "
    "disc 2. The depth is the distance between the two rims on the line of the centres.",
)

# %% [markdown]
# Two special cases need a rule, and the rule has to be the same everywhere.
#
# - **Touching is not overlapping.** With depth 0 there is nothing to push apart. `collide` returns
#   `None`.
# - **The same centre.** Then |d| = 0, and d/|d| is nan: there is no direction. Any unit vector
#   will do, if it is always the same one. This course takes (1, 0).

# %%
unit, place = Circle(1.0), (0.0, 0.0, 0.0)
check("touching", collide(unit, place, unit, (2.0, 0.0, 0.0)), None)
barely = collide(unit, place, unit, (np.nextafter(2.0, 0.0), 0.0, 0.0))
check("the next smaller number: an overlap", barely is not None, True)
same = collide(unit, place, unit, place)
check("the same centre: normal", same.normal, (1, 0))
check("the same centre: depth", same.penetrations[0], 2)

# %% [markdown]
# ## 2 The gate: only discs that approach collide
#
# Seen from disc 1, disc 2 moves with $v_2 - v_1$. The part of that along n says whether the two
# come closer:
#
# $$v_n = (v_2 - v_1) \cdot n \qquad v_n < 0: \text{they approach} \qquad v_n \ge 0: \text{they
# separate}$$
#
# This is the gate of chapter 03, with a second body that moves too. Discs that overlap and
# already separate get no impulse: they were hit a step ago, and a second hit would send them back
# into each other.

# %%
n = np.array([0.6, 0.8])
for name, v1, v2 in (
    ("head on", (3, 4), (-3, -4)),
    ("2 runs away, 1 is faster", (3, 4), (0.6, 0.8)),
    ("2 runs away, 1 is slower", (0.6, 0.8), (3, 4)),
    ("they pass each other", (4, -3), (-4, 3)),
):
    vn = dot(np.subtract(v2, v1), n)
    print(f"{name:26} vn = {vn + 0:+5.1f} m/s: {'approach' if vn < 0 else 'separate'}")

# %% [markdown]
# ## 3 The impulse acts along the normal, and along nothing else
#
# Smooth discs can only push, and only where they touch. So the impulse on disc 2 is $J = j\,n$,
# and disc 1 receives $-J$. An impulse of 1 N s changes $v_n$ by $1/m_1 + 1/m_2$; the inverse of
# that is called the **effective mass**. To turn $v_n$ into $-e\,v_n$ takes
#
# $$j = -(1 + e)\,v_n\,m_{\text{eff}} \qquad m_{\text{eff}} = \frac{1}{1/m_1 + 1/m_2}$$
#
# $$v_1' = v_1 - J/m_1 \qquad v_2' = v_2 + J/m_2$$
#
# This is chapter 01 along n. Write j for discs that approach; `vn` is then negative:


# %%
@gap("04-impulse")
def impulse_along(vn, m1, m2, e):
    return ...


# %% [markdown]
# These are the lines that run in the engine. The gate is inside `normal_impulse`:

# %%
print(inspect.getsource(equation(smooth_impulse)).split('"""')[-1].strip("\n"))

# %% [markdown]
# An example to work by hand. Along n, a disc of 1 kg comes at 2 m/s and one of 3 kg at -1 m/s,
# with e = 0.7. Across n they move at 5 and -7 m/s.

# %%
predict("04-which-change")

# %% tags=["answer"]
# the four numbers, before and after
n, t = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
m1, m2, e = 1.0, 3.0, 0.7
v1, v2 = 2 * n + 5 * t, -1 * n - 7 * t
impulse = smooth_impulse(v1, m1, v2, m2, n, e)
v1_after, v2_after = v1 - impulse / m1, v2 + impulse / m2
check("j = 1.7 * 3 * 0.75", np.hypot(*impulse), 3.825, tolerance=1e-12)
check("and by your line", impulse_along(-3, m1, m2, e), 3.825, tolerance=1e-12)
check("along n, after", (dot(v1_after, n), dot(v2_after, n)), (-1.825, 0.275), 1e-12)
check("chapter 01 says so too", collide_1d(1, 2, 3, -1, 0.7), (-1.825, 0.275), 1e-12)
check("across n, after", (dot(v1_after, t), dot(v2_after, t)), (5, -7), 1e-12)

# %% [markdown]
# **Proper mass.** Both discs receive the same |J|. The change of velocity is J/m, each with its
# own mass: the disc with three times the mass changes a third as much, and the other way. A mass
# of `math.inf` is a disc that cannot be moved. 1/m is then exactly 0, so no special case is
# needed.

# %%
change_1, change_2 = v1_after - v1, v2_after - v2
check("momentum gained by both together", m1 * change_1 + m2 * change_2, 0, 1e-12)
impulse = smooth_impulse((3, -4), 2, (0, 0), inf, (0, -1), 0.5)
check("against a fixed disc: chapter 03", np.array([3, -4]) - impulse / 2, (3, 2))

# %% [markdown]
# Disc 2 is at rest, and disc 1 comes from the left at 3 m/s. Its path misses the centre of disc 2
# by the offset, a part of $r_1 + r_2$. Both discs leave in directions that you can foresee.

# %%
predict("04-angle")

# %% tags=["answer"]
# an oblique hit: drag disc 2 to where it is to be hit
live(
    "ch04_circles/oblique_hit",
    "Disc 1 comes from the left and hits disc 2, which is at rest, half a radius sum off its "
    "centre. Disc 2 leaves along the line of the centres, disc 1 at a right angle to it, and no "
    "energy is lost. You can drag disc 2 round disc 1, and change the offset, both masses and the "
    "restitution.",
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Every pool player uses this to guess where the cue ball goes. Set the mass of disc 2 higher: the
# angle grows, because disc 1 is thrown back. Set e lower: the angle shrinks, because disc 1 keeps
# something of its part along n.

# %% tags=["answer"]
# three offsets, equal masses, e = 1
v1, v2 = np.array([3.0, 0.0]), np.zeros(2)
for offset in (0.1, 0.5, 0.9):
    n = np.array([np.sqrt(1 - offset**2), offset])
    impulse = smooth_impulse(v1, 1.0, v2, 1.0, n, restitution=1.0)
    w1, w2 = v1 - impulse, v2 + impulse
    check(f"offset {offset}: the velocities are at a right angle", dot(w1, w2), 0, 1e-12)
    check("  ball 2 leaves along n", dot(w2, perpendicular(n)), 0, 1e-12)

# %% [markdown]
# ## 4 What goes wrong: one dimension on x, one dimension on y
#
# It is tempting to take `elastic_1d` from chapter 01 and to use it twice, on the x components and
# on the y components.

# %%
predict("04-graze")

# %% tags=["answer"]
# a ball grazes another
n, v1, v2 = np.array([0.28, -0.96]), np.array([3.0, 0.0]), np.zeros(2)
impulse = smooth_impulse(v1, 1.0, v2, 1.0, n, 1.0)
answers = {
    "along the normal": (v1 - impulse, v2 + impulse),
    "x and y apart": wrong.one_dimension_on_each_axis(v1, 1.0, v2, 1.0, n, 1.0),
}

# %% tags=["answer"]
# both answers, drawn
figures.grazing_hits(n, (v1, v2), answers)

# %% [markdown]
# Which law notices that? Not momentum, and not energy: both are kept along x and along y, so both
# are kept. The impulse has the wrong **direction**. It does not point from centre to centre, so
# it would have to turn the discs, and nothing turns. The **angular momentum** sees that, here
# about the point where the discs touch.

# %%
masses, places = [1, 1], [-0.5 * n, 0.5 * n]
before = angular_momentum(masses, places, [v1, v2])
for name, after in answers.items():
    print(f"{name:17} momentum {momentum(masses, after).round(9) + 0}, ", end="")
    print(f"energy {kinetic_energy(masses, after):.2f} J, ", end="")
    print(f"angular momentum {before:+.2f} -> {angular_momentum(masses, places, after):+.2f}")

# %% [markdown]
# ## 5 Separate first, the lighter one further
#
# The velocities are right now, the positions are not: the discs still overlap. They are moved
# apart along n until they just touch. The formula is that of the impulse, with the depth in place
# of the change of velocity:
#
# $$P = \text{depth} \cdot m_{\text{eff}}\,n \qquad p_1' = p_1 - P/m_1 \qquad p_2' = p_2 + P/m_2$$
#
# The ways are in inverse proportion to the masses. A fixed disc stays, and the centre of mass
# stays where it is. Write the two lengths, |P|/m₁ and |P|/m₂, for two discs that can both move:


# %%
@gap("04-ways")
def ways(depth, m1, m2):
    return ...


# %%
n, depth = np.array([1.0, 0.0]), 0.4
push = separating_push(1, 3, n, depth)
check("1 kg and 3 kg: the ways", (-push[0] / 1, push[0] / 3), (-0.3, 0.1), 1e-15)
check("their lengths by yours", ways(depth, 1, 3), (0.3, 0.1), 1e-15)
check("together: the depth", push[0] / 1 + push[0] / 3, depth, 1e-15)
check("the centre of mass moves by", 1 * (-push / 1) + 3 * (push / 3), 0)
push = separating_push(1, inf, n, depth)
check("1 kg and a fixed disc: the ways", (-push[0] / 1, push[0] / inf), (-0.4, 0))

# %% [markdown]
# Many programs give each disc half.

# %%
predict("04-half-each")

# %% tags=["answer"]
# 1 kg overlaps 9 kg: by mass, and half each
p1, p2, r1, r2, m1, m2 = np.zeros(2), np.array([1.0, 0.0]), 0.5, 0.9, 1.0, 9.0
push = separating_push(m1, m2, n, r1 + r2 - 1.0)
both_ways = {
    "by mass": (p1 - push / m1, p2 + push / m2),
    "half each": wrong.half_each(p1, m1, p2, m2, n, r1 + r2 - 1.0),
}

# %% tags=["answer"]
# where both discs end up
figures.moved_apart((p1, r1, p2, r2), both_ways)

# %% [markdown]
# **"Separate first"** means: no gate before the positions. A pair that overlaps and already
# separates gets no impulse, but it is moved apart all the same. A program that returns early
# leaves it inside.

# %%
given = (p1, np.zeros(2), 1.0, np.array([1.0, 0.0]), np.array([0.1, 0.0]), 1.0, n, 0.4, 0.5)
q1, _, q2, _ = wrong.returns_before_separating(*given)
check("returned early: still 1 m apart, where 1.4 m are needed", q2[0] - q1[0], 1.0)
push = separating_push(1, 1, n, 0.4)
check("separated: the distance of the centres", (p2 + push - (p1 - push))[0], 1.4, 1e-15)
check("and no impulse", smooth_impulse((0, 0), 1, (0.1, 0), 1, n, 0.5), (0, 0))

# %% [markdown]
# ## 6 The engine does this for every pair, in every step
#
# A `Scene` holds bodies. `simulate` lets time pass in small steps: it moves the bodies, finds
# the pairs that overlap, and hands impulses over. Here are two discs on their way to an oblique
# hit. `solver="pymunk"` gives the same scene to pymunk. In the engine, the two bodies of a pair
# are called A and B, and n points from A to B.

# %%
material = Material(restitution=0.8)
scene = Scene(
    [
        Body(Circle(0.5), mass=1.0, position=(-2, 0.1), velocity=(3, 0), material=material),
        Body(Circle(0.8), mass=3.0, position=(1, -0.3), velocity=(-1, 0), material=material),
    ]
)
run = simulate(scene, duration=1.5, solver="sequential")
other = simulate(scene, duration=1.5, solver="pymunk")
check("velocities at the end, as pymunk's", run.velocities[-1] - other.velocities[-1], 0, 1e-12)

# %%
time = run.contacts.time[0]  # the end of the step that found the overlap
d = np.array([1 - time, -0.3]) - np.array([-2 + 3 * time, 0.1])
n = d / np.hypot(*d)
small = Struck(1 / 1, 0, velocity=(3, 0), angular_velocity=0, arm=0.5 * n)
large = Struck(1 / 3, 0, velocity=(-1, 0), angular_velocity=0, arm=-0.8 * n)
exact = disc_impact(small, large, n, restitution=0.8, friction=0)
check("and as the closed form's", run.velocities[-1] - exact.velocities, 0, 1e-12)

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3.8)
scene_plots.ghosts(ax, run, (0.0, 0.5, 1.0, 1.5))
scene_plots.trails(ax, run)
show(
    fig,
    "Two discs at four times, earlier ones fainter. They meet obliquely; the small one is thrown "
    "back and upward, the large one goes on slowly and downward.",
)

# %% [markdown]
# The engine and pymunk push a little differently against the overlap, so the *positions* after a
# hit are not compared here. Velocities are: a push never enters them.
#
# **A fair comparison.** A step first moves the discs, and then looks for contacts. So the normal
# belongs to the *moved* positions p + v dt. Below are 3,000 random pairs, with masses from 1 g to
# 1,000 kg and radii from 0.1 to 10 m. They are put back by v dt, so that one step makes them
# overlap by a millimetre.

# %%
rng, count, dt = np.random.default_rng(seed=4), 3000, 1e-3
m, r = 10 ** rng.uniform(-3, 3, (2, count)), 10 ** rng.uniform(-1, 1, (2, count))
v, e = rng.uniform(-5, 5, (2, count, 2)), rng.uniform(0, 1, count)
way = rng.uniform(0, 2 * np.pi, count)
moved = rng.uniform(-1, 1, (2, count, 2))
moved[1] = moved[0] + ((r[0] + r[1] - 1e-3) * (np.cos(way), np.sin(way))).T
start = moved - v * dt


def one_step(pair, solver):
    bodies = [
        Body(Circle(r[i, pair]), mass=m[i, pair], position=start[i, pair],
             velocity=v[i, pair], material=Material(restitution=e[pair]))
        for i in (0, 1)
    ]  # fmt: skip
    return simulate(Scene(bodies), dt, solver=solver, dt=dt, sample="end").velocities[-1]


# %%
def formula(positions):
    d = positions[1] - positions[0]
    impulse = smooth_impulse(v[0], m[0], v[1], m[1], d / np.hypot(*d.T)[:, np.newaxis], e)
    return np.stack(
        (v[0] - impulse / m[0][:, np.newaxis], v[1] + impulse / m[1][:, np.newaxis]), axis=1
    )


ours, pymunks = (
    np.array([one_step(pair, solver) for pair in range(count)])
    for solver in ("sequential", "pymunk")
)
size = np.abs(v).max(axis=(0, 2))[:, np.newaxis, np.newaxis]
check("the engine", (ours - formula(start + v * dt)) / size, 0, tolerance=1e-13)
check("pymunk", (pymunks - formula(start + v * dt)) / size, 0, tolerance=1e-13)
late = np.abs(pymunks - formula(start)) / size
print(f"with the normal before the step: off by up to {late.max():.1f} times the speed")

# %% [markdown]
# ## 7 A table full of balls
#
# Now 32 pool balls on a table, all moving, for three seconds. The scene is made in
# `lesson_code/chapters/ch04_circles/scenes.py`. Four laws are asked about every step:
#
# - with e = 1 the energy is kept;
# - with e = 0.8 it never grows;
# - the momentum of the balls changes by just what the cushions give them, and by nothing else;
# - every ball stays on the table.

# %%
fine = {"duration": 3.0, "dt": 1 / 240, "iterations": 30}  # section 8 says why 30
elastic = simulate(table.scattered_balls(restitution=1.0), **fine)
lossy = simulate(table.scattered_balls(restitution=0.8), **fine)
energy = elastic.kinetic_energy / elastic.kinetic_energy[0]
check("e = 1: energy, in every step", energy, 1, tolerance=1e-12)
growth = np.diff(lossy.kinetic_energy) / lossy.kinetic_energy[0]
check("e = 0.8: it never grows, rounding apart", bool((growth < 1e-12).all()), True)
hits = elastic.contacts
cushion = hits.body_a < disc_scenes.CUSHIONS
given = hits.normal_impulse[cushion, np.newaxis] * hits.normal[cushion]
gained = elastic.momentum[-1] - elastic.momentum[0]
check("momentum gained is what the cushions gave", gained - given.sum(axis=0), 0, 1e-12)
check("balls on the table at the end", table.balls_on_table(elastic)[-1], 32)

# %% [markdown]
# **The first attempt.** `solver="naive"` is what you would write first: for every pair, the
# impulse along the line of the centres, then half of the overlap for each; pairs that separate are
# left as they are. Every line of it looks right. Now run it on the same table, for three seconds.

# %%
predict("04-naive")

# %% tags=["answer"]
# the balls that are left after 3 s
naive = simulate(table.scattered_balls(restitution=1.0), solver="naive", **fine)
on_table = {
    "sequential impulses": (elastic.times, table.balls_on_table(elastic)),
    "the first attempt": (naive.times, table.balls_on_table(naive)),
}
print({name: int(count[-1]) for name, (_, count) in on_table.items()})
figures.balls_left(on_table)

# %% tags=["answer"]
# both tables, as they move
animate(
    {"sequential impulses": elastic, "the first attempt": naive},
    "Two pool tables with 32 balls, which all start moving. On the left they go on bouncing off "
    "each other and off the cushions for three seconds. On the right they leave the table.",
    fps=20,
    around=(-1.5, 1.5, -0.8, 0.8),
    still=0.5,
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# For two discs the line of the centres *is* the normal. A cushion is no disc: its centre is its
# middle, and a ball that meets it near a corner is pushed along the cushion instead of away from
# it. Chapter 06 finds the right normal for other shapes. Energy and momentum did not notice
# anything.

# %% [markdown]
# ## 8 More than two: one look at each contact is not enough
#
# A cue ball rolls between two balls that touch each other, and hits both at once. By symmetry it
# must not turn aside. Momentum and energy then say all: it comes back with 1/5 of its speed, and
# the two others leave with $(3, \pm\sqrt{3})/5$.

# %%
predict("04-pairs")

# %% tags=["answer"]
# the naive solver, with the two balls listed in either order
shot = {"duration": 1e-9, "dt": 1e-9}  # one step, so short that nothing moves
for upper_first in (True, False):
    scene = disc_scenes.cue_between_two(upper_first=upper_first)
    cue = simulate(scene, solver="naive", **shot).velocities[-1, 0]
    print(f"upper ball first: {upper_first!s:5}  cue ball after: ({cue[0]:.3f}, {cue[1]:+.3f}) m/s")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# It turns aside, and which way depends on the order in which the scene **lists** the two balls.
# The first pair was resolved as if it were alone in the world. That was right for a moment; then
# the second impulse changed the velocity of the cue ball, and nobody looked at the first pair
# again.

# %% [markdown]
# The cure is called **sequential impulses**: go round all contacts again and again, and each time
# correct the impulse given so far, which in total must only push. Each round is an *iteration*.

# %%
rounds = np.arange(1, 13)
aside = {
    name: [
        abs(simulate(scene, solver=solver, iterations=n, **shot).velocities[-1, 0, 1])
        for n in rounds.tolist()
    ]
    for name, solver in (("sequential impulses", "sequential"), ("pymunk", "pymunk"))
}

# %%
after = simulate(scene, iterations=20, **shot).velocities[-1]
cue, upper, lower = break_shot(speed=1, restitution=1)
check("20 iterations: the cue ball", after[0], cue, tolerance=1e-8)
check("the lower ball, listed first", after[1], lower, tolerance=1e-8)
check("the upper ball", after[2], upper, tolerance=1e-8)
fault = np.array(aside["sequential impulses"])
check("each round leaves this part of the fault", fault[1:6] / fault[:5], 1 / 16, 1e-4)
check("pymunk's fault, round by round", np.array(aside["pymunk"]) - fault, 0, 1e-12)

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3.2)
plots.curves(ax, {name: (rounds, values) for name, values in aside.items()}, "iterations", "")
ax.set_yscale("log")
ax.set_ylabel("cue ball's sideways speed, m/s")
show(
    fig,
    "The sideways speed of the cue ball, which should be zero, over the number of iterations, on "
    "a logarithmic scale. It falls along a straight line, alike for our engine and pymunk.",
)

# %% [markdown]
# The order decides which ball is favoured, and how much. Iterations take its influence away. The
# two normals are 60 degrees apart, so an impulse at one contact spoils the other by
# cos 60°/2 = 1/4, and there and back by 1/16: that is what each round leaves. The engine and
# pymunk make ten rounds in each step, unless they are asked for more.
#
# So to the break. Fifteen balls stand in a triangle, a millimetre apart, and e = 0.95. The cue
# ball comes along the middle line. By symmetry it can never leave that line; with ten rounds it
# does, because every later hit multiplies the small fault of the first.

# %%
rack = disc_scenes.rack_break(restitution=0.95)
breaks = {n: simulate(rack, 4.0, dt=1 / 240, iterations=n) for n in (10, 30)}
cue = disc_scenes.CUSHIONS  # the first ball after the cushions
strayed = {n: np.abs(run.positions[:, cue, 1]).max() for n, run in breaks.items()}
check("10 rounds: more than a millimetre off the line", bool(strayed[10] > 1e-3), True)
check("30 rounds: off the line by", strayed[30], 0, tolerance=1e-9)
growth = np.diff(breaks[30].kinetic_energy) / breaks[30].kinetic_energy[0]
check("energy never grows, rounding apart", bool((growth < 1e-12).all()), True)

# %%
animate(
    breaks[30],
    "A pool table. The cue ball hits a triangle of fifteen balls, which scatter all over the "
    "table and bounce off the cushions, mirrored at the middle line.",
    fps=24, around="all", still=1.0,
)  # fmt: skip

# %% [markdown]
# ### A row of five: two answers, both lawful
#
# Newton's cradle, without strings: one disc runs at 1 m/s into a row of four at rest. Between
# neighbours there is a gap of a thousandth of a millimetre, or an overlap of that size.

# %%
predict("04-row")

# %% tags=["answer"]
# five discs, with a gap and with an overlap
cradle = {
    name: simulate(disc_scenes.row_of_discs(5, gap), 1.0, iterations=100)
    for name, gap in (("gap of 1 µm", 1e-6), ("overlap of 1 µm", -1e-6))
}
last = {name: run.velocities[-1, :, 0] for name, run in cradle.items()}
check("one after the other", last["gap of 1 µm"], cradle_one_by_one(5, 1), tolerance=1e-9)
check("all at once", last["overlap of 1 µm"], cradle_all_at_once(5, 1), tolerance=1e-9)
for name, run in cradle.items():
    check(f"{name}: momentum", run.momentum[-1, 0], 1.0, tolerance=1e-12)
    check(f"{name}: energy", run.kinetic_energy[-1], 0.5, tolerance=1e-9)

# %% tags=["answer"]
# the velocities after
figures.row_of_five(last)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# With a gap the pairs collide one after the other, each by chapter 01. With an overlap all four
# contacts are found in the same step and solved *together*: the first pair must part as fast as
# it approached, and the pairs at rest must not come closer. Both answers keep momentum and
# energy. For three bodies or more these two laws no longer decide what happens. Steel balls on
# strings come close to the first answer, because a shock needs time to run through them.

# %% [markdown]
# ## 9 Break it on purpose: three small faults
#
# **One factor too many.** The impulse with 2(1 + e), from chapter 01, again: head on, equal
# masses.

# %%
v1, v2, n = np.array([2.0, 0.0]), np.array([-2.0, 0.0]), np.array([1.0, 0.0])
for e in (0.0, 0.5, 0.8, 1.0):
    w1, w2 = wrong.doubled_impulse(v1, 1, v2, 1, n, e)
    impulse = smooth_impulse(v1, 1, v2, 1, n, e)
    growth = kinetic_energy([1, 1], [w1, w2]) / kinetic_energy([1, 1], [v1, v2])
    right = kinetic_energy([1, 1], [v1 - impulse, v2 + impulse]) / kinetic_energy([1, 1], [v1, v2])
    print(f"e = {e}: momentum {momentum([1, 1], [w1, w2])}, ", end="")
    print(f"energy times {growth:.2f}, right {right:.2f}")

# %% [markdown]
# Momentum is blind to it, in two dimensions as in one. The energy with which the discs approach
# is multiplied by $(1 + 2e)^2$, where it should be multiplied by $e^2$.
#
# **No direction.** Two discs are put in the same place; a game that lets the player add discs
# with the mouse does this sooner or later.

# %%
predict("04-heap")

# %% tags=["answer"]
# two discs in one place, 1 kg and 3 kg
heap = Scene([Body(Circle(0.5), mass=1.0), Body(Circle(0.5), mass=3.0)])
for solver in ("naive", "sequential"):
    apart = np.diff(simulate(heap, 2.0, solver=solver).positions[:, :, 0])[:, 0]
    print(f"{solver:10} apart after 0, 0.1, 0.5, 2 s: ", end="")
    print(", ".join(f"{apart[step]:.3f}" for step in (0, 6, 30, 120)), "m")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The first attempt divides by the distance, so it has to leave such a pair alone, and the discs
# stay stuck for ever. With (1, 0) as the normal they part, the light one three times as far. The
# engine does not throw them apart at once: it takes away a fifth of the overlap in each step and
# leaves half a percent of a body's width, so that resting contacts stay contacts.

# %% [markdown]
# **Half each** was the third fault, in section 5. Against a fixed post it is the worst: the post
# ignores its half, and the ball stays inside by the other.

# %%
post = Body(Circle(0.5), position=(0.8, 0.0))
ball = Body(Circle(0.5), mass=1.0, velocity=(0.3, 0.0), material=Material(restitution=0.0))
for solver in ("naive", "sequential"):
    run = simulate(Scene([ball, post]), 2.0, solver=solver)
    print(f"{solver:10} depth after 2 s: {run.max_penetration[-1]:.3f} m")

# %% [markdown]
# ## 10 Quiz

# %%
show_quiz("04")

# %% [markdown]
# ## 11 Key takeaways
#
# - Compare squares: d · d < (r1 + r2)² throws out a far pair without a root.
# - The impulse acts along the normal. x and y apart is wrong, and only angular momentum notices.
# - Same |J|, and each its own mass: the lighter disc changes more, in velocity and in position.
# - The gate is for velocities. Positions are separated first, gate or no gate.
# - Where contacts touch each other, go round them again and again.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** contact, impulse and way apart against numbers worked by hand; 3,000 random
# pairs, our engine and pymunk, against the formula at the moved positions, to 1e-13 of the larger
# speed; energy, momentum and the cushions' impulses over three seconds of a full table; a hit of
# three balls against algebra.
#
# **Limits.** The discs are smooth: they slide on each other without a trace and never begin to
# spin. A very fast disc can jump over another between two steps; chapter 07 is about that.
#
# **Do now:** the exercise [04 Circles](../exercises/04_circles.ipynb): four tasks, seventeen
# points. In a terminal, `workbook watch 04` runs it again whenever you save. Play with what you
# know now in `workbook play simulator`; the challenge of this chapter is the field of
# [asteroids](../exercises/asteroids.py). **Next:** [05 Spin and
# friction](05_spin_and_friction.ipynb), where the direction across the normal comes alive.
#
# **Sources.** Mirtich and Canny, *Impulse-based Simulation of Rigid Bodies* (1995): one impact.
# Catto, *Fast and Simple Physics using Sequential Impulses* (2006): many. Herrmann and Seitz,
# *How does the ball-chain work?*, American Journal of Physics 50 (1982), 977: why a real row
# comes close to the first answer.
