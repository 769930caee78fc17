"""The pages that are no notebook: the front page with the contents, and the exercises."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.site.notebook_page import download

TITLE = "Collision workbook"

FRONT = """# {title}

{lab}

Two-dimensional collision response, from two carts on a line to piles of polygons: how to find a
collision, how to compute what happens in it, and how to know that the answer is right. Every
formula is compared with a physics engine that is not ours, with closed forms and with the
conservation laws.

**In these pages** you can throw bodies at each other, read everything, play the animations, drag
what the figures show and take the quizzes. **To run and change the code**, get the workbook's
folder and follow its README: the pages are its notebooks.

## Chapters

After each of them you will be able to do what stands below it.

{contents}

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

Drag a body, or the tip of its velocity, or type numbers. What moves the bodies is the course's own
engine, compiled for the browser from the Python that the chapters show. **Link to this set-up**
opens the same bodies for somebody else.
"""

EXERCISE_PAGE = """# Exercises

Each exercise is a file to complete. Every task is a function with an empty body; the cell below it
checks your answer with new numbers every time, and gives a hint where an answer is a known mistake.
The checks need the workbook's package: put the file into the folder `exercises` of the workbook,
and open it there. `workbook grade FILE` marks a whole exercise.

All of them together: <a href="exercises.zip" download>exercises.zip</a>.

{table}
"""

ABLE = re.compile(r"\*\*After this notebook you will be able to\*\*\s+(.*?)\n\n\S", re.DOTALL)
"""The list of what a notebook teaches, in its first cell."""


def front_page(
    notebooks: Sequence[tuple[str, Any]], reference: Sequence[str] = (), lab: str = ""
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
    """
    contents = "\n\n".join(_entry(name, notebook) for name, notebook in notebooks)
    documents = "\n".join(f"notebooks/{name}" for name, _ in notebooks)
    return FRONT.format(
        title=TITLE,
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


def exercise_page(root: Path) -> str:
    """Return the page of the exercises, each a file to download."""
    rows = "\n".join(_row(exercise, root) for exercise in exercises())
    head = "| exercise | tasks | points | file |\n|---|---|---|---|"
    return EXERCISE_PAGE.format(table=f"{head}\n{rows}")


def _entry(name: str, notebook: Any) -> str:
    """Return a chapter's title, as a link, and what its reader will be able to do."""
    opening = notebook.cells[0].source
    title = opening.splitlines()[0].removeprefix("# ")
    able = ABLE.search(opening)
    goals = able[1] if able else ""
    return f"### [{title}](notebooks/{name}.ipynb)\n\n{goals}".rstrip()


def _row(exercise: Exercise, root: Path) -> str:
    """Return an exercise's line of the table."""
    file = exercise.student_copy(root).name
    link = download(file, f"exercises/{file}")
    chapter = exercise.name[:2] if exercise.name[:2].isdigit() else ""
    title = f"{chapter} {exercise.title}".strip()
    return f"| {title} | {len(exercise.tasks)} | {exercise.points} | {link} |"
