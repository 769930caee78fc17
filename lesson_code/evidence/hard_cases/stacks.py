"""Families of stacks and piles of equal bodies."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.loads import STANDS, tower
from lesson_code.evidence.hard_cases.measures import (
    NO_DRIFT,
    NOT_SEEN,
    energy_above,
    fastest,
    gain,
    largest,
    pair_forces,
    relative_errors,
    sideways,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import rigid_bodies as scenes
from lesson_code.geometry.shapes import Circle, Polygon
from lesson_code.reference.rigid_body_closed_forms import stack_forces

THEME = "Stacks and piles"

SIDEWAYS = 1e-2
"""m: a hundredth of a box."""

NOT_LEANING = "a hundredth of a box: less than a tall stack leans before it falls"


@family(
    THEME,
    why="The weight of the top has to get down through all contacts in each step.",
    law=STANDS,
    unit="m",
    bound=SIDEWAYS,
    reason=NOT_LEANING,
    is_long=True,
)
def stack_of_2_to_20(draw: Draw, trial: Trial) -> float:
    """A stack of 2 to 20 boxes: drift sideways in 20 s."""
    count, friction = draw.integer("count", 2, 20), draw.uniform("friction", 0.2, 1.0)
    return sideways(
        trial.run(tower((1.0,) * count, gap=start_gap(draw, count), friction=friction), 20.0)
    )


@family(
    THEME,
    why="What drifts by a thousandth of a millimetre in a step is 1.2 m off after 20 s.",
    law=STANDS,
    unit="m",
    bound=SIDEWAYS,
    reason=NOT_LEANING,
    is_long=True,
)
def stack_of_21_to_64(draw: Draw, trial: Trial) -> float:
    """A stack of 21 to 64 boxes: drift sideways in 20 s."""
    count = draw.integer("count", 21, 64)
    return sideways(trial.run(tower((1.0,) * count, gap=start_gap(draw, count)), 20.0))


@family(
    THEME,
    why="A length in a solver's constants makes a size special.",
    law=STANDS,
    unit="",
    bound=SIDEWAYS,
    reason=NOT_LEANING,
)
def stack_of_any_size(draw: Draw, trial: Trial) -> float:
    """A stack of 2 to 8 boxes of 1 mm to 1 km: drift sideways in 5 s, in boxes."""
    count, size = draw.integer("count", 2, 8), draw.log_uniform("size", 1e-3, 1e3)
    return (
        sideways(trial.run(tower((1.0,) * count, gap=start_gap(draw, count), size=size), 5.0))
        / size
    )


@family(
    THEME,
    why="Each box stands askew, so an error of the forces tips it.",
    law="What stands stands: each centre is well above the box below.",
    unit="m",
    bound=SIDEWAYS,
    reason=NOT_LEANING,
)
def stack_askew(draw: Draw, trial: Trial) -> float:
    """A stack of 3 to 16 boxes, up to 5 cm left and right in turn: drift sideways in 10 s."""
    count, aside = draw.integer("count", 3, 16), draw.uniform("aside", 0.0, 0.05)
    return sideways(trial.run(tower((1.0,) * count, gap=start_gap(draw, count), aside=aside), 10.0))


@family(
    THEME,
    why="The lowest contact carries as many times what the highest does as there are boxes.",
    law="N = the weight of all that stands above",
    unit="",
    bound=1e-8,
    reason="rounding of linear equations with up to 160 unknowns, 1e-12, and some room",
)
def forces_in_stack(draw: Draw, trial: Trial) -> float:
    """The force under each of 2 to 40 equal boxes, after a second."""
    masses = (1.0,) * draw.integer("count", 2, 40)
    forces = pair_forces(
        trial.run(tower(masses, gap=start_gap(draw, len(masses))), 1.0, sample=None)
    )
    measured = [forces.get((n, n + 1), 0.0) for n in range(len(masses))]
    return relative_errors(measured, stack_forces(masses, scenes.GRAVITY))


@family(
    THEME,
    why="Up to 55 boxes, and each point of contact depends on all others.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def pyramid(draw: Draw, trial: Trial) -> float:
    """A pyramid of 2 to 10 rows of boxes, 5 s."""
    rows, friction = draw.integer("rows", 2, 10), draw.uniform("friction", 0.3, 1.0)
    apart, gap = draw.uniform("between", 0.01, 0.4), start_gap(draw, rows)
    scene = scenes.box_pyramid(rows, friction=friction, gap=apart, overlap=-gap)
    return unrest(trial.run(scene, 5.0))


@family(
    THEME,
    why="Contacts that open and close in turn make a stack tremble for ever.",
    law="At rest all speeds are 0.",
    unit="m/s",
    bound=1e-9,
    reason="a millimetre in eleven days",
)
def stack_comes_to_rest(draw: Draw, trial: Trial) -> float:
    """A stack of 1 to 12 boxes: the greatest speed in the second after 5 s."""
    count = draw.integer("count", 1, 12)
    scene = tower((1.0,) * count, gap=start_gap(draw, count))
    return fastest(trial.run(scene, 6.0, sample=np.linspace(5, 6, 61)))


@family(
    THEME,
    why="With restitution any error of a velocity is given back, for ever.",
    law="What has no energy gets none.",
    unit="J",
    bound=1e-9,
    reason="a speed of 3e-5 m/s of one box of 1 kg",
)
def bouncy_stack_at_rest(draw: Draw, trial: Trial) -> float:
    """A stack of 1 to 8 boxes with e from 0 to 1, exactly touching, at rest: its energy in 5 s."""
    e = draw.choice("restitution", (1.0, draw.uniform("any_restitution", 0.0, 1.0)))
    scene = tower((1.0,) * draw.integer("count", 1, 8), restitution=e)
    return largest(trial.run(scene, 5.0, sample=None).kinetic_energy)


@family(
    THEME,
    why="Each bounce of one box is an impact of all those below it.",
    law="Energy never grows, whatever e is, where there is no friction.",
    unit="",
    bound=1e-9,
    reason="rounding of some hundred impacts",
)
def dropped_stack(draw: Draw, trial: Trial) -> float:
    """A stack of 2 to 6 smooth boxes with e from 0 to 1, dropped: gain of energy in 5 s."""
    count, drop = draw.integer("count", 2, 6), draw.log_uniform("drop", 1e-3, 1.0)
    e = draw.uniform("restitution", 0.0, 1.0)
    scene = tower((1.0,) * count, gap=drop / count, restitution=e, friction=0.0)
    run = trial.run(scene, 5.0, sample=None)
    return gain(energy_above(run, count / 2))


@family(
    THEME,
    why="A heap has many contacts, of which some slide and some do not.",
    law="Nothing that is dropped gets above the height that it came from.",
    unit="",
    bound=1e-9,
    reason="energy never grows in dull impacts, whatever the friction",
)
def heap_of_discs(draw: Draw, trial: Trial) -> float:
    """A heap of 3 to 15 dull, rough discs falls in on itself: gain of energy in 4 s."""
    surface = Material(0.0, draw.uniform("friction", 0.0, 1.0))
    rows, gap = draw.integer("rows", 2, 5), start_gap(draw, sunk=False)
    discs = [
        Body(
            Circle(0.5),
            mass=1,
            position=((n - (rows - row - 1) / 2) * 1.05, 0.5 + gap + row),
            material=surface,
        )
        for row in range(rows)
        for n in range(rows - row)
    ]
    run = trial.run(
        Scene([scenes.level_ground(), *discs], gravity=(0, -scenes.GRAVITY)), 4.0, sample=None
    )
    return gain(energy_above(run, 0.25))


@family(
    THEME,
    why="A wide box carries a narrow one beside its middle: its contact points share unevenly.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def boxes_of_any_width(draw: Draw, trial: Trial) -> float:
    """A stack of 3 to 8 boxes of different widths and heights, widest at the bottom, 5 s."""
    surface, gap = Material(0.0, 0.5), start_gap(draw, 8)
    width, top = draw.uniform("width", 1.0, 4.0), 0.0
    boxes = []
    for n in range(draw.integer("count", 3, 8)):
        height = draw.uniform(f"height_{n}", 0.1, 1.0)
        shape = Polygon.box(width, height)
        place = (0.0, top + height / 2 + gap)
        boxes.append(Body(shape, mass=width * height, position=place, material=surface))
        top, width = top + height + gap, width * draw.uniform(f"narrower_{n}", 0.5, 1.0)
    scene = Scene([scenes.level_ground(), *boxes], gravity=(0, -scenes.GRAVITY))
    return unrest(trial.run(scene, 5.0))
