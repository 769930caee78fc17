"""The gradebook: what counts, who is late, and what a class believes; from marks made by hand."""

from __future__ import annotations

from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.class_run.collect import HandIn, Paper
from lesson_code.course.class_run.gradebook import Gradebook, common_exercises, gradebook
from lesson_code.course.class_run.journal import key_of
from lesson_code.course.class_run.pages import to_teach
from lesson_code.course.class_run.roster import Enrolled
from lesson_code.course.grading.exercises import exercise_by_name

NOON = datetime(2026, 11, 20, 12, tzinfo=UTC)
ONE = exercise_by_name("01")


def paper(name: str, handed_in: datetime = NOON, digest: str = "digest") -> Paper:
    """Return a file that was handed in."""
    return Paper(name, Path(name), digest, handed_in)


def marks(*points: int, model: str | None = None, message: str = "wrong") -> dict[str, Any]:
    """Return the marks of an answer to exercise 01; a model is recognised in its first task."""
    tasks = [
        {
            "task": task.id,
            "function": task.function,
            "points": earned,
            "full_points": task.points,
            "criteria": [
                {
                    "name": criterion.name,
                    "points": int(earned == task.points),
                    "full_points": 1,
                    "message": "" if earned == task.points else message,
                }
                for criterion in task.criteria
            ],
            "wrong_model": {"name": model, "hint": "?"} if model and task.id == "1.1" else None,
            "diagnoses": [{"name": model, "says": model, "hint": "?"}]
            if model and task.id == "1.1"
            else [],
        }
        for task, earned in zip(ONE.tasks, points, strict=True)
    ]
    return {
        "exercise": ONE.name,
        "points": sum(points),
        "isolation": "full",
        "tasks": tasks,
        "notes": [],
    }


def book_of(*hand_ins: HandIn, marks_of: dict[str, Any], **options: Any) -> Gradebook:
    """Return the gradebook of some students; marks are named by their files."""
    papers = [paper for hand_in in hand_ins for paper in hand_in.papers]
    known = {key_of(paper): marks_of[paper.name] for paper in papers if paper.name in marks_of}
    return gradebook(hand_ins, known, exercises=options.pop("exercises", ()), seed=7, **options)


def hand_in(name: str, *papers: Paper, due: datetime | None = None) -> HandIn:
    """Return what a student handed in."""
    return HandIn(Enrolled(name, due=due), papers, entries=tuple(p.name for p in papers))


def test_students_without_marks_say_why() -> None:
    """Graded, missing, or handed in and not gradable: three different things, and 0 points."""
    book = book_of(
        hand_in("ada", paper("a.py")),
        hand_in("bob"),
        hand_in("eve", paper("e.py")),
        hand_in("lost", paper("l.py")),
        marks_of={"a.py": marks(4, 3, 0), "e.py": {"problem": "is empty"}},
    )
    statuses = {student.id: (student.status, student.points) for student in book.students}
    assert statuses == {
        "ada": ("graded", 7),
        "bob": ("missing", 0),
        "eve": ("not gradable", 0),
        "lost": ("not gradable", 0),
    }
    assert book.students[2].problems == ("e.py: is empty",)
    assert book.students[3].problems == ("l.py: has not been graded",)
    assert not book.is_complete


def test_newest_of_two_files_counts_whichever_comes_first() -> None:
    """Not the better one: more files are no more attempts. The other is named."""
    for order in ((0, 1), (1, 0)):
        files = [paper("a.py", NOON), paper("b.py", NOON + timedelta(seconds=1))]
        book = book_of(
            hand_in("ada", *(files[n] for n in order)),
            marks_of={"a.py": marks(4, 3, 3), "b.py": marks(0, 0, 3)},
        )
        (ada,) = book.students
        assert (ada.points, ada.problems) == (3, ())
        assert ada.notes == ("01_one_dimension: b.py counts, the newest; left out: a.py",)


def test_files_changed_last_in_the_same_second_do_not_count() -> None:
    """Nothing says which is meant: a problem names them, and the older one does not step in."""
    files = [paper(name, digest=name) for name in ("a.py", "b.py")]
    older = paper("c.py", NOON - timedelta(days=1))
    all_right = dict.fromkeys(("a.py", "b.py", "c.py"), marks(4, 3, 3))
    book = book_of(hand_in("ada", older, *files), marks_of=all_right)
    (ada,) = book.students
    assert (ada.points, ada.status) == (0, "not gradable")
    assert ada.problems == (
        "01_one_dimension: no file counts, since 2 were changed last in the same second: "
        "a.py, b.py; older: c.py; keep the one that is meant",
    )
    copies = book_of(hand_in("ada", paper("a.py"), paper("b.py")), marks_of=all_right)
    assert copies.students[0].points == 10


def test_broken_file_of_no_known_exercise_is_a_problem() -> None:
    """Beside an answer it does not count, and what is broken in it is said."""
    broken = marks(0, 0, 0) | {"is_assumed": True, "notes": ["line 1: invalid syntax"]}
    files = paper("a.py"), paper("b.py", NOON + timedelta(days=1))
    book = book_of(hand_in("ada", *files), marks_of={"a.py": marks(4, 3, 3), "b.py": broken})
    assert book.students[0].points == 10
    assert book.students[0].problems == ("b.py: line 1: invalid syntax",)


def test_file_of_helpers_beside_an_answer_is_no_problem() -> None:
    """It is noted and left out; alone, or where a file is broken, there is a problem."""
    helpers = {"problem": "nothing tells which exercise", "is_other": True}
    given = {"a.py": marks(4, 3, 3), "h.py": helpers, "b.ipynb": {"problem": "is empty"}}
    book = book_of(
        hand_in("ada", paper("h.py"), paper("a.py")),
        hand_in("bob", paper("h.py")),
        hand_in("eve", paper("a.py"), paper("b.ipynb")),
        marks_of=given,
    )
    ada, bob, eve = book.students
    assert (ada.problems, ada.notes) == ((), ("h.py: left out, it answers no exercise",))
    assert bob.problems == ("h.py: nothing tells which exercise",)
    assert eve.problems == ("b.ipynb: is empty",)


def test_late_is_after_the_students_own_time() -> None:
    """A file is late by when it was last changed; who has more time is not late yet."""
    late = paper("a.py", NOON + timedelta(days=1, hours=2, minutes=3))
    more = NOON + timedelta(days=2)
    book = book_of(
        hand_in("ada", late),
        hand_in("bob", late, due=more),
        hand_in("eve", paper("e.py")),
        marks_of={"a.py": marks(0, 0, 0), "e.py": marks(0, 0, 0)},
        due=NOON,
    )
    assert [student.status for student in book.students] == ["late", "graded", "graded"]
    assert book.students[0].late == ("a.py: 1 d 2 h 3 min late",)


def test_full_mark_is_that_of_the_exercises_that_are_graded() -> None:
    """Those that were asked for; if none were, those that the class has in common."""
    ada = hand_in("ada", paper("a.py"))
    handed_in = {"a.py": marks(4, 3, 3)}
    assert book_of(ada, marks_of=handed_in).full_points == 10
    two = book_of(ada, marks_of=handed_in, exercises=["01_one_dimension", "02_restitution"])
    assert two.full_points == 23


@pytest.mark.parametrize(
    ("handed_in", "count"),
    [
        ([["01"]], {"01"}),
        ([["01"], ["02"]], {"01", "02"}),
        ([["01"], ["01", "02"]], {"01"}),
        ([["01", "02"], ["01", "02"], ["03"]], {"01", "02"}),
        ([["01"]] * 18 + [["02"]] * 2, {"01", "02"}),
        ([["01"]] * 19 + [["02"]] * 2, {"01"}),
        ([["01"], ["01", "02"], ["02"], [], []], {"01", "02"}),
        ([[], []], set()),
    ],
)
def test_exercise_counts_if_the_class_has_it_in_common(
    handed_in: list[list[str]], count: set[str]
) -> None:
    """At least two files and a tenth of those with marks; if no two are to one, all count."""
    files = [{name: f"{n}/{name}.py" for name in names} for n, names in enumerate(handed_in)]
    assert common_exercises(files) == count


def test_file_that_a_group_shares_is_one_whoever_submitted_it() -> None:
    """A group of two or twenty makes no exercise count, and takes no other out of the count."""
    alone = [{"01": f"{n}.py"} for n in range(3)]
    groups = [{"01": "first.py"}] * 30 + [{"01": "second.py"}] * 30
    assert common_exercises([*alone, *[{"02": "group.py"}] * 2]) == {"01"}
    assert common_exercises([*groups, {"02": "mine.py"}]) == {"01"}


def test_group_that_hands_in_one_stray_file_changes_nobodys_full_mark() -> None:
    """Both of the group are told which file does not count."""
    shared = paper("pool.py")
    stray = marks(4, 3, 3) | {"exercise": "pool", "submission": "pool.py"}
    students = [hand_in(name, paper(f"{name}.py")) for name in ("ada", "bob")]
    group = [hand_in(name, shared) for name in ("eve", "fay")]
    marks_of = {"ada.py": marks(4, 3, 3), "bob.py": marks(4, 3, 3), "pool.py": stray}
    book = book_of(*students, *group, marks_of=marks_of)
    assert [student.points for student in book.students] == [10, 10, 0, 0]
    assert book.full_points == 10
    assert [len(student.problems) for student in book.students] == [0, 0, 1, 1]
    assert "which does not count: files of the class that answer it: 1;" in str(book.students[2])


def test_summary_counts_what_a_class_believes() -> None:
    """By task: means, full marks, stubs, what fails most, and the commonest misconception first."""
    given = {
        "a": marks(4, 3, 3),
        "b": marks(1, 3, 3, model="always_swaps"),
        "c": marks(1, 3, 0, model="always_swaps"),
        "d": marks(1, 0, 0, model="target_at_rest"),
        "e": marks(0, 0, 0, message="not written yet"),
    }
    book = book_of(*(hand_in(name, paper(name)) for name in given), marks_of=given)
    first = book.summary[0]
    assert (first.handed_in, first.full, first.not_written, first.mean) == (5, 1, 1, 7 / 5)
    assert dict(first.failed)["equal masses"] == 3
    assert [(m.name, m.students) for m in first.misconceptions] == [
        ("always_swaps", 2),
        ("target_at_rest", 1),
    ]
    assert [who.id for who in first.misconceptions[0].who] == ["b", "c"]
    assert [(s.task.id, m.students) for s, m in to_teach(book)] == [("1.1", 2), ("1.1", 1)]
