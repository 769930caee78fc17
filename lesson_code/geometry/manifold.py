"""The manifold: where two shapes overlap, and how deep.

Everything about a contact that the rest of the workbook needs to know: the normal from A to B and
one or two points, each with its penetration. :func:`collide` answers for two shapes;
:func:`collide_rows` is the same on rows, and what the engine calls for every candidate pair.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from lesson_code.formulas.validation import Vector, finite
from lesson_code.geometry.circle_contact import collide_circles, collide_outline_circle
from lesson_code.geometry.clipping import collide_outlines
from lesson_code.geometry.rows import Corner, ManifoldRow, Placed, PlacedBody, place
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape


@dataclass(frozen=True, eq=False)
class Manifold:
    """Where two shapes A and B overlap.

    Attributes
    ----------
    normal : ndarray, shape (2,)
        Unit normal from A to B.
    points : ndarray, shape (k, 2)
        k is 1 or 2; in the world, m, midway between the surfaces of A and B.
    penetrations : ndarray, shape (k,)
        Overlap along the normal at each point, m, > 0.
    features : tuple of int, length k
        Names of the points: equal while the same edges and ends meet.
    """

    normal: Any
    points: Any
    penetrations: Any
    features: tuple[int, ...]


def collide(shape_a: Shape, pose_a: Vector, shape_b: Shape, pose_b: Vector) -> Manifold | None:
    """Return where two shapes overlap.

    Parameters
    ----------
    shape_a, shape_b : Circle, Polygon or Segment
        The shapes.
    pose_a, pose_b : (x, y, angle)
        Where they are: position in m, angle in rad, counter-clockwise.

    Returns
    -------
    Manifold or None
        Normal from A to B, one or two points, and their penetrations. None when the shapes do
        not overlap: touching is not overlapping.

    Raises
    ------
    TypeError
        A shape is something else.
    ValueError
        A pose is not three finite numbers.

    References
    ----------
    Ericson, Real-Time Collision Detection (2005), section 5.2; Catto, Contact Manifolds, Game
    Developers Conference (2007).

    Examples
    --------
    A box of 2 m by 2 m has sunk 0.25 m into a floor whose surface is at y = 0:

    >>> floor, box = Polygon.box(20, 2), Polygon.box(2, 2)
    >>> contact = collide(floor, (0, -1, 0), box, (3, 0.75, 0))
    >>> contact.normal
    array([0., 1.])
    >>> contact.points
    array([[ 4. , -0.125], [ 2. , -0.125]])
    >>> contact.penetrations
    array([0.25, 0.25])
    """
    corners: list[Corner] = []
    a = _placed("a", shape_a, pose_a, corners)
    b = _placed("b", shape_b, pose_b, corners)
    m = ManifoldRow()
    collide_rows(corners, a, b, m)
    if m.count == 0:
        return None
    offsets_a = np.array([(m.ax0, m.ay0), (m.ax1, m.ay1)])[: m.count]
    offsets_b = np.array([(m.bx0, m.by0), (m.bx1, m.by1)])[: m.count]
    return Manifold(
        np.array([m.nx, m.ny]),
        (np.array([a.x, a.y]) + offsets_a + np.array([b.x, b.y]) + offsets_b) / 2,
        np.array([m.penetration0, m.penetration1])[: m.count],
        (m.feature0, m.feature1)[: m.count],
    )


def collide_rows(corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, m: ManifoldRow) -> None:
    """Fill the manifold of two bodies; its count is 0 when they do not overlap.

    The outlines of both stand in the table of corners, already turned with their bodies.
    """
    if a.corner_count > 0 and b.corner_count > 0:
        m.count = 0
        collide_outlines(corners, a, b, m)
    else:
        collide_with_circle(corners, a, b, m)


def collide_with_circle(
    corners: Sequence[Corner], a: PlacedBody, b: PlacedBody, m: ManifoldRow
) -> None:
    """Fill the manifold of two bodies of which one at least is a circle."""
    m.count = 0
    if a.corner_count > 0:
        collide_outline_circle(corners, a, b, m)
    elif b.corner_count > 0:
        collide_outline_circle(corners, b, a, m)
        swap_bodies(m)
    else:
        collide_circles(a, b, m)


def swap_bodies(m: ManifoldRow) -> None:
    """Turn the manifold of B and A, of one point, into that of A and B."""
    m.nx, m.ny = 0.0 - m.nx, 0.0 - m.ny
    m.ax0, m.ay0, m.bx0, m.by0 = m.bx0, m.by0, m.ax0, m.ay0


def _placed(which: str, shape: Shape, pose: Vector, corners: list[Corner]) -> Placed:
    """Return the row of a shape at a pose, or raise an error that names what is wrong."""
    if not isinstance(shape, (Circle, Polygon, Segment)):
        raise TypeError(f"shape_{which} must be a Circle, Polygon or Segment, got {shape!r}")
    numbers = np.asarray(finite(f"pose_{which}", pose), dtype=float)
    if numbers.shape != (3,):
        raise ValueError(f"pose_{which} must be (x, y, angle), got shape {numbers.shape}")
    x, y, angle = numbers.tolist()
    return place(shape.outline, shape.rounding, (x, y, angle), corners)
