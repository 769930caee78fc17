"""Grades one submission after another, each behind a wall of its own."""

from __future__ import annotations

import secrets
from contextlib import ExitStack
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from types import TracebackType

from lesson_code.course.grading.check_task import LARGEST_SEED
from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercise_of
from lesson_code.course.grading.feedback import left_out_name, missing_function
from lesson_code.course.grading.lending import Allowance, Lent
from lesson_code.course.grading.report import Report
from lesson_code.course.grading.submission import Submission, read_submission
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.verdict import Call, Verdict, better, calls_of, judge
from lesson_code.course.isolation import Children, InForce, Limits, StudentProcess, isolated
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.isolation.reader import TOO_SLOW


class Grader:
    """Keeps a warm server for as long as there are submissions to grade; a context manager.

    Parameters
    ----------
    isolation : str, optional
        The least isolation that will do: "full", "limits" or "none". The best that the system
        allows is used in any case; `isolation` and every report say which that is.
    limits : Limits, optional
        What a submission may use.
    hide_inputs : bool
        Keep inputs, values and the words of errors out of every message, so that the inputs can
        be used again.
    rung : str, optional
        The only rung of the ladder to use, by name; to measure them one by one.

    Raises
    ------
    IsolationError
        There is less isolation to be had than asked for. Raised before any submission is read.
    """

    isolation: InForce

    def __init__(
        self,
        *,
        isolation: str | None = None,
        limits: Limits | None = None,
        hide_inputs: bool = False,
        rung: str | None = None,
    ) -> None:
        self._least = isolation
        self._rung = rung
        self._limits = limits or Limits()
        self._hide_inputs = hide_inputs
        self._open = ExitStack()

    def __enter__(self) -> Grader:
        self._children: Children
        self._children, self.isolation = self._open.enter_context(
            isolated(self._limits, self._least, self._rung)
        )
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._open.close()

    def grade(
        self,
        path: Path,
        *,
        exercise: str | None = None,
        seed: int | None = None,
        seconds: int | None = None,
    ) -> Report:
        """Return what a submission has earned.

        Parameters
        ----------
        path : Path
            A notebook or a .py file.
        exercise : str, optional
            Name or number of the exercise, where the submission itself does not tell.
        seed : int, optional
            Draws the inputs; by default they differ from submission to submission.
        seconds : int, optional
            What the submission may use of the processor, if not as much as the limits say.

        Raises
        ------
        ValueError
            The file cannot be graded (SubmissionError), or there is no such exercise.
        """
        self._children.prepare()
        submission = read_submission(path)
        chosen = exercise_by_name(exercise) if exercise else exercise_of(submission)
        drawn = secrets.randbelow(LARGEST_SEED) if seed is None else seed
        limits = replace(
            self._limits, seconds_a_submission=seconds or self._limits.seconds_a_submission
        )
        with StudentProcess(submission.units, self._children, limits) as student:
            made = student.together(calls_of(chosen.tasks, drawn))
            call = _explaining(made, submission, chosen)
            verdicts: list[Verdict] = []
            allowance = Allowance()
            for task in chosen.tasks:
                verdict = judge(task, call, drawn, hide_inputs=self._hide_inputs)
                lost = [] if verdict.is_full else _lost(task, submission, verdicts)
                if lost:
                    lent = Lent(lost, allowance)
                    with_ours = _explaining(partial(student.call, lender=lent), submission, chosen)
                    again = judge(task, with_ours, drawn, hide_inputs=self._hide_inputs)
                    verdict = better(verdict, again, lent.used)
                verdicts.append(verdict)
            notes = (*submission.unreadable, *student.load_errors)
        was_cut_off = student.was_cut_off or any(TOO_SLOW in line for line in submission.unreadable)
        return Report(
            submission, chosen, tuple(verdicts), notes, drawn, self.isolation, was_cut_off
        )


def _lost(task: Task, submission: Submission, before: list[Verdict]) -> list[Task]:
    """Return the earlier tasks whose functions a task's answer calls, and that lost points."""
    used = submission.used_by(task.function)
    return [v.task for v in before if not v.is_full and v.task.function in used]


def _explaining(call: Call, submission: Submission, exercise: Exercise) -> Call:
    """Return a way to call functions that says of a missing one where it may be."""
    left_out = submission.left_out

    @cache  # there may be thousands of names that are like it
    def said_of_missing(function: str) -> str:
        others = [name for name in submission.functions if name not in exercise.task_ids]
        return missing_function(function, others, submission.lost)

    def explaining(function: str, arguments: Arguments) -> CallOutcome:
        outcome = call(function, arguments)
        if outcome.kind == "raised" and (why := left_out_name(outcome.text, left_out)):
            return CallOutcome("raised", text=f"{outcome.text}: {why}")
        if outcome.kind != "missing":
            return outcome
        return CallOutcome("missing", text=said_of_missing(function))

    return explaining


def grade(
    path: Path,
    *,
    exercise: str | None = None,
    seed: int | None = None,
    limits: Limits | None = None,
    isolation: str | None = None,
) -> Report:
    """Grade one submission, with a server of its own; the arguments are those of a Grader."""
    with Grader(isolation=isolation, limits=limits) as grader:
        return grader.grade(path, exercise=exercise, seed=seed)
