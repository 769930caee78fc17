"""``workbook grade``: exit codes, one line for what cannot be graded, JSON, seed."""

from __future__ import annotations

import json
import subprocess
import sysconfig
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner, Result

from lesson_code.cli import app

FOLDER = Path(__file__).parents[1] / "golden"
WORKBOOK = Path(sysconfig.get_path("scripts")) / "workbook"


def workbook(*arguments: object) -> Result:
    """Run the command, here."""
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def graded(*arguments: str) -> dict[str, Any]:
    """Return what ``workbook grade --json`` prints."""
    name, *options = arguments
    value: dict[str, Any] = json.loads(workbook("grade", FOLDER / name, *options, "--json").stdout)
    return value


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("missing.ipynb", None, "no such file"),
        ("empty.ipynb", b"", "is empty"),
        ("broken.ipynb", b"{", "is not a notebook"),
        ("binary.py", b"\xff\xfd", "is not text"),
        ("unknown.py", b"def f(): pass", "say it with --exercise"),
    ],
)
def test_grade_of_what_cannot_be_graded_exits_2_with_a_line(
    tmp_path: Path, name: str, content: bytes | None, reason: str
) -> None:
    """Exit code 2, one line on standard error with the file's name, and nothing else."""
    if content is not None:
        (tmp_path / name).write_bytes(content)
    ran = workbook("grade", tmp_path / name, "--json")
    assert ran.exit_code == 2
    assert ran.stdout == ""
    assert len(ran.stderr.splitlines()) == 1
    assert name in ran.stderr
    assert reason in ran.stderr


def test_grade_as_a_command_of_its_own(tmp_path: Path) -> None:
    """The installed command says the same, without a traceback."""
    ran = subprocess.run(
        [WORKBOOK, "grade", "missing.ipynb"],
        cwd=tmp_path, capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert (ran.returncode, ran.stdout) == (2, "")
    assert ran.stderr == "workbook: missing.ipynb: no such file\n"


def test_grade_of_long_path_is_not_broken_over_lines(tmp_path: Path) -> None:
    """The line that names the file stays one line, however long the path."""
    path = tmp_path / ("long" * 30) / "missing.py"
    ran = workbook("grade", path)
    assert ran.exit_code == 2
    assert f"{path}: no such file\n" in ran.stderr


@pytest.mark.parametrize(
    ("name", "code", "points"),
    [("right_notebook.ipynb", 0, 10), ("wrong_model.ipynb", 1, 7), ("untouched.ipynb", 1, 0)],
)
def test_grade_exit_code_says_whether_marks_are_full(name: str, code: int, points: int) -> None:
    """Exit code 0 for full marks and 1 otherwise; JSON is one object of version 3."""
    ran = workbook("grade", FOLDER / name, "--json")
    value = json.loads(ran.stdout)
    assert ran.exit_code == code
    assert (value["version"], value["command"], value["points"]) == (3, "grade", points)
    assert ran.stderr == ""


def test_grade_seed_repeats_marks_and_messages() -> None:
    """With the seed of a first run, a second one prints the same."""
    first = graded("wrong_model.ipynb")
    assert graded("wrong_model.ipynb", "--seed", str(first["seed"])) == first


def test_grade_exercise_can_be_named() -> None:
    """A submission is graded as the exercise that is asked for."""
    value = graded("right_notebook.ipynb", "--exercise", "02")
    assert (value["exercise"], value["points"]) == ("02_restitution", 0)


def test_grade_under_nbval_says_that_it_has_no_isolation() -> None:
    """Before nbval starts it says so, and its JSON says "none"."""
    ran = workbook("grade", FOLDER / "wrong_model.ipynb", "--nbval", "--json")
    value = json.loads(ran.stdout)
    assert ran.exit_code == 1
    assert "without any isolation" in ran.stderr
    assert (value["version"], value["isolation"]) == (1, "none")
    assert [task["passed"] for task in value["tasks"]] == [False, True, True]


def test_grade_with_full_isolation_says_what_was_in_force() -> None:
    """--isolation full grades behind a full wall, or not at all and says why."""
    ran = workbook(
        "grade", FOLDER / "right_program.py", "--exercise", "02", "--isolation", "full", "--json"
    )
    if ran.exit_code == 2:
        assert "isolation full is not to be had here" in ran.stderr
    else:
        assert json.loads(ran.stdout)["isolation"]["level"] == "full"


def test_grade_with_an_unknown_level_of_isolation_exits_2() -> None:
    """A level that does not exist is one line that lists those that do."""
    ran = workbook("grade", FOLDER / "right_program.py", "--isolation", "high")
    assert ran.exit_code == 2
    assert "isolation must be full, limits or none, got 'high'" in " ".join(ran.stderr.split())
