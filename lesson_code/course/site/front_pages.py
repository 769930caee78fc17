"""The pages that are no notebook: the front page with the contents, and the exercises."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.site.notebook_page import download

TITLE = "Collision workbook"

FRONT = """# {title}

{promise}

{lab}

{level}

In these pages you throw bodies at each other, read everything, drag what the figures show, take the
quizzes, and write [exercises](exercises.md) that are checked as you go. To run and change the code,
get the workbook's folder and follow its README: the pages are its notebooks.

## Chapters

Below each stands how long it takes to read, and what you will be able to do afterwards.

{contents}

## For instructors

`workbook release` hands out the course without its solutions, `workbook grade` marks a submission
or a whole class behind a wall, with a reason for every lost point and a hint where a mistake is
known: [grading and isolation](pages/instructors.md).

```{{toctree}}
:hidden:

{documents}
exercises
{lab_page}
```

```{{toctree}}
:hidden:
:caption: Handbook

{pages}
```

```{{toctree}}
:hidden:
:caption: Reference

{reference}
```
"""

PAGES = (
    "students",
    "programs",
    "instructors",
    "python",
    "conventions",
    "glossary",
    "house",
    "lesson",
)
"""The handbook, in its order: files in the folder ``pages``."""

LAB_PAGE = """# Collision lab

{lab}

What moves the bodies is the course's own engine, compiled for the browser from the Python that the
chapters show. **Link to this set-up** opens the same bodies for somebody else.
"""

EXERCISE_PAGE = """# Exercises

Every task is a function with an empty body. Its check calls it with new numbers every time, and
gives a hint where an answer is a known mistake. Exercises with a link **in the page** are written
and checked right here: Python is loaded when you press **Check**. The others, and all of them with
NumPy, are files: put one into the folder `exercises` of the workbook, and open it there.
`workbook grade FILE` marks a whole exercise, wherever it was written.

All files together: <a href="exercises.zip" download>exercises.zip</a>.

{table}

```{{toctree}}
:hidden:

{pages}
```
"""

PROMISE = re.compile(r"^# .*\n\n((?:[^\n#!].*\n)+)")
"""The first paragraph of the README."""

LEVEL = re.compile(r"^\*\*Level:\*\*.*(?:\n.+)*", re.MULTILINE)
"""Its lines on level and hours."""

ABLE = re.compile(r"\*\*After this notebook you will be able to\*\*\s+(.*?)\n\n\S", re.DOTALL)
"""The list of what a notebook teaches, in its first cell."""

TIME = re.compile(r"\*\*Time:\*\*\s+about\s+(\d+)\s+minutes")
"""How long it takes to read, there."""


def front_page(
    notebooks: Sequence[tuple[str, Any]],
    reference: Sequence[str] = (),
    lab: str = "",
    readme: str = "",
) -> str:
    """Return the front page: what this is, and each chapter with what it teaches.

    Parameters
    ----------
    notebooks : sequence of (str, notebook)
        The name of each chapter's file without its suffix, and the notebook.
    reference : sequence of str
        The names of the pages about the public names.
    lab : str
        The collision lab as HTML; without it the page has none.
    readme : str
        The workbook's README, whose promise, level and hours the page repeats.
    """
    contents = "\n\n".join(_entry(name, notebook) for name, notebook in notebooks)
    documents = "\n".join(f"notebooks/{name}" for name, _ in notebooks)
    promise, level = PROMISE.search(readme), LEVEL.search(readme)
    return FRONT.format(
        title=TITLE,
        promise=promise[1] if promise else "",
        level=level[0] if level else "",
        contents=contents,
        documents=documents,
        pages="\n".join(f"pages/{name}" for name in PAGES),
        reference="\n".join(reference),
        lab=as_html(lab) if lab else "",
        lab_page="lab" if lab else "",
    )


def lab_page(lab: str) -> str:
    """Return the page of the collision lab alone, to which its set-ups link."""
    return LAB_PAGE.format(lab=as_html(lab))


def as_html(text: str) -> str:
    """Return HTML as Sphinx is to take it: as it stands."""
    return f"``````{{raw}} html\n{text}\n``````"


def exercise_list(root: Path, pages: Collection[Exercise]) -> str:
    """Return the page that lists the exercises: a file each, and a page for some."""
    rows = "\n".join(_row(exercise, root, has_page=exercise in pages) for exercise in exercises())
    head = "| exercise | tasks | points | here | file |\n|---|---|---|---|---|"
    documents = "\n".join(f"exercises/{exercise.name}" for exercise in pages)
    return EXERCISE_PAGE.format(table=f"{head}\n{rows}", pages=documents)


def _entry(name: str, notebook: Any) -> str:
    """Return a notebook's title, as a link, its time, and what its reader will be able to do."""
    opening = notebook.cells[0].source
    title = opening.splitlines()[0].removeprefix("# ")
    able, time = ABLE.search(opening), TIME.search(opening)
    parts = [f"### [{title}](notebooks/{name}.ipynb)"]
    parts += [f"About {time[1]} minutes."] if time else []
    return "\n\n".join([*parts, able[1] if able else ""]).rstrip()


def _row(exercise: Exercise, root: Path, *, has_page: bool) -> str:
    """Return an exercise's line of the table."""
    file = exercise.student_copy(root).name
    link = download(file, f"exercises/{file}")
    page = f"[in the page](exercises/{exercise.name}.md)" if has_page else ""
    chapter = exercise.name[:2] if exercise.name[:2].isdigit() else ""
    title = f"{chapter} {exercise.title}".strip()
    return f"| {title} | {len(exercise.tasks)} | {exercise.points} | {page} | {link} |"
