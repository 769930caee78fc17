"""Families of collisions of free bodies: momentum, angular momentum and energy."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.constants import MOST_DRIFTING
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import ROUNDING, gain, largest, rise
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import OURS, Trial, family
from lesson_code.evidence.scenes import corner_impacts, spinning_discs
from lesson_code.formulas import elastic_1d
from lesson_code.geometry.shapes import Circle, Polygon, Shape

THEME = "Collisions of free bodies"

RING = 3.0
"""m: radius of the circle from which the bodies fly to the middle. None reaches a neighbour."""

APART = 2.2
"""m: from one body of a crowd to the next; none reaches its neighbour."""

KEPT = "rounding of some collisions, relative to the sum of what the bodies have"


def shape_of(draw: Draw, kind: str, name: str) -> Shape:
    """Return a disc, or a regular or a flat polygon, no larger than 0.7 m about its centre."""
    size = draw.uniform(f"size_{name}", 0.2, 0.7)
    if kind == "discs":
        return Circle(size)
    sides = draw.integer(f"sides_{name}", 3, 8)
    return Polygon.regular(sides, size) if sides != 8 else Polygon.box(1.2 * size, 0.3 * size)


def meeting(draw: Draw, surface: Material, kind: str, ratio: float = 1e6) -> Scene:
    """Return 2 to 5 spinning bodies that fly to the middle of a circle, without gravity."""
    count, most = draw.integer("count", 2, 5), math.sqrt(ratio)
    turn = draw.uniform("turn", 0.0, 2 * math.pi)
    bodies = []
    for n in range(count):
        way = turn + 2 * math.pi * n / count
        aim = way + math.pi + draw.uniform(f"aim_{n}", -0.1, 0.1)
        speed = draw.uniform(f"speed_{n}", 1.0, 2.0)
        bodies.append(
            Body(
                shape_of(draw, kind, str(n)),
                mass=draw.log_uniform(f"mass_{n}", 1 / most, most),
                position=(RING * math.cos(way), RING * math.sin(way)),
                angle=draw.uniform(f"angle_{n}", 0.0, math.pi),
                velocity=(speed * math.cos(aim), speed * math.sin(aim)),
                angular_velocity=draw.uniform(f"spin_{n}", -5.0, 5.0),
                material=surface,
            )
        )
    return Scene(bodies)


def kind_of(draw: Draw) -> str:
    """Draw what the bodies are: discs or polygons."""
    return draw.choice("kind", ("discs", "polygons"))


def any_surface(draw: Draw) -> Material:
    """Draw restitution and friction, both over their whole range."""
    return Material(draw.uniform("restitution", 0.0, 1.0), draw.uniform("friction", 0.0, 2.0))


def smooth_surface(draw: Draw) -> Material:
    """Draw a restitution, without friction."""
    return Material(draw.uniform("restitution", 0.0, 1.0), 0.0)


def change_of_momentum(run: Run) -> float:
    """Return the largest change of the momentum, in parts of the sum of all bodies'."""
    masses = np.array([body.mass for body in run.scene.bodies])
    scale = float(masses @ np.hypot(*run.velocities[0].T))
    return largest(run.momentum - run.momentum[0]) / scale


def change_of_angular_momentum(run: Run) -> float:
    """Return the largest change of the angular momentum, in parts of the sum of all bodies'."""
    masses = np.array([body.mass for body in run.scene.bodies])
    inertias = np.array([body.inertia for body in run.scene.bodies])
    x, v = run.positions[0], run.velocities[0]
    scale = masses @ (np.hypot(*x.T) * np.hypot(*v.T)) + inertias @ abs(run.angular_velocities[0])
    return largest(run.angular_momentum - run.angular_momentum[0]) / float(scale)


@family(
    THEME,
    why="What one body gets the other has to give, to the last digit.",
    law="Momentum is kept.",
    unit="",
    bound=1e-12,
    reason=KEPT,
)
def momentum(draw: Draw, trial: Trial) -> float:
    """2 to 5 spinning discs or polygons with any e and mu meet: change of momentum in 4 s."""
    scene = meeting(draw, any_surface(draw), kind_of(draw))
    return change_of_momentum(trial.run(scene, 4.0, sample=None))


@family(
    THEME,
    why="A step finds bodies in each other, and impulses at two points make a torque.",
    law="Angular momentum is kept.",
    unit="",
    bound=1e-12,
    reason=KEPT,
)
def angular_momentum_smooth(draw: Draw, trial: Trial) -> float:
    """2 to 5 smooth discs or polygons meet: change of angular momentum in 4 s."""
    scene = meeting(draw, smooth_surface(draw), kind_of(draw))
    return change_of_angular_momentum(trial.run(scene, 4.0, sample=None))


@family(
    THEME,
    why="Friction at two points, one on each rim, makes a torque of overlap times impulse.",
    law="Angular momentum is kept.",
    unit="",
    bound=1e-12,
    reason=KEPT,
)
def angular_momentum_rough(draw: Draw, trial: Trial) -> float:
    """2 to 5 rough discs or polygons meet: change of angular momentum in 4 s."""
    scene = meeting(draw, any_surface(draw), kind_of(draw))
    return change_of_angular_momentum(trial.run(scene, 4.0, sample=None))


@family(
    THEME,
    why="Position correction must do no work, and an impact no more than the law of e.",
    law="Energy never grows.",
    unit="",
    bound=ROUNDING,
    reason=KEPT,
)
def energy_smooth(draw: Draw, trial: Trial) -> float:
    """2 to 5 smooth discs or polygons meet: gain of energy in 4 s."""
    scene = meeting(draw, smooth_surface(draw), kind_of(draw))
    return gain(trial.run(scene, 4.0, sample=None).kinetic_energy)


@family(
    THEME,
    why="Newton's e compares velocities. With friction an impact may then gain energy.",
    law="Energy never grows.",
    unit="",
    bound=ROUNDING,
    reason=KEPT,
)
def energy_rough(draw: Draw, trial: Trial) -> float:
    """2 to 5 rough discs or polygons meet: gain of energy in 4 s."""
    scene = meeting(draw, any_surface(draw), kind_of(draw))
    return gain(trial.run(scene, 4.0, sample=None).kinetic_energy)


@family(
    THEME,
    why="What is lost or won at each hit adds up.",
    law="With e = 1 and mu = 0 the energy is kept.",
    unit="",
    bound=ROUNDING,
    reason=KEPT,
)
def energy_elastic(draw: Draw, trial: Trial) -> float:
    """2 to 5 elastic smooth discs or polygons meet: change of energy in 4 s."""
    scene = meeting(draw, Material(1.0, 0.0), kind_of(draw))
    energies = trial.run(scene, 4.0, sample=None).kinetic_energy
    return largest(energies / energies[0] - 1)


@family(
    THEME,
    why="More bodies than are solved together get sweeps: rods gain energy, boxes overlap by half.",
    law="Both momenta are kept, and energy never grows, however many meet.",
    unit="",
    bound=1e-9,
    reason="rounding of some thousand collisions, relative to the sum of what the bodies have",
    is_long=True,
)
def crowd(draw: Draw, trial: Trial) -> float:
    """6 to 64 spinning discs, boxes or rods with any e and mu rush to one place: change or gain."""
    scene = rush(draw, round(draw.log_uniform("count", 6, MOST_DRIFTING)))
    run = trial.run(scene, 3.0, sample=None)
    return max(change_of_momentum(run), change_of_angular_momentum(run), rise(run.kinetic_energy))


def rush(draw: Draw, count: int, surface: Material | None = None) -> Scene:
    """Return bodies on a grid that fly to its middle, where they would all be after 2 s."""
    kind, surface = draw.choice("kind", ("discs", "boxes", "rods")), surface or any_surface(draw)
    disc, box, rod = Circle(0.5), Polygon.box(1, 1), Polygon.box(1.8, 0.1)
    shapes: dict[str, Shape] = {"discs": disc, "boxes": box, "rods": rod}
    rng = np.random.default_rng(draw.integer("crowd", 0, 10**9))
    rows = math.ceil(math.sqrt(count))
    bodies = []
    for n in range(count):
        x, y = (APART * (m - (rows - 1) / 2) for m in (n % rows, n // rows))
        vx, vy = rng.normal(0, 1, 2).tolist()
        bodies.append(
            Body(
                shapes[kind],
                mass=float(10 ** rng.uniform(-1, 1)),
                position=(x, y),
                angle=float(rng.uniform(0, math.pi)),
                velocity=(vx - x / 2, vy - y / 2),
                angular_velocity=float(rng.normal(0, 3)),
                material=surface,
            )
        )
    return Scene(bodies)


@family(
    THEME,
    why="A body of 1e-12 kg takes an impulse that the other one cannot see.",
    law="Energy never grows, momentum is kept.",
    unit="",
    bound=ROUNDING,
    reason=KEPT,
)
def masses_far_apart(draw: Draw, trial: Trial) -> float:
    """2 to 5 bodies of 1e-12 to 1e12 kg meet: change of momentum, or gain of energy, in 4 s."""
    scene = meeting(draw, smooth_surface(draw), kind_of(draw), ratio=1e24)
    run = trial.run(scene, 4.0, sample=None)
    return max(change_of_momentum(run), gain(run.kinetic_energy))


@family(
    THEME,
    why="The light ball takes its whole velocity from a difference of two large numbers.",
    law="v' = 2 V - v as m/M goes to 0; the closed form at any ratio",
    unit="",
    bound=1e-12,
    reason="rounding, relative to the speed of approach",
)
def two_balls_of_any_masses(draw: Draw, trial: Trial) -> float:
    """Two elastic balls of 1e-12 to 1e12 kg meet head on: their velocities after it."""
    m = [draw.log_uniform(f"mass_{n}", 1e-12, 1e12) for n in range(2)]
    v = [draw.uniform("left", 0.5, 2.0), -draw.uniform("right", 0.5, 2.0)]
    starts = zip(m, v, (-2.0, 2.0), strict=True)
    balls = [
        Body(Circle(0.5), mass=mass, position=(x, 0), velocity=(u, 0), material=Material(1.0))
        for mass, u, x in starts
    ]
    found = trial.run(Scene(balls), 4.0).velocities[-1, :, 0]
    return largest(found - elastic_1d(m[0], v[0], m[1], v[1])) / (v[0] - v[1])


@family(
    THEME,
    why="The clamp of friction and both effective masses have to be right.",
    law="jn = (1 + e) vn m_eff, jt = clamp(-vt m_eff_t, -mu jn, mu jn)",
    unit="",
    bound=1e-8,
    reason="the discs overlap by a billionth of their radii, as all engines need it",
)
def oblique_discs(draw: Draw, trial: Trial) -> float:
    """Two rough spinning discs with masses of 1e-3 to 1e3 kg meet at any angle."""
    impacts = spinning_discs.random_impacts(1, seed=draw.integer("pair", 0, 10**9))
    a, b, e, mu = next(impacts)
    expected = spinning_discs.hit(a, b, spinning_discs.normal_between(a, b), e, mu)
    step = spinning_discs.STEP
    scene = spinning_discs.scene_of(a.moved(-step), b.moved(-step), e, mu)
    run = trial.run(scene, step, dt=step)
    return spinning_discs.difference(expected, run)


@family(
    THEME,
    why="Friction beside the centre changes what the normal impulse has to be, and back.",
    law="The closed form by the law of restitution that the engine has: ours Stronge's, others "
    "Newton's",
    unit="",
    bound=1e-8,
    reason="the corner is a billionth of the box's width in the floor, as all engines need it",
)
def corner_impact(draw: Draw, trial: Trial) -> float:
    """A box of 0.1 to 3 m lands on a rough corner, with any motion: its velocity after it."""
    impacts = corner_impacts.random_corners(1, seed=draw.integer("box", 0, 10**9))
    impact = next(impacts)
    run = trial.run(impact.scene, corner_impacts.STEP, dt=corner_impacts.STEP)
    motion = np.column_stack((run.velocities[:, 1], run.angular_velocities[:, 1]))
    expected = impact.by_work if trial.engine == OURS else impact.expected
    return largest(motion[-1] - expected) / largest(motion)


@family(
    THEME,
    why="An infinite moment of inertia or mass must give zeros, and no infinities less infinities.",
    law="The closed form of a collision on a line: what cannot turn is struck as in its centre.",
    unit="",
    bound=1e-12,
    reason="rounding, relative to the speed of approach",
)
def infinite_inertia(draw: Draw, trial: Trial) -> float:
    """A ball hits a box that never turns, or a wall, beside its middle, any e: all velocities."""
    e, mass = draw.uniform("restitution", 0.0, 1.0), draw.log_uniform("mass", 1e-6, 1e6)
    arm, is_wall = draw.uniform("arm", -0.4, 0.4), draw.choice("wall", (0, 1)) == 1
    target = Body(
        Polygon.box(1, 1),
        mass=None if is_wall else mass,
        inertia=None if is_wall else math.inf,
        material=Material(e, 0.0),
    )
    ball = Body(Circle(0.2), mass=1, position=(-2, arm), velocity=(1, 0), material=Material(e, 0.0))
    run = trial.run(Scene([target, ball]), 2.0)
    share = 1.0 if is_wall else mass / (1 + mass)
    v_ball = 1 - (1 + e) * share
    v_target = 0.0 if is_wall else (1 + e) / (1 + mass)
    return largest(run.velocities[-1] - [[v_target, 0.0], [v_ball, 0.0]])
