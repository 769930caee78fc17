"""Docstrings as pages: an extension of Sphinx that shows equations the way they are written."""

from __future__ import annotations

import re
from typing import Any

SECTION = re.compile(r"-{3,}$")
"""Stands below the title of a docstring's section."""

ENDS = (".", ":", "?", "`")
"""What the paragraphs of a text end with."""

BEFORE_NUMPYDOC = 400
"""Priority: Sphinx's own reader of sections has 500."""


def setup(app: Any) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("autodoc-process-docstring", _process, priority=BEFORE_NUMPYDOC)
    return {"parallel_read_safe": True}


def _process(app: Any, what: str, name: str, obj: Any, options: Any, lines: list[str]) -> None:  # noqa: ARG001 - as Sphinx calls it
    """Change a docstring in place."""
    lines[:] = with_equations(lines)


def with_equations(lines: list[str]) -> list[str]:
    """Return a docstring whose equations are blocks of code.

    An equation is a paragraph before the first section that does not end as a sentence does.

    >>> with_equations(["Add.", "", "s = |a| + |b|", "", "In m."])
    ['Add.', '', '.. code-block:: text', '', '    s = |a| + |b|', '', 'In m.']
    """
    sections = (number - 1 for number, line in enumerate(lines) if SECTION.match(line))
    end = next(sections, len(lines))
    paragraphs = "\n".join(lines[:end]).split("\n\n")
    shown = "\n\n".join(map(_paragraph, paragraphs)).split("\n")
    return shown + lines[end:]


def _paragraph(text: str) -> str:
    """Return a paragraph, as code if it is no sentence."""
    if not text.strip() or text.rstrip().endswith(ENDS) or text.startswith((" ", ">>>")):
        return text
    return ".. code-block:: text\n\n" + "\n".join(f"    {line}" for line in text.split("\n"))
