"""What a guessed plan scores; bits that differ; towers that sleep, and that nothing changes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from lesson_code import simulate
from lesson_code.chapters.ch10_only_what_the_scene_needs.scenes import (
    GUESSED,
    asleep_in_time,
    bits_apart,
    bits_of,
    heavy_on_light,
    score,
    side_by_side,
    three_towers,
)
from lesson_code.engine.core.constants import QUIET_TIME

UNSEEN = 1e-6
"""m: a millionth of a box; what is still moves by less than 1e-6 of what gravity gives."""


def test_score_of_a_guess_counts_what_is_right_on_both_sides() -> None:
    """Discs that meet nobody need nothing, so each effect that is guessed is one that is wrong."""
    for wrong in range(len(GUESSED) + 1):
        assert score(GUESSED[:wrong], side_by_side()) == f"{6 - wrong} of 6 right"
    needed = {"gravity", "friction", "rotation", "manifolds", "continuous"}
    assert score(needed, three_towers()) == "6 of 6 right"


def test_score_of_a_guess_that_names_no_effect_is_refused() -> None:
    """By name, with what may be guessed."""
    with pytest.raises(ValueError, match=r"guess must name some of gravity, .*got 'spin'"):
        score({"spin"}, side_by_side())


def test_bits_apart_are_counted_in_all_states() -> None:
    """The signs of two zeros, one bit each; a 3 for a 2 of the mantissa, one more."""
    run = simulate(side_by_side(), 0.1, solver="sequential")
    places, spins = run.positions.copy(), run.angular_velocities.copy()
    spins[1:3, 0] = -0.0
    assert (places[0, 1, 0], run.velocities[0, 0, 1]) == (5.0, 0.0)
    places[0, 1, 0] = 5.5  # 1.25 and 1.375 times 4: one bit of the mantissa
    other = replace(run, positions=places, angular_velocities=spins)
    assert bits_apart(run, run) == 0
    assert bits_apart(run, other) == bits_apart(other, run) == 3
    frames = len(run.times)
    assert bits_of(run) == frames * 2 * 6 * 64


def test_bits_apart_of_runs_of_other_shapes_are_refused() -> None:
    """By name, with both shapes."""
    runs = [simulate(s, 0.1, solver="sequential") for s in (side_by_side(), heavy_on_light())]
    with pytest.raises(
        ValueError, match=r"positions of one shape, got \(7, 2, 2\) and \(7, 3, 2\)"
    ):
        bits_apart(*runs)


def test_towers_sleep_after_their_quiet_time_and_only_the_one_that_is_hit_wakes() -> None:
    """All nine boxes sleep, then the first three wake together; floor and rolling disc never do."""
    times, asleep = asleep_in_time(three_towers(), 5.0)
    assert not asleep[times < QUIET_TIME].any()
    assert asleep[times > QUIET_TIME + 0.3][0].tolist() == [False, *[True] * 9, False]
    assert asleep[-1].tolist() == [False, *[False] * 3, *[True] * 6, False]


def test_towers_end_as_if_they_had_never_slept() -> None:
    """Sleep forced off: every position is the same, to less than can be seen."""
    slept = simulate(three_towers(), 5.0, solver="sequential")
    awake = simulate(three_towers(), 5.0, solver="sequential", effects={"sleeping": False})
    assert slept.plan.effect("sleeping").used
    assert np.abs(slept.positions - awake.positions).max() <= UNSEEN


def test_duration_is_checked() -> None:
    """By name, with the rule and the value."""
    with pytest.raises(ValueError, match=r"duration must be > 0 .*got -1"):
        asleep_in_time(three_towers(), -1.0)
