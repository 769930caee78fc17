"""Pictures of a scene: its bodies, their velocities, where they touch, and where they have been.

Start with :func:`scene` or :func:`ghosts`: they choose which part of the world is seen, and the
others draw into that. A time is the time of a run, s; the state drawn is the recorded one that is
nearest to it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.transforms import ScaledTranslation
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.view import framing
from lesson_code.view.framing import Around, View
from lesson_code.view.matplotlib import style
from lesson_code.view.matplotlib.body_patches import draw_moving, draw_static, view_in, write_names
from lesson_code.view.states import events_of_step, frame_at, poses, scene_of, velocities_of

Floats: TypeAlias = NDArray[np.float64]
Names: TypeAlias = bool | Mapping[int, str]

LONGEST_ARROW = 0.16
"""Of the view's larger side: how long the longest arrow is drawn."""

NORMAL_LENGTH = 0.06
"""Of the view's larger side: how long a unit normal is drawn."""

LABELS_BELOW = 31
"""Points below the axes where the legend begins: the numbers and the name of x stand above it."""

TWO_COLUMNS = 4.0
"""Inches: wider axes have room for a legend of two columns."""

POINT: dict[str, Any] = {
    "color": style.INK,
    "markersize": 4.5,
    "markeredgecolor": "white",
    "markeredgewidth": 0.8,
    "zorder": 7,
}
"""How a contact point is drawn."""


def scene(
    ax: Axes,
    drawn: Scene | Run,
    time: float | None = None,
    *,
    around: Around = None,
    names: Names = False,
    colors: Mapping[int, str] | None = None,
) -> Axes:
    """Draw the bodies of a scene, or those of a run at some time.

    Bodies that can be pushed are in colour, circles with a spoke that turns with them. Static
    ones are grey and hatched.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    drawn : Scene or Run
        Of a scene, what it starts with.
    time : float, optional
        s. None: the last state of a run.
    around : None, "all" or (left, right, bottom, top)
        What is seen. None: all places where the run's moving bodies come to be, and of the
        static ones what leaves the others large enough to see. "all": every body, whole.
        Otherwise the edges of the view, m.
    names : bool or mapping of int to str
        True: every body's number in its middle. Or names for some of the bodies, by number. A
        name is left out where it would be too small to read, or would run into another one.
    colors : mapping of int to str, optional
        Colours for some of the bodies, by number.

    Raises
    ------
    ValueError
        The run has no such time, there is no such body, or `around` is out of order.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene, Segment
    >>> ball = Body(Circle(1.0), position=(0, 1), mass=1.0)
    >>> _, ax = style.figure()
    >>> ax = scene(ax, Scene([ball, Body(Segment((-3, 0), (3, 0)))]))
    >>> len(ax.patches), ax.get_xlabel()
    (1, 'x, m')
    """
    bodies = scene_of(drawn)
    _require_bodies("names", () if isinstance(names, bool) else names, bodies)
    _require_bodies("colors", colors or (), bodies)
    positions, angles = poses(drawn)
    view = framing.view_of(bodies, positions, angles, around)
    ax.set(xlim=(view.left, view.right), ylim=(view.bottom, view.top))
    ax.set(xlabel="x, m", ylabel="y, m", aspect="equal", anchor="S")
    frame = frame_at(drawn, time)
    chosen = _colors(bodies, colors)
    draw_static(ax, bodies, positions[frame], angles[frame], chosen)
    draw_moving(ax, bodies, positions[frame], angles[frame], chosen)
    if names:
        numbers = {n: str(n) for n in range(len(bodies.bodies))}
        wanted = numbers if isinstance(names, bool) else names
        write_names(ax, bodies, positions[frame], angles[frame], wanted)
    return ax


def velocities(
    ax: Axes,
    drawn: Scene | Run,
    time: float | None = None,
    *,
    bodies: Iterable[int] | None = None,
    scale: float | None = None,
    color: str = style.GREEN,
    label: str = "velocity",
) -> Axes:
    """Draw the bodies' velocities as arrows from their centres, all to one scale.

    Parameters
    ----------
    ax : Axes
        Where :func:`scene` has drawn.
    drawn : Scene or Run
        Of a scene, what it starts with.
    time : float, optional
        s. None: the last state of a run.
    bodies : iterable of int, optional
        Whose velocities. None: those of all bodies.
    scale : float, optional
        m that are drawn for 1 m/s; give it where figures are to be compared. None: the longest
        arrow gets a sixth of the view.
    color, label : str
        Of the arrows, and what the legend calls them.

    Raises
    ------
    ValueError
        The run has no such time, there is no such body, or `scale` is not > 0.
    """
    chosen = _chosen(bodies, scene_of(drawn))
    frame = frame_at(drawn, time)
    positions = poses(drawn)[0][frame][chosen]
    vectors = velocities_of(drawn)[frame][chosen]
    longest = _longest(vectors)
    _arrows(ax, positions, vectors, _scale(ax, scale, longest), color, filled=True)
    _key(ax, f"{label}, longest {longest:.3g} m/s", color)
    return ax


def contacts(
    ax: Axes,
    run: Run,
    time: float | None = None,
    *,
    normals: bool = True,
    scale: float | None = None,
) -> Axes:
    """Draw where bodies touch, the normals, and the impulses of the step that ends at a time.

    The arrows are the impulses on body b of each pair; body a receives the opposite. A full
    arrow is a normal impulse, a hollow one a tangent impulse.

    Parameters
    ----------
    ax : Axes
        Where :func:`scene` has drawn.
    run : Run
        Its impulses are drawn: those after the state before, and of several steps the last.
    time : float, optional
        s. None: the last state of the run.
    normals : bool
        Whether the unit normals from a to b are drawn, as thin grey lines.
    scale : float, optional
        m that are drawn for 1 N s. None: the longest arrow gets a sixth of the view.

    Raises
    ------
    ValueError
        The run has no such time, or `scale` is not > 0.
    """
    events = events_of_step(run, frame_at(run, time))
    if len(events) == 0:
        return _legend(ax, Line2D([], [], linestyle="", label="no contact"))
    points, n = run.contacts.point[events], run.contacts.normal[events]
    along = n * run.contacts.normal_impulse[events, None]
    across = np.stack((-n[:, 1], n[:, 0]), axis=-1) * run.contacts.tangent_impulse[events, None]
    longest, sideways = _longest(along), _longest(across)
    length = _scale(ax, scale, max(longest, sideways))
    if normals:
        ends = points + NORMAL_LENGTH * _side(ax) * n
        lines = [*np.stack((points, ends), axis=1)]
        thin: dict[str, Any] = {"colors": style.GREY, "linewidths": 1, "zorder": 5}
        ax.add_collection(LineCollection(lines, **thin), autolim=False)
        _legend(ax, Line2D([], [], color=style.GREY, linewidth=1, label="unit normal"))
    _arrows(ax, points, along, length, style.INK, filled=True)
    _arrows(ax, points, across, length, style.INK, filled=False)
    x, y = points.T
    _legend(ax, Line2D(x, y, linestyle="", marker="o", label="contact point", **POINT))
    _key(ax, f"normal impulse, largest {longest:.3g} N s", style.INK)
    if sideways:
        _key(ax, f"tangent impulse, largest {sideways:.3g} N s", style.INK, filled=False)
    return ax


def ghosts(
    ax: Axes,
    run: Run,
    times: Sequence[float],
    *,
    around: Around = None,
    colors: Mapping[int, str] | None = None,
) -> Axes:
    """Draw the bodies of a run at several times over each other, earlier ones fainter.

    Parameters
    ----------
    ax : Axes
        Where to draw.
    run : Run
        What is drawn.
    times : sequence of float
        s, at least one.
    around, colors
        As :func:`scene` takes them.

    Raises
    ------
    ValueError
        There are no times, or the run has no such time.
    """
    if len(times) == 0:
        raise ValueError("times must hold at least one time, got none")
    frames = sorted(frame_at(run, time) for time in times)
    scene(ax, run, times[int(np.argmax(times))], around=around, colors=colors)
    chosen = _colors(run.scene, colors)
    for place, frame in enumerate(frames[:-1], start=1):
        faint = 0.15 + 0.55 * place / len(frames)
        draw_moving(ax, run.scene, run.positions[frame], run.angles[frame], chosen, faint)
    return ax


def trails(
    ax: Axes,
    run: Run,
    *,
    bodies: Iterable[int] | None = None,
    until: float | None = None,
    colors: Mapping[int, str] | None = None,
) -> Axes:
    """Draw the ways of the bodies' centres, each with a dot where it started.

    Parameters
    ----------
    ax : Axes
        Where :func:`scene` or :func:`ghosts` has drawn.
    run : Run
        What is drawn.
    bodies : iterable of int, optional
        Whose ways. None: those of all that can be pushed.
    until : float, optional
        s, when the ways end. None: at the end of the run.
    colors : mapping of int to str, optional
        Colours for some of the bodies, by number.

    Raises
    ------
    ValueError
        The run has no such time, or there is no such body.
    """
    free = [n for n, body in enumerate(run.scene.bodies) if not body.is_static]
    chosen = _colors(run.scene, colors)
    last = frame_at(run, until)
    for n in free if bodies is None else _chosen(bodies, run.scene):
        x, y = run.positions[: last + 1, n].T
        look: dict[str, Any] = {"color": chosen[n], "linewidth": 1.2, "zorder": 4}
        ax.add_line(Line2D(x, y, **look))
        ax.add_line(Line2D(x[:1], y[:1], marker="o", markersize=4, **look))
    return ax


# Arguments


def _chosen(bodies: Iterable[int] | None, of: Scene) -> list[int]:
    """Return the numbers of the bodies that are wanted."""
    if bodies is None:
        return [*range(len(of.bodies))]
    chosen = [*bodies]
    _require_bodies("bodies", chosen, of)
    return chosen


def _require_bodies(name: str, numbers: Iterable[int], of: Scene) -> None:
    """Refuse numbers that no body has."""
    for number in numbers:
        if not 0 <= number < len(of.bodies):
            raise ValueError(
                f"{name} must hold numbers of the {len(of.bodies)} bodies, got {number}"
            )


def _colors(of: Scene, wanted: Mapping[int, str] | None) -> list[str]:
    """Return the colour of each body."""
    return [(wanted or {}).get(n, color) for n, color in enumerate(framing.body_colors(of))]


# Arrows


def _arrows(
    ax: Axes, tails: Floats, vectors: Floats, scale: float, color: str, *, filled: bool
) -> None:
    """Draw vectors as arrows, those of no length left out."""
    tips = tails + scale * vectors
    shown = np.hypot(*(tips - tails).T) > 1e-3 * _side(ax)
    shown &= np.array([view_in(ax).holds(View(x, x, y, y)) for x, y in tails], dtype=bool)
    if not shown.any():
        return
    _make_room(ax, tips[shown])
    ax.quiver(
        *tails[shown].T,
        *(tips - tails)[shown].T,
        angles="xy",
        scale_units="xy",
        scale=1,
        units="inches",
        width=0.025 if filled else 0.035,
        headwidth=4.5 if filled else 3.2,
        headlength=5.5 if filled else 4,
        headaxislength=5 if filled else 3.6,
        facecolor=color if filled else "white",
        edgecolor="white" if filled else color,
        linewidth=0.7 if filled else 0.9,
        zorder=6,
    )


def _key(ax: Axes, words: str, color: str, *, filled: bool = True) -> None:
    """Say in the legend what arrows mean, and how much the longest is."""
    face = color if filled else "white"
    look: dict[str, Any] = {"marker": ">", "markersize": 6, "markerfacecolor": face}
    _legend(ax, Line2D([], [], color=color, linewidth=1.6, label=words, **look))


def _legend(ax: Axes, line: Line2D) -> Axes:
    """Add a line to some axes and to the legend below them."""
    ax.add_line(line)
    inch = ax.figure.dpi_scale_trans
    ax.legend(
        loc="upper center",
        bbox_to_anchor=(0.5, 0.0),
        bbox_transform=ax.transAxes + ScaledTranslation(0, -LABELS_BELOW / 72, inch),
        frameon=False,
        fontsize=9,
        ncols=2 if ax.get_window_extent().width > TWO_COLUMNS * ax.figure.dpi else 1,
    )
    return ax


def _longest(vectors: Floats) -> float:
    """Return the length of the longest vector, 0 if there is none."""
    return float(np.hypot(*vectors.T).max(initial=0.0))


def _scale(ax: Axes, scale: float | None, longest: float) -> float:
    """Return the m that are drawn for a unit: those asked for, or so that the longest fits."""
    if scale is None:
        return LONGEST_ARROW * _side(ax) / longest if longest else 1.0
    if not scale > 0:
        raise ValueError(f"scale must be > 0 m for a unit, got {scale}")
    return scale


def _make_room(ax: Axes, tips: Floats) -> None:
    """Let the axes show some points too."""
    view = view_in(ax)
    for x, y in tips:
        view = view.widened(View(x, x, y, y))
    ax.set(xlim=(view.left, view.right), ylim=(view.bottom, view.top))


def _side(ax: Axes) -> float:
    """Return the larger side of what is seen, m."""
    return view_in(ax).side
