"""Everything derived from the sources, made again or compared with what is committed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from lesson_code.course.notebooks.sources import (
    executed,
    is_solution,
    notebook_from,
    sources,
    text_of,
)
from lesson_code.course.notebooks.student_copy import student_notebook, student_program

TaskNumbers: TypeAlias = Mapping[str, Mapping[str, str]]
"""For each exercise, the number of the task of each function to write."""

HOLD_DERIVED_FILES_ONLY = (
    "notebooks/*.ipynb",
    "solutions/*.ipynb",
    "exercises/*.ipynb",
    "exercises/*.py",
)
"""Where every file must have a source."""


@dataclass(frozen=True)
class Derived:
    """A file made from a source: an executed notebook, or the student copy of a solution."""

    path: Path
    source: Path
    student_tasks: Mapping[str, str] | None = None

    def text(self, *, run: bool) -> str:
        """Return what the file should hold; a notebook's outputs only if it may `run`."""
        if self.path.suffix == ".py":
            return student_program(
                self.source.read_text(encoding="utf-8"), self.student_tasks or {}
            )
        notebook = notebook_from(self.source)
        if self.student_tasks is not None:
            return text_of(student_notebook(notebook, self.student_tasks))
        if run:
            return text_of(executed(notebook, self.path.parent))
        return text_of(notebook)

    def write(self) -> None:
        """Write the file, with the same line ends on every machine."""
        self.path.write_text(self.text(run=True), encoding="utf-8", newline="\n")


def derived_files(root: Path, tasks: TaskNumbers) -> Iterator[Derived]:
    """Yield every derived file of a workbook, in the order of chapters.

    Raises
    ------
    ValueError
        A solution answers no exercise.
    """
    for source, notebook in sources(root):
        yield Derived(notebook, source)
        if is_solution(source):
            yield _student_copy(root, source, notebook.name, tasks)
    for program in sorted((root / "solutions").glob("*.py")):
        yield _student_copy(root, program, program.name, tasks)


def _student_copy(root: Path, solution: Path, name: str, tasks: TaskNumbers) -> Derived:
    """Return the student copy of a solution."""
    if solution.stem not in tasks:
        raise ValueError(f"{solution.relative_to(root)}: no exercise has this name")
    return Derived(root / "exercises" / name, solution, tasks[solution.stem])


def fresh_student_copy(root: Path, name: str, tasks: Mapping[str, str]) -> str:
    """Return the text of a student copy, made from the solution and without running anything.

    Parameters
    ----------
    root : Path
        The instructor's workbook.
    name : str
        The exercise, such as "01_one_dimension".
    tasks : mapping of str to str
        For each function to write, the number of its task.

    Raises
    ------
    FileNotFoundError
        The workbook has no solution of this name.
    """
    import nbformat

    program = root / "solutions" / f"{name}.py"
    if program.exists():
        return student_program(program.read_text(encoding="utf-8"), tasks)
    solution: Any = nbformat.read(program.with_suffix(".ipynb"), as_version=4)  # type: ignore[no-untyped-call]
    return text_of(student_notebook(solution, tasks))


def drifted(root: Path, tasks: TaskNumbers) -> list[str]:
    """Return in a line each what is not as its source says, without running anything.

    Outputs of executed notebooks are not compared here: the run under nbval does that.
    """
    files = list(derived_files(root, tasks))
    derived = {file.path for file in files}
    lines = [line for file in files if (line := _fault(file, root))]
    return lines + [
        f"{path.relative_to(root)}: has no source"
        for pattern in HOLD_DERIVED_FILES_ONLY
        for path in sorted(root.glob(pattern))
        if path not in derived
    ]


def _fault(file: Derived, root: Path) -> str:
    """Return what is wrong with a derived file, or "" if nothing is."""
    where = file.path.relative_to(root)
    if not file.path.exists():
        return f"{where}: is missing; make it with workbook regenerate"
    try:
        committed = _committed(file)
    except Exception as error:  # nbformat's reader raises many kinds
        return f"{where}: cannot be read ({error})"
    if committed != file.text(run=False):
        return f"{where}: differs from {file.source.relative_to(root)}"
    return ""


def _committed(file: Derived) -> str:
    """Return what a committed file holds; of an executed notebook, without its outputs."""
    import nbformat

    text = file.path.read_text(encoding="utf-8")
    if file.path.suffix == ".py":
        return text
    notebook: Any = nbformat.reads(text, as_version=4)  # type: ignore[no-untyped-call]
    for cell in notebook.cells:
        if cell.cell_type == "code" and file.student_tasks is None:
            cell.outputs, cell.execution_count = [], None
    return text_of(notebook)
