"""Wrong models of chapter 05, tasks 5.2 and 5.3: what a lever does to velocity and to mass.

Each stands alone, as a student would hand it in: it calls no helper.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Number: TypeAlias = Any
Vector: TypeAlias = Any


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


@wrong_model("5.2", "How fast is the point now, and how far has it come after one second?")
def the_way_of_one_second(v: Vector, w: float, r: Vector) -> Vector:
    """The velocity of a turning point is the way from where it is to where it is in a second."""
    x, y = np.cos(w) * r[0] - np.sin(w) * r[1], np.sin(w) * r[0] + np.cos(w) * r[1]
    return v + np.array([x - r[0], y - r[1]])


@wrong_model("5.2", "Is a place in one second a velocity: what if the body does not turn at all?")
def the_place_after_one_second(v: Vector, w: float, r: Vector) -> Vector:
    """The spin adds the lever as it has turned after one second."""
    x, y = np.cos(w) * r[0] - np.sin(w) * r[1], np.sin(w) * r[0] + np.cos(w) * r[1]
    return v + np.array([x, y])


@wrong_model("5.2", "An angular velocity of 1 rad/s: how long does a whole turn take?")
def turns_for_radians(v: Vector, w: float, r: Vector) -> Vector:
    """The angular velocity is in turns a second, so 2 pi makes it radians."""
    return v + 2 * np.pi * w * np.array([-r[1], r[0]])


@wrong_model("5.2", "The top of a wheel that turns on the spot: does it go up or down at all?")
def the_same_in_both_components(v: Vector, w: float, r: Vector) -> Vector:
    """The speed w r is added to the velocity, so to each of its components."""
    return v + w * np.hypot(*r)


@wrong_model("5.3", "A cart hits a wall: does the wall's mass make the cart harder to move?")
def masses_as_one(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """Both masses resist together, so they add; for the turning each body counts for itself."""
    arm_a = r_a[0] * direction[1] - r_a[1] * direction[0]
    arm_b = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / (m_a + m_b) + arm_a**2 / i_a + arm_b**2 / i_b


@wrong_model("5.3", "A free body is pushed off centre: about which point does it begin to turn?")
def turning_about_the_point_of_contact(
    m_a: float, i_a: float, r_a: Vector, m_b: float, i_b: float, r_b: Vector, direction: Vector
) -> Number:
    """The push acts at the contact, so I is taken about it: I + m r^2."""
    k = 0.0
    for m, i, r in ((m_a, i_a, r_a), (m_b, i_b, r_b)):
        arm = r[0] * direction[1] - r[1] * direction[0]
        k += 1 / m + arm**2 / (i + m * np.dot(r, r))
    return k
