"""Exercises that are written, checked and hinted in a page: its text, and the Python behind it.

The checks are those of a student's copy (:mod:`lesson_code.course.grading.practice`), the code that
marks is the very code of the notebooks. An exercise is offered if nothing that marks it needs
NumPy; there is no list to keep. ``exercise.js`` does the rest, ``in_page.py`` runs in its Python.
"""

from __future__ import annotations

import ast
import base64
import json
from collections.abc import Mapping
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import Any

from lesson_code.course.fresh_copies import Files, zipped
from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.notebooks.root import home
from lesson_code.course.release.bundle import practice_modules
from lesson_code.course.site import in_page
from lesson_code.course.site.pyodide import FILES, LOCK, MEGABYTES, PUBLIC

HOW = """- Replace the `raise` line of a function with your answer, and press **Check**. It is
  called with new numbers each time.
- What you print is shown. Helper functions may stand beside an answer.
- Your answers stay in this browser. Take them along as a file: `workbook grade` marks it.
"""

NO_NUMPY = """- There is no NumPy in this page. The vectors you are given can be added, multiplied
  by numbers and, with `@`, by each other. To use NumPy, take the notebook.
"""

ENTRY = in_page.__name__


def offered(root: Path) -> dict[Exercise, Files]:
    """Return the exercises that a page can check, each with the part of the package that does it.

    Those of a workbook's chapters for which that part needs no NumPy.
    """
    there = [e for e in exercises() if e.chapter.number and e.student_copy(root).is_file()]
    found = {exercise: files_of(exercise) for exercise in there}
    return {
        exercise: files
        for exercise, files in found.items()
        if not any(_imports_numpy(path, text.decode()) for path, text in files.items())
    }


def files_of(exercise: Exercise) -> Files:
    """Return the part of the package that checks an exercise, by path.

    That is its practice checks, what runs in a page, and all that these import.
    """
    used = dict(practice_modules(home(), [exercise]))
    whole = [e for e in exercises() if f"lesson_code/chapters/{e.chapter.folder}/tasks.py" in used]
    practice = dict(practice_modules(home(), whole))
    texts = {path: text for path, text in practice.items() if path.endswith(".json")}
    waiting = [_path(ENTRY), *(path for path in practice if path.endswith(".py"))]
    while waiting:
        path = waiting.pop()
        if path in texts or not (path in practice or (home() / path).is_file()):
            continue
        texts[path] = practice.get(path) or (home() / path).read_text("utf-8")
        waiting += [_path(name) for name in _imported(path, texts[path])]
        waiting += [(parent / "__init__.py").as_posix() for parent in Path(path).parents]
    return {path: text.encode() for path, text in sorted(texts.items())}


def python_script(files: Files) -> str:
    """Return a script that hands a part of the package to the page, as a zip in base 64."""
    packed = base64.b64encode(zipped(files)).decode()
    return f'workbookPython("{packed}");\n'


def exercise_page(exercise: Exercise, root: Path, pyodide: str = PUBLIC) -> str:
    """Return the source of an exercise's page.

    Parameters
    ----------
    exercise : Exercise
        What is to be written.
    root : Path
        The workbook that holds the student's copy.
    pyodide : str
        Where the page loads Python from; an address that ends in a slash.
    """
    text = exercise.student_copy(root).read_text(encoding="utf-8")
    notebook = json.loads(text)
    cells = enumerate(notebook["cells"], start=1)
    parts = [part for number, cell in cells if (part := _part(number, cell, exercise))]
    parts[0] = _opening(parts[0], uses_numpy="import numpy" in text)
    told = {"name": exercise.name, "points": exercise.points, "notebook": notebook}
    told |= {"pyodide": pyodide, "files": FILES, "lock": LOCK, "megabytes": MEGABYTES}
    data = json.dumps(told | {"entry": ENTRY}).replace("<", "\\u003c")
    return "\n\n".join([*parts, _html(_TAKE.format(data=data))]) + "\n"


_TAKE = """<div class="take" role="group" aria-label="Take your answers along">
<button type="button" data-take="ipynb">Save as notebook</button>
<button type="button" data-take="py">Save as Python file</button>
<span class="sum" role="status"></span>
</div>
<noscript>To answer here, allow scripts; or take the notebook.</noscript>
<script type="application/json" id="exercise">{data}</script>
<script src="../_static/exercise.js" defer></script>"""


def _part(number: int, cell: Mapping[str, Any], exercise: Exercise) -> str:
    """Return what a page shows of a cell."""
    source, tags = "".join(cell["source"]), cell["metadata"].get("tags", ())
    if cell["cell_type"] == "markdown":
        return source
    if "check" in tags or "check_task" in source:
        return ""
    if "task" not in tags:
        return f"```python\n{source}\n```"
    function = next(f.name for f in ast.parse(source).body if isinstance(f, ast.FunctionDef))
    return _html(_editor(number, source, exercise.task_ids[function], function))


def _editor(number: int, source: str, task: str, function: str) -> str:
    """Return the box in which an answer is written, its buttons, and the place of its marks."""
    name = f"task {task}"
    return (
        f'<form class="task" data-task="{task}" data-function="{function}" data-cell="{number}">\n'
        f'<textarea aria-label="Answer to {name}" rows="{source.count(chr(10)) + 4}" '
        f'spellcheck="false" autocapitalize="off" autocomplete="off">{escape(source)}</textarea>\n'
        f'<button type="submit" aria-label="Check {name}">Check</button>\n'
        f'<button type="button" class="stop" aria-label="Stop {name}" hidden>Stop</button>\n'
        f'<button type="button" class="over" aria-label="Start {name} over">Start over</button>\n'
        f'<pre class="printed" hidden></pre>\n<div class="marks" role="status"></div>\n</form>'
    )


def _opening(text: str, *, uses_numpy: bool) -> str:
    """Return an exercise's first cell, with what to do in a page for what to do in a notebook."""
    blocks = text.split("\n\n")
    lists = [place for place, block in enumerate(blocks) if block.startswith("- ")]
    blocks[lists[0] : lists[-1] + 1] = [HOW + (NO_NUMPY if uses_numpy else "")]
    return "\n\n".join(blocks)


def _html(text: str) -> str:
    """Return HTML as Sphinx is to take it: as it stands."""
    return f"``````{{raw}} html\n{text}\n``````"


def _path(module: str) -> str:
    """Return where a module stands, as a package where it is one."""
    path = module.replace(".", "/")
    return f"{path}/__init__.py" if (home() / path).is_dir() else f"{path}.py"


@lru_cache(maxsize=500)
def _imported(path: str, source: str) -> tuple[str, ...]:
    """Return the modules of the package that a module imports as it runs."""
    names: list[str] = []
    package = path.removesuffix(".py").replace("/", ".").split(".")[:-1]
    waiting: list[ast.AST] = [ast.parse(source)]
    while waiting:
        node = waiting.pop()
        for_types = isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"
        waiting += [] if for_types else ast.iter_child_nodes(node)
        if isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else []
            name = ".".join([*base, *filter(None, [node.module])])
            names += [name, *(f"{name}.{alias.name}" for alias in node.names)]
    return tuple(name for name in names if name.startswith("lesson_code"))


@lru_cache(maxsize=500)
def _imports_numpy(path: str, source: str) -> bool:
    """Return whether a module imports NumPy at its top level."""
    body = ast.parse(source).body if path.endswith(".py") else []
    return any(isinstance(n, ast.Import) and n.names[0].name == "numpy" for n in body)
