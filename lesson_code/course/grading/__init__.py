"""Marks: what a task asks and expects, what was answered, and what the student is told."""

from lesson_code.course.grading.check_task import check_task

__all__ = ["check_task"]
