"""The results of a measurement: rows of figures, their targets, and the machine.

Speed, accuracy, effects and hard cases each give a :class:`Measurement`. It is shown as tables or
as one JSON object with a version. A notebook, which has no time to measure, reads a stored one.
"""

from __future__ import annotations

import importlib.metadata
import json
import math
import operator
import platform
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from io import StringIO
from pathlib import Path
from typing import Any, ClassVar, Self, TypeVar

from rich.box import SIMPLE_HEAD, Box
from rich.console import Console
from rich.table import Table

from lesson_code.parallel import usable_cores

Row = TypeVar("Row")

PACKAGES = ("numpy", "numba", "pymunk", "pyb2d3")
"""Packages whose versions affect a measured time."""


@dataclass(frozen=True)
class Measurement:
    """The result of a command; each command has a class of its own, whose fields are the figures.

    Attributes
    ----------
    command : str
        The words after ``workbook`` that start the measurement.
    version : int
        Of the JSON object; it grows when a key changes.
    file : Path
        Where the result for a notebook is stored, if there is one.
    rows : dict of str to type
        The fields that hold rows, and the class of a row.
    derived : tuple of str
        Properties that stand in the JSON object beside the fields.
    """

    command: ClassVar[str]
    version: ClassVar[int] = 1
    file: ClassVar[Path]
    rows: ClassVar[dict[str, type]] = {}
    derived: ClassVar[tuple[str, ...]] = ()

    def tables(self) -> Iterator[Table]:
        """Yield the result as tables for the terminal."""
        raise NotImplementedError

    def as_text(self, width: int = 100) -> str:
        """Return the tables as plain text of at most `width` columns."""
        paper = StringIO()
        console = Console(file=paper, width=width, force_jupyter=False, color_system=None)
        console.print(*self.tables())
        return "\n".join(line.rstrip() for line in paper.getvalue().splitlines())

    def as_dict(self) -> dict[str, Any]:
        """Return the result as one JSON object; null stands for an unknown or infinite number."""
        return {"version": self.version, "command": self.command, **plain(self)}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Return the result that :meth:`as_dict` has written; an unknown number becomes nan."""
        return cls(**{field.name: cls._read(field.name, data[field.name]) for field in fields(cls)})

    @classmethod
    def _read(cls, name: str, value: Any) -> Any:
        if value is None or name not in cls.rows:
            return value
        row = cls.rows[name]
        if isinstance(value, list):
            return tuple(read_row(row, item) for item in value)
        return read_row(row, value)

    def store(self, path: Path | None = None) -> None:
        """Write the JSON object into the file for the notebook, a line for each row."""
        lines = [f' "{key}": {_lines(value)}' for key, value in self.as_dict().items()]
        text = "{\n" + ",\n".join(lines) + "\n}\n"
        (path or self.file).write_text(text, encoding="utf-8")

    @classmethod
    def stored(cls, path: Path | None = None) -> Self:
        """Return the stored result.

        Raises
        ------
        ValueError
            The file is of another version.
        """
        data = json.loads((path or cls.file).read_text(encoding="utf-8"))
        if data.get("version") != cls.version:
            raise ValueError(f"version must be {cls.version}, got {data.get('version')!r}")
        return cls.from_dict(data)


def plain(value: Any) -> Any:
    """Return a value as JSON can hold it: dataclasses as objects, and null for nan and infinity.

    >>> plain({"seconds": (0.5, math.nan)})
    {'seconds': [0.5, None]}
    """
    if is_dataclass(value):
        names = [*(field.name for field in fields(value)), *getattr(value, "derived", ())]
        return {name: plain(getattr(value, name)) for name in names}
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def read_row(row: type[Row], data: Mapping[str, Any]) -> Row:
    """Return a row of a JSON object, with nan for null."""
    return row(**{key: math.nan if value is None else value for key, value in data.items()})


def rows_with(rows: Iterable[Row], **wanted: str) -> list[Row]:
    """Return the rows in which one column, given by name, has a value.

    Raises
    ------
    ValueError
        There is none; the message names the values that there are.
    """
    ((column, value),) = wanted.items()
    by_value: dict[str, list[Row]] = {}
    for row in rows:
        by_value.setdefault(getattr(row, column), []).append(row)
    if value not in by_value:
        raise ValueError(f"{column} must be one of {', '.join(by_value)}, got {value!r}")
    return by_value[value]


def _lines(value: Any) -> str:
    """Return JSON, with a line for each object of a list."""
    if not (isinstance(value, list) and value and isinstance(value[0], dict)):
        return json.dumps(value)
    return "[\n" + ",\n".join(f"  {json.dumps(item)}" for item in value) + "\n ]"


# Targets


@dataclass(frozen=True)
class Limit:
    """A figure and its target.

    Attributes
    ----------
    what : str
        In words, with the unit.
    value : float
        What was measured.
    wanted : str
        In words; "" for nothing.
    reached : bool or None
        Whether it is; None if nothing is wanted.
    """

    what: str
    value: float
    wanted: str = ""
    reached: bool | None = None


def at_least(what: str, value: float, least: float) -> Limit:
    """Return a figure whose target is a lower limit.

    >>> at_least("times faster", 1.9, 2.0)
    Limit(what='times faster', value=1.9, wanted='at least 2', reached=False)
    """
    return Limit(what, value, f"at least {least:,g}", value >= least)


def at_most(what: str, value: float, most: float) -> Limit:
    """Return a figure whose target is an upper limit; nan never reaches it."""
    return Limit(what, value, f"at most {most:,g}", value <= most)


def limits_table(limits: Iterable[Limit]) -> Table:
    """Return the target and whether it is reached."""
    columns: dict[str, Callable[[Limit], str]] = {
        "what": lambda limit: limit.what,
        "measured": lambda limit: digits(limit.value),
        "wanted": lambda limit: limit.wanted,
        "reached": lambda limit: {True: "yes", False: "NO", None: ""}[limit.reached],
    }
    return table("What is wanted", columns, limits, wraps=True)


# Selection


def chosen(
    known: Iterable[str],
    only: Sequence[str],
    fits: Callable[[str, str], bool] = operator.eq,
) -> list[str]:
    """Return the known names that were requested; all if there was no request.

    Parameters
    ----------
    known : iterable of str
        What can be measured.
    only : sequence of str
        What is to be measured.
    fits : callable
        Takes a known name and a requested one; returns whether they match.

    Raises
    ------
    ValueError
        A name matches nothing.
    """
    names = list(known)
    for wanted in only:
        if not any(fits(name, wanted) for name in names):
            raise ValueError(f"only must name some of {', '.join(names)}, got {wanted!r}")
    return [name for name in names if not only or any(fits(name, wanted) for wanted in only)]


REPEATS, QUICK_REPEATS = 7, 3


def repeats_of(repeats: int | None, *, quick: bool) -> int:
    """Return how often to measure: by default 7 times, or 3 if quick.

    Raises
    ------
    ValueError
        It is not >= 1.
    """
    count = (QUICK_REPEATS if quick else REPEATS) if repeats is None else repeats
    if count < 1:
        raise ValueError(f"repeats must be >= 1, got {count}")
    return count


# The machine


def machine() -> dict[str, Any]:
    """Return what measured times depend on."""
    return {
        "python": platform.python_version(),
        "system": platform.platform(),
        "processor": platform.processor() or platform.machine(),
        "cores": usable_cores(),
        "packages": {name: _version(name) for name in PACKAGES},
    }


def machine_line() -> str:
    """Return the machine's description as one line."""
    facts = machine()
    packages = ", ".join(f"{name} {version}" for name, version in facts["packages"].items())
    return f"{facts['cores']} cores, Python {facts['python']}, {packages}, {facts['system']}"


def _version(name: str) -> str | None:
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return None


# Tables


def table(
    title: str,
    columns: Mapping[str, Callable[[Row], str]],
    rows: Iterable[Row],
    *,
    words: int = 1,
    wraps: bool = False,
    group: Callable[[Row], str] | None = None,
    caption: str = "",
    box: Box | None = SIMPLE_HEAD,
) -> Table:
    """Return rows as a table.

    Parameters
    ----------
    title, caption : str
        Above and below.
    columns : mapping of str to callable
        By heading, the text of a row's cell.
    rows : iterable
        The objects from which the columns take their text.
    words : int
        How many of the first columns hold words; the others hold figures, flush right.
    wraps : bool
        Whether the first column may take several lines.
    group : callable, optional
        The heading above a row and those that follow with the same one.
    box : Box, optional
        The lines; None for none.
    """
    made = Table(title=title, caption=caption or None, box=box, pad_edge=False)
    for n, heading in enumerate(columns):
        fits = n == 0 and not wraps
        made.add_column(
            heading, justify="left" if n < words else "right", no_wrap=fits or n >= words
        )
    last = None
    for row in rows:
        if group is not None and group(row) != last:
            last = group(row)
            made.add_section()
            made.add_row(f"[bold]{last}[/bold]")
        made.add_row(*(cell(row) for cell in columns.values()))
    return made


def digits(value: float) -> str:
    """Return a number with three digits; large ones with all before the point, "" for nan.

    >>> digits(0.01234), digits(0.5), digits(123456.7), digits(1.234e-7), digits(math.nan)
    ('0.0123', '0.5', '123,457', '1.2e-07', '')
    """
    if not math.isfinite(value):
        return "" if math.isnan(value) else str(value)
    if value != 0 and abs(value) < SMALLEST:
        return f"{value:.1e}"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


SMALLEST = 1e-3
"""A number below this is written with a power of ten."""


def micro(seconds: float) -> str:
    """Return a time in microseconds, with three digits.

    >>> micro(0.00123456), micro(1.5e-7)
    ('1,235', '0.15')
    """
    return digits(1e6 * seconds)


def four_digits(seconds: float) -> float:
    """Return a time with four digits: it has no more that could be measured again."""
    return float(f"{seconds:.4g}")
