"""Hard cases: families of scenes in which solvers go wrong, each with a law and a bound.

A family draws its parameters by a seed, runs the scene that they describe, and measures how far
the result is from what a law says; 0 is right. Its bound was written before it was run. Every
engine runs the same draws, ours with ``simulate(scene, duration)`` and nothing else. There is a
module for each theme. ``workbook measure hard-cases`` compares the engines.
"""

from lesson_code.evidence.hard_cases.catalogue import FAMILIES, by_theme, family_by_name
from lesson_code.evidence.hard_cases.comparison import Comparison, Replay, Result, summed_up
from lesson_code.evidence.hard_cases.measure import installed_engines, measure_hard_cases, replay
from lesson_code.evidence.hard_cases.parameters import Draw, seeded
from lesson_code.evidence.hard_cases.trial import (
    ENGINES,
    OURS,
    PEERS,
    SWEEPS,
    Family,
    Outcome,
    Trial,
    family,
    run_draw,
    run_drawn,
)

stored = Comparison.stored

__all__ = [
    "ENGINES",
    "FAMILIES",
    "OURS",
    "PEERS",
    "SWEEPS",
    "Comparison",
    "Draw",
    "Family",
    "Outcome",
    "Replay",
    "Result",
    "Trial",
    "by_theme",
    "family",
    "family_by_name",
    "installed_engines",
    "measure_hard_cases",
    "replay",
    "run_draw",
    "run_drawn",
    "seeded",
    "stored",
    "summed_up",
]
