"""A notebook as a page: the same cells, their outputs made ready for a browser without a kernel."""

from __future__ import annotations

import ast
import base64
import copy
import itertools
import re
import struct
from collections.abc import Collection, Iterable, Iterator
from html import escape
from io import BytesIO
from pathlib import Path
from typing import Any, TypeGuard

FIGURES = "_static/figures"
"""Where the files of figures are put, from the root of the site."""

FROM_A_PAGE = f"../{FIGURES}"
"""The same from a notebook's page."""

EXERCISE = re.compile(r"\[([^\]]+)\]\(\.\./exercises/([^)]+)\)")
"""A link to an exercise."""

BEGIN_ANSWER = '<details class="answer">\n<summary>Open the answer</summary>'
END_ANSWER = "</details>"
"""What stands around the cells that answer a prediction."""

IN_THE_PAGE = "write it and have it checked in the browser"

BEGINS = "**After this notebook"
"""Stands in the first cell of a notebook that teaches."""

RUN_ALREADY = (
    "\n\nOn this page the notebook has run already: answer its questions and move its figures "
    "here. To write its lines yourself, [open it on your computer](../pages/students.md)."
)
"""What the first cell says of code that cannot be changed in the page."""

SHOWING = {"show", "live", "lab", "animate", "show_quiz", "predict"}
"""What a cell calls to show something."""

TELLING = {"check", "print", "simulate"}
"""What a cell calls that its reader should see."""


class NotebookPage:
    """Makes one notebook's page, and writes the files of its figures.

    Parameters
    ----------
    name : str
        The notebook's name without its suffix.
    folder : Path
        The root of the site's sources.
    answered : collection of str
        The exercises that have a page of their own, by name.
    """

    def __init__(self, name: str, folder: Path, answered: Collection[str] = ()) -> None:
        self._answered = answered
        self._name, self._folder, self._count = name, folder / FIGURES, 0
        self._folder.mkdir(parents=True, exist_ok=True)

    def page_of(self, notebook: Any) -> Any:
        """Return the notebook as its page shows it; the one given is not changed."""
        page = copy.deepcopy(notebook)
        for cell in page.cells:
            if cell.cell_type == "markdown":
                cell.source = EXERCISE.sub(self._exercise, cell.source)
            else:
                shown = map(self._shown, cell.outputs)
                cell.outputs = [output for output in shown if output is not None]
        for exercise in self._answered:
            if exercise[:2] == self._name[:2]:  # each part of a chapter leads to its exercise
                link = f"[{IN_THE_PAGE}](../exercises/{exercise}.md)"
                page.cells[0].source += f"\n\n**Exercise:** {link}."
        if BEGINS in page.cells[0].source:
            page.cells[0].source += RUN_ALREADY
        page.cells = list(_folded(page.cells))
        return page

    def _exercise(self, link: re.Match[str]) -> str:
        """Return a link to an exercise: to its page, if it has one, or to its file."""
        words, file = link.groups()
        stem = file.partition(".")[0]
        if stem in self._answered:
            return f"[{words}](../exercises/{stem}.md)"
        return download(words, f"../exercises/{file}")

    def _shown(self, output: Any) -> Any:
        """Return what a page shows of an output; None for a figure's text, which its image has."""
        data = output.get("data", {})
        if "image/png" in data:
            return _html_output(output, self._figure(output))
        if data.get("text/plain", "").startswith("Figure: "):
            return None
        return output

    def _figure(self, output: Any) -> str:
        """Return a figure, and write its file."""
        self._count += 1
        name = f"{self._name}-{self._count}"
        alt, png = output.metadata["image/png"]["alt"], base64.b64decode(output.data["image/png"])
        (self._folder / f"{name}.png").write_bytes(smaller(png))
        return f'<figure class="drawn">{_image(f"{name}.png", alt, png)}</figure>'


def _folded(cells: Iterable[Any]) -> Iterator[Any]:
    """Yield cells, those that answer a prediction folded together, plumbing each for itself."""
    for is_answer, group in itertools.groupby(cells, lambda cell: has_tag(cell, "answer")):
        if is_answer:
            yield _markdown(BEGIN_ANSWER)
        for cell in group:
            if has_tag(cell, "plumbing") or (cell.cell_type == "code" and is_plumbing(cell.source)):
                cell.metadata["tags"] = [*cell.metadata.get("tags", ()), "hide-input"]
            yield cell
        if is_answer:
            yield _markdown(END_ANSWER)


def _markdown(text: str) -> Any:
    """Return a cell of text."""
    from nbformat.v4 import new_markdown_cell

    return new_markdown_cell(text)  # type: ignore[no-untyped-call]


def has_tag(cell: Any, tag: str) -> bool:
    """Return whether a notebook's cell has a tag."""
    return tag in cell.metadata.get("tags", [])


def is_plumbing(source: str) -> bool:
    """Return whether a cell teaches nothing by itself: it imports, or shows what was made.

    >>> is_plumbing("import numpy as np"), is_plumbing("show(figure, 'A ball.')")
    (True, True)
    >>> is_plumbing("check('a ball', 1, 1)"), is_plumbing("show(drawn(simulate(scene, 1.0)))")
    (False, False)
    """
    tree = ast.parse(source)
    called = {n.func.id for n in ast.walk(tree) if isinstance(n, ast.Call) and _is_named(n.func)}
    only_imports = all(isinstance(part, ast.Import | ast.ImportFrom) for part in tree.body)
    return only_imports or bool(called & SHOWING and not called & TELLING)


def _is_named(function: ast.expr) -> TypeGuard[ast.Name]:
    """Return whether a function is called by its bare name."""
    return isinstance(function, ast.Name)


def download(words: str, address: str) -> str:
    """Return a link to a file that is kept, not opened."""
    return f'<a href="{address}" download>{words}</a>'


def _html_output(output: Any, html: str) -> Any:
    """Return an output that is this HTML."""
    return type(output)(output_type="display_data", metadata={}, data={"text/html": html})


def smaller(png: bytes) -> bytes:
    """Return a drawing on white as a PNG of 256 colours: a quarter of the bytes.

    A drawing has few colours; its edges get the nearest of the palette.
    """
    from PIL import Image  # comes with matplotlib

    with Image.open(BytesIO(png)) as picture:
        sheet = Image.new("RGBA", picture.size, "white")
        sheet.alpha_composite(picture.convert("RGBA"))
    made = BytesIO()
    few = sheet.convert("RGB").quantize(256, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(made, "PNG", optimize=True)
    return made.getvalue()


def _image(file: str, alt: str, png: bytes) -> str:
    """Return an image that takes the room of a PNG from the start."""
    width, height = struct.unpack(">II", png[16:24])
    return f'<img src="{FROM_A_PAGE}/{file}" alt="{escape(alt)}" width="{width}" height="{height}">'
