"""The workbook's folder, found from anywhere in it."""

from __future__ import annotations

from pathlib import Path

import pytest

from lesson_code.course.notebooks import root
from lesson_code.course.notebooks.root import FIRST_NOTEBOOK, WorkbookNotFoundError, find_root

PROJECT = Path(__file__).parents[3]


@pytest.fixture
def workbook(tmp_path: Path) -> Path:
    """Return a folder that holds a notebook 00 and a folder below it."""
    (tmp_path / FIRST_NOTEBOOK).parent.mkdir()
    (tmp_path / FIRST_NOTEBOOK).touch()
    (tmp_path / "exercises" / "mine").mkdir(parents=True)
    return tmp_path


@pytest.fixture
def installed_elsewhere(
    tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Let the package live where no workbook stands around it, as after pip install."""
    site = tmp_path_factory.mktemp("site") / "lesson_code" / "notebook_tools" / "root.py"
    monkeypatch.setattr(root, "__file__", str(site))


@pytest.mark.parametrize("below", [".", "notebooks", "exercises/mine"])
def test_root_is_found_from_any_folder_below_it(workbook: Path, below: str) -> None:
    """A command works in every folder of the workbook."""
    assert find_root(workbook / below) == workbook.resolve()


def test_root_of_the_current_folder_is_the_default(
    workbook: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a start, the search begins where the command is run."""
    monkeypatch.chdir(workbook / "exercises")
    assert find_root() == workbook.resolve()


def test_nearest_workbook_wins(workbook: Path) -> None:
    """A workbook inside another one is found before it."""
    inner = workbook / "exercises" / "mine"
    (inner / FIRST_NOTEBOOK).parent.mkdir()
    (inner / FIRST_NOTEBOOK).touch()
    assert find_root(inner) == inner.resolve()


def test_package_own_workbook_is_the_last_resort(tmp_path: Path) -> None:
    """Outside any workbook, the one this code lives in is used."""
    assert find_root(tmp_path) == PROJECT


@pytest.mark.usefixtures("installed_elsewhere")
def test_no_workbook_anywhere_says_where_it_looked_and_what_for(tmp_path: Path) -> None:
    """The error names the folder and the notebook that was looked for."""
    with pytest.raises(WorkbookNotFoundError) as error:
        find_root(tmp_path)
    assert str(tmp_path.resolve()) in str(error.value)
    assert str(FIRST_NOTEBOOK) in str(error.value)


@pytest.mark.usefixtures("installed_elsewhere")
def test_folder_called_like_the_notebook_is_no_workbook(tmp_path: Path) -> None:
    """Notebook 00 must be a file."""
    (tmp_path / FIRST_NOTEBOOK).mkdir(parents=True)
    with pytest.raises(WorkbookNotFoundError):
        find_root(tmp_path)
