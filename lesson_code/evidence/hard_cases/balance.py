"""Families of bodies in balance, which barely stand or share a load."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.loads import STANDS
from lesson_code.evidence.hard_cases.measures import (
    HAIR,
    NO_DRIFT,
    NOT_SEEN,
    RATIO,
    angle_of,
    pair_forces,
    relative_errors,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.formulas import polygon_area, polygon_centroid
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference.rigid_body_closed_forms import wedge_forces

THEME = "Balance"

DOWN = (0, -scenes.GRAVITY)

BESIDE = (1e-4, 0.2)
"""How far from its limit a friction or an angle is drawn, relative: from a hair to a fifth."""

MOVES = 0.1
"""m: what slips, tips or slides has moved by more than this."""


def stay_or_go(should_stay: bool, way: float) -> float:
    """Return how far what should stay has moved, m; or infinity if what should go has not.

    >>> stay_or_go(True, 1e-6), stay_or_go(False, 1.0), stay_or_go(False, 1e-6)
    (1e-06, 0.0, inf)
    """
    if should_stay:
        return way
    return 0.0 if way > MOVES else math.inf


@family(
    THEME,
    why="Three posts, and two equations: many answers are right, and one of them is fair.",
    law="Equal posts at equal distances carry equal loads (the least change of all impulses).",
    unit="",
    bound=1e-6,
    reason="far below what a scale would show",
)
def beam_on_three_posts(draw: Draw, trial: Trial) -> float:
    """A beam of any mass on three posts: how uneven the loads are after half a second."""
    half, mass = draw.uniform("half_width", 0.5, 5.0), draw.log_uniform("mass", 1e-3, 1e3)
    width = 0.2 * half
    posts = [Body(Polygon.box(width, 1), position=(x, -0.5)) for x in (-half, 0.0, half)]
    beam = Body(Polygon.box(2 * half + width, 0.5), mass=mass, position=(0, 0.25 + start_gap(draw)))
    forces = pair_forces(trial.run(Scene([*posts, beam], gravity=DOWN), 0.5, sample=None))
    measured = [forces.get((n, 3), 0.0) for n in range(3)]
    return relative_errors(measured, mass * scenes.GRAVITY / 3)


@family(
    THEME,
    why="The further out the posts stand, the more one error turns the plank.",
    law="The law of the lever: the loads of both posts are as the distances of the other",
    unit="",
    bound=1e-8,
    reason="rounding, and some room for the thickness of the plank",
)
def plank_on_two_posts(draw: Draw, trial: Trial) -> float:
    """A plank lies unevenly on two narrow posts: their loads after half a second."""
    left, right = draw.uniform("left", 0.1, 2.0), draw.uniform("right", 0.1, 2.0)
    mass, gap = draw.log_uniform("mass", 1e-3, 1e3), start_gap(draw)
    posts = [Body(Segment((x, 0), (x, -1))) for x in (-left, right)]
    plank = Body(Polygon.box(6, 0.1), mass=mass, position=(0, 0.05 + gap))
    forces = pair_forces(trial.run(Scene([*posts, plank], gravity=DOWN), 0.5, sample=None))
    measured = [forces.get((n, 2), 0.0) for n in range(2)]
    share = np.array([right, left]) / (left + right)
    return relative_errors(measured, mass * scenes.GRAVITY * share)


def disc_in_wedge(left: float, right: float, mass: float, gap: float) -> Scene:
    """Return a smooth disc between two walls, a gap above the place where it touches both."""
    *walls, disc = scenes.disc_in_wedge(left, right).bodies
    x, y = disc.position
    lifted = Body(disc.shape, mass=mass, position=(x, y + gap), material=disc.material)
    return Scene([*walls, lifted], gravity=DOWN)


@family(
    THEME,
    why="In a narrow wedge the contacts push nearly against each other.",
    law="Lami: the forces of the walls are as the sines of the other's angle.",
    unit="",
    bound=1e-8,
    reason="rounding of a place, times the square of the force over the weight, 1e3",
)
def disc_in_a_wedge(draw: Draw, trial: Trial) -> float:
    """A disc of any mass in a wedge of 14 to 150 degrees: the forces of the walls after 1 s."""
    left, right = angle_of(draw, "left", 15, 83), angle_of(draw, "right", 15, 83)
    mass, gap = draw.log_uniform("mass", 1e-6, 1e6), start_gap(draw)
    run = trial.run(disc_in_wedge(left, right, mass, gap), 1.0, sample=None)
    forces = pair_forces(run)
    measured = [forces.get((n, 2), 0.0) for n in range(2)]
    return relative_errors(measured, wedge_forces(mass * scenes.GRAVITY, left, right))


@family(
    THEME,
    why="Each disc wedges the ones below it apart, and the walls have to take it.",
    law="No disc sinks into another or into a wall, and none falls through.",
    unit="",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def funnel(draw: Draw, trial: Trial) -> float:
    """A column of 2 to 4 discs of any masses in a funnel: deepest overlap after 4 s, in widths."""
    angle, gap = angle_of(draw, "angle", 30, 80), start_gap(draw, 4)
    *walls, disc = scenes.disc_in_wedge(angle, angle).bodies
    rough, (x, y) = Material(0.0, draw.uniform("friction", 0.0, 1.0)), disc.position
    discs = [
        replace(
            disc,
            mass=(mass := draw.log_uniform(f"mass_{n}", 1e-3, 1e3)),
            inertia=mass / 2,
            position=(x, y + gap + (2 + gap) * n),
            material=rough,
        )
        for n in range(draw.integer("count", 2, 4))
    ]
    run = trial.run(Scene([*walls, *discs], gravity=DOWN), 4.0, sample=None)
    aside, height = np.abs(run.positions[:, 2:, 0]), run.positions[:, 2:, 1]
    rim = max(abs(end) for end, _ in walls[0].shape.outline)  # a heavy disc may throw one over it
    has_fallen = ((aside < rim) & (height < aside * math.tan(angle))).any()
    return math.inf if has_fallen else float(run.max_penetration[-1]) / 2  # a disc is 2 m wide


@family(
    THEME,
    why="Friction alone keeps the lower two from rolling apart: it has to be exact.",
    law="It stands if mu >= tan(a / 2), a between the vertical and the line of two centres.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def three_logs(draw: Draw, trial: Trial) -> float:
    """A log on two that do not touch, with a friction on either side of its limit, 5 s."""
    half_gap, gap = draw.uniform("half_gap", 0.52, 0.8), start_gap(draw, 2, most=HAIR)
    limit = math.tan(math.asin(half_gap) / 2)
    beside, stays = draw.log_uniform("beside", *BESIDE), draw.choice("stays", (1, 0))
    surface = Material(0.0, limit * (1 + beside if stays else 1 - max(beside, 0.05)))
    height = 0.5 + gap + math.sqrt(1 - half_gap**2) + gap
    places = [(-half_gap, 0.5 + gap), (half_gap, 0.5 + gap), (0.0, height)]
    logs = [Body(Circle(0.5), mass=1, position=place, material=surface) for place in places]
    return stay_or_go(
        bool(stays), unrest(trial.run(Scene([scenes.level_ground(), *logs], gravity=DOWN), 5.0))
    )


def arch(thickness: float, stones: int, friction: float, pressed: float = 0.0) -> Scene:
    """Return an arch of wedge-shaped stones, without mortar, half a circle of 1 m.

    Parameters
    ----------
    thickness : float
        Thickness of the arch, m; its middle line has a radius of 1 m.
    stones : int
        How many.
    friction : float
        Of stones and floor.
    pressed : float
        By what angle each stone is longer at both ends, rad.
    """
    surface = Material(0.0, friction)
    radii, part = (1 - thickness / 2, 1 + thickness / 2), math.pi / stones
    bodies = [Body(Segment((-5, 0), (5, 0)), material=surface)]
    for n in range(stones):
        ends = (n * part - pressed, (n + 1) * part + pressed)
        turns = [(radii[i], ends[j]) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
        corners = np.array([(r * math.cos(t), r * math.sin(t)) for r, t in turns])
        x, y = polygon_centroid(corners).tolist()
        mass = float(polygon_area(corners))
        bodies.append(Body(Polygon(corners), mass=mass, position=(x, y), material=surface))
    return Scene(bodies, gravity=DOWN)


@family(
    THEME,
    why="The line of thrust just fits into the stones: a joint that gives way moves it out.",
    law="Milankovitch: half a circle stands from t / R = 0.1075 on.",
    unit="m",
    bound=NOT_SEEN,
    reason="a thousandth of the radius",
)
def arch_of_stones(draw: Draw, trial: Trial) -> float:
    """An arch of 5 to 15 stones, 0.12 to 0.3 thick for a radius of 1 m, 3 s."""
    pressed = draw.choice("pressed", (0.0, draw.log_uniform("pressed_by", 1e-12, 1e-4)))
    scene = arch(
        draw.uniform("thickness", 0.12, 0.3),
        draw.integer("stones", 5, 15),
        draw.uniform("friction", 0.6, 1.0),
        pressed,
    )
    return unrest(trial.run(scene, 3.0))


def ladder(lean: float, friction: float, length: float = 2.0, gap: float = 0.0) -> Scene:
    """Return a ladder that leans against a smooth wall, on a rough floor; it is body 2.

    Parameters
    ----------
    lean : float
        From the vertical, rad.
    friction : float
        Of the floor.
    length : float
        m.
    gap : float
        Of the foot and the floor, and of the head and the wall, m.
    """
    rough, smooth, half = Material(0.0, friction), Material(0.0, 0.0), length / 2
    rod = Body(
        Segment((-half, 0), (half, 0)),
        mass=1,
        position=(half * math.sin(lean) + gap, half * math.cos(lean) + gap),
        angle=math.pi / 2 + lean,
        material=rough,
    )
    floor, wall = Segment((-50, 0), (50, 0)), Segment((0, -1), (0, 50))
    return Scene([Body(floor, material=rough), Body(wall, material=smooth), rod], gravity=DOWN)


@family(
    THEME,
    why="Friction at the foot holds by a hair, and the wall pushes with what it holds.",
    law="It stands if mu >= tan(a) / 2.",
    unit="m",
    bound=NOT_SEEN,
    reason="a thousandth of 1 m; what comes further in this time slips",
)
def ladder_at_a_wall(draw: Draw, trial: Trial) -> float:
    """A ladder at a smooth wall at any angle, on either side of slipping, 4 s."""
    lean, gap = angle_of(draw, "lean", 5, 70), start_gap(draw, most=HAIR)
    beside, stays = draw.log_uniform("beside", *BESIDE), draw.choice("stays", (1, 0))
    limit = math.tan(lean) / 2
    friction = limit * (1 + beside if stays else 1 - max(beside, 0.05))
    length = draw.uniform("length", 1.0, 4.0)
    return stay_or_go(bool(stays), unrest(trial.run(ladder(lean, friction, length, gap), 4.0)))


@family(
    THEME,
    why="Each block leans on the next one, and the last on a wall: one chain of forces.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def leaning_blocks(draw: Draw, trial: Trial) -> float:
    """A row of 1 to 4 blocks leans on a wall like books on a shelf, 4 s."""
    lean, width = angle_of(draw, "lean", 6, 20), draw.uniform("width", 0.05, 0.15)
    cos, sin, gap = math.cos(lean), math.sin(lean), start_gap(draw, 4)
    surface = Material(0.0, draw.uniform("friction", 0.7, 1.0))
    first = (width / 2 * cos + sin + gap, width / 2 * sin + cos + gap)  # blocks are 2 m high
    blocks = [
        Body(
            Polygon.box(width, 2),
            mass=1,
            position=(first[0] + n * (width + gap) / cos, first[1]),
            angle=lean,
            material=surface,
        )
        for n in range(draw.integer("count", 1, 4))
    ]
    wall = Body(Segment((0, -1), (0, 9)), material=surface)
    return unrest(trial.run(Scene([scenes.level_ground(), wall, *blocks], gravity=DOWN), 4.0))


@family(
    THEME,
    why="Two bodies of very different masses balance on one edge.",
    law="The law of the lever: m_1 l_1 = m_2 l_2",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def seesaw(draw: Draw, trial: Trial) -> float:
    """A plank on a wide post carries two boxes in balance, of masses up to 1e9 apart, 3 s."""
    gap, ratio = start_gap(draw, 2), draw.log_uniform("ratio", 1 / RATIO, RATIO)
    surface, near = Material(0.0, 0.6), draw.uniform("near", 0.6, 1.2)
    far = near * draw.uniform("arm_ratio", 1.0, 2.0)
    masses = {-near: ratio * far / near, far: ratio}
    post = Body(Polygon.box(0.4, 1), position=(0, -0.5), material=surface)
    plank = Body(Polygon.box(6, 0.2), mass=1, position=(0, 0.1 + gap), material=surface)
    boxes = [
        Body(Polygon.box(0.5, 0.5), mass=m, position=(x, 0.45 + 2 * gap), material=surface)
        for x, m in masses.items()
    ]
    return unrest(trial.run(Scene([post, plank, *boxes], gravity=DOWN), 3.0))
