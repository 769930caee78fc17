"""Diagrams: the pipeline that every collision goes through."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch

from lesson_code.view.matplotlib import style

PIPELINE = (
    ("detection", ("broad phase", "narrow phase")),
    ("resolution", ("impulse calculation", "position correction", "velocity update")),
    ("post-processing", ("callbacks", "effects", "sound")),
)
"""The stages in the order data flows through them, each with its steps."""

STAGE_COLORS = (style.SKY, style.ORANGE, style.GREEN)


LOW, NAME, LINE = 0.5, 0.4, 0.2
"""Height of a step's box with its name alone; of the name, and of a line of functions below it."""

GAP = 0.3
"""Between two steps."""


def pipeline(
    ax: Axes, marked: Collection[str] = (), functions: Mapping[str, str] | None = None
) -> Axes:
    """Draw the pipeline from detection to post-processing.

    Parameters
    ----------
    ax : Axes
        Where to draw; give it about 9 x 2.6 inches, and 9 x 4 with functions.
    marked : collection of str
        Steps to mark with a thick frame: those that a chapter is about.
    functions : mapping of str to str, optional
        The functions that do a step, to be written below its name.

    Raises
    ------
    ValueError
        A step that is named is not in the pipeline.
    """
    known = {step for _, steps in PIPELINE for step in steps}
    for name, named in (("marked", marked), ("functions", functions or {})):
        for step in named:
            if step not in known:
                raise ValueError(
                    f"{name} must hold steps of the pipeline {sorted(known)}, got {step!r}"
                )
    lines = max((text.count("\n") + 1 for text in (functions or {}).values()), default=0)
    height = NAME + LINE * lines if lines else LOW
    top = 0.5 + 3 * (height + GAP)
    for column, ((stage, steps), color) in enumerate(zip(PIPELINE, STAGE_COLORS, strict=True)):
        _stage(ax, 3.4 * column, top, stage, color)
        for row, step in enumerate(steps):
            y = top - 0.38 - (row + 1) * (height + GAP)
            text = (functions or {}).get(step, "")
            _step(ax, 3.4 * column, y, height, step, text, step in marked)
        if column:
            ax.annotate(
                "",
                xy=(3.4 * column - 0.05, top / 2 + 0.3),
                xytext=(3.4 * column - 0.75, top / 2 + 0.3),
                arrowprops={"arrowstyle": "-|>", "linewidth": 2, "color": style.INK},
            )
    ax.set_xlim(-0.1, 9.6)
    ax.set_ylim(-0.1, top + 0.3)
    ax.axis("off")
    return ax


def _stage(ax: Axes, x: float, top: float, name: str, color: str) -> None:
    """Draw one stage: a frame with its name."""
    ax.add_patch(
        FancyBboxPatch(
            (x, 0),
            2.6,
            top,
            boxstyle="round,pad=0.05",
            facecolor=color,
            alpha=0.25,
            edgecolor="none",
        )
    )
    ax.text(x + 1.3, top - 0.28, name, ha="center", va="center", fontsize=12, fontweight="bold")


def _step(
    ax: Axes, x: float, y: float, height: float, name: str, functions: str, marked: bool
) -> None:
    """Draw one step: a box with its name, and below it the functions that do it."""
    ax.add_patch(
        FancyBboxPatch(
            (x + 0.15, y),
            2.3,
            height,
            boxstyle="round,pad=0.03",
            facecolor="white",
            edgecolor=style.INK,
            linewidth=2.8 if marked else 0.8,
        )
    )
    below = y + (height - 0.17 if functions else height / 2)
    ax.text(x + 1.3, below, name, ha="center", va="center", fontsize=10)
    if functions:
        look: dict[str, Any] = {
            "ha": "center",
            "va": "center",
            "fontsize": 9,
            "family": "monospace",
        }
        middle = y + (height - NAME) / 2 + 0.06
        ax.text(x + 1.3, middle, functions, **look, color=style.BLUE, linespacing=1.35)
