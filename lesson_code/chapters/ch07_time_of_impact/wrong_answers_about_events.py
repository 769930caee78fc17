"""Wrong models of chapter 07: which pair meets first, and how often blocks collide."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

from lesson_code.chapters.ch07_time_of_impact.right_answers import from_hit_to_hit, pair_by_pair
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("7.4", "A snail is near, a bullet is far. Which of them arrives first?")
@edited(
    pair_by_pair,
    {
        "append((t, i, j))": "append((np.hypot(*d) - radii[i] - radii[j], t, i, j))",
        "min(found, default=None)": "min(found)[1:] if found else None",
    },
)
def the_nearest_pair() -> None:
    """The pair with the smallest gap meets first."""


@wrong_model("7.4", "You stop at the first pair that meets. Is there one that meets before it?")
@edited(pair_by_pair, {"min(found, default=None)": "found[0] if found else None"})
def the_first_pair_found() -> None:
    """The first pair that will meet is the one that meets first."""


@wrong_model("7.4", "A later pair meets, too. Whose numbers go with the smallest time then?")
@edited(
    pair_by_pair,
    {"min(found, default=None)": "(min(found)[0], *found[-1][1:]) if found else None"},
)
def the_pair_looked_at_last() -> None:
    """The numbers are those of the last pair that meets, the time is that of the first."""


@wrong_model("7.4", "Is your event the next one, or the last one?")
@edited(pair_by_pair, {"min(found": "max(found"})
def the_last_event() -> None:
    """Of all times the largest one is the next."""


@wrong_model("7.4", "Can number 0 meet number 2, before either of them meets number 1?")
@edited(pair_by_pair, {"range(i + 1, len(radii))": "range(i + 1, len(radii))[:1]"})
def only_neighbours() -> None:
    """A circle meets the next one in the list."""


@wrong_model("7.4", "Two circles meet at the time 0.0. What does Python make of `if 0.0:`?")
@edited(pair_by_pair, {"found.append((t, i, j))": "found += [(t, i, j)] if t else []"})
def now_is_no_time() -> None:
    """`if t` asks whether two circles meet."""


@wrong_model("7.4", "One of your times is negative. Has that pair still to meet?")
@edited(
    pair_by_pair,
    {
        "b < 0 <= b * b - a * c": "a > 0 and b * b - a * c >= 0",
        "max(c, 0.0) / (-b + np.sqrt(b * b - a * c))": "(-b - np.sqrt(b * b - a * c)) / a",
    },
)
def meetings_of_the_past() -> None:
    """The smallest root of all is the next event."""


@wrong_model("7.4", "Which number has the first circle of a list in Python?")
@edited(pair_by_pair, {"(t, i, j)": "(t, i + 1, j + 1)"})
def numbered_from_one() -> None:
    """The first circle is number 1."""


@wrong_model("7.5", "Is it pi for every mass ratio? Count by hand for a ratio of 2.")
def digits_of_pi(mass_ratio: float) -> int:
    """The count is pi times the square root of the ratio, rounded down."""
    return int(math.pi * math.sqrt(mass_ratio))


@wrong_model("7.5", "The light block has hit the wall. Did you count that?")
@edited(from_hit_to_hit, {"light, count = -light, count + 1": "light = -light"})
def walls_not_counted() -> None:
    """A collision takes two blocks."""


@wrong_model("7.5", "The heavy block has turned round. Can the light one still catch up with it?")
@edited(from_hit_to_hit, {"light > heavy": "heavy < 0"})
def until_the_heavy_block_turns() -> None:
    """When the heavy block moves away, all is over."""


@wrong_model("7.5", "Which of the blocks stands at the wall, the heavy one or the light one?")
@edited(from_hit_to_hit, {"(light + mass_ratio * heavy)": "(mass_ratio * light + heavy)"})
def heavy_block_at_the_wall() -> None:
    """The block that comes is the light one."""


@wrong_model("7.5", "Only equal masses exchange their velocities. What does the mass ratio do?")
@edited(from_hit_to_hit, {"2 * centre - light, 2 * centre - heavy": "heavy, light"})
def exchanges_velocities() -> None:
    """In an elastic collision the blocks exchange their velocities."""


@wrong_model("7.5", "How many collisions can there be between two looks? How many do you count?")
def steps_in_time(mass_ratio: float) -> int:
    """One looks sixty times in a second, and counts what has met."""
    x1, x2, v1, v2, count = 1.0, 2.0, 0.0, -1.0, 0
    for _ in range(1200):
        x1, x2 = x1 + v1 / 60, x2 + v2 / 60
        if x2 <= x1 and v2 < v1:
            centre = (v1 + mass_ratio * v2) / (1 + mass_ratio)
            v1, v2, count = 2 * centre - v1, 2 * centre - v2, count + 1
        if x1 <= 0 and v1 < 0:
            v1, count = -v1, count + 1
    return count


@wrong_model("7.4", "When two centres are nearest, have the rims not met long before?")
@edited(
    pair_by_pair,
    {
        "b < 0 <= b * b - a * c": "b < 0",
        "max(c, 0.0) / (-b + np.sqrt(b * b - a * c))": "-b / a",
    },
)
def nearest_is_meeting() -> None:
    """Two that approach meet when their centres are nearest."""


@wrong_model("7.4", "Two circles overlap, but they part. Do they still have to meet?")
@edited(
    pair_by_pair,
    {
        "if b < 0 <= b * b - a * c": "if c <= 0 or b < 0 <= b * b - a * c",
        "t = max(c, 0.0) /": "t = 0.0 if c <= 0 else c /",
    },
)
def overlapping_is_meeting_now() -> None:
    """Circles that overlap meet now, whichever way they move."""


@wrong_model("7.5", "Count by hand for a ratio of 2. Has it two digits, or one, or one and a half?")
def digits_by_the_zeros(mass_ratio: float) -> int:
    """Each two zeros of the ratio give one digit of pi more, and others give what is near."""
    return int(math.pi * 10 ** round(math.log10(mass_ratio) / 2))


@wrong_model("7.5", "Which of the blocks is between the other one and the wall?")
@edited(
    from_hit_to_hit,
    {
        "        if light < 0:": (
            "        if heavy < 0:\n            heavy, count = -heavy, count + 1\n"
            "        if light < 0:"
        )
    },
)
def the_heavy_block_at_the_wall_too() -> None:
    """Each block that moves towards the wall bounces off it."""


@wrong_model(
    "7.5", "The light block is slower. Does it move away from the heavy one, or towards it?"
)
@edited(
    from_hit_to_hit,
    {
        "        if light < 0:": (
            "        if abs(light) <= abs(heavy):\n            break\n        if light < 0:"
        )
    },
)
def over_when_the_light_one_is_slower() -> None:
    """When the light block is slower than the heavy one, all is over, whichever way they move."""


@wrong_model(
    "7.5", "The last strike leaves the light block moving away from the wall. Does it hit it?"
)
@edited(
    from_hit_to_hit,
    {
        "        if light < 0:\n            light, count = -light, count + 1": (
            "        light, count = abs(light), count + 1"
        )
    },
)
def the_wall_after_every_strike() -> None:
    """After each strike the light block hits the wall."""
