"""What bodies are made of: circles, convex polygons and segments.

A shape is seen from its body: its points are offsets from the body's position, before the body is
turned. It is checked here, is complete from the start and never changes.

==================  ========================================================  =====
property            meaning                                                   unit
==================  ========================================================  =====
area                of the shape; 0 for a segment without thickness           m^2
centroid            where the centre of mass of a plate of this shape lies    m
inertia_per_mass    moment of inertia about the centroid, for 1 kg            m^2
min_width           smallest width: a door this wide lets it through          m
bounding_radius     distance from the body's position to the farthest point   m
outline             the corners, counter-clockwise; none for a circle         m
rounding            how far the shape reaches beyond its outline              m
==================  ========================================================  =====
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, TypeAlias

from lesson_code.formulas.rigid_body import (
    disc_inertia,
    polygon_area,
    polygon_centroid,
    polygon_inertia,
)
from lesson_code.formulas.validation import Vector, equation, non_negative, one_number, positive
from lesson_code.geometry.closest_point import segment_ends
from lesson_code.geometry.edges import direction, outward_normal
from lesson_code.geometry.outline import Point, convex_outline

CENTRED = 1e-14
"""Of the largest coordinate: a centroid this near the origin is the origin, but for rounding."""

_disc_inertia = equation(disc_inertia)


@dataclass(frozen=True)
class Circle:
    """A disc with its centre at the body's position.

    Parameters
    ----------
    radius : float
        m, > 0.

    Raises
    ------
    ValueError
        The radius is not > 0, or not finite.

    Examples
    --------
    >>> Circle(0.5).inertia_per_mass
    0.125
    """

    radius: float
    centroid: ClassVar[Point] = (0.0, 0.0)
    outline: ClassVar[tuple[Point, ...]] = ()

    def __post_init__(self) -> None:
        """Check the radius."""
        object.__setattr__(self, "radius", one_number("radius", self.radius, positive))

    @property
    def rounding(self) -> float:
        """The radius: all of a circle lies beyond its centre."""
        return self.radius

    @property
    def area(self) -> float:
        """Area, m^2: pi r^2."""
        return math.pi * self.radius * self.radius

    @property
    def inertia_per_mass(self) -> float:
        """Moment of inertia of 1 kg about the centre, m^2: r^2 / 2."""
        return float(_disc_inertia(1.0, self.radius))

    @property
    def min_width(self) -> float:
        """Smallest width, m: the diameter."""
        return 2 * self.radius

    @property
    def bounding_radius(self) -> float:
        """Distance from the body's position to the farthest point, m."""
        return self.radius


@dataclass(frozen=True)
class Polygon:
    """A convex polygon, moved so that its centroid is the body's position.

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3. Their origin does not matter. They are
        kept as a tuple of (x, y), seen from the centroid and counter-clockwise, beginning with
        the first; a vertex that is nearer than 1e-4 of the width to the straight line between its
        neighbours is left out.

    Raises
    ------
    ValueError
        The shape is not (N, 2), a coordinate is not finite, all lie on one line, a vertex repeats
        its neighbour, or the outline is not convex or crosses itself.

    Examples
    --------
    >>> Polygon([(0, 0), (0, 3), (3, 0)]).vertices
    ((-1.0, -1.0), (2.0, -1.0), (-1.0, 2.0))
    """

    vertices: Vector
    centroid: ClassVar[Point] = (0.0, 0.0)
    rounding: ClassVar[float] = 0.0

    def __post_init__(self) -> None:
        """Check the vertices, and see them from their centroid."""
        object.__setattr__(self, "vertices", _centred(convex_outline("vertices", self.vertices)))

    @classmethod
    def box(cls, width: float, height: float) -> Polygon:
        """Return a rectangle with its sides along the body's axes.

        >>> Polygon.box(4, 2).vertices
        ((-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0))
        """
        x, y = one_number("width", width, positive) / 2, one_number("height", height, positive) / 2
        return cls(((-x, -y), (x, -y), (x, y), (-x, y)))

    @classmethod
    def regular(cls, sides: int, radius: float) -> Polygon:
        """Return a polygon of equal sides, its first corner at (radius, 0).

        >>> len(Polygon.regular(sides=6, radius=1).vertices)
        6
        """
        count = int(one_number("sides", sides))
        if count != sides or count < 3:
            raise ValueError(f"sides must be a whole number >= 3, got {sides}")
        r = one_number("radius", radius, positive)
        angles = [2 * math.pi * k / count for k in range(count)]
        return cls([(r * math.cos(angle), r * math.sin(angle)) for angle in angles])

    @property
    def outline(self) -> tuple[Point, ...]:
        """The corners, counter-clockwise, m."""
        return tuple(self.vertices)

    @cached_property
    def area(self) -> float:
        """Area, m^2."""
        return polygon_area(self.vertices)

    @cached_property
    def inertia_per_mass(self) -> float:
        """Moment of inertia of 1 kg about the centroid, m^2."""
        return float(polygon_inertia(1.0, self.vertices))

    @cached_property
    def min_width(self) -> float:
        """Smallest width, m."""
        return smallest_width(self.outline)

    @cached_property
    def bounding_radius(self) -> float:
        """Distance from the body's position to the farthest point, m."""
        return farthest(self.outline)


@dataclass(frozen=True)
class Segment:
    """A straight wall or rod with two sides and two round ends.

    Parameters
    ----------
    start, end : array_like, shape (2,)
        Ends of the middle line, m, seen from the body's position; they must differ. They stay as
        they are given: a floor may be drawn in the world's own coordinates.
    radius : float
        Half of the thickness, m, >= 0: the shape is everything within `radius` of the line.

    Raises
    ------
    ValueError
        A coordinate is not finite, the ends coincide, or the radius is negative.

    Examples
    --------
    >>> Segment((-3, 0), (3, 0)).inertia_per_mass
    3.0
    """

    start: Vector
    end: Vector
    radius: float = 0.0

    def __post_init__(self) -> None:
        """Check both ends and the radius."""
        start, end = segment_ends(self.start, self.end)
        object.__setattr__(self, "start", tuple(start.tolist()))
        object.__setattr__(self, "end", tuple(end.tolist()))
        object.__setattr__(self, "radius", one_number("radius", self.radius, non_negative))

    @property
    def outline(self) -> tuple[Point, ...]:
        """The two ends, m: back along the left side first, then there along the right."""
        return (self.end, self.start)

    @property
    def rounding(self) -> float:
        """Half of the thickness, m."""
        return self.radius

    @property
    def length(self) -> float:
        """Distance between the ends, m."""
        return length_of(self.outline)

    @property
    def area(self) -> float:
        """Area, m^2: a rectangle and two half discs."""
        return 2 * self.radius * self.length + math.pi * self.radius * self.radius

    @property
    def centroid(self) -> Point:
        """The middle, m, seen from the body's position."""
        (ax, ay), (bx, by) = self.start, self.end
        return ((ax + bx) / 2, (ay + by) / 2)

    @property
    def inertia_per_mass(self) -> float:
        """Moment of inertia of 1 kg about the middle, m^2: L^2 / 12 for a thin rod."""
        return rod_inertia(self.length, self.radius)

    @property
    def min_width(self) -> float:
        """Smallest width, m: the thickness, or the length where there is no thickness."""
        return 2 * self.radius or self.length

    @property
    def bounding_radius(self) -> float:
        """Distance from the body's position to the farthest point, m."""
        return farthest(self.outline) + self.radius


Shape: TypeAlias = Circle | Polygon | Segment


def _centred(corners: list[Point]) -> tuple[Point, ...]:
    """Return corners seen from their centroid; those that are already stay as they are."""
    x, y = centre_of(corners)
    return tuple((cx - x, cy - y) for cx, cy in corners)


# Outlines. Programs for pages run these lines too, on tables of corners.


def centre_of(outline: Any) -> Point:
    """Return the centroid of a polygon, m; one that is the origin but for rounding is the origin.

    >>> centre_of([(0.0, 0.0), (3.0, 0.0), (0.0, 3.0)])
    (1.0, 1.0)
    """
    x, y = polygon_centroid(outline)
    distance, _, _ = direction(x, y, 1.0, 0.0)
    if distance <= CENTRED * farthest(outline):
        return 0.0, 0.0
    return float(x), float(y)


def farthest(outline: Any) -> float:
    """Return the distance from the body's position to the farthest corner, m.

    >>> farthest([(3.0, 4.0), (-1.0, 0.0)])
    5.0
    """
    most = 0.0
    for k in range(len(outline)):
        distance, _, _ = direction(outline[k][0], outline[k][1], 1.0, 0.0)
        most = max(most, distance)
    return most


def smallest_width(outline: Any) -> float:
    """Return the smallest width of a polygon, m.

    Between parallel lines it is narrowest with an edge on one of them.

    >>> smallest_width([(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)])
    2.0
    """
    least = math.inf
    for k in range(len(outline)):
        start, end = outline[k], outline[(k + 1) % len(outline)]
        nx, ny = outward_normal(start[0], start[1], end[0], end[1])
        least = min(least, width_along(outline, nx, ny))
    return least


def width_along(outline: Any, nx: float, ny: float) -> float:
    """Return the width of an outline along a direction, m."""
    low, high = math.inf, -math.inf
    for k in range(len(outline)):
        along = outline[k][0] * nx + outline[k][1] * ny
        low, high = min(low, along), max(high, along)
    return high - low


def length_of(outline: Any) -> float:
    """Return the distance between the two ends of a segment, m."""
    end, start = outline[0], outline[1]
    length, _, _ = direction(end[0] - start[0], end[1] - start[1], 1.0, 0.0)
    return length


def rod_inertia(length: float, r: float) -> float:
    """Return the moment of inertia of 1 kg of a segment about its middle, m^2.

    The mass is spread over the rectangle between the ends, L^2/12 + r^2/3, and over the two
    half discs, r^2/2 + L^2/4 + 4 r L / (3 pi), in the ratio of their areas, 2 L : pi r.

    >>> rod_inertia(6.0, 0.0)
    3.0
    """
    rectangle, discs = 2 * length, math.pi * r
    of_rectangle = length * length / 12 + r * r / 3
    of_discs = r * r / 2 + length * length / 4 + 4 * r * length / (3 * math.pi)
    return (rectangle * of_rectangle + discs * of_discs) / (rectangle + discs)
