"""The measurement of speed: its arithmetic, its verdicts, what it prints; no time is asserted."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Scene, simulate
from lesson_code.evidence.measurement import Limit, at_least, at_most, chosen
from lesson_code.evidence.scenes import speed as speed_scenes
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY
from lesson_code.evidence.scenes.speed import BUILDERS, SIZES
from lesson_code.evidence.speed import measure, measure_speed, quality, user_program, whole_runs
from lesson_code.evidence.speed.engines import engines_for, start
from lesson_code.evidence.speed.measure import fits, parts
from lesson_code.evidence.speed.piles import PILES, Held, Pile, PileRace, race_with_pile
from lesson_code.evidence.speed.profile import profile_scene, stage_calls
from lesson_code.evidence.speed.quality import Quality, worse_in
from lesson_code.evidence.speed.race import (
    LOOKED_AT,
    SHORT_BATCH_REPEATS,
    Race,
    Ratio,
    Timing,
    bytes_of,
    run_race,
    warm_up_of,
)
from lesson_code.evidence.speed.report import Speed
from lesson_code.evidence.speed.targets import TARGETS, WHOLE_RUNS, target_of
from lesson_code.evidence.speed.whole_runs import (
    BOX2D,
    FRESH,
    KEPT,
    PYMUNK,
    RunTime,
    WholeRuns,
    measure_whole_run,
    numbers_of,
)

pytest.importorskip("numba", reason="there is nothing to compare without compiled code")

ROUNDING = 1e-12
"""Of fits through a handful of points, and of places of some metres."""

SINGLE = 1e-6
"""m: of single precision, after 60 sub-steps at places of some metres."""

WIDTH = 100
"""Columns that tables have to fit into."""

GOOD = Quality(overlap=0.01, energy_error=1e-4, energy_kind="drift")


def timing(engine: str, seconds: float, quality: Quality = GOOD) -> Timing:
    """Return what an engine might have done."""
    size = 400.0 if engine == "sequential" else None
    return Timing(engine, seconds, seconds, quality, 2.0, size, 0.1)


def race(key: str = "gas-100", bodies: int = 100, **seconds: float) -> Race:
    """Return a race with given times."""
    names = {"tree": "pymunk, tree", "hash": "pymunk, hash"}
    timings = tuple(timing(names.get(name, name), value) for name, value in seconds.items())
    return Race(key, f"a gas of {bodies:,}", bodies, 10, 7, timings)


def with_quality(a_race: Race, engine: str, quality: Quality) -> Race:
    """Return a race in which an engine has another quality."""
    timings = (replace(t, quality=quality) if t.engine == engine else t for t in a_race.engines)
    return replace(a_race, engines=tuple(timings))


# Equal quality


@pytest.mark.parametrize(
    ("ours", "expected"),
    [
        (GOOD, ()),
        (replace(GOOD, overlap=0.012), ()),  # alike
        (replace(GOOD, overlap=0.02), ("overlap",)),
        (replace(GOOD, energy_error=9e-4), ()),  # under what counts
        (replace(GOOD, energy_error=0.01), ("energy",)),
        (Quality(0.02, 0.01, "drift"), ("overlap", "energy")),
        (Quality(math.nan, math.nan, "drift"), ("overlap", "energy")),
    ],
)
def test_worse_in_names_what_is_clearly_worse(ours: Quality, expected: tuple[str, ...]) -> None:
    """A quarter more is alike, and so is what is under the slop or a thousandth of the energy."""
    assert worse_in(ours, GOOD) == expected


def test_overlap_is_not_compared_with_a_gas_that_stands_still() -> None:
    """Box2D's gas loses its energy: it overlaps less because it hardly moves."""
    still = Quality(0.005, 0.99, "drift")
    assert worse_in(replace(GOOD, overlap=0.05), still) == ()
    assert worse_in(still, GOOD) == ("energy",)


def test_pile_may_overlap_by_the_slop_whatever_the_other_does() -> None:
    """Half of the slop or all of it: both are left alone."""
    deep, shallow = Quality(0.005, 0.0, "left"), Quality(0.001, 0.0, "left")
    assert worse_in(deep, shallow) == ()
    assert worse_in(replace(deep, overlap=0.02), shallow) == ("overlap",)


# Ratios and targets


def test_ratio_is_against_the_better_broad_phase_of_pymunk() -> None:
    """Which is the better one is settled scene by scene."""
    a_race = race(sequential=2.0, tree=9.0, hash=6.0, box2d=20.0)
    ratios = {(ratio.ours, ratio.peer): ratio.ratio for ratio in a_race.ratios}
    assert ratios == {("sequential", "pymunk"): 3.0, ("sequential", "box2d"): 10.0}


@pytest.mark.parametrize(
    ("seconds", "quality", "reached"),
    [(2.8, GOOD, True), (2.7, GOOD, False), (9.0, replace(GOOD, overlap=0.5), False)],
    ids=["reached", "too slow", "not as good"],
)
def test_target_is_reached_only_at_equal_quality(
    seconds: float, quality: Quality, reached: bool
) -> None:
    """2.8 times is wanted of a gas of 100 discs."""
    a_race = with_quality(race(sequential=1.0, tree=seconds), "sequential", quality)
    (ratio,) = a_race.ratios
    assert (ratio.wanted, ratio.reached) == (2.8, reached)


def test_scene_without_target_is_neither_reached_nor_missed() -> None:
    """Nothing is promised of ten discs."""
    assert Ratio("gas-10", "sequential", "pymunk", 9.0, (), None).reached is None
    assert target_of("gas-10", "sequential", "pymunk") is None


def test_every_target_is_of_a_scene_that_is_measured() -> None:
    """None can be passed over by a wrong name."""
    keys = {f"{kind}-{size}" for kind, sizes in SIZES.items() for size in sizes}
    assert {scene for _, _, ratios in TARGETS for scene in ratios} <= keys
    assert all(peer in ("pymunk", "box2d") for _, peer, _ in TARGETS)
    assert list(SIZES) == list(BUILDERS)


def test_growth_leaves_out_what_is_small() -> None:
    """From 1,000 bodies on; ten of them would only show what a call costs."""
    races = tuple(
        race(f"gas-{n}", n, sequential=time, tree=2 * time)
        for n, time in ((10, 1.0), (1_000, 1.0), (10_000, 10.0), (100_000, 100.0))
    )
    growth = Speed({}, 7, scenes=races).growth_exponents
    assert growth["gas"] == pytest.approx({"sequential": 1.0, "pymunk": 1.0}, abs=ROUNDING)


# Quality of states


@pytest.mark.full
def test_gauge_measures_what_a_run_measures() -> None:
    """The same depth, in the same states, of discs and of polygons."""
    for speed_scene in (speed_scenes.gas(30), speed_scenes.pyramid(4)):
        run = simulate(speed_scene.scene, 0.5, sample="end", solver="sequential")
        states = np.column_stack(
            [run.positions[-1], run.angles[-1], run.velocities[-1], run.angular_velocities[-1]]
        )
        reading = quality.Gauge(speed_scene.scene).read(states)
        assert reading.depth == run.max_penetration[-1]


@pytest.mark.full
def test_kinetic_energy_of_states_is_that_of_the_run() -> None:
    """Spin included; walls are at rest."""
    speed_scene = speed_scenes.bin_of_shapes(5)
    run = simulate(speed_scene.scene, 0.5, sample="end", solver="sequential")
    states = np.column_stack(
        [run.positions[-1], run.angles[-1], run.velocities[-1], run.angular_velocities[-1]]
    )
    energy = quality.Gauge(speed_scene.scene).energy(states)
    assert energy == pytest.approx(run.kinetic_energy[-1], rel=ROUNDING)


def test_energy_to_lift_two_bodies_is_their_weight_times_the_smaller_width() -> None:
    """3 kg, 10 m/s^2, and discs 1 m and 2 m wide."""
    discs = [Body(Circle(0.5), mass=1.0), Body(Circle(1.0), position=(5, 0), mass=2.0)]
    assert quality.energy_to_lift(Scene(discs, gravity=(0, -10))) == pytest.approx(30.0)


# Engines and races


def test_every_engine_takes_the_same_steps() -> None:
    """A free flight of one disc is the same for all, in single precision for Box2D."""
    disc = Body(Circle(0.5), mass=1.0, velocity=(1.0, -0.5))
    speed_scene = replace(speed_scenes.gas(10), scene=Scene([disc]))
    engines = engines_for(speed_scene)
    assert {"sequential", "substep", "exact", "pymunk, tree", "pymunk, hash"} <= set(engines)
    for name in engines:
        engine = start(name, speed_scene)
        engine.advance(30)
        engine.advance(30)
        assert engine.states()[0, :2] == pytest.approx([1.0, -0.5], abs=1e-5), name


def test_exact_solver_is_left_out_where_it_has_no_say() -> None:
    """Discs that lie in a pile, and polygons."""
    for speed_scene in (speed_scenes.settled_discs(10), speed_scenes.stack(3)):
        assert "exact" not in engines_for(speed_scene)


def test_warm_up_of_a_large_scene_is_cut_short() -> None:
    """2,000,000 body-steps, but 100 steps at least; a small scene makes all of its own."""
    small = speed_scenes.gas(100)
    assert warm_up_of(small) == small.warm_up
    assert warm_up_of(replace(small, warm_up=20_000)) == 2_000_000 // 104


@pytest.mark.full
def test_bytes_of_tables_are_told_for_our_engine_alone() -> None:
    """A body's row is two lines of 64 bytes at least; what pymunk holds cannot be seen so."""
    speed_scene = speed_scenes.gas(50)
    ours = bytes_of(start("sequential", speed_scene))
    assert ours is not None
    assert ours > 50 * 2 * 64
    assert bytes_of(start("pymunk, tree", speed_scene)) is None


@pytest.mark.full
@pytest.mark.parametrize(
    ("speed_scene", "batches"),
    [
        (speed_scenes.gas(10), LOOKED_AT // 14),
        (speed_scenes.stack(3), SHORT_BATCH_REPEATS),
        (speed_scenes.settled_discs(9), 1),
    ],
    ids=lambda value: getattr(value, "name", None),
)
def test_race_measures_every_engine(
    speed_scene: Any, batches: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Times, overlaps and energies are there; what does not last, or is small, is run more often.

    The gas has four walls.
    """
    monkeypatch.setattr("lesson_code.evidence.speed.race.BATCH_SECONDS", 1e-6)
    measured = run_race("key", replace(speed_scene, warm_up=3), repeats=1)
    assert [t.engine for t in measured.engines] == engines_for(speed_scene)
    assert measured.batches == batches
    for found in measured.engines:
        assert found.seconds > 0
        assert found.quality.overlap >= 0
        assert math.isfinite(found.quality.energy_error)


@pytest.mark.full
def test_exact_gas_keeps_its_energy_and_overlaps_by_nothing() -> None:
    """Whatever the other engines do."""
    measured = run_race("gas-10", replace(speed_scenes.gas(10), warm_up=3), repeats=1)
    exact = measured.timing("exact")
    assert exact is not None
    assert exact.quality.energy_error < ROUNDING
    assert exact.quality.overlap < ROUNDING


# Piles


def test_stack_stands_until_a_box_has_left_its_place() -> None:
    """By half a width."""
    scene = speed_scenes.stack(3).scene
    states = quality.states_of(scene)
    assert PILES["standing"].holds(scene, states, overlap=0.3)
    states[2, 0] += 0.51
    assert not PILES["standing"].holds(scene, states, overlap=0.0)


def test_pyramid_is_held_while_no_overlap_is_deep() -> None:
    """Two slops are the limit."""
    scene = speed_scenes.pyramid(3).scene
    states = quality.states_of(scene)
    assert PILES["held-20"].holds(scene, states, overlap=0.01)
    assert not PILES["held-20"].holds(scene, states, overlap=0.0101)


def pile_of_two(**options: Any) -> Pile:
    """Return two boxes that have to hold for a fifth of a second."""
    return Pile("standing", "two", lambda: speed_scenes.stack(2), 0.2, 0.5, **options)


@pytest.mark.full
def test_pile_names_the_cheapest_setting_that_holds() -> None:
    """Two boxes hold with the least that is tried."""
    raced = race_with_pile(pile_of_two(), 1)
    assert all(row.held for row in raced.rows)
    settings = {row.engine: row.setting for row in raced.rows}
    assert (settings["sequential"], settings["substep"]) == (3, 2)
    assert raced.ratio("pymunk") is not None


@pytest.mark.full
def test_pile_that_no_setting_holds_is_said_not_to_hold() -> None:
    """Bodies that rest on each other overlap by something."""
    raced = race_with_pile(pile_of_two(deepest=0.0), 1)
    assert {(row.held, row.setting) for row in raced.rows if row.engine == "sequential"} == {
        (False, 60)
    }
    assert raced.ratio("pymunk") is None


# Whole runs

SECONDS = 0.25
"""s: until then no two of four discs have met, nor one a wall."""


def whole() -> WholeRuns:
    """Return made-up times: ours is in time for the first call, and late for the second."""
    scene = ("run-gas-100", "gas of 100 for 10 s", 100)
    times = (
        RunTime(*scene, PYMUNK, 0.1, 0.1, 0.05, 0.05),
        RunTime(*scene, BOX2D, 0.2, 0.2, 0.01, 0.01),
        RunTime(*scene, KEPT, 0.25, 0.3, 0.1, 0.1),
        RunTime(*scene, FRESH, 12.0, 9.0, math.nan, math.nan),
    )
    return WholeRuns({"python": "3"}, times)


def test_numbers_of_a_whole_run_are_those_of_its_scene() -> None:
    """Rough discs in loose rows over an open box of three walls, and a gas in a closed one."""
    pile, gas = numbers_of("pile", 30, 1.0), numbers_of("gas", 10, 1.0)
    assert (len(pile["places"]), len(pile["walls"])) == (30, 3)
    assert (len(gas["places"]), len(gas["walls"])) == (10, 4)
    assert (gas["gravity"], gas["restitution"], gas["friction"]) == ((0.0, 0.0), 1.0, 0.0)
    assert (pile["restitution"], pile["friction"]) == (0.0, speed_scenes.FRICTION)
    json.dumps([pile, gas], allow_nan=False)


@pytest.mark.one_in(2)
@pytest.mark.parametrize("engine", ["ours", "compiled", "pymunk", "box2d"])
@pytest.mark.parametrize(("kind", "gravity"), [("gas", 0.0), ("pile", -GRAVITY)])
def test_program_of_every_engine_runs_the_same_scene(
    engine: str, kind: str, gravity: float
) -> None:
    """The middle of the discs moves as momentum and gravity say; Box2D has single precision.

    A fall in steps of h is off by g t h / 2.
    """
    if engine == "box2d":
        pytest.importorskip("pyb2d3")
    given = numbers_of(kind, 4, SECONDS) | {"walls": []}
    places = np.array(user_program.ENGINES[engine](given))
    moved = (places - np.array(given["places"])).mean(axis=0)
    fall, lag = gravity * SECONDS**2 / 2, abs(gravity) * SECONDS / 60 / 2
    assert moved[0] == pytest.approx(0.0, abs=SINGLE)
    assert moved[1] == pytest.approx(fall, abs=lag + SINGLE)


@pytest.mark.full
def test_whole_run_is_measured_in_fresh_processes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each engine twice; where nothing is kept there is no second call."""
    monkeypatch.setitem(whole_runs.SCENES, "run-gas-10", ("gas", 4, 0.1))
    rows = {row.who: row for row in measure_whole_run("run-gas-10", repeats=2)}
    assert {PYMUNK, KEPT, FRESH} <= set(rows)
    for row in rows.values():
        assert row.cpu > 0.0
        assert row.wall > 0.0
        assert math.isnan(row.second_cpu) == (row.who == FRESH)


def test_every_whole_run_has_a_target() -> None:
    """By the names on the command line."""
    assert set(WHOLE_RUNS) == set(whole_runs.SCENES)
    assert set(measure.QUICK_RUNS) <= set(whole_runs.SCENES)


def test_what_is_wanted_of_a_whole_run_is_a_share_of_pymunks_time() -> None:
    """As much as pymunk and .3 s more for 100 discs; a second call at most as much."""
    first, second = whole().limits
    assert (first.value, first.wanted, first.reached) == (0.25, "at most 0.4", True)
    assert (second.value, second.wanted, second.reached) == (0.1, "at most 0.05", False)
    assert WholeRuns({}, whole().times[:1]).limits == []


def test_whole_runs_are_stored_and_read_again(tmp_path: Path) -> None:
    """The notebook shows what was stored."""
    whole().store(tmp_path / "stored.json")
    read = WholeRuns.stored(tmp_path / "stored.json")
    assert read.as_text() == whole().as_text()
    assert read.of("run-gas-100", KEPT) == whole().of("run-gas-100", KEPT)


def test_import_loads_nothing_heavy() -> None:
    """Numba, matplotlib, pygame and pymunk wait until they are used."""
    code = "import sys, lesson_code.simulation; print(*sys.modules)"
    loaded = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert not {"numba", "matplotlib", "pygame", "pymunk"} & set(loaded.stdout.split())


# The profile


def test_stages_are_read_from_the_program() -> None:
    """In their order; what a loop repeats says so, and calls with other arguments are none."""
    source = """
def part(world):
    if not has_moved(world):
        return False
    for _ in range(state.substeps):
        move(world)
        for _ in range(state.iterations):
            solve(world)
    sort(world, 3)
"""
    expected = [("has_moved", ""), ("move", "substeps"), ("solve", "substeps iterations")]
    assert stage_calls(source, "part") == expected
    assert stage_calls(source, "nothing") == []


@pytest.mark.full
def test_profile_shows_the_stages_of_a_step() -> None:
    """In the order in which the step calls them; ten sweeps are ten calls."""
    profiled = profile_scene("settled-30")
    calls = {stage.name: stage.calls for stage in profiled.stages if stage.depth == 0}
    names = list(calls)
    assert names.index("move") < names.index("see_contacts") < names.index("solve")
    assert (calls["move"], calls["solve"]) == (1, 10)
    assert profiled.contacts > 30
    json.dumps(profiled.as_dict(), allow_nan=False)


@pytest.mark.parametrize("name", ["gas", "gas-", "gas-0", "gold-10", "10"])
def test_profile_of_no_scene_is_refused(name: str) -> None:
    """The error names those that there are."""
    with pytest.raises(ValueError, match="scene must be one of gas, dense"):
        profile_scene(name)


# What is chosen, and what is printed


@pytest.mark.parametrize(
    ("only", "expected"),
    [
        (["stack-10"], ["stack-10"]),
        (["stack", "standing"], ["stack-10", "stack-20", "standing"]),
        (["run-pile"], ["run-pile-30", "run-pile-300", "run-pile-3000"]),
        (["gas-10"], ["gas-10"]),
    ],
)
def test_parts_are_chosen_by_name_or_by_its_beginning(only: list[str], expected: list[str]) -> None:
    """gas-10 is not gas-100."""
    assert chosen(parts(7), only, fits) == expected


def test_all_parts_are_measured_unless_some_are_named() -> None:
    """The whole runs first, then every scene in every size, and three piles."""
    assert len(parts(7)) == len(whole_runs.SCENES) + sum(map(len, SIZES.values())) + 3
    quick = [*measure.QUICK_RUNS, *measure.QUICK, "standing"]
    assert list(parts(7, quick=True)) == quick


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"only": ["gas-7"]}, "only must name some of run-gas-10"),
        ({"repeats": 0}, "repeats must be"),
    ],
)
def test_measurement_that_is_none_is_refused(options: Any, words: str) -> None:
    """Before anything is measured."""
    with pytest.raises(ValueError, match=words):
        measure_speed(**options)


def test_measurement_without_a_compiler_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """The message says what is missing."""
    monkeypatch.setattr(
        "lesson_code.evidence.speed.engines.why_no_compiler", lambda: "Numba is not installed"
    )
    with pytest.raises(RuntimeError, match="compiled code: Numba is not installed"):
        measure_speed(only=["gas-10"])


def piles(ours: float = 1.0) -> PileRace:
    """Return a made-up race with a stack; ours: the time of the sequential solver, s."""
    rows = (
        Held("sequential", 8, True, 0.005, ours),
        Held("substep", 2, False, 0.3, 0.1),
        Held("pymunk, tree", 30, True, 0.005, 3.0),
        Held("pymunk, hash", 60, False, 0.3, 0.1),
    )
    return PileRace("standing", "a free stack of 20 for 60 s", rows)


def everything() -> Speed:
    """Return a report with made-up numbers in every part."""
    races = (
        race("gas-1000", 1_000, sequential=1e-6, exact=2e-6, tree=5e-6, hash=4e-6, box2d=2e-5),
        race("gas-100000", 100_000, sequential=1e-4, exact=2e-4, tree=5e-4, hash=4e-4, box2d=2e-3),
        race("bin-500", 500, sequential=1e-4, substep=1e-4, tree=1.6e-4),
    )
    bad = Quality(0.5, 0.5, "drift")
    return Speed(
        {"python": "3"},
        7,
        whole(),
        (with_quality(races[0], "sequential", bad), *races[1:]),
        (piles(),),
    )


def test_json_holds_every_part_without_infinity() -> None:
    """One object with a version, the facts of the machine, and whether targets are reached."""
    report = json.loads(json.dumps(everything().as_dict(), allow_nan=False))
    assert (report["version"], report["command"]) == (3, "measure speed")
    first = report["scenes"][0]
    assert {"key", "name", "bodies", "steps", "batches", "engines", "ratios"} == set(first)
    ratio = first["ratios"][0]
    assert (ratio["ours"], ratio["peer"], ratio["ratio"]) == ("sequential", "pymunk", 4.0)
    assert (ratio["wanted"], ratio["worse"], ratio["reached"]) == (4, ["overlap", "energy"], False)
    assert report["growth_exponents"]["gas"]["sequential"] == pytest.approx(1.0)
    assert report["whole_runs"]["times"][-1]["second_cpu"] is None
    assert [limit["reached"] for limit in report["whole_runs"]["limits"]] == [True, False]
    reached = {limit["what"]: limit["reached"] for limit in report["limits"]}
    assert reached["exponent of the time over the bodies, gas, sequential"] is True
    assert reached["exponent of the time over the bodies, gas, pymunk"] is None
    assert reached["a gas of 100,000, all our tables, bytes a body"] is True


def test_tables_fit_into_their_columns_and_say_what_is_reached() -> None:
    """Every ratio with what is wanted; what is worse is named."""
    text = everything().as_text(WIDTH)
    assert max(map(len, text.splitlines())) <= WIDTH
    for words in ("4 of 4", "worse overlap", "worse energy", "1.6 of 1.5 ok", "nothing kept"):
        assert words in text
    for words in ("exponent", "at most 1,000", "stack of 20", "second call, CPU s"):
        assert words in text
    assert "…" not in text


@pytest.mark.parametrize(
    ("limit", "wanted", "reached"),
    [
        (at_least("", 2.0, 2.0), "at least 2", True),
        (at_least("", 1.9, 2.0), "at least 2", False),
        (at_most("", 1_001.0, 1_000.0), "at most 1,000", False),
        (at_most("", math.nan, 1_000.0), "at most 1,000", False),
        (Limit("", 5.0), "", None),
    ],
)
def test_limit_says_whether_it_is_reached(limit: Limit, wanted: str, reached: bool | None) -> None:
    """A number that is none reaches nothing."""
    assert (limit.wanted, limit.reached) == (wanted, reached)


def test_stack_that_fell_does_not_count() -> None:
    """However little time it took."""
    (limit,) = Speed({}, 7, piles=(piles(),)).limits
    assert (limit.value, limit.wanted, limit.reached) == (3.0, "at least 2", True)
    fell = replace(piles(), rows=piles().rows[1:])
    assert Speed({}, 7, piles=(fell,)).limits == []


def test_empty_report_prints_nothing() -> None:
    """No part was asked for."""
    assert list(Speed({}, 7).tables()) == []
