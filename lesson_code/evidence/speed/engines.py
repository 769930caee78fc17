"""The engines as they race.

==============  =========================================================================
name            what runs
==============  =========================================================================
sequential      our sequential impulses, compiled, 10 iterations
substep         our soft contacts, compiled, 4 sub-steps with one sweep each
exact           from collision to collision, where that solver takes the scene
pymunk, tree    pymunk, 10 iterations, with our slop; pairs from its tree of boxes
pymunk, hash    the same; pairs from its grid
box2d           Box2D, 4 sub-steps: its manual's advice
==============  =========================================================================
"""

from __future__ import annotations

from typing import Any

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.event_driven.solver import why_not
from lesson_code.evidence.engines import ITERATIONS, Engine, ExactStepper, has_box2d, stepper_for
from lesson_code.evidence.scenes.speed import SpeedScene

OURS = ("sequential", "substep", "exact")
PYMUNK = ("pymunk, tree", "pymunk, hash")
PEERS = ("pymunk", "box2d")

SETTINGS = {"substep": 4, "box2d": 4}
"""Sub-steps of our soft solver, and of Box2D; of all others 10 iterations."""


def engines_for(speed_scene: SpeedScene) -> list[str]:
    """Return the engines that can take a scene, ours first."""
    scene = speed_scene.scene
    is_exact = not any(scene.gravity) and not why_not(scene)
    return [
        *("sequential", "substep"),
        *(["exact"] if is_exact else []),
        *PYMUNK,
        *(["box2d"] if has_box2d() else []),
    ]


def start(name: str, speed_scene: SpeedScene, setting: int | None = None) -> Engine:
    """Return an engine at the start of a scene, perhaps with other iterations, or sub-steps."""
    scene, dt = speed_scene.scene, speed_scene.dt
    count = setting or SETTINGS.get(name, ITERATIONS)
    if name == "exact":
        return ExactStepper(scene, dt)
    if name in PYMUNK:
        way: dict[str, Any] = {"broad_phase": name.split()[1], "slop": speed_scene.slop}
        return stepper_for("pymunk", scene, dt=dt, iterations=count, **way)
    if name == "box2d":
        return stepper_for(name, scene, dt=dt, substeps=count)
    if name == "substep":
        return stepper_for(name, scene, dt=dt, iterations=1, substeps=count, compiled=True)
    return stepper_for(name, scene, dt=dt, iterations=count, compiled=True)


def refuse_without_compiler() -> None:
    """Raise a RuntimeError where our stages cannot be compiled: there is nothing to compare."""
    reason = why_no_compiler()
    if reason:
        raise RuntimeError(f"speed can be measured only with compiled code: {reason}")
