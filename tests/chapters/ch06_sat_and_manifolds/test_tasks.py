"""The tasks of chapter 06: what is free in an answer, and what the drawn pairs are for."""

from __future__ import annotations

import math
from functools import partial
from random import Random
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.chapters import draws
from lesson_code.chapters.ch06_sat_and_manifolds import draws as pairs
from lesson_code.chapters.ch06_sat_and_manifolds import wrong_answers_about_axes as axes
from lesson_code.chapters.ch06_sat_and_manifolds.draws import Pair
from lesson_code.chapters.ch06_sat_and_manifolds.tasks import as_lines, is_overlap
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.verdict import judge
from lesson_code.geometry import project, sat_axes

TO_TWO_DECIMALS = 0.01
"""m: by no more than this does the rounding of the vertices change a way out."""

ANGLES = st.lists(st.integers(0, 359), min_size=1, max_size=6, unique=True)
SEEDS = range(40)

DRAWN: dict[str, tuple[Pair, bool, bool]] = {
    "corner inside": (pairs.CORNER_INSIDE, True, False),
    "nested": (pairs.NESTED, True, False),
    "past the middle, A": (pairs.PAST_THE_MIDDLE[0], True, True),
    "past the middle, B": (pairs.PAST_THE_MIDDLE[1], False, True),
}
"""Pairs that overlap: whose normal is the shortest way out, and whether the middles mislead."""


def seeded(seed: int) -> Random:
    """Return a stream of random numbers that is the same every time."""
    return Random(seed)  # noqa: S311 - for drawing inputs


def unit(degrees: float) -> tuple[float, float]:
    """Return the unit vector with an angle."""
    return math.cos(math.radians(degrees)), math.sin(math.radians(degrees))


def ways_out(pair: Pair) -> list[tuple[float, Any, bool]]:
    """Return how far B must move out of A, either way along each axis; and whose axis it is."""
    found = []
    for of_a, polygon in zip((True, False), pair, strict=True):
        for axis in sat_axes(polygon):
            (low_a, high_a), (low_b, high_b) = (project(vertices, axis) for vertices in pair)
            found += [(high_a - low_b, axis, of_a), (high_b - low_a, -axis, of_a)]
    return sorted(found, key=lambda way: way[0])


@given(ANGLES, st.randoms(use_true_random=False))
def test_as_lines_order_sign_and_repeats_are_free(angles: list[int], stream: Random) -> None:
    """Axes in another order, turned round or listed twice stand for the same lines."""
    axes = [unit(angle) for angle in angles]
    other = [(-x, -y) if stream.random() < 0.5 else (x, y) for x, y in axes * 2]
    stream.shuffle(other)
    assert np.allclose(as_lines(other), as_lines(axes), atol=1e-15)


@pytest.mark.parametrize("noise", [1e-17, -1e-17, 0.0, -0.0])
def test_as_lines_rounding_turns_no_level_axis_round(noise: float) -> None:
    """An axis along x is that axis, whatever the rounding has left in its y."""
    assert np.allclose(as_lines([(-1.0, noise), (0.6, 0.8)]), [(1.0, 0.0), (0.6, 0.8)])


@pytest.mark.parametrize(
    "other", [[unit(10)], [unit(10), unit(50), unit(90)], [unit(10), (0.0, 0.0)], []]
)
def test_as_lines_other_lines_stay_other(other: list[tuple[float, float]]) -> None:
    """A missing line, one too many, or an axis of no length is not forgiven."""
    lines = as_lines([unit(10), unit(50)])
    assert len(as_lines(other)) != len(lines) or not np.allclose(as_lines(other), lines)


def test_as_lines_lengths_are_kept() -> None:
    """An axis that is not unit does not become unit."""
    assert as_lines([(0.0, -3.0)]) == [[0.0, 3.0]]


def test_wrong_axes_in_another_order_are_recognised() -> None:
    """A misconception is known by its lines: their order and signs tell nothing."""

    def reversed_edges(vertices: Any) -> Any:
        return [-axis for axis in axes.edges_for_normals(vertices)][::-1]

    task = task_by_id("6.1")
    verdict = judge(task, partial(call_here, {task.function: reversed_edges}), 1)
    assert verdict.points == 0
    assert verdict.recognised is axes.edges_for_normals


@pytest.mark.parametrize(("pair", "of_a", "misleads"), DRAWN.values(), ids=DRAWN)
@pytest.mark.parametrize("seed", SEEDS[:10])
def test_drawn_pair_is_what_it_is_for(seed: int, pair: Pair, of_a: bool, misleads: bool) -> None:
    """However a pair is placed: one way out is the shortest, whose it is, and where B's middle is.

    The second way out is longer by at least a tenth of a metre.
    """
    a, b = pairs.placed(seeded(seed), pair)
    (depth, normal, is_of_a), (second, *_), *_ = ways_out((a, b))
    assert depth > 0.1
    assert second > depth + 0.1
    assert is_of_a is of_a
    towards_b = float((np.mean(b, axis=0) - np.mean(a, axis=0)) @ normal)
    assert abs(towards_b) > 0.1
    assert (towards_b < 0) is misleads


@pytest.mark.parametrize("seed", SEEDS[:10])
def test_drawn_nested_pair_is_nested(seed: int) -> None:
    """Every shadow of the small polygon lies inside the large one's."""
    large, small = pairs.placed(seeded(seed), pairs.NESTED)
    for axis in sat_axes(large):
        (low, high), (inner_low, inner_high) = project(large, axis), project(small, axis)
        assert low + 0.1 < inner_low < inner_high < high - 0.1


@pytest.mark.parametrize("seed", SEEDS[:10])
def test_drawn_parted_pair_is_parted_by_a_alone(seed: int) -> None:
    """The gap shows on a normal of A, and on none of B."""
    ways = ways_out(pairs.placed(seeded(seed), pairs.PARTED))
    assert {of_a for depth, _, of_a in ways if depth < TO_TWO_DECIMALS} == {True}
    assert ways[0][0] < -0.1


@pytest.mark.parametrize("count", [3, 4, 5, 6])
@pytest.mark.parametrize("seed", SEEDS)
def test_drawn_polygon_is_convex_and_counter_clockwise(seed: int, count: int) -> None:
    """Rounded to two decimals, each vertex still turns to the left, by more than a little."""
    stream = seeded(seed)
    v = np.array(draws.convex_polygon(stream, count, draws.position(stream)))
    edges = np.roll(v, -1, axis=0) - v
    following = np.roll(edges, -1, axis=0)
    turns = edges[:, 0] * following[:, 1] - edges[:, 1] * following[:, 0]
    assert len(v) == count
    assert turns.min() > 0.01


def test_is_overlap_says_which() -> None:
    """None is no overlap; whatever else is an answer says that there is one."""
    assert [is_overlap(answer) for answer in (None, 0.0, [[1.0, 0.0], 0.5])] == [
        "no overlap",
        "overlap",
        "overlap",
    ]
