"""Where the workbook is: the folder that holds notebooks, exercises and solutions."""

from __future__ import annotations

from pathlib import Path

FIRST_NOTEBOOK = Path("notebooks") / "00_start_here.ipynb"


class WorkbookNotFoundError(FileNotFoundError):
    """No workbook here; the message says where it was looked for."""


def home() -> Path:
    """Return the folder that holds this code's ``lesson_code``: a checkout, or site-packages."""
    return Path(__file__).resolve().parents[3]


def find_root(start: Path | None = None) -> Path:
    """Return the workbook's folder: the start, one above it, or the one this code lives in.

    Raises
    ------
    WorkbookNotFoundError
        There is no notebook 00 in any of them.
    """
    here = (start or Path.cwd()).resolve()
    for folder in (here, *here.parents, home()):
        if (folder / FIRST_NOTEBOOK).is_file():
            return folder
    raise WorkbookNotFoundError(
        f"no workbook in {here} or above it: go to the folder that holds {FIRST_NOTEBOOK}, "
        "or begin one with workbook start FOLDER"
    )


def require_instructors(root: Path) -> None:
    """Refuse what needs solutions or sources where there are none.

    Raises
    ------
    ValueError
        The workbook is a student's copy.
    """
    if not any((root / folder).is_dir() for folder in ("solutions", "notebooks/source")):
        raise ValueError(f"{root}: is a student's copy; this needs the instructor's")


def how_to_install(extra: str) -> str:
    """Return the command that adds what one of the package's extras brings."""
    if (home() / "pyproject.toml").is_file():
        return f'pip install -e ".[{extra}]"'
    return f'pip install "collision-workbook[{extra}]"'
