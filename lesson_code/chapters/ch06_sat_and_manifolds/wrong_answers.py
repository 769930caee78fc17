"""Wrong models of chapter 06: overlap, the way out, circle against polygon.

They use the functions of the earlier tasks that the student's file has under the same names.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch06_sat_and_manifolds.right_answers import (
    both_ways_along_each_axis,
    edge_by_edge,
    shift_by_shift,
)
from lesson_code.course.grading.task import edited, wrong_model
from lesson_code.formulas.arithmetic import cross
from lesson_code.geometry import closest_point_on_segment, project, sat_axes

Vector: TypeAlias = Any


@wrong_model("6.3", "A small interval inside a large one: moved by what you return, is it out?")
def common_part(interval_a: Vector, interval_b: Vector) -> Any:
    """The overlap is the length of the part that both intervals have in common."""
    length = min(interval_a[1], interval_b[1]) - max(interval_a[0], interval_b[0])
    return length if length > 0 else None


@wrong_model("6.3", "Put B to the left of A. Which of its ends meets A first there?")
def b_is_always_on_the_right(interval_a: Vector, interval_b: Vector) -> Any:
    """The end of A and the beginning of B say it all."""
    depth = interval_a[1] - interval_b[0]
    return depth if depth > 0 else None


@wrong_model("6.3", "Put B to the left of A, so that they overlap. Where does it leave A soonest?")
def leaves_on_the_right(interval_a: Vector, interval_b: Vector) -> Any:
    """Where the two overlap, B leaves A at its upper end."""
    way = interval_a[1] - interval_b[0]
    return way if min(way, interval_b[1] - interval_a[0]) > 0 else None


@wrong_model("6.3", "B can leave on either side. Which of the two ways do you return?")
def longer_way_out(interval_a: Vector, interval_b: Vector) -> Any:
    """Of the two ways out, the longer one is sure to be enough."""
    exits = interval_a[1] - interval_b[0], interval_b[1] - interval_a[0]
    return max(exits) if min(exits) > 0 else None


@wrong_model("6.3", "Two boxes stand side by side and just touch. How far must one be moved?")
def touching_counts(interval_a: Vector, interval_b: Vector) -> Any:
    """Intervals that touch overlap."""
    depth = min(interval_a[1] - interval_b[0], interval_b[1] - interval_a[0])
    return depth if depth >= 0 else None


@wrong_model("6.3", "An overlap of 0 and no overlap: can your caller tell them apart?")
def zero_for_a_gap(interval_a: Vector, interval_b: Vector) -> Any:
    """Where there is no overlap, the overlap is 0."""
    return max(0.0, min(interval_a[1] - interval_b[0], interval_b[1] - interval_a[0]))


@wrong_model("6.4", "Move the note of B's position to one of its ends. May the normal turn round?")
def direction_from_the_centres(vertices_a: Vector, vertices_b: Vector) -> Any:
    """The normal points the way from the middle of A to the middle of B."""
    depths = []
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        (low_a, high_a), (low_b, high_b) = project(vertices_a, axis), project(vertices_b, axis)
        depths.append((min(high_a - low_b, high_b - low_a), axis))
    depth, normal = min(depths, key=lambda found: found[0])
    towards_b = np.dot(vertices_b.mean(axis=0) - vertices_a.mean(axis=0), normal) >= 0
    return ((normal if towards_b else -normal), depth) if depth > 0 else None


@wrong_model("6.4", "A brick lies near the end of a plank. Does the plank push it up, or along?")
@edited(
    both_ways_along_each_axis,
    {
        "return best": (
            "way = vertices_b.mean(axis=0) - vertices_a.mean(axis=0)\n"
            "    return best and (way / np.hypot(*way), best[1])"
        )
    },
)
def along_the_line_of_the_middles() -> None:
    """Polygons push each other along the line of their middles, as circles do."""


@wrong_model("6.4", "Let a corner of A point at a side of B. Whose edge has the axis you need?")
@edited(
    both_ways_along_each_axis,
    {"[*sat_axes(vertices_a), *sat_axes(vertices_b)]": "sat_axes(vertices_a)"},
)
def axes_of_a_only() -> None:
    """The edges of one of the two polygons are enough."""


@wrong_model("6.4", "Put a small polygon inside a large one. Moved by what you return, is it out?")
def common_part_as_depth(vertices_a: Vector, vertices_b: Vector) -> Any:
    """The depth is the length of the part that both shadows have in common."""
    best = None
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        (low_a, high_a), (low_b, high_b) = project(vertices_a, axis), project(vertices_b, axis)
        depth = min(high_a, high_b) - max(low_a, low_b)
        if depth <= 0:
            return None
        if best is None or depth < best[1]:
            best = (axis if high_a - low_b < high_b - low_a else -axis), depth
    return best


@wrong_model("6.4", "MTV: what does its first letter stand for, and which depth do you keep?")
def largest_overlap(vertices_a: Vector, vertices_b: Vector) -> Any:
    """The axis that counts is the one with the largest overlap."""
    best = None
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        (low_a, high_a), (low_b, high_b) = project(vertices_a, axis), project(vertices_b, axis)
        depth = min(high_a - low_b, high_b - low_a)
        if depth <= 0:
            return None
        if best is None or depth > best[1]:
            best = (axis if high_a - low_b < high_b - low_a else -axis), depth
    return best


@wrong_model("6.4", "Move B by depth times your normal. Does it come out of A, or go deeper?")
@edited(both_ways_along_each_axis, {"low_b, axis": "low_b, -axis", "low_a, -axis": "low_a, axis"})
def from_b_to_a() -> None:
    """The normal points from B to A."""


@wrong_model("6.4", "Two squares stand side by side and just touch. What does yours return?")
@edited(both_ways_along_each_axis, {"depth <= 0": "depth < 0"})
def touching_is_a_hit() -> None:
    """Polygons that touch overlap."""


@wrong_model("6.6", "The ball lies flat upon a long edge. Which vertex does it touch?")
def corners_only(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The closest point of a polygon is one of its vertices."""
    offsets = centre - vertices
    distances = np.hypot(offsets[:, 0], offsets[:, 1])
    nearest = int(np.argmin(distances))
    depth = radius - distances[nearest]
    return (offsets[nearest] / distances[nearest], depth) if depth > 0 else None


@wrong_model("6.6", "Roll the ball past a corner. Does the edge go on for ever there?")
def edges_without_ends(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The edge whose line is nearest gives the normal, also beyond its ends."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    normals = np.array([(y, -x) / np.hypot(x, y) for x, y in edges])
    distances = [np.dot(centre - vertex, n) for vertex, n in zip(vertices, normals, strict=True)]
    nearest = int(np.argmax(distances))
    depth = radius - distances[nearest]
    return (normals[nearest], depth) if depth > 0 else None


@wrong_model("6.6", "With the centre inside, which way leads from the centre to the edge?")
def deeper_when_inside(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The normal always points from the closest point to the centre."""
    edges = zip(vertices, np.roll(vertices, -1, axis=0), strict=True)
    offsets = [centre - closest_point_on_segment(centre, a, b) for a, b in edges]
    offset = min(offsets, key=lambda way: np.hypot(*way))
    distance = np.hypot(*offset)
    return (offset / distance, radius - distance) if distance < radius else None


@wrong_model("6.6", "The centre is inside. It has to reach the edge, and then: how much farther?")
def shallow_when_inside(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The depth is always the radius less the distance to the closest point."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    offsets = [centre - closest_point_on_segment(centre, a, b) for a, b in edges]
    inside = all(cross(b - a, centre - a) > 0 for a, b in edges)
    offset = min(offsets, key=lambda way: np.hypot(*way))
    distance = np.hypot(*offset)
    normal = -offset / distance if inside else offset / distance
    return (normal, radius - distance) if distance < radius else None


@wrong_model(
    "6.6", "The centre lies deep inside. Is the way out longer or shorter than the radius?"
)
def difference_when_inside(centre: Vector, radius: float, vertices: Vector) -> Any:
    """Inside, the depth is the difference of the radius and the distance to the closest point."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    offsets = [centre - closest_point_on_segment(centre, a, b) for a, b in edges]
    inside = all(cross(b - a, centre - a) > 0 for a, b in edges)
    offset = min(offsets, key=lambda way: np.hypot(*way))
    distance = np.hypot(*offset)
    if inside:
        return -offset / distance, abs(radius - distance)
    return (offset / distance, radius - distance) if distance < radius else None


@wrong_model("6.6", "Move polygon and ball so that the corner is at (0, 0). Are they still apart?")
def nothing_at_the_origin(centre: Vector, radius: float, vertices: Vector) -> Any:
    """A closest point at (0, 0) means that none was found."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    points = [closest_point_on_segment(centre, a, b) for a, b in edges]
    inside = all(cross(b - a, centre - a) > 0 for a, b in edges)
    closest = min(points, key=lambda point: np.hypot(*(centre - point)))
    distance = np.hypot(*(centre - closest))
    depth = radius + distance if inside else radius - distance
    if not closest.any() or depth <= 0:
        return None
    normal = (centre - closest) / distance
    return (-normal if inside else normal), depth


@wrong_model("6.6", "A ball lies near the end of a long plank. Which way does the plank push it?")
def from_middle_to_middle(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The normal points from the middle of the polygon to the centre of the circle."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    offsets = [centre - closest_point_on_segment(centre, a, b) for a, b in edges]
    inside = all(cross(b - a, centre - a) > 0 for a, b in edges)
    distance = min(np.hypot(*offset) for offset in offsets)
    depth = radius + distance if inside else radius - distance
    way = centre - vertices.mean(axis=0)
    return (way / np.hypot(*way), depth) if depth > 0 else None


@wrong_model("6.4", "Your loop has ended. Of which axis is the depth that you still hold?")
@edited(
    both_ways_along_each_axis,
    {"return best": "return best and (best[0], min(high_a - low_b, high_b - low_a))"},
)
def depth_of_the_last_axis() -> None:
    """The depth is what stands in the variable when all axes have been tried."""


@wrong_model("6.3", "B may leave A at either end. Which two ends have to pass each other?")
def like_ends_apart(interval_a: Vector, interval_b: Vector) -> Any:
    """The way out is the distance of two beginnings, or of two ends."""
    (low_a, high_a), (low_b, high_b) = interval_a, interval_b
    if high_a <= low_b or high_b <= low_a:
        return None
    return min(abs(low_a - low_b), abs(high_a - high_b))


@wrong_model("6.6", "The centre is deep inside, far from every edge. Do they overlap?")
@edited(edge_by_edge, {"    if inside:\n": "    if inside and least < radius:\n"})
def far_from_the_outline_is_apart() -> None:
    """A circle whose centre is farther from the outline than its radius does not overlap."""


@wrong_model("6.4", "Is a shift of -3 shorter than one of 1?")
@edited(shift_by_shift, {"abs(shift) < abs(best)": "shift < best"})
def most_negative_shift() -> None:
    """The smallest shift is the one with the smallest number, its sign included."""


@wrong_model("6.3", "A small interval lies inside a large one. Which of its ends is outside?")
def none_inside_another(interval_a: Vector, interval_b: Vector) -> Any:
    """Intervals overlap where an end of each is inside the other."""
    (low_a, high_a), (low_b, high_b) = interval_a, interval_b
    if low_a < low_b < high_a < high_b:
        return high_a - low_b
    return high_b - low_a if low_b < low_a < high_b < high_a else None


@wrong_model("6.3", "You have moved it until its near end is at the border. Is it outside now?")
def to_the_nearer_end(interval_a: Vector, interval_b: Vector) -> Any:
    """An interval inside another one leaves it by the gap to the nearer end."""
    (low_a, high_a), (low_b, high_b) = interval_a, interval_b
    if high_a <= low_b or high_b <= low_a:
        return None
    if (low_a < low_b) != (high_a < high_b):
        return min(abs(low_b - low_a), abs(high_a - high_b))
    return min(high_a - low_b, high_b - low_a)


@wrong_model("6.4", "Two planks cross like a T. On which axis do their shadows part first?")
def the_line_of_the_middles_alone(vertices_a: Vector, vertices_b: Vector) -> Any:
    """The axis that counts is the line of the middles, as with circles."""
    way = vertices_b.mean(axis=0) - vertices_a.mean(axis=0)
    normal = way / np.hypot(*way)
    depth = project(vertices_a, normal)[1] - project(vertices_b, normal)[0]
    return (normal, depth) if depth > 0 else None


@wrong_model("6.4", "On one axis there is a gap between the shadows. Can the polygons overlap?")
@edited(both_ways_along_each_axis, {"return None": "continue"})
def a_gap_is_passed_over() -> None:
    """An axis with a gap tells nothing: the next one may have an overlap."""


@wrong_model(
    "6.6", "A ball touches a corner. Does a corner have the direction of one of its edges?"
)
def a_corner_pushes_like_an_edge(centre: Vector, radius: float, vertices: Vector) -> Any:
    """The normal is always that of the nearest edge, at its ends too."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    points = [closest_point_on_segment(centre, a, b) for a, b in edges]
    distances = [np.hypot(*(centre - point)) for point in points]
    x, y = np.subtract(*edges[int(np.argmin(distances))][::-1])
    inside = all(cross(b - a, centre - a) > 0 for a, b in edges)
    depth = radius + min(distances) if inside else radius - min(distances)
    return (np.array([y, -x]) / np.hypot(x, y), depth) if depth > 0 else None


@wrong_model("6.4", "Turn both polygons by 30 degrees. Do their edges turn, and do your axes?")
@edited(
    both_ways_along_each_axis,
    {"[*sat_axes(vertices_a), *sat_axes(vertices_b)]": "np.eye(2)"},
)
def boxes_along_the_axes() -> None:
    """The x axis and the y axis are enough."""


@wrong_model("6.4", "An outward normal of B: does it lead from A to B, or back?")
@edited(
    both_ways_along_each_axis,
    {"((high_a - low_b, axis), (high_b - low_a, -axis))": "((high_a - low_b, axis),)"},
)
def outward_of_both() -> None:
    """B leaves along an outward normal, of its own edges as of those of A."""


@wrong_model("6.4", "A long plank is in a short one. Which way out is the shorter, in metres?")
@edited(
    both_ways_along_each_axis,
    {
        "depth < best[1]:\n": "depth / (high_a - low_a) < least:\n"
        "                least = depth / (high_a - low_a)\n",
        "best = None": "best, least = None, np.inf",
        "best is None or ": "",
    },
)
def smallest_part_of_the_shadow() -> None:
    """The overlap that is the smallest part of A's shadow counts."""


@wrong_model("6.4", "How long is the normal that you return?")
@edited(both_ways_along_each_axis, {"return best": "return best and (best[0] * best[1], best[1])"})
def whole_way_as_the_normal() -> None:
    """The normal is the whole way out."""


@wrong_model("6.6", "A long plank has a circle around it. Does a ball in that touch the plank?")
def circle_around_the_polygon(centre: Vector, radius: float, vertices: Vector) -> Any:
    """A polygon is as good as the circle around it."""
    middle = vertices.mean(axis=0)
    reach = max(np.hypot(*(vertex - middle)) for vertex in vertices) + radius
    distance = np.hypot(*(centre - middle))
    return ((centre - middle) / distance, reach - distance) if distance < reach else None


@wrong_model("6.6", "The ball lies upon the edge near its end. Where does it touch the edge?")
def middles_of_edges(centre: Vector, radius: float, vertices: Vector) -> Any:
    """An edge is touched in its middle."""
    middles = (vertices + np.roll(vertices, -1, axis=0)) / 2
    offset = min(centre - middles, key=lambda way: np.hypot(*way))
    distance = np.hypot(*offset)
    return (offset / distance, radius - distance) if distance < radius else None
