"""The solvers, one file each, and what they share.

A file with a value `SOLVER` is a solver, and is found by being here. What all can be asked, and
what a new one has to say about itself, stands in :mod:`lesson_code.engine.core.solver`.
"""

from __future__ import annotations

import pkgutil
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from lesson_code.engine.core.solver import Solver


def solvers_in(package: ModuleType) -> dict[str, Solver]:
    """Return the solvers of the modules in a package by their names, in alphabetical order."""
    found = (
        getattr(import_module(f"{package.__name__}.{file.name}"), "SOLVER", None)
        for file in pkgutil.iter_modules(package.__path__)
    )
    return {solver.name: solver for solver in found if solver is not None}


@cache
def our_solvers() -> dict[str, Solver]:
    """Return the solvers of this package by their names."""
    return solvers_in(import_module(__name__))
