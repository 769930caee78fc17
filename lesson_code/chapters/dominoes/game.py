"""A domino chain with a branch: a tall domino sets off one chain below and one on a shelf.

Every domino is a box of the engine that stands by its own weight and friction. It counts as fallen
when it leans beyond its tipping angle. How fast the wave runs depends on the spacing: each chain
adds a point to the graph. No formula is drawn into it, for with friction none is known.
"""

from __future__ import annotations

import math

from lesson_code.chapters.dominoes.rules import tipping_angle, toppling_rate
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Polygon
from lesson_code.view.pygame.effects import Sparks
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import (
    BACKGROUND,
    FADED_INK,
    GREEN,
    INK,
    ORANGE,
    SKY,
    YELLOW,
    blend,
)

SIZE, TALL = (0.1, 0.6), (0.14, 1.3)
"""m: width and height of a domino, and of the one at the branch."""

SPACING, SPACING_STEP = 0.36, 0.06
"""m, from one domino to the next at first, and what a key changes it by."""

LEAST_SPACING, MOST_SPACING = 0.18, 0.48
"""m: closer they stand in a heap, and farther apart they hardly push each other over."""

BEFORE, AFTER, ON_SHELF = 2.52, 3.6, 2.88
"""m: lengths of the chains before the branch, after it on the floor, and on the shelf."""

STARTING = 3
"""Dominoes after the branch whose fall is not timed: the tall one has pushed them."""

REACH = 0.04
"""m, around a domino: a click so near still hits it."""

GRAPH = (0.7, 2.75, 2.4, 1.6)
"""m: left, bottom, width and height of the graph."""

FASTEST = 4.0
"""m/s, at its upper end."""

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

    def __init__(self, seed: int = 0) -> None:
        self.spacing = SPACING
        self.measured: dict[float, float] = {}  # m: m/s, of each chain that has fallen
        super().__init__(seed)

    def reset(self) -> None:
        """Stand all dominoes up."""
        self.pushed = False
        self.order: list[int] = []
        self.fell_at: dict[int, float] = {}  # s
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
        self.below = self._row(FIRST_X, FLOOR, BEFORE)
        self.tall = self._stand(self._branch_x, FLOOR, TALL)
        after = self._row(self._branch_x + self.spacing, FLOOR, AFTER)
        self.timed = after[STARTING:]
        self.below += [self.tall, *after]
        self.above = self._row(self._branch_x + 0.75, SHELF, ON_SHELF)

    def _row(self, start: float, ground: float, length: float) -> list[int]:
        """Stand up a row of dominoes."""
        count = round(length / self.spacing)
        return [self._stand(start + k * self.spacing, ground, SIZE) for k in range(count)]

    @property
    def _branch_x(self) -> float:
        """Where the tall domino stands, m."""
        return FIRST_X + round(BEFORE / self.spacing) * self.spacing

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
        elif key in ("up", "down"):
            wanted = self.spacing + (SPACING_STEP if key == "up" else -SPACING_STEP)
            self.spacing = round(min(max(wanted, LEAST_SPACING), MOST_SPACING), 2)
            self.reset()

    def push(self) -> None:
        """Give the first domino just enough, and a little more."""
        least = self.ask_number(toppling_rate, *SIZE, otherwise=math.nan)
        if self.pushed or math.isnan(least):
            return
        self.pushed = True
        rate, first = -NUDGE * least, self.below[0]
        self.world.throw(first, (-rate * SIZE[1] / 2, 0.0), rate)

    def down(self, place: XY) -> None:
        """Push the domino that is clicked, in the direction of the chain."""
        for number in self.dominoes:
            if self._is_at(number, place):
                height = (TALL if number == self.tall else SIZE)[1]
                impulse = 2.0 * self._mass(number) * height
                self.world.push(number, (impulse, 0.0), (0.0, 0.4 * height))
                self.pushed = True
                return

    def _is_at(self, number: int, place: XY) -> bool:
        """Return whether a place is on a domino, however it stands or lies."""
        (x, y), angle = self.world.position(number), self.world.angle(number)
        dx, dy, c, s = place[0] - x, place[1] - y, math.cos(angle), math.sin(angle)
        width, height = TALL if number == self.tall else SIZE
        across, along = abs(c * dx + s * dy), abs(c * dy - s * dx)
        return across <= width / 2 + REACH and along <= height / 2 + REACH

    def _mass(self, number: int) -> float:
        """Return a domino's mass, kg."""
        return self.world.body(number).mass or 0.0

    def step(self) -> None:
        """Make one step, and note which dominoes have fallen."""
        self.world.step()
        for number in self.dominoes:
            if number not in self.order and self.has_fallen(number):
                self.order.append(number)
                self.fell_at[number] = self.world.time
        speed = self.wave_speed()
        if speed is not None and self.timed[-1] in self.fell_at:
            self.measured.setdefault(self.spacing, speed)

    def wave_speed(self) -> float | None:
        """Return how fast the wave runs along the floor, m/s; None before two have fallen."""
        times = [self.fell_at[n] for n in self.timed if n in self.fell_at]
        if len(times) < 2 or times[-1] <= times[0]:
            return None
        return (len(times) - 1) * self.spacing / (times[-1] - times[0])

    def energy(self) -> float:
        """Return kinetic and potential energy above the floor, J."""
        heights = sum(self._mass(n) * (self.world.position(n)[1] - FLOOR) for n in self.dominoes)
        return self.world.kinetic_energy() - FALL[1] * heights

    def has_fallen(self, number: int) -> bool:
        """Return whether a domino leans beyond its tipping angle."""
        return abs(self.world.angle(number)) > self.leans(TALL if number == self.tall else SIZE)

    def leans(self, size: XY) -> float:
        """Return how far a domino can lean before it has fallen, rad: any way without the rule."""
        return self.ask_number(tipping_angle, *size, otherwise=math.inf)


TALL_ONE = Mark("area", ORANGE, "tall domino")
BELOW = Mark("area", SKY, "domino on the floor")
ABOVE = Mark("area", GREEN, "domino on the shelf")
FALLEN = Mark("area", blend(SKY, BACKGROUND, 0.4), "dark: fallen, in this order")
HERE = Mark("disc", YELLOW, "speed at this spacing")
ELSEWHERE = Mark("disc", SKY, "speed at another spacing")
LEGEND = (TALL_ONE, BELOW, ABOVE, FALLEN, HERE, ELSEWHERE)


def draw(game: Dominoes, picture: Picture, effects: ImpactEffects) -> None:
    """Draw floor, shelf and dominoes; those that have fallen are dark."""
    for number in game.supports:
        picture.body(game.world.body(number), game.world.position(number), 0.0, WALL)
    for number in game.dominoes:
        mark = TALL_ONE if number == game.tall else BELOW if number in game.below else ABOVE
        colour = mark.colour
        if number in game.order:
            colour = blend(colour, BACKGROUND, 0.4)
        place, angle = game.world.position(number), game.world.angle(number)
        picture.body(game.world.body(number), place, angle, effects.colour(number, colour))
    for rank, number in enumerate(game.order, start=1):
        x, _ = game.world.body(number).position
        height = FLOOR - 0.3 if number in game.below else SHELF + SIZE[1] + 0.25
        picture.text(f"{rank}", (x, height), colour=INK)
    if not game.pushed:
        picture.text("SPACE pushes the first domino", (5.6, 4.2))
    _draw_graph(game, picture)


def _draw_graph(game: Dominoes, picture: Picture) -> None:
    """Draw the speed of each wave over its spacing, with numbers on both axes."""
    left, bottom, width, height = GRAPH
    picture.line((left, bottom), (left + width, bottom), FADED_INK)
    picture.line((left, bottom), (left, bottom + height), FADED_INK)
    picture.text("speed of the wave, m/s", (left, bottom + height + 0.15), anchor="midleft")
    picture.text("spacing, m", (left + width + 0.1, bottom), anchor="midleft")
    for mark in range(0, round(FASTEST) + 1, 2):
        y = bottom + height * mark / FASTEST
        picture.line((left - 0.05, y), (left, y), FADED_INK)
        picture.text(f"{mark}", (left - 0.12, y), colour=FADED_INK, anchor="midright")
    for spacing in (0.2, 0.3, 0.4, 0.5):
        x = left + width * spacing / 0.5
        picture.line((x, bottom - 0.05), (x, bottom), FADED_INK)
        picture.text(f"{spacing:g}", (x, bottom - 0.18), colour=FADED_INK)
    for spacing, speed in sorted(game.measured.items()):
        place = left + width * spacing / 0.5, bottom + height * min(speed / FASTEST, 1.0)
        picture.disc(place, 0.05, (HERE if spacing == game.spacing else ELSEWHERE).colour)


def readings(game: Dominoes) -> Readings:
    """Return how many have fallen, how fast, and the energy."""
    speed = game.wave_speed()
    return [
        ("fallen", f"{len(game.order)} of {len(game.dominoes)}"),
        ("on the floor", f"{sum(n in game.below for n in game.order)} of {len(game.below)}"),
        ("on the shelf", f"{sum(n in game.above for n in game.order)} of {len(game.above)}"),
        ("tipping angle", f"{math.degrees(game.leans(SIZE)):.1f} degrees"),
        ("spacing", f"{game.spacing:.2f} m"),
        ("speed of the wave", "not yet" if speed is None else f"{speed:.2f} m/s"),
        ("... of sqrt(g h)", "" if speed is None else f"{speed / math.sqrt(9.81 * SIZE[1]):.2f}"),
        ("kinetic energy", f"{game.world.kinetic_energy():.2f} J"),
        ("with that of height", f"{game.energy():.2f} J"),
    ]


PROGRAM = Program(
    name="dominoes",
    title="Dominoes",
    game=Dominoes,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("SPACE", "push the first one"),
        ("click", "push any one"),
        ("up  down", "spacing"),
    ),
    camera=Camera(left=0.0, bottom=-1.2, scale=100.0),
    tour=tuple(
        (start + later, Input("press", key))
        for start, keys in ((0, "r"), (330, ("down",)), (660, ("down",)), (990, ("up",) * 3))
        for later, key in [*((k, key) for k, key in enumerate(keys)), (10, "space")]
    ),
    effects=lambda: ImpactEffects(
        sparks=Sparks(0.8, least_impulse=0.4), sounds=Sounds("wood", 0.2, 1.0)
    ),
)
