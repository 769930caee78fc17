"""Figures with sliders, drawn ahead: which values they keep, and which picture stands where."""

from __future__ import annotations

import base64
import gzip
import json
import math
from itertools import pairwise, product
from pathlib import Path
from typing import Any

import nbformat
import pytest
from hypothesis import given
from hypothesis import strategies as st
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from lesson_code.course.site.moving import MovingFigure, drawn_ahead, figures_of, short, values_of
from lesson_code.view.browser.interactive import Explorable, Slider

ROUNDING = 1e-8
"""Of a value: a stride's multiple is rounded to nine decimals."""

X = Slider("x, m", 0, 1, 0.5, step=0.5)
Y = Slider("y, m", -1, 1, 0, step=1)


def figure(words: bool = False) -> Explorable:
    """Return a figure that is two lines of text: one that stays, and the values."""
    return Explorable(
        "Two numbers.",
        {"x": X, "y": Y},
        svg=lambda x, y: f"<svg>\n{x:g} {y:g}</svg>",
        words=(lambda **at: f"x is {at['x']:g}") if words else None,
    )


def unpacked(packed: str) -> Any:
    """Return what the page's script finds in the packed pictures."""
    return json.loads(gzip.decompress(base64.b64decode(packed)))


@st.composite
def sliders(draw: st.DrawFn) -> Slider:
    """Draw a slider whose start lies on its steps, and its high end perhaps not."""
    step = draw(st.sampled_from([0.01, 0.05, 0.25, 1.0, 5.0]))
    low = draw(st.integers(-50, 50)) * step
    steps = draw(st.integers(1, 400))
    start = low + draw(st.integers(0, steps)) * step
    return Slider(
        "quantity", low, low + (steps + draw(st.sampled_from([0, 0.5]))) * step, start, step
    )


@given(st.lists(sliders(), min_size=1, max_size=3), st.integers(30, 500))
def test_kept_values_hold_start_and_ends_and_are_not_too_many(
    found: list[Slider], most: int
) -> None:
    """However a slider is made, its start and both ends are kept, in order, within the limit."""
    named = {str(n): slider for n, slider in enumerate(found)}
    kept = values_of(named, most)
    assert math.prod(len(values) for values in kept.values()) <= most
    for name, slider in named.items():
        values = kept[name]
        assert (values[0], values[-1]) == pytest.approx((slider.low, slider.high), abs=ROUNDING)
        assert min(abs(value - slider.start) for value in values) <= ROUNDING
        assert all(a < b for a, b in pairwise(values))


def test_kept_values_are_all_steps_where_there_is_room() -> None:
    """Nothing is left out of a slider with few steps."""
    assert values_of({"y": Y}, most=3) == {"y": (-1.0, 0.0, 1.0)}


def test_kept_values_are_round_numbers_from_the_start() -> None:
    """A stride is 1, 2 or 5 times a power of ten steps, counted from the start."""
    kept = values_of({"a": Slider("angle, degrees", -180, 180, 20, step=1)}, most=20)
    assert kept["a"] == tuple(range(-180, 181, 20))


def test_kept_values_are_floats_and_none_is_minus_zero() -> None:
    """They are what the notebook's sliders give, and nobody reads "-0" beside one."""
    kept = values_of({"x": Slider("x, m", -0.3, 0.3, -0.3, step=0.1)}, most=7)["x"]
    assert [repr(value) for value in kept] == ["-0.3", "-0.2", "-0.1", "0.0", "0.1", "0.2", "0.3"]


def test_pictures_stand_in_the_order_of_the_sliders() -> None:
    """The last slider changes fastest, as the page counts."""
    drawn = drawn_ahead(figure())
    values = product((0.0, 0.5, 1.0), (-1.0, 0.0, 1.0))
    assert drawn.pictures == tuple(f"<svg>\n{x:g} {y:g}</svg>" for x, y in values)
    assert drawn.pictures[drawn.start] == "<svg>\n0.5 0</svg>"
    assert [control.label for control in drawn.controls] == ["x, m", "y, m"]
    assert drawn.words == ()


def test_words_stand_beside_their_pictures() -> None:
    """A figure that says what it shows says it for every picture."""
    drawn = drawn_ahead(figure(words=True))
    assert drawn.words == tuple(f"x is {x:g}" for x in (0, 0.5, 1) for _ in range(3))


def test_packed_pictures_come_out_as_they_went_in() -> None:
    """Lines that stand in several pictures are stored once, and none is lost."""
    drawn = drawn_ahead(figure(words=True))
    parts = unpacked(drawn.packed())
    rebuilt = ["\n".join(parts["lines"][line] for line in lines) for lines in parts["pictures"]]
    assert tuple(rebuilt) == drawn.pictures
    assert tuple(parts["words"]) == drawn.words
    assert len(parts["lines"]) == len(set(parts["lines"]))


def test_packed_pictures_are_the_same_each_time() -> None:
    """No clock is packed with them: two builds give the same file."""
    assert drawn_ahead(figure()).packed() == drawn_ahead(figure()).packed()


@pytest.mark.parametrize(
    ("long", "expected"),
    [
        ("L 12.345678 7.5", "L 12.35 7.5"),
        ("L 0.015625 -3.14159", "L 0.015625 -3.14"),
        ("#a1.23456 x10.10000", "#a1.23456 x10.10000"),
        ("1.99999e-05 2.000000", "1.99999e-05 2"),
    ],
)
def test_short_rounds_coordinates_and_nothing_else(long: str, expected: str) -> None:
    """Small factors, names and powers of ten stay as they are."""
    assert short(long) == expected


@pytest.fixture
def notebook(tmp_path: Path) -> Path:
    """Return a notebook with a figure that uses what an earlier cell has set."""
    cells = [
        new_code_cell("limit = 1\nprint('heard by nobody')"),
        new_markdown_cell("explore(1 / 0)"),
        new_code_cell(
            "from lesson_code.view.matplotlib import style\n"
            "from lesson_code.view.browser.interactive import Slider, explore\n"
            "explore(lambda e: style.figure(width=2, height=1)[0], 'Axes.', "
            "e=Slider('e', 0, limit, 1, step=1))"
        ),
    ]
    path = tmp_path / "00_tiny.ipynb"
    nbformat.write(new_notebook(cells=cells), path)
    return path


def test_figures_of_a_notebook_are_drawn_from_its_own_cells(
    notebook: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Cells run in order and share their names; nothing is displayed or printed."""
    [found] = figures_of(notebook)
    assert isinstance(found, MovingFigure)
    assert found.controls[0].values == (0.0, 1.0)
    assert all("<svg" in picture for picture in found.pictures)
    assert capsys.readouterr().out == ""


def test_cell_that_fails_is_named(tmp_path: Path) -> None:
    """A notebook that does not run is an error with its name and the reason."""
    path = tmp_path / "00_tiny.ipynb"
    cells = [new_code_cell("1 / 0")]
    nbformat.write(new_notebook(cells=cells), path)
    with pytest.raises(RuntimeError, match="notebook 00_tiny: a cell failed: ZeroDivisionError"):
        figures_of(path)
