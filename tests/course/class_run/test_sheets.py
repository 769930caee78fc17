"""Sheets: the same rows, whichever program saved them."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run.sheets import SheetError, read_sheet

KNOWN = ("id", "name", "due")
CELLS = [["id", "Name", "Due"], ["ada", 'Lady; "A", L', "2026-11-20"], ["zoë", "Zoë\tÖ", ""]]
CODECS = ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be")


def saved(rows: list[list[str]], delimiter: str = ",", line: str = "\r\n") -> str:
    """Return rows as a spreadsheet saves them."""
    text = io.StringIO(newline="")
    csv.writer(text, delimiter=delimiter, lineterminator=line).writerows(rows)
    return text.getvalue()


def sheet(folder: Path, content: bytes) -> Path:
    """Write a sheet."""
    path = folder / "sheet.csv"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("codec", CODECS)
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
@pytest.mark.parametrize("first", ["", "sep={}\r\n", '"sep={}"\r\n'])
def test_rows_are_the_same_whoever_saved_them(
    tmp_path: Path, codec: str, delimiter: str, first: str
) -> None:
    """Encodings of Excel, its separators, and the line that names one."""
    text = first.format(delimiter) + saved(CELLS, delimiter)
    read = read_sheet(sheet(tmp_path, text.encode(codec)), KNOWN)
    assert read.headings == ("id", "Name", "Due")
    assert [list(row.cells.values()) for row in read.rows] == CELLS[1:]
    assert [row.line for row in read.rows] == ([3, 4] if first else [2, 3])


def test_short_rows_and_empty_cells_at_the_end_are_no_fault(tmp_path: Path) -> None:
    """Spreadsheets leave out empty cells at the end of a row, and add some to all rows."""
    path = sheet(tmp_path, b"id,name,due,,\r\nada\r\n,,,,\r\n\r\nbob,B,,,\r\n")
    read = read_sheet(path, KNOWN)
    assert [tuple(row.cells.values()) for row in read.rows] == [("ada", "", ""), ("bob", "B", "")]
    assert [row.line for row in read.rows] == [2, 5]


def test_row_with_more_cells_than_headings_is_named(tmp_path: Path) -> None:
    """A name with a comma that nobody quoted would move all that follows."""
    path = sheet(tmp_path, b'id,name\nada,"L,\nA"\nbob,Hope, Bob\n')
    with pytest.raises(SheetError, match="line 4 has 3 cells, and the first line 2"):
        read_sheet(path, KNOWN)


def test_delimiter_is_what_gives_known_headings(tmp_path: Path) -> None:
    """Commas within a heading are more than the semicolons that part the cells."""
    path = sheet(tmp_path, b"id;name;tutor, group, room, day\nada;Ada;x\n")
    assert read_sheet(path, KNOWN).headings == ("id", "name", "tutor, group, room, day")


def said_of(path: Path) -> str:
    """Return why a sheet is refused; an empty text if it is read."""
    try:
        read_sheet(path, KNOWN)
    except SheetError as error:
        return str(error)
    return ""


@given(content=st.binary(max_size=60))
def test_any_bytes_are_a_sheet_or_a_clear_error(
    tmp_path_factory: pytest.TempPathFactory, content: bytes
) -> None:
    """Whatever stands in the file, nothing else is raised, and the error names the file."""
    path = sheet(tmp_path_factory.getbasetemp(), content)
    said = said_of(path)
    assert not said or said.startswith(f"{path}: ")
