"""What was measured: a row for each effect and code; and its form as JSON."""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from lesson_code.evidence.speed.limits import Limit

VERSION = 1
"""Version of the form that :meth:`EffectCosts.as_dict` writes; it grows when a key changes."""

STORED = Path(__file__).with_name("stored.json")
"""A result that was measured once, for the notebook."""

PLAIN, COMPILED, PYMUNK = "plain Python", "compiled", "pymunk"
CODES = (PLAIN, COMPILED, PYMUNK)
"""What a row was measured in."""

ALL = "all effects"
"""The row in which not one effect is forced on but all of them."""

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
        In what the two scenes differ, as "the one that needs it | the one that does not".
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
        """What share of the time leaving it out saves, where it is not needed; nan: unknown.

        >>> EffectCost("friction", PLAIN, "", left_out=3.0, forced=4.0).saved
        0.25
        """
        return 1 - self.left_out / self.forced

    @property
    def cheaper(self) -> float:
        """What share of the time the scene that does not need it saves; nan: unknown.

        Where the effect is a saving itself, that says nothing: there is `switched_off` for it.
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

    @property
    def running(self) -> float:
        """What is left for the run, s."""
        return self.whole - self.planning


@dataclass(frozen=True)
class EffectCosts:
    """All that was measured, and where and how.

    Attributes
    ----------
    costs : tuple of EffectCost
        In the order of the stages, a row for each code.
    billiards : FewBalls or None
        None: not measured.
    repeats : int
        Batches of each run.
    machine : dict
        Versions and the kind of processor.
    """

    costs: tuple[EffectCost, ...]
    billiards: FewBalls | None
    repeats: int
    machine: dict[str, Any]

    @property
    def effects(self) -> list[str]:
        """The names of the effects, in order."""
        return list(dict.fromkeys(cost.effect for cost in self.costs))

    def of(self, effect: str, code: str) -> EffectCost | None:
        """Return the row of an effect in a code; None: there is none."""
        rows = [c for c in self.costs if (c.effect, c.code) == (effect, code)]
        return rows[0] if rows else None

    def in_code(self, code: str) -> list[EffectCost]:
        """Return the rows of a code.

        Raises
        ------
        ValueError
            Nothing was measured in it.
        """
        rows = [cost for cost in self.costs if cost.code == code]
        if not rows:
            known = ", ".join(dict.fromkeys(cost.code for cost in self.costs))
            raise ValueError(f"code must be one of {known}, got {code!r}")
        return rows

    def limits(self) -> list[Limit]:
        """Return what is wanted, and whether it is reached."""
        found = []
        for cost in self.costs:
            if cost.effect == ALL:
                what = f"{cost.difference}, {cost.code}: all effects over those called for"
                found.append(Limit(what, cost.forced / cost.left_out, GAS_RATIO))
            if cost.effect == "sleeping" and cost.code != PYMUNK:
                what = f"stacks, {cost.code}: a step awake over one asleep"
                found.append(Limit(what, cost.switched_off / cost.needed, SLEEP_RATIO))
        if self.billiards is not None:
            what = "billiards, plain Python: planned and run, s"
            found.append(Limit(what, self.billiards.whole, most=BILLIARDS_SECONDS))
        return found

    def as_dict(self) -> dict[str, Any]:
        """Return all of it as one JSON object; null stands for what is not known."""
        return {
            "version": VERSION,
            "command": "measure effects",
            "repeats": self.repeats,
            "machine": self.machine,
            "billiards": None if self.billiards is None else asdict(self.billiards),
            "limits": [_limit(limit) for limit in self.limits()],
            "costs": [_plain(asdict(cost)) for cost in self.costs],
        }


def from_dict(data: dict[str, Any]) -> EffectCosts:
    """Return the result that was written as a JSON object.

    Raises
    ------
    ValueError
        It is of another version.
    """
    if data.get("version") != VERSION:
        raise ValueError(f"version must be {VERSION}, got {data.get('version')!r}")
    few = data["billiards"]
    costs = tuple(EffectCost(**_full(cost)) for cost in data["costs"])
    billiards = None if few is None else FewBalls(**few)
    return EffectCosts(costs, billiards, data["repeats"], data["machine"])


def stored() -> EffectCosts:
    """Return the result that the package holds."""
    return from_dict(json.loads(STORED.read_text(encoding="utf-8")))


def store(result: EffectCosts, path: Path = STORED) -> None:
    """Write a result, a line for each row."""
    data = result.as_dict()
    rows = ",\n".join("  " + json.dumps(row) for row in data.pop("costs"))
    head = json.dumps(data, indent=1)[:-2]
    path.write_text(f'{head},\n "costs": [\n{rows}\n ]\n}}\n', encoding="utf-8")


def _limit(limit: Limit) -> dict[str, Any]:
    """Return a limit as JSON can hold it."""
    reached = limit.reached
    return {"what": limit.what, "value": limit.value, "wanted": limit.wanted, "reached": reached}


def _plain(row: dict[str, Any]) -> dict[str, Any]:
    """Return a row as JSON can hold it; numbers with four digits, for they have no more."""
    return {key: _digits(v) if isinstance(v, float) else v for key, v in row.items()}


def _digits(value: float) -> float | None:
    """Return a number with four digits, or None where it is not known."""
    return float(f"{value:.4g}") if math.isfinite(value) else None


def _full(row: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a row, with null filled in."""
    return {key: math.nan if value is None else value for key, value in row.items()}
