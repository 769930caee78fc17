"""A plan as a page over the field: each effect, what has become of it, and why."""

from __future__ import annotations

from lesson_code.engine.core.plan import Plan
from lesson_code.view.pygame.picture import FIELD_SIZE, GRID, PANEL_WIDTH
from lesson_code.view.pygame.window import (
    BACKGROUND,
    FADED_INK,
    INK,
    ORANGE,
    SKY,
    Colour,
    Window,
)

MARGIN = 24
"""Points, on all sides; lengths below are in points, too."""

COLUMNS = (24, 176, 270)
"""Where names, verdicts and reasons begin."""

SIZE, LINE, GAP = 18, 17, 5
"""Height of a line; from a line to the next one, and more from a row to the next one."""

VERDICT_COLOURS: dict[str, Colour] = {"used": SKY, "forced": ORANGE}
"""Of those that run; the word says it too."""


def draw_plan(window: Window, plan: Plan, title: str, note: str) -> None:
    """Draw a plan over the whole field.

    Parameters
    ----------
    window : Window
        What is drawn in.
    plan : Plan
        What is shown.
    title, note : str
        A line above the table, and some below it.
    """
    left, top, right = (
        window.px(points) for points in (MARGIN, MARGIN - 6, FIELD_SIZE[0] - MARGIN)
    )
    columns, gap = [window.px(column) for column in COLUMNS], window.px(GAP)
    width = window.surface.get_width() - window.px(PANEL_WIDTH)
    window.surface.fill(BACKGROUND, (0, 0, width, window.surface.get_height()))
    window.text(title, (left, top))
    y = _paragraph(window, plan.headline, (left, top + window.px(26)), FADED_INK) + gap
    for choice in plan.effects:
        window.surface.fill(GRID, (left, y - window.px(3), right - left, 1))
        runs = VERDICT_COLOURS.get(choice.verdict, FADED_INK)
        window.text(choice.name, (columns[0], y), size=SIZE)
        window.text(choice.verdict, (columns[1], y), colour=runs, size=SIZE)
        y = _paragraph(window, choice.reason, (columns[2], y), INK if choice.used else FADED_INK)
        y += gap
    _paragraph(window, note, (left, y + gap), FADED_INK)


def _paragraph(window: Window, words: str, place: tuple[int, int], colour: Colour) -> int:
    """Write words in as many lines as they take, and return where the next line begins, px."""
    x, y = place
    for line in window.wrapped(words, window.px(FIELD_SIZE[0] - MARGIN) - x, SIZE):
        window.text(line, (x, y), colour=colour, size=SIZE)
        y += window.px(LINE)
    return y
