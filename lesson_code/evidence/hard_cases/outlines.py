"""Families of outlines that are thin, tiny or nearly degenerate."""

from __future__ import annotations

import math

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.loads import STANDS
from lesson_code.evidence.hard_cases.measures import (
    NO_DRIFT,
    NOT_SEEN,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, level_ground
from lesson_code.geometry.shapes import Polygon

THEME = "Outlines"


def pile(shape: Polygon, height: float, count: int, gap: float) -> Scene:
    """Return equal bodies one on the other; each stands on its lower side, 0 its middle height."""
    surface = Material(0.0, 0.5)
    low = -min(y for _, y in shape.outline)
    bodies = [
        Body(shape, mass=1, position=(0, low + n * height + (n + 1) * gap), material=surface)
        for n in range(count)
    ]
    return Scene([level_ground(), *bodies], gravity=(0, -GRAVITY))


def stacked(draw: Draw, trial: Trial, shape: Polygon, height: float) -> float:
    """Return how far 1 to 5 of a shape that lie on one another move in 5 s, m."""
    count = draw.integer("count", 1, 5)
    return unrest(trial.run(pile(shape, height, count, start_gap(draw, count) * height), 5.0))


@family(
    THEME,
    why="A side in two nearly parallel halves: the contact changes from one half to the other.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def nearly_straight_sides(draw: Draw, trial: Trial) -> float:
    """A pile of 1 to 5 boxes with a corner in their lower and upper sides, 1e-15 to 1e-5 m out."""
    off, at = draw.log_uniform("off", 1e-15, 1e-5), draw.uniform("at", -0.3, 0.3)
    corners = [
        (-0.5, -0.5),
        (at, -0.5 - off),
        (0.5, -0.5),
        (0.5, 0.5),
        (at, 0.5 + off),
        (-0.5, 0.5),
    ]
    return stacked(draw, trial, Polygon(corners), 1.0 + 2 * off)


@family(
    THEME,
    why="A side so short that its direction is rounding stands where a corner should.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def tiny_edges(draw: Draw, trial: Trial) -> float:
    """A pile of 1 to 5 boxes with corners cut off by 1e-12 to 1e-2 m."""
    c = draw.log_uniform("cut", 1e-12, 1e-2)
    h = 0.5
    corners = [(-h + c, -h), (h - c, -h), (h, -h + c), (h, h - c), (h - c, h), (-h + c, h),
               (-h, h - c), (-h, -h + c)]  # fmt: skip
    return stacked(draw, trial, Polygon(corners), 1.0)


@family(
    THEME,
    why="Position correction of a thousandth of a body is more than this body's thickness.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def thin_slabs(draw: Draw, trial: Trial) -> float:
    """A pile of 1 to 5 slabs of 1 m, 1:2 to 1:1000."""
    thickness = 1.0 / draw.log_uniform("slenderness", 2.0, 1000.0)
    return stacked(draw, trial, Polygon.box(1.0, thickness), thickness)


@family(
    THEME,
    why="With many corners each side is short, and a disc nearly rolls.",
    law="A polygon that stands on a side stands.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def polygons_of_many_sides(draw: Draw, trial: Trial) -> float:
    """A pile of 1 to 3 regular polygons of 4 to 32 sides, each on one side, 3 s."""
    sides = 2 * draw.integer("half_of_sides", 2, 16)
    turn = math.pi / sides - math.pi / 2
    corners = [
        (math.cos(turn + 2 * math.pi * k / sides), math.sin(turn + 2 * math.pi * k / sides))
        for k in range(sides)
    ]
    height, count = 2 * math.cos(math.pi / sides), draw.integer("count", 1, 3)
    return unrest(trial.run(pile(Polygon(corners), height, count, start_gap(draw, count)), 3.0))


@family(
    THEME,
    why="Its lower corner is so flat that it counts as a side in one step, and not in the next.",
    law="A triangle on its longest side stands.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def flat_triangles(draw: Draw, trial: Trial) -> float:
    """A triangle of 1 m, 0.5 m to 0.1 mm high, lies on its longest side, 5 s."""
    height, top = draw.log_uniform("height", 1e-4, 0.5), draw.uniform("top", -0.4, 0.4)
    shape = Polygon([(-0.5, 0), (0.5, 0), (top, height)])
    return unrest(trial.run(pile(shape, height, 1, start_gap(draw) * height), 5.0))


@family(
    THEME,
    why="A box on the border of two others: one of its corners stands on a corner.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def brick_wall(draw: Draw, trial: Trial) -> float:
    """A wall of 2 to 5 rows of bricks, each row shifted by half a brick, ends flush, 4 s."""
    rows, long = draw.integer("rows", 2, 5), draw.integer("bricks", 1, 3)
    gap, surface = start_gap(draw, rows), Material(0.0, draw.uniform("friction", 0.3, 1.0))
    bricks = []
    for row in range(rows):
        left = 0.0
        widths = [1.0] * long if row % 2 == 0 else [0.5, *[1.0] * (long - 1), 0.5]
        for width in widths:
            place = (left + width / 2, 0.25 + row * 0.5 + (row + 1) * gap)
            bricks.append(
                Body(Polygon.box(width, 0.5), mass=width, position=place, material=surface)
            )
            left += width
    return unrest(trial.run(Scene([level_ground(), *bricks], gravity=(0, -GRAVITY)), 4.0))
