"""A plan as a page over the field: each effect, what has become of it, and why."""

from __future__ import annotations

from lesson_code.engine.core.plan import Plan
from lesson_code.view.pygame.picture import FIELD_SIZE, GRID
from lesson_code.view.pygame.window import (
    BACKGROUND,
    FADED_INK,
    INK,
    ORANGE,
    SKY,
    SMALL_TEXT_SIZE,
    Colour,
    Window,
)

MARGIN = 24
"""px, on all sides."""

COLUMNS = (24, 190, 290)
"""px: where names, verdicts and reasons begin."""

LINE, GAP = 19, 6
"""px: from a line to the next one, and more from a row to the next one."""

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
    window.surface.fill(BACKGROUND, ((0, 0), FIELD_SIZE))
    window.text(title, (MARGIN, MARGIN - 6))
    y = _paragraph(window, plan.headline, (MARGIN, MARGIN + 20), FADED_INK) + GAP
    for choice in plan.effects:
        window.surface.fill(GRID, (MARGIN, y - 4, FIELD_SIZE[0] - 2 * MARGIN, 1))
        runs = VERDICT_COLOURS.get(choice.verdict, FADED_INK)
        window.text(choice.name, (COLUMNS[0], y), size=SMALL_TEXT_SIZE)
        window.text(choice.verdict, (COLUMNS[1], y), colour=runs, size=SMALL_TEXT_SIZE)
        y = _paragraph(window, choice.reason, (COLUMNS[2], y), INK if choice.used else FADED_INK)
        y += GAP
    _paragraph(window, note, (MARGIN, y + GAP), FADED_INK)


def _paragraph(window: Window, words: str, place: tuple[int, int], colour: Colour) -> int:
    """Write words in as many lines as they take, and return where the next line begins, px."""
    x, y = place
    for line in window.wrapped(words, FIELD_SIZE[0] - MARGIN - x, SMALL_TEXT_SIZE):
        window.text(line, (x, y), colour=colour, size=SMALL_TEXT_SIZE)
        y += LINE
    return y
