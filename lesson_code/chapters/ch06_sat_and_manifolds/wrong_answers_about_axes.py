"""Wrong models of chapter 06: the axes of a polygon."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch06_sat_and_manifolds.right_answers import from_angles
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("6.1", "Two vertices that coincide: is there an edge between them, with a direction?")
def axis_of_an_empty_edge(vertices: Vector) -> Any:
    """Two neighbouring vertices always make an edge, and every edge makes an axis."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    return [np.array([y, -x]) / (np.hypot(x, y) or 1.0) for x, y in edges]


@wrong_model("6.1", "A gap runs along an edge. Along which axis do the shadows on its sides part?")
def edges_for_normals(vertices: Vector) -> Any:
    """The axes are the directions of the edges."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    return [edge / np.hypot(*edge) for edge in edges if edge.any()]


@wrong_model("6.1", "How many edges has a triangle, and how many axes do you return for it?")
def last_edge_missing(vertices: Vector) -> Any:
    """Each vertex but the last one starts an edge."""
    edges = vertices[1:] - vertices[:-1]
    return [np.array([y, -x]) / np.hypot(x, y) for x, y in edges if x or y]


@wrong_model("6.1", "Make the polygon twice as large. Should its axes grow with it?")
def axes_not_unit(vertices: Vector) -> Any:
    """An axis needs a direction only, so its length does not matter."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    return [np.array([y, -x]) for x, y in edges if x or y]


@wrong_model("6.1", "Draw a long triangle and one of your axes. Which edge does it stand upon?")
def from_the_middle_to_the_corners(vertices: Vector) -> Any:
    """The axes run from the middle of the polygon to its vertices."""
    offsets = vertices - vertices.mean(axis=0)
    return [offset / np.hypot(*offset) for offset in offsets]


@wrong_model("6.1", "Turn the polygon by 30 degrees. Do its edges turn, and do your axes?")
def x_and_y_only(vertices: Vector) -> Any:
    """The x axis and the y axis are enough for any shape."""
    return [(1.0, 0.0), (0.0, 1.0)]


@wrong_model("6.1", "Draw a long triangle. Does your axis stand at right angles to its edge?")
def from_the_middle_to_the_edges(vertices: Vector) -> Any:
    """The axes run from the middle of the polygon to the middles of its edges."""
    ends = np.roll(vertices, -1, axis=0)
    axes = [(a + b) / 2 - vertices.mean(axis=0) for a, b in zip(vertices, ends, strict=True)]
    edges = (ends - vertices).any(axis=1)
    return [
        axis / np.hypot(*axis) for axis, has_length in zip(axes, edges, strict=True) if has_length
    ]


@wrong_model("6.1", "Which edge of a triangle is parallel to another one of its edges?")
def half_of_the_edges(vertices: Vector) -> Any:
    """Opposite edges are parallel, so half of them give all the axes."""
    corners = list(dict.fromkeys(map(tuple, vertices)))
    edges = np.roll(corners, -1, axis=0) - np.array(corners)
    return [np.array([y, -x]) / np.hypot(x, y) for x, y in edges[: (len(corners) + 1) // 2]]


@wrong_model("6.1", "Draw a diagonal of a square. Is there a gap along it beside the square?")
def axes_of_diagonals_too(vertices: Vector) -> Any:
    """Any two vertices have a line between them, and each line has an axis."""
    count = len(vertices)
    ways = [vertices[k] - vertices[i] for i in range(count) for k in range(i + 1, count)]
    return [np.array([y, -x]) / np.hypot(x, y) for x, y in ways if x or y]


@wrong_model("6.1", "A vertex is listed twice. How many corners does the polygon have there?")
def vertices_listed_twice_left_out(vertices: Vector) -> Any:
    """A vertex that is listed twice does not count."""
    points = list(map(tuple, vertices))
    corners = np.array([point for point in points if points.count(point) == 1])
    return [np.array([y, -x]) / np.hypot(x, y) for x, y in np.roll(corners, -1, axis=0) - corners]


@wrong_model("6.1", "Which edge of a leaning triangle is level, so that it needs an upright axis?")
def x_and_y_besides(vertices: Vector) -> Any:
    """The x axis and the y axis are tried with every shape, besides those of its edges."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    normals = [np.array([y, -x]) / np.hypot(x, y) for x, y in edges if x or y]
    return [np.array([1.0, 0.0]), np.array([0.0, 1.0]), *normals]


@wrong_model("6.1", "Your axes have one length by one edge. Which length has each of them?")
def by_the_longest_edge(vertices: Vector) -> Any:
    """All normals are divided by one length, that of the longest edge."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    longest = max(np.hypot(*edge) for edge in edges)
    return [np.array([y, -x]) / longest for x, y in edges if x or y]


@wrong_model("6.1", "A level edge: do both of its coordinates change? Is it an edge?")
@edited(from_angles, {"(x1, y1) != (x2, y2)": "x1 != x2 and y1 != y2"})
def no_level_and_no_upright_edges() -> None:
    """An edge is empty where one of its coordinates does not change."""
