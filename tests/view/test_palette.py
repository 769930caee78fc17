"""The colours of figures: read on white and on the dark ground of a page."""

from __future__ import annotations

from dataclasses import asdict
from itertools import combinations

import pytest

from lesson_code.view.matplotlib import style
from lesson_code.view.palette import ON_WHITE, PUBLISHED, rgb

from .colours import CONES, LEAST_DIFFERENCE, contrast, difference

WORDS, LINES = 4.5, 3.0
"""Contrast that WCAG 2.2 asks of text, and of what is not text."""

WHITE, DARK = (255, 255, 255), (17, 17, 17)
"""The ground of a figure, and of a page or a notebook in a dark theme."""

DRAWN = {name: value for name, value in asdict(ON_WHITE).items() if name != "yellow"}


@pytest.mark.parametrize("name", ["blue", "green", "vermilion", "purple"])
def test_words_in_colour_can_be_read_on_white(name: str) -> None:
    """Names of bodies stand in their bodies' colour."""
    assert contrast(rgb(DRAWN[name]), WHITE) >= WORDS


@pytest.mark.parametrize("name", DRAWN)
@pytest.mark.parametrize("ground", [WHITE, DARK])
def test_lines_stand_out_from_any_ground(name: str, ground: tuple[int, int, int]) -> None:
    """Plots lie on white; what has no ground of its own lies on the page, which may be dark."""
    assert contrast(rgb(DRAWN[name]), ground) >= LINES


@pytest.mark.parametrize("cones", CONES)
def test_colours_on_white_are_told_apart_by_the_colour_blind(cones: str) -> None:
    """Any two; a label, a line style or a marker says the same once more."""
    for a, b in combinations(DRAWN.values(), 2):
        assert difference(rgb(a), rgb(b), cones) >= LEAST_DIFFERENCE, (a, b)


def test_published_colours_are_those_of_okabe_and_ito() -> None:
    """Programs draw in them on a dark ground."""
    assert [rgb(color) for color in asdict(PUBLISHED).values()] == [
        (0, 114, 178),
        (230, 159, 0),
        (0, 158, 115),
        (213, 94, 0),
        (204, 121, 167),
        (86, 180, 233),
        (240, 228, 66),
    ]


@pytest.mark.parametrize("name", ["FIRST", "SECOND", "GREY", "INK"])
def test_words_of_plots_can_be_read_on_white(name: str) -> None:
    """Axes, remarks and the names of the two bodies of a pair."""
    assert contrast(rgb(getattr(style, name)), WHITE) >= WORDS
