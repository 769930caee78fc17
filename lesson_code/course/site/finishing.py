"""What the pages of the theme lack for readers who cannot see them, put in when they are made."""

from __future__ import annotations

from pathlib import Path

from lesson_code.course.site.search import SCRIPT, write_sentences

NAMES = {
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="All pages">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="This page">',
    '<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">',
    '<div id="search-results"></div>': '<h1>Search</h1>\n<div id="search-results"></div>\n'
    '<script src="_static/search.js" defer></script>\n'
    f'<script src="{SCRIPT}" defer></script>',
}
"""Two landmarks of a kind need names that tell them apart, headings a level, and pages a title; the
search is to answer with sentences."""


def finish(site: Path) -> None:
    """Put the names into all pages of a site, and write what its search answers with."""
    write_sentences(site)
    for page in site.rglob("*.html"):
        text = page.read_text(encoding="utf-8")
        for bare, named in NAMES.items():
            text = text.replace(bare, named)
        page.write_text(text, encoding="utf-8")
