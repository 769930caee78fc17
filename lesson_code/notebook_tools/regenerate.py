"""Everything derived from the sources, made anew or compared with what is committed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from lesson_code.notebook_tools.sources import (
    executed,
    is_solution,
    notebook_from,
    sources,
    text_of,
)
from lesson_code.notebook_tools.student_copy import student_notebook, student_source

TaskNumbers: TypeAlias = Mapping[str, Mapping[str, str]]
"""For each exercise, the number of the task of each function to write."""


@dataclass(frozen=True)
class Derived:
    """A file made from a source: an executed notebook, or the student copy of a solution."""

    path: Path
    source: Path
    student_tasks: Mapping[str, str] | None = None

    def text(self, *, run: bool) -> str:
        """Return what the file should hold; a notebook's outputs only if it may `run`."""
        if self.path.suffix == ".py":
            return student_source(self.source.read_text(encoding="utf-8"), self.student_tasks or {})
        notebook = notebook_from(self.source)
        if self.student_tasks is not None:
            return text_of(student_notebook(notebook, self.student_tasks))
        if run:
            return text_of(executed(notebook, self.path.parent))
        return text_of(notebook)


def derived_files(root: Path, tasks: TaskNumbers) -> Iterator[Derived]:
    """Yield every derived file of a workbook, in the order of chapters."""
    for source, notebook in sources(root):
        yield Derived(notebook, source)
        if is_solution(source):
            yield Derived(root / "exercises" / notebook.name, source, tasks[source.stem])
    for program in sorted((root / "solutions").glob("*.py")):
        yield Derived(root / "exercises" / program.name, program, tasks[program.stem])


def drifted(root: Path, tasks: TaskNumbers) -> list[str]:
    """Return in a line each what is not as its source says, without running anything.

    Outputs are not compared here: the run under nbval does that.
    """
    files = list(derived_files(root, tasks))
    lines = []
    for file in files:
        where = file.path.relative_to(root)
        if not file.path.exists():
            lines.append(f"{where}: is missing; make it with workbook regenerate")
        elif _without_outputs(file.path) != file.text(run=False):
            lines.append(f"{where}: differs from {file.source.relative_to(root)}")
    return lines + [
        f"{path.relative_to(root)}: has no source"
        for folder in ("notebooks", "solutions", "exercises")
        for path in sorted((root / folder).glob("*.ipynb"))
        if path not in {file.path for file in files}
    ]


def _without_outputs(path: Path) -> str:
    """Return what a committed file holds, a notebook's outputs and counts left out."""
    import nbformat

    if path.suffix == ".py":
        return path.read_text(encoding="utf-8")
    notebook: Any = nbformat.read(path, as_version=4)  # type: ignore[no-untyped-call]
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    return text_of(notebook)
