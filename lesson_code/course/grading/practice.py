"""Practice checks: what a student's copy holds in place of the course's own checks.

The grader's checks draw new inputs from a seed and work out what is expected. A student's copy
holds neither the formulas nor the drawing. For each task it holds some draws, made once, with what
the right formula and each wrong model make of them. A check cell picks one of them. The hints, and
what says why an answer is wrong, are the same in both.

The answers are sealed against a glance and a search, and against nothing else: a check cell shows
them to everyone who answers wrongly. They are never used to grade.
"""

from __future__ import annotations

import base64
import importlib
import json
import zlib
from collections.abc import Callable, Iterable
from pathlib import Path
from random import Random
from typing import Any

from lesson_code.course.grading.task import Arguments, Criterion, Function, Task, WrongModel
from lesson_code.course.isolation.inside.answers import arguments_from, plain
from lesson_code.course.isolation.inside.vectors import unwarned

DRAWS = 4
"""Draws of each criterion, of which a check cell picks one."""

FAILED = "(fails)"
"""Stands where a wrong model gives no answer at all."""


def practice_of(tasks: Iterable[Task]) -> str:
    """Return the practice checks of some tasks, as the text of a JSON file."""
    return json.dumps([_as_dict(task) for task in tasks], indent=1) + "\n"


def practice_tasks(path: Path) -> tuple[Task, ...]:
    """Return the tasks whose practice checks stand in a file."""
    return tuple(_task(entry) for entry in json.loads(path.read_text(encoding="utf-8")))


def practice_draws(task: Task, criterion: Criterion) -> list[list[list[Any]]]:
    """Return some draws of a criterion that no grader's seed makes.

    A draw is a list of calls; a call is its arguments, the right answer and those of the wrong
    models.
    """
    formulas: list[Function] = [task.expected, *task.wrong_models]
    draws = []
    for number in range(DRAWS):
        # A grader's stream begins with a number, so that these are never the ones it draws.
        stream = Random(zlib.crc32(f"practice {number} {task.id} {criterion.name}".encode()))  # noqa: S311
        draws.append(
            [
                [arguments, *(_made_of(formula, arguments) for formula in formulas)]
                for arguments in criterion.cases(stream)
            ]
        )
    return draws


def _made_of(function: Function, arguments: Arguments) -> Any:
    """Return what a right or wrong formula makes of a call; FAILED where it fails."""
    try:
        with unwarned():
            return plain(function(*arguments_from(arguments)))
    except Exception:  # a wrong model may fail in any way
        return FAILED


def reference(function: Function) -> str:
    """Return where a function stands, so that another copy can find it.

    Raises
    ------
    ValueError
        It does not stand at the top level of a module.
    """
    module, name = function.__module__, function.__qualname__
    if getattr(importlib.import_module(module), name, None) is not function:
        raise ValueError(f"{name} must stand at the top level of {module}")
    return f"{module}:{name}"


def seal(value: Any) -> str:
    """Return a JSON value as text that neither a glance nor a search finds anything in.

    >>> unseal(seal([1, None, "two"]))
    [1, None, 'two']
    """
    return base64.b85encode(zlib.compress(json.dumps(value).encode(), 9)).decode()


def unseal(text: str) -> Any:
    """Return what was sealed."""
    return json.loads(zlib.decompress(base64.b85decode(text)))


def _as_dict(task: Task) -> dict[str, Any]:
    """Return a task without its formulas."""
    return {
        "id": task.id,
        "function": task.function,
        "objective": task.objective,
        "parameters": task.parameters,
        "section": task.section,
        "any_order": task.any_order,
        "explain": task.explain and reference(task.explain),
        "wrong_models": seal([[m.name, m.misconception, m.hint] for m in task.wrong_models]),
        "criteria": [
            {
                "name": criterion.name,
                "points": criterion.points,
                "part": criterion.part and reference(criterion.part),
                "draws": seal(practice_draws(task, criterion)),
            }
            for criterion in task.criteria
        ],
    }


def _task(entry: dict[str, Any]) -> Task:
    """Return a task with practice checks."""
    made: dict[str, list[Any]] = {}
    said = unseal(entry["wrong_models"])
    return Task(
        id=entry["id"],
        function=entry["function"],
        objective=entry["objective"],
        expected=_looked_up(made, 0),
        criteria=tuple(_criterion(criterion, made) for criterion in entry["criteria"]),
        wrong_models=tuple(
            WrongModel(entry["id"], _looked_up(made, place, name, misconception), hint)
            for place, (name, misconception, hint) in enumerate(said, start=1)
        ),
        explain=entry["explain"] and _found(entry["explain"]),
        parameters=tuple(entry["parameters"]),
        section=entry["section"],
        any_order=entry["any_order"],
    )


def _criterion(entry: dict[str, Any], made: dict[str, list[Any]]) -> Criterion:
    """Return a criterion with practice checks, and note what is made of its calls."""
    draws = []
    for draw in unseal(entry["draws"]):
        calls = [_tuples(call[0]) for call in draw]
        made.update((_key(arguments_from(c)), m[1:]) for c, m in zip(calls, draw, strict=True))
        draws.append(calls)
    part = entry["part"] and _found(entry["part"])
    return Criterion(entry["name"], _picked(draws), entry["points"], part)


def _picked(draws: list[list[Arguments]]) -> Callable[[Random], list[Arguments]]:
    """Return what picks the calls of one draw with a random stream."""
    return lambda stream: stream.choice(draws)


def _looked_up(made: dict[str, list[Any]], place: int, name: str = "", doc: str = "") -> Function:
    """Return a function that looks its answers up among those that were stored."""

    def answer(*arguments: Any) -> Any:
        value = made[_key(arguments)][place]
        if value == FAILED:
            raise ArithmeticError("this model fails here")
        return value

    answer.__name__, answer.__doc__ = name or answer.__name__, doc
    return answer


def _key(arguments: Iterable[Any]) -> str:
    """Return what tells a call from others."""
    return repr(plain(list(arguments)))


def _tuples(value: Any) -> Any:
    """Return a value with tuples for lists, as tasks draw them."""
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _found(where: str) -> Any:
    """Return a function or wrong model by its reference."""
    module, _, name = where.partition(":")
    return getattr(importlib.import_module(module), name)
