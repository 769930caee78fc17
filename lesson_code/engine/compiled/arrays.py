"""Tables of rows as arrays of records, which Numba can compile for: fields keep their names."""

from __future__ import annotations

import copy
import dataclasses
import re
import typing
from collections.abc import Callable
from functools import cache, lru_cache
from operator import attrgetter
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled.linker import PROGRAMS_REMEMBERED

Tables = TypeVar("Tables", bound=tuple[Any, ...])

KINDS = {"float": np.float64, "int": np.int32, "bool": np.bool_}
"""What a field of a row becomes, by its annotation. Numbers of 32 bits count 2,147,483,647 bodies,
and are faster."""

LINE = 64
"""Bytes that a processor reads at once. A table begins at a multiple of this."""

UNIT = 32
"""Bytes: longer rows are padded to a multiple of this, so that few of them cross a boundary."""


def as_arrays(tables: Tables, source: str, rows: Tables | None = None) -> Tables:
    """Return a named tuple of tables, each list of rows as an array and each row as a record.

    Rows keep only the fields that a program names, so that it pays for no others. The annotation
    of a table's field says which kind of rows it holds, even while it is empty.

    Parameters
    ----------
    tables : named tuple
        Lists of rows and single rows; or what this function has returned for another program.
    source : str
        The program.
    rows : named tuple, optional
        The tables with all fields, where `tables` are arrays for an earlier program: that program
        has not changed the fields that it did not name, and they are taken from here.

    Examples
    --------
    >>> from lesson_code import MixingRule, Scene
    >>> from lesson_code.engine.core.tables import world_of
    >>> world = world_of(Scene(), dt=0.1, iterations=1, combine=MixingRule())
    >>> as_arrays(world, "pair.b += box.cell_x").pairs.dtype.names
    ('b',)
    """
    used = fields_named(source)
    return type(tables)(
        *[
            _array(table, kind, used, first)
            if isinstance(table, (list, np.ndarray))
            else _record(table, kind)
            for table, first, kind in zip(
                tables, rows or tables, row_kinds(type(tables)).values(), strict=True
            )
        ]
    )


@lru_cache(maxsize=PROGRAMS_REMEMBERED)
def fields_named(source: str) -> frozenset[str]:
    """Return the names of all fields that a program reads or writes."""
    return frozenset(re.findall(r"\.(\w+)", source))


def new_table(kind: type, rows: int, **columns: Any) -> Any:
    """Return a table of a kind of row as an array with all fields, some of them given.

    It stands for a list of such rows, and is typed as little as the arrays of :func:`as_arrays`.

    >>> from lesson_code.engine.core.rows import VectorRow
    >>> new_table(VectorRow, 2, y=[3, 4]).tolist()
    [(0.0, 3.0), (0.0, 4.0)]
    """
    array = _zeros(rows, dtype_of(kind))
    if rows > 0:
        for name, values in (_defaults(kind) | columns).items():
            array[name] = values
    return array


@cache
def _defaults(kind: type) -> dict[str, Any]:
    """Return what a field of a new row holds, where that is not 0."""
    return {field.name: field.default for field in dataclasses.fields(kind) if field.default}


def full_rows(tables: Tables) -> Tables:
    """Return a named tuple of tables, each array with all fields as a list of rows.

    What is a list or a row already stays as it is.
    """
    kinds = row_kinds(type(tables)).values()
    return type(tables)(
        *[
            [kind(*values) for values in table.tolist()] if isinstance(table, np.ndarray) else table
            for table, kind in zip(tables, kinds, strict=True)
        ]
    )


def as_rows(tables: Tables, rows: Tables) -> Tables:
    """Return a named tuple of arrays and records as lists of rows and rows again.

    Parameters
    ----------
    tables : named tuple
        What :func:`as_arrays` has returned.
    rows : named tuple
        The lists of rows that it was given: fields that the program did not name are taken from
        here, unless the table has grown since.
    """
    return type(tables)(
        *[
            _rows(table, kind, first)
            if isinstance(table, np.ndarray)
            else _rows(np.array([table]), kind, [first])[0]
            for table, kind, first in zip(
                tables, row_kinds(type(tables)).values(), rows, strict=True
            )
        ]
    )


def column(table: Any, name: str) -> Any:
    """Return a field of all rows of a table, which is a list or an array."""
    return table[name] if isinstance(table, np.ndarray) else [getattr(row, name) for row in table]


def write_numbers(table: Any, numbers: NDArray[np.float64]) -> None:
    """Write a list of rows or an array of records into an array, one row of it for each row.

    >>> from lesson_code.engine.core.rows import VectorRow
    >>> numbers = np.empty((2, 2))
    >>> write_numbers([VectorRow(1, 2), VectorRow(1, 3)], numbers)
    >>> numbers.tolist()
    [[1.0, 2.0], [1.0, 3.0]]
    """
    if isinstance(table, np.ndarray):
        names, size = table.dtype.names or (), numbers.dtype.itemsize
        is_packed = table.flags.c_contiguous and table.dtype.itemsize == len(names) * size
        if is_packed:  # all at once, and then only what are whole numbers
            numbers[:] = table.view(numbers.dtype).reshape(numbers.shape)
        for place, name in enumerate(names):
            if not is_packed or table.dtype[name] != numbers.dtype:
                numbers[:, place] = table[name]
    elif table:
        kind: Any = type(table[0])
        numbers[:] = list(map(_values_of(kind), table))


def lengthened(table: NDArray[Any], rows: int) -> NDArray[Any]:
    """Return a table made longer by empty rows; one that is long enough is returned as it is."""
    if rows <= len(table):
        return table
    longer = _zeros(rows, table.dtype)
    longer[: len(table)] = table
    return longer


def another(table: Any) -> Any:
    """Return a table as long as one that somebody else keeps, its rows not yet written.

    A list is read before its rows are written again, and stays.
    """
    return lengthened(table[:0], len(table)) if isinstance(table, np.ndarray) else table


def copy_of(tables: Tables) -> Tables:
    """Return a named tuple of tables, lists of rows or arrays, with rows of its own."""
    return type(tables)(*map(_copy, tables))


def _copy(table: Any) -> Any:
    """Return a copy of a table, or of a single row."""
    if isinstance(table, list):
        return [_row_like(row) for row in table]
    if isinstance(table, np.ndarray):
        same = _zeros(len(table), table.dtype)
        same[:] = table
        return same
    return _row_like(table)


def _row_like(row: Any) -> Any:
    """Return a copy of a row or of a record."""
    kind: Any = type(row)
    return copy.copy(row) if kind is np.record else kind(*_values_of(kind)(row))


@cache
def _values_of(kind: type) -> Callable[[Any], Any]:
    """Return what reads all fields of a row at once: ``copy.copy`` takes five times as long."""
    names = [field.name for field in dataclasses.fields(kind)]
    read = attrgetter(*names)
    return read if len(names) > 1 else lambda row: (read(row),)


@cache
def row_kinds(tables: type) -> dict[str, Any]:
    """Return the kind of row in each table of a named tuple."""
    return {name: (typing.get_args(hint) or (hint,))[0] for name, hint in _hints(tables).items()}


@cache
def lists_in(tables: type) -> frozenset[str]:
    """Return which tables of a named tuple are lists of rows; the others are single rows."""
    return frozenset(name for name, hint in _hints(tables).items() if typing.get_args(hint))


@cache
def _hints(tables: type) -> dict[str, Any]:
    """Return the annotations of a named tuple of tables."""
    return typing.get_type_hints(tables)


@cache
def dtype_of(row: Any, used: frozenset[str] | None = None) -> np.dtype[Any]:
    """Return the kind of record for a kind of row, with the fields that are used."""
    every = [(field.name, KINDS[str(field.type)]) for field in dataclasses.fields(row)]
    fields = [(name, kind) for name, kind in every if used is None or name in used] or every[:1]
    dtype = np.dtype(fields, align=True)
    if dtype.itemsize <= UNIT:
        return dtype
    columns: dict[str, Any] = dict(dtype.fields or {})
    return np.dtype(
        {
            "names": list(columns),
            "formats": [kind for _, kind in fields],
            "offsets": [columns[name][1] for name in columns],
            "itemsize": -(-dtype.itemsize // UNIT) * UNIT,
        },
        align=True,
    )


def _array(rows: Any, kind: Any, used: frozenset[str] | None, first: Any = ()) -> NDArray[Any]:
    """Return rows, or the rows of an array, as an array of records.

    Fields that an array does not have are taken from the rows of `first`, unless the table has
    grown since: such a table holds nothing but what each step writes anew.
    """
    array = _zeros(len(rows), dtype_of(kind, used))
    for name in array.dtype.names or ():
        if _has_field(rows, name):
            array[name] = column(rows, name)
        elif len(first) == len(rows) and _has_field(first, name):
            array[name] = column(first, name)
    return array


def _has_field(table: Any, name: str) -> bool:
    """Return whether the rows of a table, a list or an array, have a field."""
    return not isinstance(table, np.ndarray) or name in (table.dtype.names or ())


def _rows(array: NDArray[Any], kind: Any, first: Any) -> list[Any]:
    """Return the records of an array as rows."""
    is_same = len(first) == len(array)
    rows = [copy.copy(row) for row in first] if is_same else [kind() for _ in array]
    for name in array.dtype.names or ():
        for row, value in zip(rows, array[name].tolist(), strict=True):
            setattr(row, name, value)
    return rows


def _record(row: Any, kind: Any) -> Any:
    """Return one row as a record whose fields can be written by name."""
    return row if isinstance(row, np.record) else _array([row], kind, None).view(np.recarray)[0]


def _zeros(rows: int, dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return a table of zeros that begins at a multiple of LINE bytes."""
    if rows == 0:
        return np.zeros(0, dtype)
    room = np.zeros(rows * dtype.itemsize + LINE, np.uint8)
    start = -room.ctypes.data % LINE
    return room[start : start + rows * dtype.itemsize].view(dtype)
