"""What Newton's cradle shows, measured on the game."""

from __future__ import annotations

import math

import pytest

from lesson_code.chapters.cradle.game import PIVOT_HEIGHT, Cradle
from lesson_code.chapters.cradle.rules import STRING
from lesson_code.view.pygame.game import Input

from ..conftest import deepest_overlap, run

KEPT = 1e-9
"""Of the energy, in an hour of swings and impacts: 1e-15 were measured in a minute."""

MINUTE, HOUR = 3_600, 216_000
"""Steps."""


def sides(game: Cradle, steps: int) -> list[tuple[int, int]]:
    """Return how many balls were out on the left and right, each time all that move were."""
    seen = []
    for _ in range(steps):
        game.step()
        if not seen or seen[-1] != game.swinging():
            seen.append(game.swinging())
    return [out for out in seen if sum(out) == game.pulled]


@pytest.mark.parametrize("count", [1, 2, 5, 9])
def test_cradle_k_balls_in_k_balls_out(count: int) -> None:
    """For every k the swing to the right lifts exactly k, and the way back k again."""
    for k in range(1, count + 1):
        game = Cradle(0)
        game.count, game.pulled = count, k
        game.reset()
        assert sides(game, 300)[:3] == [(k, 0), (0, k), (k, 0)]


@pytest.mark.parametrize("keys", ["1", "4", "u2", "i3", "iu1"])
def test_cradle_loses_nothing_in_a_minute(keys: str) -> None:
    """Equal masses and unequal ones, by both laws; nobody hangs in anybody."""
    loses_nothing(keys, MINUTE)


@pytest.mark.full
def test_cradle_loses_nothing_in_an_hour() -> None:
    """Unequal masses for an hour. Stepped and put back onto its strings, it lost 28 % a minute."""
    loses_nothing("u2", HOUR)


def loses_nothing(keys: str, steps: int) -> None:
    """Hold energy, strings and order of the balls at all times."""
    game = Cradle(0)
    for key in keys:
        game.press(key)
    before, worst = game.energy(), 0.0
    for k in range(steps):
        game.step()
        worst = max(worst, abs(game.energy() / before - 1))
        if k % 10 == 0:
            assert deepest_overlap(game.world) < 1e-9
    assert worst < KEPT
    for k, pivot in enumerate(game.pivots):
        assert math.dist(game.world.position(k), pivot) == pytest.approx(STRING, rel=1e-12)


@pytest.mark.full
def test_cradle_after_ten_minutes_as_many_go_out_as_came_in() -> None:
    """Four of five: swept and put back onto the strings they had become five within one minute."""
    game = Cradle(0)
    game.press("4")
    run(game, 10 * MINUTE)
    assert set(sides(game, 600)) == {(4, 0), (0, 4)}


def test_cradle_single_ball_swings_with_the_period_of_its_pendulum() -> None:
    """T = 4 sqrt(L/g) K(sin(a/2)), with K from the arithmetic-geometric mean."""
    game = Cradle(0)
    game.count = game.pulled = 1
    game.reset()
    start = -game.row.angles[0]
    a, b = 1.0, math.cos(start / 2)
    for _ in range(6):
        a, b = (a + b) / 2, math.sqrt(a * b)
    period = 2 * math.pi * math.sqrt(STRING / 9.81) / a
    turns = []
    for k in range(10_000):
        before = game.row.rates[0]
        game.step()
        if before < 0.0 <= game.row.rates[0]:
            turns.append(k + before / (before - game.row.rates[0]))
    assert (turns[-1] - turns[0]) / (len(turns) - 1) / 60 == pytest.approx(period, rel=1e-6)


def test_cradle_all_at_once_is_the_known_answer() -> None:
    """One of n: -(n-2)/n and 2/n for the others; in turn: 0, ..., 0, 1."""
    game = Cradle(0)
    assert game.answers()["all at once"] == pytest.approx([-0.6, 0.4, 0.4, 0.4, 0.4])
    assert game.answers()["in turn"] == [0.0, 0.0, 0.0, 0.0, 1.0]


@pytest.mark.parametrize("keys", ["3", "u1", "u3"])
def test_cradle_both_answers_are_lawful(keys: str) -> None:
    """Momentum and energy are those of the balls that come in; nobody passes through another."""
    game = Cradle(0)
    for key in keys:
        game.press(key)
    masses = game.row.masses
    coming = sum(masses[: game.pulled])
    for velocities in game.answers().values():
        assert sum(m * v for m, v in zip(masses, velocities, strict=True)) == pytest.approx(coming)
        squares = sum(m * v * v for m, v in zip(masses, velocities, strict=True))
        assert squares == pytest.approx(coming)
        assert velocities == pytest.approx(sorted(velocities), abs=1e-9)


def test_cradle_that_loses_energy_only_loses() -> None:
    """At e = 0.9 the balls come to swing together, and the energy never grows."""
    game = Cradle(0)
    game.press("e")
    last = game.energy()
    for _ in range(MINUTE):
        game.step()
        assert game.energy() <= last * (1 + 1e-12)
        last = game.energy()
    assert max(game.row.angles) - min(game.row.angles) < 0.01


def test_cradle_counts_the_balls_that_the_mouse_pulls_out() -> None:
    """Three on the right, taken at the third: the panel says three."""
    game = Cradle(0)
    x, y = game.world.position(2)
    game.take(Input("down", place=(x, y)))
    game.take(Input("move", place=(game.pivots[2][0] + 2.0, PIVOT_HEIGHT - 2.0)))
    assert game.pulled == 3
    assert game.swinging() == (0, 3)
    game.take(Input("up", place=(0.0, 0.0)))
    run(game, 100)
    assert sides(game, 200)[0] == (3, 0)
