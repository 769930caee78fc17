"""The roster: who belongs to the class, read from a sheet.

Its first line names the columns, in many words: those that people write, those of Canvas's exported
gradebook, of Moodle's grading worksheet and of Gradescope's roster. A column that tells students
apart is needed. `name`, `email`, `due` (for students with more time) and `team` (students with the
same team share what one of them handed in) may be there; other columns are left alone.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

from lesson_code.course.class_run.names import same_name, shown
from lesson_code.course.class_run.sheets import (
    Row,
    SheetError,
    plain_heading,
    read_sheet,
    read_time,
)

IDS = (
    *("id", "studentid", "studentnumber", "sid", "identifier", "sisuserid", "sisloginid"),
    *("idnumber", "matriculationnumber", "orgdefinedid", "netid", "username", "userid", "login"),
    *("email", "emailaddress", "mail"),
)
"""Headings of what tells students apart, the best first: it is called the id, and so is a student's
folder or file. The others of a row fit a folder's name, too."""

NAMES = ("name", "fullname", "student", "studentname")
FIRST_NAMES = ("firstname", "givenname", "forename")
LAST_NAMES = ("lastname", "surname", "familyname")
EMAILS = ("email", "emailaddress", "mail")
DUE = ("due", "duedate", "extension", "extendedto")
TEAMS = ("team",)
KNOWN = frozenset((*IDS, *NAMES, *FIRST_NAMES, *LAST_NAMES, *DUE, *TEAMS))

CANVAS = frozenset(("student", "id", "section"))
MOODLE = frozenset(("identifier", "grade", "lastmodifiedgrade"))
"""Headings that make a roster Canvas's gradebook, or Moodle's worksheet."""

POINTS_POSSIBLE = "Points Possible"
NO_STUDENT = re.compile(r"(muted|manual posting.*|\(read only\))?", re.IGNORECASE)
"""The cells of a row in which Canvas says something of the columns."""

NUMBER = re.compile(r"\D*(\d+)")
"""What Moodle calls a student in its worksheet: Participant 123."""


@dataclass(frozen=True)
class Enrolled:
    """A student of the class.

    `also` holds what else tells the student apart, such as a login; `canvas` and `moodle` the
    numbers that these give the student; `cells` the row of the roster as it stands there.
    """

    id: str
    name: str = ""
    email: str = ""
    due: datetime | None = None
    team: str = ""
    also: tuple[str, ...] = ()
    canvas: str = ""
    moodle: str = ""
    cells: Mapping[str, str] = field(default_factory=dict, compare=False, repr=False)


@dataclass(frozen=True)
class Roster:
    """A class, in the order of its file, and what else the file says.

    `system` is the course system whose file it is; `full_points` are the full marks of Canvas's
    columns, where they are numbers.
    """

    students: tuple[Enrolled, ...]
    headings: tuple[str, ...] = ()
    system: str = ""
    full_points: Mapping[str, str] = field(default_factory=dict)


def read_roster(path: Path) -> Roster:
    """Return the students in a roster.

    Raises
    ------
    SheetError
        The file is no sheet, or no column or more than one tells students apart; an id is empty,
        stands twice or holds a path separator; a time cannot be read. Every bad line is named.
    """
    sheet = read_sheet(path, KNOWN)
    plain = [plain_heading(heading) for heading in sheet.headings]
    columns = dict(zip(reversed(plain), reversed(sheet.headings), strict=True))
    best = next((heading for heading in IDS if heading in columns), "id")
    if plain.count(best) != 1:
        listed = ", ".join(map(repr, sheet.headings))
        raise SheetError(f"{path}: needs one column named id, and has {listed}")
    system = next(
        (name for name, its in (("canvas", CANVAS), ("moodle", MOODLE)) if its <= set(plain)), ""
    )
    first = sheet.headings[0]
    rows = [row for row in sheet.rows if not (system == "canvas" and _is_no_student(row, first))]
    students = [_student(row, columns, best, system) for row in rows]
    errors = [e for row, s in zip(rows, students, strict=True) for e in _errors(row, s, columns)]
    sheet.refuse([*errors, *_repeated([row.line for row in rows], students)])
    full = next((row.cells for row in sheet.rows if POINTS_POSSIBLE in row.cells[first]), {})
    return Roster(tuple(students), sheet.headings, system, full)


def _is_no_student(row: Row, first: str) -> bool:
    """Return whether a row of Canvas's gradebook says something of the columns."""
    return POINTS_POSSIBLE in row.cells[first] or all(
        NO_STUDENT.fullmatch(cell) for cell in row.cells.values()
    )


def _student(row: Row, columns: Mapping[str, str], best: str, system: str) -> Enrolled:
    """Return the student of a row, which may be wrong."""

    def cell(*headings: str) -> str:
        return next((row.cells[columns[h]] for h in headings if h in columns), "")

    try:
        due = read_time(cell(*DUE)) if cell(*DUE) else None
    except ValueError:
        due = None
    name = cell(*NAMES) or " ".join(filter(None, (cell(*FIRST_NAMES), cell(*LAST_NAMES))))
    own = cell(best)
    also = tuple(dict.fromkeys(other for h in IDS if (other := cell(h)) and other != own))
    email = cell(*EMAILS) or next((other for other in (own, *also) if "@" in other), "")
    number = NUMBER.fullmatch(cell("identifier")) if system == "moodle" else None
    return Enrolled(
        own,
        name,
        email,
        due,
        cell(*TEAMS),
        also,
        canvas=own if system == "canvas" else "",
        moodle=number[1] if number else "",
        cells=row.cells,
    )


def _errors(row: Row, student: Enrolled, columns: Mapping[str, str]) -> Iterator[str]:
    """Yield what is wrong with a row by itself."""
    if not student.id:
        yield f"line {row.line} has no id"
    if set(student.id) & set("/\\\0"):
        got = shown(student.id)
        yield f"line {row.line}: an id names a file, and cannot hold / or \\, got {got}"
    try:
        read_time(next((row.cells[columns[h]] for h in DUE if h in columns), "") or "2026-01-01")
    except ValueError as error:
        yield f"line {row.line}: {error}"


def _repeated(lines: list[int], students: list[Enrolled]) -> Iterator[str]:
    """Yield which ids stand twice, however they are written."""
    seen: dict[str, int] = {}
    for line, student in zip(lines, students, strict=True):
        first = seen.setdefault(same_name(student.id), line)
        if first != line and student.id:
            yield f"line {line} has the id {shown(student.id)}, as line {first} has"
