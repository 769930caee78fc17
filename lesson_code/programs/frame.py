"""The frame of every program: window, clock, keys that all share, recording, pictures.

Time comes in frames of any length and leaves in equal steps. What is left over is kept for the
next frame, so that a world does not depend on how fast it is drawn.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from lesson_code.engine.compiled.library import is_kept, why_no_compiler
from lesson_code.engine.scene import XY
from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.programs.game import Game, Input, Keys, Program
from lesson_code.programs.live_world import TIME_STEP
from lesson_code.programs.recording import Recording
from lesson_code.view.panel import PROGRAM_SIZE, Panel
from lesson_code.view.picture import FIELD_SIZE, Picture
from lesson_code.view.pygame_view import open_window, pygame

LONGEST_FRAME = 0.1
"""s: a longer one counts as this. A machine that is too slow shows slow motion, and not jerks."""

SLOW_MOTION = 0.2
"""Of the usual speed."""

WORTH_COMPILING = 100
"""Bodies: plain Python moves fewer of them in half a frame."""

SHARED_KEYS: Keys = (
    ("P   O", "pause   one step"),
    ("L   M", "slow motion   mute"),
    ("ESC", "quit"),
)
"""The keys that every program has; they change time, never the world."""


@dataclass(frozen=True)
class Outcome:
    """How a run ended.

    Attributes
    ----------
    game : Game
        As it was at the end.
    frames, steps : int
        How many pictures were drawn, and how many steps the world made.
    step_seconds, draw_seconds : float
        Of processor time, for a frame, on average; 0 where there was none.
    """

    game: Game
    frames: int
    steps: int
    step_seconds: float
    draw_seconds: float


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

    def tick(self, elapsed: float) -> int:
        """Let the time of one frame pass, s; return how many steps that made."""
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
                self.paused = not self.paused
            case pygame.K_o:
                self.paused = self._wants_step = True
            case pygame.K_l:
                self.slow = not self.slow
            case pygame.K_m if self.effects.sounds is not None:
                self.effects.sounds.muted = not self.effects.sounds.muted
            case _:
                return False
        return True

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

    def draw(self, notice: str = "") -> None:
        """Draw field and panel and show them."""
        session, program, picture = self._session, self._session.program, self._picture
        picture.clear()
        program.draw(session.game, picture, session.effects)
        if session.effects.sparks is not None:
            session.effects.sparks.draw(picture)
        words = notice or ("PAUSED: P goes on, O makes one step" if session.paused else "")
        if words:
            picture.notice(words)
        self._panel.begin()
        self._panel.readings(program.readings(session.game))
        if session.slow:
            self._panel.readings([("slow motion", f"{SLOW_MOTION:g} x")])
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
) -> Outcome:
    """Play a program until its window is closed.

    Parameters
    ----------
    program : Program
        What is played.
    seed : int
        Everything that is drawn by lot follows from it.
    frames : int, optional
        Stop after so many frames, each exactly one step, so that runs repeat bit for bit.
    headless : bool
        Draw into memory, without screen, sound and waiting.
    screenshot : path, optional
        A .png file for the last picture.
    record : path, optional
        A .json file for the seed and all inputs.
    replay : path, optional
        Such a file: its seed and inputs are played again, and the run ends where it did.
    tour : bool
        Let the program play itself; what a player does counts too.
    settings : mapping
        What else the game is made with.

    Raises
    ------
    ValueError
        `frames` is negative, or missing when headless without a recording; a file's name or
        content is not what it should be.
    RuntimeError
        There is no screen to open a window on.
    """
    _check(frames, headless, screenshot, record, replay)
    recording = Recording.read(replay, program.name) if replay else Recording(program.name, seed)
    session = Session(program, program.game(recording.seed, **settings), recording)
    session.tour = program.tour if tour else ()
    with open_window(PROGRAM_SIZE, program.title, headless=headless) as window:
        painter = Painter(session, Picture(window, program.camera))
        _compile_if_large(session.game, painter)
        if session.effects.sounds is not None and not headless:
            session.effects.sounds.open()
        try:
            outcome = _run(session, painter, frames, waits=not headless)
        finally:
            if session.effects.sounds is not None:
                session.effects.sounds.close()
        if screenshot is not None:
            window.save(screenshot)
    if record is not None:
        recording.write(record, session.steps)
    return outcome


def _run(session: Session, painter: Painter, frames: int | None, *, waits: bool) -> Outcome:
    """Turn events and time into steps and pictures until somebody or something ends it."""
    drawn, stepping, drawing = 0, 0.0, 0.0
    painter.draw()
    while session.running and (frames is None or drawn < frames):
        elapsed = painter.wait() if waits else TIME_STEP
        if not session.handle_all(pygame.event.get()):
            break
        start = time.process_time()
        session.tick(elapsed if frames is None and waits else TIME_STEP)
        between = time.process_time()
        painter.draw()
        stepping, drawing = stepping + between - start, drawing + time.process_time() - between
        drawn += 1
    share = max(drawn, 1)
    return Outcome(session.game, drawn, session.steps, stepping / share, drawing / share)


def _compile_if_large(game: Game, painter: Painter) -> None:
    """Let a large world go on in machine code; say so where that takes a while."""
    if len(game.world) < WORTH_COMPILING or why_no_compiler():
        return
    if not is_kept(game.world.source):
        painter.draw("Making machine code: half a minute, and only this once")
    game.world.compile()


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
    if frames is not None and frames < 0:
        raise ValueError(f"frames must be a whole number >= 0, got {frames}")
    for name, path, suffix in (("screenshot", screenshot, ".png"), ("record", record, ".json")):
        if path is not None and Path(path).suffix.lower() != suffix:
            raise ValueError(f"{name} must end in {suffix}, got {str(path)!r}")
