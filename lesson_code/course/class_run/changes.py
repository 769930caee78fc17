"""What an instructor changes: one CSV, beside the marks, that every later run keeps.

Each row says whom it is about (`student`; everybody if empty) and what (`task`: a task or an
exercise; all if empty), and changes one thing or more of that:

- `points`: the mark of a student's task or exercise, in place of the grader's, before its weight;
- `weight`: how much a task or an exercise counts, 1 if nothing is said; 0 takes it out;
- `due`: until when it may be handed in;
- `late`: percent of the full mark that each day begun after that takes off;
- `comment`: what the student's page says.

Of two rows about one thing the one with a student counts before the one without, and then the one
with an exercise.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from decimal import Decimal, InvalidOperation
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.collect import HandIn
from lesson_code.course.class_run.names import same_name, sheet_text, shown, visible
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.class_run.sheets import (
    Row,
    SheetError,
    plain_heading,
    read_sheet,
    read_time,
)
from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises
from lesson_code.course.grading.task import Task

CHANGES = "changes.csv"
COLUMNS = ("student", "task", "points", "weight", "due", "late", "comment")
VALUES = COLUMNS[2:]

LARGEST_WEIGHT = 100
WHOLE = Decimal(1)
SMALLEST = Decimal("0.01")
"""Points are told to the hundredth, as course systems do."""

LONGEST_COMMENT = 10_000
"""Characters."""


@dataclass(frozen=True)
class Changes:
    """What an instructor changed, by (student, exercise or task); an empty text is all."""

    said: Mapping[str, Mapping[tuple[str, str], Any]] = field(default_factory=dict)

    def points(self, student: str, what: Exercise | Task) -> Decimal | None:
        """Return the mark that a student is given by hand."""
        found: Decimal | None = self._of("points").get((student, _key(what)))
        return found

    def weight(self, what: Exercise | Task) -> Decimal:
        """Return how much a task counts within its exercise, or an exercise as a whole."""
        found: Decimal = self._of("weight").get(("", _key(what)), WHOLE)
        return found

    def due(self, student: Enrolled, exercise: Exercise, due: datetime | None) -> datetime | None:
        """Return until when a student may hand in an exercise; `due` is what the run was told."""
        said = self._of("due")
        own = (said.get((student.id, exercise.name)), said.get((student.id, "")), student.due)
        all_ = (said.get(("", exercise.name)), said.get(("", "")), due)
        return next((time for time in (*own, *all_) if time is not None), None)

    def late(self, student: Enrolled, exercise: Exercise) -> Decimal:
        """Return what a day begun takes off, in percent of the full mark."""
        said = self._of("late")
        places = [(who, what) for who in (student.id, "") for what in (exercise.name, "")]
        return next((said[place] for place in places if place in said), Decimal(0))

    def comments(self, student: str, what: Exercise | Task | None) -> list[str]:
        """Return what the instructor tells a student about a task or an exercise, or about all."""
        said, key = self._of("comment"), "" if what is None else _key(what)
        return [said[who, key] for who in ("", student) if (who, key) in said]

    def _of(self, value: str) -> Mapping[tuple[str, str], Any]:
        """Return all that was said of a value."""
        return self.said.get(value, {})


def full_points(exercise: Exercise, changes: Changes) -> Decimal:
    """Return the full mark of an exercise, as its tasks are weighed."""
    each = (full_points_of_task(task, exercise, changes) for task in exercise.tasks)
    return sum(each, Decimal(0))


def full_points_of_task(task: Task, exercise: Exercise, changes: Changes) -> Decimal:
    """Return the full mark of a task, as it is weighed."""
    return weighed(Decimal(task.points), task, exercise, changes)


def weighed(points: Decimal, task: Task, exercise: Exercise, changes: Changes) -> Decimal:
    """Return what points of a task count."""
    return hundredths(points * changes.weight(task) * changes.weight(exercise))


def hundredths(points: Decimal) -> Decimal:
    """Return points to the hundredth."""
    return points.quantize(SMALLEST)


def number(points: Decimal) -> int | float:
    """Return points as a number to write down: whole ones without a point.

    >>> number(Decimal("3.00")), number(Decimal("2.50"))
    (3, 2.5)
    """
    return int(points) if points == points.to_integral_value() else float(points)


def exact(points: int | float) -> Decimal:
    """Return what :func:`number` wrote down, to add up without rounding."""
    return Decimal(str(points))


def read_changes(folder: Path, hand_ins: Sequence[HandIn]) -> Changes:
    """Return what an instructor changed; where there is no such file, an empty one is written.

    Parameters
    ----------
    folder : Path
        Where the marks are.
    hand_ins : sequence of HandIn
        The class.

    Raises
    ------
    SheetError
        A row names nobody and nothing, changes nothing, changes what another row has changed, or
        holds a value that cannot be. Every bad line is named.
    """
    path = folder / CHANGES
    if not path.exists():
        path.write_text(",".join(COLUMNS) + "\r\n", encoding="utf-8-sig", newline="")
        return Changes()
    sheet = read_sheet(path, COLUMNS)
    columns = {plain_heading(heading): heading for heading in sheet.headings}
    if missing := [name for name in COLUMNS if name not in columns]:
        raise SheetError(f"{path}: needs the columns {', '.join(COLUMNS)}; lacks {missing[0]}")
    called = _called(hand_ins)
    said: dict[str, dict[tuple[str, str], Any]] = {name: {} for name in VALUES}
    lines: dict[tuple[str, tuple[str, str]], int] = {}
    errors: list[str] = []
    for row in sheet.rows:
        try:
            place, values = _change(row, columns, called)
        except ValueError as error:
            errors.append(f"line {row.line}: {error}")
            continue
        for name, value in values.items():
            if first := lines.get((name, place)):
                errors.append(f"line {row.line}: says {name} again, as line {first} does")
            lines[name, place] = row.line
            said[name][place] = value
    sheet.refuse(errors)
    return Changes(said)


def _called(hand_ins: Sequence[HandIn]) -> list[dict[str, set[str]]]:
    """Return the students that a name may stand for: as an id, however shown, or else a login."""
    ids: dict[str, set[str]] = {}
    others: dict[str, set[str]] = {}
    for student in (hand_in.student for hand_in in hand_ins):
        for form in (student.id, visible(student.id), sheet_text(visible(student.id))):
            ids.setdefault(same_name(form), set()).add(student.id)
        for other in filter(None, (student.email, *student.also)):
            others.setdefault(same_name(other), set()).add(student.id)
    return [ids, others]


def _change(
    row: Row, columns: Mapping[str, str], called: Sequence[Mapping[str, set[str]]]
) -> tuple[tuple[str, str], dict[str, Any]]:
    """Return whom and what a row is about, and what it changes."""
    cells = {name: row.cells[columns[name]] for name in COLUMNS}
    student = _student(cells["student"], called) if cells["student"] else ""
    what = _what(cells["task"]) if cells["task"] else None
    given = {name: cells[name] for name in VALUES if cells[name]}
    if not given:
        raise ValueError(f"changes nothing: {', '.join(VALUES)} are empty")
    if "points" in given and not (student and what):
        raise ValueError("points need a student, and a task or an exercise")
    if "weight" in given and (student or not what):
        raise ValueError("a weight needs a task or an exercise, and is everybody's: no student")
    if isinstance(what, Task) and {"due", "late"} & set(given):
        raise ValueError("due and late are of an exercise or of all, not of a task")
    most = Decimal(what.points) if what else Decimal(0)
    read: dict[str, Callable[[str], Any]] = {
        "points": lambda text: _decimal("points", text, most),
        "weight": lambda text: _decimal("weight", text, Decimal(LARGEST_WEIGHT)),
        "due": read_time,
        "late": lambda text: _decimal("late", text.removesuffix("%").strip(), Decimal(100)),
        "comment": lambda text: text[:LONGEST_COMMENT],
    }
    return (student, _key(what) if what else ""), {n: read[n](text) for n, text in given.items()}


def _student(text: str, called: Sequence[Mapping[str, set[str]]]) -> str:
    """Return the id of the one student whom a cell names."""
    found = next((by[same_name(text)] for by in called if same_name(text) in by), set())
    if len(found) == 1:
        return next(iter(found))
    if found:
        listed = ", ".join(sorted(map(visible, found)))
        raise ValueError(f"student may be one of {listed}, got {shown(text)}")
    raise ValueError(f"student must be an id of grades.csv, got {shown(text)}")


def _what(text: str) -> Exercise | Task:
    """Return the task or the exercise that a cell names."""
    for task in (task for exercise in exercises() for task in exercise.tasks):
        if same_name(text) in (same_name(task.id), same_name(task.title)):
            return task
    try:
        return exercise_by_name(_number_of_chapter(text))
    except ValueError:
        raise ValueError(
            f"task must be a task such as 1.1 or an exercise such as 01 or pool, got {shown(text)}"
        ) from None


def _number_of_chapter(text: str) -> str:
    """Return a chapter's number with the zero that spreadsheets leave out.

    >>> _number_of_chapter("1"), _number_of_chapter("pool")
    ('01', 'pool')
    """
    return text.zfill(2) if text.isdecimal() else text


def _decimal(name: str, text: str, most: Decimal) -> Decimal:
    """Return a number from 0 to the most, with at most two decimals."""
    try:
        value = Decimal(text.replace(",", "."))
    except InvalidOperation:
        value = Decimal("NaN")
    if not (value.is_finite() and 0 <= value <= most):
        raise ValueError(f"{name} must be a number from 0 to {most}, got {shown(text)}")
    if value != value.quantize(SMALLEST):
        raise ValueError(f"{name} must have at most two decimals, got {shown(text)}")
    return value


def _key(what: Exercise | Task) -> str:
    """Return what names a task or an exercise; no task is called as an exercise is."""
    return what.name if isinstance(what, Exercise) else what.id
