"""Figures of chapter 03: speeds between cushions, balls with and without a gate, the table."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from lesson_code.chapters.billiards.rules import TABLE
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style


def speeds(v_bounce: Any, v_scaled: Any, tangent: float) -> None:
    """Show speed over the number of bounces, by two rules."""
    bounces = np.arange(len(v_bounce))
    named = {
        "bounce": (bounces, np.hypot(*np.transpose(v_bounce))),
        "e R": (bounces, np.hypot(*np.transpose(v_scaled))),
        f"tangent part, {tangent:g} px/s": (bounces, np.full(len(bounces), tangent)),
    }
    fig, ax = style.figure(width=7, height=3.4)
    plots.curves(ax, named, "bounces between two parallel cushions", "speed, px/s")
    ax.set_ylim(0, None)
    show(
        fig,
        "Speed over the number of bounces between parallel cushions. With bounce it falls towards "
        "the tangent part, 280 px/s. With e R it falls towards zero.",
    )


def gate(paths: Mapping[str, tuple[Any, Any]]) -> None:
    """Show each step of two balls, side by side."""
    fig, axes = style.figure(2, width=9.5, height=3.4)
    for ax, (title, (times, heights)) in zip(axes, paths.items(), strict=True):
        ax.plot(times, heights, color=style.BLUE, marker="o", markersize=3)
        ax.axhline(0, color=style.INK)
        ax.set(xlabel="time, s", ylabel="height, m", title=title, ylim=(-0.2, 1.05))
    show(
        fig,
        "Two plots of height over time. With the gate the ball goes on bouncing. Without the gate "
        "it is caught in the floor at its third bounce and never comes up again.",
    )


def separation(paths: Mapping[str, tuple[Any, Any]]) -> None:
    """Show heights over time with and without separation."""
    fig, ax = style.figure(width=8, height=3.2)
    plots.curves(ax, paths, "time, s", "height, m")
    show(
        fig,
        "Height of a ball over 3 s. Separated first it comes to rest on the floor; never separated "
        "it sinks through the floor.",
    )


def table(track: Any) -> None:
    """Show the path of a ball on the billiard table with its bumper."""
    bumper = zip(TABLE.bumper_start, TABLE.bumper_end, strict=True)
    fig, ax = style.figure(width=7, height=4.8)
    plots.path(ax, track, "the ball's centre", style.BLUE)
    ax.plot(*bumper, color=style.VERMILION, linewidth=8, solid_capstyle="round")
    ax.set(xlim=(0, TABLE.width), ylim=(TABLE.height, 0), xlabel="x, px", ylabel="y, px (down)")
    ax.grid(False)
    show(
        fig,
        "Path of the ball over 8 s on a table of 600 by 400 pixels: it hits all four cushions and "
        "the 45 degree bumper.",
    )
