"""Runs student code, and answers calls with plain values.

The parent writes one JSON request a line, the child answers each with one JSON line:

    {"load": [{"name", "source", "groups", "missing"}, ...]}
                                            ->  {"loaded": [[unit, statement, error], ...]}
    {"call": function, "arguments": [...]}  ->  {"kind": "returned", "value": ...}
                                                or {"kind": "raised" | ..., "text": ...}

Each request has a "number", and its answer the same one.
"""

from __future__ import annotations

import ast
import codeop
import json
import numbers
import sys
import traceback
import types
from collections.abc import Iterable, Iterator
from typing import Any, BinaryIO

import numpy as np

from .reading import kept_part, parsed

MOST_NUMBERS = 10_000
"""Numbers and letters in an answer at most; no task asks for more than a thousand."""

MOST_LOAD_ERRORS = 50
"""Errors of loading that are told; a submission of a thousand cells may have as many."""

STOPPED = (Exception, SystemExit)
"""What a student's function may end in without ending this process; the rest ends it."""

DEEPEST = 20
"""Levels of nesting in an answer at most; no task needs more than four."""

UNORDERED = (dict, set, frozenset, bytes)
"""Containers that do not say which number comes first, or what the numbers are."""

LONGEST_TEXT = 300
"""Characters of an error's own words that are passed on."""

LARGEST_INTEGER = 2**53
"""A larger integer is taken as a float, as all the answers' other numbers are."""


class NotPlainError(ValueError):
    """An answer that is nothing a task can ask for; the message says what it is instead."""


def plain(value: Any) -> Any:
    """Return an answer as None, bool, int, float, str, or lists of these.

    Lists, tuples, arrays, Fractions, complex numbers (as [x, y]) and vectors of other libraries
    are all welcome. What comes back holds these very types, none made from them.

    Raises
    ------
    NotPlainError
        The answer is something else, or too large. Code of the answer's own may run here and
        raise anything.

    Examples
    --------
    >>> from fractions import Fraction
    >>> plain((Fraction(1, 2), 3 + 4j, None))
    [0.5, [3.0, 4.0], None]
    """
    return _plain(value, [MOST_NUMBERS], DEEPEST)


def _plain(value: Any, room: list[int], depth: int) -> Any:
    """Return `value` made plain; `room` counts down the numbers there is still room for."""
    room[0] -= 1
    if room[0] < 0 or depth < 0:
        raise NotPlainError("returned more than any task asks for")
    if value is None or value is True or value is False:
        return value
    if isinstance(value, str):
        text = str.__str__(value)  # str(value) would ask a class of its own
        room[0] -= len(text)
        if room[0] < 0:
            raise NotPlainError("returned more than any task asks for")
        return text
    if type(value).__name__ == "bool" and hasattr(value, "item"):  # NumPy's own bool
        return bool(value)
    if isinstance(value, numbers.Integral):
        number = int(value)
        return number if abs(number) <= LARGEST_INTEGER else float(number)
    if isinstance(value, numbers.Real) or hasattr(value, "as_integer_ratio"):
        return float(value)
    if isinstance(value, numbers.Complex):
        return [float(value.real), float(value.imag)]
    if getattr(value, "shape", None) == ():  # a NumPy array of no dimensions is a number
        return _plain(value.item(), room, depth - 1)
    if isinstance(value, Iterable) and not isinstance(value, UNORDERED):
        return [_plain(item, room, depth - 1) for item in value]
    kind = type(value).__name__
    raise NotPlainError(f"returned an object of type {kind}, which is no number, vector or tuple")


def arguments_from(values: Iterable[Any]) -> list[Any]:
    """Return the arguments of a call, made afresh: vectors are NumPy arrays of their own.

    >>> arguments_from([2.0, (3.0, 4.0)])
    [2.0, array([3., 4.])]
    """
    return [
        np.array(value, dtype=float) if isinstance(value, list | tuple) else value
        for value in values
    ]


def load(units: list[dict[str, Any]], namespace: dict[str, Any]) -> Iterator[list[Any]]:
    """Run the kept statements of all units; yield what went wrong: unit, statement, kind of error.

    No word of an error is passed on, since code that is loaded may say anything in it.

    A ``from __future__`` import holds from there on, as it does in a notebook and in a file.
    """
    compiler = codeop.Compile()
    for place, unit in enumerate(units):
        body = parsed(unit["source"])
        for group in unit["groups"]:
            for index in group:
                part = kept_part(body[index], unit["missing"]) or body[index]
                tree = ast.Module([part], type_ignores=[])
                try:
                    code = compiler(tree, unit["name"], "exec")  # type: ignore[arg-type] # a tree
                    exec(code, namespace)  # noqa: S102 - what this is for
                except STOPPED as error:
                    yield [place, index, type(error).__name__]
                    break


def call(function: str, arguments: list[Any], namespace: dict[str, Any]) -> dict[str, Any]:
    """Call a student's function and return what came of it."""
    if not callable(namespace.get(function)):
        return {"kind": "missing", "text": f"there is no function named {function}"}
    try:
        value = namespace[function](*arguments_from(arguments))
    except NotImplementedError as error:
        return {"kind": "not written", "text": _described(error)}
    except STOPPED as error:
        return {"kind": "raised", "text": _described(error)}
    try:
        return {"kind": "returned", "value": plain(value)}
    except NotPlainError as error:
        return {"kind": "unusable", "text": str(error)}
    except STOPPED as error:  # an answer may be an object of any class
        return {"kind": "raised", "text": _described(error)}


def _described(error: BaseException) -> str:
    """Return an error in a line, with the place in the student's own code."""
    told = traceback.TracebackException.from_exception(error, lookup_lines=False)
    places = [
        f" ({frame.filename}, line {frame.lineno})"
        for frame in told.stack
        if frame.filename.startswith("your ")
    ]
    text = str(told)[:LONGEST_TEXT]  # unlike str(error), does not fail where its class does
    said = f"{type(error).__name__}: {text}" if text else type(error).__name__
    return f"{said}{places[-1] if places else ''}"


def serve(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answer requests until there are no more."""
    answer_module = types.ModuleType("answer")  # dataclasses look up the module they stand in
    sys.modules["answer"] = answer_module
    namespace = vars(answer_module)
    for line in requests:
        request = json.loads(line)
        if "load" in request:
            errors = list(load(request["load"], namespace))
            answer: dict[str, Any] = {"loaded": errors[:MOST_LOAD_ERRORS]}
        else:
            answer = call(request["call"], request["arguments"], namespace)
        answers.write(json.dumps(answer | {"number": request["number"]}).encode() + b"\n")
        answers.flush()
