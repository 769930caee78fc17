# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 03 Reflection
#
# A ball meets a cushion at an angle, and you want to know where it goes. One short formula
# answers that for every wall, however it is tilted, and at the end of this chapter it runs a
# billiard table.
#
# **After this notebook you will be able to**
#
# 1. split a velocity into a part along the normal and a part along the wall, and mirror it;
# 2. bounce a ball with restitution, and say what is wrong with the popular formula v' = e R;
# 3. explain the two rules that keep a ball from sticking in a wall: the gate, and "separate
#    first".
#
# **You need** notebooks 00 to 02. **Time:** about 50 minutes with the questions; it runs in a few
# seconds.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import simulate
from lesson_code.chapters.ch02_restitution.stepped_ball import drop_in_steps
from lesson_code.chapters.ch03_reflection import figures
from lesson_code.chapters.ch03_reflection import wrong_answers as wrong
from lesson_code.chapters.ch03_reflection.scenes import CUSHIONS, billiard_table
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.formulas import bounce, reflect, scaled_reflection
from lesson_code.formulas.arithmetic import dot, perpendicular
from lesson_code.geometry import circle_against_segment
from lesson_code.reference.pymunk_reference import bounce_off_segment
from lesson_code.view.browser.live import live

# %% [markdown]
# ## 1 The mirror removes the normal part twice
#
# A wall has a unit normal N. It points **inward**: from the wall to the ball. The incoming
# velocity is I.
#
# The dot product I · N says how far I reaches along N. So **(I · N) N** is a vector: the *normal
# part* of I. What is left, T = I - (I · N) N, runs along the wall: the *tangent part*.

# %%
incident, normal = np.array([3.0, -4.0]), np.array([0.0, 1.0])
normal_part = dot(incident, normal) * normal
tangent_part = incident - normal_part
check("normal part", normal_part, (0, -4))
check("tangent part", tangent_part, (3, 0))

# %%
predict("03-once")

# %% tags=["answer"]
# the normal part, taken away once and twice
check("taken away once", incident - normal_part, (3, 0))
check("taken away twice", incident - 2 * normal_part, (3, 4))
live(
    "ch03_reflection/mirror",
    "A tilted wall with its normal N. The incoming velocity I goes on below the wall; twice the "
    "normal part leads back up to the mirror image R. You can drag I and change the tilt, how many "
    "times the normal part is taken away, and the length of N.",
)

# %% [markdown]
# Take the normal part away twice, and the ball leaves as steeply as it came:
#
# $$R = I - 2\,(I \cdot N)\,N$$
#
# Write it. Both arguments are arrays, and `dot` is there for you:


# %%
@gap("03-mirror")
def mirror(incident, normal):
    return ...


# %%
check("on a level floor", mirror(incident, normal), (3, 4))
check("the course's own function", mirror(incident, normal), reflect(incident, normal))

# %% [markdown]
# Go back to the figure and give N another length than 1. The mirror then changes the speed: this
# is why every function of this course refuses a normal that is not unit.

# %%
try:
    reflect((3, -4), (0, 2))
except ValueError as error:
    print(error)

# %% [markdown]
# ## 2 A level wall just flips a sign
#
# Many small games bounce a ball off the floor with `vy *= -1`. That is R for N = (0, 1), and for
# no other wall. A box has four walls with four inward normals (y up): floor (0, 1), ceiling (0,
# -1), left (1, 0), right (-1, 0).

# %%
velocity = np.array([3.0, 4.0])
for name, n in (("floor", (0, 1)), ("ceiling", (0, -1)), ("left", (1, 0)), ("right", (-1, 0))):
    print(f"{name:8} {mirror(velocity, np.array(n))}")
check("floor and ceiling flip y", reflect(velocity, (0, 1)), reflect(velocity, (0, -1)))

# %% [markdown]
# Floor and ceiling give the *same* R. Turn N round, and both factors N in the formula change
# sign, so nothing changes. "Inward" will matter all the same: for the gate in section 5, and for
# the push in section 6. A tilted wall needs the whole formula.

# %%
predict("03-bumper")

# %% tags=["answer"]
# a ball falls on the bumper
half = np.sqrt(0.5)
falling, n = np.array([0.0, -2.0]), np.array([half, half])
check("the bumper turns down into right", mirror(falling, n), (2, 0), 1e-15)
check("flipping one sign cannot do that", wrong.flips_an_axis(falling, n), (0, -2))

# %% [markdown]
# Four facts about every mirror, on 10,000 random walls: the speed is kept, the tangent part is
# kept, the normal part changes its sign, and two reflections undo each other.

# %%
rng = np.random.default_rng(seed=3)
angles = rng.uniform(0, 2 * np.pi, 10_000)
n = np.stack((np.cos(angles), np.sin(angles)), axis=-1)
v = rng.uniform(-10, 10, (10_000, 2))
r = reflect(v, n)
check("speed", np.hypot(*r.T) - np.hypot(*v.T), 0, tolerance=1e-12)
check("tangent part", dot((r - v).T, perpendicular(n.T)), 0, tolerance=1e-12)
check("normal part", dot((r + v).T, n.T), 0, tolerance=1e-12)
check("twice is not at all", reflect(r, n) - v, 0, tolerance=1e-12)

# %% [markdown]
# ## 3 Restitution acts on the normal part alone
#
# A smooth wall can only push along its normal. It cannot touch the tangent part. So the factor e
# goes to the normal part and to nothing else:
#
# $$v' = v - (1 + e)\,(v \cdot N)\,N$$
#
# This is chapter 01 again, along N: the impulse on a ball of mass m against an infinite mass is
# $J = -(1 + e)\,m\,(v \cdot N)$.

# %%
after = bounce(velocity=(3, -4), normal=(0, 1), restitution=0.5)
check("e = 0.5 halves the normal part only", after, (3, 2))
check("e = 1 is the mirror", bounce((3, -4), (0, 1), 1), reflect((3, -4), (0, 1)))
check("e = 0 slides along the wall", bounce((3, -4), (0, 1), 0), (3, 0))

# %% [markdown]
# ## 4 The popular variant e R brakes where nothing rubs
#
# Many programs write v' = e R and scale the *whole* mirror image. When the ball comes in steeply,
# you hardly see the difference. At a flat angle you do: the ball loses speed along a wall that is
# perfectly smooth.

# %%
predict("03-popular")

# %% tags=["answer"]
# two rules at the bottom cushion
v = np.array([280.0, 180.0])  # pixels and y down, as on the billiard table
n = np.array([0.0, -1.0])
right, popular = bounce(v, n, 0.95), scaled_reflection(v, n, 0.95)
print("bounce:", right, " e R:", popular)
by_hand = (280**2 + 171**2) / (280**2 + 180**2)
check("energy left after a bounce", dot(right, right) / dot(v, v), by_hand, 1e-12)
check("energy left after e R", dot(popular, popular) / dot(v, v), 0.95**2, 1e-12)

# %%
bounces = np.arange(31)
v_bounce, v_scaled = [v], [v]
for count in bounces[1:]:
    n = np.array([0.0, 1.0 if count % 2 == 0 else -1.0])  # bottom and top cushion in turn
    v_bounce.append(bounce(v_bounce[-1], n, 0.95))
    v_scaled.append(scaled_reflection(v_scaled[-1], n, 0.95))

# %% tags=["plumbing"]
figures.speeds(v_bounce, v_scaled, tangent=280.0)

# %% [markdown]
# `lesson_code` keeps the variant under its own name, `scaled_reflection`, because programs use
# it. Now you know what it costs.
#
# Drag I, move the sliders and compare both rules. They agree at e = 1 and for a ball that comes
# straight down; at which angle are they farthest apart?

# %%
live(
    "ch03_reflection/bounce",
    "A ball comes in at 45 degrees on a level wall, e = 0.5. The bounce leaves flat along the "
    "wall; e R leaves at 45 degrees and slower. You can drag I, tilt the wall and change e.",
)

# %% [markdown]
# ## 5 Break it on purpose: a wall without a gate
#
# A program looks at the ball once per time step. When it finds the ball inside the wall, the ball
# may already be on its way *out*, bounced a step ago. Bounce it again, and you send it back in.
# So every bounce needs a gate:
#
# $$v \cdot N < 0 \quad\text{(with N inward: the ball moves against the normal, into the wall)}$$
#
# Write the bounce with its gate. One line will do, with `min(vn, 0)`: a ball that leaves then
# gets no impulse.


# %%
@gap("03-gate")
def my_bounce(velocity, normal, restitution):
    vn = dot(velocity, normal)  # below 0: into the wall
    return ...


# %% [markdown]
# `drop_in_steps`, the loop of chapter 02, takes your function as its rule. For now nothing pushes
# the ball out of the floor.

# %%
predict("03-no-gate")

# %% tags=["answer"]
# your bounce, and the same without its gate
loop = {"height": 1.0, "restitution": 0.8, "duration": 3, "push_out": False}
times, heights = drop_in_steps(wrong.without_gate, **loop)
gated = drop_in_steps(my_bounce, **loop)[1]
figures.gate({"with the gate": (times, gated), "without": (times, heights)})

# %% tags=["answer"]
# how high both balls come
late = times > 1.8  # after the third bounce
print(f"highest point after 1.8 s: {gated[late].max():.2f} m with the gate, ", end="")
print(f"{heights[late].max():.2f} m without")
check("without the gate it stays below the floor", bool(heights[late].max() < 0), True)
check("a leaving ball is left alone", bounce((3, 4), (0, 1), 0.5), (3, 4))

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# At its third bounce the ball was so deep in the floor that, slowed down to 0.8 of its speed, one
# step did not bring it out. The next step bounced it back in, and so on for ever.

# %% [markdown]
# The gate is inside `bounce`, so that you cannot forget it: it is the clamp in `normal_impulse`,
# which never lets the impulse of a wall be negative. A wall can push, but not pull.
#
# ## 6 Separate first, or sink
#
# The gate takes care of the velocity. The position needs a rule of its own. Write it: a ball is
# inside a wall by some depth. Where do you put it?


# %%
@gap("03-out")
def moved_out(position, normal, depth):
    return ...


# %%
position, velocity, n, depth = np.array([2.0, 0.2]), np.array([1.0, 5.0]), np.array([0.0, 1.0]), 0.3
check("moved out by depth times normal", moved_out(position, n, depth), (2.0, 0.5), 1e-15)
check("the velocity of a leaving ball stays", my_bounce(velocity, n, 0.5), (1, 5))

# %%
predict("03-sinks")

# %% tags=["answer"]
# the same ball, separated first and never separated
drop = {"height": 1.0, "restitution": 0.5, "duration": 3}
paths = {
    "separated first": drop_in_steps(my_bounce, **drop),
    "never separated": drop_in_steps(my_bounce, **drop, push_out=False),
}
for name, (times, heights) in paths.items():
    print(f"{name}: after {times[-1]:.0f} s the ball is at {heights[-1]:+.3f} m")

# %% tags=["answer"]
# both heights over time
figures.separation(paths)

# %% [markdown]
# Separate first, and whether the ball comes in or leaves: the push belongs to the position alone.

# %% [markdown]
# ## 7 The judge: pymunk, on both sides and at the ends
#
# A wall of finite length has two sides and two round ends. The normal is then the direction from
# the *closest point* of the wall to the ball. We throw 2,000 balls at random walls, let pymunk do
# one step, and compare its velocities with ours.

# %%
ours, theirs = [], []
for _ in range(2000):
    start, end = rng.uniform(-2, 2, (2, 2))
    along, way = rng.uniform(-0.2, 1.2), rng.uniform(0, 2 * np.pi)
    position = start + along * (end - start) + 0.3 * np.array([np.cos(way), np.sin(way)])
    velocity, e = rng.uniform(-5, 5, 2), rng.uniform(0, 1)
    engine = bounce_off_segment(position, velocity, 0.5, start, end, 0.1, e)
    contact = circle_against_segment(engine.moved_position, 0.5, start, end, 0.1)
    ours.append(velocity if contact is None else bounce(velocity, contact[0], e))
    theirs.append(engine.velocity)

# %%
check("velocities after, ours and pymunk's", np.subtract(ours, theirs), 0, tolerance=1e-9)

# %% [markdown]
# ## 8 A billiard table with a bumper
#
# Everything of this chapter in one program: four cushions, and a bumper at 45 degrees that is a
# short wall with two sides and round ends. In every step: move, look for contacts, **separate
# first**, then **bounce**. Corners meet two cushions in one step. This table is measured in
# pixels, and y points down. The program itself is your exercise; here the workbook's engine plays
# the first shot, from one collision to the next.

# %%
run = simulate(billiard_table(), duration=8.0)
track = run.positions[:, -1]
hits = [CUSHIONS[body] for body in run.contacts.body_a]
print("in 8 s:", {name: hits.count(name) for name in sorted(set(hits))})
check("all four cushions and the bumper", len(set(hits)), 5)

# %% tags=["plumbing"]
figures.table(track)

# %% [markdown]
# The table is yours to write: [exercises/billiards.py](../exercises/billiards.py) has five
# functions for you to fill in, and `workbook play billiards` opens the window with them in it.
#
# ## 9 Quiz

# %%
show_quiz("03")

# %% [markdown]
# ## 10 Key takeaways
#
# - (I · N) N is the part of a velocity along the normal. Take it away once to slide, twice to
#   mirror.
# - Restitution acts on the normal part alone. e R brakes along a smooth wall.
# - The gate, v · N < 0: bounce only what moves into the wall.
# - Separate first: the position has a rule of its own, and it comes before the bounce.
# - Normals are unit vectors. Anything else changes the speed.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** the mirror's four properties on 10,000 random walls; the bounce against pymunk
# on 2,000 random walls, both sides and both ends, to 1e-9 m/s; the table's hits over 8 s.
#
# **Limits.** The ball cannot spin, and the wall cannot move. A very fast ball can jump over a
# thin wall between two steps: chapter 07 is about that.
#
# **Do now:** the exercise [03 Reflection](../exercises/03_reflection.ipynb): three tasks, twelve
# points; then the challenge of this chapter, the [billiards](../exercises/billiards.py). In a
# terminal, `workbook watch billiards` checks it whenever you save, and `workbook play billiards`
# opens the table. **Next:** [04 Circles](04_circles.ipynb).
#
# **Sources.** Householder, *Unitary Triangularization of a Nonsymmetric Matrix* (1958): the
# mirror as a matrix. Brach, *Mechanical Impact Dynamics* (1991), chapter 1: a particle against a
# massive surface.
