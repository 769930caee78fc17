"""All that was measured, as one JSON object or as tables that fit into 100 columns."""

from __future__ import annotations

import importlib.metadata
import math
import platform
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from rich.box import SIMPLE_HEAD
from rich.table import Column, Table

from lesson_code.evidence.speed.engines import OURS, PEERS
from lesson_code.evidence.speed.few_bodies import FewBodies
from lesson_code.evidence.speed.limits import (
    Limit,
    few_bodies_limits,
    growth_limits,
    memory_limits,
    pile_limits,
    start_limits,
)
from lesson_code.evidence.speed.piles import PileRace
from lesson_code.evidence.speed.processes import Memory, Start
from lesson_code.evidence.speed.race import Race, Timing
from lesson_code.evidence.speed.statistics import growth_exponent
from lesson_code.evidence.speed.targets import Target, targets_of
from lesson_code.parallel import usable_cores

VERSION = 2
"""Version of the form that :meth:`Speed.as_dict` writes; it grows when a key changes."""

GROWTH_FROM = 1_000
"""Bodies: from here on the growth of the time is fitted."""

RACE_CAPTION = """\
CPU: share of the time that the processor worked for us; ratios are of its times.
Overlap in smallest widths. Energy: the change of a gas's; of a pile, what it has left
of motion, over what lifts it by a width. Contacts a body.
"2.61 of 2.8": the ratio, of what is wanted; "ok" where it is reached at equal quality."""

PACKAGES = ("numpy", "numba", "pymunk", "Box2D")


@dataclass(frozen=True)
class Verdict:
    """A ratio of times, what is wanted of it, and whether it is reached at equal quality."""

    scene: str
    ours: str
    peer: str
    ratio: float
    worse: tuple[str, ...]
    wanted: float | None

    @property
    def reached(self) -> bool | None:
        """Whether the target is reached; None: there is none."""
        return None if self.wanted is None else self.ratio >= self.wanted and not self.worse


@dataclass(frozen=True)
class Speed:
    """What has been measured; parts that were not asked for are empty.

    Attributes
    ----------
    repeats : int
        Batches of each engine in each scene.
    races : tuple of Race
        One for each scene.
    piles : tuple of PileRace
        What has to hold, each engine with the least work that lets it.
    few_bodies : tuple of FewBodies
        The exact solver and pymunk at equal error.
    memory : Memory or None
        A body.
    start : Start or None
        Imports and first runs.
    """

    repeats: int
    races: tuple[Race, ...] = ()
    piles: tuple[PileRace, ...] = ()
    few_bodies: tuple[FewBodies, ...] = ()
    memory: Memory | None = None
    start: Start | None = None

    def verdicts(self, race: Race) -> list[Verdict]:
        """Return the ratios of one scene: each of ours against each peer."""
        found = []
        for ours in OURS:
            wanted = {t.peer: t for t in targets_of(race.key, ours)}
            for peer in PEERS:
                ratio = race.ratio(ours, peer)
                if ratio is not None:
                    target: Target | None = wanted.get(peer)
                    goal = None if target is None else target.ratio
                    worse = race.worse(ours, peer)
                    found.append(Verdict(race.key, ours, peer, ratio, worse, goal))
        return found

    def growth(self) -> dict[str, dict[str, float]]:
        """Return, by scene and engine, the exponent of the time from 1,000 bodies on."""
        found: dict[str, dict[str, float]] = {}
        for group in ("gas", "settled"):
            races = [race for race in self.races if race.key.split("-")[0] == group]
            races = [race for race in races if race.bodies >= GROWTH_FROM]
            for engine in (*OURS, *PEERS):
                timings = [race.timing(engine) for race in races]
                seconds = [timing.compared for timing in timings if timing is not None]
                if len(seconds) > 1:
                    sizes = [race.bodies for race in races]
                    found.setdefault(group, {})[engine] = growth_exponent(sizes, seconds)
        return found

    def limits(self) -> list[Limit]:
        """Return what is wanted besides the ratios of single scenes."""
        return [
            *growth_limits(self.growth()),
            *pile_limits(self.piles),
            *few_bodies_limits(self.few_bodies),
            *memory_limits(self.memory),
            *start_limits(self.start),
        ]

    def as_dict(self) -> dict[str, Any]:
        """Return all of it as one JSON object."""
        return {
            "version": VERSION,
            "command": "measure speed",
            "machine": machine(),
            "repeats": self.repeats,
            "scenes": [_race_as_dict(race, self.verdicts(race)) for race in self.races],
            "growth_exponents": self.growth(),
            "piles": [asdict(pile) for pile in self.piles],
            "few_bodies": [_few_as_dict(few) for few in self.few_bodies],
            "memory": None if self.memory is None else asdict(self.memory),
            "start": None if self.start is None else asdict(self.start),
            "limits": [_limit_as_dict(limit) for limit in self.limits()],
        }

    def as_tables(self) -> Iterator[Table]:
        """Yield tables: one for each kind of scene, then the rest."""
        groups = dict.fromkeys(race.key.split("-")[0] for race in self.races)
        for group in groups:
            yield self._table_of([r for r in self.races if r.key.split("-")[0] == group])
        growth = self.growth()
        if growth:
            yield _growth_table(growth)
        yield from map(_pile_table, self.piles)
        if self.few_bodies:
            yield _few_table(self.few_bodies)
        limits = self.limits()
        if limits:
            yield _limits_table(limits)

    def _table_of(self, races: list[Race]) -> Table:
        """Return the table of some scenes."""
        table = Table(
            Column("engine", no_wrap=True),
            *("us a step", "CPU", "overlap", "energy", "contacts", "pymunk/ours", "Box2D/ours"),
            title=", ".join(race.name for race in races),
            caption=RACE_CAPTION,
            box=SIMPLE_HEAD,
            padding=(0, 1, 0, 0),
        )
        for race in races:
            table.add_section()
            table.add_row(f"[bold]{race.name}", style="")
            verdicts = {(v.ours, v.peer): v for v in self.verdicts(race)}
            for timing in race.timings:
                against = [_verdict_text(verdicts.get((timing.engine, peer))) for peer in PEERS]
                table.add_row(*_timing_texts(timing), *against)
        return table


def machine() -> dict[str, Any]:
    """Return what the times depend on."""
    return {
        "python": platform.python_version(),
        "system": platform.platform(),
        "processor": platform.processor() or platform.machine(),
        "cores": usable_cores(),
        "packages": {name: _version(name) for name in PACKAGES},
    }


def machine_line() -> str:
    """Return the same in a line."""
    facts = machine()
    packages = ", ".join(f"{name} {version}" for name, version in facts["packages"].items())
    return f"{facts['cores']} cores, Python {facts['python']}, {packages}, {facts['system']}"


def _version(name: str) -> str | None:
    """Return the version of a package; None where it is not installed."""
    try:
        return importlib.metadata.version(name)
    except importlib.metadata.PackageNotFoundError:
        return None


def _race_as_dict(race: Race, verdicts: list[Verdict]) -> dict[str, Any]:
    """Return one scene as JSON can hold it."""
    return {
        **{key: value for key, value in asdict(race).items() if key != "timings"},
        "engines": [asdict(timing) for timing in race.timings],
        "ratios": [asdict(verdict) | {"reached": verdict.reached} for verdict in verdicts],
    }


def _few_as_dict(few: FewBodies) -> dict[str, Any]:
    """Return a scene of few bodies as JSON can hold it."""
    return asdict(few) | {
        "ratio_measured": few.ratio_measured,
        "ratio_extrapolated": few.ratio_extrapolated,
    }


def _limit_as_dict(limit: Limit) -> dict[str, Any]:
    """Return a limit as JSON can hold it."""
    return {
        "what": limit.what,
        "value": limit.value,
        "wanted": limit.wanted,
        "reached": limit.reached,
    }


def _timing_texts(timing: Timing) -> list[str]:
    """Return what one engine did in a scene, in words."""
    return [
        f"  {timing.engine}",
        _digits(timing.seconds * 1e6),
        f"{timing.cpu_seconds / timing.seconds:.0%}",
        f"{timing.quality.overlap:.4f}",
        f"{timing.quality.energy_error:.0e}",
        f"{timing.contacts_per_body:.2f}",
    ]


def _verdict_text(verdict: Verdict | None) -> str:
    """Return a ratio, what is wanted, and whether it is reached, in words."""
    if verdict is None:
        return ""
    text = _digits(verdict.ratio)
    if verdict.wanted is not None:
        text += f" of {verdict.wanted:g}" + (" ok" if verdict.reached else "")
    if verdict.worse:
        text += "\nworse " + "\nworse ".join(verdict.worse)
    return text


def _digits(value: float) -> str:
    """Return a number with three digits, large ones with all before the point.

    >>> _digits(0.01234), _digits(12.345), _digits(123456.7)
    ('0.0123', '12.3', '123,457')
    """
    if value == 0 or not math.isfinite(value):
        return str(value)
    return f"{value:,.{max(0, 2 - math.floor(math.log10(abs(value))))}f}"


def _growth_table(growth: dict[str, dict[str, float]]) -> Table:
    """Return the table of exponents."""
    engines = list(dict.fromkeys(engine for row in growth.values() for engine in row))
    table = Table(
        "time ~ bodies^p: p of",
        *engines,
        title="Growth from 1,000 bodies on",
    )
    for group, row in growth.items():
        table.add_row(group, *(f"{row[e]:.2f}" if e in row else "" for e in engines))
    return table


def _pile_table(pile: PileRace) -> Table:
    """Return the table of one pile that has to hold."""
    table = Table(
        *("engine", "iterations or sub-steps", "held", "overlap", "CPU ms", "this/our best"),
        title=f"Each with the least that it needs for {pile.name}",
    )
    ours = min((row.seconds for row in pile.rows if row.held and row.engine in OURS), default=None)
    for row in pile.rows:
        held = "yes" if row.held else "no"
        ratio = "" if ours is None or not row.held else _digits(row.seconds / ours)
        numbers = f"{row.overlap:.4f}", _digits(row.seconds * 1e3), ratio
        table.add_row(row.engine, str(row.setting), held, *numbers)
    return table


def _few_table(scenes: tuple[FewBodies, ...]) -> Table:
    """Return the table of few bodies."""
    table = Table(
        Column("scene", no_wrap=True),
        *("hits", "exact us", "error, m", "pymunk, steps/s", "ms", "error, m"),
        *("at least", "extrap."),
        box=SIMPLE_HEAD,
        padding=(0, 1, 0, 0),
        title="Few bodies: the exact solver and pymunk",
        caption=(
            "At least: pymunk's time over the exact solver's, though its error is still larger.\n"
            "Extrapolated: with a step so fine that the errors would be equal."
        ),
    )
    for few in scenes:
        table.add_section()
        ours = [few.name, str(few.collisions), _digits(few.exact_seconds * 1e6)]
        first = [*ours, f"{few.exact_error:.0e}"]
        rows = zip(few.steps_a_second, few.pymunk_seconds, few.pymunk_errors, strict=True)
        for rate, seconds, error in rows:
            theirs = [f"{rate:,}", _digits(seconds * 1e3), f"{error:.0e}"]
            last = rate == few.steps_a_second[-1]
            extrapolated = few.ratio_extrapolated
            told = "no order" if extrapolated is None else f"{extrapolated:.0e}"
            table.add_row(*first, *theirs, *([_digits(few.ratio_measured), told] if last else []))
            first = [""] * 4
    return table


def _limits_table(limits: list[Limit]) -> Table:
    """Return the table of what is wanted besides."""
    table = Table("what", "measured", "wanted", "reached", title="What is wanted besides")
    for limit in limits:
        reached = {True: "yes", False: "no", None: ""}[limit.reached]
        table.add_row(limit.what, _digits(limit.value), limit.wanted, reached)
    return table
