"""The figures of chapter 08: error against time, orders of convergence, and splits of sweeps.

Error is upwards and time to the right, both in powers of ten: down and left is better. A colour and
a marker stand for a method, a broken line for plain Python. A cross at the upper edge is a
failure; at the left end of that edge stand the methods that refused the scene.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from lesson_code.evidence.hard_cases import SWEEPS, Comparison, by_theme, family_by_name
from lesson_code.evidence.work_precision import (
    Fit,
    Point,
    WorkPrecision,
    order_of,
    scenes,
    splits,
)
from lesson_code.evidence.work_precision.methods import COMPILED, PLAIN
from lesson_code.evidence.work_precision.result import FLOOR
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.matplotlib.measured import marks, rows

LOOKS: dict[str, tuple[str, Any]] = {
    "naive": (style.GREY, "v"),
    "sequential": (style.BLUE, "o"),
    "substep": (style.SKY, "s"),
    "direct": (style.GREEN, "^"),
    "exact": (style.VERMILION, "D"),
    "pymunk": (style.ORANGE, "P"),
    "box2d": (style.PURPLE, "X"),
}
"""Colour and marker of each method."""

EDGE = 0.97
"""Of the height of the axes: there stand the failures."""

LOWER = 0.06
"""Of the height of the axes: where methods fail at the same setting, each next one's cross stands
lower by this."""

ROOM_ABOVE = 4
"""Above the largest error the axis goes on by this factor, where crosses stand over a split."""

ROOM_BELOW = 100
"""Below the least error the axis goes on by this factor: there stands what has no error but
rounding, with an arrow and its figure."""

ROUNDING_AT = 0.12
"""Of the height of the axes: there stands what has no error but rounding."""

COLUMNS = 2
"""Panels side by side in the figure of all scenes: more would make its words small in a page."""

WORDS = 10
"""Points: the size of the words that stand in and beside the axes."""


# What the notebook shows


def staircase(times: Sequence[float], errors: Sequence[float]) -> None:
    """Show how far the reader's ball is from its right place, m, over the time, s."""
    fig, ax = style.figure(width=7, height=3.2)
    plots.curves(ax, {"": (times, errors)}, "time, s", "distance from the right place, m")
    show(
        fig,
        "Distance of your ball from its right place over ten seconds: a staircase of six steps up "
        "to 0.16 m, level in between, with two short dips at steps.",
    )


def your_errors(rates: Sequence[int], errors: Sequence[float], fit: Fit) -> None:
    """Show the errors of the reader's solver, m, at some steps a second, and their order."""
    fig, ax = style.figure(width=7, height=3.2)
    named = "your solver"
    errors_over_steps(ax, [1 / rate for rate in rates], {named: errors}, {named: fit})
    show(
        fig,
        "Error of your solver over the length of the step, both axes in powers of ten. Six dots "
        "fall from 0.6 m at a thirtieth of a second to a hundredth of a metre, about a line of "
        "slope 1.",
    )


def map_of_prices(result: WorkPrecision) -> None:
    """Show error against time for the ball in the box."""
    fig, ax = style.figure(width=9, height=4.6)
    work_precision(ax, result, "ball in a box")
    legend_beside(ax, result.of("ball in a box"))
    show(
        fig,
        "Error against time for the ball in the box, both axes in powers of ten. The lines of "
        "methods that step run down to the right. Those in plain Python lie parallel to the "
        "compiled ones, further to the right. The direct solver's line lies far below them, near "
        "1e-10 m. The exact solver stands alone at the lower edge, on the left. Grey crosses at "
        "the upper edge are the naive solver's failures.",
    )


def towers(result: WorkPrecision, sweeps: int) -> None:
    """Show the error of both piles over the sub-steps that a number of sweeps is split into."""
    fig, axes = style.figure(2, width=9.5, height=3.8)
    for ax, name in zip(axes, ("stack of 20", "heavy on light"), strict=True):
        split_of_sweeps(ax, result, name, sweeps)
    axes[0].legend(frameon=False)
    show(
        fig,
        f"Error over the number of sub-steps, at {sweeps} sweeps in each step. Left, a stack of 20 "
        "boxes: for pymunk and the sequential solver the error falls all the way to the most "
        "sub-steps. For the solver with springs it rises from one sub-step on, and from 25 on the "
        "stack falls. Right, a heavy box on a light one: all fall towards many sub-steps.",
    )


def whole_map(result: WorkPrecision) -> None:
    """Show error against time for all scenes."""
    show(
        all_scenes(result),
        "Seven panels of error against time: ball in a box, drop, slide to roll, gas, pi blocks, "
        "stack of 20, heavy on light. In the first five the exact and the direct solver stand far "
        "below all others, in the last two the direct solver alone. Crosses at the upper edges "
        "mark what fell, was lost or refused.",
    )


def laws(comparison: Comparison) -> None:
    """Show what the default call takes over the time of sweeps, for each family of hard cases."""
    fig, ax = style.figure(width=9, height=5)
    prices_of_laws(ax, comparison)
    show(
        fig,
        "A row for each theme of hard cases, with a mark for each family over the time of the "
        "default call divided by that of sweeps, in powers of ten. Most marks are hollow, where "
        "sweeps break the law, and lie on both sides of 1.",
    )


# What it is made of


def all_scenes(result: WorkPrecision) -> Figure:
    """Return a figure with a panel for each scene of a result, and one legend."""
    names = result.scenes
    columns = min(COLUMNS, len(names) + 1)
    lines = math.ceil((len(names) + 1) / columns)
    drawn = Figure(figsize=(4.7 * columns, 3.9 * lines), layout="constrained", dpi=100)
    axes = drawn.subplots(lines, columns, squeeze=False).flatten().tolist()
    for ax, name in zip(axes, names, strict=False):
        work_precision(style.plain(ax), result, name)
    for ax in axes[len(names) :]:
        ax.axis("off")
    axes[len(names)].legend(
        handles=handles(result.points), loc="center", frameon=False, fontsize=WORDS
    )
    return drawn


def work_precision(ax: Axes, result: WorkPrecision, scene: str) -> Axes:
    """Draw error against time for each method in a scene, with dotted lines for fitted orders.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    result : WorkPrecision
        What was measured.
    scene : str
        Its name.

    Raises
    ------
    ValueError
        The scene was not measured.
    """
    for (method, code), points in result.lines(scene).items():
        sound = [p for p in points if not p.failure and p.error > FLOOR]
        color, marker = LOOKS[method]
        dashed = "--" if code == PLAIN else "-"
        look: dict[str, Any] = {"color": color, "marker": marker, "markersize": 5, "linewidth": 1.2}
        if scenes()[scene].swept != "dt":
            dashed = ""  # settings of which none is finer than the other make no line
            look |= {"markerfacecolor": "white"} if code == PLAIN else {}
        marks(ax, [(p.milliseconds, _error(p)) for p in sound], linestyle=dashed, **look)
        _draw_fit(ax, sound, order_of(points), color)
        _draw_failures(ax, [p for p in points if p.failure], color)
        _draw_rounding(ax, [p for p in points if not p.failure and p.error <= FLOOR])
    ax.set(xscale="log", yscale="log", xlabel="time, ms", ylabel="error, m")
    ax.set_ylim(bottom=_bottom(result.of(scene)))
    ax.margins(x=0.1)
    ax.set_title(scene, fontsize=11)
    return ax


def prices_of_laws(ax: Axes, comparison: Comparison) -> Axes:
    """Draw what the default call takes over the time of sweeps, a row for each theme.

    A full mark is a family that sweeps hold as well; at a hollow one they break the law.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    comparison : Comparison
        The families of hard cases, with our default call and sweeps.
    """
    themes = by_theme(map(family_by_name, comparison.names))
    looks = {True: ("sweeps hold it too", style.BLUE), False: ("sweeps break it", "white")}
    for holds, (label, face) in looks.items():
        points = [
            (comparison.price(family.name), row)
            for row, families in enumerate(themes.values())
            for family in families
            if comparison.result(family.name, SWEEPS).holds is holds
        ]
        look = {"markeredgecolor": style.BLUE, "markerfacecolor": face, "markersize": 6}
        marks(ax, points, marker="o", label=label, **look)
    ax.axvline(1.0, color=style.GREY, linewidth=1.2)
    rows(ax, list(themes), fontsize=WORDS)
    ax.set(xscale="log", xlabel="time of the default call over that of sweeps")
    ax.legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1.0), fontsize=WORDS)
    return ax


def _bottom(points: Iterable[Point]) -> float:
    """Return where the axis of errors ends: below all of them but what is only rounding, m."""
    least = min((p.error for p in points if p.error > FLOOR), default=1.0)
    return least / ROOM_BELOW


def split_of_sweeps(ax: Axes, result: WorkPrecision, scene: str, sweeps: int) -> Axes:
    """Draw the error of equally many sweeps in a step over the sub-steps they are split into."""
    crosses: list[int] = []
    for method, points in splits(result, scene, sweeps).items():
        color, marker = LOOKS[method]
        look: dict[str, Any]
        sound = [p for p in points if not p.failure]
        look = {"color": color, "marker": marker, "markersize": 6, "label": method}
        marks(ax, [(p.substeps, _error(p)) for p in sound], linestyle="-", **look)
        for p in points:
            if p.failure:
                _cross(ax, p.substeps, color, EDGE - LOWER * crosses.count(p.substeps))
                crosses.append(p.substeps)
    ax.plot([], [], label="fell", **_cross_look(style.INK))
    ax.set(xscale="log", yscale="log", xlabel="sub-steps in a step", ylabel="error, m")
    ax.set_ylim(top=ROOM_ABOVE * ax.get_ylim()[1])
    ax.set_title(f"{scene}: {sweeps} sweeps in each step", fontsize=11)
    return ax


def errors_over_steps(
    ax: Axes, steps: Sequence[float], errors: dict[str, Sequence[float]], fits: dict[str, Fit]
) -> Axes:
    """Draw errors over the step, s, both in powers of ten, with the line of each fitted order.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    steps : sequence of float
        s.
    errors : dict of str to sequence of float
        By what is written in the legend, one for each step.
    fits : dict of str to Fit
        By the same words; not all need one.
    """
    looks = list(LOOKS.values())[1:]
    for (label, values), (color, marker) in zip(errors.items(), looks, strict=False):
        marks(ax, zip(steps, values, strict=True), color=color, marker=marker, label=label)
        if label in fits:
            ax.plot(steps, [fits[label].at(dt) for dt in steps], color=color, linewidth=1)
    ax.set(xscale="log", yscale="log", xlabel="step, s", ylabel="error, m")
    ax.legend(frameon=False, fontsize=9)
    return ax


def legend_beside(ax: Axes, points: Iterable[Point]) -> None:
    """Put the legend of some points to the right of the axes."""
    beside: dict[str, Any] = {"loc": "center left", "bbox_to_anchor": (1.01, 0.5)}
    ax.legend(handles=handles(points), frameon=False, fontsize=WORDS, **beside)


def handles(points: Iterable[Point]) -> list[Line2D]:
    """Return what a legend outside of the axes needs: methods in their codes, and what else."""
    made = [_handle(*line) for line in dict.fromkeys(point.line for point in points)]
    cross = Line2D([], [], color=style.INK, marker="x", linestyle="", label="failed or refused")
    return [*made, Line2D([], [], color=style.INK, linestyle=":", label="fitted order"), cross]


def _handle(method: str, code: str) -> Line2D:
    """Return what stands for a line in a legend."""
    color, marker = LOOKS[method]
    label = f"{method}, compiled" if code == COMPILED else f"{method} in {code}"
    look: dict[str, Any] = {"color": color, "marker": marker, "markersize": 5}
    return Line2D([], [], linestyle="--" if code == PLAIN else "-", label=label, **look)


def _error(point: Point) -> float:
    """Return an error; what is 0 is drawn as the last digit of 1 m."""
    return max(point.error, 1e-16)


def _draw_fit(ax: Axes, points: Sequence[Point], fit: Fit | None, color: str) -> None:
    """Draw what a fitted order predicts for each point."""
    used = [p for p in points if fit is not None and fit.finest <= p.dt <= fit.coarsest]
    if fit is not None:
        predicted = [fit.at(p.dt) for p in used]
        ax.plot([p.milliseconds for p in used], predicted, color=color, linestyle=":", linewidth=1)


def _draw_failures(ax: Axes, points: Iterable[Point], color: str) -> None:
    """Draw a cross at the upper edge for each failure, at its cost if that is known."""
    for point in points:
        if math.isfinite(point.milliseconds):
            _cross(ax, point.milliseconds, color)
        else:
            ax.plot(0.03, EDGE, transform=ax.transAxes, **_cross_look(color))


def _draw_rounding(ax: Axes, points: Sequence[Point]) -> None:
    """Draw at the lower edge what has no error but rounding, with an arrow and the error.

    The error of the first method stands below its mark, that of others above theirs.
    """
    height = ROUNDING_AT + 0.05 if ax.texts else 0.03
    for point in points[:1]:
        color, marker = LOOKS[point.method]
        x, below = point.milliseconds, ax.get_xaxis_transform()
        ax.plot(
            x, ROUNDING_AT, transform=below, color=color, marker=marker, markersize=7, linestyle=""
        )
        ax.annotate(
            f"\u2193 {point.error:.0e} m",
            (x, 0.0),
            xytext=(x, height),
            xycoords=below,
            textcoords=below,
            ha="center",
            fontsize=WORDS,
            color=style.INK,
        )


def _cross(ax: Axes, x: float, color: str, height: float = EDGE) -> None:
    """Draw a cross at the upper edge, or lower, in parts of the height of the axes."""
    ax.plot(x, height, transform=ax.get_xaxis_transform(), **_cross_look(color))


def _cross_look(color: str) -> dict[str, Any]:
    """Return how a failure is drawn."""
    return {"color": color, "marker": "x", "markersize": 7, "markeredgewidth": 1.6, "linestyle": ""}
