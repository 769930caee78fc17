"""The ``workbook`` command: one function a subcommand, each a thin shell around its wing.

Exit codes: 0 all is well, 1 something is not (a cell failed, marks are missing), 2 the command
could not do what was asked. Wings are imported by the subcommand that needs them.
"""

from __future__ import annotations

import io
import os
import sys
from typing import Annotated

import typer

from lesson_code import __version__
from lesson_code.cli.checking import checking
from lesson_code.cli.grading import grading
from lesson_code.cli.making import making
from lesson_code.cli.measuring import measure
from lesson_code.cli.opening import opening
from lesson_code.cli.playing import play
from lesson_code.cli.practising import practising
from lesson_code.cli.shared import MAINTAINERS, STUDENTS

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="The collision workbook: open it, work through it, grade answers, play.",
)
app.add_typer(opening)
app.add_typer(practising)
app.add_typer(play, name="play", rich_help_panel=STUDENTS)
app.add_typer(grading)
app.add_typer(checking)
app.add_typer(making)
app.add_typer(measure, name="measure", rich_help_panel=MAINTAINERS)


def main() -> None:
    """Run the command."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    if isinstance(sys.stdout, io.TextIOWrapper):  # as standard error does: no name ends a command
        sys.stdout.reconfigure(errors="backslashreplace")
    app()


def _print_version(is_asked: bool) -> None:
    """Print the version and end, if it is asked for."""
    if is_asked:
        typer.echo(f"collision-workbook {__version__}")
        raise typer.Exit


@app.callback()
def options(
    version: Annotated[
        bool,
        typer.Option("--version", callback=_print_version, is_eager=True, help="Print it and end."),
    ] = False,
) -> None:
    """Take the options that stand before a command."""
