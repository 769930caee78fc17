"""The polygon that is dragged: what the browser sets, and what Python answers."""

from __future__ import annotations

from typing import Any

import ipywidgets
import numpy as np
import pytest
from ipywidgets.widgets.widget import _instances

from lesson_code.chapters.ch06_sat_and_manifolds import sat_svg
from lesson_code.chapters.ch06_sat_and_manifolds.drag_polygon import (
    LIMITS,
    DraggedPolygon,
    drag_polygon,
)
from lesson_code.geometry import Polygon
from lesson_code.view.browser import interactive

A = Polygon.box(2.0, 1.0).vertices
B = Polygon([(0.0, 0.0), (1.5, 0.0), (0.3, 1.2)]).vertices
ALT = "Polygons A and B overlap; B can be moved."
WIDGET = "application/vnd.jupyter.widget-view+json"

ROUNDING = 1e-12
"""m: one turn by an angle."""


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Collect what is displayed, in place of a notebook's front end."""
    calls: list[tuple[dict[str, Any], dict[str, Any]]] = []
    monkeypatch.setattr(
        interactive, "display", lambda data, **options: calls.append((data, options))
    )
    return calls


def test_picture_follows_x_y_and_angle() -> None:
    """Whatever is set, picture and words are those of B where it then is."""
    widget = DraggedPolygon(A, B, 1.0, 0.5, 0.0)
    for name, value in (("x", 0.25), ("y", -0.5), ("angle", 90.0)):
        setattr(widget, name, value)
        assert widget.picture == sat_svg.picture(A, widget.vertices_b)
        assert widget.words == sat_svg.in_words(A, widget.vertices_b)


def test_vertices_turn_counter_clockwise_and_then_move() -> None:
    """Turned by 90 degrees, what lay along x lies along y, about B's own origin."""
    widget = DraggedPolygon(A, [(0, 0), (1, 0), (0, 0.5)], 2.0, 1.0, 90.0)
    expected = [(2, 1), (2, 2), (1.5, 1)]
    assert np.allclose(widget.vertices_b, expected, rtol=0, atol=ROUNDING)


@pytest.mark.parametrize("name", ["x", "y", "angle"])
def test_values_beyond_the_limits_are_taken_to_them(name: str) -> None:
    """B stays in the picture, whatever the browser asks for."""
    widget = DraggedPolygon(A, B, 0.0, 0.0, 0.0)
    for value, end in ((1e9, LIMITS[name][1]), (-1e9, LIMITS[name][0])):
        setattr(widget, name, value)
        assert getattr(widget, name) == end


def test_script_says_where_b_is_and_draws_nothing() -> None:
    """The front end sets the three numbers; geometry and drawing stay in Python."""
    script = DraggedPolygon(A, B, 0.0, 0.0, 0.0)._esm
    assert 'put("x"' in script
    assert "Arrow" in script
    assert "<polygon" not in script


def test_bundle_holds_widget_picture_and_text(displayed: Any) -> None:
    """With a kernel B can be dragged; without one there is the picture; in a terminal the text."""
    drag_polygon(A, B, ALT, x=0.8, y=0.3)
    [(bundle, options)] = displayed
    assert set(bundle) == {WIDGET, "image/png", "text/plain"}
    assert bundle["text/plain"] == f"Figure: {ALT} (Run the cell to drag B.)"
    assert options == {"metadata": {"image/png": {"alt": ALT}}, "raw": True}


def test_panel_has_a_slider_for_each_number(displayed: Any) -> None:
    """Without a pointer, three sliders reach every place, and start where B is."""
    drag_polygon(A, B, ALT, x=0.8, y=0.3, angle=20)
    widget, *sliders = _instances[displayed[0][0][WIDGET]["model_id"]].children
    assert isinstance(widget, DraggedPolygon)
    assert all(isinstance(slider, ipywidgets.FloatSlider) for slider in sliders)
    assert [slider.value for slider in sliders] == [widget.x, widget.y, widget.angle]
    assert [(slider.min, slider.max) for slider in sliders] == list(LIMITS.values())


def test_drag_polygon_wants_words(displayed: Any) -> None:
    """Who cannot see the picture is told what is in it."""
    with pytest.raises(ValueError, match="alt must say what the figure shows"):
        drag_polygon(A, B, " ")


def test_collected_picture_is_the_one_the_widget_shows(displayed: Any) -> None:
    """Drawn ahead it is the same picture, as a file of its own, with the same words."""
    with interactive.collected() as figures:
        drag_polygon(A, B, "Two polygons.", x=0.5, y=0.25, angle=30)
    [figure] = figures
    widget = DraggedPolygon(A, B, -0.5, 1.0, 45)
    place = {"x": -0.5, "y": 1.0, "angle": 45}
    assert displayed == []
    assert figure.svg(**place) == sat_svg.as_file(widget.picture)
    assert figure.words is not None
    assert figure.words(**place) == widget.words
    assert [slider.start for slider in figure.sliders.values()] == [0.5, 0.25, 30]


def test_picture_as_a_file_says_what_it_is() -> None:
    """Outside of a page an SVG needs its name space; nothing else is changed."""
    assert sat_svg.as_file('<svg a="1"><g/></svg>') == (
        '<svg xmlns="http://www.w3.org/2000/svg" a="1"><g/></svg>'
    )
