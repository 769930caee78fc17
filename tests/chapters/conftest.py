"""What the tests of all games share."""

from __future__ import annotations

from lesson_code.view.pygame.program import Game


def run(game: Game, steps: int) -> None:
    """Make some steps."""
    for _ in range(steps):
        game.step()
