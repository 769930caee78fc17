"""Breakout: bricks, a paddle whose place decides the angle, and levels that get faster.

The ball is a body of the engine among walls and bricks. At no speed does it pass through a brick,
because the engine splits a step at every impact of a fast body. A brick breaks by the impulse
(1 + e) m vn that it gets: what falls from some of them changes the ball's m, or the e of all.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import Any, NamedTuple

from lesson_code.chapters.breakout.rules import STEEPEST, paddle_bounce
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.formulas import bounce
from lesson_code.geometry.shapes import Circle, Polygon
from lesson_code.view.pygame.effects import Sparks, Trails
from lesson_code.view.pygame.game import Game, Input, numbers
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings, room
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import GREEN, INK, ORANGE, PURPLE, SKY, VERMILION, YELLOW

WIDTH, HEIGHT = 8.0, 6.0
"""m. The room has no floor."""

RADIUS, MASS = 0.12, 1.0
BOUNCY = Material(restitution=1.0, friction=0.0)
COLUMNS, BRICK = 10, (0.74, 0.24)
"""Bricks in a row; width and height of one, m."""

FIRST_ROW, ROW, COLUMN = 5.4, 0.32, 0.78
"""m: height of the highest row; from one row and column to the next."""

PADDLE, PADDLE_Y, PADDLE_SPEED = (1.4, 0.2), 0.4, 9.0
"""m, m, m/s."""

SPEED, FASTER = 5.0, 1.0
"""m/s: of the ball in the first level, and more in each following one."""

FLATTEST = 0.2
"""Of the speed: its part along y at the least, so that the ball does not run from wall to wall."""

LIVES, LEVELS = 3, 5

HEAVY, DEAD = 3.0, 0.4
"""What the two kinds of capsules change: times the ball's mass, and the restitution."""

POWER_STEPS, CAPSULES = 720, 6
"""Steps that it lasts; bricks of a level that hold one."""

CAPSULE_SPEED, CAPSULE_RADIUS = 1.6, 0.16
"""m/s, m."""
ROW_COLOURS = (PURPLE, ORANGE, YELLOW, GREEN, SKY)


@dataclass(frozen=True)
class Rules:
    """What a player may write for this game; see :mod:`lesson_code.chapters.breakout.rules`."""

    paddle_bounce: Callable[..., Any] = paddle_bounce


class Impact(NamedTuple):
    """What the ball has hit: the body, the point's x, m, and the normal from it to the ball."""

    body: int
    x: float
    normal: XY


class Breakout(Game):
    """A ball, a paddle and bricks."""

    def __init__(self, seed: int = 0, rules: Rules = Rules()) -> None:
        self._paddle_bounce = rules.paddle_bounce
        super().__init__(seed)

    def reset(self) -> None:
        """Begin with the first level."""
        self.level, self.lives, self.score = 1, LIVES, 0
        self.target, self.plays_itself = WIDTH / 2, False
        self._build()

    def _build(self) -> None:
        """Set up a level."""
        walls = room(0.0, -2.0, WIDTH, HEIGHT, BOUNCY)[1:]  # right, top, left
        self.world = LiveWorld(walls, callbacks=self.callbacks)
        self.paddle = self.world.add(
            Body(Polygon.box(*PADDLE), position=(WIDTH / 2, PADDLE_Y), material=BOUNCY)
        )
        self.powers: dict[str, int] = {}  # letter: step at which it ends
        self.ball = self._new_ball(self._on_paddle(), (0.0, 0.0))
        self.falling: list[tuple[str, XY]] = []  # capsules, and where they are
        self.impulse = 0.0  # N s, of the last impact on a brick
        self.bricks: dict[int, int] = {}  # number of the body: hits that it still stands
        self.rows: dict[int, int] = {}
        self.struck: set[int] = set()
        for row in range(2 + self.level):
            for column in range(COLUMNS):
                place = (0.49 + column * COLUMN, FIRST_ROW - row * ROW)
                number = self.world.add(Body(Polygon.box(*BRICK), position=place, material=BOUNCY))
                self.bricks[number] = 2 if row == 0 and self.level > 1 else 1
                self.rows[number] = row
        draw_lots = Random(1_000 * self.seed + self.level)  # noqa: S311 - a game
        self.capsules = dict(
            zip(draw_lots.sample(sorted(self.bricks), CAPSULES), "mememe", strict=True)
        )
        self.serves = True

    @property
    def mass(self) -> float:
        """The ball's mass, kg."""
        return HEAVY * MASS if "m" in self.powers else MASS

    @property
    def restitution(self) -> float:
        """That of all impacts but the paddle's."""
        return DEAD if "e" in self.powers else 1.0

    def _new_ball(self, place: XY, velocity: XY) -> int:
        """Add a ball of the mass that it has now."""
        return self.world.add(
            Body(Circle(RADIUS), position=place, velocity=velocity, mass=self.mass, material=BOUNCY)
        )

    def _change_powers(self, powers: dict[str, int]) -> None:
        """Give ball and bricks the mass and the restitution that are on from now on."""
        self.powers = powers
        place, velocity = self.world.position(self.ball), self.world.velocity(self.ball)
        self.world.remove(self.ball)
        self.ball = self._new_ball(place, velocity)
        self.world.coat(restitution=self.restitution)

    def _on_paddle(self) -> XY:
        """Return where the ball waits to be served."""
        x, y = self.world.position(self.paddle)
        return x, y + PADDLE[1] / 2 + RADIUS + 0.02

    @property
    def speed(self) -> float:
        """The ball's speed in this level, m/s."""
        return SPEED + FASTER * (self.level - 1)

    @property
    def is_over(self) -> bool:
        """Whether there is nothing left to play."""
        return self.lives == 0 or self.level > LEVELS

    @property
    def notice(self) -> str:
        """What is not written yet, and what the end of the game was."""
        if not self.is_over:
            return super().notice
        return "All levels done: R plays again" if self.lives else "Game over: R plays again"

    def trailed(self) -> dict[int, XY]:
        """Return where the ball is, once it is served: it leaves a trail."""
        return {} if self.serves else {self.ball: self.world.position(self.ball)}

    def press(self, key: str) -> None:
        """Serve, or start again."""
        super().press(key)
        if key == "space":
            self.serve()
        elif key == "a":
            self.plays_itself = not self.plays_itself

    def down(self, place: XY) -> None:
        """Serve."""
        self.serve()

    def drag(self, place: XY) -> None:
        """Move the paddle towards the mouse; who plays wants to play alone."""
        self.target, self.plays_itself = place[0], False

    def serve(self) -> None:
        """Launch the ball, a little to one side."""
        if self.serves and not self.is_over:
            self.serves = False
            self.world.throw(self.ball, self._from_paddle(self.random.uniform(-0.5, 0.5)), 0.0)

    def _from_paddle(self, offset: float) -> XY:
        """Return the velocity of a ball that leaves the paddle: straight up without the rule."""
        straight = 0.0, self.speed
        leaving = offset, self.speed
        x, y = self.ask(self._paddle_bounce, *leaving, form=numbers(2), otherwise=straight)
        return float(x), float(y)

    def step(self) -> None:
        """Make one step: paddle, ball, and what it has hit."""
        if self.is_over:
            return
        if self.plays_itself:
            self._play()
        self._steer()
        self.world.step()
        impacts = self._last_impacts()
        for brick in sorted(self.struck):
            for _ in range(round(self.mass / MASS)):  # as many as the impulse of MASS would take
                self._hit(brick)
        self.struck.clear()
        self._let_fall()
        if self.serves:
            self.world.move(self.ball, self._on_paddle())
            self.world.throw(self.ball, (0.0, 0.0), 0.0)
        elif self.world.position(self.ball)[1] < -RADIUS:
            self.lives -= 1
            self.serves = True
            self.falling.clear()
            self._change_powers({})
        else:
            self.world.throw(self.ball, self._velocity_after(impacts))
        if not self.bricks:
            self.level += 1
            if not self.is_over:
                self._build()

    def _play(self) -> None:
        """Move the paddle under the ball, off its middle by as much as the ball has to turn."""
        self.serve()
        (x, y), (vx, vy) = self.world.position(self.ball), self.world.velocity(self.ball)
        if vy < 0:
            x += vx * (y - PADDLE_Y - PADDLE[1] / 2 - RADIUS) / -vy
            width = WIDTH - 2 * RADIUS
            x = RADIUS + width - abs((x - RADIUS) % (2 * width) - width)  # where walls send it
        left = [self.world.position(brick)[0] for brick in self.bricks]
        wanted = left[self.world.steps // 240 % len(left)] if left else x
        turn = math.atan2(wanted - x, FIRST_ROW - PADDLE_Y) / STEEPEST
        self.target = x - min(max(turn, -0.8), 0.8) * PADDLE[0] / 2

    def _let_fall(self) -> None:
        """Let capsules fall, catch them with the paddle, and end what has lasted its time."""
        px, _ = self.world.position(self.paddle)
        falling, self.falling = self.falling, []
        caught = {}
        for letter, (x, y) in falling:
            y -= CAPSULE_SPEED * self.world.dt
            if abs(y - PADDLE_Y) < CAPSULE_RADIUS and abs(x - px) < PADDLE[0] / 2 + CAPSULE_RADIUS:
                caught[letter] = self.world.steps + POWER_STEPS
            elif y > -CAPSULE_RADIUS:
                self.falling.append((letter, (x, y)))
        lasting = {k: end for k, end in self.powers.items() if end > self.world.steps}
        if caught or lasting != self.powers:
            self._change_powers(lasting | caught)

    def _steer(self) -> None:
        """Move the paddle by keys, or towards the mouse, and keep it inside."""
        x, _ = self.world.position(self.paddle)
        way = ("right" in self.held) - ("left" in self.held)
        if way:
            self.target = x + way * PADDLE_SPEED * self.world.dt
        half = PADDLE[0] / 2
        aim = min(max(self.target, half), WIDTH - half)
        speed = (aim - x) / self.world.dt
        self.world.throw(self.paddle, (min(max(speed, -PADDLE_SPEED), PADDLE_SPEED), 0.0))

    def touched(self, touch: Touch) -> None:
        """Note which brick the ball strikes."""
        numbers = {touch.body_a, touch.body_b}
        if self.ball in numbers and numbers & self.bricks.keys():
            self.struck |= numbers & self.bricks.keys()
            self.impulse = touch.normal_impulse

    def _last_impacts(self) -> list[Impact]:
        """Return what the ball has hit last in this step; in a corner there are two."""
        numbers = self.world.numbers
        ball, rows = numbers.index(self.ball), self.world.impulses.tolist()
        mine = [row for row in rows if ball in row[1:3]]
        impacts = []
        for time, a, b, x, _, nx, ny, *_ in mine:
            if time == mine[-1][0]:
                other, sign = (a, 1) if b == ball else (b, -1)
                impacts.append(Impact(numbers[int(other)], x, (sign * nx, sign * ny)))
        return impacts

    def _velocity_after(self, impacts: list[Impact]) -> XY:
        """Return how the ball goes on: as the paddle or the level wants it, and into nothing.

        The rules must not send the ball back into what it has just hit: it would strike it again.
        """
        velocity = steady(self.world.velocity(self.ball), self.speed)
        for impact in impacts:
            if impact.body == self.paddle and self.world.position(self.ball)[1] > PADDLE_Y:
                offset = (impact.x - self.world.position(self.paddle)[0]) / (PADDLE[0] / 2)
                velocity = self._from_paddle(offset)
        for impact in impacts:
            velocity = bounce(velocity, impact.normal, 1.0)
        return float(velocity[0]), float(velocity[1])

    def _hit(self, number: int) -> None:
        """Take a hit from a brick, and the brick away with its last."""
        if number not in self.bricks:
            return
        self.bricks[number] -= 1
        self.score += 10
        if self.bricks[number] == 0:
            if number in self.capsules:
                self.falling.append((self.capsules[number], self.world.position(number)))
            del self.bricks[number]
            self.world.remove(number)


def steady(velocity: XY, speed: float) -> XY:
    """Return a velocity of a given speed in the same direction, but not too flat.

    >>> steady((3.0, 4.0), 10.0)
    (6.0, 8.0)
    """
    vx, vy = velocity
    size = math.hypot(vx, vy)
    if size == 0:
        return 0.0, speed
    vx, vy = vx / size, vy / size
    if abs(vy) < FLATTEST:
        vy = math.copysign(FLATTEST, vy)
        vx = math.copysign(math.sqrt(1 - vy * vy), vx)
    return speed * vx, speed * vy


PADDLE_MARK = Mark("area", INK, "paddle")
BALL = Mark("disc", ORANGE, "ball")
HEAVY_BALL = Mark("disc", VERMILION, "ball of three times the mass")
CAPSULE = Mark("disc", YELLOW, "capsule: catch it")
WAY = Mark("line", SKY, "the way the ball came")
BOUNCE = Mark("arrow", SKY, "the way the paddle sends it")
LEGEND = (PADDLE_MARK, BALL, HEAVY_BALL, CAPSULE, WAY, BOUNCE)


def draw(game: Breakout, picture: Picture, effects: ImpactEffects) -> None:
    """Draw bricks, paddle and ball."""
    for number, hits in game.bricks.items():
        x, y = game.world.position(number)
        body = game.world.body(number)
        picture.body(body, (x, y), 0.0, ROW_COLOURS[game.rows[number] % len(ROW_COLOURS)])
        label = game.capsules.get(number, "") + (" 2" if hits > 1 else "")
        if label:
            picture.text(label.strip(), (x, y), colour=(20, 24, 30))
    for letter, capsule in game.falling:
        picture.disc(capsule, CAPSULE_RADIUS, CAPSULE.colour)
        picture.text(letter, capsule, colour=(20, 24, 30))
    place = game.world.position(game.paddle)
    picture.body(game.world.body(game.paddle), place, 0.0, PADDLE_MARK.colour)
    if effects.trails is not None:
        effects.trails.draw(picture, WAY.colour)
    colour = (HEAVY_BALL if "m" in game.powers else BALL).colour
    picture.disc(game.world.position(game.ball), RADIUS, colour)
    if game.serves and not game.is_over:
        picture.text("SPACE or click to serve", (WIDTH / 2, 1.6))
        for offset in (-1.0, -0.5, 0.0, 0.5, 1.0):
            x = place[0] + offset * PADDLE[0] / 2
            angle = offset * STEEPEST
            tail = (x, PADDLE_Y + 0.45)
            picture.arrow(tail, (0.4 * math.sin(angle), 0.4 * math.cos(angle)), BOUNCE.colour, 2.0)


def readings(game: Breakout) -> Readings:
    """Return level, lives, score, bricks and speed."""
    return [
        ("level", f"{min(game.level, LEVELS)} of {LEVELS}"),
        ("lives", f"{game.lives}"),
        ("score", f"{game.score}"),
        ("bricks", f"{len(game.bricks)}"),
        ("speed", f"{math.hypot(*game.world.velocity(game.ball)):.1f} m/s"),
        ("mass of the ball", f"{game.mass:g} kg"),
        ("restitution", f"{game.restitution:g}"),
        ("last brick got", f"{game.impulse:.1f} N s"),
    ]


PROGRAM = Program(
    name="breakout",
    title="Breakout",
    own=(paddle_bounce,),
    with_own=lambda *own: {"rules": Rules(*own)},
    game=Breakout,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("mouse", "move the paddle"),
        ("left right", "the same by keys"),
        ("SPACE", "serve"),
        ("A", "it plays itself"),
    ),
    forbids=dict.fromkeys(
        ("grab", "gravity", "restitution", "friction", "mass"), "the paddle alone moves the ball"
    ),
    camera=Camera(left=0.0, bottom=0.0, scale=100.0),
    tour=((10, Input("press", "a")),),
    effects=lambda: ImpactEffects(
        sparks=Sparks(), trails=Trails(), sounds=Sounds("stone", 0.1, 8.0)
    ),
)
