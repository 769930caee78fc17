"""Student copies: a solution with the answers taken out, and nothing of them left behind."""

from __future__ import annotations

import ast
import copy
from collections.abc import Mapping
from typing import Any

SOLUTION_ONLY = "solution"
"""Tag of cells that are for the instructor's copy alone."""


def student_notebook(solution: Any, tasks: Mapping[str, str]) -> Any:
    """Return a solution notebook with stubs for answers and without outputs.

    Parameters
    ----------
    solution : notebook
        The solution, executed or not; it is not changed.
    tasks : mapping of str to str
        For each function to write, the number of its task.
    """
    notebook = copy.deepcopy(solution)
    notebook.cells = [
        cell for cell in notebook.cells if SOLUTION_ONLY not in cell.metadata.get("tags", [])
    ]
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.source = student_source(cell.source, tasks)
            cell.outputs = []
            cell.execution_count = None
    return notebook


def student_source(solution: str, tasks: Mapping[str, str]) -> str:
    """Return code with the body of each function to write replaced by a stub.

    Signature and docstring stay; the stub raises NotImplementedError with the task's number.

    Examples
    --------
    >>> print(student_source(chr(10).join(["def f(x):", "    return 2 * x"]), {"f": "9.1"}))
    def f(x):
        raise NotImplementedError("Task 9.1: f")
    """
    lines = solution.splitlines()
    written = [
        statement
        for statement in ast.parse(solution).body
        if isinstance(statement, ast.FunctionDef) and statement.name in tasks
    ]
    for function in reversed(written):
        first, last = _answer_lines(function)
        stub = f'raise NotImplementedError("Task {tasks[function.name]}: {function.name}")'
        lines[first:last] = ["    " + stub]
    return "\n".join(lines) + ("\n" if solution.endswith("\n") else "")


def _answer_lines(function: ast.FunctionDef) -> tuple[int, int]:
    """Return the slice of lines that holds a function's body after its docstring."""
    body = function.body
    has_docstring = ast.get_docstring(function) is not None
    first = body[0].end_lineno if has_docstring else body[0].lineno - 1
    assert first is not None  # noqa: S101 - parsed code has line numbers
    assert function.end_lineno is not None  # noqa: S101 - the same
    return first, function.end_lineno
