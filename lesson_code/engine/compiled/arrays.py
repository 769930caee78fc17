"""Tables of rows as arrays of records, which Numba takes: the same fields by the same names."""

from __future__ import annotations

import dataclasses
import typing
from functools import cache
from typing import Any, TypeVar

import numpy as np
from numpy.lib.recfunctions import structured_to_unstructured
from numpy.typing import NDArray

Tables = TypeVar("Tables", bound=tuple[Any, ...])

KINDS = {float: np.float64, int: np.int32, bool: np.bool_}
"""What a field of a row becomes. 2,147,483,647 bodies are enough, and half the bytes are faster."""

LINE = 64
"""Bytes that a processor reads at once. Rows of more than half of that begin on such a border."""


def as_arrays(tables: Tables) -> Tables:
    """Return a named tuple of tables, each list of rows as an array and each row as a record.

    A table without rows has the kind of its rows from the annotation of its field.

    >>> from typing import NamedTuple
    >>> from lesson_code.engine.rows import PairRow
    >>> class Two(NamedTuple):
    ...     one: PairRow
    ...     many: list[PairRow]
    >>> as_arrays(Two(PairRow(1, 2), [])).many.dtype.names
    ('a', 'b')
    """
    kinds = row_kinds(type(tables))
    parts = [
        _array(table, kinds[name]) if isinstance(table, list) else _record(table, kinds[name])
        for name, table in zip(kinds, tables, strict=True)
    ]
    return type(tables)(*parts)


def as_rows(tables: Tables) -> Tables:
    """Return the tables that :func:`as_arrays` was given, with what has been written since."""
    kinds = row_kinds(type(tables))
    parts = [
        [kinds[name](*values) for values in table.tolist()]
        if isinstance(table, np.ndarray)
        else kinds[name](*table.item())
        for name, table in zip(kinds, tables, strict=True)
    ]
    return type(tables)(*parts)


def as_numbers(table: Any) -> NDArray[np.float64]:
    """Return a table, a list of rows or an array of records, as numbers: a row's fields in a row.

    >>> from lesson_code.engine.rows import PairRow
    >>> as_numbers([PairRow(1, 2), PairRow(1, 3)]).tolist()
    [[1.0, 2.0], [1.0, 3.0]]
    """
    if isinstance(table, np.ndarray):
        return structured_to_unstructured(table, dtype=float)
    return np.array([dataclasses.astuple(row) for row in table], dtype=float)


def lengthened(table: NDArray[Any], rows: int) -> NDArray[Any]:
    """Return a table with at least so many rows, the first ones as they are."""
    if rows <= len(table):
        return table
    longer = _zeros(rows, table.dtype)
    longer[: len(table)] = table
    return longer


@cache
def row_kinds(tables: type) -> dict[str, Any]:
    """Return the kind of row in each table of a named tuple."""
    hints = typing.get_type_hints(tables)
    return {name: (typing.get_args(hint) or (hint,))[0] for name, hint in hints.items()}


@cache
def dtype_of(row: Any) -> np.dtype[Any]:
    """Return the kind of record for a kind of row."""
    hints = typing.get_type_hints(row)
    fields = [(field.name, KINDS[hints[field.name]]) for field in dataclasses.fields(row)]
    dtype = np.dtype(fields, align=True)
    if dtype.itemsize <= LINE // 2:
        return dtype
    size = -(-dtype.itemsize // LINE) * LINE
    offsets = [dtype.fields[name][1] for name, _ in fields]  # type: ignore[index]
    kinds = [kind for _, kind in fields]
    return np.dtype(
        {"names": list(dtype.names or ()), "formats": kinds, "offsets": offsets, "itemsize": size},
        align=True,
    )


def _array(rows: list[Any], kind: Any) -> NDArray[Any]:
    """Return a list of rows as an array of records."""
    array = _zeros(len(rows), dtype_of(kind))
    names = [field.name for field in dataclasses.fields(kind)]
    for name in names:
        array[name] = [getattr(row, name) for row in rows]
    return array


def _record(row: Any, kind: Any) -> Any:
    """Return one row as a record whose fields can be written by name."""
    return _array([row], kind).view(np.recarray)[0]


def _zeros(rows: int, dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return an empty table that begins on a border of what a processor reads at once."""
    room = np.zeros(rows * dtype.itemsize + LINE, np.uint8)
    start = -room.ctypes.data % LINE
    return room[start : start + rows * dtype.itemsize].view(dtype)
