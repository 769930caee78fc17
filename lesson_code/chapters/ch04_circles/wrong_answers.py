"""Wrong models of chapter 04: two circles that touch, found, resolved and separated."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch04_circles.right_answers import (
    first_places_then_velocities,
    from_2_to_1_and_turned,
    seen_from_the_centre_of_mass,
)
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("4.1", "Circle 1 pushes circle 2 along the normal. Which way does yours push it?")
def normal_from_2_to_1(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The normal points from circle 2 to circle 1."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    normal = (p1 - p2) / distance if distance > 0 else np.array([-1.0, 0.0])
    return normal, r1 + r2 - distance


@wrong_model("4.1", "How long is your normal when the centres are 3 m apart?")
def not_normalised(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The normal is the way from one centre to the other."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    return p2 - p1 if distance > 0 else np.array([1.0, 0.0]), r1 + r2 - distance


@wrong_model("4.1", "Two circles overlap by 0.2 m. Is your depth +0.2 or -0.2?")
def gap_as_depth(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The depth is the distance of the rims: negative while the circles overlap."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, distance - (r1 + r2)


@wrong_model("4.1", "Put a coin into each corner of a box. Do coins touch whenever their boxes do?")
def boxes_for_circles(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles overlap if they do so along x and along y."""
    if np.any(np.abs(p2 - p1) >= r1 + r2):
        return None
    distance = np.hypot(*(p2 - p1))
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, r1 + r2 - distance


@wrong_model("4.1", "Two circles touch at a slant. Which way does each push the other there?")
def out_along_an_axis(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles are moved apart as their boxes are: along x or y, whichever is shorter."""
    way, reach = p2 - p1, r1 + r2
    if np.hypot(*way) >= reach:
        return None
    axis = int(np.argmax(np.abs(way)))
    normal = np.zeros(2)
    normal[axis] = 1.0 if way[axis] >= 0 else -1.0
    return normal, reach - abs(way[axis])


@wrong_model("4.1", "You squared the distance. What else has to be squared in the comparison?")
def only_one_side_squared(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles overlap if the squared distance is less than the sum of the radii."""
    squared = np.dot(p2 - p1, p2 - p1)
    if squared >= r1 + r2:
        return None
    distance = np.sqrt(squared)
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, r1 + r2 - distance


@wrong_model("4.1", "Two circles just touch. How deep do they overlap, and is that an overlap?")
def touching_counts(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles that touch in a point are in contact already, with depth 0."""
    distance = np.hypot(*(p2 - p1))
    if distance > r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, r1 + r2 - distance


@wrong_model("4.1", "Two circles lie on the same centre. How deep do they overlap?")
def same_centre_is_no_contact(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Without a direction between the centres there is no contact."""
    distance = np.hypot(*(p2 - p1))
    if distance == 0 or distance >= r1 + r2:
        return None
    return (p2 - p1) / distance, r1 + r2 - distance


@wrong_model("4.2", "Roll a ball past another so that they barely graze. Does it turn round?")
def one_dimension_on_each_axis(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The formula of one dimension serves for x and for y, each for itself."""
    if np.dot(v2 - v1, normal) >= 0:
        return v1, v2
    impulse = (1 + restitution) * (v1 - v2) / (1 / m1 + 1 / m2)
    return v1 - impulse / m1, v2 + impulse / m2


@wrong_model("4.2", "Momentum is kept. What about the energy, with e = 1?")
def doubled_impulse(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The 2 of the elastic impulse is kept, and 1 + e multiplies it."""
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = -2 * (1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - impulse / m1 * normal, v2 + impulse / m2 * normal


@wrong_model("4.2", "These circles already move apart. What does your impulse do to them?")
def without_gate(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Circles in contact always bounce, whichever way they move."""
    impulse = -(1 + restitution) * np.dot(v2 - v1, normal) / (1 / m1 + 1 / m2)
    return v1 - impulse / m1 * normal, v2 + impulse / m2 * normal


@wrong_model(
    "4.2", "The normal points from 1 to 2. If 2 moves along it faster than 1, do they approach?"
)
def gate_inverted(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Circles approach when (v2 - v1) . n is positive."""
    vn = max(0.0, np.dot(v2 - v1, normal))
    impulse = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - impulse / m1 * normal, v2 + impulse / m2 * normal


@wrong_model("4.2", "Only equal masses exchange their velocities. Where did m1 and m2 go?")
def exchanges_normal_parts(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """In a hit the circles exchange their velocities along the normal."""
    vn = min(0.0, np.dot(v2 - v1, normal))
    return v1 + vn * normal, v2 - vn * normal


@wrong_model(
    "4.2", "Two circles graze each other, very fast. How fast does the gap between them close?"
)
def speed_for_approach(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The approach is the speed of one as seen from the other."""
    if np.dot(v2 - v1, normal) >= 0:
        return v1, v2
    impulse = (1 + restitution) * np.hypot(*(v2 - v1)) * m1 * m2 / (m1 + m2)
    return v1 - impulse / m1 * normal, v2 + impulse / m2 * normal


@wrong_model("4.2", "Both circles change by the same amount. Should a truck change like a fly?")
def masses_ignored(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Each circle takes half of the change of the relative velocity."""
    vn = min(0.0, np.dot(v2 - v1, normal))
    return v1 + (1 + restitution) / 2 * vn * normal, v2 - (1 + restitution) / 2 * vn * normal


@wrong_model("4.2", "The impulse is the same for both. Which circle should change more by it?")
def masses_exchanged(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The heavier circle gets more out of the hit."""
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - impulse / m2 * normal, v2 + impulse / m1 * normal


@wrong_model("4.2", "How large is the impulse on each circle? Is one the opposite of the other?")
def impulses_by_the_other_mass(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The heavier the other circle is, the larger an impulse it gives."""
    approach = (1 + restitution) * np.dot(v1 - v2, normal)
    if approach <= 0:
        return v1, v2
    return v1 - m2 / m1 * approach * normal, v2 + m1 / m2 * approach * normal


@wrong_model("4.2", "An impulse has the unit kg m/s. What do you get when you multiply it by kg?")
def multiplies_by_the_mass(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The change of velocity is the impulse times the mass."""
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - impulse * m1 * normal, v2 + impulse * m2 * normal


@wrong_model("4.2", "Smooth circles push along the normal. What slows the tangent part in yours?")
def scales_the_tangent(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Restitution scales the velocities that an elastic hit would give."""
    vn = np.dot(v2 - v1, normal)
    if vn >= 0:
        return v1, v2
    impulse = -2 * vn / (1 / m1 + 1 / m2)
    return restitution * (v1 - impulse / m1 * normal), restitution * (v2 + impulse / m2 * normal)


@wrong_model("4.3", "A marble overlaps a bowling ball. Should the ball move as far as the marble?")
def half_each(p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float) -> Any:
    """Both circles move by half of the depth."""
    return p1 - depth / 2 * normal, p2 + depth / 2 * normal


@wrong_model("4.3", "Only one circle moves in yours. Who decides which one is number 1?")
def only_the_first_moves(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """The first circle has run into the second, and has to go back all the way."""
    return p1 - depth * normal, p2


@wrong_model("4.3", "One circle is a little lighter than the other. Should it go all of the way?")
def only_the_lighter_moves(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """The lighter circle makes room, and the heavier stays."""
    if m1 < m2:
        return p1 - depth * normal, p2
    return p1, p2 + depth * normal


@wrong_model("4.3", "In yours the heavier circle moves further. Which is easier to push aside?")
def in_proportion_to_mass(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """The heavier circle moves further: the ways are in the ratio of the masses."""
    w1, w2 = 1 / m1, 1 / m2
    return p1 - depth * w2 / (w1 + w2) * normal, p2 + depth * w1 / (w1 + w2) * normal


@wrong_model("4.3", "The normal points from 1 to 2. Are your circles further apart afterwards?")
def pushes_deeper(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """Circle 1 moves along the normal and circle 2 against it."""
    w1, w2 = 1 / m1, 1 / m2
    return p1 + depth * w1 / (w1 + w2) * normal, p2 - depth * w2 / (w1 + w2) * normal


@wrong_model("4.3", "Add up your two ways. How far did the circles overlap?")
def the_whole_depth_each(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """Each circle that can move is moved by the whole depth."""
    way_1, way_2 = (0.0 if np.isinf(m) else depth for m in (m1, m2))
    return p1 - way_1 * normal, p2 + way_2 * normal


@wrong_model("4.3", "Make both masses ten times as large. Should the ways apart become shorter?")
def depth_over_mass(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """As with an impulse, each way is the depth divided by the mass."""
    return p1 - depth / m1 * normal, p2 + depth / m2 * normal


@wrong_model("4.4", "The circles part, but they still overlap. Who moves them out of each other?")
def returns_before_separating(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Circles that are already separating need nothing at all."""
    vn = np.dot(v2 - v1, normal)
    if vn >= 0:
        return p1, v1, p2, v2
    w1, w2 = 1 / m1, 1 / m2
    way = depth / (w1 + w2) * normal
    impulse = -(1 + restitution) * vn / (w1 + w2) * normal
    return p1 - w1 * way, v1 - w1 * impulse, p2 + w2 * way, v2 + w2 * impulse


@wrong_model("4.4", "Where are the circles after your call: still inside each other?")
def velocities_alone(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Once the velocities are right, the positions take care of themselves."""
    w1, w2 = 1 / m1, 1 / m2
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = -(1 + restitution) * vn / (w1 + w2) * normal
    return p1, v1 - w1 * impulse, p2, v2 + w2 * impulse


@wrong_model("4.4", "The circles overlap, but they already part. What does your impulse do then?")
def bounces_when_separating(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Whatever overlaps is bounced, whichever way it moves."""
    w1, w2 = 1 / m1, 1 / m2
    way = depth / (w1 + w2) * normal
    impulse = -(1 + restitution) * np.dot(v2 - v1, normal) / (w1 + w2) * normal
    return p1 - w1 * way, v1 - w1 * impulse, p2 + w2 * way, v2 + w2 * impulse


@wrong_model("4.4", "The velocities know of the masses. Do the positions in yours?")
def half_each_and_bounced(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """Masses matter for velocities; of the way apart each circle takes half."""
    w1, w2 = 1 / m1, 1 / m2
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = -(1 + restitution) * vn / (w1 + w2) * normal
    return p1 - depth / 2 * normal, v1 - w1 * impulse, p2 + depth / 2 * normal, v2 + w2 * impulse


@wrong_model("4.4", "Compare the energy before and after. Where does the extra speed come from?")
def pushed_apart_by_velocity(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """The depth goes into the velocities, which then carry the circles apart."""
    w1, w2 = 1 / m1, 1 / m2
    vn = min(0.0, np.dot(v2 - v1, normal))
    impulse = (depth - (1 + restitution) * vn) / (w1 + w2) * normal
    return p1, v1 - w1 * impulse, p2, v2 + w2 * impulse


@wrong_model("4.1", "Two circles of 1 m almost touch. How deep is the overlap by your formula?")
def root_of_the_squares(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The depth is the root of the difference of the squares, as in a right triangle."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, np.sqrt((r1 + r2) ** 2 - distance**2)


@wrong_model("4.4", "By which mass is the change of the velocity of circle 2 divided in yours?")
def one_mass_for_both(
    p1: Vector, v1: Vector, m1: float, p2: Vector, v2: Vector, m2: float,
    normal: Vector, depth: float, restitution: float,
) -> Any:  # fmt: skip
    """The same impulse gives both circles the same change of velocity."""
    w1, w2 = 1 / m1, 1 / m2
    p1_after = p1 - depth * w1 / (w1 + w2) * normal
    p2_after = p2 + depth * w2 / (w1 + w2) * normal
    approach = max((v1 - v2) @ normal, 0.0)
    change = (1 + restitution) * approach / (w1 + w2) * w1 * normal
    return p1_after, v1 - change, p2_after, v2 + change


@wrong_model("4.3", "Add up how far both circles move. Is it the depth?")
def the_lighter_all_and_more(
    p1: Vector, m1: float, p2: Vector, m2: float, normal: Vector, depth: float
) -> Any:
    """The lighter circle moves by the depth, and the heavier one by its part of that."""
    one = depth * min(1.0, m2 / m1 if m1 < np.inf else 0.0)
    other = depth * min(1.0, m1 / m2 if m2 < np.inf else 0.0)
    return p1 - one * normal, p2 + other * normal


@wrong_model(
    "4.4", "You have turned the normal round for circle 1. Which way does it point after it?"
)
@edited(
    first_places_then_velocities,
    {"    p1 = p1 - w1": "    normal = -normal\n    p1 = p1 + w1"},
)
def turned_and_not_turned_back() -> None:
    """The normal is turned round to push circle 1 back, and stays so for circle 2."""


@wrong_model("4.2", "You have turned into the frame of the normal. Do you turn back?")
def left_in_the_frame_of_the_normal(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """The parts along the normal and across it are the new velocities."""
    a, b = v1 @ normal, v2 @ normal
    if a <= b:
        return v1, v2
    along = np.array([-normal[1], normal[0]])
    centre = (m1 * a + m2 * b) / (m1 + m2)
    ends = [centre - restitution * (part - centre) for part in (a, b)]
    return [ends[0], v1 @ along], [ends[1], v2 @ along]


@wrong_model("4.1", "Two circles overlap deeply. How long is the way between their centres then?")
@edited(
    from_2_to_1_and_turned,
    {"return (-x / distance, -y / distance)": "return (-x / (r1 + r2), -y / (r1 + r2))"},
)
def divided_by_the_reach() -> None:
    """The centres of circles in contact are r1 + r2 apart, so that makes the normal a unit."""


@wrong_model("4.2", "Circle 1 stands still, and circle 2 runs into it. Does nothing happen?")
@edited(
    seen_from_the_centre_of_mass,
    {"np.dot(v1 - v2, normal) <= 0": "min(np.dot(v1, normal), np.dot(v1 - v2, normal)) <= 0"},
)
def circle_1_has_to_come() -> None:
    """There is a hit only if circle 1 itself moves towards circle 2."""


@wrong_model("4.4", "Throw a ball at a slant against a pillar. Does it come back into your hand?")
@edited(
    first_places_then_velocities,
    {
        "    if (v2": (
            "    if (v2 - v1) @ normal < 0 and w1 * w2 == 0:\n"
            "        v1, v2 = -restitution * v1, -restitution * v2\n"
            "    elif (v2"
        )
    },
)
def straight_back_from_a_fixed_one() -> None:
    """A circle that hits a fixed one goes back the way it came."""
