"""The check cell of an exercise: marks one answer in the notebook it was written in."""

from __future__ import annotations

import dis
import inspect
import secrets
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache, partial
from types import CodeType
from typing import Any

from lesson_code.course.grading.exercises import exercises, task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.verdict import Verdict, better, calls_of, judge
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import DISPLAY, in_the_form_of
from lesson_code.course.isolation.inside.imports import THE_LIST, may_be_imported

LARGEST_SEED = 10_000
"""Seeds are small enough to be typed again."""


def check_task(task_id: str, function: Callable[..., Any], *, seed: int | None = None) -> None:
    """Print the marks for an answer: one line, and more only where something is wrong.

    An answer that calls a wrong function of an earlier task has full marks if it has them with the
    right one. A student's copy does not hold that one, and names the wrong function instead.

    Parameters
    ----------
    task_id : str
        The task's number, such as "3.2".
    function : callable
        The answer.
    seed : int, optional
        Draws the inputs. By default they differ from call to call.

    Raises
    ------
    ValueError
        There is no such task.

    Examples
    --------
    >>> from lesson_code.formulas import reflect
    >>> check_task("3.1", reflect)
    3.1 reflect: 4/4 points
    """
    task = task_by_id(task_id)
    drawn = secrets.randbelow(LARGEST_SEED) if seed is None else seed
    verdict = judge(task, partial(call_here, {task.function: function}), drawn)
    lost = [] if verdict.is_full else lost_before(task, function, drawn)
    lines = lines_of(verdict)
    if lost:
        again = judge(task, partial(_call_with_ours, function, lost), drawn)
        names = " and ".join(f"`{each.function}`, which lost points in {each.id}" for each in lost)
        lines = [again.line] if again.is_full else [*lines, f"  it calls your {names}"]
    print("\n".join([*lines, *left_out_of(function)]))  # noqa: T201 - a check cell's


def lost_before(task: Task, function: Callable[..., Any], seed: int) -> list[Task]:
    """Return the earlier tasks of the exercise whose functions an answer calls wrongly written."""
    used = {name: value for name, value in _looked_up(function) if inspect.isfunction(value)}
    tasks = next((e.tasks for e in exercises() if task.id in e.task_ids.values()), ())
    before = tasks[: [each.id for each in tasks].index(task.id)] if tasks else ()
    return [
        each
        for each in before
        if each.function in used and not judge(each, partial(call_here, used), seed).is_full
    ]


def _call_with_ours(
    function: Any, lent: list[Task], name: str, arguments: Arguments
) -> CallOutcome:
    """Return what came of a call while ours stand in the place of some functions."""
    names = inspect.unwrap(function).__globals__
    own = {task.function: names[task.function] for task in lent}
    names.update({task.function: _in_their_form(task, own[task.function]) for task in lent})
    try:
        return call_here({name: function}, name, arguments)
    finally:
        names.update(own)


def _in_their_form(task: Task, own: Callable[..., Any]) -> Callable[..., Any]:
    """Return the right function of a task; its values have the form of the student's own."""
    returned: dict[str, Any] = {}
    for calls in calls_of([task], seed=0):
        if not returned:
            call_here({task.function: own}, *calls[0], returned=returned)

    def right(*arguments: Any, **named: Any) -> Any:
        return in_the_form_of(returned.get(task.function), task.expected(*arguments, **named))

    return right


def check_criterion(
    task_id: str, criterion: str, function: Callable[..., Any], *, seed: int
) -> None:
    """Do nothing where an answer earns a criterion's points; otherwise say why it does not.

    So a grader that counts cells without an error, as nbgrader does, gives the marks of ours. What
    is said holds none of the inputs.

    Parameters
    ----------
    task_id : str
        The task's number, such as "3.2".
    criterion : str
        The criterion's name.
    function : callable
        The answer.
    seed : int
        Draws the inputs.

    Raises
    ------
    AssertionError
        The answer does not earn them.
    ValueError
        There is no such task or criterion.

    Examples
    --------
    >>> check_criterion("3.1", "level walls", lambda incident, normal: incident, seed=1)
    Traceback (most recent call last):
    AssertionError: ...
    """
    verdict = _verdict(task_id, function, seed)
    names = [each.name for each in verdict.criteria]
    if criterion not in names:
        raise ValueError(f"criterion must be one of {', '.join(names)}, got {criterion!r}")
    said = left_out_of(function)
    said += [each.message for each in verdict.criteria if each.name == criterion and each.message]
    if said:
        hints = [f"hint: {d.hint}" for d in verdict.diagnoses if criterion in d.criteria]
        raise AssertionError("\n".join([line.strip() for line in (*said, *hints)]))


@lru_cache(maxsize=1)  # its criteria are asked for one after another
def _verdict(task_id: str, function: Callable[..., Any], seed: int) -> Verdict:
    """Return the marks for an answer, without the inputs."""
    task = task_by_id(task_id)
    call = partial(call_here, {task.function: function})
    verdict = judge(task, call, seed, hide_inputs=True)
    lost = [] if verdict.is_full else lost_before(task, function, seed)
    if not lost:
        return verdict
    with_ours = partial(_call_with_ours, function, lost)
    return better(verdict, judge(task, with_ours, seed, hide_inputs=True), tuple(lost))


def left_out_of(function: Callable[..., Any]) -> list[str]:
    """Return in a line for each reason what an answer uses and grading leaves out.

    That is what comes from lesson_code, and from imports that are not on the list. Helpers that the
    answer calls, if they stand in the same notebook, are looked through, too. Jupyter's `display`
    is there while an answer is graded.
    """
    looked_up = [(name, value) for name, value in _looked_up(function) if name != DISPLAY]
    found = [(_home_of(value), name) for name, value in looked_up]
    found += [(root, "") for code in _codes_of(function) for root in _imported_in(code)]
    left_out = {home for home, _ in found if not may_be_imported(home)} - {_home_of(function)}
    lines = []
    for home in sorted(left_out):
        names = sorted({name for other, name in found if other == home and name})
        why = "" if home == "lesson_code" else f"; {THE_LIST}"
        rest = f", and so {', '.join(names)}" if names else ""
        lines.append(f"  grading leaves out imports of {home}{rest}{why}")
    return lines


def _looked_up(function: Any) -> list[tuple[str, Any]]:
    """Return the names that a function and its helpers look up, with their values."""
    found: dict[str, Any] = {}
    for names, code in _defined_for(function):
        found |= {
            name: names[name] for part in _nested(code) for name in part.co_names if name in names
        }
    return sorted(found.items(), key=lambda item: item[0])


def _codes_of(function: Any) -> Iterator[CodeType]:
    """Yield the code of a function of a notebook, and of its helpers, with all that is nested."""
    for _, code in _defined_for(function):
        yield from _nested(code)


def _defined_for(function: Any) -> Iterator[tuple[Mapping[str, Any], CodeType]]:
    """Yield the code of a function and of the helpers that it calls, with what names mean there."""
    left, seen = [function], set()
    while left:
        plain = inspect.unwrap(left.pop())
        code = getattr(plain, "__code__", None)
        if code is None or code in seen or _home_of(plain) == "lesson_code":
            continue
        seen.add(code)
        yield plain.__globals__, code
        called = [plain.__globals__.get(name) for part in _nested(code) for name in part.co_names]
        left += [v for v in called if inspect.isfunction(v) and v.__module__ == plain.__module__]


def _nested(code: CodeType) -> Iterator[CodeType]:
    """Yield some code, and all that stands in it."""
    yield code
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _nested(constant)


def _imported_in(code: CodeType) -> Iterator[str]:
    """Yield the packages that code imports when it is called."""
    for instruction in dis.get_instructions(code):
        if instruction.opname == "IMPORT_NAME" and instruction.argval:
            yield str(instruction.argval).partition(".")[0]


def _home_of(value: Any) -> str:
    """Return the package that a value comes from; of a plain value, that of Python itself."""
    home = value.__name__ if inspect.ismodule(value) else getattr(value, "__module__", None)
    return home.partition(".")[0] if isinstance(home, str) else "builtins"


def lines_of(verdict: Verdict) -> list[str]:
    """Return what there is to say about an answer, with the seed that repeats it."""
    if len(verdict.lines) == 1:
        return verdict.lines
    return [*verdict.lines, f"  (inputs drawn with seed {verdict.seed})"]
