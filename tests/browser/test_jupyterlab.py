"""The notebooks in JupyterLab, as a student uses them: run, slide, answer, write."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from lesson_code.course.quiz.bank import load_quiz
from lesson_code.course.quiz.questions import ArrowQuestion, ChoiceQuestion

from .in_browser import (
    JupyterLab,
    LabNotebook,
    code_of,
    expect_all_alive,
    figures_in,
    predictions_in,
)

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Locator, Page

ROOT = Path(__file__).parents[2]
NOTEBOOKS = sorted((ROOT / "notebooks").glob("*.ipynb"))

SHORT = "02_restitution"
"""The notebook that the short run opens; -m browser opens all of them."""

CHAPTERS = [
    pytest.param(path.stem, marks=() if path.stem == SHORT else pytest.mark.browser, id=path.stem)
    for path in NOTEBOOKS
]
ANSWERED = 20_000
"""ms: a figure is drawn anew and an answer judged within a second, if the machine is idle."""

WITH_FIGURES = [
    pytest.param(path.stem, marks=() if path.stem == SHORT else pytest.mark.browser, id=path.stem)
    for path in NOTEBOOKS
    if figures_in(path)
]
"""The notebooks with live figures, all but one for the full run."""

ANSWER = """def elastic_1d(m1, v1, m2, v2):
    v_centre = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v_centre - v1, 2 * v_centre - v2"""


@pytest.fixture(scope="module", params=CHAPTERS)
def chapter(
    request: pytest.FixtureRequest, browser: Browser, lab: JupyterLab
) -> Iterator[LabNotebook]:
    """Yield each notebook, all of its cells run."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    opened = lab.open(page, f"notebooks/{request.param}.ipynb")
    opened.run_all()
    yield opened
    lab.end_kernels(page)
    page.close()


def output_with(page: Page, inside: str) -> Locator:
    """Return the first output that holds something."""
    return page.locator(f".jp-OutputArea-output:has({inside})").first


def test_notebook_runs_from_top_to_bottom(chapter: LabNotebook) -> None:
    """No cell of a notebook stops with an error."""
    assert chapter.errors.all_text_contents() == []


def test_live_figure_needs_no_kernel_once_it_is_saved(browser: Browser, lab: JupyterLab) -> None:
    """The notebook is run and saved, its kernel ended, and opened again: its figures answer."""
    lab.trust("notebooks/03_reflection.ipynb")
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    notebook = lab.open(page, "notebooks/03_reflection.ipynb")
    notebook.run_all()
    page.keyboard.press("Control+S")
    page.locator(".jp-Notebook[data-jp-dirty=true]").wait_for(state="detached", timeout=ANSWERED)
    lab.end_kernels(page)
    page.close()

    page = browser.new_page(viewport={"width": 1280, "height": 900})
    lab.open(page, "notebooks/03_reflection.ipynb")
    lab.end_kernels(page)
    expect_all_alive(page, figures_in(ROOT / "notebooks" / "03_reflection.ipynb"))
    page.close()


@pytest.mark.parametrize("name", WITH_FIGURES)
def test_every_figure_of_a_saved_notebook_is_alive(
    browser: Browser, lab: JupyterLab, name: str
) -> None:
    """It is opened as it is kept and trusted, and no cell of it is run."""
    lab.trust(f"notebooks/{name}.ipynb")
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    lab.show(page, f"notebooks/{name}.ipynb")
    expect_all_alive(page, figures_in(ROOT / "notebooks" / f"{name}.ipynb"))
    lab.end_kernels(page)
    page.close()


def test_quiz_gives_the_feedback_to_the_answer_that_was_clicked(
    request: pytest.FixtureRequest, chapter: LabNotebook
) -> None:
    """A wrong option is clicked, then the right one; each time its own feedback is read out.

    Of a chapter in parts the last one has the quiz.
    """
    name = request.node.callspec.params["chapter"]
    quiz = chapter.page.locator(".quiz:not(.predict)")
    if "show_quiz(" not in code_of(ROOT / "notebooks" / f"{name}.ipynb"):
        assert quiz.count() == 0
        return
    asked = load_quiz(name[:2]).questions
    question = next(q for q in asked if isinstance(q, ChoiceQuestion))
    form = quiz.locator("form").nth(asked.index(question))
    wrong = next(option for option in question.options if option != question.right_option)
    for option in (wrong, question.right_option):
        form.get_by_text(f") {option.text}", exact=False).click()
        form.get_by_role("button").click()
        form.get_by_text(option.feedback).wait_for(timeout=ANSWERED)
    quiz.get_by_text(f"1 of {len(asked)} right").wait_for(timeout=ANSWERED)


IN_SIGHT = """form => {
    const seen = [];
    for (let cell = form.closest(".jp-Cell").nextElementSibling;
         cell && !cell.querySelector(".quiz, h2"); cell = cell.nextElementSibling) {
        const [code, output] = [".jp-Cell-inputArea", ".jp-Cell-outputWrapper"].map(
            (part) => Boolean(cell.querySelector(part)?.offsetHeight));
        seen.push([code, output && Boolean(cell.querySelector(".jp-OutputArea-child"))]);
    }
    return seen;
}"""
"""In the page: of each cell below a prediction, whether code and output can be seen."""


def test_predictions_open_their_answers(
    request: pytest.FixtureRequest, chapter: LabNotebook
) -> None:
    """After Run All each result is out of sight, until an answer is given; then it is there."""
    name = request.node.callspec.params["chapter"]
    questions = predictions_in(ROOT / "notebooks" / f"{name}.ipynb")
    forms = chapter.page.locator(".predict form")
    assert forms.count() == len(questions)
    for place, question in enumerate(questions):
        form = forms.nth(place)
        assert form.evaluate(IN_SIGHT)[0] == [False, False], question.id
        if isinstance(question, ChoiceQuestion):
            form.get_by_role("radio").first.check()
            said = question.options[0].feedback
        elif isinstance(question, ArrowQuestion):
            for k, part in enumerate(question.wrong_values[0].value):
                form.get_by_role("textbox").nth(k).fill(str(part))
            said = question.wrong_values[0].feedback
        else:
            form.get_by_role("textbox").fill(f"{question.wrong_values[0].value} {question.unit}")
            said = question.wrong_values[0].feedback
        form.get_by_role("button", name="Commit").click()
        form.get_by_text(said).wait_for(timeout=ANSWERED)
        assert any(form.evaluate(IN_SIGHT)[0]), question.id


def test_gap_is_filled_and_used(browser: Browser, lab: JupyterLab) -> None:
    """A known mistake gets its hint and ours is lent; the right line is used from then on."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    notebook = lab.open(page, "notebooks/01_one_dimension.ipynb")
    cell = page.locator(".jp-CodeCell:has-text('@gap(\"01-centre\")')")
    for written, said in (
        ("(v1 + v2) / 2", "hint: A truck meets a fly head on."),
        ("(m1 * v1 + m2 * v2) / (m1 + m2)", "From here on yours is used."),
    ):
        cell.locator(".cm-content").click()
        page.keyboard.press("Control+A")
        head = '@gap("01-centre")\ndef centre_velocity(m1, v1, m2, v2):\n    return '
        page.keyboard.insert_text(head + written)
        notebook.run_all()
        cell.get_by_text(said).wait_for(timeout=ANSWERED)
        assert notebook.errors.all_text_contents() == []
    lab.end_kernels(page)
    page.close()


def test_written_answer_gets_full_marks(browser: Browser, lab: JupyterLab) -> None:
    """A stub has no marks; the student types an answer over it, and the check gives all of them."""
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    exercise = lab.open(page, "exercises/01_one_dimension.ipynb")
    exercise.run_all()
    check = page.locator(".jp-CodeCell:has-text('check_task(\"1.1\"')")
    check.get_by_text("1.1 elastic_1d: 0/4 points").wait_for(timeout=ANSWERED)
    page.locator(".jp-CodeCell:has-text('def elastic_1d') .cm-content").click()
    page.keyboard.press("Control+A")
    page.keyboard.insert_text(ANSWER)
    exercise.run_all()
    check.get_by_text("1.1 elastic_1d: 4/4 points").wait_for(timeout=ANSWERED)
    assert exercise.errors.all_text_contents() == []
    lab.end_kernels(page)
    page.close()
