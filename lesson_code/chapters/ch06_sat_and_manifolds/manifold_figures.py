"""Figures of the contact manifold: the edges that meet, the clipping, the points, the ways out."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle as CirclePatch

from lesson_code.engine.core.scene import Scene
from lesson_code.geometry import Circle, collide
from lesson_code.view.matplotlib import scene_plots, style
from lesson_code.view.matplotlib.plots import arrow


def ways_out(ax: Axes, drawn: Scene) -> Axes:
    """Draw circles that overlap the first body of a scene, and where each has to go.

    An arrow leads along the normal, from each contact point as far as the penetration; the dashed
    outline is the circle that only touches.

    Parameters
    ----------
    ax : Axes
        Where to draw; the scene is drawn too.
    drawn : Scene
        A static body, and circles.
    """
    scene_plots.scene(ax, drawn, around="all")
    first = drawn.bodies[0]
    for body in drawn.bodies[1:]:
        manifold = collide(
            first.shape, (*first.position, first.angle), body.shape, (*body.position, body.angle)
        )
        if manifold is None or not isinstance(body.shape, Circle):
            continue
        move = float(manifold.penetrations[0]) * manifold.normal
        deepest = np.asarray(body.position) - body.shape.radius * manifold.normal
        arrow(ax, deepest, move, "", style.INK)
        _ghost(ax, np.asarray(body.position) + move, body.shape.radius)
    return ax


def _ghost(ax: Axes, centre: Any, radius: float) -> None:
    """Draw the dashed outline of a circle, and extend the view to hold it."""
    ax.add_patch(CirclePatch(tuple(centre), radius, fill=False, linestyle="--"))
    reach = radius + 0.1
    (left, right), (bottom, top) = ax.get_xlim(), ax.get_ylim()
    ax.set_xlim(min(left, centre[0] - reach), max(right, centre[0] + reach))
    ax.set_ylim(min(bottom, centre[1] - reach), max(top, centre[1] + reach))
