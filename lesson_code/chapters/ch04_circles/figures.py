"""The figures of chapter 04: two discs that touch, and rows of them.

The first disc of a pair is plain, the second hatched: a cue beside colour.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle

from lesson_code.engine.core.run import Run
from lesson_code.geometry import Manifold
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, scene_plots, style
from lesson_code.view.matplotlib.plots import Point

DISC_STYLES = ((style.FIRST, ""), (style.SECOND, "///"))
"""Colour and hatch of the first and the second disc of a pair."""

BAR_STYLES = ((style.BLUE, ""), (style.ORANGE, "///"), (style.GREEN, "..."))
"""Colour and hatch of the first, second and third group of bars."""


def two_discs(
    ax: Axes,
    p1: Point,
    r1: float,
    p2: Point,
    r2: float,
    *,
    outline: bool = False,
    arrows: Sequence[Sequence[Point]] = ((), ()),
) -> Axes:
    """Draw two discs with their centres and numbers, or dotted outlines of where they were.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    p1, p2 : sequence of 2 floats
        Centres, m.
    r1, r2 : float
        Radii, m.
    outline : bool
        Whether to draw dotted outlines only.
    arrows : two sequences of vectors
        For each disc, where arrows will leave its centre: its number keeps clear of them.
    """
    line = np.subtract(p2, p1)
    for number, (p, r, (color, hatch), taken) in enumerate(
        zip((p1, p2), (r1, r2), DISC_STYLES, arrows, strict=True), start=1
    ):
        centre = (float(p[0]), float(p[1]))
        if outline:
            ax.add_patch(Circle(centre, r, fill=False, edgecolor=color, linestyle=":"))
            continue
        ax.add_patch(Circle(centre, r, facecolor=color, alpha=0.25, hatch=hatch, edgecolor=color))
        ax.add_patch(Circle(centre, r, fill=False, edgecolor=color, linewidth=1.5))
        ax.plot(*centre, marker="o", color=color, markersize=4)
        place = np.array(centre) + 0.65 * r * _free_direction([line, -line, *taken])
        _name(ax, place, str(number), color)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.set(xlabel="x, m", ylabel="y, m")
    return ax


def overlap(
    ax: Axes, p1: Point, r1: float, p2: Point, r2: float, normal: Point, depth: float
) -> Axes:
    """Draw two overlapping discs with the normal n, and the depth as a thick line between rims.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    p1, p2 : sequence of 2 floats
        Centres, m.
    r1, r2 : float
        Radii, m.
    normal : sequence of 2 floats
        Unit normal from disc 1 to disc 2; it is drawn 1 m long, from the first centre.
    depth : float
        Of the overlap, m.
    """
    two_discs(ax, p1, r1, p2, r2)
    n = np.asarray(normal, dtype=float)
    rim = np.asarray(p1, dtype=float) + r1 * n
    ax.plot(*zip(p1, p2, strict=True), color=style.INK, linewidth=0.8, linestyle="--")
    ax.plot(*zip(rim, rim - depth * n, strict=True), color=style.INK, linewidth=4)
    aside = np.array([-n[1], n[0]])
    plots.arrow(ax, p1, n, "n", style.INK, beside=tuple(12 * aside))
    _name(ax, rim - depth / 2 * n, "depth", style.INK, tuple(-30 * aside))
    return ax


def hit(
    ax: Axes,
    normal: Point,
    radii: Point,
    before: Sequence[Point],
    after: Sequence[Point],
    *,
    seconds: float = 0.5,
) -> Axes:
    """Draw two touching discs, how each came (dashed) and how each leaves.

    Parameters
    ----------
    ax : Axes
        Where to draw; the discs touch at the origin.
    normal : sequence of 2 floats
        Unit normal from disc 1 to disc 2.
    radii : (float, float)
        m.
    before, after : sequence of two vectors
        The velocities of both discs, m/s.
    seconds : float
        Length of an arrow: the way made in this time, s.
    """
    n = np.asarray(normal, dtype=float)
    centres = (-radii[0] * n, radii[1] * n)
    ways = [[-np.asarray(v), np.asarray(w)] for v, w in zip(before, after, strict=True)]
    two_discs(ax, centres[0], radii[0], centres[1], radii[1], arrows=ways)
    across = 1.3 * max(radii) * np.array([-n[1], n[0]])
    ax.plot(*zip(-across, across, strict=True), color=style.GREY, linewidth=0.8)
    for centre, v, w, (color, _) in zip(centres, before, after, DISC_STYLES, strict=True):
        way, way_after = seconds * np.asarray(v), seconds * np.asarray(w)
        plots.arrow(ax, centre - way, way, "", color, dashed=True)
        plots.arrow(ax, centre, way_after, "", color)
        ax.update_datalim([centre - way, centre + way_after])
    ax.autoscale_view()
    _legend_of_times(ax)
    return ax


def rows_of_bars(
    ax: Axes, named: Mapping[str, Sequence[float]], labels: Sequence[str], ylabel: str
) -> Axes:
    """Draw one number for each body of a row, for up to three cases side by side.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    named : mapping of str to sequence of float
        The cases by name, each with a number for each body.
    labels : sequence of str
        The bodies.
    ylabel : str
        What the numbers are, with the unit.

    Raises
    ------
    ValueError
        There are more than three cases.
    """
    if len(named) > len(BAR_STYLES):
        raise ValueError(f"named must hold at most {len(BAR_STYLES)} cases, got {len(named)}")
    width = 0.8 / len(named)
    for case, ((name, values), (color, hatch)) in enumerate(
        zip(named.items(), BAR_STYLES, strict=False)
    ):
        places = np.arange(len(labels)) + (case - (len(named) - 1) / 2) * width
        ax.bar(places, values, width, label=name, color=color, hatch=hatch, edgecolor="white")
    ax.axhline(0, color=style.INK, linewidth=0.8)
    ax.set_xticks(range(len(labels)), labels)
    ax.set_ylabel(ylabel)
    ax.legend(frameon=False, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=len(named))
    return ax


def grazing_hits(normal: Any, before: Any, answers: Mapping[str, Any]) -> None:
    """Show a grazing hit as two formulas answer it."""
    fig, axes = style.figure(2, width=10, height=4)
    for ax, (title, after) in zip(axes, answers.items(), strict=True):
        hit(ax, normal, (0.5, 0.5), before, after)
        ax.set(xlim=(-2.2, 2.2), ylim=(-1.5, 1.5))
        ax.set_title(title, y=1.1)
    show(
        fig,
        "A grazing hit. Along the normal, ball 1 goes on nearly as before and ball 2 moves off "
        "slowly, downward. With x and y apart, ball 1 stops dead and ball 2 takes over all of it.",
    )


def moved_apart(discs: tuple[Any, float, Any, float], ways: Mapping[str, Any]) -> None:
    """Show two overlapping discs, and where two rules put them."""
    p1, r1, p2, r2 = discs
    fig, axes = style.figure(2, width=10, height=3.8)
    for ax, (title, (q1, q2)) in zip(axes, ways.items(), strict=True):
        two_discs(ax, p1, r1, p2, r2, outline=True)
        two_discs(ax, q1, r1, q2, r2)
        ax.set(title=title, xlim=(-1.1, 2.3), ylim=(-1.1, 1.1))
    show(
        fig,
        "A disc of 1 kg overlaps one of 9 kg; dotted outlines show where they were. By mass, the "
        "light disc moves nearly all of the way. Half each, the heavy disc is pushed as far as it.",
    )


def overlapping(p1: Point, r1: float, p2: Point, r2: float, contact: Manifold) -> None:
    """Show two overlapping discs, with the normal and the depth of their contact."""
    fig, ax = style.figure(width=5.4, height=5)
    overlap(ax, p1, r1, p2, r2, contact.normal, contact.penetrations[0])
    show(
        fig,
        "Two overlapping discs. The normal n points from the centre of disc 1 towards the centre "
        "of disc 2. The depth is the distance between the two rims on the line of the centres.",
    )


def two_on_their_way(run: Run) -> None:
    """Show the two discs of an oblique hit at four times, and their ways."""
    fig, ax = style.figure(width=7, height=3.8)
    scene_plots.ghosts(ax, run, (0.0, 0.5, 1.0, 1.5))
    scene_plots.trails(ax, run)
    show(
        fig,
        "Two discs at four times, earlier ones fainter. They meet obliquely; the small one is "
        "thrown back and upward, the large one goes on slowly and downward.",
    )


def sideways_speeds(speeds: Mapping[str, Sequence[float]]) -> None:
    """Show a cue ball's sideways speed over the number of iterations, 1, 2 ..., by solver."""
    fig, ax = style.figure(width=7, height=3.2)
    named = {name: (range(1, len(values) + 1), values) for name, values in speeds.items()}
    plots.curves(ax, named, "iterations", "cue ball's sideways speed, m/s")
    ax.set_yscale("log")
    show(
        fig,
        "The sideways speed of the cue ball, which should be zero, over the number of iterations, "
        "on a logarithmic scale. It falls along a straight line, alike for our engine and pymunk.",
    )


def row_of_five(last: Mapping[str, Sequence[float]]) -> None:
    """Show the velocities of five discs in a row after the hit."""
    fig, ax = style.figure(width=7, height=3.4)
    rows_of_bars(ax, last, [f"disc {k}" for k in range(1, 6)], "velocity after, m/s")
    show(
        fig,
        "Velocities of five discs after the hit. With a gap, the last disc alone moves, at 1 m/s. "
        "With an overlap, the first comes back at 0.6 m/s and the four others move at 0.4 m/s.",
    )


def _free_direction(taken: Sequence[Any]) -> Any:
    """Return the unit vector that is farthest from all directions that are taken, upwards first."""
    angles = math.pi / 2 + np.arange(24) * math.pi / 12
    directions = np.stack((np.cos(angles), np.sin(angles)), axis=-1)
    others = [v / np.hypot(*v) for v in taken if np.hypot(*v) > 0]
    nearness = [max((float(d @ other) for other in others), default=-1.0) for d in directions]
    return directions[int(np.argmin(np.round(nearness, 9)))]


def _name(
    ax: Axes, place: Point, text: str, color: str, beside: tuple[float, float] = (0.0, 0.0)
) -> None:
    """Write a name at a place, or some points beside it."""
    ax.annotate(
        text,
        (float(place[0]), float(place[1])),
        xytext=beside,
        textcoords="offset points",
        color=color,
        fontsize=11,
        fontweight="bold",
        ha="center",
        va="center",
    )


def _legend_of_times(ax: Axes) -> None:
    """Say that dashed arrows are velocities before, and solid ones after."""
    ax.legend(
        handles=[
            Line2D([], [], color=style.INK, linestyle="--", label="before"),
            Line2D([], [], color=style.INK, label="after"),
        ],
        loc="lower center",
        bbox_to_anchor=(0.5, 1.0),
        ncols=2,
        frameon=False,
    )
