"""What the search answers with: the sentences of all pages, section by section, as a script.

A page from a folder may not read other pages, so the theme's own search shows titles only.
``search.js`` puts below each title the sentence that answers best.
"""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, TypeAlias

Sections: TypeAlias = dict[str, list[str]]
"""The sentences of a page by the anchor of their section; the page's own is ""."""

SCRIPT = "_static/sentences.js"
TEXTS = ["p", "li", "dd", "td", "h1", "h2", "h3"]
"""Elements with text of their own."""

SILENT = ["script", "style", "svg", "button", "nav", "form", "annotation", "figure"]
"""Elements whose text is no sentence."""

END = re.compile(r"(?<=[.?!:])\s+(?=[A-Z])")
"""Between two sentences."""

FEWEST_WORDS = 3


def write_sentences(site: Path) -> None:
    """Write the sentences of a site's pages beside them."""
    pages = {
        path.relative_to(site).with_suffix("").as_posix(): sections_of(path.read_text("utf-8"))
        for path in sorted(site.rglob("*.html"))
        if path.stem != "search"
    }
    text = f"sentencesOfPages({json.dumps(pages, ensure_ascii=False, separators=(',', ':'))});\n"
    (site / SCRIPT).write_text(text, encoding="utf-8")


def sections_of(page: str) -> Sections:
    """Return the sentences of a page that have some words, section by section."""
    from bs4 import BeautifulSoup

    article: Any = BeautifulSoup(page, "html.parser").find("article")
    found: Sections = {}
    if article is None:
        return found
    for silent in article(SILENT):
        silent.decompose()
    for link in article("a", class_="headerlink"):
        link.decompose()
    for element in article(TEXTS):
        if element.find(TEXTS) is None:
            section = element.find_parent("section")
            said = found.setdefault(section.get("id", "") if section else "", [])
            said += sentences_in(element.get_text())
    return found


def sentences_in(text: str) -> list[str]:
    """Return the sentences of a text that have some words."""
    parts = END.split(" ".join(text.split()))
    return [part for part in parts if len(part.split()) >= FEWEST_WORDS]
