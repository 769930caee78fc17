"""Soft bodies: rings of masses and springs, with pressure inside, that fall on one another.

Springs and gas give each mass its force, contacts its impulses (:mod:`contacts`). What springs and
gas store is told beside what moves: all that is lost goes into damping, friction and impacts.
"""

from __future__ import annotations

import math
from collections import deque
from typing import Any

import numpy as np

from lesson_code.chapters.soft_body.contacts import (
    MARGIN,
    Contacts,
    Ledge,
    Skins,
    push_out,
    resolve,
    walls_at,
)
from lesson_code.chapters.soft_body.rules import pressure_forces, ring_area, ring_forces
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.view.pygame.effects import Sparks
from lesson_code.view.pygame.game import Game, Input, numbers
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.panel import Panel
from lesson_code.view.pygame.picture import WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings, room
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

STIFFNESS, DAMPING, PRESSURE = 110.0, 1.0, 120.0
"""N/m, N s/m and N/m."""

SUBSTEPS = 4
"""Of a step: the fastest springs swing at 115 1/s, half a radian in each."""

AIR = 0.15
"""1/s, damping of all motion."""

FALL = (0.0, -9.81)
"""m/s^2, and the material of all bodies: as a slider finds them."""

RUBBER = Material(restitution=0.0, friction=0.5)
LEDGES = (Ledge((0.0, 0.9), (2.2, 0.5), 0.1), Ledge((6.0, 0.7), (8.0, 0.7), 0.1))
PLACES: tuple[XY, ...] = ((2.4, 4.6), (4.3, 3.2), (5.9, 4.9))
COLOURS: tuple[Colour, ...] = (SKY, ORANGE, GREEN, PURPLE, YELLOW)
MOST_BODIES = len(COLOURS)
HISTORY = 240
"""Steps that the curve shows: four seconds."""

NUMBER_SIZE = 34
"""px: height of a body's number, as the panel counts them."""

GRIP, LONGEST_GRIP = 30.0, 2.0
"""1/s^2: how hard the mouse pulls, for 1 kg and 1 m; and m, where it pulls no harder."""

HEARD = 0.02
"""N s: a softer impact of two bodies in a step is none."""

STRIDES = (1, 3, 5)
"""Springs tie a mass to the next one, the third and the fifth: none of these divides 16, so that
the masses in steps of each make one ring again."""

ORDERS = {stride: stride * np.arange(MASSES) % MASSES for stride in STRIDES}
"""The masses of each of these rings."""

EACH = numbers(MASSES, 2)
"""What a rule gives for each mass of a ring."""

SPRINGS = np.array([(k, (k + stride) % MASSES) for stride in STRIDES for k in range(MASSES)])
"""The masses that each spring of a body ties."""


class SoftBody(Game):
    """Some soft bodies between a floor, a step and a slope."""

    def reset(self) -> None:
        """Put the bodies back to where they fall from."""
        self.rings: list[list[int]] = []  # the numbers of their masses
        self._areas: list[float] = []
        self.grip: tuple[int, XY] | None = None
        self.steps = 0
        self.history: deque[tuple[float, ...]] = deque(maxlen=HISTORY)
        walls = [Body(Segment(ledge.start, ledge.end, ledge.radius)) for ledge in LEDGES]
        self.world = LiveWorld(room(0, 0, WIDTH, HEIGHT, RUBBER) + walls, gravity=FALL)
        self.walls = self.world.numbers
        self._skins = Skins(MASSES, BEAD, LEDGES)
        self._p, self._v = np.empty((0, 2)), np.empty((0, 2))
        self._touching: set[tuple[int, int]] = set()
        for place in PLACES:
            self.add_ring(place)

    def add_ring(self, place: XY) -> None:
        """Add a soft body, round and at rest."""
        turns = [2 * math.pi * k / MASSES for k in range(MASSES)]
        points = np.array([(math.cos(t), math.sin(t)) for t in turns]) * RADIUS + place
        beads = [
            self.world.add(Body(Circle(BEAD), position=(x, y), mass=BEAD_MASS, material=RUBBER))
            for x, y in points.tolist()
        ]
        self._p = np.concatenate((self._p, points))
        self._v = np.concatenate((self._v, np.zeros((MASSES, 2))))
        self._areas.append(self._area(points))
        self.rings.append(beads)

    def press(self, key: str) -> None:
        """Start again, add a body, or kick them all."""
        super().press(key)
        if key == "b" and len(self.rings) < MOST_BODIES and self._has_room_above():
            self.add_ring((WIDTH / 2, HEIGHT - 1.0))
        elif key == "space":
            for k in range(len(self.rings)):
                kick = self.random.uniform(-2, 2), self.random.uniform(2, 5)
                self._v[k * MASSES : (k + 1) * MASSES] += kick
            self._show()

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

    grab, pull, put, drop = down, drag, drag, let_go
    """The right button holds a mass as the left one does: a hand on the world would hold a copy."""

    def step(self) -> None:
        """Make one step: forces, contacts, motion, in short parts."""
        h, pushes = TIME_STEP / SUBSTEPS, np.zeros((len(self._p), len(self.rings) + 1))
        for _ in range(SUBSTEPS):
            self._v += h * (self.forces() / BEAD_MASS + self.gravity)
            self._v *= math.exp(-AIR * h)
            reach = MARGIN + 2 * h * float(np.hypot(*self._v.T).max())
            contacts = self._skins.contacts(self._p, reach)
            walls = walls_at(self._p, (WIDTH, HEIGHT), BEAD, h)
            impulses = resolve(contacts, self._v, walls, BEAD_MASS, self.friction, h)
            self._p += h * self._v
            push_out(contacts, self._p)
            self._note(contacts, impulses, pushes)
        self.steps += 1
        self._show()
        self._tell(pushes)
        self.history.append(self.energies())

    def _show(self) -> None:
        """Put the bodies of the world where the masses are."""
        beads = [bead for ring in self.rings for bead in ring]
        for bead, place, velocity in zip(beads, self._p.tolist(), self._v.tolist(), strict=True):
            self.world.move(bead, (place[0], place[1]))
            self.world.throw(bead, (velocity[0], velocity[1]))

    def _note(self, contacts: Contacts, impulses: Any, pushes: Any) -> None:
        """Add up what each mass gets from each body, N s; in the last column: from a ledge."""
        is_skin = contacts.shares[:, 1:].any(axis=1)
        other = np.where(is_skin, contacts.masses[:, 1] // MASSES, len(self.rings))
        np.add.at(pushes, (contacts.masses[:, 0], other), impulses)

    def _tell(self, pushes: Any) -> None:
        """Tell of bodies that have begun to touch: once for each two."""
        by_ring = pushes.reshape(len(self.rings), MASSES, -1)
        before, self._touching = self._touching, set()
        for a, b in zip(*np.nonzero(by_ring.sum(axis=1) > 0.0), strict=True):
            self._touching.add((int(a), int(b)))
            impulse = float(by_ring[a, :, b].sum())
            if (a, b) not in before and impulse > HEARD:
                mass = int(by_ring[a, :, b].argmax())
                other = self.rings[b][0] if b < len(self.rings) else self.walls[-1]
                self._hear(self._touch(self.rings[a][mass], other, impulse))

    def _touch(self, bead: int, other: int, impulse: float) -> Touch:
        """Return what effects and sound hear of an impact."""
        return Touch(
            time=self.steps * TIME_STEP,
            body_a=other,
            body_b=bead,
            normal=(0.0, 1.0),
            points=(self.world.position(bead),),
            penetration=0.0,
            restitution=0.0,
            friction=self.friction,
            normal_impulse=impulse,
        )

    def forces(self) -> Any:
        """Return what springs, pressure and the mouse do to every mass, N, shape (N, 2)."""
        rings = zip(
            self._p.reshape(-1, MASSES, 2),
            self._v.reshape(-1, MASSES, 2),
            self._areas,
            strict=True,
        )
        inner = [self._pulls(ring, speeds) + self._push(ring, area) for ring, speeds, area in rings]
        forces = np.concatenate(inner)
        if self.grip is not None:
            bead, place = self.grip
            k = bead - len(self.walls)
            way = np.subtract(place, self._p[k])
            longer = max(float(np.hypot(*way)) / LONGEST_GRIP, 1.0)
            forces[k] += GRIP * BEAD_MASS * MASSES * way / longer
        return forces

    def _pulls(self, points: Any, velocities: Any) -> Any:
        """Return the forces of a body's springs; without the rule it has none."""
        forces = np.zeros((MASSES, 2))
        for stride, order in ORDERS.items():
            spring = rest_length(stride), STIFFNESS, DAMPING
            ring = points[order], velocities[order]
            forces[order] += self.ask(ring_forces, *ring, *spring, form=EACH, otherwise=0.0)
        return forces

    def _push(self, points: Any, area: float) -> Any:
        """Return the forces of a body's gas; without the rules it has none."""
        if math.isnan(area):
            return 0.0
        return self.ask(pressure_forces, points, area, PRESSURE, form=EACH, otherwise=0.0)

    def _area(self, points: Any) -> float:
        """Return the area of a body, m^2; without the rule it is not known."""
        return self.ask_number(ring_area, points, otherwise=math.nan)

    @property
    def friction(self) -> float:
        """Coefficient of friction of all contacts."""
        return self.world.body(self.rings[0][0]).material.friction or 0.0

    def points(self) -> Any:
        """Return where the masses of all bodies are, m, shape (bodies, MASSES, 2)."""
        return self._p.reshape(-1, MASSES, 2)

    def area_ratios(self) -> Any:
        """Return the areas of all bodies as parts of that at rest, shape (bodies,)."""
        return np.array([self._area(ring) for ring in self.points()]) / self._areas

    def pressures(self) -> Any:
        """Return the pressure in each body above that outside, N/m, shape (bodies,)."""
        return PRESSURE * (1 / self.area_ratios() - 1)

    def gaps(self) -> Any:
        """Return how far each mass and each end of a ledge is from each body's skin, m."""
        return self._skins.gaps(self._p)

    def energies(self) -> tuple[float, float, float, float]:
        """Return the energy of motion, height, springs and gas, J.

        That of the gas is the work against it, from its area A0 at rest to A:
        S (A - A0 - A0 ln(A / A0)), with S its stiffness.
        """
        stored = 0.0
        for stride in STRIDES:
            along = np.roll(self.points(), -stride, axis=1) - self.points()
            longer = np.hypot(along[..., 0], along[..., 1]) - rest_length(stride)
            stored += STIFFNESS * float((longer**2).sum()) / 2
        ratios, areas = self.area_ratios(), np.array(self._areas)
        gas = PRESSURE * areas * (ratios - 1 - np.log(np.maximum(ratios, 1e-9)))
        return (
            BEAD_MASS * float((self._v**2).sum()) / 2,
            -BEAD_MASS * self.gravity[1] * float((self._p[:, 1] - BEAD).sum()),
            stored,
            float(np.nan_to_num(gas).sum()),
        )


def rest_length(stride: int) -> float:
    """Return the length at rest of a spring that ties masses so many places apart, m."""
    return 2 * RADIUS * math.sin(math.pi * stride / MASSES)


MASS = Mark("disc", SKY, "mass: a colour for each body")
GAS = Mark("area", blend(SKY, BACKGROUND, 0.6), "gas inside, and its pressure")
SPRING = Mark("line", blend(SKY, BACKGROUND, 0.35), "spring")
PULL = Mark("line", INK, "pull of the mouse")
ENERGY = Mark("line", ORANGE, "curve: all of the energy")
LEGEND = (MASS, GAS, SPRING, PULL, ENERGY)


def draw(game: SoftBody, picture: Picture, effects: ImpactEffects) -> None:
    """Draw ledges, skins, springs and masses."""
    for number in game.walls:
        picture.body(game.world.body(number), game.world.position(number), 0.0, WALL)
    pressures = np.nan_to_num(game.pressures()).tolist()
    for k, points in enumerate(game.points()):
        colour = COLOURS[k % len(COLOURS)]
        picture.polygon([(x, y) for x, y in points.tolist()], blend(colour, BACKGROUND, 0.6))
        inner = SPRINGS[MASSES:]
        picture.lines(points[inner[:, 0]], points[inner[:, 1]], blend(colour, BACKGROUND, 0.35))
        picture.discs(points, [BEAD] * MASSES, [colour] * MASSES)
        x, y = points.mean(axis=0).tolist()
        picture.text(f"{k + 1}", (x, y + 0.12), size=NUMBER_SIZE)
        picture.text(f"{pressures[k]:+.1f} N/m", (x, y - 0.16))
    if game.grip is not None:
        bead, place = game.grip
        picture.line(game.world.position(bead), place, PULL.colour)


def readings(game: SoftBody) -> Readings:
    """Return areas, and energy in its parts."""
    names = ("of motion", "of height", "in springs", "in gas")
    energies = game.energies()
    return [
        *[
            (f"area of body {k}", f"{100 * ratio:.1f} %")
            for k, ratio in enumerate(game.area_ratios().tolist(), start=1)
        ],
        *[(f"energy {name}", f"{e:.2f} J") for name, e in zip(names, energies, strict=True)],
        ("sum", f"{sum(energies):.2f} J"),
    ]


def more(game: SoftBody, panel: Panel) -> None:
    """Draw the history of the whole energy."""
    panel.curve("energy, 4 s", [sum(parts) for parts in game.history], ENERGY.colour)


PROGRAM = Program(
    name="soft_body",
    title="Soft bodies",
    game=SoftBody,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    more=more,
    keys=(
        ("drag", "pull at a body"),
        ("SPACE", "kick them all"),
        ("B", "one more"),
    ),
    forbids={"restitution": "soft bodies give way: nothing bounces", "mass": "all weigh the same"},
    camera=Camera(left=0.0, bottom=0.0, scale=100.0),
    tour=(
        (150, Input("press", "space")),
        (360, Input("press", "b")),
        (480, Input("press", "space")),
        (660, Input("down", place=(4.0, 1.0))),
        (670, Input("move", place=(4.0, 4.5))),
        (800, Input("up", place=(4.0, 4.5))),
        (960, Input("press", "space")),
    ),
    effects=lambda: ImpactEffects(
        sparks=Sparks(0.8, least_impulse=0.6), sounds=Sounds("rubber", 0.3, 1.0)
    ),
)
