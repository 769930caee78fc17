"""A soft ring for a player's own world: masses that one function moves."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.chapters.soft_body.rules import BLOB, drop, ring_area
from lesson_code.engine.core.scene import XY
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.own_world import OwnWorld
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
from lesson_code.view.pygame.window import BACKGROUND, ORANGE, blend

RING, RING_RADIUS, RING_HEIGHT = 20, 0.8, 3.0
"""Masses; m; m, of the centre at the start."""


class OwnSoftBody(OwnWorld):
    """Positions and velocities of a ring."""

    ours = staticmethod(drop)

    def start(self) -> tuple[Any, Any]:
        """Return a round ring above the floor."""
        turns = 2 * np.pi * np.arange(RING) / RING
        ring = RING_RADIUS * np.column_stack([np.cos(turns), np.sin(turns)])
        self.length = 2 * RING_RADIUS * math.sin(math.pi / RING)
        self.area = self.area_of(ring)
        return ring + np.array([0.0, RING_HEIGHT]), np.zeros_like(ring)

    def area_of(self, ring: Any) -> float:
        """Return the area inside a ring, m^2; without the rule it is not known."""
        return self.ask_number(ring_area, ring, otherwise=math.nan)

    def press(self, key: str) -> None:
        """Throw the ring up."""
        super().press(key)
        if key == "space":
            positions, velocities = self.state
            self.state = positions, velocities + np.array([1.0, 4.0])

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        steps = round(TIME_STEP / BLOB.dt)
        fall = self.length, self.area, steps
        return self.answered(first, second, *fall)


def draw_soft_body(game: OwnSoftBody, picture: Picture, effects: ImpactEffects) -> None:
    """Draw floor and ring."""
    picture.capsule((-4.0, -0.1), (4.0, -0.1), 0.04, WALL)
    ring: list[XY] = [(x, y) for x, y in game.state[0].tolist()]
    picture.polygon(ring, blend(ORANGE, BACKGROUND, 0.6))
    picture.discs(ring, [0.06] * RING, [ORANGE] * RING)


def ring_readings(game: OwnSoftBody) -> Readings:
    """Return the time, the area and the kinetic energy."""
    positions, velocities = game.state
    return [
        ("time", f"{game.time:.1f} s"),
        ("area", f"{100 * game.area_of(positions) / game.area:.1f} %"),
        ("kinetic energy", f"{BLOB.mass * (velocities**2).sum() / 2:.3f} J"),
    ]


SOFT_BODY = Program(
    name="own_soft_body",
    title="Your soft body",
    own=(drop,),
    with_own=lambda own: {"move": own},
    game=OwnSoftBody,
    draw=draw_soft_body,
    readings=ring_readings,
    keys=(("SPACE", "throw it up"),),
    camera=Camera(left=-4.0, bottom=-0.5, scale=100.0),
)
