"""Where shapes touch: shapes, the separating axis theorem, and the manifold of two shapes."""

from lesson_code.geometry.closest_point import circle_against_segment, closest_point_on_segment
from lesson_code.geometry.manifold import Manifold, collide
from lesson_code.geometry.sat import mtv, overlap, project, sat_axes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

__all__ = [
    "Circle",
    "Manifold",
    "Polygon",
    "Segment",
    "Shape",
    "circle_against_segment",
    "closest_point_on_segment",
    "collide",
    "mtv",
    "overlap",
    "project",
    "sat_axes",
]
