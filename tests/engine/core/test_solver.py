"""What can be asked of a solver: its stages for some choices, its sweeps and sub-steps."""

from __future__ import annotations

from typing import Any

import pytest

from lesson_code import MixingRule, Scene
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers.impact_rules import STRIKE_RULES


def request(**asked: Any) -> Request:
    """Return a run that is asked for, with the usual settings but for some."""
    usual: dict[str, Any] = {
        "scene": Scene(), "duration": 1.0, "dt": 0.1, "iterations": None, "substeps": None,
        "combine": MixingRule(), "effects": None, "compiled": None, "options": {}, "sample": None,
    }  # fmt: skip
    return Request(**(usual | asked))


def counts(name: str, **asked: Any) -> tuple[int, int]:
    """Return the sweeps and sub-steps that a solver makes."""
    return our_solvers()[name].counts(request(**asked))


def test_sweeps_and_sub_steps_are_the_solvers_unless_given() -> None:
    """10 and 1 for most; 1 and 4 with sub-steps."""
    assert counts("sequential") == (10, 1)
    assert counts("substep") == (1, 4)
    assert counts("substep", iterations=2, substeps=8) == (2, 8)


@pytest.mark.parametrize("name", ["naive", "direct"])
def test_solver_of_one_sweep_makes_one_whatever_is_asked_for(name: str) -> None:
    """Sub-steps it makes as many as are given."""
    assert counts(name, iterations=50, substeps=3) == (1, 3)


def test_stages_are_those_of_the_options() -> None:
    """What is not given is what every solver does."""
    direct = our_solvers()["direct"]

    def rule(**options: str) -> object:
        return direct.stages_for(options).prepare.keywords["rule"]  # type: ignore[attr-defined]

    assert rule() is rule(impacts="simultaneous") is STRIKE_RULES["simultaneous", "energetic"]
    assert rule(restitution_law="newton") is STRIKE_RULES["simultaneous", "newton"]


def test_solver_without_stages_has_none_to_give() -> None:
    """It runs a scene by itself."""
    with pytest.raises(ValueError, match="solver must be one that the engine steps, got 'other'"):
        Solver(name="other").stages_for({})
