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
    if at_start <= 0 and at_end <= 0:
        return start, end
    cut = start + at_start / (at_start - at_end) * (end - start)
    return (end, cut) if at_start > 0 else (start, cut)


@wrong_model("6.5", "Is the line halfway between the ends? Which of your numbers says where it is?")
def cut_in_the_middle(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """A segment with one end outside is cut in its middle."""
    s, e = start @ normal > offset, end @ normal > offset
    if s and e:
        return None
    return ((start + end) / 2 if s else start), ((start + end) / 2 if e else end)


@wrong_model("6.5", "One end is inside. Is there nothing left of the segment?")
def none_with_an_end_outside(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """A segment with an end outside is left out."""
    return None if max(start @ normal, end @ normal) > offset else (start, end)


@wrong_model("6.5", "A segment crosses at a flat angle. Is its way outside as long as its height?")
def height_along_the_segment(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """An end moves back along the segment by as much as it lies beyond the line."""
    s, e = start @ normal - offset, end @ normal - offset
    if s > 0 and e > 0:
        return None
    way = (end - start) / np.hypot(*(end - start))
    return start + max(s, 0.0) * way, end - max(e, 0.0) * way


@wrong_model("6.5", "A segment crosses at a flat angle. Is its way inside as long as its depth?")
def depth_along_the_segment(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """From the end inside, the cut is as far along the segment as the line is away."""
    s, e = start @ normal - offset, end @ normal - offset
    if max(s, e) <= 0 or min(s, e) > 0:
        return None if s > 0 else (start, end)
    way = (end - start) / np.hypot(*(end - start))
    return (end + e * way, end) if s > 0 else (start, start - s * way)


@wrong_model("6.5", "Where on the line you cut is the dot product with the normal: 0, or offset?")
def cut_at_the_origin(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """The cut is where the dot product with the normal is 0."""
    s, e = start @ normal, end @ normal
    if s > offset and e > offset:
        return None
    cut = start + (s / (s - e) if s != e else 0.0) * (end - start)
    return (cut if s > offset else start), (cut if e > offset else end)


@wrong_model("6.5", "The whole segment is outside. What is left of it, and what do you return?")
def shrinks_to_a_point(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """Of a segment that is all outside its nearer end is left."""
    s, e = start @ normal - offset, end @ normal - offset
    cut = start + np.clip(s / (s - e), 0, 1) * (end - start)
    return (cut if s > 0 else start), (cut if e > 0 else end)


@wrong_model("6.5", "What part of the way is the crossing: of which length along the normal?")
def part_of_the_length(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """The crossing is at the distance of the start over the length of the segment."""
    s, e = start @ normal - offset, end @ normal - offset
    if max(s, e) <= 0 or min(s, e) > 0:
        return None if s > 0 else (start, end)
    cut = start + abs(s) / np.hypot(*(end - start)) * (end - start)
    return (cut, end) if s > 0 else (start, cut)


@wrong_model("6.5", "You return the crossing twice. What has become of the end inside?")
def the_cut_alone(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """What is left of a segment that crosses the line is the crossing."""
    s, e = start @ normal - offset, end @ normal - offset
    if max(s, e) <= 0 or min(s, e) > 0:
        return None if s > 0 else (start, end)
    cut = start + s / (s - e) * (end - start)
    return cut, cut


@wrong_model("6.5", "The segment comes in from outside. Which of your two ends did you look at?")
def only_the_end_is_cut(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """A segment begins inside, so only its end may have to be cut."""
    at_start, at_end = start @ normal - offset, end @ normal - offset
    if at_start > 0 and at_end > 0:
        return None
    if at_end <= 0:
        return start, end
    return start, start + at_start / (at_start - at_end) * (end - start)


@wrong_model("6.5", "One end lies just on the line. Is its dot product above the offset?")
def the_line_is_outside(start: Vector, end: Vector, normal: Vector, offset: float) -> Any:
    """What lies on the line is outside."""
    at_start, at_end = start @ normal - offset, end @ normal - offset
    if at_start >= 0 and at_end >= 0:
        return None
    if at_start <= 0 and at_end <= 0:
        return start, end
    crossing = start + at_start / (at_start - at_end) * (end - start)
    return (crossing, end) if at_start > 0 else (start, crossing)
