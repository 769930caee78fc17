"""Wrong models of chapter 05: spin and friction.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch05_spin_and_friction.right_answers import along_and_across_the_wall
from lesson_code.course.grading.task import edited, wrong_model

Number: TypeAlias = Any
Vector: TypeAlias = Any


@wrong_model(
    "5.1", "Put a vertex in the middle of an edge. The body is the same: does your number change?"
)
def vertex_masses(mass: float, vertices: Vector) -> Number:
    """The mass sits at the vertices, in equal parts."""
    from_centre = vertices - vertices.mean(axis=0)
    return mass * np.mean(np.sum(from_centre**2, axis=1))


@wrong_model("5.1", "Move the polygon 10 m away. It turns about its centroid: is that harder now?")
def about_the_origin(mass: float, vertices: Vector) -> Number:
    """The moment of inertia is taken about the origin of the coordinates."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    twice_area = x * y2 - x2 * y
    squares = x**2 + x * x2 + x2**2 + y**2 + y * y2 + y2**2
    return mass * np.sum(twice_area * squares) / (6 * np.sum(twice_area))


@wrong_model("5.1", "List the vertices the other way round. Which parts of your formula change?")
def negative_when_reversed(mass: float, vertices: Vector) -> Number:
    """The vertices always come counter-clockwise; only the area needs its sign taken off."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    twice_area = x * y2 - x2 * y
    squares = x**2 + x * x2 + x2**2 + y**2 + y * y2 + y2**2
    c = np.array([np.sum(twice_area * sums) for sums in (x + x2, y + y2)]) / np.sum(twice_area) / 3
    about_origin = mass * np.sum(twice_area * squares) / (6 * abs(np.sum(twice_area)))
    return about_origin - mass * (c @ c)


@wrong_model("5.1", "Three vertices close together, one far off: is the centroid at their average?")
def average_of_the_vertices(mass: float, vertices: Vector) -> Number:
    """The centroid is the average of the vertices."""
    moved = vertices - vertices.mean(axis=0)
    (x, y), (x2, y2) = moved.T, np.roll(moved, -1, axis=0).T
    twice_area = x * y2 - x2 * y
    squares = x**2 + x * x2 + x2**2 + y**2 + y * y2 + y2**2
    return mass * np.sum(twice_area * squares) / (6 * np.sum(twice_area))


@wrong_model("5.1", "About which point is a body easiest to turn: does m d^2 add, or go away?")
def parallel_axis_added(mass: float, vertices: Vector) -> Number:
    """The way from the origin to the centroid adds m d^2."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    twice_area = x * y2 - x2 * y
    squares = x**2 + x * x2 + x2**2 + y**2 + y * y2 + y2**2
    c = np.array([np.sum(twice_area * sums) for sums in (x + x2, y + y2)]) / np.sum(twice_area) / 3
    about_origin = mass * np.sum(twice_area * squares) / (6 * np.sum(twice_area))
    return about_origin + mass * (c @ c)


@wrong_model("5.1", "Double the mass and keep the shape. What does your number do?")
def mass_left_out(mass: float, vertices: Vector) -> Number:
    """The moment of inertia is that of the area, as if a square metre had 1 kg."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    twice_area = x * y2 - x2 * y
    squares = x**2 + x * x2 + x2**2 + y**2 + y * y2 + y2**2
    c = np.array([np.sum(twice_area * sums) for sums in (x + x2, y + y2)]) / np.sum(twice_area) / 3
    return abs(np.sum(twice_area * squares) / 12 - np.sum(twice_area) / 2 * (c @ c))


@wrong_model(
    "5.2", "A pencil turns counter-clockwise about its middle: which way goes its right end?"
)
def turns_clockwise(v: Vector, w: float, r: Vector) -> Vector:
    """A positive angular velocity turns clockwise."""
    return v + w * np.array([r[1], -r[0]])


@wrong_model("5.2", "Does a point of a spinning wheel move away from the axle, or around it?")
def along_the_lever(v: Vector, w: float, r: Vector) -> Vector:
    """The spin adds w r, in the direction of r."""
    return v + w * r


@wrong_model("5.2", "A wheel spins on the spot. Are the points of its rim at rest?")
def centre_only(v: Vector, w: float, r: Vector) -> Vector:
    """Every point of a body moves as its centre does."""
    return v


@wrong_model("5.2", "Take r = (1, 1). Is your turned vector at right angles to it?")
def swapped_without_sign(v: Vector, w: float, r: Vector) -> Vector:
    """To turn a vector by a right angle, exchange its components."""
    return v + w * np.array([r[1], r[0]])


@wrong_model("5.2", "Two points of a wheel, one twice as far out: do they move equally fast?")
def distance_forgotten(v: Vector, w: float, r: Vector) -> Vector:
    """All points of a spinning body go round with the speed w."""
    return v + w * np.array([-r[1], r[0]]) / np.hypot(*r)


@wrong_model("5.3", "Push a door near its hinge and at its edge. Is it equally hard to move?")
def levers_ignored(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """Only the masses resist a push, wherever it acts."""
    return 1 / m_a + 1 / m_b


@wrong_model("5.3", "A push through the centre, r along n: does it turn the body?")
def dot_for_cross(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The lever arm of a push is the part of r along the push."""
    turning = np.dot(r_a, direction) ** 2 / i_a + np.dot(r_b, direction) ** 2 / i_b
    return 1 / m_a + 1 / m_b + turning


@wrong_model("5.3", "A push at the rim, straight at the centre: does its whole distance count?")
def full_distance(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The lever arm is the distance from the centre to the contact."""
    return 1 / m_a + 1 / m_b + np.dot(r_a, r_a) / i_a + np.dot(r_b, r_b) / i_b


@wrong_model("5.3", "Which unit does your second term have? The lever arm makes w, and w makes v.")
def lever_not_squared(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The lever arm counts once."""
    arm_a = abs(r_a[0] * direction[1] - r_a[1] * direction[0])
    arm_b = abs(r_b[0] * direction[1] - r_b[1] * direction[0])
    return 1 / m_a + 1 / m_b + arm_a / i_a + arm_b / i_b


@wrong_model("5.3", "Your number is in kg. What is the unit of a velocity divided by an impulse?")
def the_mass_itself(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The effective mass is asked for, not its inverse."""
    arm_a = r_a[0] * direction[1] - r_a[1] * direction[0]
    arm_b = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / (1 / m_a + 1 / m_b + arm_a**2 / i_a + arm_b**2 / i_b)


@wrong_model("5.3", "The ground never turns. Does a ball on it stop turning for that?")
def turn_as_one(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """Both bodies resist turning together, so their moments of inertia add."""
    arm_a = r_a[0] * direction[1] - r_a[1] * direction[0]
    arm_b = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / m_a + 1 / m_b + (arm_a - arm_b) ** 2 / (i_a + i_b)


@wrong_model("5.3", "Both bodies can turn. Where is the lever arm of body B?")
def first_body_only(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """Only the body that hits is turned by the hit."""
    arm_a = r_a[0] * direction[1] - r_a[1] * direction[0]
    return 1 / m_a + 1 / m_b + arm_a**2 / i_a


@wrong_model("5.4", "The surfaces are pressed together by jn. Can they hold on to any sliding?")
def without_clamp(vt: float, jn: float, friction: float, k: float) -> Number:
    """Friction always stops the sliding."""
    return -vt / k


@wrong_model("5.4", "Slow, strong friction: does the sliding stop, or turn round?")
def always_at_the_limit(vt: float, jn: float, friction: float, k: float) -> Number:
    """Friction is always mu jn, however slow the sliding."""
    return -np.sign(vt) * friction * jn


@wrong_model("5.4", "The body slides to the right. Which way does the ground pull on it?")
def along_the_sliding(vt: float, jn: float, friction: float, k: float) -> Number:
    """Friction pushes the way the body slides."""
    return np.clip(vt / k, -friction * jn, friction * jn)


@wrong_model("5.4", "Something creeps at 5 mm/s. Does nothing hold it, and where should that end?")
def dead_band(vt: float, jn: float, friction: float, k: float) -> Number:
    """Sliding slower than 0.01 m/s is none at all and needs no friction."""
    if abs(vt) < 0.01:
        return 0.0
    return np.clip(-vt / k, -friction * jn, friction * jn)


@wrong_model("5.4", "Which unit has -vt, and which unit has an impulse?")
def mass_ignored(vt: float, jn: float, friction: float, k: float) -> Number:
    """The impulse that stops the sliding is the sliding velocity itself."""
    return np.clip(-vt, -friction * jn, friction * jn)


@wrong_model("5.4", "A large k means a body that gives way easily. Does it take a larger impulse?")
def multiplied_by_k(vt: float, jn: float, friction: float, k: float) -> Number:
    """The impulse that stops the sliding is vt times k."""
    return np.clip(-vt * k, -friction * jn, friction * jn)


@wrong_model("5.4", "Let it slide the other way, just as fast. Is the impulse just as large?")
def clamped_on_one_side(vt: float, jn: float, friction: float, k: float) -> Number:
    """The impulse must not be larger than mu jn; a negative one is never too large."""
    return min(-vt / k, friction * jn)


@wrong_model("5.4", "Press harder. Does the limit of friction stay the same?")
def limit_without_the_pressure(vt: float, jn: float, friction: float, k: float) -> Number:
    """The friction coefficient itself is the largest impulse."""
    return np.clip(-vt / k, -friction, friction)


@wrong_model("5.5", "The wall rubs at the rim. Does the slip get smaller by your change of spin?")
def torque_with_the_wrong_sign(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """The torque is impulse cross lever arm."""
    tangent = np.array([-normal[1], normal[0]])
    v_n, v_t = np.dot(velocity, normal), np.dot(velocity, tangent) - w * radius
    if v_n >= 0:
        return velocity, w
    jn = -(1 + restitution) * v_n
    jt = np.clip(-v_t / 3, -friction * jn, friction * jn)
    return velocity + jn * normal + jt * tangent, w + 2 * jt / radius


@wrong_model(
    "5.5", "A ball without spin hits a rough wall at an angle. Does it leave without spin?"
)
@edited(along_and_across_the_wall, {"w - 2 * jt / radius": "w"})
def spin_unchanged() -> None:
    """Friction slows the disc; only a torque of its own could change the spin."""


@wrong_model("5.5", "A disc rolls along the wall. Is there sliding where they touch?")
@edited(along_and_across_the_wall, {" - w * radius": ""})
def sliding_of_the_centre() -> None:
    """A disc slides as fast as its centre moves along the wall."""


@wrong_model("5.5", "A wall that is nearly smooth: can it stop any sliding at once?")
@edited(along_and_across_the_wall, {"np.clip(-v_t / 3, -friction * jn, friction * jn)": "-v_t / 3"})
def always_grips() -> None:
    """A rough wall always stops the sliding, however small the friction."""


@wrong_model("5.5", "After your hit, does the rim still slide, the other way? What else gave way?")
def rim_as_heavy_as_the_disc(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """Along the wall the disc resists with its mass alone, as it does along the normal."""
    tangent = np.array([-normal[1], normal[0]])
    v_n, v_t = np.dot(velocity, normal), np.dot(velocity, tangent) - w * radius
    if v_n >= 0:
        return velocity, w
    jn = -(1 + restitution) * v_n
    jt = np.clip(-v_t, -friction * jn, friction * jn)
    return velocity + jn * normal + jt * tangent, w - 2 * jt / radius


@wrong_model("5.5", "The disc is already leaving. What can the wall do to it?")
def hits_when_leaving(
    velocity: Vector, w: float, radius: float, normal: Vector, restitution: float, friction: float
) -> Any:
    """A disc at the wall is always hit, whichever way it moves."""
    tangent = np.array([-normal[1], normal[0]])
    v_n, v_t = np.dot(velocity, normal), np.dot(velocity, tangent) - w * radius
    jn = -(1 + restitution) * v_n
    jt = np.clip(-v_t / 3, -friction * abs(jn), friction * abs(jn))
    return velocity + jn * normal + jt * tangent, w - 2 * jt / radius


@wrong_model("5.4", "Push a box harder than friction can hold. Does it slide without any friction?")
def none_beyond_the_limit(vt: float, jn: float, friction: float, k: float) -> float:
    """Friction that cannot hold lets go."""
    needed = -vt / k
    return needed if abs(needed) <= friction * jn else 0.0


@wrong_model("5.1", "Does a triangle reach into all corners of the box around it?")
def box_around_it(mass: float, vertices: Vector) -> float:
    """A polygon turns as the rectangle around it: m (w^2 + h^2) / 12."""
    sides = np.max(vertices, axis=0) - np.min(vertices, axis=0)
    return float(mass * (sides @ sides) / 12)


@wrong_model("5.2", "How fast is the point now, and how far has it come after one second?")
def the_way_of_one_second(v: Vector, w: float, r: Vector) -> Vector:
    """The velocity of a turning point is the way from where it is to where it is in a second."""
    x, y = np.cos(w) * r[0] - np.sin(w) * r[1], np.sin(w) * r[0] + np.cos(w) * r[1]
    return v + np.array([x - r[0], y - r[1]])


@wrong_model("5.5", "A ball without spin hits a rough floor at a slant. Can it begin to turn?")
@edited(
    along_and_across_the_wall,
    {"w - 2 * jt / radius": "w - 2 * np.sign(w) * abs(jt) / radius"},
)
def friction_brakes_the_spin() -> None:
    """Friction can only brake the spin, and never starts it or speeds it up."""
