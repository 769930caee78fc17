"""Formulas in the page as MathML: browsers show it without a script, and screen readers read it."""

from __future__ import annotations

from importlib.metadata import distribution
from pathlib import Path
from typing import Any

FONT = "ziamath/fonts/STIXTwoMath-Regular.ttf"
"""A file of the distribution ziamath. Browsers take roots and brackets from a font made for
formulas, and not every machine has one. STIX Two is under the SIL Open Font License."""

KEPT = (
    "20-7E A0-FF 370-3FF 2000-206F 210E 2190-22FF 2308-230B 27E8-27E9 27F5-27FF "
    "1D400-1D503 1D6A4-1D71B"
)
"""The characters that formulas may use: Latin, Greek, operators, arrows, and letters in italics."""


def mathml(tex: str, display: bool = False) -> str:
    r"""Return a formula as MathML.

    Parameters
    ----------
    tex : str
        The formula as LaTeX, without dollar signs.
    display : bool
        Whether it stands on a line of its own.

    Raises
    ------
    ValueError
        The formula holds something that has no form in MathML here.
    """
    from math_core import LatexError, LatexToMathML

    try:
        return str(LatexToMathML().convert_with_local_state(tex, displaystyle=display))
    except LatexError as error:
        raise ValueError(
            f"formula must be LaTeX that MathML can say, got {tex!r}: {error}"
        ) from None


def write_font(file: Path) -> None:
    """Write the font of formulas as a WOFF file, with the characters that they may use."""
    from fontTools import subset

    options = subset.Options(flavor="woff")
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=subset.parse_unicodes(KEPT))
    with subset.load_font(str(distribution("ziamath").locate_file(FONT)), options) as font:
        subsetter.subset(font)
        subset.save_font(font, file, options)


def setup(app: Any) -> dict[str, bool]:
    """Tell Sphinx, whose extension this is, how a formula is written."""
    app.add_html_math_renderer(
        "mathml", inline_renderers=(_inline, None), block_renderers=(_block, None)
    )
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def _inline(writer: Any, node: Any) -> None:
    """Write a formula within a line."""
    from docutils.nodes import SkipNode

    writer.body.append(mathml(node.astext()))
    raise SkipNode


def _block(writer: Any, node: Any) -> None:
    """Write a formula that stands alone."""
    from docutils.nodes import SkipNode

    writer.body.append(f'<div class="formula">{mathml(node.astext(), display=True)}</div>\n')
    raise SkipNode
