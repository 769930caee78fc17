"""What a task is: the function to write, what it must get right, and how it is often got wrong."""

from __future__ import annotations

import ast
import inspect
import textwrap
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from random import Random
from typing import Any, TypeAlias, TypeVar

Arguments: TypeAlias = tuple[Any, ...]
"""The arguments of one call: numbers, and tuples of numbers for vectors."""

Function: TypeAlias = Callable[..., Any]

Part: TypeAlias = Callable[[Any], Any]
"""Picks what a criterion looks at out of an answer, or brings it to one form."""

ANSWER_TOLERANCE = 1e-9
"""Largest difference from the expected number, relative above 1 and absolute below it.

Two right ways to compute the same thing differ by rounding, 1e-13 at the worst over the inputs
of the tasks; the wrong models differ by more than 1e-3. Anything between separates them.
"""


@dataclass(frozen=True)
class KnownAnswer:
    """A function that is known to answer a task, rightly or wrongly; called, it answers."""

    task: str
    function: Function

    @property
    def name(self) -> str:
        """The function's name, which says in what way it is wrong or unusual."""
        return self.function.__name__

    def __call__(self, *args: Any) -> Any:
        """Return the answer."""
        return self.function(*args)


@dataclass(frozen=True)
class WrongModel(KnownAnswer):
    """A plausible wrong formula, the misconception behind it, and a hint that asks a question."""

    hint: str

    @property
    def misconception(self) -> str:
        """What somebody believes who computes it so, in a sentence."""
        return inspect.getdoc(self.function) or ""


@dataclass(frozen=True)
class Alternative(KnownAnswer):
    """A right answer written in an unusual way; the checks must give it full marks."""


def wrong_model(task: str, hint: str) -> Callable[[Function], WrongModel]:
    """Mark a function as a wrong model of a task; its docstring is the misconception."""
    return lambda function: WrongModel(task, function, hint)


def alternative(task: str) -> Callable[[Function], Alternative]:
    """Mark a function as an unusual right answer to a task."""
    return lambda function: Alternative(task, function)


M = TypeVar("M", bound=KnownAnswer)


def marked(module: dict[str, Any], kind: type[M]) -> tuple[M, ...]:
    """Return what a module has marked as `kind`, in the order it is written."""
    return tuple(value for value in module.values() if isinstance(value, kind))


def source_as_answer(model: KnownAnswer, function_name: str) -> str:
    """Return the model's source as a student would hand it in: undecorated, renamed, untyped."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(model.function)))
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)  # noqa: S101 - only functions are marked
    definition.decorator_list = []
    definition.name = function_name
    definition.returns = None
    for argument in definition.args.args:
        argument.annotation = None
    return ast.unparse(tree)


@dataclass(frozen=True)
class Criterion:
    """One thing that an answer must get right, with points of its own.

    `cases` draws the arguments of some calls from a random stream. `part` picks what is looked
    at, out of the answer, where that is less than all of it; or it brings answers that are
    equally right, such as axes in any order, to one form.
    """

    name: str
    cases: Callable[[Random], Iterable[Arguments]]
    points: int = 1
    part: Part | None = None


@dataclass(frozen=True)
class Task:
    """A function to write, its criteria, and the expected answer, which students never see."""

    id: str
    function: str
    objective: str
    expected: Function
    criteria: tuple[Criterion, ...]
    wrong_models: tuple[WrongModel, ...] = ()
    alternatives: tuple[Alternative, ...] = ()
    explain: Callable[[Arguments, Any], str] | None = None

    @property
    def points(self) -> int:
        """The full mark."""
        return sum(criterion.points for criterion in self.criteria)

    @property
    def title(self) -> str:
        """The task's number and function, as every report writes it."""
        return f"{self.id} {self.function}"


def for_task(marks: tuple[M, ...], task: str) -> tuple[M, ...]:
    """Return those of `marks` that belong to a task."""
    return tuple(mark for mark in marks if mark.task == task)
