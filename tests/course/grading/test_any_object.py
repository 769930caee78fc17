"""Whatever objects a submission's functions return or raise: each is judged across the wall."""

from __future__ import annotations

import json

import pytest
from clock import at_most
from tiers import share

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.grader import Grader

from ..conftest import Write

ROUNDS = 4
"""Submissions an exercise: some 1,400 answers in all; 24 made 8,673, and ended no grader either."""

SECONDS_OF_THE_PARENT = 5.0
"""For a submission; 0.5 s is usual, and the first one of an exercise takes 2 s."""

OBJECTS = '''
import array, asyncio, collections, datetime, decimal, fractions, io, itertools, random, sys, types
import numpy as np
import pygame

STREAM = random.Random({seed})


class Anything:
    """Has every attribute, is of every class, and agrees with all."""
    def __getattr__(self, name):
        return self
    def __call__(self, *_, **__):
        return self
    __eq__ = __lt__ = __le__ = __gt__ = __ge__ = __bool__ = lambda *_: True
    __iter__ = __next__ = __getitem__ = __enter__ = lambda self, *_: self
    __class__ = property(lambda self: STREAM.choice((float, int, list, tuple, str, bool, dict)))
    __hash__ = None


class Fails:
    """Raises whatever is asked of it."""
    def fail(self, *_, **__):
        raise STREAM.choice((ValueError, SystemExit, RecursionError, MemoryError, StopIteration))
    __eq__ = __repr__ = __str__ = __iter__ = __len__ = __float__ = __int__ = __index__ = fail
    __array__ = __getitem__ = __bool__ = __hash__ = __complex__ = __getattr__ = fail


class Number(float):
    __eq__ = __le__ = __ge__ = lambda *_: True
    __float__ = lambda self: Number(7.5)
    __sub__ = __rsub__ = __abs__ = lambda *_: 0.0
    __hash__ = None
    __repr__ = lambda self: "\\x1b[2J"


class Whole(int):
    __int__ = __index__ = lambda self: Whole(10**30)


class Ratio:
    as_integer_ratio = lambda self: (1, 0)
    __float__ = lambda self: "1.0"


class Scalar:
    shape = ()
    def item(self):
        return [Scalar(), np.array(Scalar(), dtype=object)]


class Row(list):
    def __iter__(self):
        return itertools.chain(super().__iter__(), [Number(1), Whole(2), None])
    __len__ = lambda self: 2


class Text(str):
    __str__ = __repr__ = lambda self: "0.0"


class Array(np.ndarray):
    __eq__ = __abs__ = lambda self, *_: self
    def __iter__(self):
        yield self
        yield from (1.0, 2.0)


class Error(Exception):
    __str__ = lambda self: "x" * 10**7
    __name__ = property(lambda self: 1 / 0)


def ring():
    ring = []
    ring += [ring, 1.0]
    return ring


def deep(levels):
    return [deep(levels - 1)] if levels else 1.0


def gives_up():
    yield 1.0
    errors = ValueError("\\x1b[2J"), SystemExit(0), Error(), ExceptionGroup("e", [Error()])
    raise STREAM.choice(errors)


async def later():
    return 1.0


MAKERS = (
    Anything, Fails, Number, Whole, Ratio, Scalar, ring, gives_up, later, object, dict, set, list,
    lambda: Row([1.0, 2.0]), lambda: Text("left"), lambda: np.zeros(2).view(Array),
    lambda: deep(STREAM.randrange(30)), lambda: deep(900),
    lambda: STREAM.choice((0, -0.0, 1e308, -1e308, 5e-324, 10**308, 10**400, 2**53 + 1, True)),
    lambda: STREAM.choice((float("nan"), float("inf"), complex("nan+infj"), 1j, None, ..., "")),
    lambda: STREAM.choice((decimal.Decimal("sNaN"), decimal.Decimal("1e9999"), NotImplemented)),
    lambda: STREAM.choice((fractions.Fraction(10**400, 3), fractions.Fraction(1, 3))),
    lambda: np.array([[1.0, np.nan], [np.inf, 2.0]]), lambda: np.array([1, "a"], dtype=object),
    lambda: np.array(Fails(), dtype=object), lambda: np.zeros(2, dtype=[("x", float), ("y", "U3")]),
    lambda: np.float32(0.1), lambda: np.longdouble("1e4000"), lambda: np.datetime64("2026-11-25"),
    lambda: np.ma.masked, lambda: np.ma.array([1.0, 2.0], mask=[1, 0]), lambda: np.void(b"1"),
    lambda: np.zeros((0, 2)), lambda: np.zeros((2, 1)), lambda: np.zeros((200, 200)),
    lambda: array.array("d", [1.0, 2.0]), lambda: memoryview(b"ab"), lambda: bytearray(b"ab"),
    lambda: collections.deque([1.0, 2.0]), lambda: range(10**15), lambda: itertools.count(),
    lambda: itertools.repeat([]), lambda: map(float, "ab"), lambda: zip([1.0], [2.0]),
    lambda: iter(int, 1), lambda: collections.Counter("ab"), lambda: {1.0: 2.0}.values(),
    lambda: collections.ChainMap({1.0: 2.0}), lambda: types.SimpleNamespace(x=1.0),
    lambda: datetime.timedelta(1), lambda: io.StringIO("1\\n2\\n"), lambda: sys, lambda: type,
    lambda: pygame.Vector2(1, float("nan")), lambda: pygame.Rect(1, 2, 3, 4),
    lambda: pygame.Surface((1, 1)), lambda: ValueError("returned"), lambda: lambda: 1.0,
    lambda: "\\ud800\\x1b]0;\\x07=cmd()\\u202e<script>", lambda: "x" * 10**6, lambda: b"\\x00\\xff",
)


def answer(*_):
    kind = STREAM.random()
    if kind < 0.05:
        errors = Error(), KeyError("\\x1b[2J"), StopIteration(Fails()), SystemExit("4/4")
        raise STREAM.choice(errors)
    if kind < 0.55:
        return STREAM.choice(MAKERS)()
    if kind < 0.85:
        return tuple(STREAM.choice(MAKERS)() for _ in range(STREAM.randrange(1, 5)))
    return [STREAM.gauss(0, 1) for _ in range(STREAM.randrange(1, 5))]
'''


@pytest.mark.one_in(9)
@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_any_object_returned_or_raised_is_judged(
    exercise: Exercise, grader: Grader, write: Write
) -> None:
    """Every task of the exercise has its marks, none full, and its lines can be shown anywhere."""
    for seed in range(share(ROUNDS, ROUNDS)):
        functions = "".join(
            f"def {task.function}(*_): return answer()\n" for task in exercise.tasks
        )
        path = write("answer.py", OBJECTS.replace("{seed}", str(seed)) + functions)
        with at_most(SECONDS_OF_THE_PARENT):
            report = grader.grade(path, exercise=exercise.name, seed=seed)
        assert report.notes == ()
        json.dumps(report.as_dict(), ensure_ascii=False).encode()
        for verdict in report.verdicts:
            assert not verdict.is_full
            assert all(line.isprintable() for line in verdict.lines)
