"""The pygame window that all programs share: opening it, colours, text, arrows, smooth shapes, PNG.

Importing this module imports pygame, and nothing else in the package does: a program's module
imports it, and is itself imported only when the program runs.

Places are in pixels of the window, y down, and may be fractions: pixel 7 reaches from 7 to 8. Sizes
of letters and lines are in points: there are 600 from the top of a window to its bottom, or fewer
in a narrow one.
"""

from __future__ import annotations

import importlib.metadata
import importlib.util
import math
import os
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache, lru_cache
from pathlib import Path
from typing import TypeAlias

from lesson_code.view.palette import PUBLISHED, rgb

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
try:
    import pygame
except ImportError as missing:
    raise ImportError(
        "the programs need pygame, which is not installed: pip install pygame-ce"
    ) from missing
if not hasattr(pygame, "init"):
    # Removing one of pygame and pygame-ce takes the other one's files with it.
    raise ImportError(
        "the pygame that is installed is empty: pip install --force-reinstall pygame-ce"
    )

__all__ = [
    "Colour",
    "Place",
    "Window",
    "antialiased",
    "blend",
    "draw_capsule",
    "open_window",
    "pygame",
    "pygame_distributions",
    "smooth_disc",
    "warn_if_both_installed",
]

Colour: TypeAlias = tuple[int, int, int]
"""Red, green and blue, 0 to 255."""

Place: TypeAlias = tuple[float, float]
"""x to the right and y down, px."""

ORANGE: Colour = rgb(PUBLISHED.orange)
SKY: Colour = rgb(PUBLISHED.sky)
GREEN: Colour = rgb(PUBLISHED.green)
YELLOW: Colour = rgb(PUBLISHED.yellow)
BLUE: Colour = rgb(PUBLISHED.blue)
VERMILION: Colour = rgb(PUBLISHED.vermilion)
PURPLE: Colour = rgb(PUBLISHED.purple)

INK: Colour = (240, 240, 236)
FADED_INK: Colour = (176, 184, 188)
BACKGROUND: Colour = (22, 27, 34)

DEJAVU = "fonts/ttf/DejaVuSans.ttf"
"""The letters of all programs, in Matplotlib's folder of data; LICENSE_DEJAVU lies beside them."""

KEPT_LINES = 256
"""Lines whose pictures are kept: most of them are the same from frame to frame."""

RIM = 1.5
"""px, round an arrow."""

FRAMES_PER_SECOND = 60
"""1/s: what the programs ask for; the clock says what they got."""

TEXT_SIZE = 22
"""Points, height of a line of ordinary text."""

SMALL_TEXT_SIZE = 20
"""Points, height of a line of help; smaller is hard to read."""

LETTER = 0.66
"""Of the height of a line: the size of its letters."""

SMALLEST_LETTERS = 6
"""px: nobody could read smaller ones."""

POINTS = (1080, 600)
"""Points, of a window of the usual form; any other form has as many in one direction at least."""

SMOOTHNESS = 4
"""Smooth shapes are painted this many times larger and then reduced."""

HEADLESS = {"SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy"}
"""The environment that makes pygame work without screen and loudspeaker."""


UNSEEN = ("dummy", "offscreen")
"""The drivers of SDL that draw where nobody can see it."""


class Window:
    """An open window, or a surface in memory that stands for it; :func:`open_window` makes it.

    Parameters
    ----------
    surface : pygame.Surface
        What is drawn on.
    """

    def __init__(self, surface: pygame.Surface) -> None:
        self.surface = surface
        self._clock = pygame.time.Clock()
        self._size = surface.get_size()
        self._written = lru_cache(KEPT_LINES)(self._write)
        self._measured = lru_cache(KEPT_LINES)(_width)

    @property
    def unit(self) -> float:
        """A point, px."""
        width, height = self.surface.get_size()
        return min(width / POINTS[0], height / POINTS[1])

    def px(self, points: float) -> int:
        """Return a length as a whole number of pixels, at least one."""
        return max(round(points * self.unit), 1)

    def fill_screen(self) -> None:
        """Fill the whole screen, or be the window again that it was."""
        if self.surface.get_flags() & pygame.FULLSCREEN:
            self.surface = pygame.display.set_mode(self._size, pygame.RESIZABLE)
        else:
            self._size = self.surface.get_size()
            self.surface = pygame.display.set_mode((0, 0), pygame.FULLSCREEN)

    def fill(self, colour: Colour, left: int, right: int) -> None:
        """Fill the window from a column of pixels to another one, from top to bottom.

        SDL's own fill writes past the processor's cache: all that is drawn on it afterwards would
        take more than twice as long.
        """
        pixels = pygame.surfarray.pixels2d(self.surface)
        pixels.T[:, left:right] = self.surface.map_rgb(colour)

    def text(
        self,
        words: str,
        place: Place,
        *,
        colour: Colour = INK,
        size: int = TEXT_SIZE,
        anchor: str = "topleft",
    ) -> pygame.Rect:
        """Write one line and return the rectangle it fills.

        `anchor` is the name of the point of that rectangle which comes to lie at `place`:
        "topleft", "center", "midright" and so on.
        """
        written = self._written(words, self._letters(size), colour)
        rectangle = written.get_rect(**{anchor: (round(place[0]), round(place[1]))})
        return self.surface.blit(written, rectangle)

    def width(self, words: str, size: float = TEXT_SIZE) -> int:
        """Return the width of a line, px."""
        return self._measured(words, self._letters(size))

    def wrapped(self, words: str, width: float, size: float = TEXT_SIZE) -> list[str]:
        """Return words in lines that are no wider than `width` px; a long word has its own line."""
        lines: list[str] = []
        for word in words.split():
            longer = f"{lines[-1]} {word}" if lines else word
            if lines and self.width(longer, size) <= width:
                lines[-1] = longer
            else:
                lines.append(word)
        return lines

    def _letters(self, size: float) -> int:
        """Return the size of letters in lines of a height in points, px."""
        return max(round(LETTER * size * self.unit), SMALLEST_LETTERS)

    def _write(self, words: str, size: int, colour: Colour) -> pygame.Surface:
        """Return the picture of a line in letters of a size in px."""
        return letters(size).render(words, True, colour)

    def arrow(self, tail: Place, along: Place, colour: Colour, *, width: float = 3.0) -> None:
        """Draw an arrow from `tail` to `tail` + `along`; one shorter than a pixel is left out.

        A dark rim sets it off from light bodies; on the dark ground it shows by itself. `width` is
        in points.
        """
        length, width = math.hypot(*along), width * self.unit
        if length < 1:
            return
        direction = along[0] / length, along[1] / length
        for ink, rim in ((BACKGROUND, RIM), (colour, 0.0)):
            corners = _arrow_outline(tail, direction, length, width, rim)
            pygame.draw.polygon(self.surface, ink, corners)
            pygame.draw.aalines(self.surface, ink, True, corners)

    def show(self) -> None:
        """Bring what was drawn to the screen; the next picture has the size of the window then."""
        pygame.display.flip()
        self.surface = pygame.display.get_surface() or self.surface

    def wait(self) -> float:
        """Wait for the next frame and return the time since the last one, s."""
        return self._clock.tick(FRAMES_PER_SECOND) / 1000

    def save(self, path: str | Path) -> None:
        """Write what was drawn to a PNG file.

        Raises
        ------
        ValueError
            The name does not end in .png.
        OSError
            The file cannot be written.
        """
        if Path(path).suffix.lower() != ".png":
            raise ValueError(f"path must end in .png, got {str(path)!r}")
        with Path(path).open("wb") as file:
            pygame.image.save(self.surface, file, "screenshot.png")


@contextmanager
def open_window(size: tuple[int, int], caption: str, *, headless: bool = False) -> Iterator[Window]:
    """Open a window for the length of a with block.

    Parameters
    ----------
    size : (int, int)
        Width and height at first, px. The user may give the window any other size.
    caption : str
        The window's title.
    headless : bool
        Draw into memory, with no screen and no sound: SDL's "dummy" drivers.

    Yields
    ------
    Window

    Raises
    ------
    RuntimeError
        There is no screen to open a window on.

    Warns
    -----
    RuntimeWarning
        Both pygame and pygame-ce are installed.

    Examples
    --------
    >>> with open_window((320, 240), "Example", headless=True) as window:
    ...     window.surface.get_size()
    (320, 240)
    """
    warn_if_both_installed()
    before = {name: os.environ.get(name) for name in HEADLESS}
    if headless:
        os.environ.update(HEADLESS)
    try:
        pygame.font.init()
        yield Window(_open_surface(size, caption, headless))
    finally:
        pygame.display.quit()
        for name, value in before.items():
            os.environ.pop(name, None)
            if value is not None:
                os.environ[name] = value


@cache
def letters(size: int) -> pygame.font.Font:
    """Return DejaVu Sans in a size, px; Matplotlib brings the file, and its free licence with it.

    Where Matplotlib is missing, pygame has letters of its own.
    """
    found = importlib.util.find_spec("matplotlib")
    if found is None or found.origin is None:
        return pygame.font.Font(None, size)
    return pygame.font.Font(Path(found.origin).parent / "mpl-data" / DEJAVU, size)


def _width(words: str, size: int) -> int:
    """Return the width of a line in letters of a size, px."""
    return letters(size).size(words)[0]


def blend(colour: Colour, other: Colour, part: float) -> Colour:
    """Return a colour between two: `part` 0 gives the first, 1 the other.

    >>> blend((0, 0, 0), (200, 100, 50), 0.5)
    (100, 50, 25)
    """
    red, green, blue = (round(a + part * (b - a)) for a, b in zip(colour, other, strict=True))
    return red, green, blue


def antialiased(
    size: tuple[int, int], paint: Callable[[pygame.Surface, int], None], empty: Colour
) -> pygame.Surface:
    """Return a picture with smooth edges: painted larger, then reduced.

    Parameters
    ----------
    size : (int, int)
        Width and height of the picture, px.
    paint : callable
        ``paint(surface, scale)`` paints it `scale` times larger.
    empty : Colour
        The colour that shows, fully transparent, where nothing is painted. At the edge of a
        shape it mixes with the shape's own.
    """
    large = pygame.Surface((size[0] * SMOOTHNESS, size[1] * SMOOTHNESS), pygame.SRCALPHA)
    large.fill((*empty, 0))
    paint(large, SMOOTHNESS)
    return pygame.transform.smoothscale(large, size)


def draw_capsule(
    surface: pygame.Surface, start: Place, end: Place, half_thickness: float, colour: Colour
) -> None:
    """Draw all points within `half_thickness` of a segment: a thick line with round ends."""
    (x1, y1), (x2, y2) = start, end
    length = math.hypot(x2 - x1, y2 - y1)
    across_x, across_y = -(y2 - y1) / length * half_thickness, (x2 - x1) / length * half_thickness
    pygame.draw.polygon(
        surface,
        colour,
        [
            (x1 + across_x, y1 + across_y),
            (x2 + across_x, y2 + across_y),
            (x2 - across_x, y2 - across_y),
            (x1 - across_x, y1 - across_y),
        ],
    )
    pygame.draw.circle(surface, colour, start, half_thickness)
    pygame.draw.circle(surface, colour, end, half_thickness)


def smooth_disc(radius: float, colour: Colour) -> pygame.Surface:
    """Return a picture of a disc; its centre is the centre of the picture."""
    side = 2 * math.ceil(radius + 1)

    def paint(surface: pygame.Surface, scale: int) -> None:
        middle = side * scale / 2
        pygame.draw.circle(surface, colour, (middle, middle), radius * scale)

    return antialiased((side, side), paint, colour)


def pygame_distributions() -> dict[str, str]:
    """Return name and version of every installed distribution that brings a pygame."""
    found = {}
    for name in ("pygame", "pygame-ce"):
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            continue
    return found


def warn_if_both_installed() -> None:
    """Warn when both pygame and pygame-ce are installed.

    They write the same files, so the one installed last is the one that runs, and removing
    either breaks the other.
    """
    found = pygame_distributions()
    if len(found) > 1:
        listed = " and ".join(f"{name} {version}" for name, version in found.items())
        warnings.warn(
            f"{listed} are both installed and overwrite each other; keep one: "
            "pip uninstall pygame pygame-ce, then pip install pygame-ce",
            RuntimeWarning,
            stacklevel=2,
        )


def _open_surface(size: tuple[int, int], caption: str, headless: bool) -> pygame.Surface:
    """Return the display's surface, or raise a RuntimeError when there is no screen."""
    no_screen = "no screen to open a window on; run the program headless"
    if os.environ.get("DISPLAY") and os.environ.get("SDL_VIDEODRIVER", "x11") == "x11":
        # What was drawn goes to X as it is. Else SDL sends it through OpenGL, which takes 14 ms
        # a picture of 1920 x 1080 where no graphics card does it.
        os.environ.setdefault("SDL_FRAMEBUFFER_ACCELERATION", "0")
    try:
        pygame.display.init()
        unseen = pygame.display.get_driver() in UNSEEN
        if unseen and not headless and "SDL_VIDEODRIVER" not in os.environ:
            # SDL falls back on drawing where nobody can see it, but nobody asked for that.
            raise RuntimeError(no_screen)
        surface = pygame.display.set_mode(size, pygame.RESIZABLE)
    except pygame.error as error:
        raise RuntimeError(f"{no_screen} (SDL says: {error})") from error
    pygame.display.set_caption(caption)
    return surface


def _arrow_outline(
    tail: Place, direction: Place, length: float, width: float, rim: float
) -> list[Place]:
    """Return the seven corners of an arrow, from its tail round its tip and back; with a rim."""
    head = min(4 * width, length)  # as wide as it is long, so that its half angle is atan(1/2)
    half_shaft, half_head = width / 2 + rim, (head + (1 + math.sqrt(5)) * rim) / 2
    neck, tip = length - head - rim, length + math.sqrt(5) * rim
    (x, y), (ux, uy) = tail, direction

    def corner(along: float, across: float) -> Place:
        return x + along * ux - across * uy, y + along * uy + across * ux

    return [
        corner(-rim, half_shaft),
        corner(neck, half_shaft),
        corner(neck, half_head),
        corner(tip, 0),
        corner(neck, -half_head),
        corner(neck, -half_shaft),
        corner(-rim, -half_shaft),
    ]
