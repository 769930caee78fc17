"""Soft bodies: rings of masses and springs, with pressure inside, that fall on one another.

The springs act between two steps, as impulses; contacts are the engine's. Each mass is a small
disc, so that rings meet the floor, steps and each other like any other bodies.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.chapters.soft_body.rules import pressure_forces, ring_area, ring_forces
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.view.pygame.effects import Sparks
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import Game, ImpactEffects, Input, Program, Readings, room
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import (
    BACKGROUND,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    YELLOW,
    Colour,
    blend,
)

WIDTH, HEIGHT = 8.0, 6.0
MASSES, RADIUS = 16, 0.7
"""Masses in a ring, and its radius, m."""

BEAD = 0.95 * RADIUS * math.sin(math.pi / MASSES)
"""m, radius of a mass: neighbours nearly touch, so that nothing slips in between."""

BEAD_MASS = 0.1
"""kg."""

STIFFNESS, DAMPING, PRESSURE = 220.0, 1.2, 100.0
"""N/m, N s/m and N/m."""

SUBSTEPS = 6
"""Of a step: the springs swing at 18 1/s at most, and each swing takes many of them."""

SWEEPS = 4
"""Over the contacts in each of these: few, because what is left over is taken up by the next."""

AIR = 0.15
"""1/s, damping of all motion."""

FALL = (0.0, -9.81)
RUBBER = Material(restitution=0.0, friction=0.5)
PLACES: tuple[XY, ...] = ((2.4, 4.6), (4.3, 3.2), (5.9, 4.9))
COLOURS: tuple[Colour, ...] = (SKY, ORANGE, GREEN, PURPLE, YELLOW)
MOST_BODIES = len(COLOURS)
NUMBER_SIZE = 34
"""px: height of a body's number, as the panel counts them."""

GRIP = 30.0
"""1/s^2: how hard the mouse pulls, for 1 kg and 1 m."""


STRIDES = (1, 2, 4)
"""Springs tie a mass to the next one, the next but one, and the fourth: rings within the ring."""

SPRINGS = np.array([(k, (k + stride) % MASSES) for stride in STRIDES for k in range(MASSES)])
"""The masses that each spring of a body ties."""


class SoftBody(Game):
    """Some soft bodies between a floor, a step and a slope."""

    def reset(self) -> None:
        """Put the bodies back to where they fall from."""
        self.rings: list[list[int]] = []  # the numbers of their masses
        self._areas: list[float] = []
        self.grip: tuple[int, XY] | None = None
        ledges = [((0.0, 0.9), (2.2, 0.5)), ((6.0, 0.7), (8.0, 0.7))]
        self.world = LiveWorld(
            room(0, 0, WIDTH, HEIGHT, RUBBER)
            + [Body(Segment(a, b, 0.1), material=RUBBER) for a, b in ledges],
            gravity=FALL,
            damping=AIR,
            dt=1 / 60 / SUBSTEPS,
            iterations=SWEEPS,
            callbacks=self.callbacks,
        )
        self.walls = self.world.numbers
        for place in PLACES:
            self.drop(place)

    def drop(self, place: XY) -> None:
        """Add a soft body, round and at rest."""
        turns = [2 * math.pi * k / MASSES for k in range(MASSES)]
        points = np.array([(math.cos(t), math.sin(t)) for t in turns]) * RADIUS + place
        beads = [
            self.world.add(Body(Circle(BEAD), position=(x, y), mass=BEAD_MASS, material=RUBBER))
            for x, y in points.tolist()
        ]
        self._areas.append(self._area(points))
        self.rings.append(beads)

    def press(self, key: str) -> None:
        """Start again, add a body, or kick them all."""
        super().press(key)
        if key == "b" and len(self.rings) < MOST_BODIES and self._has_room_above():
            self.drop((WIDTH / 2, HEIGHT - 1.0))
        elif key == "space":
            for ring in self.rings:
                kick = self.random.uniform(-2, 2), self.random.uniform(2, 5)
                for bead in ring:
                    self.world.push(bead, (BEAD_MASS * kick[0], BEAD_MASS * kick[1]))

    def _has_room_above(self) -> bool:
        """Return whether a new body would overlap no other one."""
        place, least = (WIDTH / 2, HEIGHT - 1.0), RADIUS + 2 * BEAD
        return bool((np.hypot(*(self.points() - place).T) > least).all())

    def down(self, place: XY) -> None:
        """Take hold of the nearest mass of the body under the mouse."""
        beads = [bead for ring in self.rings for bead in ring]
        nearest = min(beads, key=lambda bead: math.dist(place, self.world.position(bead)))
        if math.dist(place, self.world.position(nearest)) < RADIUS:
            self.grip = nearest, place

    def drag(self, place: XY) -> None:
        """Pull."""
        if self.grip is not None:
            self.grip = self.grip[0], place

    def let_go(self, place: XY) -> None:
        """Release what is held."""
        self.grip = None

    def step(self) -> None:
        """Make one step: springs, pressure and the mouse between the engine's short steps."""
        for _ in range(SUBSTEPS):
            self.world.push_all(self.forces() * self.world.dt)
            self.world.step()

    def forces(self) -> Any:
        """Return what springs, pressure and the mouse do to every body, N, shape (N, 2)."""
        states = self.world.states()
        forces = np.zeros((len(states), 2))
        p, v = states[len(self.walls) :, 0:2], states[len(self.walls) :, 3:5]
        rings = zip(p.reshape(-1, MASSES, 2), v.reshape(-1, MASSES, 2), self._areas, strict=True)
        inner = [self._pulls(ring, speeds) + self._push(ring, area) for ring, speeds, area in rings]
        forces[len(self.walls) :] = np.concatenate(inner)
        if self.grip is not None:
            bead, place = self.grip
            x, y = self.world.position(bead)
            pull = GRIP * BEAD_MASS * MASSES
            forces[self.world.numbers.index(bead)] += pull * (place[0] - x), pull * (place[1] - y)
        return forces

    def _pulls(self, points: Any, velocities: Any) -> Any:
        """Return the forces of a body's springs; without the rule it has none."""
        forces = np.zeros((MASSES, 2))
        for stride in STRIDES:
            spring = 2 * RADIUS * math.sin(math.pi * stride / MASSES), STIFFNESS, DAMPING
            for first in range(stride):
                ring = points[first::stride], velocities[first::stride]
                forces[first::stride] += self.ask(ring_forces, *ring, *spring, otherwise=0.0)
        return forces

    def _push(self, points: Any, area: float) -> Any:
        """Return the forces of a body's gas; without the rules it has none."""
        if math.isnan(area):
            return 0.0
        return np.asarray(self.ask(pressure_forces, points, area, PRESSURE, otherwise=0.0))

    def _area(self, points: Any) -> float:
        """Return the area of a body, m^2; without the rule it is not known."""
        return float(self.ask(ring_area, points, otherwise=math.nan))

    def points(self) -> Any:
        """Return where the masses of all bodies are, m, shape (bodies, MASSES, 2)."""
        return self.world.states()[len(self.walls) :, 0:2].reshape(-1, MASSES, 2)

    def area_ratios(self) -> Any:
        """Return the areas of all bodies as parts of that at rest, shape (bodies,)."""
        return np.array([self._area(ring) for ring in self.points()]) / self._areas


def draw(game: SoftBody, picture: Picture, effects: ImpactEffects) -> None:
    """Draw ledges, skins, springs and masses."""
    for number in game.walls:
        picture.body(game.world.body(number), game.world.position(number), 0.0, WALL)
    for k, points in enumerate(game.points()):
        colour = COLOURS[k % len(COLOURS)]
        picture.polygon([(x, y) for x, y in points.tolist()], blend(colour, BACKGROUND, 0.6))
        inner = SPRINGS[MASSES:]
        picture.lines(points[inner[:, 0]], points[inner[:, 1]], blend(colour, BACKGROUND, 0.35))
        picture.discs(points, [BEAD] * MASSES, [colour] * MASSES)
        picture.text(f"{k + 1}", tuple(points.mean(axis=0)), size=NUMBER_SIZE)
    if game.grip is not None:
        bead, place = game.grip
        picture.line(game.world.position(bead), place, INK)


def readings(game: SoftBody) -> Readings:
    """Return areas and energy."""
    return [
        *[
            (f"area of body {k}", f"{100 * ratio:.1f} %")
            for k, ratio in enumerate(game.area_ratios().tolist(), start=1)
        ],
        ("kinetic energy", f"{game.world.kinetic_energy():.2f} J"),
    ]


PROGRAM = Program(
    name="soft_body",
    title="Soft bodies",
    game=SoftBody,
    draw=draw,
    readings=readings,
    keys=(
        ("drag", "pull at a body"),
        ("SPACE", "kick them all"),
        ("B   R", "one more   reset"),
    ),
    camera=Camera(left=0.0, bottom=0.0, scale=100.0),
    tour=((150, Input("press", "space")),),
    effects=lambda: ImpactEffects(
        sparks=Sparks(0.8, least_impulse=0.6), sounds=Sounds("rubber", 0.3, 1.0)
    ),
)
