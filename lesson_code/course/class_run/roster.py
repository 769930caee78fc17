"""The roster: who belongs to the class, read from a CSV file.

Its first line names the columns. `id` is needed: what a student's folder or file is called, or
begins with. `name`, `email` and `due` (for students with more time) may be there; other columns are
left alone.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from lesson_code.course.class_run.names import same_name, shown

MOST_STUDENTS = 100_000
LARGEST_ROSTER = 20_000_000
"""Bytes."""

MOST_ERRORS = 10
"""Lines of a bad roster that are told at once."""


class RosterError(ValueError):
    """A roster that cannot be used; the message names the file and the lines."""


@dataclass(frozen=True)
class Enrolled:
    """A student of the class."""

    id: str
    name: str = ""
    email: str = ""
    due: datetime | None = None


def read_roster(path: Path) -> tuple[Enrolled, ...]:
    """Return the students in a roster, in the order of the file.

    Raises
    ------
    RosterError
        The file is missing, too large, no CSV in UTF-8 or without a column `id`; an id is empty,
        stands twice or holds a path separator; a time cannot be read. Every bad line is named.
    """
    rows = list(_rows(path, _text(path)))
    students = [_student(row) for _, row in rows]
    errors = [error for (line, row) in rows for error in _errors(line, row)]
    errors += _repeated([line for line, _ in rows], students)
    if errors:
        more = f"; and {len(errors) - MOST_ERRORS} more" if len(errors) > MOST_ERRORS else ""
        raise RosterError(f"{path}: {'; '.join(errors[:MOST_ERRORS])}{more}")
    return tuple(students)


def read_time(text: str) -> datetime:
    """Return a time such as 2026-11-20T23:59, of this machine's own zone unless it names one.

    Raises
    ------
    ValueError
        It is no such time.
    """
    try:
        return datetime.fromisoformat(text.strip()).astimezone()
    except (ValueError, OverflowError, OSError):
        raise ValueError(f"a time must be like 2026-11-20T23:59, got {text!r}") from None


def _text(path: Path) -> str:
    """Return the text of a roster, or say why it is none."""
    if not path.is_file():
        raise RosterError(f"{path}: there is no such roster")
    if path.stat().st_size > LARGEST_ROSTER:
        raise RosterError(f"{path}: larger than {LARGEST_ROSTER // 1_000_000} MB")
    try:
        text = path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError:
        raise RosterError(f"{path}: is not text in UTF-8; save it as CSV UTF-8") from None
    if not text.strip():
        raise RosterError(f"{path}: is empty")
    return text


def _rows(path: Path, text: str) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield the rows that hold anything, each with the number of its line."""
    delimiter = ";" if ";" in text.splitlines()[0] else ","
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    try:
        columns = [column.strip().lower() for column in next(reader)]
        if columns.count("id") != 1:
            listed = ", ".join(map(repr, columns))
            raise RosterError(f"{path}: needs one column named id, and has {listed}")
        count = 0
        for cells in reader:
            if any(cell.strip() for cell in cells):
                count += 1
                if count > MOST_STUDENTS:
                    raise RosterError(f"{path}: lists more than {MOST_STUDENTS:,} students")
                row = dict(zip(columns, map(str.strip, cells), strict=False))
                yield reader.line_num, row | {"": "" if len(cells) == len(columns) else "wrong"}
    except csv.Error as error:
        raise RosterError(f"{path}: line {reader.line_num} is no CSV ({error})") from None


def _student(row: dict[str, str]) -> Enrolled:
    """Return the student of a row, which may be wrong."""
    try:
        due = read_time(row["due"]) if row.get("due") else None
    except ValueError:
        due = None
    return Enrolled(row.get("id", ""), row.get("name", ""), row.get("email", ""), due)


def _errors(line: int, row: dict[str, str]) -> Iterator[str]:
    """Yield what is wrong with a row by itself."""
    if row[""]:
        yield f"line {line} has another number of cells than the first line"
    if not row.get("id"):
        yield f"line {line} has no id"
    if set(row.get("id", "")) & set("/\\\0"):
        yield f"line {line}: an id names a file, and cannot hold / or \\, got {shown(row['id'])}"
    try:
        read_time(row.get("due") or "2026-01-01")
    except ValueError as error:
        yield f"line {line}: {error}"


def _repeated(lines: list[int], students: list[Enrolled]) -> Iterator[str]:
    """Yield which ids stand twice, however they are written."""
    seen: dict[str, int] = {}
    for line, student in zip(lines, students, strict=True):
        first = seen.setdefault(same_name(student.id), line)
        if first != line and student.id:
            yield f"line {line} has the id {shown(student.id)}, as line {first} has"
