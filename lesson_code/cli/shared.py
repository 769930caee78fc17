"""What the commands share: where they print, how they show progress, and how they fail."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    TextColumn,
    TimeElapsedColumn,
    TimeRemainingColumn,
)

if TYPE_CHECKING:
    from lesson_code.course.notebooks.nbval_run import CellResult, Watcher

console = Console()
errors = Console(stderr=True)

STUDENTS, INSTRUCTORS, MAINTAINERS = "For students", "For instructors", "For maintainers"
"""Whom a command is for: the groups of `workbook --help`."""

AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON object instead of a table.")]


@contextmanager
def clear_errors() -> Iterator[None]:
    """Turn an error about what was asked into one line and exit code 2."""
    try:
        yield
    except (typer.Exit, typer.Abort):  # are RuntimeErrors too, but none of these
        raise
    except (ValueError, OSError, RuntimeError) as error:
        say_error(f"workbook: {error}", style="bold red")
        raise typer.Exit(2) from None


def cell_progress() -> Progress:
    """Return a progress bar that leaves standard output to the results."""
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=errors,
    )


def cell_watcher(progress: Progress) -> Watcher:
    """Return a watcher of a run under nbval that moves one bar for each notebook."""
    from lesson_code.course.notebooks.nbval_run import Watcher

    bars: dict[str, Any] = {}

    def collected(counts: dict[str, int]) -> None:
        for notebook, cells in counts.items():
            bars[notebook] = progress.add_task(notebook, total=cells)

    def finished(result: CellResult) -> None:
        progress.advance(bars[result.notebook])

    return Watcher(collected, finished)


@contextmanager
def share_bar() -> Iterator[Callable[[str, float], None]]:
    """Show a bar; yields a callback that receives progress messages and the share done."""
    columns = TextColumn("{task.description:40.40}"), BarColumn(), TimeElapsedColumn()
    with Progress(*columns, TimeRemainingColumn(), console=errors, transient=True) as progress:
        bar = progress.add_task("", total=1.0)
        yield lambda what, share: progress.update(bar, description=what, completed=share)


def say_error(line: str, style: str | None = None) -> None:
    """Write a line on standard error: not cut, no part of it taken for markup or obeyed.

    A file's name may stand in it, and hold what a terminal would obey.
    """
    line = "".join(c if c.isprintable() or c == "\n" else " " for c in line)
    errors.print(line, style=style, markup=False, highlight=False, soft_wrap=True)


def print_json(value: dict[str, Any]) -> None:
    """Print one JSON object on standard output."""
    typer.echo(json.dumps(value, indent=2))
