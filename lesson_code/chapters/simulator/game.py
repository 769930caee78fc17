"""The simulator: launch balls, and watch momentum and energy go from one to the other.

What to notice: whatever the mode, the total momentum jumps only at the walls. The energy is kept
in the elastic mode alone.
"""

from __future__ import annotations

import json
import math
from collections import deque
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from lesson_code.chapters.simulator.plan_page import draw_plan
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Circle
from lesson_code.scene_file import ROOMS, scene_of, set_up_of, understood
from lesson_code.view.pygame.effects import Flashes
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.panel import Panel
from lesson_code.view.pygame.picture import COLOURS, FLASH, Picture
from lesson_code.view.pygame.program import (
    ImpactEffects,
    Program,
    Readings,
    draw_bodies,
    motion_readings,
    room,
)
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import ORANGE, SKY

WIDTH, HEIGHT = 8.0, 6.0
"""m."""

MIDDLE = (WIDTH / 2, HEIGHT / 2)
"""m: the origin of scene files."""

MODES = {"1": ("elastic", 1.0), "2": ("partial", 0.6), "3": ("perfectly inelastic", 0.0)}
"""By key: name and restitution."""

BALLS, MANY = 12, 50
MOST_BALLS = 600
"""The most balls that there may be: in machine code 600 leave half of the frame's time."""

DENSITY = 10.0
"""kg/m^2."""

LAUNCH_RATE = 4.0
"""1/s: a drag of 1 m launches at 4 m/s."""

LAUNCHED_RADIUS = 0.25
HISTORY = 240
"""Steps that the curves show: four seconds."""

FALL = (0.0, -9.81)
FORCED = (
    "Forced: the scene does not call for it, and this world reckons with it all the same, so that "
    "its program stays as it is when bodies join. That changes no digit of the result. "
    "Flashes and sounds are no callbacks of the scene: they are told after each step."
)
"""What the page of the plan has to say beside the table."""


class Simulator(Game):
    """Balls in a room, launched by hand."""

    def __init__(self, seed: int = 0, balls: int = BALLS) -> None:
        if not 0 <= balls <= MOST_BALLS:
            raise ValueError(f"balls must be a whole number from 0 to {MOST_BALLS}, got {balls}")
        self.ball_count = balls
        self.mode = "1"
        self.falls = False
        self.plan: tuple[float, Plan] | None = None
        super().__init__(seed)

    def reset(self) -> None:
        """Fill the room as at the start."""
        self.random.seed(self.seed)
        self.surface = Material(restitution=MODES[self.mode][1], friction=0.0)
        self._begin((WIDTH, HEIGHT), FALL if self.falls else (0.0, 0.0))
        self._scatter(self.ball_count)

    def _begin(self, size: XY | None, gravity: XY, bodies: Iterable[Body] = ()) -> None:
        """Begin with a room of a size about the middle of the picture, and bodies in it."""
        self.aim: tuple[int, XY] | None = None
        self.history: deque[tuple[float, float]] = deque(maxlen=HISTORY)
        self.room_size = size
        walls: list[Body] = []
        if size is not None:
            (x, y), (w, h) = MIDDLE, size
            walls = room(x - w / 2, y - h / 2, x + w / 2, y + h / 2, self.surface)
        self.walls = tuple(range(len(walls)))
        self.world = LiveWorld([*walls, *bodies], gravity=gravity, callbacks=self.callbacks)

    def set_up(self) -> dict[str, Any]:
        """Return what a scene file holds of the balls as they are; its origin is the middle."""
        if self.aim is not None:
            raise ValueError("let go of the ball first: a scene file holds no hand")
        bodies = self.world.bodies()[len(self.walls) :]
        return set_up_of(
            [_shifted(body, -1.0) for body in bodies],
            surface=self.surface,
            gravity=-self.world.gravity[1] + 0.0,
            room=self.room_size,
        )

    def open_scene(self, text: str) -> None:
        """Begin with the bodies of a scene file, whose origin is the middle of the picture."""
        given = understood(json.loads(text))
        scene = scene_of(given)
        bodies = [_shifted(body, 1.0) for body in scene.bodies if not body.is_static]
        width, height = given.get("room", ROOMS[given["dimensions"]])
        if width > WIDTH or height > HEIGHT:
            raise ValueError(f"room must fit into [{WIDTH:g}, {HEIGHT:g}], got {[width, height]}")
        if len(bodies) > MOST_BALLS:
            raise ValueError(f"bodies must be a list of at most {MOST_BALLS}, got {len(bodies)}")
        self.surface = Material(given["elasticity"] / 100, given["friction"])
        self.falls = scene.gravity != (0.0, 0.0)
        self._begin((width, height) if given["walls"] else None, scene.gravity, bodies)

    def set(self, name: str, value: float, number: float = 0.0) -> None:
        """Set what a slider stands for; balls that join later have the same surface."""
        super().set(name, value, number)
        if name in ("restitution", "friction"):
            self.surface = replace(self.surface, **{name: value})

    @property
    def balls(self) -> list[int]:
        """The numbers of the balls."""
        return [number for number in self.world.numbers if number not in self.walls]

    def _scatter(self, count: int) -> None:
        """Put balls into the cells of a grid, so that none overlap."""
        columns = max(1, math.ceil(math.sqrt(count * WIDTH / HEIGHT)))
        rows = max(1, math.ceil(count / columns))
        wide, high = WIDTH / columns, HEIGHT / rows
        largest = 0.42 * min(wide, high)
        for k in range(count):
            radius = self.random.uniform(0.4, 1.0) * min(largest, 0.4)
            place = (wide * (k % columns + 0.5), high * (k // columns + 0.5))
            angle, speed = self.random.uniform(0, 2 * math.pi), self.random.uniform(0.5, 2.5)
            self._add(place, radius, (speed * math.cos(angle), speed * math.sin(angle)))

    def _add(self, place: XY, radius: float, velocity: XY = (0.0, 0.0)) -> int:
        """Add a ball."""
        return self.world.add(
            Body(
                Circle(radius),
                position=place,
                velocity=velocity,
                mass=DENSITY * math.pi * radius**2,
                material=self.surface,
            )
        )

    def press(self, key: str) -> None:
        """Change mode, gravity or what is shown; add balls; start again."""
        super().press(key)
        if key in MODES:
            self.mode = key
            self.set("restitution", MODES[key][1])
        elif key == "g":
            self.falls = not self.falls
            self.world.pull(FALL if self.falls else (0.0, 0.0))
        elif key == "b":
            self._pour(min(MANY, MOST_BALLS - len(self.balls)))
        elif key == "c":
            for ball in self.balls:
                self.world.remove(ball)
            self.aim = None
        if key == "f":
            self.plan = self._made_plan() if self.plan is None else None
        elif self.plan is not None:
            self.plan = self._made_plan()

    def _made_plan(self) -> tuple[float, Plan]:
        """Return the time, s, and the plan for the scene as it is now."""
        return self.world.time, self.world.plan()

    def _pour(self, count: int) -> None:
        """Add small balls where there is room; where there is none, none is added."""
        taken = [(*self.world.position(b), self._radius(b)) for b in self.balls]
        for _ in range(20 * count):
            radius = self.random.uniform(0.06, 0.1)
            x = self.random.uniform(radius, WIDTH - radius)
            y = self.random.uniform(radius, HEIGHT - radius)
            if count > 0 and all(math.hypot(x - u, y - v) > radius + r for u, v, r in taken):
                velocity = self.random.uniform(-1, 1), self.random.uniform(-1, 1)
                self._add((x, y), radius, velocity)
                taken.append((x, y, radius))
                count -= 1

    def _radius(self, number: int) -> float:
        """Return a ball's radius, m."""
        return self.world.body(number).shape.bounding_radius

    def down(self, place: XY) -> None:
        """Take hold of the ball under the mouse, or of a new one."""
        if self.plan is not None:
            return  # its page is in front of the balls
        for ball in self.balls:
            if math.dist(place, self.world.position(ball)) <= self._radius(ball):
                self._hold(ball, place)
                return
        r = LAUNCHED_RADIUS
        if len(self.balls) < MOST_BALLS and _is_inside(place, r) and self._is_free(place, r):
            self._hold(self._add(place, r), place)

    def _hold(self, ball: int, place: XY) -> None:
        """Hold a ball still and aim: to the others it is a wall, which takes no energy."""
        if self.aim is not None:
            self.world.release(self.aim[0])
        self.world.hold(ball)
        self.aim = ball, place

    def _is_free(self, place: XY, radius: float) -> bool:
        """Return whether a ball would overlap no other one."""
        return all(
            math.dist(place, self.world.position(ball)) > radius + self._radius(ball)
            for ball in self.balls
        )

    def drag(self, place: XY) -> None:
        """Aim."""
        if self.aim is not None:
            self.aim = self.aim[0], place

    def let_go(self, place: XY) -> None:
        """Launch the ball that is held."""
        if self.aim is not None:
            ball, self.aim = self.aim[0], None
            self.world.release(ball, self.launch_velocity(ball, place))

    def launch_velocity(self, ball: int, place: XY) -> XY:
        """Return the velocity that a drag from a ball to a place gives it, m/s."""
        x, y = self.world.position(ball)
        return LAUNCH_RATE * (place[0] - x), LAUNCH_RATE * (place[1] - y)

    def step(self) -> None:
        """Make one step."""
        self.world.step()
        px, py = self.world.momentum()
        self.history.append((math.hypot(px, py), self.world.kinetic_energy()))


def _shifted(body: Body, way: float) -> Body:
    """Return a body in the picture's coordinates for one about its middle; -1: the way back."""
    (x, y), (to_x, to_y) = body.position, MIDDLE
    return replace(body, position=(x + way * to_x, y + way * to_y))


def _is_inside(place: XY, radius: float) -> bool:
    """Return whether a ball at a place lies inside the room."""
    return radius < place[0] < WIDTH - radius and radius < place[1] < HEIGHT - radius


BALL = Mark("disc", COLOURS[0], "ball: colours tell them apart")
HIT = Mark("disc", FLASH, "just hit")
LAUNCH = Mark("arrow", ORANGE, "velocity of the launch")
MOMENTUM = Mark("line", SKY, "curve: size of the momentum")
ENERGY = Mark("line", ORANGE, "curve: kinetic energy")
LEGEND = (BALL, HIT, LAUNCH, MOMENTUM, ENERGY)


def draw(game: Simulator, picture: Picture, effects: ImpactEffects) -> None:
    """Draw balls, and what is asked for of arrows and contacts."""
    picture.grid(1.0)
    if len(game.world) > 100:
        _draw_many(game, picture)
    else:
        draw_bodies(game.world, picture, effects)
    if game.aim is not None:
        ball, place = game.aim
        vx, vy = game.launch_velocity(ball, place)
        picture.arrow(
            game.world.position(ball), (vx / LAUNCH_RATE, vy / LAUNCH_RATE), LAUNCH.colour
        )
    if game.plan is not None:
        time, plan = game.plan
        title = f"Plan for the scene as it was at {time:.1f} s (F closes it)"
        draw_plan(picture.window, plan, title, FORCED)


def _draw_many(game: Simulator, picture: Picture) -> None:
    """Draw all balls at once, without spokes, too small to see, and flashes: all would be white."""
    walls = len(game.walls)
    balls = list(game.world.items())[walls:]
    picture.discs(
        game.world.states()[walls:, :2],
        [body.shape.bounding_radius for _, body in balls],
        [COLOURS[number % len(COLOURS)] for number, _ in balls],
    )


def readings(game: Simulator) -> Readings:
    """Return mode, momentum, energy and count."""
    name, restitution = MODES[game.mode]
    is_as_mode = game.surface.restitution == restitution
    return [
        ("mode", name if is_as_mode else "own restitution"),
        ("restitution", f"{game.surface.restitution:g}"),
        ("balls", f"{len(game.balls)}"),
        *motion_readings(game.world),
    ]


def more(game: Simulator, panel: Panel) -> None:
    """Draw the history of momentum and energy."""
    panel.curve("size of the momentum, 4 s", [p for p, _ in game.history], MOMENTUM.colour)
    panel.curve("kinetic energy, 4 s", [e for _, e in game.history], ENERGY.colour)


PROGRAM = Program(
    name="simulator",
    title="Simulator",
    game=Simulator,
    draw=draw,
    readings=readings,
    legend=LEGEND,
    more=more,
    keys=(
        ("drag", "launch a ball, old or new"),
        ("1   2   3", "elastic   partial   inelastic"),
        ("B   C", "50 more balls   clear"),
        ("G   F", "gravity   plan of effects"),
    ),
    tour=((0, Input("press", "v")), (0, Input("press", "i"))),
    effects=lambda: ImpactEffects(
        Flashes(least_impulse=0.05), sounds=Sounds("ivory", 0.2, full_impulse=8.0)
    ),
)
