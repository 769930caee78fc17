"""What was measured: families in every engine, side by side, and a single draw of one."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, Self

from rich.table import Table

from lesson_code.evidence.hard_cases.catalogue import FAMILIES, family_by_name
from lesson_code.evidence.hard_cases.parameters import Value
from lesson_code.evidence.hard_cases.trial import (
    ENGINES,
    OURS,
    SWEEPS,
    Outcome,
)
from lesson_code.evidence.measurement import Measurement, four_digits, plain, rows_with, table

HEADINGS = {OURS: "ours", SWEEPS: "sweeps", "naive": "naive", "pymunk": "pymunk", "box2d": "Box2D"}

SAID = ("name", "theme", "title", "why", "law", "unit", "bound", "reason")
"""The fields of a family that are stored beside its results."""

REPLAY_WIDTH = 80
"""Columns of the tables of one draw, below titles that are sentences."""

MANY = 10
"""From so many draws on the table shows a percentage in place of counts."""


@dataclass(frozen=True)
class Result:
    """How an engine did in some draws of a family.

    Attributes
    ----------
    family, engine : str
        Their names.
    draws, held : int
        How many draws were made, and in how many of them the bound was held.
    worst : float
        The largest value; nan if a draw has no result, for that is worse.
    worst_seed : int
        Of the draw with the largest value, or of the first without a result.
    error : str
        Why the worst draw has no value; "" if it has one.
    fails_seed : int or None
        Of the mildest of the draws that fail; None if none does.
    fails_from : mapping of str to value
        Its parameters: where the engine begins to fail.
    seconds : float
        CPU time of a draw, the median.
    """

    family: str
    engine: str
    draws: int
    held: int
    worst: float
    worst_seed: int
    error: str = ""
    fails_seed: int | None = None
    fails_from: Mapping[str, Value] = field(default_factory=dict)
    seconds: float = math.nan

    @property
    def share(self) -> float:
        """Share of the draws in which the bound was held, 0 to 1."""
        return self.held / self.draws

    @property
    def holds(self) -> bool:
        """Whether the bound was held in every draw."""
        return self.held == self.draws


def summed_up(outcomes: Sequence[Outcome]) -> Result:
    """Return what the draws of one family in one engine say together; there is at least one."""
    worst = max(outcomes, key=_badness)
    failed = [outcome for outcome in outcomes if not outcome.held]
    mildest = min(failed, key=_badness) if failed else None
    seconds = [o.seconds for o in outcomes if math.isfinite(o.seconds)]
    return Result(
        family=worst.family,
        engine=worst.engine,
        draws=len(outcomes),
        held=len(outcomes) - len(failed),
        worst=worst.value,
        worst_seed=worst.seed,
        error=worst.error,
        fails_seed=mildest.seed if mildest else None,
        fails_from=mildest.parameters if mildest else {},
        seconds=four_digits(statistics.median(seconds)) if seconds else math.nan,
    )


def _badness(outcome: Outcome) -> float:
    """Return the value, or infinity where there is none."""
    return math.inf if math.isnan(outcome.value) else outcome.value


@dataclass(frozen=True)
class Comparison(Measurement):
    """How each engine did in each family.

    Attributes
    ----------
    results : tuple of Result
        In the order of the catalogue, and within a family in the order of the engines.
    """

    command = "measure hard-cases"
    version: ClassVar[int] = 2
    file = Path(__file__).with_name("stored.json")

    results: tuple[Result, ...]

    @property
    def engines(self) -> tuple[str, ...]:
        """The engines that took part."""
        present = {result.engine for result in self.results}
        return tuple(engine for engine in ENGINES if engine in present)

    @property
    def names(self) -> tuple[str, ...]:
        """The families that were run."""
        return tuple(dict.fromkeys(result.family for result in self.results))

    def result(self, family: str, engine: str) -> Result:
        """Return how an engine did in a family."""
        return next(r for r in self.results if (r.family, r.engine) == (family, engine))

    def holds(self, engine: str) -> int:
        """Return how many families an engine holds in every draw."""
        return sum(result.holds for result in rows_with(self.results, engine=engine))

    def not_held(self, engine: str = OURS) -> list[str]:
        """Return the families that an engine does not hold in every draw."""
        return [r.family for r in rows_with(self.results, engine=engine) if not r.holds]

    def share(self, engine: str) -> float:
        """Return the share of all draws in which an engine held the bound, 0 to 1."""
        mine = rows_with(self.results, engine=engine)
        return sum(result.held for result in mine) / sum(result.draws for result in mine)

    def price(self, family: str) -> float:
        """Return the time of a usual draw of a family with ours over that with sweeps."""
        return self.result(family, OURS).seconds / self.result(family, SWEEPS).seconds

    def merged(self, other: Comparison) -> Comparison:
        """Return a comparison in which what was measured anew stands in the place of the old."""
        found = {(r.family, r.engine): r for r in (*self.results, *other.results)}
        pairs = [(known.name, engine) for known in FAMILIES for engine in ENGINES]
        return Comparison(tuple(found[pair] for pair in pairs if pair in found))

    def as_dict(self) -> dict[str, Any]:
        """Return the comparison as one JSON object; null stands for a value that is not finite."""
        return {
            "version": self.version,
            "command": self.command,
            "engines": list(self.engines),
            "holds": {engine: self.holds(engine) for engine in self.engines},
            "share": {engine: self.share(engine) for engine in self.engines},
            "families": [self._family_as_dict(name) for name in self.names],
        }

    def _family_as_dict(self, name: str) -> dict[str, Any]:
        family = family_by_name(name)
        said = {key: plain(getattr(family, key)) for key in SAID}
        return said | {"results": {e: _measured(self.result(name, e)) for e in self.engines}}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Return the comparison that :meth:`as_dict` has written; an unknown number is nan."""
        return cls(
            tuple(
                Result(family["name"], engine, **{**result, **_numbers(result)})
                for family in data["families"]
                for engine, result in family["results"].items()
            )
        )

    def tables(self) -> Iterator[Table]:
        """Yield the table, grouped by theme; what does not hold every draw is marked."""
        columns: dict[str, Callable[[str], str]] = {
            "family": lambda name: f" {name}",
            "unit": lambda name: family_by_name(name).unit,
            "bound": lambda name: f"{family_by_name(name).bound:.0e}".replace("0e+00", "0"),
            **{HEADINGS[engine]: partial(self._cell, engine) for engine in self.engines},
        }
        made = table(
            "Hard cases: draws held, and the worst figure",
            columns,
            self.names,
            words=2,
            group=lambda name: family_by_name(name).theme,
            caption="Not held by every draw: x. A draw without a result: -. 0 is right.",
            box=None,
        )
        made.padding = (0, 1, 0, 0)  # so that 100 columns are enough
        made.columns[0].max_width, made.columns[1].max_width = 24, 4
        counts = [str(self.holds(engine)) for engine in self.engines]
        made.add_row(f"[bold]held whole, of {len(self.names)}[/bold]", "", "", *counts)
        shares = [f"{math.floor(1e4 * self.share(engine)) / 100:.2f} %" for engine in self.engines]
        made.add_row("[bold]draws held[/bold]", "", "", *shares)
        yield made

    def _cell(self, engine: str, name: str) -> str:
        result = self.result(name, engine)
        worst = "-" if math.isnan(result.worst) else _short(result.worst)
        held = f"{result.held}/{result.draws}" if result.draws < MANY else _percent(result.share)
        text = f"{held}{' ' if result.holds else 'x'} {worst:>6}"
        return text if result.holds else f"[red]{text}[/red]"


def _percent(share: float) -> str:
    """Return a share in whole per cent, rounded down: 100 % is all.

    >>> _percent(0.999), _percent(1.0)
    ('99%', '100%')
    """
    return f"{math.floor(100 * share)}%"


def _measured(result: Result) -> dict[str, Any]:
    names = ("draws", "held", "worst", "worst_seed", "error", "fails_seed", "fails_from", "seconds")
    return {key: plain(getattr(result, key)) for key in names}


def _numbers(result: Mapping[str, Any]) -> dict[str, float]:
    return {k: math.nan if result[k] is None else result[k] for k in ("worst", "seconds")}


def _number(value: float) -> str:
    """Return a number in few characters.

    >>> _number(31.0), _number(0.25), _number(1.2345e-7)
    ('31', '0.25', '1.2e-07')
    """
    if value == 0.0 or (value >= 1.0 and value.is_integer() and value < 1e4):
        return f"{value:.0f}"
    return f"{value:.1e}" if not 0.01 <= value < 1000 else f"{value:.3g}"


def _short(value: float) -> str:
    """Return a number in six characters at the most.

    >>> _short(0.25), _short(1.2345e-7), _short(1.2345e-15), _short(2345678.0), _short(math.inf)
    ('0.25', '1.2e-7', '1e-15', '2.3e6', 'inf')
    """
    if value == 0.0 or 0.01 <= value < 1000 or math.isinf(value):
        return _number(value)
    mantissa, exponent = f"{value:.1e}".split("e")
    power = str(int(exponent))
    return f"{mantissa}e{power}" if len(power) < 3 else f"{value:.0e}"


@dataclass(frozen=True)
class Replay(Measurement):
    """One draw of a family in each engine.

    Attributes
    ----------
    outcomes : tuple of Outcome
        One for each engine; all have the same family, seed and parameters.
    """

    command = "measure hard-cases --replay"

    outcomes: tuple[Outcome, ...]

    @property
    def parameters(self) -> Mapping[str, Value]:
        """What was drawn: the fullest list, for an engine that dies tells nothing."""
        return max((outcome.parameters for outcome in self.outcomes), key=len)

    def as_dict(self) -> dict[str, Any]:
        """Return the draw as one JSON object."""
        return {
            "version": self.version,
            "command": self.command,
            "family": self.outcomes[0].family,
            "seed": self.outcomes[0].seed,
            "bound": self.outcomes[0].bound,
            "parameters": dict(self.parameters),
            "engines": {
                o.engine: {"value": plain(o.value), "held": o.held, "error": o.error}
                for o in self.outcomes
            },
        }

    def tables(self) -> Iterator[Table]:
        """Yield the parameters, and the figure of each engine."""
        first = self.outcomes[0]
        family = family_by_name(first.family)
        drawn: dict[str, Callable[[str], str]] = {
            "parameter": str,
            "value": lambda name: _parameter(self.parameters[name]),
        }
        title = f"{family.name}:{first.seed}. {family.title}"
        parameters = table(title, drawn, self.parameters)
        figures: dict[str, Callable[[Outcome], str]] = {
            "engine": lambda outcome: HEADINGS[outcome.engine],
            "held": lambda outcome: "yes" if outcome.held else "NO",
            "figure": lambda outcome: outcome.error or f"{_number(outcome.value)} {family.unit}",
        }
        title = f"{family.law} Bound: {family.bound:g} {family.unit} ({family.reason})"
        measured = table(title, figures, self.outcomes, words=3)
        parameters.min_width = measured.min_width = REPLAY_WIDTH
        yield parameters
        yield measured


def _parameter(value: Value) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)
