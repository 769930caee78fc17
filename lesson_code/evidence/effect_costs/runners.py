"""A scene given to our engine or to pymunk, with an effect in or out."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.mixing import Combination
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.effects.choice import OPTIONAL
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.effects import EffectPair
from lesson_code.evidence.scenes.speed import DT
from lesson_code.evidence.speed.clock import worked_seconds
from lesson_code.evidence.speed.engines import ITERATIONS, Engine
from lesson_code.reference.pymunk_reference import PymunkStepper


@dataclass
class Runner:
    """An engine at work, and the times of its batches so far, s a step."""

    engine: Engine
    steps: int = 1
    seconds: list[float] = field(default_factory=list)

    def run_batch(self) -> float:
        """Make a batch of steps, and return the time of one, s."""
        start = worked_seconds()
        self.engine.advance(self.steps)
        self.seconds.append((worked_seconds() - start) / self.steps)
        return self.seconds[-1]

    def fit_batch(self, seconds: float, most: int) -> None:
        """Choose how many steps a batch has: about so long, and no more than so many."""
        while self.run_batch() * self.steps < seconds / 2 and self.steps < most:
            self.steps = min(most, 2 * self.steps)
        self.seconds.clear()


def settings_of(pair: EffectPair) -> dict[str, tuple[Scene, dict[str, bool]]]:
    """Return what our engine is to run: by the field of the result, a scene and what is asked."""
    effect, along = pair.effect, dict(pair.along)
    asked: dict[str, tuple[Scene, dict[str, bool]]] = {
        "needed": (pair.needs, along),
        "left_out": (pair.spared, along),
        "forced": (pair.spared, {**along, effect: True}),
    }
    if effect in OPTIONAL:
        asked["switched_off"] = (pair.needs, {**along, effect: False})
    if effect == "impulse_record":  # every scene calls for it
        asked["left_out"] = (pair.spared, {**along, effect: False})
    return asked


def ours(
    scene: Scene, asked: Mapping[str, bool], *, compiled: bool, duration: float = math.inf
) -> EngineStepper:
    """Return our engine at work on a scene, with effects as they are asked for."""
    return EngineStepper(
        scene,
        solver="sequential",
        dt=DT,
        iterations=ITERATIONS,
        substeps=1,
        combine=Combination(),
        compiled=compiled,
        effects=asked,
        duration=duration,
    )


def pymunk_for(pair: EffectPair) -> dict[str, PymunkStepper]:
    """Return pymunk at work on the scenes of a pair, by the field of the result."""
    made = {"needed": _pymunk(pair.needs), "left_out": _pymunk(pair.spared)}
    if pair.tells_pymunk is not None:
        pair.tells_pymunk(made["needed"].space)
    if pair.effect in OPTIONAL:
        made["switched_off"] = _pymunk(pair.needs)
    return made


def _pymunk(scene: Scene) -> PymunkStepper:
    """Return pymunk at work on a scene, as fast as it can."""
    return PymunkStepper(
        scene,
        dt=DT,
        iterations=ITERATIONS,
        substeps=1,
        combine=Combination(),
        keep_impulses=False,
        slop=SLOP,  # the bodies are 1 m wide
    )
