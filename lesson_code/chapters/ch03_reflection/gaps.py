"""What the reader of notebook 03 writes: the mirror, the bounce with its gate, the way out."""

from __future__ import annotations

from math import cos, pi, sin
from random import Random
from typing import Any, TypeAlias

from lesson_code.chapters.ch02_restitution.stepped_ball import moved_out
from lesson_code.chapters.ch03_reflection import wrong_answers as wrong
from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model
from lesson_code.formulas import bounce, reflect

Vector: TypeAlias = Any


def bounced(velocity: Vector, normal: Vector, restitution: float) -> Vector:
    """Return the velocity after a bounce off a smooth wall; one that leaves is left alone."""
    return bounce(velocity, normal, restitution)


@wrong_model("03-out", "The normal points from the wall to the ball. Which way is out?")
def deeper(position: Vector, normal: Vector, depth: float) -> Vector:
    """The ball moves against the normal."""
    return position - depth * normal


@wrong_model("03-out", "The wall cannot give way. Who has to move the whole depth?")
def half(position: Vector, normal: Vector, depth: float) -> Vector:
    """Ball and wall share the way."""
    return position + depth / 2 * normal


@wrong_model("03-out", "Which way does the ball move, if the wall is tilted?")
def upwards(position: Vector, normal: Vector, depth: float) -> Vector:
    """Out is up."""
    return position + depth


def tilted_normal(stream: Random) -> tuple[float, float]:
    """Draw a unit normal that lies off the axes and diagonals."""
    angle = (stream.randrange(8) + stream.uniform(0.4, 0.6)) * pi / 4
    return cos(angle), sin(angle)


def a_vector(stream: Random) -> tuple[float, float]:
    """Draw a vector."""
    return round(stream.uniform(-5, 5), 2), round(stream.uniform(-5, 5), 2)


def a_meeting(stream: Random) -> tuple[Any, ...]:
    """Draw a velocity and a wall's normal; about half of the balls leave the wall."""
    return a_vector(stream), tilted_normal(stream)


def a_bounce(stream: Random) -> tuple[Any, ...]:
    """Draw a velocity, a normal and a restitution."""
    return *a_meeting(stream), round(stream.uniform(0.3, 0.8), 2)


def a_depth(stream: Random) -> tuple[Any, ...]:
    """Draw a position, a normal and a depth."""
    return *a_meeting(stream), round(stream.uniform(0.05, 0.5), 2)


GAPS = (
    Gap(
        id="03-mirror",
        ours=reflect,
        draw=a_meeting,
        wrong_models=(
            wrong.slides_along,
            wrong.opposite_sign,
            wrong.flips_an_axis,
            wrong.straight_back,
        ),
    ),
    Gap(
        id="03-gate",
        ours=bounced,
        draw=a_bounce,
        wrong_models=(
            wrong.without_gate,
            wrong.gate_inverted,
            wrong.scales_the_tangent,
            wrong.doubled_impulse,
            wrong.forgets_to_stop,
        ),
    ),
    Gap(id="03-out", ours=moved_out, draw=a_depth, wrong_models=(deeper, half, upwards)),
)
