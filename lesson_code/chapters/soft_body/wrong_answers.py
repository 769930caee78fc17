"""Wrong models of the soft body: area, springs, pressure, the fall."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.soft_body.rules import BLOB, pressure_forces, ring_area, ring_forces
from lesson_code.course.grading.task import WrongModel, marked, wrong_model

Vector: TypeAlias = Any

LEAST_LENGTH = 1e-12
"""m: keeps a wrong model from dividing by 0."""


def _next(values: Vector) -> Any:
    """Return for each mass what the next one has."""
    return np.roll(values, -1, axis=0)


@wrong_model("S.1", "Two triangles: which factor turns a cross product into an area?")
def twice_the_area(positions: Vector) -> Any:
    """The area is the sum of the cross products."""
    x, y = positions.T
    return np.sum(x * _next(y) - _next(x) * y)


@wrong_model("S.1", "Go round your ring the other way. What should the sign of the area tell?")
def always_positive(positions: Vector) -> Any:
    """An area has no sign."""
    return abs(ring_area(positions))


@wrong_model("S.1", "How many edges has a closed ring of N masses?")
def ring_left_open(positions: Vector) -> Any:
    """The last mass is not tied to the first."""
    x, y = positions.T
    return np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]) / 2


@wrong_model("S.1", "Squash your ring flat. Does the box around it tell its area?")
def bounding_box(positions: Vector) -> Any:
    """The area is that of the box around the ring."""
    return float(np.prod(positions.max(axis=0) - positions.min(axis=0)))


def _pulls(positions: Vector, pull: Vector) -> Any:
    """Return the forces of springs that pull each mass towards the next one."""
    return pull - np.roll(pull, 1, axis=0)


def _directions(positions: Vector) -> tuple[Any, Any]:
    """Return the distance from each mass to the next, and the unit vector."""
    along = _next(positions) - positions
    distance = np.maximum(np.hypot(along[:, 0], along[:, 1]), LEAST_LENGTH)
    return distance, along / distance[:, None]


@wrong_model(
    "S.2", "A spring that is stretched: does it pull its ends together or push them apart?"
)
def pushes_when_stretched(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """A stretched spring pushes its masses apart."""
    return -np.asarray(ring_forces(positions, velocities, length, stiffness, damping))


@wrong_model("S.2", "Does every force have its counterpart? Add up all forces of your springs.")
def one_end_only(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """A spring acts on one of its ends."""
    distance, u = _directions(positions)
    faster = np.sum((_next(velocities) - velocities) * u, axis=1)
    return (stiffness * (distance - length) + damping * faster)[:, None] * u


@wrong_model("S.2", "At which distance is your spring without force?")
def no_rest_length(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """The force of a spring is stiffness times distance."""
    return ring_forces(positions, velocities, 0.0, stiffness, damping)


@wrong_model("S.2", "The ring flies along as a whole. Should its springs brake it?")
def damps_all_motion(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """Damping brakes every velocity."""
    undamped = np.asarray(ring_forces(positions, velocities, length, stiffness, 0.0))
    return undamped - damping * velocities


@wrong_model("S.2", "Two masses come nearer to each other. Does damping help them or hinder them?")
def damping_that_drives(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """Damping acts in the direction of the motion."""
    return ring_forces(positions, velocities, length, stiffness, -damping)


@wrong_model("S.3", "The gas has less room than at rest. Where does it push the ring?")
def sucks(positions: Vector, area: float, stiffness: float) -> Any:
    """Pressure pulls inward."""
    return -np.asarray(pressure_forces(positions, area, stiffness))


@wrong_model("S.3", "An edge has two ends. How much of its force does each get?")
def whole_force_at_each_end(positions: Vector, area: float, stiffness: float) -> Any:
    """Both ends of an edge get its whole force."""
    return 2 * np.asarray(pressure_forces(positions, area, stiffness))


@wrong_model("S.3", "A long edge and a short one under the same pressure: is the force the same?")
def edges_alike(positions: Vector, area: float, stiffness: float) -> Any:
    """Every edge is pushed alike, however long it is."""
    pressure = stiffness * (area / ring_area(positions) - 1)
    _, u = _directions(positions)
    push = pressure * np.column_stack([u[:, 1], -u[:, 0]])
    return (push + np.roll(push, 1, axis=0)) / 2


@wrong_model("S.3", "The ring is at its area at rest. What is your pressure then?")
def pressure_at_rest(positions: Vector, area: float, stiffness: float) -> Any:
    """The pressure is stiffness times rest area over area."""
    pressure = stiffness * area / ring_area(positions)
    along = _next(positions) - positions
    push = pressure * np.column_stack([along[:, 1], -along[:, 0]])
    return (push + np.roll(push, 1, axis=0)) / 2


@wrong_model(
    "S.3", "Which way does the gas push: away from the middle, or at right angles to an edge?"
)
def away_from_the_middle(positions: Vector, area: float, stiffness: float) -> Any:
    """Pressure pushes every mass away from the middle."""
    pressure = stiffness * (area / ring_area(positions) - 1)
    away = positions - positions.mean(axis=0)
    distance = np.maximum(np.hypot(away[:, 0], away[:, 1]), LEAST_LENGTH)
    length, _ = _directions(positions)
    return (pressure * (length + np.roll(length, 1)) / 2 / distance)[:, None] * away


Floor: TypeAlias = Callable[[Any, Any], None]


def _falls(
    state: tuple[Any, Any],
    length: float,
    area: float,
    steps: float,
    floor: Floor,
    gas: float = BLOB.pressure,
    weight: float = BLOB.gravity,
) -> Any:
    """Return a ring after so many steps, with a floor, a gas and a weight of its own."""
    p, v = state[0].copy(), state[1].copy()
    for _ in range(int(steps)):
        forces = ring_forces(p, v, length, BLOB.stiffness, BLOB.damping)
        forces = forces + pressure_forces(p, area, gas)
        v = v + (forces / BLOB.mass - BLOB.air * v + np.array([0.0, -weight])) * BLOB.dt
        p = p + v * BLOB.dt
        floor(p, v)
    return p, v


def _right_floor(p: Vector, v: Vector) -> None:
    """Do what the floor of the task does."""
    below = p[:, 1] < 0
    p[below, 1] = 0.0
    v[below, 1] = np.maximum(v[below, 1], 0.0)
    v[below, 0] *= BLOB.grip


def _no_floor(p: Vector, v: Vector) -> None:
    """Do nothing."""


def _only_velocities(p: Vector, v: Vector) -> None:
    """Stop what is below the floor, but leave it there."""
    below = p[:, 1] < 0
    v[below, 1] = np.maximum(v[below, 1], 0.0)
    v[below, 0] *= BLOB.grip


@wrong_model("S.4", "Where is the lowest mass at the end? And where is the floor?")
def falls_through(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """The floor is only a picture."""
    return _falls((positions, velocities), length, area, steps, _no_floor)


@wrong_model("S.4", "A mass is below the floor and stands still. How does it come out again?")
def stays_below(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """Whoever stops is no longer below the floor."""
    return _falls((positions, velocities), length, area, steps, _only_velocities)


@wrong_model("S.4", "What keeps the area of your ring when it is squashed?")
def without_gas(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """Springs alone keep the shape."""
    return _falls((positions, velocities), length, area, steps, _right_floor, gas=0.0)


@wrong_model("S.4", "Which way is down, with y up?")
def falls_upwards(
    positions: Vector, velocities: Vector, length: float, area: float, steps: float
) -> Any:
    """Weight points towards larger y."""
    return _falls((positions, velocities), length, area, steps, _right_floor, weight=-BLOB.gravity)


WRONG_MODELS = marked(globals(), WrongModel)
