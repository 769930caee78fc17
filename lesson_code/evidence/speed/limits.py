"""What is wanted besides the ratios of single scenes, and whether it is reached."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from lesson_code.evidence.speed.few_bodies import FewBodies
from lesson_code.evidence.speed.piles import PileRace
from lesson_code.evidence.speed.processes import Memory, Start
from lesson_code.evidence.speed.targets import (
    FEW_BODIES_RATIO,
    MOST_BYTES,
    MOST_GROWTH,
    MOST_SECONDS,
    PILE_RATIOS,
)


@dataclass(frozen=True)
class Limit:
    """A number, and what it is to be at least or at most.

    Attributes
    ----------
    what : str
        In words, with the unit.
    value : float
        What was measured.
    least, most : float
        The limits; infinite where there is none.
    """

    what: str
    value: float
    least: float = -math.inf
    most: float = math.inf

    @property
    def wanted(self) -> str:
        """What is wanted, in words; "" for nothing."""
        if math.isfinite(self.least):
            return f"at least {self.least:,g}"
        return f"at most {self.most:,g}" if math.isfinite(self.most) else ""

    @property
    def reached(self) -> bool | None:
        """Whether it is reached; None: nothing is wanted.

        >>> Limit("time, s", 0.2, most=0.3).reached, Limit("a number", 7.0).reached
        (True, None)
        """
        return self.least <= self.value <= self.most if self.wanted else None


def growth_limits(growth: Mapping[str, Mapping[str, float]]) -> Iterator[Limit]:
    """Yield the exponents of our sequential solver."""
    for group, exponents in growth.items():
        if "sequential" in exponents:
            what = f"exponent of the time over the bodies, {group}"
            yield Limit(what, exponents["sequential"], most=MOST_GROWTH)


def pile_limits(piles: tuple[PileRace, ...]) -> Iterator[Limit]:
    """Yield each peer's time over ours, each with the least work that lets a pile hold."""
    for pile in piles:
        for peer, wanted in PILE_RATIOS[pile.key].items():
            ratio = pile.ratio(peer)
            if ratio is not None:
                yield Limit(f"{pile.key}, {peer}'s time over ours", ratio, least=wanted)


def few_bodies_limits(scenes: tuple[FewBodies, ...]) -> Iterator[Limit]:
    """Yield what is measured of the ratios at equal error: lower bounds."""
    for few in scenes:
        what = f"{few.name}, pymunk's time over the exact one's"
        yield Limit(what, few.ratio_measured, least=FEW_BODIES_RATIO)


def memory_limits(memory: Memory | None) -> Iterator[Limit]:
    """Yield bytes a body."""
    if memory is None:
        return
    yield Limit(f"our tables for {memory.bodies:,} discs, bytes each", memory.ours, most=MOST_BYTES)
    if memory.pymunk is not None:
        yield Limit("pymunk's growth of the process for them, bytes each", memory.pymunk)


def start_limits(start: Start | None) -> Iterator[Limit]:
    """Yield seconds until something runs."""
    if start is None:
        return
    loads = ", ".join(start.loaded)
    what = "import lesson_code.simulation, s" + (f" (loads {loads})" if loads else "")
    yield Limit(what, start.importing, most=MOST_SECONDS["import"])
    if start.cold is not None and start.kept is not None:
        yield Limit("first compiled run, nothing kept, s", start.cold, most=MOST_SECONDS["cold"])
        yield Limit("first compiled run, programs kept, s", start.kept, most=MOST_SECONDS["kept"])
