# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # 09 Hard cases
#
# You can break every physics engine there is. You need no trick: a heavy crate on a light one, a
# tall tower, a floor made of tiles, or one rough corner will do. In this chapter you break one in
# four ways. Each time you find out **why** it broke, what the right answer is, and what helps.
#
# **After this notebook you will be able to**
#
# 1. say why a scene is hard, before you run it: what is far apart in it, masses, times or sizes;
# 2. find the law or the bound that a result has to hold, and write it down first;
# 3. choose between methods by the laws that they break, and by what they cost.
#
# **You need** notebooks 00 to 07. **Time:** about 45 minutes to read and to write two lines,
# fifteen seconds to run.

# %% tags=["plumbing"]
import numpy as np

from lesson_code import Circle, simulate
from lesson_code.chapters.ch08_what_accuracy_costs import figures as price_plots
from lesson_code.chapters.ch09_hard_cases import figures as case_plots
from lesson_code.chapters.ch09_hard_cases.scenes import gains_in, many_corners, spinning_hit
from lesson_code.course.grading.gaps import gap
from lesson_code.course.quiz.notebook import predict, show_quiz
from lesson_code.evidence import check, check_bound, hard_cases
from lesson_code.evidence.hard_cases import loads, rods, slopes, steps, together
from lesson_code.evidence.hard_cases.measures import DT, SUNK, pair_forces, way_of

# %% tags=["plumbing"]
from lesson_code.reference import impact_closed_forms as closed
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction
from lesson_code.reference.rigid_body_closed_forms import stack_forces
from lesson_code.view.browser.live import live
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.svg.animation import animate

# %% [markdown]
# ## 1 A heavy load on a light box
#
# A load of the mass M stands on a box of the mass m. The floor has to carry (M + m) g. Most engines
# find the forces by **sweeps**: they visit one contact after the other. First the floor stops the
# box. Then the load pushes the box down again, and loses a little of its own velocity: by the law
# of chapter 01 the two end with one velocity. Which part of the load's velocity is left after
# `sweeps` sweeps? Write it; `ratio` is M/m.


# %%
@gap("09-left")
def part_left(ratio, sweeps):
    return ...


# %%
predict("09-ten-sweeps")

# %% tags=["answer"]
# what sweeps leave
for ratio in (1.0, 100.0):
    for sweeps in (1, 10, 100):
        scene = loads.tower((1.0, ratio), gap=-SUNK)
        run = simulate(scene, 1 / 60, solver="sequential", iterations=sweeps)
        left = run.velocities[-1, 2, 1] / (-10 / 60)  # of what gravity has given it in the step
        law = part_left(ratio, sweeps)
        check(f"{ratio:3.0f} : 1, {sweeps:3} sweeps: part left", left, law, tolerance=1e-9)

# %% [markdown]
# Now break it. In the figure, make the load heavier until ten sweeps cannot carry it. Let more
# steps pass: the impulses of the step before are remembered, and the forces grow. What becomes of
# the tower meanwhile? Last, put boxes below the load, with few sweeps: how does the weight get
# down?

# %%
live(
    "ch09_hard_cases/tower",
    "A load of 50 kg on a box of 1 kg on the floor, after one step with ten sweeps. Bars show the "
    "force in each contact: 18 % of what it should carry. Boxes, load, sweeps and steps can be "
    "changed.",
)

# %% [markdown]
# How many sweeps does a load of a million kilograms need, until a millionth is left? Your line
# knows:

# %%
for sweeps in (10, 1_000_000, 14_000_000):
    print(f"1,000,000 : 1, {sweeps:10,} sweeps: {part_left(1e6, sweeps):.1e} is left")

# %% [markdown]
# No engine waits that long: the box is squeezed out, or the load falls through it.
#
# **What helps.** `solver="direct"` makes no sweeps. It writes down all the contacts of bodies that
# touch as linear equations with conditions, and solves them together. Here the load is a thousand
# times as heavy.

# %%
seen = np.linspace(0, 3, 61)
scene = loads.tower((1.0, 1e3), gap=-SUNK)
pair = {
    name: simulate(scene, 3.0, solver=s, sample=seen)
    for name, s in (("direct", "direct"), ("pymunk, 10 sweeps", "pymunk"))
}
animate(
    pair,
    "A box of 1 kg on a floor, and on it one of 1,000 kg. On the left both stand still. On the "
    "right the light box trembles and is thrown out to the left; the heavy one falls to the floor.",
    around=(-4, 2, -0.5, 3),
    still=1.7,
)

# %%
for ratio in (1e2, 1e4, 1e6):
    run = simulate(loads.tower((1.0, ratio), gap=-SUNK), 1.0, solver="direct")
    forces = pair_forces(run, DT)
    under = [forces[0, 1], forces[1, 2]]
    error = under / stack_forces([1.0, ratio], 10.0) - 1
    check(f"{ratio:9,.0f} : 1, error of both forces, parts", error, 0, tolerance=1e-8)
run = simulate(loads.tower((1.0, 1e6), gap=-SUNK), 10.0, solver="direct", sample="end")
check("1,000,000 : 1 after 10 s, overlap, m", run.max_penetration[-1], 0, tolerance=1e-3)

# %% [markdown]
# ## 2 A tower of equal boxes
#
# Twenty boxes of equal mass look harmless. But the weight of the highest has to get down to the
# floor through twenty contacts, and a sweep takes it from one body to its neighbours. How many
# sweeps pass before the floor has heard of the top? Write the least number for a tower of `boxes`;
# a sweep visits the lowest contact first.


# %%
@gap("09-heard")
def sweeps_to_hear(boxes):
    return ...


# %%
predict("09-tower")

# %% tags=["answer"]
# both towers for eleven seconds
print(f"the floor hears of the top of twenty after {sweeps_to_hear(20)} sweeps; pymunk makes ten")
seen = np.linspace(0, 11, 111)
scene = loads.tower((1.0,) * 20, gap=-SUNK)
pair = {
    name: simulate(scene, 11.0, solver=s, sample=seen)
    for name, s in (("direct", "direct"), ("pymunk, 10 sweeps", "pymunk"))
}

# %% tags=["answer"]
# eleven seconds of both towers
animate(
    pair,
    "Two towers of twenty boxes. The left one stands. The right one bends to and fro, leans over "
    "to the right and falls.",
    around=(-4, 16, -0.5, 21),
    seconds=6,
    still=8.7,
)

# %% tags=["answer"]
# eleven seconds of both towers
check("direct: farthest way in 11 s, m", way_of(pair["direct"]), 0, tolerance=1e-9)
more = simulate(scene, 14.0, solver="pymunk", iterations=100, sample="end")
for name, run in (("10 sweeps after 11 s", pair["pymunk, 10 sweeps"]), ("100 after 14 s", more)):
    check_bound(f"pymunk, {name}: height of the top, m", run.positions[-1, 20, 1], at_most=15)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# It sways and falls. More sweeps alone do not help: they delay the fall.

# %% [markdown]
# **What helps.** The direct solver sees all twenty contacts at once. A solver with many short steps
# helps, too: it passes an error on before it can grow.
#
# ## 3 Break it on purpose: a floor made of tiles
#
# A level is built of tiles, side by side and all of one height. A disc without friction lands on
# them and slides on at 5 m/s.

# %%
predict("09-tiles")

# %% tags=["answer"]
# the velocity along the tiles
slides, speed = {}, 5.0
seen = np.linspace(0, 8, 161)
shape = Circle(0.5)
for solver in ("direct", "pymunk"):
    run = simulate(slopes.slider_on_pieces(shape, 0.5, speed), 8.0, solver=solver, sample=seen)
    slides[solver] = (run.times, run.velocities[:, -1, 0])
check("direct: vx over 8 s, m/s", slides["direct"][1], speed, tolerance=1e-9)

# %% tags=["answer", "plumbing"]
# the velocity along the tiles
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, slides, "time, s", "velocity along the floor, m/s")
ax.set_ylim(4, 5.2)
show(
    fig,
    "Velocity over time. The direct solver's is a level line at 5 m/s. pymunk's falls in steps, "
    "each at a seam between two pieces.",
)

# %% [markdown] tags=["answer"]
# <b class="answer">The answer.</b>
# When the disc landed it sank in a little: engines leave a small overlap, the **slop**, so that
# resting contacts stay contacts. So it comes to the next tile below its surface and meets the
# **end** of it, with a normal that points back. The floor has no step there.

# %% [markdown]
# **What helps.** Our engine compares the contacts of neighbouring pieces: where one piece already
# carries the body, the end of the next one is no contact.
#
# ## 4 Energy from friction, and a rule that makes none
#
# You know from notebook 05b that Newton's e and friction can make energy in one blow. Here is a bad
# case. A rod of 2 m and 1 kg falls at 1 m/s, tilted by 45 degrees, and turns at 2 rad/s. Its tip
# meets a rough floor; e = 1.


# %%
def energy_kept(**chosen):
    rod = rods.rod_on_floor(**rods.KANE)
    energy = simulate(rod, 1e-9, dt=1e-9, sample="end", **chosen).kinetic_energy
    return energy[-1] / energy[0]


# for each body 1/mass, 1/inertia, velocity, spin, and the arm from its centre to the contact
a = np.pi / 4
tip = Struck(1.0, 3.0, (0.0, -1.0), 2.0, (-np.cos(a), -np.sin(a)))
floor = Struck(0.0, 0.0, (0, 0), 0.0, (0, 0))
after = impact_with_friction(floor, tip, (0, 1), 1.0, 1.0)
v, w = after.velocities[1], after.angular_velocities[1]

# %%
exact = (v @ v + w**2 / 3) / (1.0 + 2.0**2 / 3)
check("Newton's e in pymunk", energy_kept(solver="pymunk", iterations=1000), exact, 1e-8)
check("Newton's e in ours", energy_kept(restitution_law="newton"), exact, 1e-8)

# %% [markdown]
# The rod has 1.56 times its energy. **Stronge's** e compares work instead of velocities. The floor
# first takes energy out of the tip, until it approaches no more. Then it gives back the part $e^2$
# of that, and no more.

# %%
predict("09-stronge")

# %% tags=["answer"]
# the energy after over the energy before
print(f"Stronge's e = 1: {energy_kept():.4f} of the energy")

# %% [markdown]
# A floor that gives back at most what it took adds no energy. For a smooth impact both laws agree.
# `simulate(scene, T)` takes Stronge's wherever it solves contacts at once; you have to ask for
# Newton's by name. Throw 500 boxes onto one corner each:

# %%
boxes, settings = many_corners(500, seed=1), {"dt": 1e-6, "sample": "end"}
run = simulate(boxes, 1e-6, solver="pymunk", **settings)
print("pymunk:", gains_in(run), "of 500 gain energy")
run = simulate(boxes, 1e-6, solver="direct", restitution_law="energetic", **settings)
check("Stronge's law: boxes that gain", gains_in(run), 0)

# %% [markdown]
# Friction can do worse: it can keep sweeps from ever ending. Pull the same rod over the floor, with
# mu = 2 and its tip coming down at 1 mm/s. The normal impulse calls for friction, friction lifts
# the tip, and less normal impulse is needed than was given; the next sweep takes it back. Here you
# can work out the answer (task 9.3): with the friction that it calls for, 1 N s changes the tip's
# velocity by 5.5 m/s upwards.

# %%
drawn = rods.rod_on_floor(a, 1.0, -1e-3)
for sweeps in (10, 11, 100, 101, 1000):
    run = simulate(drawn, 1e-9, dt=1e-9, solver="pymunk", iterations=sweeps)
    print(f"pymunk, {sweeps:4} sweeps: jn = {run.contacts.normal_impulse.sum():.6f} N s")
run = simulate(drawn, 1e-9, dt=1e-9, solver="direct")
check("direct", run.contacts.normal_impulse.sum(), 1e-3 / 5.5, tolerance=1e-11)

# %% [markdown]
# An even number of sweeps gives one answer, an odd number another, and neither comes nearer to the
# right one, however many there are.
#
# ## 5 Two right answers: Newton's cradle
#
# In chapter 04 a row of five had two answers, and both keep momentum and energy: the pairs strike
# **one after the other**, or all at **the same instant**. The laws leave the choice to the engine.
# Ours lets you choose:

# %%
row = together.cradle(1)
for rule, law in (
    ("sequential", closed.cradle_one_by_one),
    ("simultaneous", closed.cradle_all_at_once),
):
    v = simulate(row, 0.5, solver="direct", impacts=rule, dt=1 / 240).velocities[-1, :, 0]
    check(rule, v, law(5, 1.0), tolerance=1e-8)
    check("   momentum, energy", [v.sum(), (v * v).sum() / 2], [1, 0.5], tolerance=1e-8)

# %% [markdown]
# Which rule does nature take? Neither, quite. The steel balls of a toy cradle give a little under
# the blow, so several contacts push at the same time: most of the motion reaches the far end, and
# the balls between drift a little. One after the other comes closest. An engine has to *say*
# which rule it follows. pymunk follows neither: after ten sweeps it stops, on its way to the
# second one.

# %%
v = simulate(together.cradle(1), 1e-9, dt=1e-9, solver="pymunk", sample="end").velocities[-1, :, 0]
print("pymunk, 10 sweeps:", *(f"{x:.3f}" for x in v), f"m/s, energy {(v * v).sum() / 2:.3f} J")

# %% [markdown]
# ## 6 What the default chooses, and the price
#
# Some laws cannot hold at once, and some questions have more than one answer. So
# `simulate(scene, T)` has to choose.
#
# - **e as a ratio of velocities, or no gain of energy?** No gain: Stronge's e. The price: a rough
#   corner does not part at e times its approach. `restitution_law="newton"` asks for that.
# - **Energy or angular momentum, in each step?** Where gravity acts, energy: contacts act at the
#   mean velocity of the step. Without gravity both momenta are kept, and energy can only fall.
#   The price: a pair that spins while it falls keeps its spin only as well as the step is short.
# - **Several contacts at one instant?** All bounce at once. The price: balls that touch in a row
#   share the blow. `impacts="sequential"` passes it on.
# - **Exactly where bodies touch, or a little early?** The first two impacts of a step come where
#   the bodies touch, in groups of up to 16 contacts. Others may come a thousandth of a width early.
# - **Right, or fast?** Our default solves all contacts at once for up to 40 bodies, of which no
#   more than 24 fall; for up to 64 where nothing presses them together, neither gravity nor a wall
#   that moves; and for up to 100 that all stand from the start. The price: a step may take far
#   longer than one of sweeps. Where there are more bodies, springs in short sub-steps hold them
#   (chapter 08): the springs give way a little, and the angular momentum is kept less exactly.
# - **Newton's restitution, or energy?** Many rough bodies that hit at once may gain energy by
#   Newton's rule, by sweeps more than all had before. With sub-steps bodies that touch one another
#   get as much of their bounce as their energy is enough for. The price: they may part slower.
#
# ## 7 Quiz

# %%
show_quiz("09")

# %% [markdown]
# ## Key takeaways
#
# - A case is hard where things are **far apart**: masses, sizes, speeds, lengths of steps, or the
#   ends of a long chain of contacts.
# - Sweeps converge by a factor that you can work out: M/(M + m) for a load on a box. Against a
#   factor near 1 solve all contacts together, or make the steps much shorter.
# - What an engine keeps from one step to the next has a unit. If the step changes, it has to change
#   too (section 8).
# - Newton's e and Coulomb's friction together may make energy. Stronge's e cannot.
# - Where the laws leave a choice, as in the cradle, a program has to say which one it has made.
# - Write the bound first. Then measure. Then say what does not hold.

# %% [markdown]
# ## 8 Appendix: steps that change, and the square of the golden section
#
# Some games make each step as long as the last picture took. So steps of dt and $\rho$ dt may take
# turns. A disc lies on the floor. Nothing moves. What can go wrong?
#
# An engine keeps the impulse of the last step, to begin the next one with. In a step $\rho$ times
# as long $\rho$ times the impulse is needed. pymunk applies it scaled so, but goes on counting
# from the *old* number. Call that number a, in units of what a step of dt needs. In the long
# step, and the short one after it,
#
# $$a_1 = \rho + a_0 (1 - \rho) \qquad a_2 = 1 + a_1 \left(1 - \tfrac{1}{\rho}\right)
# = \rho - \frac{(\rho - 1)^2}{\rho}\, a_0$$
#
# An error in $a$ grows if the factor before $a_0$ is more than 1: $(\rho - 1)^2 > \rho$. That is
# the case from $\rho = (3 + \sqrt{5})/2 = 2.618$ on, the square of the golden section.

# %%
limit = (3 + np.sqrt(5)) / 2
check("(rho - 1)^2 / rho at the limit", (limit - 1) ** 2 / limit, 1.0, tolerance=1e-12)
disc = steps.resting_disc()
for rho in (2.617, 2.619):
    heights = steps.heights_in_jumping_steps(disc, "pymunk", rho, steps=20_000)[:, 1]
    moved = bool(np.abs(heights - heights[0]).max() > 1e-3)
    print(f"pymunk, rho = {rho}: the disc {'jumps' if moved else 'rests'}")

# %%
ratios = np.linspace(1.5, 4, 26)
jumps = {}
for solver in ("direct", "pymunk"):
    ways = [steps.heights_in_jumping_steps(disc, solver, rho)[:, 1] for rho in ratios]
    jumps[solver] = (ratios, [np.abs(way - way[0]).max() for way in ways])
check("direct, all ratios: way, m", np.array(jumps["direct"][1]), 0, tolerance=1e-9)
fig, ax = style.figure(width=7, height=3)
plots.curves(ax, jumps, "long step / short step", "highest jump in 120 steps, m")
ax.axvline(limit, color=style.GREY, linewidth=1, linestyle="-.")
show(
    fig,
    "How far a resting disc jumps, over the ratio of two steps that take turns. pymunk's curve is "
    "zero up to 2.6 and rises from there, to many metres at 4. The direct solver's is zero "
    "everywhere.",
)

# %% [markdown]
# The direct solver does not begin with old *impulses*. It begins with old *cases* (open, sticking,
# sliding), which have no unit and need no scaling.
#
# **Use a fixed step all the same.** Collect the time that has passed in an *accumulator*, and make
# as many whole steps as fit into it; what is left waits there for the next picture. The programs of
# this workbook do so: a slow computer draws less often, and plays the same game. Here are pictures
# that take 5 to 40 ms, and steps of 1/60 s:

# %%
accumulator, steps_made = 0.0, []
for picture in (0.005, 0.040, 0.012, 0.031, 0.010):
    accumulator += picture
    steps_made.append(int(accumulator * 60))
    accumulator -= steps_made[-1] / 60
print("whole steps at each picture:", steps_made)
check("nothing is lost: steps and rest, s", sum(steps_made) / 60 + accumulator, 0.098, 1e-15)

# %% [markdown]
# ## 9 Appendix: the catalogue of hard cases
#
# One scene proves little: it may be the one that works. So the catalogue behind this chapter holds
# **families**: a law over *drawn* parameters. A load has any mass from a billionth to a billion
# times that of the box below; a rod is anything from 1:2 to 1:1000; bodies begin touching, apart,
# or sunk in. Each family has a measure that is 0 where all is right, and a bound that was **written
# down before** it was run.
#
# All engines run the same draws. Ours gets no help: we call `simulate(scene, duration)` and set
# nothing else. "Sweeps" is our own sequential solver, the cheaper way. Here is what we measured and
# stored:

# %%
measured = hard_cases.stored()
families = len(measured.names)
for engine in measured.engines:
    mine = [result for result in measured.results if result.engine == engine]
    held, draws = sum(result.held for result in mine), sum(result.draws for result in mine)
    whole = f"holds {measured.holds(engine):3} of {families} families in every draw"
    print(f"{engine:10} {whole}; {held:6,} of its {draws:6,} draws")

# %% [markdown]
# A share tells you how **often** an engine breaks a law. Here it is for each theme, with the number
# of its families:

# %% tags=["plumbing"]
missed = {hard_cases.family_by_name(name).theme.lower() for name in measured.not_held("ours")}
but = f", or a hair below it: at {' and '.join(sorted(missed))}" if missed else ""
fig, ax = style.figure(width=7, height=6)
case_plots.shares_held(ax, measured)
show(
    fig,
    "A row for each of fifteen themes of hard cases, with a mark for each engine over the share "
    f"of the draws in which it held the bound. Ours stands at 100 per cent in every row{but}. The "
    "others are spread from 5 to 100.",
)

# %% [markdown]
# The worst draw tells you how **badly** an engine breaks it. Left of the line the theme's worst
# draw holds its bound. To the right each unit is a power of ten: at 6, the result is a million
# times over the bound. A mark at the right edge is 14 powers over it, or more.

# %% tags=["plumbing"]
fig, ax = style.figure(width=7, height=6)
case_plots.over_the_bounds(ax, measured)
show(
    fig,
    "The same rows, with a mark for each engine over the powers of ten by which its worst draw is "
    f"over the bound or under it. Ours is over it at {' and '.join(sorted(missed)) or 'no theme'}; "
    "the others stand to the right of the line, most of them five to fourteen powers over.",
)

# %% [markdown]
# Which scenes are these? The table names one family of each theme, the one that all engines
# together hold least: the draws held, and the worst figure. Its last two lines count these fifteen
# families only. `workbook measure hard-cases` measures all of them on your machine and prints the
# whole table; `--only load-on-box` takes one family.

# %%
print(case_plots.least_held(measured).as_text(115))

# %% [markdown]
# **Read it with care.** A cross says "not every draw holds this bound". It does not say "useless".
# pymunk lets bodies sink into one another by a slop on purpose, and Box2D's soft contacts give way
# under a load, both by far more than the bounds of a thousandth. Box2D computes in single
# precision, and it refuses bodies that are too thin for it: that is a dash. And for a game a
# millimetre is nothing. Look at the *large* numbers: a load that has fallen by a metre, a gain of
# energy that anyone can see. And "naive" holds some families because it does nothing at all:
# without friction, friction cannot add energy.

# %% [markdown]
# ### What ours does not hold
#
# A table in which one engine holds everything would make you suspicious, and rightly. **Which
# families does our default call not hold?** Each one is work that we have to do. The list gives its
# law and its worst draw; if it is empty, draw others: `--seed 1000000`.

# %%
print(f"not held in every draw: {len(measured.not_held('ours'))} of {families} families")
for name in measured.not_held("ours"):
    family, result = hard_cases.family_by_name(name), measured.result(name, "ours")
    worst = result.error or f"{result.worst:.2g} {family.unit}"
    print(f"{name}: {result.held} of {result.draws}; worst {worst} with seed {result.worst_seed}")
    print(f"    {family.law}")

# %% [markdown]
# **What does it cost?** Each mark is a family again. Left of 1 the laws cost less than nothing:
# what stands still soon sleeps, and what is solved at once needs no ten sweeps.

# %%
prices = [measured.price(name) for name in measured.names]
print(f"time of the default call over that of sweeps, typically: {np.median(prices):.2g}")
price_plots.laws(measured)

# %% [markdown]
# **Replay.** A draw is found again by its seed. Take the load on a box, and pymunk's worst draw of
# it. The parameters come first, then the figure of both engines. On the command line:
# `workbook measure hard-cases --replay load-on-box:0`, with any seed.

# %%
family = hard_cases.family_by_name("load-on-box")
seed = measured.result(family.name, "pymunk").worst_seed
print(f"{family.title}. {family.law} Bound: {family.bound:g} {family.unit}")
for engine in ("ours", "pymunk"):
    again = hard_cases.run_draw(family, engine, seed)
    if engine == "ours":
        print(*(f"  {key}: {value}" for key, value in again.parameters.items()), sep="\n")
    figure = "under 1e-12" if again.value < 1e-12 else f"{again.value:.1e}"
    print(f"{engine}: {figure} {family.unit}, {'held' if again.held else 'NOT held'}")

# %% [markdown]
# **One reason in detail.** Two rough discs that spin meet. A step of the sequential solver finds
# them a little inside each other, and each is pushed at the point on its own rim. These are two
# points. So the angular momentum changes by the overlap times the friction impulse.

# %%
run = simulate(spinning_hit(), 1.0, solver="sequential")
impulse = run.contacts.tangent_impulse[0]
changed = run.angular_momentum[-1] - run.angular_momentum[0]
check(
    "change of L over (overlap x jt)",
    abs(changed / (run.contacts.penetration[0] * impulse)),
    1.0,
    tolerance=1e-6,
)
run = simulate(spinning_hit(), 1.0, solver="exact")
check("exact: change of L", run.angular_momentum - run.angular_momentum[0], 0, tolerance=1e-12)

# %% [markdown]
# The exact solver lets them meet where they touch, and there the two points are one.

# %% [markdown]
# ## What was checked, and what comes next
#
# **Checked here:** the rate of sweeps against M/(M + m); forces under loads up to 1,000,000 : 1;
# the limit of jumping steps, 2.618; the velocity over seams to 1e-9; the gain of energy against
# the closed form; both cradles. The tests draw every family of the table again.
#
# **Limits.** The direct solver's time grows faster than the number of contacts that hang together:
# for a heap of thousands, sub-steps are the better choice. Where a case is chaotic, paths are
# compared only as long as they can be computed. And real boxes are not rigid.
#
# **Do now:** the exercise [09 Hard cases](../exercises/09_hard_cases.ipynb): five tasks, twenty
# points. `workbook watch` checks it whenever you save. In `workbook play cradle` you choose between
# the two answers of section 5; its challenge is [exercises/cradle.py](../exercises/cradle.py).
# **Next:** [10 Only what the scene needs](10_only_what_the_scene_needs.ipynb): what you may leave
# out, and how you know.
#
# **Sources.** Stronge, *Impact Mechanics* (2000): the energetic restitution. Kane and Levinson,
# *Dynamics: Theory and Applications* (1985): impacts that gain energy. Champneys and Várkonyi, *The
# Painlevé paradox in contact mechanics*, IMA Journal of Applied Mathematics 81 (2016), 538. Catto,
# *Modeling and Solving Constraints*, Game Developers Conference 2009: sequential impulses.
