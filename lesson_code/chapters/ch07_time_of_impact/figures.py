"""The figures of chapter 07: steps that jump over a wall, times of impact, and ways unfolded."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Patch, Rectangle

from lesson_code.formulas.arithmetic import dot
from lesson_code.geometry.straight_impact_times import straight_impact_time
from lesson_code.view.matplotlib import plots, style
from lesson_code.view.matplotlib.plots import Point

LONGEST_CURVE = 400
"""Points of a curve that is drawn: more cannot be told apart."""


# Two circles


def seen_from_the_first(
    ax: Axes, d: Point, v: Point, reach: float, dt: float, samples: int
) -> Axes:
    """Draw the way of a second circle as the first one sees it: a line that meets a circle.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    d, v : sequence of 2 floats
        Place and velocity of the second centre, seen from the first, m and m/s.
    reach : float
        Sum of the radii, m.
    dt : float
        The step, s.
    samples : int
        In how many parts the step is cut; a dot stands at every end.
    """
    d, v = np.asarray(d, dtype=float), np.asarray(v, dtype=float)
    ax.add_patch(_disc((0, 0), reach, style.GREY, ""))
    ax.plot(0, 0, marker="+", color=style.GREY, markersize=8)
    ends = np.array([d, d + v * dt])
    ax.plot(*ends.T, color=style.BLUE, linewidth=1.5)
    dots = d + v * (dt * np.arange(samples + 1) / samples)[:, np.newaxis]
    ax.plot(*dots.T, linestyle="", marker="o", color=style.BLUE, markersize=5)
    for t, marker in zip(_touches(d, v, reach), ("D", "s"), strict=False):
        ax.plot(*(d + v * t), **_mark(style.VERMILION, marker))
    ax.set(xlabel="x, seen from circle 1, m", ylabel="y, m", aspect="equal")
    return ax


def distance_in_time(ax: Axes, d: Point, v: Point, reach: float, dt: float, samples: int) -> Axes:
    """Draw how the distance of two centres changes during a step, with what samples see of it.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    d, v, reach, dt, samples
        As :func:`seen_from_the_first` takes them.
    """
    d, v = np.asarray(d, dtype=float), np.asarray(v, dtype=float)
    times, looks = np.linspace(0, dt, LONGEST_CURVE), dt * np.arange(samples + 1) / samples
    ax.axhspan(0, reach, color=style.GREY, alpha=0.2, linewidth=0)
    for t, line, marker in ((times, "-", ""), (looks, "", "o")):
        distance = np.hypot(*(d[:, np.newaxis] + np.outer(v, t)))
        ax.plot(t, distance, color=style.BLUE, linestyle=line, marker=marker, markersize=5)
    handles: list[Any] = [Line2D([], [], label="samples", **_mark(style.BLUE, "o"))]
    names = (("first touch", "D"), ("last touch", "s"))
    for touch, (name, marker) in zip(_touches(d, v, reach), names, strict=False):
        ax.plot(touch, reach, **_mark(style.VERMILION, marker))
        handles.append(Line2D([], [], label=name, **_mark(style.VERMILION, marker)))
    handles.append(Patch(color=style.GREY, alpha=0.2, label="overlap"))
    ax.set(xlabel="time, s", ylabel="distance of the centres, m")
    ax.set_ylim(0, None)
    ax.legend(handles=handles, frameon=False)
    return ax


def _touches(d: Any, v: Any, reach: float) -> list[float]:
    """Return when two circles touch first and last, s; nothing if they never do."""
    first = straight_impact_time(float(d[0]), float(d[1]), float(v[0]), float(v[1]), reach)
    if math.isinf(first):
        return []
    middle = -float(dot(d, v)) / float(dot(v, v))
    return [first, 2 * middle - first]


# Ways unfolded


def unfolded_box(ax: Axes, start: Point, velocity: Point, room: Point, time: float) -> Axes:
    """Draw the way of a point in a box, folded in the box and straight through its mirror images.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    start, velocity : sequence of 2 floats
        m and m/s; both velocities > 0.
    room : (float, float)
        Width and height of what the point can reach, from the origin, m.
    time : float
        s.
    """
    x, v, size = (np.asarray(a, dtype=float) for a in (start, velocity, room))
    end = x + v * time
    across, up = (int(n) + 1 for n in end // size)
    for column in range(across):
        for row in range(up):
            corner = (column * size[0], row * size[1])
            edge = style.INK if (column, row) == (0, 0) else style.GREY
            ax.add_patch(Rectangle(corner, *size, fill=False, edgecolor=edge, linewidth=1.2))
    ax.plot(*zip(x, end, strict=True), color=style.VERMILION, linestyle="--", label="unfolded")
    crossings = [(k * size[n] - x[n]) / v[n] for n in (0, 1) for k in range(1, (across, up)[n])]
    folded = [_folded(x + v * t, size) for t in sorted([0.0, *crossings, time])]
    ax.plot(*zip(*folded, strict=True), color=style.BLUE, label="in the box")
    ax.plot(*folded[-1], marker="o", color=style.BLUE)
    ax.plot(*end, marker="o", color=style.VERMILION)
    ax.set(xlabel="x, m", ylabel="y, m", aspect="equal")
    ax.legend(frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2)
    return ax


def _folded(point: Any, size: Any) -> Any:
    """Return where a point in the mirror images of a box is in the box itself."""
    image = np.mod(point, 2 * size)
    return np.where(image > size, 2 * size - image, image)


def unfolded_wedge(ax: Axes, mass_ratio: float) -> Axes:
    """Draw two blocks and a wall as one point in a wedge, unfolded: a line that crosses rays.

    Each ray is a collision: full ones the blocks', dotted ones the wall's.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    mass_ratio : float
        Mass of the block that comes, over that of the other, > 0.
    """
    theta = math.atan(1 / math.sqrt(mass_ratio))
    count, height = math.ceil(math.pi / theta) - 1, 1.3 * math.tan(theta)
    for k in range(count + 1):
        along = 1.9 * np.array([math.cos(k * theta), math.sin(k * theta)])
        line, color = ("-", style.INK) if k % 2 else (":", style.GREY)
        ax.plot(*zip((0, 0), along, strict=True), linestyle=line, color=color, linewidth=1)
    plots.arrow(ax, (1.9, height), (-3.8, 0), "", style.BLUE)
    for k in range(1, count + 1):
        place = (height / math.tan(k * theta), height)
        ax.plot(*place, zorder=5, **_mark(style.VERMILION, "o"))
        label = ax.annotate(str(k), place, xytext=(0, 7), textcoords="offset points", ha="center")
        label.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 1})  # over the rays
    ax.set(xlim=(-1.95, 1.95), ylim=(-0.05, 1.4), aspect="equal")
    ax.axis("off")
    _legend(
        ax,
        Line2D([], [], color=style.INK, label="the blocks meet"),
        Line2D([], [], color=style.GREY, linestyle=":", label="the inner one meets the wall"),
        Line2D([], [], color=style.BLUE, linewidth=2, label="the way"),
    )
    return ax


# Parts


def _disc(centre: tuple[float, float], radius: float, color: str, hatch: str) -> Circle:
    """Return a disc with a rim of its colour and a pale inside."""
    return Circle(centre, radius, facecolor=color, edgecolor=color, hatch=hatch, alpha=0.35)


def _mark(color: str, marker: str) -> dict[str, Any]:
    """Return how a single point is drawn."""
    return {"color": color, "marker": marker, "linestyle": "", "markersize": 6}


def _legend(ax: Axes, *handles: Any) -> None:
    """Put a legend below the axes."""
    ax.legend(
        handles=[*handles],
        loc="upper center",
        bbox_to_anchor=(0.5, -0.05 if not ax.axison else -0.28),
        ncols=len(handles),
        frameon=False,
        fontsize=9,
    )
