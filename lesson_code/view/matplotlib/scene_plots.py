"""Pictures of a scene: its bodies, and where they have been.

Start with :func:`scene` or :func:`ghosts`: they choose which part of the world is seen, and the
others draw into that. A time is the time of a run, s; the state drawn is the recorded one that is
nearest to it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.view import framing
from lesson_code.view.framing import Around
from lesson_code.view.matplotlib.body_patches import draw_moving, draw_static, write_names
from lesson_code.view.states import frame_at, poses, scene_of

Floats: TypeAlias = NDArray[np.float64]
Names: TypeAlias = bool | Mapping[int, str]


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
    >>> from lesson_code.view.matplotlib import style
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
    """Draw the paths of the bodies' centres, each with a dot where it started.

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


def _chosen(bodies: Iterable[int], of: Scene) -> list[int]:
    """Return the numbers of the bodies that are wanted."""
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
