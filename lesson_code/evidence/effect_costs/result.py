"""The costs of effects: a row for each effect and code, and the targets for the savings."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.table import Table

from lesson_code.evidence.measurement import (
    Limit,
    Measurement,
    at_least,
    at_most,
    digits,
    limits_table,
    micro,
    rows_with,
    table,
)

PLAIN, COMPILED, PYMUNK = "plain Python", "compiled", "pymunk"
CODES = (PLAIN, COMPILED, PYMUNK)
"""What a row was measured in."""

ALL = "all effects"
"""The row in which all effects are forced on at once."""

GAS_RATIO = 1.5
"""Times as fast as with every effect forced on: a gas of discs without friction."""

SLEEP_RATIO = 50.0
"""Times as cheap a step as awake: stacks that sleep."""

BILLIARDS_SECONDS = 0.02
"""s: to plan and run a scene of five balls without a compiler."""


@dataclass(frozen=True)
class EffectCost:
    """What one effect costs in one code. Times are medians, s a step; nan: there is none.

    Attributes
    ----------
    effect : str
        Its name, or :data:`ALL`.
    code : str
        One of :data:`CODES`.
    difference : str
        The difference between the two scenes, as "the one that needs it | the one that does not".
    needed : float
        In the scene that needs the effect, with it.
    switched_off : float
        In the same scene without it, where that is allowed: nothing but the time changes.
    left_out : float
        In the scene that does not need it, without it. In pymunk: as it is.
    forced : float
        In the same scene, with the effect forced on.
    calls_needed, calls_left_out, calls_forced : float
        Calls a step of the functions that only this effect needs; counted in plain Python.
    """

    effect: str
    code: str
    difference: str
    needed: float = math.nan
    switched_off: float = math.nan
    left_out: float = math.nan
    forced: float = math.nan
    calls_needed: float = math.nan
    calls_left_out: float = math.nan
    calls_forced: float = math.nan

    @property
    def saved(self) -> float:
        """Share of the time saved by leaving the effect out where it is not needed; nan: unknown.

        >>> EffectCost("friction", PLAIN, "", left_out=3.0, forced=4.0).saved
        0.25
        """
        return 1 - self.left_out / self.forced

    @property
    def cheaper(self) -> float:
        """What share of the time the scene that does not need it saves; nan: unknown.

        If the effect itself saves time, use `switched_off` instead: this share says nothing then.
        """
        return math.nan if self.switched_off >= 0 else 1 - self.left_out / self.needed


@dataclass(frozen=True)
class FewBalls:
    """A scene of a few balls, planned and run in plain Python: medians, s.

    Attributes
    ----------
    solver : str
        The one that was chosen.
    planning : float
        To choose solver, code and effects.
    whole : float
        That and the run.
    """

    solver: str
    planning: float
    whole: float


@dataclass(frozen=True)
class EffectCosts(Measurement):
    """All results, with the machine and the settings.

    Attributes
    ----------
    repeats : int
        Batches of each run.
    machine : dict
        As :func:`lesson_code.evidence.measurement.machine` returns it.
    billiards : FewBalls or None
        None: not measured.
    costs : tuple of EffectCost
        In the order of the stages, a row for each code.
    """

    command = "measure effects"
    file = Path(__file__).with_name("stored.json")
    rows = {"costs": EffectCost, "billiards": FewBalls}  # noqa: RUF012 - as in the base class
    derived = ("limits",)

    repeats: int
    machine: dict[str, Any]
    billiards: FewBalls | None
    costs: tuple[EffectCost, ...]

    def of(self, effect: str, code: str) -> EffectCost | None:
        """Return the row of an effect in a code; None: there is none."""
        return next((c for c in self.costs if (c.effect, c.code) == (effect, code)), None)

    def in_code(self, code: str) -> list[EffectCost]:
        """Return the rows of a code.

        Raises
        ------
        ValueError
            Nothing was measured in it.
        """
        return rows_with(self.costs, code=code)

    @property
    def limits(self) -> list[Limit]:
        """The targets, and whether they are reached."""
        found = []
        for cost in self.costs:
            if cost.effect == ALL:
                what = f"{cost.difference}, {cost.code}: all effects over those called for"
                found.append(at_least(what, cost.forced / cost.left_out, GAS_RATIO))
            if cost.effect == "sleeping" and cost.code != PYMUNK:
                what = f"stacks, {cost.code}: a step awake over one asleep"
                found.append(at_least(what, cost.switched_off / cost.needed, SLEEP_RATIO))
        if self.billiards is not None:
            what = "billiards, plain Python: planned and run, s"
            found.append(at_most(what, self.billiards.whole, BILLIARDS_SECONDS))
        return found

    def tables(self) -> Iterator[Table]:
        """Yield a table for each code, then the targets."""
        for code in dict.fromkeys(cost.code for cost in self.costs):
            title, columns, caption = PYMUNK_TABLE if code == PYMUNK else OUR_TABLE
            yield table(f"{code}: {title}", columns, self.in_code(code), words=2, caption=caption)
        few = self.billiards
        planning = [] if few is None else [_planning(few)]
        if self.limits:
            yield limits_table([*self.limits, *planning])


def _planning(few: FewBalls) -> Limit:
    return Limit(f"billiards by {few.solver}: planning alone, s", few.planning)


NAMES: dict[str, Callable[[EffectCost], str]] = {
    "effect": lambda cost: "all of them" if cost.effect == ALL else cost.effect,
    "scenes": lambda cost: cost.difference,
}

OUR_TABLE = (
    "what an effect costs, and what leaving it out saves",
    {
        **NAMES,
        "with": lambda cost: micro(cost.needed),
        "off": lambda cost: micro(cost.switched_off),
        "left out": lambda cost: micro(cost.left_out),
        "forced": lambda cost: micro(cost.forced),
        "saved": lambda cost: _share(cost.saved),
        "calls": lambda cost: _calls(cost),
    },
    """\
us a step. "with": the scene that needs the effect. "off": the same scene without it,
where that changes nothing but the time. "left out" and "forced": the scene that does not
need it, as planned and with the effect forced on; saved: of the time forced.
Calls: a step, of the functions that only this effect needs: left out | forced.""",
)
"""Title, columns and caption of the table of one of our codes."""

PYMUNK_TABLE = (
    "the same scenes",
    {
        **NAMES,
        "needs it": lambda cost: micro(cost.needed),
        "off": lambda cost: micro(cost.switched_off),
        "does not": lambda cost: micro(cost.left_out),
        "cheaper": lambda cost: _share(cost.cheaper),
    },
    "us a step; pymunk has one program for all scenes.",
)


def _calls(cost: EffectCost) -> str:
    """Return the calls a step, left out and forced.

    >>> _calls(EffectCost("friction", "plain Python", "", calls_left_out=0.0, calls_forced=5880.0))
    '0 | 5,880'
    """
    counts = (cost.calls_left_out, cost.calls_forced)
    return " | ".join(map(digits, counts)) if all(map(math.isfinite, counts)) else ""


def _share(value: float) -> str:
    """Return a share in per cent.

    >>> _share(0.251), _share(-0.0001), _share(math.nan)
    ('25 %', '0 %', '')
    """
    return f"{round(100 * value) + 0} %" if math.isfinite(value) else ""
