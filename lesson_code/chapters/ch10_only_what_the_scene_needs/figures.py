"""The figure of chapter 10: what an effect costs where it is needed, and saves where it is not."""

from __future__ import annotations

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from lesson_code.evidence.effect_costs import CODES, EffectCost, EffectCosts
from lesson_code.evidence.effect_costs.result import ALL
from lesson_code.view.matplotlib import style
from lesson_code.view.matplotlib.measured import marks, rows

LOOKS: dict[str, dict[str, Any]] = {
    "needed": {"color": style.VERMILION, "marker": "D", "label": "needs the effect"},
    "switched_off": {"color": style.PURPLE, "marker": "X", "label": "needs it, switched off"},
    "forced": {"color": style.ORANGE, "marker": "s", "label": "does not, forced on"},
    "left_out": {"color": style.BLUE, "marker": "o", "label": "does not, left out"},
}
"""Colour, marker and words of each time of a row."""


def all_effects(result: EffectCosts) -> Figure:
    """Return a figure with a panel for each code that was measured, and one legend."""
    codes = [code for code in CODES if any(cost.code == code for cost in result.costs)]
    drawn = Figure(figsize=(4.6 * len(codes), 6.2), layout="constrained", dpi=100)
    for ax, code in zip(drawn.subplots(1, len(codes), squeeze=False)[0], codes, strict=True):
        what_effects_cost(style.plain(ax), result, code)
    handles = drawn.axes[0].get_legend_handles_labels()
    drawn.legend(*handles, loc="outside lower center", ncols=len(LOOKS), frameon=False, fontsize=9)
    return drawn


def what_effects_cost(ax: Axes, result: EffectCosts, code: str) -> Axes:
    """Draw the times of a step for each effect, in one code.

    A bar joins what the scene that does not need the effect costs with it and without it: that is
    what leaving it out saves. The other marks are the scene that needs it.

    Parameters
    ----------
    ax : Axes
        Where to draw; give it a legend, or draw one beside it.
    result : EffectCosts
        What was measured.
    code : str
        "plain Python", "compiled" or "pymunk".

    Raises
    ------
    ValueError
        Nothing was measured in that code.
    """
    costs = result.in_code(code)
    for y, cost in enumerate(costs):
        ends = [1e6 * cost.left_out, 1e6 * cost.forced]
        ax.plot(ends, [y, y], color=style.ORANGE, linewidth=4, alpha=0.35, solid_capstyle="butt")
    for name, look in LOOKS.items():
        times = [(1e6 * getattr(cost, name), y) for y, cost in enumerate(costs)]
        marks(ax, times, markersize=6, **look)
    rows(ax, [_name(cost) for cost in costs])
    ax.set(xscale="log", xlabel="time of a step, \u00b5s")
    ax.xaxis.set_major_formatter("{x:g}")
    ax.xaxis.set_minor_formatter(NullFormatter())  # a short axis would label them all
    ax.set_title(code, fontsize=11)
    return ax


def _name(cost: EffectCost) -> str:
    """Return what stands beside a row."""
    return f"all: {cost.difference}" if cost.effect == ALL else cost.effect.replace("_", " ")
