"""Tasks of chapter 06: separating axes, clipping, circle against polygon."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial
from random import Random
from typing import Any

import numpy as np

from lesson_code.chapters import draws
from lesson_code.chapters.ch06_sat_and_manifolds import draws as pairs
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import ANSWER_TOLERANCE, Arguments, Criterion, Task
from lesson_code.formulas import polygon_centroid
from lesson_code.geometry import (
    Circle,
    Polygon,
    closest_point_on_segment,
    collide,
    mtv,
    overlap,
    project,
    sat_axes,
)

FAR = 15.0
"""m: farther than any pair that is drawn lies from the origin."""


def triangles(stream: Random) -> Iterator[Arguments]:
    """Draw triangles."""
    for _ in range(2):
        yield (draws.convex_polygon(stream, 3, draws.position(stream)),)


def more_edges(stream: Random) -> Iterator[Arguments]:
    """Draw polygons with four, five and six edges, and one with a level and an upright edge."""
    for count in (4, 5, 6):
        yield (draws.convex_polygon(stream, count, draws.position(stream)),)
    x, y = draws.position(stream)
    wide, high = draws.unequal_radii(stream)
    yield (((x, y), (x + wide, y), (x + 0.7 * wide, y + 0.4 * high), (x, y + high)),)


def a_vertex_twice(stream: Random) -> Iterator[Arguments]:
    """Draw a polygon with a vertex that is listed twice, in the middle and at the end."""
    for place in (2, 4):
        corners = draws.convex_polygon(stream, 5, draws.position(stream))
        yield ((*corners[: place + 1], *corners[place:]),)


def _axes_of_edges(vertices: Any) -> Any:
    """Return the axes of a polygon whose vertices may be listed twice."""
    return sat_axes(list(dict.fromkeys(map(tuple, vertices))))


def as_lines(axes: Any) -> list[list[float]]:
    """Return axes in one order, each with one of its two signs and none twice.

    An axis and its opposite are the same line. What remains are length and direction.
    """
    turned = sorted((_turned_up(x, y) for x, y in axes), key=lambda axis: math.atan2(*axis[::-1]))
    return [
        list(axis)
        for axis, previous in zip(turned, [None, *turned], strict=False)
        if previous is None or not math.dist(axis, previous) <= ANSWER_TOLERANCE  # nan is kept
    ]


def _turned_up(x: float, y: float) -> tuple[float, float]:
    """Return whichever of (x, y) and its opposite points up; of two level ones, to the right."""
    points_down = y < 0 if abs(y) > ANSWER_TOLERANCE else x < 0
    return (-x, -y) if points_down else (x, y)


def beyond_the_origin(stream: Random) -> Iterator[Arguments]:
    """Draw polygons that lie on one side of the origin along the axis, and on the other.

    Their list begins with the vertex farthest along the axis, and with the nearest. No end of the
    shadow is, in the first, that of the vertex nearest to the origin, and in the second that of the
    one farthest to the left.
    """
    yield draws.until(
        lambda drawn: _none_is_an_end(drawn, _nearest(drawn[0])),
        lambda: _beyond_the_origin(stream, 1),
    )
    yield draws.until(
        lambda drawn: _none_is_an_end(drawn, _leftmost(drawn[0])),
        lambda: _beyond_the_origin(stream, -1),
    )


def _beyond_the_origin(stream: Random, side: int) -> Arguments:
    """Return a polygon and an axis on which it lies on one side of the origin."""
    axis = draws.oblique_normal(stream)
    way = side * stream.uniform(3.0, 6.0)
    vertices = draws.convex_polygon(stream, 5, (way * axis[0], way * axis[1]))
    return _from_the_farthest(vertices, axis, side), axis


def about_the_origin(stream: Random) -> Iterator[Arguments]:
    """Draw polygons with the origin inside them; the list ends with either end of the shadow.

    It begins with a vertex at no end. At none is, in the first of them, the vertex farthest to the
    left, and in the second the one nearest to the origin.
    """
    yield draws.until(
        lambda drawn: _none_is_an_end(drawn, drawn[0][0], _leftmost(drawn[0])),
        lambda: _about_the_origin(stream, 3, 1),
    )
    yield draws.until(
        lambda drawn: _none_is_an_end(drawn, drawn[0][0], _nearest(drawn[0])),
        lambda: _about_the_origin(stream, 4, -1),
    )


def _about_the_origin(stream: Random, count: int, side: int) -> Arguments:
    """Return a polygon about the origin, and an axis; the end of the list is one of the shadow."""
    vertices, axis = draws.convex_polygon(stream, count, size=2.0), draws.oblique_normal(stream)
    first, *others = _from_the_farthest(vertices, axis, side)
    return (*others, first), axis


def _nearest(vertices: pairs.Polygon) -> draws.Vector:
    """Return the vertex nearest to the origin."""
    return min(vertices, key=lambda vertex: math.hypot(*vertex))


def _leftmost(vertices: pairs.Polygon) -> draws.Vector:
    """Return the first of the vertices farthest to the left."""
    return min(vertices, key=lambda vertex: vertex[0])


def _none_is_an_end(drawn: Arguments, *some: draws.Vector) -> bool:
    """Return whether none of some vertices of a polygon is at an end of its shadow on an axis."""
    vertices, axis = drawn
    return not {_from_the_farthest(vertices, axis, side)[0] for side in (1, -1)} & set(some)


def _from_the_farthest(
    vertices: pairs.Polygon, axis: draws.Vector, side: int
) -> tuple[draws.Vector, ...]:
    """Return the vertices from the one that is farthest along an axis, or against it."""
    ways = [side * (x * axis[0] + y * axis[1]) for x, y in vertices]
    place = ways.index(max(ways))
    return (*vertices[place:], *vertices[:place])


def one_end_inside(stream: Random) -> Iterator[Arguments]:
    """Draw intervals that overlap at one end, B on the right of A and on the left."""
    a, b = _overlapping_ends(stream)
    yield a, b
    b, a = _overlapping_ends(stream)
    yield a, b


def one_in_the_other(stream: Random) -> Iterator[Arguments]:
    """Draw an interval inside another, off its middle: B in A, and A in B."""
    for nearer_end in (0.1, 0.6):
        outer, inner = _nested(stream, nearer_end)
        yield outer, inner
        yield inner, outer


def apart_or_not(stream: Random) -> Iterator[Arguments]:
    """Draw intervals that are apart, that touch, and that overlap by a hair, either way round."""
    for gap in (0.5, 0.0, -1e-3):
        low, width = round(stream.uniform(-3, 3), 2), round(stream.uniform(1, 3), 2)
        left, start = (low, low + width), low + width + gap
        right = (start, start + round(stream.uniform(1, 3), 2))
        yield left, right
        yield right, left


def _overlapping_ends(stream: Random) -> tuple[draws.Vector, draws.Vector]:
    """Return two intervals; the left one ends inside the right one."""
    low, width = round(stream.uniform(-5, 5), 2), round(stream.uniform(2, 4), 2)
    start = low + width - draws.depth(stream)
    return (low, round(low + width, 2)), (round(start, 2), round(start + width, 2))


def _nested(stream: Random, part: float) -> tuple[draws.Vector, draws.Vector]:
    """Return an interval, and one inside it that starts at a part of its width."""
    low, width = round(stream.uniform(-5, 5), 2), round(stream.uniform(4, 6), 2)
    start = low + part * width
    return (low, round(low + width, 2)), (round(start, 2), round(start + 0.25 * width, 2))


def is_overlap(answer: Any) -> str:
    """Return in words whether an answer says that there is an overlap."""
    return "no overlap" if answer is None else "overlap"


def at_a_corner(stream: Random) -> Iterator[Arguments]:
    """Draw pairs that are parted the short way along a normal of A, and along one of B.

    The origin lies far behind A, and far beyond B: where B is seen from there tells nothing.
    """
    for pair, way in ((pairs.CORNER_INSIDE, FAR), (pairs.swapped(pairs.CORNER_INSIDE), -FAR)):
        a, b = pairs.placed(stream, pair)
        found: Any = mtv(a, b)  # they overlap, so it is not None
        normal, _ = found
        yield tuple(tuple(_moved(p, -way * normal) for p in polygon) for polygon in (a, b))


def one_inside_the_other(stream: Random) -> Iterator[Arguments]:
    """Draw a small polygon inside a large one: B in A, and A in B."""
    yield pairs.placed(stream, pairs.NESTED)
    yield pairs.placed(stream, pairs.swapped(pairs.NESTED))


def past_the_middle(stream: Random) -> Iterator[Arguments]:
    """Draw pairs so deep that their middles lie the other way round than the way out."""
    for pair in pairs.PAST_THE_MIDDLE:
        yield pairs.placed(stream, pair)


def polygons_apart_or_not(stream: Random) -> Iterator[Arguments]:
    """Draw pairs that overlap, that only A's or only B's edges can part, and that touch.

    Of those that are apart, no level and no upright line parts the first two.
    """
    yield pairs.placed(stream, pairs.CORNER_INSIDE)
    yield draws.until(_boxes_overlap, lambda: pairs.placed(stream, pairs.PARTED))
    yield pairs.placed(stream, pairs.swapped(pairs.PARTED))
    x, y = float(stream.randint(-5, 5)), float(stream.randint(-5, 5))
    for gap in (0.0, -(2.0**-10)):  # no number is rounded: these squares touch exactly
        yield pairs.square(x, y), pairs.square(x + 2 + gap, y + 0.5)


def _boxes_overlap(pair: pairs.Pair) -> bool:
    """Return whether the boxes around two polygons overlap."""
    a, b = (
        [(min(values), max(values)) for values in zip(*polygon, strict=True)] for polygon in pair
    )
    return all(overlap(*sides) is not None for sides in zip(a, b, strict=True))


def after_your_move(arguments: Arguments, answer: Any) -> str:
    """Say whether the shadows of A and B on the answer's axis part once B is moved as it says."""
    if answer is None or not is_finite(answer):
        return ""
    a, b = arguments
    (x, y), depth = answer
    length = math.hypot(x, y)
    if length == 0:
        return ""
    end = max(x * p[0] + y * p[1] for p in a) / length
    start = min(x * p[0] + y * p[1] for p in b) / length + depth * length
    if end - start <= ANSWER_TOLERANCE:
        return "Moved by depth times normal, B is out of A; is there a shorter way?"
    return (
        f"On your axis A's shadow ends at {written(end)} m. Moved by depth times normal, "
        f"B's begins at {written(start)} m: the shadows still overlap."
    )


def is_finite(value: Any) -> bool:
    """Return whether a plain value holds finite numbers only."""
    if isinstance(value, list | tuple):
        return all(is_finite(item) for item in value)
    return isinstance(value, int | float) and math.isfinite(value)


def _clipped(start: Any, end: Any, normal: Any, offset: float) -> tuple[Any, Any] | None:
    """Return the part of a segment with p . normal <= offset."""
    s, e = (float(point @ normal) - offset for point in (start, end))
    if min(s, e) > 0:
        return None
    if max(s, e) <= 0:
        return start, end
    cut = start + s / (s - e) * (end - start)
    return (cut if s > 0 else start), (cut if e > 0 else end)


def crossing(stream: Random) -> Iterator[Arguments]:
    """Draw segments with the start inside, and with the end inside."""
    for _ in range(2):
        inside, outside, normal, offset = _segment_across(stream)
        yield inside, outside, normal, offset
        inside, outside, normal, offset = _segment_across(stream)
        yield outside, inside, normal, offset


def on_one_side(stream: Random) -> Iterator[Arguments]:
    """Draw segments that lie all inside, and all outside, with one end close to the line."""
    for side in (-1, 1):
        for near, far in (((0.02, 0.1), (0.5, 2.0)), ((0.5, 2.0), (0.02, 0.1))):
            normal, offset = draws.oblique_normal(stream), round(stream.uniform(-3, 3), 2)
            start = _beside_line(normal, offset + side * stream.uniform(*near), -1.0)
            end = _beside_line(normal, offset + side * stream.uniform(*far), 2.0)
            yield start, end, normal, offset


def on_one_side_or_touching(stream: Random) -> Iterator[Arguments]:
    """Draw segments that lie all inside, and all outside, and some that touch the line.

    Outside, these touch it with their end, with their start, and all along. No number is rounded.
    """
    yield from on_one_side(stream)
    x, y = (stream.randrange(-24, 24) / 8 for _ in range(2))
    start, end, line = (x, y), (x + 1.25, y - 2.5), (1.0, 0.0)
    yield end, start, line, x
    yield start, end, line, x
    yield start, (x, y + 1.5), line, x


def _segment_across(stream: Random) -> tuple[draws.Vector, draws.Vector, draws.Vector, float]:
    """Return a point inside, one outside, and the line between them: normal and offset."""
    normal, offset = draws.oblique_normal(stream), round(stream.uniform(-3, 3), 2)
    inside = _beside_line(normal, offset - stream.uniform(1.5, 2.5), stream.uniform(-2, -1))
    outside = _beside_line(normal, offset + stream.uniform(0.3, 1.0), stream.uniform(1, 2))
    return inside, outside, normal, offset


def _beside_line(normal: draws.Vector, along_normal: float, along_line: float) -> draws.Vector:
    """Return the point with the given parts along a normal and along its line."""
    n_x, n_y = normal
    return (
        round(along_normal * n_x - along_line * n_y, 2),
        round(along_normal * n_y + along_line * n_x, 2),
    )


def beside_an_edge(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap a long edge, away from its middle; the last one, and the first."""
    for place in (-1, 0):
        vertices, start, end, outward = _longest_edge(stream, place)
        foot = _between(start, end, stream.choice((0.3, 0.7)))
        yield draws.at_distance(foot, 0.2, outward), round(stream.uniform(0.3, 0.4), 2), vertices


def beside_an_edge_or_two(stream: Random) -> Iterator[Arguments]:
    """Draw such circles, and two that reach another edge, too: one before theirs, and one after."""
    yield from beside_an_edge(stream)
    for place, at_end in ((-1, False), (0, True)):
        yield draws.until(_reaches_two_edges, partial(_beside_a_corner, stream, place, at_end))


def _beside_a_corner(stream: Random, place: int, at_end: bool) -> Arguments:
    """Return a circle that overlaps the longest edge of a polygon near its start or its end."""
    vertices, start, end, outward = _longest_edge(stream, place)
    part = 0.12 / math.dist(start, end)
    foot = _between(start, end, 1 - part if at_end else part)
    return draws.at_distance(foot, 0.2, outward), round(stream.uniform(0.3, 0.4), 2), vertices


def _reaches_two_edges(drawn: Arguments) -> bool:
    """Return whether a circle overlaps a second edge of a polygon, which is clearly farther."""
    centre, radius, vertices = drawn
    edges = zip(vertices, (*vertices[1:], vertices[0]), strict=True)
    points = (closest_point_on_segment(centre, *edge) for edge in edges)
    nearest, second, *_ = sorted(math.dist(centre, point) for point in points)
    return bool(nearest + 0.02 < second < radius)


def beside_a_vertex(stream: Random) -> Iterator[Arguments]:
    """Draw circles that overlap a vertex, over the end of an edge and before the next one.

    The vertex is at the origin the second time.
    """
    for at_origin in (False, True):
        vertices, way = _beyond_a_vertex(stream, 0.75 if at_origin else 0.25)
        shift = vertices[1] if at_origin else (0.0, 0.0)
        centre = _moved(draws.at_distance(vertices[1], 0.25, way), shift)
        yield centre, 0.4, tuple(_moved(vertex, shift) for vertex in vertices)


def _beyond_a_vertex(stream: Random, part: float) -> tuple[pairs.Polygon, draws.Vector]:
    """Return a polygon and a way out from vertex 1: `part` of the turn between its edges.

    The turn is 1 rad or more: halfway, a point is clearly farther from the vertex than from the
    lines of the edges.
    """
    vertices, first, turn = draws.until(lambda drawn: drawn[2] > 1, lambda: _corner(stream))
    way = first + part * turn
    return vertices, (math.cos(way), math.sin(way))


def _corner(stream: Random) -> tuple[pairs.Polygon, float, float]:
    """Return a polygon, the way out of its first edge and the turn to that of the next, rad."""
    vertices = draws.convex_polygon(stream, 4, draws.position(stream), size=2.5, width=0.6)
    first, second = (math.atan2(-x, y) for x, y in np.diff(vertices[:3], axis=0))
    return vertices, first, (second - first) % (2 * math.pi)


def with_the_centre_inside(stream: Random) -> Iterator[Arguments]:
    """Draw circles whose centre is inside: smaller and larger than its distance to the edge."""
    for radius, place in ((0.1, -1), (0.5, 0)):
        vertices, start, end, outward = _longest_edge(stream, place)
        foot = _between(start, end, stream.choice((0.4, 0.6)))
        yield draws.at_distance(foot, -0.2, outward), radius, vertices


def circle_apart_or_not(stream: Random) -> Iterator[Arguments]:
    """Draw circles off an edge and just in it, past the end of an edge's line, off a vertex.

    The last one just touches an edge: no number is rounded.
    """
    vertices, start, end, outward = _longest_edge(stream, 0)
    foot = _between(start, end, 0.5)
    for radius in (0.28, 0.32):
        yield draws.at_distance(foot, 0.3, outward), radius, vertices
    yield draws.at_distance(_between(start, end, 1.5), 0.1, outward), 0.3, vertices
    vertices, way = _beyond_a_vertex(stream, 0.5)
    yield draws.at_distance(vertices[1], 0.33, way), 0.3, vertices
    x, y, radius = *(float(stream.randint(-5, 5)) for _ in range(2)), stream.randrange(3, 8) / 8
    yield (x + 2 + radius, y + 0.75), radius, pairs.square(x, y)


def _longest_edge(
    stream: Random, place: int
) -> tuple[pairs.Polygon, draws.Vector, draws.Vector, draws.Vector]:
    """Return a long polygon, both ends of its longest edge, and that edge's outward normal.

    The edge stands at a place in the list: 0 is the first, -1 the last.
    """
    vertices = draws.convex_polygon(stream, 4, draws.position(stream), size=2.5, width=0.6)
    lengths = [math.dist(a, b) for a, b in zip(vertices, vertices[1:] + vertices[:1], strict=True)]
    first = (lengths.index(max(lengths)) - place) % len(vertices)
    vertices = vertices[first:] + vertices[:first]
    start, end = vertices[place], vertices[(place + 1) % len(vertices)]
    length = max(lengths)
    return vertices, start, end, ((end[1] - start[1]) / length, (start[0] - end[0]) / length)


def _between(start: draws.Vector, end: draws.Vector, part: float) -> draws.Vector:
    """Return the point a part of the way from start to end."""
    return start[0] + part * (end[0] - start[0]), start[1] + part * (end[1] - start[1])


def _moved(point: Any, shift: Any) -> draws.Vector:
    """Return a point less a shift, to two decimals."""
    return round(point[0] - shift[0], 2), round(point[1] - shift[1], 2)


def _circle_contact(centre: Any, radius: float, vertices: Any) -> tuple[Any, float] | None:
    """Return normal, from polygon to circle, and depth of a circle that overlaps a polygon."""
    place = (*polygon_centroid(vertices), 0.0)
    found = collide(Polygon(vertices), place, Circle(radius), (*centre, 0.0))
    return None if found is None else (found.normal, found.penetrations[0])


def axes_are_lines(arguments: Arguments, answer: Any) -> str:
    """Say how many axes there are, and what about them is free."""
    return (
        f"Yours are {len(answer)} axes for {len(arguments[0])} vertices. Order, signs and repeats"
        " are free; shown are the lines they stand for."
    )


TASKS = (
    Task(
        id="6.1",
        function="sat_axes",
        section=2,
        objective="The axes on which two polygons may part: the unit normals of the edges.",
        expected=_axes_of_edges,
        criteria=(
            Criterion("triangles", triangles, part=as_lines),
            Criterion("four edges and more", more_edges, points=2, part=as_lines),
            Criterion("a vertex listed twice", a_vertex_twice, part=as_lines),
        ),
        explain=axes_are_lines,
    ),
    Task(
        id="6.2",
        function="project",
        section=1,
        objective="The shadow of a polygon on an axis.",
        expected=project,
        criteria=(
            Criterion("a polygon beyond the origin", beyond_the_origin),
            Criterion("a polygon about the origin", about_the_origin),
        ),
    ),
    Task(
        id="6.3",
        function="overlap",
        section=3,
        objective="How far one interval must move to leave another, the shorter way.",
        expected=overlap,
        criteria=(
            Criterion("one end inside the other", one_end_inside),
            Criterion("one inside the other", one_in_the_other),
            Criterion("apart, touching or overlapping", apart_or_not, part=is_overlap),
        ),
    ),
    Task(
        id="6.4",
        function="mtv",
        section=4,
        objective="The minimum translation vector of two polygons, from A to B.",
        expected=mtv,
        criteria=(
            Criterion("axes of A and of B", at_a_corner),
            Criterion("one inside the other", one_inside_the_other),
            Criterion("deeper than the middle", past_the_middle),
            Criterion("apart, touching or overlapping", polygons_apart_or_not, part=is_overlap),
        ),
        explain=after_your_move,
    ),
    Task(
        id="6.5",
        function="clip",
        section=6,
        objective="The part of a segment on the inner side of a line.",
        expected=_clipped,
        criteria=(
            Criterion("one end outside", crossing, points=2),
            Criterion("all inside, all outside, or touching", on_one_side_or_touching),
        ),
    ),
    Task(
        id="6.6",
        function="circle_against_polygon",
        section=9,
        objective="How a circle overlaps a polygon, through the closest point.",
        expected=_circle_contact,
        criteria=(
            Criterion("beside an edge", beside_an_edge_or_two),
            Criterion("beside a vertex", beside_a_vertex),
            Criterion("the centre inside", with_the_centre_inside),
            Criterion("apart, touching or overlapping", circle_apart_or_not, part=is_overlap),
        ),
    ),
)
