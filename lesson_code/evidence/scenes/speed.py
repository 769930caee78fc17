"""The scenes in which speed is measured, each a function of its size.

They are made so that every engine solves the same problem:

- Bodies are about 1 m large, because Box2D's slop of 5 mm is compiled into it; ours is as much for
  a body of 1 m, and pymunk's is to be set to :attr:`SpeedScene.slop`.
- A pair's coefficients are the same by every rule, and can be given to the bodies. Restitution
  is 1 or 0 for all. Friction is 0 or :data:`FRICTION`, whose root is exact: a body of 0.75 makes
  0.5625 by pymunk's product. So no engine is slowed by setting them contact by contact.
- Bodies at rest have nowhere to fall, or come to rest in the steps before the measurement.

One difference stays: an elastic gas loses energy in Box2D. Where a disc meets two others in a step,
each pair bounces once, one after the other, and the first is not asked again. 600 steps take 8 %
from a gas of 1,000 discs, and 67 % from a dense one.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.rigid_bodies import (
    GRAVITY,
    HALF_LENGTH,
    box_pyramid,
    box_stack,
)
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

DT = 1 / 60
"""s: the step of all scenes."""

FRICTION = 0.75**2
"""Of every rough pair; 0.75 and its square are exact in binary."""

COVERED, DENSELY_COVERED = 0.3, 0.6
"""Share of the box that the discs of a gas cover; the densest that rows allow is pi/4."""

NESTED = SLOP / 2
"""Of the width: how far settled discs, and boxes of a pyramid, stand in each other at the start.

It is half of the slop. Where bodies only touch, some engines see no contact yet: in ours, a pyramid
of 50 rows built that way sinks by a quarter of a box before it is caught.
"""

MOST_ROWS = 20
"""Rows of settled discs. Ten sweeps carry a load no further down, and a larger pile is wider: its
discs are as well held up as those of a smaller one.
"""

SMALLEST, LARGEST = 0.6, 0.8
"""m: from the middle of a shape in a bin to its farthest point."""

LOOSE = 1.1
"""m, from disc to disc of those that are to fall."""

PITCH = 2.1 * LARGEST
"""m, from place to place in a bin at the start: nothing touches there."""

THICK = 2.0
"""m: floors and walls under and around polygons."""

STEPS_TO_SETTLE = 600
"""Until what is built at rest carries its own load. In pymunk nothing is then faster than 0.05 m/s,
but in the pyramid of 50 rows, which it does not hold still; in Box2D nothing faster than 1 mm/s.
"""

STEPS_TO_STAND = 60
"""Of a free stack. There is no waiting for its rest: pymunk's stack of 20 lies on the ground after
300 steps, Box2D's after 720.
"""

STEPS_STACK_LASTS = 60
"""Later, pymunk's stack of 20 begins to lean, and is no longer a stack."""

STEPS_TO_MIX = 60
"""Until the discs of a gas have left their rows."""

STEPS_TO_FALL = 900
"""Until the shapes that fall into a bin lie, but for one or another that still slips."""


@dataclass(frozen=True)
class SpeedScene:
    """A scene in which speed is measured.

    Attributes
    ----------
    name : str
        What it is, and how many.
    scene : Scene
        The bodies.
    dt : float
        The step, s.
    warm_up : int
        Steps before the measurement.
    lasts : int, optional
        Steps after the warm-up for which the scene stays representative; then it has to be rebuilt.
        None: it lasts indefinitely.

    Examples
    --------
    >>> stack(10).name, stack(10).slop
    ('stack of 10', 0.005)
    """

    name: str
    scene: Scene
    dt: float
    warm_up: int
    lasts: int | None = None

    @property
    def slop(self) -> float:
        """Overlap that our solver leaves alone, m: a share of the smallest body that can move."""
        widths = (body.shape.min_width for body in self.scene.bodies if not body.is_static)
        return SLOP * min(widths)


def gas(count: int, *, seed: int = 1) -> SpeedScene:
    """Return elastic discs in a square box of four segments; they cover 0.3 of it.

    Pairs are found among bodies that all move; contacts are few and short.
    """
    return SpeedScene(
        f"gas of {count:,}",
        gas_of(count, COVERED, seed=seed),
        DT,
        STEPS_TO_MIX,
    )


def dense_gas(count: int, *, seed: int = 1) -> SpeedScene:
    """Return elastic discs in a square box of four segments; they cover 0.6 of it.

    Collisions are so close to one another that several share a body in one step.
    """
    return SpeedScene(
        f"dense gas of {count:,}",
        gas_of(count, DENSELY_COVERED, seed=seed),
        DT,
        STEPS_TO_MIX,
    )


def settled_discs(count: int) -> SpeedScene:
    """Return rough discs at rest in an open box, each in the gap between two below it.

    Neighbours overlap by half of the slop: nothing has to fall before it is held. Each disc has
    about six contacts that last.

    Parameters
    ----------
    count : int
        Discs, >= 1; the top row may be shorter.
    """
    rows = min(round(math.sqrt(count)), MOST_ROWS)
    across = math.ceil(count / rows + 0.5)
    radius, pitch = 0.5, 1 - NESTED
    places = [
        ((n + row % 2 / 2) * pitch, row * pitch * math.sqrt(0.75))
        for row in range(rows + 1)
        for n in range(across - row % 2)
    ]
    surface = Material(0.0, FRICTION)
    shape = Circle(radius)
    discs = [Body(shape, mass=1.0, position=place, material=surface) for place in places[:count]]
    wall = radius - NESTED
    left, right, top = -wall, (across - 1) * pitch + wall, rows + 1.0
    corners = [(left, top), (left, -wall), (right, -wall), (right, top)]
    box = [Body(Segment(start, end), material=surface) for start, end in pairwise(corners)]
    return SpeedScene(
        f"{count:,} settled discs",
        Scene([*box, *discs], gravity=(0, -GRAVITY)),
        DT,
        STEPS_TO_SETTLE,
    )


def falling_discs(count: int) -> Scene:
    """Return rough discs in loose rows that fall into an open box, and come to rest in a heap.

    Parameters
    ----------
    count : int
        Discs, >= 1; they start in about as many rows as columns.
    """
    across = math.ceil(math.sqrt(count))
    columns, rows = np.arange(count) % across, np.arange(count) // across
    x, y = LOOSE * (columns + 0.5 + rows % 2 / 4), LOOSE * (rows + 0.5)
    right, top = LOOSE * (across + 0.5), LOOSE * (across + 1)
    surface = Material(0.0, FRICTION)
    corners = [(0.0, top), (0.0, 0.0), (right, 0.0), (right, top)]
    return Scene.of_discs(
        np.stack([x, y], axis=-1),
        radius=0.5,
        mass=1.0,
        material=surface,
        obstacles=[Body(Segment(*ends), material=surface) for ends in pairwise(corners)],
        gravity=(0, -GRAVITY),
    )


def stack(count: int) -> SpeedScene:
    """Return boxes that stand freely on each other; the load is handed down box by box."""
    return SpeedScene(
        f"stack of {count}",
        _on_slab(box_stack(count, FRICTION)),
        DT,
        STEPS_TO_STAND,
        lasts=STEPS_STACK_LASTS,
    )


def pyramid(rows: int) -> SpeedScene:
    """Return boxes in rows, each one shorter than the one below; it keeps the solver busiest."""
    return SpeedScene(
        f"pyramid of {rows} rows",
        _on_slab(box_pyramid(rows, FRICTION, overlap=NESTED)),
        DT,
        STEPS_TO_SETTLE,
    )


def bin_of_shapes(count: int, *, seed: int = 1) -> SpeedScene:
    """Return circles, boxes, triangles and pentagons that fall into a bin with thick walls.

    They start in rows, turned at random; sizes are drawn too. A square metre weighs 1 kg. The bin
    is so wide that 2,000 shapes lie in some fifteen layers: sweeps carry a load no further down.

    Parameters
    ----------
    count : int
        Shapes, >= 1.
    seed : int
        Draws sizes and angles.
    """
    rng = np.random.default_rng(seed)
    across = math.ceil(2 * math.sqrt(count))
    surface = Material(0.0, FRICTION)
    bodies = []
    for n in range(count):
        shape = _shape(n % 4, rng)
        place = (PITCH * (n % across + 0.5), PITCH * (n // across + 0.5))
        angle = rng.uniform(0, 2 * math.pi)
        bodies.append(Body(shape, mass=shape.area, position=place, angle=angle, material=surface))
    walls = _bin(PITCH * across, PITCH * (count // across + 2), surface)
    return SpeedScene(
        f"bin of {count:,} shapes",
        Scene([*walls, *bodies], gravity=(0, -GRAVITY)),
        DT,
        STEPS_TO_FALL,
    )


BUILDERS: dict[str, Callable[[int], SpeedScene]] = {
    "gas": gas,
    "dense": dense_gas,
    "settled": settled_discs,
    "stack": stack,
    "pyramid": pyramid,
    "bin": bin_of_shapes,
}
"""What makes a scene, by its name on the command line; the size follows, as in "gas-100"."""

SIZES: dict[str, tuple[int, ...]] = {
    "gas": (10, 100, 1_000, 10_000, 100_000),
    "dense": (100, 1_000, 10_000),
    "settled": (10, 100, 1_000, 10_000, 100_000),
    "stack": (10, 20),
    "pyramid": (10, 20, 50),
    "bin": (500, 2_000),
}
"""The sizes in which each scene is measured."""


def scene_named(name: str) -> SpeedScene:
    """Return a scene of any size by its name.

    Raises
    ------
    ValueError
        There is no such scene.

    Examples
    --------
    >>> scene_named("stack-12").name
    'stack of 12'
    """
    kind, _, size = name.partition("-")
    if kind not in BUILDERS or not size.isdigit() or int(size) < 1:
        raise ValueError(f"scene must be one of {', '.join(BUILDERS)} with a size, got {name!r}")
    return BUILDERS[kind](int(size))


def _on_slab(scene: Scene) -> Scene:
    """Return a scene whose ground, body 0, is a slab instead of a line."""
    ground, *bodies = scene.bodies
    slab = Body(Polygon.box(2 * HALF_LENGTH, THICK), position=(0, -THICK / 2))
    return Scene([replace(slab, material=ground.material), *bodies], gravity=scene.gravity)


def _shape(kind: int, rng: np.random.Generator) -> Shape:
    """Return a circle, a box, a triangle or a pentagon of some size."""
    radius = rng.uniform(SMALLEST, LARGEST)
    if kind == 0:
        return Circle(radius)
    if kind == 1:
        side = math.sqrt(2) * radius
        return Polygon.box(side, side)
    return Polygon.regular(3 if kind == 2 else 5, radius)


def _bin(width: float, height: float, surface: Material) -> list[Body]:
    """Return a floor and two walls, so thick that no heap presses anything through them."""
    floor = Polygon.box(width + 2 * THICK, THICK)
    wall = Polygon.box(THICK, height)
    places: list[Any] = [
        (floor, (width / 2, -THICK / 2)),
        (wall, (-THICK / 2, height / 2)),
        (wall, (width + THICK / 2, height / 2)),
    ]
    return [Body(shape, position=place, material=surface) for shape, place in places]
