"""A free stack of 20 for a minute: what each engine needs so that it stands, and the time of that.

More iterations, or more sub-steps, carry the load further down. For each engine the fewest of a
short list are looked for with which the stack stands to the end; these are timed, in turns.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.scene import Scene
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.engines import Engine, builder, engines_for
from lesson_code.evidence.speed.quality import states_of
from lesson_code.evidence.speed_scenes import stack

BOXES, SECONDS = 20, 60.0

ITERATIONS = (8, 10, 12, 15, 20, 25, 30, 40, 60)
SUBSTEPS = (2, 3, 4, 5, 6, 8, 12, 16)
"""What is tried, the cheapest first."""

LEANS = 0.5
"""Of a box's width: no box may be further from its place than that."""


@dataclass(frozen=True)
class Standing:
    """What one engine needs for a stack that stands.

    Attributes
    ----------
    engine : str
        Its name.
    setting : int
        Iterations, for "substep" sub-steps; the most that were tried if the stack fell with all.
    stood : bool
        Whether the stack stood to the end.
    seconds : float
        For all steps: median.
    """

    engine: str
    setting: int
    stood: bool
    seconds: float


@dataclass
class _Trial:
    """An engine with the setting that is timed."""

    engine: str
    setting: int
    stood: bool
    seconds: list[float] = field(default_factory=list)


def measure_standing(
    repeats: int,
    boxes: int = BOXES,
    duration: float = SECONDS,
    told: Callable[[str], None] = lambda _: None,
) -> tuple[Standing, ...]:
    """Return for each engine what lets a stack stand for a while, and how long that takes.

    Parameters
    ----------
    repeats : int
        How often each is timed, >= 1.
    boxes : int
        Of the stack.
    duration : float
        s, simulated.
    told : callable
        Hears what is being done.
    """
    trials = []
    for name in engines_for(stack(boxes)):
        told(f"stack of {boxes}: what lets {name} stand")
        trials.append(_least(name, boxes, duration))
    for repeat in range(repeats):
        told(f"stack of {boxes} for {duration:g} s: {repeat + 1} of {repeats}")
        for trial in trials:
            trial.seconds.append(_run(trial.engine, trial.setting, boxes, duration)[1])
    return tuple(
        Standing(t.engine, t.setting, t.stood, statistics.median(t.seconds)) for t in trials
    )


def stands(scene: Scene, states: NDArray[np.float64]) -> bool:
    """Return whether every body is still near its place.

    >>> from lesson_code.evidence.speed_scenes import stack
    >>> scene = stack(3).scene
    >>> stands(scene, states_of(scene))
    True
    """
    moved = np.abs(states[:, :2] - states_of(scene)[:, :2])
    widths = np.array([body.shape.extent for body in scene.bodies])
    return bool((moved.max(axis=1) < LEANS * widths).all())


def _least(name: str, boxes: int, duration: float) -> _Trial:
    """Return an engine with the cheapest setting with which the stack stands."""
    settings = SUBSTEPS if name == "substep" else ITERATIONS
    for setting in settings:
        if _run(name, setting, boxes, duration)[0]:
            return _Trial(name, setting, stood=True)
    return _Trial(name, settings[-1], stood=False)


def _run(name: str, setting: int, boxes: int, duration: float) -> tuple[bool, float]:
    """Return whether a stack stands, and the time that the steps take, s."""
    speed_scene = stack(boxes)
    engine = _built(name, setting, boxes)
    engine.advance(1)  # loads or compiles the program
    steps = round(duration / speed_scene.dt) - 1
    start = worked_seconds()
    engine.advance(steps)
    seconds = worked_seconds() - start
    return stands(speed_scene.scene, engine.states()), seconds


def _built(name: str, setting: int, boxes: int) -> Engine:
    """Return an engine with its iterations or sub-steps."""
    if name == "substep":
        return builder(name, stack(boxes), substeps=setting)()
    return builder(name, stack(boxes), iterations=setting)()
