"""How long the frames of a program take, in a large window and with everything shown."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from lesson_code.view.pygame.frame import play
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.program import Program

PROJECTOR = (1920, 1080)
"""px."""

EVERYTHING = tuple((0, Input("press", key)) for key in "vkixj")
"""The keys that add to the picture."""


class FrameTimes(NamedTuple):
    """Milliseconds of the processor in a part of a run.

    Attributes
    ----------
    first, last : int
        The part's frames.
    world, picture : float
        Medians.
    within : float
        What 95 % of the frames stay within, world and picture together.
    """

    first: int
    last: int
    world: float
    picture: float
    within: float


def frame_times(
    program: Program, frames: int, part: int, *, shows: bool, settings: dict[str, Any]
) -> Iterator[FrameTimes]:
    """Play a program's tour in a large window; yield the times of each part of the run."""
    if shows:
        program = replace(program, tour=EVERYTHING + program.tour)
    outcome = play(
        program, frames=frames, headless=True, tour=True, size=PROJECTOR, settings=settings
    )
    for first in range(0, outcome.frames, part):  # a window may have been closed before
        seconds = 1e3 * outcome.seconds[first : first + part]
        world, picture = np.median(seconds, axis=0)
        within = float(np.quantile(seconds.sum(axis=1), 0.95))
        yield FrameTimes(first, first + len(seconds), float(world), float(picture), within)
