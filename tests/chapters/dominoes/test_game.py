"""What the dominoes show, measured on the game's world."""

from __future__ import annotations

import math

from lesson_code.chapters.dominoes.game import Dominoes

from ..conftest import run


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
