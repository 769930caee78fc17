"""A run as it is played: which of its states are shown when, and where everything stands in them.

A film holds only what was recorded: between two states nothing is made up.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.formulas.validation import one_number, positive
from lesson_code.view.svg.scene_svg import PlacedState, Sheet, Ticks, moving, ticks

Floats: TypeAlias = NDArray[np.float64]

MOST_FRAMES = 3000
"""With more pictures than this an animation is too large for a notebook."""

FLASH = 0.1
"""s of playing that a contact point stays in sight."""

SAME_TIME = 1e-9
"""Of a duration: times that are no further apart are equal but for rounding."""


@dataclass(frozen=True)
class Clock:
    """The times that are shown, evenly spaced, and how long playing them lasts.

    Attributes
    ----------
    start, duration : float
        s, of the run.
    seconds : float
        s, of playing.
    frames : int
        The number of pictures, >= 1.

    Examples
    --------
    >>> Clock(start=0.0, duration=1.0, seconds=4.0, frames=5).times.tolist()
    [0.0, 0.25, 0.5, 0.75, 1.0]
    """

    start: float
    duration: float
    seconds: float
    frames: int

    @property
    def times(self) -> Floats:
        """The time of each picture, s, shape (K,)."""
        return self.start + self.duration * np.arange(self.frames) / max(1, self.frames - 1)

    @property
    def decimals(self) -> int:
        """How many decimals of a time are written: two for a run of 1 to 10 s."""
        return max(0, 2 - math.floor(math.log10(self.duration))) if self.duration else 0

    def frame_at(self, time: float | None) -> int:
        """Return which picture is nearest to a time, s; None is the start."""
        if time is None:
            return 0
        end = self.start + self.duration
        if not self.start <= time <= end:
            raise ValueError(f"still must lie between {self.start:g} and {end:g} s, got {time}")
        return int(np.argmin(np.abs(self.times - time)))


@dataclass(frozen=True)
class Film:
    """Where a run's bodies stand in each of K pictures.

    Attributes
    ----------
    scene : Scene
        The bodies.
    places, turns, arrows : ndarray of int, shape (K, N, 2), (K, N) and (K, N, 2)
        As a :class:`lesson_code.view.svg.scene_svg.PlacedState` has them.
    contacts : list of list of int
        For each picture x and y of each contact point, px; empty if none are shown.
    """

    scene: Scene
    places: Ticks
    turns: Ticks
    arrows: Ticks
    contacts: list[list[int]]

    def state(self, frame: int) -> PlacedState:
        """Return one picture."""
        contacts = self.contacts[frame] if self.contacts else []
        return PlacedState(self.places[frame], self.turns[frame], self.arrows[frame], contacts)

    def paths(self) -> list[list[list[int]]]:
        """Return for each body that moves x, y and angle over time, and x and y of its arrow.

        Each is written as the first value and the differences that follow; zeros at the end,
        where a body has come to rest, are left out. So are arrows where there are none.
        """
        numbers = np.concatenate((self.places, self.turns[..., None], self.arrows), axis=-1)
        if not self.arrows.any():
            numbers = numbers[..., :3]
        return [[differences(column) for column in numbers[:, n].T] for n in moving(self.scene)]


def clock_of(runs: Sequence[Run], seconds: float | None, fps: float) -> Clock:
    """Return the times at which runs are shown together.

    Parameters
    ----------
    runs : sequence of Run
        What is shown.
    seconds : float or None
        How long playing lasts, s, > 0; None for as long as it took.
    fps : float
        Pictures a second of playing, at most.

    Raises
    ------
    ValueError
        `seconds` is not > 0, or there would be too many pictures.
    """
    start = min(float(run.times.min()) for run in runs)
    duration = max(float(run.times.max()) for run in runs) - start
    lasting = duration if seconds is None else one_number("seconds", seconds, positive)
    recorded = max(len(run.times) for run in runs)
    wanted = math.ceil(lasting * fps * (1 - SAME_TIME)) + 1
    frames = min(recorded, wanted) if duration else 1
    if frames > MOST_FRAMES:
        raise ValueError(
            f"seconds * fps must be <= {MOST_FRAMES} pictures, got {lasting:g} s * {fps:g} 1/s"
        )
    return Clock(start, duration, lasting, frames)


def fastest_speed(runs: Iterable[Run]) -> float:
    """Return the greatest speed of any body at any time, m/s; 0 if nothing moves."""
    speeds = (np.hypot(*np.moveaxis(run.velocities, -1, 0)) for run in runs)
    return max(float(speed.max(initial=0.0)) for speed in speeds)


def film_of(run: Run, clock: Clock, sheet: Sheet, arrows: float, contacts: bool) -> Film:
    """Return what is shown of a run.

    Parameters
    ----------
    run : Run
        What happened.
    clock : Clock
        When it is shown.
    sheet : Sheet
        Where it is drawn.
    arrows : float
        Pixels that are drawn for 1 m/s; 0 for no arrows.
    contacts : bool
        Whether contact points are shown.
    """
    frames = _latest_states(run, clock)
    return Film(
        run.scene,
        sheet.placed(run.positions[frames]),
        sheet.turned(run.angles[frames]),
        ticks(run.velocities[frames] * (arrows, -arrows)),
        _contacts(run, clock, sheet) if contacts else [],
    )


def differences(numbers: Ticks) -> list[int]:
    """Return the first of some numbers and each one's difference from the one before.

    >>> differences(np.array([5, 7, 7, 4, 4, 4]))
    [5, 2, 0, -3]
    """
    changes: list[int] = np.diff(numbers, prepend=0).tolist()
    while len(changes) > 1 and changes[-1] == 0:
        changes.pop()
    return changes


def _latest_states(run: Run, clock: Clock) -> NDArray[np.intp]:
    """Return for each picture the number of the last state that is not after its time."""
    order = np.argsort(run.times, kind="stable")
    times = clock.times + SAME_TIME * clock.duration
    places = np.searchsorted(run.times[order], times, side="right") - 1
    latest: NDArray[np.intp] = order[np.maximum(places, 0)]
    return latest


def _contacts(run: Run, clock: Clock, sheet: Sheet) -> list[list[int]]:
    """Return for each picture the contact points that are in sight, px.

    Of each pair of bodies they are those of its last impulse, if that is not long ago.
    """
    events, rounding = run.contacts, SAME_TIME * clock.duration
    points = np.floor_divide(sheet.placed(events.point) + 5, 10).tolist()
    between = clock.duration / max(1, clock.frames - 1)
    sight = max(between, FLASH * clock.duration / clock.seconds) if clock.seconds else 0.0
    moments = events.time.tolist()
    pairs = [*zip(events.body_a.tolist(), events.body_b.tolist(), strict=True)]
    pictures = []
    for time in clock.times:
        window = np.searchsorted(events.time, (time - sight + rounding, time + rounding))
        recent = range(*window.tolist())
        latest = {pairs[k]: moments[k] for k in recent}
        pictures.append([c for k in recent if moments[k] == latest[pairs[k]] for c in points[k]])
    return pictures
