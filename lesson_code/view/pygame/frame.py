"""The frame of every program: window, clock, keys that all share, recording, pictures.

Time comes in frames of any length and leaves in equal steps. What is left over is kept for the
next frame, so that a world does not depend on how fast it is drawn.
"""

from __future__ import annotations

import inspect
import math
import time
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, contextmanager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import Code
from lesson_code.engine.core.scene import XY
from lesson_code.engine.live_world import TIME_STEP, WORTH_COMPILING, LiveWorld
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.view.pygame.gif import MOST_SECONDS, Gif
from lesson_code.view.pygame.panel import PROGRAM_SIZE, Panel
from lesson_code.view.pygame.picture import FIELD_SIZE, Picture
from lesson_code.view.pygame.program import Game, ImpactEffects, Input, Keys, Program, Readings
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.window import YELLOW, open_window, pygame

LONGEST_FRAME = 0.1
"""s: a longer one counts as this. A machine that is too slow shows slow motion, and not jerks."""

FILM_SIZE = (720, 400)
"""px: two thirds of the window; its small letters can still be read."""

SLOW_MOTION = 0.2
"""Of the usual speed."""

SHARED_KEYS: Keys = (
    ("P   O", "pause   one step"),
    ("L   M", "slow motion   mute"),
    ("ESC", "quit"),
)
"""The keys that every program has; they change time, never the world."""


@dataclass(frozen=True)
class Played:
    """How a run ended.

    Attributes
    ----------
    game : Game
        As it was at the end.
    steps : int
        How many the world has made.
    seconds : ndarray, shape (frames, 2)
        Processor time of each frame, s: for its steps, and for its picture.
    film : Gif, optional
        What was filmed, where that was asked for.
    """

    game: Game
    steps: int
    seconds: NDArray[np.float64]
    film: Gif | None = None

    @property
    def frames(self) -> int:
        """How many pictures were drawn after the first."""
        return len(self.seconds)

    def within(self, part: float) -> float:
        """Return the time within which this share of the frames stays, s: 0.5 is the median."""
        return float(np.quantile(self.seconds.sum(axis=1), part)) if self.frames else 0.0


class Session:
    """A game while it is played: what window events and time do to it.

    Parameters
    ----------
    program : Program
        What is played.
    game : Game
        The game itself.
    recording : Recording
        Where inputs are written down; with inputs in it, they are played again.
    """

    def __init__(self, program: Program, game: Game, recording: Recording) -> None:
        self.program, self.game, self.recording = program, game, recording
        self.effects = program.effects()
        self.effects.listen_to(game)
        self.tour: tuple[tuple[int, Input], ...] = ()
        self.running = True
        self.paused = self.slow = self._wants_step = False
        self.steps = 0
        self._left_over = 0.0

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event of the window."""
        if event.type == pygame.QUIT:
            self.running = False
        elif event.type == pygame.KEYDOWN and not self._shared(event.key):
            self.give(Input("press", pygame.key.name(event.key)))
        elif event.type == pygame.KEYUP:
            self.give(Input("release", pygame.key.name(event.key)))
        elif event.type == pygame.MOUSEMOTION:
            self.give(Input("move", place=self._world_place(event.pos)))
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            if event.pos[0] < FIELD_SIZE[0]:
                self.give(Input("down", place=self._world_place(event.pos)))
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self.give(Input("up", place=self._world_place(event.pos)))

    def handle_all(self, events: Iterable[pygame.event.Event]) -> bool:
        """Take some events; return whether the session goes on."""
        for event in events:
            self.handle(event)
        return self.running

    def give(self, given: Input) -> None:
        """Give the game an input, and write it down; not while a recording is played."""
        if not self.recording.is_played:
            self.recording.note(self.steps, given)
            self.game.take(given)

    def switched(self) -> Readings:
        """Return what the keys that all programs share have changed."""
        sounds = self.effects.sounds
        changes = (
            (self.paused, "PAUSED", "P goes on"),
            (self.slow, "slow motion", f"{SLOW_MOTION:g} x"),
            (sounds is not None and sounds.muted, "sound", "muted"),
        )
        return [(name, value) for is_on, name, value in changes if is_on]

    def tick(self, elapsed: float) -> int:
        """Advance by the time of one frame, s; return the number of steps made."""
        self._left_over += min(elapsed, LONGEST_FRAME) * (SLOW_MOTION if self.slow else 1.0)
        steps = whole_parts(self._left_over, TIME_STEP)
        self._left_over = max(self._left_over - steps * TIME_STEP, 0.0)
        if self.paused:
            steps, self._left_over = int(self._wants_step), 0.0
        self._wants_step = False
        for _ in range(steps):
            self.step()
        return steps

    def step(self) -> None:
        """Make one step of the game."""
        for given in self.recording.inputs_at(self.steps):
            self.game.take(given)
        for step, given in self.tour:
            if step == self.steps:
                self.give(given)
        self.effects.step(TIME_STEP)
        self.game.step()
        self.steps += 1
        if self.recording.is_over(self.steps):
            self.running = False

    def _shared(self, key: int) -> bool:
        """Do what a key that all programs share stands for; return whether it is one."""
        match key:
            case pygame.K_ESCAPE:
                self.running = False
            case pygame.K_p:
                self._pause(not self.paused)
            case pygame.K_o:
                self._pause(True)
                self._wants_step = True
            case pygame.K_l:
                self.slow = not self.slow
            case pygame.K_m if self.effects.sounds is not None:
                self.effects.sounds.mute()
            case _:
                return False
        return True

    def _pause(self, paused: bool) -> None:
        """Pause or resume time, and sounds with it."""
        self.paused = paused
        if self.effects.sounds is not None:
            self.effects.sounds.hold(paused)

    def _world_place(self, pixel: tuple[int, int]) -> XY:
        """Return the point of the world that a pixel's centre shows."""
        return self.program.camera.screen_to_world((pixel[0] + 0.5, pixel[1] + 0.5))


class Painter:
    """Draws a session into a window."""

    def __init__(self, session: Session, picture: Picture) -> None:
        self._session, self._picture = session, picture
        self._panel = Panel(picture.window, session.program.title)

    def wait(self) -> float:
        """Wait for the next frame, and return how long the last one took, s."""
        return self._picture.window.wait()

    def show_to(self, film: Gif | None, elapsed: float) -> None:
        """Let a film see what is drawn, if there is one, so much time after the last picture, s."""
        if film is not None:
            film.see(self._picture.window.surface, elapsed)

    def draw(self) -> None:
        """Draw field and panel and show them."""
        session, program, picture = self._session, self._session.program, self._picture
        picture.clear()
        program.draw(session.game, picture, session.effects)
        if session.effects.sparks is not None:
            session.effects.sparks.draw(picture)
        picture.notice(session.game.notice)
        self._panel.begin()
        self._panel.readings(program.readings(session.game))
        self._panel.readings(session.switched(), YELLOW)
        if program.more is not None:
            program.more(session.game, self._panel)
        self._panel.keys(program.keys + SHARED_KEYS)
        picture.window.show()


def play(
    program: Program,
    *,
    seed: int = 0,
    frames: int | None = None,
    headless: bool = False,
    screenshot: str | Path | None = None,
    record: str | Path | None = None,
    replay: str | Path | None = None,
    tour: bool = False,
    settings: Mapping[str, Any] = MappingProxyType({}),
) -> Played:
    """Play a program until its window is closed.

    Parameters
    ----------
    program : Program
        What is played.
    seed : int
        Every random number follows from it.
    frames : int, optional
        Stop after this many frames, each exactly one step, so that runs repeat bit for bit.
    headless : bool
        Draw into memory, without screen, sound and waiting.
    screenshot : path, optional
        A .png file for the last picture.
    record : path, optional
        A .json file for seed, settings and all inputs, or a .gif file for what is seen: 20
        pictures a second, for 30 s at the most.
    replay : path, optional
        Such a .json file: seed, settings and inputs are played again, and the run ends where it
        did.
    tour : bool
        Let the program play itself; what a player does counts too.
    settings : mapping
        What else the game is made with.

    Raises
    ------
    ValueError
        `frames` is negative, or missing when headless without a recording; the run is longer than
        a film may be; a file's name, folder or content is not what it should be.
    OSError
        A file cannot be read or written.
    RuntimeError
        There is no screen to open a window on.
    """
    _check(frames, headless, screenshot, record, replay)
    recording = (
        Recording.read(replay, program.name) if replay else Recording(program.name, seed, settings)
    )
    films = record is not None and _suffix(record) == ".gif"
    if films:
        _check_length(recording.steps if frames is None else frames)
    session = Session(program, _new_game(program, recording, settings), recording)
    session.tour = program.tour if tour else ()
    with (
        open_window(PROGRAM_SIZE, program.title, headless=headless) as window,
        Gif(record, FILM_SIZE) if films and record else nullcontext() as film,
        _loudspeaker(session.effects, headless),
    ):
        painter = Painter(session, Picture(window, program.camera))
        outcome = _run(session, painter, film, frames, waits=not headless)
        if screenshot is not None:
            window.save(screenshot)
    if record is not None and not films:
        recording.write(record, session.steps)
    return outcome


def _new_game(program: Program, recording: Recording, settings: Mapping[str, Any]) -> Game:
    """Return a game as it begins; what a recording was made with goes before other settings."""
    all_settings = {**settings, **recording.settings}
    try:
        inspect.signature(program.game).bind(recording.seed, **all_settings)
    except TypeError as error:
        raise ValueError(f"settings must be those of {program.name}: {error}") from None
    return program.game(recording.seed, **all_settings)


@contextmanager
def _loudspeaker(effects: ImpactEffects, headless: bool) -> Iterator[None]:
    """Hold the audio device, if anything is to be heard."""
    if effects.sounds is None or headless:
        yield
        return
    effects.sounds.open()
    try:
        yield
    finally:
        effects.sounds.close()


def _run(
    session: Session, painter: Painter, film: Gif | None, frames: int | None, *, waits: bool
) -> Played:
    """Turn events and time into steps and pictures until the run ends."""
    seconds: list[tuple[float, float]] = []
    painter.draw()
    painter.show_to(film, 0.0)
    with closing(Code(None)) as code:
        while session.running and (frames is None or len(seconds) < frames):
            waited = painter.wait() if waits else TIME_STEP
            elapsed = waited if frames is None else TIME_STEP
            if not session.handle_all(pygame.event.get()):
                break
            _compile_if_large(session.game.world, code)
            start = time.process_time()
            session.tick(elapsed)
            between = time.process_time()
            painter.draw()
            seconds.append((between - start, time.process_time() - between))
            painter.show_to(film, elapsed)
    return Played(session.game, session.steps, np.reshape(seconds, (-1, 2)), film)


def _compile_if_large(world: LiveWorld, code: Code) -> None:
    """Switch a large world to machine code once that is there: nobody waits for a compiler."""
    if world.compiled or len(world) < WORTH_COMPILING:
        return
    if code.look(lambda: world.program, math.inf, "now") is not None:
        world.compile()


def _check(
    frames: int | None,
    headless: bool,
    screenshot: str | Path | None,
    record: str | Path | None,
    replay: str | Path | None,
) -> None:
    """Refuse a run that could not end, or could not save its files."""
    if frames is None and headless and replay is None:
        raise ValueError("frames must be given when headless: nobody can close the window")
    if frames is not None and (not isinstance(frames, int) or frames < 0):
        raise ValueError(f"frames must be a whole number >= 0, got {frames}")
    endings = (("screenshot", screenshot, (".png",)), ("record", record, (".json", ".gif")))
    for name, path, suffixes in endings:
        if path is not None and _suffix(path) not in suffixes:
            raise ValueError(f"{name} must end in {' or '.join(suffixes)}, got {str(path)!r}")
        if path is not None and not Path(path).parent.is_dir():
            raise ValueError(f"{name} must lie in a folder that there is, got {str(path)!r}")


def _check_length(frames: int) -> None:
    """Refuse a run that is longer than a film may be."""
    most = round(MOST_SECONDS / TIME_STEP)
    if frames > most:
        raise ValueError(f"frames must be <= {most} for a film ({MOST_SECONDS} s), got {frames}")


def _suffix(path: str | Path) -> str:
    """Return how a file's name ends, in small letters."""
    return Path(path).suffix.lower()
