"""Figures with sliders: alive with a kernel, and standing still without one."""

from __future__ import annotations

import base64
from typing import Any

import ipywidgets
import pytest
from ipywidgets.widgets.widget import _instances
from matplotlib.figure import Figure

from lesson_code.view.browser import interactive
from lesson_code.view.browser.interactive import Slider, collected, explore
from lesson_code.view.browser.show import png_of, svg_of
from lesson_code.view.matplotlib import style

WIDGET = "application/vnd.jupyter.widget-view+json"
ALT = 'A point at "x" < 1 & more.'
X = Slider("x, m", 0, 1, 0.25, step=0.25)
Y = Slider("y, m", -1, 1, 0)


def draw_point(x: float, y: float = 0.0) -> Figure:
    """Return a figure of one point."""
    figure, ax = style.figure(width=2, height=2)
    ax.plot(x, y, marker="o")
    ax.set(xlim=(-1, 1), ylim=(-1, 1))
    return figure


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Collect what is displayed, in place of a notebook's front end."""
    calls: list[tuple[dict[str, Any], dict[str, Any]]] = []
    monkeypatch.setattr(
        interactive, "display", lambda data, **options: calls.append((data, options))
    )
    return calls


def panel_of(displayed: list[tuple[dict[str, Any], dict[str, Any]]]) -> Any:
    """Return the widget that was displayed."""
    [(bundle, _)] = displayed
    return _instances[bundle[WIDGET]["model_id"]]


def picture_in(panel: Any) -> bytes:
    """Return the PNG a panel shows."""
    return base64.b64decode(panel.children[-1].value.split("base64,")[1].split('"')[0])


def test_bundle_holds_widget_picture_and_text(displayed: Any) -> None:
    """With a kernel the sliders are shown; without one the picture; in a terminal the text."""
    explore(draw_point, ALT, x=X)
    [(bundle, options)] = displayed
    assert set(bundle) == {WIDGET, "image/png", "text/plain"}
    assert bundle["image/png"] == png_of(draw_point(0.25))
    assert bundle["text/plain"] == f"Figure: {ALT} (Run the cell to move the sliders.)"
    assert options == {"metadata": {"image/png": {"alt": ALT}}, "raw": True}


def test_stored_parts_are_the_same_on_every_run(displayed: Any) -> None:
    """Only the widget's own id, which nbval does not compare, differs from run to run."""
    explore(draw_point, ALT, x=X)
    explore(draw_point, ALT, x=X)
    (first, _), (second, _) = displayed
    assert first.pop(WIDGET) != second.pop(WIDGET)
    assert first == second


def test_panel_shows_the_start_first(displayed: Any) -> None:
    """Before anything is moved, the live picture is the stored one."""
    explore(draw_point, ALT, x=X)
    assert picture_in(panel_of(displayed)) == png_of(draw_point(0.25))


def test_moving_a_slider_changes_the_picture(displayed: Any) -> None:
    """Each slider draws the figure anew, with the values of all of them."""
    explore(draw_point, ALT, x=X, y=Y)
    panel = panel_of(displayed)
    panel.children[0].value = 0.75
    assert picture_in(panel) == png_of(draw_point(0.75, 0))
    panel.children[1].value = -0.5
    assert picture_in(panel) == png_of(draw_point(0.75, -0.5))


def test_sliders_stand_above_the_picture_in_their_order(displayed: Any) -> None:
    """The panel is one slider for each quantity, and then the picture."""
    explore(draw_point, ALT, y=Y, x=X)
    *sliders, picture = panel_of(displayed).children
    assert [slider.description for slider in sliders] == ["y, m", "x, m"]
    assert isinstance(picture, ipywidgets.HTML)


def test_slider_has_the_range_step_and_start_asked_for(displayed: Any) -> None:
    """The widget is what the `Slider` says."""
    explore(draw_point, ALT, x=X)
    slider = panel_of(displayed).children[0]
    assert (slider.min, slider.max, slider.value, slider.step) == (0, 1, 0.25, 0.25)


def test_slider_leaves_room_for_its_label_and_for_narrow_windows(displayed: Any) -> None:
    """A label of 25 letters is not cut, and nothing reaches beyond a narrow window."""
    explore(draw_point, ALT, x=X)
    slider, picture = panel_of(displayed).children
    assert slider.style.description_width == "14em"
    assert slider.layout.max_width == "100%"
    assert "max-width: 100%" in picture.value


def test_picture_is_drawn_when_the_slider_is_let_go(displayed: Any) -> None:
    """A slow figure is not drawn for every pixel the slider passes."""
    explore(draw_point, ALT, x=X)
    assert panel_of(displayed).children[0].continuous_update is False


def test_alt_text_is_escaped_in_the_panel(displayed: Any) -> None:
    """Quotes and angle brackets in the text do not end the element."""
    explore(draw_point, ALT, x=X)
    value = panel_of(displayed).children[-1].value
    assert value.startswith('<img alt="A point at &quot;x&quot; &lt; 1 &amp; more." ')


@pytest.mark.parametrize("alt", ["", " \n"])
def test_figure_without_alt_text_is_refused(displayed: Any, alt: str) -> None:
    """Nobody can forget those who do not see."""
    with pytest.raises(ValueError, match="alt must say what the figure shows"):
        explore(draw_point, alt, x=X)
    assert displayed == []


def test_figure_without_sliders_is_refused(displayed: Any) -> None:
    """A figure nobody can change is for `show`."""
    with pytest.raises(ValueError, match="at least one slider"):
        explore(draw_point, ALT)
    assert displayed == []


@pytest.mark.parametrize("start", [-0.01, 1.01, float("nan")])
def test_start_outside_the_range_is_refused(start: float) -> None:
    """The error says the range and the value."""
    with pytest.raises(ValueError, match=f"start must lie between 0 and 1, got {start}"):
        Slider("x, m", 0, 1, start)


@pytest.mark.parametrize("start", [0, 1])
def test_start_at_either_end_is_allowed(start: float) -> None:
    """Both ends of the range belong to it."""
    assert Slider("x, m", 0, 1, start).start == start


def test_range_the_wrong_way_round_is_refused() -> None:
    """No start lies between 1 and 0."""
    with pytest.raises(ValueError, match="start must lie between 1 and 0"):
        Slider("x, m", 1, 0, 0.5)


@pytest.mark.parametrize("step", [0, -0.1, float("nan")])
def test_step_that_leads_nowhere_is_refused(step: float) -> None:
    """A slider with such a step could not be moved."""
    with pytest.raises(ValueError, match=f"step must be > 0, got {step}"):
        Slider("x, m", 0, 1, 0.5, step=step)


def test_collected_figure_is_not_displayed_and_can_be_drawn_anywhere(displayed: Any) -> None:
    """Whoever draws ahead gets text, sliders, and the figure for any values."""
    with collected() as figures:
        explore(draw_point, ALT, x=X, y=Y)
    [figure] = figures
    assert displayed == []
    assert (figure.alt, dict(figure.sliders), figure.words) == (ALT, {"x": X, "y": Y}, None)
    assert figure.svg(x=0.75, y=-0.5) == svg_of(draw_point(0.75, -0.5))


def test_figures_are_displayed_again_after_collecting(displayed: Any) -> None:
    """Collecting ends with its block, also where a figure fails in it."""
    with pytest.raises(ZeroDivisionError), collected():
        explore(draw_point, ALT, x=Slider("x, m", 0, 1, 1 / 0))
    explore(draw_point, ALT, x=X)
    assert len(displayed) == 1
