"""Wrong models of chapter 09: rows of balls."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch09_hard_cases.right_answers import by_mirrors
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("9.5", "Two balls come. When the last has left, is there another pair that meets?")
def one_pass(masses: Vector, velocities: Vector) -> Any:
    """One pass from the left to the right does it."""
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        if v[k] > v[k + 1]:
            centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
            v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "A heavy ball hits a light one. Do they change velocities?")
def always_swaps(masses: Vector, velocities: Vector) -> Any:
    """Elastic balls change velocities."""
    return np.sort(velocities)


@wrong_model("9.5", "Which strike comes first, where two pairs approach: the one on the left?")
def leftmost_first(masses: Vector, velocities: Vector) -> Any:
    """The pairs strike from the left to the right, again and again."""
    v = np.array(velocities, dtype=float)
    while (v[:-1] - v[1:]).max() > 1e-9:
        k = int(np.argmax(v[:-1] - v[1:] > 1e-9))
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "The balls part. Why do they strike?")
def without_a_gate(masses: Vector, velocities: Vector) -> Any:
    """Every pair that touches strikes once, from the left to the right."""
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "After your strikes all balls have one velocity. Where is the energy?")
def sticks_together(masses: Vector, velocities: Vector) -> Any:
    """What is in touch moves on together."""
    v = np.array(velocities, dtype=float)
    if (v[:-1] <= v[1:]).all():
        return v
    return np.full(len(v), masses @ v / masses.sum())


@wrong_model("9.5", "Of the pairs that approach, which one do you let strike first?")
def rightmost_first(masses: Vector, velocities: Vector) -> Any:
    """The pairs strike from the right to the left, again and again."""
    v = np.array(velocities, dtype=float)
    for _ in range(10_000):
        near = np.flatnonzero(v[:-1] - v[1:] > 1e-9)
        if len(near) == 0:
            break
        k = near[-1]
        centre = (masses[k] * v[k] + masses[k + 1] * v[k + 1]) / (masses[k] + masses[k + 1])
        v[k : k + 2] = 2 * centre - v[k : k + 2]
    return v


@wrong_model("9.5", "You go from left to right. Does the pair that approaches fastest come first?")
@edited(
    one_pass,
    {
        "    for k in range(len(v) - 1):\n": (
            "    while (v[:-1] - v[1:]).max() > 1e-9:\n     for k in range(len(v) - 1):\n"
        )
    },
)
def pass_after_pass() -> None:
    """The pairs are gone through from left to right, pass after pass, until none approaches."""


@wrong_model("9.5", "A pair has struck. May the same two strike again, later on?")
@edited(
    one_pass,
    {"for k in range(len(v) - 1)": 'for k in np.argsort(v[1:] - v[:-1], kind="stable")'},
)
def each_pair_once() -> None:
    """Each pair strikes once at the most, in the order of how fast they approach at the start."""


@wrong_model("9.5", "Four balls have three contacts. How often may one and the same pair strike?")
@edited(
    by_mirrors,
    {
        "while np.min(pairs @ v) < -1e-9:\n": (
            "for _ in pairs:\n        if np.min(pairs @ v) >= -1e-9:\n            break\n"
        )
    },
)
def one_strike_a_contact() -> None:
    """There are as many strikes as contacts, and no more."""


@wrong_model("9.5", "A fast ball follows one that is as fast. Do they approach fast?")
@edited(
    leftmost_first,
    {
        "np.argmax(v[:-1] - v[1:] > 1e-9)": (
            "np.argmax(np.where(v[:-1] - v[1:] > 1e-9,"
            " np.maximum(np.abs(v[:-1]), np.abs(v[1:])), -1))"
        )
    },
)
def fastest_ball_first() -> None:
    """The pair with the fastest ball strikes first."""


@wrong_model("9.5", "Which strike comes first: the hardest, or that of the fastest approach?")
@edited(
    leftmost_first,
    {
        "np.argmax(v[:-1] - v[1:] > 1e-9)": (
            "np.argmax((v[:-1] - v[1:]) * masses[:-1] * masses[1:] / (masses[:-1] + masses[1:]))"
        )
    },
)
def hardest_first() -> None:
    """The pair with the largest impulse strikes first."""


@wrong_model("9.5", "Two balls fly apart fast. Is that the fastest approach?")
@edited(
    leftmost_first,
    {
        "np.argmax(v[:-1] - v[1:] > 1e-9))": (
            "np.argmax(np.abs(v[:-1] - v[1:])))\n"
            "        if v[k] - v[k + 1] <= 1e-9:\n            break"
        )
    },
)
def largest_difference_first() -> None:
    """The pair with the largest difference of velocities is next; if it parts, all is over."""


@wrong_model("9.5", "The balls are elastic. What do they do after they have met: stay together?")
@edited(
    leftmost_first,
    {"v[:-1] - v[1:] > 1e-9)": "v[:-1] - v[1:])", "2 * centre - v[k : k + 2]": "centre"},
)
def pair_by_pair_together() -> None:
    """Two balls that meet go on with one velocity."""


@wrong_model("9.5", "The first ball and the last one approach. Do they touch?")
def any_two_strike(masses: Vector, velocities: Vector) -> Any:
    """Any two balls may strike, wherever they are in the row."""
    v = np.array(velocities, dtype=float)
    for _ in range(1000):
        approach = np.triu(v[:, None] - v)
        i, k = np.unravel_index(int(approach.argmax()), approach.shape)
        if approach[i, k] <= 1e-9:
            break
        centre = (masses[i] * v[i] + masses[k] * v[k]) / (masses[i] + masses[k])
        v[i], v[k] = 2 * centre - v[i], 2 * centre - v[k]
    return v


@wrong_model("9.5", "A ball is hit from both sides. Which strike comes first in the task?")
def all_that_approach_at_once(masses: Vector, velocities: Vector) -> Any:
    """All pairs that approach strike at the same time."""
    v = np.array(velocities, dtype=float)
    for _ in range(2000):
        approach = np.maximum(v[:-1] - v[1:], 0)
        if approach.max() <= 1e-9:
            break
        impulses = 2 * approach / (1 / masses[:-1] + 1 / masses[1:])
        v -= np.append(impulses, 0) / masses
        v += np.append(0, impulses) / masses
    return v
