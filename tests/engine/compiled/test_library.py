"""The library of compiled programs: what is kept, found again, noticed and forgotten."""

from __future__ import annotations

import json
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from processes import HOUSE, printed, started
from small_program import SOURCE, numbers, small_program

from lesson_code.engine.compiled import library
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.compiled.library import (
    FOLDER_VARIABLE,
    PROGRAMS_KEPT,
    folder,
    is_kept,
    load,
    name_of,
    why_no_compiler,
)

pytest.importorskip("numba")

LOAD = """
import sys
from small_program import numbers, small_program
from lesson_code.engine.compiled.compiler import compiled
from lesson_code.engine.compiled.library import is_kept
kept = is_kept(small_program())
print(compiled(small_program())(numbers(4.0, 2.0)), kept, "numba" in sys.modules)
"""


# What is kept


def test_program_that_was_compiled_is_loaded_in_a_fresh_process(place: Path) -> None:
    """The first has it made and kept, the second finds it; neither imports Numba."""
    assert printed(started(LOAD)) == ["3.0 False False"]
    assert is_kept(small_program())
    assert printed(started(LOAD)) == ["3.0 True False"]
    assert [path.name for path in place.iterdir()] == [name_of(small_program())]


WITHOUT_NUMBA = 'import sys\nsys.modules["numba"] = None\n'
WITHOUT_LLVM = WITHOUT_NUMBA + 'sys.modules["llvmlite"] = None\n'


@pytest.fixture
def has_linker() -> None:
    """Skip a test where there is no linker, or no way to load what it makes."""
    if shutil.which("cc") is None or not hasattr(os, "memfd_create"):
        pytest.skip("no shared library is made here")


@pytest.fixture
def no_linker(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let no linker be found."""
    monkeypatch.setenv("PATH", "")


def test_program_that_is_linked_runs_without_llvm(place: Path, has_linker: None) -> None:
    """The system loads it, as any other shared library; nothing of Numba need be installed."""
    compiled(small_program())
    assert printed(started(WITHOUT_LLVM + LOAD)) == ["3.0 True True"]


def test_program_that_is_not_linked_runs_without_numba(place: Path, no_linker: None) -> None:
    """Nothing but LLVM is needed to run it, and without LLVM it counts as not kept."""
    compiled(small_program())
    assert printed(started(WITHOUT_NUMBA + LOAD)) == ["3.0 True True"]
    is_kept_there = WITHOUT_LLVM + LOAD.partition("print")[0] + "print(kept)"
    assert printed(started(is_kept_there)) == ["False"]


def test_program_of_another_text_is_another_program(place: Path) -> None:
    """A constant in it is part of the text."""
    other = small_program(SOURCE.replace("0.5", "0.25"))
    assert compiled(small_program())(numbers(4.0)) == 2.0
    assert not is_kept(other)
    assert compiled(other)(numbers(4.0)) == 1.0
    assert is_kept(small_program())
    assert is_kept(other)


@pytest.mark.parametrize(
    ("name", "value"),
    [("_compiler", lambda: b"other lines"), ("COMPILER", ("linker.py",))],
)
def test_program_compiled_in_another_way_is_another_program(
    place: Path, monkeypatch: pytest.MonkeyPatch, name: str, value: object
) -> None:
    """The lines that say how a program is compiled are part of its name."""
    compiled(small_program())
    assert is_kept(small_program())
    for remembered in (library.name_of, library.sum_over, library._compiler):
        remembered.cache_clear()
    monkeypatch.setattr(library, name, value)
    assert not is_kept(small_program())
    library.name_of.cache_clear()
    library.sum_over.cache_clear()
    getattr(library._compiler, "cache_clear", lambda: None)()


def other_maker(about: dict[str, object]) -> None:
    """Say that another version of Numba has made a program."""
    about["made by"] = {**about["made by"], "numba": "0.1"}  # type: ignore[dict-item]


def other_system(about: dict[str, object]) -> None:
    """Say that a program calls what this system does not have."""
    about["needs"] = ["no_such_function_anywhere"]


def other_file(about: dict[str, object]) -> None:
    """Say that an object file is a shared library, which it is not."""
    about["is a library"] = True


@pytest.mark.one_in(3)
@pytest.mark.parametrize("change", [other_maker, other_system, other_file])
def test_program_from_elsewhere_is_not_loaded(
    place: Path, no_linker: None, change: Callable[[dict[str, object]], None]
) -> None:
    """Its first line says what made it, and what it calls."""
    compiled(small_program())
    library.forget_loaded()
    path = place / name_of(small_program())
    first, _, code = path.read_bytes().partition(b"\n")
    about = json.loads(first)
    change(about)
    path.write_bytes(json.dumps(about).encode() + b"\n" + code)
    assert load(small_program()) is None
    assert compiled(small_program())(numbers(4.0)) == 2.0


DAMAGE: dict[str, Callable[[bytes], bytes]] = {
    "empty": lambda text: text[:0],
    "cut off": lambda text: text[: len(text) // 2],
    "one bit": lambda text: text[:-100] + bytes([text[-100] ^ 1]) + text[-99:],
    "no first line": lambda text: text.partition(b"\n")[2],
    "something else": lambda text: b'["a list"]\n' + text,
}


@pytest.mark.one_in(5)
@pytest.mark.parametrize("damage", DAMAGE.values(), ids=DAMAGE)
def test_file_that_is_damaged_is_made_anew_and_never_run(
    place: Path, damage: Callable[[bytes], bytes]
) -> None:
    """Half a file after a full disk, a flipped bit, another's file under this name."""
    compiled(small_program())
    library.forget_loaded()
    path = place / name_of(small_program())
    whole = path.read_bytes()
    path.write_bytes(damage(whole))
    assert not is_kept(small_program())
    assert compiled(small_program())(numbers(4.0)) == 2.0
    assert path.read_bytes() == whole


def test_machine_code_is_loaded_once_in_a_process(place: Path) -> None:
    """Every run of a scene shares it, also when the file is gone."""
    compiled(small_program())
    shutil.rmtree(place)
    assert compiled(small_program())(numbers(4.0)) == 2.0
    assert not place.exists()


# Where it is kept


def test_folder_is_the_users_unless_another_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Named by an environment variable."""
    monkeypatch.setenv(FOLDER_VARIABLE, "/somewhere/else")
    assert folder() == Path("/somewhere/else")
    monkeypatch.delenv(FOLDER_VARIABLE)
    assert folder().name == "collision-workbook"


def test_folder_that_cannot_be_written_to_only_costs_the_keeping(
    place: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The program is compiled for this process alone."""
    (tmp_path / "file").write_text("no folder can be here")
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "file" / "programs"))
    assert compiled(small_program())(numbers(4.0)) == 2.0
    library.forget_loaded()
    assert is_kept(small_program())  # here
    assert printed(started(LOAD)) == ["3.0 False False"]  # and not in another process


def test_program_in_a_folder_that_has_become_read_only_is_still_loaded(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only what is new cannot be kept there."""
    compiled(small_program())
    library.forget_loaded()
    place.chmod(0o500)
    monkeypatch.setattr(library, "place_to_write", lambda: pytest.fail("written for nothing"))
    assert compiled(small_program())(numbers(4.0)) == 2.0
    place.chmod(0o700)


def test_oldest_programs_are_forgotten(place: Path) -> None:
    """And what a killed process has left; never more than PROGRAMS_KEPT are in the folder."""
    place.mkdir()
    for age in range(PROGRAMS_KEPT + 3):
        path = place / f"program_{age:03}{'.tmp' if age % 9 == 0 else ''}"
        path.write_text("")
        os.utime(path, (1e9 - age, 1e9 - age))
    (place / "mine").write_text("not a program")
    compiled(small_program())
    names = {path.name for path in place.glob("program_*")}
    assert PROGRAMS_KEPT - 1 <= len(names) <= PROGRAMS_KEPT  # a lock has counted, too
    assert {f"program_{age:03}" for age in range(PROGRAMS_KEPT - 2) if age % 9} < names
    assert name_of(small_program()) in names
    assert (place / "mine").exists()


# Without a compiler


def test_compiler_that_is_missing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """In words that go into the plan of a run."""
    assert why_no_compiler() == ""
    monkeypatch.setitem(sys.modules, "numba", None)
    assert why_no_compiler() == "Numba is not installed"


NO_NUMBA = """
    import sys
    sys.modules["numba"] = None  # as if it were not installed
    sys.modules["llvmlite"] = None
    from lesson_code import Body, Circle, Scene, simulate
    scene = Scene([Body(Circle(1), mass=1, position=(0, 3 * k)) for k in range(3)])
    run = simulate(scene, 1.0, solver="sequential")
    print(run.plan.headline)
    try:
        simulate(scene, 1.0, solver="sequential", compiled=True)
    except ValueError as error:
        print(error)
"""


def test_workbook_without_numba_runs_plain(place: Path) -> None:
    """Nothing of it is needed; only who asks for compiled code is refused, and told why."""
    assert printed(started(NO_NUMBA)) == [
        "solver: sequential (asked for); plain Python (a small run)",
        "compiled must be False or None here: Numba is not installed",
    ]


HEAVY = ("numba", "llvmlite", "matplotlib", "pygame", "pymunk", "IPython", "ipywidgets")

IMPORTS = f"""
    import sys
    import lesson_code
    heavy = {HEAVY!r}
    print(*[name for name in heavy if name in sys.modules], "imported")
    from lesson_code import Body, Circle, Scene, simulate
    simulate(Scene([Body(Circle(1), mass=1)]), 1.0)
    simulate(Scene([Body(Circle(1), mass=1)]), 1.0, solver="substep")
    print(*[name for name in heavy if name in sys.modules], "run")
"""


def test_import_and_small_runs_load_nothing_heavy() -> None:
    """They are loaded when they are used."""
    assert printed(started(IMPORTS)) == ["imported", "run"]


# Changes of the source

OVERLAPPING = """
    import sys
    from lesson_code import Body, Circle, Material, Scene, simulate
    discs = [Body(Circle(0.5), mass=1, position=(x, 0), material=Material(0.5)) for x in (0, 0.9)]
    scene = Scene(discs, gravity=(0, -10), damping=0.3)
    for compiled in (True, False):
        run = simulate(scene, 0.1, solver="sequential", compiled=compiled, sample="end")
        print(*((state[-1] + 0.0).tobytes().hex() for state in (run.positions, run.velocities)))
"""
"""Discs without corners make the smallest program, which is compiled in 4 s."""

EDITS = {
    "a constant": ("core/constants.py", "BAUMGARTE_FACTOR = 0.2\n", "BAUMGARTE_FACTOR = 0.25\n"),
    "a stage": ("effects/damping.py", "-world.state.damping *", "-2.0 * world.state.damping *"),
}


@pytest.mark.full
def test_change_of_any_stage_or_constant_is_noticed(tmp_path: Path, place: Path) -> None:
    """In another file than that of the function that is called; by the next process."""
    house = tmp_path / "house"
    package = house / "lesson_code"
    leave_out = shutil.ignore_patterns("__pycache__")
    shutil.copytree(HOUSE / "lesson_code", package, ignore=leave_out)
    compiled, plain = printed(started(OVERLAPPING, house))
    assert compiled == plain
    for name, old, new in EDITS.values():
        path = package / "engine" / name
        text = path.read_text()
        assert text.count(old) == 1
        path.write_text(text.replace(old, new))
    compiled_after, plain_after = printed(started(OVERLAPPING, house))
    assert compiled_after == plain_after
    places, velocities = zip(plain.split(), plain_after.split(), strict=True)
    assert places[0] != places[1]  # the push
    assert velocities[0] != velocities[1]  # the damping
    assert len(list(place.glob("program_*"))) == 2
