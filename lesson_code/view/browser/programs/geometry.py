"""Two shapes: every separating axis, the clipping step by step, and the time of impact.

A page sets the corners' ``local_x`` and ``local_y`` counter-clockwise, A's before B's, gives the
table of axes as many rows, and says where the shapes are and how they move. Then it runs
``look``, and after it ``look_ahead``.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

from lesson_code.engine.compiled.webassembly import table_program
from lesson_code.geometry.advancement import TOLERANCE, advance
from lesson_code.geometry.clipping import cut_to_shared, facing_edge, measure_penetrations
from lesson_code.geometry.edges import outward_normal
from lesson_code.geometry.manifold import collide_rows
from lesson_code.geometry.rows import Corner, ManifoldRow, following, turn
from lesson_code.geometry.sat import exit_distance, minimum_translation, project_corners
from lesson_code.geometry.sweep import impact_time


@dataclass(slots=True)
class ShapeRow:
    """A shape at a place, and how it moves."""

    x: float = 0.0  # m, position
    y: float = 0.0
    angle: float = 0.0  # rad, counter-clockwise
    cos: float = 1.0  # of the angle; `look` writes both
    sin: float = 0.0
    vx: float = 0.0  # m/s
    vy: float = 0.0
    w: float = 0.0  # rad/s, counter-clockwise
    radius: float = 0.0  # m, how far the shape reaches beyond its outline
    bounding_radius: float = 0.0  # m, distance of its farthest point from its position
    first_corner: int = 0  # where its outline begins in the table of corners
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon


@dataclass(slots=True)
class AxisRow:
    """An axis, the outward normal of an edge, and both shadows on it, seen from A's position."""

    nx: float = 0.0
    ny: float = 0.0
    low_a: float = 0.0  # m, without the rounding
    high_a: float = 0.0
    low_b: float = 0.0
    high_b: float = 0.0
    overlap: float = 0.0  # m, how far the other shape must move along n; < 0: a gap


@dataclass(slots=True)
class FoundRow:
    """What the axes decide, the edges that meet, and the time of impact."""

    overlap: float = 0.0  # m, of the outlines; < 0: a gap
    nx: float = 0.0  # unit normal from A to B, if the rounded outlines overlap
    ny: float = 0.0
    edge: int = -1  # whose normal it is, or the one with the gap
    is_of_a: bool = False
    edge_a: int = -1  # that face each other along the manifold's normal
    edge_b: int = -1
    duration: float = 0.0  # s, how far to look ahead
    time: float = 0.0  # s, of impact; infinite for none
    is_certain: bool = False  # whether the search for it came to its end


class Pair(NamedTuple):
    """The tables of two shapes."""

    corners: list[Corner]
    a: ShapeRow
    b: ShapeRow
    axes: list[AxisRow]  # one for each corner: the edge that begins there
    found: FoundRow
    cut: ManifoldRow  # the stretch that both edges share, on the outlines
    measured: ManifoldRow  # its ends on the rounded surfaces, with penetrations of either sign
    manifold: ManifoldRow  # the points that overlap


def look(pair: Pair) -> None:
    """Place the shapes, and find where they overlap."""
    place(pair.corners, pair.a)
    place(pair.corners, pair.b)
    a, b, corners, found = pair.a, pair.b, pair.corners, pair.found
    for k in range(a.first_corner, a.first_corner + a.corner_count):
        cast_shadows(pair, k)
        axis = pair.axes[k]
        axis.overlap = exit_distance(axis.high_a, axis.low_b)
    for k in range(b.first_corner, b.first_corner + b.corner_count):
        cast_shadows(pair, k)
        axis = pair.axes[k]
        axis.overlap = exit_distance(axis.high_b, axis.low_a)
    collide_rows(corners, a, b, pair.manifold)
    pair.cut.count = pair.measured.count = 0
    found.edge = found.edge_a = found.edge_b = -1
    if a.corner_count > 0 and b.corner_count > 0:
        found.overlap, found.nx, found.ny, found.edge, found.is_of_a = minimum_translation(
            corners, a, b
        )
        if pair.manifold.count > 0:
            clip(pair)


def look_ahead(pair: Pair) -> None:
    """Find when the shapes, placed by `look`, first touch and come nearer."""
    a, b, found = pair.a, pair.b, pair.found
    found.is_certain = True
    if (a.corner_count > 0 and a.w != 0.0) or (b.corner_count > 0 and b.w != 0.0):
        tolerance = TOLERANCE * (a.bounding_radius + b.bounding_radius)
        found.time, found.is_certain = advance(pair.corners, a, b, found.duration, tolerance)
    else:
        found.time = impact_time(pair.corners, a, b, b.vx - a.vx, b.vy - a.vy)
    if found.is_certain and found.time > found.duration:
        found.time = math.inf


def place(corners: list[Corner], shape: ShapeRow) -> None:
    """Write a shape's normals, and turn it to its angle."""
    shape.cos, shape.sin = math.cos(shape.angle), math.sin(shape.angle)
    for k in range(shape.first_corner, shape.first_corner + shape.corner_count):
        start, end = corners[k], corners[following(shape, k)]
        start.local_nx, start.local_ny = outward_normal(
            start.local_x, start.local_y, end.local_x, end.local_y
        )
    turn(corners, shape)


def cast_shadows(pair: Pair, k: int) -> None:
    """Write an axis and both shadows on it."""
    a, b, axis, corner = pair.a, pair.b, pair.axes[k], pair.corners[k]
    nx, ny = corner.nx, corner.ny
    along = (b.x - a.x) * nx + (b.y - a.y) * ny
    axis.nx, axis.ny = nx, ny
    axis.low_a, axis.high_a = project_corners(pair.corners, a, nx, ny)
    low_b, high_b = project_corners(pair.corners, b, nx, ny)
    axis.low_b, axis.high_b = along + low_b, along + high_b


def clip(pair: Pair) -> None:
    """Write the edges that meet and how they are cut, for the normal that has been found."""
    a, b, corners, found, m = pair.a, pair.b, pair.corners, pair.found, pair.manifold
    found.edge_a = facing_edge(corners, a, m.nx, m.ny)
    found.edge_b = facing_edge(corners, b, 0.0 - m.nx, 0.0 - m.ny)
    for stage in (pair.cut, pair.measured):
        stage.nx, stage.ny = m.nx, m.ny
        cut_to_shared(corners, a, found.edge_a, b, found.edge_b, stage)
    measure_penetrations(a, b, pair.measured)


PROGRAM = table_program(Pair, look, look_ahead)
