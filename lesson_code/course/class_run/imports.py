"""The marks of a class as course systems import them: canvas.csv, moodle.csv, gradescope.zip.

- Canvas reads a gradebook: columns that say who, up to `Section`, then a column an exercise; a row
  `Points Possible`. It finds a student by `ID`, or by the login.
- Moodle reads a grading worksheet: `Identifier`, `Grade`, `Last modified (grade)`, and `Feedback
  comments`, which it shows as HTML.
- Gradescope reads no sheet, but what an autograder says: the zip is one that looks up the marks of
  whoever hands in, by number or email.

Where the roster is the system's own file, its columns and rows are kept, and points are given in
its full marks. Nothing handed in is an empty cell: the system's rule for missing work holds.
"""

from __future__ import annotations

import csv
import html
import io
import json
from collections.abc import Iterator, Sequence
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.changes import exact, hundredths, number
from lesson_code.course.class_run.exports import lines_of, remarks_of
from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.names import same_name, sheet_text, visible
from lesson_code.course.class_run.roster import POINTS_POSSIBLE, Enrolled
from lesson_code.course.class_run.sheets import plain_heading
from lesson_code.course.class_run.student import Student
from lesson_code.course.fresh_copies import zipped
from lesson_code.course.grading.exercises import Exercise

CANVAS_COLUMNS = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
SIS_IDS = ("sisuserid", "studentid", "studentnumber", "sid", "idnumber", "matriculationnumber")
LOGINS = ("sisloginid", "username", "netid", "login", "userid")
"""Headings, as :func:`plain_heading` writes them, of what Canvas calls SIS User ID and Login ID."""

MOODLE_COLUMNS = (
    *("Identifier", "Full name", "Email address", "Grade", "Maximum Grade"),
    *("Last modified (grade)", "Feedback comments"),
)
OURS_IN_MOODLE = ("Grade", "Maximum Grade", "Feedback comments")
"""Columns that are found however Moodle's release writes them: it has Maximum grade, too."""

NO_GRADE_YET = "-"
"""How Moodle writes a time that is none."""

SETUP = """\
#!/usr/bin/env bash
# Gradescope runs this once. Looking up marks takes Python alone.
set -e
command -v python3 > /dev/null || { apt-get update && apt-get install -y python3; }
"""

LOOK_UP = """\
#!/usr/bin/env python3
# Gradescope runs this for every submission: it writes down the marks of whoever handed it in.
import json
import pathlib

PLACE = pathlib.Path("/autograder")


def known(user):
    # The keys under which the marks of a user may stand.
    return [str(user.get(key) or "").strip().casefold() for key in ("sid", "email")]


def main():
    marks = json.loads((PLACE / "source" / "marks.json").read_text(encoding="utf-8"))
    told = json.loads((PLACE / "submission_metadata.json").read_text(encoding="utf-8"))
    keys = [key for user in told.get("users", []) for key in known(user) if key]
    found = [marks["who"][key] for key in keys if key in marks["who"]]
    results = marks["results"][found[0]] if found else {
        "score": 0,
        "output": "There are no marks for you yet: please ask your instructor.",
    }
    place = PLACE / "results" / "results.json"
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(json.dumps(results), encoding="utf-8")


main()
"""


def write_imports(book: Gradebook, folder: Path) -> None:
    """Write canvas.csv, moodle.csv and gradescope.zip into a folder."""
    (folder / "canvas.csv").write_text(canvas(book), encoding="utf-8", newline="")
    (folder / "moodle.csv").write_text(moodle(book), encoding="utf-8", newline="")
    marks = json.dumps(gradescope_marks(book), indent=1) + "\n"
    files = {"setup.sh": SETUP, "run_autograder": LOOK_UP, "marks.json": marks}
    archive = zipped({name: text.encode() for name, text in files.items()})
    (folder / "gradescope.zip").write_bytes(archive)


def canvas(book: Gradebook) -> str:
    """Return the marks as a gradebook that Canvas imports, a column an exercise."""
    roster = book.roster
    is_own = roster is not None and roster.system == "canvas"
    who: Sequence[str] = CANVAS_COLUMNS
    full: dict[str, str] = {}
    named = {exercise.name: exercise.name for exercise in book.exercises}
    if roster is not None and is_own:
        plain = [plain_heading(heading) for heading in roster.headings]
        who = roster.headings[: plain.index("section") + 1]
        for exercise in book.exercises:
            if heading := _canvas_heading(exercise, roster.headings[len(who) :]):
                named[exercise.name] = heading
                full[exercise.name] = roster.full_points.get(heading, "")
    most = {e.name: _full_mark(full.get(e.name, ""), book.full_of(e)) for e in book.exercises}
    rows = [
        [*who, *named.values()],
        [f"    {POINTS_POSSIBLE}", *[""] * (len(who) - 1), *map(str, most.values())],
    ]
    for student in _theirs(book):
        enrolled = student.hand_in.student
        said = [enrolled.cells[heading] for heading in who] if is_own else _for_canvas(enrolled)
        points = [_scaled(student, e, book, most[e.name]) for e in book.exercises]
        rows.append([*map(_cell, said), *points])
    return _csv(rows)


def _for_canvas(enrolled: Enrolled) -> list[str]:
    """Return what tells a student apart where the roster is not Canvas's."""
    cells = {plain_heading(heading): cell for heading, cell in enrolled.cells.items()}
    sis, login = (next((cells[h] for h in its if cells.get(h)), "") for its in (SIS_IDS, LOGINS))
    if not (enrolled.canvas or sis):
        login = login or enrolled.id
    return [enrolled.name or enrolled.id, enrolled.canvas, sis, login, ""]


def _canvas_heading(exercise: Exercise, headings: Sequence[str]) -> str | None:
    """Return the column of an exercise in a gradebook: its name or title, and Canvas's number."""
    for heading in headings:
        title = heading.rpartition(" (")[0] if heading.endswith(")") else heading
        number_, _, rest = exercise.name.partition("_")
        forms = {exercise.name, exercise.title, f"{number_} {exercise.title}", rest}
        if plain_heading(title) in set(map(plain_heading, forms)) - {""}:
            return heading
    return None


def moodle(book: Gradebook) -> str:
    """Return the marks as a grading worksheet that Moodle imports."""
    roster = book.roster
    is_own = roster is not None and roster.system == "moodle"
    columns = list(MOODLE_COLUMNS)
    if roster is not None and is_own:
        columns = list(roster.headings)
    called = {plain_heading(column): column for column in columns}
    grade, full, feedback = (called.get(plain_heading(name), name) for name in OURS_IN_MOODLE)
    columns += [] if feedback in columns else [feedback]
    rows = [columns]
    for student in _theirs(book):
        enrolled = student.hand_in.student
        cells = dict(enrolled.cells) if is_own else _for_moodle(enrolled, book)
        most = _full_mark(cells.get(full, ""), book.full_points)
        points = exact(student.points)
        ours = {
            grade: _share(points, book.full_points, most) if student.reports else "",
            feedback: "<br>".join(map(html.escape, _feedback(student, book))),
        }
        rows.append([_cell((cells | ours).get(column, "")) for column in columns])
    return _csv(rows)


def _for_moodle(enrolled: Enrolled, book: Gradebook) -> dict[str, str]:
    """Return what tells a student apart where the roster is not Moodle's."""
    return {
        "Identifier": f"Participant {enrolled.moodle}" if enrolled.moodle else "",
        "Full name": enrolled.name or enrolled.id,
        "Email address": enrolled.email,
        "Maximum Grade": str(book.full_points),
        "Last modified (grade)": NO_GRADE_YET,
    }


def _feedback(student: Student, book: Gradebook) -> Iterator[str]:
    """Yield what a student is told, in lines."""
    yield from map(visible, student.comments)
    yield from remarks_of(student)
    for exercise in book.exercises:
        for task in exercise.tasks:
            if entry := student.of_task(exercise, task):
                yield f"{task.title}: {entry['points']} of {entry['full_points']} points"
                yield from (f"- {line}" for line in lines_of(entry) if not entry["is_full"])


def gradescope_marks(book: Gradebook) -> dict[str, Any]:
    """Return every student's results, and under which keys they are found.

    A key that two students share leads to neither.
    """
    keys: dict[str, set[str]] = {}
    for student in _theirs(book):
        enrolled = student.hand_in.student
        for key in (enrolled.id, enrolled.email, *enrolled.also):
            if key:
                keys.setdefault(same_name(key), set()).add(student.stem)
    return {
        "who": {key: min(stems) for key, stems in sorted(keys.items()) if len(stems) == 1},
        "results": {student.stem: gradescope(student, book) for student in _theirs(book)},
    }


def gradescope(student: Student, book: Gradebook) -> dict[str, Any]:
    """Return one student's marks as Gradescope's results.json.

    A test a task, visible to the student, with messages and hints. What a student may not see is
    not in it.
    """
    return {
        "score": student.points,
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "output": "\n".join([*map(visible, student.comments), *remarks_of(student)]),
        "output_format": "text",
        "tests": [test for exercise in book.exercises for test in _tests(student, exercise, book)],
    }


def _tests(student: Student, exercise: Exercise, book: Gradebook) -> Iterator[dict[str, Any]]:
    """Yield a Gradescope test for each task of an exercise."""
    for task in exercise.tasks:
        entry = student.of_task(exercise, task)
        yield {
            "name": task.title,
            "number": task.id,
            "score": entry["points"] if entry else 0,
            "max_score": book.full_of_task(exercise, task),
            "output": "\n".join(lines_of(entry)) if entry else "not handed in",
            "output_format": "text",
            "visibility": "visible",
        }


def _theirs(book: Gradebook) -> list[Student]:
    """Return the students whom a course system knows: with a roster, those on it."""
    if book.roster is None:
        return list(book.students)
    known = {student.id for student in book.roster.students}
    return [s for s in book.students if s.id in known and not s.hand_in.unmatched]


def _full_mark(said: str, ours: int | float) -> int | float:
    """Return the full mark that a system's file says, or ours where it says none."""
    try:
        mark = Decimal(said)
    except InvalidOperation:
        return ours
    return number(mark) if mark.is_finite() and mark > 0 else ours


def _scaled(student: Student, exercise: Exercise, book: Gradebook, most: int | float) -> str:
    """Return a student's points in an exercise, in the system's full mark."""
    report = student.reports.get(exercise.name)
    return _share(exact(report["points"]), book.full_of(exercise), most) if report else ""


def _share(points: Decimal, full: int | float, most: int | float) -> str:
    """Return points of a full mark in another full mark."""
    return str(number(hundredths(points * exact(most) / exact(full)))) if full else "0"


def _cell(text: str) -> str:
    """Return a text that others have chosen, safe for a sheet."""
    return sheet_text(visible(text)) if text != NO_GRADE_YET else text


def _csv(rows: Sequence[Sequence[Any]]) -> str:
    """Return rows as CSV."""
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator="\r\n").writerows(rows)
    return text.getvalue()
