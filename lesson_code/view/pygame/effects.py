"""Visible post-processing: flashes, sparks and trails; callbacks report the impacts.

An effect receives touches and reads positions. It changes no body, so that a world is the same
with and without it, and a program may leave it out.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from random import Random

from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY
from lesson_code.view.pygame.picture import FLASH, Picture
from lesson_code.view.pygame.window import BACKGROUND, YELLOW, Colour, blend

FLASH_SECONDS = 0.12
"""s: how long a body stays lit after an impact; shorter is not seen."""

SPARK_SECONDS = 0.35
MOST_SPARKS = 240
"""At once: more would cost the frame and show nothing more."""

SPARKS_A_HIT = 8
SPARK_PIXELS = 2.0
TRAIL_STEPS = 30
"""Half a second."""


class Flashes:
    """Bodies light up for a moment when they begin to touch.

    Parameters
    ----------
    least_impulse : float
        N s: a softer impact is not shown.

    Examples
    --------
    >>> flashes = Flashes()
    >>> flashes.light(3)
    >>> 3 in flashes.lit
    True
    """

    def __init__(self, least_impulse: float = 0.0) -> None:
        self._least = least_impulse
        self.lit: dict[int, float] = {}

    def hit(self, touch: Touch) -> None:
        """Light both bodies of a touch."""
        if touch.normal_impulse > self._least:
            self.light(touch.body_a)
            self.light(touch.body_b)

    def light(self, number: int) -> None:
        """Light one body."""
        self.lit[number] = FLASH_SECONDS

    def step(self, dt: float) -> None:
        """Let time pass, s."""
        self.lit = {number: left - dt for number, left in self.lit.items() if left > dt}

    def colour(self, number: int, colour: Colour) -> Colour:
        """Return the colour of a body: white when it has just been hit, then its own again."""
        if number not in self.lit:
            return colour
        return _brighter(colour, _quarters(self.lit[number], FLASH_SECONDS))


@dataclass(slots=True)
class Spark:
    """A bright point that flies off an impact."""

    x: float  # m
    y: float
    vx: float  # m/s
    vy: float
    left: float  # s


class Sparks:
    """Points that fly off an impact along its tangent.

    Parameters
    ----------
    speed : float
        m/s, of the fastest.
    least_impulse : float
        N s: a softer impact makes none.
    """

    def __init__(self, speed: float = 1.5, least_impulse: float = 0.0) -> None:
        self._speed, self._least = speed, least_impulse
        self._random = Random(0)  # noqa: S311 - decoration, and the same in each run
        self.sparks: deque[Spark] = deque(maxlen=MOST_SPARKS)

    def hit(self, touch: Touch) -> None:
        """Add sparks at a touch."""
        if touch.normal_impulse > self._least:
            self.burst(touch.points[0], touch.normal)

    def burst(self, point: XY, normal: XY) -> None:
        """Add sparks at a point, flying mostly across the normal."""
        for _ in range(SPARKS_A_HIT):
            along = self._random.uniform(-1, 1) * self._speed
            off = self._random.uniform(-0.4, 0.4) * self._speed
            vx, vy = off * normal[0] - along * normal[1], off * normal[1] + along * normal[0]
            left = self._random.uniform(0.5, 1.0) * SPARK_SECONDS
            self.sparks.append(Spark(*point, vx, vy, left))

    def step(self, dt: float) -> None:
        """Let time pass, s."""
        for spark in self.sparks:
            spark.x += spark.vx * dt
            spark.y += spark.vy * dt
            spark.left -= dt
        while self.sparks and self.sparks[0].left <= 0:
            self.sparks.popleft()

    def draw(self, picture: Picture) -> None:
        """Draw the sparks that still glow."""
        glowing = [spark for spark in self.sparks if spark.left > 0]
        if glowing:
            picture.discs(
                [(spark.x, spark.y) for spark in glowing],
                [SPARK_PIXELS / picture.camera.scale] * len(glowing),
                [blend(BACKGROUND, YELLOW, _quarters(s.left, SPARK_SECONDS)) for s in glowing],
            )


class Trails:
    """The way that bodies have come, as lines that fade."""

    def __init__(self) -> None:
        self.places: dict[int, deque[XY]] = {}

    def step(self, positions: Mapping[int, XY]) -> None:
        """Record the positions of bodies; those that are not named lose their trail."""
        self.places = {
            number: self.places.get(number, deque(maxlen=TRAIL_STEPS)) for number in positions
        }
        for number, position in positions.items():
            if not self.places[number] or self.places[number][-1] != position:
                self.places[number].append(position)

    def draw(self, picture: Picture, colour: Colour, ground: Colour = BACKGROUND) -> None:
        """Draw all trails, out of the colour of the ground."""
        for places in self.places.values():
            picture.trail(list(places), blend(ground, colour, 0.6), ground)


def _quarters(left: float, whole: float) -> float:
    """Return what is left in quarters: each colour of a disc is a picture to be painted and kept.

    >>> _quarters(0.3, 1.0)
    0.5
    """
    return math.ceil(4 * left / whole) / 4


@cache
def _brighter(colour: Colour, part: float) -> Colour:
    """Return a colour on its way to white."""
    return blend(colour, FLASH, part)
