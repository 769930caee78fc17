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
# Two carts on a track. They can only move left and right, so a velocity is a single number:
# positive to the right, negative to the left. Everything about impulses can be seen here without
# a single vector.
#
# **After this notebook you will be able to**
#
# 1. compute both velocities after a collision that is elastic, perfectly inelastic or anything
#    between;
# 2. say why the heavier body changes its velocity less, and what happens when one mass is
#    infinite;
# 3. find a wrong collision formula by asking it about momentum and energy.
#
# **You need** notebook 00. **Time:** about 40 minutes to read, a few seconds to run.

# %%
import inspect
from math import inf

import numpy as np

from lesson_code.chapters.ch01_one_dimension import wrong_answers as wrong
from lesson_code.course.quiz.notebook import show_quiz
from lesson_code.evidence import check
from lesson_code.formulas import collide_1d, elastic_1d, inelastic_1d, momentum
from lesson_code.formulas.restitution import energy_lost_1d
from lesson_code.formulas.validation import equation
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

# %% [markdown]
# ## 1 A collision hands momentum over; it makes none
#
# While two carts touch, cart 1 pushes cart 2 and cart 2 pushes cart 1 back, just as hard, for
# just as long. The push added up over time is the **impulse** J. Cart 2 receives +J and cart 1
# receives -J:
#
# $$m_1 v_1' = m_1 v_1 - J \qquad m_2 v_2' = m_2 v_2 + J$$
#
# Add the two lines. J drops out. The total momentum $m_1 v_1 + m_2 v_2$ is the same before and
# after, whatever J is.
#
# Divide each line by its mass: $v' = v \pm J/m$. The impulse is the same for both, but the
# *change of velocity* is J/m. A cart with three times the mass changes its velocity by a third as
# much, and the other way.

# %%
m1, v1, m2, v2 = 1.0, 2.0, 3.0, -2.0
impulse = 3.0
v1_after, v2_after = v1 - impulse / m1, v2 + impulse / m2
check("momentum before", m1 * v1 + m2 * v2, -4.0)
check("momentum after any impulse", m1 * v1_after + m2 * v2_after, -4.0)
check("cart 1 changes three times as much", (v1_after - v1) / (v2_after - v2), -3.0)

# %% [markdown]
# So momentum alone does not decide what happens. Every impulse keeps it. We need one more piece
# of information: what do the bodies do with the energy of the impact?
#
# ## 2 If they stick, they go on with the centre of mass
#
# The centre of mass of the pair moves with velocity
#
# $$V = w_1 v_1 + w_2 v_2, \qquad w_1 = \frac{m_1}{m_1 + m_2}, \quad w_2 = \frac{m_2}{m_1 + m_2}.$$
#
# V is the total momentum divided by the total mass, so a collision cannot change it. If the carts
# stick together, both *are* at the centre of mass, and both move with V. This is called
# **perfectly inelastic**.
#
# **Predict** the common velocity for a cart of 1 kg at 3 m/s that meets a cart of 3 kg at -1 m/s.

# %%
check("1 kg at 3 m/s meets 3 kg at -1 m/s", inelastic_1d(1, 3, 3, -1), (0, 0))
check("1 kg at 4 m/s meets 3 kg at rest", inelastic_1d(1, 4, 3, 0), (1, 1))

# %% [markdown]
# ## 3 If nothing is lost, each velocity is mirrored at V
#
# Watch the collision from a seat that moves along with the centre of mass. From there the carts
# come in with velocities $v_1 - V$ and $v_2 - V$, and their momenta cancel. If no energy is lost
# they go out as fast as they came in, each turned round: $v' - V = -(v - V)$. Back on the ground:
#
# $$v_1' = 2V - v_1 \qquad v_2' = 2V - v_2$$
#
# This is called **elastic**. The textbook form of the same thing is $v_1' = \frac{(m_1 - m_2) v_1
# + 2 m_2 v_2}{m_1 + m_2}$.

# %%
check("equal masses exchange velocities", elastic_1d(1, 3, 1, -1), (-1, 3))
textbook = ((1 - 3) * 2 + 2 * 3 * -2) / (1 + 3)
check("the textbook form agrees", elastic_1d(1, 2, 3, -2)[0], textbook, tolerance=1e-15)

# %%
before, after = (2.0, -1.0), elastic_1d(1, 2, 3, -1)
fig, ax = style.figure(width=6.4, height=2.8)
plots.carts(ax, 1, [before, after], 3, ["before", "after an elastic collision"])
show(
    fig,
    "Two carts. Before: cart 1 (1 kg) at +2 m/s, cart 2 (3 kg) at -1 m/s. After: cart 1 at "
    "-2.5 m/s, cart 2 at +0.5 m/s.",
)

# %% [markdown]
# ## 4 One equation holds everything between
#
# Real carts lie between sticking and elastic. Seen from the centre of mass, each comes back with
# a part e of its speed:
#
# $$v_1' = V - e\,(v_1 - V) \qquad v_2' = V - e\,(v_2 - V)$$
#
# The number e is the **restitution**. With e = 1 the collision is elastic, with e = 0 perfectly
# inelastic. Chapter 02 is about this number. Since $v_1 - V = w_2 (v_1 - v_2)$, the program needs
# only a few lines. These are the lines that run when you call `collide_1d`:

# %%
print(inspect.getsource(equation(collide_1d)).split('"""')[-1].strip("\n"))

# %%
for e in (0.0, 0.25, 0.5, 1.0):
    v1_after, v2_after = collide_1d(1, 2, 3, -1, restitution=e)
    print(f"e = {e:4}: v1' = {v1_after:+.4f} m/s, v2' = {v2_after:+.4f} m/s")
check("e = 0 sticks", collide_1d(1, 2, 3, -1, 0), inelastic_1d(1, 2, 3, -1))
check("e = 1 is elastic", collide_1d(1, 2, 3, -1, 1), elastic_1d(1, 2, 3, -1))

# %% [markdown]
# Here both carts are seen from the ground and from the centre of mass. Drag the tips of the
# velocities, or set numbers. **Predict first:** for which mass of cart 2 does cart 1 stop dead when
# e = 1 and cart 2 is at rest? And when e = 0.5? Then watch the lower rows: what does e do to a
# velocity there, and what do the masses do?

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
# ## 5 The ground is a body of infinite mass
#
# A wall does not move when a ball hits it. The formula needs no special case for that: let $m_2$
# grow, and $w_1 = m_1/(m_1 + m_2)$ goes to 0 and $w_2$ to 1. In Python, `math.inf` is a legal
# mass in every formula of this course, and means exactly that. `lesson_code` computes $w_1$ as
# $1/(1 + m_2/m_1)$, which is right for infinite masses too: $1/(1+\infty) = 0$.

# %%
check("a ball hits a wall", elastic_1d(1, 3, inf, 0), (-3, 0))
check("a ball hits a wall that comes towards it", elastic_1d(1, 3, inf, -1), (-5, -1))
masses = np.array([1.0, 10.0, 1e3, 1e6])
towards_the_limit = elastic_1d(1, 3, masses, 0)[0]
print("v1' for growing m2:", np.round(towards_the_limit, 6))
check("the limit is the wall", towards_the_limit[-1], -3.0, tolerance=1e-5)

# %% [markdown]
# Two infinite masses have no answer, and neither has a negative mass. Such input is refused, with
# the reason:

# %%
for bad in ((inf, 1, inf, -1), (-2, 1, 1, 0), (1, float("nan"), 1, 0)):
    try:
        elastic_1d(*bad)
    except ValueError as error:
        print(f"elastic_1d{bad}: {error}")

# %% [markdown]
# ## 6 Three judges that are not us
#
# Is our formula right? We ask the two laws, on 10,000 random pairs. Then we ask exact arithmetic:
# the same collision as two linear equations, solved in fractions without any rounding. Then we
# ask pymunk, a physics engine.

# %%
from lesson_code.reference.closed_forms import two_body_exact
from lesson_code.reference.pymunk_reference import collide_on_a_line

rng = np.random.default_rng(seed=1)
m1, m2 = 10 ** rng.uniform(-3, 3, size=(2, 10_000))
v1, v2 = rng.uniform(0, 100, size=10_000), rng.uniform(-100, 0, size=10_000)
e = rng.uniform(0, 1, size=10_000)
w1, w2 = collide_1d(m1, v1, m2, v2, e)
size = np.maximum(np.abs(v1), np.abs(v2))  # errors are measured against the larger speed

# %%
p_before, p_after = m1 * v1 + m2 * v2, m1 * w1 + m2 * w2
check("momentum is kept", (p_after - p_before) / ((m1 + m2) * size), 0, tolerance=1e-12)
lost = (m1 * v1**2 + m2 * v2**2 - m1 * w1**2 - m2 * w2**2) / 2
error = (lost - energy_lost_1d(m1, v1, m2, v2, e)) / ((m1 + m2) * size**2)
check("the energy lost is what chapter 02 says", error, 0, tolerance=1e-12)

# %%
pairs = list(zip(m1, v1, m2, v2, e, strict=True))
exact = np.array([[float(v) for v in two_body_exact(*pair)] for pair in pairs])
check("v1' in exact fractions", (w1 - exact[:, 0]) / size, 0, tolerance=1e-12)
check("v2' in exact fractions", (w2 - exact[:, 1]) / size, 0, tolerance=1e-12)

# %%
engine = np.array([collide_on_a_line(*pair) for pair in pairs[:1000]])
check("v1' in pymunk", (w1[:1000] - engine[:, 0]) / size[:1000], 0, tolerance=1e-12)
check("v2' in pymunk", (w2[:1000] - engine[:, 1]) / size[:1000], 0, tolerance=1e-12)

# %% [markdown]
# ## 7 Break it on purpose: one factor too many
#
# Here is the impulse as the web lesson had it, with 2(1 + e) where 1 + e belongs. Somebody
# remembered the 2 of the elastic case *and* the 1 + e of the general one. **Predict:** which of
# the two laws will notice?

# %%
from lesson_code.chapters.ch02_restitution.wrong_answers import doubled_impulse

print("The misconception:", doubled_impulse.misconception)
p_before = momentum([1, 1], [(2, 0), (-2, 0)])
for e in (0.0, 0.5, 0.8, 1.0):
    w1, w2 = doubled_impulse(1, 2, 1, -2, e)
    p_after = momentum([1, 1], [(w1, 0), (w2, 0)])
    energy_ratio = (w1**2 + w2**2) / (2**2 + 2**2)
    print(f"e = {e}: momentum {p_before[0]} -> {p_after[0]}, ", end="")
    print(f"energy times {energy_ratio:.2f}, right {e**2:.2f}")

# %% [markdown]
# Momentum is blind to this fault: *any* impulse keeps momentum. The energy sees it at once. Even
# with e = 0, where the carts should stop, all of the energy comes back; with e = 1 there is nine
# times as much as before. In the web lesson's demo the energy grew without end.
#
# This is why every check in this course uses more than one law. Other wrong formulas are caught
# by the other law:

# %%
for model in (wrong.always_swaps, wrong.target_at_rest, wrong.both_turn_round):
    w1, w2 = model(1.0, 2.0, 3.0, -1.0)
    p, energy = w1 + 3 * w2, (w1**2 + 3 * w2**2) / 2
    print(f"{model.name:16} momentum -1 -> {p:+.1f} kg m/s, energy 3.5 -> {energy:.1f} J")

# %%
cases = ["right", "impulse doubled", "always swaps"]
answers = [
    elastic_1d(1, 2, 3, -1),
    doubled_impulse(1, 2, 3, -1, 1.0),
    wrong.always_swaps(1, 2, 3, -1),
]
momenta = [(a, 3 * b) for a, b in answers]
energies = [(a**2 / 2, 3 * b**2 / 2) for a, b in answers]

# %%
fig, (left, right) = style.figure(2, width=10.5, height=3.6)
plots.before_and_after(left, cases, [(2, -3)] * 3, momenta, "momentum, kg m/s")
plots.before_and_after(right, cases, [(2, 1.5)] * 3, energies, "energy, J")
left.get_legend().remove()
show(
    fig,
    "Momentum and energy of a pair before and after, for the right formula and two wrong ones. "
    "The doubled impulse keeps the momentum but multiplies the energy; the swap keeps neither.",
)

# %% [markdown]
# ## 8 Quiz

# %%
show_quiz("01")

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** 10,000 random pairs with masses from 1 g to 1,000 kg, against momentum, energy
# and exact fractions; 1,000 of them against pymunk; all to 1e-12 of the larger speed. The
# infinite mass is exact.
#
# **Limits.** The formulas do not ask *whether* the carts meet. Two carts that move apart get an
# answer too, and it means nothing. Finding out who meets whom is the detection's job.
#
# **Do now:** the exercise [01 One dimension](../exercises/01_one_dimension.ipynb): three tasks,
# ten points. **Next:** [02 Restitution](02_restitution.ipynb).
#
# **Sources.** Goldstein, Poole and Safko, *Classical Mechanics*, 3rd edition, section 3.11
# (collisions seen from the centre of mass).
