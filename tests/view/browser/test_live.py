"""Live figures as HTML: one piece, the same each time, with a still picture.

What they do is tried in a browser: ``tests/browser/test_live.py``.
"""

from __future__ import annotations

import base64
import re
from pathlib import Path
from types import ModuleType
from typing import Any

import nbformat
import pytest

from lesson_code.view.browser import lab_still, stills
from lesson_code.view.browser.live import file_of, html_of, live, script_of

ROOT = Path(__file__).parents[3]
FIGURES = stills.names()
FIGURE = "ch03_reflection/bounce"


def shown(monkeypatch: pytest.MonkeyPatch, *given: str) -> dict[str, str]:
    """Return what a call displays."""
    displayed: list[dict[str, str]] = []
    note: Any = lambda data, **_: displayed.append(data)  # noqa: E731
    monkeypatch.setattr("lesson_code.view.browser.live.display", note)
    live(*given)
    return displayed[0]


def test_figure_is_displayed_with_a_still_picture_and_a_text(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where no script runs the picture stands; where there is no HTML the text does."""
    data = shown(monkeypatch, FIGURE, "A wall & a ball.")
    picture = re.search(r'<img alt="A wall &amp; a ball."[^>]*base64,([^"]+)"', data["text/html"])
    assert picture
    still = file_of(FIGURE).with_suffix(".svg").read_text("utf-8")
    assert base64.b64decode(picture[1]).decode() == still
    assert data["text/plain"] == "Live figure: A wall & a ball. (It answers in a browser.)"


def test_figure_is_the_same_each_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """A notebook that is run again has the same output."""
    assert shown(monkeypatch, FIGURE, "A wall.") == shown(monkeypatch, FIGURE, "A wall.")


@pytest.mark.parametrize("figure", FIGURES)
def test_figure_needs_no_other_file(figure: str) -> None:
    """Nothing is imported, fetched by address, or left open for the next figure of a page."""
    html = html_of(figure, "A figure.", "<svg/>")
    assert not re.search(r"^\s*(import|export)\b", html, re.MULTILINE)
    assert "http://www.w3.org/2000/svg" in html
    assert not re.search(r"https?://(?!www\.w3\.org/2000/svg)", html)
    assert html.count("<script") == html.count("</script>") == 1


@pytest.mark.parametrize("figure", FIGURES)
def test_still_picture_is_of_the_script_as_it_is(figure: str) -> None:
    """One that is edited, or whose formulas are, and not drawn again fails here."""
    assert stills.fault(figure) == ""


def test_picture_that_is_missing_or_of_another_script_is_named(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """By its path in the workbook."""
    monkeypatch.setattr("lesson_code.view.browser.live.CHAPTERS", tmp_path / "a" / "chapters")
    monkeypatch.setattr(stills, "CHAPTERS", tmp_path / "a" / "chapters")
    folder = tmp_path / "a" / "chapters" / "ch01"
    folder.mkdir(parents=True)
    (folder / "carts.js").write_text('export default {\n  program: "formulas",\n};\n')
    (folder / "other.js").write_text("// No figure.\n")
    assert stills.drifted(tmp_path) == [
        "a/chapters/ch01/carts.svg: is missing; make it with workbook regenerate"
    ]
    (folder / "carts.svg").write_text(f'<svg data-sum="{stills.sum_of("ch01/carts")}"/>')
    assert stills.drifted(tmp_path) == []
    (folder / "carts.js").write_text('export default {\n  program: "formulas",\n  e: 1,\n};\n')
    assert stills.drifted(tmp_path) == ["a/chapters/ch01/carts.svg: is not what its figure draws"]
    assert stills.drifted(tmp_path / "another") == []


def test_notebook_with_a_figure_as_it_was_is_named(tmp_path: Path) -> None:
    """A notebook holds its figures whole; one that was not made anew shows the old one."""
    (tmp_path / "notebooks").mkdir()
    html = '<figure data-live="{}" style="">'
    cells = [nbformat.v4.new_code_cell(outputs=[_shown(html.format(n))]) for n in ("now", "old")]
    nbformat.write(  # type: ignore[no-untyped-call]
        nbformat.v4.new_notebook(cells=cells), tmp_path / "notebooks" / "03_reflection.ipynb"
    )
    assert stills.old_in_notebooks(tmp_path, stills.IN_NOTEBOOK, {"now", "other"}) == [
        "notebooks/03_reflection.ipynb: holds old as it was; workbook regenerate makes it anew"
    ]


def _shown(html: str) -> Any:
    """Return the output of a cell that shows some HTML."""
    return nbformat.v4.new_output("display_data", data={"text/html": html})


@pytest.mark.parametrize("kind", [stills, lab_still])
def test_committed_notebooks_hold_the_figures_and_the_lab_of_today(kind: ModuleType) -> None:
    """And the check finds them in the files: with other titles, each is called old."""
    assert kind.drifted(ROOT) == []
    assert stills.old_in_notebooks(ROOT, kind.IN_NOTEBOOK, {"another"})


def test_figure_that_is_not_there_is_refused_by_name() -> None:
    """And one without a text."""
    with pytest.raises(ValueError, match=r"such as 'ch03_reflection/bounce', got 'ch03/bounce'"):
        live("ch03/bounce", "A wall.")
    with pytest.raises(ValueError, match="alt must say what the figure shows"):
        live(FIGURE, " ")


def test_figure_without_a_program_is_refused(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Nothing would compute it."""
    monkeypatch.setattr("lesson_code.view.browser.live.CHAPTERS", tmp_path)
    (tmp_path / "carts.js").write_text("export default {};\n")
    with pytest.raises(ValueError, match=r"carts\.js must name its program"):
        script_of("carts")
