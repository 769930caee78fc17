"""A scene given to our engine or to pymunk, with an effect in or out."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any, cast

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.effects.choice import OPTIONAL
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.engines import stepper_for
from lesson_code.evidence.scenes.effects import EffectPair
from lesson_code.evidence.scenes.speed import DT
from lesson_code.reference.pymunk_reference import PymunkStepper


def settings_of(pair: EffectPair) -> dict[str, tuple[Scene, dict[str, bool]]]:
    """Return the runs of our engine: for each field of the result, a scene and its effects."""
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
    """Return our engine at the start of a scene, with the requested effects."""
    own: dict[str, Any] = {
        "compiled": compiled,
        "effects": asked,
        "duration": duration,
        "keep_impulses": True,
    }
    return cast(EngineStepper, stepper_for("sequential", scene, dt=DT, **own))


def pymunk_for(pair: EffectPair) -> dict[str, PymunkStepper]:
    """Return pymunk at the start of both scenes of a pair, by the field of the result."""
    made = {"needed": _pymunk(pair.needs), "left_out": _pymunk(pair.spared)}
    if pair.tells_pymunk is not None:
        pair.tells_pymunk(made["needed"].space)
    if pair.effect in OPTIONAL:
        made["switched_off"] = _pymunk(pair.needs)
    return made


def _pymunk(scene: Scene) -> PymunkStepper:
    """Return pymunk at the start of a scene of bodies 1 m wide, with its fastest settings."""
    return cast(PymunkStepper, stepper_for("pymunk", scene, dt=DT, slop=SLOP))
