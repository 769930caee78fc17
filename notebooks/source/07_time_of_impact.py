# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 07 Time of impact
#
# So far your engine looks at the world sixty times a second and corrects what overlaps. Between two
# looks it is blind: a fast ball can be in front of a wall at one look and behind it at the next.
# Here you ask for the *time* at which two bodies meet. Then nothing is missed at any speed, and in
# the end the time step disappears altogether.
#
# **After this notebook you will be able to**
#
# 1. say how fast a ball must be to pass through a wall between two steps, and how often it does;
# 2. compute when two bodies meet, without losing digits and without looking at samples, and use
#    the rest of the step after the impact;
# 3. simulate from collision to collision without any time step, and say which scenes allow it.
#
# **You need** notebooks 00 to 06. **Time:** about 70 minutes to read and to write two lines,
# fifteen seconds to run. Sections 8 to 14 can be read on another day.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, Polygon, Segment, simulate
from lesson_code.chapters.ch07_time_of_impact import figures, right_answers, scenes
from lesson_code.chapters.ch07_time_of_impact import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.evidence.scenes import events, rigid_bodies
from lesson_code.evidence.scenes import gas as gas_scenes
from lesson_code.formulas.smooth_pair import smooth_impulse

# %% tags=["plumbing"]
from lesson_code.geometry import collide, time_of_impact
from lesson_code.geometry.impact_times import line_impact_time
from lesson_code.reference import closed_forms, event_closed_forms
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 A step can jump over a wall
#
# A ball with the speed v advances by v dt in a step. If that is long enough, a step begins before
# the wall and ends behind it, and no overlap is ever seen. This is called **tunnelling**.
#
# To be stopped, the ball has to be *seen in time*: at the end of a step it must overlap the wall,
# and its centre must still be before the wall's middle. (Behind the middle the shortest way out
# leads on, and the ball is let go.) These places fill the last r + th/2 of its way, where th is the
# thickness of the wall. Whether a step ends there is chance. Which part of the balls gets through?
# Write it; for slow balls it is 0.


# %%
@gap("07-passing")
def share_passing(v, dt, r, th):
    return ...


# %%
predict("07-first-speed")

# %% tags=["answer"]
# the figure
live(
    "ch07_time_of_impact/steps_at_a_wall",
    "A ball at the ends of its steps, half a metre apart. The last one before a thin wall does "
    "not touch it yet, the next one is beyond its middle, and the ball flies on. A dashed outline "
    "shows the ball at its first touch. A strip, one step long, shows from which places it is "
    "stopped: the first three tenths. The ball can be dragged along it; speed, wall and steps can "
    "be changed.",
)

# %% [markdown]
# Let pymunk try it with 200 balls at each speed. Each ball starts a little further back than the
# one before, so that their steps end at all possible places.

# %%
speeds = np.array([6, 9, 10, 12, 15, 18, 25, 40, 60, 100])
passed = []
for speed in speeds.tolist():
    scene = events.balls_at_wall(speed, count=200, dt=1 / 60)
    run = simulate(scene, 1 / speed + 0.1, solver="pymunk", sample="end")
    passed.append(events.share_beyond(run))
law = [share_passing(speed, 1 / 60, 0.1, 0.1) for speed in speeds.tolist()]
check("pymunk: fraction that gets through", passed, law, tolerance=1 / 200)

# %% tags=["plumbing"]
fine = np.linspace(6, 100, 400)
curve = [share_passing(speed, 1 / 60, 0.1, 0.1) for speed in fine.tolist()]
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, {"1 - (r + th/2) / (v dt)": (fine, curve)}, "speed, m/s", "fraction")
ax.plot(speeds, passed, "o", color=style.VERMILION, label="pymunk, 200 balls each")
ax.legend(frameon=False)
show(
    fig,
    "Fraction of the balls that get through the wall, over their speed. It is zero up to 9 m/s, "
    "a half at 18 m/s and above nine tenths at 100 m/s. pymunk's dots lie on the curve of the law.",
)

# %% [markdown]
# This is no fault of pymunk: any engine that looks only at the ends of steps does the same. With
# half the step a ball may be twice as fast, and every second of the scene costs twice the time.
#
# ## 2 Looking more often is no cure
#
# Why not simply look more often? Let a program look ten times within each step.

# %%
predict("07-ten-looks")

# %% tags=["answer", "plumbing"]
# a graze, and eleven looks
d, v, reach, dt = np.array([-2.25, 0.985]), np.array([5.0, 0.0]), 1.0, 1.0
fig, axes = style.figure(2, width=10, height=3.2)
figures.seen_from_the_first(axes[0], d, v, reach, dt, samples=10)
figures.distance_in_time(axes[1], d, v, reach, dt, samples=10)
show(
    fig,
    "On the left the way of circle 2 as circle 1 sees it: a straight line that cuts the edge of a "
    "disc of radius r1 + r2 between two of eleven dots. On the right the distance of the centres "
    "over time: it dips below r1 + r2 between the dots at 0.4 s and 0.5 s.",
)

# %% [markdown]
# How many hits are lost follows from the chords of a circle: if s is the way between two looks and
# $k = s/(2(r_1 + r_2))$, then for small k the fraction is $k^2/6$. Draw 4,000 pairs that hit within
# the step, at four speeds:

# %%
rng = np.random.default_rng(seed=7)
for speed in (5.0, 10.0, 20.0, 60.0):
    lost = 0
    for aside, start in zip(rng.uniform(-1, 1, 4000), rng.uniform(0.2, 0.7, 4000), strict=True):
        p2 = np.array([-1 - start * speed, aside])
        pair = (np.zeros(2), np.zeros(2), 0.4, p2, np.array([speed, 0.0]), 0.6)
        lost += wrong.ten_samples(*pair, 1.0) is None
    law = event_closed_forms.missed_by_samples(speed / 10, reach=1.0)
    check(f"{speed:2.0f} m a step: fraction lost", lost / 4000, law, tolerance=0.02)

# %% [markdown]
# ## 3 The time of impact is a root
#
# Let d be the way from centre 1 to centre 2 now, and v the velocity of 2 seen from 1. At the time
# t the centres are d + v t apart. The circles touch when that is $R = r_1 + r_2$ long:
#
# $$(d + v\,t)\cdot(d + v\,t) = R^2 \quad\Longrightarrow\quad a\,t^2 + 2\,b\,t + c = 0$$
#
# $$a = v\cdot v \qquad b = d\cdot v \qquad c = d\cdot d - R^2$$
#
# Each letter has a meaning: b < 0 says that they approach, c > 0 that they are apart. Of the two
# roots the **smaller** is the first touch:
#
# $$t = \frac{-b - \sqrt{b^2 - a c}}{a} = \frac{c}{-b + \sqrt{b^2 - a c}}$$
#
# The second form is the same number, and section 4 shows why you should prefer it. If $b^2 < a c$
# there is no root, and the circles pass each other. Write the second form:


# %%
@gap("07-first-touch")
def first_touch(a, b, c):
    return ...


# %% [markdown]
# An example to work by hand: R = 5 m, 3 m of them across.

# %%
d, v = np.array([14.0, 3.0]), np.array([-5.0, 0.0])
check("yours: (14 - 4) / 5", first_touch(v @ v, d @ v, d @ d - 5**2), 2.0, tolerance=1e-15)

# %%
one, place_1, velocity_1 = Circle(2.0), (0, 0, 0), (3, 0, 0)  # the third numbers: angle, spin
two, place_2, velocity_2 = Circle(3.0), (14, 3, 0), (-2, 0, 0)
t = time_of_impact(one, place_1, velocity_1, two, place_2, velocity_2, duration=10)
check("(14 - 4) / (3 + 2)", t, 2.0, tolerance=1e-15)
t = time_of_impact(one, place_1, velocity_1, two, place_2, velocity_2, duration=1.9)
check("not within 1.9 s", t, None)

# %% [markdown]
# From this you can build the other cases. A circle meets a **wall** when its distance falls to r:
# that is linear in t, or with gravity a quadratic again. It meets a **polygon** at an edge or at a
# vertex: an edge is a wall with ends, and a vertex is a circle without radius. The earliest of all
# is the impact. For turning polygons there is no such formula. There `time_of_impact` takes steps
# that are proven to be safe, until the gap is closed to within a stated tolerance.

# %%
ball, still = Circle(0.5), (0.0, 0.0, 0.0)
crate = Polygon.box(2, 2)
onto_face = time_of_impact(crate, still, still, ball, (0.3, 5, 0), (0, -1, 0), 10)
onto_corner = time_of_impact(crate, still, still, ball, (1.3, 5, 0), (0, -1, 0), 10)
check("onto the top: 5 - 1 - 0.5", onto_face, 3.5, tolerance=1e-12)
check("onto the corner, 0.3 m beside it: 5 - 1 - 0.4", onto_corner, 3.6, tolerance=1e-12)
fast = time_of_impact(crate, still, still, ball, (0, 5, 0), (0, -1e6, 0), 10)
check("onto the top at 1,000,000 m/s", fast, 3.5e-6, tolerance=1e-18)
rod = Segment((-2, 0), (2, 0))
turning = time_of_impact(rod, still, (0, 0, 1.5), ball, (0, 1.2, 0), still, 10)
foot = np.arcsin(0.5 / 1.2)  # of the angle that the rod still has to go when it touches
check("a rod that turns at 1.5 rad/s", turning, (np.pi / 2 - foot) / 1.5, tolerance=1e-6)

# %% [markdown]
# Drag the disc and the tip of its velocity. The filled disc shows the first touch, the dashed one
# what a program sees that looks at one time only. Let the box turn at 2 rad/s, but say first: does
# the disc reach it earlier or later? And how fast must the disc be so that a look after 1 s
# finds it behind the box?

# %%
live(
    "ch07_time_of_impact/two_bodies",
    "A disc flies at 2 m/s to the right and a little down, and first touches the upper left "
    "corner of a box after 1.794 s. A program that looks after 2.6 s finds it deep inside. You "
    "can drag the disc and its velocity, let the box turn, and change the time of the look.",
)

# %% [markdown]
# ## 4 The formula from school loses digits
#
# Why two forms of the same root? A ball is 1 m above the floor and moves down at 1 m/s, with a
# weak gravity g: on board a spaceship, say. It lands after about one second. From school:
#
# $$t = \frac{v + \sqrt{v^2 + 2 g h}}{g} \qquad v = -1\ \text{m/s}$$

# %%
predict("07-school")

# %% tags=["answer"]
# both formulas for ever weaker gravity
for g in (1e-3, 1e-7, 1e-11, 1e-15):
    school, right = (
        wrong.school_formula(1.0, -1.0, g),
        right_answers.with_fifty_digits(1.0, -1.0, g),
    )
    print(f"g = {g:.0e} m/s²: school {school:.12f} s, with fifty digits {right:.12f} s")

# %% [markdown]
# A float has 16 digits, so 2 g h is written with one or two of them beside the 1. Multiplied above
# and below by $\sqrt{\cdot} - v$, the formula has no subtraction any more:
#
# $$t = \frac{2h}{\sqrt{v^2 + 2gh} - v}$$
#
# It even works for g = 0. Of the two forms one adds and the other subtracts. Which is which
# depends on the sign of v; a good program asks.

# %%
gravity = 10.0 ** -np.arange(0, 15.25, 0.25)
right = np.array([float(right_answers.with_fifty_digits(1.0, -0.7, g)) for g in gravity.tolist()])
school = np.array([wrong.school_formula(1.0, -0.7, g) for g in gravity.tolist()])
sure = np.array([line_impact_time(1.0, -0.7, -g) for g in gravity.tolist()])
check("without a subtraction: off by, parts", sure / right - 1, 0, tolerance=4e-16)
losses = {
    "school": (gravity, abs(school / right - 1) + 1e-17),  # a zero cannot be drawn here
    "without a subtraction": (gravity, abs(sure / right - 1) + 1e-17),
}

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3.2)
plots.curves(ax, losses, "gravity, m/s²", "error, as a part of the time")
ax.set(xscale="log", yscale="log", ylim=(1e-17, 10))
show(
    fig,
    "Error of both forms over gravity, both axes logarithmic. The one from school grows from "
    "1e-16 at 1 m/s² to a hundredth at 1e-15 m/s². The other stays below 4e-16 everywhere.",
)

# %% [markdown]
# ## 5 Never, and now
#
# Four cases need a rule, the same one in the whole program:
#
# - They pass each other, or part: **never**. That is `None`, and no number.
# - They touch or overlap, and approach: **now**. That is 0.0.
# - They touch or overlap, and part: never. They have had their collision.
# - Their velocities are equal: never. Here a = b = 0, and the formula would be 0/0.

# %%
unit, origin = Circle(1.0), (0, 0, 0)
cases = {
    "apart, and parting": ((3, 0, 0), (1, 0, 0), None),
    "apart, side by side": ((3, 0, 0), (0, 0, 0), None),
    "touching, and approaching": ((2, 0, 0), (-1, 0, 0), 0.0),
    "touching, and parting": ((2, 0, 0), (1, 0, 0), None),
    "overlapping, and approaching": ((1.5, 0, 0), (-1, 0, 0), 0.0),
    "overlapping, and parting": ((1.5, 0, 0), (1, 0, 0), None),
}
for name, (place, velocity, expected) in cases.items():
    check(name, time_of_impact(unit, origin, still, unit, place, velocity, 9), expected)

# %% [markdown]
# In Python, 0.0 counts as false. If you write `if t:` for "if they meet", you lose just the hits
# that are due *now*. Write `if t is not None:`.

# %%
place, velocity, _ = cases["touching, and approaching"]
t = time_of_impact(unit, origin, still, unit, place, velocity, duration=9)
print("if t:", "a hit" if t else "no hit")
print("if t is not None:", "a hit" if t is not None else "no hit")

# %% [markdown]
# ## 6 At the time of impact nothing overlaps
#
# Move two circles to their exact time of impact, and call a function of chapter 04, which starts
# with the contact: no overlap, no contact, nothing to do. But touching is *not* overlapping.

# %%
predict("07-silent")


# %% tags=["answer"]
# 1,000 pairs at their time of impact
starts = [6 * np.array([x, y]) / np.hypot(x, y) for x, y in rng.normal(size=(1000, 2))]
pairs = [(p2, -p2 + rng.uniform(-1, 1, 2)) for p2 in starts]
places = [scenes.at_impact(p2, v2, unit, ball) for p2, v2 in pairs]
contacts = [collide(unit, origin, ball, (*p2, 0)) for p2 in places]
ignored = sum(contact is None for contact in contacts)
check("more than a quarter of them are ignored", bool(ignored > 250), True)
deepest = max(c.penetrations[0] for c in contacts if c is not None)
check("the others overlap by rounding only, m", deepest, 0, tolerance=1e-14)

# %% [markdown]
# Only rounding decides, in the last digit, whether there is an overlap. So an event must resolve
# the contact **explicitly**: the time of impact has told you that there is one, and the normal
# leads from centre to centre. You still ask the gate, as always.

# %%
turned_round = []
for p2, (_, v2) in zip(places, pairs, strict=True):
    n = p2 / np.hypot(*p2)
    impulse = smooth_impulse((0, 0), np.inf, v2, 1.0, n, restitution=0.5)
    turned_round.append((v2 + impulse) @ n / -(v2 @ n))
check("separation over approach, 1,000 times", turned_round, 0.5, tolerance=1e-12)

# %% [markdown]
# ## 7 The rest of the step
#
# You have found a collision at the time t, but the step is not over. Move **to** the impact,
# bounce, and **go on** for the rest of the step, dt - t. The rest may hold another impact. So write
# a loop, which ends when no more impact comes in the time that is left.
#
# Some programs stop at the impact and lose the rest. Here are both, for a ball in a room with
# e = 1, in 600 steps of 1/60 s. Its place after any time is known: section 10 says why.

# %%
start, velocity = np.array(events.BALL_START), np.array(events.BALL_VELOCITY)
radius, box = events.BALL_RADIUS, np.array(events.BOX)
rules = {"to the end of the step": right_answers.each_axis_for_itself}
rules["stops at the impact"] = wrong.stops_at_the_impact
ways = {}
for name, rule in rules.items():
    p, v, ways[name] = start - radius, velocity, [start]
    for _ in range(600):
        p, v = rule(np.array(p), np.array(v), box - 2 * radius, 1.0, 1 / 60)
        ways[name].append(np.array(p) + radius)
    print(f"{name}: speed {np.hypot(*v):.12f} m/s")

# %% tags=["plumbing"]
times = np.arange(601) / 60
exact = [closed_forms.ball_in_box(start, velocity, radius, *box, time=t)[0] for t in times]
errors = {name: (times, np.hypot(*np.subtract(way, exact).T)) for name, way in ways.items()}
check("to the end of the step: error, m", errors["to the end of the step"][1], 0, tolerance=1e-12)
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, errors, "time, s", "distance from the right place, m")
show(
    fig,
    "How far the ball is from where it should be, over 10 s. With the rest of the step: zero. "
    "When the rest is lost: the error grows at every impact, and does not go away.",
)

# %% [markdown]
# Both have the right speed to the last digit, so energy cannot tell you that time was lost.
#
# With the rest of the step it does not matter how long the step is. One step of ten seconds does
# it as well as 600:

# %%
p, _ = right_answers.each_axis_for_itself(start - radius, velocity, box - 2 * radius, 1.0, 10.0)
check("one step of 10 s, ten impacts in it: error, m", np.array(p) + radius, exact[-1], 1e-12)

# %% [markdown]
# **In the engine.** `simulate` splits a step only where it must. A body that moves by less than
# half of its width in a step is seen in time anyway. If one is faster, the engine looks for the
# first time of impact of the fast ones, ends the step there, resolves it like any other contact,
# and goes on with the rest. A slow scene pays only for a look at the speeds. This works for turning
# bodies too: below, a thin rod sweeps over a ball at rest, from 40 starting angles.

# %%
for speed in (18.0, 1e3, 1e6):
    scene = events.balls_at_wall(speed, count=50, dt=1 / 60, thickness=0.001)
    run = simulate(scene, 1 / speed + 0.1, sample="end", solver="sequential")
    check(f"{speed:11,.0f} m/s: through a wall of 1 mm", events.share_beyond(run), 0)


# %%
for turning in (5.0, 20.0, 40.0):
    law = share_passing(turning * events.ROD_ARM, 1 / 60, 0.1, 0.1)
    theirs = scenes.share_passed_over(turning, "pymunk")
    check(f"{turning:2.0f} rad/s: pymunk's rod passes over", theirs, law, tolerance=1 / 40)
    check("   ours", scenes.share_passed_over(turning, "sequential"), 0)

# %% [markdown]
# ## 8 From event to event
#
# If one step can be ten seconds long, why have steps at all? Between two collisions every disc
# moves in a way that you can write down: a straight line, or with gravity a parabola. So there is
# nothing to compute until the next collision. An **event-driven** simulation goes from one to the
# next:
#
# 1. For every disc, predict its next event: the earliest of all its times of impact.
# 2. Take the earliest event of all. (A *heap* has it on top.)
# 3. Move the discs that take part to that time, and let them bounce.
# 4. Their other predictions no longer hold, so make new ones. All other discs fly on as predicted.
#
# `solver="exact"` does this. `sample` says at which times you want to see the state; with `None`
# they are the events themselves.

# %%
scene = scenes.three_balls_and_a_post()
run = simulate(scene, 2.0, solver="exact")
print(run.plan)
for t, a, b in zip(run.contacts.time, run.contacts.body_a, run.contacts.body_b, strict=True):
    print(f"{t:.6f} s: body {a} and body {b}")

# %%
run = simulate(scene, 6.0, solver="exact", sample=np.linspace(0, 6, 181))
check("energy kept, J", run.kinetic_energy - run.kinetic_energy[0], 0, tolerance=1e-12)
check("deepest overlap in any state, m", run.max_penetration, 0, tolerance=1e-12)
animate(
    run,
    "Three balls in a box with a round post in the middle. They bounce off the walls, off the post "
    "and off each other.",
    still=1.0,
)

# %% [markdown]
# No step, so no tunnelling either, at any speed. And no overlap, so nothing to push apart.

# %%
for speed in (1.0, 1e3, 1e6):
    scene = events.balls_at_wall(speed, count=10, dt=1 / 60, thickness=0.001)
    run = simulate(scene, 2 / speed + 1 / 60, solver="exact", sample="end")
    check(f"{speed:9,.0f} m/s: balls through a wall of 1 mm", events.share_beyond(run), 0)

# %% [markdown]
# ## 9 Pi, from collisions
#
# Two blocks slide on ice before a wall. The inner one, of 1 kg, is at rest; the outer one, of M kg,
# comes. All is elastic. The inner block bounces to and fro between the wall and the outer block,
# until the outer block has turned round and is the faster one.

# %%
predict("07-pi")

# %% tags=["answer"]
# the collisions, counted
for digits in range(5):
    run = simulate(events.two_blocks(100.0**digits), 1e5, solver="exact", sample="end")
    predicted = event_closed_forms.block_collisions(100.0**digits)
    check(f"M = 100^{digits}: collisions", len(run.contacts), predicted)
    energy = run.kinetic_energy[-1] / run.kinetic_energy[0]
    check("   energy left", energy, 1, tolerance=1e-10)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# These are the digits of pi. Galperin's reason is a picture. Take $\sqrt{m_1}\,x_1$ and
# $\sqrt{m_2}\,x_2$ as the coordinates of *one* point. The two sides of a wedge with the angle
# $\theta$, where $\tan\theta = 1/\sqrt{M}$, are "the inner block is at the wall" and "the blocks
# touch". A collision is a reflection there. Unfold the wedge, as one unfolds a mirror: the way
# becomes a straight line, and it crosses a side at each multiple of $\theta$ below $\pi$.

# %% tags=["plumbing"]
fig, ax = style.figure(width=8, height=3.6)
figures.unfolded_wedge(ax, mass_ratio=9)
show(
    fig,
    "Rays from one point, at equal angles, full and dotted in turn. A straight line from right to "
    "left crosses nine of them: the nine collisions for a mass ratio of 9.",
)

# %% [markdown]
# For M = $100^k$ the angle is nearly $10^{-k}$, and $\pi/10^{-k}$ has the digits of pi. A stepped
# engine has a hard time here: the inner block gets faster and faster, in a narrower and narrower
# gap. For M = $100^3$ it moves at a thousand times the speed of the outer one, in a gap of a
# millimetre.

# %%
million = events.two_blocks(100.0**3)
for rate in (60, 2400):
    run = simulate(million, 10.0, dt=1 / rate, solver="pymunk", sample="end")
    side = "behind" if run.positions[-1, 1, 0] < 0 else "before"
    print(f"pymunk, {rate:4} steps a second: {len(run.contacts)} of 3141, ends {side} the wall")

# %% tags=["plumbing"]
run = simulate(events.two_blocks(100.0), 5.0, solver="exact")
edges = run.positions[:, :, 0] - np.array([0, 0.5, 1.5])  # blocks drawn without their width
fig, ax = style.figure(width=7, height=3)
named = {"inner block": (run.times, edges[:, 1]), "outer block, 100 kg": (run.times, edges[:, 2])}
plots.curves(ax, named, "time, s", "distance from the wall, m")
show(
    fig,
    "Distance from the wall over time. The outer block comes, slows down, turns round at a tenth "
    "of a metre and leaves. The inner one zigzags between it and the wall, fastest in the middle.",
)

# %% [markdown]
# ## 10 A ball in a box, for ever
#
# A bounce off a wall is a mirror image. Instead of the ball, mirror the *box*: then the ball flies
# straight on, through a wallpaper of mirrored boxes. Where it is after any time is a
# multiplication and a fold. So there is an answer to compare with, after any number of bounces;
# it is worked out in fractions, without rounding.

# %% tags=["plumbing"]
fig, ax = style.figure(width=9, height=4.4)
room = box - 2 * radius  # what the ball's centre can reach
figures.unfolded_box(ax, start - radius, velocity, room, time=6.0)
show(
    fig,
    "A box with the zigzag way of a ball, and the same way unfolded: a straight line through the "
    "mirror images of the box, which lie beside it and above it.",
)

# %%
scene = events.ball_in_a_box()
for duration in (10, 100, 1000):
    run = simulate(scene, duration, solver="exact", sample=np.linspace(0, duration, 101))
    off = events.error_in_the_box(run)
    check(f"exact, {duration} s, {len(run.contacts)} bounces: error, m", off, 0, 1e-13 * duration)

# %%
rates, errors = np.array([30, 60, 120, 240, 480, 960, 1920]), []
for rate in rates.tolist():
    run = simulate(scene, 10, dt=1 / rate, solver="pymunk", sample=np.linspace(0, 10, 101))
    errors.append(events.error_in_the_box(run).max())
    print(f"pymunk, {rate:4} steps a second: off by up to {errors[-1]:.3f} m in 10 s")

# %% [markdown]
# Each impact comes late by a part of a step, and the ball never makes up for it. If you halve the
# step, you roughly halve the error: ten times the accuracy costs ten times the work. The exact
# solver computes ten collisions, and only rounding is left of its error.
#
# ## 11 Backwards in time
#
# Newton's laws do not know which way time runs. Turn every velocity round, and a film of balls
# runs backwards, to the very state in which it began. This is a hard test for a simulation: let 64
# discs in a box run for a while, turn them round, and let them run for the same time again.

# %%
predict("07-back")

# %% tags=["answer"]
# there and back again
gas, returns = gas_scenes.disc_gas(8, covered=0.5, seed=1), []
for duration in np.arange(0.5, 7.0, 0.5):
    run = simulate(gas, duration, solver="exact", sample="end")
    back = simulate(events.turned_back(run), duration, solver="exact", sample="end")
    returns.append((gas_scenes.hits_a_disc(run), events.error_after_return(run, back)))
hits, off = np.transpose(returns)
check("up to 9 collisions a disc: back within, m", off[hits <= 9], 0, tolerance=1e-9)
check("beyond 42 it is lost: over a millimetre off", bool(off[hits > 42].min() > 1e-3), True)

# %% tags=["answer", "plumbing"]
# there and back again
fig, ax = style.figure(width=7, height=3.2)
plots.curves(ax, {"": (hits, off)}, "collisions of each disc with others", "farthest from start, m")
ax.set_yscale("log")
show(
    fig,
    "How far the farthest disc is from its start after the way back, over the number of "
    "collisions, on a logarithmic scale. From 1e-14 m it grows along a nearly straight line to "
    "some decimetres.",
)

# %% [markdown]
# So the discs of the following film do find their places again: on the way out, each meets fewer
# than nine others.

# %%
seen = np.linspace(0, 1, 51)
out = simulate(gas, 1.0, solver="exact", sample=seen)
back = simulate(events.turned_back(out), 1.0, solver="exact", sample=seen)
print(f"{gas_scenes.hits_a_disc(out):.1f} collisions a disc")
animate(
    {"out": out, "back": back},
    "Two boxes with 64 discs. On the left they start in rows and columns and fly into disorder. On "
    "the right they start in that disorder, and end in rows and columns.",
    seconds=4,
    still=0.9,
)

# %% [markdown]
# A straight line on this scale is exponential growth. Discs are convex: two ways that differ a
# little before a hit differ more after it, here by a factor of about two for each hit. That is
# **chaos**. It is in the laws and not in the solver: with twice as many digits the line would
# start lower and be just as steep. So do not compare long runs of many discs place by place.
# Compare what is not chaotic: energy, momentum, pressure.
#
# ## 12 Infinitely many bounces in four seconds
#
# A ball is dropped from 1 m, with e = 0.8. Chapter 02 has shown that each flight is 0.8 times as
# long as the one before. The flights add up to a finite time, and in it there are infinitely many
# bounces:
#
# $$T = \sqrt{\frac{2h}{g}}\;\frac{1 + e}{1 - e}$$
#
# A simulation that goes from event to event would never get there. It needs a **rule**: a ball
# that leaves the floor slower than $10^{-13}$ of the scene's speed rests. What it leaves out would
# have lasted less than $10^{-12}$ s.

# %%
times = np.linspace(0, 6, 601)
run = simulate(events.bouncing_to_rest(0.8), 6.0, solver="exact", sample=times)
rest = closed_forms.rest_time(height=1, restitution=0.8, gravity=10)
heights = closed_forms.bouncing_ball(times, height=1, restitution=0.8, gravity=10)
check("the last bounce, s", run.contacts.time[-1], rest, tolerance=1e-12)
check("its height at 601 times, m", run.positions[:, 1, 1] - 0.5, heights, tolerance=1e-12)
check("at rest from then on", run.velocities[times > rest, 1], 0)
print(len(run.contacts), "bounces were computed")

# %% tags=["plumbing"]
stepped = simulate(events.bouncing_to_rest(0.8), 6.0, solver="pymunk")
fig, ax = style.figure(width=7, height=3)
named = {"exact": (times, run.positions[:, 1, 1] - 0.5)}
named["pymunk, 60 steps a second"] = (stepped.times, stepped.positions[:, 1, 1] - 0.5)
plots.curves(ax, named, "time, s", "height above the floor, m")
ax.axvline(rest, color=style.GREY, linewidth=1, linestyle="-.")
show(
    fig,
    "Height of the ball over time. It bounces lower and faster, and lies still from 4.02 s on, "
    "which a vertical line marks. pymunk's ball dips a little into the floor at each bounce, and "
    "its later bounces are out of step.",
)

# %% [markdown]
# ## 13 A gas
#
# Many discs that only collide are a gas. What a gas does on average is not chaotic. Theory gives
# you two numbers to compare with. **Pressure:** points would press with p A = N T, where T is the
# mean energy of a disc. Discs need room, and press more, by the factor Z. If they cover the part
# $\eta$ of the area, Henderson's formula says
#
# $$Z = \frac{p A}{N T} = \frac{1 + \eta^2/8}{(1 - \eta)^2}$$
#
# **Collisions:** Enskog's theory says how often a disc meets another one. Measure both in the
# middle of a box with 144 discs: near the walls a gas is denser. You count a few thousand
# collisions, so chance leaves an error of a few per cent. To halve it you need four times as many.

# %%
measured = []
for covered, duration in ((0.05, 150.0), (0.12, 100.0), (0.2, 80.0), (0.3, 60.0)):
    gas = gas_scenes.disc_gas(12, covered, seed=1)
    run = simulate(gas, duration, solver="exact", sample=np.arange(0, duration, 0.25))
    measured.append(scenes.in_the_middle(run, since=4.0))
eta = [m.covered for m in measured]
z = np.array([m.compressibility for m in measured])
rate = np.array([m.collision_rate for m in measured])

# %%
henderson = [event_closed_forms.hard_disc_compressibility(e) for e in eta]
enskog = [event_closed_forms.hard_disc_collision_rate(e, 1, 1, 1) for e in eta]
check("Z within 4 % of Henderson's", bool((abs(z / henderson - 1) < 0.04).all()), True)
check("rate within 8 % of Enskog's", bool((abs(rate / enskog - 1) < 0.08).all()), True)

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
# for every collision. The table is for the ball in the box. The times were measured on one machine,
# in one moment; yours will differ. pymunk is written in C, and our solver in Python.

# %% tags=["nbval-ignore-output"]
scene = events.ball_in_a_box()
costs = [scenes.milliseconds(scene, 10, solver="pymunk", dt=1 / rate) for rate in rates.tolist()]
run = simulate(scene, 10, solver="exact", sample=np.linspace(0, 10, 101))
cost, error = scenes.milliseconds(scene, 10, solver="exact"), events.error_in_the_box(run).max()
for rate, ms, off in zip(rates, costs, errors, strict=True):
    print(f"pymunk, {rate:4} steps a second: {ms:6.2f} ms, error {off:.0e} m")
print(f"exact, no steps, 10 collisions: {cost:6.2f} ms, error {error:.0e} m")

# %% tags=["nbval-ignore-output", "plumbing"]
fig, ax = style.figure(width=7, height=3.2)
plots.curves(ax, {"pymunk, 30 to 1920 steps a second": (costs, errors)}, "time, ms", "")
ax.lines[0].set_marker("o")
ax.plot(cost, error, "D", color=style.VERMILION, label="exact")
ax.set(xscale="log", yscale="log", ylabel="error after 10 s, m")
ax.legend(frameon=False)
show(
    fig,
    "Error against computing time for the ball in the box, both axes logarithmic. pymunk's dots "
    "go from half a metre down to a centimetre as its steps get shorter and its time longer. The "
    "exact solver stands alone near 1e-14 m, at about the time of pymunk's longest steps.",
)

# %% [markdown]
# What if there are many discs? A collision spoils the predictions of two discs only. And to predict
# the next event of a disc, the solver looks only at its neighbourhood: it divides the box into
# **cells**, and crossing into the next cell is an event too. So among a thousand discs a collision
# has no more neighbours to look at than among sixty. Only the queue of all events still grows.

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
# ## 15 Break it on purpose: three faults
#
# **The other root.** The quadratic has two roots.

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

# %% [markdown]
# A program without a gate would pull them back together.
#
# **A time in the past.** Two circles that part have met before, if they flew like that for ever.
# The quadratic says when. `t <= dt` is true for it.

# %%
t = wrong.negative_time(p1, -v1, 2.0, p2, -v2, 3.0, 6.0)
print(f"they will meet in {t:.1f} s")
check("never", time_of_impact(one, place_1, (-3, 0, 0), two, place_2, (2, 0, 0), 6.0), None)

# %% [markdown]
# A program that goes "to the impact" then flies two circles *back* to where they were three seconds
# and more ago. An event-driven simulation gets stuck: the earliest event of all is in the past, and
# after it the same event comes again.
#
# **0/0.** Two circles fly side by side. a is 0 and b is 0. NumPy does not stop at 0/0; it gives
# nan.

# %%
predict("07-nan")

# %% tags=["answer"]
# the two lines
with np.errstate(invalid="ignore"):
    t = np.float64(0.0) / np.float64(0.0)
print("a hit, because t <= dt:", bool(t <= 6.0))
print("a hit, because not t > dt:", bool(not t > 6.0))
check("never", time_of_impact(one, place_1, still, two, place_2, still, 6.0), None)

# %% [markdown]
# Ask for b < 0 first, and you never divide 0 by 0: circles that do not approach do not meet.
#
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
# - Discs are chaotic. Compare what is not: energy, momentum, pressure, a law.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** the law of tunnelling against pymunk at ten speeds; the law of lost hits against
# 16,000 pairs; times of impact by hand and to fifty digits; the digits of pi up to 31,415; a ball
# in a box for 1,000 s and the last bounce of a ball against closed forms; a gas that runs
# backwards, and one against Henderson's and Enskog's formulas.
#
# **Limits.** The exact solver takes discs and fixed walls only. A gas of discs is chaotic: after
# some thirty collisions each, no simulation can say where a single disc is. And real bodies do not
# bounce at an instant: they are in touch for a thousandth of a second.
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
