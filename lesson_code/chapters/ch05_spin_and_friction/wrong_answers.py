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


@wrong_model("5.1", "A triangle has three vertices. How many edges does your sum go over?")
def last_edge_left_out(mass: float, vertices: Vector) -> Number:
    """The edges lead from each vertex to the next; from the last one, none does."""
    p, q = vertices[:-1], vertices[1:]
    weights = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    c = weights @ (p + q) / (3 * np.sum(weights))
    squares = np.sum(p * p + p * q + q * q, axis=1)
    return mass * (weights @ squares / (6 * np.sum(weights)) - c @ c)


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


@wrong_model("5.5", "A ball without spin hits a rough floor at a slant. Can it begin to turn?")
@edited(
    along_and_across_the_wall,
    {"w - 2 * jt / radius": "w - 2 * np.sign(w) * abs(jt) / radius"},
)
def friction_brakes_the_spin() -> None:
    """Friction can only brake the spin, and never starts it or speeds it up."""


@wrong_model("5.1", "Is a long, thin plate as easy to turn as a round one of the same area?")
def disc_of_the_same_area(mass: float, vertices: Vector) -> Number:
    """A polygon turns as the disc of its area: m r^2 / 2."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    return mass * abs(np.sum(x * y2 - x2 * y)) / 2 / np.pi / 2


@wrong_model("5.1", "Is a long, thin plate as easy to turn as a square one of the same area?")
def square_of_the_same_area(mass: float, vertices: Vector) -> Number:
    """A polygon turns as the square of its area: m a^2 / 6."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    return mass * abs(np.sum(x * y2 - x2 * y)) / 2 / 6


@wrong_model("5.1", "A plate and balls at its corners: is all of the plate as far out?")
def vertex_masses_about_the_centroid(mass: float, vertices: Vector) -> Number:
    """About the right centroid, but with the mass in equal parts at the vertices."""
    (x, y), (x2, y2) = vertices.T, np.roll(vertices, -1, axis=0).T
    w = x * y2 - x2 * y
    c = np.array([np.sum(w * sums) for sums in (x + x2, y + y2)]) / np.sum(w) / 3
    return mass * np.mean(np.sum((vertices - c) ** 2, axis=1))


@wrong_model("5.1", "A frame of wire and a full plate: which of them has mass in the middle?")
def a_frame_of_wire(mass: float, vertices: Vector) -> Number:
    """The mass lies along the edges, evenly."""
    ways = np.roll(vertices, -1, axis=0) - vertices
    squares = np.sum(ways**2, axis=1)
    masses = mass * np.sqrt(squares) / np.sum(np.sqrt(squares))
    middles = vertices + ways / 2
    from_centre = middles - masses @ middles / mass
    return masses @ (squares / 12 + np.sum(from_centre**2, axis=1))


@wrong_model("5.4", "A box slides twice as fast. Is the pull of dry friction twice as strong?")
def the_faster_the_more(vt: float, jn: float, friction: float, k: float) -> Number:
    """Friction is in proportion to the sliding: mu jn times vt, against it."""
    return -friction * jn * vt


@wrong_model("5.4", "A rougher floor: does it take more of an impulse to stop a box?")
def part_of_what_stops_it(vt: float, jn: float, friction: float, k: float) -> Number:
    """Of the impulse that would stop the sliding, friction gives the part mu."""
    return np.clip(-friction * vt / k, -friction * jn, friction * jn)


@wrong_model("5.4", "Friction could stop the sliding. Does it do nothing at all then?")
def nothing_while_it_holds(vt: float, jn: float, friction: float, k: float) -> Number:
    """Where friction can hold nothing slides, so there is no friction; else it is mu jn."""
    return 0.0 if abs(vt) / k <= friction * jn else -np.sign(vt) * friction * jn


@wrong_model("5.4", "A box slides on ice. Is the friction on it almost what would stop it?")
def what_friction_leaves(vt: float, jn: float, friction: float, k: float) -> Number:
    """The impulse is what would stop the sliding, less what friction can give."""
    return -np.sign(vt) * max(abs(vt) / k - friction * jn, 0.0)


@wrong_model("5.5", "A disc and a ball: which of them has more of its mass far out?")
@edited(
    along_and_across_the_wall,
    {"-v_t / 3": "-2 * v_t / 7", "w - 2 * jt": "w - 2.5 * jt"},
)
def as_a_ball() -> None:
    """The disc turns as a ball does: I = 2/5 m r^2."""


@wrong_model("5.5", "A ball of rubber has spin. Does friction do more than stop the sliding here?")
@edited(along_and_across_the_wall, {"-v_t / 3": "-(1 + restitution) * v_t / 3"})
def the_rim_bounces_back() -> None:
    """Restitution turns the sliding round as well, as far as friction can."""
