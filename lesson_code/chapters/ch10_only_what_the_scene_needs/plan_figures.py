"""The table of chapter 10: which scene calls for what."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from matplotlib.axes import Axes

from lesson_code.engine.core.plan import Plan
from lesson_code.view.matplotlib import style


def plans(ax: Axes, planned: Mapping[str, Plan]) -> Axes:
    """Draw a table of plans: a row for each effect, a column for each scene.

    Parameters
    ----------
    ax : Axes
        Where to draw; give it about an inch for each scene and a quarter for each effect.
    planned : mapping of str to Plan
        By the names of the scenes. All must name the same effects.

    Raises
    ------
    ValueError
        There is no plan, or two do not name the same effects.
    """
    rows = _effects_of(planned)
    for column, plan in enumerate(planned.values()):
        for used in (True, False):
            places = [n for n, name in enumerate(rows) if plan.effect(name).used is used]
            color, face = (style.BLUE, style.BLUE) if used else (style.GREY, "none")
            ax.scatter(
                [column] * len(places),
                places,
                s=90 if used else 30,
                facecolors=face,
                edgecolors=color,
                label=("simulated" if used else "left out") if column == 0 else None,
            )
    ax.set_xticks(range(len(planned)), list(planned), fontsize=9)
    ax.set_yticks(range(len(rows)), rows, fontsize=9)
    ax.set(xlim=(-0.6, len(planned) - 0.4), ylim=(len(rows) - 0.4, -0.6))
    ax.xaxis.tick_top()
    ax.spines[:].set_visible(False)
    ax.tick_params(length=0)
    ax.legend(frameon=False, ncols=2, loc="upper center", bbox_to_anchor=(0.5, 0.0))
    return ax


def _effects_of(planned: Mapping[str, Plan]) -> Sequence[str]:
    """Return the effects that all plans name."""
    named = {tuple(choice.name for choice in plan.effects) for plan in planned.values()}
    if len(named) != 1:
        raise ValueError(f"planned must hold plans that name the same effects, got {len(named)}")
    return named.pop()
