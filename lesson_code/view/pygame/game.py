"""A game: a world with rules that knows no window.

It takes inputs in its own terms (keys by name, places in metres) and makes equal steps; so the same
seed and the same inputs give the same world, with a window or without.
"""

from __future__ import annotations

import math
import reprlib
from collections.abc import Callable
from copy import deepcopy
from dataclasses import dataclass, replace
from random import Random
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.callbacks import Callbacks, Touch
from lesson_code.engine.core.scene import XY
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.engine.matter import Matter


@dataclass(frozen=True)
class Input:
    """What a player does: a key, by pygame's name, or the mouse, in the world's metres.

    Attributes
    ----------
    kind : str
        "press" or "release" for a key; "down", "move" or "up" for the left mouse button; "grab",
        "pull", "put" or "drop" for a body that the right one holds; "set" for a slider; "keep",
        "restore" and "forget" for a set-up; "open" for a scene file; "show" for what keys add to
        the picture.
    key : str
        Its name, such as "r" or "left"; of a slider "gravity", "restitution", "friction" or "mass";
        what is shown; the text of a scene file.
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
    """


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
        elif given.kind == "open":
            self.open_scene(given.key)
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
        """Return what can be pushed, as it is now."""
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

        It is nothing where a player's rule is not written, fails, never ends, or gives what is of
        no use. The lesson's answers in its place, where it is at hand. As in a check, a player's is
        given vectors as NumPy arrays of its own.

        Parameters
        ----------
        rule : callable
            The lesson's, whose errors are raised; or a player's, which has an attribute `is_own`,
            and an attribute `lesson` where the lesson's is at hand.
        *arguments
            What it is called with.
        form : callable
            Brings an answer to the form the game takes, and raises where it cannot.
        otherwise
            Returned as it is.
        """
        given = map(_own, arguments) if hasattr(rule, "is_own") else arguments
        try:
            answer = form(rule(*given))
        except NotImplementedError as error:
            said = f"not written yet: {str(error) or rule.__name__}"
        except EndlessError as error:
            said = f"{rule.__name__} failed: {error}"
        except Exception as error:  # a player's code may raise anything
            if isinstance(error, UnreadableError) or not hasattr(rule, "is_own"):
                raise
            said = f"{rule.__name__} failed: {type(error).__name__}: {error}"
        else:
            self.missing.pop(rule, None)
            return answer
        lesson = getattr(rule, "lesson", None)
        self.missing[rule] = said if lesson is None else f"{said}; the lesson's runs now"
        return otherwise if lesson is None else form(lesson(*arguments))

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

    def set_up(self) -> dict[str, Any]:
        """Return what a scene file holds of the game as it is now."""
        raise ValueError("scene files are for the simulator: this program has rules of its own")

    def open_scene(self, text: str) -> None:
        """Begin with the scene of a file's text."""
        self.set_up()

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
