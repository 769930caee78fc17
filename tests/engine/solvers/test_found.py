"""Solvers are found by being there: one file makes one."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

import pytest

from lesson_code import Body, Circle, Scene, simulate, simulation
from lesson_code.engine.solvers import our_solvers, solvers_in

FORGETFUL = '''
"""Sequential impulses that remember nothing."""
from lesson_code.engine.core.solver import Solver
from lesson_code.engine.solvers.naive import store, warm_start
from lesson_code.engine.solvers.sequential import SOLVER as USUAL

SOLVER = Solver(
    name="forgetful",
    stages=USUAL.stages._replace(warm_start=warm_start, store=store),
    lacks={"warm_starting": "the forgetful solver remembers nothing"},
)
'''


def test_solvers_are_ours_and_other_engines() -> None:
    """Their names, in the order of the alphabet, ours first."""
    ours = ["direct", "exact", "naive", "sequential", "substep"]
    assert list(our_solvers()) == ours
    assert list(simulation.SOLVERS) == [*ours, "box2d", "pymunk"]


def test_new_solver_is_one_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is found, runs a scene, and says in the plan what it lacks."""
    (tmp_path / "more_solvers").mkdir()
    (tmp_path / "more_solvers" / "__init__.py").touch()
    (tmp_path / "more_solvers" / "forgetful.py").write_text(FORGETFUL)
    (tmp_path / "more_solvers" / "shared.py").touch()  # no solver: it has no SOLVER
    monkeypatch.syspath_prepend(str(tmp_path))
    found = solvers_in(importlib.import_module("more_solvers"))
    assert list(found) == ["forgetful"]
    monkeypatch.setitem(our_solvers(), "forgetful", found["forgetful"])
    monkeypatch.setitem(simulation.SOLVERS, "forgetful", found["forgetful"])
    monkeypatch.setattr(simulation, "NAMES", (*simulation.NAMES, "forgetful"))
    discs = [Body(Circle(1), mass=1.0, position=(3 * k, 0), velocity=(-k, 0)) for k in (0, 1)]
    run = simulate(Scene(discs), 2.0, solver="forgetful")
    assert run.velocities[-1, :, 0].tolist() == [-0.5, -0.5]
    assert run.plan.effect("warm_starting").reason == "the forgetful solver remembers nothing"
    for name in ("more_solvers", "more_solvers.forgetful", "more_solvers.shared"):
        monkeypatch.delitem(sys.modules, name)
