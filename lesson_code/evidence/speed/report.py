"""All measurements of speed, the targets, and the tables."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
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
    table,
)
from lesson_code.evidence.orders import fit_order
from lesson_code.evidence.speed.engines import OURS, PEERS
from lesson_code.evidence.speed.piles import Held, PileRace
from lesson_code.evidence.speed.race import Race, Ratio, Timing
from lesson_code.evidence.speed.targets import (
    MOST_BYTES,
    MOST_GROWTH,
    PILE_RATIOS,
)
from lesson_code.evidence.speed.whole_runs import WholeRuns

GROWTH_FROM = 1_000
"""Bodies: from here on the growth of the time is fitted."""


@dataclass(frozen=True)
class Speed(Measurement):
    """What has been measured; parts that were not asked for are empty."""

    command = "measure speed"
    version = 3
    derived = ("growth_exponents", "limits")

    machine: dict[str, Any]
    repeats: int  # of each process, and batches of each engine in each scene
    whole_runs: WholeRuns | None = None  # from the start of Python to the result
    scenes: tuple[Race, ...] = ()
    piles: tuple[PileRace, ...] = ()  # each engine with the least work that lets them hold

    @property
    def growth_exponents(self) -> dict[str, dict[str, float]]:
        """By scene and engine, the exponent of the time over the bodies, from 1,000 on."""
        found: dict[str, dict[str, float]] = {}
        for kind in ("gas", "settled"):
            races = [r for r in self.scenes if r.kind == kind and r.bodies >= GROWTH_FROM]
            for engine in (*OURS, *PEERS):
                timed = [(race.bodies, timing) for race in races if (timing := race.timing(engine))]
                if len(timed) > 1:
                    sizes, seconds = zip(*((n, t.compared) for n, t in timed), strict=True)
                    found.setdefault(kind, {})[engine] = fit_order(sizes, seconds).order
        return found

    @property
    def limits(self) -> list[Limit]:
        """The targets besides the ratios of single scenes."""
        return list(self._limits())

    def _limits(self) -> Iterator[Limit]:
        for kind, exponents in self.growth_exponents.items():
            for engine, exponent in exponents.items():
                what = f"exponent of the time over the bodies, {kind}, {engine}"
                is_ours = engine == "sequential"
                yield at_most(what, exponent, MOST_GROWTH) if is_ours else Limit(what, exponent)
        for pile in self.piles:
            for peer, wanted in PILE_RATIOS[pile.key].items():
                if (ratio := pile.ratio(peer)) is not None:
                    yield at_least(f"{pile.key}, {peer}'s time over ours", ratio, wanted)
        for race in self.scenes:
            if race.kind == "gas" and race.bodies == max(scene.bodies for scene in self.scenes):
                ours = race.timing("sequential")
                if ours is not None and ours.bytes_per_body is not None:
                    what = f"{race.name}, all our tables, bytes a body"
                    yield at_most(what, ours.bytes_per_body, MOST_BYTES)

    def tables(self) -> Iterator[Table]:
        """Yield the whole runs, then the steps: a table for each kind of scene, and the rest."""
        if self.whole_runs is not None:
            yield from self.whole_runs.tables()
        for kind in dict.fromkeys(race.kind for race in self.scenes):
            yield _race_table([race for race in self.scenes if race.kind == kind])
        yield from map(_pile_table, self.piles)
        if self.limits:
            yield limits_table(self.limits)


RACE_CAPTION = """\
CPU: share of the time that the processor worked for us; ratios are of its times.
Overlap in smallest widths. Energy: the change of a gas's; of a pile, what it has left
of motion, over what lifts it by a width. Contacts a body.
"2.61 of 2.8": the ratio, of what is wanted; "ok" where it is reached at equal quality."""


def _race_table(races: list[Race]) -> Table:
    """Return the table of the scenes of one kind."""
    columns: dict[str, Callable[[tuple[Race, Timing]], str]] = {
        "engine": lambda row: f"  {row[1].engine}",
        "us a step": lambda row: micro(row[1].seconds),
        "CPU": lambda row: f"{row[1].cpu_seconds / row[1].seconds:.0%}",
        "overlap": lambda row: f"{row[1].quality.overlap:.4f}",
        "energy": lambda row: f"{row[1].quality.energy_error:.0e}",
        "contacts": lambda row: f"{row[1].contacts_per_body:.2f}",
        "pymunk/ours": lambda row: _ratio(row[0].ratio(row[1].engine, "pymunk")),
        "Box2D/ours": lambda row: _ratio(row[0].ratio(row[1].engine, "box2d")),
    }
    return table(
        ", ".join(race.name for race in races),
        columns,
        [(race, timing) for race in races for timing in race.engines],
        group=lambda row: row[0].name,
        caption=RACE_CAPTION,
    )


def _ratio(ratio: Ratio | None) -> str:
    """Return a ratio, its target, and whether it is reached, in words."""
    if ratio is None or ratio.ours not in OURS:
        return ""
    text = digits(ratio.ratio)
    if ratio.wanted is not None:
        text += f" of {ratio.wanted:g}" + (" ok" if ratio.reached else "")
    return "\n".join([text, *(f"worse {what}" for what in ratio.worse)])


def _pile_table(pile: PileRace) -> Table:
    """Return the table of one pile that has to hold."""
    ours = pile.least(*OURS)
    columns: dict[str, Callable[[Held], str]] = {
        "engine": lambda row: row.engine,
        "iterations or sub-steps": lambda row: str(row.setting),
        "held": lambda row: "yes" if row.held else "no",
        "overlap": lambda row: f"{row.overlap:.4f}",
        "CPU ms": lambda row: digits(1e3 * row.seconds),
        "this/our best": lambda row: digits(row.seconds / ours) if ours and row.held else "",
    }
    return table(f"Each with the least that it needs for {pile.name}", columns, pile.rows)
