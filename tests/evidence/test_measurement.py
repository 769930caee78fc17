"""The shape that all results share: JSON without nan, stored and read, and tables."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import pytest
from rich.table import Table

from lesson_code.evidence.measurement import (
    Limit,
    Measurement,
    at_least,
    digits,
    machine,
    rows_with,
    table,
)


@dataclass(frozen=True)
class Drop:
    """A row with a figure that follows from the others."""

    derived: ClassVar = ("speed",)

    ball: str
    metres: float
    seconds: float = math.nan

    @property
    def speed(self) -> float:
        """In m/s."""
        return self.metres / self.seconds


@dataclass(frozen=True)
class Plain:
    """A row of figures alone."""

    ball: str
    metres: float


@dataclass(frozen=True)
class Drops(Measurement):
    """A made-up measurement."""

    command = "measure drops"
    version = 3
    rows = {"drops": Plain, "best": Plain}  # noqa: RUF012 - as in the base class
    derived = ("limits",)

    repeats: int
    best: Plain | None
    drops: tuple[Plain, ...]

    @property
    def limits(self) -> list[Limit]:
        """What is wanted."""
        return [at_least("balls", len(self.drops), 2)]

    def tables(self) -> Iterator[Table]:
        """Yield one table."""
        columns = {"ball": lambda row: row.ball, "m": lambda row: digits(row.metres)}
        yield table("Drops", columns, self.drops, group=lambda row: row.ball[0])


RED, BLUE = Plain("red", 1.5), Plain("blue", math.nan)
RESULT = Drops(7, None, (RED, BLUE))


def test_json_has_version_command_fields_and_what_follows_from_them() -> None:
    """Null stands for what is not known."""
    assert json.loads(json.dumps(RESULT.as_dict(), allow_nan=False)) == {
        "version": 3,
        "command": "measure drops",
        "repeats": 7,
        "best": None,
        "drops": [{"ball": "red", "metres": 1.5}, {"ball": "blue", "metres": None}],
        "limits": [{"what": "balls", "value": 2, "wanted": "at least 2", "reached": True}],
    }


def test_stored_result_is_the_same_again(tmp_path: Path) -> None:
    """A line for each row; nan comes back; another version is refused."""
    path = tmp_path / "drops.json"
    RESULT.store(path)
    assert '\n  {"ball": "red", "metres": 1.5},\n' in path.read_text()
    assert repr(Drops.stored(path)) == repr(RESULT)
    path.write_text(path.read_text().replace('"version": 3', '"version": 2'))
    with pytest.raises(ValueError, match="version must be 3, got 2"):
        Drops.stored(path)


def test_row_says_what_follows_from_its_figures() -> None:
    """Speed, of way and time; unknown where one of them is."""
    result = Drops(1, None, (Drop("red", 3.0, 2.0), Drop("blue", 3.0)))  # type: ignore[arg-type]
    assert [drop["speed"] for drop in result.as_dict()["drops"]] == [1.5, None]


def test_rows_are_found_by_a_column() -> None:
    """Or refused, with the values that there are."""
    assert rows_with(RESULT.drops, ball="red") == [RED]
    with pytest.raises(ValueError, match="ball must be one of red, blue, got 'green'"):
        rows_with(RESULT.drops, ball="green")


def test_table_has_a_heading_for_each_group() -> None:
    """Two groups of one row: four lines, and nothing for an unknown figure."""
    (made,) = RESULT.tables()
    assert made.row_count == 4
    lines = [line.split() for line in RESULT.as_text(40).splitlines()]
    for line in (["r"], ["red", "1.5"], ["b"], ["blue"]):
        assert line in lines


def test_machine_names_what_times_depend_on() -> None:
    """And the packages that race, installed or not."""
    assert set(machine()) == {"python", "system", "processor", "cores", "packages"}
    assert set(machine()["packages"]) == {"numpy", "numba", "pymunk", "pyb2d3"}
