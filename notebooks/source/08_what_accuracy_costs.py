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
# How far off is a simulation, and what would it cost you to halve that? Every step takes time, and
# every shorter step buys accuracy. Here you find the price of a millimetre, and learn when not to
# pay it.
#
# **After this notebook you will be able to**
#
# 1. measure how wrong a simulation is, in one number, and what halving the step does to it;
# 2. say what a shorter step, more iterations and more sub-steps buy, each in its place;
# 3. choose the method and the setting that are good enough, and know their price.
#
# **You need** notebooks 00 to 07. **Time:** about 40 minutes to read and to write two lines,
# ten seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Body, Circle, Scene, Segment, simulate
from lesson_code.chapters.ch08_what_accuracy_costs import figures as precision_plots
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check, hard_cases
from lesson_code.evidence import work_precision as wp
from lesson_code.evidence.scenes import events as exact_scenes

# %% tags=["plumbing"]
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.reference.rigid_body_closed_forms import rolling_begins
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

# %% [markdown]
# ## 1 An error is one number
#
# In the box of chapter 07 you know where the ball should be at each time. So a run has as many
# errors as it has times, and to compare two runs you need *one* number. A rule that makes one
# number of many is called a **norm**. Ours is the largest distance:
#
# $$E = \max_k\; \lvert\, p(t_k) - p_{\text{right}}(t_k)\,\rvert$$

# %%
predict("08-jumps")

# %% tags=["answer"]
# ten seconds of a ball in a box
times = np.linspace(0, 10, 101)
scene = exact_scenes.ball_in_a_box()
run = simulate(scene, 10, solver="pymunk", dt=1 / 120, sample=times)
off = exact_scenes.error_in_the_box(run)
print(f"largest {off.max():.3f} m, mean {off.mean():.3f} m, after 8.8 s {off[88]:.3f} m")

# %% tags=["answer", "plumbing"]
# ten seconds of a ball in a box
fig, ax = style.figure(width=7, height=2.8)
plots.curves(ax, {"": (times, off)}, "time, s", "distance from the right place, m")
show(
    fig,
    "Distance of the stepped ball from its right place over ten seconds: a staircase of six steps "
    "up to 0.16 m, level in between, with two short dips at steps.",
)

# %% [markdown]
# In the dips one of the two balls has turned round and the other one has not yet: they fly towards
# each other. Look after 8.8 s alone, and the program seems three times as good as it is. The mean
# would hide a bad moment, too.
#
# ## 2 Half the step, half the error
#
# Make the step half as long, again and again. If the error follows a power of the step,
#
# $$E = C\,dt^{\,p} \qquad\Longrightarrow\qquad \ln E = \ln C + p\,\ln dt,$$
#
# the exponent p is called the **order** of the method. On axes in powers of ten it is the slope of
# a straight line. Two errors are enough to see it. Write it; `math.log` is the natural logarithm.


# %%
@gap("08-order-of")
def order_of(dt_1, error_1, dt_2, error_2):
    return ...


# %%
predict("08-halved")

# %% tags=["answer"]
# the errors of two programs
rates = np.array([30, 60, 120, 240, 480, 960])
found = {}
for solver in ("pymunk", "sequential"):
    runs = [simulate(scene, 10, solver=solver, dt=1 / r, sample=times) for r in rates.tolist()]
    found[solver] = [float(exact_scenes.error_in_the_box(run).max()) for run in runs]
for rate, one, other in zip(rates.tolist(), *found.values(), strict=True):
    print(f"{rate:4} steps a second: pymunk {one:.4f} m, ours {other:.4f} m")
first, last = found["pymunk"][0], found["pymunk"][-1]
print(f"order from the first and the last: {order_of(1 / 30, first, 1 / 960, last):.2f}")

# %% [markdown]
# The two programs share no line of code, and their errors agree to the last digit shown. So the
# *solver* makes no error here. The step does.
#
# One halving tells you little: from 240 to 480 you gain nothing, and before that more than a half,
# for chance decides where in its step an impact falls. So fit the slope through all points, and say
# in which range you did.

# %%
steps = (1 / rates).tolist()
fits = {solver: wp.fit_order(steps, errors) for solver, errors in found.items()}
for solver, fit in fits.items():
    print(f"{solver}: order {fit}")
check("first order", [fit.order for fit in fits.values()], 1, tolerance=0.25)

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=3.2)
precision_plots.errors_over_steps(ax, steps, {"pymunk": found["pymunk"]}, fits)
show(
    fig,
    "Error of pymunk over the length of the step, both axes in powers of ten. Six dots fall from "
    "0.6 m at a thirtieth of a second to a hundredth of a metre, about a straight line of slope 1.",
)

# %% [markdown]
# ## 3 Where the error comes from
#
# An engine that steps looks for overlaps at the ends of steps. If the ball has reached the wall a
# time $\tau$ before the end, it is by $v\tau$ too deep when the engine turns it round. By then it
# should be back on the other side, at e times its speed. By how much is it wrong from then on?


# %%
@gap("08-late")
def late_by(e, v, tau):
    return ...


# %% [markdown]
# Where in the step the impact falls is chance, $0 < \tau \le dt$, so $\tau$ is dt/2 on average.
# Half the step, half the delay: the order is 1. Let a ball of 1 m/s hit a wall, starting a little
# further away each time.

# %%
ball, wall = Circle(0.5), Body(Segment((0, -1), (0, 1)), material=exact_scenes.ELASTIC)


def late(gap, dt):
    """Return by how much a ball is wrong after one bounce that is due after `gap` metres."""
    coming = {"position": (-0.5 - gap, 0), "velocity": (1, 0), "material": exact_scenes.ELASTIC}
    run = simulate(
        Scene([wall, Body(ball, mass=1.0, **coming)]), 1, dt=dt, sample="end", solver="sequential"
    )
    return run.positions[-1, 1, 0] - (-0.5 - (1 - gap))


# %%
dt, phases = 1 / 50, np.arange(0.05, 1, 0.1)
errors = [late(0.5 + phase * dt, dt) for phase in phases.tolist()]
law = [late_by(1.0, 1.0, (1 - phase) * dt) for phase in phases.tolist()]
check("your law, at ten phases, m", errors, law, tolerance=1e-12)
check("their mean: v dt, m", np.mean(errors), dt, tolerance=1e-12)

# %% [markdown]
# A fall is wrong even without an impact. In each step the engine moves the body with *one*
# velocity, and accelerates it after that. So the body is always a little too slow.

# %%
predict("08-fall")

# %% tags=["answer"]
# a fall of one second
falling = Scene([Body(ball, mass=1.0, position=(0, 0))], gravity=(0, -10))
for solver in ("pymunk", "sequential"):
    run = simulate(falling, 1, dt=1 / 60, solver=solver, sample="end")
    check(f"{solver}: too high by g t dt / 2, m", run.positions[-1, 0, 1] + 5, 5 / 60, 1e-12)
run = simulate(falling, 1, solver="exact", sample="end")
check("exact: too high by, m", run.positions[-1, 0, 1] + 5, 0, tolerance=1e-15)

# %% [markdown]
# Better rules for the fall exist. They would not help: at the first impact the first order is back.
#
# ## 4 The price of a millimetre
#
# Now the price. `workbook measure accuracy` runs seven scenes with known answers by seven methods,
# each at many settings. It takes minutes, so you look at a stored result. Each point is one method
# at one setting: its error upwards, its computing time to the right. **Down and left is better.**
# Nobody is favoured: the same scene, an answer that no method has given, no drawing, no first run;
# all take turns, seven times, and the shortest time counts.

# %% tags=["plumbing"]
result = wp.stored()
fig, ax = style.figure(width=9, height=3.8)
precision_plots.work_precision(ax, result, "ball in a box")
precision_plots.legend_beside(ax, result.of("ball in a box"))
show(
    fig,
    "Error against time for the ball in a box, both axes in powers of ten. The lines of methods "
    "that step run down to the right. Those in plain Python lie parallel to the compiled ones, "
    "further to the right. The exact solver stands alone at the lower edge, on the left. Grey "
    "crosses at the upper edge are the naive solver's failures.",
)

# %% [markdown]
# *Along* a line the step gets shorter. *Parallel* lines have the same order; the gap between them
# is a factor in time. Plain Python and compiled code run one program here, and err alike to the
# last bit: what lies between them is the price of the language. C is pymunk's and Box2D's. A
# **cross** is a failure: the naive solver treats a wall as a ball at its middle, and loses the
# ball.
#
# Far below all others lies the **exact** solver, which has no step. How long would pymunk take for
# its accuracy? An error that is k times smaller needs $k^{1/p}$ times as many steps, and so much
# more time.

# %%
predict("08-millionth")

# %% tags=["answer"]
# times at the order of each scene
for name in ("ball in a box", "drop", "slide to roll", "gas", "pi blocks"):
    (exact,), finest = result.lines(name)["exact", "Python"], result.lines(name)["pymunk", "C"][-1]
    p = wp.orders(result, name)["pymunk", "C"].order
    hours = finest.seconds * (finest.error / 1e-9) ** (1 / p) / 3600
    print(f"{name}: exact in Python {exact.milliseconds:.1f} ms; pymunk would need {hours:,.1f} h")
    check("error of the exact one, m", exact.error, 0, tolerance=1e-12)

# %% [markdown]
# That carries the law far beyond the steps it was fitted on; rounding would come in before. But the
# exact solver *refuses* a pile: boxes there touch all the time, and no collision is the next one.
#
# ## 5 How to split a hundred sweeps
#
# Sweeps solve a pile. You can spend a hundred sweeps a step in many ways: one step with 100
# iterations, 100 sub-steps with one, or something between. The engine visits its contacts equally
# often.

# %%
predict("08-split")

# %% tags=["answer", "plumbing"]
# both towers
fig, axes = style.figure(2, width=10, height=3.6)
for ax, name in zip(axes, ("stack of 20", "heavy on light"), strict=True):
    precision_plots.split_of_sweeps(ax, result, name, 100)
axes[0].legend(frameon=False, fontsize=9)
show(
    fig,
    "Error over the number of sub-steps, at 100 sweeps in each step. Left, a stack of 20 boxes: "
    "for pymunk and the sequential solver the error falls all the way to 100 sub-steps. For the "
    "solver with springs it has a minimum at 10, and at both ends the stack falls. Right, a "
    "heavy box on a light one: all fall towards many sub-steps.",
)

# %% [markdown]
# Two of the three want as many sub-steps as they can get: gravity adds no more than g h to a
# velocity in the time h, and what a sweep leaves over moves the boxes only for that time.
#
# The solver with springs wants both. Its springs are the stiffer the shorter the sub-step is, and
# one sweep carries a change by one box only. With one sweep for each of 50 sub-steps the tower
# sways and falls, and with all sweeps in one sub-step it is too soft. **The best lies inside.**

# %%
springs = wp.splits(result, "stack of 20", 100)["substep"]
for point in springs:
    print(f"{point.substeps:3} x {point.iterations:2}: {point.error:.4f} m {point.failure}")
best = min(springs, key=lambda point: point.error)
check("best with so many sub-steps", best.substeps, 10)
check("and worse at both ends", [springs[0].failure, springs[-1].failure], ["fell", "fell"])

# %% [markdown]
# Equal sweeps are not equal time: in each sub-step most engines look for contacts anew. So what
# does a centimetre cost, a millimetre, a tenth of one?

# %%
for error in (1e-2, 1e-3, 1e-4):
    point = wp.cheapest(result, "stack of 20", error)
    print(f"within {error:.0e} m: {wp.in_words(point)}")

# %% [markdown]
# ## 6 How wrong may it be?
#
# You can answer the question of the beginning now: say how wrong the run may be, and look for the
# longest step that is good enough. A setting counts only if all *finer* ones of its line are good
# enough too. Otherwise one lucky hit would win.
#
# The engine runs in this figure, at all its steps. One method is new: it ends a step where an
# impact falls, and makes the rest of it after that. In which of the four scenes does that help, and
# by how much? Say it before you drag; section 3 tells why.

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
# Between two walls the split steps are wrong by 1 cm, whatever the step is: the engine lets a ball
# get 2.5 mm into a wall before it calls that a contact, and two impacts cost twice that, there and
# back. The bouncing ball gains nothing: its error comes from the fall.
#
# You pay in seconds, not in steps. In the stored result the cheapest way to stay within an error
# is:

# %%
for name in ("drop", "gas"):
    for error in (1e-1, 1e-3):
        print(f"{name}, within {error:.0e} m: {wp.in_words(wp.cheapest(result, name, error))}")

# %% [markdown]
# ## 7 What a law costs
#
# An error can be made smaller. A **law** is broken or it is not: a tower stands or falls, a picture
# and its mirror image agree or they do not. Sweeps solve contacts cheaply, and break laws. The
# default call takes a dearer way where it can pay for it. Chapter 09 tells which laws that keeps;
# here is the price, in the drawn scenes of `workbook measure hard-cases`, all in plain Python.

# %%
predict("08-law")

# %% tags=["answer"]
# what the families cost
families = hard_cases.stored()
price = {name: families.price(name) for name in families.names}
for engine, called in (("ours", "default call"), ("sequential", "sweeps")):
    print(f"{called}: {families.holds(engine)} of {len(price)} families hold in every draw")
print(f"time of the default call over that of sweeps: median {np.median(list(price.values())):.2g}")

# %% tags=["answer", "plumbing"]
# what the families cost
fig, ax = style.figure(width=9, height=4.6)
precision_plots.prices_of_laws(ax, families)
show(
    fig,
    "A row for each theme of hard cases, with a mark for each family over the time of the default "
    "call divided by that of sweeps, in powers of ten. Most marks are hollow, where sweeps break "
    "the law, and lie on both sides of 1.",
)

# %% [markdown]
# A mark to the left of 1 is a law that costs less than nothing. A full mark far to the right is
# money spent for nothing, as far as these draws can tell.
#
# **And when is the cheap answer right?** When nobody can see the error: a screen shows 60 pictures
# a second. When nobody can know better: after forty collisions each, an error of 1e-15 m in a gas
# has become "somewhere in the box" (chapter 07). Or when the model is worse than the method: you
# know the restitution of a ball to a few parts in a hundred. But where something rests on
# something, a small error *every* step adds up, and the cheap answer is no answer: what stood
# falls.

# %%
for e in (0.78, 0.80, 0.82):
    run = simulate(exact_scenes.bouncing_to_rest(e), 2.0, solver="exact", sample="end")
    print(f"restitution {e:.2f}: {run.positions[-1, 1, 1] - 0.5:.3f} m above the floor after 2 s")
step = result.lines("drop")["pymunk", "C"][3]
print(f"pymunk at 240 steps a second is wrong by up to {step.error:.3f} m")

# %% [markdown]
# ## 8 Break it on purpose: two ways to fool yourself
#
# **A method as its own judge.** Often nobody knows the answer. Then it is tempting to take the
# finest run of a method as the right one. Try it on a method that is plainly wrong: the naive
# solver knows no friction, and a disc slides on a rough floor until it should roll.

# %%
predict("08-own-judge-first")

# %% tags=["answer"]
# off itself, and off the truth
rolling = rolling_begins(3.0, 0.0, 1.0, 0.5, friction=0.2, gravity=10.0)
right = rolling.distance + rolling.velocity * (1 - rolling.time)
disc = scenes.sliding_disc(3.0, 0.2)
ends = {
    rate: simulate(disc, 1, dt=1 / rate, solver="naive", sample="end").positions[-1, 1, 0]
    for rate in (30, 60, 120, 3840)
}
for rate in (30, 60, 120):
    own, true = abs(ends[rate] - ends[3840]), abs(ends[rate] - right)
    print(f"{rate:3} steps a second: off its own finest by {own:.4f} m, off the truth {true:.3f} m")

# %% [markdown]
# Convergence says that a program solves *some* problem ever better. Only an answer from elsewhere
# can say whether it is yours: a closed form, a conserved quantity, another program. And an error
# that does not fall with the step is no matter of accuracy: look for a fault.
#
# **A lucky hit.** Take the error at the end alone, and look for the step that makes it least.

# %%
rates = np.arange(30, 91)
ends = [
    exact_scenes.error_in_the_box(simulate(scene, 10, solver="pymunk", dt=1 / r, sample="end"))[-1]
    for r in rates.tolist()
]
lucky = int(np.argmin(ends))
print(f"{rates[lucky]} steps a second: {ends[lucky]:.4f} m; their median: {np.median(ends):.4f} m")
check("at the next rate four times worse", bool(ends[lucky + 1] > 4 * ends[lucky]), True)

# %% [markdown]
# One of sixty-one rates had to be the best, and with one step more a second the error is four times
# as large. So: the largest error, many settings, and no point without its neighbours.
#
# ## 9 Quiz

# %%
show_quiz("08")

# %% [markdown]
# ## Key takeaways
#
# - Say which number is the error before you compare: the largest distance, at many times.
# - Stepping is of the first order, because an impact is seen late: half the step, half the error.
# - Sub-steps and iterations buy different things. Many sub-steps with few iterations hold a tower.
# - The exact solver has no step and no such error; it needs motion that a formula describes.
# - Pay for what your question needs. And never let a method be its own judge.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** the first order of two engines; the delay of a bounce and the delay of a fall
# against their formulas; the exact solver in five scenes; the split of a hundred sweeps.
#
# **Limits.** Times are those of one machine, and some were taken while it did other work too:
# believe factors of two, not tenths. Points are settings that were tried; a better one may lie
# between them. Box2D is 3.1.1 and counts in single precision, seven digits.
#
# `workbook measure accuracy --plot figure.png` makes the figure on your machine, `--store` puts its
# result in the place of the one drawn here.
#
# **Do now:** the exercise [08 What accuracy costs](../exercises/08_what_accuracy_costs.ipynb): five
# tasks, twenty points. `workbook watch` checks it whenever you save. **Next:** [09 Hard
# cases](09_hard_cases.ipynb): scenes in which engines fall over, and what holds them up.
#
# **Sources.** Hairer, Nørsett and Wanner, *Solving Ordinary Differential Equations I* (2nd edition,
# 1993): orders, and work-precision diagrams. Macklin and others, *Small Steps in Physics
# Simulation* (2019): sub-steps instead of iterations. Catto, *Solver2D* (2024): solvers side by
# side at equal work.
