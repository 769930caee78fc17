"""Colours and frames that all figures share."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from lesson_code.view.matplotlib import style

OKABE_AND_ITO = {
    "BLUE": (0, 114, 178),
    "ORANGE": (230, 159, 0),
    "GREEN": (0, 158, 115),
    "VERMILION": (213, 94, 0),
    "PURPLE": (204, 121, 167),
    "SKY": (86, 180, 233),
}
READABLE = 3.0
"""Contrast that WCAG 2 asks of lines and large text (1.4.11)."""


def luminance(color: str) -> float:
    """Return the relative luminance of a colour, as WCAG defines it."""
    parts = [c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in to_rgb(color)]
    return float(np.dot(parts, (0.2126, 0.7152, 0.0722)))


@pytest.mark.parametrize(("name", "expected"), OKABE_AND_ITO.items())
def test_colours_are_those_of_okabe_and_ito(name: str, expected: tuple[int, int, int]) -> None:
    """The palette is the published one, which the colour-blind can tell apart."""
    assert tuple(round(255 * part) for part in to_rgb(getattr(style, name))) == expected


@pytest.mark.parametrize("name", ["FIRST", "SECOND", "GREEN", "GREY", "INK"])
def test_lines_and_words_can_be_read_on_white(name: str) -> None:
    """Every colour that lines or words are drawn in stands out from the page."""
    assert 1.05 / (luminance(getattr(style, name)) + 0.05) >= READABLE


def test_roles_of_one_figure_have_different_colours() -> None:
    """Two bodies are never drawn alike."""
    assert style.FIRST != style.SECOND


def test_one_column_gives_axes_and_several_give_a_row() -> None:
    """A single Axes needs no index; several come as an array to unpack."""
    figure, ax = style.figure()
    assert isinstance(ax, Axes)
    assert figure.axes == [ax]
    figure, (left, right) = style.figure(2)
    assert figure.axes == [left, right]


def test_figure_has_the_size_asked_for() -> None:
    """Width and height are inches at 100 dots each."""
    figure, _ = style.figure(width=5, height=2.5)
    assert isinstance(figure, Figure)
    assert tuple(figure.get_size_inches()) == (5, 2.5)
    assert figure.dpi == 100


def test_plain_axes_keep_two_frame_lines_and_have_the_grid_behind() -> None:
    """Only the lines that carry a scale are left; data is drawn over the grid."""
    _, axes = style.figure(2)
    for ax in axes:
        assert [side for side, line in ax.spines.items() if line.get_visible()] == [
            "left",
            "bottom",
        ]
        assert ax.get_axisbelow() is True
        assert style.plain(ax) is ax


def test_figures_do_not_collect_in_pyplot() -> None:
    """A figure is freed when nobody holds it: pyplot, which keeps them all, is never loaded."""
    code = (
        "import sys; from lesson_code.view.browser import show; "
        "from lesson_code.view.matplotlib import diagrams, plots, style; "
        "style.figure(); print('matplotlib.pyplot' in sys.modules)"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "False\n"
