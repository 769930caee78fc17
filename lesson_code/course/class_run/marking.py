"""What a worker of the class run does: one file, graded across the wall, as plain values.

A worker keeps one warm grader for all its files. Whatever a file does, what comes back is its
marks, or in a line why there are none.
"""

from __future__ import annotations

import functools
import hashlib
import re
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.alike import passages_of
from lesson_code.course.class_run.answers import answer_in
from lesson_code.course.class_run.journal import Marks
from lesson_code.course.class_run.names import encodable
from lesson_code.course.grading.check_task import LARGEST_SEED
from lesson_code.course.grading.exercises import exercise_of
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.submission import SubmissionError, read_submission
from lesson_code.parallel import keep_a_core, workers_here

ADDRESS = re.compile(r"\b0x[0-9a-fA-F]{6,}\b")
"""Where an object stood in memory: another place each time, and nothing to learn from."""


@dataclass(frozen=True)
class Terms:
    """What is the same for every file of a run.

    `exercises` are the only ones that count, all if there are none. `grader` says which version
    of the grader the run was begun with.
    """

    seed: int
    exercises: tuple[str, ...]
    isolation: str | None
    grader: str


@dataclass(frozen=True)
class Job:
    """A file to grade: where it stands, or what stands in it where a worker cannot read it.

    `variant` tells a student from all others, where each has inputs of his or her own. `seconds` is
    the file's part of the student's time, if it is less than that of a submission.
    """

    name: str
    path: Path
    content: bytes | None = None
    variant: str = ""
    seconds: int | None = None


def mark(job: Job, terms: Terms) -> Marks:
    """Return what a file has earned.

    Raises
    ------
    IsolationError
        There is less isolation to be had than the run asks for.
    RuntimeError
        This worker's grader is not the one that the run was begun with.
    """
    if grader_version() != terms.grader:
        raise RuntimeError("this worker has another version of the workbook")
    grader = warm_grader(terms.isolation)  # where there is too little isolation, this raises
    terms = replace(terms, seed=seed_of(job.variant, terms.seed))
    if job.content is None:
        return _mark(job.path, job, terms, grader)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / job.path.name
        path.write_bytes(job.content)
        return _mark(path, job, terms, grader)


def seed_of(variant: str, seed: int) -> int:
    """Return what a student's inputs are drawn with: the run's seed where all have the same.

    >>> seed_of("", 7), seed_of("ada", 7) == seed_of("bob", 7)
    (7, False)
    """
    if not variant:
        return seed
    digest = hashlib.sha256(f"{seed} {variant}".encode("utf-8", "surrogatepass")).digest()
    return int.from_bytes(digest[:8], "big") % LARGEST_SEED


@functools.cache
def warm_grader(isolation: str | None) -> Grader:
    """Return this process's grader; it ends with the process."""
    keep_a_core(workers_here())
    return Grader(isolation=isolation, hide_inputs=True).__enter__()


def _mark(path: Path, job: Job, terms: Terms, grader: Grader) -> Marks:
    """Return what the file at a path has earned; it is called by its name in the class's folder."""
    try:
        exercise, is_assumed = (
            _exercise(path, terms.exercises) if terms.exercises else (None, False)
        )
        report = grader.grade(path, exercise=exercise, seed=terms.seed, seconds=job.seconds)
    except SubmissionError as error:
        return {"problem": _told(str(error), path)}
    except ValueError as error:  # nothing in it tells which exercise it is
        broken = read_submission(path).unreadable
        problem = "; ".join(broken) or _told(str(error), path)
        return {"problem": problem, "is_other": not broken}
    except OSError as error:
        return {"problem": f"cannot be read ({error.strerror})"}
    marks = report.as_dict() | {"submission": job.name, "is_assumed": is_assumed}
    marks["was_cut_off"] = report.was_cut_off
    for entry, verdict in zip(marks["tasks"], report.verdicts, strict=True):
        entry["diagnoses"] = [
            {"name": found.name, "says": found.misconception, "hint": found.hint}
            for found in verdict.diagnoses
        ]
    sources = [unit.source for unit in report.submission.units]
    marks["answers"] = {
        verdict.task.id: answer_in(sources, verdict.task.function)
        for verdict in report.verdicts
        if not verdict.is_full
    }
    marks["passages"] = passages_of(report.submission)
    return {key: _fit_to_show(value) for key, value in marks.items()}


def _exercise(path: Path, only: tuple[str, ...]) -> tuple[str, bool]:
    """Return which exercise a file answers, and whether that is assumed: only one counts."""
    submission = read_submission(path)
    try:
        found = exercise_of(submission).name
    except ValueError:
        if len(only) == 1:
            return only[0], True
        raise
    if found not in only:
        raise SubmissionError(f"answers {found}, which is not graded here")
    return found, False


def _told(message: str, path: Path) -> str:
    """Return a message without the path: the report says whose file it is."""
    return message.removeprefix(f"{path}: ").replace(str(path), path.name)


def _fit_to_show(value: Any) -> Any:
    """Return a plain value whose texts name no places in memory and can be written in UTF-8."""
    if isinstance(value, str):
        return encodable(ADDRESS.sub("0x...", value) if "0x" in value else value)
    if isinstance(value, list):
        return [_fit_to_show(item) for item in value]
    if isinstance(value, dict):
        return {key: _fit_to_show(item) for key, item in value.items()}
    return value


@functools.cache
def grader_version() -> str:
    """Return what tells this grader from any other version of it: a digest of its source.

    >>> grader_version() == grader_version()
    True
    """
    package = Path(__file__).parents[2]
    digest = hashlib.sha256()
    for path in sorted(package.rglob("*.py")):
        digest.update(path.relative_to(package).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()[:16]
