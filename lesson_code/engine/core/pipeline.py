"""What the stages of a run are: chosen once, before it begins."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple, Protocol, TypeAlias

from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects

Stage: TypeAlias = Callable[[World, Effects], None]
"""A stage changes the world's tables and returns nothing."""

BroadPhase: TypeAlias = Callable[[World], int]
"""Writes the candidate pairs, and returns how many there are."""


class SolverStages(NamedTuple):
    """The stages in which one solver differs from another."""

    prepare: Stage
    warm_start: Stage
    solve: Stage
    has_overlap_to_undo: Callable[[World, Effects], bool]
    correct: Stage
    store: Stage


class Listener(Protocol):
    """Receives the contacts of each step."""

    def before_impulses(self, world: World) -> None:
        """Receive the contacts; may change or remove them."""

    def after_impulses(self, world: World) -> None:
        """Receive the contacts again, now with their impulses."""


class Pipeline(NamedTuple):
    """The stages of a run, and what they reckon with."""

    make_part: Callable[[World, Pipeline], bool]  # a step, or the part of it until an impact
    broad_phase: BroadPhase
    solver: SolverStages
    listener: Listener | None = None
    effects: Effects = EVERY_EFFECT
    splits_steps: bool = True  # whether a step is split at their impacts; else the run stops there


MakePart: TypeAlias = Callable[[World, Pipeline], bool]
"""Makes a step, or the part of it until a fast body has hit something; returns if it is made."""
