"""What a simulation leaves behind: the states in time, the impulses, and what follows from them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.impulse_table import ImpulseTable
from lesson_code.engine.core.penetration import deepest_overlaps
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.scene import Scene
from lesson_code.formulas import angular_momentum, kinetic_energy, momentum

Floats: TypeAlias = NDArray[np.float64]
Integers: TypeAlias = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class ImpulseEvents:
    """The impulses of a run, one entry for each contact point and step with an impulse.

    pymunk does not tell the points of a pair apart: its runs have one entry for each pair.

    Attributes
    ----------
    time : ndarray, shape (K,)
        End of the step, s.
    body_a, body_b : ndarray of int, shape (K,)
        The bodies' places in the scene, a < b.
    point : ndarray, shape (K, 2)
        Midway between the two surfaces, m.
    normal : ndarray, shape (K, 2)
        Unit normal from a to b.
    normal_impulse, tangent_impulse : ndarray, shape (K,)
        What b received along the normal, and along the normal turned by +90 degrees, N s; a
        received the opposite.
    penetration : ndarray, shape (K,)
        m, > 0.
    """

    time: Floats
    body_a: Integers
    body_b: Integers
    point: Floats
    normal: Floats
    normal_impulse: Floats
    tangent_impulse: Floats
    penetration: Floats

    def __len__(self) -> int:
        """Return the number of entries."""
        return len(self.time)

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take over what has come from another process, or from a file."""
        self.__dict__.update(_frozen_again(state))


@dataclass(frozen=True, eq=False)
class Run:
    """A scene's states at F times, for N bodies.

    Attributes
    ----------
    scene : Scene
        What was simulated.
    times : ndarray, shape (F,)
        s.
    positions, velocities : ndarray, shape (F, N, 2)
        Of the centres of mass, m and m/s.
    angles, angular_velocities : ndarray, shape (F, N)
        rad and rad/s, counter-clockwise.
    impulses : ImpulseTable
        The impulses as they were written down; `contacts` reads them.
    plan : Plan
        How it was simulated.
    """

    scene: Scene
    times: Floats
    positions: Floats
    velocities: Floats
    angles: Floats
    angular_velocities: Floats
    impulses: ImpulseTable
    plan: Plan

    def __repr__(self) -> str:
        """Return what the run holds, in a line: the arrays would fill pages."""
        bodies, states, impulses = len(self.scene.bodies), len(self.times), len(self.impulses)
        return f"<Run: bodies {bodies}, states {states}, impulses {impulses}; {self.plan.headline}>"

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Take over what has come from another process, or from a file."""
        self.__dict__.update(_frozen_again(state))

    @cached_property
    def contacts(self) -> ImpulseEvents:
        """The impulses in columns."""
        table = self._floats(self.impulses.rows())
        body_a, body_b = table[:, 1].astype(np.int64), table[:, 2].astype(np.int64)
        body_a.setflags(write=False)
        body_b.setflags(write=False)
        return ImpulseEvents(
            time=table[:, 0],
            body_a=body_a,
            body_b=body_b,
            point=table[:, 3:5],
            normal=table[:, 5:7],
            normal_impulse=table[:, 7],
            tangent_impulse=table[:, 8],
            penetration=table[:, 9],
        )

    @cached_property
    def momentum(self) -> Floats:
        """Momentum of all bodies that can be pushed, shape (F, 2), kg m/s."""
        if not self._free:
            return self._floats(np.zeros((len(self.times), 2)))
        return self._floats(momentum(self._masses, self.velocities[:, self._free]))

    @cached_property
    def angular_momentum(self) -> Floats:
        """Angular momentum about the origin, shape (F,), kg m^2/s, counter-clockwise."""
        if not self._free:
            return self._floats(np.zeros(len(self.times)))
        return self._floats(
            angular_momentum(
                self._masses,
                self.positions[:, self._free],
                self.velocities[:, self._free],
                self._inertias,
                self._turning,
            )
        )

    @cached_property
    def kinetic_energy(self) -> Floats:
        """Kinetic energy, spin included, shape (F,), J."""
        if not self._free:
            return self._floats(np.zeros(len(self.times)))
        return self._floats(
            kinetic_energy(
                self._masses, self.velocities[:, self._free], self._inertias, self._turning
            )
        )

    @cached_property
    def energy(self) -> Floats:
        """Kinetic energy and the energy of height, shape (F,), J; 0 at rest at the origin."""
        heights = -self.positions[:, self._free] @ np.array(self.scene.gravity)
        return self._floats(self.kinetic_energy + heights @ self._masses)

    @cached_property
    def max_penetration(self) -> Floats:
        """Depth of the deepest overlap of any two bodies, shape (F,), m; 0 without one.

        It is measured on the states, in the same way for every solver. Two bodies that nothing
        can push may stand in each other; they do not count.
        """
        return self._floats(deepest_overlaps(self.scene, self.positions, self.angles))

    @property
    def _free(self) -> list[int]:
        """The bodies that can be pushed."""
        return [n for n, body in enumerate(self.scene.bodies) if not body.is_static]

    @property
    def _masses(self) -> Floats:
        """Their masses, kg."""
        return np.array([self.scene.bodies[n].mass for n in self._free], dtype=float)

    @property
    def _inertias(self) -> Floats:
        """Their moments of inertia, kg m^2; 0 for those that never turn: they have no spin."""
        inertias = np.array([self.scene.bodies[n].inertia for n in self._free], dtype=float)
        return np.where(np.isinf(inertias), 0.0, inertias)

    @property
    def _turning(self) -> Floats:
        """Their angular velocities, shape (F, n), rad/s."""
        return self.angular_velocities[:, self._free]

    def _floats(self, values: Any) -> Floats:
        """Return an array of floats that nobody can change by accident."""
        array = np.asarray(values, dtype=float)
        array.setflags(write=False)
        return array


def _frozen_again(state: dict[str, Any]) -> dict[str, Any]:
    """Return the fields with their arrays read-only again: pickle loses that flag."""
    for value in state.values():
        if isinstance(value, np.ndarray):
            value.setflags(write=False)
    return state
