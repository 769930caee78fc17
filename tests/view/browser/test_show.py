"""A figure in a notebook: its picture, and a text for those who do not see it."""

from __future__ import annotations

from typing import Any

import pytest

from lesson_code.view.browser import show as module
from lesson_code.view.browser.show import png_of, show
from lesson_code.view.matplotlib import style


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[tuple[dict[str, Any], dict[str, Any]]]:
    """Collect what is displayed, in place of a notebook's front end."""
    calls: list[tuple[dict[str, Any], dict[str, Any]]] = []
    monkeypatch.setattr(module, "display", lambda data, **options: calls.append((data, options)))
    return calls


def a_line(width: float = 3) -> Any:
    """Return a figure of one line."""
    figure, ax = style.figure(width=width, height=2)
    ax.plot([0, 1], [0, 1])
    return figure


def test_show_displays_the_picture_once_with_its_text_in_both_places(displayed: Any) -> None:
    """The alt text stands in the picture's metadata, and in the plain text of terminals."""
    figure = a_line()
    show(figure, "A line that rises.")
    (bundle, options), _ = displayed
    assert bundle == {"image/png": png_of(figure), "text/plain": "Figure: A line that rises."}
    assert options == {"metadata": {"image/png": {"alt": "A line that rises."}}, "raw": True}


def test_show_says_the_text_out_of_sight_for_screen_readers(displayed: Any) -> None:
    """Below the picture stands its text, escaped and out of sight."""
    show(a_line(), "A line with x < y.")
    _, (bundle, options) = displayed
    assert bundle["text/html"].endswith(">Figure: A line with x &lt; y.</p>")
    assert "clip-path" in bundle["text/html"]
    assert bundle["text/plain"] == "Figure: A line with x < y."
    assert options == {"raw": True}


def test_show_returns_nothing(displayed: Any) -> None:
    """The last line of a cell may be `show(...)`: no picture is displayed twice."""
    assert show(a_line(), "A line.") is None  # type: ignore[func-returns-value]
    assert sum("image/png" in bundle for bundle, _ in displayed) == 1


@pytest.mark.parametrize("alt", ["", "  ", "\n"])
def test_figure_without_alt_text_is_refused(displayed: Any, alt: str) -> None:
    """Nobody can forget those who do not see."""
    with pytest.raises(ValueError, match="alt must say what the figure shows"):
        show(a_line(), alt)
    assert displayed == []


def test_png_is_the_same_bytes_for_the_same_figure() -> None:
    """Neither the time nor matplotlib's version is written into the picture."""
    first, second = png_of(a_line()), png_of(a_line())
    assert first.startswith(b"\x89PNG")
    assert first == second
    assert b"Software" not in first


def test_png_has_the_size_of_the_figure() -> None:
    """A figure 4 inches wide and 2 high is 400 by 200 pixels."""
    header = png_of(a_line(width=4))[16:24]
    assert (int.from_bytes(header[:4]), int.from_bytes(header[4:])) == (400, 200)
