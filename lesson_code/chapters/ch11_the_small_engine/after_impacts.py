"""Post-processing with a reader's own functions: what a run looks and sounds like.

Events come from the touches of two frames (task 11.4), light from events (11.5), sound from events
and their impulses (11.6). What is not written yet is lent.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.course.grading.own import OwnFunction, own_functions
from lesson_code.engine.core.run import Run
from lesson_code.view.browser.sound import play_sound
from lesson_code.view.pygame.effects import FLASH_SECONDS
from lesson_code.view.pygame.sound import RATE, impact_sound

TASKS = ("11.4", "11.5", "11.6")

Pairs: TypeAlias = list[tuple[int, int]]

HALF_LIFE, TONE, RINGING = 0.1, 420.0, 0.03
"""s, until half of the light is left; 1/s; s, until the sound is half as loud."""

LOUD = 20.0
"""N s: an impulse that is heard at full loudness."""


def functions() -> dict[str, OwnFunction]:
    """Return what the reader has written for the three tasks, by the functions' names."""
    return own_functions(TASKS)


def play(run: Run, own: dict[str, OwnFunction], alt: str) -> None:
    """Display a player for the sound of a run; `alt` says what can be heard."""
    play_sound(sound(run, own), RATE, alt)


def touches(run: Run) -> list[Pairs]:
    """Return the pairs that touch in each frame: those that push each other in the step before."""
    found: list[Pairs] = [[] for _ in run.times]
    frames = np.searchsorted(run.times, run.contacts.time)
    for frame, a, b in zip(frames, run.contacts.body_a, run.contacts.body_b, strict=True):
        pair = int(min(a, b)), int(max(a, b))
        if frame < len(found) and pair not in found[frame]:
            found[frame].append(pair)
    return found


def begun(run: Run, own: OwnFunction) -> list[Pairs]:
    """Return the pairs that begin to touch in each frame."""
    pairs = touches(run)
    return [_begun(own, before, now) for before, now in zip([[], *pairs], pairs, strict=False)]


def _begun(own: OwnFunction, before: Pairs, now: Pairs) -> Pairs:
    """Return the pairs that begin to touch from one frame to the next."""
    if own.function is None:
        return [pair for pair in now if pair not in before]
    found = own.function(np.array(before), np.array(now))[0]
    return [(int(i), int(j)) for i, j in found]


def light(run: Run, own: dict[str, OwnFunction]) -> NDArray[np.float64]:
    """Return how bright each body is in each frame, shape (F, N)."""
    rows = [np.zeros(run.positions.shape[1])]
    steps = np.diff(run.times, prepend=run.times[0])
    for pairs, dt in zip(begun(run, own["touch_changes"]), steps.tolist(), strict=True):
        hit = np.isin(np.arange(len(rows[0])), pairs).astype(float)
        rows.append(_lit(own["glow"], rows[-1], hit, dt))
    return np.array(rows[1:])


def _lit(own: OwnFunction, brightness: Any, hit: Any, dt: float) -> Any:
    """Return how bright bodies are after a step."""
    if own.function is None:  # as in the programs: lit for a moment, and no more
        return np.where(hit > 0, 1.0, np.maximum(brightness - dt / FLASH_SECONDS, 0.0))
    return np.asarray(own.function(brightness.copy(), hit, dt, HALF_LIFE), dtype=float)


def sound(run: Run, own: dict[str, OwnFunction]) -> NDArray[np.float64]:
    """Return the sound of all impacts of a run, :data:`RATE` samples a second, within [-1, 1]."""
    count = int(0.25 * RATE)
    track = np.zeros(int(run.times[-1] * RATE) + count + 1)
    for time, pairs in zip(run.times.tolist(), begun(run, own["touch_changes"]), strict=True):
        for pair in pairs:
            samples = _heard(own["knock"], _loudness(run, time, pair), count)
            track[int(time * RATE) :][: len(samples)] += samples
    loudest = float(np.abs(track).max())
    return track if loudest <= 1 else track / loudest


def _loudness(run: Run, time: float, pair: tuple[int, int]) -> float:
    """Return how loud an impact is, 0 to 1, by its impulse."""
    events = run.contacts
    between = np.isin(events.body_a, pair) & np.isin(events.body_b, pair)
    near = between & (np.abs(events.time - time) <= 1 / 30)
    return min(float(events.normal_impulse[near].sum()) / LOUD, 1.0)


def _heard(own: OwnFunction, loudness: float, count: int) -> Any:
    """Return the samples of one impact."""
    if own.function is None:
        return impact_sound("wood", 0.1, loudness)[:count]
    return np.asarray(own.function(loudness, TONE, RINGING, RATE, count), dtype=float)
