"""How a quiz went: every answer given, and the counts by chapter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

VERSION = 1
"""Version of the form that :meth:`QuizResult.as_dict` writes; it grows when a key changes."""


@dataclass(frozen=True, slots=True)
class QuestionResult:
    """What was answered to one question.

    Parameters
    ----------
    chapter : str
        The chapter's number.
    id : str
        The question's id.
    answers : tuple of str
        Every valid answer, as it was typed, first try first.
    right : bool
        Whether the last of them was right.
    """

    chapter: str
    id: str
    answers: tuple[str, ...]
    right: bool

    @property
    def right_first(self) -> bool:
        """Whether the first answer was right."""
        return self.right and len(self.answers) == 1


@dataclass(frozen=True, slots=True)
class ChapterScore:
    """One chapter's counts: how many were asked, and how many of them answered right."""

    chapter: str
    asked: int
    right_first: int
    right: int


@dataclass(frozen=True, slots=True)
class QuizResult:
    """Every question that got an answer, in order.

    Parameters
    ----------
    questions : tuple of QuestionResult
        The questions asked; one that was left without an answer is not among them.
    finished : bool
        Whether the quiz went on to its last question.
    """

    questions: tuple[QuestionResult, ...]
    finished: bool

    @property
    def scores(self) -> tuple[ChapterScore, ...]:
        """The counts of each chapter, in the order in which they were asked.

        >>> once = QuestionResult("01", "01-wall", answers=("a",), right=True)
        >>> twice = QuestionResult("01", "01-momentum", answers=("11", "1"), right=True)
        >>> QuizResult((once, twice), finished=True).scores
        (ChapterScore(chapter='01', asked=2, right_first=1, right=2),)
        """
        chapters = dict.fromkeys(question.chapter for question in self.questions)
        return tuple(self._score(chapter) for chapter in chapters)

    def _score(self, chapter: str) -> ChapterScore:
        """Return the counts of one chapter."""
        asked = [question for question in self.questions if question.chapter == chapter]
        return ChapterScore(
            chapter=chapter,
            asked=len(asked),
            right_first=sum(question.right_first for question in asked),
            right=sum(question.right for question in asked),
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the result as plain lists, texts and numbers, ready for JSON."""
        return {
            "version": VERSION,
            "finished": self.finished,
            "chapters": [
                {
                    "chapter": score.chapter,
                    "asked": score.asked,
                    "right_first": score.right_first,
                    "right": score.right,
                }
                for score in self.scores
            ],
            "questions": [
                {
                    "chapter": question.chapter,
                    "id": question.id,
                    "answers": list(question.answers),
                    "right": question.right,
                    "right_first": question.right_first,
                }
                for question in self.questions
            ],
        }
