"""A program that can be compiled: its source, its entry, and the tables that it works on."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from lesson_code.engine.compiled.arrays import dtype_of, fields_named, lists_in, row_kinds
from lesson_code.engine.compiled.linker import PROGRAMS_REMEMBERED


class Layout(NamedTuple):
    """How a table lies in memory."""

    name: str
    dtype: np.dtype[Any]  # of a record
    is_list: bool  # else it is a single record

    def in_words(self) -> str:
        """Return all that matters of it to a program."""
        fields = (self.dtype.fields or {}).items()
        places = [f"{name} {kind} {place}" for name, (kind, place, *_) in fields]
        return ", ".join([self.name, str(self.is_list), str(self.dtype.itemsize), *places])


@dataclass(frozen=True)
class Program:
    """A program, and all that its machine code depends on.

    Attributes
    ----------
    source : str
        A module, from :func:`lesson_code.engine.compiled.linker.link`.
    entry : str
        The function in it that is called, with the named tuple of all tables.
    layout : tuple of Layout
        Those tables.
    """

    source: str
    entry: str
    layout: tuple[Layout, ...]


@lru_cache(maxsize=PROGRAMS_REMEMBERED)
def program_of(source: str, entry: str, tables: type) -> Program:
    """Return the program that a source makes, for tables of a kind.

    Parameters
    ----------
    source, entry : str
        A module, and the function in it that is called.
    tables : type
        The kind of named tuple that the entry is called with.

    Examples
    --------
    >>> from lesson_code.engine.core.rows import World
    >>> program = program_of("pair.b += box.cell_x", "advance", World)
    >>> next(table.dtype.names for table in program.layout if table.name == "pairs")
    ('b',)
    """
    used = fields_named(source)
    lists = lists_in(tables)
    return Program(
        source,
        entry,
        tuple(
            Layout(name, dtype_of(row, used if name in lists else None), name in lists)
            for name, row in row_kinds(tables).items()
        ),
    )
