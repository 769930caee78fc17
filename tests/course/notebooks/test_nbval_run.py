"""Notebooks run again: outputs are compared, and what happens is told."""

from __future__ import annotations

from pathlib import Path

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from lesson_code.course.notebooks.nbval_run import CellResult, Watcher, run_notebooks

CHECKED = ["nbval-check-output"]


def printing(
    source: str, printed: str | None, tags: list[str] | None = None
) -> nbformat.NotebookNode:
    """Return a cell that is stored as having printed some text; None: it was never run."""
    if printed is None:
        return new_code_cell(source)
    outputs = [new_output("stream", name="stdout", text=printed)] if printed else []
    return new_code_cell(source, outputs=outputs, execution_count=1, metadata={"tags": tags or []})


def notebook(path: Path, *cells: nbformat.NotebookNode) -> Path:
    """Write a notebook."""
    nbformat.write(new_notebook(cells=list(cells)), path)
    return path


class Log:
    """Remembers what a watcher is told."""

    def __init__(self) -> None:
        self.told: list[object] = []
        self.watcher = Watcher(self.told.append, self.told.append)


@pytest.fixture(scope="module")
def strict(tmp_path_factory: pytest.TempPathFactory) -> tuple[list[CellResult], list[object]]:
    """Run two notebooks once, and return the results and what the watcher was told."""
    folder = tmp_path_factory.mktemp("strict")
    log = Log()
    good = notebook(
        folder / "good.ipynb",
        new_markdown_cell("# Text is no cell to run"),
        printing("x = 2", None),
        printing("print(x)", "2\n"),
    )
    bad = notebook(
        folder / "sub.ipynb",
        printing("print('one')", "two\n"),
        printing("1 / 0", None),
        printing("print('still run')", "still run\n"),
    )
    return run_notebooks([good, bad], watcher=log.watcher), log.told


def test_cells_that_print_what_is_stored_pass(
    strict: tuple[list[CellResult], list[object]],
) -> None:
    """Cells are counted from 0 among the code cells; a passing one has no message."""
    assert strict[0][:2] == [CellResult("good.ipynb", 0, True), CellResult("good.ipynb", 1, True)]


def test_changed_output_fails_and_shows_both(
    strict: tuple[list[CellResult], list[object]],
) -> None:
    """The message holds what is stored and what was printed."""
    changed = strict[0][2]
    assert (changed.notebook, changed.cell, changed.passed) == ("sub.ipynb", 0, False)
    assert "one" in changed.message
    assert "two" in changed.message


def test_error_fails_and_names_it_and_the_next_cell_is_run(
    strict: tuple[list[CellResult], list[object]],
) -> None:
    """One broken cell does not hide whether the others work."""
    broken, after = strict[0][3:]
    assert not broken.passed
    assert "ZeroDivisionError" in broken.message
    assert after == CellResult("sub.ipynb", 2, True)


def test_watcher_is_told_the_counts_first_and_then_each_result(
    strict: tuple[list[CellResult], list[object]],
) -> None:
    """A progress bar knows its length before the first cell is done."""
    results, told = strict
    assert told == [{"good.ipynb": 2, "sub.ipynb": 3}, *results]


def test_lax_run_compares_tagged_cells_only(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without the tag any output will do, but an error never does; the run itself is silent."""
    path = notebook(
        tmp_path / "lax.ipynb",
        printing("print('one')", "two\n"),
        printing("print('one')", "two\n", CHECKED),
        printing("print('one')", "one\n", CHECKED),
        printing("1 / 0", ""),
    )
    results = run_notebooks([path], lax=True)
    assert [result.passed for result in results] == [True, False, True, False]
    assert capsys.readouterr().out == ""


@pytest.mark.full
def test_kernel_that_dies_fails_every_cell_from_there_on(tmp_path: Path) -> None:
    """A student's os._exit(0) is no way to pass; nbval notices when the cell's time is up."""
    path = notebook(
        tmp_path / "dies.ipynb",
        printing("print(1)", "1\n"),
        printing("import os; os._exit(0)", ""),
        printing("print(3)", "3\n"),
    )
    assert [result.passed for result in run_notebooks([path], cell_seconds=1)] == [
        True,
        False,
        False,
    ]


def test_file_that_is_no_notebook_is_an_error_that_names_it(tmp_path: Path) -> None:
    """What cannot be read is not reported as zero cells and all well."""
    path = tmp_path / "broken.ipynb"
    path.write_text("<<<<<<< HEAD", encoding="utf-8")
    with pytest.raises(RuntimeError, match=r"broken\.ipynb"):
        run_notebooks([path])


def test_missing_file_is_an_error_that_names_it(tmp_path: Path) -> None:
    """A file that is not there is not reported as all well either."""
    with pytest.raises(FileNotFoundError, match=r"absent\.ipynb"):
        run_notebooks([tmp_path / "absent.ipynb"])


def test_no_notebooks_give_no_results() -> None:
    """Nothing to run is no error."""
    assert run_notebooks([]) == []


def test_interrupted_run_is_not_taken_for_a_finished_one(tmp_path: Path) -> None:
    """Ctrl-C in the middle ends the command, and not with what was done so far."""
    path = notebook(tmp_path / "long.ipynb", printing("print(1)", "1\n"), printing("2", None))

    def press_ctrl_c(_: object) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_notebooks([path], watcher=Watcher(finished=press_ctrl_c))
