"""A program that can be compiled: its source, its entry, and the tables that it works on."""

from __future__ import annotations

import re
import typing
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from lesson_code.engine.compiled.arrays import dtype_of, row_kinds


class Layout(NamedTuple):
    """How a table lies in memory."""

    name: str
    dtype: np.dtype[Any]  # of a record
    is_list: bool  # else it is a single record


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
    used = frozenset(re.findall(r"\.(\w+)", source))
    kinds = typing.get_type_hints(tables)
    return Program(
        source,
        entry,
        tuple(
            Layout(name, dtype_of(row, used if is_list else None), is_list)
            for name, row in row_kinds(tables).items()
            for is_list in [typing.get_origin(kinds[name]) is list]
        ),
    )
