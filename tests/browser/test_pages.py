"""The pages in a browser, opened from their folder: no server, no network, no mouse needed."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any
from urllib.parse import urlsplit
from zipfile import ZipFile

import pytest

from lesson_code.course.quiz.bank import load_bank
from lesson_code.course.quiz.checker import check_answer, expected_answer
from lesson_code.course.quiz.questions import ArrowQuestion, ChoiceQuestion, Question

from .in_browser import expect_all_alive, figures_in, predictions_in

if TYPE_CHECKING:
    from playwright.sync_api import Page

ROOT = Path(__file__).parents[2]
CHAPTERS = sorted(path.stem for path in (ROOT / "notebooks").glob("*.ipynb"))
HANDBOOK = ["pages/students", "pages/glossary", "api/lesson_code", "api/lesson_code.formulas"]
PAGES = [
    "index",
    "lab",
    "exercises",
    "search",
    "exercises/01_one_dimension",
    "exercises/03_reflection",
    *HANDBOOK,
    *(f"notebooks/{name}" for name in CHAPTERS),
]
PHONE: Any = {"width": 360, "height": 740}
AXE: Any = {"resultTypes": ["violations"], "preload": False}
"""What axe-core is asked. By itself it would load style sheets, which a folder does not let it."""

OF_COLOURS = ["color-contrast", "link-in-text-block"]
"""The rules whose answer depends on the colours of a page, of those that axe-core has on."""

JUMPS = """() => new Promise((done) => {
    const jumps = [];
    new PerformanceObserver((list) => {
        for (const { value, sources } of list.getEntries()) {
            const nodes = sources.map((source) => source.node);
            const moved = nodes.filter((one) => one?.parentElement?.closest("#search-results"));
            jumps.push([value, moved.map((one) => one.textContent)]);
        }
    }).observe({ type: "layout-shift", buffered: true });
    setTimeout(() => done(jumps), 200);
})"""
"""In the page: each jump of its parts since it was opened, how far, as Cumulative Layout Shift sums
them up; and which results of a search it moved."""

LITTLE_JUMPS = 0.02
"""A fifth of what the web's vitals call good: the words above the picture may take another line."""

SOON = 10_000
"""ms: what needs no computing is there at once, unless the machine is busy."""


def open_page(page: Page, site: Path, name: str) -> None:
    """Open a page of the site."""
    page.goto((site / f"{name}.html").as_uri())


def violations_in(page: Page, **more: Any) -> list[Any]:
    """Return what axe-core finds wrong in a page: the rule, and the elements that break it."""
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs pip install -e '.[browser]'"
    )
    found = axe.Axe().run(page, options=AXE | more).response["violations"]
    return [(rule["id"], [node["html"] for node in rule["nodes"]]) for rule in found]


@pytest.mark.parametrize("name", PAGES)
def test_page_passes_axe_and_has_no_errors(
    site: Path, page: Page, faults: list[str], name: str
) -> None:
    """No script fails, no file is missing, no network is asked, and axe-core finds nothing.

    In the dark it looks at all that is about colours: nothing else changes.
    """
    open_page(page, site, name)
    assert violations_in(page) == []
    page.emulate_media(color_scheme="dark")
    assert violations_in(page, runOnly=OF_COLOURS) == []
    assert faults == []


@pytest.mark.parametrize("name", PAGES)
def test_page_fits_a_phone(site: Path, page: Page, name: str) -> None:
    """On a screen 360 px wide nothing but code and formulas has to be scrolled sideways."""
    page.set_viewport_size(PHONE)
    open_page(page, site, name)
    assert page.evaluate("document.documentElement.scrollWidth") == PHONE["width"]


@pytest.mark.parametrize("name", CHAPTERS)
def test_every_live_figure_of_a_page_answers(site: Path, page: Page, name: str) -> None:
    """All that the notebook has, without a server."""
    if count := figures_in(ROOT / "notebooks" / f"{name}.ipynb"):
        open_page(page, site, f"notebooks/{name}")
        expect_all_alive(page, count)


@pytest.mark.parametrize("name", CHAPTERS)
def test_every_picture_is_there_and_has_a_text(site: Path, page: Page, name: str) -> None:
    """Each image has arrived, and has a text for those who do not see it; so has each animation."""
    open_page(page, site, f"notebooks/{name}")
    pictures = page.locator("article img")
    shown = pictures.evaluate_all("all => all.map((image) => [image.naturalWidth > 0, image.alt])")
    moving = page.locator("article svg[role=img]").evaluate_all(
        "all => all.map((a) => a.ariaLabel)"
    )
    assert shown or moving
    assert all(arrived and alt for arrived, alt in shown)
    assert all(moving)


@pytest.mark.parametrize("name", ["index", "lab"])
@pytest.mark.parametrize("view", [{"width": 1280, "height": 800}, {"width": 390, "height": 844}])
def test_first_throw_needs_no_scrolling_and_nothing_jumps(
    site: Path, page: Page, name: str, view: Any
) -> None:
    """What to do, the picture and Run are seen at once; they stand where the still picture was."""
    page.set_viewport_size(view)
    open_page(page, site, name)
    lab = page.locator("[data-lab][data-ready]")
    lab.wait_for()
    for part in (lab.get_by_text("Drag a body"), lab.get_by_role("button", name="Run", exact=True)):
        box = part.bounding_box()
        assert box
        assert box["y"] + box["height"] <= view["height"]
    assert sum(value for value, _ in page.evaluate(JUMPS)) <= LITTLE_JUMPS


def test_dark_and_light_follow_the_reader(site: Path, page: Page) -> None:
    """The page is dark where the reader's system is, and a button changes it."""
    seen = set()
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        open_page(page, site, "index")
        seen.add(page.evaluate("getComputedStyle(document.body).backgroundColor"))
    assert len(seen) == 2
    before = page.evaluate("document.body.dataset.theme")
    page.locator("button.theme-toggle:visible").click()
    assert page.evaluate("document.body.dataset.theme") != before


@pytest.mark.parametrize(
    ("asked", "page_found", "answer"),
    [
        ("Zeno", "02 Restitution", "zeno"),
        ("bounce height", "02 Restitution", "height"),
        ("separating axis", "06 SAT and manifolds", "separat"),
        ("Coulomb's limit", "05 Spin and friction", "coulomb"),
        ("tunnelling", "07 Time of impact", "tunnel"),
    ],
)
def test_search_answers_with_a_sentence_of_the_page(
    site: Path, page: Page, faults: list[str], asked: str, page_found: str, answer: str
) -> None:
    """What is typed is found, from a folder too, and said in a sentence of that page."""
    open_page(page, site, "index")
    page.get_by_role("textbox", name="Search").fill(asked)
    page.keyboard.press("Enter")
    result = page.locator("#search-results li", has_text=page_found).first
    sentence = result.locator(".sentence")
    sentence.wait_for(timeout=SOON)
    said = sentence.inner_text()
    assert answer in said.lower()
    assert len(said.split()) >= 3
    page.get_by_text("Search finished").wait_for(timeout=SOON)
    assert [results for _, results in page.evaluate(JUMPS) if results] == []
    with page.expect_navigation():  # to the end: a chapter is long
        result.locator("a").first.click()
    text = " ".join(page.locator("article").inner_text().split())
    assert said.split(",")[0][:20] in text
    marked = page.locator("article span.highlighted")
    marked.first.wait_for(state="attached")
    assert all(len(words) > 1 for words in marked.all_text_contents())
    assert faults == []


def test_code_that_only_imports_or_shows_is_folded(site: Path, page: Page) -> None:
    """It opens by keyboard; what computes or checks is seen from the start."""
    open_page(page, site, "notebooks/01_one_dimension")
    folded = page.locator("details.hide")
    assert folded.count() >= 3
    assert not page.get_by_text("import numpy as np").first.is_visible()
    assert page.get_by_text("equal masses exchange velocities").first.is_visible()
    folded.first.locator("summary").focus()
    page.keyboard.press("Enter")
    assert page.get_by_text("import numpy as np").first.is_visible()


def test_exercise_is_one_click_from_its_chapter(site: Path, page: Page) -> None:
    """From the top of the chapter to its first task."""
    open_page(page, site, "notebooks/03_reflection")
    page.get_by_role("link", name="write it and have it checked").click()
    page.get_by_role("heading", name="Task 3.1").wait_for()


def test_pages_weigh_little(site: Path, page: Page) -> None:
    """All files that one of them asks for, before a server packs them: 1 MB at most."""
    for name in (
        "index",
        "lab",
        "notebooks/01_one_dimension",
        "exercises/01_one_dimension",
        "search",
    ):
        files: list[Path] = []
        page.on("request", lambda request, to=files: to.append(Path(urlsplit(request.url).path)))
        open_page(page, site, name)
        page.wait_for_load_state()
        weight = sum(path.stat().st_size for path in set(files) if path.is_file())
        assert 0 < weight <= 1_000_000, f"{name}: {weight}"


def test_exercises_come_as_files(site: Path, page: Page) -> None:
    """Each link leads to the student copy, byte for byte, and one brings all of them."""
    open_page(page, site, "exercises")
    links = page.locator("article td a[download]").evaluate_all(
        "all => all.map((link) => link.href)"
    )
    given = {path.name: path.read_bytes() for path in (ROOT / "exercises").glob("[!._]*.*")}
    linked = [Path(urlsplit(link).path) for link in links]
    assert {path.name: path.read_bytes() for path in linked} == given
    with page.expect_download(timeout=SOON) as coming:
        page.get_by_role("link", name="exercises.zip").click()
    with ZipFile(coming.value.path()) as archive:
        files = [name for name in archive.namelist() if not name.endswith("/")]
        assert {Path(name).name: archive.read(name) for name in files} == given


def test_animation_plays_by_keyboard(site: Path, page: Page) -> None:
    """The space bar on an animation's slider starts it, and it comes to its end."""
    open_page(page, site, "notebooks/04_circles")
    seen = page.locator("figure[data-animation] input[type=range]").locator("visible=true")
    slider = seen.first  # others wait for the reader's prediction
    slider.focus()
    page.keyboard.press(" ")
    page.get_by_role("button", name="Play again").first.wait_for(timeout=6 * SOON)
    assert slider.input_value() == slider.get_attribute("max")


def test_first_tab_leads_past_the_navigation(site: Path, page: Page) -> None:
    """Whoever uses the keyboard need not go through the list of chapters on every page."""
    open_page(page, site, "notebooks/01_one_dimension")
    page.keyboard.press("Tab")
    assert "Skip to content" in page.evaluate("document.activeElement.textContent")


def test_wide_code_can_be_scrolled_by_keyboard(site: Path, page: Page) -> None:
    """On a phone most code is wider than the screen; each such box takes the focus."""
    page.set_viewport_size(PHONE)
    open_page(page, site, "notebooks/01_one_dimension")
    wide = "all => all.filter((pre) => pre.scrollWidth > pre.clientWidth).map((p) => p.tabIndex)"
    assert set(page.locator("article pre").evaluate_all(wide)) == {0}


def test_print_leaves_out_what_paper_cannot_do(site: Path, page: Page) -> None:
    """On paper there are no buttons, sliders and navigation, but the figures and questions."""
    page.emulate_media(media="print")
    open_page(page, site, "notebooks/04_circles")
    for gone in (".quiz button", "figure[data-animation] input", ".sidebar-drawer"):
        assert page.locator(f"{gone} >> visible=true").count() == 0, gone
    for kept in (".quiz legend", "figure.drawn img", "figure[data-animation] svg", "math"):
        assert page.locator(f"{kept} >> visible=true").count() > 0, kept


# The quiz


def answers_to(question: Question) -> list[str]:
    """Return answers of all kinds: each letter or known value, its edges, and what is none."""
    if isinstance(question, ArrowQuestion):
        tips = [question.value, *(wrong.value for wrong in question.wrong_values)]
        near = [(x + 0.4, y - 0.5) for x, y in tips]
        return [", ".join(map(repr, tip)) for tip in [*tips, *near, (1e3, 0.0)]] + ["east, 1", ", "]
    if isinstance(question, ChoiceQuestion):
        return [*(letter for letter, _ in question.lettered), ""]
    answers = ["", "high", "1e999", "12 parsecs", "-7.5e3", "\N{MINUS SIGN}1,5"]
    for value in (question.value, *(wrong.value for wrong in question.wrong_values)):
        reach = question.tolerance
        near = (value, value + reach, value - reach, value + 1.01 * reach, value - 0.99 * reach)
        answers += [repr(number) for number in near]
        answers.append(f" {value!r} {question.unit} ".replace(".", ","))
    return answers


def words_to(question: Question, answer: str) -> str:
    """Return what the one judge of answers has to say, as the page writes it."""
    try:
        verdict = check_answer(question, answer)
    except ValueError:
        return f"Please give {expected_answer(question)}."
    word = "right" if verdict.right else "not right"
    return f"{answer.strip()}: {word}. {verdict.feedback}"


GIVE = """([id, answers]) => {
    const form = [...document.querySelectorAll(".quiz form")].find(
        (form) => JSON.parse(form.dataset.question).id === id);
    return answers.map((answer) => {
        form.reset();
        const radio = form.querySelector(`input[value="${answer}"]`);
        if (radio) radio.checked = true;
        else if (form.querySelector(".sheet"))
            answer.split(", ").forEach((part, k) => (form.elements[id][k].value = part));
        else if (form.elements[id].type === "text") form.elements[id].value = answer;
        form.requestSubmit();
        return form.querySelector(".verdict").textContent;
    });
}"""
"""In the page: gives each answer to a question and returns what is said to it."""


@pytest.mark.parametrize("chapter", load_bank(), ids=lambda chapter: chapter.number)
def test_quiz_of_the_page_judges_as_the_one_judge_does(
    site: Path, page: Page, chapter: Any
) -> None:
    """Every option, every known value, values at the edge of a tolerance, units, and nonsense."""
    *_, name = (name for name in CHAPTERS if name.startswith(chapter.number))  # the last part
    open_page(page, site, f"notebooks/{name}")
    for question in chapter.questions:
        answers = answers_to(question)
        said = page.evaluate(GIVE, [question.id, answers])
        assert dict(zip(answers, said, strict=True)) == {a: words_to(question, a) for a in answers}


def test_quiz_is_answered_by_keyboard(site: Path, page: Page) -> None:
    """Arrow keys choose, Enter checks, the verdict is read out, and the count goes up."""
    asked = load_bank()[1].questions
    question = next(q for q in asked if isinstance(q, ChoiceQuestion))
    open_page(page, site, "notebooks/01_one_dimension")
    form = page.locator(".quiz:not(.predict) form").nth(asked.index(question))
    form.get_by_role("radio").first.focus()
    page.keyboard.press("Space")
    for _ in range("abcde".index(question.answer)):
        page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    assert form.get_by_role("status").text_content() == words_to(question, question.answer)
    assert page.locator(".quiz .count").text_content() == f"1 of {len(asked)} right"


def test_arrow_is_drawn_by_hand_and_in_numbers(site: Path, page: Page) -> None:
    """Its tip follows the pointer from crossing to crossing; the boxes below say where it is."""
    open_page(page, site, "notebooks/03_reflection")
    form = page.locator(".predict form:has(.sheet)")
    sheet, boxes = form.locator(".sheet"), form.get_by_role("textbox")
    sheet.scroll_into_view_if_needed()
    box = sheet.bounding_box()
    assert box is not None
    unit = box["width"] * 100 / 216 / 3  # the grid of three lines a side, within its margin
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for tip in ((0.9, 1.2), (2.1, 0.1), (9, 0)):
        page.mouse.move(x + tip[0] * unit, y - tip[1] * unit)
        at = min(round(tip[0]), 3), round(tip[1])
        assert [boxes.nth(k).input_value() for k in range(2)] == [str(part) for part in at]
    page.mouse.up()
    boxes.nth(0).fill("2")
    assert sheet.locator(".drawn").get_attribute("d").startswith("M0 0L66")  # type: ignore[union-attr]
    form.get_by_role("button", name="Commit").click()
    assert "2, 0: right." in str(form.get_by_role("status").text_content())


@pytest.mark.parametrize("name", CHAPTERS)
def test_predictions_of_the_page_open_their_answers(site: Path, page: Page, name: str) -> None:
    """Each is judged as by the one judge; its answer is closed before, and open after."""
    questions = predictions_in(ROOT / "notebooks" / f"{name}.ipynb")
    open_page(page, site, f"notebooks/{name}")
    forms, answers = page.locator(".predict form"), page.locator("details.answer")
    assert forms.count() == answers.count() == len(questions)
    for place, question in enumerate(questions):
        assert answers.nth(place).get_attribute("open") is None
        given = answers_to(question)
        said = page.evaluate(GIVE, [question.id, given])
        assert dict(zip(given, said, strict=True)) == {a: words_to(question, a) for a in given}
        assert answers.nth(place).get_attribute("open") is not None
