"""The programs: the chapters that hold a game. None is loaded before it is played.

A student's copy plays them with the rules that the student has written: where the instructor's has
an answer to an exercise, there stands an :func:`own_answer`.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from lesson_code.course.chapters import chapters_with
from lesson_code.course.notebooks.root import find_root
from lesson_code.course.time_limit import NoAnswerError, TimeLimit

if TYPE_CHECKING:
    from lesson_code.view.pygame.program import Program


LIMIT = TimeLimit(1.0)
"""s, for each call of a player's function, with the reading of its file: as long the window waits
for one that never ends, once."""


def program_summaries() -> dict[str, str]:
    """Return name and a sentence, of every program."""
    return {chapter.name: chapter.summary for chapter in chapters_with("game.py")}


def load(name: str) -> Program:
    """Return a program.

    Raises
    ------
    ValueError
        There is none of that name.
    """
    programs = {chapter.name: chapter for chapter in chapters_with("game.py")}
    if name not in programs:
        raise ValueError(f"program must be one of {', '.join(programs)}, got {name!r}")
    program: Program = programs[name].module("game").PROGRAM
    return program


def own_answer(exercise: str, function: str) -> Callable[..., Any]:
    """Return a function of a student's exercise; the file is read when it is first called.

    It raises a NotImplementedError that names the file while the function is not written, an
    UnreadableError where the file cannot be read, and an EndlessError where it gives no answer in
    time; then it is not called again.
    """
    endless = ""

    def answer(*arguments: Any) -> Any:
        nonlocal endless
        path = find_root() / "exercises" / f"{exercise}.py"
        if not endless:
            try:
                return LIMIT.call(_answer_in, path, function, arguments)
            except NotImplementedError as missing:
                raise NotImplementedError(f"{missing}, in exercises/{path.name}") from missing
            except NoAnswerError as error:
                endless = str(error)
        from lesson_code.view.pygame.game import EndlessError

        raise EndlessError(endless)

    answer.__name__ = function
    vars(answer)["is_own"] = True
    return answer


def _answer_in(path: Path, function: str, arguments: tuple[Any, ...]) -> Any:
    """Return what a function in a student's file answers."""
    return getattr(_module(path), function)(*arguments)


@cache
def _module(path: Path) -> ModuleType:
    """Return a student's file as a module."""
    spec = spec_from_file_location(f"exercise_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise ValueError(f"{path}: is no Python file")
    module = module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except Exception as error:  # what a student writes may fail in any way
        from lesson_code.view.pygame.game import UnreadableError

        raise UnreadableError(f"{path}: cannot be read: {error!r}") from error
    return module
