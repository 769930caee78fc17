"""Pool: a cue that can give spin, cushions with friction, six pockets.

Seen from above. Spin is about the vertical axis: it does nothing to the cloth, but a cushion's
friction turns it into motion along the cushion.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from lesson_code.chapters.pool.rules import rack, roll, strike
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.formulas import disc_inertia
from lesson_code.geometry import time_of_impact
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.view.pygame.effects import Flashes, Trails
from lesson_code.view.pygame.picture import COLOURS, Camera, Picture
from lesson_code.view.pygame.program import Game, ImpactEffects, Input, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import INK, ORANGE, SKY, Colour, blend

LENGTH, WIDTH = 2.54, 1.27
"""m: the cloth of a table of nine feet."""

RADIUS, MASS = 0.0286, 0.17
"""m and kg, of a ball."""

BALL = Material(restitution=0.95, friction=0.06)
CUSHION = Material(restitution=0.75, friction=0.6)
"""Two balls: e 0.95, mu 0.06. A ball and a cushion: e 0.75, mu 0.19."""

GAP = 1e-4
"""m between the balls of the rack."""

MOUTH, CAPTURE = 0.075, 0.062
"""m: from a pocket's centre to the cushions' ends; how near a ball's centre falls in."""

NOSE = 0.02
"""m: half thickness of the cushions' line."""

SWEEPS = 40
"""Over the contacts: after 10 a break is off its mirror image by 2 mm after half a second, after
40 by nothing that can be seen."""

HEAD, FOOT = (0.25 * LENGTH, WIDTH / 2), (0.72 * LENGTH, WIDTH / 2)
"""m: where the cue ball and the apex of the rack lie."""

IMPULSE_RATE, LARGEST_IMPULSE = 2.0, 1.4
"""N s for a drag of 1 m, and N s at the most: 8.2 m/s, a hard break."""

OFFSET_STEP, LARGEST_OFFSET = 0.1, 0.5
"""Of the radius: beyond half of it a cue slips off."""

CLOTH: Colour = (18, 84, 78)
RAIL: Colour = (92, 62, 44)
HOLE: Colour = (8, 10, 12)

POCKETS = tuple((x, y) for y in (0.0, WIDTH) for x in (0.0, LENGTH / 2, LENGTH))
REST_SPEED = 1e-3
"""m/s: slower than a ball's width in a minute counts as at rest."""


@dataclass(frozen=True)
class Rules:
    """What a player may write for this table; see :mod:`lesson_code.chapters.pool.rules`."""

    rack: Callable[..., Any] = rack
    strike: Callable[..., Any] = strike


class Pool(Game):
    """Fifteen balls in a rack, and a cue ball."""

    def __init__(self, seed: int = 0, rules: Rules = Rules()) -> None:
        self._rack, self._strike = rules.rack, rules.strike
        super().__init__(seed)

    def reset(self) -> None:
        """Set up the rack."""
        self.offset = 0.0
        self.aim: XY | None = None
        self.potted: list[int] = []
        self.strokes = self.fouls = 0
        places = [HEAD, *self.ask(self._rack, FOOT, RADIUS, GAP, otherwise=())]
        self.world = LiveWorld(
            [self._ball(place) for place in places] + cushions(),
            iterations=SWEEPS,
            callbacks=self.callbacks,
        )
        self.cue = 0

    def _ball(self, place: XY) -> Body:
        """Return a ball at rest: a solid sphere, which is easier to turn than a disc."""
        inertia = 0.8 * disc_inertia(MASS, RADIUS)
        return Body(Circle(RADIUS), position=place, mass=MASS, inertia=inertia, material=BALL)

    @property
    def balls(self) -> list[int]:
        """The numbers of the balls on the table; the cue ball's is 0, or a new one after a foul."""
        return [number for number, body in self.world.items() if not body.is_static]

    @property
    def is_at_rest(self) -> bool:
        """Whether every ball lies still."""
        return all(math.hypot(*self.world.velocity(ball)) < REST_SPEED for ball in self.balls)

    def press(self, key: str) -> None:
        """Move the cue's tip to one side, or set up the rack."""
        super().press(key)
        if key in ("left", "right"):
            side = OFFSET_STEP if key == "left" else -OFFSET_STEP
            wanted = round(self.offset + side, 2)
            self.offset = min(max(wanted, -LARGEST_OFFSET), LARGEST_OFFSET)

    def down(self, place: XY) -> None:
        """Begin to aim, once all balls lie still."""
        if self.is_at_rest:
            self.aim = place

    def drag(self, place: XY) -> None:
        """Aim: the cue lies where the mouse is, and points at the ball."""
        if self.aim is not None:
            self.aim = place

    def let_go(self, place: XY) -> None:
        """Strike."""
        if self.aim is None:
            return
        self.aim = place
        impulse = self.impulse()
        self.aim = None
        if math.hypot(*impulse) > 0:
            self.strike(impulse)

    def impulse(self) -> XY:
        """Return the impulse that the cue would give now, N s: the farther back, the more."""
        if self.aim is None:
            return 0.0, 0.0
        x, y = self.world.position(self.cue)
        back = x - self.aim[0], y - self.aim[1]
        drawn = math.hypot(*back)
        if drawn <= RADIUS:
            return 0.0, 0.0
        size = min(IMPULSE_RATE * drawn, LARGEST_IMPULSE) / drawn
        return back[0] * size, back[1] * size

    def strike(self, impulse: XY) -> None:
        """Strike the cue ball."""
        stroke = impulse, self.offset * RADIUS, MASS, RADIUS
        after = self.ask(self._strike, *stroke, otherwise=None)
        if after is not None:
            self.world.throw(self.cue, *after)
            self.strokes += 1

    def step(self) -> None:
        """Make one step: impacts, cloth, pockets."""
        self.world.step()
        for ball in self.balls:
            velocity, spin = self.world.velocity(ball), self.world.spin(ball)
            self.world.throw(ball, *roll(velocity, spin, RADIUS, TIME_STEP))
        for ball in self.balls:
            if is_in_pocket(self.world.position(ball)):
                self._pot(ball)

    def _pot(self, ball: int) -> None:
        """Take a ball off the table; the cue ball comes back, and that is a foul."""
        self.world.remove(ball)
        if ball != self.cue:
            self.potted.append(ball)
            return
        self.fouls += 1
        self.aim = None
        place = HEAD
        while any(math.dist(place, self.world.position(b)) < 2 * RADIUS for b in self.balls):
            place = (place[0], place[1] + RADIUS)  # the next place that is free
        self.cue = self.world.add(self._ball(place))

    def trailed(self) -> dict[int, XY]:
        """Return where the balls are that move: each leaves a trail."""
        moving = [b for b in self.balls if math.hypot(*self.world.velocity(b)) > 0.1]
        return {ball: self.world.position(ball) for ball in moving}

    def first_hit(self) -> tuple[XY, XY | None]:
        """Return where the cue ball's centre would be at its first impact with a ball, and whose.

        Without one: 0.5 m on, and None.
        """
        impulse = self.impulse()
        size = math.hypot(*impulse) or 1.0
        heading = (impulse[0] / size, impulse[1] / size)
        start = self.world.position(self.cue)
        best, target = 0.5, None
        disc, still = Circle(RADIUS), (0, 0, 0)
        for ball in self.balls:
            if ball != self.cue:
                place = self.world.position(ball)
                met = time_of_impact(
                    disc, (*start, 0), (*heading, 0), disc, (*place, 0), still, 3.0
                )
                if met is not None and (target is None or met < best):
                    best, target = met, place
        return (start[0] + best * heading[0], start[1] + best * heading[1]), target


def cushions() -> list[Body]:
    """Return the six cushions, and behind the pockets a wall that nothing passes."""
    ends = []
    for y in (-NOSE, WIDTH + NOSE):
        ends.append(((MOUTH, y), (LENGTH / 2 - MOUTH, y)))
        ends.append(((LENGTH / 2 + MOUTH, y), (LENGTH - MOUTH, y)))
    ends += [((x, MOUTH), (x, WIDTH - MOUTH)) for x in (-NOSE, LENGTH + NOSE)]
    far = 0.3
    corners = [(-far, -far), (LENGTH + far, -far), (LENGTH + far, WIDTH + far), (-far, WIDTH + far)]
    outer = list(zip(corners, corners[1:] + corners[:1], strict=True))
    return [Body(Segment(a, b, NOSE), material=CUSHION) for a, b in ends] + [
        Body(Segment(a, b, 0.1), material=CUSHION) for a, b in outer
    ]


def is_in_pocket(place: XY) -> bool:
    """Return whether a ball at a place falls: near a pocket, or already off the cloth."""
    x, y = place
    off = not (-RADIUS < x < LENGTH + RADIUS and -RADIUS < y < WIDTH + RADIUS)
    return off or any(math.dist(place, pocket) < CAPTURE for pocket in POCKETS)


def ball_colour(number: int) -> Colour:
    """Return the colour of a ball: the cue ball white, 8 black, 1 to 7 and 9 to 15 in turn."""
    if number == 8:
        return HOLE
    return INK if number == 0 or number > 15 else COLOURS[(number - 1) % 8]


def draw(game: Pool, picture: Picture, effects: ImpactEffects) -> None:
    """Draw the table, the balls and the cue."""
    _draw_table(picture)
    if effects.trails is not None:
        effects.trails.draw(picture, INK, CLOTH)
    for ball in game.balls:
        place = game.world.position(ball)
        _draw_ball(picture, place, ball, effects.colour(ball, ball_colour(ball)))
    _draw_potted(game, picture)
    if game.aim is not None:
        _draw_cue(game, picture)
    elif game.is_at_rest:
        picture.ring(game.world.position(game.cue), 1.6 * RADIUS, ORANGE)


def _draw_ball(picture: Picture, place: XY, number: int, colour: Colour) -> None:
    """Draw a ball; from 8 on it has a white middle."""
    picture.disc(place, RADIUS, colour)
    if 8 <= number <= 15:
        picture.disc(place, 0.5 * RADIUS, INK)


def _draw_table(picture: Picture) -> None:
    """Draw rail, cloth and pockets."""
    for grow, colour in ((0.09, RAIL), (0.0, CLOTH)):
        low, high = -grow, WIDTH + grow
        picture.polygon(
            [(low, low), (LENGTH + grow, low), (LENGTH + grow, high), (low, high)], colour
        )
    for pocket in POCKETS:
        picture.disc(pocket, 0.058, HOLE)


def _draw_potted(game: Pool, picture: Picture) -> None:
    """Draw the potted balls in a row below the table."""
    for k, ball in enumerate(game.potted):
        _draw_ball(picture, (0.1 + 0.08 * k, -0.22), ball, ball_colour(ball))


def _draw_cue(game: Pool, picture: Picture) -> None:
    """Draw the cue, its line, and the ball as it would be at its first impact."""
    impulse = game.impulse()
    size = math.hypot(*impulse)
    if size == 0:
        return
    ux, uy = impulse[0] / size, impulse[1] / size
    x, y = game.world.position(game.cue)
    side = game.offset * RADIUS
    back = RADIUS + 0.02 + 0.12 * size
    tip = (x - back * ux - side * uy, y - back * uy + side * ux)
    picture.capsule(tip, (tip[0] - 0.6 * ux, tip[1] - 0.6 * uy), 0.008, ORANGE)
    ghost, target = game.first_hit()
    picture.line((x, y), ghost, blend(CLOTH, INK, 0.6))
    picture.ring(ghost, RADIUS, INK, 1)
    if target is not None:
        away = (target[0] - ghost[0]) / (2 * RADIUS), (target[1] - ghost[1]) / (2 * RADIUS)
        picture.arrow(target, (0.2 * away[0], 0.2 * away[1]), SKY, 2.0)


def readings(game: Pool) -> Readings:
    """Return strokes, fouls, spin and speed."""
    side = "left" if game.offset > 0 else "right"
    offset = f"{abs(game.offset):.1f} r {side}" if game.offset else "centre"
    return [
        ("potted", f"{len(game.potted)} of 15"),
        ("strokes   fouls", f"{game.strokes}   {game.fouls}"),
        ("cue hits", offset),
        ("cue ball", f"{math.hypot(*game.world.velocity(game.cue)):.2f} m/s"),
        ("its spin", f"{game.world.spin(game.cue) + 0.0:.1f} rad/s"),
        ("kinetic energy", f"{game.world.kinetic_energy():.2f} J"),
    ]


PROGRAM = Program(
    name="pool",
    title="Pool",
    own=(rack, strike),
    with_own=lambda *own: {"rules": Rules(*own)},
    game=Pool,
    draw=draw,
    readings=readings,
    keys=(
        ("drag", "aim and strike: pull back"),
        ("left right", "hit off centre: spin"),
    ),
    forbids={
        "grab": "the cue alone moves a ball",
        "gravity": "the table is seen from above",
        "mass": "all balls weigh the same",
    },
    camera=Camera(left=-0.115, bottom=-0.41, scale=289.0),
    tour=(
        (0, Input("down", place=(0.0, HEAD[1]))),
        (40, Input("up", place=(0.0, HEAD[1]))),
    ),
    effects=lambda: ImpactEffects(
        Flashes(least_impulse=0.02), trails=Trails(), sounds=Sounds("ivory", 0.06, 0.6)
    ),
)
