"""What can be earned without a formula, by way: packages, constants, the released tables."""

from __future__ import annotations

import ctypes
import importlib.util
import json
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.grading.grader import Grader, grade
from lesson_code.course.grading.practice import practice_draws
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.verdict import CONSTANT, judge
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.inside.answers import plain

from ..conftest import Write

SEED = 7
MOST_SHARE = 0.03
"""Of all points: what may be earned by answers that were looked up, or are always the same."""

FREQUENT = 12
"""Answers of the released tables that are tried as constants: the most frequent ones."""

ANYBODYS = (None, 0.0, 1.0, True, False, [], [0.0, 0.0])
"""Constants that everybody would try."""


def released(task: Task) -> dict[str, Any]:
    """Return the right answers that a student's copy holds for practice, by their inputs."""
    return {
        key(call[0]): call[1]
        for criterion in task.criteria
        for draw in practice_draws(task, criterion)
        for call in draw
    }


def key(arguments: Arguments) -> str:
    """Return what tells one call from another."""
    return json.dumps(plain(list(arguments)))


def points_of_constant(task: Task, value: Any) -> int:
    """Return what an answer earns that is always the same."""
    return judge(task, lambda *_: CallOutcome("returned", value), SEED).points


def points_of_table(task: Task, table: dict[str, Any], otherwise: Any) -> int:
    """Return what an answer earns that looks its inputs up, and says something else otherwise."""

    def call(_: str, arguments: Arguments) -> CallOutcome:
        return CallOutcome("returned", table.get(key(arguments), otherwise))

    return judge(task, call, SEED).points


def constants(table: dict[str, Any]) -> Iterator[Any]:
    """Yield the constants worth trying."""
    yield from ANYBODYS
    often = Counter(json.dumps(value) for value in table.values())
    yield from (json.loads(text) for text, _ in often.most_common(FREQUENT))


@pytest.mark.full
def test_constants_and_released_tables_earn_next_to_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Constants earn nothing at all; tables, with the best constant besides, under 3 %."""
    monkeypatch.setattr("lesson_code.course.grading.verdict.diagnoses", lambda *_: ())
    constant, table, full, by_way = 0, 0, 0, []
    for task in (task for exercise in exercises() for task in exercise.tasks):
        known = released(task)
        tried = list(constants(known))
        constant += max(points_of_constant(task, value) for value in tried)
        looked_up = max(points_of_table(task, known, value) for value in tried)
        by_way += [f"{task.title}: {looked_up}"] if looked_up else []
        table, full = table + looked_up, full + task.points
    assert constant == 0
    assert table < MOST_SHARE * full, by_way


@pytest.mark.parametrize("value", [None, 0.0, [0.0, 0.0]], ids=str)
def test_constant_is_told_what_is_wrong(value: Any) -> None:
    """Where None is the right answer to some calls, None for all of them is no answer."""
    task = next(task for task in _exercise("billiards").tasks if task.id == "B.2")
    verdict = judge(task, lambda *_: CallOutcome("returned", value), SEED)
    assert verdict.points == 0
    by_chance = [mark for mark in verdict.criteria if mark.message == CONSTANT]
    assert bool(by_chance) == (value is None)


def _exercise(name: str) -> Exercise:
    """Return an exercise by its name."""
    return next(exercise for exercise in exercises() if exercise.name == name)


PYMUNK = """\
import pymunk
def elastic_1d(m1, v1, m2, v2):
    {inside}
    space = pymunk.Space()
    bodies = []
    for mass, x, v in ((m1, -2.0, v1), (m2, 2.0, v2)):
        body = pymunk.Body(mass, float("inf"))
        body.position, body.velocity = (x, 0), (v, 0)
        shape = pymunk.Circle(body, 1.0)
        shape.elasticity = 1.0
        space.add(body, shape)
        bodies.append(body)
    for _ in range(1000):
        space.step(0.001)
    return bodies[0].velocity.x, bodies[1].velocity.x
"""


@pytest.mark.parametrize("inside", ["pass", "import pymunk", "pymunk = __import__('pymunk')"])
def test_physics_engine_of_others_earns_nothing(write: Write, inside: str) -> None:
    """However it is imported, pymunk is refused in a sentence that names the list."""
    report = grade(write("answer.py", PYMUNK.format(inside=inside)), exercise="01", seed=SEED)
    assert report.points == 0
    assert "answers can use Python's own modules, NumPy and pygame" in report.verdicts[0].lines[1]


LOADS = """\
import ctypes
def elastic_1d(m1, v1, m2, v2):
    return [ctypes.CDLL({library!r}).cpSpaceNew is None]
"""


def test_library_of_a_physics_engine_is_out_of_reach(write: Write) -> None:
    """What ctypes could load is not there: the folders of other packages are empty for a child."""
    spec = importlib.util.find_spec("pymunk")
    places = (spec and spec.submodule_search_locations) or ()
    libraries = [
        path for place in places for path in Path(place).parent.glob("*pymunk*/*chipmunk*.so")
    ]
    assert libraries
    assert ctypes.CDLL(str(libraries[0]))
    with Grader() as grader:
        if grader.isolation.level != "full":
            pytest.skip("files are hidden by a full wall only")
        path = write("answer.py", LOADS.format(library=str(libraries[0])))
        report = grader.grade(path, exercise="01", seed=SEED)
    assert report.points == 0
    assert "cannot open shared object file" in report.verdicts[0].lines[1]


BRINGS = """\
import ctypes, os
from pathlib import Path
folder = Path(os.__file__).parent / "lib-dynload"
LIBRARY = min(folder.glob("*.so"), key=lambda path: path.stat().st_size).read_bytes()
def elastic_1d(m1, v1, m2, v2):
    Path("mine.so").write_bytes(LIBRARY)
    ctypes.CDLL(str(Path("mine.so").resolve()))
    return 0.0, 0.0
"""


def test_library_that_a_submission_brings_along_is_not_loaded(write: Write) -> None:
    """Nothing that stands in its folder is machine code, so that no physics engine is packed."""
    with Grader() as grader:
        if grader.isolation.rung != "namespaces":
            pytest.skip("only there the folder is mounted by us")
        report = grader.grade(write("answer.py", BRINGS), exercise="01", seed=SEED)
    assert "failed to map segment" in report.verdicts[0].lines[1]
