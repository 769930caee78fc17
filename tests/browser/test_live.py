"""Every live figure in Chromium: what it draws, and that it answers to pointer and keys."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import pytest

from lesson_code.view.browser import stills
from lesson_code.view.browser.live import file_of, html_of

from .test_pages import violations_in

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Locator, Page

FIGURES = stills.names()
FIGURE = "ch03_reflection/bounce"
CHOOSING = [name for name in FIGURES if "names: " in file_of(name).read_text("utf-8")]
"""Figures with a list to choose from."""

NONSENSE = ("NaN", "Infinity", "undefined", "null")

LEAST_LETTERS = 8
"""Pixels: a little less than those of a chart in print."""

LEAST_HANDLE = 24
"""Pixels: what a finger can take hold of (WCAG 2.2, 2.5.8)."""

SMALLEST = """figure => {
    const scale = figure.querySelector("svg").getScreenCTM().a;
    const sizes = [...figure.querySelectorAll("svg text")].map(
        (words) => scale * words.getAttribute("font-size"));
    const handles = [...figure.querySelectorAll(".handle circle")].map(
        (circle) => circle.getBoundingClientRect().width);
    return [Math.min(...sizes), Math.min(...handles)];
}"""
"""In the page: the size of the smallest letters and handle of a figure, in pixels; of none inf."""

SETTLED = """async width => {
    const frame = () => new Promise(requestAnimationFrame);
    while (innerWidth !== width) await frame();
    await frame(); // what watches the size is told at the end of a frame
    await frame();
}"""
"""In the page: wait until it is so wide and what watches its size has been told."""

SHEET = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Figure</title>
<body style="background: {background}; color: {ink}"><main><h1>Figure</h1>{figure}</main>"""


def opened(page: Page, folder: Path, figure: str, scheme: Any = "light") -> Locator:
    """Open a page that holds a figure, from a folder, and return the figure once it is alive."""
    still = file_of(figure).with_suffix(".svg").read_text("utf-8")
    colors = {"background": "#fff", "ink": "#222"}
    if scheme == "dark":
        colors = {"background": "#131416", "ink": "#ddd"}
    file = folder / "figure.html"
    file.write_text(SHEET.format(figure=html_of(figure, "A figure.", still), **colors), "utf-8")
    page.goto(file.as_uri())
    page.locator("figure[data-ready]").wait_for()
    return page.locator("figure[data-ready]")


def resize(page: Page, width: int, height: int) -> None:
    """Give a page another size, and let its figure draw itself for it."""
    page.set_viewport_size({"width": width, "height": height})
    page.evaluate(SETTLED, width)


def seen(figure: Locator) -> tuple[str, str]:
    """Return what a figure draws and says, and hold it to be drawn without nonsense."""
    drawing = figure.locator("svg > g").first.inner_html()
    words = figure.locator("p").first.inner_text()
    assert drawing
    assert words
    assert not any(word in drawing + words for word in NONSENSE)
    assert figure.locator("svg").get_attribute("aria-label") == words
    return drawing, words


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_draws_what_its_still_picture_shows(page: Page, figure: str) -> None:
    """A reader without scripts sees how it starts."""
    assert stills.drawn(page, figure) == file_of(figure).with_suffix(".svg").read_text("utf-8")


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("figure", FIGURES)
def test_figure_passes_axe_and_has_no_errors(
    page: Page, faults: list[str], tmp_path: Path, figure: str, scheme: str
) -> None:
    """Its controls have names, its words contrast enough."""
    opened(page, tmp_path, figure, scheme)
    assert violations_in(page) == []
    assert faults == []


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_answers_to_each_slider_up_to_its_ends(
    page: Page, faults: list[str], tmp_path: Path, figure: str
) -> None:
    """By keyboard: End and Home. Somewhere on the way the picture or the words change."""
    live = opened(page, tmp_path, figure)
    start = seen(live)
    for slider in live.locator("input[type=range]").all():
        slider.focus()
        shown = []
        for key in ("End", "Home"):
            page.keyboard.press(key)
            shown.append(seen(live))
        assert {*shown} - {start}, slider.get_attribute("aria-label")
        live.get_by_role("button", name="Start again").click()
        assert seen(live) == start
    assert faults == []


@pytest.mark.parametrize("figure", CHOOSING)
def test_figure_answers_to_each_choice(
    page: Page, faults: list[str], tmp_path: Path, figure: str
) -> None:
    """Each entry of a list shows something else, without nonsense."""
    live = opened(page, tmp_path, figure)
    for choice in live.locator("select").all():
        shown = []
        for value in range(choice.locator("option").count()):
            choice.select_option(str(value))
            shown.append(seen(live))
        assert len({*shown}) == len(shown)
    assert faults == []


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_on_a_phone_has_its_panels_below_each_other(
    page: Page, tmp_path: Path, figure: str
) -> None:
    """Nothing has to be scrolled sideways, letters can be read; made wider, it stands as before."""
    live = opened(page, tmp_path, figure)
    wide = seen(live)
    resize(page, 360, 740)
    assert page.evaluate("document.documentElement.scrollWidth") == 360
    seen(live)
    letters, handle = live.evaluate(SMALLEST)
    assert letters >= LEAST_LETTERS
    assert handle >= LEAST_HANDLE
    resize(page, 1280, 900)
    assert seen(live) == wide


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_at_all_ends_at_once_draws_no_nonsense(
    page: Page, faults: list[str], tmp_path: Path, figure: str
) -> None:
    """All sliders at their least, at their most, and in turn."""
    live = opened(page, tmp_path, figure)
    sliders = live.locator("input[type=range]").all()
    for keys in (["Home"], ["End"], ["Home", "End"], ["End", "Home"]):
        for k, slider in enumerate(sliders):
            slider.focus()
            page.keyboard.press(keys[k % len(keys)])
        seen(live)
    assert faults == []


@pytest.mark.parametrize("figure", FIGURES)
def test_points_of_a_figure_move_by_key_and_by_pointer(
    page: Page, faults: list[str], tmp_path: Path, figure: str
) -> None:
    """While they are dragged, not after."""
    live = opened(page, tmp_path, figure)
    for handle in live.locator(".handle").all():
        start = seen(live)
        handle.focus()
        said = handle.get_attribute("aria-valuetext")
        for keys in (("ArrowLeft", "ArrowDown"), ("ArrowRight", "ArrowUp")):
            for key in keys:
                page.keyboard.press(key)
            if handle.get_attribute("aria-valuetext") != said:
                break  # else it was at its least
        assert handle.get_attribute("aria-valuetext") != said
        assert seen(live) != start
        box = handle.bounding_box()
        assert box
        middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        by_key = seen(live)
        page.mouse.move(*middle)
        page.mouse.down()
        page.mouse.move(middle[0] + 25, middle[1] + 20)
        assert seen(live) != by_key
        page.mouse.up()
        dropped = seen(live)
        page.mouse.move(middle[0] + 90, middle[1])
        assert seen(live) == dropped
    assert faults == []


def test_number_that_is_typed_in_is_taken_as_it_is(page: Page, tmp_path: Path) -> None:
    """Though it lies between two steps of the slider; one out of range is put right at the end."""
    live = opened(page, tmp_path, FIGURE)
    box = live.get_by_role("spinbutton", name="restitution e, as a number")
    box.fill("0.123")
    assert "out at 3.02 m/s by the bounce" in seen(live)[1]  # |(3, .123 * 3)|
    box.fill("7")
    assert "out at 3.02 m/s" in seen(live)[1]
    box.blur()
    assert box.input_value() == "0.123"


def test_words_are_read_out_once_the_figure_rests(page: Page, tmp_path: Path) -> None:
    """Not at each of the many states that it goes through."""
    live = opened(page, tmp_path, FIGURE)
    slider = live.get_by_role("slider", name="restitution e")
    slider.focus()
    for _ in range(5):
        page.keyboard.press("ArrowLeft")
    status = live.get_by_role("status")
    status.get_by_text(seen(live)[1]).wait_for()
    assert slider.get_attribute("aria-valuetext") == "0.25"


def test_figure_is_a_picture_where_no_script_runs(page: Page, tmp_path: Path) -> None:
    """With its text."""
    still = file_of(FIGURE).with_suffix(".svg").read_text("utf-8")
    page.set_content(html_of(FIGURE, "A wall.", still).split("<script")[0])
    image = page.get_by_role("img", name="A wall.")
    assert image.evaluate("image => image.naturalWidth") > 300
