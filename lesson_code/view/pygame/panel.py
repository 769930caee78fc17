"""The panel beside the field: title, read-outs, curves and keys, one below the other."""

from __future__ import annotations

from collections.abc import Sequence

from lesson_code.view.pygame.picture import FIELD_SIZE, GRID
from lesson_code.view.pygame.window import FADED_INK, INK, Colour, Window, pygame

PANEL_WIDTH = 280
"""px."""

PROGRAM_SIZE = (FIELD_SIZE[0] + PANEL_WIDTH, FIELD_SIZE[1])
"""px: the window of every program."""

PANEL: Colour = (30, 36, 44)
MARGIN = 16
"""px, on all sides."""

LINE, KEY_LINE = 24, 20
"""px: from one line to the next, of read-outs and of keys."""

TITLE_SIZE, READING_SIZE, KEY_SIZE = 30, 22, 19
"""px: height of the letters."""

KEY_COLUMN = 84
"""px: from the keys to what they do."""

CURVE_HEIGHT = 62
"""px."""


class Panel:
    """Writes from the top downward; the keys stand at the bottom.

    Parameters
    ----------
    window : Window
        What is drawn in.
    title : str
        The program's name.
    """

    def __init__(self, window: Window, title: str) -> None:
        self._window, self._title = window, title
        self._left, self._right = FIELD_SIZE[0] + MARGIN, PROGRAM_SIZE[0] - MARGIN
        self._y = 0

    def begin(self) -> None:
        """Empty the panel and write the title."""
        self._window.surface.fill(PANEL, (FIELD_SIZE[0], 0, PANEL_WIDTH, FIELD_SIZE[1]))
        self._window.text(self._title, (self._left, MARGIN), size=TITLE_SIZE)
        self._y = MARGIN + 36

    def readings(self, readings: Sequence[tuple[str, str]], colour: Colour | None = None) -> None:
        """Write names at the left and values at the right, perhaps in a colour of their own."""
        for name, value in readings:
            left, right = (self._left, self._y), (self._right, self._y)
            self._window.text(name, left, colour=colour or FADED_INK, size=READING_SIZE)
            self._window.text(
                value, right, colour=colour or INK, size=READING_SIZE, anchor="topright"
            )
            self._y += LINE

    def curve(self, name: str, values: Sequence[float], colour: Colour) -> None:
        """Draw the history of a quantity, from 0 at the bottom to its largest at the top."""
        self._window.text(name, (self._left, self._y + 6), colour=FADED_INK, size=KEY_SIZE)
        top, width = self._y + 24, self._right - self._left
        pygame.draw.rect(self._window.surface, GRID, (self._left, top, width, CURVE_HEIGHT))
        largest = max((abs(value) for value in values), default=0.0) or 1.0
        if len(values) > 1:
            across, high = width / (len(values) - 1), CURVE_HEIGHT - 6
            points = [
                (self._left + k * across, top + CURVE_HEIGHT - 3 - high * abs(value) / largest)
                for k, value in enumerate(values)
            ]
            pygame.draw.aalines(self._window.surface, colour, False, points)
        self._y = top + CURVE_HEIGHT + 4

    def keys(self, keys: Sequence[tuple[str, str]]) -> None:
        """Write what the keys do, at the bottom."""
        y = FIELD_SIZE[1] - MARGIN - KEY_LINE * len(keys)
        for key, meaning in keys:
            self._window.text(key, (self._left, y), colour=INK, size=KEY_SIZE)
            self._window.text(
                meaning, (self._left + KEY_COLUMN, y), colour=FADED_INK, size=KEY_SIZE
            )
            y += KEY_LINE
