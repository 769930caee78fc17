"""Student copies: a solution with the answers taken out, and nothing of them left behind."""

from __future__ import annotations

import ast
import copy
import io
import tokenize
from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any, TypeAlias

Function: TypeAlias = ast.FunctionDef | ast.AsyncFunctionDef

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

    Raises
    ------
    ValueError
        A function to write is not defined where it can be taken out.
    """
    return _handed_out(solution, tasks, lambda source: student_source(source, tasks))


def marked_notebook(solution: Any, tasks: Mapping[str, str], begin: str, end: str) -> Any:
    """Return a solution notebook without outputs, its answers marked as in `marked_source`."""
    return _handed_out(solution, tasks, lambda source: marked_source(source, tasks, begin, end))


def _handed_out(solution: Any, tasks: Mapping[str, str], form: Callable[[str], str]) -> Any:
    """Return a solution notebook without what is the instructor's alone, its code in some form."""
    notebook = copy.deepcopy(solution)
    notebook.cells = [
        cell for cell in notebook.cells if SOLUTION_ONLY not in cell.metadata.get("tags", [])
    ]
    code_cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    _require_all((cell.source for cell in code_cells), tasks)
    for cell in code_cells:
        cell.source = form(cell.source)
        cell.outputs = []
        cell.execution_count = None
    return notebook


def student_program(solution: str, tasks: Mapping[str, str]) -> str:
    """Return a solution program with stubs for answers; see :func:`student_notebook`."""
    _require_all([solution], tasks)
    return student_source(solution, tasks)


def student_source(solution: str, tasks: Mapping[str, str]) -> str:
    """Return code with the body of each function to write replaced by a stub.

    Decorators, signature and docstring stay; the stub raises NotImplementedError with the
    task's number. Comments of the body go with it.

    Examples
    --------
    >>> print(student_source(chr(10).join(["def f(x):", "    return 2 * x"]), {"f": "9.1"}))
    def f(x):
        raise NotImplementedError("Task 9.1: f")
    """

    def stub(function: Function, _body: list[str]) -> list[str]:
        number = tasks[function.name]
        return [f'    raise NotImplementedError("Task {number}: {function.name}")']

    return _with_bodies(solution, tasks, stub)


def marked_source(solution: str, tasks: Collection[str], begin: str, end: str) -> str:
    """Return code with a line before and after the body of each function to write.

    Examples
    --------
    >>> code = chr(10).join(["def f(x):", '    "Double."', "    return 2 * x"])
    >>> print(marked_source(code, ["f"], "# from", "# to"))
    def f(x):
        "Double."
        # from
        return 2 * x
        # to
    """
    return _with_bodies(solution, tasks, lambda _, body: [f"    {begin}", *body, f"    {end}"])


def _with_bodies(
    solution: str,
    tasks: Collection[str],
    instead: Callable[[Function, list[str]], list[str]],
) -> str:
    """Return code with other lines in place of each body, below signature and docstring."""
    solution = io.StringIO(solution, newline=None).read()  # line ends become \n
    lines = solution.split("\n")
    for function in reversed(_answers(solution, tasks)):
        before = [*_signature(function, lines), *_docstring(function, solution)]
        begin, end = function.lineno - 1, _end(function, lines)
        lines[begin:end] = [*before, *instead(function, lines[begin + len(before) : end])]
    return "\n".join(lines)


def _answers(solution: str, tasks: Collection[str]) -> list[Function]:
    """Return the functions to write that stand at the top level of some code, in their order."""
    return [
        statement
        for statement in ast.parse(solution).body
        if isinstance(statement, Function) and statement.name in tasks
    ]


def _require_all(sources: Iterable[str], tasks: Mapping[str, str]) -> None:
    """Refuse a solution in which an answer would be overlooked, and so left to the student."""
    found = {function.name for source in sources for function in _answers(source, tasks)}
    for name in tasks:
        if name not in found:
            raise ValueError(f"solution must define {name} with def, not indented; it does not")


def _signature(function: Function, lines: list[str]) -> list[str]:
    """Return the lines of a function from its ``def`` to the colon that ends the signature."""
    code = lines[function.lineno - 1 : function.end_lineno]
    depth = 0
    for token in tokenize.generate_tokens(io.StringIO("\n".join(code)).readline):
        if token.type == tokenize.OP:
            depth += (token.string in "([{") - (token.string in ")]}")
            if token.string == ":" and depth == 0:
                break
    row, column = token.end
    return [*code[: row - 1], code[row - 1][:column]]


def _docstring(function: Function, solution: str) -> list[str]:
    """Return the lines of a function's docstring as they are written; none without one."""
    first = function.body[0]
    if ast.get_docstring(function) is None or not isinstance(first, ast.Expr):
        return []
    written = ast.get_source_segment(solution, first.value)
    return f"    {written}".split("\n")


def _end(function: Function, lines: list[str]) -> int:
    """Return the number of a function's last line, indented comments after it included."""
    end = last = function.end_lineno or function.lineno
    for number, line in enumerate(lines[end:], start=end + 1):
        if line.startswith((" ", "\t")) and line.lstrip().startswith("#"):
            last = number
        elif line.strip():
            break
    return last
