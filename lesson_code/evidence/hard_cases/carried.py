"""Families of bodies that are carried, left or woken, and of bodies that rest for a long time."""

from __future__ import annotations

import math
from dataclasses import replace

from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.loads import STANDS, tower
from lesson_code.evidence.hard_cases.measures import (
    DT,
    HAIR,
    NO_DRIFT,
    NOT_SEEN,
    free,
    largest,
    start_gap,
    unrest,
)
from lesson_code.evidence.hard_cases.parameters import Draw
from lesson_code.evidence.hard_cases.trial import Trial, family
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, level_ground
from lesson_code.geometry.shapes import Circle, Polygon, Segment

THEME = "Carried, left and woken"

DOWN = (0, -GRAVITY)


def carried(scene: Scene, velocity: tuple[float, float]) -> Scene:
    """Return a scene in which everything, the floor included, moves with one velocity."""
    return Scene([replace(body, velocity=velocity) for body in scene.bodies], scene.gravity)


def left_behind(trial: Trial, scene: Scene, duration: float) -> float:
    """Return how far bodies move against the floor, which is the first body, m."""
    run = trial.run(scene, duration)
    moved = run.positions[-1] - run.positions[0]
    against = moved[free(run.scene)] - moved[0]
    return max(largest(against[:, 0]), largest(against[:, 1]) / len(against))


@family(
    THEME,
    why="The floor moves all the time, so nothing on it is ever at rest.",
    law="In a lift with a constant speed what stands stands.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def lift(draw: Draw, trial: Trial) -> float:
    """A tower of 1 to 6 boxes in a lift, up or down at up to 10 m/s, 4 s: drift against it."""
    count, speed = draw.integer("count", 1, 6), draw.uniform("speed", -10.0, 10.0)
    scene = tower((1.0,) * count, gap=start_gap(draw, count))
    return left_behind(trial, carried(scene, (0.0, speed)), 4.0)


@family(
    THEME,
    why="Friction has to see that floor and box have one velocity, which is not 0.",
    law="On a belt with a constant speed what stands stands.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def ride_on_a_belt(draw: Draw, trial: Trial) -> float:
    """A tower of 1 to 6 boxes rides on a belt at up to 10 m/s, 4 s: drift against it."""
    count, speed = draw.integer("count", 1, 6), draw.uniform("speed", -10.0, 10.0)
    scene = tower((1.0,) * count, gap=start_gap(draw, count))
    return left_behind(trial, carried(scene, (speed, 0.0)), 4.0)


@family(
    THEME,
    why="Friction drives the box until the slip is 0, and not a step longer.",
    law="v = min(mu g t, the belt's)",
    unit="m/s",
    bound=1e-8,
    reason="rounding of 120 steps",
)
def put_on_a_belt(draw: Draw, trial: Trial) -> float:
    """A flat box is put on a moving belt: its speed after 2 s."""
    belt, mu = draw.uniform("belt", 0.5, 10.0), draw.uniform("friction", 0.05, 1.0)
    floor = Body(Segment((-100, 0), (100, 0)), velocity=(belt, 0))
    box = Body(
        Polygon.box(2, 0.5),
        mass=draw.log_uniform("mass", 1e-3, 1e3),
        position=(0, 0.25 - abs(start_gap(draw, most=HAIR))),
        material=Material(0.0, mu),
    )
    run = trial.run(Scene([floor, box], gravity=DOWN), 2.0)
    return abs(float(run.velocities[-1, 1, 0]) - min(mu * GRAVITY * 2.0, belt))


@family(
    THEME,
    why="What rests on the shelf may be asleep when the shelf leaves.",
    law="Nothing stays in the air: it lies on the floor in the end.",
    unit="",
    bound=NOT_SEEN * 2,
    reason="a thousandth of the ball's width",
)
def shelf_drawn_away(draw: Draw, trial: Trial) -> float:
    """A smooth ball lies on a shelf that is drawn away at 0.2 to 20 m/s: its height at the end."""
    speed, radius = draw.log_uniform("speed", 0.2, 20.0), draw.uniform("radius", 0.1, 0.5)
    shelf = Body(Segment((-1, 0), (1, 0)), position=(0, 2), velocity=(speed, 0))
    smooth = Material(0.0, 0.0)
    ball = Body(Circle(radius), mass=1, position=(0, 2 + radius), material=smooth)
    run = trial.run(Scene([level_ground(), shelf, ball], gravity=DOWN), 1 / speed + 3.0)
    return abs(float(run.positions[-1, 2, 1]) / radius - 1)


@family(
    THEME,
    why="A pile that sleeps is not looked at; what hits it has to wake it.",
    law="A blow that comes late does what the same blow does early.",
    unit="m",
    bound=0.05,
    reason="a twentieth of a box: the blow comes in another part of a step",
)
def woken_by_a_blow(draw: Draw, trial: Trial) -> float:
    """A ball hits a tower of 1 to 3 boxes after half a second, and after 4: where they end."""
    speed, count = draw.uniform("speed", 2.0, 6.0), draw.integer("count", 1, 3)
    mass, gap = draw.uniform("mass", 0.5, 2.0), start_gap(draw, count)

    def ends(wait: float) -> list[float]:
        scene = tower((1.0,) * count, gap=gap)
        start = (-0.5 - 0.3 - speed * wait, 0.3)
        ball = Body(Circle(0.3), mass=mass, position=start, velocity=(speed, 0),
                    material=Material(0.0, 0.0))  # fmt: skip
        run = trial.run(Scene([*scene.bodies, ball], gravity=DOWN), wait + 1.0)
        found: list[float] = run.positions[-1, 1:-1, 0].tolist()
        return found

    early, late = ends(30 * DT), ends(240 * DT)
    moved = abs(late[0]) > 1e-3 or abs(early[0]) < 1e-3
    return largest([a - b for a, b in zip(early, late, strict=True)]) if moved else math.inf


@family(
    THEME,
    why="A drift of a thousandth of a millimetre in a second is half a metre in ten minutes.",
    law=STANDS,
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
    is_long=True,
)
def ten_minutes(draw: Draw, trial: Trial) -> float:
    """One or two boxes, or a disc on a box, rest for ten minutes: drift."""
    scene = tower((1.0,) * draw.integer("boxes", 1, 2), gap=start_gap(draw, 2))
    if draw.choice("disc", (0, 1)):
        top = scene.bodies[-1].position[1] + 0.5
        disc = Body(Circle(0.4), mass=1, position=(0, top + 0.4), material=Material(0.0, 0.5))
        scene = Scene([*scene.bodies, disc], gravity=DOWN)
    return unrest(trial.run(scene, 600.0))


@family(
    THEME,
    why="A wall that moves past what stands must not take it along, nor wake it to a jump.",
    law="What nothing touches stays.",
    unit="m",
    bound=NOT_SEEN,
    reason=NO_DRIFT,
)
def passed_closely(draw: Draw, trial: Trial) -> float:
    """A block passes a tower of 1 to 4 boxes at a distance of 0.1 mm to 10 cm, 4 s: drift."""
    count, gap = draw.integer("count", 1, 4), draw.log_uniform("distance", 1e-4, 0.1)
    speed = draw.log_uniform("speed", 0.5, 100.0)
    scene = tower((1.0,) * count)
    block = Body(Polygon.box(1, 1), position=(1.0 + gap, -1 - speed), velocity=(0, speed))
    floor, *boxes = scene.bodies
    half = Body(Polygon.box(1, 1), position=(0, -0.5), material=floor.material)
    return unrest(trial.run(Scene([half, *boxes, block], gravity=DOWN), 4.0))
