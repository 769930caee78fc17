"""The table of impulses: it grows, and what somebody has seen of it stays as it was."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.engine.compiled import new_table
from lesson_code.engine.core.impulse_table import EVENT_NUMBERS, ImpulseTable
from lesson_code.engine.core.rows import ImpulseRow

WORDS = st.lists(
    st.tuples(st.sampled_from(["add rows", "add records", "see", "forget"]), st.integers(0, 40)),
    max_size=30,
)


@given(words=WORDS)
def test_table_holds_what_a_list_would(words: list[tuple[str, int]]) -> None:
    """However it is filled, seen and cut, and so do all arrays that were seen on the way."""
    table, times = ImpulseTable(), list[float]()
    seen: list[tuple[np.ndarray, list[float]]] = []
    clock = 0.0
    for word, count in words:
        new = [clock + i for i in range(count)]
        if word == "add rows":
            table.add([ImpulseRow(time=time) for time in new])
        elif word == "add records":
            table.add(new_table(ImpulseRow, count, time=new))
        elif word == "see":
            seen.append((table.rows(), times.copy()))
            continue
        else:
            new, times = [], times[:count]
            table.forget_from(len(times))
        times, clock = times + new, clock + count
    seen.append((table.rows(), times))
    assert len(table) == len(times)
    for rows, expected in seen:
        assert rows.shape == (len(expected), EVENT_NUMBERS)
        assert rows[:, 0].tolist() == expected
