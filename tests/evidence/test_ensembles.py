"""Many runs at once: the runs of a loop, bit for bit, and refusals."""

from __future__ import annotations

import functools
import pickle
from dataclasses import fields
from typing import Any

import pytest

from lesson_code import Body, Callbacks, Circle, Run, Scene, simulate, simulate_many
from lesson_code.engine.core.run import ImpulseEvents
from lesson_code.evidence import ensembles
from lesson_code.evidence.scenes import discs as disc_scenes
from lesson_code.evidence.scenes import gas as disc_gas
from lesson_code.parallel import TasksFailedError

STATES = ("times", "positions", "velocities", "angles", "angular_velocities")


def gases() -> list[Scene]:
    """Return three gases that differ in their velocities."""
    return [disc_gas.disc_gas(3, 0.4, seed=seed) for seed in range(3)]


def bits(run: Run) -> list[bytes]:
    """Return every number that a run holds, as bytes."""
    impulses = [getattr(run.contacts, field.name) for field in fields(ImpulseEvents)]
    return [array.tobytes() for array in [*(getattr(run, name) for name in STATES), *impulses]]


@pytest.mark.parametrize("workers", [1, 2])
@pytest.mark.parametrize("solver", ["exact", "sequential"])
def test_runs_are_those_of_a_loop_to_the_last_bit(solver: str, workers: int) -> None:
    """States, impulses and plan are the same; the scene is the very one that was given."""
    scenes = gases()
    runs = simulate_many(scenes, 0.5, solver=solver, workers=workers)
    for scene, run in zip(scenes, runs, strict=True):
        alone = simulate(scene, 0.5, solver=solver)
        assert bits(run) == bits(alone)
        assert run.plan == alone.plan
        assert run.scene is scene
        assert run.energy.tobytes() == alone.energy.tobytes()


def test_each_scene_may_have_arguments_of_its_own() -> None:
    """They go before those of all, the duration among them."""
    scenes = [disc_scenes.rack_break(0.9)] * 3
    runs = simulate_many(scenes, 0.2, dt=0.1, each=[{}, {"dt": 0.05}, {"duration": 0.3}], workers=2)
    assert [len(run.times) for run in runs] == [3, 5, 4]


def test_measure_is_taken_where_the_run_was_made() -> None:
    """Only what it returns comes back."""
    measured = simulate_many(gases(), 0.5, solver="exact", measure=disc_gas.hits_a_disc, workers=2)
    expected = [disc_gas.hits_a_disc(simulate(scene, 0.5, solver="exact")) for scene in gases()]
    assert measured == expected


def test_no_scenes_have_no_runs() -> None:
    """An empty ensemble is one."""
    assert simulate_many([], 1.0) == []


@pytest.mark.parametrize("workers", [1, 2])
def test_run_that_fails_is_named_and_the_others_are_not_lost(workers: int) -> None:
    """The discs of the second scene fly beyond the range of floating point."""
    box = Scene([Body(Circle(1.0), mass=1.0, velocity=(1e308, 0)) for _ in range(2)])
    scenes = [gases()[0], box]
    with pytest.raises(TasksFailedError, match=r"^1 of 2 tasks failed: scenes\[1\]: ") as caught:
        simulate_many(scenes, 1.0, each=[{}, {"duration": 1e10}], dt=1e9, workers=workers)
    assert isinstance(caught.value.results[0], Run)


# What travels


def test_run_that_has_travelled_is_as_it_was_and_cannot_be_changed() -> None:
    """Pickle forgets that an array is not to be written to; a run remembers."""
    run = simulate(gases()[0], 0.5)
    run.energy  # noqa: B018 - worked out before it travels
    there: Run = pickle.loads(pickle.dumps(run))  # noqa: S301 - our own bytes
    assert bits(there) == bits(run)
    assert there.scene == run.scene
    for array in (there.positions, there.contacts.normal_impulse, there.energy):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def heavier(touch: Any) -> None:
    """Make a contact elastic: a callback that can be imported by its name."""
    touch.restitution = 1.0


def with_callback(callback: Any) -> Scene:
    """Return two discs that meet, and somebody who is told of it."""
    ball = functools.partial(Body, Circle(1.0), mass=1.0)
    discs = [ball(velocity=(1, 0)), ball(position=(2.5, 0))]
    return Scene(discs, callbacks=Callbacks(post_solve=callback))


def test_callback_that_writes_down_is_refused_where_it_would_do_so_in_vain() -> None:
    """A list that is filled in another process stays empty here; in this process it is filled."""
    heard: list[Any] = []
    for callback in (heard.append, lambda touch: heard.append(touch)):
        scene = with_callback(callback)
        with pytest.raises(TypeError, match=r"^scenes\[0\]: its callback post_solve must be"):
            simulate_many([scene], 1.0)
        simulate_many([scene], 1.0, workers=1)
        assert heard
        heard.clear()


def test_callback_of_a_module_travels() -> None:
    """What it sets is set in the other process, too."""
    scenes = [with_callback(disc_gas.hits_a_disc)] * 2
    with pytest.raises(TasksFailedError, match="AttributeError: 'Touch' object has no"):
        simulate_many(scenes, 1.0, workers=2)
    assert ensembles._is_of_a_module(heavier)


# Refusals


def test_each_that_is_not_one_for_each_scene_is_refused() -> None:
    """The error counts both."""
    with pytest.raises(ValueError, match="each must be one for each of 3 scenes, got 1"):
        simulate_many(gases(), 1.0, each=[{}])


@pytest.mark.parametrize(
    "options", [{"speed": 3}, {"each": [{"speed": 3}, {}, {}]}], ids=["all", "one"]
)
def test_option_that_simulate_does_not_know_is_refused_before_anything_runs(options: Any) -> None:
    """A slip of the pen is not found out by an hour of runs that fail."""
    with pytest.raises(TypeError, match="unexpected keyword argument 'speed'"):
        simulate_many(gases(), 1.0, **options)


def test_what_is_no_scene_is_refused_by_its_place() -> None:
    """The error names the scene and shows what was given; so it does of a single scene."""
    with pytest.raises(TypeError, match=r"scenes must be a list or tuple, got Scene"):
        simulate_many(gases()[0], 1.0)  # type: ignore[call-overload]
    with pytest.raises(TypeError, match=r"scenes\[1\] must be a Scene, got 3"):
        simulate_many([Scene(), 3], 1.0, workers=2)  # type: ignore[list-item]
