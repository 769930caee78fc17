"""One bank of questions and one checker, used by the notebook and the terminal.

The notebook's quiz stands in :mod:`lesson_code.course.quiz.notebook` and the terminal's in
:mod:`lesson_code.course.quiz.terminal`, so that neither loads what only the other needs.
"""

from lesson_code.course.quiz.bank import Quiz, chapter_numbers, load_bank, load_quiz
from lesson_code.course.quiz.checker import CheckedAnswer, check_answer
from lesson_code.course.quiz.questions import Question

__all__ = [
    "CheckedAnswer",
    "Question",
    "Quiz",
    "chapter_numbers",
    "check_answer",
    "load_bank",
    "load_quiz",
]
