"""The exercises put to the test: whether the checks tell right from wrong.

Every stub fails every task; every solution and every alternative gets full marks; every wrong
model loses points, the same with every seed, and is recognised by its own hint; no hint is empty;
nothing is orphaned; and nothing of a solution stands in a student copy.
"""

from __future__ import annotations

import ast
import json
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.grader import grade
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.grading.task import KnownAnswer, Task
from lesson_code.course.grading.verdict import Verdict, judge
from lesson_code.course.notebooks.student_copy import SOLUTION_ONLY

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
        Receives progress messages.
    """
    for exercise in exercises():
        told(f"{exercise.name}: student copy")
        yield from _student_copy_faults(exercise, root)
        told(f"{exercise.name}: solution")
        yield from _solution_faults(exercise, root)
        for task in exercise.tasks:
            told(f"{exercise.name}: task {task.title}")
            yield from _task_faults(task)
    yield from _orphans()
    yield from _orphaned_files(root)


def _student_copy_faults(exercise: Exercise, root: Path) -> Iterator[str]:
    """Yield where a student copy earns points or holds something of the solution."""
    path = exercise.student_copy(root)
    report = grade(path, exercise=exercise.name, seed=0)
    for verdict in report.verdicts:
        if any(criterion.message != "not written yet" for criterion in verdict.criteria):
            yield f"{path.name}: the stub of task {verdict.task.title} is no stub"
    for stub, _ in answers_in(path, exercise):
        yield from _body_faults(path.name, stub)
    yield from _leaks(exercise, root)
    if path.suffix == ".ipynb":
        yield from _notebook_faults(path)


def answers_in(path: Path, exercise: Exercise) -> Iterator[tuple[ast.FunctionDef, str]]:
    """Yield the definition of each function to write, and the code it stands in."""
    for unit in read_submission(path).units:
        for statement in unit.statements:
            if isinstance(statement, ast.FunctionDef) and statement.name in exercise.task_ids:
                yield statement, unit.source


def _leaks(exercise: Exercise, root: Path) -> Iterator[str]:
    """Yield which formulas of the solution stand in a student copy, even in a comment."""
    path = exercise.student_copy(root)
    copy = squeezed(_all_text(path))
    for answer, source in answers_in(exercise.solution(root), exercise):
        for formula in formulas_in(answer, source):
            if squeezed(formula) in copy:
                yield f"{path.name}: holds what the solution of {answer.name} has: {formula}"


def formulas_in(answer: ast.FunctionDef, source: str) -> Iterator[str]:
    """Yield the statements of a function that compute something."""
    for statement in ast.walk(answer):
        if isinstance(statement, ast.Assign | ast.AugAssign | ast.Return) and any(
            isinstance(part, ast.BinOp) for part in ast.walk(statement)
        ):
            yield ast.get_source_segment(source, statement) or ""


def _all_text(path: Path) -> str:
    """Return the text of a program, or of all cells of a notebook, whatever they hold."""
    text = path.read_text(encoding="utf-8")
    if path.suffix != ".ipynb":
        return text
    return "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"])


def squeezed(text: str) -> str:
    """Return a text without its white space."""
    return "".join(text.split())


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
        if SOLUTION_ONLY in cell["metadata"].get("tags", []):
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
        verdicts = list(_verdicts(task, model))
        for verdict in verdicts:
            if verdict.is_full:
                yield f"task {task.title}: wrong model {model.name} passes (seed {verdict.seed})"
            elif verdict.recognised is not model:
                yield f"task {task.title}: wrong model {model.name} is not recognised"
        if len(earned := {verdict.points for verdict in verdicts}) > 1:
            yield f"task {task.title}: wrong model {model.name} earns {sorted(earned)}, by the seed"
    for unusual in task.alternatives:
        for verdict in _verdicts(task, unusual):
            if not verdict.is_full:
                yield f"task {task.title}: alternative {unusual.name} gets {verdict.line}"


def _verdicts(task: Task, mark: KnownAnswer) -> Iterator[Verdict]:
    """Yield what a known answer earns with several seeds."""
    call = partial(call_here, {task.function: mark.function})
    return (judge(task, call, seed) for seed in SEEDS)


def _orphans() -> Iterator[str]:
    """Yield which wrong models and alternatives are marked for a task that is not there."""
    for exercise in exercises():
        for mark in exercise.known_answers:
            if mark.task not in exercise.task_ids.values():
                where = f"{mark.task}, which {exercise.name} does not have"
                yield f"{mark.name}: is marked for task {where}"


def _orphaned_files(root: Path) -> Iterator[str]:
    """Yield which files among the exercises and solutions belong to no exercise."""
    known = [exercise.file_name for exercise in exercises()]
    for folder in ("exercises", "solutions"):
        for path in sorted((root / folder).iterdir()):
            if path.suffix in (".ipynb", ".py") and path.name not in known:
                yield f"{folder}/{path.name}: belongs to no exercise"
