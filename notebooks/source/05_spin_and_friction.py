# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 05 Spin and friction
#
# Throw a rubber ball at the floor with backspin, and it comes back to you. No smooth ball can do
# that. In this chapter your bodies spin and their surfaces rub, both in the same blow.
#
# **After this notebook you will be able to**
#
# 1. compute how fast two bodies slide at their contact, and how hard it is to move them there;
# 2. compute the friction impulse of an impact, with Coulomb's limit, and the spin that it makes;
# 3. say how fast a body that slides ends up rolling, on ice as on rubber.
#
# **You need** notebooks 00 to 04. **Time:** about 30 minutes to read and to write two lines, a few
# seconds to run. The chapter goes on in [05b](05b_friction_put_to_the_test.ipynb), on another day
# if you like.

# %% tags=["plumbing"]
import inspect

import numpy as np

from lesson_code.chapters.ch05_spin_and_friction import figures, scenes
from lesson_code.chapters.ch05_spin_and_friction import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict
from lesson_code.evidence import check
from lesson_code.evidence.scenes.spinning_discs import Disc, hit

# %% tags=["plumbing"]
from lesson_code.formulas import (
    contact_velocity,
    disc_inertia,
    effective_mass,
    friction_impulse,
    polygon_centroid,
    polygon_inertia,
)
from lesson_code.reference import impact_closed_forms, rigid_body_closed_forms
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, scene_plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 A point of a spinning body moves with the centre and around it
#
# A body turns with **angular velocity** w, in radians per second, positive counter-clockwise. Take
# a point of the body at r = (r_x, r_y) from the centre of mass. The spin carries it around the
# centre at the speed |w| |r|, at right angles to r: for w > 0 in the direction (-r_y, r_x). The
# centre itself moves with v. Add both:
#
# $$v_\text{contact} = v + w\,(-r_y,\ r_x)$$

# %%
predict("05-wheel")

# %% tags=["answer"]
# three points of a rolling wheel
v, w, radius = np.array([3.0, 0.0]), -6.0, 0.5
check("the lowest point stands still", contact_velocity(v, w, (0, -radius)), (0, 0))
check("the highest point is twice as fast", contact_velocity(v, w, (0, radius)), (6, 0))
check("the foremost point goes down as well", contact_velocity(v, w, (radius, 0)), (3, -3))

# %% tags=["answer", "plumbing"]
# three points of a rolling wheel
fig, axes = style.figure(3, width=9.5, height=3.2)
for ax, (v, w, title) in zip(
    axes,
    (((3, 0), 0, "it moves"), ((0, 0), -6, "it spins"), ((3, 0), -6, "it rolls: both together")),
    strict=True,
):
    figures.point_velocities(ax, v, w, radius=0.5, longest=5.0)
    ax.set_title(title, fontsize=11)
show(
    fig,
    "Three discs with the velocities of eight points of the rim. One moves: all arrows are equal. "
    "One spins clockwise: the arrows run round. One rolls: the sum of both; the lowest point "
    "has no arrow, the highest one twice the centre's.",
)

# %% [markdown]
# At a contact you need to know how the two touching points move against each other: the
# `contact_velocity` of body B minus that of body A. Its part along the normal n is v_n; a negative
# v_n is an approach. Its part along the tangent t is v_t, the **sliding**. In this course t is n
# turned counter-clockwise: (-n_y, n_x).
#
# ## 2 The moment of inertia says how hard a body is to turn
#
# An impulse J changes the velocity by J/m. If it acts at r from the centre, it also changes the
# spin, by its **lever arm**:
#
# $$\Delta v = \frac{J}{m}, \qquad \Delta w = \frac{r \times J}{I},
# \qquad r \times J = r_x J_y - r_y J_x$$
#
# I is the **moment of inertia**. Mass that is twice as far from the centre counts four times. A
# disc has m r²/2; a hoop, with all its mass at the rim, has m r². For a polygon, cut it into
# triangles from the centroid. Let p and q be the ends of an edge, seen from the centroid:
#
# $$I = \frac{m}{6}\;
# \frac{\sum (p \cdot p + p \cdot q + q \cdot q)\,(p \times q)}{\sum p \times q}$$
#
# Each $p \times q$ is twice the area of a triangle, with a sign. Go round the other way, and all
# signs change, above and below. So it does not matter which way round you go.

# %%
box = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (0.0, 2.0)])
check("a box of 3 m by 2 m and 6 kg: m (3² + 2²) / 12", polygon_inertia(6.0, box), 6.5, 1e-12)
check("the other way round", polygon_inertia(6.0, box[::-1]), 6.5, 1e-12)
check("moved away", polygon_inertia(6.0, np.add(box, (40, -70))), 6.5, 1e-9)
turns = 2 * np.pi * np.arange(1000) / 1000
wheel = 0.5 * np.stack((np.cos(turns), np.sin(turns)), axis=-1)
check("a polygon with 1,000 sides is nearly a disc", polygon_inertia(6, wheel), 0.75, 1e-4)
check("the disc itself: m r² / 2", disc_inertia(6, 0.5), 0.75)

# %% [markdown]
# Many programs take a short cut: they put equal parts of the mass on the vertices. But the mass of
# a plate does not sit at its corners.

# %%
predict("05-fifth-vertex")

# %% tags=["answer"]
# four vertices and five, by both formulas
five = np.insert(box, 1, (1.5, 0.0), axis=0)
print(f"misconception: {wrong.vertex_masses.misconception}")
for name, vertices in (("four vertices", box), ("five vertices", five)):
    print(f"{name}: {polygon_inertia(6.0, vertices):.2f} kg m², ", end="")
    print(f"with masses on the vertices {wrong.vertex_masses(6.0, vertices):.2f} kg m²")
ratio = wrong.vertex_masses(6.0, box) / polygon_inertia(6.0, box)
check("for every rectangle it is too large by the factor", ratio, 3.0, tolerance=1e-12)
triangle = box[:3]
ratio = wrong.vertex_masses(6.0, triangle) / polygon_inertia(6.0, triangle)
check("and for every triangle", ratio, 4.0, tolerance=1e-12)

# %% tags=["answer", "plumbing"]
# four vertices and five, by both formulas
extra = np.arange(9)
lists = [np.vstack([np.linspace((0, 0), (3, 0), 2 + k), box[2:]]) for k in extra]
named = {
    "triangles": (extra, [polygon_inertia(6.0, vertices) for vertices in lists]),
    "masses on the vertices": (extra, [wrong.vertex_masses(6.0, vertices) for vertices in lists]),
}

# %% tags=["answer", "plumbing"]
# four vertices and five, by both formulas
fig, (left, right) = style.figure(2, width=9.5, height=3.4)
figures.fan_of_triangles(left, five, polygon_centroid(five))
left.set_title("triangles from the centroid", fontsize=11)
plots.curves(right, named, "extra vertices on one edge", "moment of inertia, kg m²")
right.set_ylim(0, 21)
show(
    fig,
    "Left: a box with a fifth vertex on its lower edge, cut into five triangles that meet in the "
    "centroid. Right: moment of inertia over the number of extra vertices. With triangles it "
    "stays at 6.5; with masses on the vertices it falls from 19.5, although the body is the same.",
)

# %% [markdown]
# ## 3 Off centre, a body gives way by turning
#
# Push a door near its hinge: it hardly moves. Push it at its edge: it swings open. It is the same
# door. So how hard is it to move a body *at the contact*?
#
# Give it an impulse of 1 N s along n, at r from the centre. The centre gains the velocity 1/m.
# The spin gains $(r \times n)/I$. The contact is carried along: for each rad/s it gains another
# $r \times n$ along n. So each body adds $1/m + (r \times n)^2/I$ to the change of relative
# velocity:
#
# $$\frac{1}{m_\text{eff}} = \frac{1}{m_a} + \frac{1}{m_b} +
# \frac{(r_a \times n)^2}{I_a} + \frac{(r_b \times n)^2}{I_b}$$
#
# Chapter 04 had the first two terms. The new ones are never negative: **a hit off centre meets a
# smaller effective mass**. It pushes less and spins more. The same formula with t in place of n
# is the effective mass for friction.

# %%
rod_inertia = 1 / 3  # a thin rod of 2 m and 1 kg: m L² / 12
for arm in (0.0, 0.5, 1.0):
    # 1/m of ball and rod, 1/I of both, and both lever arms; a smooth ball cannot turn
    m_eff = effective_mass(1, 1, 0, 1 / rod_inertia, 0, arm)
    impulse = 2 * m_eff  # a ball of 1 kg comes at 1 m/s, e = 1
    print(f"ball hits {arm:.1f} m off centre: effective mass {m_eff:.3f} kg, ", end="")
    print(f"ball {1 - impulse:+.2f} m/s, rod {impulse:+.2f} m/s, ", end="")
    print(f"spin {arm * impulse / rod_inertia:+.2f} rad/s")

# %% tags=["plumbing"]
arms = np.linspace(0, 1, 101)
m_eff = effective_mass(1, 1, 0, 1 / rod_inertia, 0, arms)
after = {
    "ball, m/s": (arms, 1 - 2 * m_eff),
    "rod's centre, m/s": (arms, 2 * m_eff),
    "rod's spin, rad/s": (arms, 2 * m_eff * arms / rod_inertia),
}

# %% tags=["plumbing"]
fig, (left, right) = style.figure(2, width=9.5, height=3.2)
plots.curves(
    left, {"": (arms, m_eff)}, "distance of the hit from the centre, m", "effective mass, kg"
)
left.set_ylim(0, 0.55)
plots.curves(right, after, "distance of the hit from the centre, m", "after the hit")
show(
    fig,
    "Left: the effective mass of ball and rod falls from 0.5 kg at the centre to 0.2 kg at the "
    "end. Right: the further off centre the hit, the faster the ball goes on, the slower the rod "
    "moves off, and the faster it spins; the spin is greatest at about 0.8 m.",
)

# %% [markdown]
# The spin is the lever arm times the impulse, divided by I. Further out the arm grows, but the
# impulse shrinks. So the rod spins fastest when it is hit a little inside its end:

# %%
_, spins = after["rod's spin, rad/s"]
check("the best place, m: the root of 2/3", arms[np.argmax(spins)], np.sqrt(2 / 3), tolerance=0.01)

# %% [markdown]
# Now ask the engine. A rod is a segment that has a mass. The closed form solves momentum, angular
# momentum and restitution as three equations at once, and pymunk plays the same scene.

# %%
expected = impact_closed_forms.off_centre_hit(1.0, 1.0, 1.0, 1 / 3, arm=1.0, restitution=1.0)
check("worked by hand: ball, rod and spin", expected, (0.6, 0.4, 1.2), tolerance=1e-12)
for solver in ("sequential", "pymunk"):
    run = scenes.ball_hits_rod(1.0, solver)
    after = (*run.velocities[-1, :, 1], run.angular_velocities[-1, 1])
    check(f"{solver}: ball, rod and spin", after, expected, tolerance=1e-9)

# %%
animate(
    {f"hit {arm:.0f} m off centre": scenes.ball_hits_rod(arm) for arm in (0.0, 1.0)},
    "A ball flies up and hits a level rod. Hit at its centre, the rod flies off without turning "
    "and the ball stops. Hit at its end, the rod moves off more slowly and turns, and the ball "
    "goes on.",
)

# %% [markdown]
# ## 4 Friction stops the sliding, or fails at Coulomb's limit
#
# Rough surfaces that slide on each other slow each other down. Which impulse along t stops the
# sliding v_t at once? It has to change v_t by -v_t, and you know the effective mass along t. Write
# it:


# %%
@gap("05-stopping")
def stopping_impulse(m_eff, vt):
    return ...


# %% [markdown]
# But friction cannot always stop the sliding: a car on ice slides on. Coulomb found the limit. The
# harder you press two surfaces together, the more friction they can give. For impulses:
#
# $$|j_t| \le \mu\, j_n$$
#
# The number μ is the **friction coefficient**: about 0.05 on ice, 1 for rubber on a road. If
# stopping the sliding takes less than the limit, the contact **sticks**. If it takes more, the
# contact goes on **sliding**, more slowly. Friction can stop a sliding, but never reverse it.

# %%
needed = stopping_impulse(2.0, 3.0)
print(f"2 kg that slide at 3 m/s: {needed:+.0f} N s stop them")
for mu, allowed in ((1.0, 8.0), (0.5, 4.0)):
    expected = max(needed, -allowed)
    check(f"mu = {mu}, pressed with 8 N s", friction_impulse(3.0, 2.0, mu, 8.0), expected)
check("what mu = 0.5 leaves of the sliding, m/s", 3.0 + -4 / 2.0, 1.0)
check("sliding the other way", friction_impulse(-3.0, 2.0, friction=0.5, normal_impulse=8.0), 4)
check("no pressure, no friction", friction_impulse(3.0, 2.0, friction=0.5, normal_impulse=0.0), 0)

# %%
predict("05-sticks")

# %% tags=["answer"]
# the cone
live(
    "ch05_spin_and_friction/friction_cone",
    "Left: the cone of Coulomb's limit for mu = 0.5. The dashed arrow that would stop a sliding of "
    "3 m/s points out of it; the impulse ends on its edge, at 2 N s, and the contact slides on. "
    "Right: the friction impulse over the sliding, a ramp between two limits. You can drag the tip "
    "of the dashed arrow and the sliding, and change mu, the sliding and the normal impulse.",
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# From mu = 0.75 on: it takes 3 N s to stop the sliding, and mu times 4 N s are allowed.
#
# Draw the impulse as an arrow: j_n up, j_t to the side. Coulomb's limit is a **cone**. The dashed
# arrow is what would stop the sliding. If it points out of the cone, friction gives only as much as
# the cone allows at that height. On the right you see the friction impulse over the sliding: a
# ramp, with a floor and a ceiling. Drag the tip of the dashed arrow into the cone and out of it.

# %% [markdown]
# ## 5 The friction impulse turns the body
#
# Now put it together. An impact gives j_n along n and j_t along t. Both act at the contact, so both
# have a torque. For a disc the normal impulse points at the centre and turns nothing; the friction
# impulse has the whole radius as its lever arm. These lines do all of it. You know every name
# in them but `pushed`: it adds J/m to the velocity and (r x J)/I to the spin.

# %%
print(inspect.getsource(hit).split('"""')[-1].strip("\n"))

# %% [markdown]
# Take a disc of 1 kg and 0.5 m radius, without spin. It hits a rough floor at (3, -4) m/s, with e =
# 0.5. Along the normal: j_n = 1.5 · 4 = 6 N s. Along the tangent 1/m_eff = 1 + r²/I = 3, so the
# effective mass is a third of the mass, and it takes 3/3 = 1 N s to stop the sliding.

# %%
predict("05-rubber")

# %% tags=["answer"]
# the disc on rubber and on ice
up = np.array([0.0, 1.0])
disc = Disc(mass=1.0, radius=0.5, position=0.5 * up, velocity=np.array([3.0, -4.0]))
for name, friction, v, w in (("rubber", 1.0, (2, 2), -4.0), ("ice", 0.05, (2.7, 2), -1.2)):
    after = scenes.hit_wall(disc, up, restitution=0.5, friction=friction)
    check(f"{name}: velocity", after.velocity, v, tolerance=1e-12)
    check(f"{name}: spin", after.angular_velocity, w, tolerance=1e-12)
after = scenes.hit_wall(disc, up, restitution=0.5, friction=1.0)
slip = contact_velocity(after.velocity, after.angular_velocity, -0.5 * up)[0]
check("rubber: no sliding is left at the contact", slip, 0.0, tolerance=1e-12)

# %% [markdown]
# A law checks this without any formula of ours. The floor acts on the disc at the contact alone,
# and about that point an impulse has no lever arm. So the **angular momentum about the contact**,
# $m\,r \times v + I w$, is the same before and after, whatever e and μ are.

# %%
contact = disc.position - disc.radius * up
check("before: 0.5 m times 3 m/s, clockwise", disc.angular_momentum(contact), -1.5)
for friction in (0.0, 0.05, 1.0):
    after = scenes.hit_wall(disc, up, restitution=0.5, friction=friction)
    check(f"after, mu = {friction}", after.angular_momentum(contact), -1.5, tolerance=1e-12)

# %% [markdown]
# Spin can become velocity, too. Throw a ball to the right with strong **backspin**: its lowest
# point slides to the right *faster* than the ball moves.

# %%
predict("05-backspin")

# %% tags=["answer"]
# the ball in the engine
run = scenes.thrown_with_backspin()
for when in (0.0, 1.0, 2.0):
    k = np.argmin(np.abs(run.times - when))
    print(f"at {when} s: {run.velocities[k, 0, 0]:+.3f} m/s to the right, ", end="")
    print(f"spin {run.angular_velocities[k, 0]:+.1f} rad/s")
check("worked by hand: (2 · 2 - 0.05 · 120) / 3", run.velocities[-1, 0, 0], -2 / 3, tolerance=1e-12)

# %% tags=["answer", "plumbing"]
# the ball in the engine
fig, ax = style.figure(width=7.5, height=4.4)
scene_plots.ghosts(ax, run, np.arange(0, 1.8, 0.1))
scene_plots.trails(ax, run, until=1.7)
show(
    fig,
    "A ball thrown to the right with backspin, drawn every 0.1 s with a spoke that shows its "
    "turning. It flies in an arc to its first bounce at 0.9 m, and then bounces back to the left, "
    "turning slowly.",
)

# %% [markdown]
# ## 6 Two discs, and the judge
#
# When two bodies hit, B receives the impulse and A receives the opposite one, at the same place.
# Momentum and angular momentum of both together are kept. This law is about the *sum*: the spin of
# each disc may change, even both in the same direction.
#
# Draw 2,000 random pairs: masses from 1 g to 1,000 kg, radii from 0.1 to 10 m, any spin, any e and
# μ. pymunk makes one step with each, and the formulas tell you what should come out. As in chapter
# 04, the normal belongs to the *moved* positions:

# %%
at_moved, at_start = scenes.worst_difference_from_pymunk(2000, dt=1 / 60)
check("at the moved positions, part of the fastest speed", at_moved, 0, tolerance=1e-13)
print(f"at the positions before the step: off by up to {at_start:.0%}")

# %% [markdown]
# An engine finds two discs a little inside each other, and pushes each at its own rim. That changes
# the angular momentum by overlap · j_t. Chapter 09 shows how to avoid it.
#
# ## 7 Sliding turns into rolling
#
# A disc is set down on a rough floor. It moves at v_0 and does not spin. Friction slows it down
# and turns it, until its lowest point stands still. From then on it rolls, and friction has
# nothing left to do.
#
# How fast does it roll? About a point of the floor friction has no lever arm. So m r v + I w_c is
# kept, with w_c counted clockwise. At the start that is m r v_0. When the disc rolls, w_c = v/r.
# Which part v/v_0 is left? Write it with k = I/(m r²).


# %%
@gap("05-rolling")
def rolling_part(k):
    return ...


# %% [markdown]
# The friction coefficient does not appear! On ice and on rubber the disc ends at the same speed. On
# rubber it gets there sooner.

# %%
predict("05-hoop")

# %% tags=["answer"]
# a disc and a hoop in two engines
runs = {}
for name, k in (("disc", 1 / 2), ("hoop", 1.0)):
    for solver in ("sequential", "pymunk"):
        runs[name, solver] = scenes.set_down_sliding(k, solver)
        part = runs[name, solver].velocities[-1, 0, 0] / 3
        check(f"{name}, {solver}: v / v0", part, rolling_part(k), tolerance=1e-12)

# %% tags=["answer", "plumbing"]
# a disc and a hoop in two engines
times = np.linspace(0, 1, 601)
exact, found = {}, {}
for name, k in (("disc", 1 / 2), ("hoop", 1.0)):
    v, w = rigid_body_closed_forms.slide_to_roll(times, 3, 0, 0.5, k, friction=0.3, gravity=9.81)
    exact[name] = {"velocity of the centre": (times, v), "speed of the rim": (times, -0.5 * w)}
    found[name] = {}
    for label, solver, first in (("ours", "sequential", 0), ("pymunk", "pymunk", 3)):
        some = slice(first, None, 6)
        v, w = runs[name, solver].velocities[some, 0, 0], runs[name, solver].angular_velocities
        both = np.concatenate([v, -0.5 * w[some, 0]])
        found[name][label] = (np.tile(runs[name, solver].times[some], 2), both)

# %% tags=["answer", "plumbing"]
# a disc and a hoop in two engines
fig, axes = style.figure(2, width=9.5, height=3.4)
for ax, name in zip(axes, ("disc", "hoop"), strict=True):
    figures.measured_on_curves(ax, exact[name], found[name], "time, s", "m/s")
    ax.set(title=name, xlim=(-0.03, 1.03))
show(
    fig,
    "Velocity of the centre and speed of the rim over time, for a disc and a hoop set down at 3 "
    "m/s. The first falls and the second rises in straight lines until they meet, at 2 m/s for "
    "the disc and 1.5 m/s for the hoop; then both stay. Our engine's and pymunk's points lie on "
    "the lines.",
)

# %% [markdown]
# You can now compute a whole impact with spin and friction, and say how fast a sliding body ends up
# rolling. The exercise [05 Spin and friction](../exercises/05_spin_and_friction.ipynb) asks for
# nothing more, so you may do it now. **Next:**
# [05b Friction put to the test](05b_friction_put_to_the_test.ipynb), where slopes and laws judge an
# engine. The quiz of the chapter stands at its end.
