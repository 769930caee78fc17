"""What Newton's cradle shows, measured on the game's world."""

from __future__ import annotations

import pytest

from lesson_code.chapters.cradle.game import Cradle

from ..conftest import run


@pytest.mark.parametrize("count", [1, 2, 5, 9])
def test_cradle_k_balls_in_k_balls_out(count: int) -> None:
    """For every k the swing to the right lifts exactly k, and the way back k again."""
    for k in range(1, count + 1):
        game = Cradle(0)
        game.count, game.pulled = count, k
        game.reset()
        seen = []
        for _ in range(200):
            game.step()
            if not seen or seen[-1] != game.swinging():
                seen.append(game.swinging())
        whole = [sides for sides in seen if sum(sides) == k]
        assert whole[:3] == [(k, 0), (0, k), (k, 0)]


def test_cradle_keeps_most_of_its_energy() -> None:
    """Five balls lose less than 5 % in ten seconds."""
    game = Cradle(0)
    before = game.energy()
    run(game, 600)
    assert 0.95 * before < game.energy() < 1.02 * before
