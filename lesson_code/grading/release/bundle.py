"""The student's copy of the workbook: everything but solutions, hidden checks and keys.

notebooks and exercises       as they are
lesson_code                   as it is, but for what follows
grading/tasks                 practice checks, and what says why an answer is wrong
grading/wrong_models          only those that a notebook shows; so, too, alternatives
quiz/questions                sealed
README                        the students' part
tests, solutions, sources     not at all
"""

from __future__ import annotations

import json
import re
import zipfile
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from lesson_code.grading.exercises import EXERCISES
from lesson_code.grading.practice import practice_of, reference
from lesson_code.grading.release.slicing import Names, all_needed, sliced, used_names
from lesson_code.grading.task import Task
from lesson_code.grading.watch.reset import FRESH
from lesson_code.notebook_tools.root import require_instructors
from lesson_code.quiz.sealing import seal_chapter

TOP_FILES = ("pyproject.toml", "requirements.lock", "LICENSE")
NOT_OF_THE_PACKAGE = ("__pycache__", ".mypy_cache", ".ruff_cache")
TASKS = "lesson_code.grading.tasks"
KNOWN_ANSWERS = ("lesson_code.grading.alternatives", "lesson_code.grading.wrong_models")
QUESTIONS = PurePosixPath("lesson_code/quiz/questions")
EARLIEST = (1980, 1, 1, 0, 0, 0)
"""The time of every file in the zip, so that the same workbook is the same bytes."""

COMMAND = re.compile(r"^python3 -m venv .*workbook open$", re.M)
STUDENTS_PART = re.compile(r"^## For students$.*?(?=^## )", re.M | re.S)

Files = dict[str, bytes]
"""What stands in the files of a copy, by their paths with slashes."""


def bundle_files(root: Path) -> Files:
    """Return the files of the student's copy of a workbook.

    Raises
    ------
    ValueError
        The workbook is a student's copy itself, or something in it cannot be taken apart.
    """
    require_instructors(root)
    files = {path.as_posix(): (root / path).read_bytes() for path in sorted(_as_they_are(root))}
    for exercise in EXERCISES:
        copy = exercise.student_copy(root)
        files[(FRESH / copy.name).as_posix()] = copy.read_bytes()
    files |= {path: text.encode() for path, text in _taken_apart(root, files)}
    files["README.md"] = _readme((root / "README.md").read_text(encoding="utf-8")).encode()
    return dict(sorted(files.items()))


def write_folder(files: Files, folder: Path) -> None:
    """Write a copy into a folder that is new or empty.

    Raises
    ------
    ValueError
        There is something in the folder.
    """
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise ValueError(f"{folder}: is there already; name a folder that is new or empty")
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def write_zip(files: Files, path: Path) -> None:
    """Write a copy as a zip, in which all stands in one folder of the same name."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(f"{path.stem}/{name}", EARLIEST)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content)


def _as_they_are(root: Path) -> Iterator[Path]:
    """Yield the paths of the files that a copy takes unchanged."""
    yield from map(Path, TOP_FILES)
    for folder, pattern in (("notebooks", "*.ipynb"), ("notebooks/pictures", "*")):
        yield from (path.relative_to(root) for path in (root / folder).glob(pattern))
    for exercise in EXERCISES:
        yield exercise.student_copy(root).relative_to(root)
    changed = tuple(_folder(package) for package in (TASKS, *KNOWN_ANSWERS))
    for path in (root / "lesson_code").rglob("*"):
        inside = path.relative_to(root)
        is_ours = path.is_file() and not set(inside.parts) & set(NOT_OF_THE_PACKAGE)
        if is_ours and inside.parent not in (*changed, Path(QUESTIONS)):
            yield inside


def _folder(package: str) -> Path:
    """Return the folder of a package."""
    return Path(*package.split("."))


def _taken_apart(root: Path, files: Files) -> Iterator[tuple[str, str]]:
    """Yield path and text of each file of which a copy holds a part, or holds it sealed."""
    for chapter in sorted((root / QUESTIONS).glob("*.toml")):
        sealed = seal_chapter(chapter.read_text(encoding="utf-8"))
        yield (QUESTIONS / chapter.name).as_posix(), sealed
    for package in KNOWN_ANSWERS:
        shown: Names = {}
        for code in _notebook_code(files):
            _add(shown, used_names(code, package))
        yield from _sliced_package(root, package, shown)
    chapters = _chapters()
    said: Names = {}
    for task in (task for tasks in chapters.values() for task in tasks):
        _add(said, _said_of(task))
    for path, text in _sliced_package(
        root, TASKS, said | {m: said.get(m, set()) for m in chapters}
    ):
        module = f"{TASKS}.{PurePosixPath(path).stem}"
        yield path, text + (_PRACTICE if module in chapters else "")
    for module, tasks in chapters.items():
        yield f"{module.replace('.', '/')}.json", practice_of(tasks)


_PRACTICE = """

from pathlib import Path

from lesson_code.grading.practice import practice_tasks

TASKS = practice_tasks(Path(__file__).with_suffix(".json"))
"""
"""Stands at the end of a chapter's tasks in a student's copy."""


def _chapters() -> dict[str, tuple[Task, ...]]:
    """Return the tasks of each module of tasks."""
    import importlib
    import pkgutil

    package = importlib.import_module(TASKS)
    modules = [
        importlib.import_module(f"{TASKS}.{m.name}") for m in pkgutil.iter_modules(package.__path__)
    ]
    return {module.__name__: module.TASKS for module in modules if hasattr(module, "TASKS")}


def _said_of(task: Task) -> Names:
    """Return what says why an answer to a task is wrong, and what brings answers to one form."""
    functions = [task.explain, *(criterion.part for criterion in task.criteria)]
    places = [reference(function).split(":") for function in functions if function]
    return {module: {name for m, name in places if m == module} for module, _ in places}


def _sliced_package(root: Path, package: str, wanted: Names) -> Iterator[tuple[str, str]]:
    """Yield path and text of the modules of a package, with what is needed of them."""
    folder = root / _folder(package)
    sources = {
        f"{package}.{path.stem}": path.read_text(encoding="utf-8") for path in folder.glob("*.py")
    }
    yield f"{_folder(package).as_posix()}/__init__.py", sources[f"{package}.__init__"]
    wanted = {module: names for module, names in wanted.items() if module in sources}
    for module, names in sorted(all_needed(sources, wanted).items()):
        yield f"{module.replace('.', '/')}.py", sliced(sources[module], names) + "\n"


def _add(names: Names, more: Names) -> None:
    """Add names to those of the same modules."""
    for module, found in more.items():
        names.setdefault(module, set()).update(found)


def _notebook_code(files: Files) -> Iterator[str]:
    """Yield the code of each notebook of a copy."""
    for name, content in files.items():
        if name.endswith(".ipynb"):
            cells = json.loads(content)["cells"]
            yield "\n".join("".join(c["source"]) for c in cells if c["cell_type"] == "code")


def _readme(readme: str) -> str:
    """Return what students need of the README: how to set up, and their part."""
    command, part = COMMAND.search(readme), STUDENTS_PART.search(readme)
    if command is None or part is None:
        raise ValueError("README.md: has no command to open the workbook, or no part for students")
    frame = Path(__file__).with_name("students_readme.md").read_text(encoding="utf-8")
    return frame.format(command=command.group(), part=part.group().rstrip())
