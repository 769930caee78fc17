"""Families of impacts of many bodies at once, or nearly at once."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.collisions import change_of_momentum
from lesson_code.evidence.hard_cases.measures import ROUNDING, gain, largest
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.reference import impact_closed_forms as closed

THEME = "Many bodies at once"

ELASTIC = Material(restitution=1.0, friction=0.0)


def cradle(moving: int, *, from_right: bool = False, count: int = 5, gap: float = -1e-9) -> Scene:
    """Return elastic balls in a row, in touch; some of them come from one side at 1 m/s."""
    scene = disc_scenes.row_of_discs(count, gap)
    way = -1.0 if from_right else 1.0
    comes = range(count - moving, count) if from_right else range(moving)
    return Scene(
        replace(ball, velocity=(way if n in comes else 0.0, 0.0))
        for n, ball in enumerate(scene.bodies)
    )


@family(
    THEME,
    why="The gaps are far smaller than what a step moves: all hits are in one step.",
    law="Two at a time equal balls exchange velocities: as many leave as came.",
    unit="m/s",
    bound=1e-9,
    reason="rounding",
)
def cradle_with_gaps(draw: Draw, trial: Trial) -> float:
    """A cradle of 3 to 9 balls with gaps of 1e-9 to 0.1 m; 1 or more come: all velocities."""
    count = draw.integer("count", 3, 9)
    moving, gap = draw.integer("moving", 1, count - 1), draw.log_uniform("gap", 1e-9, 0.1)
    scene = cradle(moving, from_right=draw.choice("side", (0, 1)) == 1, count=count, gap=gap)
    expected = [ball.velocity[0] for ball in reversed(scene.bodies)]
    return largest(trial.run(scene, 2.0).velocities[-1, :, 0] - expected)


@family(
    THEME,
    why="Balls that touch leave it open who is struck first; the laws hold in every order.",
    law="Momentum and energy are kept, and in the end nothing approaches.",
    unit="",
    bound=ROUNDING,
    reason="rounding of some impacts",
)
def cradle_in_touch(draw: Draw, trial: Trial) -> float:
    """A cradle of 3 to 9 balls that touch exactly; 1 or more come: momentum and energy."""
    count = draw.integer("count", 3, 9)
    scene = cradle(draw.integer("moving", 1, count - 1), count=count, gap=0.0)
    run = trial.run(scene, 1.0)
    v = run.velocities[-1, :, 0]
    energy = abs(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1)
    return max(change_of_momentum(run), energy, largest(np.maximum(v[:-1] - v[1:], 0.0)))


@family(
    THEME,
    why="The ball that is visited first is given more.",
    law="Symmetry, momentum, energy: the cue comes back with 1/5.",
    unit="m/s",
    bound=1e-8,
    reason="the cue comes from a place that is rounded",
)
def cue_between_two_balls(draw: Draw, trial: Trial) -> float:
    """A cue ball flies between two touching balls, listed in either order: all velocities."""
    first = draw.choice("first", (1, 0)) == 1
    scene = disc_scenes.cue_between_two(upper_first=first, overlap=1e-9)
    back, speed = draw.uniform("distance", 0.0, 1.0), draw.log_uniform("speed", 0.1, 100.0)
    cue, *others = scene.bodies
    x, y = cue.position
    start = -math.sqrt(0.75) - back if back > 0 else x
    cue = replace(cue, position=(start, y), velocity=(speed, 0.0))
    v_cue, upper, lower = closed.break_shot(1.0, 1.0)
    expected = np.array([v_cue, upper, lower] if first else [v_cue, lower, upper])
    run = trial.run(Scene([cue, *others]), back / speed + 0.1)
    return largest(run.velocities[-1] / speed - expected)


def rack(rows: int, gap: float, back: float, speed: float) -> Scene:
    """Return a triangle of equal elastic balls of 1 m, and a cue ball straight on its way to it."""
    pitch = 1.0 + gap
    places = [
        (row * pitch * math.sqrt(0.75), (n - row / 2) * pitch)
        for row in range(rows)
        for n in range(row + 1)
    ]
    balls = [Body(Circle(0.5), mass=1, position=place, material=ELASTIC) for place in places]
    cue = Body(Circle(0.5), mass=1, position=(-1 - back, 0), velocity=(speed, 0), material=ELASTIC)
    return Scene([cue, *balls])


@family(
    THEME,
    why="Many balls are struck at one instant, and a list has a first one.",
    law="The result is its own mirror image, and energy is kept.",
    unit="",
    bound=1e-6,
    reason="rounding, which the hits of five rows make a million times larger",
)
def cue_into_rack(draw: Draw, trial: Trial) -> float:
    """A cue ball breaks a rack of 2 to 5 rows, touching or not: symmetry and energy."""
    gap = draw.choice("gap", (0.0, draw.log_uniform("gap_of", 1e-6, 0.1)))
    rows, speed = draw.integer("rows", 2, 5), draw.uniform("speed", 1.0, 10.0)
    run = trial.run(rack(rows, gap, draw.uniform("back", 0.1, 2.0), speed), 4.0 / speed)
    change = abs(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1)
    return max(change, asymmetry(run.velocities[-1, 1:], rows) / speed)


def asymmetry(velocities: np.ndarray, rows: int) -> float:
    """Return how far the velocities of a rack are from their mirror image."""
    numbers = [[row * (row + 1) // 2 + n for n in range(row + 1)] for row in range(rows)]
    partner = [n for row in numbers for n in reversed(row)]
    return largest(velocities[partner] * [1, -1] - velocities)


@family(
    THEME,
    why="The light one flies off only if the heavy one has bounced before they meet.",
    law="One after the other: (M - 3 m)/(M + m) v and (3 M - m)/(M + m) v",
    unit="",
    bound=1e-9,
    reason="rounding of three impacts",
)
def two_ball_drop(draw: Draw, trial: Trial) -> float:
    """A light ball a gap above a heavier one, both falling on a floor: their velocities."""
    ratio, gap = draw.log_uniform("ratio", 3.01, 1e9), draw.log_uniform("gap", 1e-9, 0.1)
    bodies = [
        Body(Segment((-5, 0), (5, 0)), material=ELASTIC),
        Body(Circle(0.5), mass=ratio, position=(0, 0.6), velocity=(0, -1), material=ELASTIC),
        Body(Circle(0.25), mass=1, position=(0, 1.35 + gap), velocity=(0, -1), material=ELASTIC),
    ]
    lower, upper = (float(v) for v in closed.two_ball_drop(ratio, 1.0, 1.0))
    return largest(trial.run(Scene(bodies), 0.5).velocities[-1, 1:, 1] - [lower, upper])


@family(
    THEME,
    why="Infinitely many hits in a finite time: going from hit to hit has no end.",
    law="e < 7 - 4 sqrt 3 = 0.0718: they end with one velocity, which is 0.",
    unit="m/s",
    bound=1e-6,
    reason="a millionth of the speed that they came with",
)
def collapse(draw: Draw, trial: Trial) -> float:
    """Three dull balls on a line, e from 0 to 0.07, hit each other infinitely often."""
    e = draw.uniform("restitution", 0.0, 0.07)
    shift = draw.uniform("shift", 0.01, 0.4) * draw.choice("nearer", (1, -1))
    starts = [(-1.5 + shift, 1.0), (0.0, 0.0), (1.5 + shift, -1.0)]
    balls = [
        Body(Circle(0.5), mass=1, position=(x, 0), velocity=(v, 0), material=Material(e))
        for x, v in starts
    ]
    return largest(trial.run(Scene(balls), 4.0).velocities[-1])


@family(
    THEME,
    why="Two hits on one body fall into one step, now in this order, now in that.",
    law="Hits on opposite sides of a heavy ball: the limit does not depend on their order.",
    unit="m/s",
    bound=1e-8,
    reason="the second normal is turned by up to 1e-9 rad; and some room for light balls",
)
def nearly_simultaneous(draw: Draw, trial: Trial) -> float:
    """Two balls hit a third at right angles, 0 to 1e-9 s apart: all velocities."""
    late = draw.choice("late", (0.0, draw.log_uniform("late_by", 1e-15, 1e-9)))
    masses = [draw.log_uniform(f"mass_{n}", 0.1, 10.0) for n in range(3)]
    starts = [(0.0, 0.0), (-1.5 - late, 0.0), (0.0, -1.5)]
    speeds = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
    balls = [
        Body(Circle(0.5), mass=m, position=x, velocity=v, material=ELASTIC)
        for m, x, v in zip(masses, starts, speeds, strict=True)
    ]
    m, a, b = masses
    expected = [
        [2 * a / (m + a), 2 * b / (m + b)],
        [(a - m) / (a + m), 0.0],
        [0.0, (b - m) / (b + m)],
    ]
    return largest(trial.run(Scene(balls), 0.6).velocities[-1] - expected)


@family(
    THEME,
    why="Which pair is first decides where all of them go; what is kept does not depend on it.",
    law="Momentum is kept, and energy with e = 1.",
    unit="",
    bound=ROUNDING,
    reason="rounding of some impacts",
)
def star_of_balls(draw: Draw, trial: Trial) -> float:
    """3 to 6 elastic balls meet in one point from all sides, within 0 to 1e-6 s: energy."""
    count, late = draw.integer("count", 3, 6), draw.choice("late", (0.0, 1e-12, 1e-9, 1e-6))
    distance = 0.5 / math.sin(math.pi / count) + 1.0
    balls = []
    for n in range(count):
        x, y = math.cos(2 * math.pi * n / count), math.sin(2 * math.pi * n / count)
        far = distance + (late if n % 2 else 0.0)
        balls.append(
            Body(Circle(0.5), mass=1, position=(far * x, far * y), velocity=(-x, -y),
                 material=ELASTIC)
        )  # fmt: skip
    run = trial.run(Scene(balls), 3.0, sample=None)
    energy = abs(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1)
    return max(energy, gain(run.kinetic_energy), change_of_momentum(run))
