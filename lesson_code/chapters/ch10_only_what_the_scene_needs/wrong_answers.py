"""Wrong models of chapter 10: friction, plans, fastest ways, flights, and sleep.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

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


@wrong_model("10.3", "A heavy ball strikes a light one at rest. Which is faster after that?")
def fastest_now(masses: Vector, velocities: Vector, dt: float) -> float:
    """Nobody becomes faster than the fastest is now."""
    return float(np.hypot(*velocities.T).max() * dt)


@wrong_model("10.3", "E = m v^2 / 2. What is v?")
def half_forgotten(masses: Vector, velocities: Vector, dt: float) -> float:
    """The speed is the root of E/m."""
    energy = masses @ (velocities**2).sum(axis=1) / 2
    return float(np.sqrt(energy / min(masses)) * dt)


@wrong_model("10.3", "Must the energy be shared evenly for ever?")
def evenly_shared(masses: Vector, velocities: Vector, dt: float) -> float:
    """Each body has its share of the energy, and the lightest is fastest with it."""
    energy = masses @ (velocities**2).sum(axis=1)
    return float(np.sqrt(energy / len(masses) / min(masses)) * dt)


@wrong_model("10.3", "Who is faster with one joule: a heavy body or a light one?")
def heaviest_is_fastest(masses: Vector, velocities: Vector, dt: float) -> float:
    """The heaviest body may have all the energy."""
    return float(np.sqrt(masses @ (velocities**2).sum(axis=1) / max(masses)) * dt)


@wrong_model("10.3", "Two equal balls fly at each other. What is their momentum? And their energy?")
def from_the_momentum(masses: Vector, velocities: Vector, dt: float) -> float:
    """The lightest body may have all the momentum."""
    return float(np.hypot(*(masses @ velocities)) / min(masses) * dt)


@wrong_model("10.3", "A step lasts dt. How far does a body get in that time?")
def a_speed_is_no_way(masses: Vector, velocities: Vector, dt: float) -> float:
    """The bound is a speed."""
    return float(np.sqrt(masses @ (velocities**2).sum(axis=1) / min(masses)))


@wrong_model("10.4", "A ball is thrown up and caught again. How high was it in between?")
def only_the_ends(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """A flight lies between its start and its end."""
    end = position + velocity * duration + gravity * duration**2 / 2
    low, high = np.minimum(position, end) - radius, np.maximum(position, end) + radius
    return low[0], high[0], low[1], high[1]


@wrong_model("10.4", "Does all of the ball stay in your box, or only its centre?")
def of_the_centre(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """The box holds the centre's flight."""
    sides: list[Any] = []
    for x, v, g in zip(position, velocity, gravity, strict=True):
        times = [0, duration] + ([-v / g] if g and 0 < -v / g < duration else [])
        places = [x + v * t + g * t * t / 2 for t in times]
        sides += [min(places), max(places)]
    return sides


@wrong_model("10.4", "When does this ball turn back? Does the flight last so long?")
def turning_point_always(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """Every flight has its turning point."""
    sides: list[Any] = []
    for x, v, g in zip(position, velocity, gravity, strict=True):
        times = [0, duration] + ([-v / g] if g else [])
        places = [x + v * t + g * t * t / 2 for t in times]
        sides += [min(places) - radius, max(places) + radius]
    return sides


@wrong_model(
    "10.4", "How far does the ball get in the time that your box allows for, and is it there?"
)
def fast_either_way(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """It may get as far as speed and gravity together carry it, in both directions."""
    way = np.abs(velocity) * duration + np.abs(gravity) * duration**2 / 2 + radius
    low, high = position - way, position + way
    return low[0], high[0], low[1], high[1]


@wrong_model("10.4", "After the time t gravity has added g t to the velocity. And to the way?")
def gravity_without_the_half(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """Gravity adds g t^2 to the way."""
    sides: list[Any] = []
    for x, v, g in zip(position, velocity, gravity, strict=True):
        times = [0, duration] + ([-v / g / 2] if g and 0 < -v / g / 2 < duration else [])
        places = [x + v * t + g * t * t for t in times]
        sides += [min(places) - radius, max(places) + radius]
    return sides


@wrong_model("10.5", "A still body carries one that trembles. Will it stay still?")
def each_for_itself(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """What is still may sleep."""
    return [n for n in range(len(still)) if inverse_masses[n] > 0 and still[n]]


@wrong_model("10.5", "The neighbour of a neighbour moves. Does that reach the body?")
def only_neighbours(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """What is still and touches nothing that moves may sleep."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    awake = [n for n in free if not still[n]]
    return [n for n in free if still[n] and not any(touches[n][k] for k in awake)]


@wrong_model(
    "10.5", "Two piles stand on one floor. Does the floor carry a push from one to the other?"
)
def floors_join(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """Whatever hangs together by contacts is one island, the floor included."""
    count = len(still)
    awake = {n for n in range(count) if not still[n]}
    for _ in range(count):
        awake |= {n for n in range(count) if any(touches[n][k] for k in awake)}
    return [n for n in range(count) if inverse_masses[n] > 0 and n not in awake]


@wrong_model("10.5", "One body still flies. Must a pile far away stay awake for it?")
def all_or_none(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """The scene sleeps when everything in it is still."""
    return [n for n in range(len(still)) if inverse_masses[n] > 0] if all(still) else []


@wrong_model("10.5", "Is the floor in your answer? Can it be pushed?")
def floors_sleep(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """The floor sleeps too."""
    count = len(still)
    awake = {n for n in range(count) if not still[n]}
    for _ in range(count):
        near = {n for n in range(count) if any(touches[n][k] for k in awake)}
        awake |= {n for n in near if inverse_masses[n] > 0}
    return [n for n in range(count) if n not in awake]


@wrong_model("10.2", "A rough disc rolls down a slope. You cannot see it turn; does it?")
@edited(asks_effect_by_effect, {"w.any() or ": "", " or (m.any() and rubs)": ""})
def only_corners_turn() -> None:
    """Only a body with corners can be seen to turn, so a disc needs no rotation."""


@wrong_model("10.3", "With all the momenta, what energy would the lightest have? Is there so much?")
def all_the_momentum(masses: Any, velocities: Any, dt: float) -> float:
    """At worst the lightest body gets the momenta of all, added up by size."""
    m, v = np.asarray(masses, dtype=float), np.asarray(velocities, dtype=float)
    return float(m @ np.hypot(*v.T) / m.min() * dt)


@wrong_model("10.4", "A side wind blows. Can a flight turn back along x, too?")
def turns_back_in_y_only(
    position: Any, velocity: Any, radius: float, gravity: Any, duration: float
) -> tuple[float, ...]:
    """Gravity pulls down, so a flight turns back along y alone."""
    x, y = (
        [s + v * t + g * t * t / 2 for t in (0.0, duration)]
        for s, v, g in zip(position, velocity, gravity, strict=True)
    )
    top = -velocity[1] / gravity[1] if gravity[1] != 0 else 0.0
    if 0 < top < duration:
        y.append(position[1] + velocity[1] * top + gravity[1] * top * top / 2)
    return min(x) - radius, max(x) + radius, min(y) - radius, max(y) + radius


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


@wrong_model("10.3", "Can one disc ever get the speeds of all the others added to its own?")
def all_the_speeds(masses: Vector, velocities: Vector, dt: float) -> float:
    """At worst one disc gets the speeds of all, added up."""
    return float(np.sum(np.hypot(velocities[:, 0], velocities[:, 1])) * dt)


@wrong_model("10.3", "If one disc has all the energy, which mass does that energy move?")
def by_all_the_masses(masses: Vector, velocities: Vector, dt: float) -> float:
    """All the energy moves all the masses, at one speed."""
    twice_energy = np.sum(masses * np.sum(velocities**2, axis=1))
    return math.sqrt(twice_energy / np.sum(masses)) * dt
