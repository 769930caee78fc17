"""Where shapes touch, and when: shapes, separating axes, the manifold, the time of impact."""

from lesson_code.geometry.closest_point import circle_against_segment, closest_point_on_segment
from lesson_code.geometry.manifold import Manifold, collide
from lesson_code.geometry.sat import mtv, overlap, project, sat_axes
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.geometry.sweep import time_of_impact

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
    "time_of_impact",
]
