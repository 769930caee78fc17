"""``workbook watch`` and ``workbook quiz``: exercises checked as they are saved, and questions."""

from __future__ import annotations

import queue
import sys
import threading
from typing import TYPE_CHECKING, Annotated

import typer

from lesson_code.cli.shared import (
    STUDENTS,
    AsJson,
    clear_errors,
    console,
    errors,
    print_json,
)

if TYPE_CHECKING:
    from lesson_code.course.watch import WatchSession

practising = typer.Typer()


@practising.command(rich_help_panel=STUDENTS)
def watch(
    exercise: Annotated[
        str | None, typer.Argument(help="Its number, such as 03; all by default.")
    ] = None,
    listing: Annotated[
        bool, typer.Option("--list", help="List how far each exercise is, and end.")
    ] = False,
    reset: Annotated[
        bool, typer.Option("--reset", help="Put the exercise back, keep a backup, and end.")
    ] = False,
    plain: Annotated[
        bool, typer.Option("--plain", help="Plain lines, for screen readers and logs.")
    ] = False,
) -> None:
    """Check an exercise each time it is saved, with help that goes a step further each time."""
    from lesson_code.course.grading.exercises import exercise_by_name, exercises
    from lesson_code.course.grading.grader import Grader
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.watch import Screen, WatchSession

    with clear_errors():
        if reset and exercise is None:
            raise ValueError("--reset needs the exercise: workbook watch 03 --reset")
        chosen = exercises() if exercise is None else (exercise_by_name(exercise),)
        screen = Screen(console, plain=plain or not console.is_terminal)
        with Grader() as grader:
            session = WatchSession(find_root(), chosen, grader, screen)
            if reset:
                session.reset()
                return
            session.begin()
            if listing:
                session.list()
            else:
                _watch(session)


def _watch(session: WatchSession) -> None:
    """Watch until standard input says to stop, or Ctrl-C does."""
    from lesson_code.course.watch import listen

    lines: queue.Queue[str] = queue.Queue()
    threading.Thread(target=listen, args=(lines, sys.stdin.readline), daemon=True).start()
    try:
        session.run(lines)
    except KeyboardInterrupt:
        session.screen.say("Stopped.")


@practising.command(rich_help_panel=STUDENTS)
def quiz(
    names: Annotated[
        list[str] | None,
        typer.Argument(help="Chapters, or questions such as 03-once; all chapters by default."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Take the quiz here in the terminal, or answer one prediction of a notebook."""
    from lesson_code.course.quiz.bank import chapter_numbers
    from lesson_code.course.quiz.terminal import run_quiz

    with clear_errors():
        result = run_quiz(names or chapter_numbers(), errors if as_json else console)
        if as_json:
            print_json(result.as_dict() | {"command": "quiz"})
