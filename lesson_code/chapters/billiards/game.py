"""Cushion-bounce billiards: a ball, four cushions and a bumper, moved by one function.

All physics comes through one argument, `advance`: the table's own, or a student's with the same
signature. The program turns mouse and keys into launches and steps into calls of `advance`; it
computes nothing itself. Like the table, it counts in pixels and has y pointing down.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.chapters.billiards import rules as billiards_table
from lesson_code.chapters.billiards.rules import (
    CUSHIONS,
    MAX_LAUNCH_SPEED,
    TABLE,
    TIME_STEP,
    first_shot,
)
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY
from lesson_code.engine.matter import Matter
from lesson_code.formulas.validation import Vector, non_negative, one_vector
from lesson_code.view.pygame.effects import Flashes
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import FLASH, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import (
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    YELLOW,
    Colour,
)

Advance: TypeAlias = Callable[[Any, Any, float], tuple[Vector, Vector, list[str], float]]
"""advance(position, velocity, elapsed) -> (position, velocity, hits, left_over)."""

ARROW_SECONDS = 0.25
"""s: an arrow ends where the ball would be after this time; a drag of 100 px gives 400 px/s."""

BOUNCE_SECONDS, NAME_ASIDE = 0.16, 14.0
"""s: an arrow of a bounce is as long as the way in this time; px: how far its name stands aside."""

TRAIL_STEPS = 120
"""How many past positions are kept to be drawn: two seconds."""

GRAB_RADIUS = 2 * TABLE.radius
"""px: a press this near to the ball's centre takes hold of it."""

MOST_LEFT_OVER = 0.25
"""s: what `advance` leaves over counts as no more than this, so that no step takes ever longer."""

BALL, MASS = len(CUSHIONS), 1.0
"""The ball's number, after those of the cushions; and its mass, kg, for the sound of an impact."""

RAIL, CUSHION = 28.0, 12.0
"""px: width of the frame round the table, and of the cushions, its inner part."""

CLOTH: Colour = (18, 70, 78)
CUSHION_CLOTH: Colour = (10, 42, 48)
WOOD: Colour = (88, 62, 44)


class Bounce(NamedTuple):
    """A bounce off one cushion: where, px, and I, (I.N)N and R, px/s."""

    place: XY
    incident: XY
    normal_part: XY
    reflected: XY


class Billiards(Game):
    """A ball on a table.

    Parameters
    ----------
    seed : int
        Draws the first shot; 0 is the table's own.
    advance : callable
        ``advance(position, velocity, elapsed) -> (position, velocity, hits, left_over)``, as
        :func:`lesson_code.chapters.billiards.rules.advance`. While it raises NotImplementedError,
        the ball stands still and the window says what is missing.
    launch : (position, velocity), optional
        Another first shot, px and px/s, y down.

    Raises
    ------
    ValueError
        The launch is not finite or too fast; or, in a step, `advance` returns what is no ball.

    Examples
    --------
    >>> game = Billiards()
    >>> for _ in range(60):
    ...     game.step()
    >>> game.bounces
    {'top': 1, 'bottom': 0, 'left': 0, 'right': 0, 'bumper': 0}
    """

    def __init__(
        self,
        seed: int = 0,
        advance: Advance = billiards_table.advance,
        launch: tuple[Vector, Vector] | None = None,
    ) -> None:
        self._advance = advance
        self._first = _checked_launch(first_shot(seed) if launch is None else launch)
        self.shows_normals = False
        super().__init__(seed)

    def reset(self) -> None:
        """Play the first shot again."""
        self.launch(*self._first)

    def launch(self, position: Vector, velocity: Vector) -> None:
        """Start a shot: counts, time and trail start again."""
        self.position, self.velocity = np.array(position), np.array(velocity)
        self.bounces = dict.fromkeys(CUSHIONS, 0)
        self.time = self.left_over = 0.0
        self.all_hit_at: float | None = None
        self.last_bounce: Bounce | None = None
        self.trail = deque([as_place(position)], maxlen=TRAIL_STEPS)
        self.aim: XY | None = None

    def snapshot(self) -> NDArray[np.float64]:
        """Return the ball's position and velocity, shape (2, 2)."""
        return np.array([self.position, self.velocity])

    def matter(self) -> Matter:
        """Return the ball; it does not turn."""
        state = [*self.position, 0.0, *self.velocity, 0.0]
        return Matter(np.array([state]), np.array([MASS]), np.zeros(1))

    def press(self, key: str) -> None:
        """Show normals, or play the first shot again."""
        super().press(key)
        if key in ("n", "g"):
            self.shows_normals = not self.shows_normals

    def down(self, place: XY) -> None:
        """Take hold of the ball."""
        if math.dist(place, self.position) <= GRAB_RADIUS:
            self.aim = place

    def drag(self, place: XY) -> None:
        """Aim."""
        if self.aim is not None:
            self.aim = place

    def let_go(self, place: XY) -> None:
        """Launch the ball; a drag that ends on it launches nothing."""
        aimed, self.aim = self.aim is not None, None
        if aimed and math.dist(place, self.position) > TABLE.radius:
            self.launch(self.position, launch_velocity(self.position, place))

    def step(self) -> None:
        """Make one step; time stands still while the player aims."""
        if self.aim is not None:
            return
        elapsed = min(self.left_over, MOST_LEFT_OVER) + TIME_STEP
        before = self.velocity
        ball = self.position, self.velocity
        answer = self.ask(self._advance, *ball, elapsed, form=_checked_answer, otherwise=None)
        if answer is None:
            return
        self.position, self.velocity, hits, self.left_over = answer
        self.time += elapsed - self.left_over
        self.trail.append(as_place(self.position))
        self._count(hits, before)

    def _count(self, hits: list[str], before: Any) -> None:
        """Count the hits, and tell of them who listens: they share the change of velocity."""
        change = self.velocity - before
        size = math.hypot(*change)
        if len(hits) == 1 and size > 0:
            self.last_bounce = self._bounce(before, change / size)
        for name in hits:
            self.bounces[name] += 1
            if size > 0:
                self._hear(self._touch(name, change / size, MASS * size / len(hits)))
        if self.all_hit_at is None and all(self.bounces.values()):
            self.all_hit_at = self.time

    def _bounce(self, incident: Any, normal: Any) -> Bounce:
        """Return the bounce that has just happened; N is along what the velocity changed by."""
        return Bounce(
            as_place(self.position - TABLE.radius * normal),
            as_place(incident),
            as_place(np.dot(incident, normal) * normal),
            as_place(self.velocity),
        )

    def _touch(self, name: str, normal: Any, impulse: float) -> Touch:
        """Return what effects and sound hear of a hit."""
        return Touch(
            time=self.time,
            body_a=CUSHIONS.index(name),
            body_b=BALL,
            normal=as_place(normal),
            points=(as_place(self.position - TABLE.radius * normal),),
            penetration=0.0,
            restitution=TABLE.restitution,
            friction=0.0,
            normal_impulse=impulse,
        )


def launch_velocity(ball: Vector, mouse: XY) -> Any:
    """Return the velocity that a drag from the ball to `mouse` gives, px/s, capped.

    >>> launch_velocity((100, 100), (150, 80))
    array([200., -80.])
    """
    velocity = (np.asarray(mouse) - np.asarray(ball)) / ARROW_SECONDS
    speed = math.hypot(*velocity)
    return velocity if speed <= MAX_LAUNCH_SPEED else velocity * (MAX_LAUNCH_SPEED / speed)


def as_place(point: Vector) -> XY:
    """Return a point as two plain numbers."""
    return float(point[0]), float(point[1])


def _checked_launch(launch: tuple[Vector, Vector]) -> tuple[Any, Any]:
    """Return position and velocity of a shot, or raise a ValueError that names what is wrong."""
    position = one_vector("launch position", launch[0])
    velocity = one_vector("launch velocity", launch[1])
    speed = math.hypot(*velocity)
    if speed > MAX_LAUNCH_SPEED:
        raise ValueError(f"launch speed must be <= {MAX_LAUNCH_SPEED:g} px/s, got {speed:g}")
    return position, velocity


def _checked_answer(answer: Any) -> tuple[Any, Any, list[str], float]:
    """Return what `advance` returned, or raise a ValueError that says what it should be."""
    if not isinstance(answer, tuple) or len(answer) != 4:
        rule = "advance must return (position, velocity, hits, left_over)"
        raise ValueError(f"{rule}, got {answer!r}")
    position, velocity, hits, left_over = answer
    if not isinstance(hits, list) or any(name not in CUSHIONS for name in hits):
        rule = f"hits from advance must be a list of names among {', '.join(CUSHIONS)}"
        raise ValueError(f"{rule}, got {hits!r}")
    return (
        one_vector("position from advance", position),
        one_vector("velocity from advance", velocity),
        list(hits),
        float(non_negative("left_over from advance", left_over)),
    )


WAY = Mark("disc", INK, "ball, and the way it came")
LAUNCH = Mark("arrow", ORANGE, "velocity of the launch")
INCIDENT = Mark("arrow", YELLOW, "I: velocity before a bounce")
NORMAL_PART = Mark("arrow", VERMILION, "(I.N)N: its part along N")
REFLECTED = Mark("arrow", GREEN, "R: velocity after it")
NORMAL = Mark("arrow", SKY, "N: normals of the sides")
BUMPER = Mark("area", PURPLE, "bumper")
HIT = Mark("area", FLASH, "what was just hit")
LEGEND = (WAY, LAUNCH, INCIDENT, NORMAL_PART, REFLECTED, NORMAL, BUMPER, HIT)


def draw(game: Billiards, picture: Picture, effects: ImpactEffects) -> None:
    """Draw the table, the way of the ball, what is asked for of arrows, and the ball."""
    _draw_table(picture, effects)
    picture.trail(list(game.trail), WAY.colour, CLOTH)
    if game.shows_normals:
        _draw_normals(picture)
    if game.last_bounce is not None:
        _draw_bounce(game.last_bounce, picture)
    ball = as_place(game.position)
    picture.disc(ball, TABLE.radius, WAY.colour)
    if game.aim is not None:
        picture.arrow(ball, as_place(velocity_shown(game) * ARROW_SECONDS), LAUNCH.colour)


def _draw_bounce(bounce: Bounce, picture: Picture) -> None:
    """Draw I into the point where the ball has touched, (I.N)N and R out of it, with their names.

    The names stand aside, I's to the left of it and R's to the right, so that they are apart in a
    bounce straight back, too.
    """
    (x, y), k = bounce.place, BOUNCE_SECONDS
    (ix, iy), (rx, ry) = bounce.incident, bounce.reflected
    picture.arrow((x - k * ix, y - k * iy), (k * ix, k * iy), INCIDENT.colour)
    picture.arrow(
        (x, y), (k * bounce.normal_part[0], k * bounce.normal_part[1]), NORMAL_PART.colour
    )
    picture.arrow((x, y), (k * rx, k * ry), REFLECTED.colour)
    names = ("I", (ix, iy), -k), ("R", (rx, ry), k)
    for name, (vx, vy), end in names:
        size = math.hypot(vx, vy) or 1.0
        aside = NAME_ASIDE / size
        picture.text(name, (x + end * vx - aside * vy, y + end * vy + aside * vx))


def _draw_table(picture: Picture, effects: ImpactEffects) -> None:
    """Draw wood, cloth, cushions and bumper; what is hit lights up."""
    picture.polygon(_frame(RAIL), WOOD)
    picture.polygon(_frame(0.0), CLOTH)
    inner, outer = _frame(0.0), _frame(CUSHION)
    for name, sides in {"top": (0, 1), "right": (1, 2), "bottom": (2, 3), "left": (3, 0)}.items():
        corners = [inner[sides[0]], inner[sides[1]], outer[sides[1]], outer[sides[0]]]
        picture.polygon(corners, effects.colour(CUSHIONS.index(name), CUSHION_CLOTH))
    colour = effects.colour(CUSHIONS.index("bumper"), BUMPER.colour)
    picture.capsule(TABLE.bumper_start, TABLE.bumper_end, TABLE.bumper_half_thickness, colour)


def _frame(grow: float) -> list[XY]:
    """Return the corners of the table, grown on all sides: clockwise from the top left, px."""
    w, h = TABLE.width + grow, TABLE.height + grow
    return [(-grow, -grow), (w, -grow), (w, h), (-grow, h)]


def _draw_normals(picture: Picture) -> None:
    """Draw the normal of each wall, and of both sides of the bumper."""
    for (x, y), (nx, ny) in _normals():
        picture.arrow((x, y), (40 * nx, 40 * ny), NORMAL.colour)
        beside = (x + 80 * nx, y + 56 * ny)
        picture.text(f"({nx:.4g}, {ny:.4g})", beside, colour=NORMAL.colour)


def _normals() -> list[tuple[XY, XY]]:
    """Return foot and direction of every normal to draw: four walls, two sides of the bumper."""
    w, h = TABLE.width, TABLE.height
    feet = {"top": (w / 2, 0.0), "bottom": (w / 2, h), "left": (0.0, h / 2), "right": (w, h / 2)}
    walls = [(feet[name], normal) for name, normal, _ in TABLE.walls]
    (x1, y1), (x2, y2) = TABLE.bumper_start, TABLE.bumper_end
    nx, ny = TABLE.bumper_normal
    sides = []
    for sign in (1, -1):
        reach = sign * TABLE.bumper_half_thickness
        foot = ((x1 + x2) / 2 + reach * nx, (y1 + y2) / 2 + reach * ny)
        sides.append((foot, (sign * nx, sign * ny)))
    return walls + sides


def velocity_shown(game: Billiards) -> Any:
    """Return the ball's velocity, or the one that the drag would give it, px/s."""
    return game.velocity if game.aim is None else launch_velocity(game.position, game.aim)


def readings(game: Billiards) -> Readings:
    """Return the bounces in total and by cushion, speed, restitution and time."""
    speed = math.hypot(*velocity_shown(game))
    bounce = game.last_bounce
    vectors = bounce[1:] if bounce is not None else (None, None, None)
    names = ("I, yellow", "(I.N)N, red", "R, green")
    return [
        ("bounces", f"{sum(game.bounces.values())}"),
        *[(f"   {name}", f"{count}") for name, count in game.bounces.items()],
        ("speed" if game.aim is None else "launch", f"{speed:.0f} px/s"),
        ("restitution", f"{TABLE.restitution:g}"),
        *[
            (name, "" if v is None else f"({round(v[0]) + 0}, {round(v[1]) + 0}) px/s")
            for name, v in zip(names, vectors, strict=True)
        ],
        ("time", f"{game.time:.1f} s"),
        ("all five hit", "not yet" if game.all_hit_at is None else f"in {game.all_hit_at:.2f} s"),
    ]


PROGRAM = Program(
    name="billiards",
    title="Cushion-bounce billiards",
    own=(billiards_table.advance,),
    with_own=lambda own: {"advance": own},
    game=Billiards,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("drag", "from the ball: launch it"),
        ("N", "normals"),
    ),
    camera=Camera(left=-100.0, bottom=500.0, scale=1.0, up=-1),
    length="px",
    forbids=dict.fromkeys(("grab",), "the ball is launched by a drag"),
    tour=(
        (0, Input("press", "v")),
        (0, Input("down", place=(80.0, 80.0))),
        (15, Input("move", place=(125.0, 45.0))),
        (45, Input("up", place=(170.0, 10.0))),
        (75, Input("press", "n")),
    ),
    effects=lambda: ImpactEffects(Flashes(), sounds=Sounds("wood", 0.1, 700.0)),
)
