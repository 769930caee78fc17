"""The asteroid field: varying masses, pieces that fly apart, a ship with thrust and recoil.

What matters is the ledger: the momentum of everything there is, and the momentum that exhaust,
spent shots and dust have carried away, always add up to the same. Both are drawn tip to tail, with
their sum beside them. Three waves are to be shot to dust with three lives.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from lesson_code.chapters.asteroids.rules import fire, split, wrap
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.geometry.shapes import Circle, Polygon
from lesson_code.view.pygame.effects import Flashes, Sparks
from lesson_code.view.pygame.game import Game, Input, numbers
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings, short
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import (
    BACKGROUND,
    INK,
    ORANGE,
    SKY,
    VERMILION,
    YELLOW,
    Colour,
    blend,
)

SIZE = (8.0, 6.0)
"""m: the field. What has left on one side comes back on the other."""

WAVES, LIVES, DENSITY = (6, 8, 10), 3, 30.0
"""Asteroids of each wave; lives; kg/m^2."""

SAFE_STEPS = 150
"""Steps after a hit, or the begin of a wave, in which the ship loses no life."""

CLEAR = 1.2
"""m around the ship, in which no asteroid of a wave begins."""

LEDGER_PLACE, LEDGER_SCALE = (1.6, 1.2), 0.05
"""m, where the arrows of the ledger begin; m for 1 kg m/s."""

AIMED = 0.06
"""rad: the pilot shoots when it is so near to its aim; a step turns the ship by as much."""

SMALLEST_SPLIT, PIECES = 0.26, 3
"""m, radius: a smaller asteroid bursts into dust; pieces of one that is larger."""

HEADINGS = 12
"""Directions that a burst is tried in; the one in which its pieces have most room is taken."""

BURST_SPEED = 1.2
"""m/s, of the pieces."""

ROCK = Material(restitution=0.9, friction=0.1)
SHIP_MASS, THRUST, TURN = 2.0, 8.0, 3.6
"""kg; N; rad/s."""

SHOT_MASS, SHOT_RADIUS, MUZZLE = 0.05, 0.05, 6.0
"""kg, m, m/s."""

SHOT_STEPS, RELOAD_STEPS = 60, 12
"""Steps that a shot flies, and between two shots."""

OUTLINE = ((0.28, 0.0), (-0.2, 0.17), (-0.2, -0.17))
"""m: the ship, its nose first."""

MOST_ROCKS = 60


@dataclass(frozen=True)
class Rules:
    """What a player may write for this field; see :mod:`lesson_code.chapters.asteroids.rules`."""

    split: Callable[..., Any] = split
    fire: Callable[..., Any] = fire


class Asteroids(Game):
    """A ship among asteroids."""

    def __init__(self, seed: int = 0, rules: Rules = Rules()) -> None:
        self._split, self._fire = rules.split, rules.fire
        super().__init__(seed)

    def reset(self) -> None:
        """Scatter the asteroids, and put the ship into the middle."""
        self.random.seed(self.seed)
        self.score = self.wave = self.safe_until = 0
        self.lives, self.plays_itself = LIVES, False
        self.carried_away = (0.0, 0.0)
        self._last_shot = -RELOAD_STEPS
        self.world = LiveWorld(callbacks=self.callbacks)
        self.ship = self.world.add(
            Body(
                Polygon(OUTLINE),
                position=(SIZE[0] / 2, SIZE[1] / 2),
                angle=math.pi / 2,
                mass=SHIP_MASS,
                material=ROCK,
            )
        )
        self.shots: dict[int, int] = {}  # number of the body: step at which it is spent
        self.struck: set[int] = set()
        self._begin_wave()

    def _begin_wave(self) -> None:
        """Scatter the asteroids of the next wave; what momentum they bring was outside before."""
        count, before = WAVES[self.wave], self.world.momentum()
        self.wave += 1
        self.safe_until = self.world.steps + SAFE_STEPS
        for k in range(count):
            turn = 2 * math.pi * k / count
            place = (SIZE[0] / 2 + 3.1 * math.cos(turn), SIZE[1] / 2 + 2.3 * math.sin(turn))
            heading, speed = self.random.uniform(0, 2 * math.pi), self.random.uniform(0.2, 0.9)
            radius = self.random.uniform(0.25, 0.55)
            velocity = speed * math.cos(heading), speed * math.sin(heading)
            if math.dist(place, self.world.position(self.ship)) > CLEAR or self.wave == 1:
                self._add_rock(place, radius, velocity)
        after = self.world.momentum()
        if self.wave > 1:
            self._carry_away((before[0] - after[0], before[1] - after[1]))

    @property
    def is_over(self) -> bool:
        """Whether all lives are lost, or all waves are dust."""
        return self.lives == 0 or (self.wave == len(WAVES) and not self.rocks)

    @property
    def notice(self) -> str:
        """What is not written yet, and what the end of the game was."""
        if not self.is_over:
            return super().notice
        return "All waves are dust: R plays again" if self.lives else "Game over: R plays again"

    @property
    def rocks(self) -> list[int]:
        """The numbers of the asteroids."""
        return [n for n in self.world.numbers if n != self.ship and n not in self.shots]

    def _add_rock(self, place: XY, radius: float, velocity: XY) -> int:
        """Add an asteroid."""
        return self.world.add(
            Body(
                Circle(radius),
                position=place,
                velocity=velocity,
                angular_velocity=self.random.uniform(-1, 1),
                mass=DENSITY * math.pi * radius**2,
                material=ROCK,
            )
        )

    def radius(self, number: int) -> float:
        """Return the radius of a body, m."""
        return self.world.body(number).shape.bounding_radius

    def mass(self, number: int) -> float:
        """Return the mass of a body, kg."""
        return self.world.body(number).mass or 0.0

    def press(self, key: str) -> None:
        """Shoot, or start again."""
        super().press(key)
        if key == "space" and not self.is_over:
            self.shoot()
        elif key == "a":
            self.plays_itself = not self.plays_itself

    def step(self) -> None:
        """Make one step: ship, impacts, bursts, edges."""
        if self.is_over:
            return
        self._steer()
        self.world.step()
        for rock in sorted(self.struck):
            self._burst(rock)
        self.struck.clear()
        for shot in [s for s, end in self.shots.items() if end <= self.world.steps]:
            self._spend(shot)
        for number in self.world.numbers:
            place = self.world.position(number)
            inside = wrap(place, SIZE, self.radius(number))
            if inside != place and self._is_free(number, inside):
                self.world.move(number, inside)
        if not self.rocks and not self.is_over:
            self._begin_wave()

    def _is_free(self, number: int, place: XY) -> bool:
        """Return whether a body would overlap no other one there; if not, it waits outside."""
        return all(
            math.dist(place, self.world.position(other)) > self.radius(number) + self.radius(other)
            for other in self.world.numbers
            if other != number
        )

    def _steer(self) -> None:
        """Turn the ship and push it; the exhaust carries the opposite momentum away."""
        way = ("left" in self.held) - ("right" in self.held) + 0.0
        if self.plays_itself:
            way = self._pilot()
        self.world.throw(self.ship, self.world.velocity(self.ship), TURN * way)
        if "up" in self.held:
            angle = self.world.angle(self.ship)
            push = THRUST * TIME_STEP
            impulse = push * math.cos(angle), push * math.sin(angle)
            self.world.push(self.ship, impulse)
            self._carry_away((-impulse[0], -impulse[1]))

    def _pilot(self) -> float:
        """Shoot at where the asteroid that comes first will be; return the turn towards that."""
        (x, y), (vx, vy) = self.world.position(self.ship), self.world.velocity(self.ship)
        aims = []
        for rock in self.rocks:
            (rx, ry), (ux, uy) = self.world.position(rock), self.world.velocity(rock)
            distance = math.dist((x, y), (rx, ry)) - self.radius(rock)
            closing = ((ux - vx) * (x - rx) + (uy - vy) * (y - ry)) / (distance + 1e-9)
            time = distance / MUZZLE
            aim = rx - x + (ux - vx) * time, ry - y + (uy - vy) * time
            aims.append((distance / max(closing, 0.1), math.atan2(aim[1], aim[0])))
        if not aims:
            return 0.0
        turn = min(aims)[1] - self.world.angle(self.ship)
        turn = math.remainder(turn, 2 * math.pi)
        if abs(turn) < AIMED:
            self.shoot()
        return min(max(turn / (TURN * TIME_STEP), -1.0), 1.0)

    def _carry_away(self, momentum: XY) -> None:
        """Note momentum that has left the field, kg m/s."""
        x, y = self.carried_away
        self.carried_away = x + momentum[0], y + momentum[1]

    def shoot(self) -> None:
        """Fire a shot ahead; the ship recoils. The shot's mass comes from the ship's stores."""
        if self.world.steps - self._last_shot < RELOAD_STEPS:
            return
        angle = self.world.angle(self.ship)
        velocity = self.world.velocity(self.ship)
        guns = SHIP_MASS, SHOT_MASS, MUZZLE, angle
        after = self.ask(self._fire, velocity, *guns, form=numbers(2, 2), otherwise=None)
        if after is None:
            return
        self._last_shot, (ship, shot) = self.world.steps, after
        # The stores are outside of the ledger: the shot's mass joins with the ship's velocity.
        self._carry_away((-SHOT_MASS * velocity[0], -SHOT_MASS * velocity[1]))
        self.world.throw(self.ship, (float(ship[0]), float(ship[1])))
        x, y = self.world.position(self.ship)
        nose = x + 0.38 * math.cos(angle), y + 0.38 * math.sin(angle)
        number = self.world.add(
            Body(
                Circle(SHOT_RADIUS),
                position=nose,
                velocity=(float(shot[0]), float(shot[1])),
                mass=SHOT_MASS,
                material=ROCK,
            )
        )
        self.shots[number] = self.world.steps + SHOT_STEPS

    def _spend(self, shot: int) -> None:
        """Take a shot out of the field, and note its momentum."""
        vx, vy = self.world.velocity(shot)
        self._carry_away((SHOT_MASS * vx, SHOT_MASS * vy))
        self.world.remove(shot)
        del self.shots[shot]

    def touched(self, touch: Touch) -> None:
        """Note which asteroid a shot strikes, and what strikes the ship."""
        pair = (touch.body_a, touch.body_b)
        for one, other in (pair, pair[::-1]):
            if one in self.shots and other != self.ship and other not in self.shots:
                self.struck.add(other)
                self.shots[one] = self.world.steps
            is_safe = self.world.steps < self.safe_until
            if one == self.ship and other not in self.shots and not is_safe:
                self.lives = max(self.lives - 1, 0)
                self.safe_until = self.world.steps + SAFE_STEPS

    def _burst(self, rock: int) -> None:
        """Split an asteroid into pieces of unequal mass, which keep mass and momentum."""
        self.score += 1
        if self.radius(rock) < SMALLEST_SPLIT:
            vx, vy = self.world.velocity(rock)
            self._carry_away((self.mass(rock) * vx, self.mass(rock) * vy))
            self.world.remove(rock)
            return
        if len(self.rocks) + PIECES > MOST_ROCKS:
            return
        place, velocity, mass = (
            self.world.position(rock),
            self.world.velocity(rock),
            self.mass(rock),
        )
        parts = [self.random.uniform(1.0, 2.0) for _ in range(PIECES)]
        masses = [mass * part / sum(parts) for part in parts]
        radii = [math.sqrt(m / DENSITY / math.pi) for m in masses]
        reach, drawn = self.radius(rock), self.random.uniform(0, 2 * math.pi)
        self.world.remove(rock)
        headings = [drawn + 2 * math.pi * k / HEADINGS for k in range(HEADINGS)]
        heading = min(headings, key=lambda h: self._overlap(around(place, reach, h), radii))
        burst = velocity, masses, BURST_SPEED, heading
        velocities = self.ask(
            self._split, *burst, form=numbers(PIECES, 2), otherwise=np.array([velocity] * PIECES)
        )
        places = around(place, reach, heading)
        for away, radius, v in zip(places, radii, velocities.tolist(), strict=True):
            self._add_rock(away, radius, (v[0], v[1]))

    def _overlap(self, places: list[XY], radii: list[float]) -> float:
        """Return by how much discs would overlap what there is, all together, m."""
        there = [(self.world.position(n), self.radius(n)) for n in self.world.numbers]
        return sum(
            max(radius + r - math.dist(place, other), 0.0)
            for place, radius in zip(places, radii, strict=True)
            for other, r in there
        )

    def ledger(self) -> XY:
        """Return what must not change: the momentum in the field, and what has left it, kg m/s."""
        (px, py), (ox, oy) = self.world.momentum(), self.carried_away
        return px + ox, py + oy


def around(place: XY, reach: float, heading: float) -> list[XY]:
    """Return where the pieces of an asteroid begin: evenly around its centre, m."""
    turns = [heading + 2 * math.pi * k / PIECES for k in range(PIECES)]
    return [(place[0] + reach * math.cos(t), place[1] + reach * math.sin(t)) for t in turns]


LIGHT = Mark("disc", SKY, "light asteroid")
HEAVY = Mark("disc", VERMILION, "heavy one; its mass in kg")
SHIP = Mark("area", YELLOW, "ship; darker: nothing harms it")
SHOT = Mark("disc", INK, "shot")
EXHAUST = Mark("arrow", ORANGE, "exhaust")
IN_FIELD = Mark("arrow", SKY, "momentum in the field")
CARRIED = Mark("arrow", ORANGE, "momentum carried away")
SUM = Mark("arrow", INK, "sum of both: it is kept")
LEGEND = (LIGHT, HEAVY, SHIP, SHOT, EXHAUST, IN_FIELD, CARRIED, SUM)


def rock_colour(mass: float) -> Colour:
    """Return the colour of an asteroid: the heavier, the more of vermilion."""
    return blend(LIGHT.colour, HEAVY.colour, min(mass / 25.0, 1.0))


def draw(game: Asteroids, picture: Picture, effects: ImpactEffects) -> None:
    """Draw asteroids with their masses, shots and ship."""
    for rock in game.rocks:
        x, y = game.world.position(rock)
        r, colour = game.radius(rock), effects.colour(rock, rock_colour(game.mass(rock)))
        picture.disc((x, y), r, colour, game.world.angle(rock))
        if r > 0.2 and 0 < x < SIZE[0] and 0 < y < SIZE[1]:
            picture.text(f"{game.mass(rock):.0f}", (x, y), colour=(20, 24, 30))
    for shot in game.shots:
        picture.disc(game.world.position(shot), SHOT_RADIUS, SHOT.colour)
    place, angle = game.world.position(game.ship), game.world.angle(game.ship)
    if "up" in game.held:
        tail = place[0] - 0.2 * math.cos(angle), place[1] - 0.2 * math.sin(angle)
        picture.arrow(tail, (-0.3 * math.cos(angle), -0.3 * math.sin(angle)), EXHAUST.colour, 5.0)
    is_safe = game.world.steps < game.safe_until
    colour = effects.colour(
        game.ship, blend(SHIP.colour, BACKGROUND, 0.5) if is_safe else SHIP.colour
    )
    picture.body(game.world.body(game.ship), place, angle, colour)
    _draw_ledger(game, picture)


def _draw_ledger(game: Asteroids, picture: Picture) -> None:
    """Draw the momentum in the field and what was carried away tip to tail, and their sum."""
    lx, ly = game.ledger()
    picture.arrow(LEDGER_PLACE, (LEDGER_SCALE * lx, LEDGER_SCALE * ly), SUM.colour, 5.0)
    x, y = LEDGER_PLACE
    parts = (game.world.momentum(), IN_FIELD.colour), (game.carried_away, CARRIED.colour)
    for (px, py), colour in parts:
        picture.arrow((x, y), (LEDGER_SCALE * px, LEDGER_SCALE * py), colour)
        x, y = x + LEDGER_SCALE * px, y + LEDGER_SCALE * py


def readings(game: Asteroids) -> Readings:
    """Return counts, momentum and the ledger."""
    (px, py), (ox, oy) = game.world.momentum(), game.carried_away
    lx, ly = game.ledger()
    return [
        ("wave", f"{game.wave} of {len(WAVES)}"),
        ("lives", f"{game.lives}"),
        ("asteroids", f"{len(game.rocks)}"),
        ("hits", f"{game.score}"),
        ("kinetic energy", f"{short(game.world.kinetic_energy())} J"),
        ("momentum, kg m/s:", ""),
        ("in the field, blue", f"({short(px)}, {short(py)})"),
        ("carried away, orange", f"({short(ox)}, {short(oy)})"),
        ("sum, white: kept", f"({short(lx)}, {short(ly)})"),
    ]


PROGRAM = Program(
    name="asteroids",
    title="Asteroid field",
    own=(split, fire),
    with_own=lambda *own: {"rules": Rules(*own)},
    game=Asteroids,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("left right", "turn"),
        ("up", "thrust"),
        ("SPACE", "shoot"),
        ("A", "it plays itself"),
    ),
    forbids={
        "grab": "the ship and its shots move everything",
        "gravity": "the field is far from any star",
        "mass": "masses are in the ledger",
    },
    camera=Camera(left=0.0, bottom=0.0, scale=100.0),
    tour=(
        (0, Input("press", "right")),
        (20, Input("release", "right")),
        (30, Input("press", "space")),
        (50, Input("press", "space")),
        (60, Input("press", "up")),
        (90, Input("release", "up")),
        (110, Input("press", "space")),
        (130, Input("press", "a")),
    ),
    effects=lambda: ImpactEffects(
        Flashes(least_impulse=0.2), Sparks(least_impulse=1.0), sounds=Sounds("stone", 0.6, 20.0)
    ),
)
