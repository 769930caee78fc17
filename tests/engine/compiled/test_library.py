"""The library of compiled programs: what is kept, found again, noticed and forgotten."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import lesson_code
from lesson_code.engine.compiled import library
from lesson_code.engine.compiled.library import (
    FOLDER_VARIABLE,
    PROGRAMS_KEPT,
    compiled_function,
    folder,
    is_kept,
    why_no_compiler,
)

pytest.importorskip("numba")

HOUSE = Path(lesson_code.__file__).parents[1]

SMALL = """from __future__ import annotations

SHARE = 0.5


def part(x: float) -> float:
    return SHARE * x


def entry(x: float) -> float:
    return part(x) + 1.0
"""
"""A program that is compiled in half a second."""


def started(code: str, house: Path = HOUSE) -> subprocess.Popen[str]:
    """Start a fresh Python process that finds the package in a house."""
    path = os.pathsep.join([str(house), *filter(None, sys.path)])
    return subprocess.Popen(
        [sys.executable, "-P", "-c", textwrap.dedent(code)],
        env=os.environ | {"PYTHONPATH": path},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def printed(process: subprocess.Popen[str]) -> list[str]:
    """Return the lines that a process has printed when it has ended well."""
    out, error = process.communicate()
    assert process.returncode == 0, error
    return out.splitlines()


LOAD = f"""
from lesson_code.engine.compiled.library import compiled_function, is_kept
source = {SMALL!r}
kept = is_kept(source)
entry = compiled_function(source, "entry")
stats = entry(4.0), kept, sum(entry.stats.cache_hits.values())
print(*stats)
"""


# What is kept


def test_program_that_was_compiled_is_loaded_in_a_fresh_process(place: Path) -> None:
    """The first compiles and keeps it, the second finds its machine code."""
    assert printed(started(LOAD)) == ["3.0 False 0"]
    assert is_kept(SMALL)
    assert printed(started(LOAD)) == ["3.0 True 1"]
    assert len(list(place.glob("*.py"))) == 1


def test_program_of_another_text_is_another_program(place: Path) -> None:
    """A constant in it is part of the text."""
    other = SMALL.replace("0.5", "0.25")
    assert compiled_function(SMALL, "entry")(4.0) == 3.0
    assert not is_kept(other)
    assert compiled_function(other, "entry")(4.0) == 2.0
    assert is_kept(SMALL)
    assert is_kept(other)
    assert len(list(place.glob("program_*.py"))) == 2


def test_program_is_written_as_it_was_linked(place: Path) -> None:
    """So that anybody can read what runs, and what is in place; nothing else is left beside it."""
    compiled_function(SMALL, "entry")
    [path] = [path for path in place.iterdir() if path.is_file()]
    assert path.read_text() == SMALL + "\n\nIN_PLACE = []\nMERGED = ['part']\n"


@pytest.mark.parametrize(("way", "names"), [("inlined", {"part"}), ("merged", set())])
def test_program_compiled_in_another_way_is_another_program(
    place: Path, monkeypatch: pytest.MonkeyPatch, way: str, names: set[str]
) -> None:
    """What stands in place of its calls makes other machine code of the same lines."""
    compiled_function(SMALL, "entry")(4.0)
    assert is_kept(SMALL)
    monkeypatch.setattr(library, way, lambda _: frozenset(names))
    assert not is_kept(SMALL)


def test_program_that_has_been_damaged_is_written_anew(place: Path) -> None:
    """Half a file, after a full disk."""
    compiled_function(SMALL, "entry")
    [path] = place.glob("program_*.py")
    path.write_text(SMALL[:50])
    compiled_function.cache_clear()
    assert compiled_function(SMALL, "entry")(4.0) == 3.0
    assert path.read_text().startswith(SMALL)


def test_function_is_loaded_once_in_a_process(place: Path) -> None:
    """Every run of a scene shares it."""
    assert compiled_function(SMALL, "entry") is compiled_function(SMALL, "entry")


def test_division_by_zero_is_what_numpy_makes_of_it(place: Path) -> None:
    """No exception: a compiled program has none, and plain code never divides by 0."""
    divide = compiled_function("def entry(x: float) -> float:\n    return 1.0 / x\n", "entry")
    assert divide(0.0) == float("inf")


# Where it is kept


def test_folder_is_the_users_unless_another_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    """Named by an environment variable."""
    monkeypatch.setenv(FOLDER_VARIABLE, "/somewhere/else")
    assert folder() == Path("/somewhere/else")
    monkeypatch.delenv(FOLDER_VARIABLE)
    assert folder().name == "collision-workbook"


def test_folder_that_cannot_be_written_to_only_costs_the_keeping(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The program is compiled for this process alone."""
    (tmp_path / "file").write_text("no folder can be here")
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path / "file" / "programs"))
    compiled_function.cache_clear()
    assert compiled_function(SMALL, "entry")(4.0) == 3.0
    assert not is_kept(SMALL)
    compiled_function.cache_clear()


def test_program_in_a_folder_that_has_become_read_only_is_compiled_anew(
    place: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It can be read, but Numba would refuse to look for machine code beside it."""
    compiled_function(SMALL, "entry")
    compiled_function.cache_clear()
    monkeypatch.setattr(library.os, "access", lambda *_: False)
    assert compiled_function(SMALL, "entry")(4.0) == 3.0
    assert not is_kept(SMALL)


def test_two_processes_at_once_keep_one_program(place: Path) -> None:
    """Each writes a file of its own and puts it in its place whole."""
    both = [started(LOAD) for _ in range(2)]
    assert [printed(process)[0].split()[0] for process in both] == ["3.0", "3.0"]
    assert [path.suffix for path in place.iterdir() if path.is_file()] == [".py"]
    assert printed(started(LOAD)) == ["3.0 True 1"]


def test_oldest_programs_are_forgotten(place: Path) -> None:
    """The source and its machine code; never more than PROGRAMS_KEPT are in the folder."""
    (place / "__pycache__").mkdir(parents=True)
    for age in range(PROGRAMS_KEPT + 3):
        path = place / f"program_{age:03}.py"
        path.write_text("")
        (place / "__pycache__" / f"program_{age:03}.entry-1.py311.1.nbc").write_text("")
        os.utime(path, (1e9 - age, 1e9 - age))
    (place / "mine.py").write_text("not a program")
    compiled_function(SMALL, "entry")
    names = {path.stem for path in place.glob("program_*.py")}
    assert len(names) == PROGRAMS_KEPT
    assert {f"program_{age:03}" for age in range(PROGRAMS_KEPT - 1)} < names
    codes = {path.name.split(".")[0] for path in (place / "__pycache__").glob("*.nbc")}
    assert codes <= names
    assert (place / "mine.py").exists()


# Without a compiler


def test_compiler_that_is_missing_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """In words that go into the plan of a run."""
    assert why_no_compiler() == ""
    monkeypatch.setitem(sys.modules, "numba", None)
    assert why_no_compiler() == "Numba is not installed"


NO_NUMBA = """
    import sys
    sys.modules["numba"] = None  # as if it were not installed
    from lesson_code import Body, Circle, Scene, simulate
    scene = Scene([Body(Circle(1), mass=1, position=(0, 3 * k)) for k in range(3)])
    run = simulate(scene, 1.0, solver="sequential")
    print(run.plan.headline)
    try:
        simulate(scene, 1.0, solver="sequential", compiled=True)
    except ValueError as error:
        print(error)
"""


def test_workbook_without_numba_runs_plain() -> None:
    """Nothing of it is needed; only who asks for compiled code is refused, and told why."""
    assert printed(started(NO_NUMBA)) == [
        "solver: sequential (asked for); plain Python (a small run)",
        "compiled must be False or None here: Numba is not installed",
    ]


HEAVY = ("numba", "matplotlib", "pygame", "pymunk", "IPython", "ipywidgets")

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
    """Numba, matplotlib, pygame and pymunk are loaded when they are used."""
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
    assert len(list(place.glob("program_*.py"))) == 2
