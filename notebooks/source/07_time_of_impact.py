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
# Here you ask for the *time* at which two bodies meet. Then nothing is missed, at any speed.
#
# **After this notebook you will be able to**
#
# 1. say how fast a ball must be to pass through a wall between two steps, and how often it does;
# 2. compute when two bodies meet, without losing digits and without looking at samples;
# 3. use the rest of the step after an impact, so that no time is lost.
#
# **You need** notebooks 00 to 06. **Time:** about 35 minutes to read and to write two lines, a few
# seconds to run. The chapter goes on in [07b](07b_from_event_to_event.ipynb) and
# [07c](07c_the_gas.ipynb), on other days if you like.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, Polygon, Segment, simulate
from lesson_code.chapters.ch07_time_of_impact import figures, right_answers, scenes
from lesson_code.chapters.ch07_time_of_impact import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict
from lesson_code.evidence import check, check_bound
from lesson_code.evidence.scenes import events
from lesson_code.formulas.smooth_pair import smooth_impulse

# %% tags=["plumbing"]
from lesson_code.geometry import collide, time_of_impact
from lesson_code.geometry.impact_times import line_impact_time
from lesson_code.reference import closed_forms, event_closed_forms
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

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

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# From 9 m/s on: then a step is as long as r + th/2 = 0.15 m, and a ball may begin it just before
# the wall's first touch and end it beyond the middle. Let pymunk try it with 200 balls at each
# speed. Each ball starts a little further back than the one before, so that their steps end at all
# possible places.

# %% tags=["answer"]
# 200 balls at each speed
speeds = np.array([6, 9, 10, 12, 15, 18, 25, 40, 60, 100])
passed = []
for speed in speeds.tolist():
    scene = events.balls_at_wall(speed, count=200, dt=1 / 60)
    run = simulate(scene, 1 / speed + 0.1, solver="pymunk", sample="end")
    passed.append(events.share_beyond(run))
law = [share_passing(speed, 1 / 60, 0.1, 0.1) for speed in speeds.tolist()]
check("pymunk: fraction that gets through", passed, law, tolerance=1 / 200)

# %% tags=["answer", "plumbing"]
# 200 balls at each speed
fine = np.linspace(6, 100, 400)
curve = [share_passing(speed, 1 / 60, 0.1, 0.1) for speed in fine.tolist()]
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, {"1 - (r + th/2) / (v dt)": (fine, curve)}, "speed, m/s", "fraction that passes")
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
# ## 2 Why not look more often?
#
# Let a program look ten times within each step.

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
# $k = s/(2(r_1 + r_2))$, then for small k the fraction is $k^2/6$. For k > 1 even the longest chord
# is shorter than the way, and the fraction is $1 - \pi/(4k)$. Draw 4,000 pairs that hit within the
# step, at four speeds, and compare with the law for every k:

# %%
rng = np.random.default_rng(seed=7)
for speed in (5.0, 10.0, 20.0, 60.0):
    lost = 0
    for aside, start in zip(rng.uniform(-1, 1, 4000), rng.uniform(0.2, 0.7, 4000), strict=True):
        p2 = np.array([-1 - start * speed, aside])
        pair = (np.zeros(2), np.zeros(2), 0.4, p2, np.array([speed, 0.0]), 0.6)
        lost += wrong.ten_samples(*pair, 1.0) is None
    law = event_closed_forms.missed_by_samples(speed / 10, reach=1.0)
    scatter = np.sqrt(law * (1 - law) / 4000)  # chance moves a count of 4,000 by so much
    check(f"{speed:2.0f} m a step: fraction lost", lost / 4000, law, round(3 * scatter, 3))

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
# An example to work by hand: R is 5 m, and the centres are 14 m apart along the way and 3 m across.
# The circles touch when 4 m are left along the way, since 3² + 4² = 5².

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
to_upright = np.arcsin(0.5 / 1.2)  # the angle between the rod and the vertical at the touch
check("a rod that turns at 1.5 rad/s", turning, (np.pi / 2 - to_upright) / 1.5, tolerance=1e-6)

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
# ## 4 Two forms of one root
#
# Why should you prefer the second one? A ball is 1 m above the floor and moves down at 1 m/s, with
# a weak gravity g: on board a spaceship, say. It lands after about one second. From school:
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

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# A float has 16 digits. Where 2 g h is 2e-15, only one or two of them are left for it beside the
# 1 under the root, and taking the 1 away leaves just these.

# %% [markdown]
# Multiply the formula above and below by $\sqrt{v^2 + 2gh} - v$, and nothing is subtracted any
# more, since v is negative:
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
# So ask `if t is not None:`. You know from notebook 00 what `if t:` would lose: the hits that are
# due *now*.
#
# ## 6 At the time of impact nothing overlaps
#
# Move two circles to their exact time of impact, and call a function of chapter 04, which starts
# with the contact: no overlap, no contact, nothing to do. But touching is *not* overlapping.

# %%
predict("07-silent")


# %% tags=["answer"]
# 1,000 pairs at their time of impact, by your line
starts = [6 * np.array([x, y]) / np.hypot(x, y) for x, y in rng.normal(size=(1000, 2))]
pairs = [(p2, -p2 + rng.uniform(-1, 1, 2)) for p2 in starts]
times = [first_touch(v2 @ v2, p2 @ v2, p2 @ p2 - (1 + 0.5) ** 2) for p2, v2 in pairs]
places = [p2 + v2 * t for (p2, v2), t in zip(pairs, times, strict=True)]
contacts = [collide(unit, origin, ball, (*p2, 0)) for p2 in places]
ignored = sum(contact is None for contact in contacts)
check_bound("part of them that is ignored", ignored / 1000, at_least=0.25)
deepest = max(c.penetrations[0] for c in contacts if c is not None)
check("the others overlap by rounding only, m", deepest, 0, tolerance=1e-14)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Only rounding decides, in the last digit, whether there is an overlap.

# %% [markdown]
# So an event must resolve the contact **explicitly**: the time of impact has told you that there is
# one, and the normal leads from centre to centre. You still ask the gate, as always.

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
# e = 1, in 600 steps of 1/60 s. Its place after any time is known: section 10, in notebook 07b,
# says why.

# %%
start, velocity = np.array(events.BALL_START), np.array(events.BALL_VELOCITY)
radius, box = events.BALL_RADIUS, np.array(events.BOX)
# the walls are level or upright, so here x and y may be done apart
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
# You can now say when two bodies meet, and use the rest of the step: the first three tasks of the
# exercise [07 Time of impact](../exercises/07_time_of_impact.ipynb) ask for no more. One step of
# ten seconds was as good as 600. **Next:**
# [07b From event to event](07b_from_event_to_event.ipynb), which has no steps at all.
