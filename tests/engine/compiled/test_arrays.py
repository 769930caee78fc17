"""Tables of rows as arrays of records: the same fields, the same values, and back again."""

from __future__ import annotations

import dataclasses
import typing
from typing import Any

import numpy as np
import pytest

from lesson_code import MixingRule, Scene
from lesson_code.engine.compiled.arrays import (
    KINDS,
    LINE,
    UNIT,
    as_arrays,
    dtype_of,
    full_rows,
    lengthened,
    new_table,
    row_kinds,
)
from lesson_code.engine.core import tables
from lesson_code.engine.core.rows import BodyRow, PairRow, World
from lesson_code.engine.core.tables import world_of
from lesson_code.evidence.scenes.speed import bin_of_shapes
from lesson_code.geometry.rows import Corner

ROWS = list(row_kinds(World).values())

EVERY_FIELD = " ".join(f"row.{field.name}" for row in ROWS for field in dataclasses.fields(row))
"""Stands for a program that names all fields."""


def arrays_of(world: World) -> Any:
    """Return tables with all fields as arrays."""
    return as_arrays(world, EVERY_FIELD)


def rows_of(tables: Any) -> Any:
    """Return arrays as rows again."""
    kinds = row_kinds(World)
    return World(
        *[
            [kinds[name](*values) for values in table.tolist()]
            if isinstance(table, np.ndarray)
            else kinds[name](*table.item())
            for name, table in zip(kinds, tables, strict=True)
        ]
    )


def stirred() -> World:
    """Return the tables of 20 shapes with another value in every field of every row."""
    world = world_of(bin_of_shapes(20).scene, 0.01, 3, MixingRule())
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
    back = rows_of(arrays_of(world))
    assert back == world
    body = back.bodies[0]
    assert [type(getattr(body, f.name)) for f in dataclasses.fields(body)] == [
        typing.get_type_hints(BodyRow)[f.name] for f in dataclasses.fields(body)
    ]


def test_values_that_are_no_numbers_come_back() -> None:
    """Infinity, nan and minus zero."""
    world = stirred()
    world.bodies[0].x, world.bodies[0].y, world.bodies[0].vx = np.inf, -0.0, np.nan
    row = rows_of(arrays_of(world)).bodies[0]
    assert (row.x, np.signbit(row.y), np.isnan(row.vx)) == (np.inf, True, True)


def test_number_that_no_field_can_hold_is_refused() -> None:
    """A whole number beyond 2**31 is an error, not another number."""
    world = stirred()
    world.pairs[0].a = 2**31
    with pytest.raises(OverflowError):
        arrays_of(world)


def test_tables_without_rows_have_their_kinds_of_rows() -> None:
    """An empty list knows nothing of its rows; the annotation does."""
    world = world_of(Scene(), 0.01, 1, MixingRule())
    arrays: Any = arrays_of(world)
    for name, kind in row_kinds(World).items():
        if isinstance(getattr(world, name), list):
            table = getattr(arrays, name)
            assert table.dtype.names == tuple(field.name for field in dataclasses.fields(kind))
    assert len(arrays.bodies) == 0
    assert rows_of(arrays) == world


def test_single_row_is_written_through() -> None:
    """A record that is handed on is the same record, and its fields are set by name."""
    arrays: Any = arrays_of(stirred())
    state = arrays.state
    state.dt, state.has_pairs, state.pair_count = 0.125, True, 7
    assert (arrays.state.dt, arrays.state.has_pairs, arrays.state.pair_count) == (0.125, True, 7)
    row = rows_of(arrays).state
    assert (row.dt, row.has_pairs, row.pair_count) == (0.125, True, 7)


def test_row_of_a_table_is_written_through() -> None:
    """By its place in the table, as in a list of rows."""
    arrays: Any = arrays_of(stirred())
    arrays.bodies[3]["vx"] = 4.5
    assert rows_of(arrays).bodies[3].vx == 4.5


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.__name__)
def test_fields_lie_where_a_processor_reads_them_at_once(row: Any) -> None:
    """Each number on a multiple of its size; larger rows are a multiple of half a line."""
    dtype = dtype_of(row)
    hints = typing.get_type_hints(row)
    ends = 0
    for name in dtype.names or ():
        kind, offset = (dtype.fields or {})[name][:2]
        assert kind == KINDS[hints[name].__name__]
        assert offset % kind.itemsize == 0
        assert offset >= ends  # in the order of the row, none over another
        ends = offset + kind.itemsize
    assert ends <= dtype.itemsize
    assert dtype.itemsize % UNIT == 0 or dtype.itemsize <= UNIT


def test_tables_begin_on_the_border_of_a_line() -> None:
    """Also when they have grown."""
    arrays: Any = arrays_of(stirred())
    for table in (arrays.bodies, arrays.corners, arrays.pairs, lengthened(arrays.pairs, 99)):
        assert table.ctypes.data % LINE == 0
        assert table.flags["C_CONTIGUOUS"]


def test_tables_made_as_arrays_are_those_made_as_rows() -> None:
    """Both ways lead to the same bits, with all fields or with those of a program."""
    scene = bin_of_shapes(20).scene
    rows = world_of(scene, 0.01, 3, MixingRule())
    arrays = tables.arrays_of(scene, 0.01, 3, MixingRule())
    for program in (EVERY_FIELD, "body.x += body.vx * dt"):
        for made, turned in zip(as_arrays(arrays, program), as_arrays(rows, program), strict=True):
            assert np.asarray(made).tobytes() == np.asarray(turned).tobytes()
    assert full_rows(arrays) == rows


def test_new_table_has_the_defaults_of_its_rows() -> None:
    """And what it is given instead, for all rows or for each."""
    table = new_table(BodyRow, 2, x=[3.0, 4.0], friction=0.5)
    assert [BodyRow(*values) for values in table.tolist()] == [
        BodyRow(x=3.0, friction=0.5),
        BodyRow(x=4.0, friction=0.5),
    ]


def test_fields_that_a_program_does_not_name_are_left_out() -> None:
    """It pays for no other; those that it names keep their values and their order."""
    world = stirred()
    bodies: Any = as_arrays(world, "body.x += body.vx * dt").bodies
    assert bodies.dtype.names == ("vx", "x")
    assert bodies["x"].tolist() == [body.x for body in world.bodies]


def test_tables_of_one_program_can_be_those_of_another() -> None:
    """What both name stays; what only the second names begins at 0."""
    world = stirred()
    second: Any = as_arrays(as_arrays(world, "body.x body.vx"), "body.x body.vy")
    assert second.bodies["x"].tolist() == [body.x for body in world.bodies]


def test_longer_table_begins_with_the_rows_of_the_shorter_one() -> None:
    """And goes on with rows of zeros; one that is long enough stays the same."""
    table: Any = arrays_of(stirred()).pairs
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
