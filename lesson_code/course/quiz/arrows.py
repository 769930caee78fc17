"""The sheet on which an arrow is drawn: a grid, a wall, and the arrows that are given.

It is drawn here once and works without a script, as a picture above two boxes for the components.
The script of the forms (``quiz.js``) lets the reader drag the tip.
"""

from __future__ import annotations

import math
from html import escape

from lesson_code.course.quiz.questions import ArrowQuestion, Tip

HALF = 100.0
"""Half of the sheet's width, in its own units; y grows downwards in them."""

MARGIN = 8.0
"""Around the sheet, so that a tip on its edge is seen as a whole."""

HEAD = 7.0
"""Length of an arrow's head."""


def sheet(question: ArrowQuestion) -> str:
    """Return the sheet of a question as SVG; the arrow to be drawn is an empty path in it."""
    unit = HALF / question.reach
    edge = HALF + MARGIN
    lines = round(question.reach / question.spacing)
    places = [unit * question.spacing * k for k in range(-lines, lines + 1)]
    grid = "".join(f"M{p:g} {-HALF:g}V{HALF:g}M{-HALF:g} {p:g}H{HALF:g}" for p in places)
    arrows = "".join(_given(name, tip, unit) for name, tip in question.given.items())
    return (
        f'<svg class="sheet" viewBox="{-edge:g} {-edge:g} {2 * edge:g} {2 * edge:g}" '
        f'data-unit="{unit:g}" role="img" aria-label="{escape(question.in_words)}">\n'
        f'<path class="grid" d="{grid}"/>\n{_wall(question)}{arrows}'
        f'<path class="drawn" d=""/>\n</svg>'
    )


def arrow_path(tip: Tip) -> str:
    """Return the path of an arrow from the origin, its head included; quiz.js draws the same."""
    length, angle = math.hypot(*tip), math.atan2(tip[1], tip[0])
    path = f"M0 0L{tip[0]:g} {tip[1]:g}"
    head = min(HEAD, length / 2)
    for side in (0.5, -0.5):
        x, y = (tip[0] - head * math.cos(angle + side), tip[1] - head * math.sin(angle + side))
        path += f"M{tip[0]:g} {tip[1]:g}L{x:.1f} {y:.1f}"
    return path


def _given(name: str, tip: Tip, unit: float) -> str:
    """Return an arrow that stands on the sheet, with its name beyond its tip."""
    x, y = tip[0] * unit, -tip[1] * unit
    beyond = 1 + 11 / math.hypot(x, y)
    return (
        f'<path class="given" d="{arrow_path((x, y))}"/>'
        f'<text x="{beyond * x:.1f}" y="{beyond * y:.1f}">{escape(name)}</text>\n'
    )


def _wall(question: ArrowQuestion) -> str:
    """Return the wall through the middle, with strokes on the side that its normal leaves."""
    if question.wall is None:
        return ""
    x, y = question.wall
    n = (x / math.hypot(x, y), -y / math.hypot(x, y))
    along = (-n[1], n[0])
    path = f"M{-HALF * along[0]:.1f} {-HALF * along[1]:.1f}"
    path += f"L{HALF * along[0]:.1f} {HALF * along[1]:.1f}"
    for k in range(-9, 10):
        start = (10 * k * along[0], 10 * k * along[1])
        path += f"M{start[0]:.1f} {start[1]:.1f}"
        path += f"l{5 * (along[0] - n[0]):.1f} {5 * (along[1] - n[1]):.1f}"
    return f'<path class="wall" d="{path}"/>\n'
