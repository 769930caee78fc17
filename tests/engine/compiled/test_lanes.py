"""A loop in lanes: four turns at once have the bits of one after the other."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code.engine.compiled.lanes import LANES, everywhere, in_lanes, where

CONTACT = np.dtype(
    [("a", np.int32), ("b", np.int32), ("mass", float), ("total", float), ("rest", float)]
)
BODY = np.dtype([("v", float), ("w", float), ("spare_1", float), ("spare_2", float)])
PAIRS = 4 * LANES


def visit(c, a, b):  # type: ignore[no-untyped-def]
    """Use the operations of lanes, and both ways out; the early one changes nothing."""
    missing = (b.v - a.v) * c.mass - 1
    is_done = (missing >= 0) & (c.total == 0)
    if everywhere(is_done):
        return
    total = min(max(-missing + c.total, 0.0), 0.7)
    total = where((total < 0.5) & (c.mass > 0.1) & (c.rest <= 0.9), 2 * total / b.w, total)
    more = total - c.total
    a.v -= more * 0.5
    b.v += more
    c.total = total


def sweep(visits, contacts, bodies, count):  # type: ignore[no-untyped-def]
    """Visit all pairs, each table row after next."""
    for n in in_lanes(0, count):
        c = contacts[visits[n].index + 1]
        visit(c, bodies[c.a], bodies[c.b])


def tables(seed: int) -> tuple[Any, Any, Any]:
    """Return visits in some order, contacts with bodies of their own, and bodies."""
    rng = np.random.default_rng(seed)
    visits = np.zeros(PAIRS, [("index", np.int32)]).view(np.recarray)
    visits["index"] = rng.permutation(PAIRS)
    contacts = np.zeros(PAIRS + 1, CONTACT).view(np.recarray)
    contacts["a"], contacts["b"] = rng.permutation(2 * (PAIRS + 1)).reshape(2, -1)
    for name in ("mass", "rest"):
        contacts[name] = rng.uniform(0, 1, PAIRS + 1)
    contacts["total"] = rng.choice([0.0, 0.3], PAIRS + 1)
    bodies = np.zeros(2 * (PAIRS + 1), BODY).view(np.recarray)
    bodies["v"], bodies["w"] = rng.normal(0, 3, len(bodies)), rng.uniform(1, 2, len(bodies))
    return visits, contacts, bodies


@pytest.fixture(scope="module")
def compiled_sweep() -> Any:
    """Return the sweep as machine code."""
    numba = pytest.importorskip("numba")
    import lesson_code.engine.compiled.lane_types

    assert lesson_code.engine.compiled.lane_types.LANES == LANES
    options: dict[str, Any] = {"error_model": "numpy", "_nrt": False}
    in_place = numba.njit(forceinline=True, **options)(visit)
    whole = {**globals(), "visit": in_place}
    turned = type(sweep)(sweep.__code__, whole)
    return numba.njit(**options)(turned)


@pytest.mark.parametrize("seed", range(20))
def test_lanes_have_the_bits_of_visits_one_by_one(compiled_sweep: Any, seed: int) -> None:
    """Whatever the numbers: each lane takes its own side of every choice."""
    expected = tables(seed)
    sweep(*expected, PAIRS)
    made = tables(seed)
    compiled_sweep(*[table.view(np.ndarray) for table in made], PAIRS)
    assert [table.tobytes() for table in made] == [table.tobytes() for table in expected]


def test_loop_without_turns_changes_nothing(compiled_sweep: Any) -> None:
    """Where a colour does not fill the lanes there is none."""
    made = tables(0)
    compiled_sweep(*[table.view(np.ndarray) for table in made], 0)
    assert [table.tobytes() for table in made] == [table.tobytes() for table in tables(0)]
