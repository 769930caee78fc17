"""The exercises put to the test: can the checks tell wrong from right.

Every stub fails every task; every solution and every alternative gets full marks; every wrong
model loses points and is recognised by its own hint; no hint is empty; nothing is orphaned; and
nothing of a solution stands in a student copy.
"""

from __future__ import annotations

import ast
import importlib
import json
import pkgutil
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from types import ModuleType

from lesson_code.grading import alternatives, wrong_models
from lesson_code.grading.exercises import EXERCISES, Exercise
from lesson_code.grading.isolation import call_here
from lesson_code.grading.report import grade
from lesson_code.grading.submission import read_submission
from lesson_code.grading.task import Alternative, Task, WrongModel, marked
from lesson_code.grading.verdict import Verdict, judge

FEWEST_WRONG_MODELS = 3
SEEDS = range(5)
"""Seeds that every wrong model and alternative is judged with."""


def faults(root: Path, told: Callable[[str], None] = lambda _: None) -> Iterator[str]:
    """Yield in a line each what is wrong with the exercises of a workbook.

    Parameters
    ----------
    root : Path
        The workbook's folder.
    told : callable
        Is told what is being checked.
    """
    for exercise in EXERCISES:
        told(f"{exercise.name}: student copy")
        yield from _student_copy_faults(exercise, root)
        told(f"{exercise.name}: solution")
        yield from _solution_faults(exercise, root)
        for task in exercise.tasks:
            told(f"{exercise.name}: task {task.title}")
            yield from _task_faults(task)
    yield from _orphans()


def _student_copy_faults(exercise: Exercise, root: Path) -> Iterator[str]:
    """Yield where a student copy earns points or holds something of the solution."""
    path = exercise.student_copy(root)
    report = grade(path, exercise=exercise.name, seed=0)
    for verdict in report.verdicts:
        if any(criterion.message != "not written yet" for criterion in verdict.criteria):
            yield f"{path.name}: the stub of task {verdict.task.title} is no stub"
    for unit in read_submission(path).units:
        for statement in ast.parse(unit.source).body:
            if isinstance(statement, ast.FunctionDef) and statement.name in exercise.task_ids:
                yield from _body_faults(path.name, statement)
    if path.suffix == ".ipynb":
        yield from _notebook_faults(path)


def _body_faults(name: str, stub: ast.FunctionDef) -> Iterator[str]:
    """Yield whether anything but a docstring and the raise stands in a stub."""
    rest = stub.body[1:] if ast.get_docstring(stub) else stub.body
    if len(rest) != 1 or not isinstance(rest[0], ast.Raise):
        yield f"{name}: something of the solution of {stub.name} is left in the stub"


def _notebook_faults(path: Path) -> Iterator[str]:
    """Yield which cells of a student notebook hold outputs or are the instructor's."""
    for number, cell in enumerate(json.loads(path.read_text(encoding="utf-8"))["cells"], start=1):
        if cell.get("outputs"):
            yield f"{path.name}: cell {number} has outputs"
        if "solution" in cell["metadata"].get("tags", []):
            yield f"{path.name}: cell {number} belongs to the solution"


def _solution_faults(exercise: Exercise, root: Path) -> Iterator[str]:
    """Yield which tasks of a solution do not get full marks."""
    report = grade(exercise.solution(root), exercise=exercise.name, seed=0)
    for verdict in report.verdicts:
        if not verdict.is_full:
            yield f"{exercise.solution(root).name}: {verdict.line}"


def _task_faults(task: Task) -> Iterator[str]:
    """Yield which wrong models pass, which alternatives do not, and what is missing."""
    if len(task.wrong_models) < FEWEST_WRONG_MODELS:
        yield f"task {task.title}: has fewer than {FEWEST_WRONG_MODELS} wrong models"
    if not task.alternatives:
        yield f"task {task.title}: has no alternative"
    for model in task.wrong_models:
        if not (model.hint.strip() and model.misconception.strip()):
            yield f"task {task.title}: wrong model {model.name} has an empty hint or misconception"
        for verdict in _verdicts(task, model):
            if verdict.is_full:
                yield f"task {task.title}: wrong model {model.name} passes (seed {verdict.seed})"
            elif verdict.recognised is not model:
                yield f"task {task.title}: wrong model {model.name} is not recognised"
    for unusual in task.alternatives:
        for verdict in _verdicts(task, unusual):
            if not verdict.is_full:
                yield f"task {task.title}: alternative {unusual.name} gets {verdict.line}"


def _verdicts(task: Task, mark: WrongModel | Alternative) -> Iterator[Verdict]:
    """Yield what a known answer earns with several seeds."""
    call = partial(call_here, {task.function: mark.function})
    return (judge(task, call, seed) for seed in SEEDS)


def _orphans() -> Iterator[str]:
    """Yield which wrong models and alternatives belong to no task."""
    known = {task.id for exercise in EXERCISES for task in exercise.tasks}
    marks: list[WrongModel | Alternative] = [
        *(mark for module in _modules(wrong_models) for mark in marked(vars(module), WrongModel)),
        *(mark for module in _modules(alternatives) for mark in marked(vars(module), Alternative)),
    ]
    for mark in marks:
        if mark.task not in known:
            yield f"{mark.name}: belongs to task {mark.task}, which does not exist"


def _modules(package: ModuleType) -> Iterator[ModuleType]:
    """Yield the modules of a package, one a chapter."""
    for found in pkgutil.iter_modules(package.__path__):
        yield importlib.import_module(f"{package.__name__}.{found.name}")
