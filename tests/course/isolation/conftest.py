"""What the tests of isolation share: every rung of the ladder that this machine allows."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from lesson_code.course.grading.submission import Unit
from lesson_code.course.isolation import (
    RUNGS,
    Children,
    IsolationError,
    Limits,
    Rung,
    isolated,
    opened,
)
from lesson_code.course.isolation.inside.reading import parsed

BY_NAME = {rung.name: rung for rung in RUNGS}


def units(source: str) -> tuple[Unit, ...]:
    """Return code as a submission that keeps all of its statements in one group."""
    lines = tuple(statement.lineno for statement in parsed(source))
    return (Unit("your test", source, (tuple(range(len(lines))),), lines),)


def open_or_skip(rung: Rung, limits: Limits) -> Children:
    """Return who makes children on a rung, or skip where the system has no such rung."""
    try:
        return opened(rung, limits)[0]
    except IsolationError as error:
        pytest.skip(f"no rung {rung.name} here: {error}")


@pytest.fixture(scope="session", params=list(BY_NAME))
def rung(request: pytest.FixtureRequest) -> Rung:
    """Return each rung in turn."""
    return BY_NAME[request.param]


@pytest.fixture(scope="session")
def children(rung: Rung) -> Iterator[Children]:
    """Return who makes children on each rung in turn, with the usual limits."""
    made = open_or_skip(rung, Limits())
    yield made
    made.close()


@pytest.fixture
def children_with(rung: Rung) -> Iterator[Callable[[Limits], Children]]:
    """Return a function that returns who makes children with other limits."""
    made: list[Children] = []

    def make(limits: Limits) -> Children:
        made.append(open_or_skip(rung, limits))
        return made[-1]

    yield make
    for one in made:
        one.close()


@pytest.fixture(scope="session")
def best() -> Iterator[Children]:
    """Return who makes children on the highest rung there is."""
    with isolated(Limits()) as (made, _):
        yield made
