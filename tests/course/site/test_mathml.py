"""Formulas as MathML: none is misread, and the font has a letter for every character."""

from __future__ import annotations

import re
import unicodedata
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import nbformat
import pytest

pytest.importorskip("math_core", reason="needs what builds the pages: pip install -e '.[site]'")

from lesson_code.course.site.mathml import mathml, write_font

ROOT = Path(__file__).parents[3]
FORMULA = re.compile(r"\$\$(.+?)\$\$|\$(.+?)\$", re.DOTALL)
UNSEEN = ("Cf", "Zs")
"""Spaces, and marks that say how a formula is read aloud."""

ITALIC_H = "\N{PLANCK CONSTANT}"
"""Unicode has no other italic h."""


def formulas() -> list[str]:
    """Return all formulas of all notebooks, without their dollar signs."""
    found = []
    for path in sorted((ROOT / "notebooks").glob("*.ipynb")):
        for cell in nbformat.read(path, as_version=4).cells:
            if cell.cell_type == "markdown":
                found += [a or b for a, b in FORMULA.findall(cell.source)]
    return found


def tree_of(tex: str) -> ElementTree.Element:
    """Return a formula's tree; XML knows three of the names that HTML has for characters."""
    named = re.compile(r"&(?!lt;|gt;|amp;)\w+;")
    return ElementTree.fromstring(named.sub(lambda name: unescape(name[0]), mathml(tex)))  # noqa: S314


def italic(letter: str) -> str:
    """Return the letter that a browser draws for a variable of one letter."""
    if letter == "h":
        return ITALIC_H
    for first, start in (("a", 0x1D44E), ("A", 0x1D434), ("\N{GREEK SMALL LETTER ALPHA}", 0x1D6FC)):
        if 0 <= ord(letter) - ord(first) < 26:
            return chr(start + ord(letter) - ord(first))
    return letter


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        (r"e^2", "<msup><mi>e</mi><mn>2</mn></msup>"),
        (r"\tfrac12 m", "<mn>1</mn><mn>2</mn></mfrac><mi>m</mi>"),
        (r"v_1'", "<msubsup><mi>v</mi><mn>1</mn>"),
    ],
)
def test_formula_is_read_as_latex_reads_it(tex: str, expected: str) -> None:
    """A fraction without braces is one digit above and one below, and not twelve above nothing."""
    assert expected in mathml(tex)


def test_formula_that_cannot_be_said_is_refused() -> None:
    """The error names the formula, for whoever wrote it."""
    with pytest.raises(ValueError, match=r"formula must be LaTeX .* got '\\\\nosuch x'"):
        mathml(r"\nosuch x")


def test_every_formula_of_the_notebooks_is_well_formed() -> None:
    """All of them can be said, and each is a tree with one root."""
    trees = [tree_of(tex) for tex in formulas()]
    assert len(trees) > 100
    assert {tree.tag for tree in trees} == {"math"}


def test_font_draws_every_character_of_the_formulas(tmp_path: Path) -> None:
    """No letter falls back on a font without italics or without a place for its index."""
    from fontTools.ttLib import TTFont

    write_font(tmp_path / "math.woff")
    with TTFont(tmp_path / "math.woff") as font:
        drawn = {chr(code) for code in font.getBestCmap()}
        assert "MATH" in font
    used = set()
    for tex in formulas():
        for element in tree_of(tex).iter():
            text = element.text or ""
            used |= {italic(text)} if element.tag == "mi" and len(text) == 1 else set(text)
    assert {
        letter for letter in used - drawn if unicodedata.category(letter) not in UNSEEN
    } == set()
