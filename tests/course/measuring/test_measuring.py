"""What is measured of the grader: the hostile set on its rungs, and submissions a second."""

from __future__ import annotations

import json
from functools import partial
from pathlib import Path

import pytest
from typer.testing import CliRunner

from lesson_code.cli import app
from lesson_code.course.grading.exercises import exercise_by_name, exercises
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.isolation import RUNGS, InForce
from lesson_code.course.measuring import hostile_set, nbgrader_run, throughput
from lesson_code.course.measuring.hostile_set import HostileRuns, OnRung, chosen_rungs
from lesson_code.course.measuring.throughput import measure_grading


def test_hostile_set_is_every_hostile_file(root: Path) -> None:
    """What is run on the rungs is what the golden table has, each with its points."""
    found = hostile_set.hostile_set(root)
    folder = root / hostile_set.FOLDER / "hostile"
    assert {one.path for one in found} == {p for p in folder.iterdir() if p.suffix != ".pyc"}
    for one in found:
        assert len(one.points) == len(exercise_by_name(one.exercise).tasks)
        assert read_submission(one.path)


def test_hostile_set_names_what_gets_through_a_rung(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A submission that says that it has read something is not contained; an honest one is."""
    reads = "def got_through(): return ['reads minds']\n"
    monkeypatch.setattr(
        hostile_set,
        "hostile_set",
        lambda _: [
            hostile_set.Hostile("talks", root / "talks.py", "01", (0, 0, 0)),
            hostile_set.Hostile("honest", exercise_by_name("01").solution(root), "01", (4, 3, 3)),
            hostile_set.Hostile("inflated", exercise_by_name("01").solution(root), "01", (0, 0, 0)),
        ],
    )
    monkeypatch.setattr(
        hostile_set,
        "read_submission",
        lambda path: read_submission(path) if path.name != "talks.py" else _talks(reads),
    )
    best = next(rung.name for rung in RUNGS if not rung.missing())
    ran = hostile_set.run_hostile_set(root, [best])
    assert ran.rungs[0].through == {
        "talks": ("reads minds",), "honest": (), "inflated": ("earns more",),
    }  # fmt: skip
    assert ran.rungs[0].contained == 1


def _talks(source: str) -> object:
    """Return code as a submission."""
    from ..isolation.conftest import units

    return type("Read", (), {"units": units(source)})()


@pytest.mark.parametrize(
    ("level", "through", "holds"),
    [("full", (), True), ("full", ("reads files",), False), ("limits", ("reads files",), True)],
)
def test_hostile_runs_hold_if_full_lets_nothing_through(
    level: str, through: tuple[str, ...], holds: bool
) -> None:
    """Only what is said to be full has to be; the exit code goes by that."""
    in_force = InForce(level, "a rung", ())  # type: ignore[arg-type]
    runs = HostileRuns((OnRung("a rung", in_force, "", {"one": through}),))
    assert runs.full_holds is holds
    assert runs.as_dict()["rungs"][0]["contained"] == (not through)


def test_chosen_rungs_are_in_the_order_of_the_ladder() -> None:
    """All by default; an unknown one is an error that lists them."""
    assert chosen_rungs([]) == list(RUNGS)
    assert [rung.name for rung in chosen_rungs(["process", "limits"])] == ["limits", "process"]
    with pytest.raises(ValueError, match=r"rung must be one of namespaces, .* got 'moat'"):
        chosen_rungs(["moat"])


def test_measure_isolation_of_an_unknown_rung_exits_2() -> None:
    """A name that is no rung is one line and exit code 2."""
    ran = CliRunner().invoke(app, ["measure", "isolation", "--only", "moat"])
    assert ran.exit_code == 2
    assert len(ran.stderr.strip().splitlines()) == 1


def test_measure_grading_measures_a_rate_for_each_rung(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each rung that is there has a rate and a time; each other one has its reason."""
    monkeypatch.setattr("lesson_code.course.measuring.throughput.BATCH", 2)
    names = [rung.name for rung in RUNGS if rung.name != "process"]
    measured = measure_grading(root, names, workers=1, batches=1)
    assert {rate.name for rate in measured.rates} | set(measured.missing) == set(names)
    assert all(rate.a_second > 0.0 for rate in measured.rates)
    value = json.loads(json.dumps(measured.as_dict()))
    assert [rate["submissions_a_second"] for rate in value["rates"]] == [
        rate.a_second for rate in measured.rates
    ]
    assert measured.as_table().row_count == len(measured.rates)


def test_measure_grading_of_the_mix_grades_every_exercise(
    root: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All solutions in turn are one way of grading, and as many as there are exercises."""
    graded: list[Path] = []
    monkeypatch.setattr(
        throughput, "_turn", lambda _pool, _rung, paths, _workers: partial(_noted, graded, paths)
    )
    best = next(rung.name for rung in RUNGS if not rung.missing())
    measured = measure_grading(root, [best], exercise=throughput.MIX, workers=1, batches=1)
    assert measured.as_dict()["exercise"] == "mix"
    assert graded[: len(exercises())] == [each.solution(root) for each in exercises()]
    assert [rate.name for rate in measured.rates] == [best]


def _noted(graded: list[Path], paths: list[Path]) -> tuple[int, float, float]:
    """Note what would be graded, and return that it took a second."""
    graded += paths
    return len(paths), 1.0, 1.0


def test_nbgrader_notebook_has_our_points_and_inputs(root: Path) -> None:
    """Its graded cells, run here, pass with the solution's answers and fail with others."""
    exercise = exercise_by_name("01")
    notebook = nbgrader_run._notebook(exercise.solution(root), exercise, seed=7)
    graded = [c for c in notebook["cells"] if c["metadata"]]
    points = [cell["metadata"]["nbgrader"]["points"] for cell in graded]
    assert points == [task.points for task in exercise.tasks]
    namespace: dict[str, object] = {}
    for cell in notebook["cells"]:
        exec(cell["source"], namespace)  # noqa: S102 - our own solution
    namespace["elastic_1d"] = lambda *given: (given[3], given[1])
    with pytest.raises(AssertionError):
        exec(graded[0]["source"], namespace)  # noqa: S102


def test_nbgrader_that_is_not_installed_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without the command there is a reason in place of a rate."""
    monkeypatch.setattr(nbgrader_run, "command", lambda: None)
    assert nbgrader_run.missing() == "not installed (pip install nbgrader)"
