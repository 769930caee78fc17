"""``workbook watch`` as a command."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from lesson_code.cli import app
from lesson_code.course.notebooks.root import FIRST_NOTEBOOK

from .conftest import ONE, Desk


@pytest.fixture
def watch(make_desk: Callable[..., Desk], monkeypatch: pytest.MonkeyPatch) -> Callable[..., Result]:
    """Return a function that runs the command in a workbook of its own."""
    root = make_desk().root
    (root / FIRST_NOTEBOOK).parent.mkdir()
    (root / FIRST_NOTEBOOK).write_text("{}")
    monkeypatch.chdir(root)
    return lambda *options, **given: CliRunner().invoke(app, ["watch", *options], **given)


def test_watch_list_says_how_far_an_exercise_is(watch: Callable[..., Result]) -> None:
    """In plain lines where there is no terminal, and then it ends."""
    ran = watch("01", "--list")
    assert ran.exit_code == 0
    assert ran.stdout.endswith(
        "01_one_dimension.ipynb: 0 of 3 tasks, 0 of 10 points\n"
        "Course: 0 of 3 tasks right, 0 of 10 points\n"
    )


def test_watch_obeys_lines_of_standard_input(watch: Callable[..., Result]) -> None:
    """Commands come as lines, so that any terminal and screen reader will do."""
    ran = watch("01", "--plain", input="l\nq\n")
    assert ran.exit_code == 0
    assert "Next: 1.1 elastic_1d" in ran.stdout
    assert "01_one_dimension.ipynb: 0 of 3 tasks" in ran.stdout


def test_watch_reset_puts_an_exercise_back(watch: Callable[..., Result]) -> None:
    """The option asks nothing, since it was typed, and keeps a backup all the same."""
    path = ONE.student_copy(Path.cwd())
    fresh = path.read_bytes()
    path.write_text("mine")
    ran = watch("01", "--reset")
    assert ran.exit_code == 0
    assert path.read_bytes() == fresh
    assert "kept in exercises/backups/01_one_dimension-1.ipynb" in ran.stdout


@pytest.mark.parametrize(
    ("options", "said"),
    [(["--reset"], "--reset needs the exercise"), (["77"], "exercise must be one of")],
)
def test_watch_with_a_bad_option_is_refused(
    watch: Callable[..., Result], options: list[str], said: str
) -> None:
    """Exit code 2, one line."""
    ran = watch(*options)
    assert ran.exit_code == 2
    assert said in ran.stderr
    assert len(ran.stderr.splitlines()) == 1
