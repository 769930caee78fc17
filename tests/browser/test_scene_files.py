"""Scene files in Chromium: the lab opens what Python writes, and Python what the lab saves."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from lesson_code import Body, Circle, Material, Polygon, read_scene, simulate
from lesson_code.chapters.simulator.game import Simulator
from lesson_code.scene_file import set_up_of, write_scene

from ..test_scene_file import BROKEN, DISC
from .test_lab import SHOWN, numbers_of, opened, press
from .test_lab import set_up_of as shown_set_up

if TYPE_CHECKING:
    from playwright.sync_api import Locator, Page


def open_file(lab: Locator, path: Path) -> None:
    """Open a scene file in the lab, and wait until it has been read."""
    box = lab.get_by_label("Open a file")
    box.set_input_files(path)
    lab.page.wait_for_function("box => box.files.length === 0", arg=box.element_handle())


def saved_file(page: Page, lab: Locator, folder: Path) -> Path:
    """Return the file that the lab saves."""
    with page.expect_download() as coming:
        press(lab, "Save as file")
    path = folder / coming.value.suggested_filename
    coming.value.save_as(path)
    return path


def test_lab_opens_what_python_writes_and_saves_it_again(
    page: Page, faults: list[str], tmp_path: Path
) -> None:
    """Every field, surfaces of single bodies, a room of its own, gravity of the moon; and back."""
    bodies = [
        Body(Circle(0.25), mass=1.5, position=(1, -1), velocity=(2, 3), angular_velocity=4),
        Body(Polygon.box(0.5, 0.5), mass=2, angle=0.3, material=Material(0.25, 0.75)),
        Body(Polygon.regular(5, 0.5), mass=3, position=(-1, 2)),
    ]
    made = set_up_of(bodies, surface=Material(0.5, 0.2), gravity=1.62, room=(8, 6))
    write_scene(tmp_path / "written.json", made)
    lab = opened(page, tmp_path)
    open_file(lab, tmp_path / "written.json")
    assert shown_set_up(lab) == json.loads((tmp_path / "written.json").read_text())
    assert numbers_of(lab, "mass") == [1.5, 2, 3]
    again = saved_file(page, lab, tmp_path)
    assert read_scene(again) == read_scene(tmp_path / "written.json")
    press(lab, "Step", 40)
    run = simulate(read_scene(again), 40 / 60, solver="sequential")
    assert numbers_of(lab, "x") == pytest.approx(run.positions[-1, :3, 0].tolist(), abs=SHOWN)
    assert numbers_of(lab, "y") == pytest.approx(run.positions[-1, :3, 1].tolist(), abs=SHOWN)
    assert faults == []


def test_python_of_a_set_up_is_the_scene_of_its_file(page: Page, tmp_path: Path) -> None:
    """The lines that the lab shows build the bodies that the file holds."""
    bodies = [Body(Circle(0.25), mass=1), Body(Circle(0.5), mass=2, position=(2, 1), angle=0.5)]
    bodies.append(Body(Circle(0.3), mass=1, position=(-2, 1), material=Material(0.25, 0.75)))
    made = set_up_of(bodies, surface=Material(0.5, 0.2), gravity=1.62, room=(8, 6))
    write_scene(tmp_path / "written.json", made)
    lab = opened(page, tmp_path)
    open_file(lab, tmp_path / "written.json")
    lab.get_by_text("This set-up in Python").click()
    names: dict[str, Any] = {}
    text = lab.locator("details[open] pre").filter(has_text="scene = Scene").inner_text()
    exec(text, names)  # noqa: S102 - the lab's own lines
    assert names["scene"] == read_scene(tmp_path / "written.json")


def test_simulator_and_lab_show_the_same_bodies(page: Page, tmp_path: Path) -> None:
    """The balls of the simulator in the lab; those of the lab in the simulator."""
    game = Simulator(3, balls=5)
    for _ in range(30):
        game.step()
    write_scene(tmp_path / "scene-1.json", game.set_up())
    lab = opened(page, tmp_path)
    open_file(lab, tmp_path / "scene-1.json")
    states = [game.world.position(ball) for ball in game.balls]
    assert numbers_of(lab, "x") == pytest.approx([x - 4 for x, _ in states], abs=SHOWN)
    assert numbers_of(lab, "y") == pytest.approx([y - 3 for _, y in states], abs=SHOWN)
    lab.get_by_label("Begin with").select_option("Friction makes spin")
    other = Simulator()
    other.open_scene(saved_file(page, lab, tmp_path).read_text())
    for _ in range(20):
        other.step()
    press(lab, "Step", 20)
    places = [other.world.position(ball) for ball in other.balls]
    assert numbers_of(lab, "x") == pytest.approx([x - 4 for x, _ in places], abs=SHOWN)


def test_broken_file_is_refused_in_the_words_of_python(page: Page, tmp_path: Path) -> None:
    """After the file's name; the lab keeps what it shows."""
    lab = opened(page, tmp_path)
    before = shown_set_up(lab)
    path = tmp_path / "broken.json"
    for given, words in BROKEN:
        path.write_text(json.dumps(given), encoding="utf-8")
        open_file(lab, path)
        assert lab.get_by_role("alert").inner_text() == f"broken.json holds no scene: {words}"
    path.write_text('{"bodies": [', encoding="utf-8")
    open_file(lab, path)
    assert re.match(r"broken\.json holds no scene: .*JSON", lab.get_by_role("alert").inner_text())
    assert shown_set_up(lab) == before
    path.write_text(json.dumps({"bodies": [DISC]}), encoding="utf-8")
    open_file(lab, path)
    assert lab.get_by_role("alert").inner_text() == ""


def test_slider_coats_bodies_that_had_a_surface_of_their_own(page: Page, tmp_path: Path) -> None:
    """What the slider says is true of all bodies."""
    path = tmp_path / "scene.json"
    path.write_text(json.dumps({"bodies": [DISC | {"elasticity": 30}]}), encoding="utf-8")
    lab = opened(page, tmp_path)
    open_file(lab, path)
    assert shown_set_up(lab)["bodies"][0]["elasticity"] == 30
    lab.get_by_role("slider", name="Elasticity").fill("60")
    assert shown_set_up(lab)["elasticity"] == 60
    assert "elasticity" not in shown_set_up(lab)["bodies"][0]
