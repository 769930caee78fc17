"""The solution of a task, for a student who has solved it."""

from __future__ import annotations

from pathlib import Path

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.self_check import answers_in
from lesson_code.course.grading.submission import SubmissionError
from lesson_code.course.grading.task import Task


def solution_of(exercise: Exercise, task: Task, root: Path) -> str | None:
    """Return how the solution writes a task's function; None where a copy holds no solutions."""
    try:
        for function, source in answers_in(exercise.solution(root), exercise):
            if function.name == task.function:
                lines = source.splitlines()[function.lineno - 1 : function.end_lineno]
                return "\n".join([f"# {task.title}, as the solution has it", *lines])
    except SubmissionError:
        return None
    return None
