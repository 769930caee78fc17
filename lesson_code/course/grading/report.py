"""The marks of one submission: graded across the wall, as a table and as JSON."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from rich.console import Console, Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.submission import Submission
from lesson_code.course.grading.verdict import CriterionVerdict, Verdict
from lesson_code.course.isolation import InForce
from lesson_code.course.isolation.call_outcome import one_line

VERSION = 3
"""Version of the form that :meth:`Report.as_dict` writes; it grows when a key changes."""


@dataclass(frozen=True)
class Report:
    """What a submission has earned, task by task.

    `was_cut_off` says that it wanted more time than it may use.
    """

    submission: Submission
    exercise: Exercise
    verdicts: tuple[Verdict, ...]
    notes: tuple[str, ...]
    seed: int
    isolation: InForce
    was_cut_off: bool = False

    @property
    def points(self) -> int:
        """The points earned."""
        return sum(verdict.points for verdict in self.verdicts)

    @property
    def is_full(self) -> bool:
        """Whether every task has full marks."""
        return self.points == self.exercise.points

    def as_dict(self) -> dict[str, Any]:
        """Return the report as one JSON object."""
        return {
            "version": VERSION,
            "command": "grade",
            "submission": str(self.submission.path),
            "exercise": self.exercise.name,
            "seed": self.seed,
            "isolation": self.isolation.as_dict(),
            "points": self.points,
            "full_points": self.exercise.points,
            "tasks": [_task_as_dict(verdict) for verdict in self.verdicts],
            "notes": list(self.notes),
        }


def print_report(report: Report, console: Console) -> None:
    """Print a report as a table, followed by what is wrong in each task."""
    name = one_line(str(report.submission.path))
    console.print(Text(f"{name}: {report.exercise.title}", style="bold"))
    table = Table("task", "function", "points", "what is right", "what is not")
    for verdict in report.verdicts:
        table.add_row(
            verdict.task.id,
            verdict.task.function,
            f"{verdict.points}/{verdict.task.points}",
            _names(verdict.criteria, full=True),
            _names(verdict.criteria, full=False),
        )
    table.add_section()
    table.add_row("", "", f"{report.points}/{report.exercise.points}", "", "", style="bold")
    console.print(table)
    for verdict in report.verdicts:
        if not verdict.is_full or verdict.lent:
            console.print(_to_mend(verdict))
    for note in report.notes:
        console.print(Text(f"left out: {note}"))
    console.print(Text(f"seed {report.seed}, isolation: {report.isolation}", style="dim"))


def _names(criteria: tuple[CriterionVerdict, ...], *, full: bool) -> str:
    """Return the names of the criteria that hold, or of those that do not."""
    return "\n".join(c.name for c in criteria if (c.points == c.full_points) is full)


def _to_mend(verdict: Verdict) -> Group:
    """Return what was asked, and what there is to say about the answer."""
    first, *rest = verdict.lines
    lines: list[Any] = [Text(first), _indented(verdict.task.objective, "italic")]
    for line in rest:
        is_hint = line.startswith("  hint: ")
        lines.append(_indented(line.strip(), "bold" if is_hint else ""))
    return Group(*lines)


def _indented(text: str, style: str) -> Padding:
    """Return a line below the one that names the task."""
    return Padding(Text(text, style=style), (0, 0, 0, 2))


def _task_as_dict(verdict: Verdict) -> dict[str, Any]:
    """Return a task's marks as a JSON object."""
    model = verdict.recognised
    return {
        "task": verdict.task.id,
        "function": verdict.task.function,
        "points": verdict.points,
        "full_points": verdict.task.points,
        "criteria": [
            {
                "name": criterion.name,
                "points": criterion.points,
                "full_points": criterion.full_points,
                "message": criterion.message,
            }
            for criterion in verdict.criteria
        ],
        "lent": verdict.said_of_lent,
        "wrong_model": None if model is None else {"name": model.name, "hint": model.hint},
    }
