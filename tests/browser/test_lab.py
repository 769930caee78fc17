"""The collision lab in Chromium: what it shows is what the engine computes, by every control."""

from __future__ import annotations

import json
import re
from math import cos, hypot, pi, sin
from random import Random
from typing import TYPE_CHECKING, Any
from urllib.parse import quote, unquote

import pytest

from lesson_code import (
    Body,
    Circle,
    Material,
    Polygon,
    Scene,
    Segment,
    formulas,
    scene_file,
    simulate,
)
from lesson_code.course.chapters import chapters
from lesson_code.engine.core.run import Run
from lesson_code.engine.effects.choice import choose_effects
from lesson_code.engine.effects.question import Question
from lesson_code.view.browser import lab_still
from lesson_code.view.browser.lab import lab_html

from .test_pages import violations_in

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Browser, Locator, Page

SHEET = """<!doctype html><html lang="en"><meta charset="utf-8"><title>Lab</title>
<meta name="color-scheme" content="light dark"><body><main><h1>Lab</h1>{lab}</main>"""

FEW = ["Oblique hit", "Head on, equal masses", "Heavy on light", "They stay together"]
FEW += ["Row of five", "Friction makes spin", "Polygons and discs that fall"]
FEW += ["Ball that bounces", "Ball between mirrors", "Fast ball, thin plate"]
FEW += ["Heavy on a light box"]
MANY = ["Rack of fifteen", "Gas of 500"]

TWO_FRAMES = """() => new Promise(
    (done) => requestAnimationFrame(() => requestAnimationFrame(done)))"""
"""In the page: lets two frames pass."""

PLANNED = 10.0
"""s: the run that the lab's plan is for, as it says itself."""

SHOWN = 5e-5
"""Numbers have four decimals."""


def opened(page: Page, folder: Path, link: str = "") -> Locator:
    """Open a page with the lab from a folder, and return the lab once it is alive."""
    file = folder / "lab.html"
    file.write_text(SHEET.format(lab=lab_html()), "utf-8")
    page.goto(file.as_uri() + link)
    page.locator("[data-lab][data-ready] canvas").first.wait_for()
    return page.locator("[data-lab]")


def press(lab: Locator, name: str, times: int = 1) -> None:
    """Press a button some times."""
    button = lab.get_by_role("button", name=name, exact=True)
    button.evaluate("(button, times) => { while (times--) button.click(); }", times)


def set_up_of(lab: Locator) -> dict[str, Any]:
    """Return the set-up that the link holds."""
    href = lab.get_by_role("link", name="Link to this set-up").get_attribute("href") or ""
    set_up: dict[str, Any] = json.loads(unquote(href.removeprefix("#lab=")))
    return set_up


def numbers_of(lab: Locator, name: str) -> list[float]:
    """Return a number of each body, as its card shows it."""
    boxes = lab.locator(f'fieldset input[aria-label^="{name},"]').all()
    return [float(box.input_value()) for box in boxes]


def words_of(lab: Locator) -> str:
    """Return the totals in words."""
    return lab.locator(".lab-words").inner_text()


def shape_of(body: dict[str, Any]) -> Circle | Polygon:
    """Return the shape of a body: a regular polygon has a corner at the angle 0."""
    size = body["size"]
    if body["shape"] == "disc":
        return Circle(size)
    if body["shape"] == "box":
        return Polygon.box(2 * size, 2 * size)
    turns = [2 * pi * k / body["corners"] for k in range(body["corners"])]
    return Polygon([(size * cos(turn), size * sin(turn)) for turn in turns])


def simulated(set_up: dict[str, Any], steps: int) -> Run:
    """Return a run of a set-up in Python, by the lab's solver."""
    is_track = set_up["dimensions"] == 1
    friction = 0.0 if is_track else set_up["friction"]
    surface = Material(set_up["elasticity"] / 100, friction)
    bodies = []
    for b in set_up["bodies"]:
        shape = shape_of(b)
        given: dict[str, Any] = {"mass": b["mass"], "material": surface}
        if is_track:
            given |= {"position": (b["x"], 0), "velocity": (b["vx"], 0), "inertia": float("inf")}
        else:
            given |= {"position": (b["x"], b["y"]), "velocity": (b["vx"], b["vy"])}
            given |= {"angle": b["angle"], "angular_velocity": b["w"]}
        bodies.append(Body(shape, **given))
    if set_up["walls"]:
        high = 1.0 if is_track else 2.5
        corners = [(-4, -high), (4, -high), (4, high), (-4, high)]
        sides = [Segment(corners[k], corners[(k + 1) % 4]) for k in range(4)]
        bodies += [Body(side, material=surface) for side in (sides[1::2] if is_track else sides)]
    gravity = (0, -9.81 if set_up["gravity"] and not is_track else 0)
    return simulate(Scene(bodies, gravity), steps / 60, solver="sequential")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_lab_passes_axe_without_errors(
    page: Page, faults: list[str], tmp_path: Path, scheme: Any
) -> None:
    """Its controls have names, its words contrast enough."""
    page.emulate_media(color_scheme=scheme)
    lab = opened(page, tmp_path)
    lab.get_by_text("Graphs and values").click()
    press(lab, "Step", 60)
    assert violations_in(page) == []
    assert faults == []


@pytest.mark.parametrize("preset", FEW + MANY)
def test_lab_fits_a_telephone(page: Page, faults: list[str], tmp_path: Path, preset: str) -> None:
    """360 pixels wide, nothing has to be scrolled sideways; the picture is not empty."""
    page.set_viewport_size({"width": 360, "height": 740})
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option(preset)
    assert page.evaluate("document.documentElement.scrollWidth") == 360
    assert lab.locator("canvas").first.evaluate(
        """canvas => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height)
            .data.some((value) => value > 0)"""
    )
    assert faults == []


@pytest.mark.parametrize("preset", FEW)
def test_lab_shows_what_the_engine_computes(page: Page, tmp_path: Path, preset: str) -> None:
    """Places and velocities after 70 steps, momentum and energies, as a run in Python has them."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option(preset)
    press(lab, "Step", 70)
    run = simulated(set_up_of(lab), 70)
    count = len(set_up_of(lab)["bodies"])
    for name, expected in [
        ("x", run.positions[-1, :count, 0]),
        ("y", run.positions[-1, :count, 1]),
        ("velocity x", run.velocities[-1, :count, 0]),
        ("velocity y", run.velocities[-1, :count, 1]),
    ]:
        assert numbers_of(lab, name) == pytest.approx(expected, abs=SHOWN), name
    lost = run.energy[0] - run.energy[-1]
    px, py = run.momentum[-1]
    told = words_of(lab).replace("\N{MINUS SIGN}", "-")
    is_track = set_up_of(lab)["dimensions"] == 1
    momentum = f"{px + 0.0:.2f}" if is_track else f"({px:.2f}, {py:.2f})"
    assert f"Momentum {momentum} kg m/s" in told.replace("-0.00", "0.00") or "-0.00" in momentum
    assert f"kinetic energy {run.kinetic_energy[-1]:.2f} J" in told
    assert f"energy lost since t = 0: {abs(lost):.2f} J" in told


def test_steps_back_lead_to_what_was_seen(page: Page, tmp_path: Path) -> None:
    """Over a hundred steps, past the states that are kept, and forward again."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option("Polygons and discs that fall")

    def seen() -> tuple[Any, ...]:
        return words_of(lab), numbers_of(lab, "x"), lab.locator(".lab-clock").inner_text()

    press(lab, "Step", 20)
    early = seen()
    press(lab, "Step", 100)
    late = seen()
    press(lab, "Step back", 100)
    assert seen() == early
    press(lab, "Step", 100)
    assert seen() == late
    press(lab, "Reset")
    assert numbers_of(lab, "y") == [body["y"] for body in set_up_of(lab)["bodies"]]
    assert lab.get_by_role("button", name="Step back").is_disabled()


def test_body_and_tip_of_a_velocity_are_dragged(page: Page, tmp_path: Path) -> None:
    """The picture is 8.2 m wide, its middle at (0, 0); an arrow has 0.4 m for 1 m/s."""
    lab = opened(page, tmp_path)
    box = lab.locator("canvas").first.bounding_box()
    assert box
    metre = box["width"] / 8.2

    def drag(start: tuple[float, float], end: tuple[float, float]) -> None:
        for move, (x, y) in ((page.mouse.down, start), (page.mouse.up, end)):
            middle = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
            page.mouse.move(middle[0] + x * metre, middle[1] - y * metre)
            move()

    drag((-2.5, -0.3), (-1.5, 1.2))
    assert (numbers_of(lab, "x")[0], numbers_of(lab, "y")[0]) == (-1.5, 1.2)
    assert numbers_of(lab, "velocity x")[0] == 3
    drag((-0.3, 1.2), (-0.7, 0.8))  # the tip lies 3 * 0.4 m to the right
    assert (numbers_of(lab, "velocity x")[0], numbers_of(lab, "velocity y")[0]) == (2, -1)
    drag((0.5, 0), (9, 9))
    assert (numbers_of(lab, "x")[1], numbers_of(lab, "y")[1]) == (3.5, 2.0)  # at the walls
    drag((-3.9, -2.4), (0, 0))
    assert numbers_of(lab, "x") == [-1.5, 3.5]  # nothing was there


def test_every_number_is_set_by_keyboard_and_read_out(page: Page, tmp_path: Path) -> None:
    """Typed, or by arrow keys; what is out of range is put right at the end."""
    lab = opened(page, tmp_path)
    mass = lab.get_by_role("spinbutton", name="mass, kg, of body 1")
    mass.focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Shift+ArrowUp")
    assert mass.input_value() == "2.1"
    mass.fill("2.345")
    assert set_up_of(lab)["bodies"][0]["mass"] == 2.345
    mass.fill("-1")
    mass.blur()
    assert mass.input_value() == "2.345"
    elasticity = lab.get_by_role("slider", name="Elasticity, %")
    elasticity.focus()
    page.keyboard.press("ArrowLeft")
    assert set_up_of(lab)["elasticity"] == 95
    heard = lab.get_by_role("status").filter(has_text="Momentum (7.04")  # 2.345 kg at 3 m/s
    heard.filter(has_text="Body 1 at (\N{MINUS SIGN}2.50").wait_for()
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.parentElement.textContent").startswith("Friction")


def test_change_in_motion_begins_where_the_bodies_are(page: Page, tmp_path: Path) -> None:
    """Gravity is switched on after 30 steps: places and velocities stay."""
    lab = opened(page, tmp_path)
    press(lab, "Step", 30)
    before = numbers_of(lab, "x"), numbers_of(lab, "velocity x")
    lab.get_by_label("Gravity").check()
    assert (numbers_of(lab, "x"), numbers_of(lab, "velocity x")) == before
    press(lab, "Step", 6)
    fallen = numbers_of(lab, "velocity y")
    assert fallen == pytest.approx([-9.81 * 6 / 60] * 2, abs=SHOWN)
    lab.get_by_label("Motion").select_option("on a line")
    assert lab.get_by_label("Gravity").is_hidden()
    press(lab, "Add a body")
    assert len(numbers_of(lab, "mass")) == 3
    press(lab, "Remove body 1")
    assert numbers_of(lab, "mass") == [2, 1]


def test_link_opens_the_same_set_up_and_a_wrong_one_is_refused(page: Page, tmp_path: Path) -> None:
    """In another page; the words name argument, rule and value."""
    lab = opened(page, tmp_path)
    press(lab, "Step", 50)
    lab.get_by_role("slider", name="Friction").fill("0.3")
    shared = set_up_of(lab)
    page.goto("about:blank")
    again = opened(page, tmp_path, "#lab=" + quote(json.dumps(shared)))
    assert set_up_of(again) == shared
    wrong = json.dumps(shared | {"elasticity": 101})
    page.evaluate("hash => { location.hash = hash; }", "lab=" + quote(wrong))
    words = "The link holds no set-up: elasticity must lie between 0 and 100, got 101"
    again.get_by_role("alert").get_by_text(words).wait_for()
    assert set_up_of(again) == shared


def test_lab_runs_until_it_is_paused(page: Page, faults: list[str], tmp_path: Path) -> None:
    """With 500 discs too; the clock goes on, and stands still afterwards."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option("Gas of 500")
    clock = lab.locator(".lab-clock")
    press(lab, "Run")
    page.wait_for_function(
        "document.querySelector('[data-lab] .lab-clock').textContent > 't = 0.2'"
    )
    press(lab, "Pause")
    stopped = clock.inner_text()
    page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    assert clock.inner_text() == stopped
    assert faults == []


def test_link_keeps_the_run_and_says_what_it_has_done(page: Page, tmp_path: Path) -> None:
    """The address holds the set-up, the clock goes on, and the words tell it."""
    lab = opened(page, tmp_path)
    press(lab, "Step", 30)
    href = lab.get_by_role("link", name="Link to this set-up").get_attribute("href") or ""
    lab.get_by_role("link", name="Link to this set-up").click()
    lab.get_by_role("link", name=re.compile("The link is copied|The address holds")).wait_for()
    assert page.url.endswith(href)
    assert lab.locator(".lab-clock").inner_text() == "t = 0.50 s"


def test_choice_says_what_the_lab_began_with(page: Page, tmp_path: Path) -> None:
    """A preset by its name, also after Reset; anything else is the reader's own."""
    lab = opened(page, tmp_path)
    begun = lab.get_by_label("Begin with")
    assert begun.input_value() == "Oblique hit"
    press(lab, "Step", 5)
    press(lab, "Reset")
    assert begun.input_value() == "Oblique hit"
    lab.get_by_label("Walls").uncheck()
    assert begun.input_value() == "a set-up of your own"
    begun.select_option("Oblique hit")
    assert lab.get_by_label("Walls").is_checked()


def test_lab_says_what_it_needs_where_no_script_runs() -> None:
    """In words and a still picture of today's lab, which the script replaces."""
    before = lab_html().split("<script")[0]
    assert "needs a browser that runs JavaScript" in before
    assert 'alt="Two discs' in before
    assert lab_still.fault() == ""


def test_momenta_and_impulses_of_an_impact_add_up(page: Page, tmp_path: Path) -> None:
    """What the list says of the oblique hit, against a run in Python and Newton's third law."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option("Friction makes spin")
    press(lab, "Step", 70)
    run = simulated(set_up_of(lab), 70)
    lines = [line.replace("\N{MINUS SIGN}", "-") for line in lab.locator("li").all_inner_texts()]
    contact = next(line for line in lines if line.startswith("Contact"))
    normal, tangent = run.contacts.normal_impulse[-1], run.contacts.tangent_impulse[-1]
    assert f"gave each other {normal:.2f} N s" in contact
    assert f"and {abs(tangent):.2f} N s of friction" in contact
    changes = [line.split("change (")[1].split(")")[0] for line in lines if "change (" in line]
    (ax, ay), (bx, by) = ([float(part) for part in change.split(", ")] for change in changes)
    assert (ax + bx, ay + by) == pytest.approx((0, 0), abs=0.011)  # two decimals each
    assert hypot(ax, ay) == pytest.approx(hypot(normal, tangent), abs=0.01)


@pytest.mark.parametrize(
    "preset", ["Head on, equal masses", "Heavy on light", "Friction makes spin"]
)
def test_code_that_has_just_run_says_what_the_engine_gave(
    page: Page, tmp_path: Path, preset: str
) -> None:
    """The printed calls, run in Python, yield the impulses of a run in Python."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option(preset)
    lab.get_by_text("The code that has just run").click()
    part = lab.locator("details").filter(has_text="The code that has just run")
    part.get_by_text("No two bodies have met yet.").wait_for()
    steps = 0
    while "That is what the formulas say." not in part.inner_text():
        press(lab, "Step")
        steps += 1
        assert steps < 200
    contacts = simulated(set_up_of(lab), steps).contacts
    values: dict[str, Any] = {name: getattr(formulas, name) for name in formulas.__all__}
    exec(lab.locator(".lab-calls").inner_text(), values)  # noqa: S102 - our own text
    assert values["jn"] == pytest.approx(contacts.normal_impulse[-1], rel=1e-5)  # six digits
    assert values.get("jt", 0.0) == pytest.approx(contacts.tangent_impulse[-1], rel=1e-5)


@pytest.mark.parametrize(("friction", "verb"), [("1", "sticks"), ("0.05", "slips on at")])
def test_contact_sticks_within_the_cone_and_slips_at_its_edge(
    page: Page, tmp_path: Path, friction: str, verb: str
) -> None:
    """The same oblique hit, with much friction and with little; the slip is that of Python."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option("Friction makes spin")
    lab.get_by_role("slider", name="Friction").fill(friction)
    press(lab, "Step", 70)
    contact = lab.locator("li").filter(has_text="Contact").first.inner_text()
    run = simulated(set_up_of(lab), 70)
    first, second = set_up_of(lab)["bodies"]
    nx, ny = run.contacts.normal[-1]
    v, w = run.velocities[-1], run.angular_velocities[-1]
    along = (v[1] - v[0]) @ (-ny, nx)
    slip = abs(along - w[1] * second["size"] - w[0] * first["size"])
    assert verb in contact
    if verb == "sticks":
        assert slip < 1e-9
    else:
        assert contact.endswith(f"slips on at {slip:.2f} m/s.")


def parts_of_plan(text: str) -> tuple[str, list[str]]:
    """Return the solver and why, and the effects: all but the code that ran."""
    first, *effects = text.splitlines()
    return first.partition(";")[0], effects


@pytest.mark.parametrize("preset", [*FEW, "Rack of fifteen"])
def test_python_of_a_set_up_makes_the_same_run_and_has_its_plan(
    page: Page, tmp_path: Path, capsys: pytest.CaptureFixture[str], preset: str
) -> None:
    """The lines that are shown, run: the places of the lab, and the engine's plan of effects.

    The plan's first line says what code ran, which may be another by the second run.
    """
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option(preset)
    press(lab, "Step", 40)
    lab.get_by_text("This set-up in Python").click()
    lab.get_by_text("print(run.plan)").wait_for()
    names: dict[str, Any] = {}
    exec(lab.locator("pre").last.inner_text(), names)  # noqa: S102 - our own text
    expected = simulated(set_up_of(lab), 40)
    assert (names["run"].positions[-1] == expected.positions[-1]).all()
    assert parts_of_plan(capsys.readouterr().out) == parts_of_plan(str(expected.plan))
    assert {*expected.plan.used, *expected.plan.left_out} >= {"gravity", "friction", "rotation"}
    shown = numbers_of(lab, "x")
    assert shown == pytest.approx(expected.positions[-1, : len(shown), 0], abs=SHOWN)


def plan_of(lab: Locator) -> list[tuple[str, str, str]]:
    """Return the rows of the plan that the lab shows."""
    rows: list[list[str]] = lab.locator(".lab-plan tr").evaluate_all(
        "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))"
    )
    return [(name, verdict[2:], reason) for name, verdict, reason in rows]


def planned(set_up: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return the plan of a set-up in Python, for the time that the lab names.

    A hand may reach in: no two bodies are taken to fly past each other.
    """
    question = Question(scene_file.scene_of(set_up), duration=PLANNED)
    question.facts.flights_meet = True
    choices = choose_effects(question)
    return [(c.name.replace("_", " "), c.verdict, c.reason) for c in choices]


@pytest.mark.parametrize("preset", [*FEW, *MANY])
def test_plan_of_a_preset_is_that_of_python(page: Page, tmp_path: Path, preset: str) -> None:
    """Every effect, in its order, with the verdict and the reason in the same words."""
    lab = opened(page, tmp_path)
    lab.get_by_label("Begin with").select_option(preset)
    with page.expect_download() as saved:
        press(lab, "Save as file")
    set_up = json.loads(saved.value.path().read_text("utf-8"))
    assert f"for {PLANNED:g} s" in (lab.locator("details:has(.lab-plan) p").text_content() or "")
    assert plan_of(lab) == planned(set_up)


def test_plan_of_drawn_set_ups_is_that_of_python(page: Page, tmp_path: Path) -> None:
    """200 of them, from no body to thirty, some with surfaces of their own."""
    lab = opened(page, tmp_path)
    for seed in range(200):
        set_up = scene_file.understood(drawn(Random(seed)))  # noqa: S311 - no secret
        page.evaluate("link => (location.hash = link)", f"#lab={quote(json.dumps(set_up))}")
        page.evaluate(TWO_FRAMES)
        assert plan_of(lab) == planned(set_up), seed


def drawn(random: Random) -> dict[str, Any]:
    """Return a set-up that may have anything."""
    bodies = []
    for _ in range(random.choice([0, 1, 2, 3, 6, 23, 24, 30])):
        one: dict[str, Any] = {"shape": random.choice(["disc", "disc", "box", "polygon"])}
        one |= {"mass": random.uniform(0.1, 9), "size": random.uniform(0.05, 0.6)}
        one |= {key: random.uniform(-3, 3) for key in ("x", "y", "vx", "vy")}
        one |= {"w": random.choice([0, 0, 2.5])}
        if random.random() < 0.2:
            one |= {"elasticity": random.choice([0, 35]), "friction": random.choice([0, 0.7])}
        bodies.append(one)
    if random.random() < 0.5:
        bodies = [{**one, "shape": "disc", "w": 0} for one in bodies]
    return {
        "dimensions": random.choice([1, 2, 2]),
        "elasticity": random.choice([0, 33.3, 100]),
        "friction": random.choice([0, 0, 0.35]),
        "gravity": random.choice([False, False, True, 1.62]),
        "walls": random.random() < 0.5,
        "bodies": bodies,
    }


def test_plan_answers_while_the_set_up_changes(page: Page, tmp_path: Path) -> None:
    """Friction is switched on by its slider: it is used at once, and turns the discs."""
    lab = opened(page, tmp_path)
    before = {name: verdict for name, verdict, _ in plan_of(lab)}
    lab.get_by_role("slider", name="Friction").fill("0.5")
    after = {name: (verdict, reason) for name, verdict, reason in plan_of(lab)}
    assert before["friction"] == before["rotation"] == "left out"
    assert after["friction"] == ("used", "a pair has mu = 0.5")
    assert after["rotation"] == ("used", "friction turns discs")


@pytest.mark.parametrize("corners", [3, 7, 20])
def test_polygon_has_as_many_corners_as_are_typed(page: Page, tmp_path: Path, corners: int) -> None:
    """It hits another body as it does in Python; three and a half corners are refused."""
    lab = opened(page, tmp_path)
    lab.get_by_label("shape").first.select_option("polygon")
    box = lab.get_by_label("corners, of body 1")
    box.fill(str(corners))
    box.fill("3.5")
    box.press("Tab")
    assert box.input_value() == str(corners)
    assert set_up_of(lab)["bodies"][0]["corners"] == corners
    press(lab, "Step", 80)
    run = simulated(set_up_of(lab), 80)
    assert run.contacts.time.size
    assert numbers_of(lab, "x") == pytest.approx(run.positions[-1, :2, 0], abs=SHOWN)
    assert numbers_of(lab, "angle") == pytest.approx(run.angles[-1, :2], abs=SHOWN)


def test_every_chapter_of_physics_has_a_preset(page: Page, tmp_path: Path) -> None:
    """Chapters 01 to 10, each by its title; all presets stand under a chapter."""
    lab = opened(page, tmp_path)
    groups = lab.get_by_label("Begin with").locator("optgroup")
    titles = [f"{each.number} {each.title}" for each in chapters() if each.number not in ("", "00")]
    assert [group.get_attribute("label") for group in groups.all()] == titles[:10]
    assert {*FEW, *MANY} <= set(groups.locator("option").all_inner_texts())


def test_values_of_every_step_are_saved_as_csv(page: Page, tmp_path: Path) -> None:
    """The last row is the last state of a run in Python; graphs of every kind can be chosen."""
    lab = opened(page, tmp_path)
    press(lab, "Step", 70)
    lab.get_by_text("Graphs and values").click()
    for kind in lab.get_by_label("Show").locator("option").all_inner_texts():
        lab.get_by_label("Show").select_option(kind)
        label = lab.locator("details canvas").last.get_attribute("aria-label") or ""
        assert label.startswith(f"{kind}, over 1.17 s: at the end")
    with page.expect_download() as saving:
        press(lab, "Save the values as CSV")
    head, *rows = saving.value.path().read_text("utf-8").splitlines()
    values = dict(zip(head.split(","), map(float, rows[-1].split(",")), strict=True))
    run = simulated(set_up_of(lab), 70)
    assert len(rows) == 71
    assert (values["x_2"], values["y_2"]) == pytest.approx(tuple(run.positions[-1, 1]), abs=1e-12)
    assert values["kinetic_energy"] == pytest.approx(run.kinetic_energy[-1], abs=1e-12)
    assert values["time"] == pytest.approx(70 / 60)


def test_body_is_moved_thrown_and_scaled_by_keys(page: Page, tmp_path: Path) -> None:
    """Body 2 is chosen; one arrow is 0.05 m, with Shift 0.1 m/s."""
    lab = opened(page, tmp_path)
    lab.locator("canvas").first.focus()
    for key in ("2", "ArrowRight", "ArrowUp", "Shift+ArrowLeft", "+", "+", "-"):
        page.keyboard.press(key)
    second = set_up_of(lab)["bodies"][1]
    wanted = {"x": 0.55, "y": 0.05, "vx": -0.1, "vy": 0, "size": 0.55}
    assert {name: second[name] for name in wanted} == pytest.approx(wanted)


def test_size_is_dragged_by_its_handle(page: Page, tmp_path: Path) -> None:
    """A press on a body chooses it; the handle stands on its rim, at its angle."""
    lab = opened(page, tmp_path)
    box = lab.locator("canvas").first.bounding_box()
    assert box
    metre = box["width"] / 8.2

    def to(x: float, y: float) -> None:
        page.mouse.move(
            box["x"] + box["width"] / 2 + x * metre, box["y"] + box["height"] / 2 - y * metre
        )

    to(0.5, 0)
    page.mouse.down()
    page.mouse.up()
    to(1.0, 0)
    page.mouse.down()
    to(1.3, 0)
    page.mouse.up()
    assert [body["size"] for body in set_up_of(lab)["bodies"]] == [0.4, 0.8]


def test_finger_drags_a_body(browser: Browser, tmp_path: Path) -> None:
    """Touch events of Chromium, on a telephone: a finger on a body moves it, the page stays."""
    context = browser.new_context(viewport={"width": 360, "height": 740}, has_touch=True)
    page = context.new_page()
    lab = opened(page, tmp_path)
    box = lab.locator("canvas").first.bounding_box()
    assert box
    metre = box["width"] / 8.2
    touch = context.new_cdp_session(page)

    def send(kind: str, *places: tuple[float, float]) -> None:
        points = [
            {
                "x": box["x"] + box["width"] / 2 + x * metre,
                "y": box["y"] + box["height"] / 2 - y * metre,
            }
            for x, y in places
        ]
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    send("touchStart", (0.5, 0))
    for k in range(1, 6):
        send("touchMove", (0.5 + 0.2 * k, -0.2 * k))
    send("touchEnd")
    moved = set_up_of(lab)["bodies"][1]
    assert (moved["x"], moved["y"]) == pytest.approx((1.5, -1.0), abs=0.051)
    assert page.evaluate("scrollY") == 0
    context.close()
