"""Figures that answer while they are moved, in a notebook and in a page, with or without a kernel.

What they show is computed where they stand, by the lesson's own functions (``programs``). A chapter
describes a figure in a JavaScript module; ``figure.js`` says how, and brings it to life. Its still
picture, ``bounce.svg`` beside ``bounce.js``, is what a reader sees where no script runs.
"""

from __future__ import annotations

import base64
import hashlib
import re
from dataclasses import asdict
from functools import cache
from html import escape
from importlib.resources import files
from pathlib import Path

from IPython.display import display

import lesson_code
from lesson_code.view.browser import programs
from lesson_code.view.palette import PUBLISHED

CHAPTERS = Path(lesson_code.__file__).parent / "chapters"

IMPORT = re.compile(r"^import .*\n", re.MULTILINE)
EXPORT = re.compile(r"^export (default )?", re.MULTILINE)
NOTHING = re.compile(r"^\s*(//.*|/\*\*.*\*/)?\n", re.MULTILINE)
"""A line that holds no code."""

PROGRAMS = re.compile(r"^  programs?: (.+),$", re.MULTILINE)
"""Names the program whose functions a figure calls, or several."""

OURS = re.compile(r'^import .* from "\.\./\.\./view/browser/(\w+\.js)";$', re.MULTILINE)
"""Names a module of this folder that a figure uses."""


def live(figure: str, alt: str) -> None:
    """Display a figure whose points can be dragged and whose numbers can be set.

    Parameters
    ----------
    figure : str
        The chapter's folder and the figure's name: ``"ch03_reflection/bounce"``.
    alt : str
        What can be seen at the start and what can be changed, for readers who cannot see it.

    Raises
    ------
    ValueError
        There is no such figure, or `alt` is empty.
    """
    if not alt.strip():
        raise ValueError("alt must say what the figure shows, got nothing")
    still = file_of(figure).with_suffix(".svg").read_text("utf-8")
    words = f"Live figure: {alt} (It answers in a browser.)"
    display({"text/html": html_of(figure, alt, still), "text/plain": words}, raw=True)  # type: ignore[no-untyped-call]


def file_of(figure: str) -> Path:
    """Return the file that describes a figure.

    Raises
    ------
    ValueError
        There is no such figure.
    """
    file = CHAPTERS / f"{figure}.js"
    if not file.is_file():
        raise ValueError(
            f"figure must name a chapter's folder and a figure in it, such as "
            f"'ch03_reflection/bounce', got {figure!r}"
        )
    return file


def html_of(figure: str, alt: str, still: str) -> str:
    """Return a figure as HTML that needs no other file; `still` is its picture, an SVG."""
    script = script_of(figure)
    name = title_of(figure)
    picture = base64.b64encode(still.encode("ascii", "xmlcharrefreplace")).decode()
    return (
        f'<figure data-live="{name}" style="{colors()}">'
        f'<img alt="{escape(alt)}" style="display:block;max-width:100%;background:#fff" '
        f'src="data:image/svg+xml;base64,{picture}">\n'
        f'<script type="module">\n{script}start("{name}", shown, await open_program());\n'
        "</script></figure>"
    )


def title_of(figure: str) -> str:
    """Return a figure's name in a page: its own, and a sum over its script."""
    return f"{file_of(figure).stem}-{hashlib.sha256(script_of(figure).encode()).hexdigest()[:8]}"


def script_of(figure: str) -> str:
    """Return a figure's modules and its program as one script.

    A page that is opened from a folder may not fetch others.
    """
    described = file_of(figure).read_text("utf-8")
    named = PROGRAMS.search(described)
    if not named:
        raise ValueError(
            f"{file_of(figure)} must name its program, such as 'program: \"formulas\"'"
        )
    modules = {"figure.js", *OURS.findall(described)}
    lines = [_module(name) for name in (programs.LOADER.name, *sorted(modules))]
    return plain("\n".join([*lines, described, _opening(named[1])]))


def plain(modules: str) -> str:
    """Return modules that stand one after the other as one script."""
    text = IMPORT.sub("", modules)
    text = EXPORT.sub(lambda found: "const shown = " if found[1] else "", text)
    return NOTHING.sub("", text)


@cache
def _module(name: str) -> str:
    """Return a module of this folder."""
    return files("lesson_code.view.browser").joinpath(name).read_text("utf-8")


def _opening(named: str) -> str:
    """Return a function that opens a figure's program, or all of several by their names."""
    names = re.findall(r"\w+", named)
    if named.startswith('"'):
        return f"const open_program = () => {programs.opened(names[0])};\n"
    each = ", ".join(f"{name}: await {programs.opened(name)}" for name in names)
    return f"const open_program = async () => ({{ {each} }});\n"


def colors() -> str:
    """Return the palette as variables of a style; ``figure.js`` blends it with the text's colour.

    >>> colors().split(";")[0]
    '--blue:#0072B2'
    """
    return ";".join(f"--{name}:{value}" for name, value in asdict(PUBLISHED).items())
