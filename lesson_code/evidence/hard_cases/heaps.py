"""Families of heaps: many bodies that fall on one another, more than are solved at once."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from lesson_code.engine.core.constants import MOST_DRIFTING, MOST_FALLING
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.bounces import ELASTIC, KEEPS, energy_error
from lesson_code.evidence.hard_cases.collisions import any_surface, change_of_momentum, rush
from lesson_code.evidence.hard_cases.loads import STANDS, tower
from lesson_code.evidence.hard_cases.measures import ROUNDING, free, gain, largest, rise, start_gap
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.stacks import NOT_LEANING, SIDEWAYS
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

THEME = "Heaps"

MOST = 120
"""Bodies of a heap: pymunk takes some seconds for as many."""

KINDS = ("disc", "box", "plank", "capsule", "mixed")

CELL = 2.4
"""Of the largest radius: from one body to the next at the start."""


class Heap(NamedTuple):
    """Bodies above a bin into which they fall."""

    scene: Scene
    size: float  # m, the largest radius
    width: float  # m, of the bin
    fall: float  # s, from the top to the floor


def poured(
    draw: Draw,
    surface: Material,
    ratio: float = 100.0,
    kinds: tuple[str, ...] = KINDS,
    smallest: float | None = None,
) -> Heap:
    """Draw bodies of one kind or of all, at rest in rows above the floor of a bin, of any size.

    The smallest is half as large as the largest, or some other part of it: then all are of one
    density, and `ratio` counts beside it.
    """
    count = round(draw.log_uniform("count", MOST_FALLING + 1, MOST))
    kind = draw.choice("kind", kinds)
    size, masses = draw.log_uniform("size", 0.03, 3.0), draw.log_uniform("ratio", 1.0, ratio)
    rng = np.random.default_rng(draw.integer("places", 0, 10**9))
    columns, cell = math.ceil(0.8 * math.sqrt(count)), CELL * size
    bodies = []
    for n in range(count):
        what = str(rng.choice(KINDS[:-1])) if kind == "mixed" else kind
        part = rng.uniform(0.5, 1) if smallest is None else smallest ** rng.uniform(0, 1)
        area = 1.0 if smallest is None else part**2
        bodies.append(
            Body(
                shape_of(what, size * part),
                mass=float(area * masses ** rng.uniform(0, 1)),
                position=((n % columns + 0.5) * cell, (n // columns + 1) * cell),
                angle=float(rng.uniform(0, 2 * math.pi)),
                material=surface,
            )
        )
    width, height = columns * cell, 3 * (count // columns + 2) * cell
    ends = ((0, height), (0, 0), (width, 0), (width, height))
    walls = [Body(Segment(a, b), material=surface) for a, b in pairwise(ends)]
    fall = math.sqrt(2 * height / 3 / GRAVITY)
    return Heap(Scene([*bodies, *walls], gravity=(0, -GRAVITY)), size, width, fall)


def shape_of(kind: str, radius: float) -> Shape:
    """Return a body that fits into a circle."""
    shapes: dict[str, Shape] = {
        "disc": Circle(radius),
        "box": Polygon.box(1.4 * radius, radius),
        "plank": Polygon.box(1.9 * radius, 0.2 * radius),
        "capsule": Segment((-0.9 * radius, 0), (0.9 * radius, 0), radius=0.1 * radius),
    }
    return shapes[kind]


def outside(heap: Heap, run: Run) -> int:
    """Return how many bodies have left the bin at the end."""
    x, y = run.positions[-1, free(run.scene)].T
    return int(((x < 0) | (x > heap.width) | (y < 0)).sum())


@family(
    THEME,
    why="A blow within a step may throw a body through its neighbours, or out of the bin.",
    law="All stay in the bin, and never have more energy than before they fell.",
    unit="",
    bound=ROUNDING,
    reason="rounding",
)
def heap_in_a_bin(draw: Draw, trial: Trial) -> float:
    """25 to 120 bodies of any size, e and mu fall into a bin: how many get out, or gain."""
    heap = poured(draw, any_surface(draw))
    run = trial.run(heap.scene, heap.fall + 1.0, sample=None)
    return outside(heap, run) or gain(run.energy)


@family(
    THEME,
    why="What carries a heap has to find its forces while bodies still arrive.",
    law="Bodies that lie on one another hardly lie in one another, and all are in the bin.",
    unit="",
    bound=0.2,
    reason="springs of a step give way by millimetres: much for bodies of 3 cm",
)
def heap_that_lies(draw: Draw, trial: Trial) -> float:
    """25 to 120 dull, rough bodies lie in a bin: how many are out, or deepest overlap over size."""
    surface = Material(draw.uniform("restitution", 0.0, 0.3), draw.uniform("friction", 0.3, 1.0))
    heap = poured(draw, surface, ratio=10.0)
    run = trial.run(heap.scene, heap.fall + 100 * math.sqrt(heap.size / GRAVITY))
    return outside(heap, run) or float(run.max_penetration[-1]) / heap.size


@family(
    THEME,
    why="What stops a heavy body goes through light ones, to which it is a blow at each change.",
    law="All stay in the box, and never have more energy than before they fell.",
    unit="",
    bound=ROUNDING,
    reason="rounding",
)
def heavy_ball_on_a_heap(draw: Draw, trial: Trial) -> float:
    """A ball of up to 10,000 times their mass falls on 25 to 120: how many get out, or gain."""
    surface = Material(draw.uniform("restitution", 0.0, 0.5), draw.uniform("friction", 0.1, 1.0))
    heap = poured(draw, surface, ratio=2.0)
    radius = heap.size * draw.uniform("radius", 0.5, 3.0)
    filled = GRAVITY * heap.fall**2 / 2
    middle, above = heap.width / 2, filled + 6 * heap.size
    mass = draw.log_uniform("load", 1.0, 1e4)
    ball = Body(Circle(radius), mass=mass, position=(middle, above), material=surface)
    lid = Body(Segment((0, 3 * filled), (heap.width, 3 * filled)), material=surface)
    scene = Scene([*heap.scene.bodies, ball, lid], gravity=heap.scene.gravity)
    run = trial.run(scene, heap.fall + 30 * math.sqrt(heap.size / GRAVITY), sample=None)
    y = run.positions[-1, free(scene), 1]
    return int((y > 3 * filled).sum()) + outside(heap, run) or gain(run.energy)


@family(
    THEME,
    why="The large press on the small at a few points, and roll over them.",
    law="All stay in the bin, and never have more energy than before they fell.",
    unit="",
    bound=ROUNDING,
    reason="rounding",
)
def heap_of_all_sizes(draw: Draw, trial: Trial) -> float:
    """25 to 120 bodies up to 50 times as large as others fall: how many get out, or gain."""
    surface = Material(draw.uniform("restitution", 0.0, 0.5), draw.uniform("friction", 0.1, 1.0))
    heap = poured(draw, surface, ratio=2.0, smallest=draw.log_uniform("smallest", 0.02, 1.0))
    run = trial.run(heap.scene, heap.fall + 30 * math.sqrt(heap.size / GRAVITY), sample=None)
    return outside(heap, run) or gain(run.energy)


@family(
    THEME,
    why="They never come to rest, and collide some thousand times.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason="rounding of some thousand bounces",
)
def elastic_discs_falling(draw: Draw, trial: Trial) -> float:
    """25 to 120 elastic, smooth discs fall into a bin, 5 s: change of energy."""
    return energy_error(trial.run(poured(draw, ELASTIC, kinds=("disc",)).scene, 5.0))


@family(
    THEME,
    why="Steps see an impact once the bodies overlap, and those beside it press them on.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason="rounding of some thousand bounces",
)
def elastic_shapes_falling(draw: Draw, trial: Trial) -> float:
    """25 to 120 elastic, smooth bodies of other kinds fall into a bin, 5 s: change of energy."""
    return energy_error(trial.run(poured(draw, ELASTIC, kinds=KINDS[1:]).scene, 5.0))


@family(
    THEME,
    why="More than are solved at once: rough impacts are where Newton's restitution gains energy.",
    law="Momentum is kept, and energy never grows.",
    unit="",
    bound=ROUNDING,
    reason="rounding of some thousand collisions",
)
def large_crowd(draw: Draw, trial: Trial) -> float:
    """65 to 200 discs, boxes or rods with any e and mu rush to one place: change or gain."""
    scene = rush(draw, round(draw.log_uniform("count", MOST_DRIFTING + 1, 200)))
    run = trial.run(scene, 3.0, sample=None)
    return max(change_of_momentum(run), rise(run.kinetic_energy))


@family(
    THEME,
    why="Impacts of an island hang together, and each takes sweeps to fit the others.",
    law="Momentum and energy are kept.",
    unit="",
    bound=ROUNDING,
    reason="rounding of some thousand collisions",
)
def elastic_crowd(draw: Draw, trial: Trial) -> float:
    """65 to 200 elastic, smooth discs, boxes or rods rush to one place, 3 s: change of either."""
    scene = rush(draw, round(draw.log_uniform("count", MOST_DRIFTING + 1, 200)), ELASTIC)
    run = trial.run(scene, 3.0, sample=None)
    return max(change_of_momentum(run), energy_error(run))


@family(
    THEME,
    why="A solver that is chosen for the whole scene is chosen by bodies that are far away.",
    law=STANDS,
    unit="m",
    bound=SIDEWAYS,
    reason=NOT_LEANING,
)
def stack_among_spectators(draw: Draw, trial: Trial) -> float:
    """A stack of 2 to 20 boxes; far off 41 to 100 discs fall on its floor: drift in 10 s."""
    count, spectators = draw.integer("count", 2, 20), draw.integer("spectators", 41, 100)
    friction = draw.uniform("friction", 0.2, 1.0)
    stack = tower((1.0,) * count, gap=start_gap(draw, count), friction=friction)
    rng = np.random.default_rng(draw.integer("places", 0, 10**9))
    discs = [
        Body(Circle(0.5), mass=1.0, position=(50.0 + 2 * n, rng.uniform(1, 10)))
        for n in range(spectators)
    ]
    run = trial.run(Scene([*stack.bodies, *discs], gravity=stack.gravity), 10.0)
    boxes = free(stack)
    return largest(run.positions[-1, boxes, 0] - run.positions[0, boxes, 0])
