"""Wrong models of chapter 06: the part of a segment on one side of a line."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


@wrong_model("6.5", "One end is outside. Where does the segment cross the line: is a point kept?")
def drops_the_end_outside(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """Clipping leaves out the ends that lie outside."""
    return [point for point in (start, end) if np.dot(point, normal) <= offset] or None


@wrong_model("6.5", "Take a point far along the normal. Is its dot product above the offset?")
def keeps_the_other_side(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """What lies beyond the line, where the normal points, is kept."""
    s, e = np.dot(start, normal) - offset, np.dot(end, normal) - offset
    if s < 0 and e < 0:
        return None
    if s >= 0 and e >= 0:
        return [start, end]
    crossing = start + s / (s - e) * (end - start)
    return [start, crossing] if s >= 0 else [crossing, end]


@wrong_model("6.5", "Draw the point that you put on the line. Does it still lie on the segment?")
def moved_along_the_normal(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """An end outside is moved straight back to the line."""
    s, e = np.dot(start, normal) - offset, np.dot(end, normal) - offset
    if s > 0 and e > 0:
        return None
    return [start - max(s, 0.0) * normal, end - max(e, 0.0) * normal]


@wrong_model("6.5", "If the start is just outside, is the crossing near the start or near the end?")
def counts_from_the_wrong_end(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """The crossing divides the segment by the distance of the end over the sum of both."""
    s, e = np.dot(start, normal) - offset, np.dot(end, normal) - offset
    if s > 0 and e > 0:
        return None
    if s <= 0 and e <= 0:
        return [start, end]
    crossing = start + e / (e - s) * (end - start)
    return [crossing, end] if s > 0 else [start, crossing]


@wrong_model("6.5", "A segment lies half outside. How much of it do you give back?")
def all_or_nothing(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """A segment with one end inside is kept as it is."""
    s, e = np.dot(start, normal) - offset, np.dot(end, normal) - offset
    return None if s > 0 and e > 0 else [start, end]


@wrong_model("6.5", "The segment comes in from outside. Which of its ends has to be cut off?")
def cuts_the_end_always(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """What lies outside is the part behind the cut."""
    at_start, at_end = start @ normal - offset, end @ normal - offset
    if at_start > 0 and at_end > 0:
        return None
    if at_start <= 0 and at_end <= 0:
        return start, end
    return start, start + at_start / (at_start - at_end) * (end - start)


@wrong_model("6.5", "The segment comes in from outside. Which of your two points comes first?")
def cut_always_last(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """First the ends that are inside, then the cut."""
    at_start, at_end = start @ normal - offset, end @ normal - offset
    if at_start > 0 and at_end > 0:
        return None
    cut = start + at_start / (at_start - at_end) * (end - start) if at_start * at_end < 0 else end
    return (end, cut) if at_start > 0 else (start, cut)
