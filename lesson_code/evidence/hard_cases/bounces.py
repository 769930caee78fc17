"""Hard cases: bounces. Each happens between two steps, and the errors add up."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import largest
from lesson_code.evidence.scenes import events as exact_scenes
from lesson_code.evidence.scenes import gas as disc_gas
from lesson_code.geometry.shapes import Circle, Polygon, Segment
from lesson_code.reference import closed_forms
from lesson_code.reference.event_closed_forms import block_collisions

THEME = "Bounces"


def energy_error(trial: Trial) -> float:
    """Return the largest relative change of the energy in 60 s."""
    run = trial.run(60.0)
    above = run.energy - np.asarray(trial.scene.gravity) @ np.array([0, -0.5])
    return largest(above / above[0] - 1)


RESTITUTIONS = (0.3, 0.5, 0.8, 0.95)


def rebound_error(trial: Trial) -> float:
    """Return the largest error of the first bounce's height, relative to the drop."""
    worst = 0.0
    for e in RESTITUTIONS:
        height = 2.0
        top = closed_forms.bounce_times(height, e, 2, exact_scenes.GRAVITY)
        middle = float(np.mean(top))
        times = np.linspace(float(top[0]), float(top[1]), 401)
        times = np.sort(np.append(times, middle))
        run = trial.run(float(top[1]), exact_scenes.bouncing_to_rest(e, height), sample=times)
        rise = float(run.positions[:, 1, 1].max()) - 0.5
        worst = max(worst, abs(rise / height - e * e))
    return worst


def height_error(duration: float, restitution: float, height: float = 1.0) -> Any:
    """Return a measure: the largest error of a bouncing ball's height, m."""

    def measure(trial: Trial) -> float:
        times = np.linspace(0, duration, 301)
        run = trial.run(duration, sample=times)
        right = closed_forms.bouncing_ball(times, height, restitution, exact_scenes.GRAVITY)
        return largest(run.positions[:, 1, 1] - 0.5 - right)

    return measure


def box_error(trial: Trial) -> float:
    """Return how far the ball in the box is from the closed form in 10 s, m."""
    run = trial.run(10.0, sample=np.linspace(0, 10, 101))
    return largest(exact_scenes.error_in_the_box(run))


PI_RATIO = 1e6
"""Mass of the heavy block over the light one's: 3141 collisions."""


def pi_error(trial: Trial) -> float:
    """Return the error in the number of collisions of two blocks and a wall."""
    run = trial.run(1e3 if trial.solver == "auto" else 10.0, sample="end")
    return abs(len(run.contacts) - block_collisions(PI_RATIO))


def return_error(trial: Trial) -> float:
    """Return how far a gas is from its start after a run forwards and back, m."""
    run = trial.run(1.0, sample="end")
    back = trial.run(1.0, exact_scenes.turned_back(run), sample="end")
    return exact_scenes.error_after_return(run, back)


def gas() -> Scene:
    """Return 64 elastic discs in a box, half of which they cover."""
    return disc_gas.disc_gas(8, covered=0.5, seed=1)


def gas_energy_error(trial: Trial) -> float:
    """Return the relative change of a gas's energy in 20 s; infinite if a disc escapes."""
    run = trial.run(20.0, sample="end")
    length = max(y for _, y in trial.scene.bodies[1].shape.outline)  # the wall at the top
    if not stays_inside(run, length, length):
        return math.inf
    return abs(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1)


WALL_SPEED, BALL_SPEED, ROOM = 0.1, 1.0, 10.0
"""m/s, m/s, m: speed of the moving wall, speed of the ball, room for the ball."""


def closing_walls() -> Scene:
    """Return a fixed wall, an approaching wall, and an elastic ball between them."""
    smooth = Material(restitution=1.0)
    side = Segment((0, -1), (0, 1))
    return Scene(
        [
            Body(side, material=smooth),
            Body(side, position=(ROOM + 1, 0), velocity=(-WALL_SPEED, 0), material=smooth),
            Body(Circle(0.5), mass=1, position=(0.5, 0), velocity=(BALL_SPEED, 0), material=smooth),
        ]
    )


def speed_between_closing_walls(seconds: float) -> float:
    """Return the ball's exact speed: it gains 2 u at each hit of the moving wall."""
    room, speed, x, clock = ROOM, BALL_SPEED, 0.0, 0.0
    while True:
        until = (room - x) / (speed + WALL_SPEED)
        if clock + until > seconds:
            return speed
        clock, room = clock + until, room - WALL_SPEED * until
        speed += 2 * WALL_SPEED
        back = room / speed
        if clock + back > seconds:
            return speed
        clock, room, x = clock + back, room - WALL_SPEED * back, 0.0


def closing_error(trial: Trial) -> float:
    """Return the error of the ball's speed after 80 s, m/s."""
    run = trial.run(80.0, sample="end")
    return abs(abs(float(run.velocities[-1, 2, 0])) - speed_between_closing_walls(80.0))


TUMBLING_BOX = (4.0, 3.0)
"""m: width and height."""


def stays_inside(run: Run, width: float, height: float) -> bool:
    """Return whether every centre stays inside a box at the origin."""
    places = run.positions[:, exact_scenes.WALLS :]
    return bool(((places >= 0) & (places <= (width, height))).all())


def tumbling_square() -> Scene:
    """Return an elastic square that tumbles in a box of 4 m by 3 m."""
    square = Body(
        Polygon.box(0.6, 0.6),
        mass=1,
        position=(1.7, 1.2),
        angle=0.3,
        velocity=(1.3, 0.7),
        angular_velocity=2.0,
        material=exact_scenes.ELASTIC,
    )
    return Scene([*exact_scenes.box(*TUMBLING_BOX), square])


def kinetic_error(trial: Trial) -> float:
    """Return the largest relative change of the kinetic energy in 60 s; infinite outside."""
    run = trial.run(60.0)
    if not stays_inside(run, *TUMBLING_BOX):
        return math.inf
    return largest(run.kinetic_energy / run.kinetic_energy[0] - 1)


CASES = (
    HardCase(
        name="bounce-60-s",
        theme=THEME,
        title="An elastic ball, 60 s, 67 bounces",
        why="Each bounce happens between two steps, and what is lost there adds up.",
        law="E = m v^2 / 2 + m g h",
        scene=partial(exact_scenes.bouncing_to_rest, 1.0),
        measure=energy_error,
        unit="",
        bound=1e-12,
        reason="rounding of 67 bounces",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="rebound",
        theme=THEME,
        title="Rebound from 2 m with e = 0.3, 0.5, 0.8, 0.95",
        why="A contact found late is found faster, and deeper, than it was.",
        law="height after / height before = e^2",
        scene=partial(exact_scenes.bouncing_to_rest, 0.5, 2.0),
        measure=rebound_error,
        unit="",
        bound=1e-12,
        reason="rounding",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="slow-bounce",
        theme=THEME,
        title="An elastic ball dropped from 4 cm, 2 s",
        why="Box2D takes what is slower than 1 m/s for rest; a real ball still bounces.",
        law="The closed form of a bouncing ball",
        scene=partial(exact_scenes.bouncing_to_rest, 1.0, 0.04),
        measure=height_error(2.0, 1.0, 0.04),
        unit="m",
        bound=1e-12,
        reason="rounding of 11 bounces",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="zeno",
        theme=THEME,
        title="A ball that bounces to rest, e = 0.8",
        why="Infinitely many bounces in 4.02 s; then it has to lie still.",
        law="T = sqrt(2 h / g) (1 + e) / (1 - e)",
        scene=partial(exact_scenes.bouncing_to_rest, 0.8),
        measure=height_error(6.0, 0.8),
        unit="m",
        bound=1e-12,
        reason="rounding of 138 bounces",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="ball-in-box",
        theme=THEME,
        title="A ball in a box, 10 s",
        why="A bounce that is late by a part of a step stays late.",
        law="The box unfolded: a straight line",
        scene=exact_scenes.ball_in_a_box,
        measure=box_error,
        unit="m",
        bound=1e-13,
        reason="rounding of ten bounces",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="pi-blocks",
        theme=THEME,
        title="Two blocks and a wall, 1,000,000 : 1",
        why="3141 collisions, most of them in a gap of a millimetre.",
        law="Galperin: the digits of pi",
        scene=partial(exact_scenes.two_blocks, PI_RATIO),
        measure=pi_error,
        unit="",
        bound=0.0,
        reason="a count is right or wrong",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="time-reversal",
        theme=THEME,
        title="A gas of 64 discs, there and back in 2 s",
        why="Each hit doubles an error; steps make errors that do not undo themselves.",
        law="Newton's laws are the same backwards in time.",
        scene=gas,
        measure=return_error,
        unit="m",
        bound=1e-9,
        reason="rounding, doubled by 9 hits of each disc there and 9 back, and some room",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="gas-energy",
        theme=THEME,
        title="A gas of 64 discs, 20 s, thousands of hits",
        why="A little lost or won at each hit is a lot after thousands.",
        law="Elastic collisions keep the energy.",
        scene=gas,
        measure=gas_energy_error,
        unit="",
        bound=1e-12,
        reason="rounding of thousands of hits, which mostly cancels",
        failed_by=("naive", "pymunk", "box2d"),
    ),
    HardCase(
        name="closing-walls",
        theme=THEME,
        title="A ball between two walls that come nearer, 80 s",
        why="Every hit makes the ball faster, and the next hit come sooner.",
        law="v' = v + 2 u at each hit of a wall that comes with u",
        scene=closing_walls,
        measure=closing_error,
        unit="m/s",
        bound=1e-12,
        reason="rounding of 39 hits",
        failed_by=("box2d",),
    ),
    HardCase(
        name="tumbling-square",
        theme=THEME,
        title="An elastic square tumbles in a box, 60 s",
        why="Corners hit while they turn: velocity and spin are exchanged in each hit.",
        law="Without friction and with e = 1 the energy is kept.",
        scene=tumbling_square,
        measure=kinetic_error,
        unit="",
        bound=1e-12,
        reason="rounding of 44 hits",
        failed_by=("naive", "box2d"),
    ),
)
