"""What a run is made in: by seconds, by what is asked for, and by what is possible and kept."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest
from processes import printed, started
from small_program import small_program

from lesson_code import Body, Callbacks, Circle, Scene, Segment, simulate
from lesson_code.engine.compiled import Code, Program, choice, compiler
from lesson_code.engine.compiled import library as library_module
from lesson_code.engine.compiled.choice import PART, Choice
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.stepper import why_never
from lesson_code.evidence.scenes.gas import gas_of

LOADING, COMPILING = 0.1, 6.0
"""s, as the tests have it."""


def unlooked() -> Program:
    """Stand for a program that nobody may ask for."""
    pytest.fail("linked for nothing")


class Library:
    """What is kept and what is being compiled, in place of files and processes."""

    def __init__(self) -> None:
        self.kept = self.is_over = False
        self.begun: list[Program] = []
        self.left: list[bool] = []
        self.seconds = 0.0

    def load(self, _: Program) -> str | None:
        """Return what stands for machine code."""
        return "machine code" if self.kept else None

    def begin(self, program: Program, *, in_background: bool) -> _Process:
        """Begin to compile."""
        assert in_background
        self.begun.append(program)
        return _Process(program, self)


class _Process:
    """One that is over when the library says so."""

    def __init__(self, program: Program, told: Library) -> None:
        self.program, self._told = program, told

    @property
    def seconds(self) -> float:
        """For how long it has been at work."""
        return self._told.seconds

    def is_over(self) -> bool:
        """Return whether it has ended."""
        return self._told.is_over

    def leave(self, *, to_finish: bool) -> None:
        """Let it end."""
        self._told.left.append(to_finish)


@pytest.fixture
def library(monkeypatch: pytest.MonkeyPatch) -> Library:
    """Return the library on a machine of known speed, where Numba is installed."""
    told = Library()
    for module, name, value in (
        (library_module, "load", told.load),
        (library_module, "why_no_compiler", lambda: ""),
        (compiler, "Compiling", told.begin),
        (compiler, "compiled", lambda _: "just compiled"),
        (choice, "slowness", lambda: 1.0),
        (choice, "load_seconds", lambda: LOADING),
        (choice, "compile_seconds", lambda _: COMPILING),
        (choice, "LOOK_SECONDS", 0.0),
    ):
        monkeypatch.setattr(module, name, value)
    return told


# At the start


@pytest.mark.parametrize(
    ("seconds", "is_kept", "entry", "expected"),
    [
        (0.9 * LOADING, True, None, ("plain Python", "a small run")),
        (LOADING, True, "machine code", ("compiled", "its machine code was kept")),
        (
            0.9 * PART * COMPILING, False, None,
            ("plain Python", "a run too small to wait for a compiler"),
        ),
        (
            PART * COMPILING, False, None,
            ("plain Python", "its machine code is still being made"),
        ),
    ],
)  # fmt: skip
def test_run_is_made_in_what_takes_least(
    library: Library, seconds: float, is_kept: bool, entry: str | None, expected: tuple[str, str]
) -> None:
    """What is kept is used if that pays; what is not is made beside a run that is long enough."""
    library.kept = is_kept
    code = Code(None)
    assert code.begin(small_program, seconds) == entry
    assert code.choice == expected
    assert len(library.begun) == ("being made" in code.choice.reason)


def test_seconds_are_those_of_this_machine(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On one that is ten times slower, a tenth of the work is worth it."""
    library.kept = True
    monkeypatch.setattr(choice, "slowness", lambda: 10.0)
    assert Code(None).begin(small_program, 0.11 * LOADING) == "machine code"


def test_program_of_a_small_run_is_not_even_linked(library: Library) -> None:
    """Small scenes never wait; nor do those that are to be plain."""
    assert Code(None).begin(unlooked, 0.0) is None
    code = Code(False)
    assert code.begin(unlooked, 1e6) is code.look(unlooked, math.inf, "step 2") is None
    assert code.choice == Choice("plain Python", "asked for")


@pytest.mark.parametrize(("is_kept", "entry"), [(True, "machine code"), (False, "just compiled")])
def test_run_that_is_asked_to_be_compiled_is(library: Library, is_kept: bool, entry: str) -> None:
    """However small, and though it has to wait."""
    library.kept = is_kept
    code = Code(True)
    assert code.begin(small_program, 0.0) == entry
    assert code.choice == Choice("compiled", "asked for")
    assert not code.may_change


# On the way


def test_run_goes_on_compiled_when_its_machine_code_is_there(library: Library) -> None:
    """It says from where on."""
    code = Code(None)
    assert code.begin(small_program, math.inf) is None
    assert code.look(unlooked, 1.0, "step 7") is None
    library.kept = library.is_over = True
    assert code.look(unlooked, 1.0, "step 8") == "machine code"
    assert code.choice == (
        "plain Python, compiled from step 8 on",
        "it was compiled meanwhile",
    )
    code.close()
    assert library.left == [False]


def test_run_that_needs_another_program_tells_from_where_on_it_is_compiled(
    library: Library,
) -> None:
    """From the start, if it was; else from when the first machine code was there."""
    code = Code(None)
    code.begin(unlooked, 0.0)
    library.kept = True
    assert code.begin(small_program, math.inf, "step 5") == "machine code"
    assert code.begin(small_program, math.inf, "step 9") == "machine code"
    assert code.choice.code == "plain Python, compiled from step 5 on"
    always = Code(None)
    for now in ("", "step 9"):
        always.begin(small_program, math.inf, now)
    assert always.choice.code == "compiled"


def test_run_that_turns_out_to_be_long_is_looked_at_again(library: Library) -> None:
    """Though it was expected to be small."""
    code = Code(None)
    assert code.begin(unlooked, 0.0) is None
    assert code.look(unlooked, 0.0, "step 2") is None
    assert not library.begun
    assert code.look(small_program, math.inf, "step 3") is None
    assert library.begun == [small_program()]


def test_run_is_looked_at_from_time_to_time(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Not at every step."""
    monkeypatch.setattr(choice, "LOOK_SECONDS", 1e3)
    assert Code(None).look(unlooked, math.inf, "step 2") is None


def test_program_that_does_not_compile_is_left_alone(library: Library) -> None:
    """The run goes on plain, and says so; it does not try again."""
    code = Code(None)
    code.begin(small_program, math.inf)
    library.is_over = True
    assert code.look(unlooked, math.inf, "step 2") is None
    assert code.choice == ("plain Python", "its program could not be compiled")
    assert not code.may_change
    assert len(library.begun) == 1


def test_machine_where_no_process_can_be_started_runs_plain(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Such as one with a limit on them."""

    def refuse(*_: Any, **__: Any) -> None:
        raise BlockingIOError("no more processes")

    monkeypatch.setattr(compiler, "Compiling", refuse)
    code = Code(None)
    assert code.begin(small_program, math.inf) is None
    assert code.choice == ("plain Python", "no process can be started to compile it")


@pytest.mark.parametrize(("share", "finishes"), [(0.9 * PART, False), (1.1 * PART, True)])
def test_process_of_a_run_that_is_over_ends_unless_it_is_nearly_done(
    library: Library, share: float, finishes: bool
) -> None:
    """Then it may finish, so that the next run finds the program."""
    code = Code(None)
    code.begin(small_program, math.inf)
    library.seconds = share * COMPILING
    code.close()
    code.close()
    assert library.left == [finishes]


@pytest.mark.parametrize(
    ("solver", "recorder"),
    [
        ("sequential", "lesson_code.engine.stepper.record"),
        ("exact", "lesson_code.engine.solvers.exact.record_exact"),
    ],
)
def test_interrupted_run_is_over_too(
    library: Library, monkeypatch: pytest.MonkeyPatch, solver: str, recorder: str
) -> None:
    """Ctrl-C in its middle; a process that compiles for it ends."""

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(recorder, interrupt)
    monkeypatch.setattr(choice, "load_seconds", lambda: 0.0)
    monkeypatch.setattr(choice, "PART", 0.0)
    with pytest.raises(KeyboardInterrupt):
        simulate(gas_of(9, 0.3, seed=1), 1.0, solver=solver)
    assert len(library.left) == 1


# What cannot be


def test_large_run_that_cannot_be_compiled_says_why(library: Library) -> None:
    """It runs, only more slowly; a small one has nothing to say."""
    library.kept = True
    code = Code(None, "of the moon")
    assert code.begin(unlooked, math.inf) is None
    assert code.choice == Choice("plain Python", "of the moon")
    small = Code(None, "of the moon")
    small.begin(unlooked, 0.0)
    assert small.choice.reason == "a small run"


def test_run_that_cannot_be_compiled_but_is_asked_to_be_is_refused() -> None:
    """The error says why it cannot."""
    with pytest.raises(ValueError, match="compiled must be False or None here: of the moon"):
        Code(True, "of the moon")
    assert Code(False, "of the moon").choice == Choice("plain Python", "asked for")


def falling(**scene: Any) -> Scene:
    """Return a disc over a floor."""
    return Scene(
        [Body(Segment((-1, 0), (1, 0))), Body(Circle(1), mass=1, position=(0, 2))], **scene
    )


def test_scene_with_callbacks_runs_plain() -> None:
    """They are Python functions, which a compiled program cannot call."""
    scene = falling(callbacks=Callbacks(begin=lambda *_: True))
    words = "callbacks are Python functions"
    assert why_never(scene, our_solvers()["sequential"]) == words
    with pytest.raises(ValueError, match=f"compiled must be False or None here: {words}"):
        simulate(scene, 0.0, compiled=True)


def test_direct_solver_runs_plain() -> None:
    """It works on arrays of its own."""
    assert why_never(falling(), our_solvers()["direct"])
    with pytest.raises(ValueError, match="compiled must be False or None here: the direct solver"):
        simulate(falling(), 0.0, solver="direct", compiled=True)


def test_run_without_numba_is_plain_and_says_so(
    library: Library, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever asks for compiled code is told what is missing."""
    monkeypatch.setattr(library_module, "why_no_compiler", lambda: "Numba is not installed")
    code = Code(None)
    assert code.begin(small_program, math.inf) is None
    assert code.choice == Choice("plain Python", "Numba is not installed")
    with pytest.raises(ValueError, match="compiled must be False or None here: Numba is not inst"):
        Code(True).begin(small_program, 0.0)


@pytest.mark.parametrize("solver", ["pymunk", "box2d"])
def test_engine_that_is_not_ours_has_code_of_its_own(solver: str) -> None:
    """There is nothing to choose; before it is even loaded."""
    with pytest.raises(ValueError, match=f"compiled must be None for {solver}, got True"):
        simulate(falling(), 0.1, solver=solver, compiled=True)


# All together

LONG = """
import sys
from lesson_code import simulate
from lesson_code.engine.compiled import compiler
from lesson_code.evidence.scenes.gas import gas_of

class Compiling(compiler.Compiling):
    def is_over(self):
        self._process.wait()
        return True

compiler.Compiling = Compiling
for solver, duration in (("sequential", 500.0), ("exact", 1500.0)):
    left_out = {"impulse_record": False}
    run = simulate(
        gas_of(100, 0.3, seed=1), duration, solver=solver, sample="end", effects=left_out
    )
    print((run.positions + 0.0).tobytes().hex(), run.plan.headline, sep="|")
print("numba" in sys.modules)
"""
"""Each is long enough for its program to be compiled, and none for any scene will do. When a run
first looks whether it is, it waits: how fast the compiler is on this machine then decides nothing.
"""


@pytest.mark.full
def test_long_run_begins_plain_and_the_next_one_finds_its_program(place: Path) -> None:
    """With a real process beside it, in both engines; and the bits are the same."""
    pytest.importorskip("numba")
    *first, has_numba = printed(started(LONG))
    *later, _ = printed(started(LONG))
    assert has_numba == "False"
    bits = [[line.partition("|")[0] for line in lines] for lines in (first, later)]
    assert bits[0] == bits[1]
    assert "plain Python, compiled from step " in first[0]
    assert "plain Python, compiled from t = " in first[1]
    assert all(line.endswith("compiled (its machine code was kept)") for line in later)
    assert not list(place.glob("*.lock"))
