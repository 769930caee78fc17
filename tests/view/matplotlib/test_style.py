"""Colours and frames that all figures share."""

from __future__ import annotations

import subprocess
import sys

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lesson_code.view.matplotlib import style


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
