"""``workbook play``: the pygame programs, each a subcommand."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import cache, partial
from pathlib import Path
from typing import Annotated

import typer

from lesson_code.chapters.programs import program_summaries
from lesson_code.cli.shared import clear_errors, console

SIZE = "1280x720"

play = typer.Typer(help="Play one of the programs; without a name, choose it by its picture.")

Seed = Annotated[int, typer.Option(help="What is drawn by lot follows from it.")]
Frames = Annotated[int | None, typer.Option(help="Stop after so many frames.")]
Headless = Annotated[bool, typer.Option("--headless", help="Without a window.")]
Screenshot = Annotated[Path | None, typer.Option(help="Save the last frame as a PNG.")]
Record = Annotated[
    Path | None,
    typer.Option(help="Write seed and inputs to a .json file, or film what is seen as a .gif."),
]
Replay = Annotated[Path | None, typer.Option(help="Play such a .json file again.")]
Tour = Annotated[bool, typer.Option("--tour", help="Let the program play itself.")]
Size = Annotated[str, typer.Option(help="Of the window at first, px: WIDTHxHEIGHT.")]
With = Annotated[
    str | None, typer.Option("--with", help='"exercises": run what stands in the exercise.')
]
Balls = Annotated[int, typer.Option(min=0, max=600, help="How many there are at the start.")]


@play.callback(invoke_without_command=True)
def menu(context: typer.Context) -> None:
    """Show the menu of all programs, until it is closed; without a screen, the list."""
    if context.invoked_subcommand is not None:
        return
    from lesson_code.chapters.programs import load
    from lesson_code.view.pygame.frame import play as play_program
    from lesson_code.view.pygame.menu import Entry, choose

    entries = [Entry(n, words, partial(load, n)) for n, words in program_summaries().items()]
    try:
        while (name := choose(entries, when_shown=_prepare_once)) is not None:
            play_program(load(name))
    except RuntimeError:
        console.print(context.get_help(), markup=False, highlight=False)
        raise typer.Exit(2) from None


@cache
def _prepare_once() -> None:
    """Have the programs of live worlds compiled, as long as somebody plays."""
    threading.Thread(target=_prepare, daemon=True).start()


def _prepare() -> None:
    """Compile what is not kept, one after the other, in a process that gives way to all others."""
    from lesson_code.evidence.common_programs import (
        LIVE,
        compile_in_background,
        programs_to_compile,
    )

    compile_in_background(programs_to_compile(*LIVE))


@play.command("simulator", help=program_summaries()["simulator"])
def play_simulator(
    balls: Balls = 12,
    seed: Seed = 0,
    frames: Frames = None,
    headless: Headless = False,
    screenshot: Screenshot = None,
    record: Record = None,
    replay: Replay = None,
    tour: Tour = False,
    size: Size = SIZE,
) -> None:
    """Play the simulator, with any number of balls."""
    _play("simulator", seed, frames, headless, screenshot, record, replay, tour, size, balls)


def _command(name: str) -> Callable[..., None]:
    """Return the subcommand of a program."""

    def command(
        seed: Seed = 0,
        frames: Frames = None,
        headless: Headless = False,
        screenshot: Screenshot = None,
        record: Record = None,
        replay: Replay = None,
        tour: Tour = False,
        size: Size = SIZE,
        own: With = None,
    ) -> None:
        _play(name, seed, frames, headless, screenshot, record, replay, tour, size, own=own)

    return command


def _play(
    name: str,
    seed: int,
    frames: int | None,
    headless: bool,
    screenshot: Path | None,
    record: Path | None,
    replay: Path | None,
    tour: bool,
    size: str,
    balls: int | None = None,
    own: str | None = None,
) -> None:
    """Play a program, and say how it went."""
    with clear_errors():
        _require_end(headless, frames, replay)
        from lesson_code.chapters.own_functions import OwnProgram, load_own
        from lesson_code.chapters.programs import load
        from lesson_code.view.pygame.frame import play as play_program

        if own not in (None, "exercises"):
            raise ValueError(f'--with must be "exercises", got {own!r}')
        settings = {} if balls is None else {"balls": balls}
        shown = load_own(name) if own else OwnProgram(load(name), settings, [])
        outcome = play_program(
            shown.program,
            seed=seed,
            frames=frames,
            headless=headless,
            screenshot=screenshot,
            record=record,
            replay=replay,
            tour=tour,
            size=_pixels(size),
            settings=shown.settings,
            beside=shown.is_compared,
        )
    world, picture = 1e3 * outcome.seconds.sum(axis=0) / max(outcome.frames, 1)
    console.print(
        f"Frames: {outcome.frames}; world {world:.2f} ms, picture {picture:.2f} ms; "
        f"95 % within {1e3 * outcome.within(0.95):.2f} ms",
        highlight=False,
    )
    for one in shown.watched:
        told = [": ".join(one.reading()), one.difference]
        console.print(*filter(None, told), sep="\n", markup=False, highlight=False, soft_wrap=True)
    for missing in outcome.game.missing.values():
        said = f"{missing[0].upper()}{missing[1:]}"
        console.print(said, markup=False, highlight=False, soft_wrap=True)
    if outcome.film is not None:
        film = outcome.film
        end = ", the most that a film takes" if film.is_full else ""
        console.print(f"Film: {film.pictures} pictures, {film.seconds:.2f} s{end}", highlight=False)


def _pixels(size: str) -> tuple[int, int]:
    """Return width and height from WIDTHxHEIGHT."""
    width, _, height = size.partition("x")
    if not (width.isdecimal() and height.isdecimal() and int(width) >= 1 <= int(height)):
        raise ValueError(f"--size must be WIDTHxHEIGHT, such as {SIZE}, got {size!r}")
    return int(width), int(height)


def _require_end(headless: bool, frames: int | None, replay: Path | None) -> None:
    """Refuse a run that nobody could end."""
    if headless and frames is None and replay is None:
        raise ValueError("--headless needs --frames: without a window nobody can close it")


for _name, _summary in program_summaries().items():
    if _name != "simulator":
        play.command(_name, help=_summary)(_command(_name))
