"""What a task is: the function to write, what it must get right, and how it is often got wrong."""

from __future__ import annotations

import ast
import inspect
import linecache
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from random import Random
from typing import Any, TypeAlias

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
        """What a student who computes it this way believes, in a sentence."""
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


def edited(right: KnownAnswer, edits: Mapping[str, str]) -> Callable[[Function], Function]:
    """Write a wrong answer as a right one with a few pieces of its source replaced.

    The decorated function gives the name and, as its docstring, the misconception; it has no code.

    Parameters
    ----------
    right : KnownAnswer
        The right answer to start from.
    edits : mapping of str to str
        Each piece of its source to replace, and what replaces it.

    Raises
    ------
    ValueError
        A piece does not stand in the source exactly once.
    """

    def write(named: Function) -> Function:
        source = inspect.getsource(right.function)
        for old, new in edits.items():
            if source.count(old) != 1:
                raise ValueError(f"{old!r} must stand once in {right.name}, for {named.__name__}")
            source = source.replace(old, new)
        return _defined(_renamed(source, named), named, right.function.__globals__)

    return write


def _renamed(source: str, named: Function) -> str:
    """Return a function's source with another name and docstring, and without decorators."""
    tree = ast.parse(source)
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)  # noqa: S101 - only functions are marked
    definition.name, definition.decorator_list = named.__name__, []
    definition.body[0] = ast.Expr(ast.Constant(inspect.getdoc(named)))
    return ast.unparse(tree)


def _defined(source: str, named: Function, names: dict[str, Any]) -> Function:
    """Return the function that some source defines; `inspect` finds this source."""
    file = f"<{named.__module__}.{named.__name__}>"
    linecache.cache[file] = len(source), None, source.splitlines(keepends=True), file
    made: dict[str, Function] = {}
    exec(compile(source, file, "exec"), names, made)  # noqa: S102 - the course's own source
    return made[named.__name__]


@dataclass(frozen=True, eq=False)
class Criterion:
    """One thing that an answer must get right, with points of its own.

    `cases` draws the arguments of some calls from a random stream. `part` picks the part of an
    answer that the criterion looks at, or brings answers that are equally right, such as axes in
    any order, to one form.
    """

    name: str
    cases: Callable[[Random], Iterable[Arguments]]
    points: int = 1
    part: Part | None = None


@dataclass(frozen=True, eq=False)
class Task:
    """A function to write, its criteria, and the expected answer, which students never see.

    A task is made once and equal to itself alone, as is a criterion: what is kept by task is looked
    up a hundred times a submission.

    `section` is that of the chapter's notebook in which the formula stands; a program has none.
    `has_one_form` says that honest answers are the same line by line, so that two that are alike
    tell nothing. `any_order` is the level at which any order is right, and a set with it: 0 of the
    answer itself, 1 of each of its parts.
    """

    id: str
    function: str
    objective: str
    expected: Function
    criteria: tuple[Criterion, ...]
    wrong_models: tuple[WrongModel, ...] = ()
    alternatives: tuple[Alternative, ...] = ()
    explain: Callable[[Arguments, Any], str] | None = None
    parameters: tuple[str, ...] = ()
    section: int | None = None
    has_one_form: bool = False
    any_order: int | None = None

    @property
    def points(self) -> int:
        """The full mark."""
        return sum(criterion.points for criterion in self.criteria)

    @property
    def title(self) -> str:
        """The task's number and function, as every report writes it."""
        return f"{self.id} {self.function}"
