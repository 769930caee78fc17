"""What a student is told: plainly, once, and nothing that is to stay hidden."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import pytest

from lesson_code.course.grading.exercises import exercise_by_name, task_by_id
from lesson_code.course.grading.feedback import QUESTIONS, missing_function
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.verdict import Verdict, judge

from ..conftest import Write

TELLS_ALL = """\
def elastic_1d(m1, v1, m2, v2):
    seen.append((m1, v1, m2, v2))
    raise type(f"Error{m1}", (Exception,), {})(f"{m1} {v1}")
seen = []
def inelastic_1d(m1, v1, m2, v2):
    return type(f"Value{m1}", (), {})()
def elastic_impulse_1d(m1, v1, m2, v2):
    return seen
"""


def judged(function: object, task: str = "1.1") -> Verdict:
    """Return the verdict on an answer to a task."""
    asked = task_by_id(task)
    return judge(asked, partial(call_here, {asked.function: function}), 1)


def test_missing_function_that_could_not_be_read_says_why() -> None:
    """The line with the syntax error stands where the student looks for the marks."""
    lost = {"reflect": "your cell 4, line 1: expected ':', in: def reflect(v, n)"}
    assert missing_function("reflect", ["reflex"], lost) == (
        "reflect could not be read (your cell 4, line 1: expected ':', in: def reflect(v, n))"
    )


@pytest.mark.parametrize("misspelt", ["elastic1d", "Elastic_1d", "elastic_1D", "elasitc_1d"])
def test_missing_function_that_is_misspelt_is_found(misspelt: str) -> None:
    """A name that is almost the one asked for is offered, the nearest alone."""
    said = missing_function("elastic_1d", ["plot", misspelt, "helper"], {})
    assert said == f"there is no function named elastic_1d; did you mean {misspelt}?"


def test_missing_function_without_a_likely_name_is_just_missing() -> None:
    """Nothing is offered that is not near."""
    assert missing_function("mtv", ["draw_all"], {}) == "there is no function named mtv"


def test_graded_misspelt_and_unreadable_functions_are_named(write: Write) -> None:
    """Through the whole grader: the misspelt one is offered, the unreadable one has its line."""
    path = write(
        "answer.ipynb",
        "def elastic1d(m1, v1, m2, v2): return v2, v1",
        "import math\ndef inelastic_1d(m1, v1, m2, v2)\n    return 0, 0",
        "def elastic_impulse_1d(m1, v1, m2, v2): return 0.0",
    )
    with Grader() as grader:
        first, second, _ = grader.grade(path, exercise="01", seed=1).verdicts
    assert first.lines[1:] == ["  there is no function named elastic_1d; did you mean elastic1d?"]
    assert second.lines[1] == (
        "  inelastic_1d could not be read "
        "(your cell 2, line 2: expected ':', in: def inelastic_1d(m1, v1, m2, v2))"
    )


def test_name_from_an_import_that_is_left_out_is_said_to_be(write: Write) -> None:
    """An answer that uses the lesson's own formula is told why the name is not there."""
    path = write(
        "answer.py",
        "from lesson_code.formulas import elastic_1d as ours\n"
        "def elastic_1d(m1, v1, m2, v2):\n    return ours(m1, v1, m2, v2)\n",
    )
    with Grader() as grader:
        lines = grader.grade(path, exercise="01", seed=1).verdicts[0].lines
    assert "ours comes from an import of lesson_code, which is left out" in lines[1]


@pytest.mark.parametrize(
    ("before", "said"),
    [
        ("two = await slow()", "two comes from a line with await, which is left out"),
        ("async with slow() as two:\n    pass", "two comes from a line with await"),
        ("from lesson_code.formulas import *", "two may come from an import of lesson_code, which"),
    ],
)
def test_name_from_a_line_that_is_left_out_is_not_called_misspelt(
    write: Write, before: str, said: str
) -> None:
    """An answer is told which line gave the name, and is asked nothing about its spelling."""
    path = write("a.ipynb", before, "def elastic_1d(m1, v1, m2, v2):\n    return two * v1, v2\n")
    with Grader() as grader:
        lines = grader.grade(path, exercise="01", seed=1).verdicts[0].lines
    assert said in lines[1]
    assert QUESTIONS["NameError"] not in str(lines)


def test_error_is_told_once_with_its_place_and_a_question() -> None:
    """Three calls that fail alike are one line, without a traceback."""
    lines = judged(lambda *given: given[0] / 0).lines
    assert len(lines) == 3
    assert "It stopped with ZeroDivisionError: float division by zero." in lines[1]
    assert lines[1].endswith(QUESTIONS["ZeroDivisionError"])
    assert lines[2].startswith("  for the same reason: ")
    assert not any("Traceback" in line for line in lines)


def test_failures_of_different_reasons_are_all_told() -> None:
    """What is wrong in another way is told too, and what is right is said first."""

    def answer(m1: float, v1: float, m2: float, v2: float) -> object:
        if m1 == m2:
            return v2, v1
        return None if v2 == 0.0 else m1 / 0

    lines = judged(answer).lines
    assert lines[1] == "  right: equal masses"
    assert "is a return missing?" in lines[2]
    assert "ZeroDivisionError" in lines[3]
    assert lines[4] == "  for the same reason: unequal masses, one catching up"


def test_hidden_inputs_are_in_no_message(write: Write) -> None:
    """Whatever an answer does to tell its inputs, no message carries them on."""
    path = write("answer.py", TELLS_ALL)
    with Grader(hide_inputs=True) as hiding, Grader() as telling:
        hidden = hiding.grade(path, exercise="01", seed=1)
        told = telling.grade(path, exercise="01", seed=1)
    inputs = "0.82"  # the mass that seed 1 draws; test_verdict has it too
    assert inputs in str(told.as_dict())
    assert inputs not in str(hidden.as_dict())
    assert hidden.points == told.points == 0
    assert [v.criteria[0].message for v in hidden.verdicts] == [
        "It stopped with an error.",
        "It returned something that is no number, vector or tuple.",
        "It returned several values where one number was asked for.",
    ]


def test_hidden_inputs_leave_the_hint(write: Write) -> None:
    """A recognised misconception gets its hint, inputs hidden or not."""
    path = write("answer.py", "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n")
    with Grader(hide_inputs=True) as grader:
        verdict = grader.grade(path, exercise="01", seed=1).verdicts[0]
    assert verdict.lines[-1] == f"  hint: {task_by_id('1.1').wrong_models[0].hint}"
    assert "Called" not in str(verdict.lines)


def test_grader_grades_one_after_another_alike(write: Write) -> None:
    """A grader that is kept gives each submission what a grader of its own would."""
    right = exercise_by_name("01")
    paths = [
        write("wrong.py", "def elastic_1d(m1, v1, m2, v2): return v2, v1"),
        write("exits.py", "import os\ndef elastic_1d(*_): os._exit(0)"),
        write("hangs.py", "def elastic_1d(*_):\n    raise KeyError"),
    ]
    with Grader() as grader:
        kept = [grader.grade(p, exercise=right.name, seed=3).as_dict() for p in paths * 2]
    alone = []
    for path in paths:
        with Grader() as grader:
            alone.append(grader.grade(path, exercise=right.name, seed=3).as_dict())
    assert kept == alone * 2


def test_grader_stays_usable_after_a_file_that_cannot_be_graded(write: Write) -> None:
    """A file without code is an error of its own, and the next one is graded."""
    right = write("right.py", "def elastic_1d(m1, v1, m2, v2): return v2, v1")
    with Grader() as grader:
        with pytest.raises(ValueError, match="is empty"):
            grader.grade(write("empty.py", ""))
        assert grader.grade(right, exercise="01", seed=1).points == 1


def test_answer_of_another_form_is_shown_as_it_came() -> None:
    """A list that cannot be put in order is not said to be None, and None not to be a text."""
    flat = judged(lambda vertices: [x for vertex in vertices for x in vertex], "6.1").lines[1]
    assert "It returned (" in flat
    assert "Three values were asked for, and there are six." in flat
    nothing = judged(lambda *_: 0.0, "6.3").criteria[2].message
    assert "It returned 0, which counts as 'overlap'; expected 'no overlap'. There is" in nothing


def test_axis_that_is_no_number_is_shown() -> None:
    """An edge from a vertex to itself gives 0/0, and does not hide another axis."""

    def of_every_edge(vertices: Any) -> list[Any]:
        edges = np.roll(vertices, -1, axis=0) - vertices
        return [np.array([-y, x]) / np.hypot(x, y) for x, y in edges]

    with np.errstate(invalid="ignore"):
        said = judged(of_every_edge, "6.1").criteria[2].message
    assert "(nan, nan)" in said
    assert "Five values were asked for, and there are six." in said


@pytest.mark.parametrize(
    ("name", "line"),
    [("np", "import numpy as np"), ("math", "import math"), ("hypot", "from math import hypot")],
)
def test_import_that_is_missing_is_named(name: str, line: str) -> None:
    """A name that an import usually gives is not one that was spelt in another way."""
    scope: dict[str, Any] = {}
    exec(f"def answer(*_): return {name}.sqrt(2.0)", scope)  # noqa: S102
    assert f"Is `{line}` missing?" in judged(scope["answer"]).lines[1]
    assert "missing" not in judged(lambda *_: m_1).lines[1]  # noqa: F821


def test_bodies_that_are_left_alone_are_said_to_be() -> None:
    """Equal masses make it the right answer in another order, and that is not what was done."""
    verdict = judged(lambda *given: given[1::2])
    assert "That is v1 and v2 as they came in." in verdict.criteria[0].message
    assert verdict.diagnoses[0].name == "given"
    assert "v1 and v2 come back as they came in." in verdict.diagnoses[0].hint


@pytest.mark.parametrize(("task", "kept"), [("1.2", 1), ("8.4", 1)])
def test_value_too_few_is_no_factor(task: str, kept: int) -> None:
    """The 2 that says how many values there are is no factor of 2."""

    def short(*arguments: Any) -> Any:
        return (task_by_id(task).expected(*arguments) or ())[:kept] or None

    assert "factor" not in str(judged(short, task).lines)


def test_answer_that_is_always_none_is_not_taken_for_another() -> None:
    """Where a return is missing, nothing was thought of which circles may meet."""
    assert judged(lambda *_: None, "7.4").diagnoses == ()


def test_hidden_message_says_of_what_kind_an_answer_is(write: Write) -> None:
    """That there is no return, or one number for two, tells nothing of the inputs."""
    path = write(
        "answer.py",
        "def elastic_1d(m1, v1, m2, v2): return v1\n"
        "def inelastic_1d(m1, v1, m2, v2): v = 0.0, 0.0\n"
        "def elastic_impulse_1d(m1, v1, m2, v2): return {m1, v1}\n",
    )
    with Grader(hide_inputs=True) as grader:
        first, second, third = grader.grade(path, exercise="01", seed=1).verdicts
    assert (
        first.criteria[0].message == "It returned one number where several values were asked for."
    )
    assert second.criteria[0].message == "It returned None where several values were asked for."
    assert third.criteria[0].message == (
        "It returned a set where the order counts: a set has none, a list or tuple has."
    )
