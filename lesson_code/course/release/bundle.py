"""The student's copy of the workbook: everything but solutions, hidden checks and keys.

notebooks and exercises       as they are
lesson_code                   as it is, but for what follows of each chapter
tasks.py, draws.py            practice checks, and what says why an answer is wrong
wrong_answers, right_answers  only those that a notebook shows or a gap knows
rules.py                      a program's constants and helpers; for its answers, the student's own
quiz.toml                     sealed
README                        the students' part
tests, solutions, sources     not at all
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path, PurePath, PurePosixPath

from lesson_code.course.fresh_copies import KEPT_EXERCISES, Files, zipped
from lesson_code.course.grading.exercises import Exercise, exercises, marks_answers
from lesson_code.course.grading.gaps import GAPS
from lesson_code.course.grading.practice import practice_of, reference
from lesson_code.course.grading.task import Task
from lesson_code.course.notebooks.root import require_instructors
from lesson_code.course.quiz.bank import QUIZ
from lesson_code.course.quiz.sealing import seal_quiz
from lesson_code.course.release.slicing import Names, all_needed, replaced, sliced, used_names

TOP_FILES = ("pyproject.toml", "requirements.lock", "LICENSE")
NOT_OF_THE_PACKAGE = ("__pycache__", ".mypy_cache", ".ruff_cache")
CHAPTERS = PurePosixPath("lesson_code/chapters")
CHECKS = ("tasks.py", "draws.py")
"""Of a chapter, and of all chapters: what is asked, with which inputs, and what is expected."""

RULES = "rules.py"
"""Of a program: what its game needs, with the answers to its exercise among it."""

COMMAND = re.compile(r"^python3 -m venv .*workbook open$", re.M)
STUDENTS_PART = re.compile(r"^## For students$.*?(?=^## )", re.M | re.S)


def bundle_files(root: Path) -> Files:
    """Return the files of the student's copy of a workbook.

    Raises
    ------
    ValueError
        The workbook is a student's copy itself, or something in it cannot be taken apart.
    """
    require_instructors(root)
    files = {path.as_posix(): (root / path).read_bytes() for path in sorted(_as_they_are(root))}
    for exercise in exercises():
        copy = exercise.student_copy(root)
        files[(KEPT_EXERCISES / copy.name).as_posix()] = copy.read_bytes()
    files |= {path: text.encode() for path, text in _taken_apart(root, files)}
    files |= {path: text.encode() for path, text in _rules(root, files)}
    files["README.md"] = _readme((root / "README.md").read_text(encoding="utf-8")).encode()
    return dict(sorted(files.items()))


def write_zip(files: Files, path: Path) -> None:
    """Write a copy as a zip that holds one folder of the same name."""
    path.write_bytes(zipped({f"{path.stem}/{name}": content for name, content in files.items()}))


def _as_they_are(root: Path) -> Iterator[Path]:
    """Yield the paths of the files that a copy takes unchanged."""
    yield from map(Path, TOP_FILES)
    yield from (path.relative_to(root) for path in (root / "notebooks").glob("*.ipynb"))
    for exercise in exercises():
        yield exercise.student_copy(root).relative_to(root)
    for path in of_the_package(root):
        secret = (holds_checks, holds_answers, holds_rules, is_quiz)
        if not any(is_secret(path) for is_secret in secret):
            yield path


def of_the_package(root: Path) -> Iterator[Path]:
    """Yield the paths of the package's files, in a workbook."""
    for path in (root / "lesson_code").rglob("*"):
        inside = path.relative_to(root)
        if path.is_file() and not set(inside.parts) & set(NOT_OF_THE_PACKAGE):
            yield inside


def holds_checks(path: PurePath) -> bool:
    """Return whether a file of the workbook holds tasks or draws their inputs."""
    return path.is_relative_to(CHAPTERS) and path.name in CHECKS


def holds_answers(path: PurePath) -> bool:
    """Return whether a file of the workbook holds known answers, right or wrong."""
    return path.is_relative_to(CHAPTERS) and path.suffix == ".py" and marks_answers(path.stem)


def holds_rules(path: PurePath) -> bool:
    """Return whether a file of the workbook holds the rules of a program."""
    return path.is_relative_to(CHAPTERS) and path.name == RULES


def is_quiz(path: PurePath) -> bool:
    """Return whether a file of the workbook holds questions."""
    return path.is_relative_to(CHAPTERS) and path.name == QUIZ


def _taken_apart(root: Path, files: Files) -> Iterator[tuple[str, str]]:
    """Yield path and text of each file of which a copy holds a part, or holds it sealed."""
    inside = [path.relative_to(root) for path in sorted((root / CHAPTERS).rglob("*.*"))]
    for quiz in filter(is_quiz, inside):
        yield quiz.as_posix(), seal_quiz((root / quiz).read_text(encoding="utf-8"))
    answers = _sources(root, filter(holds_answers, inside))
    shown: Names = {}
    gaps = (content.decode() for path, content in files.items() if path.endswith(f"/{GAPS}"))
    for code in (*_notebook_code(files), *gaps):
        _add(shown, used_names(code, answers))
    yield from _sliced_modules(answers, shown)
    yield from practice_modules(root, exercises())


def practice_modules(root: Path, chosen: Iterable[Exercise]) -> Iterator[tuple[str, str]]:
    """Yield path and text of the tasks of some exercises, with practice checks in them.

    What these use of other tasks, and of what draws inputs, comes with them.
    """
    inside = (path.relative_to(root) for path in sorted((root / CHAPTERS).rglob("*.py")))
    tasks = {_tasks_module(exercise): exercise.tasks for exercise in chosen}
    said: Names = {module: set() for module in tasks}
    for task in (task for of_chapter in tasks.values() for task in of_chapter):
        _add(said, _said_of(task))
    for path, text in _sliced_modules(_sources(root, filter(holds_checks, inside)), said):
        module = path.removesuffix(".py").replace("/", ".")
        yield path, text + (_PRACTICE if module in tasks else "")
    for module, of_chapter in tasks.items():
        yield f"{module.replace('.', '/')}.json", practice_of(of_chapter)


def _rules(root: Path, files: Files) -> Iterator[tuple[str, str]]:
    """Yield path and text of the programs' rules, as far as the other files of a copy use them."""
    paths = (path.relative_to(root) for path in (root / CHAPTERS).rglob(RULES))
    rules = _sources(root, sorted(paths))
    for exercise in exercises():
        for task in exercise.tasks:
            module, name = reference(task.expected).split(":")
            if module in rules:
                rules[module] = replaced(rules[module], name, _OWN_ANSWER.format(exercise, task))
    needed: Names = {module: set() for module in rules}
    code = [content.decode() for path, content in files.items() if path.endswith(".py")]
    for text in (*code, *_notebook_code(files)):
        _add(needed, used_names(text, rules))
    rules = {module: source.replace(_FUTURE, _OWN_IMPORT, 1) for module, source in rules.items()}
    yield from _sliced_modules(rules, needed)


_FUTURE = "from __future__ import annotations\n"
_OWN_IMPORT = f"{_FUTURE}\nfrom lesson_code.chapters.programs import own_answer\n"
_OWN_ANSWER = '''\
{1.function} = own_answer("{0.name}", "{1.function}")
"""Task {1.id}: yours, in exercises/{0.file_name}."""'''
"""Stands in a student's copy where the instructor's has the answer to a program's task."""


def _tasks_module(exercise: Exercise) -> str:
    """Return the name of the module that holds the tasks of an exercise."""
    return exercise.chapter.module("tasks").__name__


def _sources(root: Path, paths: Iterable[Path]) -> dict[str, str]:
    """Return the text of modules, by their names."""
    return {
        path.with_suffix("").as_posix().replace("/", "."): (root / path).read_text("utf-8")
        for path in paths
    }


_PRACTICE = """

from pathlib import Path

from lesson_code.course.grading.practice import practice_tasks

TASKS = practice_tasks(Path(__file__).with_suffix(".json"))
"""
"""Stands at the end of a chapter's tasks in a student's copy."""


def _said_of(task: Task) -> Names:
    """Return the functions that explain a wrong answer to a task, or bring answers to one form."""
    functions = [task.explain, *(criterion.part for criterion in task.criteria)]
    places = [reference(function).split(":") for function in functions if function]
    return {module: {name for m, name in places if m == module} for module, _ in places}


def _sliced_modules(sources: Mapping[str, str], wanted: Names) -> Iterator[tuple[str, str]]:
    """Yield path and text of some modules, with what is needed of them."""
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
