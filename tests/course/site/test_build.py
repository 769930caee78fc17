"""The site as files: where it may go, what it needs, and what is in it."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook

from lesson_code.course.site import build as building
from lesson_code.course.site.api_pages import MODULES
from lesson_code.course.site.build import MissingToolsError, SiteError, build
from lesson_code.course.site.front_pages import PAGES

ROOT = Path(__file__).parents[3]
NEEDS_TOOLS = pytest.mark.skipif(
    bool(building.missing_tools()), reason="needs what builds the pages: pip install -e '.[site]'"
)
PYTHON = {"language_info": {"name": "python"}}


@pytest.fixture
def tiny(tmp_path: Path) -> Path:
    """Return a workbook of one short notebook and one exercise."""
    root = tmp_path / "workbook"
    (root / "notebooks").mkdir(parents=True)
    (root / "exercises").mkdir()
    (root / "exercises" / "00_tiny.ipynb").write_text("{}", encoding="utf-8")
    cells = [
        new_markdown_cell(
            "# 00 Tiny\n\n**After this notebook you will be able to**\n\n1. count.\n\n**Time:** no."
        ),
        new_markdown_cell(
            "## One\n\nA formula: $e^2$. Now the [exercise](../exercises/00_tiny.ipynb)."
        ),
        new_code_cell("print('one')"),
    ]
    nbformat.write(new_notebook(cells=cells, metadata=PYTHON), root / "notebooks" / "00_tiny.ipynb")
    return root


def test_missing_tools_are_named_with_the_command_that_installs_them(
    monkeypatch: pytest.MonkeyPatch, tiny: Path
) -> None:
    """Whoever installed the lean package learns what to type."""
    monkeypatch.setattr(building, "NEEDS", ("sphinx_of_thebes",))
    with pytest.raises(
        MissingToolsError, match=r'sphinx_of_thebes not .*pip install -e "\.\[site\]"'
    ):
        build(tiny, tiny / "site")


@NEEDS_TOOLS
def test_folder_with_other_files_is_left_alone(tiny: Path) -> None:
    """Nobody's files are mixed with a site, or overwritten by one."""
    (tiny / "mine").mkdir()
    (tiny / "mine" / "index.html").write_text("mine", encoding="utf-8")
    with pytest.raises(SiteError, match="must be new, empty or a site"):
        build(tiny, tiny / "mine")
    assert (tiny / "mine" / "index.html").read_text(encoding="utf-8") == "mine"


@NEEDS_TOOLS
def test_file_in_place_of_the_folder_is_refused(tiny: Path) -> None:
    """The error names it."""
    (tiny / "site").write_text("mine", encoding="utf-8")
    with pytest.raises(SiteError, match="must be a folder, got the file"):
        build(tiny, tiny / "site")


@pytest.mark.full
@NEEDS_TOOLS
def test_link_that_leads_nowhere_is_an_error(tiny: Path) -> None:
    """What Sphinx only warns of is said, with its place."""
    notebook = new_notebook(cells=[new_markdown_cell("# 01 Lost\n\n[there](09_nowhere.ipynb)")])
    nbformat.write(notebook, tiny / "notebooks" / "01_lost.ipynb")
    with pytest.raises(SiteError, match="09_nowhere"):
        build(tiny, tiny / "site")


@NEEDS_TOOLS
def test_site_holds_pages_exercises_and_nothing_of_the_solutions(tiny: Path) -> None:
    """Front page, chapter, exercises, search; built a second time in the same place too."""
    (tiny / "solutions").mkdir()
    (tiny / "solutions" / "00_tiny.ipynb").write_text("{}", encoding="utf-8")
    site = tiny / "site"
    assert build(tiny, site) == build(tiny, site) == 3 + len(PAGES) + len(MODULES)
    handbook = [f"pages/{name}" for name in PAGES] + [f"api/{name}" for name in MODULES]
    for page in ("index", "exercises", "search", "notebooks/00_tiny", *handbook):
        assert (site / f"{page}.html").is_file()
    reference = (site / "api" / "lesson_code.formulas.html").read_text(encoding="utf-8")
    assert 'id="lesson_code.formulas.reflect"' in reference
    assert (site / "exercises" / "00_tiny.ipynb").read_text(encoding="utf-8") == "{}"
    assert not [path for path in site.rglob("*") if "solution" in path.name]
    chapter = (site / "notebooks" / "00_tiny.html").read_text(encoding="utf-8")
    assert "<msup><mi>e</mi><mn>2</mn></msup>" in chapter
    assert '<a href="../exercises/00_tiny.ipynb" download>exercise</a>' in chapter
    assert "count." in (site / "index.html").read_text(encoding="utf-8")
