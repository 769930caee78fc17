"""The programs that `workbook open` has compiled: those that runs ask for, and none twice."""

from __future__ import annotations

import importlib

import pytest
from small_program import small_program

from lesson_code import simulate
from lesson_code.engine.compiled import library
from lesson_code.engine.live_solver import program_for
from lesson_code.evidence import common_programs as common
from lesson_code.evidence.scenes.gas import gas_of


def test_common_programs_are_those_of_runs_of_their_kind() -> None:
    """Whatever the number of bodies, and however long they run."""
    programs = list(common.common_programs())
    assert len(set(programs)) == len(programs)
    assert simulate(gas_of(50, 0.2, seed=7), 0.1).plan.source() == programs[0].source
    assert common.stepped(common.falling_discs(101)) == programs[1]


def test_programs_that_are_kept_are_not_compiled_again(
    tmp_path: object, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The next time the workbook is opened there is nothing to do."""
    pytest.importorskip("numba")
    library.forget_loaded()
    monkeypatch.setenv(library.FOLDER_VARIABLE, str(tmp_path))
    monkeypatch.setattr(common, "common_programs", lambda: iter([small_program()]))
    assert common.programs_to_compile() == [small_program()]
    common.compile_in_background([small_program()])
    assert common.programs_to_compile() == []


def test_menu_has_the_programs_compiled_that_worlds_go_on_by(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Those of discs that fly, and of all others: a part of what `open` has compiled."""
    live = list(common.live_programs())
    assert live[1:] == [program_for("substep")]
    assert set(live) < set(common.common_programs())
    playing = importlib.import_module("lesson_code.cli.playing")
    compiled: list[object] = []
    monkeypatch.setattr(common, "compile_in_background", compiled.extend)
    monkeypatch.setattr(common, "live_programs", lambda: iter([small_program()]))
    monkeypatch.setattr(common, "is_kept", lambda _: False)
    monkeypatch.setattr(common, "why_no_compiler", str)
    playing._prepare()
    assert compiled == [small_program()]


def test_nothing_is_compiled_where_nothing_can_be(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without Numba."""
    monkeypatch.setattr(common, "why_no_compiler", lambda: "Numba is not installed")
    assert common.programs_to_compile() == common.live_programs_to_compile() == []


def test_open_says_what_is_compiled(
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
