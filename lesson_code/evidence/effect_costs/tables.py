"""What effects cost, as tables for the terminal."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rich import box
from rich.table import Column, Table

from lesson_code.evidence.effect_costs.result import ALL, PYMUNK, EffectCost, EffectCosts

CAPTION = """\
us a step. "with": the scene that needs the effect. "off": the same scene without it,
where that changes nothing but the time. "left out" and "forced": the scene that does not
need it, as planned and with the effect forced on; saved: of the time forced.
Calls: a step, of the functions that only this effect needs: left out | forced."""

PYMUNK_CAPTION = "us a step; pymunk has one program for all scenes."


def as_tables(result: EffectCosts) -> Iterator[Table]:
    """Yield a table for each code, then what is wanted."""
    for code in dict.fromkeys(cost.code for cost in result.costs):
        yield pymunk_table(result) if code == PYMUNK else code_table(result, code)
    if result.billiards is not None or result.limits():
        yield limits_table(result)


def code_table(result: EffectCosts, code: str) -> Table:
    """Return the rows of one of our codes."""
    table = _table(
        f"{code}: what an effect costs, and what leaving it out saves",
        *("with", "off", "left out", "forced", "saved", "calls"),
        caption=CAPTION,
    )
    for cost in result.in_code(code):
        times = (cost.needed, cost.switched_off, cost.left_out, cost.forced)
        table.add_row(*_names(cost), *map(micro, times), _share(cost.saved), calls(cost))
    return table


def pymunk_table(result: EffectCosts) -> Table:
    """Return what pymunk takes for the same scenes."""
    table = _table(
        "pymunk: the same scenes", "needs it", "off", "does not", "cheaper", caption=PYMUNK_CAPTION
    )
    for cost in result.in_code(PYMUNK):
        times = map(micro, (cost.needed, cost.switched_off, cost.left_out))
        table.add_row(*_names(cost), *times, _share(cost.cheaper))
    return table


def limits_table(result: EffectCosts) -> Table:
    """Return what is wanted, and whether it is reached; and how the billiard balls were run."""
    table = _table("limits", "measured", "wanted", "reached", second=False)
    for limit in result.limits():
        reached = {True: "yes", False: "NO", None: ""}[limit.reached]
        table.add_row(limit.what, f"{limit.value:.3g}", limit.wanted, reached)
    if result.billiards is not None:
        few = result.billiards
        table.add_row(f"billiards by {few.solver}: planning alone, s", f"{few.planning:.3g}")
    return table


def micro(seconds: float) -> str:
    """Return a time in microseconds, with three digits; "" where there is none.

    >>> micro(0.00123456), micro(1.5e-7), micro(math.nan)
    ('1,230', '0.15', '')
    """
    if not math.isfinite(seconds):
        return ""
    rounded = float(f"{1e6 * seconds:.3g}")
    return f"{rounded:,.0f}" if rounded >= 100 else f"{rounded:g}"


def calls(cost: EffectCost) -> str:
    """Return the calls a step, left out and forced, as text.

    >>> calls(EffectCost("friction", "plain Python", "", calls_left_out=0.0, calls_forced=5880.0))
    '0 | 5,880'
    """
    counts = (cost.calls_left_out, cost.calls_forced)
    if not all(map(math.isfinite, counts)):
        return ""
    return " | ".join(f"{count:,.0f}" if count >= 100 else f"{count:.3g}" for count in counts)


def _table(title: str, *columns: str, caption: str = "", second: bool = True) -> Table:
    """Return an empty table."""
    first = [Column("effect", no_wrap=True), Column("scenes")] if second else [Column("what")]
    return Table(
        *first,
        *(Column(name, justify="right") for name in columns),
        title=title,
        caption=caption or None,
        box=box.SIMPLE_HEAD,
        pad_edge=False,
    )


def _names(cost: EffectCost) -> tuple[str, str]:
    """Return the effect, and in what its scenes differ."""
    return ("all of them" if cost.effect == ALL else cost.effect), cost.difference


def _share(value: float) -> str:
    """Return a share in per cent; "" where there is none.

    >>> _share(0.251), _share(-0.0001), _share(math.nan)
    ('25 %', '0 %', '')
    """
    return f"{round(100 * value) + 0} %" if math.isfinite(value) else ""
