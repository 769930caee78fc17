"""The catalogue of hard cases: ours holds every bound, and the bounds can be broken."""

from __future__ import annotations

import json
import math
from collections import Counter
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from lesson_code import Body, Circle, Scene
from lesson_code.evidence.hard_cases import (
    CASES,
    OURS,
    PEERS,
    Comparison,
    HardCase,
    Outcome,
    Trial,
    case_by_name,
    comparison,
    installed_solvers,
    measure_hard_cases,
    run_case,
    stored,
)
from lesson_code.parallel import WorkerDiedError

FEWEST = 45
"""Cases that the catalogue promises."""

WIDTH = 100
"""Columns: the table fits a page."""

CHEAP = ("kane", "limit-cycle", "flat-landing", "dt-jumps", "cradle", "small-discs", "tunnelling")
"""Cases in which pymunk fails within a second."""


def marked(case: HardCase) -> Any:
    """Return a case as a parameter of a test; the long ones are slow."""
    return pytest.param(case, id=case.name, marks=pytest.mark.full if case.is_long else ())


# The catalogue


@pytest.mark.one_in(9)
@pytest.mark.parametrize("case", [marked(case) for case in CASES])
def test_ours_holds_the_bound(case: HardCase) -> None:
    """The bound stands in the catalogue, with its reason."""
    outcome = run_case(case)
    assert outcome.error == ""
    assert outcome.held, f"{case.title}: {outcome.value} {case.unit}, the bound is {case.bound}"


def test_catalogue_has_as_many_cases_as_it_promises_each_once() -> None:
    """Names and titles are unique, and so are scene and measure together."""
    assert len(CASES) >= FEWEST
    for names in ([case.name for case in CASES], [case.title for case in CASES]):
        assert max(Counter(names).values()) == 1


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_every_case_says_what_it_is(case: HardCase) -> None:
    """A bound is finite, and everything that is to be read is a sentence or a formula."""
    assert math.isfinite(case.bound)
    assert case.bound >= 0.0
    for text in (case.theme, case.title, case.why, case.law, case.reason):
        assert len(text) > 3
    assert case.why.endswith(".")
    assert case.ours["solver"] == "auto"
    assert set(case.failed_by) <= set(PEERS)
    assert isinstance(case.scene(), Scene)


def test_unknown_case_is_refused_with_the_known_ones() -> None:
    """Whoever mistypes a name is told all of them."""
    with pytest.raises(ValueError, match=r"name must be one of heavy-load, .*, got 'heavy'"):
        case_by_name("heavy")


# A check that can fail


@pytest.mark.parametrize("name", CHEAP)
def test_pymunk_is_found_out(name: str) -> None:
    """What is meant to be failed is failed: each of these cases tells pymunk from the law."""
    assert "pymunk" in case_by_name(name).failed_by
    assert not run_case(case_by_name(name), "pymunk").held


@pytest.mark.parametrize(
    "name", ["heavy-load-force", "break-shot", "box-on-slope", "seams-rolling"]
)
def test_naive_is_found_out(name: str) -> None:
    """The lesson's first attempt has neither friction nor a second look."""
    assert "naive" in case_by_name(name).failed_by
    assert not run_case(case_by_name(name), "naive").held


def test_stored_outcomes_are_those_that_the_catalogue_foretells() -> None:
    """Who is said to fail has failed; ours has held everything."""
    kept = stored()
    assert kept.not_held() == []
    for case in CASES:
        for solver in set(case.failed_by) & set(kept.solvers):
            assert not kept.outcome(case.name, solver).held, (case.name, solver)


def test_most_cases_tell_another_engine_from_the_law() -> None:
    """A catalogue that everybody holds would show nothing."""
    kept = stored()
    assert len(kept.not_held("pymunk")) > len(CASES) / 2


def test_stored_outcomes_are_of_this_catalogue() -> None:
    """Every case, in its order, with its bound; by every solver. Regenerate it with --store."""
    kept = stored()
    assert kept.names == tuple(case.name for case in CASES)
    assert {OURS, "naive", "pymunk"} <= set(kept.solvers)
    assert len(kept.outcomes) == len(CASES) * len(kept.solvers)
    for case in CASES:
        assert {kept.outcome(case.name, s).bound for s in kept.solvers} == {case.bound}


# How a case is run


def always(value: float) -> HardCase:
    """Return a case whose measure is known."""
    return replace(case_by_name("zeno"), measure=lambda _: value, bound=1.0)


@pytest.mark.parametrize(
    ("value", "held"),
    [(0.0, True), (1.0, True), (1.1, False), (math.inf, False), (math.nan, False)],
)
def test_bound_is_held_up_to_itself_and_never_by_nan(value: float, held: bool) -> None:
    """A number that is none holds nothing."""
    assert run_case(always(value)).held is held


@pytest.mark.parametrize("value", [math.inf, math.nan])
def test_value_that_is_no_number_says_so(value: float) -> None:
    """An error stands where a value should."""
    assert run_case(always(value)).error == "no finite number"


def test_exception_of_a_solver_is_an_outcome() -> None:
    """The exact solver refuses boxes: no value, and its words."""
    case = replace(case_by_name("tower-20"), ours={"solver": "exact"})
    outcome = run_case(case)
    assert math.isnan(outcome.value)
    assert not outcome.held
    assert outcome.error.startswith("ValueError: ")


def test_trial_gives_every_solver_the_same_options() -> None:
    """The step is the case's, the solver's name the trial's."""
    case = case_by_name("limit-cycle")
    assert case.trial(OURS).options == {"dt": 1e-9, "solver": "auto"}
    assert case.trial("pymunk").options == {"dt": 1e-9, "solver": "pymunk"}
    with pytest.raises(ValueError, match=r"solver must be one of ours, .*, got 'mine'"):
        case.trial("mine")


def test_trial_runs_another_scene_too() -> None:
    """A ball that flies on alone, with the trial's step."""
    trial = Trial(Scene(), {"solver": "naive", "dt": 0.5})
    ball = Scene([Body(Circle(1.0), mass=1.0, velocity=(2, 0))])
    assert trial.run(1.0, ball).positions[:, 0, 0].tolist() == [0.0, 1.0, 2.0]


# All of them together


def test_comparison_is_the_same_for_one_worker_and_for_two() -> None:
    """Only the seconds differ."""
    names = ["kane", "break-shot", "zeno"]
    one, two = (measure_hard_cases(names, workers=n).without_times().as_dict() for n in (1, 2))
    assert one == two
    assert [case["name"] for case in one["cases"]] == names
    assert one["solvers"] == list(installed_solvers())


def test_comparison_refuses_unknown_solvers() -> None:
    """Before anything is run."""
    with pytest.raises(ValueError, match=r"solver must be one of ours, .*, got 'rapier'"):
        measure_hard_cases(["kane"], solvers=["rapier"])


def test_dead_process_is_an_outcome(monkeypatch: pytest.MonkeyPatch) -> None:
    """A solver that takes its worker with it has no result, and the others go on."""

    def one_dies(function: Any, tasks: Any, **_options: Any) -> Any:
        for n, task in enumerate(tasks):
            future: Future[Any] = Future()
            if task[1] == "pymunk":
                future.set_exception(WorkerDiedError("signal 6"))
            else:
                future.set_result(function(task))
            yield n, future

    monkeypatch.setattr(comparison, "iter_tasks", one_dies)
    both = measure_hard_cases(["kane"], solvers=[OURS, "pymunk"])
    assert (both.not_held(), both.not_held("pymunk")) == ([], ["kane"])
    written = both.as_dict()["cases"][0]["outcomes"]["pymunk"]
    assert written["value"] is None
    assert written["error"] == "the process died: signal 6"


def test_stored_file_gives_back_what_was_stored(tmp_path: Path) -> None:
    """Values, errors and bounds; the times are not kept, they differ from run to run."""
    kept = Comparison(
        (
            Outcome("kane", OURS, 0.25, 1e-12, 3.0),
            Outcome("kane", "naive", math.nan, 1e-12, 1.0, "x"),
        )
    )
    kept.without_times().store(tmp_path / "kept.json")
    back = stored(tmp_path / "kept.json")
    assert repr(back) == repr(kept.without_times())
    assert math.isnan(back.outcome("kane", "naive").value)
    assert '"seconds": null' in (tmp_path / "kept.json").read_text()


def test_stored_file_of_another_version_is_refused(tmp_path: Path) -> None:
    """Its keys may mean something else."""
    (tmp_path / "old.json").write_text(json.dumps({"version": 0}))
    with pytest.raises(ValueError, match=r"version must be 1, got 0"):
        stored(tmp_path / "old.json")


def test_table_fits_a_page_and_names_every_case() -> None:
    """100 columns, no line broken."""
    text = stored().as_text(WIDTH)
    assert max(map(len, text.splitlines())) <= WIDTH
    for case in CASES:
        assert f"\n {case.name} " in text
    assert comparison.HEADINGS["box2d"] in text or "box2d" not in stored().solvers


@pytest.mark.parametrize(
    ("value", "excess"), [(0.0, 0.0), (1.0, 0.5), (6.0, 3.0), (math.inf, math.inf)]
)
def test_excess_is_how_many_times_the_bound(value: float, excess: float) -> None:
    """Half, or three times."""
    assert Outcome("a", OURS, value, 2.0).excess == excess


def test_excess_over_a_bound_of_zero_is_infinite() -> None:
    """A count that may not be one."""
    assert Outcome("a", OURS, 1.0, 0.0).excess == math.inf
    assert Outcome("a", OURS, 0.0, 0.0).excess == 0.0
