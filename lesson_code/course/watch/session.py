"""A session of ``workbook watch``: what it says, and what it does when a file or a line comes."""

from __future__ import annotations

import queue
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from lesson_code.course.grading.exercises import Exercise
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.report import Report
from lesson_code.course.grading.submission import SubmissionError
from lesson_code.course.grading.verdict import Verdict
from lesson_code.course.watch.files import Files
from lesson_code.course.watch.hints import hints
from lesson_code.course.watch.progress import Progress
from lesson_code.course.watch.reset import put_back
from lesson_code.course.watch.screen import Screen
from lesson_code.course.watch.solutions import solution_of

SECONDS_BETWEEN_LOOKS = 0.3

HELP = "h: more help   l: list   n: next exercise   s: solution   r: reset   q: quit   (then Enter)"


@dataclass
class WatchSession:
    """Exercises that are watched, what is known of them, and the one that is on the screen.

    Parameters
    ----------
    root : Path
        The workbook.
    exercises : sequence of Exercise
        Those that are watched, in the order of the course.
    grader : Grader
        Grades the files.
    screen : Screen
        Where everything is written.
    """

    root: Path
    exercises: Sequence[Exercise]
    grader: Grader
    screen: Screen
    progress: Progress = field(init=False)
    current: Exercise = field(init=False)
    reports: dict[str, Report] = field(init=False, default_factory=dict)
    asked: dict[str, int] = field(init=False, default_factory=dict)
    resetting: bool = field(init=False, default=False)

    def __post_init__(self) -> None:
        self.progress = Progress(self.root / "exercises")
        self.current = self.exercises[0]

    def begin(self) -> None:
        """Check whatever has changed since the last session, and find where to go on."""
        changed = [
            exercise
            for exercise in self.exercises
            if (path := exercise.student_copy(self.root)).exists()
            and not self.progress.is_checked(exercise, path)
        ]
        if changed:
            self.screen.say(f"Checking {', '.join(exercise.name for exercise in changed)}")
        for exercise in changed:
            self._check(exercise)
        self.current = next((e for e in self.exercises if not self._is_done(e)), self.current)

    def run(self, lines: queue.Queue[str]) -> None:
        """Watch until a line says to stop."""
        paths = {exercise.student_copy(self.root): exercise for exercise in self.exercises}
        files = Files(paths)  # before anything is shown, so that no save is missed meanwhile
        self.show()
        while True:
            for path in files.saved():
                self.saved(paths[path])
            try:
                line = lines.get(timeout=SECONDS_BETWEEN_LOOKS)
            except queue.Empty:
                continue
            if not self.obey(line):
                return

    def saved(self, exercise: Exercise) -> None:
        """Check an exercise that was saved, and show it."""
        self.current = exercise
        self.asked.clear()
        self._check(exercise)
        self.show()

    def obey(self, line: str) -> bool:
        """Do what a line asks for; return False if it asks to stop."""
        word = line.strip().lower()
        asked_for_yes, self.resetting = self.resetting, False
        commands = {"h": self.hint, "l": self.list, "n": self.next, "s": self.solution}
        if asked_for_yes and word == "yes":
            self.reset()
        elif asked_for_yes:
            self.screen.say("It is left as it is.")
        elif word in ("q", "quit"):
            return False
        elif word[:1] == "r":
            self.resetting = True
            self.screen.say(f"Put {self.current.name} back to its beginning? Type yes, then Enter.")
        elif word[:1] in commands:
            commands[word[:1]]()
        else:
            self.screen.say(HELP)
        return True

    def show(self) -> None:
        """Show the course, the exercise, and what to do next."""
        self.screen.begin()
        self._show_course()
        path = self.current.student_copy(self.root)
        if not path.exists():
            self.screen.say(f"{path}: is not there. r puts it back.")
            return
        report = self._report(self.current)
        if report is None:
            return
        self.screen.exercise(self.current.title, [(v.line, v.is_full) for v in report.verdicts])
        for note in report.notes:
            self.screen.say(f"Left out: {note}")
        self._show_next(report)
        self.screen.say(HELP)

    def list(self) -> None:
        """List every exercise with how far it is."""
        for exercise in self.exercises:
            right, tasks = self.progress.count([exercise])
            earned, full = self.progress.points([exercise])
            name = exercise.file_name
            self.screen.row(name, f"{right} of {tasks} tasks", f"{earned} of {full} points")
        self._show_course()

    def hint(self) -> None:
        """Show one step more of the help for the task that is next."""
        report = self._report(self.current)
        verdict = report and _first_open(report)
        if not verdict:
            self.screen.say("Nothing is left to mend in this exercise.")
            return
        self.asked[verdict.task.id] = self.asked.get(verdict.task.id, 0) + 1
        level, steps = self._level(verdict), hints(verdict, self.current, self.root)
        if level > len(steps):
            self.screen.say("That is all the help there is here. Ask whoever teaches you.")
        else:
            self.screen.help(verdict.task.title, steps[level - 1 : level])

    def next(self) -> None:
        """Go to the next exercise that is not done, from the beginning again after the last."""
        place = self.exercises.index(self.current)
        order = [*self.exercises[place + 1 :], *self.exercises[: place + 1]]
        self.current = next((e for e in order if not self._is_done(e)), order[0])
        self.show()

    def solution(self) -> None:
        """Show the solution of each task that is right, and of no other."""
        right = [task for task in self.current.tasks if self.progress.is_right(task)]
        if not right:
            self.screen.say("A solution is shown once your own answer is right.")
        for task in right:
            found = solution_of(self.current, task, self.root)
            self.screen.code(found or f"{task.title}: this copy holds no solutions.")

    def reset(self) -> None:
        """Put the current exercise back, and say where what was there is kept."""
        try:
            backup = put_back(self.current, self.root)
        except (OSError, ValueError) as error:
            self.screen.say(str(error))
            return
        self.progress.forget(self.current)
        self.reports.pop(self.current.name, None)
        kept = f" What was there is kept in {backup.relative_to(self.root)}." if backup else ""
        self.screen.say(f"{self.current.name} is back at its beginning.{kept}")

    def _show_course(self) -> None:
        """Show how far the course is."""
        self.screen.course(
            self.progress.count(self.exercises), self.progress.points(self.exercises)
        )

    def _show_next(self, report: Report) -> None:
        """Show the help for the first task that is not right, or that all are."""
        verdict = _first_open(report)
        if verdict is None:
            done = all(map(self._is_done, self.exercises))
            more = "That is the whole course." if done else "n goes on to the next exercise."
            self.screen.say(f"All of it is right. {more} s shows how we wrote it.")
        else:
            self._show_help(verdict)

    def _show_help(self, verdict: Verdict) -> None:
        """Show the help for a task, up to where it has come."""
        steps = hints(verdict, self.current, self.root)
        self.screen.help(verdict.task.title, steps[: self._level(verdict)])

    def _level(self, verdict: Verdict) -> int:
        """Return how many steps of help are due: one more with each failed try or request."""
        asked = self.asked.get(verdict.task.id, 0)
        return max(self.progress.of(verdict.task).tries, 1) + asked

    def _report(self, exercise: Exercise) -> Report | None:
        """Return an exercise's latest report, checked now if there is none from this session."""
        if exercise.name not in self.reports:
            self._check(exercise)
        return self.reports.get(exercise.name)

    def _check(self, exercise: Exercise) -> None:
        """Check an exercise and keep what was found; say it if its file cannot be read."""
        try:
            path = exercise.student_copy(self.root)
            report = self.grader.grade(path, exercise=exercise.name)
        except (SubmissionError, OSError) as error:
            self.reports.pop(exercise.name, None)
            self.screen.say(str(error))
            return
        if not self.progress.is_checked(exercise, path):
            self.progress.note(report)
        self.reports[exercise.name] = report

    def _is_done(self, exercise: Exercise) -> bool:
        """Return whether every task of an exercise is right."""
        return all(map(self.progress.is_right, exercise.tasks))


def _first_open(report: Report) -> Verdict | None:
    """Return the first task that is not right."""
    return next((verdict for verdict in report.verdicts if not verdict.is_full), None)


def listen(lines: queue.Queue[str], source: Callable[[], str]) -> None:
    """Put each line of a source into a queue; at its end watching goes on without more."""
    while line := source():
        lines.put(line)
