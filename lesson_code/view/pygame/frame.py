"""The frame of every program: window, clock, keys that all share, recording, pictures.

Time comes in frames of any length and leaves in equal steps. What is left over is kept for the
next frame, so that a world does not depend on how fast it is drawn.
"""

from __future__ import annotations

import inspect
import itertools
import json
import math
import time
from collections.abc import Iterator, Mapping
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from threading import Thread
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.any_scene import program_for_any_scene
from lesson_code.engine.compiled import Code, ready_made
from lesson_code.engine.live_world import TIME_STEP, LiveWorld
from lesson_code.scene_file import set_up_in, write_scene
from lesson_code.view.pygame.game import Game
from lesson_code.view.pygame.gif import MOST_SECONDS, Gif
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.panel import PROGRAM_SIZE
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.program import ImpactEffects, Program
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import STEPPING_SECONDS, Session
from lesson_code.view.pygame.window import Window, open_window, pygame

FILM_HEIGHT = 400
"""px: small letters can still be read."""

LONGEST_WAIT = 2.0
"""s: then a world goes on in plain Python until its machine code is there."""

SCENES = "scene"
"""How the names of scene files begin; a browser saves the lab's as scene.json."""


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


class Camcorder:
    """Makes a film from the start, or between two presses of a key."""

    def __init__(self, window: Window) -> None:
        self._window = window
        self.film: Gif | None = None

    def begin(self, path: str | Path) -> None:
        """Begin a film."""
        width, height = self._window.surface.get_size()
        self.film = Gif(path, (round(FILM_HEIGHT * width / height), FILM_HEIGHT))

    def see(self, elapsed: float) -> None:
        """Take what is seen now, so much time after the last picture, s."""
        if self.film is not None:
            self.film.see(self._window.surface, elapsed)

    def close(self) -> Gif | None:
        """Write the film, and return it."""
        film, self.film = self.film, None
        if film is not None:
            film.close()
        return film


def free_name(stem: str, suffix: str) -> Path:
    """Return a name in this folder that no file has yet: pool-1.png, pool-2.png ..."""
    return next(
        path for k in itertools.count(1) if not (path := Path(f"{stem}-{k}{suffix}")).exists()
    )


def _do_wanted(session: Session, window: Window, camcorder: Camcorder) -> None:
    """Do what keys have asked of the window, and say so."""
    name = session.program.name
    for what in session.wanted:
        try:
            if what == "full screen":
                window.fill_screen()
            elif what == "screenshot":
                window.save(path := free_name(name, ".png"))
                session.say(f"saved {path}")
            elif what == "ledger":
                session.ledger.write(path := free_name(name, ".csv"))
                session.say(f"saved {path}")
            elif what == "save scene":
                set_up = session.game.set_up()
                write_scene(path := free_name(SCENES, ".json"), set_up)
                session.say(f"saved {path}")
            elif what == "open scene":
                _open_newest(session)
            elif camcorder.film is None:
                camcorder.begin(free_name(name, ".gif"))
                session.say("filming: F9 ends it")
            elif (film := camcorder.close()) is not None:
                session.say(f"film of {film.seconds:.1f} s saved")
        except OSError as error:
            session.say(f"not saved: {error.strerror}")
        except ValueError as error:
            session.say(str(error))
    session.wanted.clear()


def _open_newest(session: Session) -> None:
    """Begin with the newest scene file in this folder."""
    found = sorted(Path().glob(f"{SCENES}*.json"), key=lambda path: path.stat().st_mtime_ns)
    if not found:
        session.say(f"no {SCENES}*.json in this folder")
        return
    session.open_scene(json.dumps(set_up_in(found[-1])))
    session.say(f"opened {found[-1]}")


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
    size: tuple[int, int] = PROGRAM_SIZE,
    settings: Mapping[str, Any] = MappingProxyType({}),
    beside: bool = False,
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
    size : (int, int)
        px, of the window at first.
    settings : mapping
        What else the game is made with.
    beside : bool
        Draw the game without these settings pale beside it, with the same inputs.

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
    game = _new_game(program, recording, settings)
    ghost = _new_game(program, recording, {}) if beside else None
    session = Session(program, game, recording, ghost)
    session.tour = program.tour if tour else ()
    with (
        open_window(size, program.title, headless=headless) as window,
        _loudspeaker(session.effects, headless),
        closing(Camcorder(window)) as camcorder,
    ):
        if films and record is not None:
            camcorder.begin(record)
        outcome = _run(session, window, camcorder, frames, waits=not headless)
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
    session: Session, window: Window, camcorder: Camcorder, frames: int | None, *, waits: bool
) -> Played:
    """Turn events and time into steps and pictures until the run ends."""
    seconds: list[tuple[float, float]] = []
    painter = Painter(session, Picture(window, session.program.camera))
    painter.draw()
    camcorder.see(0.0)
    most_seconds = math.inf if frames is not None or not waits else STEPPING_SECONDS
    with closing(MachineCode()) as code:
        while session.running and (frames is None or len(seconds) < frames):
            waited = window.wait() if waits else TIME_STEP
            elapsed = waited if frames is None else TIME_STEP
            if not session.handle_all(pygame.event.get()):
                break
            start = time.process_time()
            session.waits = any(code.is_awaited_by(game.world) for game in session.games)
            if not session.waits:
                session.tick(elapsed, most_seconds)
            between = time.process_time()
            painter.draw()
            if not session.waits:
                seconds.append((between - start, time.process_time() - between))
                camcorder.see(elapsed)
            _do_wanted(session, window, camcorder)
    return Played(session.game, session.steps, np.reshape(seconds, (-1, 2)), camcorder.film)


class MachineCode:
    """Switches a world to machine code where plain Python takes long for its steps.

    Time stands still until a program that came ready-made is loaded, or made into machine code once
    on a machine; keys are heard meanwhile. For a compiler nobody waits.
    """

    def __init__(self) -> None:
        self._coming: dict[str, _Coming] = {}

    def is_awaited_by(self, world: LiveWorld) -> bool:
        """Return whether a world is to wait for its code; switch it to what is there."""
        if not world.wants_code:
            return False
        solver = world.solver
        if solver not in self._coming:
            self._coming[solver] = _Coming(solver)
        coming = self._coming[solver]
        if coming.is_awaited():
            return True
        if coming.is_there():
            world.compile()
        return False

    def close(self) -> None:
        """End the processes that compile, unless they are nearly done."""
        for coming in self._coming.values():
            coming.code.close()


class _Coming:
    """A solver's machine code, on its way."""

    def __init__(self, solver: str) -> None:
        self.code, self._is_there = Code(None), False
        self._program = partial(program_for_any_scene, solver)
        self._end = time.perf_counter() + LONGEST_WAIT
        self._thread = Thread(target=self._load, daemon=True)
        self._thread.start()

    def _load(self) -> None:
        """Load it, or make it where its program came ready-made."""
        self._is_there = ready_made.load(self._program()) is not None

    def is_awaited(self) -> bool:
        """Return whether it is being loaded, which has not taken too long; look for a frame."""
        if time.perf_counter() < self._end:
            self._thread.join(TIME_STEP)
            return self._thread.is_alive()
        return False

    def is_there(self) -> bool:
        """Return whether it is there; if it did not come ready-made, have it compiled."""
        if not self._is_there and not self._thread.is_alive():
            self._is_there = self.code.look(self._program, math.inf, "now") is not None
        return self._is_there


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
