"""``workbook site`` and ``workbook regenerate``: what is made of the notebooks' sources."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from lesson_code.cli.shared import (
    INSTRUCTORS,
    MAINTAINERS,
    clear_errors,
    console,
    say_error,
    share_bar,
)

making = typer.Typer()


@making.command(rich_help_panel=INSTRUCTORS)
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


@making.command(rich_help_panel=MAINTAINERS)
def regenerate(
    only_check: Annotated[
        bool, typer.Option("--check", help="Change nothing; say what is not as its source says.")
    ] = False,
    names: Annotated[list[str] | None, typer.Argument(help="Only files that begin so.")] = None,
) -> None:
    """Make every notebook and student copy anew from its source, and programs that have changed."""
    from lesson_code.course.grading.exercises import exercises
    from lesson_code.course.notebooks.regenerate import derived_files, drifted
    from lesson_code.course.notebooks.root import find_root, require_instructors
    from lesson_code.view.browser import programs

    tasks = {exercise.name: exercise.task_ids for exercise in exercises()}
    with clear_errors():
        root = find_root()
        require_instructors(root)
        if only_check:
            lines = drifted(root, tasks) + programs.drifted(root)
            for line in lines:
                say_error(line)
            raise typer.Exit(1 if lines else 0)
        begins = tuple(names or [""])
        wanted = [f for f in derived_files(root, tasks) if f.path.name.startswith(begins)]
        stale = [
            name
            for name in programs.names_in(root)
            if name.startswith(begins) and (names or programs.fault(name))
        ]
        if not wanted and not stale:
            raise ValueError(f"names must begin a file's name, such as 01, got {', '.join(begins)}")
        for file in wanted:
            file.write()
            console.print(f"{file.path.relative_to(root)}", soft_wrap=True, highlight=False)
        for name in stale:
            made = programs.write(name)
            console.print(f"{made.relative_to(root)}", soft_wrap=True, highlight=False)
