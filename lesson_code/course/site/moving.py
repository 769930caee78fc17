"""Figures with sliders, drawn ahead: a page without Python shows the picture nearest by.

Each slider keeps some of its values, evenly spaced and with its start and both ends among them.
A figure is drawn for every combination. The pictures of one figure are almost alike, so
together they take little more room than a few of them.
"""

from __future__ import annotations

import base64
import gzip
import itertools
import json
import math
import re
from collections.abc import Iterator, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Any

from lesson_code.view.browser.interactive import Explorable, Slider, collected

MOST_STATES = 150
"""Pictures of one figure, at most. Matplotlib needs 0.05 to 0.4 s for each."""

MOST_QUICK_STATES = 6000
"""The same for a figure that is written as text, and so comes with words: 1 ms for each."""

FEWEST = 3
"""Values that a slider keeps in any case: its start and both ends."""

NICE = (1, 2, 5)
"""A stride is one of these times a power of ten, in steps of the slider."""

DECIMALS = 9
"""Of a slider's value: what lies beyond is the rounding of its steps."""

SAME_VALUE = 1e-9
"""Of a stride: a value so near to an end is the end."""

LONG_NUMBER = re.compile(r"(?<![\w.])[1-9]\d{0,3}\.\d{3,}(?![\de])")
"""A coordinate with more than two decimals."""


@dataclass(frozen=True)
class Control:
    """A slider as it stands in the page: its label, the values it can take, and its start."""

    label: str
    values: tuple[float, ...]
    start: int


@dataclass(frozen=True)
class MovingFigure:
    """A figure with sliders, drawn for all combinations of their values.

    Attributes
    ----------
    alt : str
        What can be seen at the start, and what the sliders change.
    controls : tuple of Control
        The sliders.
    pictures : tuple of str
        An SVG for each combination; the last slider changes fastest.
    words : tuple of str
        What each picture shows, or nothing at all.
    """

    alt: str
    controls: tuple[Control, ...]
    pictures: tuple[str, ...]
    words: tuple[str, ...]

    @property
    def start(self) -> int:
        """Which picture is shown first."""
        place = 0
        for control in self.controls:
            place = place * len(control.values) + control.start
        return place

    def packed(self) -> str:
        """Return pictures and words for the page: JSON, compressed, in letters.

        A picture is a list of lines, each line by its number: most stand in all pictures.
        """
        lines: dict[str, int] = {}
        pictures = [
            [lines.setdefault(line, len(lines)) for line in picture.split("\n")]
            for picture in self.pictures
        ]
        parts = {"lines": [*lines], "pictures": pictures, "words": self.words}
        text = json.dumps(parts, ensure_ascii=False, separators=(",", ":"))
        return base64.b64encode(gzip.compress(text.encode(), mtime=0)).decode()


def drawn_ahead(figure: Explorable) -> MovingFigure:
    """Return a figure with all the pictures it has in the page."""
    grid = values_of(figure.sliders, MOST_QUICK_STATES if figure.words else MOST_STATES)
    pictures, words = [], []
    for state in _combinations(grid):
        pictures.append(short(figure.svg(**state)))
        words += [figure.words(**state)] if figure.words else []
    controls = [
        Control(slider.label, grid[name], grid[name].index(round(slider.start, DECIMALS)))
        for name, slider in figure.sliders.items()
    ]
    return MovingFigure(figure.alt, tuple(controls), tuple(pictures), tuple(words))


def values_of(sliders: Mapping[str, Slider], most: int) -> dict[str, tuple[float, ...]]:
    """Return the values that each slider keeps, so that there are not too many combinations.

    Parameters
    ----------
    sliders : mapping of str to Slider
        The sliders by name.
    most : int
        How many combinations there may be.

    Examples
    --------
    >>> values_of({"e": Slider("restitution e", 0, 1, 0.5, step=0.05)}, most=11)
    {'e': (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)}
    """
    strides = dict.fromkeys(sliders, 0)
    kept = {name: _every(slider, 0) for name, slider in sliders.items()}
    while math.prod(len(values) for values in kept.values()) > most:
        finest = max(kept, key=lambda name: len(kept[name]))
        if len(kept[finest]) <= FEWEST:
            break
        strides[finest] += 1
        kept[finest] = _every(sliders[finest], strides[finest])
    return kept


def short(svg: str) -> str:
    """Return an SVG with coordinates to a hundredth of a point.

    >>> short('<path d="M 12.345678 0.015625 L 7.5 1.999999"/>')
    '<path d="M 12.35 0.015625 L 7.5 2"/>'
    """
    return LONG_NUMBER.sub(lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), svg)


def figures_of(notebook: Path) -> list[MovingFigure]:
    """Return the figures with sliders that a notebook makes, in order.

    The cells are run in this process, top to bottom, and what they print is dropped.

    Parameters
    ----------
    notebook : Path
        A notebook whose cells pass.

    Raises
    ------
    RuntimeError
        A cell failed.
    """
    import nbformat

    names: dict[str, Any] = {"__name__": notebook.stem}
    cells = nbformat.read(notebook, as_version=4).cells  # type: ignore[no-untyped-call]
    codes = [cell.source for cell in cells if cell.cell_type == "code"]
    return [drawn_ahead(figure) for code in codes for figure in _run(code, names)]


def _run(code: str, names: dict[str, Any]) -> list[Explorable]:
    """Run a cell and return the figures with sliders that it makes."""
    notebook = names["__name__"]
    with collected() as figures, redirect_stdout(StringIO()):
        try:
            exec(compile(code, notebook, "exec"), names)  # noqa: S102 - the workbook's own notebook
        except Exception as error:
            raise RuntimeError(f"notebook {notebook}: a cell failed: {error!r}") from error
    return figures


def _every(slider: Slider, number: int) -> tuple[float, ...]:
    """Return a slider's values at its stride of that number: 1, 2, 5, 10, 20 ... steps."""
    power, place = divmod(number, len(NICE))
    stride = slider.step * NICE[place] * 10**power
    below = math.floor((slider.start - slider.low) / stride + SAME_VALUE)
    above = math.floor((slider.high - slider.start) / stride + SAME_VALUE)
    between = [slider.start + k * stride for k in range(-below, above + 1)]
    rounded = {round(float(value), DECIMALS) + 0.0 for value in (slider.low, *between, slider.high)}
    return tuple(sorted(rounded))  # + 0.0 makes 0 of -0


def _combinations(grid: Mapping[str, tuple[float, ...]]) -> Iterator[dict[str, float]]:
    """Yield all combinations of the sliders' values; the last slider changes fastest."""
    for values in itertools.product(*grid.values()):
        yield dict(zip(grid, values, strict=True))
