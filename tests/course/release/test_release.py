"""The student's copy: it works, holds nothing of the instructor's, and is searched for it."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from typer.testing import CliRunner

from lesson_code.chapters.programs import load
from lesson_code.cli import app
from lesson_code.course import release
from lesson_code.course.fresh_copies import Files, write_folder
from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.verdict import stream_of
from lesson_code.course.notebooks.student_copy import SOLUTION_ONLY
from lesson_code.course.quiz.bank import load_quiz
from lesson_code.course.release.bundle import bundle_files, write_zip
from lesson_code.course.release.leaks import HIDDEN_SEEDS, leaks

SECONDS = 120


@pytest.fixture(scope="module")
def copy(files: Files, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder into which the zip of the student's copy was unpacked."""
    folder = tmp_path_factory.mktemp("release")
    write_zip(files, folder / "workbook.zip")
    with zipfile.ZipFile(folder / "workbook.zip") as archive:
        archive.extractall(folder)
    return folder / "workbook"


def run_there(copy: Path, code: str) -> subprocess.CompletedProcess[str]:
    """Run some code in a copy, with its own lesson_code."""
    return subprocess.run(
        [sys.executable, "-c", code],
        cwd=copy,
        env=os.environ | {"PYTHONPATH": str(copy), "COLUMNS": "200"},
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
    )


def workbook_there(copy: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run the workbook command in a copy."""
    return run_there(copy, f"from lesson_code.cli import app; app({list(arguments)})")


@pytest.mark.full
def test_copy_leaks_nothing(files: Files, root: Path) -> None:
    """The search finds nothing in the copy that would go out today."""
    assert list(leaks(files, root)) == []


def test_copy_holds_what_students_need_and_no_folder_of_the_instructors(files: Files) -> None:
    """Notebooks, exercises, code and set-up; no tests, solutions or sources."""
    folders = {name.split("/")[0] for name in files}
    assert folders == {
        "LICENSE", "README.md", "exercises", "lesson_code", "notebooks", "pyproject.toml",
        "requirements.lock",
    }  # fmt: skip
    assert len([name for name in files if name.startswith("exercises/")]) == len(exercises())
    assert not any("/source/" in name or "draw" in name.split("grading/")[-1] for name in files)
    for name, content in files.items():
        if name.startswith("exercises/") and name.endswith(".ipynb"):
            assert SOLUTION_ONLY.encode() not in content


PLANTED = {
    "solutions/01_one_dimension.ipynb": ("is not for students", "{}"),
    "exercises/01_one_dimension.ipynb": (
        "holds a line of the solution of elastic_1d",
        json.dumps({"cells": [{"source": ["v_centre = (m1 * v1 + m2 * v2)", " / (m1 + m2)"]}]}),
    ),
    "lesson_code/chapters/ch01_one_dimension/tasks.py": (
        "holds target_at_rest, which is for the instructor alone",
        "def target_at_rest(stream): ...",
    ),
    "lesson_code/chapters/pool/rules.py": (
        "holds rack, which is for the instructor alone",
        "def rack(apex, radius, gap): ...",
    ),
    "lesson_code/chapters/ch03_reflection/wrong_answers.py": (
        "holds the solution of reflect",
        'def slides(v, normal):\n    """Wrong."""\n'
        "    return incident - 2 * np.dot(incident, normal) * normal",
    ),
    "lesson_code/chapters/ch00_start_here/quiz.toml": (
        "is not sealed",
        '[[question]]\nid = "00-x"\nkind = "choice"\noption = []',
    ),
    "notebooks/00_start_here.ipynb": (
        "holds what the quiz says to an answer",
        json.dumps({"cells": [{"outputs": [load_quiz("01").questions[0].right_feedback]}]}),
    ),
}


NOTES = "exercises/notes.py"
"""A file that a copy does not have."""


@pytest.fixture(scope="module")
def found(files: Files, root: Path) -> list[str]:
    """Return what the search finds in a copy in which each kind of leak is planted."""
    task = exercises()[0].tasks[0]
    criterion = task.criteria[2]
    arguments = next(iter(criterion.cases(stream_of(task, criterion, HIDDEN_SEEDS[0]))))
    planted = {name: text for name, (_, text) in PLANTED.items()}
    planted[NOTES] = f"answers = {task.expected(*arguments)!r}"  # as it would be printed
    return list(leaks({**files, **{name: text.encode() for name, text in planted.items()}}, root))


@pytest.mark.parametrize("name", PLANTED)
def test_search_finds_what_is_planted(name: str, found: list[str]) -> None:
    """Each kind of leak is found and named with its file."""
    said, _ = PLANTED[name]
    assert any(line.startswith(f"{name}: ") and said in line for line in found), found


def test_search_finds_an_expected_value(found: list[str]) -> None:
    """A number that the grader expects with a seed of its own."""
    assert any(f"{NOTES}: holds an expected value" in line for line in found)


def test_copy_checks_answers_and_gives_hints(copy: Path) -> None:
    """A check cell works there, with marks, reason and hint, though no formula is in its tasks."""
    ran = run_there(
        copy,
        "from lesson_code.course.grading import check_task\n"
        "from lesson_code.formulas import elastic_1d\n"
        "check_task('1.1', elastic_1d, seed=1)\n"
        "check_task('1.1', lambda m1, v1, m2, v2: (v2, v1), seed=1)",
    )
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.startswith("1.1 elastic_1d: 4/4 points\n1.1 elastic_1d: 1/4 points\n")
    assert "Momentum before" in ran.stdout
    assert "Only equal masses exchange velocities." in ran.stdout


PLAYED = """
from lesson_code.chapters.programs import load
from lesson_code.view.pygame.frame import play
played = [play(load(name), frames=90, headless=True, tour=True).game for name in {names}]
print([[game.notice] if game.missing else len(game.world) for game in played])
"""


@pytest.mark.full
def test_copy_plays_with_what_the_student_has_written(copy: Path, root: Path) -> None:
    """What is missing is named with its file, and nothing else fails; then it is played."""
    names = [exercise.name for exercise in exercises() if not exercise.chapter.number]
    ran = run_there(copy, PLAYED.format(names=names))
    assert ran.returncode == 0, ran.stderr
    for said in (
        "Task A.2: fire, in exercises/asteroids.py",
        "Task B.5: advance, in exercises/billiards.py",
        "Task K.1: paddle_bounce, in exercises/breakout.py",
        "Task D.1: tipping_angle, in exercises/dominoes.py",
        "Task P.1: rack, in exercises/pool.py",
        "Task S.1: ring_area, in exercises/soft_body.py",
    ):
        assert f"not written yet: {said}" in ran.stdout
    written = copy / "exercises" / "pool.py"
    fresh = written.read_bytes()
    written.write_bytes((root / "solutions" / "pool.py").read_bytes())
    try:
        ran = run_there(copy, PLAYED.format(names=["pool"]))
        assert ran.stdout.strip() == f"[{len(load('pool').game().world)}]", ran.stderr
        written.write_text("def rack(:", encoding="utf-8")
        ran = workbook_there(copy, "play", "pool", "--headless", "--frames", "1")
    finally:
        written.write_bytes(fresh)
    assert ran.returncode == 2
    assert "pool.py: cannot be read: SyntaxError" in ran.stderr
    assert "Traceback" not in ran.stderr


OWN_WORLDS = """
from importlib import import_module
from lesson_code.view.pygame.frame import play
for name in ("cradle", "dominoes", "soft_body"):
    program = getattr(import_module(f"lesson_code.chapters.{name}.own_world"), name.upper())
    print(play(program, frames=9, headless=True).game.notice)
"""


def test_copys_own_worlds_stand_still_until_they_are_written(copy: Path) -> None:
    """Their one function is named, and so is the area that the soft ring asks for."""
    ran = run_there(copy, OWN_WORLDS)
    assert ran.stdout.splitlines() == [
        "not written yet: Task C.3: cradle, in exercises/cradle.py",
        "not written yet: Task D.3: chain, in exercises/dominoes.py",
        "not written yet: Task S.1: ring_area, in exercises/soft_body.py",
    ], ran.stderr


def test_copy_grades_asks_its_quiz_and_resets(copy: Path) -> None:
    """The commands a student needs work in a fresh folder."""
    graded = workbook_there(copy, "grade", "exercises/06_sat_and_manifolds.ipynb", "--json")
    assert graded.returncode == 1, graded.stderr
    assert json.loads(graded.stdout)["full_points"] == exercises()[5].points
    quiz = run_there(
        copy,
        "from lesson_code.course.quiz import load_bank\n"
        "print(sum(len(c.questions) for c in load_bank()))",
    )
    assert int(quiz.stdout) > 20, quiz.stderr
    exercise = copy / "exercises" / "billiards.py"
    fresh = exercise.read_bytes()
    exercise.write_text("mine", encoding="utf-8")
    assert workbook_there(copy, "watch", "billiards", "--reset").returncode == 0
    assert exercise.read_bytes() == fresh
    assert (copy / "exercises" / "backups" / "billiards-1.py").read_text() == "mine"


@pytest.mark.full
def test_copys_notebook_reproduces_its_outputs(copy: Path) -> None:
    """Those that show wrong models, unusual answers and the billiards find them there."""
    ran = run_there(
        copy,
        "from pathlib import Path\n"
        "from lesson_code.course.notebooks.nbval_run import run_notebooks\n"
        "paths = sorted(Path('notebooks').glob('0[37]*.ipynb'))\n"
        "results = run_notebooks(paths)\n"
        "print(len(paths), [r.message for r in results if not r.passed])",
    )
    assert ran.stdout.strip() == "4 []", ran.stdout + ran.stderr


@pytest.mark.parametrize(
    "command", [["check", "--exercises"], ["release", "out"], ["regenerate"]], ids=" ".join
)
def test_instructors_commands_say_that_they_need_the_instructors_copy(
    copy: Path, command: list[str]
) -> None:
    """Exit code 2 and one line, no traceback."""
    ran = workbook_there(copy, *command)
    assert ran.returncode == 2
    assert "is a student's copy" in ran.stderr
    assert "Traceback" not in ran.stderr


@pytest.mark.full
def test_release_writes_folder_and_zip_alike(
    files: Files, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is in one is in the other; the command says how many files, and that nothing leaks."""
    monkeypatch.setattr(release, "bundle_files", lambda _: files)
    ran = CliRunner().invoke(app, ["release", str(tmp_path / "out"), "--json"])
    assert ran.exit_code == 0, ran.stderr
    made = json.loads(ran.stdout)
    with zipfile.ZipFile(made["zip"]) as archive:
        zipped = {name.partition("/")[2]: archive.read(name) for name in archive.namelist()}
    folder = tmp_path / "out"
    assert {
        p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()
    } == zipped
    assert made["files"] == len(zipped)
    again = CliRunner().invoke(app, ["release", str(tmp_path / "out")])
    assert again.exit_code == 2
    assert "is there already" in again.stderr


@pytest.mark.full
def test_two_releases_are_the_same_bytes(files: Files, root: Path, tmp_path: Path) -> None:
    """No clock and no chance in it, nor in its zip."""
    assert bundle_files(root) == files
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        write_zip(files, tmp_path / name / "workbook.zip")
    one, other = ((tmp_path / name / "workbook.zip").read_bytes() for name in "ab")
    assert one == other


def test_folder_that_holds_something_is_left_alone(files: Files, tmp_path: Path) -> None:
    """Nobody's work is overwritten."""
    (tmp_path / "mine.txt").write_text("mine")
    with pytest.raises(ValueError, match=r"must be new or empty, got .*, which holds mine\.txt"):
        write_folder(files, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["mine.txt"]
