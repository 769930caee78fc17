"""Pool: a cue that can give spin, cushions with friction, six pockets.

Seen from above. Spin is about the vertical axis: it does nothing to the cloth, but a cushion's
friction turns it into motion along the cushion.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from lesson_code.chapters.pool.eight_ball import EIGHT, Match, Shot, judge
from lesson_code.chapters.pool.pilot import stroke
from lesson_code.chapters.pool.rules import rack, roll, strike
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.formulas import disc_inertia
from lesson_code.geometry import time_of_impact
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.view.pygame.effects import Flashes, Trails
from lesson_code.view.pygame.game import Game, Input, numbers
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import COLOURS, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
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

PLACES = (1, 9, 2, 10, 8, 3, 11, 4, 12, 5, 6, 13, 14, 7, 15)
"""The balls in the rack, row by row: the 8 in the middle, and two kinds in the far corners."""

PLAYERS = ("first player", "second player")
PAUSE_STEPS = 40
"""Steps at rest before the pilot strikes."""

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
        self.match, self.plays_itself, self.is_in_hand = Match(), False, False
        self._moves_cue, self._rested = False, 0
        self._labels = dict(enumerate(PLACES, start=1))
        rack = self.ask(self._rack, FOOT, RADIUS, GAP, form=numbers(-1, 2), otherwise=())
        places = [HEAD, *((float(x), float(y)) for x, y in rack)]
        self.world = LiveWorld(
            [self._ball(place) for place in places] + cushions(),
            callbacks=self.callbacks,
        )
        self.cue = 0
        self._begin_stroke()
        self.in_play = False

    def _begin_stroke(self) -> None:
        """Forget the last stroke."""
        self.in_play = True
        self._first: int | None = None
        self._cushion = self._scratch = False
        self._fallen: list[int] = []
        self._left = [self.label(ball) for ball in self.balls if self.label(ball)]

    def label(self, ball: int) -> int:
        """Return the number that is on a ball: 0 for the cue ball."""
        return self._labels.get(ball, 0)

    @property
    def notice(self) -> str:
        """What is not written yet, and who has won."""
        if self.match.winner is None:
            return super().notice
        return f"The {PLAYERS[self.match.winner]} has won: R sets up a new rack"

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
        if key == "a":
            self.plays_itself = not self.plays_itself
        if key in ("left", "right"):
            side = OFFSET_STEP if key == "left" else -OFFSET_STEP
            wanted = round(self.offset + side, 2)
            self.offset = min(max(wanted, -LARGEST_OFFSET), LARGEST_OFFSET)

    def down(self, place: XY) -> None:
        """Begin to aim, once all balls lie still; after a foul a press on the cue ball takes it."""
        if not self.is_at_rest or self.match.winner is not None:
            return
        cue = self.world.position(self.cue)
        if self.is_in_hand and math.dist(place, cue) < 1.5 * RADIUS:
            self._moves_cue = True
        else:
            self.aim = place

    def drag(self, place: XY) -> None:
        """Aim: the cue lies where the mouse is, and points at the ball."""
        if self._moves_cue:
            self._put_cue(place)
        elif self.aim is not None:
            self.aim = place

    def _put_cue(self, place: XY) -> None:
        """Put the cue ball where there is room."""
        x = min(max(place[0], RADIUS), LENGTH - RADIUS)
        y = min(max(place[1], RADIUS), WIDTH - RADIUS)
        others = [self.world.position(ball) for ball in self.balls if ball != self.cue]
        is_free = all(math.dist((x, y), other) > 2 * RADIUS + GAP for other in others)
        if is_free and not is_in_pocket((x, y)):
            self.world.move(self.cue, (x, y))

    def let_go(self, place: XY) -> None:
        """Strike."""
        self._moves_cue = False
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
        cue = impulse, self.offset * RADIUS, MASS, RADIUS
        after = self.ask(self._strike, *cue, form=_struck, otherwise=None)
        if after is not None:
            self._begin_stroke()
            self.world.throw(self.cue, *after)
            self.strokes += 1
            self.is_in_hand = False

    def step(self) -> None:
        """Make one step: impacts, cloth, pockets."""
        self.world.step()
        for ball in self.balls:
            velocity, spin = self.world.velocity(ball), self.world.spin(ball)
            self.world.throw(ball, *roll(velocity, spin, RADIUS, TIME_STEP))
        for ball in self.balls:
            if is_in_pocket(self.world.position(ball)):
                self._pot(ball)
        if self.in_play and self.is_at_rest:
            self._judge()
        self._rested = self._rested + 1 if self.is_at_rest else 0
        if self.plays_itself and self._rested > PAUSE_STEPS and self.match.winner is None:
            self._rested = 0
            self.offset = 0.0
            self.strike(self._pilot())

    def _judge(self) -> None:
        """Apply the rules of eight-ball to the stroke that is over."""
        self.in_play = False
        was_break = self.match.is_break
        shot = Shot(self._first, tuple(self._fallen), self._scratch, self._cushion)
        self.match = judge(self.match, shot, self._left)
        if was_break and EIGHT in self._fallen:
            self.potted = [ball for ball in self.potted if self.label(ball) != EIGHT]
            self._labels[self.world.add(self._ball(self._free_place(FOOT)))] = EIGHT
        if self.match.foul:
            self.fouls += 1
            self.is_in_hand = self.match.winner is None

    def touched(self, touch: Touch) -> None:
        """Note what the cue ball meets first, and cushions after that."""
        pair = {touch.body_a, touch.body_b}
        balls = pair & set(self.balls)
        if self.cue in pair and len(balls) == 2 and self._first is None:
            self._first = self.label((pair - {self.cue}).pop())
        elif len(balls) == 1 and self._first is not None:
            self._cushion = True

    def _pilot(self) -> XY:
        """Return the impulse of the next stroke when nobody plays, N s."""
        if self.match.is_break:
            return LARGEST_IMPULSE, 0.0
        places = {self.label(b): self.world.position(b) for b in self.balls if b != self.cue}
        wanted = [places[label] for label in self.match.wanted(self.on_table()) if label in places]
        cue = self.world.position(self.cue)
        return stroke(cue, wanted, list(places.values()), POCKETS, RADIUS)

    def on_table(self) -> list[int]:
        """Return the numbers on the balls that lie on the table."""
        return [self.label(ball) for ball in self.balls if ball != self.cue]

    def _free_place(self, place: XY) -> XY:
        """Return a place, or the next one beside it that is free."""
        while any(math.dist(place, self.world.position(b)) < 2 * RADIUS for b in self.balls):
            place = (place[0], place[1] + RADIUS)
        return place

    def _pot(self, ball: int) -> None:
        """Take a ball off the table; the cue ball comes back, and that is a foul."""
        self.world.remove(ball)
        if ball != self.cue:
            self.potted.append(ball)
            self._fallen.append(self.label(ball))
            return
        self.aim, self._scratch = None, True
        self.cue = self.world.add(self._ball(self._free_place(HEAD)))

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


def _struck(answer: Any) -> tuple[XY, float]:
    """Return velocity and spin of a ball that was struck, or raise a ValueError."""
    velocity, spin = answer
    (x, y), spin = numbers(2)(velocity).tolist(), numbers()(spin)
    return (x, y), float(spin)


CUE_BALL = Mark("disc", INK, "cue ball, and ways balls came")
STRIPED = Mark("ring", COLOURS[0], "white middle: 9 to 15, and the 8")
READY = Mark("ring", ORANGE, "the cue ball may be struck")
CUE = Mark("line", ORANGE, "cue, and strength of the stroke")
TARGET_WAY = Mark("arrow", SKY, "way of the ball that is hit")
CUE_WAY = Mark("arrow", INK, "way of the cue ball after it")
LEGEND = (CUE_BALL, STRIPED, READY, CUE, TARGET_WAY, CUE_WAY)


def draw(game: Pool, picture: Picture, effects: ImpactEffects) -> None:
    """Draw the table, the balls and the cue."""
    _draw_table(picture)
    if effects.trails is not None:
        effects.trails.draw(picture, CUE_BALL.colour, CLOTH)
    for ball in game.balls:
        place = game.world.position(ball)
        label = game.label(ball)
        _draw_ball(picture, place, label, effects.colour(ball, ball_colour(label)))
    _draw_potted(game, picture)
    if game.aim is not None:
        _draw_cue(game, picture)
    elif game.is_at_rest:
        picture.ring(game.world.position(game.cue), 1.6 * RADIUS, READY.colour)


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
        label = game.label(ball)
        _draw_ball(picture, (0.1 + 0.08 * k, -0.22), label, ball_colour(label))


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
    picture.capsule(tip, (tip[0] - 0.6 * ux, tip[1] - 0.6 * uy), 0.008, CUE.colour)
    ghost, target = game.first_hit()
    picture.line((x, y), ghost, blend(CLOTH, INK, 0.6))
    picture.ring(ghost, RADIUS, INK, 1)
    if target is not None:
        away = (target[0] - ghost[0]) / (2 * RADIUS), (target[1] - ghost[1]) / (2 * RADIUS)
        picture.arrow(target, (0.2 * away[0], 0.2 * away[1]), TARGET_WAY.colour, 2.0)
        along = ux * away[0] + uy * away[1]  # equal masses: the rest goes at a right angle to it
        rest = ux - along * away[0], uy - along * away[1]
        picture.arrow(ghost, (0.2 * rest[0], 0.2 * rest[1]), CUE_WAY.colour, 2.0)
    _draw_strength(size, picture)


def _draw_strength(impulse: float, picture: Picture) -> None:
    """Draw a bar as long as the stroke is strong, and its value."""
    start, full = (1.45, -0.22), 0.45
    end = (start[0] + full * impulse / LARGEST_IMPULSE, start[1])
    picture.capsule(start, (start[0] + full, start[1]), 0.012, blend(CUE.colour, HOLE, 0.7))
    picture.capsule(start, end, 0.012, CUE.colour)
    words = f"{impulse:.2f} N s: {impulse / MASS:.1f} m/s"
    picture.text(words, (start[0] + full + 0.06, start[1]), anchor="midleft")


def readings(game: Pool) -> Readings:
    """Return strokes, fouls, spin and speed."""
    side = "left" if game.offset > 0 else "right"
    offset = f"{abs(game.offset):.1f} r {side}" if game.offset else "centre"
    match = game.match
    group = "any but the 8" if match.owner is None else "solids, 1 to 7"
    if match.owner is not None and match.turn != match.owner:
        group = "stripes, 9 to 15"
    return [
        ("to play", PLAYERS[match.turn]),
        ("has to meet", "the 8" if match.wanted(game.on_table()) == {EIGHT} else group),
        ("potted", f"{len(game.potted)} of 15"),
        ("strokes   fouls", f"{game.strokes}   {game.fouls}"),
        ("last foul", match.foul or "none"),
        ("cue ball", "in hand: drag it" if game.is_in_hand else "as it lies"),
        ("cue hits", offset),
        ("its speed", f"{math.hypot(*game.world.velocity(game.cue)):.2f} m/s"),
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
    legend=LEGEND,
    keys=(
        ("drag", "aim and strike: pull back"),
        ("left right", "hit off centre: spin"),
        ("A", "it plays itself"),
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
        (41, Input("press", "a")),
    ),
    effects=lambda: ImpactEffects(
        Flashes(least_impulse=0.02), trails=Trails(), sounds=Sounds("ivory", 0.06, 0.6)
    ),
)
