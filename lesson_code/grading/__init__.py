"""The exercises' tasks, wrong models, isolation of student code, reports."""

from lesson_code.grading.check_task import check_task

__all__ = ["check_task"]
