"""What is simulated: materials, bodies and the scene they stand in, as a user writes them down.

A scene says nothing about how it is solved. All of it is checked here, at the door, and none of
it can be changed afterwards.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import cached_property
from typing import Any, TypeAlias, TypeVar

from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.core.columns import Columns, columns_of
from lesson_code.engine.core.many_discs import disc_values
from lesson_code.formulas import validation
from lesson_code.formulas.validation import (
    Number,
    Vector,
    non_negative,
    one_number,
    one_vector,
    unit_interval,
)
from lesson_code.geometry.edges import direction
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape, length_of

XY: TypeAlias = tuple[float, float]

Item = TypeVar("Item")

OFF_CENTRE = 1e-9
"""Of a segment's length: how far the middle of a rod may lie from its centre of mass."""


@dataclass(frozen=True)
class Material:
    """How a body's surface bounces and rubs.

    Attributes
    ----------
    restitution : float, optional
        0 to 1. None, the default, leaves it to the other body of a pair.
    friction : float, optional
        Coulomb's coefficient, >= 0. None, the default, leaves it to the other body of a pair.
        Where neither body says anything the pair's value is 0.

    Raises
    ------
    ValueError
        The restitution lies outside [0, 1], or the friction is negative or not finite.

    Examples
    --------
    >>> Material(restitution=0.8).friction is None
    True
    """

    restitution: float | None = None
    friction: float | None = None

    def __post_init__(self) -> None:
        """Refuse what is out of range."""
        if self.restitution is not None:
            object.__setattr__(
                self, "restitution", one_number("restitution", self.restitution, unit_interval)
            )
        if self.friction is not None:
            object.__setattr__(
                self, "friction", one_number("friction", self.friction, non_negative)
            )


@dataclass(frozen=True, slots=True)
class Body:
    """A shape with a place, a motion, a mass and a surface.

    Without a mass a body is *static*: nothing can push it. If it is given a velocity it keeps
    that for ever (a moving wall).

    Attributes
    ----------
    shape : Circle, Polygon or Segment
        A polygon stands with its centroid at `position`, a segment with its ends relative to it.
    position : (float, float)
        Of the centre of mass, m.
    angle : float
        rad, counter-clockwise.
    velocity : (float, float)
        m/s.
    angular_velocity : float
        rad/s, counter-clockwise.
    mass : float, optional
        kg, > 0. None or ``math.inf``: static.
    inertia : float, optional
        Moment of inertia about the centre of mass, kg m^2, > 0; ``math.inf`` for a body that
        never turns. None, the default: the shape's, evenly filled.
    material : Material
        Its surface.

    Raises
    ------
    ValueError
        A number is out of range, an inertia is given without a mass, or a segment with a mass is
        not centred on its position.
    TypeError
        `shape` or `material` is something else.

    Examples
    --------
    >>> Body(Circle(2.0), mass=3.0).inertia
    6.0
    >>> Body(Segment((-10, 0), (10, 0))).is_static
    True
    """

    shape: Shape
    _: KW_ONLY
    position: XY = (0.0, 0.0)
    angle: float = 0.0
    velocity: XY = (0.0, 0.0)
    angular_velocity: float = 0.0
    mass: float | None = None
    inertia: float | None = None
    material: Material = field(default=Material())

    def __post_init__(self) -> None:
        """Check every value, and write down what was left to the shape."""
        _require_type("shape", self.shape, (Circle, Polygon, Segment))
        _require_type("material", self.material, (Material,))
        body_mass = _mass(self.mass)
        checked = {
            "position": _pair("position", self.position),
            "velocity": _pair("velocity", self.velocity),
            "angle": one_number("angle", self.angle),
            "angular_velocity": one_number("angular_velocity", self.angular_velocity),
            "mass": body_mass,
            "inertia": _inertia(self.inertia, body_mass, self.shape),
        }
        for name, value in checked.items():
            object.__setattr__(self, name, value)

    @property
    def is_static(self) -> bool:
        """Whether nothing can push this body."""
        return self.mass is None


@dataclass(frozen=True)
class Scene:
    """Bodies, and what acts on all of them.

    Attributes
    ----------
    bodies : sequence of Body
        In the order that a run numbers them. The order is part of the scene: where contacts
        share a body, the one between earlier bodies is visited first.
    gravity : (float, float)
        Acceleration of every body with a mass, m/s^2.
    damping : float
        Rate at which all motion dies away, 1/s, >= 0: speeds fall as exp(-damping t).
    callbacks : Callbacks
        What to call when bodies begin to touch, touch, and part.

    Raises
    ------
    ValueError
        Gravity or damping is out of range.
    TypeError
        Something in `bodies` is not a Body.

    Examples
    --------
    >>> scene = Scene([Body(Circle(0.5), mass=1.0)], gravity=(0, -9.81))
    >>> len(scene.bodies), scene.gravity
    (1, (0.0, -9.81))
    """

    bodies: tuple[Body, ...] = ()
    gravity: XY = (0.0, 0.0)
    damping: float = 0.0
    callbacks: Callbacks = field(default=Callbacks())

    def __init__(
        self,
        bodies: Iterable[Body] = (),
        gravity: Vector = (0.0, 0.0),
        damping: float = 0.0,
        callbacks: Callbacks | None = None,
    ) -> None:
        bodies = listed("bodies", bodies)
        _require_bodies(bodies)
        callbacks = Callbacks() if callbacks is None else callbacks
        _require_type("callbacks", callbacks, (Callbacks,))
        object.__setattr__(self, "bodies", bodies)
        object.__setattr__(self, "gravity", _pair("gravity", gravity))
        object.__setattr__(self, "damping", one_number("damping", damping, non_negative))
        object.__setattr__(self, "callbacks", callbacks)

    @classmethod
    def of_discs(
        cls,
        positions: Vector,
        velocities: Vector = (0.0, 0.0),
        *,
        radius: Number,
        mass: Number | None,
        angle: Number = 0.0,
        angular_velocity: Number = 0.0,
        inertia: Number | None = None,
        material: Material | Sequence[Material] = Material(),
        obstacles: Iterable[Body] = (),
        gravity: Vector = (0.0, 0.0),
        damping: float = 0.0,
        callbacks: Callbacks | None = None,
    ) -> Scene:
        """Return a scene of many discs, which are checked all at once.

        It is the scene of the same bodies made one by one, to the last bit, and takes
        less time: whole arrays are checked.

        Parameters
        ----------
        positions : array_like, shape (N, 2)
            m.
        velocities : array_like, shape (2,) or (N, 2)
            m/s.
        radius, mass, angle, angular_velocity, inertia : float or array_like, shape (N,)
            As for one body, in the same units: one value for all discs, or one for each.
        material : Material, or N of them
            The surface of all discs, or of each.
        obstacles : sequence of Body
            The other bodies. They come first, and the discs after them.
        gravity, damping, callbacks
            As for every scene.

        Raises
        ------
        ValueError
            A number is out of range, or an array does not have a value for each disc. The message
            names the argument and the place.
        TypeError
            Something is of another kind.

        Examples
        --------
        >>> scene = Scene.of_discs([(0, 0), (3, 0)], (1, 0), radius=1.0, mass=[1.0, 2.0])
        >>> [body.inertia for body in scene.bodies]
        [0.5, 1.0]
        """
        values = disc_values(
            positions,
            velocities,
            radius=radius,
            mass=mass,
            angle=angle,
            angular_velocity=angular_velocity,
            inertia=inertia,
        )
        values["material"] = _materials(material, len(positions))
        discs = _complete(len(positions), values)
        return cls([*obstacles, *discs], gravity, damping, callbacks)

    @cached_property
    def columns(self) -> Columns:
        """The bodies' properties as arrays, for what looks at all of them."""
        return columns_of(self.bodies)


def body_at(body: Body, state: Any) -> Body:
    """Return a body as it is by now: x, y, angle, vx, vy, w."""
    x, y, angle, vx, vy, w = state
    return replace(body, position=(x, y), angle=angle, velocity=(vx, vy), angular_velocity=w)


def scene_at(scene: Scene, states: Any, gravity: XY | None = None) -> Scene:
    """Return a scene with its bodies as they are by now.

    Parameters
    ----------
    scene : Scene
        As it was at the start.
    states : array, shape (N, 6)
        x, y, angle, vx, vy, w of every body.
    gravity : (float, float), optional
        m/s^2; the scene's own unless given.

    Examples
    --------
    >>> scene = Scene([Body(Circle(1), mass=1.0)])
    >>> scene_at(scene, [[1, 2, 0, 3, 4, 0]]).bodies[0].position
    (1.0, 2.0)
    """
    bodies = [body_at(body, state) for body, state in zip(scene.bodies, states, strict=True)]
    chosen = scene.gravity if gravity is None else gravity
    return Scene(bodies, chosen, scene.damping, scene.callbacks)


def _mass(value: float | None) -> float | None:
    """Return a mass in kg, or None for a body that nothing can push."""
    if value is None or math.isinf(one_number("mass", value, validation.mass)):
        return None
    return float(value)


def _inertia(value: float | None, body_mass: float | None, shape: Shape) -> float | None:
    """Return a moment of inertia in kg m^2: the one given, or that of the filled shape."""
    if body_mass is None:
        if value is not None:
            raise ValueError(f"inertia must be left out of a body without a mass, got {value}")
        return None
    if isinstance(shape, Segment):
        _require_centred(shape)
    inertia = body_mass * shape.inertia_per_mass if value is None else value
    return one_number("inertia", inertia, validation.moment_of_inertia)


def _require_centred(segment: Segment) -> None:
    """Refuse a rod whose centre of mass is not where its body is."""
    if is_off_centre(segment.outline):
        raise ValueError(
            "a segment with a mass must be centred on its body's position (end = -start), "
            f"got start {segment.start} and end {segment.end}"
        )


def is_off_centre(outline: Any) -> bool:
    """Return whether the middle of a segment is not its body's position."""
    end, start = outline[0], outline[1]
    off, _, _ = direction(start[0] + end[0], start[1] + end[1], 1.0, 0.0)
    return off > OFF_CENTRE * length_of(outline)


def _materials(material: Material | Sequence[Material], count: int) -> Sequence[Material]:
    """Return N materials."""
    if isinstance(material, Material):
        return [material] * count
    if len(material) != count:
        raise ValueError(
            f"material must be one, or one for each of {count} discs, got {len(material)}"
        )
    for index, one in enumerate(material):
        _require_type(f"material[{index}]", one, (Material,))
    return material


def _complete(count: int, values: Mapping[str, Iterable[Any]]) -> list[Body]:
    """Return bodies whose values have been checked, from a column for each field."""
    bodies = [object.__new__(Body) for _ in range(count)]
    for name, column in values.items():
        write = getattr(Body, name).__set__  # of the slot: a Body refuses to be changed
        for body, value in zip(bodies, column, strict=True):
            write(body, value)
    return bodies


def _pair(name: str, value: Vector) -> XY:
    """Return a vector as two floats; two plain numbers without the detour over an array."""
    if type(value) in (tuple, list) and len(value) == 2:
        x, y = value
        if _is_plain(x) and _is_plain(y):
            return float(x), float(y)
    x, y = one_vector(name, value)
    return float(x), float(y)


def _is_plain(value: Any) -> bool:
    """Return whether a value is a number that every rule for finite ones accepts."""
    return type(value) in (float, int) and abs(value) <= sys.float_info.max


def listed(name: str, values: Iterable[Item]) -> tuple[Item, ...]:
    """Return values as a tuple, and refuse a single one by name."""
    if not isinstance(values, Iterable):
        raise TypeError(f"{name} must be a list or tuple, got {values!r}")
    return tuple(values)


def _require_bodies(bodies: tuple[Any, ...]) -> None:
    """Refuse what is no body, by its place."""
    for index, body in enumerate(bodies):
        if not isinstance(body, Body):
            _require_type(f"bodies[{index}]", body, (Body,))


def _require_type(name: str, value: object, kinds: tuple[type, ...]) -> None:
    """Refuse a value of another kind."""
    if not isinstance(value, kinds):
        names = " or ".join(kind.__name__ for kind in kinds)
        raise TypeError(f"{name} must be a {names}, got {value!r}")
