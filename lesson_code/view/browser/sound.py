"""Sounds in a notebook and in a page: a player that needs no other file."""

from __future__ import annotations

import base64
import html
import io
import wave

import numpy as np
from IPython.display import display
from numpy.typing import ArrayLike

LARGEST = 2**15 - 1
"""Of a sample with 16 bits."""


def play_sound(samples: ArrayLike, rate: int, alt: str) -> None:
    """Display a player for a sound.

    Parameters
    ----------
    samples : array_like, shape (K,)
        Within [-1, 1].
    rate : int
        Samples a second, > 0.
    alt : str
        What can be heard, for readers who cannot hear it.

    Raises
    ------
    ValueError
        A sample lies outside [-1, 1] or is not finite, or `alt` is empty.
    """
    values = np.asarray(samples, dtype=float)
    if not np.all(np.abs(values) <= 1):
        raise ValueError(f"samples must lie in [-1, 1], got {np.abs(values).max():g}")
    if not alt.strip():
        raise ValueError("alt must say what can be heard, got nothing")
    data = base64.b64encode(_wav(values, rate)).decode()
    words = html.escape(alt, quote=True)
    player = (
        f'<figure><audio controls aria-label="{words}" src="data:audio/wav;base64,{data}"></audio>'
        f"<figcaption>{words}</figcaption></figure>"
    )
    display({"text/html": player, "text/plain": f"Sound: {alt}"}, raw=True)  # type: ignore[no-untyped-call]


def _wav(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]], rate: int) -> bytes:
    """Return samples as a WAV file with one channel."""
    buffer = io.BytesIO()
    with wave.open(buffer, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(np.round(values * LARGEST).astype("<i2").tobytes())
    return buffer.getvalue()
