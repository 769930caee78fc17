"""What can be told of bodies as they are: momenta and energy, each found once."""

from __future__ import annotations

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.scene import XY
from lesson_code.formulas import angular_momentum, kinetic_energy, momentum


class Matter:
    """Bodies that can be pushed, at one moment.

    Parameters
    ----------
    states : ndarray, shape (N, 6)
        x, y, angle, vx, vy, w of each; read them only.
    mass, inertia : ndarray, shape (N,)
        kg and kg m^2.

    Examples
    --------
    >>> states = np.array([[0.0, 3.0, 0.0, 2.0, 0.0, 1.0]])
    >>> one = Matter(states, mass=np.array([5.0]), inertia=np.array([4.0]))
    >>> one.momentum, one.angular_momentum, one.motion, one.kinetic_energy
    ((10.0, 0.0), -26.0, 10.0, 12.0)
    """

    def __init__(
        self,
        states: NDArray[np.float64],
        mass: NDArray[np.float64],
        inertia: NDArray[np.float64],
    ) -> None:
        self.states, self.mass, self.inertia = states, mass, inertia
        self.places, self.velocities, self.spins = states[:, 0:2], states[:, 3:5], states[:, 5]

    @cached_property
    def momentum(self) -> XY:
        """Their total momentum, kg m/s."""
        x, y = momentum(self.mass, self.velocities) if len(self.mass) else (0.0, 0.0)
        return float(x), float(y)

    @cached_property
    def angular_momentum(self) -> float:
        """Their total angular momentum about the origin, kg m^2/s."""
        if not len(self.mass):
            return 0.0
        turning = self.inertia, self.spins
        return float(angular_momentum(self.mass, self.places, self.velocities, *turning))

    @cached_property
    def motion(self) -> float:
        """Their kinetic energy without that of spin, J."""
        return float(kinetic_energy(self.mass, self.velocities)) if len(self.mass) else 0.0

    @cached_property
    def kinetic_energy(self) -> float:
        """Their kinetic energy, that of spin included, J."""
        if not len(self.mass):
            return 0.0
        return float(kinetic_energy(self.mass, self.velocities, self.inertia, self.spins))
