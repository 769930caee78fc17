"""Marks: tasks, what is expected, what was answered, and what is said to it."""

from lesson_code.course.grading.check_task import check_task

__all__ = ["check_task"]
