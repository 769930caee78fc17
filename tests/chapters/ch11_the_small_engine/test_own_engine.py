"""The small engine with a reader's functions: who does what, and what is wrong with it."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Scene, Segment
from lesson_code.chapters.ch11_the_small_engine.own_engine import OwnEngine
from lesson_code.chapters.ch11_the_small_engine.scenes import demo
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.own import own_functions
from lesson_code.course.notebooks.root import home
from lesson_code.engine.small_engine import simulate_small

ROUNDING = 1e-9
"""m after 3 s: 1e-13 of two ways to compute the same, which some forty hits make larger."""

SECONDS = 3.0


@pytest.fixture(scope="module")
def solved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a workbook whose exercises are all solved."""
    root = tmp_path_factory.mktemp("solved")
    (root / "notebooks").mkdir()
    shutil.copy(home() / "notebooks" / "00_start_here.ipynb", root / "notebooks")
    copied = shutil.ignore_patterns("source")
    shutil.copytree(home() / "solutions", root / "exercises", ignore=copied)
    return root


def with_function(engine: OwnEngine, name: str, function: Callable[..., Any]) -> OwnEngine:
    """Return an engine with another function in the place of one."""
    engine.functions[name] = replace(engine.functions[name], function=function)
    return engine


def test_functions_that_are_not_written_are_lent_and_named() -> None:
    """The workbook's own exercises hold stubs: all is lent, and the run is the small engine's."""
    engine = OwnEngine(home())
    lines = str(engine).splitlines()
    assert len(lines) == len(engine.functions)
    assert all("lent: not written yet" in line for line in lines)
    run, ours = engine.simulate(demo(), SECONDS), simulate_small(demo(), SECONDS)
    np.testing.assert_allclose(run.positions, ours.positions, atol=ROUNDING)
    assert engine.differences == {}


def test_solved_exercises_run_the_demo_as_the_small_engine_does(solved: Path) -> None:
    """Functions with other signatures and other code: the same paths but for rounding."""
    engine = OwnEngine(solved)
    assert all(own.is_own for own in engine.functions.values())
    run, ours = engine.simulate(demo(), SECONDS), simulate_small(demo(), SECONDS)
    np.testing.assert_allclose(run.positions, ours.positions, atol=ROUNDING)
    np.testing.assert_allclose(run.angles, ours.angles, atol=ROUNDING)
    assert engine.differences == {}
    assert all(own.is_own for own in engine.functions.values())


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
    assert engine.differences[task.function] in str(engine)
    apart = np.abs(run.positions - simulate_small(demo(), SECONDS).positions)
    assert np.isnan(apart.max()) or apart.max() > 1e-3


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


def test_wall_without_thickness_is_refused() -> None:
    """Task 6.6 is about polygons, and a line is none."""
    scene = Scene([Body(Segment((0, 0), (1, 0))), Body(Circle(1), mass=1.0)])
    with pytest.raises(ValueError, match="no segment of radius 0"):
        OwnEngine(home()).simulate(scene, 1.0)


def test_marks_and_first_reason_are_told(tmp_path: Path, solved: Path) -> None:
    """A wrong answer is called all the same, and its line says what is wrong."""
    shutil.copytree(solved, tmp_path, dirs_exist_ok=True)
    (tmp_path / "exercises" / "04_circles.ipynb").unlink()
    (tmp_path / "exercises" / "05_spin_and_friction.ipynb").write_text("no notebook")
    half = "def near_pairs(boxes):\n    return []\n"
    notebook = tmp_path / "exercises" / "11_the_small_engine.ipynb"
    notebook.write_text(_notebook_of(half))
    own = own_functions(["11.1", "4.1", "5.4"], tmp_path)
    assert own["near_pairs"].said.startswith("0/3 points. apart in one direction: ")
    assert own["near_pairs"].is_own
    assert "no such file" in own["circle_contact"].said
    assert "is not a notebook" in own["friction_impulse"].said
    with pytest.raises(ValueError, match=r"numbers of tasks, got '99\.1'"):
        own_functions(["99.1"], tmp_path)


def _notebook_of(code: str) -> str:
    """Return a notebook with one cell."""
    cell = {"cell_type": "code", "metadata": {}, "outputs": [], "source": code}
    return json.dumps({"cells": [cell], "metadata": {}, "nbformat": 4, "nbformat_minor": 5})
