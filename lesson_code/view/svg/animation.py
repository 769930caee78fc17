"""A run that plays in the notebook: a still picture, its motion, and a script that joins them.

What is displayed needs nothing but itself: no film, no network, no kernel. It is the still
picture (an SVG) with its text, the places of all bodies as whole tenths of a pixel, and
``animation.js``, which draws them. Where scripts do not run, the still picture stands. The same run
gives the same text on every machine, unless the last bits of a position decide how a tenth of a
pixel is rounded: about once in a thousand million numbers for errors of 1e-12 m.
"""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Mapping
from functools import cache
from html import escape
from importlib.resources import files
from typing import Any, TypeAlias

from IPython.display import display

from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.formulas.validation import one_number, positive
from lesson_code.view import framing
from lesson_code.view.framing import Around, View
from lesson_code.view.svg import scene_svg
from lesson_code.view.svg.film import Clock, Film, clock_of, fastest_speed, film_of
from lesson_code.view.svg.scene_svg import Sheet

Names: TypeAlias = bool | Mapping[int, str]

WIDTH, TALLEST = 640, 420
"""px: of all pictures together, and the height of the tallest."""

CONTROLS = 320
"""px: the least width of the line with button, slider and clock."""

LONGEST_ARROW = 0.16
"""Of the picture's larger side: how long the fastest velocity is drawn."""


def animate(
    runs: Run | Mapping[str, Run],
    alt: str,
    *,
    seconds: float | None = None,
    fps: float = 30.0,
    around: Around = None,
    names: Names = False,
    velocities: bool = False,
    contacts: bool = False,
    still: float | None = None,
) -> None:
    """Display a run that can be played, or several side by side with one clock.

    It never plays by itself. The button and the slider work with the mouse and with the keys:
    on the slider the arrow keys go from picture to picture, and the space bar plays.

    Parameters
    ----------
    runs : Run or mapping of str to Run
        What is shown; several by their titles.
    alt : str
        What can be seen in it, in a sentence or two, for readers who cannot.
    seconds : float, optional
        How long playing lasts, s, > 0. None: as long as it took.
    fps : float
        Pictures a second of playing, at most, > 0. There are never more of them than recorded
        states. Each shows the last state that is not after its time.
    around : None, "all" or (left, right, bottom, top)
        What is seen, m, as :func:`lesson_code.view.matplotlib.scene_plots.scene` takes it.
    names : bool or mapping of int to str
        True: every moving body's number on it. Or names for some of them, by number.
    velocities : bool
        Whether velocities are drawn as arrows.
    contacts : bool
        Whether contact points are drawn, for a tenth of a second of playing after each impulse.
    still : float, optional
        s: the time of the picture that stands where scripts do not run. None: the start.

    Raises
    ------
    ValueError
        There is no run, `alt` is empty, a number is out of range, or there would be more than
        3,000 pictures.
    """
    named = {"": runs} if isinstance(runs, Run) else dict(runs)
    if not named:
        raise ValueError("runs must hold at least one run, got none")
    if not alt.strip():
        raise ValueError("alt must say what the animation shows, got nothing")
    clock = clock_of([*named.values()], seconds, one_number("fps", fps, positive))
    sheet = Sheet.fitted(_view(named, around), [*named], WIDTH, TALLEST)
    fastest = fastest_speed(named.values()) if velocities else 0.0
    arrows = LONGEST_ARROW * max(sheet.picture) / fastest if fastest else 0.0
    films = [film_of(run, clock, sheet, arrows, contacts) for run in named.values()]
    frame = clock.frame_at(still)
    pictures = [
        scene_svg.picture(sheet, film.scene, film.state(frame), _names(film.scene, names))
        for film in films
    ]
    note = f"longest arrow {fastest:.3g} m/s" if fastest else ""
    motion = json.dumps(_motion(films, clock), separators=(",", ":"))
    name = f"run-{_digest(motion, *pictures, *named, note)}"
    shown = _html(name, scene_svg.drawing(sheet, pictures, note, name), motion, alt)
    words = f"Animation: {alt} (It plays in a browser.)"
    display({"text/html": shown, "text/plain": words}, raw=True)  # type: ignore[no-untyped-call]


def _view(named: Mapping[str, Run], around: Around) -> View:
    """Return the part of the world that shows all runs."""
    views = [framing.view_of(r.scene, r.positions, r.angles, around) for r in named.values()]
    view = views[0]
    for other in views[1:]:
        view = view.widened(other)
    return view


def _names(scene: Scene, names: Names) -> Mapping[int, str]:
    """Return what stands on which body."""
    if isinstance(names, bool):
        return {n: str(n) for n in range(len(scene.bodies))} if names else {}
    return names


def _motion(films: list[Film], clock: Clock) -> dict[str, Any]:
    """Return what the script needs to know, in the order of the drawing."""
    return {
        "frames": clock.frames,
        "start": clock.start,
        "duration": clock.duration,
        "decimals": clock.decimals,
        "seconds": clock.seconds,
        "bodies": [path for film in films for path in film.paths()],
        "contacts": [film.contacts for film in films],
    }


def _digest(*parts: str) -> str:
    """Return a name for some texts that others do not have."""
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:12]


def _html(name: str, drawing: str, motion: str, alt: str) -> str:
    """Return the still picture with its text, and the script that brings it to life."""
    picture = base64.b64encode(drawing.encode("ascii", "xmlcharrefreplace")).decode()
    return (
        f'<figure data-animation="{name}" style="display:inline-block;margin:0;padding:8px;'
        "max-width:100%;box-sizing:border-box;background:#fff;color:#222;color-scheme:light;"
        f'font:13px sans-serif">'
        f'<img alt="{escape(alt)}" style="display:block;max-width:100%" '
        f'src="data:image/svg+xml;base64,{picture}">\n'
        f'<script>\n({_script()})("{name}", {CONTROLS},\n{motion});\n</script></figure>'
    )


@cache
def _script() -> str:
    """Return the script, without its comments."""
    lines = files("lesson_code.view.svg").joinpath("animation.js").read_text("utf-8").splitlines()
    return "\n".join(line for line in lines if line.strip() and not line.strip().startswith("//"))
