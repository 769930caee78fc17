"""How far a student is: the points of each task, kept from one day to the next."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.feedback import NOT_WRITTEN
from lesson_code.course.grading.report import Report
from lesson_code.course.grading.task import Task

NAME = ".progress.json"
VERSION = 1


@dataclass
class TaskState:
    """A task's points at the last check, and how often it has failed since it was last right."""

    points: int = 0
    tries: int = 0


class Progress:
    """The points of each task of the course, in a file beside the exercises.

    A file that cannot be read is replaced: everything in it can be worked out again.

    Parameters
    ----------
    folder : Path
        Holds the exercises.
    """

    def __init__(self, folder: Path) -> None:
        self._path = folder / NAME
        self._tasks: dict[str, TaskState] = {}
        self._checked: dict[str, str] = {}
        try:
            stored = json.loads(self._path.read_text(encoding="utf-8"))
            tasks = {task: TaskState(**state) for task, state in stored["tasks"].items()}
            checked = {str(name): str(digest) for name, digest in stored["checked"].items()}
        except (OSError, ValueError, TypeError, KeyError, AttributeError):
            return
        if stored.get("version") == VERSION:
            self._tasks, self._checked = tasks, checked

    def of(self, task: Task) -> TaskState:
        """Return the state of a task."""
        return self._tasks.setdefault(task.id, TaskState())

    def is_right(self, task: Task) -> bool:
        """Return whether a task had full marks at its last check."""
        return self.of(task).points == task.points

    def is_checked(self, exercise: Exercise, path: Path) -> bool:
        """Return whether a file is as it was when it was last checked."""
        return self._checked.get(exercise.name) == _digest(path)

    def note(self, report: Report) -> None:
        """Keep what a check has shown. A stub is no failed try."""
        for verdict in report.verdicts:
            state = self.of(verdict.task)
            state.points = verdict.points
            if verdict.is_full:
                state.tries = 0
            elif any(c.message != NOT_WRITTEN for c in verdict.criteria if c.message):
                state.tries += 1
        self._checked[report.exercise.name] = _digest(report.submission.path)
        self._save()

    def forget(self, exercise: Exercise) -> None:
        """Forget what is known of an exercise."""
        for task in exercise.tasks:
            self._tasks.pop(task.id, None)
        self._checked.pop(exercise.name, None)
        self._save()

    def count(self, exercises: Sequence[Exercise]) -> tuple[int, int]:
        """Return how many tasks of some exercises are right, and how many there are."""
        tasks = [task for exercise in exercises for task in exercise.tasks]
        return sum(map(self.is_right, tasks)), len(tasks)

    def points(self, exercises: Sequence[Exercise]) -> tuple[int, int]:
        """Return the points earned in some exercises, and the full mark."""
        earned = sum(self.of(task).points for exercise in exercises for task in exercise.tasks)
        return earned, sum(exercise.points for exercise in exercises)

    def _save(self) -> None:
        """Write the file, whole or not at all."""
        value: dict[str, Any] = {
            "version": VERSION,
            "tasks": {name: vars(state) for name, state in sorted(self._tasks.items())},
            "checked": self._checked,
        }
        new = self._path.with_name(f"{NAME}.new")
        new.write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")
        new.replace(self._path)


def _digest(path: Path) -> str:
    """Return what tells a file's content from any other."""
    try:
        return hashlib.sha256(path.read_bytes()).hexdigest()[:16]
    except OSError:
        return ""
