"""Ensembles: many independent runs, over the cores of this machine or over a cluster."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, replace
from types import FunctionType
from typing import Any, TypeAlias, TypeVar, overload

from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene, listed
from lesson_code.parallel import map_tasks
from lesson_code.simulation import simulate

M = TypeVar("M")
Options: TypeAlias = Mapping[str, Any]
"""Arguments of :func:`lesson_code.simulate`, by name."""


@overload
def simulate_many(
    scenes: Iterable[Scene],
    duration: float,
    *,
    each: Sequence[Options] | None = None,
    measure: None = None,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
    **options: Any,
) -> list[Run]: ...


@overload
def simulate_many(
    scenes: Iterable[Scene],
    duration: float,
    *,
    each: Sequence[Options] | None = None,
    measure: Callable[[Run], M],
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
    **options: Any,
) -> list[M]: ...


def simulate_many(
    scenes: Iterable[Scene],
    duration: float,
    *,
    each: Sequence[Options] | None = None,
    measure: Callable[[Run], Any] | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
    **options: Any,
) -> list[Any]:
    """Run many scenes, each by itself, on several cores, and return the runs.

    [simulate(scene, duration, **options) for scene in scenes]

    The results are the same to the last bit for any number of workers.

    Parameters
    ----------
    scenes : iterable of Scene
        The scenes. On several cores their callbacks must be functions of a module: data recorded by
        any other callable would stay in the other process.
    duration : float
        s, >= 0.
    each : sequence of dict, optional
        One for each scene: arguments of :func:`lesson_code.simulate` for this scene alone, such as
        ``[{"dt": 1 / 60}, {"dt": 1 / 120}]``; a "duration" among them, too.
    measure : callable, optional
        Takes a Run and returns what is measured. It is called where the run was made, so that of
        thousands of runs only the measurements are kept and sent. By default the runs are returned.
    workers, cluster, progress
        As :func:`lesson_code.parallel.map_tasks` takes them.
    **options
        What :func:`lesson_code.simulate` takes: `solver`, `dt`, `sample` and so on.

    Returns
    -------
    list of Run, or of what `measure` returns
        In the order of the scenes.

    Raises
    ------
    TypeError
        An option is not one of simulate's, a scene is something else, or what is given cannot
        travel to another process.
    ValueError
        `each` is not one for each scene, or an argument is out of range.
    TasksFailedError
        Some of the runs failed. It names them, and holds what the others gave.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene
    >>> balls = [Scene([Body(Circle(1.0), mass=1.0, velocity=(v, 0))]) for v in (1, 2)]
    >>> runs = simulate_many(balls, 3.0, dt=0.5, workers=1)
    >>> [run.positions[-1, 0, 0].item() for run in runs]
    [3.0, 6.0]
    """
    chosen = listed("scenes", scenes)
    own = [{} for _ in chosen] if each is None else list(each)
    if len(own) != len(chosen):
        raise ValueError(f"each must be one for each of {len(chosen)} scenes, got {len(own)}")
    tasks = [
        (scene, {"duration": duration, **options, **others})
        for scene, others in zip(chosen, own, strict=True)
    ]
    for number, (scene, arguments) in enumerate(tasks):
        inspect.signature(simulate).bind(scene, **arguments)
        _require_scene(f"scenes[{number}]", scene, travels=workers != 1 or cluster is not None)
    results = map_tasks(
        functools.partial(_simulated, measure),
        tasks,
        names=[f"scenes[{number}]" for number in range(len(tasks))],
        workers=workers,
        cluster=cluster,
        progress=progress,
    )
    if measure is not None:
        return results
    # Each run has the scene that was given, and not a copy that has travelled there and back.
    return [replace(run, scene=scene) for run, scene in zip(results, chosen, strict=True)]


def _simulated(measure: Callable[[Run], Any] | None, task: tuple[Scene, dict[str, Any]]) -> Any:
    """Do a worker's task: return one run, or its measurement."""
    scene, arguments = task
    run = simulate(scene, **arguments)
    return replace(run, scene=Scene()) if measure is None else measure(run)


def _require_scene(name: str, scene: Scene, *, travels: bool) -> None:
    """Refuse anything but scenes, and callbacks whose effects would be lost."""
    if not isinstance(scene, Scene):
        raise TypeError(f"{name} must be a Scene, got {scene!r}")
    for field in fields(Callbacks):
        callback = getattr(scene.callbacks, field.name)
        if travels and callback is not None and not _is_of_a_module(callback):
            raise TypeError(
                f"{name}: its callback {field.name} must be a function of a module, got "
                f"{callback!r}; what it writes down would stay in another process. Give workers=1"
            )


def _is_of_a_module(callback: object) -> bool:
    """Return whether a callback is a plain function that can be imported."""
    return isinstance(callback, FunctionType) and "<" not in callback.__qualname__
