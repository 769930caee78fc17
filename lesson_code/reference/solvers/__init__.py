"""Engines that are not ours, as solvers; each file loads its engine only to run a scene."""

from __future__ import annotations

from typing import Any

from lesson_code.engine.core.solver import Request, Solver


def settings_of(asked: Request, solver: Solver) -> dict[str, Any]:
    """Return the options of a run for another engine, or refuse those of ours alone.

    It has one program for all scenes, and that is compiled.
    """
    for option in ("compiled", "effects"):
        if (value := getattr(asked, option)) is not None:
            raise ValueError(f"{option} must be None for {solver.name}, got {value!r}")
    counts = zip(("iterations", "substeps"), solver.counts(asked), strict=True)
    return {"dt": asked.dt, "combine": asked.combine, **dict(counts)}
