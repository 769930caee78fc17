"""The collision lab: bodies to throw at each other in a page, moved by the course's own engine."""

from __future__ import annotations

import base64
from functools import cache
from html import escape
from pathlib import Path

from IPython.display import display

from lesson_code.view.browser import programs
from lesson_code.view.browser.live import colors, plain

SOLVER = "sequential"
"""The program that steps the lab."""

MODULES = (
    "world.js",
    "lab_setup.js",
    "lab_picture.js",
    "lab_hold.js",
    "lab_controls.js",
    "lab_account.js",
    "lab.js",
)
"""What makes the lab, in the order in which one uses the other."""

STILL = Path(__file__).parent / "lab.svg"
"""Its picture when it is opened; ``workbook regenerate`` makes it."""

ALT = (
    "Two discs between four walls; an arrow shows the velocity of disc 1, which moves to the right "
    "towards disc 2, at rest."
)
WITHOUT = "The collision lab needs a browser that runs JavaScript and WebAssembly."


def lab() -> None:
    """Display the collision lab in a notebook; it needs no kernel."""
    words = f"Collision lab: {ALT} (It answers in a browser.)"
    display({"text/html": lab_html(), "text/plain": words}, raw=True)  # type: ignore[no-untyped-call]


def lab_html() -> str:
    """Return the lab as HTML that needs no other file.

    >>> lab_html().count("</script>")
    1
    """
    picture = base64.b64encode(STILL.read_bytes()).decode() if STILL.exists() else ""
    return (
        f'<div data-lab style="{colors()}"><img alt="{escape(ALT)}" '
        'style="display:block;max-width:100%;background:#fff" '
        f'src="data:image/svg+xml;base64,{picture}"><p>{WITHOUT}</p></div>\n'
        f'<script type="module">\n{script()}startLab(await open_program());\n</script>'
    )


@cache
def script() -> str:
    """Return the lab's modules and its program as one script."""
    here = Path(__file__).parent
    modules = "\n".join((here / name).read_text("utf-8") for name in MODULES)
    return plain(programs.script_with(SOLVER, modules))
