"""Newton's cradle: k balls in, k balls out.

The balls hang a hair apart, so that each impact is one of a pair: elastic and between equal
masses it swaps their velocities, and the swaps run through the row. A string is a rigid constraint:
after each step a ball is put back onto its circle, and loses the velocity along its string.
"""

from __future__ import annotations

import math

from lesson_code.chapters.cradle.rules import STRING, on_circle
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Circle
from lesson_code.view.pygame.effects import Flashes
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import Game, ImpactEffects, Input, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import FADED_INK, INK, ORANGE, SKY

RADIUS, MASS, GAP = 0.35, 1.0, 0.002
"""m, kg, m: a gap of nothing would make one impact of many, which a solver has to share out."""

PIVOT_HEIGHT = 5.0
"""m."""

PULL = math.radians(35)
"""How far the balls are pulled out."""

SUBSTEPS = 16
"""Of a step: the string is put right in each."""

BALLS, MOST_BALLS = 5, 9
FALL = (0.0, -9.81)


class Cradle(Game):
    """A row of balls on strings; some of them are pulled out and let go."""

    def __init__(self, seed: int = 0) -> None:
        self.count, self.pulled, self.restitution = BALLS, 1, 1.0
        super().__init__(seed)

    def reset(self) -> None:
        """Hang the balls, pull some out on the left, and let go."""
        spacing = 2 * RADIUS + GAP
        self.pivots = [
            ((k - (self.count - 1) / 2) * spacing, PIVOT_HEIGHT) for k in range(self.count)
        ]
        self.held_ball: int | None = None
        self.world = LiveWorld(
            [self._ball(k) for k in range(self.count)],
            gravity=FALL,
            dt=1 / 60 / SUBSTEPS,
            callbacks=self.callbacks,
        )
        self.swing = max(self._height(k) for k in range(self.count))

    def _ball(self, k: int) -> Body:
        """Return a ball, pulled out or hanging."""
        angle = -PULL if k < self.pulled else 0.0
        x, y = self.pivots[k]
        return Body(
            Circle(RADIUS),
            position=(x + STRING * math.sin(angle), y - STRING * math.cos(angle)),
            mass=MASS,
            material=Material(self.restitution, 0.0),
        )

    def press(self, key: str) -> None:
        """Pull out another number of balls, hang more or fewer, or change the restitution."""
        super().press(key)
        if key.isdecimal() and 1 <= int(key) <= self.count:
            self.pulled = int(key)
            self.reset()
        elif key in ("up", "down"):
            self.count = min(max(self.count + (1 if key == "up" else -1), 1), MOST_BALLS)
            self.pulled = min(self.pulled, self.count)
            self.reset()
        elif key == "e":
            self.restitution = 0.9 if self.restitution == 1.0 else 1.0
            self.reset()

    def down(self, place: XY) -> None:
        """Take hold of a ball."""
        for k in range(self.count):
            if math.dist(place, self.world.position(k)) <= RADIUS:
                self.held_ball = k

    def drag(self, place: XY) -> None:
        """Pull the ball that is held, and those outside of it with it."""
        if self.held_ball is None:
            return
        x, y = self.pivots[self.held_ball]
        angle = math.atan2(place[0] - x, max(y - place[1], 0.1))
        for k in range(self.count):
            if (k - self.held_ball) * (1 if angle > 0 else -1) >= 0:
                px, py = self.pivots[k]
                self.world.move(k, (px + STRING * math.sin(angle), py - STRING * math.cos(angle)))
        for k in range(self.count):
            self.world.throw(k, (0.0, 0.0), 0.0)

    def let_go(self, place: XY) -> None:
        """Let the ball go."""
        self.held_ball = None

    def step(self) -> None:
        """Make one step; a ball that is held keeps everything still."""
        if self.held_ball is not None:
            return
        for _ in range(SUBSTEPS):
            self.world.step()
            for k, pivot in enumerate(self.pivots):
                position, velocity = on_circle(
                    self.world.position(k), self.world.velocity(k), pivot, STRING
                )
                self.world.move(k, position)
                self.world.throw(k, velocity)

    def _height(self, k: int) -> float:
        """Return how far a ball is above the lowest point of its swing, m."""
        return self.world.position(k)[1] - (PIVOT_HEIGHT - STRING)

    def swinging(self) -> tuple[int, int]:
        """Return how many balls are clearly out on the left, and on the right."""
        lifted = [k for k in range(self.count) if self._height(k) > 0.3 * self.swing]
        left = sum(self.world.position(k)[0] < self.pivots[k][0] for k in lifted)
        return left, len(lifted) - left

    def energy(self) -> float:
        """Return kinetic and potential energy, J; 0 for balls that hang still."""
        heights = sum(self._height(k) for k in range(self.count))
        return self.world.kinetic_energy() - MASS * FALL[1] * heights


def draw(game: Cradle, picture: Picture, effects: ImpactEffects) -> None:
    """Draw the beam, the strings and the balls."""
    left, right = game.pivots[0][0] - 1.0, game.pivots[-1][0] + 1.0
    picture.capsule((left, PIVOT_HEIGHT), (right, PIVOT_HEIGHT), 0.08, WALL)
    for k, pivot in enumerate(game.pivots):
        picture.line(pivot, game.world.position(k), FADED_INK)
    for k in range(game.count):
        colour = effects.colour(k, ORANGE if k < game.pulled else SKY)
        picture.disc(game.world.position(k), RADIUS, colour)
        picture.text(f"{k + 1}", game.world.position(k), colour=(20, 24, 30))
    left_out, right_out = game.swinging()
    picture.text(f"{left_out} out", (-3.2, 0.5), colour=INK)
    picture.text(f"{right_out} out", (3.2, 0.5), colour=INK)


def readings(game: Cradle) -> Readings:
    """Return the counts, the momentum along the row and the energy."""
    return [
        ("balls", f"{game.count}"),
        ("pulled out", f"{game.pulled}"),
        ("restitution", f"{game.restitution:g}"),
        ("momentum along x", f"{game.world.momentum()[0]:.2f} kg m/s"),
        ("energy", f"{game.energy():.3f} J"),
    ]


PROGRAM = Program(
    name="cradle",
    title="Newton's cradle",
    game=Cradle,
    draw=draw,
    readings=readings,
    keys=(
        ("drag", "pull balls out"),
        ("1 ... 9", "balls to pull out"),
        ("up  down", "more balls, fewer"),
        ("E", "restitution 1 or 0.9"),
        ("R", "reset"),
    ),
    camera=Camera(left=-5.4, bottom=-0.6, scale=74.0),  # nine balls swing within it
    tour=((0, Input("press", "2")),),
    effects=lambda: ImpactEffects(Flashes(least_impulse=0.3), sounds=Sounds("steel", 0.3, 3.0)),
)
