"""The measurement of speed: its arithmetic, its verdicts, what it prints; no time is asserted."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Scene, simulate
from lesson_code.evidence.measurement import Limit, at_least, at_most, chosen
from lesson_code.evidence.scenes import speed as speed_scenes
from lesson_code.evidence.scenes.speed import BUILDERS, SIZES
from lesson_code.evidence.speed import few_bodies, measure, measure_speed, processes, quality
from lesson_code.evidence.speed.engines import engines_for, start
from lesson_code.evidence.speed.few_bodies import FewBodies
from lesson_code.evidence.speed.measure import fits, parts
from lesson_code.evidence.speed.piles import PILES, Held, Pile, PileRace, race_with_pile
from lesson_code.evidence.speed.processes import Memory, Start
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
from lesson_code.evidence.speed.targets import TARGETS, target_of

pytest.importorskip("numba", reason="there is nothing to compare without compiled code")

ROUNDING = 1e-12
"""Of fits through a handful of points, and of places of some metres."""

WIDTH = 100
"""Columns that tables have to fit into."""

GOOD = Quality(overlap=0.01, energy_error=1e-4, energy_kind="drift")


def timing(engine: str, seconds: float, quality: Quality = GOOD) -> Timing:
    """Return what an engine might have done."""
    return Timing(engine, seconds, seconds, quality, 2.0, None, 0.1)


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
    growth = Speed({}, 7, races).growth_exponents
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


# The stack, few bodies, processes


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


@pytest.mark.full
def test_few_bodies_are_off_by_rounding_in_the_exact_solver_alone() -> None:
    """Pymunk's error is more than a million times as large at 60 steps a second."""
    for few in few_bodies.measure_few_bodies(1, rates=(60, 600)):
        assert few.exact_error < 1e-10
        assert few.pymunk_errors[0] > 1e6 * few.exact_error
        assert few.ratio_measured == few.pymunk_seconds[1] / few.exact_seconds


def test_ratio_at_equal_error_is_extrapolated_along_the_errors() -> None:
    """First order: an error 1,000 times smaller wants steps 1,000 times as fine."""
    few = FewBodies("", 1.0, 9, 1e-5, 1e-6, (10, 100, 1_000), (0.1, 1.0, 10.0), (0.1, 1e-2, 1e-3))
    assert few.ratio_measured == pytest.approx(1e6)
    assert few.ratio_extrapolated == pytest.approx(1e9, rel=1e3 * ROUNDING)


@pytest.mark.parametrize(
    ("errors", "expected"),
    [
        ((0.1, 0.1, 0.1), None),  # does not fall
        ((1.0, 0.9, 0.8), None),  # hardly falls
        ((1e-3, 1e-2, 1e-1), None),  # grows
        ((1e-2, 1e-4, 1e-6), 1e7),  # second order: steps ten times as fine than the finest
    ],
    ids=["flat", "hardly falls", "grows", "second order"],
)
def test_ratio_at_equal_error_is_told_only_where_errors_fall(
    errors: tuple[float, ...], expected: float | None
) -> None:
    """An error of 1e-8 m; pymunk takes a million times as long with its finest step."""
    few = FewBodies("", 1.0, 9, 1e-5, 1e-8, (10, 100, 1_000), (0.1, 1.0, 10.0), errors)
    assert few.ratio_extrapolated == (expected and pytest.approx(expected, rel=1e3 * ROUNDING))


def test_import_loads_nothing_heavy() -> None:
    """Numba, matplotlib, pygame and pymunk wait until they are used."""
    start = processes.measure_start(1, cold=False)
    assert start.loaded == ()
    assert start.importing > 0
    assert (start.cold, start.kept) == (None, None)


@pytest.mark.full
def test_memory_of_pymunk_is_measured_in_a_process_of_its_own() -> None:
    """Or not at all where the system does not tell."""
    memory = processes.measure_memory(2_000)
    assert 3 * 64 < memory.ours < 1_000
    assert memory.pymunk is None or memory.pymunk > 0


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
    assert names.index("move") < names.index("find_contacts") < names.index("solve")
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
        (["stack", "memory"], ["stack-10", "stack-20", "memory"]),
        (["gas-10"], ["gas-10"]),
    ],
)
def test_parts_are_chosen_by_name_or_by_its_beginning(only: list[str], expected: list[str]) -> None:
    """gas-10 is not gas-100."""
    assert chosen(parts(7), only, fits) == expected


def test_all_parts_are_measured_unless_some_are_named() -> None:
    """Every scene in every size, and six more."""
    assert len(parts(7)) == sum(map(len, SIZES.values())) + 6
    quick = [*measure.QUICK, "standing", "few_bodies", "memory", "start"]
    assert list(parts(7, quick=True)) == quick


@pytest.mark.parametrize(
    ("options", "words"),
    [({"only": ["gas-7"]}, "only must name some of gas-10"), ({"repeats": 0}, "repeats must be")],
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
        (with_quality(races[0], "sequential", bad), *races[1:]),
        (piles(),),
        (FewBodies("three", 1.0, 9, 1e-5, 0.0, (60, 600), (0.1, 1.0), (0.1, 0.1)),),
        Memory(1_000, 400.0, None),
        Start(0.2, ("numba",), 9.0, 0.9),
    )


def test_json_holds_every_part_without_infinity() -> None:
    """One object with a version, the facts of the machine, and whether targets are reached."""
    report = json.loads(json.dumps(everything().as_dict(), allow_nan=False))
    assert (report["version"], report["command"]) == (2, "measure speed")
    first = report["scenes"][0]
    assert {"key", "name", "bodies", "steps", "batches", "engines", "ratios"} == set(first)
    ratio = first["ratios"][0]
    assert (ratio["ours"], ratio["peer"], ratio["ratio"]) == ("sequential", "pymunk", 4.0)
    assert (ratio["wanted"], ratio["worse"], ratio["reached"]) == (4, ["overlap", "energy"], False)
    assert report["growth_exponents"]["gas"]["sequential"] == pytest.approx(1.0)
    assert report["few_bodies"][0]["ratio_extrapolated"] is None
    assert report["memory"]["pymunk"] is None
    assert report["start"]["kept"] == 0.9
    reached = {limit["what"]: limit["reached"] for limit in report["limits"]}
    assert reached["exponent of the time over the bodies, gas, sequential"] is True
    assert reached["exponent of the time over the bodies, gas, pymunk"] is None
    assert reached["first compiled run, programs kept, s"] is True


def test_tables_fit_into_their_columns_and_say_what_is_reached() -> None:
    """Every ratio with what is wanted; what is worse is named."""
    text = everything().as_text(WIDTH)
    assert max(map(len, text.splitlines())) <= WIDTH
    for words in ("4 of 4", "worse overlap", "worse energy", "1.6 of 1.5 ok", "no order"):
        assert words in text
    for words in ("exponent", "loads numba", "at most 1,000", "stack of 20"):
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
