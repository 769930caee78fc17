"""Wrong models of chapter 03: reflection and bounce."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


@wrong_model("3.1", "Your ball slides along the wall. How often must the normal part be removed?")
def slides_along(incident: Vector, normal: Vector) -> Vector:
    """Reflecting takes the normal part away once."""
    return incident - np.dot(incident, normal) * normal


@wrong_model("3.1", "Throw the ball along the wall. Does your mirror turn it round?")
def opposite_sign(incident: Vector, normal: Vector) -> Vector:
    """The mirror image is 2 (I . N) N - I."""
    return 2 * np.dot(incident, normal) * normal - incident


@wrong_model("3.1", "Tilt the wall. Is it still one component alone that changes sign?")
def flips_an_axis(incident: Vector, normal: Vector) -> Vector:
    """A wall turns round the component of the axis that it faces most."""
    axis = int(np.argmax(np.abs(normal)))
    flipped = np.array(incident)
    flipped[axis] = -flipped[axis]
    return flipped


@wrong_model("3.1", "A wall at 45 degrees: does your ball come off it as fast as it came?")
def flips_each_component(incident: Vector, normal: Vector) -> Vector:
    """Each component is turned round as far as the normal has it."""
    return incident * (1 - 2 * np.abs(normal))


@wrong_model(
    "3.1",
    "I . N is one number. Is your I * N one? If you have a tangent, is it at right angles to N?",
)
def componentwise_product(incident: Vector, normal: Vector) -> Vector:
    """The dot product is the product of the components, each for itself."""
    return incident - 2 * incident * normal * normal


@wrong_model("3.1", "A ball that comes in at an angle: does it go back the way it came?")
def straight_back(incident: Vector, normal: Vector) -> Vector:
    """A wall sends the ball back along its own path."""
    return -incident


@wrong_model("3.2", "A smooth wall pushes along its normal. What slows the tangent part in yours?")
def scales_the_tangent(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """Restitution scales the whole mirror image: v' = e R."""
    if np.dot(velocity, normal) >= 0:
        return velocity
    return restitution * (velocity - 2 * np.dot(velocity, normal) * normal)


@wrong_model("3.2", "The ball is already leaving. What does your wall do to it?")
def without_gate(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """A ball at the wall always bounces, whichever way it moves."""
    return velocity - (1 + restitution) * np.dot(velocity, normal) * normal


@wrong_model(
    "3.2", "The normal points to the ball. What is the sign of v . N for a ball coming in?"
)
def gate_inverted(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """A ball comes in when v . N is positive."""
    if np.dot(velocity, normal) <= 0:
        return velocity
    return velocity - (1 + restitution) * np.dot(velocity, normal) * normal


@wrong_model("3.2", "Set e = 1 and compare the speed before and after. Should it grow?")
def doubled_impulse(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """The factor 2 of the mirror is kept, and 1 + e multiplies it."""
    v_n = min(0.0, np.dot(velocity, normal))
    return velocity - 2 * (1 + restitution) * v_n * normal


@wrong_model("3.2", "With e = 0 your ball goes on into the wall. What has to be stopped first?")
def forgets_to_stop(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """The wall gives back e times the normal part, and that is all."""
    v_n = min(0.0, np.dot(velocity, normal))
    return velocity - restitution * v_n * normal


@wrong_model("3.3", "Where is the ball after your call: still inside the wall?")
def stays_inside(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """Once the velocity is right, the position takes care of itself."""
    v_n = min(0.0, np.dot(velocity, normal))
    return position, velocity - (1 + restitution) * v_n * normal


@wrong_model("3.3", "The normal points from the wall to the ball. Which way is out?")
def pushes_deeper(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """The normal points into the wall."""
    v_n = min(0.0, np.dot(velocity, normal))
    return position - depth * normal, velocity - (1 + restitution) * v_n * normal


@wrong_model("3.3", "After going back along its path, does a ball that came in at a slant touch?")
def back_along_the_path(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """The ball goes back the way it has come, by the depth."""
    v_n = min(0.0, np.dot(velocity, normal))
    way = velocity / np.hypot(*velocity)
    return position - depth * way, velocity - (1 + restitution) * v_n * normal


@wrong_model("3.3", "A ball inside the wall, but leaving it: does it not have to be moved out?")
def gate_before_position(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """A ball that is leaving needs nothing at all, not even to be moved out."""
    v_n = np.dot(velocity, normal)
    if v_n >= 0:
        return position, velocity
    return position + depth * normal, velocity - (1 + restitution) * v_n * normal


@wrong_model("3.3", "The wall cannot give way. Who has to move the whole depth?")
def moves_half_the_depth(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """Ball and wall share the way apart."""
    v_n = min(0.0, np.dot(velocity, normal))
    return position + depth / 2 * normal, velocity - (1 + restitution) * v_n * normal


@wrong_model(
    "3.3", "The normal points to the ball. What is the sign of v . N for a ball coming in?"
)
def bounces_only_when_leaving(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """A ball comes in when v . N is positive."""
    v_n = max(0.0, np.dot(velocity, normal))
    return position + depth * normal, velocity - (1 + restitution) * v_n * normal


@wrong_model("3.3", "The ball is already leaving. What does your wall do to its velocity?")
def bounces_when_leaving(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """Whatever overlaps is bounced, whichever way it moves."""
    v_n = np.dot(velocity, normal)
    return position + depth * normal, velocity - (1 + restitution) * v_n * normal


@wrong_model(
    "3.2", "Tilt the wall. Is it still one component alone that is turned round and shrinks?"
)
def bounces_along_an_axis(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """A wall turns round the component of the axis that it faces most, and multiplies it by e."""
    after = np.array(velocity, dtype=float)
    if after @ normal < 0:
        axis = int(np.argmax(np.abs(normal)))
        after[axis] = -restitution * after[axis]
    return after


@wrong_model("3.2", "Turn the wall. In whose directions are the two numbers that you return?")
def left_in_the_frame_of_the_wall(velocity: Vector, normal: Vector, restitution: float) -> Any:
    """The parts along the wall and across it are the new velocity."""
    across, along = velocity @ normal, velocity[1] * normal[0] - velocity[0] * normal[1]
    return velocity if across >= 0 else np.array([-restitution * across, along])


@wrong_model("3.1", "How fast is the ball after your mirror, and how fast was it before?")
def a_direction_alone(incident: Vector, normal: Vector) -> Vector:
    """The mirror image is a direction, so its length is 1."""
    image = incident - 2 * np.dot(incident, normal) * normal
    return image / np.hypot(*image)


@wrong_model("3.3", "By how much does the ball overlap the wall, and by how much do you move it?")
def mirrored_at_the_wall(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """The ball went too far by the depth, so it comes back by that, and then e times that more."""
    v_n = min(0.0, np.dot(velocity, normal))
    factor = 1 + restitution
    return position + factor * depth * normal, velocity - factor * v_n * normal


@wrong_model("3.1", "A mirror has two sides. What does yours do with what comes from behind?")
def only_from_the_front(incident: Vector, normal: Vector) -> Vector:
    """What moves the way the normal points is not turned round."""
    return incident - 2 * min(0.0, np.dot(incident, normal)) * normal


@wrong_model("3.1", "A ball comes in at a slant. Does it leave straight along the normal?")
def leaves_along_the_normal(incident: Vector, normal: Vector) -> Vector:
    """A wall throws the ball straight out, as fast as it came."""
    return np.hypot(*incident) * normal


@wrong_model("3.2", "A smooth wall pushes along its normal. What slows the tangent part?")
def whole_mirror_by_the_root(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """Restitution is the part of the energy that is left, and its root scales the mirror image."""
    v_n = np.dot(velocity, normal)
    return velocity if v_n >= 0 else restitution**0.5 * (velocity - 2 * v_n * normal)


@wrong_model("3.2", "A ball leaves the wall slowly. What takes away a part of its speed in yours?")
def slows_what_leaves(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """Whichever way the ball moves, it leaves with e times its normal speed."""
    v_n = np.dot(velocity, normal)
    return velocity + (restitution * abs(v_n) - v_n) * normal


@wrong_model("3.2", "A ball comes in at 5 cm/s. Is that no bounce? At which speed does it begin?")
def too_slow_to_bounce(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """A slow ball does not bounce: it stays at the wall."""
    v_n = min(0.0, np.dot(velocity, normal))
    return velocity - (1 + restitution if v_n < -0.1 else 1) * v_n * normal


@wrong_model("3.2", "A ball comes in at 5 cm/s. Does it go on into the wall?")
def too_slow_to_count(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """A ball that comes in slowly is as good as at rest, and nothing happens to it."""
    v_n = np.dot(velocity, normal)
    return velocity - (1 + restitution) * (v_n if v_n < -0.1 else 0) * normal


@wrong_model("3.3", "The normal points out. Which is the shortest way out of the wall?")
def out_along_the_new_velocity(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """The ball goes out the way it flies after the bounce, by the depth."""
    v_n = min(0.0, np.dot(velocity, normal))
    velocity = velocity - (1 + restitution) * v_n * normal
    return position + depth * velocity / np.hypot(*velocity), velocity


@wrong_model("3.3", "The ball is already leaving. What takes away a part of its speed in yours?")
def slows_what_leaves_the_wall(
    position: Vector, velocity: Vector, normal: Vector, depth: float, restitution: float
) -> Vector:
    """Whichever way the ball moves, it leaves with e times its normal speed."""
    v_n = np.dot(velocity, normal)
    return position + depth * normal, velocity + (restitution * abs(v_n) - v_n) * normal
