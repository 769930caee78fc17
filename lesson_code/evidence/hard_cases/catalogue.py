"""The catalogue: all hard cases, by theme."""

from __future__ import annotations

from lesson_code.evidence.hard_cases import (
    balance,
    bounces,
    fast,
    floors,
    impacts,
    loads,
    overlaps,
    steps,
    symmetry,
    together,
)
from lesson_code.evidence.hard_cases.case import HardCase

CASES: tuple[HardCase, ...] = (
    *loads.CASES,
    *balance.CASES,
    *impacts.CASES,
    *together.CASES,
    *steps.CASES,
    *bounces.CASES,
    *fast.CASES,
    *floors.CASES,
    *overlaps.CASES,
    *symmetry.CASES,
)
"""All cases, each once; those of a theme stand together."""


def case_by_name(name: str) -> HardCase:
    """Return a case by its name.

    Raises
    ------
    ValueError
        There is no such case.
    """
    for case in CASES:
        if case.name == name:
            return case
    raise ValueError(f"name must be one of {', '.join(c.name for c in CASES)}, got {name!r}")


def by_theme(cases: tuple[HardCase, ...] = CASES) -> dict[str, list[HardCase]]:
    """Return the cases of each theme, in the order of the catalogue."""
    themes: dict[str, list[HardCase]] = {}
    for case in cases:
        themes.setdefault(case.theme, []).append(case)
    return themes
