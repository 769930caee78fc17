"""A sound's player holds the samples it was given."""

from __future__ import annotations

import base64
import io
import re
import wave
from typing import Any

import numpy as np
import pytest

from lesson_code.view.browser import sound

HALF_A_STEP = 0.5 / sound.LARGEST
"""Of a sample with 16 bits."""


def test_player_holds_the_samples(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read back from the HTML: rate, length and values."""
    shown: list[Any] = []
    monkeypatch.setattr(sound, "display", lambda data, **_: shown.append(data))
    samples = np.sin(np.arange(500) / 7)
    sound.play_sound(samples, 8000, 'A "tone".')
    assert shown[0]["text/plain"] == 'Sound: A "tone".'
    found = re.search(r"base64,([^\"]+)", shown[0]["text/html"])
    assert found
    with wave.open(io.BytesIO(base64.b64decode(found[1]))) as file:
        assert (file.getnchannels(), file.getframerate()) == (1, 8000)
        read = np.frombuffer(file.readframes(file.getnframes()), "<i2") / sound.LARGEST
    np.testing.assert_allclose(read, samples, atol=HALF_A_STEP)
    assert "&quot;tone&quot;" in shown[0]["text/html"]


@pytest.mark.parametrize(
    ("samples", "alt", "said"),
    [([0.0, 1.5], "x", "must lie in"), ([np.nan], "x", "must lie in"), ([0.0], " ", "alt must")],
)
def test_bad_sounds_are_refused(samples: Any, alt: str, said: str) -> None:
    """What would be clipped, what is not a number, and what says nothing."""
    with pytest.raises(ValueError, match=said):
        sound.play_sound(samples, 8000, alt)
