"""Hard cases: impacts with friction."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.hard_cases.case import HardCase, Trial
from lesson_code.evidence.hard_cases.measures import STEP, TOUCH, end_state, largest
from lesson_code.evidence.scenes import corner_impacts, spinning_discs
from lesson_code.evidence.scenes.rigid_bodies import box_landing_flat
from lesson_code.geometry.shapes import Circle, Segment
from lesson_code.reference import impact_closed_forms as closed

THEME = "Rough impacts"

ENERGETIC = {"solver": "auto", "restitution_law": "energetic"}


IMPACTS, BATCH, PITCH = 15_000, 500, 6.0
"""Number of random impacts, impacts in a scene, and the distance between two of them, m."""


def many_corners(count: int, seed: int) -> Scene:
    """Return boxes that hit a long rough floor with one corner, far from one another.

    Each has its own restitution and friction: the floor leaves both to the boxes.
    """
    rng = np.random.default_rng(seed)
    boxes = []
    for n in range(count):
        width, height = (10 ** rng.uniform(-1, 0.5, 2)).tolist()
        box, _ = corner_impacts.box_on_corner(
            width,
            height,
            angle=rng.uniform(0.2, 1.3),
            velocity=(rng.uniform(-3, 3), rng.uniform(-4, -1)),
            angular_velocity=rng.uniform(-2, 2),
            surface=Material(rng.uniform(0, 1), rng.uniform(0, 1.5)),
        )
        x, y = box.position
        boxes.append(replace(box, position=(x + (n - count / 2) * PITCH, y)))
    floor = Body(Segment((-count * PITCH, 0), (count * PITCH, 0)))
    return Scene([floor, *boxes])


def energy_of_each(scene: Scene, velocities: Any, spins: Any) -> Any:
    """Return the kinetic energy of every body but the floor, J."""
    bodies = scene.bodies[1:]
    mass, inertia = (np.array([getattr(b, n) for b in bodies]) for n in ("mass", "inertia"))
    return (mass * (velocities[1:] ** 2).sum(axis=1) + inertia * spins[1:] ** 2) / 2


def gains_in(run: Run) -> int:
    """Return how many bodies of a run end with more energy than they began with."""
    before, after = (
        energy_of_each(run.scene, run.velocities[n], run.angular_velocities[n]) for n in (0, -1)
    )
    return int(np.count_nonzero(after > before * (1 + SAME)))


SAME = 1e-10
"""Relative: a smaller difference of energies is rounding."""


def gains(trial: Trial) -> float:
    """Return how many of the random impacts end with more energy than they began with."""
    batches = (many_corners(BATCH, seed) for seed in range(IMPACTS // BATCH))
    return float(
        sum(gains_in(trial.run(corner_impacts.STEP, scene, sample="end")) for scene in batches)
    )


def rod_on_floor(
    angle: float, vx: float, vy: float, w: float = 0.0, e: float = 0.0, mu: float = 2.0
) -> Scene:
    """Return a rod of 1 kg and 2 m whose lower tip is just in a rough floor."""
    surface = Material(e, mu)
    rod = Body(
        Segment((-1, 0), (1, 0)),
        mass=1,
        position=(0, math.sin(angle) - TOUCH),
        angle=angle,
        velocity=(vx, vy),
        angular_velocity=w,
        material=surface,
    )
    return Scene([Body(Segment((-50, 0), (50, 0)), material=surface), rod])


KANE = {"angle": math.pi / 4, "vx": 0.0, "vy": -1.0, "w": 2.0, "e": 1.0, "mu": 1.0}
"""A rod that falls and turns, and does not slide at first. By Newton's rule with e = 1 this
off-centre impact raises the energy by 56 %."""


def energy_gain(trial: Trial) -> float:
    """Return the relative gain of kinetic energy in one impact; 0 if there is none."""
    run = trial.run(STEP, sample="end")
    return max(float(run.kinetic_energy[-1] / run.kinetic_energy[0]) - 1, 0.0)


def limit_cycle_error(trial: Trial) -> float:
    """Return the relative error of the impulse: jn = 1e-3 / (knn + mu knt) = 1e-3 / 5.5."""
    impulses = trial.run(STEP).contacts.normal_impulse
    return abs(float(impulses.sum()) * 5.5e3 - 1)


def jam_error(trial: Trial) -> float:
    """Return how far the tip's velocity is from 0 after the impact, m/s."""
    run = trial.run(STEP, sample="end")
    angle = trial.scene.bodies[1].angle
    lever = np.array([math.sin(angle), -math.cos(angle)])
    return largest(run.velocities[-1, 1] + run.angular_velocities[-1, 1] * lever)


CORNERS = 200


def corner_error(trial: Trial) -> float:
    """Return the largest relative error of a velocity in random impacts of corners."""
    worst = 0.0
    for impact in corner_impacts.random_corners(CORNERS, seed=3):
        run = trial.run(corner_impacts.STEP, impact.scene, sample="end")
        motion = np.column_stack((run.velocities[:, 1], run.angular_velocities[:, 1]))
        worst = max(worst, largest(motion[-1] - impact.expected) / largest(motion))
    return worst


DISCS = 300


def disc_error(trial: Trial) -> float:
    """Return the largest relative error of a velocity in random impacts of discs.

    The discs start one step earlier, so that the solver resolves the impact at the positions of the
    closed form.
    """
    worst = 0.0
    for a, b, e, mu in spinning_discs.random_impacts(DISCS, seed=5):
        expected = spinning_discs.hit(a, b, spinning_discs.normal_between(a, b), e, mu)
        back = [replace(disc, position=disc.position - disc.velocity * STEP) for disc in (a, b)]
        scene = spinning_discs.scene_of(back[0], back[1], e, mu)
        run = trial.run(STEP, scene, sample="end")
        worst = max(worst, spinning_discs.difference(expected, run))
    return worst


def landing_error(trial: Trial) -> float:
    """Return the error of velocity or turning of a box that lands flat, m/s or rad/s."""
    vx, vy, w = end_state(trial.run(STEP, sample="end"))[1, 3:]
    return largest([vx, vy - 0.5, w])


def tall_box_landing() -> Scene:
    """Return a box of 1 m by 10 m that lands flat at 1 m/s, with e = 1/2."""
    scene = box_landing_flat(1.0, 10.0, 1.0, 0.5)
    floor, box = scene.bodies
    return Scene([floor, replace(box, position=(0, 5 - TOUCH))])


def rod_and_ball() -> Scene:
    """Return a rod of 2 m at rest, and a ball that hits its end at 1 m/s; all is elastic."""
    smooth = Material(restitution=1.0)
    return Scene(
        [
            Body(Segment((-1, 0), (1, 0)), mass=1, material=smooth),
            Body(
                Circle(0.25), mass=1, position=(1, TOUCH - 0.25), velocity=(0, 1), material=smooth
            ),
        ]
    )


def rod_error(trial: Trial) -> float:
    """Return the largest error of the velocities, m/s or rad/s, over the closed form's."""
    run = trial.run(STEP, sample="end")
    ball, body, turning = closed.off_centre_hit(1.0, 1.0, 1.0, 1 / 3, arm=1.0, restitution=1.0)
    measured = [*run.velocities[-1, :, 1], run.angular_velocities[-1, 0]]
    return largest(np.array(measured) - [body, ball, turning])


CASES = (
    HardCase(
        name="oblique-discs",
        theme=THEME,
        title="300 random pairs of rough spinning discs",
        why="Masses from 1e-3 to 1e3 kg: the clamp and both effective masses have to be right.",
        law="jn = (1 + e) vn m_eff, jt = clamp(-vt m_eff_t, -mu jn, mu jn)",
        scene=lambda: spinning_discs.scene_of(*next(spinning_discs.random_impacts(1, seed=5))),
        measure=disc_error,
        unit="",
        bound=1e-12,
        reason="rounding, for masses a million apart",
        options={"dt": STEP},
        failed_by=("naive",),
    ),
    HardCase(
        name="corner-friction",
        theme=THEME,
        title="200 boxes that land on a rough corner",
        why="Friction beside the centre changes what the normal impulse has to be, and back.",
        law="The closed 2 x 2 solution: sticks, or slides on the edge of Coulomb's cone",
        scene=lambda: next(corner_impacts.random_corners(1, seed=3)).scene,
        measure=corner_error,
        unit="",
        bound=1e-9,
        reason="rounding of places before and after a step of 1e-6 s",
        options={"dt": corner_impacts.STEP},
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="limit-cycle",
        theme=THEME,
        title="A rod drawn over a floor with mu = 2",
        why="mu knt > knn: each sweep of friction overthrows the normal impulse, for ever.",
        law="jn = -vn / (knn + mu knt)",
        scene=partial(rod_on_floor, math.pi / 4, 1.0, -1e-3),
        measure=limit_cycle_error,
        unit="",
        bound=1e-8,
        reason="the tip turns by 1e-9 in the step",
        options={"dt": STEP},
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="painleve",
        theme=THEME,
        title="A rod pushed over a floor with mu = 2",
        why="Painleve's paradox: no finite force lets it slide on. The tip jams at once.",
        law="Impulses that stop the tip",
        scene=partial(rod_on_floor, math.atan(2), -1.0, -1e-3),
        measure=jam_error,
        unit="m/s",
        bound=1e-9,
        reason="rounding of places before and after a step of 1e-9 s",
        options={"dt": STEP},
        failed_by=("naive", "pymunk"),
    ),
    HardCase(
        name="kane",
        theme=THEME,
        title="A turning rod hits a rough floor, e = 1",
        why="Newton's e compares velocities. With friction an impact may then gain energy.",
        law="Stronge: e^2 is the work given back over the work taken.",
        scene=partial(rod_on_floor, **KANE),
        measure=energy_gain,
        unit="",
        bound=1e-12,
        reason="rounding: an impact gains nothing",
        ours=ENERGETIC,
        options={"dt": STEP},
        failed_by=("pymunk",),
    ),
    HardCase(
        name="energy-gains",
        theme=THEME,
        title="15,000 random impacts of corners",
        why="By Newton's rule one in forty gains energy, and nothing on the screen tells which.",
        law="Stronge: e^2 is the work given back over the work taken.",
        scene=partial(many_corners, 10, 0),
        measure=gains,
        unit="",
        bound=0.0,
        reason="none of them may gain",
        ours=ENERGETIC,
        options={"dt": corner_impacts.STEP},
        failed_by=("pymunk",),
    ),
    HardCase(
        name="flat-landing",
        theme=THEME,
        title="A box of 1 m by 10 m lands flat, e = 1/2",
        why="Two points at once: what one does to the other is forgotten by a short sweep.",
        law="vy' = e vy, w' = 0",
        scene=tall_box_landing,
        measure=landing_error,
        unit="m/s",
        bound=1e-12,
        reason="rounding",
        options={"dt": STEP},
        failed_by=("pymunk",),
    ),
    HardCase(
        name="rod-end",
        theme=THEME,
        title="A ball hits the end of a free rod",
        why="The end of a rod yields to a blow as if the rod had a quarter of its mass.",
        law="Momentum, angular momentum and e: v' = 0.6, V' = 0.4, w' = 1.2",
        scene=rod_and_ball,
        measure=rod_error,
        unit="m/s",
        bound=1e-8,
        reason="the ball and the rod overlap by 1e-9 m",
        options={"dt": STEP},
        failed_by=("naive",),
    ),
)
