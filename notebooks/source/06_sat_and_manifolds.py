# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 06 SAT and manifolds
#
# Two discs overlap when their centres are too near. A box has no radius: how near is too near
# depends on how it is turned. Here you find the normal and the depth for polygons, and then the
# points at which impulses act. With that, boxes land, slide and stand on each other.
#
# **After this notebook you will be able to**
#
# 1. find out with separating axes whether two convex polygons overlap, how deep, and which is the
#    shortest way out;
# 2. turn an overlap into one or two contact points, and say why a box needs two to stand;
# 3. test an engine with contacts that influence each other: a flat landing, a corner, a stack.
#
# **You need** notebooks 00 to 05. **Time:** about 50 minutes to read and to write two lines, a few
# seconds to run.

# %% tags=["plumbing"]
from dataclasses import replace

import numpy as np

from lesson_code import Body, Circle, Polygon, Scene, Segment, simulate
from lesson_code.chapters.ch06_sat_and_manifolds import figures, manifold_figures, scenes
from lesson_code.chapters.ch06_sat_and_manifolds import right_answers as unusual
from lesson_code.chapters.ch06_sat_and_manifolds import wrong_answers as wrong
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check

# %% tags=["plumbing"]
from lesson_code.evidence.scenes import corner_impacts, rigid_bodies
from lesson_code.formulas import reflect
from lesson_code.formulas.smooth_pair import separating_push
from lesson_code.geometry import collide, mtv, overlap, project, sat_axes
from lesson_code.reference.impact_closed_forms import flat_landing, off_centre_hit
from lesson_code.reference.pymunk_reference.overlap import circle_overlap, polygon_overlap
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 A gap between two shadows is proof
#
# Hold a lamp beside two shapes, so that both cast a shadow on a line. If there is a gap between
# the *shadows*, there is a gap between the *shapes*. The line is called an **axis**.
#
# An axis has a direction: a unit vector n. The dot product p · n says how far a point p lies
# along it. A polygon reaches no farther than its vertices, so its shadow is the interval
#
# $$\left[\ \min_i\ (p_i \cdot n),\quad \max_i\ (p_i \cdot n)\ \right]$$

# %%
predict("06-diagonal")

# %% tags=["answer"]
# two shadows of a square
square = np.array([(0, 0), (2, 0), (2, 2), (0, 2)])
diagonal = np.array([1, 1]) / np.sqrt(2)
check("along x it is as long as a side", project(square, (1, 0)), (0, 2))
check("along the diagonal, as long as it is", project(square, diagonal), (0, np.sqrt(8)), 1e-12)

# %% [markdown]
# No gap on *one* axis proves nothing. Here are two shapes that are apart, seen along two axes. On
# the left the shadows overlap. On the right they do not: that axis settles it.

# %% tags=["plumbing"]
triangle = np.array([(1.6, 3.0), (3.2, 1.5), (3.6, 3.4)])
fig, axes = style.figure(2, width=9.5, height=4.0)
for ax, axis, title in zip(
    axes, ((1, 0), diagonal), ("these shadows overlap", "these do not: a gap"), strict=True
):
    figures.shadows_beside(ax, square, triangle, axis)
    ax.set_title(title, fontsize=11)
show(
    fig,
    "A square and a triangle with a gap between them, twice. On the left their shadows on a level "
    "axis overlap. On the right, on an axis along the diagonal of the square, they part.",
)

# %% [markdown]
# ## 2 The normals of the edges are enough
#
# You cannot try all axes: there are infinitely many. But take two convex polygons with a gap
# between them, lay a line into the gap, and turn and shift it until it lies along an edge of one of
# them. It still fits into the gap. So if there is a gap at all, there is one *along an edge*. The
# axis that shows it stands across that edge: it is the edge's **normal**.
#
# So the test needs one axis for each edge of A and of B. This is the **separating axis theorem**,
# SAT for short. It holds for convex shapes only. For vertices counter-clockwise, the outward
# normal of an edge with direction u is $(u_y, -u_x)$. Two vertices in one place would make an
# edge without a direction, and so without a normal: `Polygon` refuses them at the door.

# %%
axes = sat_axes(square)
print(axes)
edges = np.roll(square, -1, axis=0) - square
check("four edges, four normals", len(axes), 4)
check("each at right angles to its edge", (axes * edges).sum(axis=1), 0)

# %% [markdown]
# Parallel edges share an axis, so a box has two. Below, A is a box and B a triangle: five axes.
# The picture shows the axis that **decides**: the one with the widest gap, or else with the
# shortest way out. Each row on the right is one axis with both shadows.
#
# Drag B. Find a place where only one of the five axes shows a gap.

# %%
live(
    "ch06_sat_and_manifolds/two_polygons",
    "A tilted box A and a triangle B that overlap at the right end of A. On the axis that "
    "decides, A2, the two shadows overlap by 0.81 m; on four others by more. B can be moved and "
    "turned.",
)

# %% [markdown]
# ## 3 Two intervals part the shorter way
#
# If no axis shows a gap, the shapes overlap. How deep? On each axis, B can leave A in two
# directions: upwards, until its low end is at A's high end, or downwards, until its high end is
# at A's low end. The shorter way counts. Write it, for two intervals that overlap:


# %%
@gap("06-way-out")
def shorter_way(low_a, high_a, low_b, high_b):
    return ...


# %%
predict("06-nested")

# %% tags=["answer"]
# two pairs of intervals
check("one end inside: the part they share", shorter_way(0, 3, 2, 5), 1)
check("B inside A, right in the middle", shorter_way(0, 40, 15, 25), 25)
check("the part they share", wrong.common_part((0, 40), (15, 25)), 10)
check("touching is not overlapping", overlap((0, 3), (3, 5)), None)

# %% [markdown]
# Many programs take the part that both shadows share as the depth. That is right as long as each
# has an end outside the other. It fails when one contains the other: then a small body sits deep in
# a large one, where a wrong depth does most harm.
#
# ## 4 The shortest way out has a direction
#
# The smallest overlap of all axes is the **depth**, and its axis is the **normal**. Together they
# are the **minimum translation vector**, MTV: B moved by depth times normal just touches A. The
# normal points from A to B, as always in this course.
#
# An axis has two directions. The shadows tell you which of them is the normal: the one in which B
# has the shorter way out. The centres of the shapes do not matter.

# %%
slab, brick = np.array([(0, 0), (4, 0), (4, 2), (0, 2)]), np.array([(3, 1), (6, 1), (6, 4), (3, 4)])
normal, depth = mtv(slab, brick)
check("out to the right or upwards: 1 m each way", depth, 1)
check("moved by it, B only touches", mtv(slab, brick + depth * normal), None)
check("a little less is not enough", mtv(slab, brick + 0.99 * depth * normal)[1], 0.01, 1e-12)
axes = np.concatenate((sat_axes(slab), sat_axes(brick)))
ways_out = [shorter_way(*project(slab, n), *project(brick, n)) for n in axes]
check("the smallest of your ways, over all axes", min(ways_out), depth)
right = np.array([0.5, 0])
for name, shift in (("left", -right), ("right", right)):
    normal, depth = mtv(slab, brick + shift)
    print(f"B half a metre further {name}: normal {normal}, depth {depth} m")

# %% tags=["plumbing"]
fig, axes = style.figure(2, width=9.5, height=3.4)
chip = np.array([(0.8, 0.5), (2.0, 0.7), (1.1, 1.6)])
for ax, b, title in (
    (axes[0], brick + right, "at the side: out to the right"),
    (axes[1], chip, "inside: out through the top"),
):
    figures.pair(ax, slab, b)
    figures.translation(ax, slab, b)
    ax.set_title(title, fontsize=11)
show(
    fig,
    "Two pairs of polygons, each with an arrow from the deepest point of B along the minimum "
    "translation vector, and B's outline where it then is. At the side of A the way leads right; "
    "a small triangle inside A goes out by its whole height and the way to the edge.",
)

# %% [markdown]
# Two bodies share this way as in chapter 04: both move along the normal, the lighter one further,
# in the ratio of the inverse masses.

# %%
m_a, m_b = 1.0, 3.0
normal, depth = mtv(slab, brick + right)
push = separating_push(m_a, m_b, normal, depth)
check("A gives way by three quarters", -push / m_a, (-0.375, 0))
check("B by one quarter", push / m_b, (0.125, 0))
check("then they only touch", mtv(slab - push / m_a, brick + right + push / m_b), None)

# %% [markdown]
# ## 5 Two judges: pymunk, and the Minkowski difference
#
# pymunk does not use separating axes. It looks for the nearest points of two shapes (GJK and
# EPA). So it is a good judge. The second judge is a construction from geometry: the **Minkowski
# difference** is the set of all a - b, with a in A and b in B. A and B overlap when it contains
# the origin, and the depth is the distance from there to its outline.
#
# Ask all three about 1,000 random pairs.

# %%
rng = np.random.default_rng(seed=6)
pairs = [(scenes.random_polygon(rng), scenes.random_polygon(rng, reach=1.5)) for _ in range(1000)]
ours = [mtv(a, b) for a, b in pairs]
pymunks = [polygon_overlap(a, b) for a, b in pairs]
minkowskis = [unusual.minkowski_difference(a, b) for a, b in pairs]
hits = [found is not None for found in ours]
print(sum(hits), "of 1000 pairs overlap")
for judge, answers in (("pymunk", pymunks), ("Minkowski", minkowskis)):
    check(f"{judge} agrees who overlaps", [found is not None for found in answers], hits)
    both = [(a, b) for a, b in zip(ours, answers, strict=True) if a is not None]
    apart = [depth - other for (_, depth), (_, other) in both]
    check(f"depths, ours and {judge}'s, m", apart, 0, tolerance=1e-12)

# %% [markdown]
# ## 6 From the overlap to the contact points
#
# The MTV tells you how to separate two polygons. But where does the impulse act? The points where
# two shapes meet are called the **manifold**. For polygons it has one or two points:
#
# 1. The **reference edge** is the edge whose normal is the MTV's. The **incident edge** is the
#    edge of the other polygon that faces it most.
# 2. You **clip** the incident edge: you cut off what lies beyond the ends of the reference edge.
# 3. The ends of what is left are the contacts, if they are behind the reference edge. How far
#    behind is the **penetration** there.
#
# Drag B, or turn it, and go through the steps with the first slider. Before each step say what it
# will find. Where does one contact become two?

# %%
live(
    "ch06_sat_and_manifolds/clipping",
    "A tilted box B sits with its lower edge in the top of a level box A; the top edge of A and "
    "the lower edge of B are thick. What of B's edge lies beyond the right end of A's is cut off. "
    "B can be dragged and turned, and the clipping followed in six steps.",
)

# %%
floor, crate = Polygon.box(20, 2), Polygon.box(2, 2)
for name, pose in (("flat", (3, 0.9, 0)), ("on its corner", (3, 1.3, np.pi / 4))):
    contact = collide(floor, (0, -1, 0), crate, pose)
    print(f"{name}: normal {contact.normal}, {len(contact.points)} point(s)")
flat = collide(floor, (0, -1, 0), crate, (3, 0.9, 0))
check("flat: half way into the overlap of 0.1 m", flat.points, [(4, -0.05), (2, -0.05)], 1e-12)
check("penetrations", flat.penetrations, (0.1, 0.1), 1e-12)
moved = collide(floor, (0, -1, 0), crate, (3.02, 0.91, 0))
check("the same contacts a step later, by name", moved.features, flat.features)

# %% [markdown]
# Each point has a name, its **feature**: which edges meet there, and at which end. By its feature
# the engine recognises a contact in the next step. It can then start from the impulse that was
# right a step ago. This is called warm starting. It is one reason why a stack comes to rest.
#
# ## 7 One point makes a box spin, two let it stand
#
# A box lands flat. If there is only one contact, at a corner, the impulse has a lever arm and the
# box starts to turn. With a second contact at the other corner both torques cancel.

# %%
predict("06-one-contact")

# %% tags=["answer"]
# both landings
landing = rigid_bodies.box_landing_flat(width=2, height=1, speed=1, restitution=0)
pin = Body(Circle(0.1), position=(0.95, -0.1))
on_pin = Scene([pin, landing.bodies[1]])
two, one = (simulate(scene, 1.5, solver="sequential") for scene in (landing, on_pin))
inertia = (2**2 + 1**2) / 12
jn = 1 / (1 + 0.95**2 / inertia)  # (1 + e) v m_eff, with the lever arm 0.95 m
flat_end = [*two.velocities[-1, 1], two.angles[-1, 1]]
check("two contacts: at rest, and flat", flat_end, (0, 0, 0), 1e-12)
check("one contact: after the impact it falls on", one.velocities[1, 1, 1], jn - 1, 1e-12)
check("and turns, rad/s", one.angular_velocities[1, 1], 0.95 * jn / inertia, 1e-12)

# %% tags=["answer"]
# both landings
animate(
    {"a floor: two contacts": two, "a pin: one contact": one},
    "Two boxes come down flat. The one on a floor stops. The one whose right corner meets a pin "
    "turns about it counter-clockwise and falls past it.",
    still=0.8,
    around=(-2, 2, -1.8, 1.4),
)

# %% [markdown]
# ## 8 The impulse acts at the contact, along its normal
#
# A ball falls onto a plank, 1.5 m beside the middle. The normal there points straight up: it is
# the plank's, and not the line from centre to centre. Momentum, angular momentum and restitution
# give the velocities after the impact, and none of them is sideways.

# %%
scene = rigid_bodies.ball_on_plank(arm=1.5)
plank = scene.bodies[0]
ball, body, turning = off_centre_hit(1.0, -2.0, plank.mass, plank.inertia, 1.5, restitution=1)
for solver in ("sequential", "pymunk"):
    run = simulate(scene, 0.5, solver=solver, sample="end")
    check(f"{solver}: ball", run.velocities[-1, 1], (0, ball), 1e-12)
    check(f"{solver}: plank", run.velocities[-1, 0], (0, body), 1e-12)
    check(f"{solver}: the plank turns", run.angular_velocities[-1, 0], turning, 1e-12)

# %%
naive = simulate(scene, 0.5, solver="naive")
print("centre to centre:", naive.velocities[-1, 1].round(3), "m/s")
print("angular velocity:", naive.angular_velocities[-1, 0])
animate(
    {"along the normal": simulate(scene, 0.5, solver="sequential"), "centre to centre": naive},
    "A ball falls on the right part of a plank. Along the normal: the plank whirls away, the ball "
    "stays on its vertical line. Centre to centre: the ball goes off to the right, and the plank "
    "moves to the left without turning.",
    seconds=3,
    still=0.4,
)

# %% [markdown]
# The naive solver of chapter 04 pushes from centre to centre. The ball gains a velocity along the
# plank, though nothing pushes it that way, and the plank does not turn. Yet an impulse along the
# line of the centres keeps momentum, energy and angular momentum. None of these laws notices that
# its *direction* is wrong.

# %%
predict("06-plank-as-wall")

# %% tags=["answer"]
# the momentum, with a free plank and with a wall
wall = Scene([replace(plank, mass=None, inertia=None), scene.bodies[1]])
for name, with_plank in (("the plank is free", scene), ("the plank is a wall", wall)):
    run = simulate(with_plank, 0.5, sample="end", solver="sequential")
    momentum = 1.0 * run.velocities[:, :, 1].sum(axis=1)  # 1 kg each
    print(f"{name:19}: momentum {momentum[0]:+.2f} -> {momentum[1]:+.2f} kg m/s")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The wall changes the momentum of the ball by twice its amount. A wall may do that, because the
# whole earth holds it. A free plank of 1 kg may not.

# %% [markdown]
# ## 9 A circle meets the closest point
#
# A circle has no edges. It touches a polygon at the point of the polygon that is closest to its
# centre c:
#
# - **beside an edge**: the foot of the perpendicular; the normal is the edge's;
# - **beside a vertex**: the vertex; the normal points from it to c;
# - **the centre is inside**: out through the nearest edge. Then the normal points from c to the
#   closest point, and with d between the two the depth is r + d instead of r - d.
#
# A segment is the same with two sides and two round ends.

# %% tags=["plumbing"]
pentagon = Polygon([(0, 0), (3, 0), (3.4, 1.6), (1.2, 2.4), (-0.4, 1.3)])
around_it = [(0, -1.35, 0.4), (2.0, 0.8, 0.4), (0.3, 0.75, 0.35), (-1.55, -0.3, 0.3)]
around_rod = [(-0.8, 0.25, 0.45), (0.8, -0.2, 0.45), (2.2, 0.12, 0.4), (-2.25, -0.2, 0.4)]
fig, axes = style.figure(2, width=9.5, height=3.6)
groups = ((pentagon, around_it), (Segment((-2, 0), (2, 0), radius=0.1), around_rod))
for ax, (shape, circles) in zip(axes, groups, strict=True):
    discs = [Body(Circle(r), position=(x, y), mass=1) for x, y, r in circles]
    manifold_figures.ways_out(ax, Scene([Body(shape), *discs]))
show(
    fig,
    "On the left four circles at a pentagon: beside an edge, at a vertex, and two with the centre "
    "inside; on the right four circles at a thick segment: on both sides and at both ends. An "
    "arrow shows each way out, and a dashed circle where it leads.",
)

# %%
circles = [(rng.uniform(-1.3, 1.3, 2), rng.uniform(0.05, 0.6)) for _ in range(1000)]
shapes = [Polygon(scenes.random_polygon(rng)) for _ in circles]
depths, theirs, inside = [], [], 0
for shape, (centre, radius) in zip(shapes, circles, strict=True):
    contact = collide(shape, (0, 0, 0), Circle(radius), (*centre, 0))
    found = circle_overlap(shape.vertices, centre, radius)
    depths.append(0.0 if contact is None else contact.penetrations[0])
    theirs.append(0.0 if found is None else found[1])
    inside += depths[-1] > radius
print(f"{np.count_nonzero(depths)} of 1000 circles overlap, {inside} with the centre inside")
check("depths, ours and pymunk's, m", np.subtract(depths, theirs), 0, tolerance=1e-12)

# %% [markdown]
# A last trap: some programs write `if closest_point:` where they mean "if one was found". Then the
# corner at (0, 0) counts as no corner. Ask for `None` by name.

# %%
box, ball = Polygon.box(2, 2), Circle(0.6)
contact = collide(box, (-1, -1, 0), ball, (0.3, 0.4, 0))  # the upper right corner is at (0, 0)
check("pushed away from the corner", contact.normal, (0.6, 0.8), tolerance=1e-15)
corners = np.array(box.vertices) - 1
check("the trap", wrong.nothing_at_the_origin(np.array([0.3, 0.4]), 0.6, corners), None)

# %% [markdown]
# ## 10 What one contact does, the next one feels
#
# The two contacts of a box share a body. A push at the left corner also moves the right corner.
# Say that 1 N s at one corner changes the velocity of that corner by k11, and the velocity of the
# other by k12. For a box of the width b
#
# $$k_{11} = \frac1m + \frac{(b/2)^2}{I}, \qquad k_{12} = \frac1m - \frac{(b/2)^2}{I}$$
#
# A solver that visits the contacts in turn leaves an error behind each time. A visit corrects one
# contact and disturbs the other by $k_{12}/k_{11}$. A **sweep** visits both. Which part of an error
# is left after `sweeps` sweeps?


# %%
@gap("06-error-left")
def error_left(k11, k12, sweeps):
    return ...


# %% [markdown]
# For a square box a sweep leaves 1/25, for a tall, narrow one nearly all. pymunk makes 10 sweeps a
# step. Our engine solves the two points of a manifold together, and is exact at once. A box 1 m
# wide and 10 m high lands flat:

# %%
tall = rigid_bodies.box_landing_flat(width=1, height=10, speed=1, restitution=0.5)
for sweeps in (1, 10, 100):
    run = simulate(tall, 1 / 60, solver="pymunk", iterations=sweeps, sample="end")
    v, w = np.abs(flat_landing(1, 10, 1.0, 0.5, sweeps=sweeps))
    print(f"pymunk, sweeps {sweeps:3}: up at {v:.4f} m/s, turning at {w:.4f} rad/s")
    check("   as predicted, m/s", run.velocities[-1, 1], (0, v), tolerance=1e-7)
    check("   as predicted, rad/s", abs(run.angular_velocities[-1, 1]), w, tolerance=1e-7)

# %%
k_move, k_turn = 1.0, 0.5**2 / ((1 + 10**2) / 12)  # of 1 kg
spins = [abs(flat_landing(1, 10, 1.0, 0.5, sweeps=n)[1]) for n in (20, 10)]
law = error_left(k_move + k_turn, k_move - k_turn, 10)
check("ten more sweeps leave this part of the spin", spins[0] / spins[1], law, tolerance=1e-9)
run = simulate(tall, 1 / 60, iterations=1, sample="end")
check("ours, 1 sweep: up at e v", run.velocities[-1, 1], (0, 0.5), tolerance=1e-12)
check("and not turning", run.angular_velocities[-1, 1], 0, tolerance=1e-12)


# %% [markdown]
# Here are the visits one by one. Drag the corner of the box: when does a sweep bring nearly
# nothing, and when is one sweep enough?

# %%
live(
    "ch06_sat_and_manifolds/sweeps",
    "A box 1 m wide and 4 m high has landed flat, and the contact at its left corner has been "
    "visited: that corner goes up at 0.5 m/s, as it should, the right one at 0.05 m/s. Beside it "
    "the spin that is left over the sweeps, in powers of ten: a straight line downwards. The box "
    "and the number of visits can be changed.",
)

# %% [markdown]
# **A corner with friction** has only one contact, but its normal and its tangent influence each
# other: a push at a corner also makes it slide, and friction at a corner
# also presses it down. The answer is a pair of linear equations. We let 500 boxes land on a corner,
# with random size, speed, spin, restitution and friction.

# %%
corners = list(corner_impacts.random_corners(500, seed=1))
for sweeps in (1, 10, 30):
    errors = [corner_impacts.error(impact, "pymunk", sweeps) for impact in corners]
    print(f"pymunk, sweeps {sweeps:2}: the worst is off by {max(errors):.1%} of its velocity")
errors = [corner_impacts.error(impact, "pymunk", 1000) for impact in corners]
check("pymunk is right after 1,000", max(errors), 0, tolerance=1e-9)
errors = [corner_impacts.error(impact, "sequential", 1000) for impact in corners[:100]]
check("and so are we", max(errors), 0, tolerance=1e-9)

# %% [markdown]
# At pymunk's usual 10 sweeps a corner can be wrong by more than a tenth. That is not a fault of
# pymunk; it is the price of 10 sweeps. If you compare an engine with a formula, give it enough of
# them.
#
# ## 11 A stack stands, a pile comes to rest
#
# In a stack every box has two contacts with the one below, and carries all the boxes above. Ten
# boxes, 10 sweeps a step:

# %%
stack = rigid_bodies.box_stack(10)
ours = simulate(stack, 8.0, solver="sequential")
pymunks = simulate(stack, 8.0, solver="pymunk")
check("no box moves sideways", ours.positions[-1, 1:, 0], 0, tolerance=1e-12)

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3)
heights = {"ours": (ours.times, ours.positions[:, 10, 1])}
heights["pymunk"] = (pymunks.times, pymunks.positions[:, 10, 1])
plots.curves(ax, heights, "time, s", "height of the highest box, m")
ax.set_ylim(0, None)
show(
    fig,
    "Height of the highest of ten boxes over 8 s. Ours stays at 9.45 m. pymunk's stays for 4 s, "
    "then leans over and is on the ground after 7.6 s.",
)

# %% [markdown]
# pymunk visits the contacts in turn. With 10 sweeps its stack leans a little more in each step.
# With more sweeps it falls later.
#
# The contacts tell how the load is shared. In the last step, the impulses between floor and
# lowest box add up to the weight of all ten boxes times the step. One box higher it is nine, and
# so on.

# %%
last = ours.contacts.time > ours.times[-2] + 1e-9
on_top = ours.contacts.body_b[last]
carried = [ours.contacts.normal_impulse[last][on_top == n].sum() for n in range(1, 11)]
check(
    "10, 9, ..., 1 weights",
    np.multiply(carried, 60 / rigid_bodies.GRAVITY),
    [*range(10, 0, -1)],
    1e-9,
)

# %%
pile = simulate(scenes.trough(14, rng), 6.0, solver="sequential")
check("in the end all are still, m/s", pile.velocities[-1], 0, tolerance=1e-3)

# %% tags=["nbval-ignore-output"]
animate(
    pile,
    "Fourteen polygons fall into a trough one after the other, and come to rest in a pile.",
    still=4.0,
    around=(-3.2, 3.2, -0.3, 6),
)

# %% [markdown]
# ## 12 Break it on purpose: two faults with polygons
#
# **The direction from the positions.** Many programs point the normal from the position of A to the
# position of B. But a position may be any point of a body that its author found handy. In the next
# scene it is a corner.

# %%
predict("06-notes")

# %% tags=["answer"]
# the crate, by both rules
room = 4 * square
crate = np.array([(7.5, 3), (8.5, 3), (8.5, 4), (7.5, 4)])
position_a, position_b = room[2], crate[0]
normal, depth = mtv(room, crate)
pointed = normal if (position_b - position_a) @ normal > 0 else -normal
check("the way out is to the right", normal, (1, 0))
check("from position to position: to the left", pointed, (-1, 0))
check("the crate was this deep, m", depth, 0.5)
check("and is now this deep, m", mtv(room, crate + depth * pointed)[1], 1.0)

# %% [markdown]
# Even the two middles mislead you when B is deep. Here the middle of a dart lies below that of A,
# and yet its shorter way out leads up.

# %%
kite = np.array([(1.7, 1.9), (-1.5, 1.4), (-1.7, 1.1), (-0.4, -0.9)])
dart = np.array([(0.4, 0.3), (1.0, 0.7), (-2.3, 0.9), (-0.1, 0.3)])
normal, depth = mtv(kite, dart)
pointed, _ = wrong.direction_from_the_centres(kite, dart)
check("the opposite direction", pointed, -normal)
check("the right way leads out", mtv(kite, dart + depth * normal * (1 + 1e-9)), None)
print(f"moved {depth:.2f} m the wrong way: {mtv(kite, dart + depth * pointed)[1]:.2f} m deep")

# %% tags=["plumbing"]
fig, ax = style.figure(width=5.5, height=3.8)
figures.translation(figures.pair(ax, kite, dart), kite, dart)
ax.set_ylim(-1.3, 2.4)
start = figures.deepest(dart, normal)
plots.arrow(ax, start, depth * pointed, "from middle to middle", style.PURPLE, beside=(0, -9))
show(
    fig,
    "A flat dart B deep inside a quadrilateral A. A black arrow shows the right way out, to the "
    "top, and the outline of B there. A purple one points the other way, from middle to middle.",
)

# %% [markdown]
# **A bounce for every vertex.** A loop over the vertices of a box reflects the velocity at the
# floor once for each vertex that is below it.

# %%
predict("06-twice")

# %% tags=["answer"]
# one reflection for each vertex
velocity, up = np.array([1.0, -3.0]), np.array([0.0, 1.0])
for vertex in ("left", "right"):
    velocity = reflect(velocity, up)
    print(f"after the {vertex} vertex: {velocity} m/s")
check("it goes on into the floor", velocity, (1, -3))

# %% [markdown]
# An engine goes further than a gate: it solves for both points at once, and asks of each that it
# does not approach any more.
#
# ## 13 Quiz

# %%
show_quiz("06")

# %% [markdown]
# ## Key takeaways
#
# - One axis on which the shadows part proves a gap. If the shadows overlap on the normals of all
#   edges, the shapes overlap.
# - The shortest way out of all axes is the depth, and it brings its own direction with it. Where a
#   shape has its position plays no part.
# - A manifold is the incident edge, clipped at the ends of the reference edge: one point or two.
# - The impulse acts at the contact and along its normal. One contact turns a box, two let it stand.
# - What one contact does, the next one feels: sweeps leave an error that you can work out.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** overlap and depth of 1,000 random pairs against pymunk and against the
# Minkowski difference, to 1e-12 m; 1,000 circles against pymunk; the ball on the plank and the
# flat landing against closed forms; 500 corners with friction; the forces in a stack.
#
# **Limits.** SAT is for convex shapes; others have to be cut into convex ones first. A fast body
# can still pass through a thin one between two steps: that is chapter 07. Beyond the two points
# of one manifold our solver makes sweeps too, so a high stack needs more of them.
#
# **Do now:** the exercise [06 SAT and manifolds](../exercises/06_sat_and_manifolds.ipynb): six
# tasks, twenty points. `workbook watch` checks it whenever you save. `workbook play dominoes` is
# made of such contacts, and [its challenge](../exercises/dominoes.py) lets you topple them.
# **Next:** [07 Time of impact](07_time_of_impact.ipynb), for bodies that are too fast for a time
# step.
#
# **Sources.** Ericson, *Real-Time Collision Detection* (2005), chapters 4 and 5. Gottschalk, Lin
# and Manocha, *OBBTree* (1996): separating axes for boxes. Catto, *Iterative Dynamics with
# Temporal Coherence* (2005): sweeps, and the friction limit.
