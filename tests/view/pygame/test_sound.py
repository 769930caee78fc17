"""Impact sounds: loudness, pitch, decay, and silence where there is no device."""

from __future__ import annotations

import math
from functools import partial

import numpy as np
import pytest

from lesson_code.chapters.programs import load
from lesson_code.view.pygame import sound as sound_module
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.sound import (
    LATENCY,
    LEVELS,
    MOST_A_STEP,
    RATE,
    RINGS,
    SECONDS,
    Headroom,
    Sounds,
    impact_sound,
    loudness_level,
)
from lesson_code.view.pygame.window import pygame


@pytest.fixture(autouse=True)
def _no_device(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run without a loudspeaker."""
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")


@pytest.mark.parametrize("material", RINGS)
def test_sound_is_within_its_loudness_and_dies_away(material: str) -> None:
    """No sample is louder; the last tenth has under a hundredth of the first tenth's power."""
    sound = impact_sound(material, 0.1, 0.7)
    tenth = len(sound) // 10
    assert np.abs(sound).max() <= 0.7
    assert (sound[-tenth:] ** 2).sum() < 0.01 * (sound[:tenth] ** 2).sum()


@pytest.mark.parametrize("material", RINGS)
def test_sound_rings_in_its_lowest_mode(material: str) -> None:
    """The strongest frequency is that mode's, to the width that its decay gives it."""
    ring = RINGS[material]
    spectrum = np.abs(np.fft.rfft(impact_sound(material, ring.size, 1.0)))
    strongest = np.fft.rfftfreq(int(0.6 * RATE), 1 / RATE)[spectrum.argmax()]
    assert strongest == pytest.approx(ring.modes[0], abs=ring.decay)


def test_larger_bodies_sound_lower() -> None:
    """Four times the size, half the frequency."""
    ring = RINGS["steel"]
    spectrum = np.abs(np.fft.rfft(impact_sound("steel", 4 * ring.size, 1.0)))
    strongest = np.fft.rfftfreq(int(0.6 * RATE), 1 / RATE)[spectrum.argmax()]
    assert strongest == pytest.approx(ring.modes[0] / 2, abs=ring.decay)


def test_modes_above_half_the_rate_are_left_out() -> None:
    """A tiny body is silent rather than wrong."""
    assert not impact_sound("steel", 1e-6, 1.0).any()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("glass", 0.1, 1.0), "material must be one of wood, .* got 'glass'"),
        (("wood", 0.0, 1.0), "size must be > 0 m, got 0.0"),
        (("wood", float("nan"), 1.0), "size must be > 0 m, got nan"),
        (("wood", 0.1, 1.5), r"loudness must lie in \[0, 1\], got 1.5"),
    ],
)
def test_sound_out_of_range_is_refused(arguments: tuple[str, float, float], words: str) -> None:
    """The error names argument, rule and value."""
    with pytest.raises(ValueError, match=words):
        impact_sound(*arguments)


def test_level_grows_with_the_impulse_from_silence_to_full() -> None:
    """A touch is silent, a hard impact is full, nothing is beyond; nan is silent."""
    levels = [loudness_level(impulse, 2.0) for impulse in np.linspace(0, 4, 60)]
    assert levels == sorted(levels)
    assert (levels[0], levels[-1]) == (0, LEVELS)
    assert loudness_level(float("nan"), 2.0) == 0


def test_few_sounds_begin_in_a_step() -> None:
    """A pile that falls is a rattle and not a roar; the next step may sound again."""
    sounds = Sounds("wood", 0.1, 1.0)
    assert sum(sounds.play(1.0) > 0 for _ in range(50)) == MOST_A_STEP
    sounds.step()
    assert sounds.play(1.0) == LEVELS


def test_sounds_are_played_on_a_device_and_muted() -> None:
    """On SDL's dummy device a sound is made once for each loudness."""
    sounds = Sounds("wood", 0.1, 1.0)
    sounds.open()
    try:
        assert sounds.audible
        sounds.play(1.0)
        sounds.play(1.0)
        sounds.muted = True
        sounds.play(0.1)
        assert list(sounds._kept) == [LEVELS]
    finally:
        sounds.close()
    assert not sounds.audible


def test_sounds_are_held_and_go_on(monkeypatch: pytest.MonkeyPatch) -> None:
    """Held, what is heard stops where it is, and nothing begins; it goes on when it is let go."""
    done: list[str] = []
    for name in ("pause", "unpause", "stop"):
        monkeypatch.setattr(sound_module.pygame.mixer, name, partial(done.append, name))
    sounds = Sounds("wood", 0.1, 1.0)
    sounds.hold(True)
    sounds.hold(False)
    assert done == []  # no device is open
    sounds.open()
    try:
        sounds.hold(True)
        sounds.play(1.0)
        assert sounds._kept == {}
        sounds.hold(False)
        sounds.play(1.0)
        assert list(sounds._kept) == [LEVELS]
        sounds.mute()
        sounds.mute()
        assert done == ["pause", "unpause", "stop"]
    finally:
        sounds.close()


def test_sounds_without_a_device_are_silent(monkeypatch: pytest.MonkeyPatch) -> None:
    """No device is no error."""

    def no_device(*_: object) -> None:
        raise pygame.error("no such audio device")

    monkeypatch.setattr(sound_module.pygame.mixer, "init", no_device)
    sounds = Sounds("wood", 0.1, 1.0)
    sounds.open()
    assert not sounds.audible
    assert sounds.play(1.0) == LEVELS
    sounds.close()


# Many sounds at once


def test_sounds_together_are_never_clipped_cradle() -> None:
    """The impacts of a cradle's tour, mixed: no sample beyond what can be played.

    Without the headroom some are.
    """
    program = load("cradle")
    session = Session(program, program.game(0), Recording("cradle", 0))
    session.tour = program.tour
    heard: list[tuple[float, float]] = []
    sounds = session.effects.sounds
    assert sounds is not None
    session.game.listeners.append(
        lambda touch: heard.append(
            (session.steps / 60, loudness_level(touch.normal_impulse, sounds._full) / LEVELS)
        )
    )
    for _ in range(1200):
        session.step()
    mixes = []
    for headroom in (Headroom(RINGS["steel"].decay), None):
        mix = np.zeros(int((1200 / 60 + SECONDS + 0.1) * RATE))
        for now, loudness in (one for one in heard if one[1] > 0):
            part = 1.0 if headroom is None else headroom.take(loudness, now)
            sound = part * impact_sound("steel", 0.3, loudness)
            mix[int(now * RATE) :][: len(sound)] += sound
        mixes.append(np.abs(mix).max())
    assert mixes[0] <= 1.0
    assert mixes[1] > 1.0


@pytest.mark.parametrize("seed", range(5))
def test_headroom_bounds_any_sequence_of_sounds(seed: int) -> None:
    """Whatever begins when, a block late or not: the sum of all envelopes stays within 1."""
    stream, headroom, decay = np.random.default_rng(seed), Headroom(30.0), 30.0
    playing: list[tuple[float, float]] = []
    now = 0.0
    for wait in stream.exponential(0.02, 300):
        now += wait
        loudness = stream.uniform(0.1, 1.0)
        delay = stream.uniform(0.0, LATENCY)
        playing.append((now + delay, headroom.take(loudness, now) * loudness))
        ringing = sum(a * math.exp(-decay * max(now - begun, 0.0)) for begun, a in playing)
        assert ringing <= 1.0 + 1e-9
