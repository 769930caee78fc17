"""``workbook check``: notebooks and solutions run again, and exercises put to the test."""

from __future__ import annotations

from typing import Annotated

import typer

from lesson_code.cli.shared import (
    INSTRUCTORS,
    AsJson,
    cell_progress,
    cell_watcher,
    clear_errors,
    console,
    errors,
    print_json,
    say_error,
)

checking = typer.Typer()


@checking.command(rich_help_panel=INSTRUCTORS)
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
