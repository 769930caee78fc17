"""The quiz of chapter 01, checked against the laws of a collision."""

from __future__ import annotations

from lesson_code.course.quiz.bank import load_quiz
from lesson_code.course.quiz.questions import ChoiceQuestion


def test_equal_masses_only_the_exchange_keeps_momentum_and_energy_and_changes_something() -> None:
    """Of the options of 01-equal-masses one alone obeys both laws and is a collision."""
    before = (3, -1)
    afters = {"a": (-3, 1), "b": (1, 1), "c": (0, 3), "d": (-1, 3), "e": (3, -1)}
    right = [
        letter
        for letter, after in afters.items()
        if sum(after) == sum(before)
        and sum(v * v for v in after) == sum(v * v for v in before)
        and after != before
    ]
    (question,) = [q for q in load_quiz("01").questions if q.id == "01-equal-masses"]
    assert isinstance(question, ChoiceQuestion)
    written = [
        f"v1\N{PRIME} = {v1} m/s, v2\N{PRIME} = {v2} m/s".replace("-", "\N{MINUS SIGN}")
        for v1, v2 in afters.values()
    ]
    assert [option.text for option in question.options] == written
    assert right == [question.answer]
