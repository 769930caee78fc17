"""What the tasks of the soft body tell apart."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from random import Random

import pytest
from tiers import share

from lesson_code.chapters.soft_body import rules
from lesson_code.chapters.soft_body.rules import BLOB, Blob, drop
from lesson_code.chapters.soft_body.tasks import TASKS, is_damped, keeps_area, landings, rebounds
from lesson_code.course.grading.verdict import drawn

FALLS = 24

MOST_STEPS = 300
"""Of all calls of S.4 together. A student's step takes 0.1 ms, or ten times that in plain Python;
a call may take 3 s."""


def left_after(blob: Blob, falls: int, monkeypatch: pytest.MonkeyPatch) -> Iterator[bool]:
    """Yield of some falls by the rules with other constants whether they pass as damped."""
    monkeypatch.setattr(rules, "BLOB", blob)
    for seed in range(falls):
        for fall in rebounds(Random(seed)):  # noqa: S311
            yield all(is_damped(drop(*fall)))


def test_is_damped_holds_of_every_fall_by_the_rules(monkeypatch: pytest.MonkeyPatch) -> None:
    """The right answer rises with the energy that is asked for, however the ring is turned."""
    assert all(left_after(BLOB, share(FALLS), monkeypatch))


def test_keeps_area_holds_of_every_fall_by_the_rules() -> None:
    """The right answer keeps its area at its landing."""
    for seed in range(share(FALLS)):
        for fall in landings(Random(seed)):  # noqa: S311
            assert keeps_area(drop(*fall)) == [True, True, True]
            assert keeps_area(fall[:2]) == [True, True, False], "a ring that has not fallen"


@pytest.mark.parametrize("blob", [replace(BLOB, air=0.0), replace(BLOB, damping=0.0)])
def test_is_damped_fails_without_air_and_without_damping(
    blob: Blob, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A fall that loses no energy to the air, or none in its springs, has too much left."""
    assert not any(left_after(blob, share(FALLS), monkeypatch))


def test_drop_is_graded_by_few_steps() -> None:
    """The calls of S.4 cost little, since students may write it slowly."""
    [task] = [task for task in TASKS if task.id == "S.4"]
    calls = [call for criterion in task.criteria for call, _ in drawn(task, criterion, 0)]
    assert sum(arguments[-1] for arguments in calls) < MOST_STEPS
