"""The class run: everything that was handed in, graded side by side, and written down at once."""

from __future__ import annotations

import os
import secrets
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import Future
from contextlib import closing, suppress
from dataclasses import dataclass, replace
from datetime import datetime
from functools import partial
from pathlib import Path

from lesson_code.course.class_run.changes import read_changes
from lesson_code.course.class_run.collect import HandIn, Paper, collect
from lesson_code.course.class_run.exports import write_exports
from lesson_code.course.class_run.gradebook import Gradebook, gradebook
from lesson_code.course.class_run.imports import write_imports
from lesson_code.course.class_run.journal import JOURNAL, Journal, Marks, is_journal, key_of
from lesson_code.course.class_run.marking import Job, Terms, grader_version, mark
from lesson_code.course.class_run.names import shown
from lesson_code.course.class_run.pages import write_pages
from lesson_code.course.class_run.roster import read_roster
from lesson_code.course.grading.check_task import LARGEST_SEED
from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.submission import LARGEST_FILE
from lesson_code.course.isolation import Limits
from lesson_code.parallel import iter_tasks

VERSION = 1
"""Version of the journal's form."""

WRITTEN = (
    *("class.html", "feedback", "grades.csv", "grades.json"),
    *("canvas.csv", "moodle.csv", "gradescope.zip"),
)
"""What a run writes beside its journal, and over what an earlier run wrote."""


@dataclass(frozen=True)
class Hands:
    """Who does the work: processes of this machine, or the workers of a dask cluster."""

    workers: int | None = None
    cluster: str | None = None


def grade_class(
    folder: Path,
    out: Path,
    *,
    roster: Path | None = None,
    exercises: Sequence[str] = (),
    seed: int | None = None,
    due: datetime | None = None,
    isolation: str | None = None,
    hands: Hands | None = None,
    fresh: bool = False,
    variant: bool = False,
    told: Callable[[str], None] = lambda _: None,
) -> Gradebook:
    """Grade a class, and write marks, feedback and an overview into a folder.

    The marks of each file are written down as they come. Called again after an interruption, it
    goes on where it stopped, with the same seed, and writes the same bytes as without one.

    Parameters
    ----------
    folder : Path
        Holds one folder or file a student.
    out : Path
        Is made if it is not there.
    roster : Path, optional
        A sheet with the students of the class.
    exercises : sequence of str
        Names or numbers of the exercises that count; by default those that
        :func:`.gradebook.common_exercises` finds.
    seed : int, optional
        Draws the inputs, the same ones for everybody. By default that of the journal, or one drawn
        now.
    due : datetime, optional
        Files that are newer are late.
    isolation : str, optional
        The least that is accepted: "full", "limits" or "none".
    hands : Hands, optional
        Who does the work; by default one process for each core.
    fresh : bool
        Forget an earlier run.
    variant : bool
        Draw inputs for each student, from the seed and the id; a team's are those of its first.
    told : callable
        Receives progress messages, one line each.

    Raises
    ------
    ValueError
        The folder, the roster, the changes, an exercise or the journal cannot be used, or a file
        that no run has written would be lost; nothing has been graded.
    OSError
        The results cannot be written, or no cluster answers.
    """
    names = tuple(exercise_by_name(name).name for name in exercises)
    _refuse_to_lose(out)
    enrolled = None if roster is None else read_roster(roster)
    own = {os.path.realpath(path) for path in (out, roster) if path}
    hand_ins, left_out = collect(folder, enrolled.students if enrolled else None, without=own)
    if hands is None or hands.cluster is None:
        with Grader(isolation=isolation) as grader:  # refuses before anything is read or written
            told(f"isolation: {grader.isolation}")
    out.mkdir(parents=True, exist_ok=True)
    changes = read_changes(out, hand_ins)
    if fresh:
        (out / JOURNAL).unlink(missing_ok=True)
    head = {
        "version": VERSION,
        "seed": seed,
        "exercises": list(names),
        "isolation": isolation,
        "variant": variant,
        "grader": grader_version(),
    }
    with Journal(out / JOURNAL, head, drawn={"seed": secrets.randbelow(LARGEST_SEED)}) as journal:
        terms = Terms(journal.head["seed"], names, isolation, journal.head["grader"])
        marks = _graded(hand_ins, journal, terms, hands or Hands(), variant, told)
    book = gradebook(
        hand_ins,
        marks,
        exercises=names,
        seed=terms.seed,
        due=due,
        left_out=left_out,
        changes=changes,
        roster=enrolled,
        is_variant=variant,
    )
    write_exports(book, out)
    write_imports(book, out)
    write_pages(book, out)
    return book


def _refuse_to_lose(out: Path) -> None:
    """Raise if a run would write over a file that no earlier run has written."""
    taken = [out / name for name in (JOURNAL, *WRITTEN) if os.path.lexists(out / name)]
    if taken and not is_journal(out / JOURNAL):
        raise ValueError(
            f"{taken[0]}: is there already, and no earlier run wrote it; "
            "--out names another folder for the marks"
        )


def _graded(
    hand_ins: Sequence[HandIn],
    journal: Journal,
    terms: Terms,
    hands: Hands,
    is_variant: bool,
    told: Callable[[str], None],
) -> dict[str, Marks]:
    """Return the marks of every file, those that the journal lacks worked out now.

    Whatever wanted more time than it may use is tried once more, alone: a busy machine takes
    nobody's points.
    """
    jobs: dict[str, tuple[Paper, Job]] = {}
    for hand_in in hand_ins:
        variant = hand_in.student.id if is_variant else ""
        seconds = Limits().seconds_a_file(len(hand_in.papers))
        for paper in hand_in.papers:
            jobs.setdefault(key_of(paper), (paper, _job(paper, hands, variant, seconds)))
    waiting = [jobs[key] for key in jobs if key not in journal.done]
    if len(waiting) < len(jobs):
        told(f"{len(jobs) - len(waiting)} of {len(jobs)} files are graded already")
    failed: dict[str, Marks] = {}
    cut_off: list[tuple[Paper, Job]] = []

    def keep(each: tuple[Paper, Job], future: Future[Marks], *, is_alone: bool) -> None:
        if error := future.exception():
            failed[key_of(each[0])] = {"problem": _lost(error)}
            return
        marks = dict(future.result())
        if marks.pop("was_cut_off", False) and not is_alone:
            cut_off.append(each)
        else:
            journal.write(each[0], marks)

    with closing(_at_work(waiting, terms, hands, "grading")) as done:
        for number, future in done:
            keep(waiting[number], future, is_alone=False)
    if cut_off:
        told(f"{len(cut_off)} files wanted more time than they may use: tried again, each alone")
    for each in cut_off:
        with closing(_at_work([each], terms, Hands(1, hands.cluster), None)) as done:
            for _, future in done:
                keep(each, future, is_alone=True)
    return {**journal.done, **failed}


def _at_work(
    work: Sequence[tuple[Paper, Job]], terms: Terms, hands: Hands, label: str | None
) -> Generator[tuple[int, Future[Marks]], None, None]:
    """Yield number and future of each file; closing it, as an interruption does, stops all."""
    return iter_tasks(
        partial(mark, terms=terms),
        [job for _, job in work],
        workers=hands.workers,
        cluster=hands.cluster,
        names=[shown(paper.name) for paper, _ in work],
        progress=label if work else None,
    )


def _job(paper: Paper, hands: Hands, variant: str, seconds: int) -> Job:
    """Return a file as a task; workers on other machines are sent what stands in it."""
    job = Job(paper.name, paper.path, variant=variant, seconds=seconds)
    with suppress(OSError):  # whoever grades it finds out, too, and says so
        is_file = paper.path.is_file() and not paper.path.is_symlink()
        if hands.cluster and is_file and paper.path.stat().st_size <= LARGEST_FILE:
            return replace(job, content=paper.path.read_bytes())
    return job


def _lost(error: BaseException) -> str:
    """Return in a line why a file has no marks; it is tried again when the run is repeated."""
    return (
        f"the grader failed ({type(error).__name__}: {error}); "
        "run the same command again to grade it"
    )
