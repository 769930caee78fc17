"""Where shapes touch."""

from lesson_code.geometry.closest_point import circle_against_segment, closest_point_on_segment

__all__ = ["circle_against_segment", "closest_point_on_segment"]
