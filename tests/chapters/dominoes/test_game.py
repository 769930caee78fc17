"""What the dominoes show, measured on the game's world."""

from __future__ import annotations

import math

import pytest

from lesson_code.chapters.dominoes.game import FLOOR, PROGRAM, Dominoes
from lesson_code.view.pygame.game import Input

from ..conftest import make_step, run


def test_dominoes_stand_until_they_are_pushed() -> None:
    """Two seconds and nobody leans by half a degree."""
    game = Dominoes(0)
    run(game, 120)
    assert game.order == []
    assert max(abs(game.world.angle(n)) for n in game.dominoes) < math.radians(0.5)


def test_dominoes_all_fall_and_in_order_on_both_branches() -> None:
    """Along the floor one after the other, and along the shelf too, after the tall one."""
    game = Dominoes(0)
    game.press("space")
    run(game, 420)
    assert sorted(game.order) == game.dominoes
    assert [n for n in game.order if n in game.below] == game.below
    assert [n for n in game.order if n in game.above] == game.above
    assert game.order.index(game.tall) < game.order.index(game.above[0])


@pytest.mark.one_in(2)
@pytest.mark.parametrize("spacing", [0.42, 0.24])
def test_dominoes_wave_is_timed_all_fall_and_energy_never_grows(spacing: float) -> None:
    """The speed is that of the fronts seen by the game, from another domino than the game's first.

    Of sqrt(g h), where the scaling laws have it: between a half and two. Wood does not bounce, so
    that motion and height never sum to more than the push gave; swept it was 0.07 % more.
    """
    game = Dominoes(0)
    game.spacing = spacing
    game.reset()
    game.press("space")
    start = game.energy()
    for _ in range(420):
        make_step(game)
        assert game.energy() <= start * (1 + 1e-9)
    assert sorted(game.order) == game.dominoes
    first, end = game.timed[1], game.timed[-1]
    way = game.world.body(end).position[0] - game.world.body(first).position[0]
    speed = way / (game.fell_at[end] - game.fell_at[first])
    assert game.measured[spacing] == pytest.approx(speed, rel=0.15)
    assert 0.5 < game.measured[spacing] / math.sqrt(9.81 * 0.6) < 2.0


@pytest.mark.parametrize("height", [0.03, 0.3, 0.65, 1.0, 1.27])
def test_dominoes_tall_one_answers_a_click_anywhere_on_it(height: float) -> None:
    """From foot to top: it falls over."""
    game = Dominoes(0)
    x, _ = game.world.position(game.tall)
    game.take(Input("down", place=(x + 0.05, FLOOR + height)))
    assert game.pushed
    run(game, 120)
    assert game.tall in game.order


def test_dominoes_click_beside_them_pushes_nobody() -> None:
    """Between two, above one, and where a fallen one stood."""
    game = Dominoes(0)
    x, y = game.world.position(game.below[0])
    for place in ((x + 0.18, y), (x, y + 0.4), (x - 0.12, y)):
        game.take(Input("down", place=place))
    assert not game.pushed


@pytest.mark.full
def test_dominoes_tour_measures_four_waves() -> None:
    """At four spacings, and none is lost by a reset."""
    game = Dominoes(0)
    for k in range(1_320):
        for step, given in PROGRAM.tour:
            if step == k:
                game.take(given)
        make_step(game)
    assert len(game.measured) == 4
