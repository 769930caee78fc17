"""Figures with sliders, and the same figure standing still for those who only read."""

from __future__ import annotations

import base64
import html
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

import ipywidgets
from IPython.display import display
from matplotlib.figure import Figure

from lesson_code.view.browser.show import png_of, svg_of


@dataclass(frozen=True)
class Slider:
    """A quantity the reader can change: its label with the unit, its range and where it starts."""

    label: str
    low: float
    high: float
    start: float
    step: float = 0.01

    def __post_init__(self) -> None:
        if not self.low <= self.start <= self.high:
            raise ValueError(f"start must lie between {self.low} and {self.high}, got {self.start}")
        if not self.step > 0:
            raise ValueError(f"step must be > 0, got {self.step}")


@dataclass(frozen=True)
class Explorable:
    """A figure with sliders, for tools that draw its pictures in advance.

    Attributes
    ----------
    alt : str
        What can be seen at the start, and what the sliders change.
    sliders : mapping of str to Slider
        The quantities to change, by name.
    svg : callable
        Takes the sliders' values by name and returns the picture as the text of an SVG.
    words : callable, optional
        Takes the same and says what the picture shows.
    """

    alt: str
    sliders: Mapping[str, Slider]
    svg: Callable[..., str]
    words: Callable[..., str] | None = None


_collected: ContextVar[list[Explorable] | None] = ContextVar("_collected", default=None)


@contextmanager
def collected() -> Iterator[list[Explorable]]:
    """Collect the figures with sliders that are made inside, and display none of them."""
    figures: list[Explorable] = []
    token = _collected.set(figures)
    try:
        yield figures
    finally:
        _collected.reset(token)


def collects(explorable: Explorable) -> bool:
    """Pass a figure to the active collector; return whether there is one."""
    figures = _collected.get()
    if figures is None:
        return False
    figures.append(explorable)
    return True


def explore(draw: Callable[..., Figure], alt: str, **sliders: Slider) -> None:
    """Display a figure that is drawn anew whenever a slider moves.

    A reader without a kernel sees the figure as it starts.

    Parameters
    ----------
    draw : callable
        Takes the sliders' values by name and returns a figure.
    alt : str
        What can be seen in the figure at the start, and what the sliders change.
    **sliders : Slider
        The quantities to change, by the names of `draw`'s arguments.

    Raises
    ------
    ValueError
        There is no slider, or `alt` is empty.
    """
    if not sliders:
        raise ValueError("explore needs at least one slider, got none")
    if collects(Explorable(alt, sliders, lambda **values: svg_of(draw(**values)))):
        return
    start = png_of(draw(**{name: slider.start for name, slider in sliders.items()}))
    show_panel(_panel(draw, alt, sliders, start), start, alt, "Run the cell to move the sliders.")


def show_panel(panel: Any, start: bytes, alt: str, invitation: str) -> None:
    """Display a widget, and a still picture for a reader without a kernel.

    Parameters
    ----------
    panel : ipywidgets.Widget
        What is shown where a kernel runs.
    start : bytes
        A PNG of how it looks at the start.
    alt : str
        What can be seen in it.
    invitation : str
        A sentence for the reader of the text: how it comes to life.

    Raises
    ------
    ValueError
        `alt` is empty.
    """
    if not alt.strip():
        raise ValueError("alt must say what the figure shows, got nothing")
    display(  # type: ignore[no-untyped-call]
        {
            **panel._repr_mimebundle_(),
            "image/png": start,
            "text/plain": f"Figure: {alt} ({invitation})",
        },
        metadata={"image/png": {"alt": alt}},
        raw=True,
    )


def _panel(draw: Callable[..., Figure], alt: str, sliders: dict[str, Slider], start: bytes) -> Any:
    """Return the sliders with the picture below them."""
    picture = ipywidgets.HTML(_image(start, alt))
    controls = {name: float_slider(slider) for name, slider in sliders.items()}

    def redraw(_: Any) -> None:
        values = {name: control.value for name, control in controls.items()}
        picture.value = _image(png_of(draw(**values)), alt)

    for control in controls.values():
        control.observe(redraw, names="value")
    return ipywidgets.VBox([*controls.values(), picture])


def float_slider(slider: Slider) -> Any:
    """Return the widget of a slider: reachable by keyboard, its label never cut."""
    return ipywidgets.FloatSlider(
        value=slider.start,
        min=slider.low,
        max=slider.high,
        step=slider.step,
        description=slider.label,
        continuous_update=False,
        style={"description_width": "14em"},
        layout={"width": "38em", "max_width": "100%"},
    )


def _image(png: bytes, alt: str) -> str:
    """Return a picture as HTML that needs no file."""
    data = base64.b64encode(png).decode()
    text = html.escape(alt, quote=True)
    return f'<img alt="{text}" style="max-width: 100%" src="data:image/png;base64,{data}">'
