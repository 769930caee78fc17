"""Help that comes a step at a time: what is wrong, a question, an example, where to read."""

from __future__ import annotations

from pathlib import Path
from random import Random

from lesson_code.course.grading.compare import written
from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN, call_of
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.verdict import Verdict
from lesson_code.course.isolation.inside.answers import arguments_from, plain
from lesson_code.course.notebooks.parts import parts


def hints(verdict: Verdict, exercise: Exercise, root: Path) -> list[str]:
    """Return the help there is for a task that is not right, the gentlest first.

    Parameters
    ----------
    verdict : Verdict
        What the check has shown.
    exercise : Exercise
        Where the task stands.
    root : Path
        The workbook whose notebooks are read.
    """
    messages = list(dict.fromkeys(c.message for c in verdict.criteria if c.message))
    if messages == [NOT_WRITTEN]:
        return [
            f"Not written yet. {verdict.task.objective}",
            where_to_read(verdict.task, exercise, root),
        ]
    steps = [messages[0]]
    if verdict.recognised is not None:
        steps.append(f"A question: {verdict.recognised.hint}")
        steps.append(f"Your answer is what comes of this: {verdict.recognised.misconception}")
    else:
        steps += [f"Also: {message}" for message in messages[1:]]
    steps.append(f"What is asked: {verdict.task.objective}")
    steps.append(example(verdict.task))
    return [*steps, where_to_read(verdict.task, exercise, root)]


def example(task: Task) -> str:
    """Return a call with its right answer, with other numbers than those of the check.

    Of the first calls of all criteria it is the one with the fewest digits, which is the easiest
    to follow by hand.
    """
    stream = Random(0)  # noqa: S311 - any will do
    calls = [next(iter(criterion.cases(stream))) for criterion in task.criteria]
    arguments = min(calls, key=lambda call: len(call_of(task, call)))
    answer = plain(task.expected(*arguments_from(arguments)))
    return f"An example to follow by hand: {call_of(task, arguments)} is {written(answer)}."


def where_to_read(task: Task, exercise: Exercise, root: Path) -> str:
    """Return which section of a chapter, or which other text, is to be read."""
    if task.section is not None:
        number = exercise.name[:2]
        titles = (p.title for p in parts(root, number) if p.has_section(task.section))
        title = next(titles, f"{number} {exercise.title}")
        return f"Read section {task.section} of notebook {title} again."
    return f"Read what stands at the top of exercises/{exercise.file_name} again."
