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
