"""What the reader of chapter 05 writes: an impulse, a ratio of speeds, limits of a slope."""

from __future__ import annotations

import math
from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def stopping_impulse(m_eff: float, vt: float) -> float:
    """Return the impulse along the tangent that stops a sliding, N s."""
    return -m_eff * vt


@wrong_model("05-stopping", "The contact slides to the right. Which way does what stops it push?")
def pushes_along(m_eff: float, vt: float) -> float:
    """The impulse has the direction of the sliding."""
    return m_eff * vt


@wrong_model("05-stopping", "A heavier body is harder to stop. Is yours?")
def divides_by_the_mass(m_eff: float, vt: float) -> float:
    """A large mass needs a small impulse."""
    return -vt / m_eff


@wrong_model("05-stopping", "What changes a velocity by -2 vt does more than stop it. What?")
def turns_the_sliding_round(m_eff: float, vt: float) -> float:
    """The sliding bounces, as the approach does."""
    return -2 * m_eff * vt


def rolling_part(k: float) -> float:
    """Return which part of its velocity a body keeps that begins to roll."""
    return 1 / (1 + k)


@wrong_model("05-rolling", "Put in k = 0: a body that turns by itself. How fast does it go on?")
def part_that_turns(k: float) -> float:
    """The part that is left is the one that has gone into turning."""
    return k / (1 + k)


@wrong_model("05-rolling", "With k = 1 nothing would be left. Does a hoop stop on a rough floor?")
def takes_k_away(k: float) -> float:
    """The part k is lost."""
    return 1 - k


@wrong_model("05-rolling", "Which quantity is kept about a point of the floor: energy, or another?")
def from_the_energy(k: float) -> float:
    """Energy is kept: the square of the velocity falls to 1/(1 + k)."""
    return 1 / math.sqrt(1 + k)


def friction_to_roll(slope: float, k: float) -> float:
    """Return the smallest friction coefficient with which a round body rolls down a slope."""
    return math.tan(slope) * k / (1 + k)


@wrong_model("05-roll-down", "That is what holds a box. Does a disc need as much, which may turn?")
def as_for_a_box(slope: float, k: float) -> float:
    """A round body slips where a box would slide."""
    return math.tan(slope)


@wrong_model("05-roll-down", "A body with k near 0 is easy to turn. Does that need much friction?")
def the_other_share(slope: float, k: float) -> float:
    """The share is 1/(1 + k)."""
    return math.tan(slope) / (1 + k)


@wrong_model("05-roll-down", "What presses the body on the slope: all of its weight, or a part?")
def sine_for_tangent(slope: float, k: float) -> float:
    """The body is pressed on with its whole weight."""
    return math.sin(slope) * k / (1 + k)


def slope_to_tip(width: float, height: float) -> float:
    """Return the slope from which on a box that cannot slide tips over, rad."""
    return math.atan(width / height)


@wrong_model("05-tips", "Does a tall, narrow box stand on a steeper slope than a flat one?")
def tall_boxes_stand_best(width: float, height: float) -> float:
    """The tangent is that of height over width."""
    return math.atan(height / width)


@wrong_model("05-tips", "The centre of mass is half way up, and half way along the base. And then?")
def half_of_the_base(width: float, height: float) -> float:
    """Half of the base over the whole height."""
    return math.atan(width / 2 / height)


@wrong_model("05-tips", "That is the tangent of the angle. Which function gives the angle?")
def the_tangent_itself(width: float, height: float) -> float:
    """A small angle is its own tangent, and so is a large one."""
    return width / height


@wrong_model("05-tips", "The slope is wanted in radians. What is yours in?")
def in_degrees(width: float, height: float) -> float:
    """Angles are in degrees."""
    return math.degrees(slope_to_tip(width, height))


def box_on_a_slope(stream: Random) -> tuple[float, ...]:
    """Draw the width of a box, m, and its height."""
    return round(stream.uniform(0.3, 1.5), 2), round(stream.uniform(0.6, 3), 2)


def sliding(stream: Random) -> tuple[float, ...]:
    """Draw an effective mass, kg, and a sliding either way, m/s."""
    speed = round(stream.uniform(0.5, 5), 2) * stream.choice((-1, 1))
    return round(stream.uniform(0.3, 4), 2), speed


def share(stream: Random) -> tuple[float, ...]:
    """Draw k = I/(m r^2)."""
    return (round(stream.uniform(0.1, 0.95), 2),)


def slope_and_share(stream: Random) -> tuple[float, ...]:
    """Draw a slope, rad, and k."""
    return round(stream.uniform(0.2, 0.9), 2), round(stream.uniform(0.1, 0.95), 2)


GAPS = (
    Gap("05-stopping", stopping_impulse, sliding,
        (pushes_along, divides_by_the_mass, turns_the_sliding_round)),
    Gap("05-rolling", rolling_part, share, (part_that_turns, takes_k_away, from_the_energy)),
    Gap("05-roll-down", friction_to_roll, slope_and_share,
        (as_for_a_box, the_other_share, sine_for_tangent)),
    Gap("05-tips", slope_to_tip, box_on_a_slope,
        (tall_boxes_stand_best, half_of_the_base, the_tangent_itself, in_degrees)),
)  # fmt: skip
