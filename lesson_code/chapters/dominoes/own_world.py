"""Dominoes for a player's own world: a row that one function moves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.chapters.dominoes.rules import chain
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.own_world import PARTS, OwnWorld, rate_readings
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program
from lesson_code.view.pygame.window import ORANGE, SKY

HEIGHT, SPACING, DOMINOES_STANDING = 1.2, 0.6, 10
"""m, m, count."""


class OwnDominoes(OwnWorld):
    """Angles and rates of a row of thin dominoes."""

    ours = staticmethod(chain)

    def start(self) -> tuple[Any, Any]:
        """Return a row that stands."""
        return np.zeros(DOMINOES_STANDING), np.zeros(DOMINOES_STANDING)

    def press(self, key: str) -> None:
        """Push the first one."""
        super().press(key)
        if key == "space":
            angles, rates = self.state
            self.state = angles, np.concatenate([[1.0], rates[1:]])

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        parts = HEIGHT, SPACING, TIME_STEP / PARTS, PARTS
        return self.answered(first, second, *parts)


def draw_dominoes(game: OwnDominoes, picture: Picture, effects: ImpactEffects) -> None:
    """Draw floor and dominoes."""
    picture.capsule((-4.0, 1.0), (4.0, 1.0), 0.04, WALL)
    touch = math.asin(SPACING / HEIGHT)
    for k, angle in enumerate(game.state[0].tolist()):
        foot = (-3.4 + k * SPACING, 1.08)
        top = foot[0] + HEIGHT * math.sin(angle), foot[1] + HEIGHT * math.cos(angle)
        picture.capsule(foot, top, 0.05, ORANGE if angle > touch else SKY)


DOMINOES = Program(
    name="own_dominoes",
    title="Your dominoes",
    own=(chain,),
    with_own=lambda own: {"move": own},
    game=OwnDominoes,
    draw=draw_dominoes,
    readings=rate_readings,
    keys=(("SPACE", "push the first one"),),
    camera=Camera(left=-4.0, bottom=-1.0, scale=100.0),
)
