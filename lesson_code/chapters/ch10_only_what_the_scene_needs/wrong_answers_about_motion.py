"""Wrong models of chapter 10: the fastest way, and the box around a flight."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any
Table: TypeAlias = Any


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


@wrong_model("10.3", "Can one disc ever get the speeds of all the others added to its own?")
def all_the_speeds(masses: Vector, velocities: Vector, dt: float) -> float:
    """At worst one disc gets the speeds of all, added up."""
    return float(np.sum(np.hypot(velocities[:, 0], velocities[:, 1])) * dt)


@wrong_model("10.3", "If one disc has all the energy, which mass does that energy move?")
def by_all_the_masses(masses: Vector, velocities: Vector, dt: float) -> float:
    """All the energy moves all the masses, at one speed."""
    twice_energy = np.sum(masses * np.sum(velocities**2, axis=1))
    return math.sqrt(twice_energy / np.sum(masses)) * dt


@wrong_model("10.3", "Of which body do you take the mass: of one that there is?")
def with_the_mean_mass(masses: Vector, velocities: Vector, dt: float) -> float:
    """All the energy moves a body of the mean mass."""
    return math.sqrt(masses @ (velocities**2).sum(axis=1) / np.mean(masses)) * dt


@wrong_model("10.3", "Can the lightest one be hit by several others, one after the other?")
def energy_of_one_other(masses: Vector, velocities: Vector, dt: float) -> float:
    """The most that a body can get is the largest energy of one body."""
    return math.sqrt(max(masses * (velocities**2).sum(axis=1)) / min(masses)) * dt


@wrong_model("10.3", "The walls can take up momentum. Does their centre of mass go on for ever?")
def beside_the_centre_of_mass(masses: Vector, velocities: Vector, dt: float) -> float:
    """The centre of mass keeps its velocity, so only the energy beside it can be given away."""
    centre = masses @ velocities / sum(masses)
    energy = masses @ ((velocities - centre) ** 2).sum(axis=1)
    return float((np.hypot(*centre) + math.sqrt(energy / min(masses))) * dt)


@wrong_model("10.4", "Gravity is a vector. What does its x do to the flight?")
@edited(
    turns_back_in_y_only,
    {
        "zip(position, velocity, gravity": "zip(position, velocity, gravity * [0.0, 1.0]",
    },
)
def gravity_in_y_only() -> None:
    """Gravity pulls down, so along x the flight is even."""


@wrong_model("10.4", "You look at a hundred moments. Is the highest of them the turning point?")
def a_hundred_moments(
    position: Vector, velocity: Vector, radius: float, gravity: Vector, duration: float
) -> Any:
    """Whoever looks a hundred times sees how far a flight gets."""
    t = np.linspace(0, duration, 101)[:, None]
    places = position + velocity * t + gravity * t**2 / 2
    low, high = places.min(axis=0) - radius, places.max(axis=0) + radius
    return low[0], high[0], low[1], high[1]


@wrong_model("10.3", "A heavy ball throws a light one at 2 v. How fast is what that one throws?")
def twice_the_fastest(masses: Any, velocities: Any, dt: float) -> float:
    """No body can get faster than twice the fastest one."""
    return 2 * float(np.linalg.norm(velocities, axis=1).max()) * dt
