"""Wrong models of chapter 11: a broad phase, a hit, a step.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch11_the_small_engine.right_answers import (
    one_loop_for_both_directions,
    pair_by_pair_and_wall_by_wall,
    swept_in_order,
)
from lesson_code.course.grading.task import edited, wrong_model

Table: TypeAlias = Any
Vector: TypeAlias = Any


@wrong_model("11.1", "One box is far above the other. Do they share a point?")
def only_along_x(boxes: Table) -> Any:
    """Boxes overlap if they do along x."""
    count = range(len(boxes))
    return [
        (i, j)
        for i in count
        for j in count
        if i < j and boxes[i][0] <= boxes[j][1] and boxes[j][0] <= boxes[i][1]
    ]


@wrong_model("11.1", "Two planks make a cross. Which corner of one is inside the other?")
def corners_inside(boxes: Table) -> Any:
    """Boxes overlap if a corner of one is inside the other."""
    found = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            for (left, right, low, high), corners in ((boxes[i], boxes[j]), (boxes[j], boxes[i])):
                x_inside = any(left <= x <= right for x in corners[:2])
                if x_inside and any(low <= y <= high for y in corners[2:]):
                    found.append((i, j))
    return list(dict.fromkeys(found))


@wrong_model("11.1", "The pair of 2 and 5 is that of 5 and 2. Is it hit twice?")
def both_orders(boxes: Table) -> Any:
    """Each box asks every other one."""
    count = range(len(boxes))
    return [
        (i, j)
        for i in count
        for j in count
        if i != j
        and boxes[i][0] <= boxes[j][1]
        and boxes[j][0] <= boxes[i][1]
        and boxes[i][2] <= boxes[j][3]
        and boxes[j][2] <= boxes[i][3]
    ]


@wrong_model("11.1", "The right side of one is the left side of the other. Do they share a point?")
def touching_is_apart(boxes: Table) -> Any:
    """Boxes that only touch share nothing."""
    count = range(len(boxes))
    return [
        (i, j)
        for i in count
        for j in count
        if i < j
        and boxes[i][0] < boxes[j][1]
        and boxes[j][0] < boxes[i][1]
        and boxes[i][2] < boxes[j][3]
        and boxes[j][2] < boxes[i][3]
    ]


@wrong_model("11.1", "A small box lies inside a long one, off its middle. What does your rule say?")
def neighbours_in_a_row(boxes: Table) -> Any:
    """Sorted by their left sides, only neighbours can overlap."""
    order = np.argsort(boxes[:, 0])
    found = []
    for n in range(len(order) - 1):
        first, second = order[n], order[n + 1]
        one, other = boxes[first], boxes[second]
        if other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]:
            found.append((min(first, second), max(first, second)))
    return found


@wrong_model("11.1", "The next box hangs high above. May the one after it still touch yours?")
@edited(
    swept_in_order,
    {"if other[0] > one[1]": "if other[0] > one[1] or one[2] > other[3] or other[2] > one[3]"},
)
def stops_at_the_first_miss() -> None:
    """Sorted by their left sides, all boxes after the first that misses are too far away."""


@wrong_model(
    "11.2", "A body that is hit beside its centre turns away. Does it yield as if it could not?"
)
@edited(
    one_loop_for_both_directions,
    {"1 / a[0] + 1 / b[0] + r[0] ** 2 / a[1] + r[1] ** 2 / b[1]": "1 / a[0] + 1 / b[0]"},
)
def yields_by_moving_alone() -> None:
    """The effective mass is that of the masses."""


@wrong_model("11.2", "Both centres are at rest, and one body spins. Can its corner strike?")
@edited(
    one_loop_for_both_directions,
    {"w[1] * r[1] - w[0] * r[0]": "(w[1] * r[1] - w[0] * r[0]) * turn"},
)
def centres_approach() -> None:
    """How fast two bodies come together is how fast their centres do, however they spin."""


@wrong_model(
    "11.2", "Friction stops the sliding as far as it can. How far can it, with a small mu?"
)
@edited(one_loop_for_both_directions, {"np.clip(-u / yields, -limit, limit)": "-u / yields"})
def friction_stops_everything() -> None:
    """Friction always stops the sliding."""


@wrong_model(
    "11.2", "The two receive opposite impulses at their arms. Are both torques of one sign?"
)
@edited(one_loop_for_both_directions, {"w[0] - j * r[0] / a[1]": "w[0] + j * r[0] / a[1]"})
def both_turn_the_same_way() -> None:
    """The impulse turns both bodies the same way."""


@wrong_model("11.2", "Bodies that part at the contact: does anything pull them together?")
@edited(
    one_loop_for_both_directions,
    {
        "friction * jn": "friction * abs(jn)",
        "max(-(1 + restitution) * u / yields, 0)": "-(1 + restitution) * u / yields",
    },
)
def without_a_gate() -> None:
    """Every contact is a hit."""


@wrong_model(
    "11.2", "The blow along the normal turns both bodies. Do they slide as before, after it?"
)
@edited(
    one_loop_for_both_directions,
    {
        "(v[1] - v[0]) @ n + w[1] * r[1] - w[0] * r[0]": (
            "(b[2:4] - a[2:4]) @ n + b[4] * r[1] - a[4] * r[0]"
        )
    },
)
def sliding_before_the_blow() -> None:
    """Friction acts on the sliding that there was before the impact."""


@wrong_model(
    "11.3", "Which velocity moves the disc in your step: that at its start, or that at its end?"
)
@edited(
    pair_by_pair_and_wall_by_wall,
    {"p = positions + velocities * dt": "p = positions + v * dt"},
)
def falls_before_it_moves() -> None:
    """Gravity comes first, and the new velocity moves the discs."""


@wrong_model("11.3", "Read step 1 of the task again. With which velocity do the discs move?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"positions + velocities * dt": "positions + velocities * dt + gravity * dt**2 / 2"},
)
def falls_as_it_moves() -> None:
    """In a step a disc moves by v t + g t^2 / 2, as in free fall."""


@wrong_model(
    "11.3",
    "A disc beyond the wall is on its way in already. Which way does it fly after your step?",
)
@edited(pair_by_pair_and_wall_by_wall, {"v[out, axis] *=": "v[left | right, axis] *="})
def walls_without_a_gate() -> None:
    """A disc beyond a wall is turned round."""


@wrong_model("11.3", "The disc has turned round. Is it still in the wall?")
@edited(pair_by_pair_and_wall_by_wall, {"p[:, axis] = np.clip(p[:, axis], low, high)": "pass"})
def nobody_is_put_back() -> None:
    """The velocity is turned round, and the disc comes out by itself."""


@wrong_model("11.3", "A disc has a size. Which part of it touches the wall first?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"low, high = radii, room[axis] - radii": "low, high = 0, room[axis]"},
)
def centres_at_the_walls() -> None:
    """A disc is beyond a wall where its centre is."""


@wrong_model("11.3", "Two discs overlap and part already. Why do you hit them?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"max(-(1 + restitution) * vn / k, 0)": "-(1 + restitution) * vn / k"},
)
def pairs_without_a_gate() -> None:
    """Discs that overlap hit each other."""


@wrong_model("11.3", "A heavy disc and a light one: do both give way by the same?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"depth / k / masses[i]": "depth / 2", "depth / k / masses[j]": "depth / 2"},
)
def half_each() -> None:
    """Each disc is moved by half of the overlap."""


@wrong_model("11.1", "You sorted the boxes. In which order do the two numbers of a pair stand?")
def pairs_as_they_were_sorted(boxes: Any) -> list[tuple[int, int]]:
    """The pairs come out in the order of the sweep."""
    order = sorted(range(len(boxes)), key=lambda n: boxes[n][0])
    return [
        (i, j)
        for place, i in enumerate(order)
        for j in order[place + 1 :]
        if boxes[j][0] <= boxes[i][1] and boxes[j][2] <= boxes[i][3] and boxes[i][2] <= boxes[j][3]
    ]


@wrong_model("11.1", "You have sorted the boxes. Whose numbers are asked for: the sorted ones?")
def places_after_sorting(boxes: Table) -> Any:
    """The number of a box is its place in the sorted list."""
    order = sorted([float(side) for side in box] for box in boxes)
    return [
        (i, k)
        for i in range(len(order))
        for k in range(i + 1, len(order))
        if order[k][0] <= order[i][1] and order[k][2] <= order[i][3] and order[i][2] <= order[k][3]
    ]
