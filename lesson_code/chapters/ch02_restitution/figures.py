"""Figures of chapter 02: what e keeps of speed and energy, and balls that are stepped in time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style


def speed_and_energy_kept() -> None:
    """Show which part of the speed and of the energy is kept, over the restitution."""
    e = np.linspace(0, 1, 101)
    fig, ax = style.figure(width=6, height=3.4)
    named = {"part of the relative energy kept: e²": (e, e**2), "part of the speed kept: e": (e, e)}
    plots.curves(ax, named, "restitution e", "part kept")
    show(
        fig,
        "Two curves over restitution from 0 to 1: the speed kept is e, a straight line; the energy "
        "kept is e squared, below it.",
    )


def heights(paths: Mapping[str, tuple[Any, Any]], alt: str) -> None:
    """Show heights over time, each path with its name."""
    fig, ax = style.figure(width=8, height=3.4)
    plots.curves(ax, paths, "time, s", "height, m")
    show(fig, alt)
