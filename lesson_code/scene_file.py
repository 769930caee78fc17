"""Scene files: one form for the simulator, the collision lab of the pages, and Python.

A scene file is JSON; the link to a set-up of the lab holds the same::

    {
      "dimensions": 2,
      "elasticity": 80,
      "friction": 0.2,
      "gravity": 9.81,
      "walls": true,
      "room": [8, 5],
      "bodies": [
        {"shape": "disc", "size": 0.4, "mass": 1, "x": -2, "y": 0, "vx": 2, "vy": 0,
         "angle": 0, "w": 0},
        {"shape": "polygon", "size": 0.5, "corners": 5, "mass": 2, "elasticity": 30}
      ]
    }

============ ======================================================================================
dimensions   2, or 1: a track along y = 0, where nothing turns or falls or rubs; 2 unless given
elasticity   restitution of all surfaces in %, from 0 to 100; a body may have its own; 100
friction     Coulomb's coefficient of all surfaces, from 0 to 1; a body may have its own; 0
gravity      m/s^2, downward, from 0 to 20; true stands for 9.81; 0
walls        whether the room has walls; on a track the left and the right one; false
room         its width and height, m, about the origin; [8, 5], of a track [8, 2]
bodies       at most 1000, in the order in which a run numbers them
shape        "disc", "box" (a square) or "polygon" (regular, a corner at the angle 0); "disc"
size         m: a disc's radius, half of a box's width, from a polygon's centre to a corner
corners      of a polygon: a whole number from 3 to 20; 5
mass         kg
x, y, angle  where the centre of mass is, m, and how far the body has turned, rad; 0
vx, vy, w    velocity, m/s, and angular velocity, rad/s, counter-clockwise; 0
============ ======================================================================================

Mass and size must be given. :data:`FIELDS` holds the range of each number, for Python and the pages
alike; a field of another name is an error. `lab_setup.js` reads and writes the form in a page.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

GRAVITY = 9.81
"""m/s^2: what "gravity": true stands for."""

MOST_BODIES = 1000
ROOMS = {1: (8.0, 2.0), 2: (8.0, 5.0)}
"""m: width and height by the number of dimensions, unless a file gives others."""

SHAPES = ("disc", "box", "polygon")
SAME_CORNER = 1e-9
"""Of a size: how far the corner of a regular polygon may be off."""


class Field(NamedTuple):
    """The range of a number, what stands for it where it is left out, and whether it is whole."""

    low: float
    high: float
    usual: float | None = 0
    is_whole: bool = False


SETTINGS = {"elasticity": Field(0, 100, 100), "friction": Field(0, 1)}
FIELDS = {
    "mass": Field(0.001, 100, None),
    "size": Field(0.02, 1, None),
    "corners": Field(3, 20, 5, is_whole=True),
    "x": Field(-100, 100),
    "y": Field(-100, 100),
    "vx": Field(-50, 50),
    "vy": Field(-50, 50),
    "angle": Field(-1e9, 1e9),
    "w": Field(-1e9, 1e9),
}
FALL = Field(0, 20)
SIDE = Field(1, 100)


def read_scene(path: str | Path) -> Scene:
    """Return the scene of a file, for :func:`lesson_code.simulate`.

    Parameters
    ----------
    path : path
        A scene file: this module describes its form.

    Returns
    -------
    Scene
        Its bodies in their order; the walls come last.

    Raises
    ------
    ValueError
        The file holds no scene; the message names the field, its rule and the value.
    OSError
        The file cannot be read.
    """
    return scene_of(set_up_in(path))


def write_scene(path: str | Path, set_up: Mapping[str, Any]) -> None:
    """Write a set-up to a file, if it is one.

    Raises
    ------
    ValueError
        It is none; the message names the field, its rule and the value.
    OSError
        The file cannot be written.
    """
    text = json.dumps(understood(set_up), indent=1) + "\n"
    Path(path).write_text(text, encoding="utf-8")


def set_up_in(path: str | Path) -> dict[str, Any]:
    """Return the checked set-up of a file."""
    try:
        given = json.loads(Path(path).read_text(encoding="utf-8"))
        return understood(given)
    except ValueError as error:  # of JSON and of letters, too
        raise ValueError(f"{path} holds no scene: {error}") from None


def understood(given: Any) -> dict[str, Any]:
    """Return a set-up with every field checked, and what was left out written down.

    >>> understood({"bodies": [{"mass": 1, "size": 0.4, "vx": 51}]})
    Traceback (most recent call last):
    ...
    ValueError: bodies[0].vx must lie between -50 and 50, got 51
    """
    names = ("dimensions", *SETTINGS, "gravity", "walls", "room", "bodies")
    _require_fields("a scene", given, names)
    dimensions = given.get("dimensions", 2)
    if type(dimensions) is not int or dimensions not in ROOMS:
        raise ValueError(f"dimensions must be 1 or 2, got {_said(dimensions)}")
    settings = {name: _number(name, given.get(name), field) for name, field in SETTINGS.items()}
    gravity, walls = given.get("gravity", False), given.get("walls", False)
    if not isinstance(gravity, bool):
        gravity = _number("gravity", gravity, FALL)
    if not isinstance(walls, bool):
        raise ValueError(f"walls must be true or false, got {_said(walls)}")
    bodies = given.get("bodies")
    if not isinstance(bodies, list) or len(bodies) > MOST_BODIES:
        raise ValueError(f"bodies must be a list of at most {MOST_BODIES}, got {_counted(bodies)}")
    return {
        "dimensions": dimensions,
        **settings,
        "gravity": gravity,
        "walls": walls,
        **({"room": _room(given["room"])} if "room" in given else {}),
        "bodies": [_body(f"bodies[{k}]", one) for k, one in enumerate(bodies)],
    }


def scene_of(set_up: Mapping[str, Any]) -> Scene:
    """Return a set-up as a scene; the walls come last.

    >>> scene = scene_of({"walls": True, "bodies": [{"mass": 2, "size": 0.5, "x": 1}]})
    >>> scene.bodies[0].position, scene.bodies[0].mass, len(scene.bodies)
    ((1.0, 0.0), 2.0, 5)
    """
    checked = understood(set_up)
    is_track = checked["dimensions"] == 1
    bodies = [_as_body(one, checked) for one in checked["bodies"]]
    if checked["walls"]:
        surface = _surface({}, checked)
        wide, high = (side / 2 for side in checked.get("room", ROOMS[checked["dimensions"]]))
        corners = [(-wide, -high), (wide, -high), (wide, high), (-wide, high)]
        sides = [Segment(corners[k], corners[(k + 1) % 4]) for k in range(4)]
        bodies += [Body(side, material=surface) for side in (sides[1::2] if is_track else sides)]
    return Scene(bodies, (0.0, 0.0 if is_track else -float(_fall(checked))))


def set_up_of(
    bodies: Iterable[Body],
    *,
    surface: Material,
    gravity: float = 0.0,
    room: tuple[float, float] | None = None,
) -> dict[str, Any]:
    """Return the set-up of bodies as they are.

    Parameters
    ----------
    bodies : iterable of Body
        Discs, squares and regular polygons with masses.
    surface : Material
        Of the walls, and of all bodies that have no other.
    gravity : float
        m/s^2, downward.
    room : (float, float), optional
        Width and height of the walls about the origin, m; None: there are none.

    Raises
    ------
    ValueError
        A body is of another kind, or a number is out of range.
    """
    kept = list(bodies)
    is_track = bool(kept) and all(_is_on_track(body) for body in kept)
    common = {"elasticity": 0.0, "friction": 0.0} | _percent(surface)
    around = {} if room is None else {"room": list(room)}
    return understood(
        {
            "dimensions": 1 if is_track else 2,
            **common,
            "gravity": gravity,
            "walls": room is not None,
            **around,
            "bodies": [
                _as_plain(f"bodies[{k}]", body, common, is_track) for k, body in enumerate(kept)
            ],
        }
    )


def form() -> dict[str, Any]:
    """Return what a page has to know of the form.

    >>> form()["ranges"]["friction"]
    {'low': 0, 'high': 1, 'usual': 0, 'is_whole': False}
    """
    fields = {**SETTINGS, **FIELDS, "gravity": FALL, "side": SIDE}
    return {
        "ranges": {name: field._asdict() for name, field in fields.items()},
        "shapes": SHAPES,
        "rooms": ROOMS,
        "gravity": GRAVITY,
        "most_bodies": MOST_BODIES,
    }


# From plain values


def _as_body(one: Mapping[str, Any], checked: Mapping[str, Any]) -> Body:
    """Return a body of a set-up."""
    shape, material = _shape(one), _surface(one, checked)
    if checked["dimensions"] == 1:
        at, velocity = (one["x"], 0.0), (one["vx"], 0.0)
        still = {"mass": one["mass"], "inertia": math.inf}
        return Body(shape, position=at, velocity=velocity, material=material, **still)
    return Body(
        shape,
        position=(one["x"], one["y"]),
        velocity=(one["vx"], one["vy"]),
        angle=one["angle"],
        angular_velocity=one["w"],
        mass=one["mass"],
        material=material,
    )


def _shape(one: Mapping[str, Any]) -> Shape:
    """Return a body's shape."""
    size = one["size"]
    if one["shape"] == "disc":
        return Circle(size)
    if one["shape"] == "box":
        return Polygon.box(2 * size, 2 * size)
    return Polygon.regular(one["corners"], size)


def _surface(one: Mapping[str, Any], checked: Mapping[str, Any]) -> Material:
    """Return the surface of a body, or with nothing of its own that of all."""
    rubs = 0.0 if checked["dimensions"] == 1 else one.get("friction", checked["friction"])
    return Material(one.get("elasticity", checked["elasticity"]) / 100, rubs)


def _fall(checked: Mapping[str, Any]) -> float:
    """Return the gravity of a set-up, m/s^2."""
    return GRAVITY if checked["gravity"] is True else checked["gravity"]


# To plain values


def _as_plain(name: str, body: Body, common: Mapping[str, float], is_track: bool) -> dict[str, Any]:
    """Return a body as plain values; of its surface what differs from the common one."""
    if body.is_static:
        raise ValueError(f"{name}.mass must be given: a scene file has no fixed bodies but walls")
    if body.inertia == math.inf and not is_track:
        raise ValueError(f"{name}.inertia must be its shape's, got inf")
    own = _percent(body.material)
    (x, y), (vx, vy) = body.position, body.velocity
    return {
        **_plain_shape(f"{name}.shape", body.shape),
        "mass": body.mass,
        "x": x,
        "y": y,
        "vx": vx,
        "vy": vy,
        "angle": body.angle,
        "w": body.angular_velocity,
        **{key: value for key, value in own.items() if value != common[key]},
    }


def _percent(surface: Material) -> dict[str, float]:
    """Return what a surface says as a file does; nothing of what it leaves to the other body."""
    made = {} if surface.restitution is None else {"elasticity": 100 * surface.restitution}
    return made if surface.friction is None else made | {"friction": surface.friction}


def _plain_shape(name: str, shape: Shape) -> dict[str, Any]:
    """Return a shape as plain values."""
    if isinstance(shape, Circle):
        return {"shape": "disc", "size": shape.radius}
    if isinstance(shape, Polygon):
        corners = shape.vertices
        size = shape.bounding_radius
        half = size / math.sqrt(2)
        if _are_near(corners, Polygon.box(2 * half, 2 * half).vertices, size):
            return {"shape": "box", "size": half}
        if _are_near(corners, Polygon.regular(len(corners), size).vertices, size):
            return {"shape": "polygon", "size": size, "corners": len(corners)}
    raise ValueError(f"{name} must be a disc, a square or a regular polygon, got {shape!r}")


def _are_near(corners: Any, others: Any, size: float) -> bool:
    """Return whether corners are others, but for rounding."""
    return len(corners) == len(others) and all(
        math.dist(a, b) <= SAME_CORNER * size for a, b in zip(corners, others, strict=True)
    )


def _is_on_track(body: Body) -> bool:
    """Return whether a body moves along y = 0, and cannot turn."""
    return body.inertia == math.inf and body.position[1] == body.velocity[1] == 0.0


# The door


def _body(name: str, one: Any) -> dict[str, Any]:
    """Return a body with every field checked."""
    _require_fields(name, one, ("shape", *FIELDS, *SETTINGS))
    shape = one.get("shape", "disc")
    if shape not in SHAPES:
        raise ValueError(f"{name}.shape must be one of {', '.join(SHAPES)}, got {_said(shape)}")
    numbers = {key: _number(f"{name}.{key}", one.get(key), f) for key, f in FIELDS.items()}
    own = {key: _number(f"{name}.{key}", one[key], f) for key, f in SETTINGS.items() if key in one}
    return {"shape": shape, **numbers, **own}


def _number(name: str, value: Any, field: Field) -> float:
    """Return a number that its field allows, or what stands for one that is left out."""
    taken: Any = field.usual if value is None else value
    is_number = isinstance(taken, int | float) and not isinstance(taken, bool)
    is_inside = is_number and field.low <= taken <= field.high
    if not is_inside or (field.is_whole and taken != int(taken)):
        kind = "be a whole number" if field.is_whole else "lie"
        ends = f"{field.low:.10g} and {field.high:.10g}"
        raise ValueError(f"{name} must {kind} between {ends}, got {_said(value)}")
    number: float = taken
    return number


def _room(value: Any) -> list[float]:
    """Return the width and the height of a room."""
    if not isinstance(value, list) or len(value) != 2:
        raise ValueError(f"room must be [width, height], got {_said(value)}")
    return [_number(f"room[{k}]", side, SIDE) for k, side in enumerate(value)]


def _require_fields(name: str, given: Any, known: tuple[str, ...]) -> None:
    """Refuse what is no object, and a field that the form does not have."""
    if not isinstance(given, dict):
        raise ValueError(f"{name} must be an object with fields, got {_said(given)}")
    for key in given:
        if key not in known:
            raise ValueError(f"{name} must have no field but {', '.join(known)}, got {key}")


def _counted(bodies: Any) -> str:
    """Return how many bodies there are, or what there is."""
    return str(len(bodies)) if isinstance(bodies, list) else _said(bodies)


def _said(value: Any) -> str:
    """Return a value as it stands in the file; nothing, where it does not."""
    return "nothing" if value is None else json.dumps(value, separators=(",", ":"))
