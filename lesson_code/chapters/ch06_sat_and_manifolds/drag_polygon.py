"""Two polygons in a notebook, one of them to be dragged: axes, shadows and the way out follow.

Python computes and draws (`geometry`, `sat_svg`); the browser only says where B is. It can be
dragged with the pointer, moved with the arrow keys and turned with Q and E, or set with sliders.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import anywidget
import ipywidgets
import numpy as np
import traitlets

from lesson_code.chapters.ch06_sat_and_manifolds import figures as sat_plots
from lesson_code.chapters.ch06_sat_and_manifolds import sat_svg
from lesson_code.chapters.ch06_sat_and_manifolds.figures import Vertices
from lesson_code.view.browser.interactive import (
    Explorable,
    Slider,
    collects,
    float_slider,
    show_panel,
)
from lesson_code.view.browser.show import png_of
from lesson_code.view.matplotlib import style

LIMITS = {"x": (-2.2, 2.2), "y": (-1.8, 1.8), "angle": (-180.0, 180.0)}
"""How far B can be moved, m, and turned, degrees."""

LABEL = "Polygons A and B. Arrow keys move B, Q and E turn it."
HINT = "Drag B. Or click into the picture: the arrow keys move B, Q and E turn it."


class DraggedPolygon(anywidget.AnyWidget):
    """A picture of two polygons that follows x, y and angle of the second one.

    Parameters
    ----------
    vertices_a : array_like, shape (N, 2)
        Corners of A, m.
    vertices_b : array_like, shape (N, 2)
        Corners of B about its own origin, m; they are turned by `angle` and then moved by x, y.
    x, y, angle : float
        Where B starts, m and degrees counter-clockwise.
    """

    _esm = Path(__file__).with_suffix(".js")
    x = traitlets.Float().tag(sync=True)
    y = traitlets.Float().tag(sync=True)
    angle = traitlets.Float().tag(sync=True)
    picture = traitlets.Unicode().tag(sync=True)
    words = traitlets.Unicode().tag(sync=True)
    label = traitlets.Unicode(LABEL).tag(sync=True)
    hint = traitlets.Unicode(HINT).tag(sync=True)
    scale = traitlets.Float(sat_svg.SCALE).tag(sync=True)
    limits = traitlets.Dict(LIMITS).tag(sync=True)

    def __init__(
        self, vertices_a: Vertices, vertices_b: Vertices, x: float, y: float, angle: float
    ) -> None:
        self._a, self._b = (np.asarray(v, dtype=float) for v in (vertices_a, vertices_b))
        super().__init__(x=x, y=y, angle=angle)
        self._draw()

    @property
    def vertices_b(self) -> Any:
        """Corners of B where it is now, m."""
        return placed(self._b, self.x, self.y, self.angle)

    @traitlets.validate("x", "y", "angle")
    def _within_limits(self, proposal: Any) -> float:
        """Return a value that is asked for, or the nearest one that is allowed."""
        low, high = LIMITS[proposal["trait"].name]
        return min(high, max(low, float(proposal["value"])))

    @traitlets.observe("x", "y", "angle")
    def _moved(self, _: Any) -> None:
        """Draw the picture again."""
        self._draw()

    def _draw(self) -> None:
        """Set picture and words for where B is now."""
        self.words = sat_svg.in_words(self._a, self.vertices_b)
        self.picture = sat_svg.picture(self._a, self.vertices_b)


def drag_polygon(
    vertices_a: Vertices,
    vertices_b: Vertices,
    alt: str,
    *,
    x: float = 0.0,
    y: float = 0.0,
    angle: float = 0.0,
) -> None:
    """Display two polygons; B can be dragged, moved by keys, or set with three sliders.

    A reader without a kernel sees the picture as it starts.

    Parameters
    ----------
    vertices_a, vertices_b : array_like, shape (N, 2)
        Corners, counter-clockwise, m; those of B about its own origin.
    alt : str
        What can be seen at the start, and what can be changed.
    x, y : float
        Where B starts, m.
    angle : float
        How it starts turned, degrees.

    Raises
    ------
    ValueError
        `alt` is empty, or the vertices are no convex polygon.
    """
    ranges = {
        "x": Slider("x of B, m", *LIMITS["x"], x, step=0.01),
        "y": Slider("y of B, m", *LIMITS["y"], y, step=0.01),
        "angle": Slider("angle of B, degrees", *LIMITS["angle"], angle, step=1),
    }
    if collects(_explorable(vertices_a, vertices_b, alt, ranges)):
        return
    widget = DraggedPolygon(vertices_a, vertices_b, x, y, angle)
    sliders = {name: float_slider(slider) for name, slider in ranges.items()}
    for name, slider in sliders.items():
        slider.continuous_update = True
        # Linked in the browser: by way of Python, a slider would undo a drag that is faster.
        ipywidgets.jslink((widget, name), (slider, "value"))
    panel = ipywidgets.VBox([widget, *sliders.values()])
    start = png_of(still(vertices_a, widget.vertices_b))
    show_panel(panel, start, alt, "Run the cell to drag B.")


def _explorable(
    vertices_a: Vertices, vertices_b: Vertices, alt: str, sliders: dict[str, Slider]
) -> Explorable:
    """Return the explorable, to be drawn ahead of its reader."""

    def at(x: float, y: float, angle: float) -> tuple[Any, Any]:
        """Return the corners of A and those of B where it then is."""
        return np.asarray(vertices_a, dtype=float), placed(vertices_b, x, y, angle)

    return Explorable(
        alt,
        sliders,
        svg=lambda **place: sat_svg.as_file(sat_svg.picture(*at(**place))),
        words=lambda **place: sat_svg.in_words(*at(**place)),
    )


def placed(vertices: Vertices, x: float, y: float, angle: float) -> Any:
    """Return corners, m, turned by an angle in degrees and then moved by x and y."""
    turn = np.radians(angle)
    cos, sin = np.cos(turn), np.sin(turn)
    return np.asarray(vertices, dtype=float) @ np.array([[cos, sin], [-sin, cos]]) + (x, y)


def still(vertices_a: Vertices, vertices_b: Vertices) -> Any:
    """Return the same as a figure: the polygons with the way out, and a row for every axis."""
    figure, (left, right) = style.figure(2, width=9.5, height=3.8)
    found = sat_plots.shadows(vertices_a, vertices_b)
    decides = sat_plots.shortest(found)
    sat_plots.shadows_beside(left, vertices_a, vertices_b, decides.axis, decides.name)
    sat_plots.translation(left, vertices_a, vertices_b)
    sat_plots.shadow_rows(right, found)
    return figure
