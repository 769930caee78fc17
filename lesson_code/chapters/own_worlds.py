"""Three small programs for a player's own world: a cradle, a row of dominoes, a soft ring.

Here the engine has nothing to do. One function moves everything, the workbook's or a player's with
the same signature; the program turns time into steps and what comes back into a picture.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.chapters.cradle.rules import cradle
from lesson_code.chapters.dominoes.rules import chain
from lesson_code.chapters.soft_body.rules import BLOB, drop, ring_area
from lesson_code.engine.core.scene import XY
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.borrowed import lent
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import Effects, Game, Program, Readings
from lesson_code.view.pygame.window import BACKGROUND, FADED_INK, ORANGE, SKY, blend

PARTS = 10
"""Parts of a step, which a player's function makes at once; 600 in a second."""

LENGTH, BALLS, PULL = 2.4, 5, 0.6
"""m; balls; rad."""

HEIGHT, SPACING, DOMINOES_STANDING = 1.2, 0.6, 10
"""m, m, count."""

RING, RING_RADIUS, RING_HEIGHT = 20, 0.8, 3.0
"""Masses; m; m, of the centre at the start."""


class OwnWorld(Game):
    """A state that one function moves.

    Parameters
    ----------
    seed : int
        Nothing is drawn by lot here.
    move : callable
        Returns the state after a number of parts of a step.
    """

    ours: Callable[..., Any]

    def __init__(self, seed: int = 0, move: Callable[..., Any] | None = None) -> None:
        self._move = lent(self.ours if move is None else move, self.ours)
        super().__init__(seed)

    def reset(self) -> None:
        """Put the state back to its beginning."""
        self.time = 0.0
        self.state = self.start()

    def start(self) -> tuple[Any, Any]:
        """Return the state at the beginning."""
        raise NotImplementedError

    def step(self) -> None:
        """Make one step."""
        first, second = self.moved(*self.state)
        self.state = np.asarray(first, dtype=float), np.asarray(second, dtype=float)
        self.time += TIME_STEP

    def snapshot(self) -> NDArray[np.float64]:
        """Return both halves of the state."""
        return np.stack(self.state)

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        raise NotImplementedError


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
        return self._move(first, second, LENGTH, TIME_STEP / PARTS, PARTS)


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
        return self._move(first, second, HEIGHT, SPACING, TIME_STEP / PARTS, PARTS)


class OwnSoftBody(OwnWorld):
    """Positions and velocities of a ring."""

    ours = staticmethod(drop)

    def start(self) -> tuple[Any, Any]:
        """Return a round ring above the floor."""
        turns = 2 * np.pi * np.arange(RING) / RING
        ring = RING_RADIUS * np.column_stack([np.cos(turns), np.sin(turns)])
        self.length = 2 * RING_RADIUS * math.sin(math.pi / RING)
        self.area = ring_area(ring)
        return ring + np.array([0.0, RING_HEIGHT]), np.zeros_like(ring)

    def press(self, key: str) -> None:
        """Throw the ring up."""
        super().press(key)
        if key == "space":
            positions, velocities = self.state
            self.state = positions, velocities + np.array([1.0, 4.0])

    def moved(self, first: Any, second: Any) -> Any:
        """Return the state after one step."""
        steps = round(TIME_STEP / BLOB.dt)
        return self._move(first, second, self.length, self.area, steps)


def draw_cradle(game: OwnCradle, picture: Picture, effects: Effects) -> None:
    """Draw strings and balls."""
    radius, top = 0.3, 4.8
    half = (BALLS + 1) * radius
    picture.capsule((-half, top), (half, top), 0.06, WALL)
    for k, angle in enumerate(game.state[0].tolist()):
        pivot = ((2 * k - BALLS + 1) * radius, top)
        ball = pivot[0] + LENGTH * math.sin(angle), top - LENGTH * math.cos(angle)
        picture.line(pivot, ball, FADED_INK)
        picture.disc(ball, radius, ORANGE if k < game.pulled else SKY)


def draw_dominoes(game: OwnDominoes, picture: Picture, effects: Effects) -> None:
    """Draw floor and dominoes."""
    picture.capsule((-4.0, 1.0), (4.0, 1.0), 0.04, WALL)
    touch = math.asin(SPACING / HEIGHT)
    for k, angle in enumerate(game.state[0].tolist()):
        foot = (-3.4 + k * SPACING, 1.08)
        top = foot[0] + HEIGHT * math.sin(angle), foot[1] + HEIGHT * math.cos(angle)
        picture.capsule(foot, top, 0.05, ORANGE if angle > touch else SKY)


def draw_soft_body(game: OwnSoftBody, picture: Picture, effects: Effects) -> None:
    """Draw floor and ring."""
    picture.capsule((-4.0, -0.1), (4.0, -0.1), 0.04, WALL)
    ring: list[XY] = [(x, y) for x, y in game.state[0].tolist()]
    picture.polygon(ring, blend(ORANGE, BACKGROUND, 0.6))
    picture.discs(ring, [0.06] * RING, [ORANGE] * RING)


def rate_readings(game: OwnWorld) -> Readings:
    """Return the time, and the largest angle and rate."""
    angles, rates = game.state
    return [
        ("time", f"{game.time:.1f} s"),
        ("largest angle", f"{math.degrees(abs(angles).max()):.1f} degrees"),
        ("largest rate", f"{abs(rates).max():.2f} rad/s"),
    ]


def ring_readings(game: OwnSoftBody) -> Readings:
    """Return the time, the area and the kinetic energy."""
    positions, velocities = game.state
    return [
        ("time", f"{game.time:.1f} s"),
        ("area", f"{100 * ring_area(positions) / game.area:.1f} %"),
        ("kinetic energy", f"{BLOB.mass * (velocities**2).sum() / 2:.3f} J"),
    ]


CRADLE = Program(
    name="own_cradle",
    title="Your cradle",
    game=OwnCradle,
    draw=draw_cradle,
    readings=rate_readings,
    keys=(("1 ... 5", "pull out so many"), ("R", "reset")),
    camera=Camera(left=-4.0, bottom=0.0, scale=100.0),
)

DOMINOES = Program(
    name="own_dominoes",
    title="Your dominoes",
    game=OwnDominoes,
    draw=draw_dominoes,
    readings=rate_readings,
    keys=(("SPACE", "push the first one"), ("R", "stand all up")),
    camera=Camera(left=-4.0, bottom=-1.0, scale=100.0),
)

SOFT_BODY = Program(
    name="own_soft_body",
    title="Your soft body",
    game=OwnSoftBody,
    draw=draw_soft_body,
    readings=ring_readings,
    keys=(("SPACE", "throw it up"), ("R", "drop it anew")),
    camera=Camera(left=-4.0, bottom=-0.5, scale=100.0),
)
