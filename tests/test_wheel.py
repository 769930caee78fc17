"""The package without a checkout: a wheel, in an environment of its own, in an empty folder."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import venv
import zipfile
from pathlib import Path

import pytest

from lesson_code import __version__
from lesson_code.course.grading.exercises import exercises

ROOT = Path(__file__).parents[1]
SECONDS = 600
RUN_NOTEBOOK = """
import sys
import nbformat
from nbclient import NotebookClient

notebook = nbformat.read(sys.argv[1], as_version=4)
NotebookClient(notebook, timeout=120, resources={"metadata": {"path": "notebooks"}}).execute()
"""
CHECK = """
from lesson_code.course.grading import check_task
from lesson_code.formulas import elastic_1d

check_task("1.1", elastic_1d)
"""

pytestmark = pytest.mark.full


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a wheel of this project."""
    folder = tmp_path_factory.mktemp("wheel")
    command = [
        sys.executable,
        "-m",
        "pip",
        "wheel",
        "-q",
        "--no-deps",
        "-w",
        str(folder),
        str(ROOT),
    ]
    subprocess.run(command, check=True, timeout=SECONDS)
    [made] = folder.glob("*.whl")
    return made


class Installed:
    """The package in an environment that borrows everything else from this one, and a folder."""

    def __init__(self, wheel: Path, folder: Path) -> None:
        self.folder = folder
        venv.create(folder / "environment")
        scripts = "Scripts" if os.name == "nt" else "bin"
        self._python = folder / "environment" / scripts / "python"
        place = self._run("-c", "import sysconfig; print(sysconfig.get_path('purelib'))").stdout
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(place.strip())
        others = [p for p in sys.path if p.endswith("site-packages")]
        (Path(place.strip()) / "others.pth").write_text("\n".join(others), encoding="utf-8")

    def workbook(self, *arguments: str, code: int = 0) -> subprocess.CompletedProcess[str]:
        """Run the workbook command."""
        return self._run(
            "-c", f"from lesson_code.cli import app; app({list(arguments)})", code=code
        )

    def python(self, *arguments: str) -> str:
        """Run Python, and return what it prints."""
        return self._run(*arguments).stdout

    def _run(self, *arguments: str, code: int = 0) -> subprocess.CompletedProcess[str]:
        """Run Python, and hold it to its exit code."""
        ran = subprocess.run(
            [self._python, *arguments],
            cwd=self.folder,
            env={k: v for k, v in os.environ.items() if k != "PYTHONPATH"} | {"COLUMNS": "200"},
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
            timeout=SECONDS,
            check=False,
        )
        assert ran.returncode == code, ran.stdout + ran.stderr
        return ran


@pytest.fixture
def installed(wheel: Path, tmp_path: Path) -> Installed:
    """Return the package in an environment and in a folder without a workbook."""
    return Installed(wheel, tmp_path)


def test_wheel_holds_notebooks_and_exercises_and_no_solutions(wheel: Path) -> None:
    """The handbook and the marker of types are in it, too; solutions and sources are not."""
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    for folder, where in (("notebooks", "notebooks"), ("exercises", "exercises")):
        ours = [path for path in (ROOT / folder).iterdir() if path.suffix in (".ipynb", ".py")]
        assert {f"lesson_code/workbook/{where}/{path.name}" for path in ours} <= names
    assert {"lesson_code/py.typed", "lesson_code/course/site/pages/glossary.md"} <= names
    assert {name.split("/")[0] for name in names} == {
        "lesson_code", f"collision_workbook-{__version__}.dist-info",
    }  # fmt: skip
    assert not [
        name for name in names if "solution" in name.split("/")[-2:][0] or "/source/" in name
    ]


def test_installed_package_begins_a_workbook_that_works(installed: Installed) -> None:
    """In an empty folder: start, run notebooks, check and grade an exercise, put it back, play."""
    assert installed.workbook("--version").stdout == f"collision-workbook {__version__}\n"
    home = installed.python("-c", "import lesson_code; print(lesson_code.__file__)")
    assert home.startswith(str(installed.folder / "environment"))
    nowhere = installed.workbook("open", code=2)
    assert "workbook start FOLDER" in nowhere.stderr
    installed.workbook("start", "mine")
    installed.folder /= "mine"
    for name in ("00_start_here", "01_one_dimension"):
        installed.python("-c", RUN_NOTEBOOK, f"notebooks/{name}.ipynb")
    assert installed.python("-c", CHECK) == "1.1 elastic_1d: 4/4 points\n"
    exercise = "exercises/01_one_dimension.ipynb"
    graded = json.loads(installed.workbook("grade", exercise, "--json", code=1).stdout)
    assert graded["full_points"] == exercises()[0].points
    pool = installed.folder / "exercises" / "pool.py"
    fresh = pool.read_bytes()
    pool.write_text("mine", encoding="utf-8")
    installed.workbook("watch", "pool", "--reset")
    assert pool.read_bytes() == fresh == (ROOT / "exercises" / "pool.py").read_bytes()
    played = installed.workbook("play", "pool", "--headless", "--frames", "10")
    assert played.stdout.startswith("Frames: 10")
    assert "is a student's copy" in installed.workbook("regenerate", code=2).stderr
