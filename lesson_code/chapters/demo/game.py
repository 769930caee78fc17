"""The complete demo: circles and polygons of all masses in one box, through one engine.

Everything of the course meets here: detection, impulses with spin and friction, position
correction, walls, and post-processing that lights up what touches. Each scene asks a question,
and gives the answer when it has been seen.
"""

from __future__ import annotations

import math

from lesson_code.chapters.demo.scenes import ANSWER_STEPS, SCENES
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Circle, Shape
from lesson_code.view.pygame.effects import Sparks
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import COLOURS, FLASH, Picture
from lesson_code.view.pygame.program import (
    ImpactEffects,
    Program,
    Readings,
    draw_bodies,
    motion_readings,
    room,
    short,
)
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import INK, YELLOW

WIDTH, HEIGHT = 8.0, 6.0
"""m: 800 x 600 px."""

GRID_SPACING = 0.5
"""m: 50 px."""

DENSITY = 10.0
"""kg/m^2."""

RESTITUTION_STEP = 0.05
MOST_BODIES = 60
"""More do not fit into the box side by side."""

KICK = 2.0
"""m/s: the most that a random impulse changes a velocity by, and a rim's speed."""


class Demo(Game):
    """The bodies of a scene in a box, and as many more as are clicked in."""

    def __init__(self, seed: int = 0) -> None:
        self.scene = SCENES["1"]
        super().__init__(seed)

    def reset(self) -> None:
        """Start again with the bodies of the scene, and nothing else."""
        self.random.seed(self.seed)
        self.restitution = self.scene.restitution
        self.world = LiveWorld(room(0, 0, WIDTH, HEIGHT, self._material), callbacks=self.callbacks)
        self.walls = self.world.numbers
        for shape, position, velocity in self.scene.bodies:
            self._add(shape, position, velocity)

    @property
    def _material(self) -> Material:
        """The surface of all bodies."""
        return Material(self.restitution, self.scene.friction)

    @property
    def bodies(self) -> tuple[int, ...]:
        """The numbers of all bodies but the walls."""
        return self.world.numbers[len(self.walls) :]

    def _add(self, shape: Shape, position: XY, velocity: XY) -> None:
        """Add a body."""
        self.world.add(
            Body(
                shape,
                position=position,
                velocity=velocity,
                mass=DENSITY * shape.area,
                material=self._material,
            )
        )

    def press(self, key: str) -> None:
        """Clear, reset, kick everything, or change the restitution."""
        super().press(key)
        if key in SCENES:
            self.scene = SCENES[key]
            self.reset()
        elif key == "c":
            for number in self.bodies:
                self.world.remove(number)
        elif key == "space":
            self.kick()
        elif key in ("up", "right"):
            self.coat(self.restitution + RESTITUTION_STEP)
        elif key in ("down", "left"):
            self.coat(self.restitution - RESTITUTION_STEP)

    def coat(self, restitution: float) -> None:
        """Give all bodies another restitution, kept within 0 and 1."""
        self.restitution = round(min(max(restitution, 0.0), 1.0), 2)
        self.world.coat(restitution=self.restitution)

    def kick(self) -> None:
        """Give every body a random impulse at a random point of its rim."""
        for number in self.bodies:
            body = self.world.body(number)
            heading, side = (self.random.uniform(0, 2 * math.pi) for _ in range(2))
            size = self.random.uniform(0.3, 1.0) * KICK * (body.mass or 0.0)
            reach = 0.5 * body.shape.bounding_radius
            self.world.push(
                number,
                (size * math.cos(heading), size * math.sin(heading)),
                (reach * math.cos(side), reach * math.sin(side)),
            )

    def down(self, place: XY) -> None:
        """Add a circle where there is a click, if the box has room there."""
        radius = self.random.uniform(0.15, 0.4)
        velocity = self.random.uniform(-2, 2), self.random.uniform(-2, 2)
        is_inside = radius < place[0] < WIDTH - radius and radius < place[1] < HEIGHT - radius
        if is_inside and len(self.bodies) < MOST_BODIES and self._is_free(place, radius):
            self._add(Circle(radius), place, velocity)

    def _is_free(self, place: XY, radius: float) -> bool:
        """Return whether a circle would overlap no other body's bounding circle."""
        return all(
            math.dist(place, self.world.position(number))
            > radius + self.world.body(number).shape.bounding_radius
            for number in self.bodies
        )


TOUCHING = Mark("disc", FLASH, "body that is touched now")
BODY = Mark("disc", COLOURS[0], "body: colours tell them apart")
QUESTION = Mark("line", YELLOW, "question; sparks of an impact")
LEGEND = (TOUCHING, BODY, QUESTION)


def draw(game: Demo, picture: Picture, effects: ImpactEffects) -> None:
    """Draw grid and bodies, white while they touch."""
    picture.grid(GRID_SPACING)
    touching = game.world.touching()
    draw_bodies(
        game.world,
        picture,
        effects,
        lambda number: TOUCHING.colour if number in touching else COLOURS[number % len(COLOURS)],
    )
    picture.label(game.scene.question, (0.25, 5.75), QUESTION.colour)
    if game.world.steps >= ANSWER_STEPS:
        picture.label(game.scene.answer, (0.25, 5.45), INK)


def readings(game: Demo) -> Readings:
    """Return restitution, count, vector momentum and the energy of all bodies, spin included."""
    return [
        ("restitution", f"{game.restitution:.2f}"),
        ("bodies", f"{len(game.bodies)}"),
        *motion_readings(game.world),
        ("angular momentum", f"{short(game.world.angular_momentum())} N m s"),
    ]


PROGRAM = Program(
    name="demo",
    title="The complete demo",
    game=Demo,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("1 ... 4", "a scene and its question"),
        ("click", "add a circle"),
        ("SPACE", "random impulses"),
        ("arrows", "restitution up, down"),
        ("C", "clear"),
    ),
    tour=(
        (0, Input("press", "v")),
        (300, Input("press", "space")),
        (480, Input("press", "2")),
        (840, Input("press", "3")),
        (1200, Input("press", "4")),
        (1560, Input("press", "1")),
    ),
    effects=lambda: ImpactEffects(
        sparks=Sparks(least_impulse=2.0), sounds=Sounds("wood", 0.3, 15.0)
    ),
)
