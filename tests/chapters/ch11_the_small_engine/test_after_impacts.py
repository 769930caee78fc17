"""Light and sound of a run, by a reader's functions and by those that are lent."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, simulate
from lesson_code.chapters.ch11_the_small_engine import after_impacts, near_places
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.own import OwnFunction


@pytest.fixture(scope="module")
def drop() -> Run:
    """Return a ball that falls from 1 m, bounces once or twice and then lies on the floor."""
    clay = Material(restitution=0.3)
    floor = Body(Polygon.box(4, 1), position=(0, -0.5), material=clay)
    ball = Body(Circle(0.2), mass=2.0, position=(0, 1.2), material=clay)
    return simulate(Scene([floor, ball], gravity=(0, -9.81)), 2.0, solver="direct")


def written(name: str, **functions: Any) -> dict[str, OwnFunction]:
    """Return the three functions; those that are given are the reader's."""
    tasks = {task.function: task for task in map(task_by_id, after_impacts.TASKS)}
    return {n: OwnFunction(task, functions.get(n), name) for n, task in tasks.items()}


RIGHT = {task.function: task.expected for task in map(task_by_id, after_impacts.TASKS)}


@pytest.mark.parametrize("functions", [{}, RIGHT], ids=["lent", "yours"])
def test_ball_that_lies_there_touches_for_long_and_begins_seldom(
    functions: dict[str, Any], drop: Run
) -> None:
    """It begins to touch at each bounce, the first time after sqrt(2 h / g) = 0.4515 s."""
    own = written("", **functions)
    begun = after_impacts.begun(drop, own["touch_changes"])
    first = next(frame for frame, pairs in enumerate(begun) if pairs)
    assert drop.times[first] == pytest.approx(0.4515, abs=1 / 60)
    assert {pair for pairs in begun for pair in pairs} == {(0, 1)}
    in_touch = sum(map(len, after_impacts.touches(drop)))
    assert sum(map(len, begun)) < 12 < 60 < in_touch


@pytest.mark.parametrize("functions", [{}, RIGHT], ids=["lent", "yours"])
def test_light_goes_on_at_the_impact_and_then_fades(functions: dict[str, Any], drop: Run) -> None:
    """Dark before, 1 at the impact, and less from frame to frame until the next."""
    light = after_impacts.light(drop, written("", **functions))
    first = int(np.argmax(light[:, 1]))
    assert light.shape == (len(drop.times), 2)
    assert np.all(light[:first] == 0)
    assert light[first].tolist() == [1, 1]
    assert 0 < light[first + 2, 1] < light[first + 1, 1] < 1
    assert light[-1, 1] < 0.1


@pytest.mark.parametrize("functions", [{}, RIGHT], ids=["lent", "yours"])
def test_sound_begins_with_the_impact_and_is_never_too_loud(
    functions: dict[str, Any], drop: Run
) -> None:
    """Silence while the ball falls; then, within [-1, 1], a sound."""
    heard = after_impacts.sound(drop, written("", **functions))
    begins = int(np.flatnonzero(heard)[0]) / after_impacts.RATE
    assert begins == pytest.approx(0.4515, abs=1 / 60)
    assert 0.05 < np.abs(heard).max() <= 1


def test_loudness_is_that_of_the_impulse(drop: Run) -> None:
    """The first blow, m (1 + e) v = 2 * 1.3 * 4.43 = 11.5 N s of the 20 that are loudest."""
    own = written("", **RIGHT)
    begun = after_impacts.begun(drop, own["touch_changes"])
    first = next(frame for frame, pairs in enumerate(begun) if pairs)
    loudness = after_impacts._loudness(drop, float(drop.times[first]), (0, 1))
    assert loudness == pytest.approx(2 * 1.3 * np.sqrt(2 * 9.81) / after_impacts.LOUD, rel=0.05)


@pytest.mark.parametrize("seed", range(5))
def test_all_ways_find_the_pairs_that_numpy_finds(seed: int) -> None:
    """A table of all differences, also for places on the borders of cells."""
    places = [*near_places.crowd(60, seed), (0.0, 0.0), (1.0, 0.0), (-1.0, 2.0), (3.0, 3.0)]
    table = np.array(places)
    near = np.all(np.abs(table[:, None] - table) <= 1.0, axis=2)
    expected = {(int(i), int(j)) for i, j in np.argwhere(np.triu(near, k=1))}
    for way in near_places.WAYS.values():
        assert way(places, 1.0)[0] == expected
