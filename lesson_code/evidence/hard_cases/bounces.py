"""Families of bounces. Each happens between two steps, and the errors add up."""

from __future__ import annotations

import math

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.measures import ROUNDING, energy_above, gain, largest
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes import events
from lesson_code.evidence.scenes import gas as disc_gas
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference import closed_forms
from lesson_code.reference.event_closed_forms import block_collisions

THEME = "Bounces"

DOWN = (0, -events.GRAVITY)

ELASTIC = Material(restitution=1.0, friction=0.0)

KEEPS = "With e = 1 and mu = 0 the energy is kept."

BOUNCES = "rounding of some hundred bounces"


def energy_error(run: Run, height: float = 0.0) -> float:
    """Return the largest change of the mechanical energy, in parts of it."""
    energies = energy_above(run, height)
    return largest(energies / energies[0] - 1)


def pit(width: float) -> list[Body]:
    """Return a floor and two walls, 10 m high."""
    lines = [((0, 0), (width, 0)), ((0, 0), (0, 10)), ((width, 0), (width, 10))]
    return [Body(Segment(start, end), material=ELASTIC) for start, end in lines]


def floor() -> Body:
    """Return a level elastic floor."""
    return Body(Segment((-100, 0), (100, 0)), material=ELASTIC)


@family(
    THEME,
    why="Each bounce happens between two steps, and what is lost there adds up.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def ball_over_floor(draw: Draw, trial: Trial) -> float:
    """An elastic ball of any size bounces for 20 s: change of its height."""
    height, radius = draw.log_uniform("height", 1e-2, 10.0), draw.log_uniform("radius", 1e-2, 1.0)
    ball = Body(Circle(radius), mass=1, position=(0, radius + height), material=ELASTIC)
    return energy_error(trial.run(Scene([floor(), ball], gravity=DOWN), 20.0, sample=None), radius)


@family(
    THEME,
    why="A box that lands flat hits with two corners at once.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def box_over_floor(draw: Draw, trial: Trial) -> float:
    """An elastic box of any shape falls flat and bounces for 10 s: change of its height."""
    height, tall = draw.log_uniform("height", 1e-2, 10.0), draw.log_uniform("tall", 0.02, 2.0)
    box = Body(Polygon.box(1, tall), mass=1, position=(0, tall / 2 + height), material=ELASTIC)
    run = trial.run(Scene([floor(), box], gravity=DOWN), 10.0, sample=None)
    return energy_error(run, tall / 2)


@family(
    THEME,
    why="A corner hits beside the centre: height and spin are exchanged at each bounce.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def polygon_over_floor(draw: Draw, trial: Trial) -> float:
    """An elastic polygon of 3 to 8 corners bounces tumbling for 10 s: change of energy."""
    body = Body(
        Polygon.regular(draw.integer("sides", 3, 8), 0.5),
        mass=1,
        position=(0, 0.6 + draw.uniform("height", 0.1, 3.0)),
        angle=draw.uniform("angle", 0.0, math.pi),
        angular_velocity=draw.uniform("spin", -5.0, 5.0),
        material=ELASTIC,
    )
    return energy_error(trial.run(Scene([floor(), body], gravity=DOWN), 10.0, sample=None))


@family(
    THEME,
    why="Walls beside the floor change who solves the scene, and must not change the bounce.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def ball_in_pit(draw: Draw, trial: Trial) -> float:
    """An elastic ball bounces between the walls of a pit for 10 s: change of energy."""
    width = draw.uniform("width", 1.0, 5.0)
    ball = Body(
        Circle(draw.uniform("radius", 0.1, 0.4)),
        mass=1,
        position=(width / 2, draw.uniform("height", 0.5, 5.0)),
        velocity=(draw.uniform("speed", -3.0, 3.0), 0),
        material=ELASTIC,
    )
    return energy_error(trial.run(Scene([*pit(width), ball], gravity=DOWN), 10.0, sample=None))


@family(
    THEME,
    why="They hit each other, the walls and the floor, sometimes in one step.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def balls_in_pit(draw: Draw, trial: Trial) -> float:
    """2 to 6 elastic balls of different masses in a pit, 4 s: change of energy."""
    balls = [
        Body(
            Circle(draw.uniform(f"radius_{n}", 0.1, 0.4)),
            mass=draw.log_uniform(f"mass_{n}", 0.1, 10.0),
            position=(0.6 + 0.9 * n, draw.uniform(f"height_{n}", 0.5, 4.0)),
            velocity=(draw.uniform(f"speed_{n}", -2.0, 2.0), 0),
            material=ELASTIC,
        )
        for n in range(draw.integer("count", 2, 6))
    ]
    scene = Scene([*pit(0.3 + 0.9 * len(balls)), *balls], gravity=DOWN)
    return energy_error(trial.run(scene, 4.0, sample=None))


@family(
    THEME,
    why="Each polygon that has come to rest is hit by the next one.",
    law="Energy never grows, and nothing leaves the pit.",
    unit="",
    bound=ROUNDING,
    reason="rounding of some hundred dull impacts",
)
def polygons_fall_into_pit(draw: Draw, trial: Trial) -> float:
    """2 to 6 dull polygons fall into a pit of 3 m, with any friction, 4 s: gain of energy."""
    surface = Material(0.0, draw.uniform("friction", 0.0, 1.0))
    bodies = [
        Body(
            Polygon.regular(draw.integer(f"sides_{n}", 3, 7), draw.uniform(f"size_{n}", 0.2, 0.5)),
            mass=1,
            position=(draw.uniform(f"x_{n}", 0.6, 2.4), 0.7 + 1.1 * n),
            angle=draw.uniform(f"angle_{n}", 0.0, math.pi),
            material=surface,
        )
        for n in range(draw.integer("count", 2, 6))
    ]
    run = trial.run(Scene([*pit(3.0), *bodies], gravity=DOWN), 4.0, sample=None)
    x, y = np.moveaxis(run.positions[:, 3:], -1, 0)
    inside = bool(((x > 0) & (x < 3) & (y > 0)).all())
    return gain(energy_above(run)) if inside else math.inf


@family(
    THEME,
    why="A contact found late is found faster, and deeper, than it was.",
    law="The closed form of a bouncing ball",
    unit="",
    bound=ROUNDING,
    reason="rounding, relative to the height of the drop",
)
def rebounds(draw: Draw, trial: Trial) -> float:
    """A ball dropped from 1 mm to 10 m with any e: error of its height during three falls."""
    height, e = draw.log_uniform("height", 1e-3, 10.0), draw.uniform("restitution", 0.0, 1.0)
    duration = 3 * math.sqrt(2 * height / events.GRAVITY)
    times = np.linspace(0, duration, 101)
    run = trial.run(events.bouncing_to_rest(e, height), duration, sample=times)
    right = closed_forms.bouncing_ball(times, height, e, events.GRAVITY)
    return largest(run.positions[:, 1, 1] - 0.5 - right) / height


@family(
    THEME,
    why="Infinitely many bounces happen in a finite time.",
    law="It rests from sqrt(2 h / g) (1 + e) / (1 - e) on.",
    unit="m",
    bound=1e-9,
    reason="a bounce of 1e-9 m lasts 3e-5 s",
)
def zeno(draw: Draw, trial: Trial) -> float:
    """A ball with any e below 0.95 bounces to rest: its height, or speed, a moment later."""
    height, e = draw.log_uniform("height", 1e-3, 3.0), draw.uniform("restitution", 0.0, 0.95)
    rest = closed_forms.rest_time(height, e, events.GRAVITY)
    run = trial.run(events.bouncing_to_rest(e, height), rest + 0.1)
    return max(abs(float(run.positions[-1, 1, 1]) - 0.5), largest(run.velocities[-1, 1]))


@family(
    THEME,
    why="Each wall is hit between two steps, and the errors of the place add up.",
    law="Unfolded, the ball flies straight on.",
    unit="m",
    bound=1e-11,
    reason="rounding of some hundred bounces",
)
def ball_in_box(draw: Draw, trial: Trial) -> float:
    """An elastic ball in a box of any size, without gravity, 10 s: error of its place."""
    width, height = draw.uniform("width", 1.0, 5.0), draw.uniform("height", 1.0, 5.0)
    start, radius = (0.5 * width, 0.4 * height), draw.uniform("radius", 0.01, 0.3)
    speed = draw.uniform("vx", -10.0, 10.0), draw.uniform("vy", -10.0, 10.0)
    ball = Body(Circle(radius), mass=1, position=start, velocity=speed, material=ELASTIC)
    run = trial.run(Scene([*events.box(width, height), ball]), 10.0)
    right, _ = closed_forms.ball_in_box(start, speed, radius, width, height, time=10.0)
    return float(np.hypot(*(run.positions[-1, events.WALLS] - right)))


@family(
    THEME,
    why="The last of the hits come in a swarm, and each one counts.",
    law="Galperin: ceil(pi / atan(1 / sqrt(M))) - 1 collisions",
    unit="",
    bound=0.0,
    reason="a count is right or wrong",
)
def blocks_and_wall(draw: Draw, trial: Trial) -> float:
    """A block pushes a lighter one against a wall, 3 to 3000 collisions: error of their count."""
    count = int(draw.log_uniform("count", 3.0, 3000.0))
    theta = math.pi / (count + draw.uniform("margin", 0.2, 0.8))  # the last hit is not late
    ratio = 1 / math.tan(theta) ** 2
    run = trial.run(events.two_blocks(ratio), 20.0)
    return abs(len(run.contacts) - block_collisions(ratio))


@family(
    THEME,
    why="Each hit doubles an error; steps make errors that do not undo themselves.",
    law="Newton's laws are the same backwards in time.",
    unit="m",
    bound=1e-9,
    reason="rounding, doubled by up to 9 hits of each disc there and 9 back, and some room",
)
def gas_there_and_back(draw: Draw, trial: Trial) -> float:
    """A gas of 2 to 36 discs, forwards for a second and back: how far it is from its start."""
    count, covered = draw.integer("count", 2, 36), draw.uniform("covered", 0.1, 0.38)
    gas = disc_gas.gas_of(count, covered, seed=draw.integer("velocities", 0, 10**6))
    run = trial.run(gas, 1.0)
    return events.error_after_return(run, trial.run(events.turned_back(run), 1.0))


@family(
    THEME,
    why="A little lost or won at each hit is a lot after thousands.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason="rounding of some thousand hits",
)
def gas_energy(draw: Draw, trial: Trial) -> float:
    """A gas of 2 to 64 discs, 10 s: change of energy; infinite if a disc escapes."""
    count, covered = draw.integer("count", 2, 64), draw.uniform("covered", 0.05, 0.38)
    gas = disc_gas.gas_of(count, covered, seed=draw.integer("velocities", 0, 10**6))
    run = trial.run(gas, 10.0)
    places = run.positions[-1, events.WALLS :]
    length = max(y for _, y in gas.bodies[1].shape.outline)  # the wall at the top
    inside = bool(((places > 0) & (places < length)).all())
    change = abs(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1)
    return change if inside else math.inf


@family(
    THEME,
    why="Every hit makes the ball faster, and the next hit come sooner.",
    law="v' = v + 2 u at each hit of a wall that comes with u",
    unit="m/s",
    bound=1e-9,
    reason="rounding of some hundred hits",
)
def closing_walls(draw: Draw, trial: Trial) -> float:
    """A ball between two walls that come nearer until half of the room is left: its speed."""
    room, u = draw.uniform("room", 2.0, 10.0), draw.log_uniform("wall_speed", 0.02, 1.0)
    speed, side = draw.uniform("speed", 0.5, 3.0), Segment((0, -1), (0, 1))
    walls = [Body(side, material=ELASTIC), Body(side, position=(room + 1, 0), velocity=(-u, 0))]
    ball = Body(Circle(0.5), mass=1, position=(0.5, 0), velocity=(speed, 0), material=ELASTIC)
    duration = 0.5 * room / u
    run = trial.run(Scene([*walls, ball]), duration)
    expected = speed_between_closing_walls(room, u, speed, duration)
    return abs(abs(float(run.velocities[-1, 2, 0])) - expected)


def speed_between_closing_walls(room: float, wall: float, speed: float, seconds: float) -> float:
    """Return the ball's exact speed, m/s: it gains twice the wall's at each hit of it."""
    clock = 0.0
    while True:
        until = room / (speed + wall)
        if clock + until > seconds:
            return speed
        clock, room, speed = clock + until, room - wall * until, speed + 2 * wall
        back = room / speed
        if clock + back > seconds:
            return speed
        clock, room = clock + back, room - wall * back


@family(
    THEME,
    why="Corners hit while they turn: velocity and spin are exchanged in each hit.",
    law=KEEPS,
    unit="",
    bound=ROUNDING,
    reason=BOUNCES,
)
def tumbling_polygon(draw: Draw, trial: Trial) -> float:
    """An elastic polygon tumbles in a closed box for 10 s: change of energy; infinite outside."""
    body = Body(
        Polygon.regular(draw.integer("sides", 3, 7), draw.uniform("size", 0.2, 0.8)),
        mass=1,
        position=(2.0, 1.5),
        angle=draw.uniform("angle", 0.0, math.pi),
        velocity=(draw.uniform("vx", -5.0, 5.0), draw.uniform("vy", -5.0, 5.0)),
        angular_velocity=draw.uniform("spin", -5.0, 5.0),
        material=ELASTIC,
    )
    run = trial.run(Scene([*events.box(4.0, 3.0), body]), 10.0, sample=None)
    places = run.positions[:, events.WALLS :]
    inside = bool(((places >= 0) & (places <= (4.0, 3.0))).all())
    return largest(run.kinetic_energy / run.kinetic_energy[0] - 1) if inside else math.inf
