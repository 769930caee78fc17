"""What the reader of chapter 07 writes: times, counts, a fold, a pressure, and a gate."""

from __future__ import annotations

import math
from random import Random
from typing import Any, TypeAlias

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


def share_passing(v: float, dt: float, r: float, th: float) -> float:
    """Return which part of the balls passes a wall, 0 to 1."""
    return max(1 - (r + th / 2) / (v * dt), 0)


@wrong_model("07-passing", "A slow ball: can less than none of them pass?")
def below_zero_for_slow_balls(v: float, dt: float, r: float, th: float) -> float:
    """The formula holds for slow balls, too."""
    return 1 - (r + th / 2) / (v * dt)


@wrong_model("07-passing", "Behind the middle of the wall: which way out is the shorter one?")
def seen_in_all_of_the_wall(v: float, dt: float, r: float, th: float) -> float:
    """A ball is stopped anywhere in the wall."""
    return max(1 - (r + th) / (v * dt), 0)


@wrong_model("07-passing", "That is who is seen in time. And who is not?")
def those_that_are_stopped(v: float, dt: float, r: float, th: float) -> float:
    """The part is that of the places at which a ball is seen."""
    return min((r + th / 2) / (v * dt), 1)


@wrong_model("07-passing", "A ball is seen as soon as its rim is in the wall. Where is its centre?")
def a_ball_without_a_radius(v: float, dt: float, r: float, th: float) -> float:
    """The ball is a point."""
    return max(1 - th / 2 / (v * dt), 0)


def first_touch(a: float, b: float, c: float) -> float:
    """Return the smaller root of a t^2 + 2 b t + c, without a difference of near numbers."""
    return c / (-b + math.sqrt(b * b - a * c))


@wrong_model("07-first-touch", "Try b = -1, a = 1e-20, c = 1: which two numbers do you subtract?")
def with_a_difference(a: float, b: float, c: float) -> float:
    """The first form is as good as the second."""
    return (-b - math.sqrt(b * b - a * c)) / a


@wrong_model("07-first-touch", "Which of the two roots comes first, the smaller or the larger one?")
def the_other_root(a: float, b: float, c: float) -> float:
    """The root with the plus sign."""
    return (-b + math.sqrt(b * b - a * c)) / a


@wrong_model("07-first-touch", "The middle term is 2 b t here. Which b is in your formula?")
def with_four_times_ac(a: float, b: float, c: float) -> float:
    """The root is that of a t^2 + b t + c."""
    return 2 * c / (-b + math.sqrt(b * b - 4 * a * c))


def _turns(mass_ratio: float) -> float:
    """Return how often the angle of the wedge fits into half a turn."""
    return math.pi / math.atan(1 / math.sqrt(mass_ratio))


def crossings(mass_ratio: float) -> int:
    """Return how often a straight line crosses the sides of an unfolded wedge, tan = 1/sqrt(M)."""
    return math.ceil(_turns(mass_ratio)) - 1


@wrong_model("07-crossings", "Equal masses: the angle is pi/4. Is its fourth multiple below pi?")
def with_the_last_side(mass_ratio: float) -> int:
    """A line that is parallel to a side crosses it."""
    return math.floor(_turns(mass_ratio))


@wrong_model("07-crossings", "Half a crossing? Count the multiples of the angle that lie below pi.")
def not_a_whole_number(mass_ratio: float) -> float:
    """The number of crossings is pi over the angle."""
    return _turns(mass_ratio)


@wrong_model("07-crossings", "The tangent of the angle is 1 over the root of M. Where is the root?")
def without_the_root(mass_ratio: float) -> int:
    """The tangent is 1/M."""
    return crossings(mass_ratio * mass_ratio)


@wrong_model("07-crossings", "Seen from the tip of the wedge, by which angle does the line turn?")
def half_a_turn_is_a_right_angle(mass_ratio: float) -> int:
    """The line passes through a right angle."""
    return math.ceil(_turns(mass_ratio) / 2) - 1


def fold(x: float, room: float) -> float:
    """Return where a ball is that bounces between 0 and `room`; without walls it would be at x."""
    return room - abs(x % (2 * room) - room)


@wrong_model("07-fold", "Does a ball that leaves on the right come in again on the left?")
def comes_in_on_the_other_side(x: float, room: float) -> float:
    """The images of the room are all alike, and none is a mirror image."""
    return x % room


@wrong_model("07-fold", "Does the second image of the room lie as the first one, or as the room?")
def every_image_is_mirrored(x: float, room: float) -> float:
    """Every image of the room is a mirror image."""
    return room - x % room


@wrong_model("07-fold", "The ball has bounced off both ends. Where does yours say that it is?")
def one_bounce_at_most(x: float, room: float) -> float:
    """There is one bounce, and no other."""
    return 2 * room - x if x > room else abs(x)


@wrong_model("07-fold", "Does the ball stay at the wall that it has met?")
def stays_at_the_wall(x: float, room: float) -> float:
    """What would be beyond a wall is at the wall."""
    return min(max(x, 0.0), room)


def pressure(impulses: Vector, seconds: float, length: float) -> float:
    """Return the pressure on walls of a length, N/m, from the impulses they received in a time."""
    return float(sum(impulses)) / (seconds * length)


@wrong_model("07-pressure", "Each blow stops a disc and sends it back. Is that not in J already?")
def every_blow_counts_twice(impulses: Vector, seconds: float, length: float) -> float:
    """A disc is turned round, so that its impulse counts twice."""
    return 2 * pressure(impulses, seconds, length)


@wrong_model("07-pressure", "Twice as many blows in the same time: is the pressure the same?")
def of_a_mean_blow(impulses: Vector, seconds: float, length: float) -> float:
    """The mean blow says how hard the gas presses."""
    return pressure(impulses, seconds, length) / len(impulses)


@wrong_model("07-pressure", "Watch the walls for twice as long. Should the pressure double?")
def without_the_time(impulses: Vector, seconds: float, length: float) -> float:
    """The pressure is the impulse on each metre."""
    return float(sum(impulses)) / length


@wrong_model("07-pressure", "That is a force, in N. How many metres of wall share it?")
def force_of_all_walls(impulses: Vector, seconds: float, length: float) -> float:
    """The pressure is the impulse in a second."""
    return float(sum(impulses)) / seconds


def come_nearer(d: Vector, v: Vector) -> bool:
    """Return whether a body at d that moves with v, both seen from another one, comes nearer."""
    return bool(d[0] * v[0] + d[1] * v[1] < 0)


@wrong_model("07-nearer", "d leads to body 2. Does a velocity along d bring it nearer?")
def along_is_nearer(d: Vector, v: Vector) -> bool:
    """A velocity along d leads to the other body."""
    return bool(d[0] * v[0] + d[1] * v[1] > 0)


@wrong_model("07-nearer", "Put d on the left: (-3, 0), with v = (1, 0). Does it come nearer?")
def one_axis_only(d: Vector, v: Vector) -> bool:
    """It comes nearer if it moves to the left."""
    return bool(v[0] < 0)


@wrong_model("07-nearer", "They fly side by side, v = 0: do they come nearer?")
def or_side_by_side(d: Vector, v: Vector) -> bool:
    """Whatever does not part comes nearer."""
    return bool(d[0] * v[0] + d[1] * v[1] <= 0)


def places_and_velocities(stream: Random) -> tuple[Any, ...]:
    """Draw where body 2 is, seen from body 1, m, and how it moves, m/s; some fly side by side."""
    d = (round(stream.uniform(-9, 9), 1) or 1.0, round(stream.uniform(-9, 9), 1))
    v = (round(stream.uniform(-5, 5), 1), round(stream.uniform(-5, 5), 1))
    return d, stream.choice((v, v, (0.0, 0.0)))


def mass_ratios(stream: Random) -> tuple[float]:
    """Draw a ratio of masses; 1 is one of them, where the last side is parallel to the line."""
    return (stream.choice((1.0, round(10 ** stream.uniform(0.7, 4), 1))),)


def balls_at_a_wall(stream: Random) -> tuple[float, ...]:
    """Draw a speed, m/s, a step, s, a radius and a thickness, m; some balls are slow."""
    dt, r = 1 / stream.choice((30, 60, 120)), round(stream.uniform(0.05, 0.2), 2)
    th = round(stream.uniform(0.02, 0.2), 2)
    return round((r + th / 2) / dt * stream.choice((0.6, 0.8, 1.5, 2.5, 4.0)), 1), dt, r, th


def that_meet(stream: Random) -> tuple[float, ...]:
    """Draw a, b < 0 and c > 0 with a root; in some a is so small that digits are lost."""
    b, c = -round(stream.uniform(1, 5), 2), round(stream.uniform(0.1, 2), 2)
    part = stream.choice((0.05, 0.15, 0.2, 1e-14))
    return part * b * b / c, b, c


def straight_ways(stream: Random) -> tuple[float, ...]:
    """Draw a place on a straight way, m, up to four images of the room away, and the room, m."""
    room, image = round(stream.uniform(1, 6), 2), stream.choice((-3, -2, -1, 1, 2, 3, 4))
    return round((image + stream.uniform(0.1, 0.9)) * room, 2), room


def blows(stream: Random) -> tuple[Any, ...]:
    """Draw some impulses, N s, a time, s, and a length of wall, m."""
    impulses = tuple(round(stream.uniform(0.2, 3), 2) for _ in range(stream.randint(3, 8)))
    return impulses, round(stream.uniform(2, 9), 1), round(stream.uniform(2, 9), 1)


GAPS = (
    Gap("07-passing", share_passing, balls_at_a_wall,
        (below_zero_for_slow_balls, seen_in_all_of_the_wall, those_that_are_stopped,
         a_ball_without_a_radius)),
    Gap("07-first-touch", first_touch, that_meet,
        (with_a_difference, the_other_root, with_four_times_ac)),
    Gap("07-crossings", crossings, mass_ratios,
        (with_the_last_side, not_a_whole_number, without_the_root, half_a_turn_is_a_right_angle)),
    Gap("07-fold", fold, straight_ways,
        (comes_in_on_the_other_side, every_image_is_mirrored, one_bounce_at_most,
         stays_at_the_wall)),
    Gap("07-pressure", pressure, blows,
        (every_blow_counts_twice, of_a_mean_blow, without_the_time, force_of_all_walls)),
    Gap("07-nearer", come_nearer, places_and_velocities,
        (along_is_nearer, one_axis_only, or_side_by_side)),
)  # fmt: skip
