"""Tables of rows as arrays of records: the same fields, the same values, and back again."""

from __future__ import annotations

import dataclasses
import typing
from typing import Any

import numpy as np
import pytest

from lesson_code import Combination, Scene
from lesson_code.engine.compiled.arrays import (
    KINDS,
    LINE,
    as_arrays,
    as_rows,
    dtype_of,
    lengthened,
    row_kinds,
)
from lesson_code.engine.rows import BodyRow, PairRow, World
from lesson_code.engine.tables import world_of
from lesson_code.evidence.speed_scenes import bin_of_shapes
from lesson_code.geometry.rows import Corner

ROWS = list(row_kinds(World).values())


def stirred() -> World:
    """Return the tables of 20 shapes with another value in every field of every row."""
    world = world_of(bin_of_shapes(20).scene, 0.01, 3, Combination())
    world.pairs.extend(PairRow() for _ in range(5))
    rng = np.random.default_rng(5)
    for table in world:
        for row in table if isinstance(table, list) else [table]:
            for name, kind in typing.get_type_hints(type(row)).items():
                value = {
                    float: float(rng.normal()) * 10.0 ** int(rng.integers(-300, 300)),
                    int: int(rng.integers(-(2**31), 2**31)),
                    bool: bool(rng.integers(2)),
                }[kind]
                setattr(row, name, value)
    return world


def test_tables_come_back_as_they_were() -> None:
    """Every field of every row to the last bit, and of its own kind."""
    world = stirred()
    back = as_rows(as_arrays(world))
    assert back == world
    body = back.bodies[0]
    assert [type(getattr(body, f.name)) for f in dataclasses.fields(body)] == [
        typing.get_type_hints(BodyRow)[f.name] for f in dataclasses.fields(body)
    ]


def test_values_that_are_no_numbers_come_back() -> None:
    """Infinity, nan and minus zero."""
    world = stirred()
    world.bodies[0].x, world.bodies[0].y, world.bodies[0].vx = np.inf, -0.0, np.nan
    row = as_rows(as_arrays(world)).bodies[0]
    assert (row.x, np.signbit(row.y), np.isnan(row.vx)) == (np.inf, True, True)


def test_number_that_no_field_can_hold_is_refused() -> None:
    """A whole number beyond 2**31 is an error, not another number."""
    world = stirred()
    world.pairs[0].a = 2**31
    with pytest.raises(OverflowError):
        as_arrays(world)


def test_tables_without_rows_have_their_kinds_of_rows() -> None:
    """An empty list knows nothing of its rows; the annotation does."""
    world = world_of(Scene(), 0.01, 1, Combination())
    arrays: Any = as_arrays(world)
    for name, kind in row_kinds(World).items():
        if isinstance(getattr(world, name), list):
            table = getattr(arrays, name)
            assert table.dtype.names == tuple(field.name for field in dataclasses.fields(kind))
    assert len(arrays.bodies) == 0
    assert as_rows(arrays) == world


def test_single_row_is_written_through() -> None:
    """A record that is handed on is the same record, and its fields are set by name."""
    arrays: Any = as_arrays(stirred())
    state = arrays.state
    state.dt, state.has_pairs, state.pair_count = 0.125, True, 7
    assert (arrays.state.dt, arrays.state.has_pairs, arrays.state.pair_count) == (0.125, True, 7)
    row = as_rows(arrays).state
    assert (row.dt, row.has_pairs, row.pair_count) == (0.125, True, 7)


def test_row_of_a_table_is_written_through() -> None:
    """By its place in the table, as in a list of rows."""
    arrays: Any = as_arrays(stirred())
    arrays.bodies[3]["vx"] = 4.5
    assert as_rows(arrays).bodies[3].vx == 4.5


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.__name__)
def test_fields_lie_where_a_processor_reads_them_at_once(row: Any) -> None:
    """Each number on a multiple of its size; rows of more than half a line on borders of lines."""
    dtype = dtype_of(row)
    hints = typing.get_type_hints(row)
    ends = 0
    for name in dtype.names or ():
        kind, offset = (dtype.fields or {})[name][:2]
        assert kind == KINDS[hints[name]]
        assert offset % kind.itemsize == 0
        assert offset >= ends  # in the order of the row, none over another
        ends = offset + kind.itemsize
    assert ends <= dtype.itemsize
    assert dtype.itemsize % LINE == 0 or dtype.itemsize <= LINE // 2


def test_tables_begin_on_the_border_of_a_line() -> None:
    """Also when they have grown."""
    arrays: Any = as_arrays(stirred())
    for table in (arrays.bodies, arrays.corners, arrays.pairs, lengthened(arrays.pairs, 99)):
        assert table.ctypes.data % LINE == 0
        assert table.flags["C_CONTIGUOUS"]


def test_longer_table_begins_with_the_rows_of_the_shorter_one() -> None:
    """And goes on with rows of zeros; one that is long enough stays the same."""
    table: Any = as_arrays(stirred()).pairs
    longer = lengthened(table, 9)
    assert (len(longer), longer.dtype) == (9, table.dtype)
    assert longer[:5].tobytes() == table.tobytes()
    assert not np.any(longer["a"][5:])
    assert lengthened(table, 5) is table


def test_row_kinds_are_those_of_the_annotations() -> None:
    """Of a list its element, of a single row the row itself."""
    kinds = row_kinds(World)
    assert (kinds["bodies"], kinds["corners"], kinds["state"].__name__) == (
        BodyRow,
        Corner,
        "State",
    )
