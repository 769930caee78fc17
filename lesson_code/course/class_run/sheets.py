"""Sheets that people write: CSV as spreadsheets and course systems save it, read row by row.

UTF-8 with or without a byte order mark, UTF-16; commas, semicolons or tabs; a first line ``sep=;``;
rows that end before the last column, or after it in empty cells.
"""

from __future__ import annotations

import codecs
import csv
import io
import re
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

LARGEST_SHEET = 20_000_000
"""Bytes."""

MOST_ROWS = 100_000

MOST_ERRORS = 10
"""Lines of a bad sheet that are told at once."""

DELIMITERS = (",", ";", "\t")

SEPARATOR_LINE = re.compile(r'"?sep=(.)"?[;,\t]*\r?\n?', re.IGNORECASE)
"""The line with which Excel is told what stands between cells."""


class SheetError(ValueError):
    """A sheet that cannot be used; the message names the file and the lines."""


@dataclass(frozen=True)
class Row:
    """A row that holds anything: the line it begins in, and its cells by heading."""

    line: int
    cells: Mapping[str, str]


@dataclass(frozen=True)
class Sheet:
    """A sheet: its headings as they are written, and its rows."""

    path: Path
    headings: tuple[str, ...]
    rows: tuple[Row, ...]

    def refuse(self, errors: list[str]) -> None:
        """Raise what is wrong with the sheet, if anything is.

        Raises
        ------
        SheetError
            There are errors; the first ten are told.
        """
        if errors:
            more = f"; and {len(errors) - MOST_ERRORS} more" if len(errors) > MOST_ERRORS else ""
            raise SheetError(f"{self.path}: {'; '.join(errors[:MOST_ERRORS])}{more}")


def read_sheet(path: Path, known: Container[str]) -> Sheet:
    """Return the sheet in a file.

    Parameters
    ----------
    path : Path
        A CSV file.
    known : container of str
        Headings that are looked for, as :func:`plain_heading` writes them; they tell what stands
        between the cells.

    Raises
    ------
    SheetError
        The file is missing, too large, empty, not in UTF-8 or UTF-16 or no CSV; or a row has more
        cells than there are headings.
    """
    text = _text(path)
    before = 0
    if separator := SEPARATOR_LINE.match(text):
        text, before = text[separator.end() :], 1
    delimiter = separator[1] if separator else _delimiter(text, known)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True)
    rows: list[Row] = []
    errors: list[str] = []
    try:
        headings = tuple(heading.strip() for heading in next(reader, []))
        while headings and not headings[-1]:
            headings = headings[:-1]
        for line, cells in _numbered(reader, before):
            if len(cells) > len(headings) and any(cells[len(headings) :]):
                errors.append(
                    f"line {line} has {len(cells)} cells, and the first line {len(headings)}"
                )
            named: dict[str, str] = {}
            for number, heading in enumerate(headings):
                named.setdefault(heading, cells[number] if number < len(cells) else "")
            rows.append(Row(line, named))
            if len(rows) > MOST_ROWS:
                raise SheetError(f"{path}: has more than {MOST_ROWS:,} rows")
    except csv.Error as error:
        raise SheetError(f"{path}: line {reader.line_num + before} is no CSV ({error})") from None
    sheet = Sheet(path, headings, tuple(rows))
    sheet.refuse(errors)
    return sheet


def plain_heading(heading: str) -> str:
    """Return a heading without what people write differently: capitals, spaces and marks.

    >>> plain_heading("E-mail Address")
    'emailaddress'
    """
    return "".join(letter for letter in heading.casefold() if letter.isalnum())


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
    """Return the text of a sheet, or say why it is none."""
    if not path.is_file():
        raise SheetError(f"{path}: there is no such file")
    if path.stat().st_size > LARGEST_SHEET:
        raise SheetError(f"{path}: larger than {LARGEST_SHEET // 1_000_000} MB")
    content = path.read_bytes()
    try:
        text = content.decode(_encoding(content))
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise SheetError(
            f"{path}: line {line} is not text in {error.encoding.upper()} (byte "
            f"{content[error.start] if error.start < len(content) else 0:#04x}); "
            "save the sheet as CSV UTF-8"
        ) from None
    if not text.strip():
        raise SheetError(f"{path}: is empty")
    return text


def _encoding(content: bytes) -> str:
    """Return the encoding of a sheet; where no mark tells, UTF-16 is known by its empty bytes."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    begins = content[:200]
    if begins[1::2].count(0) > len(begins) // 4:
        return "utf-16-le"
    if begins[::2].count(0) > len(begins) // 4:
        return "utf-16-be"
    return "utf-8-sig"


def _delimiter(text: str, known: Container[str]) -> str:
    """Return what stands between cells: what gives the most known headings, then the most."""

    def gives(delimiter: str) -> tuple[int, int]:
        try:
            first = next(csv.reader(io.StringIO(text, newline=""), delimiter=delimiter), [])
        except csv.Error:
            return (0, 0)
        return (sum(plain_heading(heading) in known for heading in first), len(first))

    return max(DELIMITERS, key=gives)


def _numbered(reader: Iterator[list[str]], before: int) -> Iterator[tuple[int, list[str]]]:
    """Yield the rows that hold anything, each with the line it begins in."""
    begins = reader.line_num + before  # type: ignore[attr-defined]
    for cells in reader:
        stripped = [cell.strip() for cell in cells]
        if any(stripped):
            yield begins + 1, stripped
        begins = reader.line_num + before  # type: ignore[attr-defined]
