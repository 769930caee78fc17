"""A robot that packs the released modules under other names: what it earns, by way.

It needs no physics: it hands in, as its answer, whatever function of the student's copy earns the
most. The formulas that the chapters teach are there, and are meant to be read; programs' rules are
their exercises' answers, and are not.
"""

from __future__ import annotations

import ast
import importlib
import inspect
import pkgutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code.course.fresh_copies import Files, write_folder
from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.in_process import TimeLimitError, time_limit
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.verdict import judge, stream_of
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import arguments_from, plain

PACKED = "packed"
WINGS = ("formulas", "geometry", "reference", "chapters")
"""The parts of the copy that hold physics; its engine moves scenes, and answers no task."""

OTHERS_ENGINES = ("pymunk", "box2d")
"""Modules that stand for an engine which answers cannot import, and which ends a process."""

SEED, SECONDS = 7, 2.0

MOST_BY_NAME, MOST_FROM_PROGRAMS = 50, 5
"""Of 275 and 79 points. What is left of programs are formulas that the lesson teaches: at which
angle a box tips over (2), the area of a polygon, which has no sign there (1 of 2), the impulse of
notebook 04 for two balls alone (1 of 5), and the cradle's other law, for a row in which nothing
approaches (1 of 4)."""

Function = Callable[..., Any]


@pytest.fixture(scope="module")
def packed(files: Files, tmp_path_factory: pytest.TempPathFactory) -> dict[str, list[Function]]:
    """Return the functions of the student's copy by their names, from a package of another name."""
    folder = tmp_path_factory.mktemp("robot")
    ours = {name: text for name, text in files.items() if name.startswith("lesson_code/")}
    write_folder({renamed(name): renamed(text) for name, text in ours.items()}, folder)
    found: dict[int, Function] = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(folder))
        for module in map(importlib.import_module, modules()):
            for value in vars(module).values():
                if inspect.isroutine(value) and str(value.__module__).startswith(PACKED):
                    found[id(value)] = value
    by_name: dict[str, list[Function]] = {}
    for function in found.values():
        by_name.setdefault(function.__name__, []).append(function)
    return by_name


def renamed(text: Any) -> Any:
    """Return a name or a content with the package called otherwise."""
    if isinstance(text, bytes):
        return text.replace(b"lesson_code", PACKED.encode())
    return text.replace("lesson_code", PACKED)


def modules() -> Iterator[str]:
    """Yield the names of the modules with physics in them."""
    for wing in WINGS:
        package = importlib.import_module(f"{PACKED}.{wing}")
        for module in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            if not any(engine in module.name for engine in OTHERS_ENGINES):
                yield module.name


def points(task: Task, function: Function) -> int:
    """Return what a function earns as the answer to a task."""

    def call(_: str, arguments: Arguments) -> CallOutcome:
        try:
            return CallOutcome("returned", plain(function(*arguments_from(arguments))))
        except Exception as error:  # a function that was meant for something else
            return CallOutcome("raised", text=type(error).__name__)

    try:
        with np.errstate(all="ignore"), time_limit(SECONDS):
            return judge(task, call, SEED).points
    except TimeLimitError:
        return 0


def takes(function: Function, task: Task) -> bool:
    """Return whether a function can be called as a task's is."""
    criterion = task.criteria[0]
    try:
        arguments = next(iter(criterion.cases(stream_of(task, criterion, SEED))))
        inspect.signature(function).bind(*arguments)
    except (TypeError, ValueError):
        return False
    return True


@pytest.fixture
def _without_diagnoses(monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out what explains a wrong answer: it takes long, and changes no mark."""
    monkeypatch.setattr("lesson_code.course.grading.verdict.diagnoses", lambda *_: ())


@pytest.mark.full
@pytest.mark.usefixtures("_without_diagnoses")
def test_functions_of_the_same_name_earn_no_more_than_the_lesson_teaches(
    packed: dict[str, list[Function]],
) -> None:
    """A fifth of all points, from formulas that notebooks print; from programs next to none."""
    earned = {
        task.title: max((points(task, f) for f in packed.get(task.function, ())), default=0)
        for task in (task for exercise in exercises() for task in exercise.tasks)
    }
    assert sum(earned.values()) <= MOST_BY_NAME, {k: v for k, v in earned.items() if v}


@pytest.mark.full
@pytest.mark.usefixtures("_without_diagnoses")
def test_no_function_under_whatever_name_answers_a_program(
    packed: dict[str, list[Function]],
) -> None:
    """Every function that takes as many arguments is tried as the answer to every task."""
    every = [function for named in packed.values() for function in named]
    earned = {
        task.title: max(points(task, f) for f in every if takes(f, task))
        for exercise in programs()
        for task in exercise.tasks
    }
    assert len(every) > 400
    assert sum(earned.values()) <= MOST_FROM_PROGRAMS, {k: v for k, v in earned.items() if v}


def programs() -> list[Exercise]:
    """Return the exercises that are programs."""
    return [exercise for exercise in exercises() if not exercise.chapter.number]


def flattened(files: Files, module: str, seen: set[str]) -> str:
    """Return a module and those that it uses as one program without a package."""
    path = module.replace(".", "/")
    name = next((n for n in (f"{path}.py", f"{path}/__init__.py") if n in files), None)
    if name is None or name in seen:
        return ""
    seen.add(name)
    parts = []
    for statement in ast.parse(files[name]).body:
        if isinstance(statement, ast.ImportFrom) and statement.module:
            if statement.module.startswith("lesson_code"):
                parts.append(flattened(files, statement.module, seen))
                continue
            if statement.module == "__future__":
                continue
        parts.append(ast.unparse(statement))
    return "\n".join(filter(None, parts))


@pytest.mark.full
def test_packed_modules_are_handed_in(files: Files, tmp_path: Path) -> None:
    """Across the wall: what a chapter teaches earns its points, programs' rules nothing."""
    earned = {}
    with Grader() as grader:
        answers = {"01": "formulas.one_dimension"} | {
            exercise.name: f"chapters.{exercise.name}.rules" for exercise in programs()
        }
        for exercise, module in answers.items():
            path = tmp_path / f"{exercise}.py"
            path.write_text(flattened(files, f"lesson_code.{module}", set()), encoding="utf-8")
            earned[exercise] = grader.grade(path, exercise=exercise, seed=SEED).points
    assert earned.pop("01") == 7
    assert sum(earned.values()) == 0, earned
