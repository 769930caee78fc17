"""The ``workbook`` command: what each subcommand prints, and with which exit code it ends."""

from __future__ import annotations

import importlib
import importlib.util
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook, new_output
from typer.testing import CliRunner

from lesson_code import __version__, cli
from lesson_code.course import fresh_copies
from lesson_code.course.grading import self_check
from lesson_code.course.grading.exercises import exercises
from lesson_code.course.notebooks import nbval_run, root, server
from lesson_code.course.notebooks.nbval_run import CellResult
from lesson_code.course.quiz.bank import chapter_numbers
from lesson_code.course.site import build

ROOT = Path(__file__).parents[2]
COMMANDS = [
    "start",
    "open",
    "watch",
    "check",
    "grade",
    "merge",
    "quiz",
    "regenerate",
    "play",
    "measure",
    "release",
    "site",
]
ALL_IS_WELL, SOMETHING_IS_NOT, NOT_DONE = 0, 1, 2
HEAVY = ("matplotlib", "pygame", "pymunk", "IPython", "nbformat", "jupytext", "numpy", "pytest")


def workbook(*arguments: str, answers: str | None = None) -> Any:
    """Run the command in this process."""
    return CliRunner().invoke(cli.app, arguments, input=answers)


def printing(source: str, printed: str) -> Any:
    """Return a cell that is stored as having printed some text."""
    output = new_output("stream", name="stdout", text=printed)
    return new_code_cell(source, outputs=[output], execution_count=1)


@pytest.fixture
def tiny(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Go to a workbook of one notebook with one right cell and one whose output changed."""
    cells = [printing("print('one')", "one\n"), printing("print('two')", "three\n")]
    path = tmp_path / root.FIRST_NOTEBOOK
    (path.parent / "source").mkdir(parents=True)
    nbformat.write(new_notebook(cells=cells), path)
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture
def nowhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Go to an empty folder, with the package installed where no workbook stands around it."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(root, "__file__", str(tmp_path / "site" / "lesson_code" / "n" / "root.py"))
    return tmp_path


# The command as a whole


def test_help_lists_every_command() -> None:
    """A newcomer finds everything with --help."""
    result = workbook("--help")
    assert result.exit_code == ALL_IS_WELL
    for name in COMMANDS:
        assert f" {name} " in result.output


def test_help_groups_commands_by_whom_they_are_for() -> None:
    """Students come first, and find their commands together."""
    groups = re.split(r"For (students|instructors|maintainers) ", workbook("--help").output)
    assert groups[1::2] == ["students", "instructors", "maintainers"]
    for name, group in (("start", 2), ("open", 2), ("watch", 2), ("grade", 4), ("regenerate", 6)):
        assert f" {name} " in groups[group]


def test_version_is_printed_and_nothing_else_is_done() -> None:
    """One line, with or without a command behind it."""
    for arguments in (["--version"], ["--version", "check"]):
        result = workbook(*arguments)
        assert (result.exit_code, result.output) == (0, f"collision-workbook {__version__}\n")


@pytest.mark.parametrize(
    "command",
    [
        *([name] for name in COMMANDS),
        ["play", "simulator"],
        ["play", "billiards"],
        ["measure", "chaos"],
        ["measure", "hard-cases"],
        ["measure", "speed"],
        ["measure", "accuracy"],
        ["measure", "effects"],
    ],
)
def test_every_command_has_help(command: list[str]) -> None:
    """Each says in a sentence what it does."""
    result = workbook(*command, "--help")
    assert result.exit_code == ALL_IS_WELL
    assert f"Usage: {' '.join(['root', *command])}" in result.output


@pytest.mark.parametrize("arguments", [[], ["play"], ["measure"]])
def test_command_without_a_subcommand_shows_its_help(arguments: list[str]) -> None:
    """Nothing to do is answered with what there is to do."""
    result = workbook(*arguments)
    assert result.exit_code == NOT_DONE
    assert "COMMAND [ARGS]" in result.output


@pytest.mark.parametrize("arguments", [["fly"], ["check", "--fast"], ["open", "--port", "70000"]])
def test_what_is_not_understood_ends_with_2(arguments: list[str]) -> None:
    """Exit code 2 means that the command was not done."""
    assert workbook(*arguments).exit_code == NOT_DONE


@pytest.mark.parametrize("module", ["lesson_code", "lesson_code.cli"])
def test_start_loads_nothing_heavy(module: str) -> None:
    """The command answers at once: what a subcommand needs is loaded when it runs."""
    code = f"import sys, {module}; print([m for m in {HEAVY} if m in sys.modules])"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout == "[]\n"


def test_installed_command_runs() -> None:
    """The entry point that pip makes is this command."""
    run = subprocess.run(
        [str(Path(sys.executable).parent / "workbook"), "play", "--help"],
        capture_output=True,
        text=True,
        check=True,
    )
    assert "billiards" in run.stdout


# Outside a workbook


@pytest.mark.parametrize("arguments", [["open"], ["check"], ["check", "--json"], ["regenerate"]])
def test_outside_a_workbook_the_error_says_where_it_looked(
    nowhere: Path, arguments: list[str]
) -> None:
    """One line, exit code 2, and nothing on standard output for a program to misread."""
    result = workbook(*arguments)
    assert result.exit_code == NOT_DONE
    assert result.stderr.startswith(f"workbook: no workbook in {nowhere.resolve()} or above it")
    assert result.stderr.count("\n") == 1
    assert result.stdout == ""


def test_outside_a_workbook_the_one_of_the_code_is_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From a checkout the command works in every folder."""
    monkeypatch.chdir(tmp_path)
    result = workbook("regenerate", "--check")
    assert (result.exit_code, result.output) == (ALL_IS_WELL, "")


# start


@pytest.mark.parametrize("made_before", [False, True])
def test_start_writes_notebooks_and_fresh_exercises_and_nothing_else(
    tmp_path: Path, made_before: bool
) -> None:
    """What a student gets: no solutions, no sources, no keys; the folder may be there, empty."""
    folder = tmp_path / "mine"
    if made_before:
        folder.mkdir()
    result = workbook("start", str(folder))
    assert result.exit_code == ALL_IS_WELL
    written = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    expected = {p.relative_to(ROOT).as_posix() for p in (ROOT / "notebooks").glob("*.ipynb")}
    expected |= {f"exercises/{exercise.file_name}" for exercise in exercises()}
    assert written == expected
    assert result.stdout.startswith(f"{len(expected)} files in {folder}: ")
    for name in expected:
        assert (folder / name).read_bytes() == (ROOT / name).read_bytes()


def test_start_leaves_a_folder_that_holds_something_alone(tmp_path: Path) -> None:
    """The error names argument, rule and value; nothing is written."""
    (tmp_path / "letter.txt").write_text("mine", encoding="utf-8")
    for taken, what in ((tmp_path, "holds letter.txt"), (tmp_path / "letter.txt", "is a file")):
        result = workbook("start", str(taken))
        assert (result.exit_code, result.stdout) == (NOT_DONE, "")
        said = f"workbook: folder must be new or empty, got {taken}, which {what}\n"
        assert result.stderr == said
    assert [path.name for path in tmp_path.iterdir()] == ["letter.txt"]


@pytest.mark.parametrize(("answer", "is_begun"), [("y\n", True), ("n\n", False)])
def test_open_offers_to_begin_a_workbook_where_there_is_none(
    nowhere: Path, monkeypatch: pytest.MonkeyPatch, answer: str, is_begun: bool
) -> None:
    """Asked on a terminal alone; after a no, it says the command."""
    opening = importlib.import_module("lesson_code.cli.opening")
    monkeypatch.setattr(opening, "_is_terminal", lambda: True)
    monkeypatch.setattr(fresh_copies, "home", lambda: ROOT)
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)  # no server is started
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    result = workbook("open", answers=answer)
    assert result.exit_code == NOT_DONE
    assert (nowhere / opening.NEW_FOLDER / root.FIRST_NOTEBOOK).is_file() == is_begun
    words = "JupyterLab is not installed" if is_begun else "workbook start FOLDER"
    assert words in result.stderr


# check


def test_check_as_json_names_the_cell_that_failed(tiny: Path) -> None:
    """One versioned object on standard output, the progress elsewhere, and exit code 1."""
    result = workbook("check", "--json")
    assert result.exit_code == SOMETHING_IS_NOT
    report = json.loads(result.stdout)
    [failed] = report.pop("failed")
    assert report == {"version": 1, "command": "check", "notebooks": 1, "cells": 2}
    assert (failed["notebook"], failed["cell"]) == ("00_start_here.ipynb", 1)
    assert "three" in failed["message"]


@pytest.mark.parametrize(
    ("results", "code", "words"),
    [
        ([CellResult("a.ipynb", 0, True)], ALL_IS_WELL, "1 notebooks, 1 cells, 0 failed"),
        (
            [CellResult("a.ipynb", 2, False, "[red]one[/red] is not two")],
            SOMETHING_IS_NOT,
            "a.ipynb, code cell 3:\n[red]one[/red] is not two",
        ),
    ],
)
def test_check_says_which_cells_failed_and_why(
    monkeypatch: pytest.MonkeyPatch, tiny: Path, results: Any, code: int, words: str
) -> None:
    """Cells are counted from 1 for people, and no part of a message is taken for markup."""
    monkeypatch.setattr(nbval_run, "run_notebooks", lambda *_, **__: results)
    result = workbook("check")
    assert result.exit_code == code
    assert words in result.output


def test_check_of_a_broken_notebook_ends_with_2(tiny: Path) -> None:
    """What cannot be read is not reported as all well."""
    (tiny / root.FIRST_NOTEBOOK).write_text("<<<<<<<", encoding="utf-8")
    result = workbook("check", "--json")
    assert result.exit_code == NOT_DONE
    assert "00_start_here.ipynb" in result.stderr
    assert result.stdout == ""


def test_exercises_without_faults_are_said_to_have_none(monkeypatch: pytest.MonkeyPatch) -> None:
    """Exit code 0. That this workbook's have none is shown in tests/grading/test_self_check.py."""
    looked_at: list[Path] = []
    monkeypatch.setattr(self_check, "faults", lambda folder, **_: looked_at.append(folder) or ())
    result = workbook("check", "--exercises", "--json")
    assert looked_at == [ROOT]
    assert json.loads(result.stdout) == {"version": 1, "command": "check --exercises", "faults": []}
    assert result.exit_code == ALL_IS_WELL


def test_faults_of_exercises_are_printed_each_in_a_line(monkeypatch: pytest.MonkeyPatch) -> None:
    """Exit code 1, and a line is not broken where a window would end."""
    faults = ["task 1.1: " + "x" * 200, "task 1.2: has no alternative"]
    monkeypatch.setattr(self_check, "faults", lambda *_, **__: iter(faults))
    result = workbook("check", "--exercises")
    assert result.exit_code == SOMETHING_IS_NOT
    assert result.stderr.splitlines() == faults
    assert "2 faults" in result.stdout


# grade and merge


@pytest.mark.parametrize(
    ("folder", "code"), [("solutions", ALL_IS_WELL), ("exercises", SOMETHING_IS_NOT)]
)
def test_grade_ends_with_0_for_full_marks_only(folder: str, code: int) -> None:
    """The solution gets all points; the student copy, as it is handed out, gets none."""
    path = ROOT / folder / "01_one_dimension.ipynb"
    result = workbook("grade", str(path), "--json", "--seed", "1")
    report = json.loads(result.stdout)
    assert result.exit_code == code
    assert report["version"] == 3
    assert report["points"] == (report["full_points"] if folder == "solutions" else 0)


@pytest.mark.parametrize("command", [["grade"], ["grade", "--nbval"], ["merge", "-o", "m.ipynb"]])
def test_submission_that_is_not_there_ends_with_2(tiny: Path, command: list[str]) -> None:
    """The error names the file."""
    result = workbook(*command, "absent.ipynb")
    assert result.exit_code == NOT_DONE
    assert "absent.ipynb" in result.stderr
    assert not Path("m.ipynb").exists()


def test_merge_writes_a_notebook_and_says_what_to_do_with_it(tmp_path: Path) -> None:
    """The merged notebook is one that pytest --nbval-lax can run."""
    path = tmp_path / "merged.ipynb"
    result = workbook("merge", str(ROOT / "solutions" / "01_one_dimension.ipynb"), "-o", str(path))
    assert result.exit_code == ALL_IS_WELL
    assert f"pytest --nbval-lax {path}" in result.stdout
    nbformat.validate(nbformat.read(path, as_version=4))


# quiz


def test_quiz_reads_piped_answers_and_prints_its_result_as_json() -> None:
    """The talk goes to standard error, the result alone to standard output."""
    result = workbook("quiz", "02", "--json", answers="a\nb\n")
    report = json.loads(result.stdout)
    assert result.exit_code == ALL_IS_WELL
    assert (report["version"], report["command"], report["finished"]) == (1, "quiz", False)
    assert report["questions"][0]["answers"] == ["a", "b"]
    assert "Your answer" in result.stderr


def test_quiz_of_all_chapters_ends_politely_at_the_end_of_input() -> None:
    """Without chapters it begins at the first; without answers it says so."""
    result = workbook("quiz", answers="")
    assert result.exit_code == ALL_IS_WELL
    assert f"Chapter {chapter_numbers()[0]}" in result.stdout
    assert "No question was answered." in result.stdout


def test_quiz_of_an_unknown_chapter_ends_with_2() -> None:
    """The error says which chapters there are."""
    result = workbook("quiz", "99")
    assert result.exit_code == NOT_DONE
    assert "00, 01, 02, 03" in result.stderr
    assert "'99'" in result.stderr


# play


def test_program_without_a_window_plays_so_many_frames(tmp_path: Path) -> None:
    """It says how many, and how long they took; the last one is saved."""
    picture = tmp_path / "last.png"
    result = workbook(
        "play", "billiards", "--headless", "--frames", "60", "--screenshot", str(picture)
    )
    assert result.exit_code == ALL_IS_WELL
    ms = r"\d+\.\d\d ms"
    told = rf"Frames: 60; world {ms}, picture {ms}; 95 % within {ms}\n"
    assert re.fullmatch(told, result.stdout)
    assert picture.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--headless"], "--headless needs --frames: without a window nobody can close it"),
        (["--headless", "--frames", "-1"], "frames must be a whole number >= 0, got -1"),
        (["--headless", "--frames", "1", "--screenshot", "x.jpg"], "must end in .png"),
    ],
)
def test_program_that_cannot_be_played_ends_with_2(options: list[str], words: str) -> None:
    """The reason is one clear line."""
    result = workbook("play", "billiards", *options)
    assert result.exit_code == NOT_DONE
    assert words in result.stderr
    assert result.stderr.count("\n") == 1


def test_program_is_filmed(tmp_path: Path) -> None:
    """It says how long the film is; one that would be too long is refused before it begins."""
    film = tmp_path / "film.gif"
    options = ("play", "billiards", "--headless", "--record", str(film), "--frames")
    refused = workbook(*options, "1801")
    assert (refused.exit_code, film.exists()) == (NOT_DONE, False)
    assert "frames must be <= 1800 for a film (30 s), got 1801" in refused.stderr
    result = workbook(*options, "30")
    assert result.exit_code == ALL_IS_WELL
    assert result.stdout.endswith("Film: 11 pictures, 0.55 s\n")
    assert film.read_bytes().startswith(b"GIF89a")


@pytest.mark.parametrize("name", ["billiards", "simulator", "cradle"])
def test_program_with_a_seed_plays_without_a_window(name: str) -> None:
    """A seed is an option of every program."""
    result = workbook("play", name, "--seed", "3", "--headless", "--frames", "2")
    assert result.exit_code == ALL_IS_WELL
    assert result.stdout.startswith("Frames: 2")


def test_simulator_plays_with_as_many_balls_as_are_asked_for(tmp_path: Path) -> None:
    """More than fit are refused; a recording that is none too."""
    assert workbook("play", "simulator", "--balls", "601").exit_code == NOT_DONE
    file = tmp_path / "no.json"
    file.write_text("{}")
    result = workbook("play", "pool", "--headless", "--replay", str(file))
    assert result.exit_code == NOT_DONE
    assert "replay must be a recording" in result.stderr


# measure


def test_measure_hard_cases_prints_one_json_object() -> None:
    """Ours holds the family, naive does not; nothing else is printed."""
    result = workbook(
        "measure", "hard-cases", "--json", "--workers", "1", "--only", "slide-to-roll",
        "--draws", "2", "--seed", "5", "--solver", "ours", "--solver", "naive",
    )  # fmt: skip
    assert result.exit_code == ALL_IS_WELL
    told = json.loads(result.stdout)
    assert (told["version"], told["command"]) == (2, "measure hard-cases")
    assert told["holds"] == {"ours": 1, "naive": 0}
    assert told["families"][0]["results"]["naive"]["draws"] == 2
    assert told["families"][0]["results"]["naive"]["worst_seed"] in (5, 6)


def test_measure_hard_cases_prints_a_table() -> None:
    """A line for the family, under its theme."""
    result = workbook("measure", "hard-cases", "--workers", "1", "--only", "zeno", "--draws", "1")
    assert result.exit_code == ALL_IS_WELL
    assert "Bounces" in result.stdout
    assert "zeno" in result.stdout


def test_measure_hard_cases_replays_a_draw() -> None:
    """The parameters, and the figure of each engine."""
    result = workbook("measure", "hard-cases", "--replay", "zeno:7", "--solver", "ours", "--json")
    assert result.exit_code == ALL_IS_WELL
    told = json.loads(result.stdout)
    assert (told["family"], told["seed"]) == ("zeno", 7)
    assert set(told["parameters"]) == {"height", "restitution"}
    assert told["engines"]["ours"]["held"]


@pytest.mark.parametrize(
    "wrong",
    [
        ["--only", "easy"],
        ["--solver", "mine"],
        ["--replay", "zeno"],
        ["--replay", "easy:1"],
    ],
)
def test_measure_hard_cases_refuses_what_it_does_not_know(wrong: list[str]) -> None:
    """In one line that names what is wrong, before anything is run."""
    result = workbook("measure", "hard-cases", *wrong)
    assert result.exit_code == NOT_DONE
    assert "must be" in result.stderr


@pytest.mark.full
def test_measure_chaos_prints_one_json_object_whoever_does_the_work() -> None:
    """The bytes are the same for one worker and for two, and nothing else is printed."""
    one, two = (
        workbook("measure", "chaos", "--json", "--runs", "2", "--workers", workers)
        for workers in ("1", "2")
    )
    assert one.exit_code == two.exit_code == ALL_IS_WELL
    assert (one.stdout, one.stderr) == (two.stdout, "")
    report = json.loads(one.stdout)
    assert (report["version"], report["command"], report["runs"]) == (1, "measure chaos", 2)
    assert report["growth_rate_per_collision"]["median"] > 0


def test_measure_chaos_prints_a_table() -> None:
    """A row for each displacement, and one for all."""
    result = workbook("measure", "chaos", "--runs", "2", "--workers", "1")
    assert result.exit_code == ALL_IS_WELL
    for words in ("64 discs", "1e-12", "1e-11", "all"):
        assert words in result.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--runs", "0"], "Invalid value for '--runs'"),
        (["--workers", "0"], "Invalid value for '--workers'"),
        (["--cluster", "here"], 'cluster must be "local" or an address such as tcp://'),
    ],
)
def test_measure_chaos_with_options_out_of_range_ends_with_2(
    options: list[str], words: str
) -> None:
    """The error names the option."""
    result = workbook("measure", "chaos", *options)
    assert result.exit_code == NOT_DONE
    assert words in " ".join(result.stderr.split())


@pytest.mark.full
def test_measure_speed_prints_one_json_object() -> None:
    """One small scene; the bar is on standard error, and away when it is done."""
    pytest.importorskip("numba")
    options = ["--json", "--quick", "--only", "gas-10", "--repeats", "1"]
    result = workbook("measure", "speed", *options)
    assert result.exit_code == ALL_IS_WELL
    report = json.loads(result.stdout)
    assert (report["version"], report["command"], report["repeats"]) == (3, "measure speed", 1)
    assert [scene["key"] for scene in report["scenes"]] == ["gas-10"]
    assert {"sequential", "pymunk, tree"} <= {e["engine"] for e in report["scenes"][0]["engines"]}


@pytest.mark.full
def test_measure_speed_prints_a_table() -> None:
    """With the machine above it, and a row for each engine."""
    pytest.importorskip("numba")
    result = workbook("measure", "speed", "--quick", "--only", "gas-10", "--repeats", "1")
    assert result.exit_code == ALL_IS_WELL
    for words in ("cores", "gas of 10", "sequential", "substep", "exact", "pymunk, hash"):
        assert words in result.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--repeats", "0"], "Invalid value for '--repeats'"),
        (["--only", "gold"], "only must name some of run-gas-10"),
        (["--store", "--quick"], "--store needs all whole runs"),
        (["--store", "--only", "gas-10"], "--store needs all whole runs"),
        (["--profile", "gold-10"], "scene must be one of gas"),
    ],
)
def test_measure_speed_with_options_out_of_range_ends_with_2(
    options: list[str], words: str
) -> None:
    """The error names the option."""
    pytest.importorskip("numba")
    result = workbook("measure", "speed", *options)
    assert result.exit_code == NOT_DONE
    assert words in " ".join(result.stderr.split())


@pytest.mark.full
def test_measure_accuracy_prints_one_json_object_and_draws(tmp_path: Path) -> None:
    """All points of a scene; the figure goes into the file."""
    figure = tmp_path / "figure.png"
    options = ["--quick", "--only", "drop", "--repeats", "1"]
    result = workbook("measure", "accuracy", "--json", *options, "--plot", str(figure))
    assert (result.exit_code, result.stderr) == (ALL_IS_WELL, "")
    report = json.loads(result.stdout)
    assert (report["version"], report["command"]) == (2, "measure accuracy")
    assert {point["scene"] for point in report["points"]} == {"drop"}
    assert len({point["method"] for point in report["points"]}) >= 6
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_measure_accuracy_prints_a_table() -> None:
    """Norm, methods and orders."""
    options = ["--quick", "--only", "slide", "--repeats", "1"]
    result = workbook("measure", "accuracy", *options)
    assert result.exit_code == ALL_IS_WELL
    for words in ("slide to roll", "along the floor", "exact", "pymunk, C: order 1"):
        assert words in result.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--repeats", "0"], "Invalid value for '--repeats'"),
        (["--only", "moon"], "only must name some of ball in a box"),
        (["--quick", "--store"], "--store wants a full measurement"),
        (["--plot", "figure.txt"], "--plot must end in .png, .svg or .pdf"),
    ],
)
def test_measure_accuracy_with_options_out_of_range_ends_with_2(
    options: list[str], words: str
) -> None:
    """The error names the option, or the scenes that there are."""
    result = workbook("measure", "accuracy", *options)
    assert result.exit_code == NOT_DONE
    assert words in " ".join(result.stderr.split())


def test_measure_effects_prints_one_json_object_and_draws(tmp_path: Path) -> None:
    """The rows of an effect, ours and pymunk's; the figure goes into the file."""
    figure = tmp_path / "figure.png"
    options = ["--quick", "--only", "damping", "--repeats", "1", "--plot", str(figure)]
    result = workbook("measure", "effects", "--json", *options)
    assert result.exit_code == ALL_IS_WELL
    report = json.loads(result.stdout)
    assert (report["version"], report["command"]) == (1, "measure effects")
    rows = [(row["effect"], row["code"], row["calls_left_out"]) for row in report["costs"]]
    assert rows == [("damping", "plain Python", 0.0), ("damping", "pymunk", None)]
    assert figure.read_bytes().startswith(b"\x89PNG")


@pytest.mark.full
def test_measure_effects_prints_tables() -> None:
    """Ours, pymunk's, and what is wanted."""
    options = ["--quick", "--only", "gravity", "--only", "billiards", "--repeats", "1"]
    result = workbook("measure", "effects", *options)
    assert result.exit_code == ALL_IS_WELL
    for words in ("plain Python: what an effect costs", "pymunk: the same", "planned and run, s"):
        assert words in result.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--repeats", "0"], "Invalid value for '--repeats'"),
        (["--only", "magic"], "only must name some of collisions"),
        (["--quick", "--store"], "--store wants all effects, measured in full"),
        (["--only", "gravity", "--store"], "--store wants all effects, measured in full"),
        (["--plot", "figure.txt"], "--plot must end in .png, .svg or .pdf"),
    ],
)
def test_measure_effects_with_options_out_of_range_ends_with_2(
    options: list[str], words: str
) -> None:
    """The error names the option, or the effects that there are."""
    result = workbook("measure", "effects", *options)
    assert result.exit_code == NOT_DONE
    assert words in " ".join(result.stderr.split())


# regenerate


def test_regenerate_check_passes_for_this_workbook() -> None:
    """Nothing derived has drifted from its source, and nothing is printed."""
    result = workbook("regenerate", "--check")
    assert (result.exit_code, result.output) == (ALL_IS_WELL, "")


def test_regenerate_check_names_what_has_drifted_and_changes_nothing(tiny: Path) -> None:
    """Exit code 1, and a line for each file."""
    before = (tiny / root.FIRST_NOTEBOOK).read_bytes()
    result = workbook("regenerate", "--check")
    assert result.exit_code == SOMETHING_IS_NOT
    assert result.stderr == "notebooks/00_start_here.ipynb: has no source\n"
    assert (tiny / root.FIRST_NOTEBOOK).read_bytes() == before


def test_regenerate_makes_the_notebooks_that_are_named(tiny: Path) -> None:
    """Only the named one is run and written; afterwards it is as its source says."""
    for name in ("00_start_here", "01_other"):
        source = tiny / "notebooks" / "source" / f"{name}.py"
        source.write_text("# %%\nprint(6 * 7)\n", encoding="utf-8")
    result = workbook("regenerate", "00")
    assert (result.exit_code, result.stdout) == (ALL_IS_WELL, "notebooks/00_start_here.ipynb\n")
    assert "42" in (tiny / root.FIRST_NOTEBOOK).read_text(encoding="utf-8")
    assert workbook("regenerate", "--check").stderr == (
        "notebooks/01_other.ipynb: is missing; make it with workbook regenerate\n"
    )


def test_regenerate_of_a_name_that_begins_no_file_ends_with_2(tiny: Path) -> None:
    """A slip of the finger is not answered with silence."""
    result = workbook("regenerate", "7")
    assert result.exit_code == NOT_DONE
    assert "got 7" in result.stderr


# open


@pytest.mark.parametrize("notebook", ["99", "0", "", "*", "/etc/passwd", "source"])
def test_open_of_no_notebook_or_of_several_ends_with_2(notebook: str) -> None:
    """The error says what is wanted; no server is started."""
    result = workbook("open", notebook)
    assert result.exit_code == NOT_DONE
    assert f"notebook must be the number of one, such as 00, got {notebook!r}" in result.stderr


@pytest.mark.parametrize(
    ("notebook", "opened"), [("01", "01_first"), ("01b", "01b_second"), ("02", "02_other")]
)
def test_open_of_a_chapter_in_parts_opens_the_one_that_is_named_or_the_first(
    tiny: Path, monkeypatch: pytest.MonkeyPatch, notebook: str, opened: str
) -> None:
    """The number alone is that of the first part."""

    def start(_root: Path, path: Path, _port: int | None) -> None:
        raise RuntimeError(path.stem)

    for name in ("01b_second", "01_first", "02_other"):
        shutil.copy(tiny / root.FIRST_NOTEBOOK, tiny / "notebooks" / f"{name}.ipynb")
    monkeypatch.setattr(server, "start", start)
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    assert workbook("open", notebook).stderr == f"workbook: {opened}\n"


def test_open_without_jupyterlab_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """The lean package cannot open a browser, and says what is missing."""
    monkeypatch.setattr(importlib.util, "find_spec", lambda _: None)
    monkeypatch.setattr(signal, "signal", lambda *_: None)
    result = workbook("open")
    assert result.exit_code == NOT_DONE
    assert 'pip install -e ".[jupyter]"' in result.stderr


def hear_ctrl_c() -> None:
    """Undo what a shell does to a command that it runs in the background."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(params=[signal.SIGINT, signal.SIGTERM], ids=["Ctrl-C", "terminate"])
def served(request: pytest.FixtureRequest) -> Iterator[tuple[str, signal.Signals, Any]]:
    """Serve this workbook's notebook 01 in another process."""
    command = [str(Path(sys.executable).parent / "workbook"), "open", "01", "--no-browser"]
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, text=True, preexec_fn=hear_ctrl_c
    ) as process:
        try:
            assert process.stdout is not None
            yield process.stdout.readline(), request.param, process
        finally:
            if process.poll() is None:
                os.kill(process.pid, signal.SIGTERM)


@pytest.mark.skipif(
    importlib.util.find_spec("jupyterlab") is None,
    reason="needs JupyterLab: pip install -e '.[jupyter]'",
)
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals")
def test_open_serves_the_workbook_until_it_is_stopped(
    served: tuple[str, signal.Signals, Any],
) -> None:
    """The address that is printed answers; after Ctrl-C or terminate nothing is left of it."""
    line, stop, process = served
    words, _, address = line.rstrip().rpartition(" ")
    assert words == "The workbook is served at"
    assert "/lab/tree/notebooks/01_one_dimension.ipynb?token=" in address
    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with opener.open(address, timeout=10) as response:
        assert response.status == 200
    process.send_signal(stop)
    assert process.wait(timeout=20) == ALL_IS_WELL
    host, port = address.split("/")[2].split(":")
    with socket.socket() as tried:
        assert tried.connect_ex((host, int(port))) != 0


# Pages


def test_site_leaves_other_files_alone(tiny: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder that holds something else is refused in one line, and nothing in it changes."""
    monkeypatch.setattr(build, "NEEDS", ())
    (tiny / "mine").mkdir()
    (tiny / "mine" / "letter.txt").write_text("mine", encoding="utf-8")
    result = workbook("site", "mine")
    assert result.exit_code == NOT_DONE
    assert "the site's folder must be new, empty or a site, got mine" in result.stderr
    assert [path.name for path in (tiny / "mine").iterdir()] == ["letter.txt"]
