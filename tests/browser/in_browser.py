"""Chromium and JupyterLab, driven by Playwright."""

from __future__ import annotations

import json
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import nbformat
from nbformat.sign import NotebookNotary

from lesson_code.course.notebooks import server
from lesson_code.course.quiz.bank import load_quiz
from lesson_code.course.quiz.questions import Question

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page

SETTINGS: dict[str, dict[str, Any]] = {
    # All cells stand in the page, also those that are not in sight.
    "@jupyterlab/notebook-extension/tracker": {"windowingMode": "none"},
    "@jupyterlab/apputils-extension/notification": {"fetchNews": "false", "checkForUpdates": False},
}
"""JupyterLab's, by plugin."""

KERNEL_STARTS = 60_000
"""ms: a kernel answers after 3 to 8 s, on a machine that is busy later."""

NOTEBOOK_RUNS = 300_000
"""ms: a notebook runs for some seconds, a few of them for half a minute."""


IDLE = "Python 3 (ipykernel) | Idle"
"""What JupyterLab says of a kernel that has nothing to do."""

MOVES = """figure => {
    const slider = figure.querySelector("input[type=range]");
    const drawing = figure.querySelector("svg > g");
    const before = drawing.innerHTML;
    for (const value of [slider.min, slider.max]) {
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
        if (drawing.innerHTML !== before) return true;
    }
    return false;
}"""
"""In the page: whether a figure draws itself anew when its first slider is moved."""

ALL_HAVE_RUN = r"""() => {
    const prompts = [...document.querySelectorAll(
        ".jp-Notebook .jp-CodeCell:not(:has(.jp-InputPlaceholder)) .jp-InputPrompt")];
    return prompts.length && prompts.every((prompt) => /\[\d+\]/.test(prompt.textContent));
}"""
"""In the page: whether every prompt holds a number, and none is empty or a star.

A folded cell shows no prompt. If the last one is folded, only the kernel tells that it has run.
"""


@contextmanager
def jupyterlab(root: Path) -> Iterator[JupyterLab]:
    """Serve a workbook in JupyterLab with settings of its own, and stop it afterwards."""
    with tempfile.TemporaryDirectory(prefix="workbook-lab-") as folder:
        for plugin, settings in SETTINGS.items():
            file = Path(folder) / "lab" / "user-settings" / f"{plugin}.jupyterlab-settings"
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(json.dumps(settings), encoding="utf-8")
        running = server.start(root, Path("notebooks"), config=Path(folder))
        try:
            yield JupyterLab(root, running.address)
        finally:
            running.stop()


@dataclass(frozen=True)
class JupyterLab:
    """A running JupyterLab: its workbook, and the address at which the notebooks open."""

    root: Path
    address: str

    def open(self, page: Page, notebook: str) -> LabNotebook:
        """Open a notebook, "notebooks/02_restitution.ipynb", and wait for its kernel."""
        self.show(page, notebook)
        page.get_by_text(IDLE).wait_for(timeout=KERNEL_STARTS)
        return LabNotebook(page)

    def show(self, page: Page, notebook: str) -> None:
        """Open a notebook, and do not wait for its kernel."""
        page.goto(self.address.replace("/tree/notebooks", f"/tree/{notebook}") + "&reset")
        page.locator(".jp-Notebook .jp-Cell:visible").first.wait_for(timeout=KERNEL_STARTS)

    def trust(self, notebook: str) -> None:
        """Sign a notebook, as Jupyter does when a reader has run and saved it; open its answers."""
        path = self.root / notebook
        opened: Any = nbformat.read(path, as_version=4)  # type: ignore[no-untyped-call]
        for cell in opened.cells:
            cell.metadata.pop("jupyter", None)
        nbformat.write(opened, path)
        NotebookNotary().sign(opened)

    def end_kernels(self, page: Page) -> None:
        """End all kernels that run."""
        place, token = self.address.split("/lab/")[0], self.address.split("token=")[1]
        headers = {"Authorization": f"token {token}"}
        for session in page.request.get(f"{place}/api/sessions", headers=headers).json():
            page.request.delete(f"{place}/api/sessions/{session['id']}", headers=headers)


@dataclass(frozen=True)
class LabNotebook:
    """A notebook that is open in JupyterLab, and the page it is in."""

    page: Page

    @property
    def errors(self) -> Locator:
        """The tracebacks in all outputs."""
        return self.page.locator('[data-mime-type="application/vnd.jupyter.error"]')

    def run_all(self) -> None:
        """Run all cells and wait for the last one, and for the kernel."""
        self._choose("Edit", "Clear Outputs of All Cells")
        self._choose("Run", "Run All Cells")
        self.page.wait_for_function(ALL_HAVE_RUN, timeout=NOTEBOOK_RUNS)
        self.page.get_by_text(IDLE).wait_for(timeout=NOTEBOOK_RUNS)

    def _choose(self, menu: str, entry: str) -> None:
        """Choose an entry of a menu."""
        self.page.get_by_role("menuitem", name=menu, exact=True).click()
        self.page.get_by_role("menuitem", name=entry, exact=True).click()


def figures_in(notebook: Path) -> int:
    """Return how many live figures the outputs of a notebook hold."""
    cells = nbformat.read(notebook, as_version=4).cells  # type: ignore[no-untyped-call]
    outputs = [output for cell in cells for output in cell.get("outputs", ())]
    return sum("<figure data-live=" in o.get("data", {}).get("text/html", "") for o in outputs)


def code_of(notebook: Path) -> str:
    """Return the code of a notebook."""
    cells = nbformat.read(notebook, as_version=4).cells  # type: ignore[no-untyped-call]
    return "\n".join(cell.source for cell in cells if cell.cell_type == "code")


def predictions_in(notebook: Path) -> list[Question]:
    """Return what a notebook asks its reader to predict; a part asks some of its chapter's."""
    code = code_of(notebook)
    known = load_quiz(notebook.name[:2]).predictions
    return [question for question in known if f'predict("{question.id}")' in code]


def expect_all_alive(page: Page, count: int) -> None:
    """Hold a page to have so many live figures, each of which answers to its first slider.

    In a page some stand in an answer that is still closed.
    """
    assert count > 0
    figures = page.locator("figure[data-live][data-ready]")
    figures.nth(count - 1).wait_for(state="attached", timeout=KERNEL_STARTS)
    assert figures.count() == count
    assert [figures.nth(k).evaluate(MOVES) for k in range(count)] == [True] * count
