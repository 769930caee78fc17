"""Measures and draws that more than one family uses."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.evidence.hard_cases.parameters import Draw

DT = 1 / 60
"""s: the step of every engine unless a family is about steps."""

STEP = 1e-9
"""s: a step so short that nothing moves, but overlapping bodies collide."""

TOUCH = 1e-9
"""m: overlap that puts bodies of 1 m in contact."""

SUNK = 4e-4
"""Of a body's size: the deepest overlap at the start that every engine here tolerates."""

NOT_SEEN = 1e-3
"""m: a thousandth of the size of a body of 1 m, too small to see."""

NO_DRIFT = "a thousandth of a body: too small to see"

HAIR = 1e-9
"""Of a body's size: a gap so small that closing it gives no speed that matters."""

ROUNDING = 1e-9
"""Relative: rounding, and some room for what a hit makes of it."""

RATIO = 1e9
"""Masses differ by up to this factor, in both directions."""


def start_gap(draw: Draw, layers: int = 1, *, sunk: bool = True, most: float = SUNK) -> float:
    """Return the gap between neighbours at the start, in parts of their size.

    Half of the draws are on the border: exactly touching. The others are apart, or sunk in, by
    anything from rounding to what every engine tolerates.

    Parameters
    ----------
    draw : Draw
        What it is drawn from.
    layers : int
        The gaps of so many layers together are at most that.
    sunk : bool
        Whether they may be sunk in. To come out of an overlap takes energy.
    most : float
        The largest gap or overlap.
    """
    starts = ("touching", "touching", "apart", "sunk" if sunk else "apart")
    start = draw.choice("start", starts)
    size = draw.log_uniform("start_size", 1e-12, most / layers)
    return {"touching": 0.0, "apart": size, "sunk": -size}[start]


def drawn_masses(draw: Draw, count: int, ratio: float = RATIO) -> list[float]:
    """Return masses that differ by up to a ratio, kg."""
    most = math.sqrt(ratio)
    return [draw.log_uniform(f"mass_{n}", 1 / most, most) for n in range(count)]


def free(scene: Scene) -> list[int]:
    """Return the places of the bodies that can be pushed."""
    return [n for n, body in enumerate(scene.bodies) if not body.is_static]


def largest(differences: Any) -> float:
    """Return the largest absolute value; nan if there is one among them."""
    return float(np.max(np.abs(differences)))


def way_of(run: Run) -> float:
    """Return the largest distance of a body from its start, m."""
    moved = run.positions[-1] - run.positions[0]
    return float(np.max(np.hypot(*moved[free(run.scene)].T)))


def unrest(run: Run) -> float:
    """Return how far bodies that should stand have moved, m.

    The largest distance sideways; or the largest one up or down, for each body in the scene: in a
    stack each contact may give way a little, and those above go down with it.
    """
    moved = (run.positions[-1] - run.positions[0])[free(run.scene)]
    return max(largest(moved[:, 0]), largest(moved[:, 1]) / len(moved))


def sideways(run: Run) -> float:
    """Return the largest horizontal distance of a body from its start, m."""
    moved = run.positions[-1] - run.positions[0]
    return largest(moved[free(run.scene), 0])


def fastest(run: Run) -> float:
    """Return the greatest speed of any body that can be pushed, in any state, m/s."""
    return float(np.max(np.hypot(*np.moveaxis(run.velocities[:, free(run.scene)], -1, 0))))


def gain(energies: Any) -> float:
    """Return how far energies rise above the first, in parts of it; 0 if they never do."""
    return max(float(np.max(energies)) / float(energies[0]) - 1.0, 0.0)


def rise(energies: Any) -> float:
    """Return how far energies rise above the least before, in parts of the first; 0: they fall."""
    return largest(energies - np.minimum.accumulate(energies)) / float(energies[0])


def energy_above(run: Run, height: float = 0.0) -> Any:
    """Return the mechanical energy in each state, 0 for bodies at rest at a height, shape (F,)."""
    weight = -run.scene.gravity[1] * sum(body.mass or 0.0 for body in run.scene.bodies)
    return run.energy - weight * height


AT_THE_BORDER = 1e-9
"""Of a step: impulses that come later than this are not those of the step before."""


def pair_forces(run: Run, dt: float = DT) -> dict[tuple[int, int], float]:
    """Return the normal force of each pair of bodies that touch in the last step, N.

    It is the mean over the step, of all parts of it: a step begins anew where bodies meet.
    """
    hits = run.contacts
    last = hits.time > run.times[-1] - dt * (1 - AT_THE_BORDER)
    forces: dict[tuple[int, int], float] = {}
    for a, b, impulse in zip(
        hits.body_a[last].tolist(),
        hits.body_b[last].tolist(),
        hits.normal_impulse[last].tolist(),
        strict=True,
    ):
        forces[a, b] = forces.get((a, b), 0.0) + impulse / dt
    return forces


def relative_errors(measured: Any, expected: Any) -> float:
    """Return the largest difference, relative to the expected value."""
    return largest(np.asarray(measured) / np.asarray(expected) - 1)


def end_state(run: Run) -> Any:
    """Return x, y, angle, vx, vy, w of every body at the end, shape (N, 6)."""
    return np.column_stack(
        (run.positions[-1], run.angles[-1], run.velocities[-1], run.angular_velocities[-1])
    )


def angle_of(draw: Draw, name: str, low: float, high: float) -> float:
    """Return an angle drawn in degrees, rad."""
    return math.radians(draw.uniform(name, low, high))
