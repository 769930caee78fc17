"""The engines, all behind the same few methods, and none writing down impulses.

==============  =========================================================================
name            what runs
==============  =========================================================================
sequential      our sequential impulses, compiled, 10 iterations
substep         our soft contacts, compiled, 4 sub-steps
exact           from collision to collision, where that solver takes the scene
pymunk, tree    pymunk, 10 iterations, with our slop; pairs from its tree of boxes
pymunk, hash    the same; pairs from its grid
box2d           Box2D, 8 velocity and 3 position iterations: its manual's advice
==============  =========================================================================
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from typing import Any, Literal, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.core.mixing import Combination
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.event_driven.solver import why_not
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.speed import SpeedScene
from lesson_code.reference.pymunk_reference import PymunkStepper

OURS = ("sequential", "substep", "exact")
PYMUNK = ("pymunk, tree", "pymunk, hash")
PEERS = ("pymunk", "box2d")

ITERATIONS = 10
"""Of the sequential solvers, ours and pymunk's."""

SUBSTEPS = 4
"""Of our soft solver, with one sweep each."""

BOX2D_ITERATIONS = (8, 3)
"""For velocities and for positions: what Box2D's manual advises."""


class Engine(Protocol):
    """An engine at work on a scene."""

    def advance(self, steps: int) -> None:
        """Advance by so many steps."""

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""


Build: TypeAlias = Callable[[], Engine]


class ExactStepper:
    """The exact solver, asked for its states at the ends of steps."""

    def __init__(self, scene: Scene, dt: float) -> None:
        self._dt, self._steps = dt, 0
        self.solver = ExactSolver(scene, combine=Combination(), keep_impulses=False, compiled=True)

    def advance(self, steps: int) -> None:
        """Advance by so many steps."""
        self._steps += steps
        self.solver.advance(self._steps * self._dt)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        return np.array(self.solver.states(self._steps * self._dt), dtype=float)


def engines_for(speed_scene: SpeedScene) -> dict[str, Build]:
    """Return the engines that can take a scene, ours first; each is built when it is called."""
    scene = speed_scene.scene
    names = ["sequential", "substep"]
    if not any(scene.gravity) and not why_not(scene):
        names.append("exact")
    names += PYMUNK
    if importlib.util.find_spec("Box2D") is not None:
        names.append("box2d")
    return {name: builder(name, speed_scene) for name in names}


def builder(
    name: str,
    speed_scene: SpeedScene,
    *,
    iterations: int | None = None,
    substeps: int = SUBSTEPS,
) -> Build:
    """Return what builds an engine: by name, perhaps with other iterations or sub-steps."""
    scene, dt = speed_scene.scene, speed_scene.dt
    settings: dict[str, Any] = {"dt": dt, "combine": Combination(), "keep_impulses": False}
    sweeps = ITERATIONS if iterations is None else iterations
    ways: dict[str, Literal["tree", "hash"]] = {PYMUNK[0]: "tree", PYMUNK[1]: "hash"}

    def build() -> Engine:
        if name == "exact":
            return ExactStepper(scene, dt)
        if name == "box2d":
            return _box2d(scene, settings, iterations)
        if name in ways:
            return PymunkStepper(
                scene,
                iterations=sweeps,
                substeps=1,
                broad_phase=ways[name],
                slop=speed_scene.slop,
                **settings,
            )
        counts = (1, substeps) if name == "substep" else (sweeps, 1)
        settings["iterations"], settings["substeps"] = counts
        return EngineStepper(scene, solver=name, compiled=True, **settings)

    return build


def refuse_without_compiler() -> None:
    """Raise a RuntimeError where our stages cannot be compiled: there is nothing to compare."""
    reason = why_no_compiler()
    if reason:
        raise RuntimeError(f"speed can be measured only with compiled code: {reason}")


def let_go(engine: Engine) -> None:
    """Prepare an engine for being thrown away, which may take long otherwise."""
    if isinstance(engine, PymunkStepper):
        engine.forget_contacts()


def bytes_of(engine: Engine) -> int | None:
    """Return how large all tables of one of our engines are; None where they are no arrays."""
    if isinstance(engine, EngineStepper):
        return sum(np.asarray(table).nbytes for table in engine.world)
    return None


def _box2d(scene: Scene, settings: dict[str, Any], iterations: int | None) -> Engine:
    """Return Box2D at work on a scene."""
    from lesson_code.reference.box2d_reference import Box2DStepper

    velocity, position = BOX2D_ITERATIONS
    return Box2DStepper(
        scene,
        iterations=velocity if iterations is None else iterations,
        substeps=1,
        position_iterations=position,
        **settings,
    )
