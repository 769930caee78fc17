"""Functions that are alike: remarked with both passages, for the instructor to read, never judged.

Alike are functions that share most of their fingerprints
(:mod:`lesson_code.course.isolation.inside.winnowing`): those of two students, or of a student and
of the lesson. What is short is written alike by everybody, and so is the answer to a task that has
one form: those are alike where they are the same word for word, with names of their author's own.
"""

from __future__ import annotations

import ast
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import combinations
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.answers import LONGEST_ANSWER
from lesson_code.course.class_run.student import MOST_COMPARED, Student
from lesson_code.course.fresh_copies import fresh_exercise
from lesson_code.course.grading.exercises import Exercise, marks_answers
from lesson_code.course.grading.submission import Submission
from lesson_code.course.isolation.inside.winnowing import fingerprints
from lesson_code.course.notebooks.root import home

FEWEST = 12
"""Fingerprints of a function that is long enough to tell: about eight lines."""

SHARE = 0.8
"""Of the fingerprints of the shorter one. Right answers that were found by other ways share 0.74 at
the most, and a copy with other names, comments and layout shares all of them."""

FEWEST_NAMES = 4
"""Names of one's own, of two letters or more, in functions of two files that are the same word for
word: one such function may be found twice by chance, where the task gives most of its names."""

MOST_HANDS = 3
"""Whose function may be the same: what more students write is what one writes."""

LESSON = ("formulas", "geometry", "reference", "chapters")
NOT_THE_LESSON = ("tasks", "draws")
"""Modules of a chapter, beside those that mark answers, that a student has not read."""


@dataclass(frozen=True)
class Passage:
    """A function: whose, which, its text and its fingerprints. Nobody's is the lesson's.

    A worded one is all functions of a file that are short or of one form, by their own names.
    """

    who: tuple[Student, ...]
    name: str
    text: str
    prints: frozenset[str]
    is_worded: bool = False


@dataclass(frozen=True)
class Alike:
    """Functions of an exercise that are alike, the lesson's first."""

    exercise: Exercise
    passages: tuple[Passage, ...]

    @property
    def who(self) -> tuple[Student, ...]:
        """The students whose functions these are."""
        return tuple(student for passage in self.passages for student in passage.who)


def passages_of(submission: Submission) -> list[dict[str, Any]]:
    """Return what tells of each function that is long enough, or has names of its author's own.

    Of very many, the longest: each is compared with those of all others.
    """
    found = [
        {**f, "text": _cut(lines, *f["lines"])}
        for unit in submission.units
        for lines in [unit.source.split("\n")]
        for f in unit.prints
        if len(f["prints"]) >= FEWEST or f["own"]
    ]
    if len(found) <= MOST_COMPARED:
        return found
    return sorted(found, key=lambda f: -len(f["prints"]))[:MOST_COMPARED]


def alike_in(students: Sequence[Student], exercises: Iterable[Exercise]) -> tuple[Alike, ...]:
    """Return what is alike among a class's answers, and what is like the lesson, by exercise."""
    return tuple(
        Alike(exercise, tuple(group))
        for exercise in exercises
        if (passages := list(_handed_in(students, exercise)))
        for group in (
            *_groups(
                [
                    *_lesson(),
                    *(p for p in passages if not p.is_worded),
                ],
                _alike_pairs,
            ),
            *_groups([p for p in passages if p.is_worded], _same_words),
        )
    )


def _handed_in(students: Sequence[Student], exercise: Exercise) -> Iterator[Passage]:
    """Yield the functions that were handed in for an exercise and tell something.

    Those that were given tell nothing.
    """
    of_file: dict[str, list[Student]] = defaultdict(list)
    for student in students:
        if exercise.name in student.papers:
            of_file[student.papers[exercise.name].name].append(student)
    given = fresh_exercise(exercise, home()) if of_file else ""
    usual = {task.function for task in exercise.tasks if task.has_one_form}
    for team in of_file.values():
        report: Mapping[str, Any] = team[0].reports.get(exercise.name, {})
        worded = []
        for found in report.get("passages", ()):
            if f"def {found['name']}(" in given and found["name"] not in exercise.task_ids:
                continue
            if len(found["prints"]) < FEWEST or found["name"] in usual:
                worded.append(found)
            else:
                prints = frozenset(found["prints"])
                yield Passage(tuple(team), found["name"], found["text"], prints)
        if marks := frozenset(_marks(worded)):
            names = ", ".join(found["name"] for found in worded)
            text = "\n\n".join(found["text"] for found in worded)
            yield Passage(tuple(team), names, text, marks, is_worded=True)


def _marks(worded: Iterable[Mapping[str, Any]]) -> Iterator[str]:
    """Yield a mark for each name of two letters or more that is its author's own."""
    for found in worded:
        yield from (f"{found['words']} {name}" for name in found["own"] if len(name) > 1)


def _is_secret(module: str) -> bool:
    """Return whether a module of a chapter is kept from students."""
    return module in NOT_THE_LESSON or marks_answers(module)


@cache
def _lesson() -> tuple[Passage, ...]:
    """Return the lesson's functions that are long enough to tell."""
    package = Path(__file__).parents[2]
    paths = [path for wing in LESSON for path in sorted((package / wing).rglob("*.py"))]
    found = []
    for path in (path for path in paths if not _is_secret(path.stem)):
        source = path.read_text(encoding="utf-8")
        for each in fingerprints(ast.parse(source).body):
            if len(each["prints"]) >= FEWEST:
                where = f"{path.relative_to(package.parent).as_posix()}: {each['name']}"
                text = _cut(source.split("\n"), *each["lines"])
                found.append(Passage((), where, text, frozenset(each["prints"])))
    return tuple(found)


def _groups(
    passages: list[Passage], pairs: Callable[[list[Passage]], Iterable[tuple[int, int]]]
) -> Iterator[list[Passage]]:
    """Yield the passages that are alike, in the order given; each stands in one group."""
    leader = list(range(len(passages)))

    def first(place: int) -> int:
        while leader[place] != place:
            place = leader[place]
        return place

    for a, b in pairs(passages):
        low, high = sorted((first(a), first(b)))
        leader[high] = low
    groups: dict[int, list[Passage]] = defaultdict(list)
    for place, passage in enumerate(passages):
        groups[first(place)].append(passage)
    for group in groups.values():
        if len(group) > 1 and any(passage.who for passage in group):
            yield group


def _alike_pairs(passages: list[Passage]) -> Iterator[tuple[int, int]]:
    """Yield the places of passages of different hands that share most of their fingerprints."""
    holding: dict[str, list[int]] = defaultdict(list)
    for place, passage in enumerate(passages):
        shared = Counter(other for mark in passage.prints for other in holding[mark])
        for other, count in sorted(shared.items()):
            least = min(len(passage.prints), len(passages[other].prints))
            if count >= max(FEWEST, SHARE * least) and passage.who != passages[other].who:
                yield other, place
        for mark in passage.prints:
            holding[mark].append(place)


def _same_words(passages: list[Passage]) -> Iterator[tuple[int, int]]:
    """Yield the places of files in which a few students alone have functions word for word."""
    holding: dict[str, list[int]] = defaultdict(list)
    for place, passage in enumerate(passages):
        for mark in passage.prints:
            holding[mark].append(place)
    few = [places for places in holding.values() if 1 < len(places) <= MOST_HANDS]
    shared = Counter(pair for places in few for pair in combinations(places, 2))
    yield from sorted(pair for pair, names in shared.items() if names >= FEWEST_NAMES)


def _cut(lines: list[str], first: int, last: int) -> str:
    """Return some lines of a text, as far as an instructor wants to read them."""
    text = "\n".join(lines[first - 1 : last])
    return text if len(text) <= LONGEST_ANSWER else f"{text[:LONGEST_ANSWER]}\n..."
