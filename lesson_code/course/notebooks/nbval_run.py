"""Notebooks run under nbval: every cell again, its output compared with the stored one."""

from __future__ import annotations

import contextlib
import gc
import io
import os
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

CELL_SECONDS = 120
"""A cell that runs longer has gone wrong: whole notebooks take under 20 s."""


@dataclass(frozen=True)
class CellResult:
    """One cell: its notebook, its place among the code cells, and why it failed, if it did."""

    notebook: str
    cell: int
    passed: bool
    message: str = ""


@dataclass
class Watcher:
    """What a run tells while it goes on: how many cells there are, and each cell's result."""

    collected: Callable[[dict[str, int]], None] = lambda _counts: None
    finished: Callable[[CellResult], None] = lambda _result: None


@dataclass(eq=False)  # pytest keeps its plugins in a set
class _Plugin:
    """Listens to pytest and passes on what concerns notebooks' cells."""

    watcher: Watcher
    results: list[CellResult] = field(default_factory=list)
    collect_errors: list[str] = field(default_factory=list)

    def pytest_collection_finish(self, session: Any) -> None:
        counts: dict[str, int] = {}
        for item in session.items:
            notebook = item.nodeid.partition("::")[0]
            counts[notebook] = counts.get(notebook, 0) + 1
        self.watcher.collected(counts)

    def pytest_collectreport(self, report: Any) -> None:
        if report.failed:
            self.collect_errors.append(f"{report.nodeid}: {report.longreprtext}")

    def pytest_runtest_logreport(self, report: Any) -> None:
        if report.when != "call" and not report.failed:
            return
        notebook, _, cell = report.nodeid.partition("::")
        # A cell after one that timed out is not run, and reported as an expected failure.
        passed = report.passed and not hasattr(report, "wasxfail")
        result = CellResult(
            notebook,
            int(cell.rsplit(" ", 1)[-1]),
            passed,
            "" if passed else report.longreprtext,
        )
        self.results.append(result)
        self.watcher.finished(result)


def run_notebooks(
    paths: Sequence[Path],
    *,
    lax: bool = False,
    cell_seconds: int = CELL_SECONDS,
    watcher: Watcher | None = None,
) -> list[CellResult]:
    """Return the result of every code cell of some notebooks.

    Parameters
    ----------
    paths : sequence of Path
        Executed notebooks.
    lax : bool
        Compare only the outputs of cells that are tagged ``nbval-check-output``.
    cell_seconds : int
        A cell that runs longer fails, and so do those after it.
    watcher : Watcher, optional
        Receives the number of cells and each result.

    Raises
    ------
    FileNotFoundError
        There is no such notebook.
    RuntimeError
        A notebook could not be read, or the run did not come to its end.
    KeyboardInterrupt
        Ctrl-C was pressed.
    """
    import pytest

    if not paths:
        return []
    for path in paths:
        if not path.is_file():
            raise FileNotFoundError(f"{path}: there is no such notebook")
    plugin = _Plugin(watcher or Watcher())
    code, written = _run_pytest([*_arguments(paths, lax, cell_seconds), *map(str, paths)], plugin)
    if plugin.collect_errors:
        raise RuntimeError("\n".join(plugin.collect_errors))
    if code == pytest.ExitCode.INTERRUPTED:
        raise KeyboardInterrupt
    if code in (pytest.ExitCode.USAGE_ERROR, pytest.ExitCode.INTERNAL_ERROR):
        raise RuntimeError(f"the notebooks could not be run:\n{written}")
    return plugin.results


def _arguments(paths: Sequence[Path], lax: bool, cell_seconds: int) -> list[str]:
    """Return pytest's options: the configuration of a project around is left alone."""
    return [
        "-c",
        os.devnull,
        "--rootdir",
        os.path.commonpath([path.resolve().parent for path in paths]),
        "-p",
        "no:cacheprovider",
        "-p",
        "no:unraisableexception",
        "--color=no",
        "--capture=no",
        "--nbval-lax" if lax else "--nbval",
        "--nbval-current-env",
        f"--nbval-cell-timeout={cell_seconds}",
    ]


def _run_pytest(arguments: list[str], plugin: _Plugin) -> tuple[int, str]:
    """Run pytest in this process; return its exit code and what it wrote."""
    import pytest

    # nbval needs pytest's own reporter, so that is kept, and what it writes goes nowhere.
    with contextlib.redirect_stdout(io.StringIO()) as written, warnings.catch_warnings():
        # nbval leaves a file open for each kernel.
        warnings.simplefilter("ignore", ResourceWarning)
        code = pytest.main(arguments, plugins=[plugin])
        gc.collect()
    return int(code), written.getvalue()
