"""Hard cases: bodies in balance, which barely stand or share a load."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.loads import DT, NOT_SEEN, SUNK
from lesson_code.evidence.hard_cases.measures import drift, pair_forces, relative_errors, way_of
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.formulas import polygon_area, polygon_centroid
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference.rigid_body_closed_forms import wedge_forces

THEME = "Balance"


def beam_on_posts() -> Scene:
    """Return a beam of 6 kg on three posts of one width: six points that share the load."""
    posts = [Body(Polygon.box(0.2, 1), position=(x, -0.5)) for x in (-1.9, 0.0, 1.9)]
    beam = Body(Polygon.box(4, 0.5), mass=6, position=(0, 0.25 - SUNK))
    return Scene([*posts, beam], gravity=(0, -scenes.GRAVITY))


def unevenness(trial: Trial) -> float:
    """Return how far the force on a post is from a third of the weight, as a part of it."""
    forces = pair_forces(trial.run(0.5), DT)
    return relative_errors([forces.get((n, 3), 0.0) for n in range(3)], 2 * scenes.GRAVITY)


def disc_in_narrow_wedge() -> Scene:
    """Return a smooth disc that touches two walls at 80 degrees."""
    scene = scenes.disc_in_wedge(*NARROW)
    left, right, disc = scene.bodies
    x, y = disc.position
    lowered = Body(disc.shape, mass=disc.mass, position=(x, y - SUNK), material=disc.material)
    return Scene([left, right, lowered], gravity=scene.gravity)


NARROW = (math.radians(80), math.radians(80))
"""rad: the walls of a narrow wedge. Each has to hold nearly three times the weight."""


def wedge_errors(trial: Trial) -> float:
    """Return the relative error of the forces of both walls after a second."""
    forces = pair_forces(trial.run(1.0), DT)
    measured = [forces.get((n, 2), 0.0) for n in range(2)]
    return relative_errors(measured, wedge_forces(scenes.GRAVITY, *NARROW))


def three_logs() -> Scene:
    """Return two discs side by side with a gap of a tenth of their width, and a third on them."""
    surface, half_gap = Material(0.0, 0.5), 0.55
    height = 0.5 + math.sqrt((1 - SUNK) ** 2 - half_gap**2) - SUNK
    places = [(-half_gap, 0.5 - SUNK), (half_gap, 0.5 - SUNK), (0.0, height)]
    logs = [Body(Circle(0.5), mass=1, position=place, material=surface) for place in places]
    return Scene([scenes.level_ground(), *logs], gravity=(0, -scenes.GRAVITY))


def arch(thickness: float, stones: int = 11) -> Scene:
    """Return an arch of wedge-shaped stones, without mortar, half a circle of 1 m.

    Parameters
    ----------
    thickness : float
        Thickness of the arch, m; its middle line has a radius of 1 m.
    stones : int
        How many.
    """
    surface = Material(0.0, 0.7)
    radii, part = (1 - thickness / 2, 1 + thickness / 2), math.pi / stones
    bodies = [Body(Segment((-5, 0), (5, 0)), material=surface)]
    for n in range(stones):
        ends = (n * part - PRESSED, (n + 1) * part + PRESSED)
        places = (
            (radii[0], ends[0]),
            (radii[1], ends[0]),
            (radii[1], ends[1]),
            (radii[0], ends[1]),
        )
        corners = np.array([(r * math.cos(t), r * math.sin(t)) for r, t in places])
        x, y = polygon_centroid(corners).tolist()
        mass = float(polygon_area(corners))
        bodies.append(Body(Polygon(corners), mass=mass, position=(x, y), material=surface))
    return Scene(bodies, gravity=(0, -scenes.GRAVITY))


PRESSED = 1e-4
"""rad: each stone is longer by this angle at both ends, so that neighbours touch."""

LEANS = math.radians(30)
"""rad, from the vertical."""


def ladder(friction: float) -> Scene:
    """Return a ladder of 2 m that leans against a smooth wall, on a rough floor; it is body 2."""
    rough, smooth = Material(0.0, friction), Material(0.0, 0.0)
    rod = Body(
        Segment((-1, 0), (1, 0)),
        mass=1,
        position=(math.sin(LEANS) - SUNK, math.cos(LEANS) - SUNK),
        angle=math.pi / 2 + LEANS,
        material=rough,
    )
    floor, wall = Segment((-5, 0), (5, 0)), Segment((0, -1), (0, 5))
    return Scene(
        [Body(floor, material=rough), Body(wall, material=smooth), rod],
        gravity=(0, -scenes.GRAVITY),
    )


LEAST = math.tan(LEANS) / 2
"""The friction coefficient below which the ladder slips."""


def ladder_way(trial: Trial) -> float:
    """Return how far a ladder moves in 5 s with 1 % more friction than it needs, m.

    The result is infinite if a ladder with 1 % too little friction does not slip.
    """
    slips = way_of(trial.run(5.0, ladder(0.99 * LEAST), sample="end"))
    stays = way_of(trial.run(5.0, ladder(1.01 * LEAST), sample="end"))
    return stays if slips > 0.1 else math.inf


CASES = (
    HardCase(
        name="even-load",
        theme=THEME,
        title="A beam on three posts",
        why="Three posts, and two equations: many answers are right, and one of them is fair.",
        law="Equal posts carry equal loads (the least change of all impulses).",
        scene=beam_on_posts,
        measure=unevenness,
        unit="",
        bound=1e-6,
        reason="far below what a scale would show",
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="narrow-wedge",
        theme=THEME,
        title="A disc in a wedge of 20 degrees",
        why="The two contacts push nearly against each other: a sweep undoes what the last did.",
        law="N = W / (2 cos 80 degrees)",
        scene=disc_in_narrow_wedge,
        measure=wedge_errors,
        unit="",
        bound=1e-9,
        reason="rounding, times the square of the force over the weight",
        failed_by=("naive", "box2d"),
    ),
    HardCase(
        name="three-logs",
        theme=THEME,
        title="A log on two that do not touch each other, 10 s",
        why="Friction alone keeps the lower two from rolling apart: it has to be exact.",
        law="It stands if mu >= tan(a / 2), a between the vertical and the line of two centres.",
        scene=three_logs,
        measure=drift(10.0),
        unit="m",
        bound=NOT_SEEN,
        reason="a thousandth of a log; what comes further in this time does not stand",
        failed_by=("naive",),
    ),
    HardCase(
        name="arch",
        theme=THEME,
        title="An arch of 11 stones, 12 cm thick for a radius of 1 m, 5 s",
        why="The line of thrust just fits into the stones: a joint that gives way moves it out.",
        law="Milankovitch: half a circle stands from t / R = 0.1075 on.",
        scene=partial(arch, 0.12),
        measure=drift(5.0),
        unit="m",
        bound=NOT_SEEN,
        reason="a thousandth of the radius",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="ladder",
        theme=THEME,
        title="A ladder at a smooth wall, 1 % on both sides of slipping",
        why="Friction at the foot holds by a hair, and the wall pushes with what it holds.",
        law="It stands if mu >= tan(a) / 2.",
        scene=partial(ladder, 1.01 * LEAST),
        measure=ladder_way,
        unit="m",
        bound=1e-9,
        reason="rounding of 300 steps",
        failed_by=("naive", "pymunk"),
    ),
)
