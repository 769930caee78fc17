"""A film of a window as an animated GIF, in which Pillow keeps only what changes."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from PIL import Image
from PIL.Image import Resampling

from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.view.pygame.window import pygame

PICTURES_PER_SECOND = 20
"""1/s: every third frame. The format counts in hundredths of a second, and this is five of them."""

MOST_SECONDS = 30
"""s: a longer film is larger than a page or a mail takes, and than the memory of a laptop: until
the film is written, each picture takes a byte a pixel."""

MOST_PICTURES = PICTURES_PER_SECOND * MOST_SECONDS

COLOURS = 255
"""In a picture; the last place of its table of 256 is taken by what stays as it was."""


class Gif:
    """A film that is being made; :meth:`close` writes it.

    Parameters
    ----------
    path : path
        The .gif file.
    size : (int, int)
        Width and height of the film, px; what is seen is scaled to it.

    Attributes
    ----------
    pictures : int
        How many there are, each 1 / :data:`PICTURES_PER_SECOND` long. At :data:`MOST_PICTURES` the
        film is full, and takes no more.

    Raises
    ------
    OSError
        The file cannot be written.
    """

    def __init__(self, path: str | Path, size: tuple[int, int]) -> None:
        self._file = Path(path).open("wb")  # noqa: SIM115 - closed at the end of the film
        self._size = size
        self._seen: list[Image.Image] = []
        self._clock = 0.0
        self.pictures = 0

    def close(self) -> None:
        """Write the film."""
        with self._file:
            if self._seen:
                self._seen.reverse()
                self._seen.pop().save(
                    self._file,
                    "gif",
                    save_all=True,
                    append_images=self._others(),
                    duration=1000 // PICTURES_PER_SECOND,
                    loop=0,  # for ever
                )

    def _others(self) -> Iterator[Image.Image]:
        """Yield the pictures after the first, and forget them."""
        while self._seen:
            yield self._seen.pop()

    @property
    def is_full(self) -> bool:
        """Whether the film takes no more pictures."""
        return self.pictures >= MOST_PICTURES

    @property
    def seconds(self) -> float:
        """How long the film is, s."""
        return self.pictures / PICTURES_PER_SECOND

    def see(self, surface: pygame.Surface, elapsed: float) -> None:
        """Take what is seen now, so much time after the last call, s; the first takes a picture."""
        self._clock += elapsed
        due = 1 + whole_parts(self._clock, 1 / PICTURES_PER_SECOND) - self.pictures
        due = min(due, MOST_PICTURES - self.pictures)
        if due > 0:
            self.pictures += due
            self._seen += self._seen[-1:] * (due - 1)  # the last one was on the screen till now
            self._seen.append(_reduced(surface, self._size))


def _reduced(surface: pygame.Surface, size: tuple[int, int]) -> Image.Image:
    """Return what a surface shows, in the size and the colours of the film."""
    pixels = pygame.image.tostring(surface, "RGB")
    image = Image.frombytes("RGB", surface.get_size(), pixels)
    return image.resize(size, Resampling.HAMMING).quantize(COLOURS)  # the octree loses faint lines
