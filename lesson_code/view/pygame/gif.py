"""A film of a window as an animated GIF, written picture by picture.

Only what has changed since the last picture is written, and nothing but that picture is kept: a
film takes as much memory as two pictures, however long it is. Pillow finds the colours and packs
the pictures; the few bytes around them are those of the format.
"""

from __future__ import annotations

import struct
from pathlib import Path
from types import TracebackType
from typing import NamedTuple

from PIL import Image, ImageChops
from PIL.GifImagePlugin import getdata
from PIL.Image import Resampling

from lesson_code.formulas.arithmetic import whole_parts
from lesson_code.view.pygame.window import pygame

PICTURES_PER_SECOND = 20
"""1/s: every third frame. The format counts in hundredths of a second, and this is five of them."""

MOST_SECONDS = 30
"""s: a longer film is larger than a page or a mail takes."""

MOST_PICTURES = PICTURES_PER_SECOND * MOST_SECONDS

COLOURS = 255
"""In a picture; the last place of its table of 256 is taken by what stays as it was."""

END = b";"
FOR_EVER = b"!\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00"
"""After the last picture a viewer begins again."""


class Change(NamedTuple):
    """What a picture changes: its pixels, where they belong, and how long it is seen."""

    pixels: Image.Image
    corner: tuple[int, int]
    pictures: int  # of the usual length


class Gif:
    """A film that is being written; with a ``with`` block it is finished too.

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
        self._size = size
        self._seen: Image.Image | None = None
        self._change: Change | None = None
        self._clock = 0.0
        self.pictures = 0
        self._file = Path(path).open("wb")  # noqa: SIM115 - closed at the end of the film
        self._file.write(b"GIF89a" + struct.pack("<HHBBB", *size, 0, 0, 0) + FOR_EVER)

    def __enter__(self) -> Gif:
        """Return the film."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Finish the film, whatever has ended it."""
        with self._file:
            self._write_change()
            self._file.write(END)

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
        if due <= 0:
            return
        self.pictures += due
        seen = _reduced(surface, self._size)
        box = (0, 0, *self._size) if self._seen is None else _box_of_change(self._seen, seen)
        if box is None:
            self._hold(due)
            return
        self._hold(due - 1)
        self._write_change()
        self._change = Change(_packed(seen, self._seen, box), box[:2], 1)
        self._seen = seen

    def _hold(self, pictures: int) -> None:
        """Let the last picture stay for longer."""
        if self._change is not None:
            self._change = self._change._replace(pictures=self._change.pictures + pictures)

    def _write_change(self) -> None:
        """Write the picture that has waited to know how long it is seen."""
        if self._change is None:
            return
        pixels, corner, pictures = self._change
        self._file.writelines(
            getdata(
                pixels,
                corner,
                duration=1000 * pictures // PICTURES_PER_SECOND,
                disposal=1,  # the next picture is drawn over this one
                transparency=COLOURS,
                include_color_table=True,
            )
        )
        self._change = None


def _reduced(surface: pygame.Surface, size: tuple[int, int]) -> Image.Image:
    """Return what a surface shows, in the size of the film."""
    pixels = pygame.image.tostring(surface, "RGB")
    return Image.frombytes("RGB", surface.get_size(), pixels).resize(size, Resampling.HAMMING)


def _box_of_change(before: Image.Image, after: Image.Image) -> tuple[int, int, int, int] | None:
    """Return the box round all that differs, left, top, right, bottom; None: nothing does."""
    return ImageChops.difference(before, after).getbbox()


def _packed(
    after: Image.Image, before: Image.Image | None, box: tuple[int, int, int, int]
) -> Image.Image:
    """Return a part of a picture in 255 colours; what is as before is transparent."""
    part = after.crop(box)
    packed = part.quantize(COLOURS)
    table = packed.getpalette() or []
    packed.putpalette(table + [0] * (3 * (COLOURS + 1) - len(table)))
    if before is not None:
        red, green, blue = ImageChops.difference(part, before.crop(box)).split()
        change = ImageChops.lighter(ImageChops.lighter(red, green), blue)
        packed.paste(COLOURS, mask=change.point([255] + 255 * [0], "1"))
    return packed
