"""Wrong models of dominoes: when one topples, what that takes, a row of them."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.dominoes.right_answers import as_a_list_of_pairs
from lesson_code.chapters.dominoes.rules import GRAVITY
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("D.1", "A tall, thin domino: does it stand a large tilt, or a small one?")
def upside_down(width: float, height: float) -> float:
    """The tipping angle is that of the diagonal above the ground."""
    return math.atan2(height, width)


@wrong_model("D.1", "Draw the centre and the edge. Is the tangent width / height, or half of it?")
def half_the_width(width: float, height: float) -> float:
    """The centre lies half a width from the edge and a whole height above it."""
    return math.atan2(width / 2, height)


@wrong_model("D.1", "Of which angle is width / height the tangent? And what unit is asked for?")
def ratio_for_angle(width: float, height: float) -> float:
    """The angle is width over height."""
    return width / height


@wrong_model("D.1", "Which side of your triangle is the longest one?")
def sine_for_tangent(width: float, height: float) -> float:
    """Width over height is the sine of the angle."""
    return math.asin(width / height) if width < height else math.pi / 2


@wrong_model("D.2", "It turns about an edge. Which moment of inertia belongs to that axis?")
def about_the_centre(width: float, height: float) -> float:
    """The domino turns about its centre."""
    rise = (math.hypot(width, height) - height) / 2
    return math.sqrt(2 * GRAVITY * rise / ((width**2 + height**2) / 12))


@wrong_model(
    "D.2", "How high is the centre of a standing domino, and how high at the tipping point?"
)
def whole_diagonal(width: float, height: float) -> float:
    """The centre rises by diagonal less height."""
    rise = math.hypot(width, height) - height
    return math.sqrt(2 * GRAVITY * rise / ((width**2 + height**2) / 3))


@wrong_model("D.2", "Kinetic energy has a factor in front of I w^2. Where is it?")
def without_one_half(width: float, height: float) -> float:
    """The energy of rotation is I w^2."""
    rise = (math.hypot(width, height) - height) / 2
    return math.sqrt(GRAVITY * rise / ((width**2 + height**2) / 3))


@wrong_model("D.2", "Energy goes with the square of the rate. Is yours a rate, or its square?")
def squared(width: float, height: float) -> float:
    """The rate goes with the energy."""
    rise = (math.hypot(width, height) - height) / 2
    return 2 * GRAVITY * rise / ((width**2 + height**2) / 3)


def _pass_by(angles: Vector, rates: Vector) -> None:
    """Do nothing to dominoes that touch."""


def _run(state: Vector, height: float, dt: float, steps: float, touch: Any) -> Any:
    """Return a row after `steps` steps; `touch(angles, rates)` does what a model does to pairs."""
    angles, rates = state[0].copy(), state[1].copy()
    for _ in range(int(steps)):
        rates += 3 * GRAVITY / (2 * height) * np.sin(angles) * dt
        angles += rates * dt
        touch(angles, rates)
        lies = angles > math.pi / 2
        angles[lies], rates[lies] = math.pi / 2, 0.0
    return angles, rates


@wrong_model("D.3", "Does your second domino ever hear of the first?")
def each_for_itself(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """Dominoes do not touch."""
    return _run((angles, rates), height, dt, steps, _pass_by)


@wrong_model("D.3", "A domino touches the next one with its top. Where is its top at that angle?")
def touches_by_the_tangent(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """Two dominoes touch at the angle whose tangent is spacing over height."""

    def touch(a: Vector, r: Vector) -> None:
        for k in range(len(a) - 1):
            if a[k] > math.atan2(spacing, height) and r[k] > r[k + 1]:
                r[k] = r[k + 1] = (r[k] + r[k + 1]) / 2

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", "Add up the rates before and after a touch. Who has paid for the second one's?")
def copies_the_rate(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """The next domino gets the rate of the one that pushes it, which keeps its own."""

    def touch(a: Vector, r: Vector) -> None:
        for k in range(len(a) - 1):
            if a[k] > math.asin(spacing / height) and r[k] > r[k + 1]:
                r[k + 1] = r[k]

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", "Balls of a cradle part after a touch. Do two dominoes that lean together?")
def exchange_their_rates(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """Equal dominoes exchange their rates, as balls of a cradle do."""

    def touch(a: Vector, r: Vector) -> None:
        for k in range(len(a) - 1):
            if a[k] > math.asin(spacing / height) and r[k] > r[k + 1]:
                r[k], r[k + 1] = r[k + 1], r[k]

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", "The first one hangs back and the next falls away. Do they still touch?")
def without_gate(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """A domino that leans far enough and the next one always turn together."""

    def touch(a: Vector, r: Vector) -> None:
        for k in range(len(a) - 1):
            if a[k] > math.asin(spacing / height):
                r[k] = r[k + 1] = (r[k] + r[k + 1]) / 2

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", "Upright, nothing pulls at a domino. What does your gravity do at angle 0?")
def cosine_for_sine(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """Gravity turns a domino by the cosine of its angle."""
    a, r = angles.copy(), rates.copy()
    for _ in range(int(steps)):
        r += 3 * GRAVITY / (2 * height) * np.cos(a) * dt
        a += r * dt
        for k in range(len(a) - 1):
            if a[k] > math.asin(spacing / height) and r[k] > r[k + 1]:
                r[k] = r[k + 1] = (r[k] + r[k + 1]) / 2
        lies = a > math.pi / 2
        a[lies], r[lies] = math.pi / 2, 0.0
    return a, r


@wrong_model("D.3", "The first rate has changed when you work out the second. What do both get?")
def mean_of_the_mean(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """The second of two rates is the mean of the first, as it is by then, and its own."""
    angles, rates = np.array(angles, dtype=float), np.array(rates, dtype=float)
    reach = math.asin(spacing / height)
    for _ in range(int(steps)):
        rates += 1.5 * GRAVITY / height * np.sin(angles) * dt
        angles += rates * dt
        for i in range(len(angles) - 1):
            if angles[i] > reach and rates[i] > rates[i + 1]:
                rates[i] = (rates[i] + rates[i + 1]) / 2
                rates[i + 1] = (rates[i] + rates[i + 1]) / 2
        rates[angles > math.pi / 2] = 0.0
        angles = np.minimum(angles, math.pi / 2)
    return angles, rates


@wrong_model("D.3", "A domino lies on the floor. What is its rate then?")
@edited(as_a_list_of_pairs, {"[math.pi / 2, 0]": "[math.pi / 2, r]"})
def keeps_its_rate_on_the_floor() -> None:
    """What lies has its angle, and the rate that it had."""


@wrong_model("D.3", "One domino stands free. Can two that come after it lean against each other?")
@edited(
    as_a_list_of_pairs,
    {
        "if height * math.sin(min(one[0], math.pi / 2)) > spacing and": (
            "if height * math.sin(min(one[0], math.pi / 2)) <= spacing:\n"
            "                break\n"
            "            if"
        )
    },
)
def ends_at_the_first_that_stands_free() -> None:
    """The push has come as far as the first domino that does not touch the next one."""


@wrong_model("D.2", "How far from the edge is the centre: half the height, or half the diagonal?")
def moved_by_half_the_height(width: float, height: float) -> float:
    """The axis lies half the height below the centre: I = m (w^2 + h^2) / 12 + m (h / 2)^2."""
    inertia = (width**2 + height**2) / 12 + height**2 / 4
    return math.sqrt(GRAVITY * (math.hypot(width, height) - height) / inertia)


def _at_once(a: Vector, r: Vector, reach: float) -> list[tuple[int, float]]:
    """Return who touches the next one, and the mean of both rates: all before any has changed."""
    touching = [k for k in range(len(a) - 1) if a[k] > reach and r[k] > r[k + 1]]
    return [(k, (r[k] + r[k + 1]) / 2) for k in touching]


OF_THE_OLD_RATES = "The first has just braked against the second. Which rate meets the third?"


@wrong_model("D.3", OF_THE_OLD_RATES)
def all_at_once(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """All that touch do so at once, each pair with its rates from before the step's touches."""

    def touch(a: Vector, r: Vector) -> None:
        for k, mean in _at_once(a, r, math.asin(spacing / height)):
            r[k] = r[k + 1] = mean

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", OF_THE_OLD_RATES)
def all_at_once_the_pushed_last(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """All that touch do so at once, and who pushes and is pushed has the mean of the latter."""

    def touch(a: Vector, r: Vector) -> None:
        found = _at_once(a, r, math.asin(spacing / height))
        for shift in (0, 1):
            for k, mean in found:
                r[k + shift] = mean

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.3", OF_THE_OLD_RATES)
def all_at_once_added_up(
    angles: Vector, rates: Vector, height: float, spacing: float, dt: float, steps: float
) -> Any:
    """All that touch do so at once, and what each gives to the next one is added up at the end."""

    def touch(a: Vector, r: Vector) -> None:
        given = [(k, r[k] - mean) for k, mean in _at_once(a, r, math.asin(spacing / height))]
        for k, part in given:
            r[k] -= part
            r[k + 1] += part

    return _run((angles, rates), height, dt, steps, touch)


@wrong_model("D.2", "Is all of a domino as far from its edge as its centre is?")
def all_at_the_centre(width: float, height: float) -> float:
    """The mass is at the centre, half a diagonal from the edge: I = m d^2."""
    d = math.hypot(width, height) / 2
    return math.sqrt(2 * GRAVITY * (d - height / 2)) / d


@wrong_model("D.2", "How high is the centre of the standing domino, and how far does that tilt up?")
def lowered_by_the_tilt(width: float, height: float) -> float:
    """The centre moves by h / 2 (1 - cos a): it is right above the edge from the beginning."""
    rise = height / 2 * (1 - math.cos(math.atan2(width, height)))
    return math.sqrt(6 * GRAVITY * rise) / math.hypot(width, height)


@wrong_model("D.3", "Do two equal dominoes that lean together turn as fast as the one before?")
@edited(
    as_a_list_of_pairs,
    {
        "one[1] = following[1] = 0.5 * (one[1] + following[1])": (
            "one[1], following[1] = 0.0, one[1] + following[1]"
        )
    },
)
def hands_all_on() -> None:
    """A domino that touches the next one stops, and adds its rate to that one's."""


@wrong_model("D.3", "Add up the rates before and after a touch. Where is the next one's old rate?")
@edited(
    as_a_list_of_pairs,
    {
        "one[1] = following[1] = 0.5 * (one[1] + following[1])": (
            "one[1], following[1] = 0.0, one[1]"
        )
    },
)
def hands_its_rate_on() -> None:
    """A domino that touches the next one stops, and that one goes on at its rate."""


@wrong_model("D.3", "Which of the two is new in the task when the angle grows: which rate is it?")
@edited(
    as_a_list_of_pairs,
    {
        "            domino[0] += domino[1] * dt\n": "",
        "            domino[1] +=": (
            "            domino[0], angle = domino[0] + domino[1] * dt, domino[0]\n"
            "            domino[1] +="
        ),
        "math.sin(domino[0])": "math.sin(angle)",
    },
)
def grows_by_the_old_rate() -> None:
    """The angle grows by the rate from before the step."""


@wrong_model("D.3", "Is a domino as easy to turn about its foot as a ball on a string?")
@edited(as_a_list_of_pairs, {"1.5 * 9.81": "9.81"})
def as_a_pendulum() -> None:
    """Gravity turns a domino by g / height, as it does a ball on a string."""


@wrong_model("D.3", "A domino leans by 80 degrees. Is the pull on it as large as its angle?")
@edited(as_a_list_of_pairs, {"math.sin(domino[0])": "domino[0]"})
def pull_by_the_angle() -> None:
    """Gravity pulls by the angle, of which the sine is nearly the same."""


@wrong_model("D.3", "Which comes first in the task: the floor, or the touches?")
@edited(
    as_a_list_of_pairs,
    {
        "        for one, following": (
            "        for domino in row:\n"
            "            if domino[0] > math.pi / 2:\n"
            "                domino[:] = [math.pi / 2, 0.0]\n"
            "        for one, following"
        ),
        "[math.pi / 2, 0]": "[a, r]",
    },
)
def stopped_by_the_floor_first() -> None:
    """What is beyond the floor is stopped first, and then the touches are looked at."""
