"""Families of loads: heavy bodies on light ones. Each sweep carries a force by one body only."""

from __future__ import annotations

from collections.abc import Sequence

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import (
    NO_DRIFT,
    NOT_SEEN,
    RATIO,
    drawn_masses,
    largest,
    pair_forces,
    relative_errors,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference.rigid_body_closed_forms import stack_forces

THEME = "Loads"

STANDS = "What stands stands."


def tower(
    masses: Sequence[float],
    *,
    gap: float = 0.0,
    restitution: float = 0.0,
    friction: float = 0.5,
    aside: float = 0.0,
    at: float = 0.0,
    size: float = 1.0,
) -> Scene:
    """Return square boxes, one on the other, on a floor.

    Parameters
    ----------
    masses : sequence of float
        From the lowest box up, kg.
    gap : float
        Between neighbours, in parts of a box; negative for an overlap.
    restitution, friction : float
        Of all.
    aside : float
        How far every other box is shifted to the right, and the rest to the left, in parts of a
        box.
    at : float
        Both coordinates of the middle of the floor, m.
    size : float
        Width and height of a box, m.

    Examples
    --------
    >>> [body.mass for body in tower([1.0, 2.0]).bodies]
    [None, 1.0, 2.0]
    """
    surface = Material(restitution, friction)
    half = scenes.HALF_LENGTH * size
    floor = Body(Segment((-half, 0), (half, 0)), position=(at, at), material=surface)
    boxes = [
        Body(
            Polygon.box(size, size),
            mass=mass,
            position=(
                at + size * (aside if n % 2 else -aside),
                at + size * (0.5 + n + (n + 1) * gap),
            ),
            material=surface,
        )
        for n, mass in enumerate(masses)
    ]
    return Scene([floor, *boxes], gravity=(0, -scenes.GRAVITY))


def elsewhere(count: int = 40) -> list[Body]:
    """Return discs that lie on the floor of a tower far to the right, apart from each other."""
    return [Body(Circle(0.5), mass=1.0, position=(20.0 + 1.5 * n, 0.5)) for n in range(count)]


def loaded(draw: Draw) -> Scene:
    """Return a load on a box, of a drawn ratio of masses and gap."""
    ratio = draw.log_uniform("ratio", 1 / RATIO, RATIO)
    return tower((1.0, ratio), gap=start_gap(draw, 2), friction=draw.uniform("friction", 0.1, 1.0))


@family(
    THEME,
    why="A sweep of impulses takes the part m/M of the load's velocity, and no more.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def load_on_box(draw: Draw, trial: Trial) -> float:
    """A load of any mass stands on a box of 1 kg, 10 s."""
    return unrest(trial.run(loaded(draw), 10.0))


@family(
    THEME,
    why="What lies far away must not change how these two are solved.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def load_among_discs(draw: Draw, trial: Trial) -> float:
    """The same load, with forty discs lying elsewhere in the scene, 5 s."""
    scene = loaded(draw)
    run = trial.run(Scene([*scene.bodies, *elsewhere()], gravity=scene.gravity), 5.0)
    moved = (run.positions[-1] - run.positions[0])[1:3]
    return max(largest(moved[:, 0]), largest(moved[:, 1]) / 2)


@family(
    THEME,
    why="A velocity of the light box that is rounding is a force as large as the ratio makes it.",
    law="N = the weight of all that stands above",
    unit="",
    bound=1e-6,
    reason="rounding, 1e-15, times the largest ratio of the masses",
)
def forces_under_load(draw: Draw, trial: Trial) -> float:
    """The forces under a load of any mass and the box below it, after a second."""
    scene = loaded(draw)
    forces = pair_forces(trial.run(scene, 1.0, sample=None))
    masses = [float(body.mass or 0.0) for body in scene.bodies[1:]]
    measured = [forces.get((n, n + 1), 0.0) for n in range(2)]
    return relative_errors(measured, stack_forces(masses, scenes.GRAVITY))


@family(
    THEME,
    why="Every contact needs the answer of all the others.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def tower_of_any_masses(draw: Draw, trial: Trial) -> float:
    """A tower of 3 to 10 boxes whose masses differ up to a billion times, 5 s."""
    masses = drawn_masses(draw, draw.integer("count", 3, 10))
    return unrest(trial.run(tower(masses, gap=start_gap(draw, len(masses))), 5.0))


@family(
    THEME,
    why="The light boxes between the heavy ones have to carry what they cannot feel.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def light_and_heavy_in_turn(draw: Draw, trial: Trial) -> float:
    """A tower of 4 to 10 boxes, light and heavy in turn, 5 s."""
    ratio = draw.log_uniform("ratio", 1 / RATIO, RATIO)
    masses = [ratio if n % 2 else 1.0 for n in range(draw.integer("count", 4, 10))]
    return unrest(trial.run(tower(masses, gap=start_gap(draw, len(masses))), 5.0))


@family(
    THEME,
    why="Every contact has the heavier body on top.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def heavier_upwards(draw: Draw, trial: Trial) -> float:
    """A tower of 3 to 10 boxes, each heavier than the one below by one factor, 5 s."""
    count = draw.integer("count", 3, 10)
    factor = draw.log_uniform("factor", 1.0, RATIO ** (1 / (count - 1)))
    masses = [factor**n for n in range(count)]
    return unrest(trial.run(tower(masses, gap=start_gap(draw, len(masses))), 5.0))


@family(
    THEME,
    why="A light disc rolls away as soon as the load on it is not straight above.",
    law="By symmetry nothing pushes the plank sideways: it stays.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def plank_on_light_discs(draw: Draw, trial: Trial) -> float:
    """A plank of any mass lies on two rough discs of 1 kg, 3 s."""
    gap, half = start_gap(draw, 2), draw.uniform("half_distance", 0.5, 1.5)
    surface = Material(0.0, draw.uniform("friction", 0.3, 1.0))
    discs = [
        Body(Circle(0.5), mass=1.0, position=(x, 0.5 + gap), material=surface)
        for x in (-half, half)
    ]
    plank = Body(
        Polygon.box(4, 0.25),
        mass=draw.log_uniform("ratio", 1 / RATIO, RATIO),
        position=(0, 1.125 + 2 * gap),
        material=surface,
    )
    return unrest(
        trial.run(Scene([scenes.level_ground(), *discs, plank], gravity=(0, -scenes.GRAVITY)), 3.0)
    )
