"""The panel beside the field: title, clock, read-outs, curves, and keys, sliders or legend."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.legend import Mark
from lesson_code.view.pygame.picture import GRID, LINE, PANEL_WIDTH
from lesson_code.view.pygame.window import FADED_INK, INK, SKY, YELLOW, Colour, Window, pygame

PROGRAM_SIZE = (1280, 720)
"""px: the window of every program, at first."""

PANEL: Colour = (30, 36, 44)
MARGIN = 16
"""Points, on all sides; lengths below are in points, too."""

KEY_LINE = 20
"""From one line to the next, of keys."""

TITLE_SIZE, READING_SIZE, KEY_SIZE = 28, 20, 18
"""Height of a line."""

KEY_COLUMN = 88
"""From the keys to what they do."""

MARK_WIDTH = 26
"""Of a colour or an arrow in the legend."""

CURVE_HEIGHT = 44
SLIDER_LINE, KNOB = 38, 6
"""From one slider to the next; the radius of its knob."""


class Panel:
    """Writes from the top downward; keys, sliders or the legend stand at the bottom.

    Parameters
    ----------
    window : Window
        What is drawn in.
    title : str
        The program's name.
    """

    def __init__(self, window: Window, title: str) -> None:
        self._window, self._title = window, title
        self._y = 0
        self.sliders: dict[str, pygame.Rect] = {}

    def begin(self) -> None:
        """Empty the panel and write the title."""
        width, px = self._window.surface.get_width(), self._window.px
        self._left, self._right = width - px(PANEL_WIDTH) + px(MARGIN), width - px(MARGIN)
        self._window.surface.set_clip(None)
        self._window.fill(PANEL, width - px(PANEL_WIDTH), width)
        self._window.text(self._title, (self._left, px(MARGIN)), size=TITLE_SIZE)
        self._y = px(MARGIN + 34)

    def scale(self, unit: str, pixels: float) -> None:
        """Draw a bar of a round length in the field's scale, px for a unit of length."""
        px = self._window.px
        length = round_below(px(110) / pixels)
        wide, middle = round(length * pixels), self._y + px(LINE) // 2
        words = f"{length:g} {unit}"
        self._window.text("scale", (self._left, self._y), colour=FADED_INK, size=READING_SIZE)
        place = self._right, self._y
        box = self._window.text(words, place, size=READING_SIZE, anchor="topright")
        bar = pygame.Rect(box.left - px(8) - wide, middle, wide, px(2))
        self._window.surface.fill(INK, bar)
        for x in (bar.left, bar.right - px(2)):
            self._window.surface.fill(INK, (x, middle - px(4), px(2), px(10)))
        self._y += px(LINE)

    def readings(self, readings: Sequence[tuple[str, str]], colour: Colour | None = None) -> None:
        """Write names at the left and values at the right, perhaps in a colour of their own."""
        for name, value in readings:
            left, right = (self._left, self._y), (self._right, self._y)
            self._window.text(name, left, colour=colour or FADED_INK, size=READING_SIZE)
            self._window.text(
                value, right, colour=colour or INK, size=READING_SIZE, anchor="topright"
            )
            self._y += self._window.px(LINE)

    def paragraph(self, words: str) -> None:
        """Write words in as many lines as they take."""
        for line in self._window.wrapped(words, self._right - self._left, KEY_SIZE):
            self._window.text(line, (self._left, self._y), colour=YELLOW, size=KEY_SIZE)
            self._y += self._window.px(KEY_LINE)

    def curve(self, name: str, values: Sequence[float], colour: Colour) -> None:
        """Draw the history of a quantity, a value a step, between axes with numbers."""
        px, surface = self._window.px, self._window.surface
        self._window.text(name, (self._left, self._y + px(2)), colour=FADED_INK, size=KEY_SIZE)
        largest = max((abs(value) for value in values), default=0.0) or 1.0
        label = f"{largest:.3g}"
        indent = max(self._window.width(words, KEY_SIZE - 3) for words in (label, "0")) + px(5)
        box = pygame.Rect(
            self._left + indent,
            self._y + px(22),
            self._right - self._left - indent,
            px(CURVE_HEIGHT),
        )
        surface.fill(GRID, box)
        for words, y in ((label, box.top + px(3)), ("0", box.bottom - px(3))):
            self._tick(words, (box.left - px(4), y), "midright")
        seconds = f"\N{MINUS SIGN}{(len(values) - 1) * TIME_STEP:.1f} s"
        for words, place, anchor in (
            (seconds if len(values) > 1 else "", box.bottomleft, "topleft"),
            ("now", box.bottomright, "topright"),
        ):
            self._tick(words, place, anchor)
        if len(values) > 1:
            across, high = box.width / (len(values) - 1), box.height - px(6)
            foot, scale = box.bottom - px(3), high / largest
            points = [
                (box.left + k * across, foot - scale * abs(value)) for k, value in enumerate(values)
            ]
            pygame.draw.aalines(surface, colour, False, points)
        self._y = box.bottom + px(17)

    def _tick(self, words: str, place: tuple[int, int], anchor: str) -> None:
        """Write a number beside an axis."""
        self._window.text(words, place, colour=FADED_INK, size=KEY_SIZE - 3, anchor=anchor)

    def keys(self, keys: Sequence[tuple[str, str]]) -> None:
        """Write what the keys do, at the bottom."""
        px = self._window.px
        y = self._window.surface.get_height() - px(MARGIN) - px(KEY_LINE) * len(keys)
        for key, meaning in keys:
            self._window.text(key, (self._left, y), colour=INK, size=KEY_SIZE)
            place = self._left + px(KEY_COLUMN), y
            self._window.text(meaning, place, colour=FADED_INK, size=KEY_SIZE)
            y += px(KEY_LINE)

    def legend(self, marks: Sequence[Mark]) -> None:
        """Write what colours and arrows mean, at the bottom, over read-outs that reach so far.

        Below it one line is left, for a key.
        """
        px, (width, height) = self._window.px, self._window.surface.get_size()
        y = height - px(MARGIN) - px(KEY_LINE) * (len(marks) + 1)
        covered = max(math.ceil((self._y - y) / px(LINE)), 0)  # whole lines
        top = min(self._y - covered * px(LINE), y)
        self._window.surface.fill(PANEL, (self._left, top, width - self._left, height - top))
        for mark in marks:
            mark.draw(self._window, pygame.Rect(self._left, y, px(MARK_WIDTH), px(KEY_LINE)))
            place = self._left + px(MARK_WIDTH + 8), y
            self._window.text(mark.meaning, place, colour=FADED_INK, size=KEY_SIZE)
            y += px(KEY_LINE)

    def slide(self, sliders: Mapping[str, tuple[str, float, float, float | None]]) -> None:
        """Draw sliders at the bottom: by name a label, both ends, and the value if all share it."""
        px, surface = self._window.px, self._window.surface
        y = surface.get_height() - px(MARGIN + KEY_LINE) - px(SLIDER_LINE) * len(sliders)
        self.sliders = {}
        for name, (label, low, high, value) in sliders.items():
            words = "\N{EN DASH}" if value is None else f"{value:.2f}"
            self._window.text(label, (self._left, y), colour=FADED_INK, size=KEY_SIZE)
            self._window.text(words, (self._right, y), size=KEY_SIZE, anchor="topright")
            rail = pygame.Rect(self._left + px(KNOB), y + px(24), 0, px(4))
            rail.width = self._right - px(KNOB) - rail.left
            surface.fill(FADED_INK, rail)
            if value is not None:
                part = min(max((value - low) / (high - low), 0.0), 1.0)
                knob = rail.left + part * rail.width, rail.centery
                pygame.draw.circle(surface, SKY, knob, px(KNOB))
            self.sliders[name] = rail.inflate(0, px(3 * KNOB))
            y += px(SLIDER_LINE)


def round_below(value: float) -> float:
    """Return the largest of 1, 2, 5, 10, 20 ... that is no larger.

    >>> round_below(3.2), round_below(0.03)
    (2.0, 0.02)
    """
    power = 10.0 ** math.floor(math.log10(value))
    return next(k * power for k in (5.0, 2.0, 1.0) if k * power <= value * (1 + 1e-12))
