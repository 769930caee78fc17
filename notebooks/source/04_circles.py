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
# Two pool balls hardly ever meet head on. That is why pool is a game of skill: where you hit a
# ball decides where it goes. In this chapter you find the discs that touch, send each off in the
# right direction, and move overlapping discs apart. At the end an engine does this for a whole
# table.
#
# **After this notebook you will be able to**
#
# 1. find out whether two discs overlap, in which direction and how deep;
# 2. compute both velocities after an oblique hit, and say why you must not use the formula of one
#    dimension on x and on y;
# 3. move overlapping discs apart by their masses, and explain why a solver has to visit contacts
#    more than once.
#
# **You need** notebooks 01 to 03. **Time:** about 50 minutes with the questions; it runs in
# ten seconds.

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
from lesson_code.evidence import check, check_bound
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.formulas import angular_momentum, collide_1d, kinetic_energy, momentum
from lesson_code.formulas.arithmetic import dot
from lesson_code.formulas.smooth_pair import separating_push, smooth_impulse
from lesson_code.formulas.validation import equation
from lesson_code.geometry import Circle, collide
from lesson_code.reference import impact_closed_forms as closed
from lesson_code.view.browser.live import live
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 Two discs overlap when their centres are nearer than r1 + r2
#
# A table of 32 balls has 496 pairs, and in each step you ask every pair: do you overlap? Let d be
# the vector from centre 1 to centre 2. Discs that just touch have their centres exactly $r_1 + r_2$
# apart. Nearer centres mean an overlap. Write the test, and compare *squares*: then it needs no
# square root, which takes time. `d` is an array, and `dot` is there for you:


# %%
@gap("04-overlap")
def overlap(d, r1, r2):
    return ...


# %% [markdown]
# $$d \cdot d < (r_1 + r_2)^2$$
#
# If a pair overlaps, you need two more things: the **normal** n, a unit vector from disc 1 to
# disc 2, and the **depth**.
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
figures.overlapping(p1, r1, p2, r2, contact)

# %% [markdown]
# Two special cases need a rule:
#
# - **Touching is not overlapping.** At depth 0 there is nothing to push apart, so `collide`
#   returns `None`.
# - **The same centre.** Then |d| = 0, and d/|d| is nan: there is no direction. Any unit vector
#   will do, as long as you always take the same one. This course takes (1, 0).

# %%
unit, place = Circle(1.0), (0.0, 0.0, 0.0)
check("touching", collide(unit, place, unit, (2.0, 0.0, 0.0)), None)
barely = collide(unit, place, unit, (np.nextafter(2.0, 0.0), 0.0, 0.0))
check("a hair closer: an overlap", barely is not None, True)
same = collide(unit, place, unit, place)
check("the same centre: normal", same.normal, (1, 0))
check("the same centre: depth", same.penetrations[0], 2)

# %% [markdown]
# ## 2 The gate: only discs that approach collide
#
# A pair that you bounced a step ago may still overlap. Bounce it again, and you send the discs back
# into each other. Seen from disc 1, disc 2 moves with $v_2 - v_1$. The part along n tells you
# whether they approach:
#
# $$v_n = (v_2 - v_1) \cdot n \qquad v_n < 0: \text{they approach} \qquad v_n \ge 0: \text{they
# separate}$$
#
# Only a pair that approaches gets an impulse: the gate of chapter 03, and now both bodies move.

# %%
n = np.array([0.6, 0.8])
for name, v1, v2 in (
    ("head on", (3, 4), (-3, -4)),
    ("2 runs away, 1 is faster", (3, 4), (0.6, 0.8)),
    ("they pass each other", (4, -3), (-4, 3)),
):
    vn = dot(np.subtract(v2, v1), n) + 0.0  # makes 0.0 of -0.0
    print(f"{name:26} vn = {vn:+5.1f} m/s: {'approach' if vn < 0 else 'separate'}")

# %% [markdown]
# ## 3 The impulse acts along the normal, and along nothing else
#
# Now you can compute a hit. Smooth discs can only push, and only along n. So disc 2 receives the
# impulse $J = j\,n$, and disc 1 receives $-J$:
#
# $$v_1' = v_1 - J/m_1 \qquad v_2' = v_2 + J/m_2$$
#
# So an impulse of 1 N s changes $v_n$ by $1/m_1 + 1/m_2$. Which j turns $v_n$ into $-e\,v_n$? Write
# it for discs that approach, so `vn` is negative:


# %%
@gap("04-impulse")
def impulse_along(vn, m1, m2, e):
    return ...


# %% [markdown]
# The inverse of $1/m_1 + 1/m_2$ has a name: it is the **effective mass** of the pair.
#
# $$j = -(1 + e)\,v_n\,m_{\text{eff}} \qquad m_{\text{eff}} = \frac{1}{1/m_1 + 1/m_2}$$
#
# The engine runs these lines. Its gate is inside `normal_impulse`:

# %%
print(inspect.getsource(equation(smooth_impulse)).split('"""')[-1].strip("\n"))

# %% [markdown]
# Work one example by hand. Along n, a disc of 1 kg moves at 2 m/s and a disc of 3 kg at -1 m/s;
# e = 0.7. Across n they move at 5 and -7 m/s.

# %%
predict("04-by-hand")

# %% tags=["answer"]
# the four numbers, before and after
n, t = np.array([0.6, 0.8]), np.array([-0.8, 0.6])
m1, m2, e = 1.0, 3.0, 0.7
v1, v2 = 2 * n + 5 * t, -1 * n - 7 * t
impulse = smooth_impulse(v1, m1, v2, m2, n, e)
v1_after, v2_after = v1 - impulse / m1, v2 + impulse / m2
check("j = 1.7 * 3 * 0.75", np.hypot(*impulse), 3.825, tolerance=1e-12)
check("by your line", impulse_along(-3, m1, m2, e), 3.825, tolerance=1e-12)
along = (dot(v1_after, n), dot(v2_after, n))
check("along n, after, as in chapter 01", along, collide_1d(1, 2, 3, -1, 0.7), 1e-12)
check("across n, after", (dot(v1_after, t), dot(v2_after, t)), (5, -7), 1e-12)

# %% [markdown]
# **Proper mass.** Both discs receive the same |J|, but each divides it by its own mass. So the
# disc with three times the mass changes its velocity by a third as much, in the opposite
# direction. A mass of `math.inf` means a disc that nothing can move: 1/m is then exactly 0.

# %%
check("momentum", m1 * v1_after + m2 * v2_after, m1 * v1 + m2 * v2, 1e-12)
impulse = smooth_impulse((3, -4), 2, (0, 0), inf, (0, -1), 0.5)
check("against a fixed disc: chapter 03", np.array([3, -4]) - impulse / 2, (3, 2))

# %% [markdown]
# Now aim. Disc 2 is at rest, and disc 1 comes from the left at 3 m/s. The *offset* says how far its
# path misses the centre of disc 2, as a part of $r_1 + r_2$.

# %%
predict("04-angle")

# %% tags=["answer"]
# an oblique hit: drag disc 2, and change offset, masses and e
live(
    "ch04_circles/oblique_hit",
    "Disc 1 comes from the left and hits disc 2 at rest, half a radius sum off its centre. Disc 2 "
    "leaves along the line of the centres, disc 1 at a right angle to it. You can drag disc 2 "
    "round disc 1, and change the offset, both masses and e.",
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The two ways make a right angle, wherever the hit was: disc 2 leaves along n, disc 1 across it.
# Pool players use this to guess where the cue ball goes. Now make disc 2 heavier: the angle grows,
# because disc 1 bounces back. Make e smaller: the angle shrinks, because disc 1 keeps some of its
# velocity along n.

# %% tags=["answer"]
# three offsets, equal masses, e = 1
v1 = np.array([3.0, 0.0])
for offset in (0.1, 0.5, 0.9):
    n = np.array([np.sqrt(1 - offset**2), offset])
    impulse = smooth_impulse(v1, 1, (0, 0), 1, n, restitution=1)
    check(f"offset {offset}: at a right angle", dot(v1 - impulse, impulse), 0, 1e-12)

# %% [markdown]
# ## 4 What goes wrong: one dimension on x, one dimension on y
#
# You already have a formula for one dimension. Why not use `elastic_1d` from chapter 01 twice, once
# for the x components and once for the y components? Many first programs do.

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
figures.grazing_hits(n, (v1, v2), answers)

# %% [markdown]
# Which law notices the fault? Not momentum and not energy: the formula keeps both along x and along
# y. But the impulse has the wrong **direction**. It does not point from centre to centre, so it
# would have to make the discs spin, and they do not. The **angular momentum** shows it, here about
# the point where they touch.

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
# The velocities are right, but the discs still overlap. So move them apart along n until they just
# touch. The formula is that of the impulse, with the depth in place of the change of velocity:
#
# $$P = \text{depth} \cdot m_{\text{eff}}\,n \qquad p_1' = p_1 - P/m_1 \qquad p_2' = p_2 + P/m_2$$
#
# The lighter disc moves further, a fixed disc does not move at all, and the centre of mass stays
# where it is. Write the two lengths, |P|/m₁ and |P|/m₂, for two discs that can both move:


# %%
@gap("04-ways")
def ways(depth, m1, m2):
    return ...


# %%
n, depth = np.array([1.0, 0.0]), 0.4
push = separating_push(1, 3, n, depth)
check("1 kg and 3 kg move by", (-push[0] / 1, push[0] / 3), (-0.3, 0.1), 1e-15)
check("by your line", ways(depth, 1, 3), (0.3, 0.1), 1e-15)
check("the centre of mass moves by", 1 * (-push / 1) + 3 * (push / 3), 0)
push = separating_push(1, inf, n, depth)
check("1 kg and a fixed disc move by", (-push[0] / 1, push[0] / inf), (-0.4, 0))

# %% [markdown]
# Many programs simply move each disc by half of the depth.

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
figures.moved_apart((p1, r1, p2, r2), both_ways)

# %% [markdown]
# **"Separate first"** means: positions have no gate. A pair that overlaps and already separates
# gets no impulse, but you still move it apart. Do not return early.

# %%
q1, _, q2, _ = wrong.returns_before_separating(p1, 0 * n, 1, p2, 0.1 * n, 1, n, 0.4, 0.5)
check("returned early: still 1 m apart, where 1.4 m are needed", q2[0] - q1[0], 1.0)
push = separating_push(1, 1, n, 0.4)
check("separated", (p2 + push - (p1 - push))[0], 1.4, 1e-15)

# %% [markdown]
# ## 6 The engine does this for every pair, in every step
#
# You now have all the parts: overlap, gate, impulse, separation. Here they are in a step, and three
# of its lines are yours:


# %%
def my_step(p1, v1, r1, m1, p2, v2, r2, m2, e, dt):
    p1, p2 = p1 + v1 * dt, p2 + v2 * dt
    d = p2 - p1
    if not overlap(d, r1, r2):
        return p1, v1, p2, v2
    distance = np.hypot(*d)
    n = d / distance
    way_1, way_2 = ways(r1 + r2 - distance, m1, m2)
    p1, p2 = p1 - way_1 * n, p2 + way_2 * n  # separate first
    vn = dot(v2 - v1, n)
    if vn < 0:  # the gate
        j = impulse_along(vn, m1, m2, e)
        v1, v2 = v1 - j / m1 * n, v2 + j / m2 * n
    return p1, v1, p2, v2


# %% [markdown]
# A `Scene` holds bodies, and `simulate` repeats such steps. With `solver="pymunk"` the same scene
# runs in pymunk, an engine that other people wrote. The engine calls the bodies of a pair A and B;
# n points from A to B.

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
(p1, p2), (v1, v2) = run.positions[0], run.velocities[0]
for _ in range(90):
    p1, v1, p2, v2 = my_step(p1, v1, 0.5, 1.0, p2, v2, 0.8, 3.0, 0.8, 1 / 60)
check("and by your own steps", (v1, v2), run.velocities[-1], 1e-12)

# %% tags=["plumbing"]
figures.two_on_their_way(run)

# %% [markdown]
# We do not compare positions: the engines push a little differently against an overlap, and that
# push never enters a velocity.
#
# **A fair comparison.** A step first moves the discs and then looks for
# contacts. So the normal belongs to the *moved* positions p + v dt. We draw 3,000 pairs, with
# masses from 1 g to 1,000 kg and radii from 0.1 to 10 m; a step makes each of them overlap by a
# millimetre. Then we compare both engines with the formula.

# %%
pairs = table.random_pairs(3000, seed=4)
moved, late = pairs.by_formula(moved=True), pairs.by_formula(moved=False)
# the largest component of each pair's velocities
size = np.abs(pairs.velocities).max(axis=(0, 2))[:, np.newaxis, np.newaxis]
for solver in ("sequential", "pymunk"):
    off = (pairs.after_one_step(solver) - moved) / size
    check(f"{solver}: off by, in parts of the speed", off, 0, tolerance=1e-13)
late = np.abs(late - moved) / size
print(f"with the normal before the step: off by up to {late.max():.1f} times the speed")

# %% [markdown]
# ## 7 A table full of balls
#
# Two discs are easy to watch. With 32 pool balls for three seconds you need laws that watch for
# you, in every step:
#
# - with e = 1 the balls keep their energy;
# - with e = 0.8 the energy never grows;
# - only the cushions change the momentum of the balls;
# - every ball stays on the table.

# %%
fine = {"duration": 3.0, "dt": 1 / 240, "iterations": 30}  # section 8 says why 30
elastic = simulate(table.scattered_balls(restitution=1.0), **fine)
lossy = simulate(table.scattered_balls(restitution=0.8), **fine)
energy = elastic.kinetic_energy / elastic.kinetic_energy[0]
check("e = 1: energy, in every step", energy, 1, tolerance=1e-12)
growth = np.diff(lossy.kinetic_energy) / lossy.kinetic_energy[0]
check_bound("e = 0.8: it never grows, rounding apart", growth, at_most=1e-12)
hits = elastic.contacts
cushion = hits.body_a < disc_scenes.CUSHIONS
given = hits.normal_impulse[cushion, np.newaxis] * hits.normal[cushion]
gained = elastic.momentum[-1] - elastic.momentum[0]
check("momentum gained is what the cushions gave", gained - given.sum(axis=0), 0, 1e-12)

# %% [markdown]
# **The first attempt.** `solver="naive"` is what most people write first: for every pair the
# impulse along the line of the centres, then half of the overlap for each; it skips pairs that
# separate. Every line looks right. Run it on the same table.

# %%
predict("04-naive")

# %% tags=["answer"]
# the balls that are left after 3 s
naive = simulate(table.scattered_balls(restitution=1.0), solver="naive", **fine)
print("sequential:", table.balls_on_table(elastic)[-1])
print("naive:     ", table.balls_on_table(naive)[-1])

# %% tags=["answer"]
# both tables, as they move
animate(
    {"sequential impulses": elastic, "the first attempt": naive},
    "Two pool tables with 32 moving balls. On the left they bounce off each other and off the "
    "cushions for three seconds. On the right they leave the table.",
    fps=20,
    around=(-1.5, 1.5, -0.8, 0.8),
    still=0.5,
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# For two discs the line of the centres *is* the normal. A cushion is not a disc: from its middle,
# it pushes a ball near the corner along the cushion instead of away from it. Energy and momentum
# notice nothing. Chapter 06 finds the right normal for other shapes.

# %% [markdown]
# ## 8 More than two discs at once
#
# A solver that treats each pair once is right as long as no two contacts share a ball. Now a cue
# ball hits two balls that touch each other, both at the same time. By symmetry it must not turn
# aside. Momentum and energy give the rest: it comes back with 1/5 of its speed, and the other two
# leave with $(3, \pm\sqrt{3})/5$.

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
# It turns aside, and the order in which the scene **lists** the two balls decides which way. The
# solver treats the first pair as if it were alone in the world. The second impulse then changes
# the velocity of the cue ball, and nobody looks at the first pair again.

# %% [markdown]
# The cure is called **sequential impulses**: visit all contacts again and again, and each time
# correct the impulse given so far. In total an impulse must only push. Each round is an
# *iteration*.

# %%
aside = {
    solver: table.sideways_speeds(scene, solver, rounds=range(1, 13))
    for solver in ("sequential", "pymunk")
}
figures.sideways_speeds(aside)

# %%
after = simulate(scene, iterations=20, **shot).velocities[-1]
cue, upper, lower = closed.break_shot(speed=1, restitution=1)
check("20 iterations: cue ball, lower ball, upper ball", after, (cue, lower, upper), 1e-8)
fault = aside["sequential"]
check("each round leaves this part of the fault", fault[1:6] / fault[:5], 1 / 16, 1e-4)
check("pymunk's fault, round by round", aside["pymunk"] - fault, 0, 1e-12)

# %% [markdown]
# Why 1/16? An impulse at one contact changes the velocities of two equal discs. Only the cue ball,
# half of that change, belongs to the other contact too. The normals are 60 degrees apart, so
# cos 60° = 1/2 of it counts there: the other contact is spoilt by 1/4. Each round goes there and
# back. The engine and pymunk make ten rounds in each step, unless you ask for more.
#
# Are ten enough for the break? Fifteen balls stand in a triangle, a millimetre apart; e = 0.95. By
# symmetry the cue ball can never leave the middle line. With ten rounds it does: every later hit
# multiplies the small fault of the first.

# %%
rack = disc_scenes.rack_break(restitution=0.95)
breaks = {n: simulate(rack, 4.0, dt=1 / 240, iterations=n) for n in (10, 30)}
cue = disc_scenes.CUSHIONS  # the first ball after the cushions
strayed = {n: np.abs(run.positions[:, cue, 1]).max() for n, run in breaks.items()}
check_bound("10 rounds: more than a millimetre off the line, m", strayed[10], at_least=1e-3)
check("30 rounds: off the line by", strayed[30], 0, tolerance=1e-9)

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
# Here is Newton's cradle without its strings: one disc runs at 1 m/s into a row of four at rest.
# Neighbours have a gap of a thousandth of a millimetre, or they overlap by as much.

# %%
predict("04-row")

# %% tags=["answer"]
# five discs, with a gap and with an overlap
cradle = {
    name: simulate(disc_scenes.row_of_discs(5, gap), 1.0, iterations=100)
    for name, gap in (("gap of 1 µm", 1e-6), ("overlap of 1 µm", -1e-6))
}
last = {name: run.velocities[-1, :, 0] for name, run in cradle.items()}
check("one after the other", last["gap of 1 µm"], closed.cradle_one_by_one(5, 1), 1e-9)
check("all at once", last["overlap of 1 µm"], closed.cradle_all_at_once(5, 1), 1e-9)
for name, run in cradle.items():
    laws = run.momentum[-1, 0], run.kinetic_energy[-1]
    check(f"{name}: momentum, energy", laws, (1, 0.5), tolerance=1e-9)
figures.row_of_five(last)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# With a gap the pairs collide one after the other, each by chapter 01. With an overlap the step
# solves all four contacts *together*: the first pair must part as fast as it approached, and no
# pair may come closer. Both answers keep momentum and energy: for more than two bodies these laws
# alone do not decide. Steel balls on strings come close to the first answer, because a shock takes
# time to run through them.

# %% [markdown]
# ## 9 Break it on purpose: two discs in one place
#
# In a game that lets the player add discs with the mouse, this happens sooner or later.

# %%
predict("04-heap")

# %% tags=["answer"]
# two discs in one place, 1 kg and 3 kg
heap = Scene([Body(Circle(0.5), mass=1.0), Body(Circle(0.5), mass=3.0)])
for solver in ("naive", "sequential"):
    apart = np.diff(simulate(heap, 2.0, solver=solver).positions[:, :, 0])[:, 0]
    print(f"{solver:10} apart after 0, 0.1, 0.5, 2 s:", apart[[0, 6, 30, 120]].round(3), "m")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The first attempt divides by the distance, so it has to skip this pair: the discs stay stuck.
# With (1, 0) as the normal they part, the light one three times as far. They part gently:
# each step removes a fifth of the overlap, and the last half percent of a body's width stays, so
# that resting contacts stay contacts.

# %% [markdown]
# ## 10 Quiz

# %%
show_quiz("04")

# %% [markdown]
# ## 11 Key takeaways
#
# - d · d < (r1 + r2)² rejects a far pair without a root.
# - The impulse acts along the normal. x and y separately is wrong, and only angular momentum
#   notices.
# - Both discs get the same |J|, and each divides by its own mass: the lighter one changes more, in
#   velocity and in position.
# - The gate is for velocities. Separate positions first, gate or no gate.
# - Where contacts share a ball, visit them again and again.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** contact, impulse and separation by hand; 3,000 random pairs in two engines
# against the formula, to 1e-13 of the larger speed; the laws of a full table; a hit of three balls
# by algebra.
#
# **Limits.** The discs are smooth, so they never begin to spin. A very fast disc can jump over
# another between two steps; chapter 07 is about that.
#
# **Do now:** the exercise [04 Circles](../exercises/04_circles.ipynb): four tasks, seventeen
# points. In a terminal, `workbook watch 04` runs it again whenever you save. Try out what you know
# in `workbook play simulator`; the challenge of this chapter is the field of
# [asteroids](../exercises/asteroids.py). **Next:** [05 Spin and
# friction](05_spin_and_friction.ipynb), where the discs get a grip on each other.
#
# **Sources.** Mirtich and Canny, *Impulse-based Simulation of Rigid Bodies* (1995): one impact.
# Catto, *Fast and Simple Physics using Sequential Impulses* (2006): many. Herrmann and Seitz,
# *How does the ball-chain work?*, American Journal of Physics 50 (1982), 977: real rows.
