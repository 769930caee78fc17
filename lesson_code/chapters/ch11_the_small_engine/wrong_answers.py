"""Wrong models of chapter 11: a broad phase, a hit, a step; callbacks, an effect, a sound.

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


@wrong_model("11.4", "A box has lain on the floor for a minute. Does it begin to touch it again?")
def everything_that_touches(before: Table, now: Table) -> Any:
    """What touches now has begun to touch."""
    return [tuple(pair) for pair in now], [tuple(p) for p in before if list(p) not in now.tolist()]


@wrong_model("11.4", "Which of your two lists should a door use that opens when it is pressed?")
def begun_and_parted_swapped(before: Table, now: Table) -> Any:
    """What was there before and is no more has begun."""
    earlier, later = {tuple(p) for p in before}, {tuple(p) for p in now}
    return list(earlier - later), list(later - earlier)


@wrong_model("11.4", "A ball lies on the floor and now meets a second ball. Is that a new touch?")
def only_bodies_that_touched_nothing(before: Table, now: Table) -> Any:
    """A body that touches something already cannot begin to."""
    busy = {body for pair in before for body in pair}
    still = {body for pair in now for body in pair}
    return (
        [tuple(pair) for pair in now if not busy & set(pair)],
        [tuple(pair) for pair in before if not still & set(pair)],
    )


@wrong_model("11.4", "One pair parts and another one begins. Which of them is in which list?")
def all_changes_in_both(before: Table, now: Table) -> Any:
    """Whatever has changed is both."""
    changed = list({tuple(p) for p in before} ^ {tuple(p) for p in now})
    return changed, changed


@wrong_model("11.5", "Half of it is left after one half-life. What is left after two? Nothing?")
def fades_by_a_fixed_amount(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """The light goes down evenly, to one half in a half-life."""
    return np.where(hit, 1.0, np.maximum(brightness * (1 - dt / (2 * half_life)), 0))


@wrong_model("11.5", "exp(-1) is 0.37. How much is left after one half-life by your formula?")
def e_in_place_of_two(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """A half-life is the time constant of the exponential."""
    return np.where(hit, 1.0, brightness * np.exp(-dt / half_life))


@wrong_model("11.5", "A slow computer makes half as many steps. Does its light last twice as long?")
def half_in_every_step(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """Every step takes one half."""
    return np.where(hit, 1.0, brightness / 2)


@wrong_model("11.5", "A body is hit just now. Should anyone see it at full brightness?")
def fades_at_once(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """What is hit is lit, and then everything fades."""
    return np.where(hit, 1.0, brightness) * 0.5 ** (dt / half_life)


@wrong_model("11.5", "A body that is bright already is hit again. Can it be brighter than full?")
def light_adds_up(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """A hit adds its light to what is there."""
    return brightness * 0.5 ** (dt / half_life) + hit


@wrong_model("11.6", "The sine takes radians. How many does one period have?")
def without_two_pi(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The sine's argument is f t."""
    t = np.arange(count) / rate
    if frequency >= rate / 2:
        return np.zeros(count)
    return loudness * 0.5 ** (t / half_life) * np.sin(frequency * t)


@wrong_model("11.6", "At the instant of the blow the membrane is at rest. What do you hear there?")
def begins_with_a_jump(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The sound is loudest where it begins: a cosine."""
    t = np.arange(count) / rate
    if frequency >= rate / 2:
        return np.zeros(count)
    return loudness * 0.5 ** (t / half_life) * np.cos(2 * np.pi * frequency * t)


@wrong_model("11.6", "Strike a bell. Does it ring for ever?")
def never_dies_away(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """A tone keeps its loudness."""
    t = np.arange(count) / rate
    if frequency >= rate / 2:
        return np.zeros(count)
    return loudness * np.sin(2 * np.pi * frequency * t)


@wrong_model("11.6", "exp(-1) is 0.37. How loud is the tone after one half-life by your formula?")
def fades_by_e(loudness: float, frequency: float, half_life: float, rate: float, count: int) -> Any:
    """After one half-life a tone has faded by the factor e."""
    t = np.arange(count) / rate
    if frequency >= rate / 2:
        return np.zeros(count)
    return loudness * np.exp(-t / half_life) * np.sin(2 * np.pi * frequency * t)


@wrong_model("11.6", "Sample a tone of 1,100 per second 1,000 times a second. Which tone is heard?")
def any_tone_can_be_sampled(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The samples of a tone are heard as that tone, however high it is."""
    t = np.arange(count) / rate
    return loudness * 0.5 ** (t / half_life) * np.sin(2 * np.pi * frequency * t)


@wrong_model("11.6", "Sample number k is heard at which time?")
def a_sample_a_second(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The samples are numbered in seconds for the loudness."""
    k = np.arange(count)
    if frequency >= rate / 2:
        return np.zeros(count)
    return loudness * 0.5 ** (k / half_life) * np.sin(2 * np.pi * frequency * k / rate)


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


@wrong_model("11.4", "1 and 2 touched, and 3 and 4. Now 1 and 3 do: is that pair an old one?")
def numbers_in_place_of_pairs(before: Any, now: Any) -> Any:
    """A pair is known if both of its numbers are."""
    was, stays = ({int(n) for pair in pairs for n in pair} for pairs in (before, now))
    begun = [(int(i), int(j)) for i, j in now if not {int(i), int(j)} <= was]
    parted = [(int(i), int(j)) for i, j in before if not {int(i), int(j)} <= stays]
    return begun, parted


@wrong_model("11.4", "A pair moves up a row, as one above it has parted. Does it touch anew?")
def row_against_row(before: Any, now: Any) -> Any:
    """A pair that touches keeps its row in the table."""
    old, new = ([(int(i), int(j)) for i, j in pairs] for pairs in (before, now))
    begun = [pair for k, pair in enumerate(new) if old[k : k + 1] != [pair]]
    return begun, [pair for k, pair in enumerate(old) if new[k : k + 1] != [pair]]


@wrong_model("11.6", "The samples are 1/rate apart. Between ten samples, how many gaps are there?")
def with_the_end_of_the_time(
    loudness: float, frequency: float, half_life: float, rate: float, count: int
) -> Any:
    """The samples divide the whole time, its end included."""
    if frequency >= rate / 2:
        return np.zeros(int(count))
    t = np.linspace(0, count / rate, int(count))
    return loudness * 0.5 ** (t / half_life) * np.sin(2 * np.pi * frequency * t)


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
