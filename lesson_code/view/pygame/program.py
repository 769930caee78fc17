"""What a program is: a game that knows no window, and how it is shown.

A `Game` is a world with rules. It takes inputs in its own terms (keys by name, places in metres)
and makes equal steps; so the same seed and the same inputs give the same world, with a window or
without. A `Program` puts a title, a camera and a way of drawing beside it.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Callable, Mapping
from copy import deepcopy
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.callbacks import Callbacks, Touch
from lesson_code.engine.core.scene import XY, Body, Material
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.geometry.shapes import Segment
from lesson_code.view.pygame.effects import Flashes, Sparks, Trails
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
class Input:
    """What a player does: a key, by pygame's name, or the mouse, in the world's metres.

    Attributes
    ----------
    kind : str
        "press" or "release" for a key; "down", "move" or "up" for the left mouse button; "grab",
        "pull", "put" or "drop" for a body that the right one holds; "set" for a slider; "keep",
        "restore" and "forget" for a set-up; "show" for what keys add to the picture.
    key : str
        Its name, such as "r" or "left"; of a slider "gravity", "restitution", "friction" or "mass";
        what is shown.
    place : (float, float)
        Where the mouse is, m; a slider's value, and for a mass the body's number.
    """

    kind: str
    key: str = ""
    place: XY = (0.0, 0.0)


MOUSE = {
    "down": "down",
    "move": "drag",
    "up": "let_go",
    "grab": "grab",
    "pull": "pull",
    "put": "put",
    "drop": "drop",
}
"""What a game does with each kind of input of the mouse."""

NOT_SAVED = {"listeners", "_kept"}
"""What belongs to the window, or outlives a set-up."""

GRIP_RATE = 20.0
"""1/s: of the spring by which the mouse holds a body; it follows within a tenth of a second."""


class UnreadableError(ValueError):
    """A player's file cannot be read, so that no rule of it can be asked."""


class EndlessError(TimeoutError):
    """A player's function gave no answer in time.

    Parameters
    ----------
    words : str
        Which call it was.
    lesson : callable, optional
        The lesson's own, which answers in its place; in a student's copy it is not there.
    """

    def __init__(self, words: str, lesson: Callable[..., Any] | None = None) -> None:
        super().__init__(words)
        self.lesson = lesson


Matter: TypeAlias = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


@dataclass(frozen=True)
class Grip:
    """A body that the mouse holds.

    Attributes
    ----------
    number : int
        The body's.
    arm : (float, float)
        m, from its centre to where it is held.
    place : (float, float)
        m, where the mouse is.
    """

    number: int
    arm: XY
    place: XY

    @property
    def centre(self) -> XY:
        """Where the body's centre is wanted, m."""
        return self.place[0] - self.arm[0], self.place[1] - self.arm[1]


class Game:
    """A world with rules; what games share.

    Parameters
    ----------
    seed : int
        Every random number follows from it.

    Attributes
    ----------
    world : LiveWorld
        The bodies; none in a game whose own function moves everything.
    held : set of str
        The keys that are down.
    listeners : list of callable
        Called for each touch that begins; effects and sound are among them.
    missing : dict
        The rules that gave no answer to go on with, and why.
    """

    def __init__(self, seed: int = 0) -> None:
        self.seed = seed
        self.hand: Grip | None = None
        self._kept: dict[str, Any] | None = None
        self.random = Random(seed)  # noqa: S311 - a game, no secret
        self.held: set[str] = set()
        self.listeners: list[Callable[[Touch], None]] = []
        self.missing: dict[Callable[..., Any], str] = {}
        self.world = LiveWorld()
        self.reset()

    @property
    def callbacks(self) -> Callbacks:
        """The callbacks that report touches from the world to the game."""
        return Callbacks(begin=self._hear)

    def _hear(self, touch: Touch) -> None:
        """Handle a touch that begins: the rules first, then the listeners."""
        self.touched(touch)
        for listener in self.listeners:
            listener(touch)

    def take(self, given: Input) -> None:
        """Take one input."""
        if given.kind == "press":
            self.held.add(given.key)
            self.press(given.key)
        elif given.kind == "release":
            self.held.discard(given.key)
        elif given.kind == "set":
            self.set(given.key, *given.place)
        elif given.kind == "keep":
            self._kept = self.saved()
        elif given.kind == "forget":
            self._kept = None
        elif given.kind == "restore" and self._kept is not None:
            self.restore(self._kept)
        elif given.kind in MOUSE:
            getattr(self, MOUSE[given.kind])(given.place)

    # What the frame does in any game

    @property
    def has_kept(self) -> bool:
        """Whether there is a set-up that "restore" comes back to."""
        return self._kept is not None

    def saved(self) -> dict[str, Any]:
        """Return all that the game is now; :meth:`restore` makes it that again.

        Those who listen, and a set-up that is kept, stay what they are.
        """
        state = {name: value for name, value in vars(self).items() if name not in NOT_SAVED}
        return deepcopy(state, {id(self): self})

    def restore(self, saved: dict[str, Any]) -> None:
        """Be again what was saved."""
        vars(self).update(deepcopy(saved, {id(self): self}))

    def set(self, name: str, value: float, number: float = 0.0) -> None:
        """Set what a slider stands for: gravity downward, a coefficient of all, a body's mass."""
        if name == "gravity":
            self.world.pull((0.0, -value))
        elif name == "mass":
            if int(number) in self.world:
                self.world.weigh(int(number), value)
        else:
            self.world.coat(**{name: value})

    def body_at(self, place: XY) -> int | None:
        """Return the body at a place that can be pushed; None where there is none."""
        free = [n for n, body in self.world.items() if not body.is_static]
        spots = [(math.dist(place, self.world.position(n)), n) for n in free]
        inside = [(far, n) for far, n in spots if far <= self.world.body(n).shape.bounding_radius]
        return min(inside)[1] if inside else None

    def grab(self, place: XY) -> None:
        """Take hold of the body at a place."""
        if (number := self.body_at(place)) is not None:
            x, y = self.world.position(number)
            self.hand = Grip(number, (place[0] - x, place[1] - y), place)

    def pull(self, place: XY) -> None:
        """Pull the body that is held towards a place, from the next step on."""
        if self.hand is not None:
            self.hand = replace(self.hand, place=place)

    def put(self, place: XY) -> None:
        """Put the body that is held to a place while time stands still."""
        self.pull(place)
        if self.hand is not None and self.hand.number in self.world:
            self.world.move(self.hand.number, self.hand.centre)

    def drop(self, place: XY) -> None:
        """Let go of the body that is held."""
        self.hand = None

    def pull_grip(self) -> None:
        """Let a spring pull the body that is held, for one step."""
        if self.hand is None or self.hand.number not in self.world:
            self.hand = None
            return
        number, rate, dt = self.hand.number, GRIP_RATE, TIME_STEP
        mass = self.world.body(number).mass or 0.0
        there = zip(self.hand.centre, self.world.position(number), strict=True)
        off, velocity = [a - b for a, b in there], self.world.velocity(number)
        part = mass / (1 + 2 * rate * dt + (rate * dt) ** 2)  # backward Euler: stable at any rate
        x, y = (
            part * (rate**2 * dt * d - (2 * rate * dt + (rate * dt) ** 2) * v)
            for d, v in zip(off, velocity, strict=True)
        )
        self.world.push(number, (x, y))

    # What the frame shows of any game

    @property
    def gravity(self) -> XY:
        """What pulls all bodies, m/s^2."""
        return self.world.gravity

    def matter(self) -> Matter:
        """Return states (N, 6), masses and inertias (N,) of what can be pushed."""
        return self.world.matter()

    def trailed(self) -> dict[int, XY]:
        """Return the places of the bodies that leave a trail, m, by number."""
        return {}

    def stored_energy(self) -> float:
        """Return the energy in springs and the like, J."""
        return 0.0

    def ask(
        self,
        rule: Callable[..., Any],
        *arguments: Any,
        form: Callable[[Any], Any],
        otherwise: Any,
    ) -> Any:
        """Return what a rule says that a player may write; `otherwise` where that is nothing.

        It is nothing while the rule is not written, and where a player's fails or gives what is of
        no use. For one that never ends, the lesson's own answers. As in a check, it is given
        vectors as NumPy arrays of its own.

        Parameters
        ----------
        rule : callable
            The lesson's, whose errors are raised; or a player's, which has an attribute `is_own`.
        *arguments
            What it is called with.
        form : callable
            Brings an answer to the form the game takes, and raises where it cannot.
        otherwise
            Returned as it is.
        """
        try:
            answer = form(rule(*map(_own, arguments)))
        except NotImplementedError as error:
            self.missing[rule] = f"not written yet: {str(error) or rule.__name__}"
            return otherwise
        except EndlessError as error:
            self.missing[rule] = f"{rule.__name__} failed: {error}"
            lesson = error.lesson
            return otherwise if lesson is None else form(lesson(*map(_own, arguments)))
        except Exception as error:  # a player's code may raise anything
            if isinstance(error, UnreadableError) or not hasattr(rule, "is_own"):
                raise
            self.missing[rule] = f"{rule.__name__} failed: {type(error).__name__}: {error}"
            return otherwise
        self.missing.pop(rule, None)
        return answer

    def ask_number(self, rule: Callable[..., Any], *arguments: Any, otherwise: float) -> float:
        """Return the number that a rule says: see :meth:`ask`."""
        return float(self.ask(rule, *arguments, form=numbers(), otherwise=otherwise))

    @property
    def notice(self) -> str:
        """Message to the player in the middle of the field: usually none, or what is missing."""
        return next(iter(self.missing.values()), "")

    def step(self) -> None:
        """Let one time step pass."""
        self.world.step()

    def snapshot(self) -> NDArray[np.float64]:
        """Return where everything is and how it moves: the same in two games, and they are one."""
        return self.world.states()

    # What a game may do

    def reset(self) -> None:
        """Begin anew."""
        raise NotImplementedError

    def press(self, key: str) -> None:
        """Do what a key stands for."""
        if key == "r":
            self.reset()

    def down(self, place: XY) -> None:
        """Handle a press of the mouse button, at a place in m."""

    def drag(self, place: XY) -> None:
        """Handle a move of the mouse."""

    def let_go(self, place: XY) -> None:
        """Handle the release of the mouse button."""

    def touched(self, touch: Touch) -> None:
        """Handle two bodies that begin to touch."""


def numbers(*shape: int) -> Callable[[Any], NDArray[np.float64]]:
    """Return what makes an answer an array of finite numbers of a shape; -1 is any length.

    >>> numbers(2, -1)([[1, 2, 3], [4, 5, 6]]).tolist()
    [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]
    >>> numbers(2)([1.0, None])
    Traceback (most recent call last):
    ...
    ValueError: answer must be 2 finite numbers, got [1.0, None]
    """

    def form(answer: Any) -> NDArray[np.float64]:
        try:
            array = np.array(answer, dtype=float)
        except (TypeError, ValueError):
            array = np.array(np.nan)
        fits = array.ndim == len(shape) and all(
            wanted in (-1, length) for wanted, length in zip(shape, array.shape, strict=True)
        )
        if not fits or not np.isfinite(array).all():
            size = " x ".join("N" if length < 0 else str(length) for length in shape)
            asked = f"{size} finite numbers" if shape else "a finite number"
            raise ValueError(f"answer must be {asked}, got {reprlib.repr(answer)}")
        return array

    return form


def _own(argument: Any) -> Any:
    """Return a vector as an array that belongs to nobody else, and a number as it is."""
    is_vector = isinstance(argument, list | tuple | np.ndarray)
    return np.array(argument, dtype=float) if is_vector else argument


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
