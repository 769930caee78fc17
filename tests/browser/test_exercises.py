"""Exercises in their pages: the marks and words of `workbook grade`, in Chromium, with Pyodide.

The pages are opened from their folder. What they ask of the public network is answered with the
files of the npm package; where that cannot be had, what needs it is skipped.
"""

from __future__ import annotations

import ast
import inspect
import math
import shutil
import subprocess
import tarfile
import textwrap
from collections.abc import Iterator
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from lesson_code.course.grading.exercises import Exercise, exercise_by_name, exercises
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.report import Report
from lesson_code.course.grading.task import KnownAnswer
from lesson_code.course.site.pyodide import FILES, PUBLIC, VERSION, sum_of

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page, Route

ROOT = Path(__file__).parents[2]
ANSWERED = [f"{number:02}" for number in range(1, 12)]
"""The exercises that can be answered in a page."""

PLAIN = {*dir(math), *dir(list), *dir(set), *dir(dict)}
"""What the code of an answer may ask of an object by name; NumPy's arrays have more."""

PYTHON_STARTS = 90_000
"""ms: Python is there after 2 to 7 s, on a machine that is busy later."""

STOPS = 40_000
"""ms: an endless loop is stopped after 10 s."""

SOON = 10_000

SEED = 9
"""Of the grader, so that every run finds the same: a page's draws are fixed, and what a mistake
earns may hang on luck once in hundreds of seeds."""


@pytest.fixture(scope="session")
def pyodide(request: pytest.FixtureRequest) -> Path:
    """Return the npm package that the pages load, kept from run to run."""
    config: Any = request.config
    folder = Path(config.cache.mkdir("pyodide")) / VERSION
    if not all((folder / name).is_file() for name in FILES):
        npm = shutil.which("npm")
        if npm is None:
            pytest.skip("needs npm, which brings Pyodide")
        folder.mkdir(exist_ok=True)
        command = [npm, "pack", f"pyodide@{VERSION}", "--pack-destination", str(folder)]
        if subprocess.run(command, capture_output=True, check=False).returncode:
            pytest.skip(f"npm cannot bring Pyodide {VERSION}")
        with tarfile.open(next(folder.glob("*.tgz"))) as archive:
            for name in FILES:
                packed = archive.extractfile(f"package/{name}")
                assert packed is not None
                (folder / name).write_bytes(packed.read())
    return folder


@pytest.fixture
def asked(page: Page, pyodide: Path) -> list[str]:
    """Answer what the page asks of the public network with Pyodide's files; return what it was."""
    names: list[str] = []

    def answer(route: Route) -> None:
        name = route.request.url.removeprefix(PUBLIC)
        names.append(name)
        route.fulfill(path=pyodide / name, headers={"Access-Control-Allow-Origin": "*"})

    page.context.route(f"{PUBLIC}**", answer)
    return names


@pytest.fixture(scope="module")
def grader() -> Iterator[Grader]:
    """Yield a grader."""
    with Grader() as started:
        yield started


def open_exercise(page: Page, site: Path, number: str) -> Exercise:
    """Open an exercise's page."""
    exercise = exercise_by_name(number)
    page.goto((site / "exercises" / f"{exercise.name}.html").as_uri())
    return exercise


def form_of(page: Page, task: str) -> Locator:
    """Return what belongs to a task."""
    return page.locator(f'form[data-task="{task}"]')


def marks_for(page: Page, task: str, source: str) -> list[str]:
    """Write an answer, press the button, and return what is said to it."""
    form = form_of(page, task)
    form.locator("textarea").fill(source)
    form.get_by_role("button", name="Check").click()
    form.locator("[type=submit]:enabled").wait_for(timeout=PYTHON_STARTS)
    lines: list[str] = form.locator(".marks p").all_inner_texts()
    return lines


def saved(page: Page, kind: str, folder: Path) -> Path:
    """Return the file that the page saves."""
    with page.expect_download(timeout=SOON) as coming:
        page.get_by_role("button", name=kind).click()
    path = folder / coming.value.suggested_filename
    coming.value.save_as(path)
    return path


def plain_source(answer: KnownAnswer, function: str) -> str | None:
    """Return a known answer as a student would write it; None if it needs more than `math`."""
    given = answer.function
    definition = ast.parse(textwrap.dedent(inspect.getsource(given))).body[0]
    assert isinstance(definition, ast.FunctionDef)
    parts = [part for statement in definition.body for part in ast.walk(statement)]
    names = {part.id for part in parts if isinstance(part, ast.Name)} & set(given.__globals__)
    imports = {name.name for p in parts if isinstance(p, ast.Import) for name in p.names}
    asked = {part.attr for part in parts if isinstance(part, ast.Attribute)}
    columns = [p for p in parts if isinstance(p, ast.Subscript) and isinstance(p.slice, ast.Tuple)]
    if not names | imports <= {"math"} or not asked <= PLAIN or columns:
        return None
    definition.name, definition.decorator_list, definition.returns = function, [], None
    for argument in definition.args.args:
        argument.annotation = None
    return f"import math\n\n\n{ast.unparse(definition)}\n"


def hints_of(report: Report) -> dict[str, tuple[int, list[str]]]:
    """Return points and hints of each task of a report."""
    return {
        verdict.task.id: (
            verdict.points,
            [line.strip() for line in verdict.lines if line.startswith("  hint: ")],
        )
        for verdict in report.verdicts
    }


def said(lines: list[str]) -> tuple[int, list[str]]:
    """Return points and hints of what a page says."""
    points = lines[0].split(": ")[1].split("/")[0]
    return int(points), [line for line in lines if line.startswith("hint: ")]


@pytest.mark.parametrize("number", ANSWERED)
def test_known_answers_get_marks_and_hints_of_the_grader(
    site: Path, page: Page, asked: list[str], grader: Grader, tmp_path: Path, number: str
) -> None:
    """Each wrong model that needs no NumPy, one a task at a time; the page's file is graded.

    Then each unusual right answer that needs none, for full marks.
    """
    exercise = open_exercise(page, site, number)
    columns = [
        [(t.id, s) for m in t.wrong_models if (s := plain_source(m, t.function))]
        for t in exercise.tasks
    ]
    tried = 0
    for place, chosen in enumerate(zip_longest(*columns)):
        given = [each for each in chosen if each]
        page_says = {task: said(marks_for(page, task, source)) for task, source in given}
        path = saved(page, ("notebook", "Python file")[place % 2], tmp_path)
        grader_says = hints_of(grader.grade(path, seed=SEED))
        assert page_says == {task: grader_says[task] for task, _ in given}
        tried += len(given)
    assert tried
    assert set(asked) == set(FILES)
    for task in exercise.tasks:
        for answer in task.alternatives:
            if source := plain_source(answer, task.function):
                full = f"{task.title}: {task.points}/{task.points} points"
                assert marks_for(page, task.id, source) == [full]


def test_right_answers_get_full_marks_in_page_and_file(
    site: Path, page: Page, asked: list[str], grader: Grader, tmp_path: Path
) -> None:
    """Chapter 01 as a first reader writes it, marked as a whole in the page and by the grader."""
    exercise = open_exercise(page, site, "01")
    answers = {
        "1.1": "def elastic_1d(m1, v1, m2, v2):\n    c = (m1 * v1 + m2 * v2) / (m1 + m2)\n"
        "    return 2 * c - v1, 2 * c - v2\n",
        "1.2": "def inelastic_1d(m1, v1, m2, v2):\n"
        "    v = (m1 * v1 + m2 * v2) / (m1 + m2)\n    return [v, v]\n",
        "1.3": "def elastic_impulse_1d(m1, v1, m2, v2):\n"
        "    return m2 * (elastic_1d(m1, v1, m2, v2)[1] - v2)\n",
    }
    for task, source in answers.items():
        assert len(marks_for(page, task, source)) == 1
    assert page.locator(".take .sum").text_content() == "10 of 10 points"
    for kind in ("notebook", "Python file"):
        assert grader.grade(saved(page, kind, tmp_path)).points == exercise.points
    assert len(asked) == len(FILES)  # loaded once


def test_vectors_are_added_and_multiplied_as_the_task_says(
    site: Path, page: Page, asked: list[str]
) -> None:
    """A formula with vectors is right in the page; NumPy is missed in words, where it is used."""
    open_exercise(page, site, "03")
    formula = "    return incident - 2 * (incident @ normal) * normal\n"
    [line] = marks_for(page, "3.1", f"def reflect(incident, normal):\n{formula}")
    assert line == "3.1 reflect: 4/4 points"
    with_numpy = formula.replace("(incident @ normal)", "np.dot(incident, normal)")
    lines = marks_for(page, "3.1", f"def reflect(incident, normal):\n{with_numpy}")
    assert any("NumPy is not in this page" in line for line in lines)


def test_rows_of_vectors_are_projected_and_searched(
    site: Path, page: Page, asked: list[str]
) -> None:
    """The corners of a polygon, and the circles of a crowd, without NumPy."""
    open_exercise(page, site, "06")
    shadow = "def project(vertices, axis):\n    s = vertices @ axis\n    return min(s), max(s)\n"
    assert marks_for(page, "6.2", shadow) == ["6.2 project: 2/2 points"]
    still = "def mtv(a, b):\n    return (1, 0), 0.001\n"
    assert any("the shadows still overlap" in line for line in marks_for(page, "6.4", still))
    open_exercise(page, site, "07")
    late = "def next_event(positions, velocities, radii):\n    return 0.123, 0, 1\n"
    assert any("Left alone, these meet: " in line for line in marks_for(page, "7.4", late))


def test_endless_loop_is_stopped_and_the_next_answer_is_checked(
    site: Path, page: Page, asked: list[str]
) -> None:
    """By itself after 10 s, or by its button; the page stays alive meanwhile."""
    open_exercise(page, site, "01")
    form = form_of(page, "1.1")
    endless = "def elastic_1d(m1, v1, m2, v2):\n    while True:\n        pass\n"
    assert marks_for(page, "1.1", "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n")
    form.locator("textarea").fill(endless)
    form.get_by_role("button", name="Check").click()
    form.get_by_text("Does a loop in it never end?").wait_for(timeout=STOPS)
    form.get_by_role("button", name="Check").click()
    form.get_by_role("button", name="Stop").click()
    form.get_by_text("Stopped.").wait_for(timeout=SOON)
    lines = marks_for(page, "1.1", "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n")
    assert said(lines)[0] == 1


def test_what_is_printed_and_what_fails_is_shown(site: Path, page: Page, asked: list[str]) -> None:
    """As in a notebook: prints, the value of the last line, and an error with its own lines."""
    open_exercise(page, site, "01")
    box = form_of(page, "1.1").locator(".printed")
    marks_for(page, "1.1", "print('one')\n6 * 7\n")
    assert box.text_content() == "one\n42\n"
    lines = marks_for(page, "1.1", "def elastic_1d(m1, v1, m2, v2):\n    return v2 v1\n")
    assert "SyntaxError" in (box.text_content() or "")
    assert lines == ["1.1 elastic_1d: there is no function named elastic_1d"]


def test_work_survives_a_reload_and_can_be_started_over(site: Path, page: Page) -> None:
    """Answers are kept in the browser, an exercise's apart from another's."""
    open_exercise(page, site, "01")
    area = form_of(page, "1.1").locator("textarea")
    given = area.input_value()
    area.fill("mine")
    page.reload()
    assert area.input_value() == "mine"
    assert form_of(page, "1.2").locator("textarea").input_value() != "mine"
    form_of(page, "1.1").get_by_role("button", name="over").click()
    page.reload()
    assert area.input_value() == given


def test_editor_indents_and_is_left_by_keyboard(site: Path, page: Page) -> None:
    """Enter keeps the indentation, a colon deepens it, Tab indents, Escape and Tab lead on."""
    open_exercise(page, site, "01")
    area = form_of(page, "1.1").locator("textarea")
    area.fill("")
    area.focus()
    for key in ("i", "f", " ", "x", ":", "Enter", "y", "Enter", "Tab", "z"):
        page.keyboard.press("Space" if key == " " else key)
    assert area.input_value() == "if x:\n    y\n        z"
    page.keyboard.press("Escape")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.textContent") == "Check"


def test_nothing_is_loaded_before_an_answer_is_checked(
    site: Path, page: Page, faults: list[str]
) -> None:
    """The page asks the network for nothing."""
    open_exercise(page, site, "01")
    form_of(page, "1.1").locator("textarea").fill("mine")
    assert faults == []


def test_file_that_is_not_pyodides_is_refused(site: Path, page: Page, pyodide: Path) -> None:
    """A changed file does not run; the page says that Python could not be loaded."""
    changed = (pyodide / "pyodide.mjs").read_bytes() + b"\n"
    free = {"Access-Control-Allow-Origin": "*"}

    def answer(route: Route) -> None:
        name = route.request.url.removeprefix(PUBLIC)
        body = changed if name == "pyodide.mjs" else (pyodide / name).read_bytes()
        route.fulfill(body=body, headers=free)

    page.context.route(f"{PUBLIC}**", answer)
    open_exercise(page, site, "01")
    [line] = marks_for(page, "1.1", "def elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n")
    assert line.startswith("Python could not be loaded: ")


def test_sums_are_those_of_the_package(pyodide: Path) -> None:
    """What npm brings under this version has the sums that pages ask for."""
    assert {name: sum_of(pyodide / name) for name in FILES} == FILES
    assert math.isclose(sum((pyodide / name).stat().st_size for name in FILES) / 1e6, 13, abs_tol=1)


def test_every_exercise_without_numpy_has_a_page(site: Path) -> None:
    """No more and no fewer, and the others are files."""
    pages = {path.stem for path in (site / "exercises").glob("*.html")}
    names = {exercise.name for exercise in exercises() if exercise.name[:2] in ANSWERED}
    assert pages == names
