"""The programs that come ready-made: those that runs ask for; `workbook open` has them finished."""

from __future__ import annotations

import importlib

import pytest
from small_program import small_program

from lesson_code import MixingRule, Scene, simulate
from lesson_code.engine.compiled import choice, library
from lesson_code.engine.event_driven import ExactSolver
from lesson_code.engine.live_solver import stepper_for
from lesson_code.evidence import common_programs as common
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import falling_discs


def test_common_programs_are_those_that_runs_ask_for(
    monkeypatch: pytest.MonkeyPatch, tmp_path: object
) -> None:
    """The default call's, with a gas and a pile, long and short; and those of live worlds."""
    monkeypatch.setattr(choice, "LOAD_SECONDS", 0.0)
    asked: list[object] = []
    monkeypatch.setattr(library, "load", asked.append)
    monkeypatch.setattr(choice.Code, "_compile_if_long", lambda *_: "")
    for scene, duration in ((gas_of(99, 0.2, seed=7), 0.1), (falling_discs(99), 0.1)):
        simulate(scene, duration)
    simulate(falling_discs(99), 1.1, sample="end")
    programs = common.common_programs()
    names = [name for name, program in programs.items() if program in asked]
    assert names == ["exact", "substep", "substep_with_sleep"]
    usual = {"dt": 1.0, "iterations": None, "combine": MixingRule(), "compiled": False}
    for solver in ("substep", "sequential"):
        assert stepper_for(Scene([]), solver, **usual).program() == programs[solver]
    live = ExactSolver(gas_of(99, 0.2, seed=7), combine=MixingRule(), compiled=None)
    live.close()
    assert asked[-1] == programs["exact"]
    assert set(common.LIVE) == {"exact", "substep"}


def test_programs_that_are_kept_are_not_made_again(
    tmp_path: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next time the workbook is opened there is nothing to do."""
    pytest.importorskip("numba")
    library.forget_loaded()
    monkeypatch.setenv(library.FOLDER_VARIABLE, str(tmp_path))
    monkeypatch.setattr(common, "common_programs", lambda: {"small": small_program()})
    assert common.programs_to_compile() == [small_program()]
    common.compile_in_background([small_program()])
    assert common.programs_to_compile() == common.programs_to_compile("small") == []


def test_menu_has_the_programs_finished_that_worlds_go_on_by(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Those of discs that fly, and of all others."""
    playing = importlib.import_module("lesson_code.cli.playing")
    compiled: list[object] = []
    monkeypatch.setattr(common, "compile_in_background", compiled.extend)
    monkeypatch.setattr(common, "is_kept", lambda _: False)
    monkeypatch.setattr(common, "why_no_compiler", str)
    playing._prepare()
    programs = common.common_programs()
    assert compiled == [programs["exact"], programs["substep"]]


def test_nothing_is_made_where_nothing_can_be(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without Numba."""
    monkeypatch.setattr(common, "why_no_compiler", lambda: "Numba is not installed")
    assert common.programs_to_compile() == common.programs_to_compile("exact") == []


def test_open_says_what_is_made(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Once, and not where all is kept."""
    opening = importlib.import_module("lesson_code.cli.opening")
    compiled: list[object] = []
    monkeypatch.setattr(common, "compile_in_background", compiled.extend)
    for programs in ([small_program()], []):
        monkeypatch.setattr(common, "programs_to_compile", lambda programs=programs: programs)
        opening._prepare()
    assert compiled == [small_program()]
    line = "Programs of large runs are compiled in the background, once: 1"
    assert capsys.readouterr().out.splitlines() == [line]
