"""The front page and the page of exercises."""

from __future__ import annotations

import re
from pathlib import Path

import nbformat
from nbformat.v4 import new_markdown_cell, new_notebook

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.site.front_pages import exercise_list, front_page, lab_page

ROOT = Path(__file__).parents[3]


def test_front_page_says_what_each_chapter_teaches() -> None:
    """Title, link, time, and the three goals of every notebook."""
    paths = sorted((ROOT / "notebooks").glob("*.ipynb"))
    page = front_page([(path.stem, nbformat.read(path, as_version=4)) for path in paths])
    for path in paths:
        entry = page.split(f"](notebooks/{path.name})")[1].split("###")[0]
        assert re.match(r"\n\nAbout \d+ minutes\.\n", entry), path.name
        assert all(f"\n{number}. " in entry for number in (1, 2, 3)), path.name
        assert f"\nnotebooks/{path.stem}\n" in page


def test_lab_stands_first_and_alone() -> None:
    """As it is given, on the front page under its promise and on a page of its own; or nowhere."""
    lab = "<div>`A` {lab}</div>"
    page = front_page([], lab=lab)
    assert page.index(lab) < page.index("In these pages")
    assert "\nlab\n" in page
    assert lab in lab_page(lab)
    assert "\nlab\n" not in front_page([])


def test_front_page_opens_with_the_promise_of_the_readme_and_its_hours() -> None:
    """The README's first paragraph stands above the lab, level and hours below it."""
    page = front_page([], lab="<div>lab</div>", readme=(ROOT / "README.md").read_text("utf-8"))
    places = [
        page.index(part)
        for part in (
            "You write the formulas",
            "<div>lab</div>",
            "**Level:**",
            "**Time:** fifteen notebooks",
            "## Chapters",
            "## For instructors",
        )
    ]
    assert places == sorted(places)
    assert "Two commands" not in page


def test_chapter_without_goals_stands_by_its_title() -> None:
    """A notebook that does not say what it teaches is listed all the same."""
    page = front_page([("10_new", new_notebook(cells=[new_markdown_cell("# 10 New\n\nText.")]))])
    assert "### [10 New](notebooks/10_new.ipynb)" in page


def test_exercises_are_listed_with_tasks_points_file_and_page() -> None:
    """Each exercise that the grader knows has a line; those with a page of their own lead there."""
    first, *others = exercises()
    page = exercise_list(ROOT, [first])
    for exercise in (first, *others):
        file = exercise.student_copy(ROOT).name
        line = next(line for line in page.splitlines() if file in line)
        assert f"| {len(exercise.tasks)} | {exercise.points} |" in line
        assert f'<a href="exercises/{file}" download>' in line
        assert ("[in the page]" in line) is (exercise == first)
    assert f"\nexercises/{first.name}\n" in page
