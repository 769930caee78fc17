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
from lesson_code.view.matplotlib import style
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

ROOM_BELOW = 100
"""Below the least error the axis goes on by this factor: there stands what has no error but
rounding, each with an arrow and its figure."""

ROUNDING_AT = 0.12
"""Of the height of the axes: there stands what has no error but rounding."""

COLUMNS = 4
"""Panels side by side in the figure of all scenes."""


def all_scenes(result: WorkPrecision) -> Figure:
    """Return a figure with a panel for each scene of a result, and one legend."""
    names = result.scenes
    columns = min(COLUMNS, len(names) + 1)
    lines = math.ceil((len(names) + 1) / columns)
    drawn = Figure(figsize=(3.5 * columns, 3.3 * lines), layout="constrained", dpi=100)
    axes = drawn.subplots(lines, columns, squeeze=False).flatten().tolist()
    for ax, name in zip(axes, names, strict=False):
        work_precision(style.plain(ax), result, name)
    for ax in axes[len(names) :]:
        ax.axis("off")
    axes[len(names)].legend(handles=handles(result.points), loc="center", frameon=False, fontsize=9)
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
    ax.margins(x=0.15)  # room for the figures at the lower edge
    ax.set(xscale="log", yscale="log", xlabel="time, ms", ylabel="error, m")
    ax.set_ylim(bottom=_bottom(result.of(scene)))
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
    rows(ax, list(themes), fontsize=9)
    ax.set(xscale="log", xlabel="time of the default call over that of sweeps")
    ax.legend(frameon=False, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1.0), fontsize=9)
    return ax


def _bottom(points: Iterable[Point]) -> float:
    """Return where the axis of errors ends: below all of them but what is only rounding, m."""
    least = min((p.error for p in points if p.error > FLOOR), default=1.0)
    return least / ROOM_BELOW


def split_of_sweeps(ax: Axes, result: WorkPrecision, scene: str, sweeps: int) -> Axes:
    """Draw the error of equally many sweeps in a step over the sub-steps they are split into."""
    for method, points in splits(result, scene, sweeps).items():
        color, marker = LOOKS[method]
        look: dict[str, Any]
        sound = [p for p in points if not p.failure]
        look = {"color": color, "marker": marker, "markersize": 6, "label": method}
        marks(ax, [(p.substeps, _error(p)) for p in sound], linestyle="-", **look)
        for p in points:
            if p.failure:
                _cross(ax, p.substeps, color)
    ax.set(xscale="log", yscale="log", xlabel="sub-steps in a step", ylabel="error, m")
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
    ax.legend(handles=handles(points), frameon=False, fontsize=9, **beside)


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
        cost = point.milliseconds
        if math.isfinite(cost) and cost > 0:
            _cross(ax, cost, color)
        else:
            ax.plot(0.03, EDGE, transform=ax.transAxes, **_cross_look(color))


def _draw_rounding(ax: Axes, points: Sequence[Point]) -> None:
    """Draw at the lower edge what has no error but rounding, with an arrow and the error."""
    for point in points[:1]:
        color, marker = LOOKS[point.method]
        x, below = point.milliseconds, ax.get_xaxis_transform()
        ax.plot(
            x, ROUNDING_AT, transform=below, color=color, marker=marker, markersize=7, linestyle=""
        )
        ax.annotate(
            f"\u2193 {point.error:.0e} m",
            (x, 0.0),
            xytext=(x, 0.03),
            xycoords=below,
            textcoords=below,
            ha="center",
            fontsize=9,
            color=style.INK,
        )


def _cross(ax: Axes, x: float, color: str) -> None:
    """Draw a cross at the upper edge."""
    ax.plot(x, EDGE, transform=ax.get_xaxis_transform(), **_cross_look(color))


def _cross_look(color: str) -> dict[str, Any]:
    """Return how a failure is drawn."""
    return {"color": color, "marker": "x", "markersize": 7, "markeredgewidth": 1.6, "linestyle": ""}
