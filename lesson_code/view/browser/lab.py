"""The collision lab: bodies to throw at each other in a page, moved by the course's own engine."""

from __future__ import annotations

from importlib.resources import files

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

WITHOUT = "The collision lab needs a browser that runs JavaScript and WebAssembly."


def lab_html() -> str:
    """Return the lab as HTML that needs no other file.

    >>> lab_html().count("</script>")
    1
    """
    here = files("lesson_code.view.browser")
    modules = "\n".join(here.joinpath(name).read_text("utf-8") for name in MODULES)
    script = plain(programs.script_with(SOLVER, modules))
    return (
        f'<div data-lab style="{colors()}"><p>{WITHOUT}</p></div>\n'
        f'<script type="module">\n{script}startLab(await open_program());\n</script>'
    )
