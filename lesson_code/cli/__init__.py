"""The ``workbook`` command: one function a subcommand, each a thin shell around its wing.

Exit codes: 0 all is well, 1 something is not (a cell failed, marks are missing), 2 the command
could not do what was asked. Wings are imported by the subcommand that needs them.
"""

from __future__ import annotations

import os
import signal
from pathlib import Path
from typing import Annotated

import typer

from lesson_code.cli.grading import grading
from lesson_code.cli.measuring import measure
from lesson_code.cli.playing import play
from lesson_code.cli.shared import (
    AsJson,
    cell_progress,
    cell_watcher,
    clear_errors,
    console,
    errors,
    print_json,
    say_error,
    share_bar,
)
from lesson_code.cli.watching import watching

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    help="The collision workbook: open it, check it, grade answers, take the quiz, play.",
)
app.add_typer(play, name="play")
app.add_typer(measure, name="measure")
app.add_typer(grading)
app.add_typer(watching)


def main() -> None:
    """Run the command."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    app()


@app.command("open")
def open_workbook(
    notebook: Annotated[str, typer.Argument(help="Its number, such as 03.")] = "00",
    browser: Annotated[
        bool, typer.Option(help="Open a browser window, if there is a screen.")
    ] = True,
    port: Annotated[
        int | None, typer.Option(min=1, max=65535, help="The port to serve on.")
    ] = None,
) -> None:
    """Open the workbook in a browser; without a screen, serve it and print the address."""
    import webbrowser

    from lesson_code.course.notebooks import server
    from lesson_code.course.notebooks.root import find_root

    with clear_errors():
        root = find_root()
        notebooks = sorted((root / "notebooks").glob("*.ipynb"))
        found = [path for path in notebooks if path.name.startswith(notebook)]
        if len(found) != 1:
            raise ValueError(f"notebook must be the number of one, such as 00, got {notebook!r}")
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # it ends as Ctrl-C does
        running = server.start(root, found[0].relative_to(root), port)
    try:
        console.print("The workbook is served at", running.address, soft_wrap=True, highlight=False)
        console.print("Stop it with Ctrl-C.")
        if browser and server.has_screen():
            webbrowser.open(running.address)
        running.process.wait()
    except KeyboardInterrupt:
        console.print("Stopped.")
    finally:
        running.stop()


@app.command()
def check(
    exercises: Annotated[
        bool, typer.Option("--exercises", help="Put the exercises to the test instead.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Run every notebook and solution again, and compare each output with the stored one."""
    with clear_errors():
        if exercises:
            _check_exercises(as_json)
        else:
            _check_notebooks(as_json)


def _check_notebooks(as_json: bool) -> None:
    """Run all notebooks under nbval, with a progress bar."""
    from lesson_code.course.notebooks.nbval_run import run_notebooks
    from lesson_code.course.notebooks.root import find_root

    root = find_root()
    paths = [p for f in ("notebooks", "solutions") for p in sorted((root / f).glob("*.ipynb"))]
    with cell_progress() as progress:
        results = run_notebooks(paths, watcher=cell_watcher(progress))
    failed = [result for result in results if not result.passed]
    if as_json:
        print_json(
            {
                "version": 1,
                "command": "check",
                "notebooks": len(paths),
                "cells": len(results),
                "failed": [vars(result) for result in failed],
            }
        )
    else:
        for result in failed:
            say_error(f"{result.notebook}, code cell {result.cell + 1}:\n{result.message}")
        console.print(f"{len(paths)} notebooks, {len(results)} cells, {len(failed)} failed")
    raise typer.Exit(1 if failed else 0)


def _check_exercises(as_json: bool) -> None:
    """Put the exercises to the test, with a line for what is being checked."""
    from lesson_code.course.grading.self_check import faults
    from lesson_code.course.notebooks.root import find_root, require_instructors

    root = find_root()
    require_instructors(root)
    with errors.status("exercises") as status:
        found = list(faults(root, told=status.update))
    if as_json:
        print_json({"version": 1, "command": "check --exercises", "faults": found})
    else:
        for fault in found:
            say_error(fault)
        console.print(f"exercises: {len(found)} faults")
    raise typer.Exit(1 if found else 0)


@app.command()
def quiz(
    chapters: Annotated[
        list[str] | None, typer.Argument(help="Their numbers; all by default.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Take the quiz here in the terminal."""
    from lesson_code.course.quiz.bank import chapter_numbers
    from lesson_code.course.quiz.terminal import run_quiz

    with clear_errors():
        result = run_quiz(chapters or chapter_numbers(), errors if as_json else console)
        if as_json:
            print_json(result.as_dict() | {"command": "quiz"})


@app.command()
def site(
    folder: Annotated[Path, typer.Argument(help="Where the pages go: new, empty or a site.")],
    still: Annotated[
        bool, typer.Option("--still", help="Leave figures with sliders as they stand: seconds.")
    ] = False,
) -> None:
    """Make the workbook's pages: a folder that needs no server and no network."""
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.site.build import build

    with clear_errors(), share_bar() as told:
        pages = build(find_root(), folder, moving=() if still else None, told=told)
    console.print(f"{pages} pages. Open {folder / 'index.html'}", soft_wrap=True, highlight=False)


@app.command()
def pictures(
    folder: Annotated[Path, typer.Argument(help="Where they go.")],
    only: Annotated[list[str] | None, typer.Option(help="Only the one of this name.")] = None,
) -> None:
    """Take the pictures of the README (for those who carry it on); needs Chromium."""
    from lesson_code.cli.readme_pictures import write_pictures

    with clear_errors():
        for file in write_pictures(folder, only or ()):
            console.print(f"{file}", soft_wrap=True, highlight=False)


@app.command()
def regenerate(
    only_check: Annotated[
        bool, typer.Option("--check", help="Change nothing; say what is not as its source says.")
    ] = False,
    names: Annotated[list[str] | None, typer.Argument(help="Only files that begin so.")] = None,
) -> None:
    """Make every notebook and student copy anew from its source (for those who carry it on)."""
    from lesson_code.course.grading.exercises import exercises
    from lesson_code.course.notebooks.regenerate import derived_files, drifted
    from lesson_code.course.notebooks.root import find_root, require_instructors

    tasks = {exercise.name: exercise.task_ids for exercise in exercises()}
    with clear_errors():
        root = find_root()
        require_instructors(root)
        if only_check:
            lines = drifted(root, tasks)
            for line in lines:
                say_error(line)
            raise typer.Exit(1 if lines else 0)
        begins = tuple(names or [""])
        wanted = [f for f in derived_files(root, tasks) if f.path.name.startswith(begins)]
        if not wanted:
            raise ValueError(f"names must begin a file's name, such as 01, got {', '.join(begins)}")
        for file in wanted:
            file.write()
            console.print(f"{file.path.relative_to(root)}", soft_wrap=True, highlight=False)
