"""The collision lab: bodies to throw at each other in a page, moved by the course's own engine."""

from __future__ import annotations

import ast
import base64
import hashlib
import inspect
import json
from collections.abc import Callable
from functools import cache
from html import escape
from pathlib import Path

from IPython.display import display

from lesson_code import scene_file
from lesson_code.formulas import effective_mass, friction_impulse, normal_impulse
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
    "plan.js",
    "lab_plan.js",
    "lab_code.js",
    "lab_python.js",
    "lab.js",
)
"""What makes the lab, in the order in which one uses the other."""

SHOWN = (effective_mass, normal_impulse, friction_impulse)
"""The formulas whose code it shows: what the engine does to a contact."""

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
        f'<div data-lab="{title()}" style="{colors()};font:14px/1.4 sans-serif">'
        f'<p>{WITHOUT}</p><img alt="{escape(ALT)}" '
        'style="display:block;width:100%;max-width:56em;background:#fff" '
        f'src="data:image/svg+xml;base64,{picture}"></div>\n'
        f'<script type="module">\n{script()}'
        "startLab(await open_program(), await open_formulas(), FUNCTIONS, "
        "await open_plan());\n</script>"
    )


def title() -> str:
    """Return the lab's name in a page, with a sum over its script."""
    return f"lab-{script_sum()}"


def script_sum() -> str:
    """Return a sum over the lab's script, in which any change of it shows."""
    return hashlib.sha256(script().encode()).hexdigest()[:16]


@cache
def script() -> str:
    """Return the lab's modules and its program as one script."""
    here = Path(__file__).parent
    form = f"const FORM = {json.dumps(scene_file.form())};\n"
    modules = form + "\n".join((here / name).read_text("utf-8") for name in MODULES)
    functions = "\n".join(code_of(function) for function in SHOWN)
    return (
        plain(programs.script_with(SOLVER, modules))
        + f"const open_formulas = () => {programs.opened('formulas')};\n"
        + f"const open_plan = () => {programs.opened('plan')};\n"
        + f"const FUNCTIONS = {json.dumps(functions)};\n"
    )


def code_of(function: Callable[..., object]) -> str:
    """Return the lines of a function, without its decorator and its docstring.

    >>> print(code_of(normal_impulse))
    def normal_impulse(
        vn: Number, m_eff: Number, restitution: Number, accumulated: Number = 0
    ) -> Number:
        return clamp(accumulated - (1 + restitution) * vn * m_eff, 0.0, math.inf)
    <BLANKLINE>
    """
    text = inspect.getsource(function)
    definition = ast.parse(text).body[0]
    if not isinstance(definition, ast.FunctionDef):
        raise TypeError(f"function must be written with def, got {function!r}")
    lines = text.splitlines(keepends=True)
    docstring = definition.body[0]
    return "".join(
        lines[definition.lineno - 1 : docstring.lineno - 1] + lines[docstring.end_lineno :]
    )
