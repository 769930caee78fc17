"""A domino chain with a branch: a tall domino sets off one chain below and one on a shelf.

Every domino is a box of the engine that stands by its own weight and friction. It counts as fallen
when it leans beyond its tipping angle.
"""

from __future__ import annotations

import math

from lesson_code.chapters.dominoes.rules import tipping_angle, toppling_rate
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Polygon
from lesson_code.view.pygame.effects import Sparks
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import Game, ImpactEffects, Input, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import BACKGROUND, GREEN, INK, ORANGE, SKY, blend

SIZE, TALL = (0.1, 0.6), (0.14, 1.3)
"""m: width and height of a domino, and of the one at the branch."""

SPACING = 0.36
"""m, from one domino to the next."""

BEFORE, AFTER, ON_SHELF = 7, 10, 8
"""Dominoes before the branch, after it on the floor, and on the shelf."""

FLOOR, SHELF = 0.6, 1.38
"""m, heights."""

FIRST_X = 0.5
DENSITY = 20.0
"""kg/m^2."""

WOOD = Material(restitution=0.0, friction=0.5)
FALL = (0.0, -9.81)
NUDGE = 2.5
"""Times the rate at which the first one just topples."""


class Dominoes(Game):
    """A row that branches."""

    def reset(self) -> None:
        """Stand all dominoes up."""
        self.pushed = False
        self.order: list[int] = []
        self.world = LiveWorld(gravity=FALL, callbacks=self.callbacks)
        for left, right, top in ((-2.0, 10.0, FLOOR), (self._branch_x + 0.62, 8.6, SHELF)):
            thick = 0.12 if top == SHELF else 3.0
            self.world.add(
                Body(
                    Polygon.box(right - left, thick),
                    position=((left + right) / 2, top - thick / 2),
                    material=WOOD,
                )
            )
        self.supports = self.world.numbers
        self.below = [self._stand(FIRST_X + k * SPACING, FLOOR, SIZE) for k in range(BEFORE)]
        self.tall = self._stand(self._branch_x, FLOOR, TALL)
        self.below.append(self.tall)
        start = self._branch_x + SPACING
        self.below += [self._stand(start + k * SPACING, FLOOR, SIZE) for k in range(AFTER)]
        shelf = self._branch_x + 0.75
        self.above = [self._stand(shelf + k * SPACING, SHELF, SIZE) for k in range(ON_SHELF)]

    @property
    def _branch_x(self) -> float:
        """Where the tall domino stands, m."""
        return FIRST_X + BEFORE * SPACING

    @property
    def dominoes(self) -> list[int]:
        """The numbers of all dominoes."""
        return self.below + self.above

    def _stand(self, x: float, ground: float, size: XY) -> int:
        """Stand a domino up."""
        width, height = size
        return self.world.add(
            Body(
                Polygon.box(width, height),
                position=(x, ground + height / 2),
                mass=DENSITY * width * height,
                material=WOOD,
            )
        )

    def press(self, key: str) -> None:
        """Push the first one, or stand all up again."""
        super().press(key)
        if key == "space":
            self.push()

    def push(self) -> None:
        """Give the first domino just enough, and a little more."""
        least = self.ask(toppling_rate, *SIZE, otherwise=None)
        if self.pushed or least is None:
            return
        self.pushed = True
        rate, first = -NUDGE * least, self.below[0]
        self.world.throw(first, (-rate * SIZE[1] / 2, 0.0), rate)

    def down(self, place: XY) -> None:
        """Push the domino that is clicked, in the direction of the chain."""
        for number in self.dominoes:
            x, y = self.world.position(number)
            if abs(place[0] - x) < 0.12 and abs(place[1] - y) < 0.35:
                self.world.push(number, (self._mass(number) * 1.2, 0.0), (0.0, 0.25))
                self.pushed = True
                return

    def _mass(self, number: int) -> float:
        """Return a domino's mass, kg."""
        return self.world.body(number).mass or 0.0

    def step(self) -> None:
        """Make one step, and note which dominoes have fallen."""
        self.world.step()
        for number in self.dominoes:
            if number not in self.order and self.has_fallen(number):
                self.order.append(number)

    def has_fallen(self, number: int) -> bool:
        """Return whether a domino leans beyond its tipping angle."""
        return abs(self.world.angle(number)) > self.leans(TALL if number == self.tall else SIZE)

    def leans(self, size: XY) -> float:
        """Return how far a domino can lean before it has fallen, rad: any way without the rule."""
        return float(self.ask(tipping_angle, *size, otherwise=math.inf))


def draw(game: Dominoes, picture: Picture, effects: ImpactEffects) -> None:
    """Draw floor, shelf and dominoes; those that have fallen are dark."""
    for number in game.supports:
        picture.body(game.world.body(number), game.world.position(number), 0.0, WALL)
    for number in game.dominoes:
        colour = ORANGE if number == game.tall else SKY if number in game.below else GREEN
        if number in game.order:
            colour = blend(colour, BACKGROUND, 0.4)
        place, angle = game.world.position(number), game.world.angle(number)
        picture.body(game.world.body(number), place, angle, effects.colour(number, colour))
    for rank, number in enumerate(game.order, start=1):
        x, _ = game.world.body(number).position
        height = FLOOR - 0.3 if number in game.below else SHELF + SIZE[1] + 0.25
        picture.text(f"{rank}", (x, height), colour=INK)
    if not game.pushed:
        picture.text("SPACE pushes the first domino", (2.0, 2.6))


def readings(game: Dominoes) -> Readings:
    """Return how many have fallen, and the energy."""
    return [
        ("fallen", f"{len(game.order)} of {len(game.dominoes)}"),
        ("on the floor", f"{sum(n in game.below for n in game.order)} of {len(game.below)}"),
        ("on the shelf", f"{sum(n in game.above for n in game.order)} of {len(game.above)}"),
        ("tipping angle", f"{math.degrees(game.leans(SIZE)):.1f} degrees"),
        ("kinetic energy", f"{game.world.kinetic_energy():.2f} J"),
    ]


PROGRAM = Program(
    name="dominoes",
    title="Dominoes",
    game=Dominoes,
    draw=draw,
    readings=readings,
    keys=(("SPACE", "push the first one"), ("click", "push any one")),
    camera=Camera(left=0.0, bottom=-1.2, scale=100.0),
    tour=((10, Input("press", "space")),),
    effects=lambda: ImpactEffects(
        sparks=Sparks(0.8, least_impulse=0.4), sounds=Sounds("wood", 0.2, 1.0)
    ),
)
