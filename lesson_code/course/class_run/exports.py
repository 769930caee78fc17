"""The marks of a class as files: a sheet, and JSON with all there is to say.

Everything is written in the order of the students' ids and holds no clock, so that the same marks
are the same bytes.
"""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.alike import Alike
from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.names import encodable, sheet_text, told_apart, visible
from lesson_code.course.class_run.student import Student
from lesson_code.course.class_run.summary import TaskSummary, percent
from lesson_code.course.grading.exercises import Exercise

VERSION = 3
"""Version of the form of grades.json; it grows when a key changes."""


def as_csv(book: Gradebook) -> str:
    """Return a table with a line a student, which no spreadsheet takes for formulas.

    Points of an exercise that was not handed in are 0, so that a sum over a row is the mark; the
    columns `status` and `remarks` say why. An exercise is the sum of its tasks, unless points were
    taken off for lateness or given by hand, as the remarks say.
    """
    text = io.StringIO(newline="")
    rows = csv.writer(text, lineterminator="\r\n")
    ends = ["total", "full", "percent", "remarks"]
    rows.writerow(["id", "name", "email", "status", *_columns(book), *ends])
    ids = told_apart((student.id for student in book.students), _cell)
    for student in book.students:
        enrolled = student.hand_in.student
        words = [ids[student.id], *map(_cell, (enrolled.name, enrolled.email, student.status))]
        marks = [points for exercise in book.exercises for points in _points(student, exercise)]
        remarks = "; ".join(remarks_of(student))
        share = round(percent(student.points, book.full_points), 1)
        rows.writerow(
            [*words, *marks, student.points, book.full_points, share, sheet_text(remarks)]
        )
    return text.getvalue()


def _cell(text: str) -> str:
    """Return a text that a student or a roster has chosen, safe for a sheet."""
    return sheet_text(visible(text))


def _columns(book: Gradebook) -> list[str]:
    """Return the headings of the marks: each exercise, and each of its tasks."""
    return [
        heading
        for exercise in book.exercises
        for heading in (exercise.name, *(task.title for task in exercise.tasks))
    ]


def _points(student: Student, exercise: Exercise) -> Iterator[int | float]:
    """Yield a student's points in an exercise, and in each of its tasks."""
    report = student.reports.get(exercise.name)
    yield report["points"] if report else 0
    for task in exercise.tasks:
        entry = student.of_task(exercise, task)
        yield entry["points"] if entry else 0


def remarks_of(student: Student) -> list[str]:
    """Return what there is to say of what a student handed in, a line each."""
    missing = ["nothing was handed in"] if student.hand_in.is_missing else []
    said = [*missing, *student.problems, *student.late, *student.notes, *_by_hand(student)]
    return list(map(visible, said))


def _by_hand(student: Student) -> Iterator[str]:
    """Yield the marks that were given by hand."""
    for name, report in student.reports.items():
        if report["is_by_hand"]:
            yield f"{name}: {report['points']} of {report['full_points']} points, given by hand"
        for entry in report["tasks"]:
            if entry["is_by_hand"]:
                mark = f"{entry['points']} of {entry['full_points']} points"
                yield f"{entry['task']} {entry['function']}: {mark}, given by hand"


def credits_of(book: Gradebook) -> list[str]:
    """Return whose the entries are that are not called as their student is, a line a student."""
    return [
        f"{handed_in_as(student)}: credited to {student.label}"
        for student in book.students
        if student.hand_in.is_renamed and not student.hand_in.is_missing
    ]


def handed_in_as(student: Student) -> str:
    """Return in a line what a student's folders and files are called."""
    return ", ".join(map(visible, student.hand_in.entries))


def as_dict(book: Gradebook) -> dict[str, Any]:
    """Return everything about a class as one JSON object."""
    ids = told_apart((student.id for student in book.students), encodable)
    return {
        "version": VERSION,
        "command": "grade",
        "seed": book.seed,
        "variant": book.is_variant,
        "isolation": book.isolation,
        "due": book.due.isoformat() if book.due else None,
        "full_points": book.full_points,
        "exercises": [{"name": e.name, "full_points": book.full_of(e)} for e in book.exercises],
        "left_out": list(book.left_out),
        "students": [_student_as_dict(s, ids[s.id]) for s in book.students],
        "tasks": [_summary_as_dict(summary) for summary in book.summary],
        "alike": [_alike_as_dict(alike) for alike in book.alike],
    }


def _alike_as_dict(alike: Alike) -> dict[str, Any]:
    """Return functions that are alike, with their passages; those of nobody are the lesson's."""
    return {
        "exercise": alike.exercise.name,
        "passages": [
            {
                "who": [student.label for student in passage.who],
                "function": passage.name,
                "text": passage.text,
            }
            for passage in alike.passages
        ],
    }


def _student_as_dict(student: Student, name: str) -> dict[str, Any]:
    """Return one student's marks, under an id that no other student has."""
    enrolled = student.hand_in.student
    return {
        "id": name,
        "handed_in_as": list(map(encodable, student.hand_in.entries)),
        "unmatched": student.hand_in.unmatched or None,
        "name": enrolled.name,
        "email": enrolled.email,
        "status": student.status,
        "points": student.points,
        "team": enrolled.team,
        "feedback": feedback_name(student),
        "remarks": remarks_of(student),
        "exercises": [
            {key: value for key, value in report.items() if key != "passages"}
            for report in student.reports.values()
        ],
    }


def _summary_as_dict(summary: TaskSummary) -> dict[str, Any]:
    """Return how a class did in a task."""
    return {
        "task": summary.task.id,
        "function": summary.task.function,
        "exercise": summary.exercise.name,
        "handed_in": summary.handed_in,
        "full_marks": summary.full,
        "not_written": summary.not_written,
        "mean_points": round(summary.mean, 3),
        "full_points": summary.full_points,
        "failed_criteria": dict(summary.failed),
        "misconceptions": [
            {
                "name": found.name,
                "says": found.says,
                "hint": found.hint,
                "students": found.students,
                "who": [student.label for student in found.who],
            }
            for found in summary.misconceptions
        ],
        "unexplained": [student.label for student in summary.unexplained.who],
    }


def feedback_name(student: Student) -> str:
    """Return the name of the page that a student gets."""
    return f"feedback/{student.stem}.html"


def lines_of(entry: dict[str, Any]) -> list[str]:
    """Return what there is to say of a task, a line each: what is right, what is not, the hint."""
    right = [f"right: {c['name']}" for c in entry["criteria"] if c["points"] == c["full_points"]]
    wrong = [f"{c['name']}: {c['message']}" for c in entry["criteria"] if c["message"]]
    hints = [f"hint: {found['hint']}" for found in entry["diagnoses"]]
    lent = [entry["lent"]] if entry["lent"] else []
    return [*lent, *right, *wrong, *hints, *map(visible, entry["comments"])]


def write_exports(book: Gradebook, folder: Path) -> None:
    """Write grades.csv and grades.json into a folder."""
    (folder / "grades.csv").write_text(as_csv(book), encoding="utf-8-sig", newline="")
    write_json(folder / "grades.json", as_dict(book))


def write_json(path: Path, value: dict[str, Any]) -> None:
    """Write a JSON object, in letters that any program can read."""
    path.write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8", newline="\n")
