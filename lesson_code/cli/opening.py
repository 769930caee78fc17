"""``workbook start`` and ``workbook open``: a workbook in a folder, and in a browser."""

from __future__ import annotations

import signal
import sys
import threading
from pathlib import Path
from typing import Annotated

import typer

from lesson_code.cli.shared import STUDENTS, clear_errors, console

opening = typer.Typer()

NEW_FOLDER = Path("collision-workbook")
"""Where `open` offers to begin a workbook."""


@opening.command(rich_help_panel=STUDENTS)
def start(
    folder: Annotated[Path, typer.Argument(help="A folder that is new or empty.")],
) -> None:
    """Begin a workbook: write the notebooks and the exercises into a folder."""
    with clear_errors():
        _start(folder)
    console.print(f"Go there (cd {folder}), then: workbook open", soft_wrap=True, highlight=False)


@opening.command("open", rich_help_panel=STUDENTS)
def open_workbook(
    notebook: Annotated[str, typer.Argument(help="Its number, such as 03 or 07b.")] = "00",
    browser: Annotated[
        bool, typer.Option(help="Open a browser window, if there is a screen.")
    ] = True,
    port: Annotated[
        int | None, typer.Option(min=1, max=65535, help="The port to serve on.")
    ] = None,
) -> None:
    """Open the workbook in a browser; without a screen, serve it and print the address."""
    import webbrowser

    from lesson_code.course.fresh_copies import unchanged_notebooks
    from lesson_code.course.notebooks import server

    with clear_errors():
        root = _root()
        notebooks = sorted((root / "notebooks").glob("*.ipynb"))
        found = [path for path in notebooks if path.name.startswith(notebook)]
        if len({path.name[:2] for path in found}) != 1:  # of a chapter in parts, the first
            raise ValueError(f"notebook must be the number of one, such as 00, got {notebook!r}")
        signal.signal(signal.SIGTERM, signal.default_int_handler)  # it ends as Ctrl-C does
        signing = threading.Thread(target=lambda: server.trust(unchanged_notebooks(root)))
        signing.start()  # in the seconds that the server needs to start
        running = server.start(root, found[0].relative_to(root), port)
    try:
        signing.join()
        console.print("The workbook is served at", running.address, soft_wrap=True, highlight=False)
        console.print("Stop it with Ctrl-C.")
        threading.Thread(target=_prepare, daemon=True).start()
        if browser and server.has_screen():
            webbrowser.open(running.address)
        running.process.wait()
    except KeyboardInterrupt:
        console.print("Stopped.")
    finally:
        running.stop()


def _prepare() -> None:
    """Have the programs of large runs compiled, as long as the workbook is open."""
    from lesson_code.evidence.common_programs import compile_in_background, programs_to_compile

    if programs := programs_to_compile():
        console.print("Programs of large runs are compiled in the background, once:", len(programs))
        compile_in_background(programs)


def _root() -> Path:
    """Return the workbook's folder; where there is none, offer to begin one."""
    from lesson_code.course.notebooks.root import WorkbookNotFoundError, find_root

    try:
        return find_root()
    except WorkbookNotFoundError:
        question = f"There is no workbook here. Begin one in the folder {NEW_FOLDER}?"
        if not (_is_terminal() and typer.confirm(question)):
            raise
    _start(NEW_FOLDER)
    return find_root(NEW_FOLDER)


def _is_terminal() -> bool:
    """Return whether somebody can be asked."""
    return sys.stdin.isatty() and console.is_terminal


def _start(folder: Path) -> None:
    """Begin a workbook, and say what was written."""
    from lesson_code.course.fresh_copies import start as start_workbook

    files = start_workbook(folder)
    line = f"{files} files in {folder}: notebooks and exercises"
    console.print(line, soft_wrap=True, markup=False, highlight=False)
