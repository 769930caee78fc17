"""Audible post-processing: an impact's sound, made from its impulse and its material.

A struck body rings in a few modes. Each is a sine that dies away; the material says how high, how
long, and how many. The impulse says how loud. Small bodies ring higher than large ones.
"""

from __future__ import annotations

import math
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.callbacks import Touch
from lesson_code.view.pygame.window import pygame

RATE = 22_050
"""1/s: samples. Nothing below rings higher than half of it."""

SECONDS = 0.6
LEVELS = 8
"""Loudnesses that are told apart; each is made once and kept."""

MOST_A_STEP = 6
"""Sounds that may begin in one step; more are noise."""

LARGEST_SAMPLE = 32_000
"""Of 32,767: what loudness 1 is played as."""

LATENCY = 512 / RATE
"""s: a sound begins with the next block of samples, as late as this."""

INAUDIBLE = 1e-6
"""Of the largest loudness."""

QUIETEST = 0.02
"""Of the impulse that is full loudness: below it nothing is played."""


@dataclass(frozen=True)
class Ring:
    """How a material sounds.

    Attributes
    ----------
    modes : tuple of float
        1/s, frequencies for a body of `size`.
    decay : float
        1/s: how fast the lowest mode dies away; higher ones do so faster.
    size : float
        m, of the body that `modes` belong to.
    """

    modes: tuple[float, ...]
    decay: float
    size: float = 0.1


RINGS = {
    "wood": Ring((420.0, 1130.0, 1970.0), decay=45.0),
    "steel": Ring((1250.0, 3410.0, 6620.0), decay=11.0),
    "ivory": Ring((2100.0, 4300.0), decay=70.0),
    "stone": Ring((260.0, 710.0, 1540.0), decay=60.0),
    "rubber": Ring((110.0, 240.0), decay=30.0),
}
"""The materials by name."""


@cache
def impact_sound(material: str, size: float, loudness: float) -> NDArray[np.float64]:
    """Return the sound of an impact, shape (K,), within [-1, 1].

    s(t) = loudness sum_k a_k exp(-d_k t) sin(2 pi f_k t)

    with f_k = mode_k / sqrt(size / ring.size), d_k = decay (1 + k) and a_k falling as 1 / (1 + k).

    Parameters
    ----------
    material : str
        A name in :data:`RINGS`.
    size : float
        m, > 0: of the body that rings.
    loudness : float
        0 to 1.

    Raises
    ------
    ValueError
        The material is not known, the size is not > 0, or the loudness lies outside [0, 1].

    Examples
    --------
    >>> sound = impact_sound("steel", 0.1, 0.5)
    >>> bool(abs(sound).max() <= 0.5)
    True
    """
    if material not in RINGS:
        raise ValueError(f"material must be one of {', '.join(RINGS)}, got {material!r}")
    if not (math.isfinite(size) and size > 0):
        raise ValueError(f"size must be > 0 m, got {size}")
    if not 0 <= loudness <= 1:
        raise ValueError(f"loudness must lie in [0, 1], got {loudness}")
    ring = RINGS[material]
    t = np.arange(int(SECONDS * RATE)) / RATE
    sound, total = np.zeros_like(t), 0.0
    for k, mode in enumerate(ring.modes):
        frequency = mode / math.sqrt(size / ring.size)
        if frequency < RATE / 2:  # a higher one would be heard as a lower one
            share = 1 / (1 + k)
            wave = np.sin(2 * math.pi * frequency * t)
            sound += share * np.exp(-ring.decay * (1 + k) * t) * wave
            total += share
    return loudness * sound / max(total, 1.0)


class Headroom:
    """How loud a sound may begin, so that all that ring together stay within what can be played.

    No sound of loudness L is louder than L exp(-d t) after a time t; the sum of these bounds is
    never above 1, so no sample is clipped.

    Parameters
    ----------
    decay : float
        1/s, > 0: how fast a sound dies away at the least.

    Examples
    --------
    >>> headroom = Headroom(decay=10.0)
    >>> headroom.take(0.75, now=0.0), headroom.take(0.75, now=0.0), headroom.take(0.75, now=0.0)
    (1.0, 0.3333333333333333, 0.0)
    """

    def __init__(self, decay: float) -> None:
        self._decay = decay
        self._playing: list[tuple[float, float]] = []

    def take(self, loudness: float, now: float) -> float:
        """Return what part of its loudness a sound may have that begins now, s."""
        left = [(begun, size, self._bound(size, now - begun)) for begun, size in self._playing]
        self._playing = [(begun, size) for begun, size, bound in left if bound > INAUDIBLE]
        free = 1.0 - sum(bound for *_, bound in left)
        part = min(1.0, max(free, 0.0) / loudness)
        self._playing.append((now, part * loudness))
        return part

    def _bound(self, loudness: float, age: float) -> float:
        """Return how loud a sound is at the most, a time after it was asked for, s."""
        return loudness * math.exp(-self._decay * max(age - LATENCY, 0.0))


class Sounds:
    """Plays impacts; it is silent where there is no audio device.

    Parameters
    ----------
    material : str
        A name in :data:`RINGS`.
    size : float
        m, of the bodies.
    full_impulse : float
        N s: what is played at full loudness.
    """

    def __init__(self, material: str, size: float, full_impulse: float) -> None:
        self._material, self._size, self._full = material, size, full_impulse
        self.headroom = Headroom(RINGS[material].decay)
        self._kept: dict[int, pygame.mixer.Sound] = {}
        self._begun = 0
        self.muted = self.held = False
        self.audible = False

    def open(self) -> None:
        """Ask for the audio device; without one everything stays silent."""
        try:
            with quiet():
                pygame.mixer.init(RATE, -16, 1, 512)
        except pygame.error:
            return
        pygame.mixer.set_num_channels(24)
        self.audible = pygame.mixer.get_init() is not None

    def close(self) -> None:
        """Give the audio device back."""
        self.audible = False
        self._kept.clear()
        pygame.mixer.quit()

    def mute(self) -> None:
        """Be silent at once, or no longer."""
        self.muted = not self.muted
        if self.muted and self.audible:
            pygame.mixer.stop()

    def hold(self, held: bool) -> None:
        """Hold all sounds in the midst of what they are, or let them go on; held, none begins."""
        self.held = held
        if self.audible:
            (pygame.mixer.pause if held else pygame.mixer.unpause)()

    def step(self) -> None:
        """Begin a new step: sounds may be played again."""
        self._begun = 0

    def hit(self, touch: Touch) -> None:
        """Play the sound of a touch."""
        self.play(touch.normal_impulse)

    def play(self, impulse: float) -> int:
        """Play the sound of an impulse, N s; return how loud, 0 (nothing) to :data:`LEVELS`."""
        level = loudness_level(impulse, self._full)
        if level == 0 or self._begun >= MOST_A_STEP:
            return 0
        self._begun += 1
        if self.audible and not self.muted and not self.held:
            if level not in self._kept:
                self._kept[level] = self._made(level)
            if (channel := self._kept[level].play()) is not None:
                channel.set_volume(self.headroom.take(level / LEVELS, perf_counter()))
        return level

    def _made(self, level: int) -> pygame.mixer.Sound:
        """Return the sound of a loudness as the mixer plays it."""
        wave = impact_sound(self._material, self._size, level / LEVELS)
        samples = (LARGEST_SAMPLE * wave).astype(np.int16)
        _, _, channels = pygame.mixer.get_init()
        return pygame.mixer.Sound(buffer=np.repeat(samples, channels).tobytes())


@contextmanager
def quiet() -> Iterator[None]:
    """Keep what libraries in C write on standard error from the terminal.

    ALSA writes a dozen unwanted lines if there is no sound card.
    """
    sys.stderr.flush()
    kept = os.dup(2)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)


def loudness_level(impulse: float, full: float) -> int:
    """Return how loud an impulse is, 0 to :data:`LEVELS`: twice the impulse, more than a level.

    >>> loudness_level(0.0, 1.0), loudness_level(1.0, 1.0), loudness_level(50.0, 1.0)
    (0, 8, 8)
    """
    part = impulse / full
    if not part > QUIETEST:
        return 0
    return max(1, min(LEVELS, math.ceil(LEVELS * math.sqrt(part))))
