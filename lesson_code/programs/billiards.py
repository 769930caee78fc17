"""Cushion-bounce billiards: a window round the table, which computes nothing itself.

All physics comes through one argument, `advance`: the table's own, or a student's with the same
signature. The window turns mouse and keys into launches, time into calls of `advance`, and what
comes back into a picture.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from lesson_code.formulas.validation import Vector
from lesson_code.programs import billiards_table
from lesson_code.programs.billiards_game import Advance, Game, as_place
from lesson_code.programs.billiards_picture import WINDOW_SIZE, Painter
from lesson_code.programs.billiards_table import LAUNCH, TIME_STEP
from lesson_code.view.pygame_view import open_window, pygame


@dataclass(frozen=True)
class Outcome:
    """How a run ended.

    Parameters
    ----------
    position, velocity : (float, float)
        Of the ball, px and px/s, y down.
    bounces : dict
        For each cushion the number of hits since the last launch.
    frames : int
        How many frames were drawn after the first picture.
    """

    position: tuple[float, float]
    velocity: tuple[float, float]
    bounces: dict[str, int]
    frames: int


def play(
    advance: Advance = billiards_table.advance,
    *,
    frames: int | None = None,
    headless: bool = False,
    screenshot: str | Path | None = None,
    launch: tuple[Vector, Vector] = LAUNCH,
) -> Outcome:
    """Open the table and play until the window is closed.

    Drag from the ball to launch it: the arrow is the way it would go in 0.25 s. SPACE pauses, R
    plays the first shot again, V shows the velocity, N or G the normals, ESC quits.

    Parameters
    ----------
    advance : callable
        ``advance(position, velocity, elapsed) -> (position, velocity, hits, left_over)``, as
        :func:`lesson_code.programs.billiards_table.advance`. If it raises NotImplementedError in
        a window that stays open, the window says so and waits.
    frames : int, optional
        Stop after so many frames, each exactly 1/60 s, so that runs repeat bit for bit. Without
        it the clock says how long each frame was. A frame longer than 0.25 s counts as 0.25 s:
        to catch up on a long pause would take many steps, the next frame would be late for that,
        and the player would miss what happened.
    headless : bool
        Draw into memory, without screen and waiting; `frames` must then be given.
    screenshot : path, optional
        A .png file for the last picture.
    launch : (position, velocity)
        The first shot, px and px/s, y down.

    Returns
    -------
    Outcome
        Ball, hits and number of frames at the end.

    Raises
    ------
    ValueError
        `frames` is negative, or missing when headless; the screenshot is no .png; the launch is
        not finite or too fast; `advance` returns something that is no ball.
    RuntimeError
        There is no screen to open a window on.

    Examples
    --------
    >>> play(frames=60, headless=True).bounces
    {'top': 1, 'bottom': 0, 'left': 0, 'right': 0, 'bumper': 0}
    """
    _check_run(frames, headless, screenshot)
    game = Game(advance, launch)
    drawn = 0
    with open_window(WINDOW_SIZE, "Cushion-bounce billiards", headless=headless) as window:
        painter = Painter(window)
        painter.draw(game)
        while frames is None or drawn < frames:
            elapsed = TIME_STEP if headless else window.wait()
            for event in pygame.event.get():
                game.handle(event)
            if not game.running:
                break
            _tick(game, elapsed if frames is None else TIME_STEP, forgiving=frames is None)
            painter.draw(game)
            drawn += 1
        if screenshot is not None:
            window.save(screenshot)
    return Outcome(as_place(game.position), as_place(game.velocity), game.bounces, drawn)


def _tick(game: Game, elapsed: float, *, forgiving: bool) -> None:
    """Let time pass; a forgiving window shows what is not written yet, and waits."""
    try:
        game.tick(elapsed)
        game.notice = ""
    except NotImplementedError as missing:
        if not forgiving:
            raise
        game.notice = f"not written yet: {missing}"


def _check_run(frames: int | None, headless: bool, screenshot: str | Path | None) -> None:
    """Refuse a run that could not end, or could not save its picture."""
    if frames is None and headless:
        raise ValueError("frames must be given when headless: nobody can close the window")
    if frames is not None and (not isinstance(frames, int) or frames < 0):
        raise ValueError(f"frames must be a whole number >= 0, got {frames}")
    if screenshot is not None and Path(screenshot).suffix.lower() != ".png":
        raise ValueError(f"screenshot must end in .png, got {str(screenshot)!r}")
