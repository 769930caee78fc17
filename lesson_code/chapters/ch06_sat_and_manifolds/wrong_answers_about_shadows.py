"""Wrong models of chapter 06: the shadow of a polygon on an axis."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


@wrong_model("6.2", "Move the polygon far from the origin. Does its shadow still reach back to 0?")
def starts_from_zero(vertices: Vector, axis: Vector) -> Any:
    """Smallest and largest are found by starting from 0."""
    low = high = 0.0
    for value in vertices @ axis:
        low, high = min(low, value), max(high, value)
    return low, high


@wrong_model("6.2", "Which vertices lie farthest out along the axis: always the same two?")
def first_and_last_vertex(vertices: Vector, axis: Vector) -> Any:
    """The shadow reaches from the first vertex to the last."""
    values = vertices @ axis
    return min(values[0], values[-1]), max(values[0], values[-1])


@wrong_model("6.2", "Move the polygon along the axis. Does your interval move with it?")
def about_its_own_middle(vertices: Vector, axis: Vector) -> Any:
    """A shadow is measured from the middle of the polygon."""
    values = (vertices - vertices.mean(axis=0)) @ axis
    return values.min(), values.max()


@wrong_model("6.2", "Which place has the first vertex in its own shadow? Must that always be 0?")
def from_the_first_vertex(vertices: Vector, axis: Vector) -> Any:
    """A shadow is measured from the first vertex."""
    values = (vertices - vertices[0]) @ axis
    return values.min(), values.max()


@wrong_model("6.2", "For the axis (1, 0), the shadow holds the x of every vertex. Does yours?")
def across_the_axis(vertices: Vector, axis: Vector) -> Any:
    """The shadow falls on the line at right angles to the axis."""
    values = vertices @ np.array([-axis[1], axis[0]])
    return values.min(), values.max()


@wrong_model("6.2", "Which sign has the dot product of a vertex that lies behind the origin?")
def distances_from_the_origin(vertices: Vector, axis: Vector) -> Any:
    """A place on the axis is a distance from the origin, so it is never negative."""
    values = np.abs(vertices @ axis)
    return values.min(), values.max()


@wrong_model("6.2", "The axis points up. Which vertices are the ends of the shadow then?")
def leftmost_and_rightmost(vertices: Vector, axis: Vector) -> Any:
    """The ends of the shadow are those of the vertices farthest to the left and to the right."""
    across = vertices[:, 0]
    return vertices[across.argmin()] @ axis, vertices[across.argmax()] @ axis


@wrong_model("6.2", "Turn a long plank. Does its shadow stay as long as it was?")
def shadow_of_a_circle(vertices: Vector, axis: Vector) -> Any:
    """The shadow reaches from the middle as far as the farthest vertex does, either way."""
    middle = vertices.mean(axis=0)
    reach = max(np.hypot(*(vertex - middle)) for vertex in vertices)
    return middle @ axis - reach, middle @ axis + reach


@wrong_model("6.2", "The first vertex is the highest one. Does your loop ever ask it for that?")
def either_lower_or_higher(vertices: Vector, axis: Vector) -> Any:
    """A value that is the lowest so far need not be asked whether it is the highest."""
    low, high = np.inf, -np.inf
    for value in vertices @ axis:
        if value < low:
            low = value
        elif value > high:
            high = value
    return low, high


@wrong_model("6.2", "An interval from 3 to 5: which two numbers do you return for it?")
def low_and_length(vertices: Vector, axis: Vector) -> Any:
    """An interval is its beginning and its length."""
    values = vertices @ axis
    return values.min(), values.max() - values.min()


@wrong_model("6.2", "Draw a leaning triangle and its box. Are its corners where the box has its?")
def shadow_of_the_box(vertices: Vector, axis: Vector) -> Any:
    """The smallest x and the smallest y make the beginning of the shadow, the largest its end."""
    parts = vertices * axis
    return parts.min(axis=0).sum(), parts.max(axis=0).sum()


@wrong_model("6.2", "Which vertex is farthest along the axis: always the one farthest away?")
def nearest_and_farthest_vertex(vertices: Vector, axis: Vector) -> Any:
    """The shadow reaches from the vertex nearest to the origin to the one farthest from it."""
    by_distance = sorted(vertices, key=lambda vertex: np.hypot(*vertex))
    return tuple(sorted((by_distance[0] @ axis, by_distance[-1] @ axis)))


@wrong_model("6.2", "A foot on the axis is 5 m from the origin. Is that its x?")
def x_of_the_foot(vertices: Vector, axis: Vector) -> Any:
    """A place on the axis is the x of the foot."""
    values = (vertices @ axis) * axis[0]
    return values.min(), values.max()


@wrong_model("6.2", "Where does the shadow begin: always at the origin?")
def from_zero_to_the_length(vertices: Vector, axis: Vector) -> Any:
    """A shadow begins at 0 and ends at its length."""
    values = vertices @ axis
    return 0.0, values.max() - values.min()


@wrong_model("6.2", "Which points of a polygon throw the ends of its shadow?")
def shadow_of_the_middles(vertices: Vector, axis: Vector) -> Any:
    """The shadow is that of the middles of the edges."""
    values = (vertices + np.roll(vertices, -1, axis=0)) / 2 @ axis
    return values.min(), values.max()
