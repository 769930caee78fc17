"""Gaps: what is written is used if it is right, and ours is lent if it is not."""

from __future__ import annotations

import inspect
from typing import Any

import pytest

from lesson_code.course.grading.gaps import Gap, all_gaps, gap, gap_by_id, is_open
from lesson_code.course.grading.task import WrongModel

GAPS = pytest.mark.parametrize("asked", all_gaps(), ids=lambda asked: asked.id)
MODELS = [
    pytest.param(asked, model, id=f"{asked.id}-{model.name}")
    for asked in all_gaps()
    for model in asked.wrong_models
]


def still_open(*_: Any) -> Any:
    """Stand for a gap that nobody has filled."""
    return ...


@GAPS
def test_open_gap_lends_ours_and_names_it(asked: Gap, capsys: pytest.CaptureFixture[str]) -> None:
    """With nothing written, the notebook goes on with our function."""
    assert gap(asked.id)(still_open) is asked.ours
    said = capsys.readouterr().out
    assert "still_open is yours to write" in said
    assert f"{asked.ours.__module__}.{asked.ours.__name__}" in said


@GAPS
def test_right_answer_is_used(asked: Gap, capsys: pytest.CaptureFixture[str]) -> None:
    """What is written stays: the reader's own function comes back."""

    def mine(*arguments: Any) -> Any:
        return asked.ours(*arguments)

    assert gap(asked.id)(mine) is mine
    assert "mine is right" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("asked", "model"), MODELS, ids=lambda each: getattr(each, "id", each.name)
)
def test_known_mistake_gets_its_hint(
    asked: Gap, model: WrongModel, capsys: pytest.CaptureFixture[str]
) -> None:
    """Each wrong model fails, is recognised, and leaves the notebook with ours."""
    assert gap(asked.id)(model.function) is asked.ours
    said = capsys.readouterr().out
    assert said.startswith("Not yet. ")
    assert "\nhint: " in said
    assert model.hint in said


@GAPS
def test_gap_belongs_to_its_chapter_and_knows_two_mistakes(asked: Gap) -> None:
    """Its id names the chapter it stands in, and a hint asks a question."""
    home = inspect.getmodule(asked.draw)
    assert home is not None
    assert home.__name__.startswith(f"lesson_code.chapters.ch{asked.id[:2]}_")
    assert len(asked.wrong_models) >= 2
    assert all("?" in model.hint and model.misconception for model in asked.wrong_models)


def test_error_in_what_is_written_stops_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    """A name that is not there is told, and ours is lent."""

    def broken(*_: Any) -> Any:
        raise NameError("name 'v3' is not defined")

    assert gap("01-centre")(broken) is gap_by_id("01-centre").ours
    assert "v3" in capsys.readouterr().out


def test_unknown_gap_is_refused_by_name() -> None:
    """The error lists the gaps there are."""
    with pytest.raises(ValueError, match=r"gap must be one of .*01-centre.*, got '99-none'"):
        gap("99-none")


def test_open_means_that_the_dots_still_stand() -> None:
    """A function without dots counts as written, whatever it returns."""
    assert is_open(still_open)
    assert not is_open(lambda: None)
