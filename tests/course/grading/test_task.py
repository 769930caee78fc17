"""What a task is made of: marks on functions, points, and sources as students hand them in."""

from __future__ import annotations

import pytest

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.task import (
    Alternative,
    WrongModel,
    alternative,
    for_task,
    marked,
    source_as_answer,
    wrong_model,
)

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


def test_marked_lists_one_kind_in_the_order_of_the_module() -> None:
    """Wrong models and alternatives of a module are told apart."""
    module = {"a": unusual, "b": wrong, "c": 3}
    assert marked(module, WrongModel) == (wrong,)
    assert marked(module, Alternative) == (unusual,)
    assert for_task((wrong,), "9.1") == (wrong,)
    assert for_task((wrong,), "9.2") == ()


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
