"""What a task is made of: marks on functions, points, and sources as students hand them in."""

from __future__ import annotations

import inspect

import pytest

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.task import (
    Alternative,
    WrongModel,
    alternative,
    edited,
    wrong_model,
)

from ..conftest import source_as_answer

ALL_TASKS = [task for exercise in exercises() for task in exercise.tasks]


@wrong_model("9.1", "Why?")
def wrong(x: float, *, y: float = 1.0) -> float:
    """It is so."""  # noqa: D401 - a misconception
    return x + y


@alternative("9.2")
def unusual(x: float) -> float:
    """In a way of its own."""
    return x


def test_wrong_model_carries_name_misconception_and_hint() -> None:
    """A marked function keeps its name, its docstring as the misconception, and still computes."""
    assert (wrong.name, wrong.misconception, wrong.hint) == ("wrong", "It is so.", "Why?")
    assert (wrong(1.0), unusual(2.0)) == (2.0, 2.0)


@wrong_model("9.2", "Where is it at first?")
@edited(unusual, {"return x": "return -x"})
def reversed_sign() -> None:
    """It is so, the other way round."""  # noqa: D401 - a misconception


def test_edited_answer_is_the_right_one_with_the_edit() -> None:
    """It computes what its source says, under its own name and with its own misconception."""
    assert unusual(2.0) == 2.0
    assert reversed_sign(2.0) == -2.0
    assert reversed_sign.name == "reversed_sign"
    assert reversed_sign.misconception == "It is so, the other way round."
    source = inspect.getsource(reversed_sign.function)
    assert source.startswith("def reversed_sign(x: float)")
    assert "return -x" in source


@pytest.mark.parametrize("piece", ["return y", "x"], ids=["nowhere", "twice"])
def test_edited_piece_must_stand_once(piece: str) -> None:
    """An edit that would change nothing, or more than is meant, is refused by name."""
    with pytest.raises(ValueError, match=f"'{piece}' must stand once in unusual, for spoilt"):

        @edited(unusual, {piece: "0.0"})
        def spoilt() -> None:
            """It is so."""  # noqa: D401 - a misconception


@pytest.mark.parametrize(
    "mark",
    [mark for task in ALL_TASKS for mark in (*task.wrong_models, *task.alternatives)],
    ids=lambda mark: f"{mark.task} {mark.name}",
)
def test_source_as_answer_is_what_a_student_would_hand_in(
    mark: WrongModel | Alternative,
) -> None:
    """The source is plain Python: renamed, without decorators, and without type annotations."""
    source = source_as_answer(mark, "renamed")
    namespace: dict[str, object] = {}
    exec(source, namespace)  # noqa: S102 - our own source
    assert callable(namespace["renamed"])
    assert not namespace["renamed"].__annotations__  # type: ignore[attr-defined]
    assert "wrong_model(" not in source
    assert "alternative(" not in source
