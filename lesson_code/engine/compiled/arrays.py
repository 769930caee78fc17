"""Tables of rows as arrays of records, which Numba takes: the same fields by the same names."""

from __future__ import annotations

import dataclasses
import typing
from functools import cache
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Tables = TypeVar("Tables", bound=tuple[Any, ...])

KINDS = {float: np.float64, int: np.int32, bool: np.bool_}
"""What a field of a row becomes. 2,147,483,647 bodies are enough, and half the bytes are faster."""

LINE = 64
"""Bytes that a processor reads at once. Rows of more than half of that begin on such a border."""


def as_arrays(tables: Tables) -> Tables:
    """Return a named tuple of tables, each list of rows as an array and each row as a record.

    A table without rows has the kind of its rows from the annotation of its field.

    >>> from lesson_code import Combination, Scene
    >>> from lesson_code.engine.tables import world_of
    >>> world = world_of(Scene(), dt=0.1, iterations=1, combine=Combination())
    >>> as_arrays(world).pairs.dtype.names
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
