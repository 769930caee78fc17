"""What runs in a page's Python: a reader's cells, in order, and then the check of one task.

The check is that of the notebooks; without NumPy, which a page's Python does not have, vectors are
those of :mod:`lesson_code.course.isolation.inside.vectors`.
"""

from __future__ import annotations

import ast
import contextlib
import io
import json
import linecache
import sys
import traceback
from types import ModuleType
from typing import Any

from lesson_code.course.grading import check_task
from lesson_code.course.isolation.inside.vectors import used_modules

MOST_PRINTED = 5_000
"""Characters of what a cell prints that are shown."""

NO_NUMPY = "NumPy is not in this page: write it with x and y, or in the notebook"


class NotHere(ModuleType):
    """Stands in for NumPy: it can be imported, and says where it is used that it is missing."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):  # Python itself asks for these
            raise AttributeError(name)
        raise ImportError(NO_NUMPY)


def checked(cells: str, task: str, function: str) -> str:
    """Return what cells print, what went wrong in them, and the marks for a task.

    Parameters
    ----------
    cells : str
        JSON: a list of pairs, each the cell's name ("your cell 2") and its source. The last one is
        the answer; what those before print is dropped.
    task, function : str
        The task's number, and the name of the function that it asks for.

    Returns
    -------
    str
        JSON: what the last cell ``printed``, and the ``lines`` of the check. A cell that fails ends
        with its traceback, and the check is made all the same.
    """
    names: dict[str, Any] = {"__name__": "__main__"}
    if not used_modules():
        sys.modules["numpy"] = NotHere("numpy")
    printed = ""
    for name, source in json.loads(cells):
        printed = _run(name, source, names)
    lines = [f"{task} {function}: there is no function named {function}"]
    if callable(names.get(function)):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            check_task(task, names[function])
        lines = said.getvalue().splitlines()
    return json.dumps({"printed": printed[:MOST_PRINTED], "lines": lines})


def _run(name: str, source: str, names: dict[str, Any]) -> str:
    """Run a cell as a notebook does: the value of its last line is shown."""
    said = io.StringIO()
    linecache.cache[name] = len(source), None, source.splitlines(keepends=True), name
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        try:
            body = ast.parse(source, name).body
            last = [body.pop()] if body and isinstance(body[-1], ast.Expr) else []
            exec(compile(ast.Module(body, []), name, "exec"), names)  # noqa: S102 - what this is for
            exec(compile(ast.Interactive(list(last)), name, "single"), names)  # noqa: S102
        except (Exception, SystemExit) as error:  # a reader's code may fail in any way
            told = traceback.TracebackException.from_exception(error)
            own = [frame for frame in told.stack if frame.filename.startswith("your ")]
            told.stack[:] = own
            said.write("".join(told.format()))
    return said.getvalue()
