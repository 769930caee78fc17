"""What the search answers with: sentences, by section, without what is no text."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from lesson_code.course.site.search import SCRIPT, sections_of, sentences_in, write_sentences

pytest.importorskip("bs4", reason="needs what builds the pages: pip install -e '.[site]'")

PAGE = """<html><body><nav><p>Not this one here.</p></nav><article><section id="top">
<h1>A title here<a class="headerlink" href="#top">link to this heading</a></h1>
<p>The first sentence. The second  one
is broken.</p><script>var no = "a sentence or so";</script>
<section id="below"><ul><li>An item of <b>three words</b>.</li></ul></section>
</section></article></body></html>"""


def test_sentences_stand_by_their_sections() -> None:
    """Headings, paragraphs, items; without scripts, navigation and the links of headings."""
    assert sections_of(PAGE) == {
        "top": ["A title here", "The first sentence.", "The second one is broken."],
        "below": ["An item of three words."],
    }


def test_page_without_an_article_has_none() -> None:
    """As pages that only lead elsewhere."""
    assert sections_of("<html><body><p>There is nothing here.</p></body></html>") == {}


@pytest.mark.parametrize(
    ("text", "sentences"),
    [
        ("It falls at 9.81 m/s. Then it rests.", ["It falls at 9.81 m/s.", "Then it rests."]),
        ("See Fig. 3 for this one", ["See Fig. 3 for this one"]),
        ("Too short. This is long enough.", ["This is long enough."]),
    ],
)
def test_sentences_end_before_a_capital(text: str, sentences: list[str]) -> None:
    """A number's point ends none, and neither does an abbreviation before a number."""
    assert sentences_in(text) == sentences


def test_script_hands_over_all_pages_but_the_search(tmp_path: Path) -> None:
    """By their names, as JSON."""
    (tmp_path / "_static").mkdir()
    for name in ("one", "search"):
        (tmp_path / f"{name}.html").write_text(PAGE, encoding="utf-8")
    write_sentences(tmp_path)
    text = (tmp_path / SCRIPT).read_text(encoding="utf-8")
    given = json.loads(text.removeprefix("sentencesOfPages(").removesuffix(");\n"))
    assert given == {"one": sections_of(PAGE)}
