# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 08 What accuracy costs
#
# The ball on your screen is never quite where it should be, and putting it right costs computing
# time. Here you pay for one millimetre: with a solver that you write, with ours and with pymunk.
#
# **After this notebook you will be able to**
#
# 1. say in one number how wrong a simulation is, and what half the step does to it;
# 2. work out what a millimetre costs before you pay for it;
# 3. choose a method and its setting.
#
# **You need** notebooks 00 to 07. **Time:** about 40 minutes with the questions; it runs in ten
# seconds.

# %% tags=["plumbing"]
from functools import partial

import numpy as np

from lesson_code import simulate
from lesson_code.chapters.ch08_what_accuracy_costs import figures
from lesson_code.chapters.ch08_what_accuracy_costs.prices import milliseconds
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check
from lesson_code.evidence import work_precision as wp
from lesson_code.evidence.scenes import events, rigid_bodies
from lesson_code.view.browser.live import live

# %% [markdown]
# ## 1 Your own solver, and its error in one number
#
# A ball flies in the box of chapter 07, whose formula knows its place at any time. So you can catch
# every program that gets it wrong, your own first. A step moves the ball along one axis. If it is
# then beyond the wall at `low` or `high`, and *still on its way out*, turn its velocity round.
# Return x and v; leave x where it is.


# %%
@gap("08-step")
def step(x, v, dt, low, high):
    x = x + v * dt
    return ...


# %%
(width, height), r = events.BOX, events.BALL_RADIUS


def my_places(rate):
    (x, y), (vx, vy) = events.BALL_START, events.BALL_VELOCITY
    places = [(x, y)]
    for n in range(1, 10 * rate + 1):
        x, vx = step(x, vx, 1 / rate, r, width - r)
        y, vy = step(y, vy, 1 / rate, r, height - r)
        if n % (rate // 10) == 0:
            places.append((x, y))
    return np.array(places)


# %% [markdown]
# In 10 s you look at 101 places: 101 errors. To compare programs you need *one* number. A rule that
# makes one number of many is called a **norm**. Ours is the largest distance from the right place.
# A mean would hide a bad moment; a single time may be a lucky one.

# %%
predict("08-jumps")

# %% tags=["answer"]
# ten seconds of your ball
times = np.linspace(0, 10, 101)
right = events.places_in_the_box(times)
off = np.hypot(*(my_places(120) - right).T)
print(f"largest {off.max():.3f} m, mean {off.mean():.3f} m, after 8.8 s {off[88]:.3f} m")
figures.staircase(times, off)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# In jumps. In a dip your ball and the right one fly towards each other: only one of them has turned
# round. Look after 8.8 s alone, and you seem three times as good as you are.

# %% [markdown]
# ## 2 What a shorter step buys
#
# You could just make the step shorter. How much better is that? If errors follow a power of dt,
#
# $$E = C\,dt^{\,p} \qquad\Longrightarrow\qquad \ln E = \ln C + p\,\ln dt,$$
#
# then p is the **order** of the method: a slope, on axes in powers of ten. Two errors tell you p.
# Write it; `math.log` is the natural logarithm.


# %%
@gap("08-order-of")
def order_of(dt_1, error_1, dt_2, error_2):
    return ...


# %%
predict("08-halved")

# %% tags=["answer"]
# the errors of your solver
rates = [30, 60, 120, 240, 480, 960]
errors = [float(np.hypot(*(my_places(rate) - right).T).max()) for rate in rates]
for rate, error in zip(rates, errors, strict=True):
    print(f"{rate:4} steps a second: {error:.4f} m")
print(f"order, first to last: {order_of(1 / 30, errors[0], 1 / 960, errors[-1]):.2f}")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Half the step, half the error, on the whole. But from 240 to 480 steps you gain nothing: where in
# its step an impact falls is chance. So fit the slope through *all* errors, by least squares. (The
# last number says by which factor an error typically lies off the line.)

# %% tags=["answer"]
# the slope through all errors
fit = wp.fit_order([1 / rate for rate in rates], errors)
print(f"order {fit}")
check("first order", fit.order, 1, tolerance=0.25)
figures.your_errors(rates, errors, fit)

# %% [markdown]
# ## 3 Why: you see every impact late
#
# You look for the wall at the ends of steps only. If the ball met it a time $\tau$ before the end,
# it is too deep by $v\tau$ when you turn it round. By then it should be back on the other side, at
# e times its speed. By how much is it wrong from then on?


# %%
@gap("08-late")
def late_by(e, v, tau):
    return ...


# %% [markdown]
# On average $\tau$ is dt/2. Half the step, half the delay: that is order 1. Test your law on your
# solver, at ten moments of a step:

# %%
dt, phases = 1 / 50, np.arange(0.05, 1, 0.1)


def wrong_by(phase):
    x, v = -(10 + phase) * dt, 1.0  # at the wall, x = 0, after ten steps and a part of one
    for _ in range(50):
        x, v = step(x, v, dt, -9.0, 0.0)
    return x - ((10 + phase) * dt - 1)  # less the right place after 1 s


law = [late_by(1.0, 1.0, (1 - phase) * dt) for phase in phases]
check("your law, at ten phases, m", [wrong_by(phase) for phase in phases], law, tolerance=1e-12)

# %% [markdown]
# ## 4 Pay for your millimetre
#
# Name the price before you pay. For an error k times smaller you need $k^{1/p}$ times as many
# steps, and that much more time.

# %%
predict("08-millimetre")

# %% tags=["answer"]
# errors at four rates
for rate in (5_000, 10_000, 20_000, 40_000):
    error = np.hypot(*(my_places(rate) - right).T).max()
    print(f"{rate:6,} steps a second: {1000 * error:.2f} mm")
enough = 20_000

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# At 20,000 steps a second you have your millimetre.

# %% [markdown]
# Do engines, which share no line with you, need fewer steps? Compare where they put the ball:

# %%
box = events.ball_in_a_box()
for solver in ("sequential", "pymunk"):
    run = simulate(box, 10, solver=solver, dt=1 / 120, sample=times)
    apart = run.positions[:, events.WALLS] - my_places(120)
    check(f"{solver} and you, m", apart, 0, tolerance=1e-12)
run = simulate(box, 10, solver="exact", sample=times)
check("exact: error, m", events.error_in_the_box(run), 0, tolerance=1e-13)

# %% [markdown]
# Both engines make *your* error: the step errs, not the solver. So they need as many steps as you
# for this millimetre. Only chapter 07's exact solver has no step, and no error. What differs is the
# time, here that of your own machine:

# %% tags=["nbval-ignore-output"]
programs = {"yours": partial(my_places, enough)}
for solver in ("sequential", "pymunk", "exact"):
    programs[solver] = partial(simulate, box, 10, solver=solver, dt=1 / enough, sample="end")
for name, ms in milliseconds(programs).items():
    print(f"{name:10}: {ms:7.1f} ms")

# %% [markdown]
# Yours is fast because it knows one ball and four walls, and nothing else. pymunk looks for
# contacts of any shapes, in C; "sequential", our engine, does so in Python.
#
# ## 5 A map of prices
#
# To choose, you need more prices than these. The next figure is a map of them. Each point is a
# method at one setting. **Down and left is better.** Besides those that you know there are *naive*,
# the first attempt of chapter 04; *substep*, with short steps and springs in its contacts (section
# 6); *direct*, which ends its steps where bodies touch (chapter 09); and Box2D, another engine in
# C. Ours run in plain Python or compiled to machine code. All ran the same scene in turns, without
# drawing (`workbook measure accuracy`), and the right answer comes from none of them.

# %% tags=["plumbing"]
result = wp.stored()
figures.map_of_prices(result)

# %% [markdown]
# Go *along* a line, and the step gets shorter. The gap between two parallel lines is a factor in
# time: that is what plain Python costs. An arrow downwards names an error that lies below the
# figure. A **cross** is a failure. Leave those out, and every method looks good.
#
# ## 6 A tower: how to spend a hundred sweeps
#
# The exact solver *refuses* a tower: boxes at rest touch all the time, so there is no next
# collision. Engines make **sweeps** over its contacts instead. You can cut a step into
# **sub-steps**, each with its own **iterations**; their product is the number of sweeps. How would
# you split a hundred?

# %%
predict("08-split")

# %% tags=["answer", "plumbing"]
# both towers
figures.towers(result, 100)
springs = wp.splits(result, "stack of 20", 100)["substep"]
best = min(springs, key=lambda point: point.error)
check("with springs, best in this many sub-steps", best.substeps, 1)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# Two methods want as many sub-steps as they can get: what a sweep leaves over moves the boxes only
# for a short time. "substep" holds the boxes apart by springs, and makes them stiffer the more
# sweeps follow each motion. It sweeps twice in an iteration, before the motion and after it, so 50
# iterations make the hundred. **For the stack one step with 50 is its best**; in 25 sub-steps with
# two each the stack falls. The heavy box wants the opposite: short sub-steps stiffen springs, too.

# %% [markdown]
# ## 7 How wrong may it be?
#
# "How accurate is this program?" has no answer. Ask how wrong it may be; then look for the longest
# step that is good enough. A step counts only if all *shorter* ones are good enough too: section 2
# showed you what luck can do.
#
# One method in this figure is new: it ends a step where an impact falls. In which scenes will that
# help? A fall is late even without an impact, by g t dt/2, because an engine moves a body first and
# accelerates it afterwards. Choose, then drag the line.

# %%
live(
    "ch08_what_accuracy_costs/how_wrong",
    "On the left the height of a ball that bounces, at 20 steps a second, beside the right curve: "
    "it is late, and later at each bounce. On the right the largest error of three methods over "
    "the steps a second, in powers of ten; a dashed line, which can be dragged, says how wrong it "
    "may be, and rings mark the first step of each method that is good enough. Scene, method and "
    "step can be chosen.",
)

# %% [markdown]
# Between the walls, steps that end at impacts stay wrong by 1 cm, however short they are: the
# engine lets a ball a few millimetres into a wall before it calls that a contact.
#
# Now buy. Here is the cheapest millimetre of each scene:

# %%
for name in result.scenes:
    print(f"{name}: {wp.in_words(wp.cheapest(result, name, 1e-3))}")

# %% [markdown]
# **Which do you choose?** Take the exact solver where a formula describes the flight between
# collisions, and sweeps in many sub-steps in a pile. Sixty cheap steps a second are enough where
# nobody sees the difference (half a picture late is no fault in a game), where nobody can know
# better (a gas is chaotic), or where you know e only to a few parts in a hundred. But where one
# body rests on another, a small error in *every* step adds up until the tower falls.
#
# ## 8 Break it on purpose: a method that judges itself
#
# Often you have no right answer, so you take your finest run for one. Try that on the naive solver,
# which has no friction. A disc slides at 3 m/s; it should begin to roll.

# %%
predict("08-own-judge-first")

# %% tags=["answer"]
# off itself, and off the truth
disc = rigid_bodies.sliding_disc(3.0, friction=0.2)
ends = {}
for rate in (30, 60, 120, 3840):
    run = simulate(disc, 1, dt=1 / rate, solver="naive", sample="end")
    ends[rate] = run.positions[-1, 1, 0]
truth = 3 * 0.5 - 2 * 0.5**2 / 2 + 2 * 0.5  # it slides for 0.5 s, then rolls at 2 m/s
for rate in (30, 60, 120):
    own, true = abs(ends[rate] - ends[3840]), abs(ends[rate] - truth)
    print(f"{rate:3} steps a second: off its own finest by {own:.4f} m, off the truth {true:.3f} m")

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# The method agrees with itself. The error stays, however short the step: **order 0**. A rule is
# missing.

# %% [markdown]
# A program that converges solves *some* problem ever better. Only an answer from elsewhere can say
# whether it is yours: a closed form, a conserved quantity, another program.
#
# ## 9 Quiz

# %%
show_quiz("08")

# %% [markdown]
# ## Key takeaways
#
# - Say which number is the error before you compare: the largest distance, at many times.
# - A program that looks at the ends of steps sees impacts late: half the step, half the error. That
#   is the first order.
# - A millimetre has a price that you can work out: a tenth of the error, ten times the time.
# - The exact solver has no such error, but needs a formula; a tower needs many short sub-steps.
# - First ask what is good enough, then what is cheapest. Never let a method be its own judge.

# %% [markdown]
# ## 10 Appendix: the whole map
#
# Look up a price in seven scenes. In the two piles, the settings are splits of sweeps.

# %% tags=["plumbing"]
figures.whole_map(result)

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** your solver against two engines, to 1e-12 m; its first order; your law of the
# late impact; the exact solver in the box.
#
# **Limits.** Stored times are those of one machine, which did other work too at times: believe
# factors of two, not tenths.
#
# **Do now:** the exercise [08 What accuracy costs](../exercises/08_what_accuracy_costs.ipynb): five
# tasks, twenty points. `workbook watch` checks it whenever you save. `workbook play soft_body`
# moves rings of masses and springs; its challenge,
# [exercises/soft_body.py](../exercises/soft_body.py), asks for a stepped solver again. **Next:**
# [09 Hard cases](09_hard_cases.ipynb): scenes in which engines fall over, and what holds them up.
#
# **Sources.** Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I* (2nd edition,
# 1993): orders. Macklin and others, *Small Steps in Physics Simulation* (2019): sub-steps. Catto,
# *Solver2D* (2024): solvers at equal work.
