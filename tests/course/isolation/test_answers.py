"""The student's side of the wall: answers made plain, code loaded statement by statement."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from itertools import count, repeat
from typing import Any

import numpy as np
import pygame
import pytest

from lesson_code.course.isolation.inside import answers, imports
from lesson_code.course.isolation.inside.answers import (
    MOST_NUMBERS,
    NotPlainError,
    arguments_from,
    plain,
)
from lesson_code.course.isolation.inside.reading import read


class Impostor:
    """Says of itself to be of a class that it is not of."""

    def __init__(self, claimed: type) -> None:
        self.claimed = claimed

    @property  # type: ignore[misc]
    def __class__(self) -> type:  # type: ignore[override]
        """Return the claimed class."""
        return self.claimed

    def __eq__(self, other: object) -> bool:
        """Agree with everything."""
        return True

    __hash__ = None  # type: ignore[assignment]


class Named(str):
    """A text of a class of its own."""

    __slots__ = ()

    def __str__(self) -> str:
        """Return something else."""
        return "forged"


class Itself:
    """Claims to be an array without dimensions, and holds itself."""

    shape = ()

    def item(self) -> Itself:
        """Return itself."""
        return self


def ring() -> list[Any]:
    """Return a list that holds itself."""
    ring: list[Any] = []
    ring.append(ring)
    return ring


def failing() -> Iterator[float]:
    """Yield a number, then fail."""
    yield 1.0
    raise ZeroDivisionError("half way")


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (None, None),
        (True, True),
        (np.True_, True),
        (np.array(False), False),
        (3, 3),
        (np.int64(3), 3),
        (np.float32(0.5), 0.5),
        (np.longdouble(0.5), 0.5),
        (Fraction(1, 4), 0.25),
        (Decimal("0.25"), 0.25),
        (np.array(0.25), 0.25),
        (np.array(Fraction(1, 4)), 0.25),
        (3 + 4j, [3.0, 4.0]),
        (np.complex64(3 + 4j), [3.0, 4.0]),
        (np.array(3 + 4j), [3.0, 4.0]),
        ([1, (2.0, [3])], [1, [2.0, [3]]]),
        (np.array([[1.0, 2.0]]), [[1.0, 2.0]]),
        (np.ones((2, 1)).view(np.matrix), [[1.0], [1.0]]),
        ((np.ones((1, 2), dtype=int).view(np.matrix), 1), [[[1, 1]], 1]),
        (pygame.Vector2(3, 4), [3.0, 4.0]),
        (pygame.Vector3(1, 2, 3), [1.0, 2.0, 3.0]),
        (range(3), [0, 1, 2]),
        ((n * n for n in range(3)), [0, 1, 4]),
        (map(float, "12"), [1.0, 2.0]),
        ([], []),
        ("left", "left"),
        (np.str_("left"), "left"),
        (Named("left"), "left"),
        (10**300, 1e300),
        (2**53, 2**53),
    ],
)
def test_plain_of_any_number_or_container(value: Any, expected: Any) -> None:
    """Numbers, vectors and containers of any library become plain numbers and lists."""
    made = plain(value)
    assert made == expected
    assert _types(made) == _types(expected)
    json.dumps(made)


def _types(value: Any) -> Any:
    """Return the exact types within a plain value."""
    return [_types(item) for item in value] if type(value) is list else type(value)


@pytest.mark.parametrize("value", [math.nan, np.nan, np.array([math.nan])])
def test_plain_of_nan_stays_nan(value: Any) -> None:
    """Nan is handed on as it is; the comparison refuses it."""
    assert np.isnan(plain(value)).all()


@pytest.mark.parametrize(
    "value",
    [{}, {"v": 1.0}, b"12", {1.0, 2.0}, frozenset({1.0}), object(), len, [object()], iter, ...],
)
def test_plain_refuses_what_is_no_number_or_vector(value: Any) -> None:
    """Dictionaries, sets, bytes, functions and other objects are refused by name of type."""
    with pytest.raises((NotPlainError, TypeError), match="which is no number, vector or tuple"):
        plain(value)


def test_plain_of_sets_says_where_they_stood() -> None:
    """Sets become lists, the same ones in every process, and their levels are told."""
    levels: set[int] = set()
    assert plain([1, {"b", "a"}, [frozenset({2})]], levels) == [1, ["a", "b"], [[2]]]
    assert levels == {1, 2}


@pytest.mark.parametrize("claimed", [str, list, float, int, bool, type(None)])
def test_plain_is_not_taken_in_by_a_claimed_class(claimed: type) -> None:
    """An object that only says it is a number or a text never comes through as itself."""
    with pytest.raises((NotPlainError, TypeError)):
        plain([Impostor(claimed)])


@pytest.mark.parametrize(
    "make",
    [
        count,
        lambda: repeat([]),
        lambda: np.zeros(MOST_NUMBERS),
        lambda: [[0.0] * 1000] * 1000,
        lambda: "x" * MOST_NUMBERS,
        ring,
        Itself,
        lambda: [[[[[[[[[[[[[[[[[[[[[1.0]]]]]]]]]]]]]]]]]]]]],
    ],
    ids=[
        "endless",
        "endless lists",
        "huge array",
        "huge list",
        "huge text",
        "ring",
        "itself",
        "deep",
    ],
)
def test_plain_refuses_what_is_endless_huge_or_deep(make: Callable[[], Any]) -> None:
    """An answer without an end is given up after MOST_NUMBERS numbers or DEEPEST levels."""
    with pytest.raises(NotPlainError, match="more than any task asks for"):
        plain(make())


@pytest.mark.parametrize(
    "value", [10**400, -(10**5000), Fraction(10**400, 3)], ids=["large", "larger", "fraction"]
)
def test_plain_refuses_a_number_beyond_all_floats(value: Any) -> None:
    """A number that no float can hold is an error here, and not one in the grader."""
    with pytest.raises(OverflowError):
        plain(value)


def test_arguments_from_makes_arrays_of_their_own() -> None:
    """Each call gets vectors made afresh, so that changing them changes nothing else."""
    given = [1.0, (3, 4), [5.0, 6.0], 2]
    arguments = arguments_from(given)
    arguments[1] += 1
    arguments[2][:] = 0
    assert given == [1.0, (3, 4), [5.0, 6.0], 2]
    assert arguments[1].dtype == float
    assert arguments[3] == 2


def _unit(source: str, *groups: tuple[int, ...]) -> dict[str, Any]:
    """Return a unit as the parent sends it."""
    return {"name": "your test", "source": source, "groups": groups, "missing": ()}


def test_load_group_stops_at_its_first_error_and_the_next_goes_on() -> None:
    """A failing statement takes the rest of its own cell with it, and nothing of the next."""
    namespace: dict[str, Any] = {}
    units = [_unit("a = 1\n1 / 0\nb = 2", (0, 1, 2)), _unit("c = 3", (0,))]
    assert list(answers.load(units, namespace)) == [[0, 1, "ZeroDivisionError"]]
    assert [name in namespace for name in "abc"] == [True, False, True]


def test_load_runs_kept_statements_alone() -> None:
    """A statement whose number is not listed does not run."""
    namespace: dict[str, Any] = {}
    assert not list(answers.load([_unit("a = 1\na = 2\nb = a", (0, 2))], namespace))
    assert namespace["b"] == 1


def test_load_future_import_holds_for_what_follows() -> None:
    """``from __future__ import annotations`` in a file lets its functions name unknown types."""
    source = "from __future__ import annotations\ndef f(x: Unknown): return x"
    namespace: dict[str, Any] = {}
    assert not list(answers.load([_unit(source, (0,), (1,))], namespace))
    assert answers.call("f", [2.0], namespace) == {"kind": "returned", "value": 2.0}


@pytest.mark.parametrize("broken", [False, True])
def test_load_of_compiled_code_is_the_load_of_its_source(broken: bool) -> None:
    """The same names, errors and future imports; one statement that no compiler takes changes none.

    Then nothing is taken compiled, or an import from the future would not hold for what follows.
    """
    sources = [
        "from __future__ import annotations\nx = 1 / 0\nn = 1",
        "def f(x: Unknown): return x",
        "return 3" if broken else "n = 2",
        "def g(): raise ValueError('g')",
    ]
    given = [
        {"name": f"your cell {n}", "source": s, "is_cell": True} for n, s in enumerate(sources)
    ]
    compiled = json.loads(json.dumps(read(given)))
    plain_units = [{**unit, "codes": []} for unit in compiled]
    names: list[dict[str, Any]] = [{}, {}]
    errors = [list(answers.load(u, n)) for u, n in zip((compiled, plain_units), names, strict=True)]
    assert errors[0] == errors[1]
    assert [error[2] for error in errors[0]] == ["ZeroDivisionError"] + ["SyntaxError"] * broken
    assert set(names[0]) == set(names[1]) >= {"f", "g"}
    assert answers.call("g", [], names[0]) == answers.call("g", [], names[1])


def test_load_does_not_lend_its_own_future_imports() -> None:
    """An annotation that fails in a notebook fails here too."""
    errors = list(answers.load([_unit("def f(x: Unknown): return x", (0,))], {}))
    assert errors == [[0, 0, "NameError"]]


class MuteError(Exception):
    """An error that cannot be shown."""

    def __str__(self) -> str:
        """Fail."""
        raise KeyError


def _raises(error: BaseException) -> Callable[[], Any]:
    """Return a function that raises an error."""

    def fail() -> None:
        raise error

    return fail


@pytest.mark.parametrize(
    ("function", "answer"),
    [
        (lambda: 1.5, {"kind": "returned", "value": 1.5}),
        (lambda: ({3, 10, 2}, 1), {"kind": "returned", "value": [[10, 2, 3], 1], "sets": [1]}),
        (dict, {"kind": "unusable", "text": "returned an object of type dict, which is no number, "
                "vector or tuple"}),
        (failing, {"kind": "raised", "text": "ZeroDivisionError: half way"}),
        (_raises(ValueError("odd")), {"kind": "raised", "text": "ValueError: odd"}),
        (_raises(MemoryError()), {"kind": "raised", "text": "MemoryError"}),
        (_raises(SystemExit(0)), {"kind": "raised", "text": "SystemExit: 0"}),
        (_raises(MuteError()), {"kind": "raised", "text": "MuteError: <exception str() failed>"}),
        (_raises(NotImplementedError("Task 1.1: f")),
         {"kind": "not written", "text": "NotImplementedError: Task 1.1: f"}),
        (3.0, {"kind": "missing", "text": "there is no function named f"}),
        (None, {"kind": "missing", "text": "there is no function named f"}),
    ],
)  # fmt: skip
def test_call_says_what_came_of_it(function: Any, answer: dict[str, Any]) -> None:
    """A call ends in a value, an error, an unusable object, or says that there is no answer yet."""
    assert answers.call("f", [], {"f": function}) == answer


def test_call_with_wrong_number_of_arguments_is_an_error_of_the_answer() -> None:
    """A function with other arguments than asked for raises, and does not crash the child."""
    answer = answers.call("f", [1.0, 2.0], {"f": lambda x: x})
    assert answer["kind"] == "raised"
    assert "takes 1 positional argument but 2 were given" in answer["text"]


def test_only_the_list_can_be_imported() -> None:
    """The finder refuses what is not listed, and all below it, and leaves the rest to others."""
    finder = imports.OnlyTheList()
    for name in ("json", "numpy.fft", "pygame", "encodings.idna"):
        finder.find_spec(name)
    for name in ("lesson_code.course.grading", "pymunk", "scipy.optimize", "lesson_code_2"):
        with pytest.raises(ModuleNotFoundError, match="answers can use Python's own modules, Num"):
            finder.find_spec(name)
