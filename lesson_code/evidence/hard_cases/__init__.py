"""Hard cases: scenes in which solvers go wrong, each with a law and a bound.

The catalogue has a module for each theme. A case is a scene, a measure, which is 0 for a perfect
result, and a bound, which was written before the case was run. The tests hold our solver to the
bounds; ``workbook measure hard-cases`` compares it with the others.
"""

from lesson_code.evidence.hard_cases.case import OURS, PEERS, HardCase, Outcome, Trial, run_case
from lesson_code.evidence.hard_cases.catalogue import CASES, by_theme, case_by_name
from lesson_code.evidence.hard_cases.comparison import (
    Comparison,
    installed_solvers,
    measure_hard_cases,
)

stored = Comparison.stored

__all__ = [
    "CASES",
    "OURS",
    "PEERS",
    "Comparison",
    "HardCase",
    "Outcome",
    "Trial",
    "by_theme",
    "case_by_name",
    "installed_solvers",
    "measure_hard_cases",
    "run_case",
    "stored",
]
