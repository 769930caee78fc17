"""The state of the billiards program: what mouse, keys and time do to it, without any drawing."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from typing import Any, TypeAlias

import numpy as np

from lesson_code.formulas.arithmetic import clamp
from lesson_code.formulas.validation import Vector, non_negative, one_vector
from lesson_code.programs.billiards_table import CUSHIONS, LAUNCH, MAX_LAUNCH_SPEED, TABLE
from lesson_code.view.pygame_view import Place, pygame

Advance: TypeAlias = Callable[[Any, Any, float], tuple[Vector, Vector, list[str], float]]
"""advance(position, velocity, elapsed) -> (position, velocity, hits, left_over)."""

LONGEST_FRAME = 0.25
"""s: a frame that took longer (a dragged window, a sleeping laptop) counts as this long."""

ARROW_SECONDS = 0.25
"""s: an arrow ends where the ball would be after this time; a drag of 100 px gives 400 px/s."""

FLASH_SECONDS = 0.2
"""s: how long a cushion lights up after a hit."""

TRAIL_FRAMES = 120
"""How many past positions are kept to be drawn: two seconds."""

GRAB_RADIUS = 2 * TABLE.radius
"""px: a press this near to the ball's centre takes hold of it."""

RAIL = 28
"""px: width of the frame round the table; the table's corner lies so far inside the window."""

FAR = 10_000.0
"""px: pygame cannot draw at any distance, and a student's ball may fly away."""


class Game:
    """The state behind the window; events and time change it, drawing does not.

    Parameters
    ----------
    advance : callable
        The physics, see :data:`Advance`.
    launch : (position, velocity)
        The first shot, px and px/s, no faster than :data:`MAX_LAUNCH_SPEED`.
    """

    def __init__(self, advance: Advance, launch: tuple[Vector, Vector] = LAUNCH) -> None:
        self._advance = advance
        self._first = _checked_launch(launch)
        self.running = True
        self.paused = False
        self.shows_velocity = False
        self.shows_normals = False
        self.notice = ""
        self.reset()

    def reset(self) -> None:
        """Play the first shot again."""
        self.launch(*self._first)

    def launch(self, position: Vector, velocity: Vector) -> None:
        """Start a shot: counts, time and trail begin anew."""
        self.position, self.velocity = np.array(position), np.array(velocity)
        self.bounces = dict.fromkeys(CUSHIONS, 0)
        self.time = self.left_over = 0.0
        self.all_hit_at: float | None = None
        self.flashes: dict[str, float] = {}
        self.trail: deque[Place] = deque([as_place(position)], maxlen=TRAIL_FRAMES)
        self.aim: Place | None = None
        self.paused = False

    def handle(self, event: pygame.event.Event) -> None:
        """Change what one event of mouse, keyboard or window says."""
        if event.type == pygame.QUIT:
            self.running = False
        elif event.type == pygame.KEYDOWN:
            self._press(event.key)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            mouse = on_table(event.pos)
            if math.dist(mouse, self.position) <= GRAB_RADIUS:
                self.aim = mouse
        elif event.type == pygame.MOUSEMOTION and self.aim is not None:
            self.aim = on_table(event.pos)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1 and self.aim is not None:
            self._let_go(on_table(event.pos))

    def tick(self, elapsed: float) -> None:
        """Let the time of one frame pass, s; it stands still while paused or aiming."""
        if self.paused or self.aim is not None:
            return
        available = self.left_over + min(elapsed, LONGEST_FRAME)
        self.position, self.velocity, hits, self.left_over = _checked_answer(
            self._advance(self.position.copy(), self.velocity.copy(), available)
        )
        self.time += available - self.left_over
        self.trail.append(as_place(self.position))
        self._count(hits, elapsed)

    def _count(self, hits: list[str], elapsed: float) -> None:
        """Count the hits, and light up what was hit."""
        self.flashes = {
            name: left - elapsed for name, left in self.flashes.items() if left > elapsed
        }
        for name in hits:
            self.bounces[name] += 1
            self.flashes[name] = FLASH_SECONDS
        if self.all_hit_at is None and all(self.bounces.values()):
            self.all_hit_at = self.time

    def _press(self, key: int) -> None:
        """Do what a key stands for."""
        match key:
            case pygame.K_SPACE:
                self.paused = not self.paused
            case pygame.K_r:
                self.reset()
            case pygame.K_v:
                self.shows_velocity = not self.shows_velocity
            case pygame.K_n | pygame.K_g:
                self.shows_normals = not self.shows_normals
            case pygame.K_ESCAPE:
                self.running = False

    def _let_go(self, mouse: Place) -> None:
        """End a drag; one that ends on the ball launches nothing."""
        self.aim = None
        if math.dist(mouse, self.position) > TABLE.radius:
            self.launch(self.position, launch_velocity(self.position, mouse))


def launch_velocity(ball: Vector, mouse: Place) -> Any:
    """Return the velocity that a drag from the ball to `mouse` gives, px/s, capped.

    >>> launch_velocity((100, 100), (150, 80))
    array([200., -80.])
    """
    velocity = (np.asarray(mouse) - np.asarray(ball)) / ARROW_SECONDS
    speed = math.hypot(*velocity)
    return velocity if speed <= MAX_LAUNCH_SPEED else velocity * (MAX_LAUNCH_SPEED / speed)


def on_screen(point: Vector) -> Place:
    """Return the place in the window of a point on the table; no further off than can be drawn.

    >>> on_screen((0.0, -1e300))
    (28.0, -10000.0)
    """
    return clamp(float(point[0]) + RAIL, -FAR, FAR), clamp(float(point[1]) + RAIL, -FAR, FAR)


def on_table(pixel: tuple[int, int]) -> Place:
    """Return the point on the table that a pixel's centre shows."""
    return pixel[0] + 0.5 - RAIL, pixel[1] + 0.5 - RAIL


def _checked_launch(launch: tuple[Vector, Vector]) -> tuple[Any, Any]:
    """Return position and velocity of a shot, or raise a ValueError that names what is wrong."""
    position = one_vector("launch position", launch[0])
    velocity = one_vector("launch velocity", launch[1])
    speed = math.hypot(*velocity)
    if speed > MAX_LAUNCH_SPEED:
        raise ValueError(f"launch speed must be <= {MAX_LAUNCH_SPEED:g} px/s, got {speed:g}")
    return position, velocity


def _checked_answer(answer: Any) -> tuple[Any, Any, list[str], float]:
    """Return what `advance` returned, or raise a ValueError that says what it should be."""
    if not isinstance(answer, tuple) or len(answer) != 4:
        rule = "advance must return (position, velocity, hits, left_over)"
        raise ValueError(f"{rule}, got {answer!r}")
    position, velocity, hits, left_over = answer
    if not isinstance(hits, list) or any(name not in CUSHIONS for name in hits):
        rule = f"hits from advance must be a list of names among {', '.join(CUSHIONS)}"
        raise ValueError(f"{rule}, got {hits!r}")
    return (
        one_vector("position from advance", position),
        one_vector("velocity from advance", velocity),
        list(hits),
        float(non_negative("left_over from advance", left_over)),
    )


def as_place(point: Vector) -> Place:
    """Return a point as two plain numbers."""
    return float(point[0]), float(point[1])
