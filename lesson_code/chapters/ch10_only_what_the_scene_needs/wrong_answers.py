"""Wrong models of chapter 10: friction, and plans.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

from lesson_code.chapters.ch10_only_what_the_scene_needs.right_answers import asks_effect_by_effect
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any
Table: TypeAlias = Any


@wrong_model("10.1", "One body is rough and all others are smooth. Which pair rubs?")
def roughest_body(inverse_masses: Vector, frictions: Vector) -> float:
    """Friction is called for as soon as one body is rough."""
    return float(max(frictions))


@wrong_model("10.1", "Two floors overlap. Does anything come of it?")
def static_pairs_count(inverse_masses: Vector, frictions: Vector) -> float:
    """All pairs count, those of two static bodies too."""
    count = len(frictions)
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count)]
    return max((math.sqrt(frictions[a] * frictions[b]) for a, b in pairs), default=0.0)


@wrong_model("10.1", "A rough ball on a rough floor: is the floor in one of your pairs?")
def floors_forgotten(inverse_masses: Vector, frictions: Vector) -> float:
    """Only bodies that can be pushed are looked at."""
    free = [n for n in range(len(frictions)) if inverse_masses[n] > 0]
    pairs = [(a, b) for a in free for b in free if a < b]
    return max((math.sqrt(frictions[a] * frictions[b]) for a, b in pairs), default=0.0)


@wrong_model("10.1", "A body of 0.5 meets a smooth one of 0. What does your rule make of that?")
def mean_of_both(inverse_masses: Vector, frictions: Vector) -> float:
    """A pair's coefficient is the mean of the two."""
    count = len(frictions)
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count)]
    some = [(a, b) for a, b in pairs if inverse_masses[a] > 0 or inverse_masses[b] > 0]
    return max(((frictions[a] + frictions[b]) / 2 for a, b in some), default=0.0)


@wrong_model("10.1", "The smaller of both is the rule for e. Which one is it for mu?")
def smaller_of_both(inverse_masses: Vector, frictions: Vector) -> float:
    """A pair's coefficient is the smaller of the two."""
    count = len(frictions)
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count)]
    some = [(a, b) for a, b in pairs if inverse_masses[a] > 0 or inverse_masses[b] > 0]
    return max((min(frictions[a], frictions[b]) for a, b in some), default=0.0)


@wrong_model("10.1", "One pair rubs, and no other does. Is friction called for?")
def smoothest_pair(inverse_masses: Vector, frictions: Vector) -> float:
    """The pair that rubs least decides."""
    count = len(frictions)
    pairs = [(a, b) for a in range(count) for b in range(a + 1, count)]
    some = [(a, b) for a, b in pairs if inverse_masses[a] > 0 or inverse_masses[b] > 0]
    return min((math.sqrt(frictions[a] * frictions[b]) for a, b in some), default=0.0)


@wrong_model("10.1", "Your pairs: can a body meet itself?")
def pairs_with_itself(inverse_masses: Vector, frictions: Vector) -> float:
    """Each body makes a pair with every body, itself included."""
    count = len(frictions)
    pairs = [(a, b) for a in range(count) for b in range(count)]
    some = [(a, b) for a, b in pairs if inverse_masses[a] > 0 or inverse_masses[b] > 0]
    return max((math.sqrt(frictions[a] * frictions[b]) for a, b in some), default=0.0)


@wrong_model("10.2", "A ball slides over a rough floor. Does it ever begin to turn?")
@edited(asks_effect_by_effect, {" or (m.any() and rubs)": ""})
def discs_never_turn() -> None:
    """Rotation is for bodies with corners, and for those that turn from the start."""


@wrong_model("10.2", "A box at rest is hit at one end. Does it turn?")
@edited(asks_effect_by_effect, {" or corners[m > 0].any() or (m.any() and rubs)": ""})
def only_what_turns_already() -> None:
    """Rotation is called for if a body turns at the start."""


@wrong_model("10.2", "The floor has corners. Can anything turn it?")
@edited(
    asks_effect_by_effect, {"corners[m > 0].any() or (m.any() and rubs)": "corners.any() or rubs"}
)
def floors_turn() -> None:
    """Whatever has corners can be turned."""


@wrong_model("10.2", "A ball with e = 0.8 meets one with e = 0. Which e has the pair?")
@edited(asks_effect_by_effect, {"any(e[a] * e[b] > 0 for a, b in pairs)": "e.any()"})
def bounces_alone() -> None:
    """One body that bounces is enough for restitution."""


@wrong_model("10.2", "A smooth box falls on its corner. What does it do then?")
@edited(asks_effect_by_effect, {"corners[m > 0].any()": "False"})
def corners_never_turn() -> None:
    """Without friction nothing begins to turn."""


@wrong_model("10.2", "A rough ball on smooth ice: what does the pair do?")
@edited(asks_effect_by_effect, {"any(mu[a] * mu[b] > 0 for a, b in pairs)": "mu.any()"})
def rubs_alone() -> None:
    """One rough body is enough for friction."""


@wrong_model("10.2", "Gravity is a vector. Which of its parts have you asked?")
@edited(asks_effect_by_effect, {"any(gravity)": "gravity[1] != 0"})
def gravity_is_down() -> None:
    """Gravity pulls down, so its y decides."""


@wrong_model("10.2", "A rough disc rolls down a slope. You cannot see it turn; does it?")
@edited(asks_effect_by_effect, {"w.any() or ": "", " or (m.any() and rubs)": ""})
def only_corners_turn() -> None:
    """Only a body with corners can be seen to turn, so a disc needs no rotation."""


@wrong_model("10.2", "A rough disc on ice: does one rough body make friction?")
@edited(
    asks_effect_by_effect,
    {
        "any(mu[a] * mu[b] > 0 for a, b in pairs)": "mu.any()",
        "any(e[a] * e[b] > 0 for a, b in pairs)": "e.any()",
    },
)
def each_body_by_itself() -> None:
    """One rough body calls for friction, and one that bounces for restitution."""


@wrong_model("10.1", "Two balls roll over smooth ice, and meet. Is there a pair without a floor?")
def only_pairs_with_a_floor(inverse_masses: Vector, frictions: Vector) -> float:
    """Friction acts between a body and what is static."""
    free = [mu for m, mu in zip(inverse_masses, frictions, strict=True) if m > 0]
    fixed = [mu for m, mu in zip(inverse_masses, frictions, strict=True) if m == 0]
    return max((math.sqrt(f * g) for f in free for g in fixed), default=0.0)


@wrong_model("10.1", "Can the first body of the list meet the last one?")
def neighbours_in_the_list(inverse_masses: Vector, frictions: Vector) -> float:
    """A body meets the next one in the list."""
    pairs = [(n, n + 1) for n in range(len(frictions) - 1)]
    some = [(a, b) for a, b in pairs if inverse_masses[a] > 0 or inverse_masses[b] > 0]
    return max((math.sqrt(frictions[a] * frictions[b]) for a, b in some), default=0.0)


@wrong_model("10.2", "A disc turns clockwise. Which sign has its angular velocity?")
@edited(asks_effect_by_effect, {"w.any()": "(w > 0).any()"})
def spins_one_way_only() -> None:
    """A body turns if its angular velocity is greater than 0."""


@wrong_model("10.2", "A smooth wheel turns on a fixed axle. What did the task say of such bodies?")
@edited(asks_effect_by_effect, {"w.any()": "w[m > 0].any()"})
def static_bodies_never_spin() -> None:
    """A static body cannot turn, so its angular velocity does not count."""


@wrong_model("10.2", "The floor and the wall overlap. Do they rub, or bounce off each other?")
@edited(asks_effect_by_effect, {" if m[a] + m[b] > 0]": "]"})
def all_pairs_meet() -> None:
    """Any two bodies may meet, static ones too."""


@wrong_model("10.2", "With e = 1 a ball comes back as fast as it came. Is that no bounce?")
@edited(asks_effect_by_effect, {"any(e[a] * e[b] > 0 for": "any(0 < min(e[a], e[b]) < 1 for"})
def elastic_needs_no_restitution() -> None:
    """Restitution is called for where an impact costs energy."""


@wrong_model("10.2", "Two rough discs meet in space, where nothing has a weight. Do they rub?")
@edited(asks_effect_by_effect, {"rubs = any(": "rubs = any(gravity) and any("})
def no_friction_without_weight() -> None:
    """What has no weight does not press, so nothing rubs it."""


@wrong_model("10.2", "A ball rolls against the end of a plank. Has the ball a corner, too?")
@edited(
    asks_effect_by_effect,
    {"corners[m > 0].any()": "any(corners[a] * corners[b] > 0 for a, b in pairs)"},
)
def corners_against_corners() -> None:
    """A body is turned where both bodies of a pair have corners."""


@wrong_model("10.2", "A smooth disc spins from the start. What would a scene without turning show?")
@edited(asks_effect_by_effect, {"w.any() or ": ""})
def spin_forgotten() -> None:
    """Rotation is for what a push can begin to turn."""


@wrong_model("10.2", "A ball falls on the floor. Is that a pair in which something happens?")
@edited(asks_effect_by_effect, {" if m[a] + m[b] > 0]": " if m[a] > 0 and m[b] > 0]"})
def floors_meet_nobody() -> None:
    """Only bodies that can be pushed make a pair."""
