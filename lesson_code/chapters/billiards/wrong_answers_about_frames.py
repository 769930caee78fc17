"""Wrong models of the billiards: a frame's time in steps.

They use the constants and functions that the student's file has under the same names.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.billiards.rules import TIME_STEP, step
from lesson_code.course.grading.task import wrong_model

Vector: TypeAlias = Any


def _stepped(position: Vector, velocity: Vector, count: int) -> Any:
    """Return position, velocity and hits after some steps."""
    hits: list[str] = []
    for _ in range(count):
        position, velocity, new_hits = step(position, velocity, TIME_STEP)
        hits += new_hits
    return position, velocity, hits


@wrong_model("B.5", "A frame took a whole second. Where does one step of that length put the ball?")
def one_long_step(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """One step can be as long as the frame was."""
    return (*step(position, velocity, elapsed), 0.0)


@wrong_model("B.5", "A frame of 0.11 s holds 6 steps. What becomes of the time that is left over?")
def drops_the_rest(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """What is left over is too short to matter."""
    return *_stepped(position, velocity, int(elapsed / TIME_STEP + 1e-9)), 0.0


@wrong_model("B.5", "A frame of 0.11 s holds 6.6 steps. How many whole ones is that?")
def rounds_up(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """A step that has begun is made whole."""
    count = int(np.ceil(elapsed / TIME_STEP - 1e-9))
    return *_stepped(position, velocity, count), elapsed - count * TIME_STEP


@wrong_model("B.5", "Take 1/60 from 1.0 sixty times. Does exactly nothing remain, in floats?")
def subtracts_until_empty(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """Taking a step's length off again and again counts the steps exactly."""
    hits = []
    while elapsed >= TIME_STEP:
        position, velocity, new_hits = step(position, velocity, TIME_STEP)
        hits += new_hits
        elapsed -= TIME_STEP
    return position, velocity, hits, elapsed


@wrong_model("B.5", "Two frames of half a step, or one of a whole step: the same table afterwards?")
def uses_up_the_rest(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """What is left over is made up by a shorter step, so that no time is lost."""
    hits: list[str] = []
    whole = int(elapsed / TIME_STEP + 1e-9)
    rest = elapsed - whole * TIME_STEP
    for dt in [TIME_STEP] * whole + ([rest] if rest > 1e-9 * TIME_STEP else []):
        position, velocity, found = step(position, velocity, dt)
        hits += found
    return position, velocity, hits, 0.0


@wrong_model("B.5", "30 steps, added up, lack 1e-16 s of a half. How many whole steps are that?")
def loses_a_step_to_rounding(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """A quotient of floats that should be whole is whole."""
    count = int(elapsed / TIME_STEP)
    return *_stepped(position, velocity, count), elapsed - count * TIME_STEP


@wrong_model("B.5", "A frame of 6.6 steps: is what is left over 0.6, or 0.6 of a step?")
def rest_in_steps(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """What is left over is counted in steps."""
    count = int(elapsed / TIME_STEP + 1e-9)
    return *_stepped(position, velocity, count), max(0.0, elapsed / TIME_STEP - count)


@wrong_model("B.5", "A ball meets the same cushion twice. How many hits are that?")
def each_name_once(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """What has been hit is listed once, however often."""
    count = int(elapsed / TIME_STEP + 1e-9)
    position, velocity, hits = _stepped(position, velocity, count)
    return position, velocity, [*dict.fromkeys(hits)], max(0.0, elapsed - count * TIME_STEP)


@wrong_model("B.5", "A hit in the second step of six: does your list still hold it?")
def last_steps_hits(position: Vector, velocity: Vector, elapsed: float) -> Any:
    """The hits are those of the step that was made last."""
    count = int(elapsed / TIME_STEP + 1e-9)
    hits: list[str] = []
    for _ in range(count):
        position, velocity, hits = step(position, velocity, TIME_STEP)
    return position, velocity, hits, max(0.0, elapsed - count * TIME_STEP)
