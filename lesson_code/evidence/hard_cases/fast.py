"""Families of fast bodies. A step can jump over a contact, which its end does not show."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import DT, ROUNDING, angle_of, largest
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import events
from lesson_code.formulas import elastic_1d
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape

THEME = "Fast bodies"

FASTEST = 1e7
"""m/s."""

THROUGH = "Nothing passes through a wall."

NEVER = "what is in front of a wall is never behind it"

SEEN = 12
"""How many states are looked at, at drawn times: most lie between two steps."""


def drawn_times(draw: Draw, duration: float) -> np.ndarray:
    """Return times at which a run is looked at, and its end, s."""
    rng = np.random.default_rng(draw.integer("times", 0, 10**6))
    return np.append(np.sort(rng.uniform(0.0, duration, SEEN)), duration)


def bullet(draw: Draw, surface: Material) -> tuple[Shape, float, Material]:
    """Return a ball, or a box that turns, its greatest radius, m, and its surface."""
    size = draw.uniform("size", 0.05, 0.3)
    if draw.choice("bullet", ("ball", "box")) == "ball":
        return Circle(size), size, surface
    return Polygon.box(size, size), size / math.sqrt(2), surface


@family(
    THEME,
    why="In one step they move by up to ten million times the thickness of the wall.",
    law=THROUGH,
    unit="",
    bound=0.0,
    reason=NEVER,
)
def balls_at_wall(draw: Draw, trial: Trial) -> float:
    """Ten balls at 1 to 1e7 m/s at a wall of 0.1 mm to 10 cm: share that gets through."""
    speed = draw.log_uniform("speed", 1.0, FASTEST)
    thickness = draw.log_uniform("thickness", 1e-4, 0.1)
    scene = events.balls_at_wall(speed, count=10, dt=DT, thickness=thickness)
    run = trial.run(scene, 1 / speed + 3 * DT, sample=drawn_times(draw, 1 / speed + 3 * DT))
    return float(np.mean((run.positions[:, 1:, 0] > 0).any(axis=0)))


@family(
    THEME,
    why="A corner is hit while the body turns, on one wall and then on the other.",
    law=THROUGH,
    unit="",
    bound=0.0,
    reason=NEVER,
)
def into_a_corner(draw: Draw, trial: Trial) -> float:
    """A ball or a turning box at 1 to 1e7 m/s flies into a corner: is it ever beyond a wall?"""
    e, mu = draw.uniform("restitution", 0.0, 1.0), draw.choice("friction", (0.0, 0.5))
    shape, _, surface = bullet(draw, Material(e, mu))
    speed, aim = draw.log_uniform("speed", 1.0, FASTEST), angle_of(draw, "aim", 5.0, 85.0)
    start = (1.0 + draw.uniform("x", 0.0, 1.0), 1.0 + draw.uniform("y", 0.0, 1.0))
    body = Body(
        shape,
        mass=1,
        position=start,
        velocity=(-speed * math.cos(aim), -speed * math.sin(aim)),
        angular_velocity=draw.uniform("spin", -20.0, 20.0),
        material=surface,
    )
    walls = [Body(Segment((-1, 0), (1e3, 0))), Body(Segment((0, -1), (0, 1e3)))]
    duration = 4.0 / speed + 3 * DT
    run = trial.run(Scene([*walls, body]), duration, sample=drawn_times(draw, duration))
    return float((run.positions[:, 2] < 0).any())


@family(
    THEME,
    why="The wall moves; an engine that looks out along the ball's way alone misses it.",
    law="v' = 2 u",
    unit="",
    bound=ROUNDING,
    reason="rounding, relative to the speed of the plate",
)
def moving_plate(draw: Draw, trial: Trial) -> float:
    """A plate of 0.1 mm to 10 cm comes at 1 to 1e7 m/s and hits a ball at rest: its speed."""
    speed = draw.log_uniform("speed", 1.0, FASTEST)
    half, radius = draw.log_uniform("thickness", 1e-4, 0.1) / 2, draw.uniform("radius", 0.05, 0.5)
    way = draw.uniform("phase", 0.0, 2.0) * speed * DT + 1e-3
    plate = Segment((0, -1), (0, 1), radius=half)
    scene = Scene(
        [
            Body(plate, position=(-half - radius - way, 0), velocity=(speed, 0)),
            Body(Circle(radius), mass=1, material=events.ELASTIC),
        ]
    )
    run = trial.run(scene, way / speed + 3 * DT)
    return largest(run.velocities[-1, 1] / speed - [2.0, 0.0])


@family(
    THEME,
    why="Both bodies move; an engine that looks out for walls alone misses the plate.",
    law="The closed form of an elastic collision, smooth and through the centre",
    unit="",
    bound=ROUNDING,
    reason="rounding of the place at which the ball meets the plate",
)
def free_plate(draw: Draw, trial: Trial) -> float:
    """A ball at 1 to 1e7 m/s hits a free plate of any mass, 1 mm to 10 cm thick: both speeds."""
    speed, mass = draw.log_uniform("speed", 1.0, FASTEST), draw.log_uniform("mass", 1e-2, 1e2)
    thickness = draw.log_uniform("thickness", 1e-3, 0.1)
    way = draw.uniform("phase", 0.0, 2.0) * speed * DT + 1e-3
    plate = Body(Polygon.box(thickness, 2), mass=mass, material=events.ELASTIC)
    ball = Body(
        Circle(0.1),
        mass=1,
        position=(-thickness / 2 - 0.1 - way, 0),
        velocity=(speed, 0),
        material=events.ELASTIC,
    )
    run = trial.run(Scene([plate, ball]), way / speed + 3 * DT)
    ball_after, plate_after = elastic_1d(1.0, speed, mass, 0.0)
    found = run.velocities[-1, :, 0] - [plate_after, ball_after]
    return largest(found) / speed


@family(
    THEME,
    why="The rod's middle stands still; only its ends are fast.",
    law="A ball in the way of a rod is hit.",
    unit="",
    bound=0.0,
    reason="a ball in the way is in the way",
)
def turning_rod(draw: Draw, trial: Trial) -> float:
    """A rod that turns at 1 to 1000 rad/s sweeps over a ball: is it missed?"""
    turning = draw.log_uniform("turning", 1.0, 1000.0)
    scene = events.turning_rod(turning, phase=draw.uniform("phase", 0.0, 1.0), dt=DT)
    run = trial.run(scene, 0.6 / turning + 3 * DT)
    return float(not run.velocities[-1, 1].any())


@family(
    THEME,
    why="Some thousand bounces, and one missed is the last.",
    law="What is inside stays inside.",
    unit="m",
    bound=0.0,
    reason="the centre is never beyond a wall, also between two steps",
)
def ball_in_cage(draw: Draw, trial: Trial) -> float:
    """A ball at 10 to 1e4 m/s in a closed box of thin walls, 0.2 s: how far it is ever outside."""
    speed, aim = draw.log_uniform("speed", 10.0, 1e4), angle_of(draw, "aim", 0.0, 360.0)
    ball = Body(
        Circle(draw.uniform("radius", 0.01, 0.4)),
        mass=1,
        position=(2.0, 1.5),
        velocity=(speed * math.cos(aim), speed * math.sin(aim)),
        material=Material(draw.uniform("restitution", 0.5, 1.0), 0.0),
    )
    return outside(draw, trial, ball)


@family(
    THEME,
    why="Its corners are faster than its centre, and hit while it turns.",
    law="What is inside stays inside.",
    unit="m",
    bound=0.0,
    reason="the centre is never beyond a wall, also between two steps",
)
def box_in_cage(draw: Draw, trial: Trial) -> float:
    """A turning box at 10 to 1e4 m/s in a closed box, any e and mu, 0.2 s: how far outside."""
    speed, aim = draw.log_uniform("speed", 10.0, 1e4), angle_of(draw, "aim", 0.0, 360.0)
    box = Body(
        Polygon.box(draw.uniform("width", 0.1, 1.0), draw.uniform("height", 0.1, 1.0)),
        mass=1,
        position=(2.0, 1.5),
        velocity=(speed * math.cos(aim), speed * math.sin(aim)),
        angular_velocity=draw.uniform("spin", -20.0, 20.0),
        material=Material(draw.uniform("restitution", 0.0, 1.0), draw.uniform("friction", 0, 1)),
    )
    return outside(draw, trial, box)


def outside(draw: Draw, trial: Trial, body: Body) -> float:
    """Return how far a body's centre is ever outside a box of 4 m by 3 m in 0.2 s, m."""
    run = trial.run(Scene([*events.box(4.0, 3.0), body]), 0.2, sample=drawn_times(draw, 0.2))
    places = run.positions[:, events.WALLS]
    return float(np.max(np.maximum(np.maximum(-places, places - [4.0, 3.0]), 0.0)))


@family(
    THEME,
    why="It moves through all of them in a step.",
    law="What is on top stays on top.",
    unit="m",
    bound=0.05,
    reason="half of the ball's radius: the pile gives a little",
)
def shot_at_tower(draw: Draw, trial: Trial) -> float:
    """A ball of 1 to 30 g falls at 10 to 3000 m/s on 1 to 4 boxes: how deep it is seen in them."""
    speed, count = draw.log_uniform("speed", 10.0, 3e3), draw.integer("count", 1, 4)
    high = count + 0.1 + draw.uniform("phase", 0.5, 1.5) * speed * DT
    dull = Material(0.0, 0.5)
    boxes = [
        Body(Polygon.box(1, 1), mass=1, position=(0, 0.5 + n), material=dull) for n in range(count)
    ]
    ball = Body(
        Circle(0.1),
        mass=draw.log_uniform("mass", 1e-3, 0.03),
        position=(draw.uniform("beside", -0.1, 0.1), high),
        velocity=(0, -speed),
    )
    scene = Scene([Body(Segment((-50, 0), (50, 0))), *boxes, ball], gravity=(0, -10))
    run = trial.run(scene, 0.1, sample=drawn_times(draw, 0.1))
    return max(count - float(run.positions[:, -1, 1].min()), 0.0)


@family(
    THEME,
    why="Between two steps an engine draws a straight line, and the line goes through the floor.",
    law="A ball is never in the floor, at no time.",
    unit="",
    bound=1e-2,
    reason="a hundredth of a radius",
)
def seen_between_steps(draw: Draw, trial: Trial) -> float:
    """A ball thrown down at 1 to 1e4 m/s, any e: how deep it is seen in the floor, in radii."""
    speed, radius = draw.log_uniform("speed", 1.0, 1e4), draw.log_uniform("radius", 0.05, 0.5)
    phase = draw.choice("phase", (0.0, draw.uniform("phase_of", 0.0, 5.0)))
    ball = Body(
        Circle(radius),
        mass=1,
        position=(0, radius + phase * speed * DT),
        velocity=(draw.uniform("aside", -1.0, 1.0), -speed),
        material=Material(draw.uniform("restitution", 0.0, 1.0), 0.0),
    )
    scene = Scene([Body(Segment((-50, 0), (50, 0))), ball], gravity=(0, -10))
    run = trial.run(scene, 0.12, sample=drawn_times(draw, 0.12))
    return max(radius - float(run.positions[:, 1, 1].min()), 0.0) / radius


@family(
    THEME,
    why="Each is far beyond the other before the step in which they meet has ended.",
    law="The closed form of an elastic collision",
    unit="",
    bound=ROUNDING,
    reason="rounding, relative to the speed",
)
def two_fast_bodies(draw: Draw, trial: Trial) -> float:
    """Two balls, or two boxes, meet head on at 1 to 1e7 m/s: both speeds."""
    speed, mass = draw.log_uniform("speed", 1.0, FASTEST), draw.log_uniform("mass", 1e-2, 1e2)
    shapes: dict[str, Shape] = {"balls": Circle(0.1), "boxes": Polygon.box(0.2, 0.2)}
    shape = shapes[draw.choice("what", ("balls", "boxes"))]
    way = draw.uniform("phase", 0.0, 2.0) * speed * DT + 1e-3
    bodies = [
        Body(
            shape,
            mass=m,
            position=(side * (0.1 + way), 0),
            velocity=(-side * speed, 0),
            material=events.ELASTIC,
        )
        for side, m in ((-1.0, 1.0), (1.0, mass))
    ]
    run = trial.run(Scene(bodies), way / speed + 3 * DT)
    expected = elastic_1d(1.0, speed, mass, -speed)
    return largest(run.velocities[-1, :, 0] - expected) / speed
