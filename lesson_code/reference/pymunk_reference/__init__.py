"""Reference: pymunk's results for the lesson's collisions and scenes.

This is the only package that imports pymunk. pymunk ends the whole process when a coefficient
is out of range and lets nan pass in silence, so every argument is checked before it is called.

single_impacts
    one impact, set up so that pymunk's answer is the analytic one
scene_run
    a whole scene, stepped by pymunk with every convention mapped
overlap
    whether two shapes overlap, and how deep
"""

from lesson_code.reference.pymunk_reference.scene_run import PymunkStepper
from lesson_code.reference.pymunk_reference.single_impacts import (
    LONGEST_MOVE,
    OVERLAP,
    STEP,
    SegmentBounce,
    bounce_off_segment,
    collide_on_a_line,
    drop_onto_floor,
    rebound_heights,
)

__all__ = [
    "LONGEST_MOVE",
    "OVERLAP",
    "STEP",
    "PymunkStepper",
    "SegmentBounce",
    "bounce_off_segment",
    "collide_on_a_line",
    "drop_onto_floor",
    "rebound_heights",
]
