"""The small engine with a reader's functions: who does what, and what is wrong with it."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Scene, Segment
from lesson_code.chapters.billiards.rules import LAUNCH, TABLE, step
from lesson_code.chapters.ch11_the_small_engine import near_places
from lesson_code.chapters.ch11_the_small_engine.own_engine import OwnEngine
from lesson_code.chapters.ch11_the_small_engine.scenes import (
    PIXELS_PER_METRE,
    billiards,
    demo,
    pool_break,
)
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.own import own_functions
from lesson_code.course.notebooks.root import home
from lesson_code.course.notebooks.sources import executed, notebook_from
from lesson_code.engine.small_engine import simulate_small

ROUNDING = 1e-9
"""m at the end: 1e-13 of two ways to compute the same, which each hit makes larger."""

SECONDS = 3.0

SCENES = {"demo": (demo(), SECONDS), "pool": (pool_break(), 2.0), "billiards": (billiards(), 4.0)}
"""Those of section 6."""

EVERY_SCENE = pytest.mark.parametrize("scene", SCENES)


def with_function(engine: OwnEngine, name: str, function: Callable[..., Any]) -> OwnEngine:
    """Return an engine with another function in the place of one."""
    engine.functions[name] = replace(engine.functions[name], function=function)
    return engine


def test_functions_that_are_not_written_are_lent_and_named() -> None:
    """The workbook's own exercises hold stubs: all is lent, and the runs are the small engine's."""
    engine = OwnEngine(home())
    lines = str(engine).splitlines()
    assert len(lines) == len(engine.functions)
    assert all("lent: not written yet" in line for line in lines)
    for scene in SCENES.values():
        run, ours = engine.simulate(*scene), simulate_small(*scene)
        np.testing.assert_allclose(run.positions, ours.positions, atol=ROUNDING)
        assert engine.report == "all functions are lent"


@EVERY_SCENE
def test_solved_exercises_run_a_scene_as_the_small_engine_does(scene: str, solved: Path) -> None:
    """Functions with other signatures and other code: the same paths but for rounding."""
    engine = OwnEngine(solved)
    assert all(own.is_own for own in engine.functions.values())
    run, ours = engine.simulate(*SCENES[scene]), simulate_small(*SCENES[scene])
    np.testing.assert_allclose(run.positions, ours.positions, atol=ROUNDING)
    np.testing.assert_allclose(run.angles, ours.angles, atol=ROUNDING)
    assert engine.report == "no function of yours answered otherwise"
    assert all(own.is_own for own in engine.functions.values())


def test_first_shot_of_the_billiards_is_the_program_s(solved: Path) -> None:
    """The program bounces in its own way; in pixels, y down, the last place is the same."""
    place, velocity = map(np.array, LAUNCH)
    for _ in range(240):
        place, velocity, _ = step(place, velocity)
    x, y = OwnEngine(solved).simulate(*SCENES["billiards"]).positions[-1, -1]
    found = x * PIXELS_PER_METRE, TABLE.height - y * PIXELS_PER_METRE
    np.testing.assert_allclose(found, place, atol=ROUNDING * PIXELS_PER_METRE)


def test_hit_of_chapter_05_is_used_while_11_2_is_not_written(solved: Path) -> None:
    """Then contact_velocity, inverse_effective_mass and friction_impulse do the hits."""
    engine = OwnEngine(solved)
    engine.functions["hit"].give_up("not written yet")
    calls: list[Any] = []

    def counted(vt: float, jn: float, friction: float, k: float) -> float:
        calls.append(vt)
        return float(max(-friction * jn, min(-vt / k, friction * jn)))

    run = with_function(engine, "friction_impulse", counted).simulate(demo(), SECONDS)
    np.testing.assert_allclose(
        run.positions, simulate_small(demo(), SECONDS).positions, atol=ROUNDING
    )
    assert len(calls) > 10


SHOWN_BY_THE_DEMO = {
    "4.1": ("normal_from_2_to_1", "not_normalised", "gap_as_depth"),
    "4.3": ("half_each", "only_the_first_moves", "in_proportion_to_mass", "pushes_deeper"),
    "5.1": ("vertex_masses", "mass_left_out"),
    "6.4": ("largest_overlap", "from_b_to_a"),
    "6.6": ("corners_only", "edges_without_ends", "from_middle_to_middle"),
    "11.1": ("neighbours_in_a_row",),
    "11.2": (
        "yields_by_moving_alone",
        "friction_stops_everything",
        "both_turn_the_same_way",
        "sliding_before_the_blow",
    ),
}
"""Wrong answers that come out otherwise somewhere in the demo. The others need what does not happen
there: coincident centres, a disc's centre inside a polygon, one polygon inside another."""


@pytest.mark.one_in(3)
@pytest.mark.parametrize(
    ("task_id", "name"),
    [(task_id, name) for task_id, names in SHOWN_BY_THE_DEMO.items() for name in names],
)
def test_wrong_function_is_named_and_no_other(task_id: str, name: str, solved: Path) -> None:
    """Each stage is compared on the very bodies it was given, so that one error is told once."""
    task = task_by_id(task_id)
    wrong = next(model for model in task.wrong_models if model.name == name)
    engine = with_function(OwnEngine(solved), task.function, wrong.function)
    run = engine.simulate(demo(), SECONDS)
    assert list(engine.differences) == [task.function]
    assert f"{task.title} differs first at" in engine.differences[task.function]
    assert engine.differences[task.function] in engine.report
    apart = np.abs(run.positions - simulate_small(demo(), SECONDS).positions)
    assert np.isnan(apart.max()) or apart.max() > 1e-3


@EVERY_SCENE
def test_wrong_function_is_named_in_every_scene_that_shows_it(scene: str, solved: Path) -> None:
    """Moved apart by the whole depth each: the demo and the pool show it; a wall never moves."""

    def too_far(p1: Any, m1: float, p2: Any, m2: float, normal: Any, depth: float) -> Any:
        apart = depth * normal
        return p1 - apart * np.isfinite(m1), p2 + apart * np.isfinite(m2)

    engine = with_function(OwnEngine(solved), "separate", too_far)
    engine.simulate(*SCENES[scene])
    shown = "no function of yours" if scene == "billiards" else "4.3 separate differs first at 0."
    assert engine.report.startswith(shown)
    engine.simulate(Scene([Body(Circle(1), mass=1.0)]), 0.1)
    assert engine.report == "no function of yours answered otherwise"


@pytest.mark.parametrize(
    ("answer", "said"),
    [
        (lambda *_: None, "TypeError"),
        (lambda *_: 1 / 0, "ZeroDivisionError: division by zero"),
        (lambda *_: ((float("nan"), 0.0), (0.0, 0.0)), "not finite"),
        (lambda *_: (1.0, 2.0), "ValueError"),
    ],
)
def test_function_that_fails_is_named_and_lent_from_there_on(
    answer: Callable[..., Any], said: str, solved: Path
) -> None:
    """An engine goes on: what raises, or returns nothing to go on with, is asked no more."""
    engine = with_function(OwnEngine(solved), "separate", answer)
    run = engine.simulate(demo(), SECONDS)
    own = engine.functions["separate"]
    assert not own.is_own
    assert own.said.startswith("failed at 0.4")
    assert said in own.said
    assert engine.report == f"4.3 separate {own.said}\nlent: separate"
    np.testing.assert_allclose(
        run.positions, simulate_small(demo(), SECONDS).positions, atol=ROUNDING
    )


def test_function_may_change_what_it_is_given(solved: Path) -> None:
    """It gets arrays of its own."""

    def careless(p1: Any, m1: float, p2: Any, m2: float, normal: Any, depth: float) -> Any:
        normal *= depth / (1 / m1 + 1 / m2)
        p1 -= normal / m1
        p2 += normal / m2
        return p1, p2

    engine = with_function(OwnEngine(solved), "separate", careless)
    engine.simulate(demo(), SECONDS)
    assert engine.differences == {}


def test_wall_that_is_a_segment_is_refused() -> None:
    """Task 6.6 is about polygons, and a segment is none."""
    scene = Scene([Body(Segment((0, 0), (1, 0))), Body(Circle(1), mass=1.0)])
    with pytest.raises(ValueError, match="no segments"):
        OwnEngine(home()).simulate(scene, 1.0)


def test_marks_and_first_reason_are_told(solved: Path) -> None:
    """A wrong answer is called all the same, and its line says what is wrong."""
    (solved / "exercises" / "04_circles.ipynb").unlink()
    (solved / "exercises" / "05_spin_and_friction.ipynb").write_text("no notebook")
    half = "def near_pairs(boxes):\n    return []\n"
    notebook = solved / "exercises" / "11_the_small_engine.ipynb"
    notebook.write_text(_notebook_of(half))
    own = own_functions(["11.1", "4.1", "5.4"], solved)
    assert own["near_pairs"].said.startswith("0/3 points. apart in one direction: ")
    assert own["near_pairs"].is_own
    assert "no such file" in own["circle_contact"].said
    assert "is not a notebook" in own["friction_impulse"].said
    with pytest.raises(ValueError, match=r"numbers of tasks, got '99\.1'"):
        own_functions(["99.1"], solved)


def test_near_pairs_of_a_reader_is_timed_where_it_is_written_and_does_not_fail(
    solved: Path,
) -> None:
    """It finds what the three ways find. One that fails is named; a stub is not timed."""
    own = own_functions(["11.1"], solved)["near_pairs"]
    places = near_places.crowd(50)
    found, _ = near_places.own_way(own)["yours"](places, 1.0)
    assert found == near_places.every_pair(places, 1.0)[0]
    failing = replace(own, function=lambda boxes: boxes[99])
    assert near_places.own_way(failing) == {}
    assert "lent: failed with IndexError: index 99 is out of bounds" in failing.line
    stub = own_functions(["11.1"], home())["near_pairs"]
    assert near_places.own_way(stub) == {}
    assert stub.line.endswith("lent: not written yet")


WHOLE_DEPTH = """
def separate(p1, m1, p2, m2, normal, depth):
    return p1 - depth * normal, p2 + depth * normal
"""
"""What section 6 asks the reader to try: both discs move by the whole depth."""


@pytest.mark.full
@pytest.mark.parametrize("is_wrong", [False, True])
def test_notebook_11_runs_with_a_reader_s_exercises(is_wrong: bool, solved: Path) -> None:
    """In a kernel of its own. All solved: nothing is lent, and the three scenes are the lesson's.

    With `separate` as section 6 asks to break it, each scene names it; the notebook runs through.
    """
    if is_wrong:
        exercise = solved / "exercises" / "04_circles.ipynb"
        cells = json.loads(exercise.read_text(encoding="utf-8"))
        cells["cells"] += json.loads(_notebook_of(WHOLE_DEPTH))["cells"]
        exercise.write_text(json.dumps(cells), encoding="utf-8")
    source = home() / "notebooks" / "source" / "11_the_small_engine.py"
    notebook = executed(notebook_from(source), solved / "notebooks")
    told = "\n".join(o.text for c in notebook.cells for o in c.get("outputs", ()) if "text" in o)
    pipeline, _, scenes = told.partition("demo, your ")
    assert pipeline.count("yours: ") == len(OwnEngine(solved).functions) + 1  # near_pairs is timed
    assert "200 bodies, yours" in pipeline
    assert "lent" not in told
    if is_wrong:
        assert "4.3 separate                     yours: 0/4 points" in pipeline
        assert scenes.count("4.3 separate differs first at ") == len(SCENES)
        assert "engine and the lesson's: the same" not in scenes
    else:
        assert scenes.count("engine and the lesson's: the same") == len(SCENES)
        assert scenes.count("no function of yours answered otherwise") == len(SCENES)


def _notebook_of(code: str) -> str:
    """Return a notebook with one cell."""
    cell = {"cell_type": "code", "metadata": {}, "outputs": [], "source": code}
    return json.dumps({"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
