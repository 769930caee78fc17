"""Frames: the states of all bodies, noted while a program runs, and the arrays that a run holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from lesson_code.engine.compiled.arrays import column, lengthened
from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.rows import FrameRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects

STATE_FIELDS = ["x", "y", "angle", "vx", "vy", "w"]
"""The numbers in a body's state, by the names that they have in its row."""

STATE_NUMBERS = len(STATE_FIELDS)

OF_ROTATION = ("angle", "w")
"""Those of them that do not change where nothing turns."""

ROWS_AT_ONCE = 8192
"""Rows of a table of frames, unless one frame needs more. They are half a megabyte."""


def note_frame(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Note the states of all bodies, in the next rows of the table of frames."""
    state = world.state
    for i in range(len(world.bodies)):
        body, row = world.bodies[i], world.frames[state.frame_rows]
        row.x, row.y = body.x, body.y
        row.vx, row.vy = body.vx, body.vy
        if effects.rotation:
            row.angle, row.w = body.angle, body.w
        state.frame_rows += 1


def frames_at_once(bodies: int) -> int:
    """Return how many frames of so many bodies are noted before they are taken away."""
    return max(ROWS_AT_ONCE // max(bodies, 1), 1)


def table_for(table: Any, rows: int) -> Any:
    """Return a table of frames with so many rows, of the kind of an empty one."""
    if isinstance(table, np.ndarray):
        return lengthened(table, rows)
    return [FrameRow() for _ in range(rows)]


def read_frames(table: Any, states: Floats, bodies: Any, *, rotation: bool) -> None:
    """Write the frames that were noted in a table into states.

    Parameters
    ----------
    table : list of FrameRow, or an array of such records
    states : ndarray, shape (K, N, 6)
        They hold what was not noted: other bodies, and angles that do not change.
    bodies : slice or array of int
        The bodies that were noted, in each frame.
    rotation : bool
        Whether they turn.
    """
    for number, name in enumerate(STATE_FIELDS):
        if rotation or name not in OF_ROTATION:
            states[:, bodies, number] = np.reshape(column(table, name), (len(states), -1))


class Frames:
    """The states of N bodies at F times, in the arrays that a run will hold.

    They are written once: 10,000 bodies in 300 frames are 144 MB, which take longer to be copied
    than a gas of as many takes to be simulated.
    """

    def __init__(self, times: Sequence[float], bodies: int) -> None:
        shape = (len(times), bodies)
        self.times = np.array(times, dtype=float)
        self.positions, self.velocities = np.empty((*shape, 2)), np.empty((*shape, 2))
        self.angles, self.angular_velocities = np.empty(shape), np.empty(shape)

    def put(self, frames: Any, states: Floats) -> None:
        """Write down some frames: x, y, angle, vx, vy, w of every body.

        Parameters
        ----------
        frames : int, or array of int, shape (K,)
            Which of the F times.
        states : ndarray, shape (N, 6), or (K, N, 6)

        Raises
        ------
        FloatingPointError
            A number is not finite: a body has left the range of floating point.
        """
        if not np.isfinite(states).all():
            *frame, body, _ = np.argwhere(~np.isfinite(states))[0].tolist()
            time = np.atleast_1d(self.times[frames])[frame[0] if frame else 0]
            raise FloatingPointError(
                f"body {body} has left the range of floating point at {time} s"
            )
        self.positions[frames] = states[..., 0:2]
        self.angles[frames] = states[..., 2]
        self.velocities[frames] = states[..., 3:5]
        self.angular_velocities[frames] = states[..., 5]
