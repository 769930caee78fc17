"""The report: its JSON form and its table."""

from __future__ import annotations

import io
import json
import os

import pytest
from rich.console import Console

from lesson_code.cli.shared import say_error
from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.grading.grader import grade
from lesson_code.course.grading.report import Report, print_report

from ..conftest import Write

SWAPS = "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n"
RIGHT = """\
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v
"""


def printed(report: Report, width: int = 200) -> str:
    """Return what is printed of a report."""
    text = io.StringIO()
    print_report(report, Console(file=text, width=width, force_terminal=False))
    return text.getvalue()


@pytest.fixture
def report(write: Write) -> Report:
    """Return the report of a submission with a wrong, a right and a missing answer."""
    return grade(write("answer.ipynb", SWAPS, RIGHT, "1 / 0\nx = 1 /"), exercise="01", seed=1)


def test_report_as_dict_is_one_json_object(report: Report) -> None:
    """The JSON form holds version, marks, criteria, the recognised wrong model and the seed."""
    value = json.loads(json.dumps(report.as_dict()))
    assert list(value) == [
        "version", "command", "submission", "exercise", "seed", "isolation", "points",
        "full_points", "tasks", "notes",
    ]  # fmt: skip
    assert (value["version"], value["command"], value["seed"]) == (3, "grade", 1)
    assert value["submission"].endswith("answer.ipynb")
    assert value["exercise"] == "01_one_dimension"
    assert value["isolation"] == report.isolation.as_dict()
    assert (value["points"], value["full_points"]) == (4, 10)
    assert value["notes"] == ["your cell 3, line 2: invalid syntax, in: x = 1 /"]
    assert [task["points"] for task in value["tasks"]] == [1, 3, 0]
    first = value["tasks"][0]
    assert list(first) == [
        "task", "function", "points", "full_points", "criteria", "lent", "wrong_model",
    ]  # fmt: skip
    assert first["wrong_model"]["name"] == "always_swaps"
    assert first["wrong_model"]["hint"]
    assert value["tasks"][1]["wrong_model"] is None
    assert first["criteria"][0] == {
        "name": "equal masses", "points": 1, "full_points": 1, "message": "",
    }  # fmt: skip


def test_report_points_are_the_sums_of_their_parts(report: Report) -> None:
    """Points add up from criteria to tasks to the submission."""
    value = report.as_dict()
    assert value["points"] == sum(task["points"] for task in value["tasks"])
    assert value["full_points"] == sum(task["full_points"] for task in value["tasks"])
    for task in value["tasks"]:
        assert task["points"] == sum(criterion["points"] for criterion in task["criteria"])


def test_report_same_seed_gives_the_same_report(write: Write) -> None:
    """With a seed, marks and messages repeat; without, the inputs differ between runs."""
    path = write("answer.py", SWAPS)
    assert grade(path, seed=3).as_dict() == grade(path, seed=3).as_dict()
    assert len({grade(path).seed for _ in range(4)}) > 1


def test_report_table_shows_marks_hint_notes_seed_and_isolation(report: Report) -> None:
    """A reader finds the marks, what to mend, the hint, what was left out, seed and isolation."""
    text = printed(report)
    for part in (
        "answer.ipynb: One dimension",
        "1/4",
        "3/3",
        "0/3",
        "4/10",
        "Called elastic_1d(",
        "hint: Only equal masses exchange velocities.",
        "there is no function named elastic_impulse_1d",
        "left out: your cell 3, line 2: invalid syntax, in: x = 1 /",
        f"seed 1, isolation: {report.isolation}",
    ):
        assert part in text


def test_report_of_full_marks_has_nothing_to_mend(root: object) -> None:
    """A full mark prints the table and no message."""
    report = grade(exercise_by_name("01").solution(root), seed=1)  # type: ignore[arg-type]
    assert report.is_full
    assert "10/10" in printed(report)
    assert "Called" not in printed(report)


def test_report_cannot_be_forged_by_words_of_the_submission(write: Write) -> None:
    """Escape sequences, line ends, markup and lone surrogates come through as plain text."""
    source = """\
def elastic_1d(m1, v1, m2, v2):
    raise ValueError("\\x1b[2J\\r\\n1.1 elastic_1d: 4/4 points\\ud800[bold]")
def inelastic_1d(m1, v1, m2, v2):
    return "\\x1b[2J\\n\\ud800[red]", "[/red]"
raise KeyError("\\x1b[2J\\n[blink]\\ud800")
"""
    text = printed(grade(write("answer.ipynb", source), exercise="01", seed=1))
    text.encode()
    assert "\x1b" not in text
    assert "\r" not in text
    assert not any(line.startswith("1.1 elastic_1d: 4/4") for line in text.splitlines())
    assert "[bold]" in text


def test_error_sends_nothing_of_a_files_name_to_the_terminal(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """What is said of a file that cannot be graded names it in the same way."""
    say_error("workbook: a\x1b[2Jb\u202e.py: is empty\nsee the handbook")
    assert capsys.readouterr().err == "workbook: a [2Jb .py: is empty\nsee the handbook\n"


@pytest.mark.skipif(os.name != "posix", reason="other systems refuse such a name")
def test_report_sends_nothing_of_a_files_name_to_the_terminal(write: Write) -> None:
    """A file's name is shown without what a terminal would obey."""
    named = grade(write("a\x1b[2Jb\u202e.py", "x = 1"), exercise="01")
    lines = printed(named).splitlines()
    assert "a [2Jb .py: " in lines[0]
    assert all(line.isprintable() for line in lines)


def test_report_without_exercise_goes_by_the_submission(write: Write) -> None:
    """The exercise is found by the functions, unless it is named."""
    path = write("answer.py", SWAPS)
    assert grade(path).exercise.name == "01_one_dimension"
    assert grade(path, exercise="02").exercise.name == "02_restitution"
    with pytest.raises(ValueError, match="exercise must be one of"):
        grade(path, exercise="99")
