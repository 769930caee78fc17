# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 01 One dimension
#
# A truck and a fly meet head on. You know which of them changes course, and after this notebook you
# can compute by how much. We put everything on a track, so that a velocity is a single number:
# positive to the right, negative to the left. You need no vectors yet, and you already get the
# whole idea of an impulse.
#
# **After this notebook you will be able to**
#
# 1. compute both velocities after a collision that is elastic, perfectly inelastic or anything
#    between;
# 2. say why the heavier body changes its velocity less, and what happens when one mass is
#    infinite;
# 3. find a wrong collision formula by asking it about momentum and energy.
#
# **You need** notebook 00. **Time:** about 35 minutes with the questions; it runs in a few
# seconds.

# %% tags=["plumbing"]
import inspect
from math import inf

import numpy as np

from lesson_code.chapters.ch01_one_dimension import figures
from lesson_code.chapters.ch01_one_dimension import wrong_answers as wrong
from lesson_code.chapters.ch02_restitution.wrong_answers import doubled_impulse
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.formulas import collide_1d, elastic_1d, inelastic_1d, momentum
from lesson_code.formulas.restitution import energy_lost_1d
from lesson_code.formulas.validation import equation
from lesson_code.reference.closed_forms import two_body_exact
from lesson_code.reference.pymunk_reference import collide_on_a_line
from lesson_code.view.browser.live import live

# %% [markdown]
# ## 1 A collision hands momentum over; it makes none
#
# While two carts touch, cart 1 pushes cart 2, and cart 2 pushes cart 1 back: just as hard, and
# for just as long. Add up the push over that time, and you have the **impulse** J. Cart 2
# receives +J, and cart 1 receives -J:
#
# $$m_1 v_1' = m_1 v_1 - J \qquad m_2 v_2' = m_2 v_2 + J$$
#
# Add the two lines, and J drops out. The total momentum $m_1 v_1 + m_2 v_2$ is the same before
# and after, however hard the carts hit each other.

# %%
predict("01-share")

# %% tags=["answer"]
# an impulse of 3 N s between 1 kg and 3 kg
m1, v1, m2, v2 = 1.0, 2.0, 3.0, -2.0
impulse = 3.0
v1_after, v2_after = v1 - impulse / m1, v2 + impulse / m2
check("cart 2 gains, m/s", v2_after - v2, 1.0)
check("cart 1 changes three times as much", (v1_after - v1) / (v2_after - v2), -3.0)
check("momentum before", m1 * v1 + m2 * v2, -4.0)
check("momentum after", m1 * v1_after + m2 * v2_after, -4.0)

# %% [markdown]
# Divide each line by its mass: $v' = v \pm J/m$. Both carts receive the same impulse, but the
# *change of velocity* is J/m. That is why the truck hardly notices the fly.
#
# Momentum alone does not decide what happens, because every impulse keeps it. So you need to know
# one thing more: what do the carts do with the energy of the impact?
#
# ## 2 Carts that stick move with their centre of mass
#
# The centre of mass of the pair moves with the velocity V, the total momentum divided by the
# total mass. A collision changes neither, so it cannot change V. If the carts stick together,
# both of them *are* at the centre of mass, and both move with V. This is called **perfectly
# inelastic**.
#
# Write V. Replace the three dots and run the cell; it checks your line at once.


# %%
@gap("01-centre")
def centre_velocity(m1, v1, m2, v2):
    return ...


# %%
predict("01-stick")

# %% tags=["answer"]
# two carts that stick together
check("1 kg at 3 m/s meets 3 kg at -1 m/s", centre_velocity(1, 3, 3, -1), 0, 1e-15)
check("1 kg at 4 m/s meets 3 kg at rest", centre_velocity(1, 4, 3, 0), 1, 1e-15)
check("the course's own function", inelastic_1d(1, 4, 3, 0), (1, 1))

# %% [markdown]
# ## 3 If nothing is lost, V is a mirror
#
# Imagine that you sit on a seat that moves along with the centre of mass. From there you see the
# carts come in with velocities $v_1 - V$ and $v_2 - V$, and their momenta cancel. If no energy is
# lost, each cart leaves as fast as it came, in the opposite direction: $v' - V = -(v - V)$. Seen
# from the ground:
#
# $$v_1' = 2V - v_1 \qquad v_2' = 2V - v_2$$
#
# This is called **elastic**. Textbooks write the same thing as
# $v_1' = \frac{(m_1 - m_2) v_1 + 2 m_2 v_2}{m_1 + m_2}$.

# %%
predict("01-elastic")

# %% tags=["answer"]
# an elastic collision, as a picture
check("cart 1", elastic_1d(1, 2, 3, -1)[0], -2.5)
figures.before_and_after()

# %%
check("equal masses exchange velocities", elastic_1d(1, 3, 1, -1), (-1, 3))
textbook = ((1 - 3) * 2 + 2 * 3 * -2) / (1 + 3)
check("the textbook form agrees", elastic_1d(1, 2, 3, -2)[0], textbook, tolerance=1e-15)

# %% [markdown]
# ## 4 One number covers everything between
#
# Real carts neither stick nor bounce perfectly. From the seat you see each of them come back with
# a fraction e of its speed: $v' - V = -e\,(v - V)$. The number e is the **restitution**. With e =
# 1 the collision is elastic, with e = 0 perfectly inelastic. Chapter 02 is about this number.
#
# Write the velocity after, as seen from the ground. Here `v` is the velocity before, and `centre`
# is V.


# %%
@gap("01-sent-back")
def sent_back(v, centre, e):
    return ...


# %% [markdown]
# With your two lines you have a collision on a track, with every restitution:


# %%
def my_collision(m1, v1, m2, v2, e):
    centre = centre_velocity(m1, v1, m2, v2)
    return sent_back(v1, centre, e), sent_back(v2, centre, e)


for e in (0.0, 0.25, 0.5, 1.0):
    v1_after, v2_after = my_collision(1, 2, 3, -1, e)
    print(f"e = {e:4}: v1' = {v1_after:+.4f} m/s, v2' = {v2_after:+.4f} m/s")
check("e = 0 sticks", my_collision(1, 2, 3, -1, 0), inelastic_1d(1, 2, 3, -1), 1e-15)
check("e = 1 is elastic", my_collision(1, 2, 3, -1, 1), elastic_1d(1, 2, 3, -1), 1e-15)

# %% [markdown]
# The engine of this course computes the same in another order. Since $v_1 - V = w_2 (v_1 - v_2)$
# with $w_2 = m_2/(m_1 + m_2)$, it needs only the relative velocity. When you call `collide_1d`,
# its arguments are checked, and then these lines run. (`equation(f)` is f without that check.)

# %%
print(inspect.getsource(equation(collide_1d)).split('"""')[-1].strip("\n"))

# %%
predict("01-stops")

# %% tags=["answer"]
# e = 0.5, cart 2 at rest
check("cart 1 of 1 kg meets 2 kg", my_collision(1, 2, 2, 0, 0.5), (0, 1), 1e-15)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Cart 1 stops when $V = e\,(v_1 - V)$. With cart 2 at rest that is $m_1 = e\,m_2$. Try it: set the
# mass of cart 2 and the restitution below, and watch the first row "after".

# %% [markdown]
# Below you see both carts from the ground and from the centre of mass. Drag the tips of the
# velocities, or set numbers. Look at the two lower rows: what does e do to a velocity there, and
# what do the masses do?

# %%
live(
    "ch01_one_dimension/carts",
    "Two carts on a track, before and after they meet. Seen from the ground, cart 1 (1 kg) comes "
    "at +2 m/s and stops; cart 2 (1 kg) was at rest and goes on at +2 m/s. Seen from the centre of "
    "mass both come at 1 m/s and turn round. Below, the momenta tip to tail reach the same total "
    "before and after, and the bars of energy are equally long. You can drag the tips of the "
    "velocities and change both masses and the restitution, which is 1.",
)

# %% [markdown]
# ## 5 A wall is a cart of infinite mass
#
# A wall does not move when a ball hits it. The formula needs no special case for that: let $m_2$
# grow, and $w_2 = m_2/(m_1 + m_2)$ goes to 1. In Python, `math.inf` is a legal mass in every
# formula of this course, and means exactly that. Your own line would divide infinity by infinity
# there. `lesson_code` computes the share of cart 1 as $1/(1 + m_2/m_1)$, and $1/(1+\infty)$ is 0.

# %%
predict("01-wall-comes")

# %% tags=["answer"]
# a ball and a wall
check("a ball hits a wall that stands", elastic_1d(1, 3, inf, 0), (-3, 0))
check("a ball hits a wall that comes towards it", elastic_1d(1, 3, inf, -1), (-5, -1))

# %%
masses = np.array([1.0, 10.0, 1e3, 1e6])
towards_the_limit = elastic_1d(1, 3, masses, 0)[0]
print("v1' for growing m2:", np.round(towards_the_limit, 6))
check("the limit is the wall", towards_the_limit[-1], -3.0, tolerance=1e-5)

# %% [markdown]
# Two infinite masses have no answer, and a negative mass makes no sense. `lesson_code` refuses such
# input and gives the reason:

# %%
for bad in ((inf, 1, inf, -1), (-2, 1, 1, 0), (1, float("nan"), 1, 0)):
    try:
        elastic_1d(*bad)
    except ValueError as error:
        print(f"elastic_1d{bad}: {error}")

# %% [markdown]
# ## 6 Three judges that are not us
#
# Is the formula right? Do not take our word for it. Ask three judges: the two laws, on 10,000
# random pairs; exact arithmetic, which solves the equations of momentum and restitution in
# fractions, without rounding; and pymunk, a physics engine that we did not write. They judge your
# own collision beside ours.

# %%
rng = np.random.default_rng(seed=1)
m1, m2 = 10 ** rng.uniform(-3, 3, size=(2, 10_000))
v1, v2 = rng.uniform(0, 100, size=10_000), rng.uniform(-100, 0, size=10_000)
e = rng.uniform(0, 1, size=10_000)
u1, u2 = collide_1d(m1, v1, m2, v2, e)  # the velocities after
size = np.maximum(np.abs(v1), np.abs(v2))  # errors are measured against the larger speed

# %%
p_before, p_after = m1 * v1 + m2 * v2, m1 * u1 + m2 * u2
check("momentum is kept", (p_after - p_before) / ((m1 + m2) * size), 0, tolerance=1e-12)
lost = (m1 * v1**2 + m2 * v2**2 - m1 * u1**2 - m2 * u2**2) / 2
error = (lost - energy_lost_1d(m1, v1, m2, v2, e)) / ((m1 + m2) * size**2)
check("the energy lost is what chapter 02 says", error, 0, tolerance=1e-12)

# %%
pairs = list(zip(m1, v1, m2, v2, e, strict=True))
exact = np.array([[float(v) for v in two_body_exact(*pair)] for pair in pairs])
mine = np.transpose(my_collision(m1, v1, m2, v2, e))
check("v1' in exact fractions", (u1 - exact[:, 0]) / size, 0, tolerance=1e-12)
check("v2' in exact fractions", (u2 - exact[:, 1]) / size, 0, tolerance=1e-12)
check("and by your two lines", (mine - exact) / size[:, np.newaxis], 0, tolerance=1e-12)

# %%
engine = np.array([collide_on_a_line(*pair) for pair in pairs[:1000]])
check("v1' in pymunk", (u1[:1000] - engine[:, 0]) / size[:1000], 0, tolerance=1e-12)
check("v2' in pymunk", (u2[:1000] - engine[:, 1]) / size[:1000], 0, tolerance=1e-12)

# %% [markdown]
# ## 7 Break it on purpose: one factor too many
#
# The web lesson from which this course grew computes the impulse with 2(1 + e) instead of 1 + e.
# Somebody remembered the 2 of the elastic case *and* the 1 + e of the general one.

# %%
predict("01-blind")

# %% tags=["answer"]
# momentum and energy, with the factor doubled
p_before = momentum([1, 1], [(2, 0), (-2, 0)])
for e in (0.0, 0.5, 0.8, 1.0):
    u1, u2 = doubled_impulse(1, 2, 1, -2, e)
    p_after = momentum([1, 1], [(u1, 0), (u2, 0)])
    energy_ratio = (u1**2 + u2**2) / (2**2 + 2**2)
    print(f"e = {e}: momentum {p_before[0]} -> {p_after[0]}, ", end="")
    print(f"energy times {energy_ratio:.2f}, right {e**2:.2f}")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Even with e = 0, where the carts should stop, all of the energy comes back. With e = 1 there is
# nine times as much as before. In the demo of that lesson the energy grew without end.

# %% [markdown]
# This is why every check in this course uses more than one law. Other wrong formulas pass the
# energy and fail the momentum, or fail both:

# %%
for model in (wrong.always_swaps, wrong.target_at_rest, wrong.both_turn_round):
    u1, u2 = model(1.0, 2.0, 3.0, -1.0)
    p, energy = u1 + 3 * u2, (u1**2 + 3 * u2**2) / 2
    print(f"{model.name:16} momentum -1 -> {p:+.1f} kg m/s, energy 3.5 -> {energy:.1f} J")

# %%
figures.two_laws()

# %% [markdown]
# ## 8 Quiz

# %%
show_quiz("01")

# %% [markdown]
# ## 9 Key takeaways
#
# - Two bodies hand the same impulse J to each other, in opposite directions. So momentum is kept,
#   whatever J is.
# - The change of velocity is J/m. The heavier body changes less.
# - Seen from the centre of mass, a collision turns each velocity round and multiplies it by e.
# - An infinite mass is a wall, and needs no special case.
# - One law is not enough to find a fault: ask momentum *and* energy.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** 10,000 random pairs with masses from 1 g to 1,000 kg, against momentum, energy
# and exact fractions; 1,000 of them against pymunk; all to 1e-12 of the larger speed. The
# infinite mass is exact.
#
# **Limits.** The formulas do not ask *whether* the carts meet. Two carts that move apart get an
# answer too, and it means nothing. Detection has to find out first who meets whom.
#
# **Do now:** the exercise [01 One dimension](../exercises/01_one_dimension.ipynb): three tasks,
# ten points. In a terminal, `workbook watch 01` runs it again whenever you save. To see momentum
# run down a row of balls, open `workbook play cradle`; its challenge is
# [exercises/cradle.py](../exercises/cradle.py). **Next:** [02 Restitution](02_restitution.ipynb).
#
# **Sources.** Goldstein, Poole and Safko, *Classical Mechanics*, 3rd edition, section 3.11
# (collisions seen from the centre of mass).
