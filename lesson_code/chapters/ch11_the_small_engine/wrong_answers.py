"""Wrong models of chapter 11: a broad phase, and a hit.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch11_the_small_engine.right_answers import (
    one_loop_for_both_directions,
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


@wrong_model("11.1", "A large box lies around a small one. Where are the corners of the large one?")
@edited(
    corners_inside,
    {"((boxes[i], boxes[j]), (boxes[j], boxes[i]))": "((boxes[i], boxes[j]),)"},
)
def corners_of_the_later_box() -> None:
    """Boxes overlap if a corner of the one that comes later is inside the other."""


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


@wrong_model("11.1", "A long box comes first, two short ones lie in it. Which are compared?")
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


@wrong_model("11.1", "In which order do the four sides of a box stand in its row?")
def sides_in_another_order(boxes: Table) -> Any:
    """A row is left, low, right, high."""
    count = len(boxes)
    return [
        (i, j)
        for i in range(count)
        for j in range(i + 1, count)
        if (boxes[i][:2] <= boxes[j][2:]).all() and (boxes[j][:2] <= boxes[i][2:]).all()
    ]


@wrong_model("11.1", "A long plank hangs above another. Do the circles around them tell?")
def circles_around_boxes(boxes: Table) -> Any:
    """Boxes may touch if the circles around them do."""
    middles = (boxes[:, ::2] + boxes[:, 1::2]) / 2
    radii = np.hypot(*(boxes[:, 1::2] - boxes[:, ::2]).T) / 2
    count = range(len(boxes))
    ways = [(i, j, np.hypot(*(middles[j] - middles[i]))) for i in count for j in count if i < j]
    return [(i, j) for i, j, way in ways if way <= radii[i] + radii[j]]


@wrong_model("11.1", "Two boxes touch at their corners. Where are their centres?")
def centre_inside(boxes: Table) -> Any:
    """Boxes overlap if the centre of one is inside the other."""
    middles = (boxes[:, ::2] + boxes[:, 1::2]) / 2
    holds = [
        [(box[::2] <= middle).all() and (middle <= box[1::2]).all() for middle in middles]
        for box in boxes
    ]
    count = range(len(boxes))
    return [(i, j) for i in count for j in count if i < j and (holds[i][j] or holds[j][i])]


@wrong_model("11.1", "A long box lies under two others. How many pairs is it in?")
@edited(
    swept_in_order,
    {
        "min(order[i], order[k]), max(order[i], order[k])))": (
            "min(order[i], order[k]), max(order[i], order[k])))\n                break"
        )
    },
)
def one_partner_in_a_sweep() -> None:
    """Sorted by their left sides, a box is in one pair with those after it."""


@wrong_model("11.1", "A long box lies under two others. In how many pairs can it be?")
def one_partner_each(boxes: Table) -> Any:
    """A box that has found a partner is done."""
    found: list[tuple[int, int]] = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            x, y = (
                boxes[i][k] <= boxes[j][k + 1] and boxes[j][k] <= boxes[i][k + 1] for k in (0, 2)
            )
            if x and y:
                found.append((i, j))
                break
    return found


@wrong_model("11.1", "Number 0 has met number 3. Can number 3 still meet number 5?")
def each_in_one_pair(boxes: Table) -> Any:
    """A box is in one pair at the most."""
    found: list[tuple[int, int]] = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            x, y = (
                boxes[i][k] <= boxes[j][k + 1] and boxes[j][k] <= boxes[i][k + 1] for k in (0, 2)
            )
            if x and y and not {i, j} & {n for pair in found for n in pair}:
                found.append((i, j))
    return found


@wrong_model("11.2", "A lever for the push along n, and one for the rub along t. Are they alike?")
@edited(
    one_loop_for_both_directions,
    {
        "limit = friction * jn": (
            "limit = friction * jn\n        kept = yields = kept if turn else yields"
        )
    },
)
def yields_alike_both_ways() -> None:
    """The bodies yield along the tangent as they do along the normal."""


@wrong_model("11.2", "Two discs do not move but spin. Do their rims slide on each other?")
@edited(
    one_loop_for_both_directions,
    {"w[1] * r[1] - w[0] * r[0]": "(w[1] * r[1] - w[0] * r[0]) * (1 - turn)"},
)
def centres_slide() -> None:
    """How fast two bodies slide is how fast their centres do, however they spin."""


@wrong_model("11.2", "A ball is rubbed at its rim. Does it begin to turn?")
@edited(
    one_loop_for_both_directions,
    {
        "j * r[0] / a[1]": "(0 if turn else j) * r[0] / a[1]",
        "j * r[1] / b[1]": "(0 if turn else j) * r[1] / b[1]",
    },
)
def friction_does_not_turn() -> None:
    """Friction changes the velocities, and the spins stay."""


@wrong_model("11.2", "Your bodies slide on after the hit as fast as before. What does mu do?")
@edited(one_loop_for_both_directions, {"np.clip(-u / yields, -limit, limit)": "0.0"})
def hit_without_friction() -> None:
    """A hit acts along the normal alone."""


@wrong_model("11.2", "The push goes through the centre. Is the lever then all of the arm, or 0?")
@edited(
    one_loop_for_both_directions,
    {
        "r = arms[:, 0] * n[1] - arms[:, 1] * n[0]": (
            "q = arms[:, 0] * n[1] - arms[:, 1] * n[0]\n        r = arms @ n"
        ),
        "w[1] * r[1] - w[0] * r[0]": "w[1] * q[1] - w[0] * q[0]",
    },
)
def dot_product_for_a_lever() -> None:
    """The lever is the part of the arm along the impulse."""


@wrong_model("11.2", "The push goes through the centre. Does the length of the arm turn the body?")
@edited(
    one_loop_for_both_directions,
    {
        "r = arms[:, 0] * n[1] - arms[:, 1] * n[0]": (
            "q = arms[:, 0] * n[1] - arms[:, 1] * n[0]\n        r = np.hypot(*arms.T)"
        ),
        "w[1] * r[1] - w[0] * r[0]": "w[1] * q[1] - w[0] * q[0]",
    },
)
def whole_arm_for_a_lever() -> None:
    """The lever is the length of the arm."""


@wrong_model("11.2", "A disc turns counter-clockwise. Which way moves its right rim?")
@edited(
    one_loop_for_both_directions, {"+ w[1] * r[1] - w[0] * r[0]": "- w[1] * r[1] + w[0] * r[0]"}
)
def rims_move_the_other_way() -> None:
    """A body that turns counter-clockwise moves down on its right."""


@wrong_model("11.2", "With how much does the contact press: with all of jn, the bounce included?")
@edited(one_loop_for_both_directions, {"friction * jn": "friction * jn / (1 + restitution)"})
def limit_without_the_bounce() -> None:
    """Only the part of the normal impulse that stops the approach counts for friction."""


@wrong_model("11.2", "A rubber ball slides over the floor. Does friction throw it back?")
@edited(
    one_loop_for_both_directions,
    {"np.clip(-u / yields,": "np.clip(-(1 + restitution) * u / yields,"},
)
def friction_with_restitution() -> None:
    """Restitution turns the sliding round as well, as far as friction can."""
