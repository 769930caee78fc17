"""A scene's bodies as columns: one array for each property, so that 10,000 are looked at together.

Whatever looks at all bodies of a scene (the rules of the effects, the choice of a solver, the
tables) reads these, and nothing else makes columns of bodies.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.mixing import UNSPECIFIED

if TYPE_CHECKING:
    from lesson_code.engine.core.scene import Body

Floats: TypeAlias = NDArray[np.float64]
Flags: TypeAlias = NDArray[np.bool_]

SEGMENT_CORNERS = 2
"""A circle has none, a polygon three or more."""


@dataclass(frozen=True, eq=False)
class Columns:
    """The properties of N bodies, each of shape (N,)."""

    x: Floats  # m, centre of mass
    y: Floats
    angle: Floats  # rad, counter-clockwise
    vx: Floats  # m/s
    vy: Floats
    w: Floats  # rad/s
    mass: Floats  # kg; infinite for a body that nothing can push
    inertia: Floats  # kg m^2; infinite for a body that nothing can turn
    restitution: Floats  # UNSPECIFIED: left to the other body
    friction: Floats  # likewise
    rounding: Floats  # m, how far the shape reaches beyond its outline
    min_width: Floats  # m, smallest width
    bounding_radius: Floats  # m, from the position to the farthest point
    corner_count: NDArray[np.int64]  # 0 circle, 2 segment, 3 and more polygon

    def __len__(self) -> int:
        """Return the number of bodies."""
        return len(self.x)

    @cached_property
    def is_free(self) -> Flags:
        """Whether something can push the body."""
        free: Flags = self.mass < math.inf
        return free

    @cached_property
    def is_moving(self) -> Flags:
        """Whether the body moves or turns at the start."""
        moving: Flags = (self.vx != 0.0) | (self.vy != 0.0) | (self.w != 0.0)
        return moving

    @property
    def has_mover(self) -> bool:
        """Whether a body moves that nothing can push."""
        return bool((self.is_moving & ~self.is_free).any())

    @cached_property
    def has_corners(self) -> Flags:
        """Whether the body is no circle."""
        cornered: Flags = self.corner_count > 0
        return cornered

    @property
    def thickness(self) -> Floats:
        """The smallest width of a body's matter, m; a line has none."""
        is_segment = self.corner_count == SEGMENT_CORNERS
        return np.where(is_segment, 2 * self.rounding, self.min_width)


def columns_of(bodies: Sequence[Body]) -> Columns:
    """Return the columns of bodies, in their order.

    Examples
    --------
    >>> from lesson_code import Body, Circle
    >>> columns_of([Body(Circle(1)), Body(Circle(2), mass=3.0)]).mass.tolist()
    [inf, 3.0]
    """
    shapes = [body.shape for body in bodies]
    materials = [body.material for body in bodies]
    x, y = _pairs([body.position for body in bodies])
    vx, vy = _pairs([body.velocity for body in bodies])
    return Columns(
        x=x,
        y=y,
        angle=_floats([body.angle for body in bodies]),
        vx=vx,
        vy=vy,
        w=_floats([body.angular_velocity for body in bodies]),
        mass=_floats([math.inf if body.mass is None else body.mass for body in bodies]),
        inertia=_floats([math.inf if body.inertia is None else body.inertia for body in bodies]),
        restitution=_coefficients([material.restitution for material in materials]),
        friction=_coefficients([material.friction for material in materials]),
        rounding=_floats([shape.rounding for shape in shapes]),
        min_width=_floats([shape.min_width for shape in shapes]),
        bounding_radius=_floats([shape.bounding_radius for shape in shapes]),
        corner_count=_frozen(np.array([len(shape.outline) for shape in shapes], dtype=np.int64)),
    )


def _pairs(values: list[tuple[float, float]]) -> tuple[Floats, Floats]:
    """Return the first and the second numbers of pairs."""
    first, second = np.array(values, dtype=float).reshape(-1, 2).T.copy()
    return _frozen(first), _frozen(second)


def _coefficients(values: list[float | None]) -> Floats:
    """Return coefficients, those that are left to the other body as the tables hold them."""
    return _floats([UNSPECIFIED if value is None else value for value in values])


def _floats(values: list[float]) -> Floats:
    """Return a column of floats."""
    return _frozen(np.array(values, dtype=float))


def _frozen(column: NDArray[Any]) -> NDArray[Any]:
    """Return a column that nobody can change by accident."""
    column.setflags(write=False)
    return column
