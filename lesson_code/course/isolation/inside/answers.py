"""Runs student code, and answers calls with plain values.

The parent writes one JSON request a line, the child answers each with one JSON line:

    {"load": [{"name", "source", "groups", "missing", "codes"}, ...]}
                                            ->  {"loaded": [[unit, statement, error], ...]}
    {"call": function, "arguments": [...]}  ->  {"kind": "returned", "value": ..., "sets": [...]}
                                                or {"kind": "raised" | ..., "text": ...}
    {"together": [[[function, [...]], ...], ...]}
                                            ->  {"answers": [[answer, ...], ...]}

Each request has a "number", and its answer the same one. A call may name functions that are "lent",
each with its parameters. Where the student's code calls one of them, the parent's value is asked
for, and its code never comes here:

    {"lend": function, "arguments": [...]}  ->  {"value": ...} or {"refused": why}
"""

from __future__ import annotations

import base64
import codeop
import io
import json
import marshal
import numbers
import sys
import traceback
import types
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial
from typing import Any, BinaryIO

from .reading import compiled, parsed, read
from .vectors import is_array_of_floats, is_matrix, is_vector, shape_of, vector

MOST_NUMBERS = 10_000
"""Numbers and letters in an answer at most; no task asks for more than a thousand."""

MOST_LOAD_ERRORS = 50
"""Errors of loading that are told; a submission of a thousand cells may have as many."""

STOPPED = (Exception, SystemExit)
"""What a student's function may end in without ending this process; the rest ends it."""

GOES_ON = ("returned", "raised")
"""Outcomes after which the next call of a group is made."""

DEEPEST = 20
"""Levels of nesting in an answer at most; no task needs more than four."""

EXACT = frozenset({float, bool, type(None)})
"""What is plain as it is; a class made from one of these is another, and may do anything."""

UNORDERED = (dict, set, frozenset, bytes)
"""Containers that do not say which number comes first, or what the numbers are."""

LONGEST_TEXT = 300
"""Characters of an error's own words that are passed on."""

DISPLAY = "display"
"""What Jupyter has built in beside Python's own names."""

LARGEST_INTEGER = 2**53
"""A larger integer is taken as a float, as all the answers' other numbers are."""


class NotPlainError(ValueError):
    """An answer that is nothing a task can ask for; the message says what it is instead."""


def plain(value: Any, sets: set[int] | None = None) -> Any:
    """Return an answer as None, bool, int, float, str, or lists of these.

    Lists, tuples, arrays, Fractions, complex numbers (as [x, y]) and vectors of other libraries
    are all welcome. What comes back holds these very types, none made from them.

    Where `sets` is given, sets are welcome, too: they become lists in an order of our own, and
    `sets` is told at which levels they stood, 0 for the answer itself.

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
    >>> plain(({3, 2}, set()), levels := set()), levels
    ([[2, 3], []], {1})
    """
    return _plain(value, [MOST_NUMBERS], DEEPEST, sets)


def _plain(value: Any, room: list[int], depth: int, sets: set[int] | None) -> Any:
    """Return `value` made plain; `room` counts down the numbers there is still room for."""
    room[0] -= 1
    if room[0] < 0 or depth < 0:
        raise NotPlainError("returned more than any task asks for")
    kind = type(value)
    if kind in EXACT or (kind is int and abs(value) <= LARGEST_INTEGER):
        return value
    if kind is list or kind is tuple:  # by far the most frequent kinds come first
        if depth > 0 and len(value) <= room[0] and EXACT.issuperset(map(type, value)):
            room[0] -= len(value)
            return list(value)
        return [_plain(item, room, depth - 1, sets) for item in value]
    if isinstance(value, float):  # NumPy's, too
        return float.__float__(value)
    if is_matrix(value):  # its rows are matrices, without end
        value = value.A
    if is_array_of_floats(value) and value.size <= room[0]:
        return _plain(value.tolist(), room, depth, sets)
    if isinstance(value, str):
        text = str.__str__(value)  # str(value) would ask a class of its own
        room[0] -= len(text)
        if room[0] < 0:
            raise NotPlainError("returned more than any task asks for")
        return text
    if kind.__name__ == "bool" and hasattr(value, "item"):  # NumPy's own bool
        return bool(value)
    if isinstance(value, numbers.Integral):
        number = int(value)
        return number if abs(number) <= LARGEST_INTEGER else float(number)
    if isinstance(value, numbers.Real) or hasattr(value, "as_integer_ratio"):
        return float(value)
    if isinstance(value, numbers.Complex):
        return [float(value.real), float(value.imag)]
    if getattr(value, "shape", None) == ():  # a NumPy array of no dimensions is a number
        return _plain(value.item(), room, depth - 1, sets)
    if isinstance(value, Iterable) and not isinstance(value, UNORDERED):
        return [_plain(item, room, depth - 1, sets) for item in value]
    if sets is not None and isinstance(value, set | frozenset):
        sets.add(DEEPEST - depth)
        return sorted([_plain(item, room, depth - 1, sets) for item in value], key=repr)
    raise NotPlainError(
        f"returned an object of type {kind.__name__}, which is no number, vector or tuple"
    )


def arguments_from(values: Iterable[Any]) -> list[Any]:
    """Return the arguments of a call, made afresh: vectors are NumPy arrays of their own.

    >>> arguments_from([2.0, (3.0, 4.0)])
    [2.0, array([3., 4.])]
    """
    return [vector(value) if isinstance(value, list | tuple) else value for value in values]


def load(units: list[dict[str, Any]], namespace: dict[str, Any]) -> Iterator[list[Any]]:
    """Run the kept statements of all units; yield what went wrong: unit, statement, kind of error.

    No word of an error is passed on, since code that is loaded may say anything in it.

    A ``from __future__`` import holds from there on, as it does in a notebook and in a file. As in
    a notebook there is a `display`, which shows nothing here.
    """
    namespace.setdefault(DISPLAY, _display)
    compiler = codeop.Compile()
    is_compiled = _is_compiled(units)
    for place, unit in enumerate(units):
        body = [] if is_compiled else parsed(unit["source"])
        for group in unit["groups"]:
            for index in group:
                try:
                    if is_compiled:
                        code = marshal.loads(base64.b64decode(unit["codes"][index]))  # noqa: S302
                    else:
                        code = compiled(body[index], unit, compiler)
                    exec(code, namespace)  # noqa: S102 - what this is for
                except STOPPED as error:
                    yield [place, index, type(error).__name__]
                    break


def _display(*_: Any, **__: Any) -> None:
    """Show nothing."""


def _is_compiled(units: list[dict[str, Any]]) -> bool:
    """Return whether all that is kept has come compiled; if not, none of it is taken so."""
    return all(
        index < len(unit.get("codes", ())) and unit["codes"][index] is not None
        for unit in units
        for group in unit["groups"]
        for index in group
    )


def call(
    function: str,
    arguments: list[Any],
    namespace: dict[str, Any],
    returned: dict[str, Any] | None = None,
) -> dict[str, Any]:
    """Call a student's function and return what came of it.

    A value that is not None is kept in `returned` as it came, by the function's name.
    """
    if not callable(namespace.get(function)):
        return {"kind": "missing", "text": f"there is no function named {function}"}
    try:
        value = namespace[function](*arguments_from(arguments))
    except NotImplementedError as error:
        return {"kind": "not written", "text": _described(error)}
    except STOPPED as error:
        return {"kind": "raised", "text": _described(error)}
    if returned is not None and value is not None:
        returned[function] = value
    try:
        sets: set[int] = set()
        answer = {"kind": "returned", "value": plain(value, sets)}
        return answer | {"sets": sorted(sets)} if sets else answer
    except NotPlainError as error:
        return {"kind": "unusable", "text": str(error)}
    except STOPPED as error:  # an answer may be an object of any class
        return {"kind": "raised", "text": _described(error)}


def together(
    groups: list[list[Any]], namespace: dict[str, Any], returned: dict[str, Any] | None = None
) -> list[list[dict[str, Any]]]:
    """Make the calls of some groups; a group ends with one that neither returns nor raises."""
    answered: list[list[dict[str, Any]]] = []
    for group in groups:
        answers: list[dict[str, Any]] = []
        answered.append(answers)
        for function, arguments in group:
            answers.append(call(function, arguments, namespace, returned))
            if answers[-1]["kind"] not in GOES_ON:
                break
    return answered


def lendable(value: Any) -> Any:
    """Return a value so that JSON tells its arrays, and the vectors in its tuples, from tuples.

    >>> lendable((1.0, 2.0)), lendable((vector([1.0, 2.0]), 3.0))
    ([1.0, 2.0], [{'array': [1.0, 2.0]}, 3.0])
    """
    if is_vector(value):
        return {"array": plain(value)}
    if isinstance(value, list | tuple):
        return [{"array": plain(item)} if _is_vector(item) else lendable(item) for item in value]
    return plain(value)


def _is_vector(value: Any) -> bool:
    """Return whether a value is a tuple or list of nothing but floats."""
    return (
        isinstance(value, list | tuple)
        and len(value) > 0
        and all(isinstance(item, float) for item in value)
    )


def _lent(value: Any) -> Any:
    """Return the value that was lent in such a form."""
    if isinstance(value, dict):
        return vector(value["array"])
    return tuple(map(_lent, value)) if isinstance(value, list) else value


def in_the_form_of(own: Any, value: Any) -> Any:
    """Return a right value in lists, tuples and arrays like those of the student's own function.

    The code that calls it may add lists to each other, which arrays do in another way. Where the
    two forms do not fit, the value stays as it is.

    >>> in_the_form_of([vector([0.0, 1.0])], vector([[1.0, 2.0], [3.0, 4.0]]))
    [array([1., 2.]), array([3., 4.])]
    >>> in_the_form_of((0.0, 1.0), vector([1.0, 2.0])), in_the_form_of([0.0], None)
    ((1.0, 2.0), None)
    """
    shape = _shape_of(value)
    if is_vector(own) and shape:
        return vector(value)
    if isinstance(own, complex) and shape == (2,):
        return complex(*value)
    is_many = is_vector(value) or isinstance(value, list | tuple)
    if type(own) not in (list, tuple) or not is_many:
        return value
    items = value.tolist() if is_vector(value) and len(shape) == 1 else value
    likes = own if len(own) == len(items) else [*own[:1], None][:1] * len(items)
    return type(own)(map(in_the_form_of, likes, items))


def _shape_of(value: Any) -> tuple[int, ...]:
    """Return how many values stand in each direction; () of what is no array and cannot be one."""
    try:
        return shape_of(value)
    except ValueError:  # vectors beside numbers
        return ()


class Lent:
    """Stands in for a function of the student's: its values come from the parent, each once.

    They have the form of a value that the student's own function has returned, if there is one.
    """

    def __init__(
        self,
        name: str,
        parameters: list[str],
        ask: Callable[[dict[str, Any]], dict[str, Any]],
        kept: dict[str, dict[str, Any]],
        own: Any = None,
    ) -> None:
        self.__name__ = name
        self._own = own
        self._parameters = parameters
        self._ask = ask
        self._kept = kept

    def __call__(self, *given: Any, **named: Any) -> Any:
        """Return the parent's value, or raise what it says against these arguments."""
        missing = self._parameters[len(given) :]
        if len(given) > len(self._parameters) or set(missing) != set(named):
            raise TypeError(f"{self.__name__} takes {', '.join(self._parameters)}")
        arguments = plain([*given, *(named[name] for name in missing)])
        key = json.dumps([self.__name__, arguments])
        if key not in self._kept:
            self._kept[key] = self._ask({"lend": self.__name__, "arguments": arguments})
        reply = self._kept[key]
        if "refused" in reply:
            raise ValueError(reply["refused"])
        return in_the_form_of(self._own, _lent(reply["value"]))


def call_with(
    lent: Mapping[str, Callable[..., Any]],
    function: str,
    arguments: list[Any],
    namespace: dict[str, Any],
) -> dict[str, Any]:
    """Call a student's function while others of the same namespace are replaced."""
    own = {name: namespace[name] for name in lent if name in namespace}
    namespace.update(lent)
    try:
        return call(function, arguments, namespace)
    finally:
        for name in lent:
            namespace.pop(name, None)
        namespace.update(own)


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
    kept: dict[str, dict[str, Any]] = {}  # what was lent to each function that was called
    returned: dict[str, Any] = {}
    while line := requests.readline():
        request = json.loads(line)
        if "load" in request:
            errors = list(load(request["load"], namespace))
            answer: dict[str, Any] = {"loaded": errors[:MOST_LOAD_ERRORS]}
        elif "together" in request:
            answer = {"answers": together(request["together"], namespace, returned)}
        else:
            ask = partial(_asked, requests, answers, request["number"])
            lent = {
                name: Lent(
                    name,
                    parameters,
                    ask,
                    kept.setdefault(request["call"], {}),
                    returned.get(name),
                )
                for name, parameters in request.get("lent", {}).items()
            }
            answer = call_with(lent, request["call"], request["arguments"], namespace)
        answers.write(json.dumps(answer | {"number": request["number"]}).encode() + b"\n")
        answers.flush()


REHEARSED = """
import math
import numpy as np
from dataclasses import dataclass
@dataclass(frozen=True)
class Pair:
    v: np.ndarray
    m: float
def given(v, m):
    pair = Pair(np.asarray(v, dtype=float), m)
    n = pair.v / math.hypot(*pair.v)
    return [(float(np.dot(n, pair.v)) * n, np.array([[m, 0.0], [0.0, m]]) @ n), {1: None}[1]]
def fails(v, m):
    raise ValueError("rehearsed")
"""


def rehearse() -> None:
    """Do once what every submission has done, so that no child pays for a first time."""
    [unit] = read([{"name": "your cell 1", "source": REHEARSED, "is_cell": True}])
    calls = [["given", [[3.0, 4.0], 2.0]]] * 20 + [["fails", [[3.0, 4.0], 2.0]]]
    lines = [{"load": [unit], "number": 1}, {"together": [calls], "number": 2}]
    requests = io.BytesIO(b"".join(json.dumps(line).encode() + b"\n" for line in lines))
    serve(requests, io.BytesIO())
    del sys.modules["answer"]


def _asked(
    requests: BinaryIO, answers: BinaryIO, number: int, loan: dict[str, Any]
) -> dict[str, Any]:
    """Return what the parent says to a request for the value of a function that is lent."""
    answers.write(json.dumps(loan | {"number": number}).encode() + b"\n")
    answers.flush()
    reply: dict[str, Any] = json.loads(requests.readline())
    return reply
