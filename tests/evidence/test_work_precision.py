"""Accuracy against time: errors, orders, the statistics, and the result that is stored."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from lesson_code.evidence import work_precision
from lesson_code.evidence.scenes.speed import stack
from lesson_code.evidence.work_precision import (
    Point,
    WorkPrecision,
    cheapest,
    in_words,
    measure,
    order_of,
    orders,
    scenes,
    splits,
    stored,
)
from lesson_code.evidence.work_precision.counting import work_of
from lesson_code.evidence.work_precision.methods import (
    METHODS,
    SPLITS,
    SPRING_SPLITS,
    Setting,
    methods_here,
    sampled,
    stepper,
)
from lesson_code.evidence.work_precision.scenes import pressed
from lesson_code.reference.pymunk_reference import PymunkStepper

ROUNDING = 1e-9
"""Relative: a straight line fitted to a few logarithms."""

EXACT = 1e-12
"""m: ten to some forty collisions, each with a rounding of 1e-16 of a few metres."""

FIRST_ORDER = 0.25
"""Of an order fitted to eight steps: where in a step an impact falls is chance, and so a single
error may be anything from nothing to twice the typical one."""

SAME = 1e-6
"""Relative, of an error that is computed again: libraries differ in the last digit of a sine, and
what follows from it is short of chaos."""

ANSWERED = {
    "ball in a box": ("pymunk", "sequential", "exact"),
    "drop": ("pymunk", "sequential", "exact"),
    "slide to roll": ("pymunk", "sequential", "exact", "substep", "direct"),
    "pi blocks": ("pymunk", "sequential", "exact"),
    "gas": ("pymunk", "sequential", "exact"),
    "stack of 20": ("direct",),
    "heavy on light": ("direct",),
}
"""Who is tried here, at one setting each."""


def point(error: float, seconds: float, *, dt: float = 0.1, failure: str = "") -> Point:
    """Return a made-up point of pymunk's."""
    return Point("drop", "pymunk", "C", dt, 10, 1, error, seconds, failure=failure)


def result_of(*points: Point) -> WorkPrecision:
    """Return a made-up result."""
    return WorkPrecision(repeats=7, machine={"python": "3"}, points=points)


def error_of(scene: str, method: str, setting: Setting) -> float:
    """Return an error, measured in plain Python."""
    run = sampled(scenes()[scene], METHODS[method], setting, compiled=False)
    return scenes()[scene].error(run)


def errors_over_dt(scene: str, method: str, rates: tuple[int, ...]) -> Iterator[Point]:
    """Yield points at some steps a second."""
    m = METHODS[method]
    for rate in rates:
        setting = Setting(1 / rate, m.iterations, m.substeps)
        error = error_of(scene, method, setting)
        yield Point(scene, method, "Python", 1 / rate, m.iterations, m.substeps, error)


# Orders


def test_order_leaves_out_failures_and_rounding() -> None:
    """What has fallen says nothing of the order, nor does an error of 1e-15 m."""
    line = [point(dt, 1.0, dt=dt) for dt in (0.1, 0.05, 0.025, 0.0125)]
    line += [point(9.0, 1.0, dt=0.2, failure="lost"), point(1e-15, 1.0, dt=1e-3)]
    fit = order_of(line)
    assert fit is not None
    assert fit.order == pytest.approx(1, rel=ROUNDING)
    assert fit.coarsest == 0.1
    assert order_of(line[:3]) is None
    assert order_of([point(1e-14, 1.0, dt=0.0)]) is None


@pytest.mark.parametrize("method", ["pymunk", "sequential"])
@pytest.mark.parametrize("scene", ["ball in a box", "slide to roll"])
def test_position_error_of_stepping_is_first_order(scene: str, method: str) -> None:
    """Halving the step halves the error, however good the solver is within a step."""
    fit = order_of(errors_over_dt(scene, method, (30, 60, 120, 240, 480, 960)))
    assert fit is not None
    assert fit.order == pytest.approx(1, abs=FIRST_ORDER)


def test_error_of_a_bounce_is_the_steps_not_the_solvers() -> None:
    """Free bodies that meet one at a time: pymunk and sequential are late alike.

    The direct solver ends the part of a step where they touch.
    """
    setting = Setting(1 / 120, 10, 1)
    errors = [error_of("ball in a box", m, setting) for m in ("pymunk", "sequential", "direct")]
    assert errors[1] == pytest.approx(errors[0], rel=SAME)
    assert errors[0] > 0.1
    assert errors[2] < 1e-8


@pytest.mark.parametrize("scene", ["ball in a box", "drop", "slide to roll", "pi blocks", "gas"])
def test_error_of_the_exact_solver_is_rounding(scene: str) -> None:
    """From collision to collision there is no step to be wrong by."""
    assert error_of(scene, "exact", Setting(0.0, 1, 1)) < EXACT


@pytest.mark.parametrize("scene", ["stack of 20", "heavy on light"])
def test_error_of_the_direct_solver_at_rest_is_rounding(scene: str) -> None:
    """A pile that stands is an equation, and it is solved."""
    short = replace(scenes()[scene], duration=0.5, times=(0.1, 0.3, 0.5))
    run = sampled(short, METHODS["direct"], Setting(1 / 60, 1, 1), compiled=False)
    assert short.error(run) < EXACT


# Splits of sweeps


def test_substeps_beat_iterations_under_a_heavy_box() -> None:
    """100 sweeps a step hold 1,000 kg on 1 kg in ten sub-steps; in one, pymunk lets it fall.

    One second is enough to see it.
    """
    scene = replace(scenes()["heavy on light"], duration=1.0, times=(0.5, 1.0))
    errors = [
        scene.error(sampled(scene, METHODS["pymunk"], Setting(1 / 60, k, n), compiled=False))
        for n, k in ((1, 100), (10, 10))
    ]
    assert errors[1] < errors[0] / 10


def test_springs_under_a_tower_are_as_stiff_as_sweeps_can_follow() -> None:
    """In one sub-step more sweeps carry the tower higher, and better than 25 sub-steps of one do.

    Ten boxes for two seconds, so that it is soon seen. From 1 to 25 sweeps the springs get 25 times
    as stiff, and the tower sinks by so much less: 135, 23 and 1.5 mm were measured, and 4.8 mm with
    25 sub-steps.
    """
    given_scene = pressed(stack(10).scene)
    tower = replace(scenes()["stack of 20"], scene=given_scene, duration=2.0, times=(1.0, 2.0))
    method = METHODS["substep"]
    errors = {
        (n, k): tower.error(sampled(tower, method, Setting(1 / 60, k, n), compiled=False))
        for n, k in ((1, 1), (1, 5), (1, 25), (25, 1))
    }
    assert errors[1, 5] < errors[1, 1] / 5
    assert errors[1, 25] < errors[1, 1] / 25
    assert errors[1, 25] < errors[25, 1] / 2


def test_settings_of_equal_work_have_equal_sweeps() -> None:
    """Sub-steps times iterations is 10 or 100, the two passes of springs counted."""
    assert {n * k for n, k in SPLITS} == {10, 100}
    assert {2 * n * k for n, k in SPRING_SPLITS} == {10, 100}


# The cheapest


def test_cheapest_is_the_fastest_that_is_good_enough() -> None:
    """A finer setting costs more; a failure never counts."""
    line = [point(0.4, 1.0, dt=0.1), point(0.2, 2.0, dt=0.05), point(0.1, 4.0, dt=0.025)]
    result = result_of(*line, replace(point(0.01, 0.5, failure="fell"), method="naive"))
    assert cheapest(result, "drop", 1.0) == line[0]
    assert cheapest(result, "drop", 0.3) == line[1]
    assert cheapest(result, "drop", 0.1) == line[2]
    assert cheapest(result, "drop", 0.09) is None


def test_cheapest_does_not_trust_a_lucky_hit() -> None:
    """A coarse step whose error is small by chance: the next finer one says that it was chance."""
    lucky, honest, fine = point(0.01, 1.0), point(0.3, 2.0, dt=0.05), point(0.01, 4.0, dt=0.02)
    assert cheapest(result_of(lucky, honest, fine), "drop", 0.05) == fine


def test_cheapest_refuses_what_was_not_asked() -> None:
    """An error of nothing, and a scene that nobody has measured."""
    with pytest.raises(ValueError, match="error must be > 0, got 0"):
        cheapest(result_of(point(1.0, 1.0)), "drop", 0)
    with pytest.raises(ValueError, match="scene must be one of drop, got 'gas'"):
        cheapest(result_of(point(1.0, 1.0)), "gas", 1.0)


def test_point_in_words_names_method_code_setting_and_time() -> None:
    """All that somebody needs to choose it."""
    ours = replace(point(0.1, 0.0123), method="sequential", code="compiled")
    assert in_words(ours) == "sequential, compiled, 1/10 s, 1 x 10: 12 ms"
    assert in_words(replace(ours, method="exact", code="Python", dt=0.0)) == (
        "exact in Python, no steps: 12 ms"
    )


# Settings and scenes


def test_every_method_but_one_is_tried_at_several_settings() -> None:
    """The exact solver has no setting; the others have at least three."""
    for scene in scenes().values():
        for method in METHODS.values():
            settings = list(method.settings(scene))
            assert len(set(settings)) == len(settings)
            assert len(settings) == 1 if method.name == "exact" else len(settings) >= 3


def test_pymunk_is_not_slowed_by_its_coefficients() -> None:
    """No scene needs a callback for each contact: the comparison of times is fair."""
    for scene in scenes().values():
        setting = next(METHODS["pymunk"].settings(scene))
        made = stepper(scene, METHODS["pymunk"], setting, compiled=False)
        assert isinstance(made, PymunkStepper)
        assert not made.corrects_coefficients


def test_piles_begin_at_rest() -> None:
    """All contacts are there in the first step, and no solver pushes anything out of the other."""
    for name, contacts in (("stack of 20", 40), ("heavy on light", 4)):
        scene = replace(scenes()[name], duration=1 / 60, times=(1 / 60,))
        setting = Setting(1 / 60, 1, 1)
        work = work_of(scene, METHODS["sequential"], setting, compiled=False)
        assert work.contact_solves == contacts


@pytest.mark.parametrize(("method", "factor"), [("sequential", 7), ("direct", 1)])
def test_work_is_contacts_times_sweeps(method: str, factor: int) -> None:
    """A pile of two: four contacts in each of six steps."""
    scene = replace(scenes()["heavy on light"], duration=0.1, times=(0.1,))
    work = work_of(scene, METHODS[method], Setting(1 / 60, factor, 1), compiled=False)
    assert work.contact_solves == 6 * 4 * factor


def test_work_of_pymunk_is_what_it_reports_times_its_iterations() -> None:
    """No more than four contacts in each of six steps; it may find one a step later than we do."""
    scene = replace(scenes()["heavy on light"], duration=0.1, times=(0.1,))
    work = work_of(scene, METHODS["pymunk"], Setting(1 / 60, 7, 1), compiled=False)
    assert work.contact_solves % 7 == 0
    assert 5 * 2 * 7 < work.contact_solves <= 6 * 4 * 7
    assert math.isnan(work.pair_tests)


def test_work_of_substeps_is_that_of_all_their_sweeps() -> None:
    """Springs find contacts once for all sub-steps; the others once in each."""
    scene = replace(scenes()["heavy on light"], duration=0.1, times=(0.1,))
    setting = Setting(1 / 60, 3, 2)
    springs = work_of(scene, METHODS["substep"], setting, compiled=False)
    parts = work_of(scene, METHODS["sequential"], setting, compiled=False)
    assert springs.contact_solves == 2 * parts.contact_solves == 2 * 6 * 4 * 6
    assert 2 * springs.pair_tests == parts.pair_tests


def test_what_a_method_refuses_is_a_point_that_says_so() -> None:
    """Boxes are nothing for the exact solver; its point is kept, without an error."""
    error, failure, work = measure.find_error(("stack of 20", "exact", Setting(0.0, 1, 1), False))
    assert failure == "refused"
    assert all(map(math.isnan, (error, *work)))


def test_what_has_fallen_is_a_point_that_says_so() -> None:
    """The naive solver drives a heavy box through a light one."""
    setting = Setting(1 / 60, 1, 1)
    error, failure, _ = measure.find_error(("heavy on light", "naive", setting, False))
    assert error > 0.5
    assert failure == "fell"


# Measuring


def test_quick_measurement_of_a_scene_has_every_method_and_a_time_for_each() -> None:
    """Four settings of each method; what is timed is a number of seconds."""
    result = measure.measure_accuracy(["drop"], quick=True, repeats=1)
    lines = result.lines("drop")
    assert [method for method, _ in lines] == [method.name for method in methods_here()]
    for (method, _), points in lines.items():
        assert len(points) == (1 if method == "exact" else measure.QUICK["dt"])
        assert all(p.seconds > 0 and not p.failure for p in points)


@pytest.mark.full
def test_errors_are_the_same_whoever_computes_them() -> None:
    """One process or two: all but the times."""
    one, two = (
        measure.measure_accuracy(["slide"], quick=True, repeats=1, workers=workers)
        for workers in (1, 2)
    )
    first, second = ([replace(p, seconds=0.0) for p in found.points] for found in (one, two))
    assert repr(first) == repr(second)  # nan, for what is not known, is no number's equal


def test_measurement_refuses_what_it_does_not_know() -> None:
    """A scene that there is not, and no repeats at all."""
    with pytest.raises(ValueError, match=r"only must name some of ball .*, got 'moon'"):
        measure.measure_accuracy(["moon"])
    with pytest.raises(ValueError, match="repeats must be >= 1, got 0"):
        measure.measure_accuracy(repeats=0)


def test_each_run_of_a_point_begins_at_the_start() -> None:
    """What is timed again and again is the same run, not its continuation."""
    scene, method = scenes()["drop"], METHODS["sequential"]
    begin = measure.stepper_at_the_start(scene, method, Setting(1 / 60, 10, 1), compiled=False)
    ends = []
    for _ in range(2):
        made = begin()
        made.advance(100)
        ends.append(made.states().tolist())
    assert ends[0] == ends[1]


# The form


def test_result_survives_its_form_as_json(tmp_path: Path) -> None:
    """What is not finite or not known is null there, and the same again afterwards."""
    refused = Point("drop", "exact", "Python", 0.0, 1, 1, math.nan, failure="refused")
    result = result_of(point(0.125, 1.5e-3), refused)
    result.store(tmp_path / "result.json")
    text = (tmp_path / "result.json").read_text(encoding="utf-8")
    again = WorkPrecision.stored(tmp_path / "result.json")
    assert repr(again) == repr(result)
    assert math.isnan(again.points[1].error)
    assert "NaN" not in text
    assert "Infinity" not in text


def test_result_of_another_version_is_refused(tmp_path: Path) -> None:
    """Its keys would mean something else."""
    (tmp_path / "result.json").write_text(json.dumps({"version": 1, "points": []}))
    with pytest.raises(ValueError, match="version must be 2, got 1"):
        WorkPrecision.stored(tmp_path / "result.json")


def test_result_is_merged_scene_by_scene() -> None:
    """Scenes that were measured anew take the old ones' place; the others stay."""
    old = result_of(point(1.0, 1.0), replace(point(2.0, 1.0), scene="gas"))
    merged = old.merged(result_of(point(3.0, 1.0)))
    assert [(p.scene, p.error) for p in merged.points] == [("drop", 3.0), ("gas", 2.0)]


def test_tables_show_every_point() -> None:
    """A row for each, in a table for each scene."""
    (table,) = result_of(point(1.0, 1.0), point(2.0, math.nan, failure="fell")).tables()
    assert table.row_count == 2


# What is stored


def test_stored_result_has_every_scene_and_method() -> None:
    """The notebook draws from it; its form is the one that is written now."""
    result = stored()
    assert result.scenes == list(scenes())
    for name, scene in scenes().items():
        for method in METHODS.values():
            measured = {p.setting for p in result.of(name) if p.method == method.name}
            assert measured == set(method.settings(scene)), (name, method.name)


def test_stored_result_keeps_failures_and_times_the_rest() -> None:
    """Refused and fallen points are there; all others have a time, and visits but for Box2D's."""
    failed = [p for p in stored().points if p.failure]
    assert {"refused", "fell", "lost"} <= {p.failure for p in failed}
    for p in stored().points:
        if not p.failure:
            assert p.seconds > 0
            assert math.isfinite(p.error)
            assert p.contact_solves > 0 or p.method == "box2d"


def test_stored_errors_are_the_same_in_all_codes() -> None:
    """Compiled or not, each method gives the same bits."""
    errors: dict[tuple[str, str, Setting], set[float]] = {}
    for p in stored().points:
        errors.setdefault((p.scene, p.method, p.setting), set()).add(p.error)
    assert all(len(found) == 1 for found in errors.values())


@pytest.mark.parametrize(
    ("scene", "method"), [(scene, method) for scene, who in ANSWERED.items() for method in who]
)
def test_stored_error_is_what_is_measured_now(scene: str, method: str) -> None:
    """At the coarsest setting of each, computed again."""
    setting = next(METHODS[method].settings(scenes()[scene]))
    (first, *_) = [p for p in stored().of(scene) if (p.method, p.setting) == (method, setting)]
    assert error_of(scene, method, setting) == pytest.approx(first.error, rel=SAME, abs=EXACT)


def test_stored_orders_are_those_of_the_lesson() -> None:
    """All that steps is of the first order in the ball's scene; the exact solver has none."""
    fits = orders(stored(), "ball in a box")
    assert ("exact", "Python") not in fits
    for line in (("pymunk", "C"), ("sequential", "compiled"), ("substep", "compiled")):
        assert fits[line].order == pytest.approx(1, abs=FIRST_ORDER)


def test_stored_splits_of_springs_want_sweeps_under_a_tower_and_substeps_under_a_load() -> None:
    """100 sweeps a step: the tower stands best in one sub-step, the heavy box in fifty."""
    tower, load = (
        splits(stored(), scene, 100)["substep"] for scene in ("stack of 20", "heavy on light")
    )
    assert [p.error for p in tower] == sorted(p.error for p in tower)
    assert tower[-1].failure == "fell"
    assert [p.error for p in load] == sorted((p.error for p in load), reverse=True)


@pytest.mark.parametrize("method", ["sequential", "pymunk"])
@pytest.mark.parametrize("scene", ["stack of 20", "heavy on light"])
def test_stored_splits_of_rigid_contacts_want_substeps(scene: str, method: str) -> None:
    """At equal sweeps the error of rigid contacts falls all the way to 100 sub-steps."""
    points = splits(stored(), scene, 100)[method]
    sound = [p.error for p in points if not p.failure]
    assert sound == sorted(sound, reverse=True)
    assert len(sound) > 3


def test_stored_result_answers_how_wrong_it_may_be() -> None:
    """The less error is allowed, the more it costs, and at last only the exact solver is left."""
    costs = [cheapest(stored(), "ball in a box", error) for error in (0.5, 0.1, 1e-9)]
    assert all(p is not None for p in costs)
    assert costs[-1] is not None
    assert costs[-1].method == "exact"


def test_package_names_are_those_of_its_docstring() -> None:
    """Each module is named there."""
    folder = Path(work_precision.__file__).parent
    names = {path.stem for path in folder.glob("*.py")} - {"__init__"}
    assert all(f"``{name}``" in str(work_precision.__doc__) for name in names)
