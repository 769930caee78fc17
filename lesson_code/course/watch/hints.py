"""Help that comes a step at a time: what is wrong, a question, the misconception, the text."""

from __future__ import annotations

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN
from lesson_code.course.grading.verdict import Verdict


def hints(verdict: Verdict, exercise: Exercise) -> list[str]:
    """Return the help there is for a task that is not right, the gentlest first.

    Parameters
    ----------
    verdict : Verdict
        What the check has shown.
    exercise : Exercise
        Where the task stands.
    """
    messages = list(dict.fromkeys(c.message for c in verdict.criteria if c.message))
    if messages == [NOT_WRITTEN]:
        return [f"Not written yet. {verdict.task.objective}", _where_to_read(exercise)]
    steps = [messages[0]]
    if verdict.recognised is not None:
        steps.append(f"A question: {verdict.recognised.hint}")
        steps.append(f"Your answer is what comes of this: {verdict.recognised.misconception}")
    else:
        steps += [f"Also: {message}" for message in messages[1:]]
    steps.append(f"What is asked: {verdict.task.objective}")
    return [*steps, _where_to_read(exercise)]


def _where_to_read(exercise: Exercise) -> str:
    """Return where an exercise's chapter, or its own text, is to be read."""
    if exercise.suffix == ".ipynb":
        return f"Read notebook {exercise.name[:2]}, {exercise.title}, again."
    return f"Read what stands at the top of exercises/{exercise.file_name} again."
