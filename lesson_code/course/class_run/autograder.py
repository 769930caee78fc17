"""One submission, graded where Gradescope runs an autograder: in a container, at /autograder.

submission (and its metadata) -> collect, mark, gradebook -> results/results.json

The instructor's files are in `source`, where no student's code can read them: it runs as another
user, behind the best wall that the container allows, and `output` says which that is. Every
submission has inputs of its own, drawn from its number, so that a regrade draws the same again.
"""

from __future__ import annotations

import json
import os
import sys
import time
import traceback
from contextlib import suppress
from pathlib import Path
from typing import Any

from lesson_code.course.class_run.collect import collect
from lesson_code.course.class_run.exports import write_json
from lesson_code.course.class_run.gradebook import gradebook
from lesson_code.course.class_run.imports import gradescope
from lesson_code.course.class_run.journal import key_of
from lesson_code.course.class_run.marking import (
    Job,
    Terms,
    grader_version,
    mark,
    seed_of,
    warm_grader,
)
from lesson_code.course.isolation import Limits

SETTINGS = "settings.json"
"""In `source`: which exercises count, the seed, and the least isolation that will do."""


def autograde(place: Path) -> dict[str, Any]:
    """Return what Gradescope is to be told of the submission in a container.

    Parameters
    ----------
    place : Path
        Holds `source`, `submission` and `submission_metadata.json`.

    Raises
    ------
    IsolationError
        There is less isolation to be had than the settings ask for; nothing has run.
    """
    began = time.monotonic()
    settings = json.loads((place / "source" / SETTINGS).read_text(encoding="utf-8"))
    isolation = warm_grader(settings["isolation"]).isolation
    seed = seed_of(_number(place), settings["seed"])
    terms = Terms(seed, tuple(settings["exercises"]), settings["isolation"], grader_version())
    others = {os.path.realpath(entry) for entry in place.iterdir() if entry.name != "submission"}
    [hand_in], _ = collect(place, without=others)
    seconds = Limits().seconds_a_file(len(hand_in.papers))
    jobs = {key_of(paper): Job(paper.name, paper.path, seconds=seconds) for paper in hand_in.papers}
    marks = {key: mark(job, terms) for key, job in jobs.items()}
    book = gradebook([hand_in], marks, exercises=terms.exercises, seed=seed)
    results = gradescope(book.students[0], book)
    lines = [results["output"], f"seed {seed}, isolation: {isolation}"]
    return results | {
        "output": "\n".join(filter(None, lines)),
        "execution_time": round(time.monotonic() - began, 1),
    }


def _number(place: Path) -> str:
    """Return the number that Gradescope has given to the submission; "" if it says none."""
    with suppress(OSError, ValueError):
        told = json.loads((place / "submission_metadata.json").read_text(encoding="utf-8"))
        return str(told["id"]) if "id" in told else ""
    return ""


def _failed(error: Exception) -> dict[str, Any]:
    """Return what to tell where nothing could be graded: no points, and that it is not the end."""
    return {
        "score": 0,
        "output": f"The grader failed ({type(error).__name__}), and these are no marks. "
        "Please tell your instructor.",
        "output_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
    }


def main() -> None:
    """Write results.json, whatever happens; what an instructor sees has the error."""
    place = Path(sys.argv[1]).resolve()
    try:
        results = autograde(place)
    except Exception as error:  # a submission without results would look like one that hangs
        traceback.print_exc()
        results = _failed(error)
    (place / "results").mkdir(exist_ok=True)
    write_json(place / "results" / "results.json", results)


if __name__ == "__main__":
    main()
