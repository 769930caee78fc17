"""How well a scene was simulated: overlaps and energy, measured alike on every engine's states."""

from __future__ import annotations

import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import as_arrays, link, program_of
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.penetration import EVERY_OVERLAP, in_widths, measure_overlaps
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of

Floats = NDArray[np.float64]

ALIKE = 1.25
"""Two qualities count as equal up to this factor. The deepest overlap in a gas is random: it
differs by as much from one batch to the next."""

OVERLAP_LEFT_ALONE = 1.5 * SLOP
"""Of a body's width: every engine here leaves the slop alone, and what is little deeper."""

ENERGY_LEFT_ALONE = {"drift": 1e-3, "left": 1e-5}
"""Smaller errors in energy are ignored. For bodies 1 m wide in a pile, this corresponds to a
residual speed of 0.014 m/s."""

MOST_DRIFT = 0.1
"""A gas that has lost more of its energy is another one: it overlaps less, for it hardly moves."""


@dataclass(frozen=True)
class Quality:
    """How well a scene was simulated; medians over the ends of all batches.

    "drift" is the share by which the energy of a gas has changed. "left" is the kinetic energy in a
    pile, over what would lift it by the smallest width.
    """

    overlap: float  # the deepest, as a share of the smaller body's width
    energy_error: float
    energy_kind: str  # "drift" or "left"


def worse_in(ours: Quality, theirs: Quality) -> tuple[str, ...]:
    """Return in what ours is worse: nothing, "overlap", "energy" or both.

    Examples
    --------
    >>> worse_in(Quality(0.04, 0.01, "drift"), Quality(0.02, 0.01, "drift"))
    ('overlap',)
    """
    is_other_gas = theirs.energy_kind == "drift" and theirs.energy_error > MOST_DRIFT
    overlap_left_alone = math.inf if is_other_gas else OVERLAP_LEFT_ALONE
    energy_left_alone = ENERGY_LEFT_ALONE[ours.energy_kind]
    alike = {
        "overlap": ours.overlap <= max(ALIKE * theirs.overlap, overlap_left_alone),
        "energy": ours.energy_error <= max(ALIKE * theirs.energy_error, energy_left_alone),
    }
    return tuple(name for name, is_alike in alike.items() if not is_alike)


class Reading(NamedTuple):
    """The readings of a gauge in one state."""

    depth: float  # of the deepest overlap, as a share of the smaller body's width
    contacts: int  # points
    energy: float  # J, kinetic


class Gauge:
    """Measures overlaps and energy in the states of one scene.

    It is compiled and keeps its tables, since there may be 100,000 bodies.

    Parameters
    ----------
    scene : Scene
        The bodies, in any state.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        inertias = np.array([body.inertia or 0.0 for body in scene.bodies])
        self._masses = np.array([body.mass or 0.0 for body in scene.bodies])
        self._inertias = np.where(np.isfinite(inertias), inertias, 0.0)
        broad_phase = BROAD_PHASES[broad_phase_for(scene)]
        source = link(
            measure_overlaps, broad_phase=broad_phase, effects=EVERY_OVERLAP, depth=in_widths
        )
        self._world: Any = as_arrays(world_of(scene, 1.0, 0, MixingRule()), source)
        self._measure = compiled(program_of(source, "measure_overlaps", World))

    def read(self, states: Floats) -> Reading:
        """Return what is measured in a state, shape (N, 6)."""
        bodies = self._world.bodies
        bodies["x"], bodies["y"], bodies["angle"] = states[:, 0], states[:, 1], states[:, 2]
        bodies["vx"] = bodies["vy"] = 0.0  # no margins are needed
        while (depth := float(self._measure(self._world))) < 0.0:
            self._world = add_capacity(self._world)
        return Reading(depth, int(self._world.state.contact_count), self.energy(states))

    def energy(self, states: Floats) -> float:
        """Return the kinetic energy of all bodies that can be pushed, J."""
        vx, vy, w = states[:, 3], states[:, 4], states[:, 5]
        return float((self._masses * (vx * vx + vy * vy) + self._inertias * w * w).sum() / 2)

    def quality(self, readings: Sequence[Reading]) -> Quality:
        """Return a quality: a gas must keep its energy, a pile must have none of motion."""
        overlap = statistics.median(reading.depth for reading in readings)
        lift = energy_to_lift(self.scene)
        if lift == 0.0:
            began = self.energy(states_of(self.scene))
            return Quality(overlap, abs(readings[-1].energy / began - 1), "drift")
        left = statistics.median(reading.energy for reading in readings)
        return Quality(overlap, left / lift, "left")


def energy_to_lift(scene: Scene) -> float:
    """Return the energy to lift all bodies by the smallest width, J; 0 without gravity."""
    smallest = min(body.shape.min_width for body in scene.bodies if not body.is_static)
    mass = sum(body.mass or 0.0 for body in scene.bodies)
    return mass * float(np.hypot(*scene.gravity)) * smallest


def states_of(scene: Scene) -> Floats:
    """Return the initial state of a scene, shape (N, 6)."""
    rows = [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in scene.bodies]
    return np.array(rows, dtype=float)
