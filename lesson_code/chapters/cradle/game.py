"""Newton's cradle: k balls in, k balls out, and the other lawful answer.

Momentum and energy leave more than one answer open where many balls touch. If one pair strikes
after the other, as hard balls do that hang a hair apart, k come in and k go out. If all strike at
once, the first bounce back. A chooses; both are drawn below the cradle.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from lesson_code.chapters.cradle.motion import LAWS, Impact, Law, Row, step
from lesson_code.chapters.cradle.rules import GRAVITY, STRING
from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.formulas import kinetic_energy, momentum
from lesson_code.geometry.shapes import Circle
from lesson_code.view.pygame.effects import Flashes
from lesson_code.view.pygame.game import Game, Input, numbers
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import FLASH, WALL, Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import FADED_INK, INK, ORANGE, SKY, YELLOW

RADIUS, MASS = 0.35, 1.0
"""m, kg: of the smallest ball."""

UNEQUAL = (1.0, 2.0, 1.5, 3.0, 1.2, 2.5, 1.0, 2.0, 1.4)
"""Times that: the masses of nine balls that differ. Their areas do as well."""

PIVOT_HEIGHT = 5.0
"""m."""

PULL = math.radians(35)
"""How far the balls are pulled out."""

BALLS, MOST_BALLS = 5, 9
STRINGS = "the balls hang on strings; drag pulls them out"


class Cradle(Game):
    """A row of balls on strings; some of them are pulled out and let go."""

    def __init__(self, seed: int = 0) -> None:
        self.count, self.pulled, self.restitution = BALLS, 1, 1.0
        self.law, self.is_unequal = "in turn", False
        super().__init__(seed)

    def reset(self) -> None:
        """Hang the balls, pull some out on the left, and let go."""
        masses = [MASS * (UNEQUAL[k] if self.is_unequal else 1.0) for k in range(self.count)]
        self.radii = [RADIUS * math.sqrt(m / MASS) * self._shrink(masses) for m in masses]
        places = [0.0]
        for left, right in zip(self.radii, self.radii[1:], strict=False):
            places.append(places[-1] + left + right)
        middle = (places[0] + places[-1]) / 2
        self.pivots = [(x - middle, PIVOT_HEIGHT) for x in places]
        self.held_ball: int | None = None
        angles = [-PULL if k < self.pulled else 0.0 for k in range(self.count)]
        self.row = Row(masses, angles, [0.0] * self.count, STRING)
        self.steps = 0
        self.world = LiveWorld(self._ball(k) for k in range(self.count))
        self._show()

    def _shrink(self, masses: list[float]) -> float:
        """Return by how much all balls are smaller: the row is as wide as one of equal balls."""
        return self.count / sum(math.sqrt(m / MASS) for m in masses)

    def _ball(self, k: int) -> Body:
        """Return a ball."""
        surface = Material(self.restitution, 0.0)
        return Body(Circle(self.radii[k]), mass=self.row.masses[k], material=surface)

    def _show(self) -> None:
        """Put the bodies of the world where the strings have them."""
        for k, (x, y) in enumerate(self.pivots):
            angle, speed = self.row.angles[k], STRING * self.row.rates[k]
            s, c = math.sin(angle), math.cos(angle)
            self.world.move(k, (x + STRING * s, y - STRING * c))
            self.world.throw(k, (speed * c, speed * s))

    def press(self, key: str) -> None:
        """Pull out another number of balls, hang more or fewer, or change the restitution."""
        super().press(key)
        if key.isdecimal() and 1 <= int(key) <= self.count:
            self.pulled = int(key)
            self.reset()
        elif key in ("up", "down"):
            self.count = min(max(self.count + (1 if key == "up" else -1), 1), MOST_BALLS)
            self.pulled = min(self.pulled, self.count)
            self.reset()
        elif key == "e":
            self.restitution = 0.9 if self.restitution == 1.0 else 1.0
            self.reset()
        elif key == "w":
            self.is_unequal = not self.is_unequal
            self.reset()
        elif key == "a":
            self.law = next(name for name in LAWS if name != self.law)
            self.reset()

    def down(self, place: XY) -> None:
        """Take hold of a ball."""
        for k in range(self.count):
            if math.dist(place, self.world.position(k)) <= self.radii[k]:
                self.held_ball = k

    def drag(self, place: XY) -> None:
        """Pull the ball that is held, and those outside of it with it."""
        if self.held_ball is None:
            return
        x, y = self.pivots[self.held_ball]
        angle = math.atan2(place[0] - x, max(y - place[1], 0.1))
        outside = [
            k for k in range(self.count) if (k - self.held_ball) * (1 if angle > 0 else -1) >= 0
        ]
        self.row.angles = [angle if k in outside else 0.0 for k in range(self.count)]
        self.row.rates = [0.0] * self.count
        self.pulled = len(outside)
        self._show()

    def let_go(self, place: XY) -> None:
        """Let the ball go."""
        self.held_ball = None

    def step(self) -> None:
        """Make one step; a ball that is held keeps everything still."""
        if self.held_ball is not None:
            return
        self.steps += 1
        impacts = step(self.row, TIME_STEP, self._asked(self.law), self.restitution)
        self._show()
        for impact in impacts:
            self._hear(self._touch(impact))

    def _touch(self, impact: Impact) -> Touch:
        """Return what effects and sound hear of an impact."""
        left, right = impact.left, impact.left + 1
        x, y = self.world.position(left)
        return Touch(
            time=self.steps * TIME_STEP,
            body_a=left,
            body_b=right,
            normal=(1.0, 0.0),
            points=((x + self.radii[left], y),),
            penetration=0.0,
            restitution=self.restitution,
            friction=0.0,
            normal_impulse=impact.impulse,
        )

    def swinging(self) -> tuple[int, int]:
        """Return how many balls are clearly out on the left, and on the right."""
        least = 0.3 * max(max(map(abs, self.row.angles)), PULL)
        left = sum(angle < -least for angle in self.row.angles)
        return left, sum(angle > least for angle in self.row.angles)

    @property
    def gravity(self) -> XY:
        """What pulls the balls, m/s^2; the strings hold against it."""
        return 0.0, -GRAVITY

    def energy(self) -> float:
        """Return kinetic and potential energy, J; 0 for balls that hang still."""
        return self.row.energy()

    def answers(self) -> dict[str, list[float]]:
        """Return what each law makes of the balls that come in at 1 m/s, in m/s."""
        coming = [1.0] * self.pulled + [0.0] * (self.count - self.pulled)
        if self.count == 1:
            return dict.fromkeys(LAWS, coming)
        return {name: self._asked(name)(self.row.masses, coming, 1.0) for name in LAWS}

    def _asked(self, name: str) -> Law:
        """Return a law; one that a player has not written yet is named, and changes nothing."""

        def law(
            masses: Sequence[float], velocities: Sequence[float], restitution: float
        ) -> list[float]:
            given = (masses, velocities, restitution)
            form = numbers(len(masses))
            return [float(v) for v in self.ask(LAWS[name], *given, form=form, otherwise=velocities)]

        return law


PULLED = Mark("disc", ORANGE, "ball that was pulled out")
HANGING = Mark("disc", SKY, "ball that hung still")
STRUCK = Mark("disc", FLASH, "just struck")
LAW = Mark("arrow", INK, "velocities, by the law that is on")
OTHER_LAW = Mark("arrow", FADED_INK, "velocities, by the other one")
LEGEND = (PULLED, HANGING, STRUCK, LAW, OTHER_LAW)


def draw(game: Cradle, picture: Picture, effects: ImpactEffects) -> None:
    """Draw the beam, the strings and the balls."""
    left, right = game.pivots[0][0] - 1.0, game.pivots[-1][0] + 1.0
    picture.capsule((left, PIVOT_HEIGHT), (right, PIVOT_HEIGHT), 0.08, WALL)
    for k, pivot in enumerate(game.pivots):
        picture.line(pivot, game.world.position(k), FADED_INK)
    for k in range(game.count):
        colour = effects.colour(k, (PULLED if k < game.pulled else HANGING).colour)
        place = game.world.position(k)
        picture.disc(place, game.radii[k], colour)
        label = f"{game.row.masses[k]:g}" if game.is_unequal else f"{k + 1}"
        picture.text(label, place, colour=(20, 24, 30))
    left_out, right_out = game.swinging()
    picture.text(f"{left_out} out", (-4.2, 6.4), colour=INK)
    picture.text(f"{right_out} out", (4.2, 6.4), colour=INK)
    for y, (name, velocities) in zip((0.75, -0.1), game.answers().items(), strict=True):
        _draw_answer(game, picture, name, velocities, y)


def _draw_answer(
    game: Cradle, picture: Picture, name: str, velocities: list[float], y: float
) -> None:
    """Draw what a law makes of the first impact: an arrow a ball, and both sums."""
    is_on = name == game.law
    ink = (LAW if is_on else OTHER_LAW).colour
    picture.text(name, (-5.1, y), colour=YELLOW if is_on else FADED_INK, anchor="midleft")
    for k, velocity in enumerate(velocities):
        place = (-3.2 + 0.62 * k, y)
        picture.disc(place, 0.13, ink)
        if abs(velocity) > 1e-9:
            picture.arrow((place[0], y + 0.22), (0.5 * velocity, 0.0), ink, 2.0)
    p = float(momentum(game.row.masses, [(v, 0.0) for v in velocities])[0])
    e = float(kinetic_energy(game.row.masses, [(v, 0.0) for v in velocities]))
    picture.text(f"sum m v = {p:.2f}", (3.1, y + 0.14), colour=ink, anchor="midleft")
    picture.text(f"sum m v^2 / 2 = {e:.2f}", (3.1, y - 0.16), colour=ink, anchor="midleft")


def readings(game: Cradle) -> Readings:
    """Return the set-up, the momentum along the row and the energy."""
    return [
        ("balls", f"{game.count}"),
        ("pulled out", f"{game.pulled}"),
        ("masses", "unequal" if game.is_unequal else "equal"),
        ("restitution", f"{game.restitution:g}"),
        ("pairs strike", game.law),
        ("momentum along x", f"{game.world.momentum()[0]:.2f} kg m/s"),
        ("energy", f"{game.energy():.9f} J"),
    ]


PROGRAM = Program(
    name="cradle",
    title="Newton's cradle",
    game=Cradle,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    keys=(
        ("drag", "pull balls out"),
        ("1 ... 9", "balls to pull out"),
        ("up  down", "more balls, fewer"),
        ("A", "strike in turn, or at once"),
        ("W   E", "masses   restitution"),
    ),
    forbids=dict.fromkeys(("grab", "gravity", "restitution", "friction", "mass"), STRINGS),
    camera=Camera(left=-5.4, bottom=-0.6, scale=74.0),  # nine balls swing within it
    tour=(
        (0, Input("press", "2")),
        (480, Input("press", "3")),
        (960, Input("press", "a")),
        (1440, Input("press", "1")),
        (1920, Input("press", "a")),
        (1920, Input("press", "w")),
    ),
    effects=lambda: ImpactEffects(Flashes(least_impulse=0.3), sounds=Sounds("steel", 0.3, 3.0)),
)
