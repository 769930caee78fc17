"""A program that runs what a player has written, and shows where that differs from the lesson's."""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any, NamedTuple

import numpy as np

from lesson_code.chapters.programs import LIMIT, load, own_answer
from lesson_code.course.chapters import chapters_with
from lesson_code.course.time_limit import NoAnswerError
from lesson_code.view.pygame.game import EndlessError
from lesson_code.view.pygame.program import Program


class OwnProgram(NamedTuple):
    """A program with a player's functions, the settings of its game, and the functions.

    They can be compared where the lesson's answers are: not in a student's copy.
    """

    program: Program
    settings: dict[str, Any]
    watched: list[Watched]

    @property
    def is_compared(self) -> bool:
        """Whether the lesson's answers to some of the functions are at hand."""
        return any(one.lesson for one in self.watched)


def load_own(name: str) -> OwnProgram:
    """Return a program that runs what stands in its exercise.

    Its panel says whose functions run, and names the first answer of each that is not the lesson's.

    Raises
    ------
    ValueError
        There is no program of that name, or it is no exercise.
    """
    program = load(name)
    chapter = next(one for one in chapters_with("game.py") if one.name == name)
    if chapter.has("own_world.py"):
        values = vars(chapter.module("own_world")).values()
        program = next(value for value in values if isinstance(value, type(program)))
    if program.with_own is None:
        raise ValueError(f"--with exercises needs a program that is an exercise, got {name!r}")
    watched = [Watched(own_answer(name, one.__name__), one) for one in program.own]
    own = replace(
        program,
        readings=lambda game: [*map(Watched.reading, watched), *program.readings(game)],
        more=partial(_more, watched, program.more),
    )
    return OwnProgram(own, program.with_own(*watched), watched)


def _more(
    watched: list[Watched], before: Callable[..., None] | None, game: Any, panel: Any
) -> None:
    """Write the first differences below what is in the panel."""
    if before is not None:
        before(game, panel)
    for one in watched:
        panel.paragraph(one.difference)


class Watched:
    """A player's function, compared with the lesson's at every call.

    Attributes
    ----------
    lesson : callable or None
        The lesson's function, which is lent while the player's is not written; None in a student's
        copy, which does not have it.
    difference : str
        The first answer that failed or was not the lesson's, in words; "" while there is none.
    """

    is_own = True

    def __init__(self, own: Callable[..., Any], lesson: Callable[..., Any]) -> None:
        self._own, self.__name__ = own, own.__name__
        self.lesson = None if hasattr(lesson, "is_own") else lesson
        self._is_written: bool | None = None
        self._endless = ""
        self.difference = ""

    def __call__(self, *arguments: Any) -> Any:
        """Return the player's answer; one that has not ended once is not called again."""
        if self._endless:
            raise EndlessError(self._endless)
        given = deepcopy(arguments)
        try:
            answer = LIMIT.call(self._own, *arguments)
        except NotImplementedError:
            self._is_written = False
            raise
        except NoAnswerError as error:
            self._is_written = True
            self._endless = f"{self._call(given)}: {error}"
            self._tell(given, f"gives {error}")
            raise EndlessError(self._endless) from None
        except Exception as error:  # a player's code may raise anything
            self._is_written = True
            self._tell(given, f"fails with {type(error).__name__}: {error}")
            raise
        self._is_written = True
        if self.lesson is not None and not self.difference:
            expected = self.lesson(*deepcopy(given))
            if not alike(answer, expected):
                self._tell(given, f"is {in_short(answer)}; the lesson's is {in_short(expected)}")
        return answer

    def _tell(self, given: tuple[Any, ...], what: str) -> None:
        """Say what is wrong with a call, if it is the first one."""
        if not self.difference:
            self.difference = f"{self._call(given)} {what}"

    def _call(self, given: tuple[Any, ...]) -> str:
        """Return a call in words."""
        return f"{self.__name__}({', '.join(map(in_short, given))})"

    def __deepcopy__(self, memo: dict[int, Any]) -> Watched:
        """Return itself: what it has seen is no part of a game's state."""
        return self

    def reading(self) -> tuple[str, str]:
        """Return its name, and whose function runs."""
        if self._is_written is None:
            return self.__name__, "yours, not called yet"
        if not self._is_written:
            return self.__name__, "lent, not written yet" if self.lesson else "not written yet"
        if self._endless:
            return self.__name__, "the lesson's" if self.lesson else "yours, never ends"
        if self.difference:
            return self.__name__, "yours, and not the lesson's"
        return self.__name__, "yours, as the lesson's" if self.lesson else "yours"


def alike(answer: Any, expected: Any) -> bool:
    """Return whether two answers are the same, up to rounding.

    >>> alike((np.array([1.0, 2.0]), ["top"]), ([1.0, 2.0 + 1e-12], ["top"]))
    True
    """
    if isinstance(expected, str) or not np.iterable(expected):
        try:
            return bool(np.isclose(answer, expected, rtol=1e-9, atol=1e-9))
        except (TypeError, ValueError):  # no number, or many
            return type(answer) is type(expected) and bool(answer == expected)
    if isinstance(answer, str) or not np.iterable(answer):
        return False
    theirs = list(expected)
    mine = list(islice(answer, len(theirs) + 1))
    return len(mine) == len(theirs) and all(map(alike, mine, theirs))


def in_short(value: Any) -> str:
    """Return a value in few letters.

    >>> in_short((np.array([1.0, 2.5]), 0.12345))
    '((1, 2.5), 0.123)'
    """
    if isinstance(value, str) or not np.iterable(value):
        return f"{value:.3g}" if isinstance(value, float | int) else str(value)
    inside = list(map(in_short, islice(value, 5)))
    return f"({', '.join(inside[:4])}{', ...' if len(inside) > 4 else ''})"
