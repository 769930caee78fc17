"""Families of rods and corners that hit a floor, with friction and gravity."""

from __future__ import annotations

import math

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import (
    ROUNDING,
    STEP,
    TOUCH,
    energy_above,
    gain,
    largest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import corner_impacts
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, level_ground
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference import impact_closed_forms as closed

THEME = "Rods and corners"

NO_GAIN = "Energy never grows."

BOUNCES = "rounding of some hundred bounces"


def rod_on_floor(
    angle: float, vx: float, vy: float, w: float = 0.0, e: float = 0.0, mu: float = 2.0
) -> Scene:
    """Return a rod of 1 kg and 2 m whose lower tip is just in a rough floor."""
    surface = Material(e, mu)
    rod = Body(
        Segment((-1, 0), (1, 0)),
        mass=1,
        position=(0, math.sin(angle) - TOUCH),
        angle=angle,
        velocity=(vx, vy),
        angular_velocity=w,
        material=surface,
    )
    return Scene([Body(Segment((-50, 0), (50, 0)), material=surface), rod])


KANE = {"angle": math.pi / 4, "vx": 0.0, "vy": -1.0, "w": 2.0, "e": 1.0, "mu": 1.0}
"""A rod that falls and turns, and does not slide at first. By Newton's rule with e = 1 this
off-centre impact raises the energy by 56 %."""


def thrown_rod(draw: Draw, surface: Material) -> Scene:
    """Return a rod of 1 m, of any slenderness, thrown at a floor; gravity acts."""
    thickness = 1.0 / draw.log_uniform("slenderness", 2.0, 1000.0)
    rod = Body(
        Polygon.box(1.0, thickness),
        mass=draw.log_uniform("mass", 1e-3, 1e3),
        position=(0, 0.6 + draw.uniform("drop", 0.0, 1.0)),
        angle=draw.uniform("angle", 0.0, math.pi),
        velocity=(draw.uniform("vx", -3.0, 3.0), draw.uniform("vy", -5.0, 0.0)),
        angular_velocity=draw.uniform("spin", -10.0, 10.0),
        material=surface,
    )
    return Scene([level_ground(), rod], gravity=(0, -GRAVITY))


@family(
    THEME,
    why="A thin rod turns far in a step, and each end hits the floor in turn.",
    law=NO_GAIN,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def rod_on_smooth_floor(draw: Draw, trial: Trial) -> float:
    """A rod of 1:2 to 1:1000 is thrown at a smooth floor with any e: gain of energy in 2 s."""
    scene = thrown_rod(draw, Material(draw.uniform("restitution", 0.0, 1.0), 0.0))
    return gain(energy_above(trial.run(scene, 2.0, sample=None)))


@family(
    THEME,
    why="What is lost at each of many hits of the ends adds up.",
    law="With e = 1 and mu = 0 the energy is kept.",
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def elastic_rod(draw: Draw, trial: Trial) -> float:
    """An elastic rod of 1:2 to 1:1000 is thrown at a smooth floor: change of energy in 2 s."""
    energies = energy_above(trial.run(thrown_rod(draw, Material(1.0, 0.0)), 2.0, sample=None))
    return largest(energies / energies[0] - 1)


@family(
    THEME,
    why="Newton's e with friction can gain energy in an impact beside the centre.",
    law=NO_GAIN,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def rod_on_rough_floor(draw: Draw, trial: Trial) -> float:
    """A rod of 1:2 to 1:1000 is thrown at a rough floor, any e, mu to 2: gain of energy in 2 s."""
    e, mu = draw.uniform("restitution", 0.0, 1.0), draw.uniform("friction", 0.0, 2.0)
    return gain(energy_above(trial.run(thrown_rod(draw, Material(e, mu)), 2.0, sample=None)))


@family(
    THEME,
    why="A dull impact with friction stops a tip, and the other one comes down at once.",
    law=NO_GAIN,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def dull_rod_on_rough_floor(draw: Draw, trial: Trial) -> float:
    """A rod of 1:2 to 1:1000 is thrown at a rough floor, e = 0: gain of energy in 2 s."""
    scene = thrown_rod(draw, Material(0.0, draw.uniform("friction", 0.0, 2.0)))
    return gain(energy_above(trial.run(scene, 2.0, sample=None)))


@family(
    THEME,
    why="Its foot stands on two corners that are close together, and then on one.",
    law="It topples, and energy never grows.",
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def toppling_rod(draw: Draw, trial: Trial) -> float:
    """A rod of 1:2 to 1:1000 stands on its end, tilted over its corner: gain of energy in 4 s."""
    thickness = 1.0 / draw.log_uniform("slenderness", 2.0, 1000.0)
    tilt = math.atan(thickness) * draw.uniform("over", 1.05, 1.5) + draw.uniform("tilt", 0.0, 0.1)
    surface = Material(0.0, draw.uniform("friction", 0.0, 2.0))
    low = -0.5 * math.cos(tilt) - thickness / 2 * math.sin(tilt)
    rod = Body(
        Polygon.box(thickness, 1.0), mass=1, position=(0, -low), angle=tilt, material=surface
    )
    run = trial.run(Scene([level_ground(), rod], gravity=(0, -GRAVITY)), 4.0, sample=None)
    lies = float(run.positions[-1, 1, 1]) < 0.6 * float(run.positions[0, 1, 1])
    return gain(energy_above(run)) if lies else math.inf


@family(
    THEME,
    why="The impact is beside the centre of the rod, which turns and hits with its other end.",
    law=NO_GAIN,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def ball_on_rod(draw: Draw, trial: Trial) -> float:
    """A ball falls on a smooth rod that lies on a floor, any e: gain of energy in 3 s."""
    surface = Material(draw.uniform("restitution", 0.0, 1.0), 0.0)
    thickness = 1.0 / draw.log_uniform("slenderness", 1.0, 100.0)
    rod = Body(Polygon.box(2, thickness), mass=1, position=(0, thickness / 2), material=surface)
    ball = Body(
        Circle(0.2),
        mass=draw.log_uniform("mass", 1e-2, 1e2),
        position=(draw.uniform("beside", -0.9, 0.9), thickness + 0.2 + draw.uniform("drop", 0, 2)),
        material=surface,
    )
    run = trial.run(Scene([level_ground(), rod, ball], gravity=(0, -GRAVITY)), 3.0, sample=None)
    return gain(energy_above(run))


@family(
    THEME,
    why="The end of a rod yields to a blow as if the rod had a quarter of its mass.",
    law="Momentum, angular momentum and e",
    unit="m/s",
    bound=1e-8,
    reason="the ball and the rod overlap by 1e-9 m",
)
def ball_at_free_rod(draw: Draw, trial: Trial) -> float:
    """A ball hits a free rod anywhere, with any e and masses to 1e6: all velocities after it."""
    arm, e = draw.uniform("arm", -1.0, 1.0), draw.uniform("restitution", 0.0, 1.0)
    ball_mass, rod_mass = (draw.log_uniform(name, 1e-3, 1e3) for name in ("ball", "rod"))
    surface = Material(e, 0.0)
    rod = Body(Segment((-1, 0), (1, 0)), mass=rod_mass, material=surface)
    ball = Body(
        Circle(0.25),
        mass=ball_mass,
        position=(arm, TOUCH - 0.25),
        velocity=(0, 1),
        material=surface,
    )
    run = trial.run(Scene([rod, ball]), STEP, dt=STEP)
    after = closed.off_centre_hit(ball_mass, 1.0, rod_mass, rod_mass / 3, arm, e)
    found = (run.velocities[-1, 1, 1], run.velocities[-1, 0, 1], run.angular_velocities[-1, 0])
    return largest([f - x for f, x in zip(found, after, strict=True)])


@family(
    THEME,
    why="Two points at once: what one does to the other is forgotten by a short sweep.",
    law="vy' = e vy, w' = 0",
    unit="m/s",
    bound=1e-12,
    reason="rounding",
)
def flat_landing(draw: Draw, trial: Trial) -> float:
    """A box of 1:100 to 100:1 lands flat at 1 m/s, any e: error of velocity and turning."""
    e, ratio = draw.uniform("restitution", 0.0, 1.0), draw.log_uniform("ratio", 0.01, 100.0)
    width, height = math.sqrt(ratio), 1 / math.sqrt(ratio)
    box = Body(
        Polygon.box(width, height),
        mass=draw.log_uniform("mass", 1e-3, 1e3),
        position=(0, height / 2 - TOUCH),
        velocity=(0, -1),
        material=Material(e, 0.0),
    )
    run = trial.run(Scene([level_ground(), box]), STEP, dt=STEP)
    vx, vy = run.velocities[-1, 1]
    return largest([vx, vy - e, run.angular_velocities[-1, 1]])


@family(
    THEME,
    why="mu knt > knn: each sweep of friction overthrows the normal impulse, for ever.",
    law="jn = -vn / (knn + mu knt)",
    unit="",
    bound=1e-7,
    reason="the tip turns by 1e-9 in the step, and jams where mu is large",
)
def drawn_rod(draw: Draw, trial: Trial) -> float:
    """A rod is drawn over a floor at any angle, mu to 2: the impulse at its tip."""
    angle, mu = draw.uniform("angle", 0.3, 1.3), draw.uniform("friction", 0.0, 2.0)
    vy = -draw.log_uniform("approach", 1e-3, 0.1)
    impulses = trial.run(
        rod_on_floor(angle, 1.0, vy, mu=mu), STEP, sample=None, dt=STEP
    ).contacts.normal_impulse
    cos, sin = math.cos(angle), math.sin(angle)
    knn, knt = 1 + 3 * cos**2, 3 * cos * sin
    return abs(float(impulses.sum()) * (knn + mu * knt) / -vy - 1)


@family(
    THEME,
    why="Painleve's paradox: no finite force lets the tip slide on. It jams at once.",
    law="Impulses that stop the tip",
    unit="m/s",
    bound=1e-9,
    reason="rounding of places before and after a step of 1e-9 s",
)
def pushed_rod(draw: Draw, trial: Trial) -> float:
    """A rod is pushed over a floor, mu above Painleve's limit: velocity of its tip after it."""
    angle = draw.uniform("angle", 0.9, 1.2)
    limit = (1 + 3 * math.cos(angle) ** 2) / (3 * math.cos(angle) * math.sin(angle))
    mu = limit * (1 + draw.log_uniform("beside", 1e-2, 1.0))
    vy = -draw.log_uniform("approach", 1e-3, 0.1)
    run = trial.run(rod_on_floor(angle, -1.0, vy, mu=mu), STEP, dt=STEP)
    w = float(run.angular_velocities[-1, 1])
    vx, vy = run.velocities[-1, 1].tolist()
    return largest([vx + w * math.sin(angle), vy - w * math.cos(angle)])


@family(
    THEME,
    why="By Newton's rule one such impact in forty gains energy, and nothing shows which.",
    law="Stronge: e^2 is the work given back over the work taken.",
    unit="",
    bound=1e-10,
    reason="rounding: an impact gains nothing",
)
def corner_energy(draw: Draw, trial: Trial) -> float:
    """A box of any shape hits a rough floor with a corner, any e, mu to 2: gain of energy."""
    box, _ = corner_impacts.box_on_corner(
        draw.log_uniform("width", 0.1, 3.0),
        draw.log_uniform("height", 0.1, 3.0),
        angle=draw.uniform("angle", 0.2, 1.3),
        velocity=(draw.uniform("vx", -3.0, 3.0), draw.uniform("vy", -4.0, -1.0)),
        angular_velocity=draw.uniform("spin", -2.0, 2.0),
        surface=Material(draw.uniform("restitution", 0.0, 1.0), draw.uniform("friction", 0.0, 2.0)),
    )
    step = corner_impacts.STEP
    return gain(trial.run(Scene([level_ground(), box]), step, dt=step).kinetic_energy)


@family(
    THEME,
    why="A rod that falls and turns, and does not slide at first, is Kane's paradox.",
    law="Stronge: e^2 is the work given back over the work taken.",
    unit="",
    bound=1e-10,
    reason="rounding: an impact gains nothing",
)
def tip_energy(draw: Draw, trial: Trial) -> float:
    """A turning rod hits a rough floor with its tip, any e, mu to 2: gain of energy."""
    scene = rod_on_floor(
        draw.uniform("angle", 0.2, 1.4),
        draw.uniform("vx", -2.0, 2.0),
        -draw.uniform("vy", 0.5, 2.0),
        draw.uniform("spin", -3.0, 3.0),
        draw.uniform("restitution", 0.0, 1.0),
        draw.uniform("friction", 0.0, 2.0),
    )
    return gain(trial.run(scene, STEP, dt=STEP).kinetic_energy)
