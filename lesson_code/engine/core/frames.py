"""Frames: the states of all bodies, noted while a program runs, in the arrays that a run holds."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeVar

import numpy as np

from lesson_code.engine.compiled.arrays import column, dtype_of
from lesson_code.engine.core.columns import Floats
from lesson_code.engine.core.rows import NumberRow, VectorRow, World
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects

STATE_FIELDS = ["x", "y", "angle", "vx", "vy", "w"]
"""The numbers in a body's state, by the names that they have in its row."""

STATE_NUMBERS = len(STATE_FIELDS)

NOTED = {"positions": VectorRow, "velocities": VectorRow, "angles": NumberRow, "spins": NumberRow}
"""The tables in which a program notes states, in those of a run, and their rows."""

OF_ROTATION = ("angles", "spins")
"""Those of them that are not written where nothing turns."""

ROWS_AT_ONCE, PLAIN_ROWS_AT_ONCE = 32768, 1024
"""States that are noted before somebody looks at them, unless one frame has more: machine code
notes one and a half megabytes, which a processor has at hand; plain Python makes rows for them."""

Tables = TypeVar("Tables", bound=Any)


def note_frame(world: World, effects: Effects = EVERY_EFFECT) -> None:
    """Note the states of all bodies, in the next rows of the tables for them."""
    state = world.state
    for i in range(len(world.bodies)):
        body, k = world.bodies[i], state.frame_rows
        place, velocity = world.positions[k], world.velocities[k]
        place.x, place.y = body.x, body.y
        velocity.x, velocity.y = body.vx, body.vy
        if effects.rotation:
            world.angles[k].value, world.spins[k].value = body.angle, body.w
        state.frame_rows += 1


class Frames:
    """The states of N bodies at F times, in the arrays that a run will hold.

    Machine code writes them there itself: 10,000 bodies in 300 frames are 144 MB, which take longer
    to be copied than a gas of as many takes to be simulated.

    Parameters
    ----------
    times : sequence of float
        s.
    bodies : int
        N.
    """

    def __init__(self, times: Sequence[float], bodies: int) -> None:
        shape = (len(times), bodies)
        self.times = np.array(times, dtype=float)
        self.positions, self.velocities = np.empty((*shape, 2)), np.empty((*shape, 2))
        self.angles, self.spins = np.zeros(shape), np.zeros(shape)

    def put(
        self, frames: Any, states: Floats, bodies: Any = slice(None), *, rotation: bool = True
    ) -> None:
        """Write down the states of some bodies, all of them unless told, in some frames.

        Parameters
        ----------
        frames : int or slice
            Which of the F times: one, or K.
        states : ndarray, shape (N, 6) or (K, N, 6)
            x, y, angle, vx, vy, w.
        bodies : array of int, shape (N,), optional
        rotation : bool
            Whether angles and spins are among it.
        """
        self.positions[frames, bodies] = states[..., 0:2]
        self.velocities[frames, bodies] = states[..., 3:5]
        if rotation:
            self.angles[frames, bodies] = states[..., 2]
            self.spins[frames, bodies] = states[..., 5]

    def stay_turned(self, frames: slice, angles: Any, spins: Any) -> None:
        """Write down in some frames how all bodies have turned, where nothing turns them further.

        Zeros stand there already: memory that nobody writes takes no time.
        """
        for table, values in ((self.angles, angles), (self.spins, spins)):
            if np.any(values):
                table[frames] = values

    def tables(self, frames: slice) -> dict[str, Any]:
        """Return some frames as the tables in which a program notes them, in this memory."""
        return {
            name: getattr(self, name)[frames].reshape(-1).view(dtype_of(kind))
            for name, kind in NOTED.items()
        }

    def lend(self, frames: slice, tables: Tables) -> Tables:
        """Return a program's tables, in which it is to note some frames.

        Machine code gets this memory, and plain Python rows, of which it has some already.
        """
        lent = self.tables(frames)
        if isinstance(tables.positions, list):
            for name, kind in NOTED.items():
                rows = getattr(tables, name)
                rows += [kind() for _ in range(len(lent[name]) - len(rows))]
                lent[name] = rows
        result: Tables = tables._replace(**lent)
        return result

    def take(self, frames: slice, tables: Any, *, rotation: bool) -> None:
        """Take over what a program has noted elsewhere; `rotation` says whether anything turns."""
        for name, here in self.tables(frames).items():
            noted = getattr(tables, name)
            is_here = isinstance(noted, np.ndarray) and np.may_share_memory(noted, here)
            if not is_here and (rotation or name not in OF_ROTATION):
                for field in here.dtype.names or ():
                    here[field] = column(noted[: len(here)], field)

    def require_numbers(self, frames: slice, *, rotation: bool = True) -> None:
        """Look at some frames; `rotation` says whether anything turns.

        Raises
        ------
        FloatingPointError
            A number is not finite: a body has left the range of floating point.
        """
        for name in NOTED:
            if not rotation and name in OF_ROTATION:
                continue
            is_number = np.isfinite(getattr(self, name)[frames])
            if not is_number.all():
                frame, body, *_ = np.argwhere(~is_number)[0].tolist()
                raise FloatingPointError(
                    f"body {body} has left the range of floating point "
                    f"at {self.times[frames][frame]} s"
                )

    def in_order(self, times: Sequence[float]) -> Frames:
        """Return these frames, whose times ascend, in the order of the same times as asked for."""
        if list(times) == self.times.tolist():
            return self
        order = np.argsort(times, kind="stable")
        asked = Frames(times, self.angles.shape[1])
        for name in NOTED:
            getattr(asked, name)[order] = getattr(self, name)
        return asked


def frames_at_once(bodies: int, *, is_plain: bool) -> int:
    """Return how many frames of so many bodies are noted before somebody looks at them."""
    return max((PLAIN_ROWS_AT_ONCE if is_plain else ROWS_AT_ONCE) // max(bodies, 1), 1)


def given_back(tables: Tables) -> Tables:
    """Return a program's tables without the memory that was lent to it; rows it may keep."""
    if isinstance(tables.positions, list):
        return tables
    result: Tables = tables._replace(**{name: getattr(tables, name)[:0] for name in NOTED})
    return result
