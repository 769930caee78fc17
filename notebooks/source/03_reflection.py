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
# A ball hits a cushion at an angle. Where does it go? One short formula answers this for every
# wall, however it is tilted. At the end of this chapter it runs a billiard table.
#
# **After this notebook you will be able to**
#
# 1. split a velocity into a part along the normal and a part along the wall, and mirror it;
# 2. bounce a ball with restitution, and say what is wrong with the popular formula v' = e R;
# 3. explain the two rules that keep a ball from sticking in a wall: the gate, and "separate
#    first".
#
# **You need** notebooks 00 to 02. **Time:** about 40 minutes with the questions; it runs in a few
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
from lesson_code.evidence import check, check_bound
from lesson_code.formulas import bounce, reflect, scaled_reflection
from lesson_code.formulas.arithmetic import dot, perpendicular
from lesson_code.geometry import circle_against_segment
from lesson_code.reference.pymunk_reference import bounce_off_segment
from lesson_code.view.browser.live import live

# %% [markdown]
# ## 1 A velocity has two parts
#
# Before you can turn a velocity round, you have to know which part of it the wall can turn. A wall
# has a unit normal N. It points **inward**: from the wall to the ball. Call the incoming velocity
# I.
#
# The dot product I · N tells you how far I reaches along N. So **(I · N) N** is a vector, the
# *normal part* of I. The rest, T = I - (I · N) N, runs along the wall: the *tangent part*.

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
# Take the normal part away twice, and the ball leaves as steeply as it came. Write this mirror.
# Both arguments are arrays, and `dot` is there for you:


# %%
@gap("03-mirror")
def mirror(incident, normal):
    return ...


# %%
check("on a level floor", mirror(incident, normal), (3, 4))
check("the course's own function", mirror(incident, normal), reflect(incident, normal))

# %% [markdown]
# $$R = I - 2\,(I \cdot N)\,N$$
#
# Go back to the figure and make N longer or shorter than 1: the mirror now changes the speed. This
# is why every function of this course refuses a normal that is not a unit vector.

# %%
try:
    reflect((3, -4), (0, 2))
except ValueError as error:
    print(error)

# %% [markdown]
# ## 2 A level wall just flips a sign
#
# Many small games bounce a ball off the floor with `vy *= -1`. That is the mirror R for N = (0, 1),
# the level floor. You need it four times for a box. With y up, the inward normals are: floor
# (0, 1), ceiling (0, -1), left wall (1, 0), right wall (-1, 0).

# %%
velocity = np.array([3.0, 4.0])
for name, n in (("floor", (0, 1)), ("ceiling", (0, -1)), ("left", (1, 0)), ("right", (-1, 0))):
    print(f"{name:8} {mirror(velocity, np.array(n))}")
check("floor and ceiling flip y", reflect(velocity, (0, 1)), reflect(velocity, (0, -1)))

# %% [markdown]
# Floor and ceiling give the *same* R. If you turn N round, both factors N in the formula change
# their sign, so R stays the same. You will still need "inward" for the gate in section 5 and for
# the push in section 6.
#
# Flipping a sign works only for level and upright walls. Now tilt one.

# %%
predict("03-bumper")

# %% tags=["answer"]
# a ball falls on the bumper
half = np.sqrt(0.5)
falling, n = np.array([0.0, -2.0]), np.array([half, half])
check("the bumper turns down into right", mirror(falling, n), (2, 0), 1e-15)
check("flipping one sign cannot do that", wrong.flips_an_axis(falling, n), (0, -2))

# %% [markdown]
# Is the formula right for every tilt? Test it on 10,000 random walls. A mirror keeps the speed and
# the tangent part, it changes the sign of the normal part, and two reflections cancel.

# %%
rng = np.random.default_rng(seed=3)
angles = rng.uniform(0, 2 * np.pi, 10_000)
n = np.stack((np.cos(angles), np.sin(angles)), axis=-1)
v = rng.uniform(-10, 10, (10_000, 2))
r = reflect(v, n)  # a wall in each row; r.T has all x, then all y
check("speed", np.hypot(*r.T) - np.hypot(*v.T), 0, tolerance=1e-12)
check("tangent part", dot((r - v).T, perpendicular(n.T)), 0, tolerance=1e-12)
check("normal part", dot((r + v).T, n.T), 0, tolerance=1e-12)
check("reflected twice: back to the start", reflect(r, n) - v, 0, tolerance=1e-12)

# %% [markdown]
# ## 3 Restitution acts on the normal part alone
#
# A real ball loses speed when it bounces. Which part of its velocity shrinks? A smooth wall pushes
# along its normal and in no other direction, so it cannot change the tangent part. The factor e
# belongs to the normal part alone:
#
# $$v' = v - (1 + e)\,(v \cdot N)\,N$$
#
# You know this from chapter 01, here along N: a ball of mass m that hits an infinite mass receives
# the impulse $J = -(1 + e)\,m\,(v \cdot N)$.

# %%
after = bounce(velocity=(3, -4), normal=(0, 1), restitution=0.5)
check("e = 0.5 halves the normal part only", after, (3, 2))
check("e = 1 is the mirror", bounce((3, -4), (0, 1), 1), reflect((3, -4), (0, 1)))
check("e = 0 slides along the wall", bounce((3, -4), (0, 1), 0), (3, 0))

# %% [markdown]
# ## 4 The popular variant e R brakes where nothing rubs
#
# Many programs write v' = e R: they scale the *whole* mirror image. If the ball comes in steeply,
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
# Because programs use this variant, `lesson_code` has it too, under its own name:
# `scaled_reflection`. Now you know what it costs.
#
# Drag I, move the sliders and compare both rules. They agree at e = 1, and for a ball that comes
# straight at the wall. What is left of each at e = 0?

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
# may already be on its way *out*, because it bounced a step ago. Such a ball needs no second
# bounce. So every bounce has a gate, and only a ball that moves into the wall may pass it:
#
# $$v \cdot N < 0 \quad\text{(with N inward: the ball moves against the normal)}$$
#
# Write the bounce with its gate. One line is enough if you use `min(vn, 0)`: a ball that leaves
# then gets no impulse.


# %%
@gap("03-gate")
def my_bounce(velocity, normal, restitution):
    vn = dot(velocity, normal)  # below 0: into the wall
    return ...


# %% [markdown]
# `drop_in_steps`, the loop of chapter 02, now bounces the ball with your function. For now nothing
# pushes the ball out of the floor.

# %%
predict("03-no-gate")

# %% tags=["answer"]
# your bounce, and the same without its gate
loop = {"height": 1.0, "restitution": 0.8, "duration": 3, "separate": None}
times, heights = drop_in_steps(wrong.without_gate, **loop)
gated = drop_in_steps(my_bounce, **loop)[1]
figures.gate({"with the gate": (times, gated), "without": (times, heights)})

# %% tags=["answer"]
# how high both balls come
late = times > 1.8  # after the third bounce
print(f"highest point after 1.8 s: {gated[late].max():.2f} m with the gate, ", end="")
print(f"{heights[late].max():.2f} m without")
check_bound("without the gate it stays below the floor, m", heights[late].max(), at_most=0)
check("a leaving ball is left alone", bounce((3, 4), (0, 1), 0.5), (3, 4))

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# At its third bounce the ball was so deep in the floor that, slowed down to 0.8 of its speed, one
# step did not bring it out. The next step bounced it back in, and so on for ever.

# %% [markdown]
# Our `bounce` contains the gate, so you cannot forget it: `normal_impulse` never lets the impulse
# of a wall be negative. A wall can push, but not pull.
#
# ## 6 Separate first
#
# The gate takes care of the velocity. But the ball is still inside the wall, by some depth. Where
# do you put it? Write the new position:


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
# the same ball, separated first by your line, and never separated
drop = {"height": 1.0, "restitution": 0.5, "duration": 3}
paths = {
    "separated first": drop_in_steps(my_bounce, **drop, separate=moved_out),
    "never separated": drop_in_steps(my_bounce, **drop, separate=None),
}
for name, (times, heights) in paths.items():
    print(f"{name}: after {times[-1]:.0f} s the ball is at {heights[-1]:+.3f} m")

# %% tags=["answer"]
# both heights over time
figures.separation(paths)

# %% [markdown]
# So separate first, and always: push the ball out whether it comes in or leaves. The push changes
# its position and leaves its velocity alone.

# %% [markdown]
# ## 7 The judge: pymunk, on both sides and at the ends
#
# So far every wall was endless. A real one has two sides and two ends, which we make round. Then
# the normal is the direction from the *closest point* of the wall to the ball. Does the bounce
# still hold there? We throw 2,000 balls at random walls, let pymunk make one step, and compare its
# velocities with ours.

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
# Now all of this chapter goes into one program: four cushions, and a bumper at 45 degrees, a short
# wall with two sides and round ends. In every step: move, look for contacts, **separate first**,
# then **bounce**. In a corner the ball meets two cushions in one step. This table is measured in
# pixels, and y points down. You write the program as an exercise. Here the workbook's engine plays
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
# Now write your own table: [exercises/billiards.py](../exercises/billiards.py) has five functions
# for you to fill in, and `workbook play billiards --with exercises` plays with them in a window.
#
# ## 9 Quiz

# %%
show_quiz("03")

# %% [markdown]
# ## 10 Key takeaways
#
# - (I · N) N is the part of a velocity along the normal. Take it away once, and the ball slides;
#   take it away twice, and the ball bounces.
# - Restitution acts on the normal part alone. e R brakes along a smooth wall.
# - The gate: bounce a ball only if v · N < 0, that is, if it moves into the wall.
# - Separate first: push the ball out of the wall before you bounce it, gate or no gate.
# - Use unit normals. Any other length changes the speed.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** the mirror's four properties on 10,000 random walls; the bounce against pymunk
# on 2,000 random walls, both sides and both ends, to 1e-9 m/s; the table's hits over 8 s.
#
# **Limits.** The ball cannot spin, and the wall cannot move. A very fast ball can jump over a thin
# wall between two steps; chapter 07 is about that.
#
# **Do now:** the exercise [03 Reflection](../exercises/03_reflection.ipynb): three tasks, twelve
# points; then the challenge of this chapter, the [billiards](../exercises/billiards.py). In a
# terminal, `workbook watch billiards` checks it whenever you save, and `workbook play billiards`
# opens the table. **Next:** [04 Circles](04_circles.ipynb).
#
# **Sources.** Householder, *Unitary Triangularization of a Nonsymmetric Matrix* (1958): the
# mirror as a matrix. Brach, *Mechanical Impact Dynamics* (1991), chapter 1: a particle against a
# massive surface.
