"""The instructor's commands: ``workbook grade``, ``merge`` and ``release``."""

from __future__ import annotations

import json
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer
from rich.table import Table

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

if TYPE_CHECKING:
    from lesson_code.course.class_run import Gradebook

Isolation = Annotated[
    str | None,
    typer.Option(
        metavar="LEVEL",
        help="The least isolation that will do: full, limits or none; a class asks for full.",
    ),
]

CLASS_ISOLATION = "full"
"""The least isolation for a class unless told otherwise: its submissions are unread code."""

grading = typer.Typer()


@grading.command(rich_help_panel=INSTRUCTORS)
def grade(
    submission: Annotated[
        Path, typer.Argument(help="A notebook or a .py file; for a class, its folder.")
    ],
    exercise: Annotated[
        list[str] | None,
        typer.Option(help="Which exercise, if the file does not tell; for a class, the only ones."),
    ] = None,
    seed: Annotated[int | None, typer.Option(help="Draw the same inputs again.")] = None,
    nbval: Annotated[
        bool, typer.Option("--nbval", help="Grade under nbval, without isolation.")
    ] = False,
    isolation: Isolation = None,
    out: Annotated[
        Path | None, typer.Option(help="A class: where the marks go; by default FOLDER-marks.")
    ] = None,
    roster: Annotated[
        Path | None,
        typer.Option(help="A class: CSV; also an export of Canvas or Moodle."),
    ] = None,
    due: Annotated[
        str | None, typer.Option(help="A class: later is late, such as 2026-11-20T23:59.")
    ] = None,
    workers: Annotated[
        int | None, typer.Option(min=1, help="A class: processes; by default one a core.")
    ] = None,
    cluster: Annotated[
        str | None, typer.Option(help='A class: a dask scheduler\'s address, or "local".')
    ] = None,
    fresh: Annotated[bool, typer.Option("--fresh", help="A class: forget an earlier run.")] = False,
    variant: Annotated[
        bool, typer.Option("--variant", help="A class: draw inputs for each student.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Grade one submission, or a folder with one file or folder a student.

    A class that is interrupted goes on where it stopped when the command is given again. What you
    write into changes.csv, beside its marks, counts from the next run on.
    """
    names = exercise or []
    with clear_errors():
        if submission.is_dir() and not nbval:
            from lesson_code.course.class_run import Hands

            place = out or submission.resolve().with_name(f"{submission.resolve().name}-marks")
            hands = Hands(workers, cluster)
            _grade_class(
                submission,
                place,
                roster,
                names,
                seed,
                due,
                isolation,
                hands,
                fresh,
                variant,
                as_json,
            )
        from lesson_code.course.grading.submission import is_archive

        for option, given in (
            ("--out", out),
            ("--roster", roster),
            ("--due", due),
            ("--workers", workers),
            ("--cluster", cluster),
            ("--fresh", fresh or None),
            ("--variant", variant or None),
        ):
            if given is not None:
                cure = "; unpack it first" if is_archive(submission.name) else ""
                raise ValueError(f"{option} is for a class, and {submission} is no folder{cure}")
        if len(names) > 1:
            raise ValueError("--exercise can be given once for one file")
        if nbval:
            _grade_under_nbval(submission, names[0] if names else None, as_json)
        _grade_one(submission, names[0] if names else None, seed, isolation, as_json)


def _grade_one(
    path: Path, exercise: str | None, seed: int | None, isolation: str | None, as_json: bool
) -> NoReturn:
    """Grade one submission."""
    from lesson_code.course.grading.grader import grade
    from lesson_code.course.grading.report import print_report

    graded = grade(path, exercise=exercise, seed=seed, isolation=isolation)
    if as_json:
        print_json(graded.as_dict())
    else:
        print_report(graded, console)
    raise typer.Exit(0 if graded.is_full else 1)


def _grade_class(
    folder: Path,
    out: Path,
    roster: Path | None,
    exercises: list[str],
    seed: int | None,
    due: str | None,
    isolation: str | None,
    hands: Any,
    fresh: bool,
    variant: bool,
    as_json: bool,
) -> NoReturn:
    """Grade a class; exit code 1 says that some of what was handed in has no marks."""
    from lesson_code.course.class_run import exports, grade_class
    from lesson_code.course.class_run.names import visible
    from lesson_code.course.class_run.sheets import read_time

    try:
        book = grade_class(
            folder,
            out,
            roster=roster,
            exercises=exercises,
            seed=seed,
            due=None if due is None else read_time(due),
            isolation=isolation or CLASS_ISOLATION,
            hands=hands,
            fresh=fresh,
            variant=variant,
            told=say_error,
        )
    except KeyboardInterrupt:
        say_error("Interrupted. The same command goes on from here.")
        raise typer.Exit(2) from None
    if as_json:
        print_json(exports.as_dict(book))
    else:
        _print_class(book)
        console.print(
            f"Written to {visible(str(out))}", soft_wrap=True, markup=False, highlight=False
        )
    raise typer.Exit(0 if book.is_complete else 1)


def _print_class(book: Gradebook) -> None:
    """Print how the class did, what to teach next, and about whom there is something to say."""
    from lesson_code.course.class_run.exports import credits_of, remarks_of
    from lesson_code.course.class_run.pages import to_teach

    table = Table("task", "function", "mean", "full marks", "not written")
    for summary in book.summary:
        table.add_row(
            summary.task.id,
            summary.task.function,
            f"{summary.mean:.1f}/{summary.full_points}",
            f"{summary.full} of {summary.handed_in}",
            str(summary.not_written),
        )
    console.print(table)
    if to_teach(book):
        console.print("What to teach next:", style="bold")
    for summary, model in to_teach(book):
        line = f"  {model.students} of {summary.handed_in}, {summary.task.title}: {model.says}"
        console.print(line, markup=False, highlight=False, soft_wrap=True)
    for line in credits_of(book):
        say_error(line)
    for student in book.students:
        if lines := remarks_of(student):
            say_error(f"{student.label}: {'; '.join(lines)}")
    for line in book.left_out:
        say_error(line)
    counts = ", ".join(
        f"{len(book.with_status(status))} {status}"
        for status in ("graded", "late", "missing", "not gradable")
    )
    console.print(f"{len(book.students)} students: {counts}", highlight=False)


def _grade_under_nbval(path: Path, exercise: str | None, as_json: bool) -> NoReturn:
    """Grade by nbval alone: a task passes with full marks, or it does not."""
    from lesson_code.course.grading.nbval_grading import grade_under_nbval
    from lesson_code.course.notebooks.root import find_root

    submission, chosen = _submission_and_exercise(path, exercise)
    errors.print("nbval runs the submission's code in a kernel without any isolation.")
    with cell_progress() as progress:
        outcomes = grade_under_nbval(submission, chosen, find_root(), cell_watcher(progress))
    passed = all(outcome.passed for outcome in outcomes)
    if as_json:
        print_json(
            {
                "version": 1,
                "command": "grade --nbval",
                "submission": str(path),
                "exercise": chosen.name,
                "isolation": "none",
                "tasks": [vars(outcome) for outcome in outcomes],
            }
        )
    else:
        for outcome in outcomes:
            verdict = "full marks" if outcome.passed else "not full marks"
            console.print(f"{outcome.task} {outcome.function}: {verdict}", highlight=False)
    raise typer.Exit(0 if passed else 1)


@grading.command(rich_help_panel=INSTRUCTORS)
def merge(
    submission: Annotated[Path, typer.Argument(help="A notebook or a .py file.")],
    output: Annotated[Path, typer.Option("-o", "--output", help="The notebook to write.")],
    exercise: Annotated[
        str | None, typer.Option(help="Which exercise, if the file does not tell.")
    ] = None,
) -> None:
    """Lay a submission into the solution notebook, to be graded by pytest --nbval-lax."""
    from lesson_code.course.grading.nbval_grading import merge as merged
    from lesson_code.course.isolation.call_outcome import one_line
    from lesson_code.course.notebooks.root import find_root

    with clear_errors():
        read, chosen = _submission_and_exercise(submission, exercise)
        text = json.dumps(merged(read, chosen, find_root()), indent=1)
        output.write_text(text + "\n", encoding="utf-8")
    name = one_line(str(output))
    line = f"Wrote {name}. Now run: pytest --nbval-lax {shlex.quote(name)}"
    console.print(line, soft_wrap=True, markup=False, highlight=False)


def _submission_and_exercise(path: Path, name: str | None) -> tuple[Any, Any]:
    """Return a submission and the exercise it answers."""
    from lesson_code.course.grading.exercises import exercise_by_name, exercise_of
    from lesson_code.course.grading.submission import read_submission

    submission = read_submission(path)
    return submission, exercise_by_name(name) if name else exercise_of(submission)


@grading.command(rich_help_panel=INSTRUCTORS)
def release(
    folder: Annotated[
        Path, typer.Argument(help="A folder that is new or empty; with --gradescope, a new zip.")
    ],
    gradescope: Annotated[
        bool, typer.Option("--gradescope", help="Write an autograder for Gradescope instead.")
    ] = False,
    nbgrader: Annotated[
        bool, typer.Option("--nbgrader", help="Write a course folder for nbgrader instead.")
    ] = False,
    exercise: Annotated[
        list[str] | None,
        typer.Option(help="For Gradescope and nbgrader: the only exercises that count."),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Write the students' copy: no solutions, no hidden checks, no keys; and a zip of it."""
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.release import release as release_to

    with clear_errors():
        if gradescope and nbgrader:
            raise ValueError("--gradescope and --nbgrader write different things: choose one")
        if gradescope:
            _release_for_gradescope(folder, exercise or [], as_json)
        if nbgrader:
            _release_for_nbgrader(folder, exercise or [], as_json)
        if exercise:
            raise ValueError("--exercise needs --gradescope or --nbgrader")
        made = release_to(find_root(), folder)
        if as_json:
            print_json(
                {
                    "version": 1,
                    "command": "release",
                    "folder": str(made.folder),
                    "zip": str(made.archive),
                    "files": made.files,
                    "leaks": [],
                }
            )
        else:
            line = f"{made.files} files in {made.folder} and {made.archive}; nothing leaks"
            console.print(line, soft_wrap=True, markup=False, highlight=False)


def _release_for_gradescope(archive: Path, exercises: list[str], as_json: bool) -> NoReturn:
    """Write the zip that Gradescope runs."""
    from lesson_code.course.fresh_copies import zipped
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.release.gradescope import gradescope_files

    if archive.suffix != ".zip" or archive.exists():
        raise ValueError(f"an autograder must be a new .zip, got {archive}")
    files = gradescope_files(find_root(), exercises)
    archive.write_bytes(zipped(files))
    _say_released("gradescope", {"zip": str(archive), "files": len(files)}, as_json)


def _release_for_nbgrader(folder: Path, exercises: list[str], as_json: bool) -> NoReturn:
    """Write a course folder for nbgrader."""
    from lesson_code.course.fresh_copies import write_folder
    from lesson_code.course.notebooks.root import find_root
    from lesson_code.course.release.nbgrader import nbgrader_files

    files = nbgrader_files(find_root(), exercises)
    write_folder(files, folder)
    _say_released("nbgrader", {"folder": str(folder), "files": len(files)}, as_json)


def _say_released(form: str, made: dict[str, Any], as_json: bool) -> NoReturn:
    """Say what was written that students must not have."""
    if as_json:
        print_json({"version": 1, "command": f"release --{form}", **made})
    else:
        place = made.get("zip") or made["folder"]
        line = f"{made['files']} files in {place}: not for students, hidden checks are among them"
        console.print(line, soft_wrap=True, markup=False, highlight=False)
    raise typer.Exit(0)
