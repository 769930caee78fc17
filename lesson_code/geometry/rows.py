"""What the narrow phase reads and writes: rows with named fields, and how shapes become rows.

A row is a small object with fixed fields, a table is a list of rows. The functions of this wing
that take rows use plain arithmetic, loops and each other, and nothing else; the engine runs
those very lines. All points of a body are kept as offsets from its position and never as
places in the world, so that contacts are as exact far from the origin as near it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from lesson_code.geometry.edges import outward_normal
from lesson_code.geometry.outline import Point


@dataclass(slots=True)
class Corner:
    """One corner of an outline, and the edge from it to the next corner (counter-clockwise)."""

    local_x: float = 0.0  # m, offset from the body's position when the angle is 0; never changes
    local_y: float = 0.0
    local_nx: float = 0.0  # outward unit normal of the edge when the angle is 0; never changes
    local_ny: float = 0.0
    x: float = 0.0  # m, the same offset turned with the body; written by `turn`
    y: float = 0.0
    nx: float = 0.0  # the same normal turned with the body; written by `turn`
    ny: float = 0.0


class PlacedBody(Protocol):
    """The fields of a body that the narrow phase reads; a row may have more than these."""

    x: float
    y: float
    cos: float
    sin: float
    radius: float
    first_corner: int
    corner_count: int


@dataclass(slots=True)
class Placed:
    """A shape at a place: no more of a body than the narrow phase needs."""

    x: float = 0.0  # m, position
    y: float = 0.0
    cos: float = 1.0  # of the angle, counter-clockwise
    sin: float = 0.0
    radius: float = 0.0  # m, how far the shape reaches beyond its outline: a circle's radius, a
    #                      segment's half thickness, 0 for a polygon
    first_corner: int = 0  # where its outline begins in the table of corners
    corner_count: int = 0  # 0 circle, 2 segment, 3 and more polygon


@dataclass(slots=True)
class ManifoldRow:
    """Where two bodies A and B overlap, written anew at every call.

    For each point  position_A + a  =  position_B + b + penetration n: along the normal A's
    surface reaches deeper into B than B's own surface does, by the penetration.
    """

    count: int = 0  # points in use: 0, 1 or 2
    nx: float = 0.0  # unit normal from A to B, one for both points
    ny: float = 0.0

    ax0: float = 0.0  # m, first point on A's surface, offset from A's position
    ay0: float = 0.0
    bx0: float = 0.0  # m, first point on B's surface, offset from B's position
    by0: float = 0.0
    penetration0: float = 0.0  # m, > 0
    feature0: int = 0  # which edges and ends meet: equal in the next step for the same contact

    ax1: float = 0.0  # the second point likewise
    ay1: float = 0.0
    bx1: float = 0.0
    by1: float = 0.0
    penetration1: float = 0.0
    feature1: int = 0


def corner_rows(outline: Sequence[Point]) -> list[Corner]:
    """Return the rows of an outline, counter-clockwise, with its body not yet turned.

    >>> corner = corner_rows([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)])[0]
    >>> (corner.x, corner.y), (corner.nx, corner.ny)
    ((0.0, 0.0), (0.0, -1.0))
    """
    rows = []
    for k, (x, y) in enumerate(outline):
        nx, ny = outward_normal(x, y, *outline[(k + 1) % len(outline)])
        rows.append(Corner(x, y, nx, ny, x, y, nx, ny))
    return rows


def place(
    outline: Sequence[Point],
    radius: float,
    pose: tuple[float, float, float],
    corners: list[Corner],
) -> Placed:
    """Return the row of a shape at (x, y, angle), and append its outline to the corners.

    The shape is its outline, rounded by `radius`; a circle has no corners.

    >>> corners = []
    >>> body = place([(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)], 0.0, (5.0, 0.0, 0.0), corners)
    >>> body.first_corner, body.corner_count, len(corners)
    (0, 3, 3)
    """
    x, y, angle = pose
    body = Placed(x, y, math.cos(angle), math.sin(angle), radius, len(corners), len(outline))
    corners += corner_rows(outline)
    turn(corners, body)
    return body


def turn(corners: Sequence[Corner], body: PlacedBody) -> None:
    """Turn the outline of a body with it: write x, y, nx, ny of its corners.

    x = cos local_x - sin local_y,   y = sin local_x + cos local_y
    """
    for k in range(body.first_corner, body.first_corner + body.corner_count):
        c = corners[k]
        c.x = body.cos * c.local_x - body.sin * c.local_y
        c.y = body.sin * c.local_x + body.cos * c.local_y
        c.nx = body.cos * c.local_nx - body.sin * c.local_ny
        c.ny = body.sin * c.local_nx + body.cos * c.local_ny


def following(body: PlacedBody, corner: int) -> int:
    """Return the table index of the corner after a given one of a body: the end of its edge."""
    last = body.first_corner + body.corner_count - 1
    return body.first_corner if corner == last else corner + 1
