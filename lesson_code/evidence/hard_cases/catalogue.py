"""The catalogue: all families of hard cases, by theme."""

from __future__ import annotations

from collections.abc import Iterable

from lesson_code.evidence.hard_cases import (
    balance,
    bounces,
    carried,
    collisions,
    fast,
    heaps,
    loads,
    outlines,
    overlaps,
    rods,
    slopes,
    stacks,
    steps,
    symmetry,
    together,
)
from lesson_code.evidence.hard_cases.trial import Family

THEMES = (
    loads,
    stacks,
    balance,
    outlines,
    slopes,
    collisions,
    rods,
    bounces,
    together,
    heaps,
    fast,
    overlaps,
    carried,
    steps,
    symmetry,
)
"""A module for each theme, in the order of the table."""

FAMILIES: tuple[Family, ...] = tuple(
    value
    for module in THEMES
    for value in vars(module).values()
    if isinstance(value, Family) and value.measure.__module__ == module.__name__
)
"""All families, each once, in the order in which they are defined."""


def family_by_name(name: str) -> Family:
    """Return a family by its name.

    Raises
    ------
    ValueError
        There is no such family.
    """
    for family in FAMILIES:
        if family.name == name:
            return family
    raise ValueError(f"name must be one of {', '.join(f.name for f in FAMILIES)}, got {name!r}")


def by_theme(families: Iterable[Family] = FAMILIES) -> dict[str, list[Family]]:
    """Return the families of each theme, in the order of the catalogue."""
    themes: dict[str, list[Family]] = {}
    for family in families:
        themes.setdefault(family.theme, []).append(family)
    return themes
