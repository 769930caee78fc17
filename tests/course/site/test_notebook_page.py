"""A notebook's page: what becomes of each kind of output, and of links to exercises."""

from __future__ import annotations

import base64
from dataclasses import astuple
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from lesson_code.course.site.notebook_page import BEGIN_ANSWER, END_ANSWER, NotebookPage, smaller
from lesson_code.view.browser.show import png_of
from lesson_code.view.matplotlib import style
from lesson_code.view.palette import PUBLISHED

SHADE = 16
"""Of 255 of a colour: what is hardly seen between two lines of a pixel's width."""

PNG = png_of(style.figure(width=3, height=2)[0])
ALT = 'Two "carts" & a wall.'


def picture(words: str) -> Any:
    """Return the output of a figure, as notebooks hold it."""
    data = {"image/png": base64.b64encode(PNG).decode(), "text/plain": words}
    return new_output("display_data", data=data, metadata={"image/png": {"alt": ALT}})


def pixels_of(png: bytes) -> Any:
    """Return the pixels of a PNG, from 0 to 255."""
    return 255 * imread(BytesIO(png), format="png")[:, :, :3]


def html(text: str, words: str = "") -> Any:
    """Return an output that is HTML."""
    return new_output("display_data", data={"text/html": text, "text/plain": words})


def page_of(folder: Path, *outputs: Any) -> list[Any]:
    """Return the outputs of a page whose notebook has one cell with these."""
    notebook = new_notebook(cells=[new_code_cell("", outputs=list(outputs))])
    [cell] = NotebookPage("01_carts", folder).page_of(notebook).cells
    return list(cell.outputs)


def test_figure_becomes_an_image_with_its_text_and_size(tmp_path: Path) -> None:
    """The file is a smaller PNG; the text is escaped; the page keeps room for it."""
    [shown] = page_of(tmp_path, picture("Figure: carts"))
    assert (
        'alt="Two &quot;carts&quot; &amp; a wall." width="300" height="200"'
        in shown.data["text/html"]
    )
    assert 'src="../_static/figures/01_carts-1.png"' in shown.data["text/html"]
    made = (tmp_path / "_static" / "figures" / "01_carts-1.png").read_bytes()
    assert made == smaller(PNG)


def test_smaller_figure_looks_the_same() -> None:
    """Lines in all colours of the palette, and letters: few pixels are off by more than a shade."""
    figure, axes = style.figure(width=6, height=4)
    for k, color in enumerate(astuple(PUBLISHED)):
        axes.plot([0, 1], [0, 1 + 0.1 * k], color=color, label=f"line {k}")
    axes.legend()
    png = png_of(figure)
    made = smaller(png)
    pixels = [pixels_of(data) for data in (png, made)]
    off = np.abs(pixels[0] - pixels[1]).max(axis=2)
    assert len(made) < len(png) / 2
    assert (off > SHADE).mean() < 0.002
    assert off.max() <= 3 * SHADE


def test_text_of_a_figure_is_not_said_twice(tmp_path: Path) -> None:
    """What a notebook adds for screen readers is in the image's own text here."""
    shown = page_of(
        tmp_path, picture("Figure: carts"), html("<p>Figure: carts</p>", "Figure: carts")
    )
    assert len(shown) == 1


def test_answers_are_folded_together_and_plumbing_each_for_itself(tmp_path: Path) -> None:
    """Neighbouring cells of an answer stand in one element that opens without a script."""
    tagged = {tag: {"tags": [tag]} for tag in ("answer", "plumbing")}
    cells = [
        new_code_cell("import numpy", metadata=tagged["plumbing"]),
        new_code_cell("x = 1", metadata=tagged["answer"]),
        new_markdown_cell("And so it is.", metadata=tagged["answer"]),
        new_markdown_cell("Next."),
    ]
    page = NotebookPage("01_carts", tmp_path).page_of(new_notebook(cells=cells))
    assert [cell.source for cell in page.cells] == [
        "import numpy",
        BEGIN_ANSWER,
        "x = 1",
        "And so it is.",
        END_ANSWER,
        "Next.",
    ]
    assert page.cells[0].metadata.tags == ["plumbing", "hide-input"]


def test_other_outputs_and_the_notebook_itself_stay(tmp_path: Path) -> None:
    """What was printed and animations are shown as they are; the notebook is not changed."""
    printed = new_output("stream", name="stdout", text="ok\n")
    animation = html('<figure data-animation="run-1">')
    notebook = new_notebook(cells=[new_code_cell("x", outputs=[printed, animation, picture("")])])
    page = NotebookPage("01_carts", tmp_path).page_of(notebook)
    assert page.cells[0].outputs[:2] == [printed, animation]
    assert notebook.cells[0].outputs[2] == picture("")


@pytest.mark.parametrize("suffix", [".ipynb", ".py"])
def test_link_to_an_exercise_becomes_a_download(tmp_path: Path, suffix: str) -> None:
    """A link over two lines too; links between notebooks are left to Sphinx."""
    text = f"Do [02\nNow](../exercises/02{suffix}), then [03](03_r.ipynb)."
    page = NotebookPage("02", tmp_path).page_of(new_notebook(cells=[new_markdown_cell(text)]))
    link = f'<a href="../exercises/02{suffix}" download>02\nNow</a>'
    assert page.cells[0].source == f"Do {link}, then [03](03_r.ipynb)."


def test_link_to_an_exercise_with_a_page_leads_there(tmp_path: Path) -> None:
    """From the text, and from the top of its chapter's parts; one without a page is a file."""
    text = "Do [this](../exercises/01_one.ipynb) and [that](../exercises/pool.py)."
    notebook = new_notebook(cells=[new_markdown_cell("# 01 One"), new_markdown_cell(text)])
    page = NotebookPage("01_one", tmp_path, answered=["01_one"]).page_of(notebook)
    assert page.cells[0].source.endswith("(../exercises/01_one.md).")
    assert "[this](../exercises/01_one.md)" in page.cells[1].source
    assert '<a href="../exercises/pool.py" download>that</a>' in page.cells[1].source
    for name, leads in (("01b_on", True), ("02_two", False)):
        page = NotebookPage(name, tmp_path, answered=["01_one"]).page_of(notebook)
        assert page.cells[0].source.endswith("(../exercises/01_one.md).") == leads
