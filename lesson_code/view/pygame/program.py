"""What a program is: a game, its title, a camera, a way of drawing; and what programs share."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

from lesson_code.engine.core.scene import Body, Material
from lesson_code.engine.live_world import LiveWorld
from lesson_code.geometry.shapes import Segment
from lesson_code.view.pygame.effects import Flashes, Sparks, Trails
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import COLOURS, WALL, Camera, Picture
from lesson_code.view.pygame.sound import Sounds
from lesson_code.view.pygame.window import Colour

Readings: TypeAlias = list[tuple[str, str]]
"""Names and values, as the panel shows them."""

Keys: TypeAlias = tuple[tuple[str, str], ...]
"""Keys and what they do, as the panel shows them."""

WALL_HALF = 4.0
"""m: half thickness of the walls of a room, most of which lies outside the picture. What a heap
presses into a wall by more than this would be pushed out on the other side."""


@dataclass(frozen=True)
class ImpactEffects:
    """The effects that a program is shown with; any of them may be left out."""

    flashes: Flashes | None = None
    sparks: Sparks | None = None
    trails: Trails | None = None
    sounds: Sounds | None = None

    def listen_to(self, game: Game) -> None:
        """Receive the touches of a game."""
        for effect in (self.flashes, self.sparks, self.sounds):
            if effect is not None:
                game.listeners.append(effect.hit)

    def step(self, dt: float) -> None:
        """Let time pass, s."""
        if self.flashes is not None:
            self.flashes.step(dt)
        if self.sparks is not None:
            self.sparks.step(dt)
        if self.sounds is not None:
            self.sounds.step()

    def colour(self, number: int, colour: Colour) -> Colour:
        """Return the colour of a body, lighter if it flashes."""
        return colour if self.flashes is None else self.flashes.colour(number, colour)


@dataclass(frozen=True)
class Program:
    """A game and how it is shown.

    Attributes
    ----------
    name, title : str
        What it is called, and what its window is called.
    game : callable
        ``game(seed)`` makes one.
    draw : callable
        ``draw(game, picture, effects)`` draws the field.
    readings : callable
        ``readings(game)`` returns what the panel shows.
    keys : tuple
        The program's own keys.
    camera : Camera
        What is seen.
    effects : callable
        Makes its effects.
    more : callable
        ``more(game, panel)`` writes what else is in the panel.
    tour : tuple of (int, Input)
        Steps and inputs with which the program plays itself.
    forbids : mapping
        What its rules forbid of what a laboratory allows, and why: "grab", "gravity",
        "restitution", "friction", "mass".
    length : str
        The unit of lengths in its world.
    own : tuple of callable
        The lesson's functions that a player may write for it.
    with_own : callable, optional
        ``with_own(*functions)`` returns the settings of a game that runs on others in their place.
    legend : tuple of Mark
        What its colours and arrows mean; they are drawn from the same marks.
    """

    name: str
    title: str
    game: Callable[..., Game]
    draw: Callable[..., None]
    readings: Callable[..., Readings]
    keys: Keys
    camera: Camera = Camera(0.0, 0.0, 100.0)  # noqa: RUF009 - it never changes
    effects: Callable[[], ImpactEffects] = ImpactEffects
    more: Callable[..., None] | None = None
    tour: tuple[tuple[int, Input], ...] = ()
    forbids: Mapping[str, str] = field(default_factory=dict)
    length: str = "m"
    own: tuple[Callable[..., Any], ...] = ()
    with_own: Callable[..., dict[str, Any]] | None = None
    legend: tuple[Mark, ...] = ()


def room(left: float, bottom: float, right: float, top: float, material: Material) -> list[Body]:
    """Return four walls round a rectangle, m; their inner faces are its sides."""
    h = WALL_HALF
    corners = [
        (left - h, bottom - h),
        (right + h, bottom - h),
        (right + h, top + h),
        (left - h, top + h),
    ]
    sides = zip(corners, corners[1:] + corners[:1], strict=True)
    return [Body(Segment(start, end, h), material=material) for start, end in sides]


def draw_bodies(
    world: LiveWorld,
    picture: Picture,
    effects: ImpactEffects,
    colours: Callable[[int], Colour] = lambda number: COLOURS[number % len(COLOURS)],
) -> None:
    """Draw all bodies of a world: walls grey, the others in turn in the colours there are."""
    for (number, body), state in zip(world.items(), world.states().tolist(), strict=True):
        x, y, angle = state[:3]
        colour = WALL if body.is_static else effects.colour(number, colours(number))
        picture.body(body, (x, y), angle, colour)


def motion_readings(world: LiveWorld) -> Readings:
    """Return momentum and energy of a world, as every panel shows them."""
    px, py = world.momentum()
    return [
        ("momentum", f"({short(px)}, {short(py)}) kg m/s"),
        ("kinetic energy", f"{short(world.kinetic_energy())} J"),
    ]


def short(value: float) -> str:
    """Return a number as the panel has room for it.

    >>> short(3.14159), short(-271.83), short(1.6e7), short(-0.001)
    ('3.14', '-272', '1.6e+07', '0.00')
    """
    if abs(value) < 100:
        return f"{round(value, 2) + 0.0:.2f}"
    return f"{value:.0f}" if abs(value) < 1e5 else f"{value:.1e}"
