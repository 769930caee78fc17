"""Gradescope's autograder: the zip, run as Gradescope runs it, in a folder laid out like its own.

The places, the names of the two programs and the keys of results.json are those of
https://gradescope-autograders.readthedocs.io (Autograder Specifications, Submission Metadata).
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeAlias

import pytest
from typer.testing import CliRunner

from lesson_code.cli import app
from lesson_code.course.class_run.marking import seed_of
from lesson_code.course.fresh_copies import zipped
from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.release.gradescope import gradescope_files

from .conftest import RIGHT, SWAPS

ONE = exercise_by_name("01")
NUMBER = 123456
NOON = 1_790_000_000
"""When everything is handed in, s."""
SECONDS = 120

VISIBILITY = {"hidden", "after_due_date", "after_published", "visible"}
TEXT_FORMATS = {"text", "html", "simple_format", "md", "ansi"}
RESULTS: dict[str, type | tuple[type, ...] | set[str]] = {
    "score": (int, float),
    "execution_time": (int, float),
    "output": str,
    "output_format": TEXT_FORMATS,
    "visibility": VISIBILITY,
    "stdout_visibility": VISIBILITY,
    "tests": list,
}
TEST: dict[str, type | tuple[type, ...] | set[str]] = {
    "score": (int, float),
    "max_score": (int, float),
    "name": str,
    "number": str,
    "output": str,
    "output_format": TEXT_FORMATS,
    "visibility": VISIBILITY,
}
"""What the specification allows of the keys that we write."""

Submit: TypeAlias = Callable[[Mapping[str, str]], dict[str, Any]]

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Gradescope's containers are Linux")


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory, root: Path) -> Path:
    """Return the autograder of exercise 01."""
    path = tmp_path_factory.mktemp("gradescope") / "one.zip"
    path.write_bytes(zipped(gradescope_files(root, ["01"])))
    return path


@pytest.fixture
def submit(archive: Path, tmp_path: Path) -> Submit:
    """Return a function that hands in some files, and returns what the autograder says.

    In place of the environment that setup.sh makes stands this Python.
    """
    place = tmp_path / "autograder"
    for folder in ("source", "submission", "results", "environment/bin"):
        (place / folder).mkdir(parents=True)
    with zipfile.ZipFile(archive) as opened:
        opened.extractall(place / "source")
    python = place / "environment" / "bin" / "python"
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n')
    python.chmod(0o755)
    (place / "submission_metadata.json").write_text(json.dumps({"id": NUMBER, "users": []}))

    def run(files: Mapping[str, str]) -> dict[str, Any]:
        for name, text in files.items():
            path = place / "submission" / name
            path.write_text(text, encoding="utf-8")
            os.utime(path, (NOON, NOON))
        ran = subprocess.run(
            ["/usr/bin/env", "bash", place / "source" / "run_autograder", place],
            cwd=place,
            env={name: text for name, text in os.environ.items() if name != "PYTHONPATH"},
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
        )
        assert ran.returncode == 0, ran.stderr
        results: dict[str, Any] = json.loads((place / "results" / "results.json").read_text())
        assert_documented(results, RESULTS)
        for test in results.get("tests", []):
            assert_documented(test, TEST)
        assert (place / "source").stat().st_mode & 0o777 == 0o700
        return results

    return run


def assert_documented(value: dict[str, Any], known: dict[str, Any]) -> None:
    """Hold an object to keys and kinds of values that Gradescope's specification names."""
    assert set(value) <= set(known)
    for key, found in value.items():
        allowed = known[key]
        assert found in allowed if isinstance(allowed, set) else isinstance(found, allowed)


def test_right_answer_earns_all_points_and_the_wall_is_named(submit: Submit) -> None:
    """A test a task; the inputs are drawn from the number of the submission."""
    results = submit({"answer.py": RIGHT})
    assert results["score"] == ONE.points == sum(test["max_score"] for test in results["tests"])
    assert [test["number"] for test in results["tests"]] == [task.id for task in ONE.tasks]
    assert "isolation: full (" in results["output"] or "isolation: limits (" in results["output"]
    assert results["execution_time"] > 0


def test_regrade_draws_the_same_inputs_and_a_new_submission_others() -> None:
    """Who hands in again and again learns nothing about the next inputs."""
    assert seed_of("1", 7) == seed_of("1", 7) != seed_of("2", 7)


def test_wrong_answer_gets_its_hint_and_no_input(submit: Submit) -> None:
    """What is said holds none of the numbers that were graded with."""
    results = submit({"answer.py": SWAPS})
    assert results["score"] == 1
    said = results["tests"][0]["output"]
    assert "hint: Only equal masses exchange velocities." in said
    assert not any(letter.isdigit() for letter in said.partition("hint:")[0])


def test_empty_file_and_no_file_earn_nothing_and_are_named(submit: Submit) -> None:
    """Every task has its test, so that the full mark is the same for everybody."""
    nothing = submit({})
    assert "holds no .ipynb or .py file" in nothing["output"]
    empty = submit({"answer.py": ""})
    assert "answer.py: is empty" in empty["output"]
    for results in (nothing, empty):
        assert results["score"] == 0
        assert [test["max_score"] for test in results["tests"]] == [t.points for t in ONE.tasks]


def test_of_two_files_the_one_that_counts_is_named(submit: Submit) -> None:
    """A helper that answers nothing is left out; two answers of one second are no answer."""
    helped = submit({"answer.py": RIGHT, "helper.py": "x = 1\n"})
    assert helped["score"] == ONE.points
    assert "helper.py: left out, it answers no exercise" in helped["output"]
    twice = submit({"again.py": SWAPS})
    assert twice["score"] == 0
    assert "no file counts, since 2 were changed last in the same second" in twice["output"]


@pytest.mark.full
def test_answer_that_hangs_costs_its_own_task_alone(submit: Submit) -> None:
    """The others are graded, and all ends long before Gradescope's 10 minutes."""
    results = submit({"answer.py": f"{RIGHT}\ndef inelastic_1d(*_):\n    while True: pass\n"})
    assert [test["score"] for test in results["tests"]] == [4, 0, 3]
    assert "did not finish" in results["tests"][1]["output"]


def test_answer_that_reads_the_source_earns_nothing(submit: Submit, tmp_path: Path) -> None:
    """Hidden checks stand there; the same answer without the look has full marks."""
    look = f"    open({str(tmp_path / 'autograder' / 'source' / 'settings.json')!r}).read()\n"
    results = submit({"answer.py": RIGHT.replace("    c = ", f"{look}    c = ")})
    assert [test["score"] for test in results["tests"]] == [0, 0, 3]


def test_less_isolation_than_asked_for_is_said_and_nothing_runs(
    submit: Submit, tmp_path: Path
) -> None:
    """There are results all the same, which say that they are no marks."""
    settings = tmp_path / "autograder" / "source" / "settings.json"
    settings.write_text(settings.read_text().replace("limits", "more"))
    results = submit({"answer.py": RIGHT})
    assert results["score"] == 0
    assert "The grader failed (ValueError), and these are no marks" in results["output"]


def test_command_writes_one_exercise_or_all(tmp_path: Path) -> None:
    """Programs may be run, hidden checks are in it, solutions are not needed."""
    runner, one = CliRunner(), tmp_path / "one.zip"
    ran = runner.invoke(app, ["release", str(one), "--gradescope", "--exercise", "01", "--json"])
    assert ran.exit_code == 0, ran.stderr
    with zipfile.ZipFile(one) as opened:
        names = opened.namelist()
        settings = json.loads(opened.read("settings.json"))
        for program in ("setup.sh", "run_autograder"):
            assert opened.read(program).startswith(b"#!/usr/bin/env bash\n")
            assert opened.getinfo(program).external_attr >> 16 & 0o111
    assert len(names) == json.loads(ran.stdout)["files"]
    assert settings["exercises"] == [ONE.name]
    assert "lesson_code/chapters/ch01_one_dimension/tasks.py" in names
    assert not [name for name in names if name.startswith(("solutions/", "tests/"))]
    for refused in ([str(one), "--gradescope"], [str(tmp_path / "x"), "--exercise", "01"]):
        assert runner.invoke(app, ["release", *refused]).exit_code == 2
