"""The marks of a class as pages: one for each student, and one for the instructor.

A page is one file without scripts or anything from elsewhere. It can be read by eye, by ear and on
paper: headings in order, tables with captions, and words beside every colour.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.exports import feedback_name, handed_in_as, remarks_of
from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.names import visible
from lesson_code.course.class_run.student import Student
from lesson_code.course.class_run.summary import (
    Misconception,
    Spread,
    TaskSummary,
    percent,
    spread_of,
)
from lesson_code.course.grading.exercises import Exercise

MOST_TO_TEACH = 10
"""Misconceptions that are listed on the terminal as what to teach next."""

MOST_IN_A_CHAPTER = 3
"""Misconceptions of a chapter that the class's page shows answers of."""


def student_page(student: Student, book: Gradebook) -> str:
    """Return a student's feedback: what is right, what is not, and the hints.

    It holds no input, no expected value and no seed.
    """
    return _page(
        "student.html",
        student=student,
        book=book,
        name=visible(student.hand_in.student.name) or student.label,
        remarks=remarks_of(student),
        exercises=[exercise for exercise in book.exercises if exercise.name in student.reports],
        not_handed_in=[e for e in book.exercises if e.name not in student.reports],
        full_points=book.full_points,
    )


def class_page(book: Gradebook) -> str:
    """Return the overview of a class: what to teach next, how marks are spread, who needs what."""
    return _page(
        "class.html",
        book=book,
        chapters=[
            (exercise, found)
            for exercise in book.exercises
            if (found := _to_teach_in(exercise, book))
        ],
        unexplained=[summary for summary in book.summary if summary.unexplained.who],
        spreads=_spreads(book),
        students=[_row(student, book) for student in book.students],
        remarks=[
            (student.label, remarks)
            for student in book.students
            if (remarks := remarks_of(student))
        ],
    )


def to_teach(book: Gradebook) -> list[tuple[TaskSummary, Misconception]]:
    """Return the commonest misconceptions of a class, the commonest first, with their tasks."""
    return _ranked(book.summary)[:MOST_TO_TEACH]


def _to_teach_in(exercise: Exercise, book: Gradebook) -> list[tuple[TaskSummary, Misconception]]:
    """Return the commonest misconceptions of a chapter."""
    its = [summary for summary in book.summary if summary.exercise is exercise]
    return _ranked(its)[:MOST_IN_A_CHAPTER]


def _ranked(summaries: Iterable[TaskSummary]) -> list[tuple[TaskSummary, Misconception]]:
    """Return the misconceptions of some tasks, the commonest first."""
    found = [(summary, model) for summary in summaries for model in summary.misconceptions]
    return sorted(found, key=lambda pair: (-pair[1].students, pair[0].task.id, pair[1].name))


def _spreads(book: Gradebook) -> list[tuple[str, int, Spread]]:
    """Return how the marks of each exercise are spread, and those of all: among whom, and how."""
    spreads = []
    for exercise in book.exercises:
        reports = [s.reports[exercise.name] for s in book.students if exercise.name in s.reports]
        shares = [percent(report["points"], report["full_points"]) for report in reports]
        spreads.append((exercise.title, len(shares), spread_of(shares)))
    if len(book.exercises) > 1:
        shares = [percent(s.points, book.full_points) for s in book.students if s.reports]
        spreads.append(("All exercises", len(shares), spread_of(shares)))
    return [(title, count, spread) for title, count, spread in spreads if spread]


def write_pages(book: Gradebook, folder: Path) -> None:
    """Write class.html and a page a student into a folder."""
    (folder / "feedback").mkdir(parents=True, exist_ok=True)
    _write(folder / "class.html", class_page(book))
    for student in book.students:
        _write(folder / feedback_name(student), student_page(student, book))


def _row(student: Student, book: Gradebook) -> dict[str, Any]:
    """Return what the class's page says of a student."""
    return {
        "id": student.label,
        "name": visible(student.hand_in.student.name),
        "status": student.status,
        "handed_in_as": handed_in_as(student),
        "points": student.points,
        "percent": percent(student.points, book.full_points),
        "page": feedback_name(student),
    }


def _write(path: Path, text: str) -> None:
    """Write a page, the same bytes on every machine."""
    path.write_text(text, encoding="utf-8", newline="\n")


def _page(template: str, **laid_in: Any) -> str:
    """Return a template with values laid in."""
    return str(_template(template).render(**laid_in))


@cache
def _template(name: str) -> Any:
    """Return a template of this folder, which escapes whatever is laid into it."""
    import jinja2

    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("lesson_code.course.class_run"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["counted"] = _counted
    environment.filters["listed"] = _listed
    environment.filters["page"] = feedback_name
    environment.filters["visible"] = visible
    environment.filters["lines"] = _lines
    return environment.get_template(name)


def _counted(number: int, noun: str) -> str:
    """Return a number and its noun, which takes an s.

    >>> _counted(1, "student"), _counted(2, "student")
    ('1 student', '2 students')
    """
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def _listed(pairs: Iterable[tuple[str, int]]) -> str:
    """Return names and how often each came, in a line."""
    return "; ".join(f"{name} ({count})" for name, count in pairs)


def _lines(text: str) -> str:
    """Return a text of several lines with all that cannot be seen written out."""
    return "\n".join(visible(line.replace("\t", "    ")) for line in text.splitlines())
