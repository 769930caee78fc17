"""Many discs at once: the checks of one body, made of whole arrays.

The values are those that the same discs would have if they were made one by one, to the last bit,
and an error names the argument and the place in it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.formulas.rigid_body import disc_inertia
from lesson_code.formulas.validation import (
    Number,
    Vector,
    equation,
    finite,
    moment_of_inertia,
    positive,
    vector,
)
from lesson_code.formulas.validation import mass as mass_rule
from lesson_code.geometry.shapes import Circle

Floats: TypeAlias = NDArray[np.float64]

_disc_inertia = equation(disc_inertia)


def disc_values(
    positions: Vector,
    velocities: Vector,
    *,
    radius: Number,
    mass: Number | None,
    angle: Number,
    angular_velocity: Number,
    inertia: Number | None,
) -> dict[str, Iterable[Any]]:
    """Return the values of N discs by the names that a body has for them, each N long.

    Parameters
    ----------
    positions : array_like, shape (N, 2)
        m.
    velocities : array_like, shape (2,) or (N, 2)
        m/s.
    radius, mass, angle, angular_velocity, inertia : float or array_like, shape (N,)
        As a body has them; mass and inertia may be None.

    Raises
    ------
    ValueError
        A number is out of range, or an array does not have a value for each disc.
    TypeError
        Something is no number.

    Examples
    --------
    >>> values = disc_values([(0, 0), (3, 0)], (0, 0), radius=1.0, mass=[2.0, math.inf],
    ...                      angle=0.0, angular_velocity=0.0, inertia=None)
    >>> values["mass"], values["inertia"]
    ([2.0, None], [1.0, None])
    """
    places = vector("positions", positions)
    if places.ndim != 2:
        raise ValueError(f"positions must have shape (N, 2), got shape {places.shape}")
    count = len(places)
    radii = _for_each("radius", positive("radius", radius), count)
    masses = _masses(mass, count)
    is_static = np.isinf(masses)
    spins = finite("angular_velocity", angular_velocity)
    return {
        "shape": _circles(radii.tolist()),
        "position": _tuples(places),
        "angle": _for_each("angle", finite("angle", angle), count).tolist(),
        "velocity": _tuples(_for_each("velocities", vector("velocities", velocities), count, 2)),
        "angular_velocity": _for_each("angular_velocity", spins, count).tolist(),
        "mass": _unless(is_static, masses),
        "inertia": _unless(is_static, _inertias(inertia, masses, radii)),
    }


def _for_each(name: str, checked: Any, count: int, *components: int) -> Floats:
    """Return one value, or one for each of N discs, as an array with N rows."""
    array, shape = np.asarray(checked, dtype=float), (count, *components)
    if array.shape not in (shape, components):
        raise ValueError(
            f"{name} must have shape {components} or, with a value for each disc, {shape}, "
            f"got shape {array.shape}"
        )
    return np.broadcast_to(array, shape)


def _masses(mass: Number | None, count: int) -> Floats:
    """Return N masses, kg; infinite for a disc that nothing can push."""
    return _for_each("mass", math.inf if mass is None else mass_rule("mass", mass), count)


def _inertias(inertia: Number | None, masses: Floats, radii: Floats) -> Floats:
    """Return N moments of inertia, kg m^2: those given, or those of filled discs."""
    if inertia is not None and (static := np.flatnonzero(np.isinf(masses))).size:
        raise ValueError(
            "inertia must be left out of a body without a mass, "
            f"got one for the disc at index {static[0]}"
        )
    with np.errstate(over="ignore"):
        given = masses * _disc_inertia(1.0, radii) if inertia is None else inertia
    return _for_each("inertia", moment_of_inertia("inertia", given), len(masses))


def _circles(radii: list[float]) -> list[Circle]:
    """Return a circle for each radius; equal ones are one object."""
    different = {radius: Circle(radius) for radius in dict.fromkeys(radii)}
    return [different[radius] for radius in radii]


def _tuples(vectors: Floats) -> Iterable[tuple[float, float]]:
    """Return vectors, shape (N, 2), as tuples of two floats."""
    return zip(*vectors.T.tolist(), strict=True)


def _unless(is_static: NDArray[np.bool_], values: Floats) -> list[float | None]:
    """Return the values of the bodies that can be pushed, and None for the others."""
    return [
        None if fixed else value
        for value, fixed in zip(values.tolist(), is_static.tolist(), strict=True)
    ]
