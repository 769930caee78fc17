"""Wrong models of chapter 04: two circles that touch, found, resolved and separated."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch04_circles.right_answers import (
    first_places_then_velocities,
    seen_from_the_centre_of_mass,
)
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


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
@edited(seen_from_the_centre_of_mass, {"v1 - (1": "v1 - 2 * (1", "v2 - (1": "v2 - 2 * (1"})
def doubled_impulse() -> None:
    """The 2 of the elastic impulse is kept, and 1 + e multiplies it."""


@wrong_model("4.2", "These circles already move apart. What does your impulse do to them?")
@edited(seen_from_the_centre_of_mass, {"if np.dot(v1 - v2, normal) <= 0": "if False"})
def without_gate() -> None:
    """Circles in contact always bounce, whichever way they move."""


@wrong_model(
    "4.2", "The normal points from 1 to 2. If 2 moves along it faster than 1, do they approach?"
)
@edited(seen_from_the_centre_of_mass, {"<= 0": ">= 0"})
def gate_inverted() -> None:
    """Circles approach when (v2 - v1) . n is positive."""


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


@wrong_model("4.2", "Circle 2 pushes back. What does circle 1 do in your hit?")
def circle_1_is_a_wall(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """Circle 2 bounces off circle 1, which goes on as before."""
    vn = np.dot(v2 - v1, normal)
    return v1, v2 if vn >= 0 else v2 - (1 + restitution) * vn * normal


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
@edited(
    first_places_then_velocities,
    {"- w1 / (w1 + w2) * depth * normal": "", "+ w2 / (w1 + w2) * depth * normal": ""},
)
def velocities_alone() -> None:
    """Once the velocities are right, the positions take care of themselves."""


@wrong_model("4.4", "The circles overlap, but they already part. What does your impulse do then?")
@edited(first_places_then_velocities, {"(v2 - v1) @ normal < 0": "True"})
def bounces_when_separating() -> None:
    """Whatever overlaps is bounced, whichever way it moves."""


@wrong_model("4.4", "The velocities know of the masses. Do the positions in yours?")
@edited(
    first_places_then_velocities,
    {"w1 / (w1 + w2) * depth": "depth / 2", "w2 / (w1 + w2) * depth": "depth / 2"},
)
def half_each_and_bounced() -> None:
    """Masses matter for velocities; of the way apart each circle takes half."""


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


@wrong_model("4.4", "By which mass is the change of the velocity of circle 2 divided in yours?")
@edited(first_places_then_velocities, {"* w2 * normal,": "* w1 * normal,"})
def one_mass_for_both() -> None:
    """The same impulse gives both circles the same change of velocity."""


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


@wrong_model("4.2", "A light circle hits a heavy one: is the momentum kept in yours?")
@edited(
    seen_from_the_centre_of_mass,
    {
        "v1 - centre": "(v1 - restitution * v2) / (1 + restitution)",
        "v2 - centre": "(v2 - restitution * v1) / (1 + restitution)",
    },
)
def exchanged_and_slowed() -> None:
    """The circles exchange their velocities along the normal, and e is left of them."""


@wrong_model("4.2", "Circle 2 stands still. Along which direction alone can it be pushed?")
def whole_velocities_exchanged(
    v1: Vector, m1: float, v2: Vector, m2: float, normal: Vector, restitution: float
) -> Any:
    """In a hit the circles exchange their velocities, as they are."""
    return (v2, v1) if np.dot(v1 - v2, normal) > 0 else (v1, v2)


@wrong_model("4.2", "With e = 0: do the circles go on together along the normal, or stop?")
@edited(
    seen_from_the_centre_of_mass,
    {
        "v1 - centre": "v1 - 2 * restitution / (1 + restitution) * centre",
        "v2 - centre": "v2 - 2 * restitution / (1 + restitution) * centre",
    },
)
def elastic_then_scaled_along() -> None:
    """Along the normal the velocities are e times those of an elastic hit."""


@wrong_model(
    "4.2", "Two circles meet at 5 cm/s. Is that no hit, and at which speed does one begin?"
)
@edited(seen_from_the_centre_of_mass, {"<= 0": "<= 0.1"})
def too_slow_to_count() -> None:
    """Circles that approach slowly are as good as at rest against each other."""


@wrong_model("4.2", "Two circles meet at 5 cm/s. What is their restitution then?")
@edited(
    seen_from_the_centre_of_mass,
    {"    centre =": "    restitution *= np.dot(v1 - v2, normal) > 0.1\n    centre ="},
)
def too_slow_to_bounce() -> None:
    """Circles that meet slowly go on together: a slow hit is inelastic."""


@wrong_model("4.2", "One car runs into the back of another. Is that no hit?")
@edited(
    seen_from_the_centre_of_mass,
    {
        "np.dot(v1 - v2, normal) <= 0": (
            "np.dot(v1, normal) <= max(0, np.dot(v2, normal)) or np.dot(v2, normal) >= 0"
        )
    },
)
def towards_each_other() -> None:
    """There is a hit only if each circle moves towards the other."""


@wrong_model("4.2", "The circles already part. What makes them part more slowly in yours?")
@edited(
    seen_from_the_centre_of_mass,
    {
        "if np.dot(v1 - v2, normal) <= 0": "if False",
        "    return v1 - (1": (
            "    restitution *= np.sign(np.dot(v1 - v2, normal))\n    return v1 - (1"
        ),
    },
)
def slows_what_parts() -> None:
    """Whichever way the circles move, they part with e times that speed."""


@wrong_model("4.4", "How far does a circle go along the wall while you turn back the time?")
@edited(
    first_places_then_velocities,
    {
        "    p1 = p1 - w1": (
            "    if (v1 - v2) @ normal > 0:\n"
            "        time = depth / ((v1 - v2) @ normal)\n"
            "        p1, p2, depth = p1 - time * v1, p2 - time * v2, 0.0\n"
            "    p1 = p1 - w1"
        )
    },
)
def back_in_time() -> None:
    """The circles go back along their ways, to where they were when they first touched."""
