"""Builds the site: writes Sphinx's sources from the workbook, and lets Sphinx make the pages."""

from __future__ import annotations

import importlib.util
import io
import shutil
import tempfile
import warnings
from collections.abc import Iterable, Mapping
from importlib.resources import as_file, files
from pathlib import Path
from typing import Any

from lesson_code.course.fresh_copies import Files
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.notebooks.root import how_to_install
from lesson_code.course.site.api_pages import MODULES, write_api_pages
from lesson_code.course.site.finishing import finish
from lesson_code.course.site.front_pages import PAGES, TITLE, exercise_list, front_page, lab_page
from lesson_code.course.site.mathml import write_font
from lesson_code.course.site.notebook_page import NotebookPage
from lesson_code.course.site.page_exercises import exercise_page as page_to_answer
from lesson_code.course.site.page_exercises import offered, python_script
from lesson_code.course.site.pyodide import BESIDE, PUBLIC, NoPyodideError, copy_pyodide

NEEDS = ("sphinx", "furo", "myst_nb", "math_core", "ziamath")
"""What builds the pages, by import name."""

MARK = ".buildinfo"
"""A file that Sphinx leaves in what it has built."""

SCRIPTS = ("scrolling.js",)

SETTINGS: dict[str, Any] = {
    "project": TITLE,
    "html_title": TITLE,
    "author": "",
    "copyright": "",
    "extensions": [
        "myst_nb",
        "sphinx.ext.autodoc",
        "sphinx.ext.napoleon",
        "lesson_code.course.site.docstrings",
        "lesson_code.course.site.mathml",
    ],
    "autodoc_typehints": "none",  # the docstrings say what may be given
    "autodoc_default_options": {"members": True},
    "napoleon_google_docstring": False,
    "napoleon_use_ivar": True,
    "napoleon_use_rtype": False,
    "exclude_patterns": ["downloads"],
    "nb_execution_mode": "off",
    "nb_code_prompt_show": "Show the code",
    "nb_code_prompt_hide": "Hide the code",
    "myst_enable_extensions": ["dollarmath"],
    "html_math_renderer": "mathml",
    "html_theme": "furo",
    "html_favicon": "_static/icon.svg",
    "html_static_path": ["_static"],
    "html_extra_path": ["downloads"],
    "html_css_files": ["site.css"],
    "html_js_files": [(name, {"defer": "defer"}) for name in SCRIPTS],
    "html_copy_source": False,
    "html_use_index": False,
    "html_show_sphinx": False,
    "html_show_search_summary": False,  # it would read other pages, which a folder does not let it
    "html_show_copyright": False,
}
"""Sphinx's, in place of a conf.py. With them no page asks the network for anything."""


class SiteError(RuntimeError):
    """The site cannot be built; the message says what is missing or wrong."""


class MissingToolsError(SiteError):
    """What builds the pages is not installed."""


def build(root: Path, site: Path, *, lab: str = "", pyodide: Path | None = None) -> int:
    """Make the workbook's pages.

    Parameters
    ----------
    root : Path
        The workbook.
    site : Path
        The folder for the pages: a new one, an empty one, or a site that was built before. Files
        of the latter that are made again are replaced; others stay.
    lab : str, optional
        The collision lab as HTML, for the home page and a page of its own.
    pyodide : Path, optional
        The npm package ``pyodide``, whose files the site then holds. By default the pages load them
        from the public network, when an answer is run.

    Returns
    -------
    int
        How many pages there are.

    Raises
    ------
    SiteError
        Sphinx is not installed or finds a fault, or a folder holds something else.
    """
    _require_tools()
    _require_own(site)
    notebooks = sorted((root / "notebooks").glob("*.ipynb"))
    with tempfile.TemporaryDirectory(prefix="workbook-site-") as folder:
        pages = offered(root)
        _write_sources(root, Path(folder), notebooks, lab, pages)
        _write_exercises(root, Path(folder), pages, pyodide)
        _run_sphinx(Path(folder), site)
    finish(site)
    return len(notebooks) + len(PAGES) + len(MODULES) + len(pages) + 2 + bool(lab)


def missing_tools() -> list[str]:
    """Return what of the tools that build the pages is not installed."""
    return [name for name in NEEDS if importlib.util.find_spec(name) is None]


def _require_tools() -> None:
    """Say what to install if something is missing."""
    if missing := missing_tools():
        raise MissingToolsError(f"{', '.join(missing)} not installed: {how_to_install('site')}")


def _require_own(site: Path) -> None:
    """Refuse a folder that holds something else than a site."""
    if site.exists() and not site.is_dir():
        raise SiteError(f"the site's folder must be a folder, got the file {site}")
    if site.is_dir() and any(site.iterdir()) and not (site / MARK).is_file():
        raise SiteError(f"the site's folder must be new, empty or a site, got {site} with files")


def _write_sources(
    root: Path,
    folder: Path,
    notebooks: Iterable[Path],
    lab: str,
    pages: Mapping[Exercise, Files],
) -> None:
    """Write what Sphinx reads."""
    import nbformat

    with as_file(files("lesson_code.course.site")) as ours:
        shutil.copytree(ours / "assets", folder / "_static")
        shutil.copytree(ours / "pages", folder / "pages")
    write_font(folder / "_static" / "math.woff")
    downloads = folder / "downloads" / "exercises"
    shutil.copytree(root / "exercises", downloads, ignore=shutil.ignore_patterns(".*", "_*"))
    shutil.make_archive(str(downloads), "zip", downloads.parent, "exercises")
    (folder / "notebooks").mkdir()
    read: list[tuple[str, Any]] = [
        (path.stem, nbformat.read(path, as_version=4))  # type: ignore[no-untyped-call]
        for path in notebooks
    ]
    answered = {exercise.name for exercise in pages}
    for name, notebook in read:
        page = NotebookPage(name, folder, answered).page_of(notebook)
        text = nbformat.writes(page)  # type: ignore[no-untyped-call]
        (folder / "notebooks" / f"{name}.ipynb").write_text(text, encoding="utf-8")
    reference = write_api_pages(folder)
    readme = root / "README.md"
    told = readme.read_text(encoding="utf-8") if readme.is_file() else ""
    (folder / "index.md").write_text(front_page(read, reference, lab, told), encoding="utf-8")
    if lab:
        (folder / "lab.md").write_text(lab_page(lab), encoding="utf-8")


def _write_exercises(
    root: Path, folder: Path, pages: Mapping[Exercise, Files], pyodide: Path | None
) -> None:
    """Write the pages in which exercises are answered, and the list of all exercises."""
    scripts = folder / "_static" / "exercises"
    for place in (scripts, folder / "exercises"):
        place.mkdir(exist_ok=True)
    if pyodide is not None:
        try:
            copy_pyodide(pyodide, folder / "_static" / BESIDE)
        except NoPyodideError as error:
            raise SiteError(str(error)) from error
    address = PUBLIC if pyodide is None else f"../_static/{BESIDE}/"
    for exercise, part in pages.items():
        text = page_to_answer(exercise, root, address)
        (folder / "exercises" / f"{exercise.name}.md").write_text(text, encoding="utf-8")
        (scripts / f"{exercise.name}.js").write_text(python_script(part), encoding="utf-8")
    (folder / "exercises.md").write_text(exercise_list(root, pages), encoding="utf-8")


def _run_sphinx(sources: Path, site: Path) -> None:
    """Let Sphinx make the pages; a warning is an error."""
    from sphinx.application import Sphinx
    from sphinx.errors import SphinxError
    from sphinx.util.docutils import docutils_namespace, patch_docutils

    found = io.StringIO()
    try:
        with patch_docutils(), docutils_namespace(), warnings.catch_warnings():
            # What Sphinx's extensions call that Sphinx will drop one day is their business.
            warnings.simplefilter("ignore", DeprecationWarning)
            warnings.simplefilter("ignore", PendingDeprecationWarning)
            app = Sphinx(
                sources,
                confdir=None,
                outdir=site,
                doctreedir=sources / ".trees",
                buildername="html",
                confoverrides=SETTINGS,
                status=None,
                warning=found,
            )
            app.build(force_all=True)
    except SphinxError as error:
        raise SiteError(f"Sphinx found a fault: {error}") from error
    if app.statuscode or found.getvalue():
        raise SiteError(f"Sphinx found a fault:\n{found.getvalue()}")
