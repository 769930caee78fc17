"""Room in the tables: a step says what it wants, gets it, and goes on where it was."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule, Scene, Segment
from lesson_code.engine.compiled import as_arrays
from lesson_code.engine.core.capacity import (
    FEWEST_ROWS,
    SPARE,
    add_capacity,
    longer,
    refuse_heap,
    rows_for,
)
from lesson_code.engine.core.constants import PAIRS_ANYWAY, PAIRS_PER_BODY
from lesson_code.engine.core.rows import PairRow, World
from lesson_code.engine.core.tables import world_of
from lesson_code.engine.stepper import EngineStepper

WANTED = {
    "pairs_wanted": ("pairs", "sorted_pairs"),
    "contacts_wanted": ("contacts", "memory"),
    "impulses_wanted": ("impulses",),
}
"""What a stage asks for, and the tables that grow."""


EVERY_TABLE = "row.a row.b row.feature row.index row.body row.time"
"""Stands for a program that names some field of every table."""


def empty(kind: str = "rows") -> World:
    """Return the tables of one disc, none of which has room for a contact."""
    world = world_of(Scene([Body(Circle(1), mass=1)]), 0.01, 1, MixingRule())
    return as_arrays(world, EVERY_TABLE) if kind == "arrays" else world


@given(st.integers(1, 10**6))
def test_rows_for_what_is_wanted_are_enough_and_some_to_spare(wanted: int) -> None:
    """Half as many again, at least 16."""
    assert rows_for(wanted) >= max(wanted, FEWEST_ROWS)
    assert rows_for(wanted) <= max(SPARE * wanted, FEWEST_ROWS)


def test_rows_for_nothing_are_none() -> None:
    """A table that was large enough is not made longer."""
    assert rows_for(0) == 0


@pytest.mark.parametrize("kind", ["rows", "arrays"])
@pytest.mark.parametrize("wish", WANTED)
def test_room_is_made_in_the_tables_that_were_too_small(kind: str, wish: str) -> None:
    """In these and in no other; and the wish is fulfilled, once."""
    world = empty(kind)
    setattr(world.state, wish, 100)
    made = add_capacity(world)
    for name, table in made._asdict().items():
        if name in {name for names in WANTED.values() for name in names}:
            assert len(table) == (150 if name in WANTED[wish] else 0), name
    assert getattr(made.state, wish) == 0
    assert [len(table) for table in add_capacity(made)[1:-1]] == [len(t) for t in made[1:-1]]


def test_rows_that_there_are_stay_the_same_rows() -> None:
    """Room for fewer throws nothing away; room for more adds rows of their own."""
    table: list[PairRow] = longer([], 20, PairRow)
    before = [id(row) for row in table]
    assert [id(row) for row in longer(table, 5, PairRow)] == before
    more = longer(table, 21, PairRow)
    assert more is table
    assert [id(row) for row in more[:30]] == before
    assert len({id(row) for row in more}) == len(more) == 31


def test_records_that_there_are_are_copied_bit_for_bit() -> None:
    """An array cannot grow: the longer one begins with what the shorter one held."""
    table = as_arrays(world_of(Scene(), 0.01, 1, MixingRule()), EVERY_TABLE).pairs
    table = longer(table, 20, PairRow)
    table["a"], table["b"] = np.arange(30), np.arange(30) + 1
    more = longer(table, 40, PairRow)
    assert len(more) == 60
    assert more[:30].tobytes() == table.tobytes()
    assert not more["b"][30:].any()
    assert longer(table, 5, PairRow) is table


@pytest.mark.parametrize("bodies", [0, 2, 10_000])
def test_heap_is_refused_above_the_limit_and_not_at_it(bodies: int) -> None:
    """The error names how many bodies and how many pairs."""
    most = PAIRS_PER_BODY * bodies + PAIRS_ANYWAY
    refuse_heap(bodies, most)
    match = rf"not be heaped into one another: {bodies} of them overlap in {most + 1} pairs or more"
    with pytest.raises(ValueError, match=match):
        refuse_heap(bodies, most + 1)


def rain() -> Scene:
    """Return 12 discs that fall on a floor and onto one another."""
    floor = Body(Segment((-9, 0), (9, 0)), material=Material(0.3, 0.4))
    discs = [
        Body(Circle(0.4), mass=1, position=(0.1 * (k % 3), 1 + k), material=Material(0.3, 0.4))
        for k in range(12)
    ]
    return Scene([floor, *discs], gravity=(0, -10))


def engine(solver: str) -> EngineStepper:
    """Return a solver at work on the rain."""
    return EngineStepper(
        rain(), solver=solver, dt=1 / 60, iterations=4, substeps=2, combine=MixingRule()
    )


def roomy(solver: str, rows: int) -> EngineStepper:
    """Return the same with tables that are large enough from the start."""
    stepper = engine(solver)
    state: Any = stepper.world.state
    state.pairs_wanted = state.contacts_wanted = state.impulses_wanted = rows
    stepper.world = add_capacity(stepper.world)
    return stepper


@pytest.mark.parametrize("solver", ["sequential", "substep", "naive"])
def test_run_whose_tables_grow_has_the_same_bits(solver: str) -> None:
    """To stop for room and to go on is to have had it from the start."""
    growing, ready = engine(solver), roomy(solver, 5_000)
    growing.advance(90)
    ready.advance(90)
    assert growing.states().tobytes() == ready.states().tobytes()
    assert growing.events().tobytes() == ready.events().tobytes()
    assert len(growing.events()) > 50
    assert len(growing.world.contacts) < 100


@pytest.mark.parametrize("solver", ["sequential", "substep", "naive"])
def test_run_in_many_calls_has_the_bits_of_one_call(solver: str) -> None:
    """Ninety times one step, or ninety steps."""
    one_by_one, at_once = engine(solver), engine(solver)
    for _ in range(90):
        one_by_one.advance(1)
    at_once.advance(90)
    assert one_by_one.states().tobytes() == at_once.states().tobytes()
    assert one_by_one.events().tobytes() == at_once.events().tobytes()
