"""Wrong models of the soft body: area, springs, pressure, the fall."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.soft_body.right_answers import force_by_force
from lesson_code.chapters.soft_body.rules import pressure_forces, ring_area, ring_forces
from lesson_code.course.grading.task import edited, wrong_model

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


@wrong_model("S.2", "The ring turns as a whole. Does any of its springs get longer by that?")
def damps_across_the_springs(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """Damping acts on the whole of the velocity between two masses."""
    undamped = np.asarray(ring_forces(positions, velocities, length, stiffness, 0.0))
    braked = damping * (_next(velocities) - velocities)
    return undamped + braked - np.roll(braked, 1, axis=0)


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


@wrong_model("S.4", "Which velocity moves a mass in the task's second step: v, or v'?")
@edited(
    force_by_force,
    {
        "        p = p + v * BLOB.dt\n": "",
        "        v = v + (forces": "        p = p + v * BLOB.dt\n        v = v + (forces",
    },
)
def moves_by_the_old_velocity() -> None:
    """A mass moves by the velocity that it had at the beginning of the step."""


@wrong_model("S.4", "Where is the lowest mass at the end? And where is the floor?")
@edited(force_by_force, {"p[:, 1] < 0": "p[:, 1] < -np.inf"})
def falls_through() -> None:
    """The floor is only a picture."""


@wrong_model("S.4", "Why does a real ball lie still after a while?")
@edited(force_by_force, {"BLOB.air * v": "0.0 * v"})
def without_air() -> None:
    """The air does not matter."""


@wrong_model("S.4", "A mass is below the floor and stands still. How does it come out again?")
@edited(force_by_force, {"p[below, 1] = 0.0": "pass"})
def stays_below() -> None:
    """Whoever stops is no longer below the floor."""


@wrong_model("S.4", "What keeps the area of your ring when it is squashed?")
@edited(force_by_force, {"BLOB.pressure": "0.0"})
def without_gas() -> None:
    """Springs alone keep the shape."""


@wrong_model("S.4", "Which way is down, with y up?")
@edited(force_by_force, {"-BLOB.gravity": "BLOB.gravity"})
def falls_upwards() -> None:
    """Weight points towards larger y."""


@wrong_model("S.2", "How many springs has a ring of N masses? Which mass is tied to the first?")
def springs_left_open(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """The last mass is tied to nobody."""
    distance, u = _directions(positions)
    faster = np.sum((_next(velocities) - velocities) * u, axis=1)
    pull = (stiffness * (distance - length) + damping * faster)[:, None] * u
    pull[-1] = 0.0
    return pull - np.roll(pull, 1, axis=0)


@wrong_model(
    "S.2", "Two masses come nearer. Which way does your damper act: is it ever turned round?"
)
def damps_the_speed(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """A damper pulls in proportion to the speed between its ends, whichever way that is."""
    distance, u = _directions(positions)
    speed = np.hypot(*(_next(velocities) - velocities).T)
    pull = (stiffness * (distance - length) + damping * speed)[:, None] * u
    return pull - np.roll(pull, 1, axis=0)


@wrong_model(
    "S.3", "Which way does the gas push an edge: away from the middle, or at right angles?"
)
def edges_away_from_the_middle(positions: Vector, area: float, stiffness: float) -> Any:
    """Pressure pushes every edge away from the middle."""
    away = (positions + _next(positions)) / 2 - positions.mean(axis=0)
    length, _ = _directions(positions)
    pressure = stiffness * (area / ring_area(positions) - 1)
    far = np.maximum(np.hypot(*away.T), LEAST_LENGTH)
    half = (pressure * length / far / 2)[:, None] * away
    return half + np.roll(half, 1, axis=0)


@wrong_model("S.4", "You divide all forces by the mass. Was g a force?")
@edited(force_by_force, {"-BLOB.gravity": "-BLOB.gravity / BLOB.mass"})
def gravity_over_the_mass() -> None:
    """Gravity is added to the forces as it is given."""


@wrong_model("S.3", "A ring is flat on one side. Which way does the gas push its masses there?")
def by_the_chord_from_the_middle(positions: Vector, area: float, stiffness: float) -> Any:
    """Pressure pushes each mass away from the middle, by half the way between its neighbours."""
    pressure = stiffness * (area / ring_area(positions) - 1)
    chord = np.roll(positions, -1, axis=0) - np.roll(positions, 1, axis=0)
    away = positions - positions.mean(axis=0)
    far = np.maximum(np.hypot(*away.T), LEAST_LENGTH)
    return (pressure / 2 * np.hypot(*chord.T) / far)[:, None] * away


@wrong_model("S.4", "The first mass has moved already. Which ring do the others feel in yours?")
@edited(
    force_by_force,
    {
        "        forces = ring_forces": (
            "        for k in range(len(p)):\n         forces = ring_forces"
        ),
        "        forces = forces": "         forces = forces",
        "        v = v + (forces / BLOB.mass - BLOB.air * v +": (
            "         v[k] = v[k] + (forces[k] / BLOB.mass - BLOB.air * v[k] +"
        ),
        "        p = p + v * BLOB.dt": "         p[k] = p[k] + v[k] * BLOB.dt",
        "        below = p[:, 1] < 0": (
            "         below = (p[:, 1] < 0) & (np.arange(len(p)) == k)"
        ),
        "        p[below": "         p[below",
        "        v[below, 1] =": "         v[below, 1] =",
        "        v[below, 0]": "         v[below, 0]",
    },
)
def mass_by_mass() -> None:
    """One mass after the other moves, and each feels the ring as it is by then."""


@wrong_model("S.4", "Which velocity has a mass that has just come to the floor: up, or none?")
@edited(force_by_force, {"np.maximum(v[below, 1], 0.0)": "np.abs(v[below, 1])"})
def floor_throws_back() -> None:
    """The floor throws a mass back as fast as it came."""


@wrong_model("S.3", "Squeeze the ring to nothing. How large does your pressure become?")
def pressure_by_the_loss_of_area(positions: Vector, area: float, stiffness: float) -> Any:
    """The pressure is stiffness times the part of the area that is lost."""
    along = _next(positions) - positions
    pressure = stiffness * (1 - ring_area(positions) / area)
    push = pressure * np.column_stack([along[:, 1], -along[:, 0]])
    return (push + np.roll(push, 1, axis=0)) / 2


@wrong_model("S.1", "A square and a long strip of the same girth: do they enclose the same area?")
def circle_of_the_same_girth(positions: Vector) -> Any:
    """A ring encloses what a circle of its length does."""
    return np.sum(_directions(positions)[0]) ** 2 / (4 * np.pi)


@wrong_model("S.1", "Is the area under one edge that of a rectangle, or of a trapezium?")
def rectangles_under_the_edges(positions: Vector) -> Any:
    """The area is the sum of y times the way along x, over all edges."""
    return -np.sum((_next(positions) - positions)[:, 0] * positions[:, 1])


@wrong_model("S.1", "List the masses counter-clockwise. Has your area the sign that is asked for?")
def clockwise_counts(positions: Vector) -> Any:
    """The area below the edges counts as it comes: clockwise is positive."""
    return -ring_area(positions)


@wrong_model("S.2", "Stiffness is in N/m. Which unit has your force?")
def stiffness_of_the_stretch(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """A spring pulls with its stiffness times how much longer it is in parts of its length."""
    return np.asarray(ring_forces(positions, velocities, length, stiffness / length, damping))


@wrong_model("S.2", "The longer a spring, the larger your u. How long should a direction be?")
def direction_is_the_whole_way(
    positions: Vector, velocities: Vector, length: float, stiffness: float, damping: float
) -> Any:
    """The direction of a spring is the way from one mass to the next."""
    distance, u = _directions(positions)
    faster = np.sum((_next(velocities) - velocities) * u, axis=1)
    pull = (stiffness * (distance - length) + damping * faster)[:, None] * u * distance[:, None]
    return pull - np.roll(pull, 1, axis=0)


@wrong_model("S.3", "The ring is larger than its gas wants. Which way does the task push it then?")
def never_pulls(positions: Vector, area: float, stiffness: float) -> Any:
    """A gas can only push, so the pressure is never less than 0."""
    return pressure_forces(positions, area, stiffness) * (area > ring_area(positions))


@wrong_model("S.3", "A gas pushes at right angles to a wall. Which way do yours push?")
def along_the_edges(positions: Vector, area: float, stiffness: float) -> Any:
    """The gas pushes each edge the way it runs."""
    push = stiffness * (area / ring_area(positions) - 1) * (_next(positions) - positions) / 2
    return push + np.roll(push, 1, axis=0)


@wrong_model("S.3", "Which two edges end in a mass: its own and the one before, or the one after?")
def edge_of_the_next_mass(positions: Vector, area: float, stiffness: float) -> Any:
    """A mass shares the push of its own edge with the edge that begins at the next mass."""
    edges = _next(positions) - positions
    pressure = stiffness * (area / ring_area(positions) - 1)
    push = pressure * np.column_stack([edges[:, 1], -edges[:, 0]]) / 2
    return push + _next(push)


@wrong_model("S.3", "Does each edge feel the whole pressure, or a part of it?")
def pressure_shared_out(positions: Vector, area: float, stiffness: float) -> Any:
    """The pressure is shared out among the masses."""
    return np.asarray(pressure_forces(positions, area, stiffness)) / len(positions)


@wrong_model("S.4", "A force of 1 N on 0.1 kg: which acceleration is that?")
@edited(force_by_force, {"forces / BLOB.mass": "forces"})
def force_for_acceleration() -> None:
    """Forces change the velocity as they are."""


@wrong_model("S.4", "Does the air's 1.5 have the unit 1/s, or kg/s?")
@edited(force_by_force, {"BLOB.air * v": "BLOB.air * v / BLOB.mass"})
def air_as_a_force() -> None:
    """What the air takes is a force, so it is divided by the mass."""


@wrong_model("S.4", "A wet floor: does a mass that slides on it stop at once?")
@edited(force_by_force, {"v[below, 0] *= BLOB.grip": "v[below, 0] = 0.0"})
def floor_holds_at_once() -> None:
    """A mass that is on the floor stands still."""


@wrong_model("S.4", "Which masses does the floor brake?")
@edited(force_by_force, {"v[below, 0] *=": "v[:, 0] *="})
def floor_brakes_all() -> None:
    """On the floor the whole ring is slowed along it, also where it does not touch."""


@wrong_model("S.4", "A mass that was put onto the floor: which way does it still move?")
@edited(force_by_force, {"v[below, 1] = np.maximum(v[below, 1], 0.0)": "pass"})
def still_falls_on_the_floor() -> None:
    """Once the position is right, the velocity takes care of itself."""


@wrong_model("S.4", "What pulls two neighbours back that have come too far apart?")
@edited(
    force_by_force,
    {"ring_forces(p, v, length, BLOB.stiffness, BLOB.damping)": "np.zeros(p.shape)"},
)
def without_springs() -> None:
    """The gas alone keeps the shape."""
