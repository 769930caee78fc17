"""Diagrams: the pipeline that every collision goes through."""

from __future__ import annotations

from collections.abc import Collection

from matplotlib.axes import Axes
from matplotlib.patches import FancyBboxPatch

from lesson_code.view import style

PIPELINE = (
    ("detection", ("broad phase", "narrow phase")),
    ("resolution", ("impulse calculation", "position correction", "velocity update")),
    ("post-processing", ("callbacks", "effects", "sound")),
)
"""The stages in the order data flows through them, each with its steps."""

STAGE_COLORS = (style.SKY, style.ORANGE, style.GREEN)


def pipeline(ax: Axes, marked: Collection[str] = ()) -> Axes:
    """Draw the pipeline from detection to post-processing.

    Parameters
    ----------
    ax : Axes
        Where to draw; give it about 9 x 2.6 inches.
    marked : collection of str
        Steps to mark with a thick frame: those that a chapter is about.

    Raises
    ------
    ValueError
        A marked step is not in the pipeline.
    """
    known = {step for _, steps in PIPELINE for step in steps}
    for step in marked:
        if step not in known:
            raise ValueError(
                f"marked must hold steps of the pipeline {sorted(known)}, got {step!r}"
            )
    for column, ((stage, steps), color) in enumerate(zip(PIPELINE, STAGE_COLORS, strict=True)):
        _stage(ax, 3.4 * column, stage, steps, color, marked)
        if column:
            ax.annotate(
                "",
                xy=(3.4 * column - 0.05, 1.75),
                xytext=(3.4 * column - 0.75, 1.75),
                arrowprops={"arrowstyle": "-|>", "linewidth": 2, "color": style.INK},
            )
    ax.set_xlim(-0.1, 9.6)
    ax.set_ylim(-0.1, 3.2)
    ax.axis("off")
    return ax


def _stage(
    ax: Axes, x: float, name: str, steps: tuple[str, ...], color: str, marked: Collection[str]
) -> None:
    """Draw one stage: a frame with its name, and its steps below each other."""
    ax.add_patch(
        FancyBboxPatch(
            (x, 0),
            2.6,
            2.9,
            boxstyle="round,pad=0.05",
            facecolor=color,
            alpha=0.25,
            edgecolor="none",
        )
    )
    ax.text(x + 1.3, 2.62, name, ha="center", va="center", fontsize=12, fontweight="bold")
    for row, step in enumerate(steps):
        y = 1.72 - 0.8 * row
        ax.add_patch(
            FancyBboxPatch(
                (x + 0.15, y),
                2.3,
                0.5,
                boxstyle="round,pad=0.03",
                facecolor="white",
                edgecolor=style.INK,
                linewidth=2.8 if step in marked else 0.8,
            )
        )
        ax.text(x + 1.3, y + 0.25, step, ha="center", va="center", fontsize=10)
