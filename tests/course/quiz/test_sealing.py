"""The sealed bank: asks the same, judges the same, and tells no key at a glance."""

from __future__ import annotations

import tomllib

import pytest

from lesson_code.course.chapters import chapters
from lesson_code.course.quiz.bank import QUIZ, chapter_numbers, load_quiz, read_quiz
from lesson_code.course.quiz.questions import ChoiceQuestion
from lesson_code.course.quiz.sealing import SECRET, seal_quiz

CHAPTERS = chapter_numbers()


def written(number: str) -> str:
    """Return a chapter's file."""
    chapter = next(chapter for chapter in chapters() if chapter.number == number)
    return chapter.file(QUIZ).read_text(encoding="utf-8")


@pytest.mark.parametrize("number", CHAPTERS)
def test_sealed_chapter_is_the_same_chapter(number: str) -> None:
    """Questions, keys and feedback come back as they were."""
    assert read_quiz(number, seal_quiz(written(number))) == load_quiz(number)


@pytest.mark.parametrize("number", CHAPTERS)
def test_sealed_chapter_shows_what_is_asked_and_no_key(number: str) -> None:
    """Questions and options can be read; which is right, values and feedback cannot."""
    sealed = seal_quiz(written(number))
    table = tomllib.loads(sealed)
    quiz = load_quiz(number)
    entries = [*table["question"], *table.get("predict", [])]
    for question, entry in zip((*quiz.questions, *quiz.predictions), entries, strict=True):
        assert entry["text"] == question.text
        assert not set(entry) & set(SECRET[entry["kind"]])
        if isinstance(question, ChoiceQuestion):
            assert entry["options"] == [option.text for option in question.options]
            assert all(option.feedback not in sealed for option in question.options)
            assert len(entry["key"]) == 64
        else:
            assert question.right_feedback not in sealed
            sheet = {"given", "spacing", "reach", "wall"} if entry["kind"] == "arrow" else set()
            assert set(entry) - sheet == {"id", "kind", "text", "unit", "salt", "sealed"}


def test_same_letter_has_another_hash_in_each_question() -> None:
    """So that one key that is known tells nothing of the others."""
    entries = [e for n in CHAPTERS for e in tomllib.loads(seal_quiz(written(n)))["question"]]
    keys = [entry["key"] for entry in entries if entry["kind"] == "choice"]
    assert len(set(keys)) == len(keys) > len("abcde")


def test_each_question_has_a_salt_of_its_own() -> None:
    """Two questions with the same key look different under their seals."""
    table = tomllib.loads(seal_quiz(written("01")))
    salts = [question["salt"] for question in table["question"]]
    assert len(set(salts)) == len(salts) > 1


def test_sealing_twice_gives_the_same_bytes() -> None:
    """A release depends on the workbook alone."""
    assert seal_quiz(written("03")) == seal_quiz(written("03"))
