"""The project holds itself to its own rules: layout, links, commands, versions."""

import re
import subprocess
import tomllib
from pathlib import Path

import pytest

from lesson_code import __version__

ROOT = Path(__file__).parents[1]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
README = (ROOT / "README.md").read_text(encoding="utf-8")

TOOLS = (
    "ruff check .",
    "ruff format --check .",
    "mypy",
    "lint-imports",
    "workbook regenerate --check",
)
"""What is run beside the tests: they take seconds, and need no test to start them."""

TOP_LEVEL = {
    ".ci",
    ".editorconfig",
    ".gitignore",
    ".pre-commit-config.yaml",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "LICENSE",
    "README.md",
    "exercises",
    "lesson_code",
    "notebooks",
    "noxfile.py",
    "pyproject.toml",
    "requirements.lock",
    "solutions",
    "tests",
}


def test_top_level_holds_what_is_fixed_and_nothing_else() -> None:
    """Git tracks the fixed top level and no other file or folder there."""
    listed = subprocess.run(
        ["git", "ls-files"],  # noqa: S607 - git is wherever it is
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if listed.returncode:
        pytest.skip("not a git checkout")
    assert {line.split("/")[0] for line in listed.stdout.splitlines()} <= TOP_LEVEL


def test_readme_two_commands_are_what_ci_runs() -> None:
    """The README has one command to open and one to test, and CI picks the latter from it."""
    commands = re.findall(r"^python3 -m venv .*$", README, flags=re.MULTILINE)
    assert [command.split(" && ")[-1] for command in commands] == [
        ".venv/bin/workbook open",
        ".venv/bin/pytest -n 2 --dist loadfile",
    ]
    run = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    assert "README.md" in run
    assert all(tool in run for tool in ("--full", *TOOLS))


def test_readme_commands_for_windows_are_those_of_other_systems() -> None:
    """One in each line, in double quotes, so that cmd and PowerShell take them."""
    [line] = re.findall(r"^python3 -m venv .*workbook open$", README, flags=re.MULTILINE)
    windows = line.replace("python3", "py").replace(".venv/bin/", ".venv\\Scripts\\")
    assert "\n".join(windows.split(" && ")) in README
    assert "'.[" not in README


def test_readme_lists_every_notebook_and_exercise() -> None:
    """Each stands in the students' part."""
    for folder in ("notebooks", "exercises"):
        for path in (ROOT / folder).iterdir():
            if path.suffix in (".ipynb", ".py"):
                assert f"]({folder}/{path.name})" in README


def test_every_dependency_has_a_lower_bound() -> None:
    """Every requirement in pyproject names the oldest version that was tested."""
    extras = PYPROJECT["project"]["optional-dependencies"].values()
    requirements = [*PYPROJECT["project"]["dependencies"], *(r for extra in extras for r in extra)]
    assert all(">=" in requirement for requirement in requirements)


def test_pygame_is_pygame_ce_where_it_has_no_wheel() -> None:
    """Exactly one of pygame and pygame-ce is asked for by any interpreter."""
    pygame = [r for r in PYPROJECT["project"]["dependencies"] if r.startswith("pygame")]
    assert [r.split(";")[1].strip() for r in pygame] == [
        "python_version < '3.14'",
        "python_version >= '3.14'",
    ]


def test_version_is_the_same_everywhere() -> None:
    """The package, pyproject and the newest entry of the changelog agree on the version."""
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    newest = re.search(r"^## ([\d.]+)", changelog, flags=re.MULTILINE)
    assert newest is not None
    assert __version__ == PYPROJECT["project"]["version"] == newest.group(1)
