"""Every engine in the comparisons, behind the same two methods."""

from __future__ import annotations

import importlib.util
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.stepper import EngineStepper
from lesson_code.reference.box2d_reference import Box2DStepper
from lesson_code.reference.pymunk_reference import PymunkStepper

Stepper: TypeAlias = EngineStepper | PymunkStepper | Box2DStepper

ITERATIONS = 10
"""Default number of sweeps in a step."""


class Engine(Protocol):
    """An engine that is running a scene."""

    def advance(self, steps: int) -> None:
        """Advance by some steps."""

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""


class ExactStepper:
    """The exact solver, compiled, and asked for its states at the ends of steps."""

    def __init__(self, scene: Scene, dt: float) -> None:
        self._dt, self._steps = dt, 0
        self.solver = ExactSolver(scene, combine=MixingRule(), keep_impulses=False, compiled=True)

    def advance(self, steps: int) -> None:
        """Advance by some steps."""
        self._steps += steps
        self.solver.advance(self._steps * self._dt)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        return np.array(self.solver.states(self._steps * self._dt), dtype=float)


def stepper_for(
    name: str,
    scene: Scene,
    *,
    dt: float,
    iterations: int = ITERATIONS,
    substeps: int = 1,
    **own: Any,
) -> Stepper:
    """Return an engine that makes steps and writes nothing down.

    Box2D's angles are right but for whole turns.

    Parameters
    ----------
    name : str
        "pymunk", "box2d" or one of our solvers that make steps.
    scene : Scene
        The bodies.
    dt, iterations, substeps
        As :func:`lesson_code.simulate` takes them; Box2D has no iterations.
    **own
        Options of this engine alone, such as `slop` for pymunk or `compiled` for ours.

    Raises
    ------
    ValueError
        The engine refuses the scene.
    """
    given: dict[str, Any] = {"dt": dt, "substeps": substeps, "combine": MixingRule(), **own}
    if name == "box2d":
        return Box2DStepper(scene, follow_turns=False, **given)
    given = {"iterations": iterations, "keep_impulses": False} | given
    if name == "pymunk":
        return PymunkStepper(scene, **given)
    return EngineStepper(scene, solver=name, **given)


def has_box2d() -> bool:
    """Return whether Box2D is installed."""
    return importlib.util.find_spec("pyb2d3") is not None
