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
)

making = typer.Typer()


@making.command(rich_help_panel=INSTRUCTORS)
def site(
    folder: Annotated[Path, typer.Argument(help="Where the pages go: new, empty or a site.")],
    pyodide: Annotated[
        Path | None,
        typer.Option(
            help="The npm package pyodide, unpacked: exercises in the pages then need no network."
        ),
    ] = None,
) -> None:
    """Make the workbook's pages: a folder that needs no server and no network.

    Only exercises that are answered in a page load Python, from the network or as --pyodide says.
    """
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.site.build import build
    from lesson_code.view.browser.lab import lab_html

    with clear_errors():
        pages = build(find_root(), folder, lab=lab_html(), pyodide=pyodide)
    console.print(f"{pages} pages. Open {folder / 'index.html'}", soft_wrap=True, highlight=False)


@making.command(rich_help_panel=MAINTAINERS)
def regenerate(
    only_check: Annotated[
        bool, typer.Option("--check", help="Change nothing; say what is not as its source says.")
    ] = False,
    names: Annotated[list[str] | None, typer.Argument(help="Only files that begin so.")] = None,
) -> None:
    """Make every notebook and student copy anew from its source, and programs that have changed.

    The README's table of notebooks, too.
    """
    from lesson_code.course.grading.exercises import exercises
    from lesson_code.course.notebooks import contents
    from lesson_code.course.notebooks.regenerate import derived_files, drifted
    from lesson_code.course.notebooks.root import find_root, require_instructors
    from lesson_code.evidence import common_programs
    from lesson_code.view.browser import lab_still, programs, stills

    tasks = {exercise.name: exercise.task_ids for exercise in exercises()}
    kinds = (common_programs, programs, stills, lab_still)
    with clear_errors():
        root = find_root()
        require_instructors(root)
        if only_check:
            lines = [*drifted(root, tasks), *contents.drifted(root)]
            lines += [line for kind in kinds for line in kind.drifted(root)]
            for line in lines:
                say_error(line)
            raise typer.Exit(1 if lines else 0)
        begins = tuple(names or [""])
        made = 0
        # Figures hold programs, and notebooks hold figures.
        for kind in kinds:
            for name in kind.names_in(root):
                if name.startswith(begins) and (names or kind.fault(name)):
                    say_made(kind.write(name), root)
                    made += 1
        for file in derived_files(root, tasks):
            if file.path.name.startswith(begins):
                file.write()
                say_made(file.path, root)
                made += 1
        for path in contents.write(root):
            say_made(path, root)
        if names and not made:
            raise ValueError(f"names must begin a file's name, such as 01, got {', '.join(begins)}")


def say_made(file: Path, root: Path) -> None:
    """Say which file has been made."""
    console.print(f"{file.relative_to(root)}", soft_wrap=True, highlight=False)
