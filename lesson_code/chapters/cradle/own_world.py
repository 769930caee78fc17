"""A cradle for a player's own world: strings and balls that one function moves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.chapters.cradle.rules import cradle
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.own_world import PARTS, OwnWorld, rate_readings
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program
from lesson_code.view.pygame.window import FADED_INK, ORANGE, SKY

LENGTH, BALLS, PULL = 2.4, 5, 0.6
"""m; balls; rad."""


class OwnCradle(OwnWorld):
    """Angles and rates of a cradle."""

    ours = staticmethod(cradle)
    pulled = 1

    def start(self) -> tuple[Any, Any]:
        """Return a cradle with some balls pulled out."""
        out = [-PULL] * self.pulled + [0.0] * (BALLS - self.pulled)
        return np.array(out), np.zeros(BALLS)

    def press(self, key: str) -> None:
        """Pull out another number of balls."""
        if key.isdecimal() and 1 <= int(key) <= BALLS:
            self.pulled = int(key)
            self.reset()
        super().press(key)

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        parts = LENGTH, TIME_STEP / PARTS, PARTS
        return self.answered(first, second, *parts)


def draw_cradle(game: OwnCradle, picture: Picture, effects: ImpactEffects) -> None:
    """Draw strings and balls."""
    radius, top = 0.3, 4.8
    half = (BALLS + 1) * radius
    picture.capsule((-half, top), (half, top), 0.06, WALL)
    for k, angle in enumerate(game.state[0].tolist()):
        pivot = ((2 * k - BALLS + 1) * radius, top)
        ball = pivot[0] + LENGTH * math.sin(angle), top - LENGTH * math.cos(angle)
        picture.line(pivot, ball, FADED_INK)
        picture.disc(ball, radius, ORANGE if k < game.pulled else SKY)


CRADLE = Program(
    name="own_cradle",
    title="Your cradle",
    own=(cradle,),
    with_own=lambda own: {"move": own},
    game=OwnCradle,
    draw=draw_cradle,
    readings=rate_readings,
    keys=(("1 ... 5", "balls to pull out"),),
    camera=Camera(left=-4.0, bottom=0.0, scale=100.0),
)
