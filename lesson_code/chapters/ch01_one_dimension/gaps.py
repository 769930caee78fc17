"""What the reader of notebook 01 writes: a collision, seen from the centre of mass."""

from __future__ import annotations

from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def centre_velocity(m1: float, v1: float, m2: float, v2: float) -> float:
    """Return the velocity of the centre of mass, m/s."""
    return (m1 * v1 + m2 * v2) / (m1 + m2)


@wrong_model("01-centre", "A truck meets a fly head on. Does the truck lose half its speed?")
def plain_average(m1: float, v1: float, m2: float, v2: float) -> float:
    """The centre of mass moves with the average of the velocities."""
    return (v1 + v2) / 2


@wrong_model("01-centre", "What unit does your answer have? Momentum is not yet a velocity.")
def total_momentum(m1: float, v1: float, m2: float, v2: float) -> float:
    """The total momentum is a velocity already."""
    return m1 * v1 + m2 * v2


@wrong_model("01-centre", "Which mass belongs to which velocity in the total momentum?")
def weights_exchanged(m1: float, v1: float, m2: float, v2: float) -> float:
    """Each velocity is weighted with the other body's mass."""
    return (m2 * v1 + m1 * v2) / (m1 + m2)


def sent_back(v: float, centre: float, e: float) -> float:
    """Return a velocity after the collision, m/s, from that before and the centre's."""
    return centre - e * (v - centre)


@wrong_model(
    "01-sent-back", "Your answer is what the cart does from the seat. And from the ground?"
)
def stays_in_the_seat(v: float, centre: float, e: float) -> float:
    """The velocity seen from the centre of mass is the one on the ground."""
    return -e * (v - centre)


@wrong_model("01-sent-back", "Seen from the centre of mass, does the cart go on or turn round?")
def goes_on(v: float, centre: float, e: float) -> float:
    """The collision slows the cart down, and does not turn it round."""
    return centre + e * (v - centre)


@wrong_model("01-sent-back", "Which of the two should e shrink: the velocity seen from the centre?")
def shrinks_the_mirror_image(v: float, centre: float, e: float) -> float:
    """E shrinks the elastic answer."""
    return e * (2 * centre - v)


@wrong_model("01-sent-back", "Put in e = 0. The carts stick: do they then stand still?")
def turns_round(v: float, centre: float, e: float) -> float:
    """The cart comes back with a part of the velocity that it had on the ground."""
    return -e * v


def two_carts(stream: Random) -> tuple[float, ...]:
    """Draw masses and velocities of two carts that meet."""
    m1, m2 = round(stream.uniform(0.5, 2), 2), round(stream.uniform(2.5, 6), 2)
    return m1, round(stream.uniform(1, 6), 2), m2, round(stream.uniform(-4, -0.5), 2)


def seen_from_the_centre(stream: Random) -> tuple[float, ...]:
    """Draw a cart's velocity, the centre's and a restitution."""
    v, centre = round(stream.uniform(2, 6), 2), round(stream.uniform(-1.5, 1.5), 2)
    return v, centre, round(stream.uniform(0.2, 0.8), 2)


GAPS = (
    Gap(
        id="01-centre",
        ours=centre_velocity,
        draw=two_carts,
        wrong_models=(plain_average, total_momentum, weights_exchanged),
    ),
    Gap(
        id="01-sent-back",
        ours=sent_back,
        draw=seen_from_the_centre,
        wrong_models=(stays_in_the_seat, goes_on, shrinks_the_mirror_image, turns_round),
    ),
)
