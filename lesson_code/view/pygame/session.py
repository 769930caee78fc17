"""A game while it is played: what keys, mouse and time do to it.

The keys that all programs share stand in one table, :data:`ACTIONS`: it binds them, and the page of
help is made from it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from time import perf_counter
from typing import Any, TypeAlias

from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY
from lesson_code.engine.live_world import TIME_STEP
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.view.pygame.game import Game, Input
from lesson_code.view.pygame.ledger import Ledger
from lesson_code.view.pygame.picture import FIELD_SIZE, Camera
from lesson_code.view.pygame.program import Program, Readings
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.window import pygame

LONGEST_FRAME = 0.1
"""s: a longer one counts as this. A machine that is too slow shows slow motion, and not jerks."""

STEPPING_SECONDS = 0.012
"""s: after that no further step begins in a frame, so that keys are heard between slow ones."""

SLOW_MOTION = 0.2
"""Of the usual speed."""

STEPS_A_SAVE, MOST_SAVES = 60, 120
"""Steps between two states that are saved for the way back, and how many are kept: two minutes."""

NEWS_STEPS = 30
"""Steps that the impulse of an impact stays in the picture."""

MOST_NEWS = 400

SLIDERS = {
    "gravity": ("gravity, m/s\N{SUPERSCRIPT TWO}", 0.0, 20.0),
    "restitution": ("restitution e", 0.0, 1.0),
    "friction": ("friction \N{GREEK SMALL LETTER MU}", 0.0, 1.0),
    "mass": ("mass of the body last grabbed, kg", 0.1, 20.0),
}
"""By name: what stands beside a slider, and its ends."""

News: TypeAlias = tuple[int, Touch]
"""A step, and a touch that began in it."""


class Session:
    """A game while it is played.

    Parameters
    ----------
    program : Program
        What is played.
    game : Game
        The game itself.
    recording : Recording
        Where inputs are written down; with inputs in it, they are played again.
    ghost : Game, optional
        Another game that gets the same inputs, and is drawn pale beside it.

    Attributes
    ----------
    games : list of Game
        The game, and the ghost where there is one.
    waits : bool
        Whether time stands still until machine code is there.
    shown : set of str
        What keys have added to the picture.
    wanted : list of str
        What the window is to do after this frame: "screenshot", "film" and so on.
    """

    def __init__(
        self, program: Program, game: Game, recording: Recording, ghost: Game | None = None
    ) -> None:
        self.program, self.game, self.recording, self.ghost = program, game, recording, ghost
        self.games = [game] if ghost is None else [game, ghost]
        self.effects = program.effects()
        self.effects.listen_to(game)
        game.listeners.append(lambda touch: self.news.append((self.steps, touch)))
        self.camera: Camera = program.camera
        self.field: pygame.Rect = pygame.Rect((0, 0), FIELD_SIZE)
        self.tour: tuple[tuple[int, Input], ...] = ()
        self.running = True
        self.paused = self.slow = self.waits = self._wants_step = False
        self.steps = 0
        self.shown: set[str] = set()
        self.wanted: list[str] = []
        self.sliders: dict[str, float] = {}
        self.rails: dict[str, pygame.Rect] = {}
        self._sliding = ""
        self.selected: int | None = None
        self.message, self._message_ends = "", 0.0
        self.news: deque[News] = deque(maxlen=MOST_NEWS)
        self.ledger = Ledger(game, program.camera.bottom if program.camera.up > 0 else 0.0)
        self._saves: deque[tuple[int, list[dict[str, Any]]]] = deque(maxlen=MOST_SAVES)
        self._was_touched = True
        self._left_over = 0.0

    # Events

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event of the window."""
        if event.type == pygame.QUIT:
            self.running = False
        elif event.type == pygame.KEYDOWN:
            self.press(pygame.key.name(event.key))
        elif event.type == pygame.KEYUP:
            self.give(Input("release", pygame.key.name(event.key)))
        elif event.type == pygame.MOUSEMOTION and self._sliding:
            self._slide_to(event.pos[0])
        elif event.type == pygame.MOUSEMOTION:
            self._move(self.place_of(event.pos))
        elif event.type == pygame.MOUSEBUTTONDOWN and self.field.collidepoint(event.pos):
            self._button_down(event.button, self.place_of(event.pos))
        elif event.type == pygame.MOUSEBUTTONDOWN:
            found = [name for name, rail in self.rails.items() if rail.collidepoint(event.pos)]
            self._sliding = found[0] if found else ""
            self._slide_to(event.pos[0])
        elif event.type == pygame.MOUSEBUTTONUP:
            self._sliding = ""
            self._button_up(event.button, self.place_of(event.pos))

    def handle_all(self, events: Iterable[pygame.event.Event]) -> bool:
        """Take some events; return whether the session goes on."""
        for event in events:
            self.handle(event)
        return self.running

    def press(self, key: str) -> None:
        """Do what a key stands for: in all programs, or else in this one."""
        action = BOUND.get(key)
        if action is None:
            self.give(Input("press", key))
        else:
            action.do(self)

    def give(self, given: Input) -> None:
        """Give the game an input, and write it down; not while a recording is played."""
        if not self.recording.is_played:
            self.recording.note(self.steps, given)
            self._take(given)

    def say(self, words: str) -> None:
        """Show a message for some seconds."""
        self.message, self._message_ends = words, perf_counter() + 4.0

    def place_of(self, pixel: tuple[int, int]) -> XY:
        """Return the point of the world that a pixel's centre shows."""
        return self.camera.screen_to_world((pixel[0] + 0.5, pixel[1] + 0.5))

    def _take(self, given: Input) -> None:
        """Let the game take an input; what keys show is no part of it."""
        self._was_touched = True
        if given.kind == "show":
            self.shown ^= {given.key}
        else:
            for game in self.games:
                game.take(given)

    def _button_down(self, button: int, place: XY) -> None:
        """Handle a press in the field: the left button is the program's, the right one grabs."""
        if button == 1:
            self.give(Input("down", place=place))
        elif button == 3:
            self.selected = self.game.body_at(place)
            if "grab" in self.program.forbids:
                self.say(self.program.forbids["grab"])
            else:
                self.give(Input("grab", place=place))

    def _move(self, place: XY) -> None:
        """Handle a movement: what is held follows."""
        if self.game.hand is not None:
            self.give(Input("put" if self.paused else "pull", place=place))
        else:
            self.give(Input("move", place=place))

    def _button_up(self, button: int, place: XY) -> None:
        """Handle the release of a button."""
        if button == 1:
            self.give(Input("up", place=place))
        elif button == 3:
            self.give(Input("drop", place=place))

    # What keys do in every program

    def show(self, what: str) -> None:
        """Add something to the picture, or take it away; in a recording that is played, too."""
        if self.recording.is_played:
            self.shown ^= {what}
        self.give(Input("show", what))

    def toggle_pause(self) -> None:
        """Pause or go on, and sounds with it."""
        self._pause(not self.paused)

    def want_step(self) -> None:
        """Pause, and make one step."""
        self._pause(True)
        self._wants_step = True

    def toggle_slow(self) -> None:
        """Go into slow motion, or out of it."""
        self.slow = not self.slow

    def toggle_sound(self) -> None:
        """Be silent, or no longer."""
        if self.effects.sounds is not None:
            self.effects.sounds.mute()

    def stop(self) -> None:
        """End the session."""
        self.running = False

    def keep(self) -> None:
        """Keep what there is now: R comes back to it."""
        self.give(Input("keep"))
        self.say("kept: R comes back to this")

    def open_scene(self, text: str) -> None:
        """Begin with the scene of a file's text; R comes back to it."""
        if not self.recording.is_played:
            given = Input("open", text)
            self._take(given)  # what is refused is not written down
            self.recording.note(self.steps, given)
            self.give(Input("keep"))

    def restart(self) -> None:
        """Come back to what was kept, or to the start; what sliders were set to stays."""
        if self.game.has_kept:
            self.give(Input("restore"))
        else:
            self.give(Input("press", "r"))
            for name, value in self.sliders.items():
                self.give(Input("set", name, (value, 0.0)))

    def restart_as_given(self) -> None:
        """Forget what was kept and set, and begin as the program came."""
        self.sliders.clear()
        self.give(Input("forget"))
        self.give(Input("press", "r"))

    def slide(self, name: str, value: float) -> None:
        """Set a slider."""
        if name == "mass":
            if self.selected is not None:
                self.give(Input("set", name, (value, float(self.selected))))
            return
        self.sliders[name] = value
        self.give(Input("set", name, (value, 0.0)))

    def slider_values(self) -> dict[str, tuple[str, float, float, float | None]]:
        """Return label, both ends and value of the sliders that the program's rules allow."""
        world = self.game.world
        bodies = [body for _, body in world.items()]
        values: dict[str, float | None] = {
            "gravity": -world.gravity[1] + 0.0,
            "restitution": common([body.material.restitution for body in bodies]),
            "friction": common([body.material.friction for body in bodies]),
            "mass": None,
        }
        if self.selected is not None and self.selected in world:
            values["mass"] = world.body(self.selected).mass
        return {
            name: (*about, values[name])
            for name, about in SLIDERS.items()
            if bodies and name not in self.program.forbids
        }

    def _slide_to(self, x: float) -> None:
        """Move the slider that is held to a place, px."""
        if self._sliding in self.rails:
            rail = self.rails[self._sliding]
            _, low, high = SLIDERS[self._sliding]
            part = min(max((x - rail.left) / rail.width, 0.0), 1.0)
            self.slide(self._sliding, round(low + part * (high - low), 2))

    def want(self, what: str) -> None:
        """Ask the window for something that it does after this frame."""
        self.wanted.append(what)

    # Time

    def tick(self, elapsed: float, seconds: float = float("inf")) -> int:
        """Advance by the time of one frame, s; return the number of steps made.

        After some `seconds` of work no other step begins: what is left over is given up.
        """
        self._left_over += min(elapsed, LONGEST_FRAME) * (SLOW_MOTION if self.slow else 1.0)
        steps = whole_parts(self._left_over, TIME_STEP)
        self._left_over = max(self._left_over - steps * TIME_STEP, 0.0)
        if self.paused:
            steps, self._left_over = int(self._wants_step), 0.0
        self._wants_step = False
        end = perf_counter() + seconds
        for made in range(steps):
            if made and perf_counter() > end:
                return made
            self.step()
        return steps

    def step(self) -> None:
        """Make one step of the game."""
        if self.steps % STEPS_A_SAVE == 0 and (not self._saves or self._saves[-1][0] != self.steps):
            self._saves.append((self.steps, [game.saved() for game in self.games]))
        for given in self.recording.inputs_at(self.steps):
            self._take(given)
        for step, given in self.tour:
            if step == self.steps:
                self._tour(given)
        self._advance()
        if self.recording.is_over(self.steps):
            self.running = False

    def step_back(self) -> None:
        """Undo one step: go back to a state that was saved, and make the steps after it again."""
        self._pause(True)
        wanted = self.steps - 1
        while self._saves and self._saves[-1][0] > wanted:
            self._saves.pop()
        if not self._saves:
            self.say("no further back")
            return
        self.ledger.forget(self.steps - self._saves[-1][0])
        self.steps, saved = self._saves[-1]
        for game, state in zip(self.games, saved, strict=True):
            game.restore(state)
        while self.steps < wanted:
            for given in self.recording.before(self.steps):
                if given.kind != "show":
                    self._take(given)
            self._advance()
        self.recording.forget_from(self.steps)
        self.news = deque((n for n in self.news if n[0] <= self.steps), maxlen=MOST_NEWS)

    def _advance(self) -> None:
        """Let the game make a step, and note what came of it."""
        if self._was_touched:
            self.ledger.before_step()
            self._was_touched = False
        self.effects.step(TIME_STEP)
        for game in self.games:
            game.pull_grip()
        if self.game.hand is not None:
            self.ledger.before_step()  # the hand has pushed
        for game in self.games:
            game.step()
        self.steps += 1
        self.ledger.after_step(TIME_STEP)
        if self.effects.trails is not None:
            self.effects.trails.step(self.game.trailed())

    def _tour(self, given: Input) -> None:
        """Do what the tour does next; its keys are those of the window."""
        if given.kind == "press":
            self.press(given.key)
        else:
            self.give(given)

    def _pause(self, paused: bool) -> None:
        """Pause or resume time, and sounds with it."""
        self.paused = paused
        if self.effects.sounds is not None:
            self.effects.sounds.hold(paused)

    # What is said of it

    def switched(self) -> Readings:
        """Return what the keys that all programs share have changed, and messages."""
        sounds = self.effects.sounds
        changes = (
            (self.paused, "PAUSED", "P goes on"),
            (self.waits, "one moment", "getting ready"),
            (self.slow, "slow motion", f"{SLOW_MOTION:g} x"),
            (sounds is not None and sounds.muted, "sound", "muted"),
            (perf_counter() < self._message_ends, self.message, ""),
        )
        return [(name, value) for is_on, name, value in changes if is_on]


def common(values: list[float | None]) -> float | None:
    """Return the value that all have, or None.

    >>> common([0.5, 0.5]), common([0.5, 1.0])
    (0.5, None)
    """
    return values[0] if len(set(values)) == 1 else None


@dataclass(frozen=True)
class Action:
    """What a key does in every program.

    Attributes
    ----------
    key : str
        By pygame's name.
    group, meaning : str
        As the page of help shows it.
    do : callable
        ``do(session)`` does it.
    """

    key: str
    group: str
    meaning: str
    do: Callable[[Session], None]

    @property
    def label(self) -> str:
        """The key as it is written on a keyboard."""
        return "ESC" if self.key == "escape" else self.key.upper()


def _shows(key: str, meaning: str, what: str) -> Action:
    """Return the action that adds something to the picture."""
    return Action(key, "show", meaning, lambda session: session.show(what))


def _wants(key: str, meaning: str, what: str) -> Action:
    """Return the action that asks something of the window."""
    return Action(key, "keep", meaning, lambda session: session.want(what))


ACTIONS = (
    Action("p", "time", "pause, go on", Session.toggle_pause),
    Action("o", "time", "one step", Session.want_step),
    Action("u", "time", "one step back", Session.step_back),
    Action("l", "time", "slow motion", Session.toggle_slow),
    _shows("v", "velocities, with values", "velocities"),
    _shows("k", "momenta, with values", "momenta"),
    _shows("i", "impulses, with values", "impulses"),
    _shows("x", "centre of mass", "centre"),
    _shows("j", "energy and its parts", "energy"),
    _shows("t", "colours and arrows: their key", "legend"),
    _shows("tab", "sliders", "sliders"),
    Action("r", "set-up", "start again: your set-up", Session.restart),
    Action("s", "set-up", "keep this as your set-up", Session.keep),
    Action("backspace", "set-up", "as the program came", Session.restart_as_given),
    _wants("f4", "ledger as a CSV file", "ledger"),
    _wants("f5", "scene as a file", "save scene"),
    _wants("f6", "open the newest scene file here", "open scene"),
    _wants("f9", "film: begin, end", "film"),
    _wants("f12", "screenshot", "screenshot"),
    _wants("f11", "full screen", "full screen"),
    Action("m", "window", "sound", Session.toggle_sound),
    Action("h", "window", "this page", lambda session: session.show("help")),
    Action("escape", "window", "quit", Session.stop),
)
"""The keys that every program has. They are in one table, and mean the same everywhere."""

BOUND = {action.key: action for action in ACTIONS}
