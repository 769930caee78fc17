"""Why an answer is wrong: recognised where it differs, and never said wrongly."""

from __future__ import annotations

import ast
import copy
import math
from collections.abc import Callable
from functools import partial
from random import Random
from typing import Any

import numpy as np
import pytest
from course.recognition.apprentices import THIRTEENTH
from course.recognition.beginners import TWELFTH
from course.recognition.hobbyists import FIFTH
from course.recognition.juniors import NINTH
from course.recognition.markers import ELEVENTH
from course.recognition.mathematicians import SEVENTH
from course.recognition.newcomers import FIRST, FOURTH, SECOND, THIRD
from course.recognition.pupils import SIXTH
from course.recognition.students import WRONG, Wrong
from course.recognition.teachers import TENTH
from course.recognition.test_right_answers import FORMS, TASKS, WAYS
from course.recognition.textual_slips import textual_slips
from course.recognition.tutors import EIGHTH
from tiers import share

from lesson_code.course.grading.compare import agrees
from lesson_code.course.grading.exercises import exercises, task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.recognition import Diagnosis, answer_of, is_degenerate
from lesson_code.course.grading.recognition.candidates import (
    most_models,
    pairs,
    right_answers,
    slips,
)
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.grading.verdict import Verdict, drawn, judge
from lesson_code.course.notebooks.root import home

LATER = (FIFTH, SIXTH, SEVENTH, EIGHTH, NINTH, TENTH, ELEVENTH, TWELFTH, THIRTEENTH)
"""Sets of wrong answers that the full tier tries, after the others."""

SEED = 11
"""Draws the inputs of the wrong answers by hand; they were measured with others, too."""

FEWEST_RECOGNISED = 0.9
"""Of the wrong answers by hand: what the course promises."""

MOST_SLIPS = 4
SLIPS_A_SOURCE = share(MOST_SLIPS, one_in=MOST_SLIPS)
"""Slips made in the text of each right answer; all together 742 in the full tier."""

FEWEST = 500
"""Slips whose cause is known, and right answers, that the course promises to have tried."""

FRESH_SEEDS = range(40, 43)
"""Draws of which the diagnosis knew nothing."""

SECONDS = 0.5
"""Of a call; a slip may make a loop that never ends."""

LIGHT = [
    task for exercise in exercises() for task in exercise.tasks if most_models(task) > 100
]  # fmt: skip
"""Tasks whose right answer takes little work, so that many slips in it can be judged."""


def judged(task: Task, function: Callable[..., Any], seed: int = SEED) -> Verdict:
    """Return what a function earns."""
    return judge(task, partial(call_here, {task.function: function}, seconds=SECONDS), seed)


def verdict_of(wrong: Wrong, seed: int = SEED) -> Verdict:
    """Return what a student's wrong answer earns."""
    task = task_by_id(wrong.task)
    names = names_given(task)
    exec(wrong.source, names)  # noqa: S102 - written here
    return judged(task, names[task.function], seed)


def names_given(task: Task) -> dict[str, Any]:
    """Return what a file gives a student beside the function to write: constants, and helpers."""
    names: dict[str, Any] = {"__name__": "student", "math": math, "np": np}
    exercise = next(each for each in exercises() if task in each.tasks)
    if exercise.suffix == ".py":
        exec(exercise.student_copy(home()).read_text(), names)  # noqa: S102 - the course's own
    else:
        names |= right_answers(task.id, task.function)[0].names
    return names


def is_right(wrong: Wrong, verdict: Verdict) -> bool:
    """Return whether all that was said of an answer is its cause."""
    return all(any(word in found.name for word in wrong.found) for found in verdict.diagnoses)


@pytest.mark.parametrize(
    "answers",
    [
        *(WRONG, FIRST, SECOND, THIRD, FOURTH),
        *(pytest.param(answers, marks=pytest.mark.full) for answers in LATER),
    ],
    ids=[f"set {number}" for number in range(5 + len(LATER))],
)
def test_wrong_answers_by_hand_are_recognised_nine_times_in_ten(answers: tuple[Wrong, ...]) -> None:
    """Of wrong answers written by hand at least nine in ten are explained, and none wrongly."""
    verdicts = [(wrong, verdict_of(wrong)) for wrong in answers]
    assert not [wrong.cause for wrong, verdict in verdicts if verdict.is_full]
    assert not [wrong.cause for wrong, verdict in verdicts if not is_right(wrong, verdict)]
    explained = [wrong for wrong, verdict in verdicts if verdict.diagnoses]
    assert len(explained) >= FEWEST_RECOGNISED * len(answers)


@pytest.mark.one_in(4)
@pytest.mark.parametrize("task", LIGHT, ids=lambda task: task.title)
def test_diagnosis_of_a_machine_made_slip_holds_for_inputs_it_did_not_see(task: Task) -> None:
    """What is said of a slip in a right answer's text is its kind, or true of other draws, too."""
    stream = Random(task.id)  # noqa: S311
    for answer in right_answers(task.id, task.function):
        found = textual_slips(ast.unparse(_as_written(answer.definition)))
        for kind, text in stream.sample(found, min(SLIPS_A_SOURCE, len(found))):
            names = dict(answer.names)
            exec(text, names)  # noqa: S102 - the course's own source
            for diagnosis in judged(task, names["slip"]).diagnoses:
                is_true = kind in diagnosis.name or holds_elsewhere(task, names["slip"], diagnosis)
                assert is_true, (diagnosis.name, text)


def test_slips_and_right_answers_that_are_tried_are_five_hundred_each() -> None:
    """The full tier makes so many: no fewer than are promised."""
    sources = [answer for task in LIGHT for answer in right_answers(task.id, task.function)]
    found = [textual_slips(ast.unparse(_as_written(answer.definition))) for answer in sources]
    assert sum(min(MOST_SLIPS, len(slips)) for slips in found) >= FEWEST
    right = [answer for task in TASKS for answer in right_answers(task.id, task.function)]
    assert len(WAYS) * len(right) + len(FORMS) * len(TASKS) >= FEWEST


def _as_written(definition: ast.FunctionDef) -> ast.FunctionDef:
    """Return a right answer without what counts the rounds of its loops."""
    written = copy.deepcopy(definition)
    for node in ast.walk(written):
        if isinstance(node, ast.For | ast.While):
            del node.body[0]
    return written


def holds_elsewhere(task: Task, function: Callable[..., Any], diagnosis: Diagnosis) -> bool:
    """Return whether one of the mistakes gives a function's own wrong answers to fresh inputs."""
    calls = []
    for criterion in task.criteria:
        for seed in FRESH_SEEDS if criterion.name in diagnosis.criteria else ():
            for arguments, expected in drawn(task, criterion, seed):
                outcome = call_here({task.function: function}, task.function, arguments, SECONDS)
                call = TriedCall(criterion, arguments, expected, outcome)
                if outcome.kind == "returned" and not call.is_right:
                    calls.append(call)
    telling = [call for call in calls if not is_degenerate(call.arguments)]
    return any(
        all(agrees(call.got, answer_of(mistake, call)) for call in telling)
        for mistake in diagnosis.mistakes
    )


def test_slips_of_a_task_are_made_once_and_none_is_right_by_name_alone() -> None:
    """Slips and pairs are kept; each has a hint that asks and a misconception."""
    task = task_by_id("1.1")
    assert slips(task) is slips(task)
    assert pairs(task) is pairs(task)
    assert all(model.hint.endswith("?") and model.misconception for model in slips(task))


def test_task_of_no_chapter_has_no_slips_in_its_source() -> None:
    """A task that is made up has no right answer whose source could be rewritten."""
    assert right_answers("9.9", "never") == []


def test_two_mistakes_that_explain_the_same_are_both_said() -> None:
    """1 - e for 1 + e is a sign turned round or a term taken for another: both are named."""
    (wrong,) = [each for each in WRONG if each.cause.startswith("1 - e instead")]
    verdict = verdict_of(wrong)
    assert len(verdict.diagnoses[0].mistakes) == 2
    assert verdict.recognised is None
    assert " Or: " in verdict.lines[-1]
