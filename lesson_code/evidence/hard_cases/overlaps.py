"""Families of bodies that overlap or have no room. Undoing an overlap must not add speed."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import fastest, free
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes.events import box
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, level_ground
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

THEME = "Overlaps"

NO_SPEED = "What has no energy gets none."

APART = "They come apart, and none gets any speed."


def some_shape(draw: Draw, name: str = "") -> Shape:
    """Draw a disc, a box or a triangle, about 1 m wide; what has a face stands on it."""
    kind = draw.choice(f"shape{name}", ("disc", "box", "triangle"))
    shapes: dict[str, Shape] = {
        "disc": Circle(0.5),
        "box": Polygon.box(1, 1),
        "triangle": Polygon([(-0.5, -0.3), (0.5, -0.3), (0.0, 0.6)]),
    }
    return shapes[kind]


@family(
    THEME,
    why="Restitution must not see the speed at which an overlap is undone.",
    law=NO_SPEED,
    unit="m/s",
    bound=1e-9,
    reason="rounding",
)
def two_in_each_other(draw: Draw, trial: Trial) -> float:
    """Two bodies of any masses and e stand 0 to 90 % in each other: greatest speed in 3 s."""
    surface = Material(draw.uniform("restitution", 0.0, 1.0), draw.uniform("friction", 0.0, 1.0))
    distance, way = draw.uniform("distance", 0.1, 1.0), draw.uniform("way", 0.0, 2 * math.pi)
    places = [(0.0, 0.0), (distance * math.cos(way), distance * math.sin(way))]
    bodies = [
        Body(
            some_shape(draw, f"_{n}"),
            mass=draw.log_uniform(f"mass_{n}", 1e-3, 1e3),
            position=place,
            angle=draw.uniform(f"angle_{n}", 0.0, math.pi),
            material=surface,
        )
        for n, place in enumerate(places)
    ]
    return fastest(trial.run(Scene(bodies), 3.0, sample=None))


def still_overlapping(trial: Trial, bodies: list[Body]) -> float:
    """Return the deepest overlap after 5 s, m; or the greatest speed ever, m/s, if that is more."""
    run = trial.run(Scene(bodies), 5.0, sample=None)
    return max(float(run.max_penetration[-1]), fastest(run))


@family(
    THEME,
    why="There is no direction from a centre to itself.",
    law=APART,
    unit="m",
    bound=1e-2,
    reason="a hundredth of a body",
)
def discs_in_one_place(draw: Draw, trial: Trial) -> float:
    """2 to 12 discs with one centre, or nearly: overlap after 5 s, or speed."""
    spread = draw.choice("spread", (0.0, draw.log_uniform("spread_by", 1e-12, 0.3)))
    rng = np.random.default_rng(draw.integer("places", 0, 10**6))
    dull = Material(0.0, draw.uniform("friction", 0.0, 1.0))
    places = (spread * rng.uniform(-1, 1, (draw.integer("count", 2, 12), 2))).tolist()
    return still_overlapping(
        trial, [Body(Circle(0.5), mass=1, position=(x, y), material=dull) for x, y in places]
    )


@family(
    THEME,
    why="The least way out of one body leads into another one.",
    law=APART,
    unit="m",
    bound=1e-2,
    reason="a hundredth of a body",
)
def bodies_in_one_place(draw: Draw, trial: Trial) -> float:
    """2 to 8 discs, boxes and triangles heaped in one place: overlap after 5 s, or speed."""
    rng = np.random.default_rng(draw.integer("places", 0, 10**6))
    dull, bodies = Material(0.0, draw.uniform("friction", 0.0, 1.0)), []
    for n in range(draw.integer("count", 2, 8)):
        x, y, angle = rng.uniform((-0.3, -0.3, 0), (0.3, 0.3, math.pi)).tolist()
        shape = some_shape(draw, f"_{n}")
        bodies.append(Body(shape, mass=1, position=(x, y), angle=angle, material=dull))
    return still_overlapping(trial, bodies)


@family(
    THEME,
    why="An overlap undone by force is a spring let go.",
    law="Undoing an overlap gives no speed.",
    unit="m/s",
    bound=0.5,
    reason="less than bodies get that fall by 13 mm",
)
def sunken_pyramid(draw: Draw, trial: Trial) -> float:
    """A pyramid whose rows stand 0 to 50 % in each other: greatest upward speed in 2 s."""
    rows, sunk = draw.integer("rows", 2, 5), draw.uniform("sunk", 0.0, 0.5)
    surface = Material(0.0, draw.uniform("friction", 0.2, 1.0))
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=1,
            position=(n - (rows - row) / 2, 0.5 - sunk + (1 - sunk) * row),
            material=surface,
        )
        for row in range(rows)
        for n in range(rows - row)
    ]
    run = trial.run(Scene([level_ground(), *boxes], gravity=(0, -GRAVITY)), 2.0, sample=None)
    return max(float(run.velocities[:, 1:, 1].max()), 0.0)


@family(
    THEME,
    why="The middle of the body may be beyond the line that it should stand on.",
    law="It comes out of the floor at no speed, and stands on it.",
    unit="m/s",
    bound=0.5,
    reason="less than bodies get that fall by 13 mm",
)
def sunk_in_the_floor(draw: Draw, trial: Trial) -> float:
    """A body stands 0 to 45 % in the floor: upward speed in 2 s; infinite if it falls."""
    shape, surface = some_shape(draw), Material(draw.uniform("restitution", 0.0, 1.0), 0.5)
    low = shape.radius if isinstance(shape, Circle) else -min(y for _, y in shape.outline)
    height = low * (1 - draw.uniform("sunk", 0.0, 0.9))
    body = Body(shape, mass=1, position=(0, height), material=surface)
    run = trial.run(Scene([level_ground(), body], gravity=(0, -GRAVITY)), 2.0, sample=None)
    through = float(run.positions[-1, 1, 1]) < 0.0
    return math.inf if through else max(float(run.velocities[:, 1, 1].max()), 0.0)


@family(
    THEME,
    why="No impulse is right: whatever helps at one wall is wrong at the other.",
    law="What is squeezed stays between the walls, no faster than they are.",
    unit="",
    bound=1.0 + 1e-9,
    reason="the walls' speed",
)
def squeezed(draw: Draw, trial: Trial) -> float:
    """A ball or a box between two blocks that close in: its greatest speed over theirs."""
    speed = draw.log_uniform("speed", 0.01, 10.0)
    shapes: dict[str, Shape] = {"ball": Circle(0.5), "box": Polygon.box(1, 1)}
    shape = shapes[draw.choice("what", ("ball", "box"))]
    blocks = [
        Body(Polygon.box(4, 20), position=(side * 3.0, 0), velocity=(-side * speed, 0))
        for side in (-1.0, 1.0)
    ]
    body = Body(shape, mass=1, position=(draw.uniform("x", -0.2, 0.2), 0))
    run = trial.run(Scene([*blocks, body]), 0.9 / speed, sample=None)
    x = run.positions[:, 2, 0]
    between = bool(((x > run.positions[:, 0, 0]) & (x < run.positions[:, 1, 0])).all())
    return fastest(run) / speed if between else math.inf


@family(
    THEME,
    why="There is no way to lie without overlap, and each step tries again.",
    law="No disc gets out, and none gets any speed.",
    unit="m/s",
    bound=1e-6,
    reason="a millimetre in a quarter of an hour",
)
def crowded_box(draw: Draw, trial: Trial) -> float:
    """9 to 100 discs at rest in a box that is 0 to 20 % too small: greatest speed in 3 s."""
    side, tight = draw.integer("side", 3, 10), draw.uniform("tight", 0.0, 0.2)
    room = side * (1 - tight)
    places = ((np.arange(side) + 0.5) * (room / side)).tolist()
    discs = [
        Body(Circle(0.5), mass=1, position=(x, y), material=Material(0.0))
        for x in places
        for y in places
    ]
    run = trial.run(Scene([*box(room, room, Material(0.0)), *discs]), 3.0, sample=None)
    final = run.positions[-1, free(run.scene)]
    inside = bool(((final > 0) & (final < room)).all())
    return fastest(run) if inside else math.inf


@family(
    THEME,
    why="A ball pressed by a heavy one must not give its way out as a blow.",
    law="Together they never have more energy than at rest in the highest place that one has had.",
    unit="",
    bound=1e-9,
    reason="rounding; pushes may lift a body, and it may fall from there",
)
def dropped_into_each_other(draw: Draw, trial: Trial) -> float:
    """2 to 10 boxes start in one heap above a floor, and fall: gain of energy in 3 s."""
    places, friction = draw.integer("places", 0, 10**6), draw.uniform("friction", 0.0, 1.0)
    count = draw.integer("count", 2, 10)
    run = trial.run(dropped_boxes(places, friction, count), 3.0, sample=None)
    heights = run.positions[:, 1:, 1]
    top = np.maximum.accumulate(heights.max(axis=1))
    gained = run.energy / (GRAVITY * count * top) - 1.0
    return math.inf if (heights[-1] < 0).any() else max(float(gained.max()), 0.0)


def dropped_boxes(places: int, friction: float, count: int) -> Scene:
    """Return boxes that start in one heap above a floor; `places` is the seed of where."""
    rng, surface = np.random.default_rng(places), Material(0.0, friction)
    boxes = [
        Body(
            Polygon.box(1, 1),
            mass=1,
            position=(float(rng.uniform(-0.4, 0.4)), float(rng.uniform(0.6, 1.4))),
            angle=float(rng.uniform(0, math.pi)),
            material=surface,
        )
        for _ in range(count)
    ]
    floor = Body(Segment((-50, 0), (50, 0)), material=surface)
    return Scene([floor, *boxes], gravity=(0, -GRAVITY))
