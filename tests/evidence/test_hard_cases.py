"""The catalogue of hard cases: families are held by the default call, and broken laws are seen."""

from __future__ import annotations

import json
import math
from collections import Counter
from concurrent.futures import Future
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import tiers
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from lesson_code import Body, Circle, Scene
from lesson_code.evidence.hard_cases import (
    ENGINES,
    FAMILIES,
    OURS,
    Comparison,
    Draw,
    Family,
    Outcome,
    Result,
    Trial,
    catalogue,
    family,
    family_by_name,
    installed_engines,
    loads,
    measure,
    measure_hard_cases,
    replay,
    run_draw,
    run_drawn,
    seeded,
    stored,
    summed_up,
)
from lesson_code.evidence.hard_cases.measures import DT, pair_forces
from lesson_code.parallel import WorkerDiedError

FEWEST = 70
"""Families that the catalogue promises."""

WIDTH = 100
"""Columns: the table fits a page."""

EXAMPLES = 3
"""Draws of each family that Hypothesis makes; of a long one it makes one."""


# The laws


@pytest.mark.full
@pytest.mark.parametrize("known", FAMILIES, ids=lambda known: known.name)
def test_default_call_holds_the_law(known: Family) -> None:
    """The bound stands in the catalogue, with its reason."""

    @settings(
        max_examples=1 if known.is_long else EXAMPLES,
        phases=(Phase.generate,),
        suppress_health_check=list(HealthCheck),
    )
    @given(data=st.data())
    def holds(data: st.DataObject) -> None:
        outcome = run_drawn(known, OURS, Draw(lambda: data.draw(st.floats(0.0, 1.0))))
        assert outcome.held, f"{outcome.value} {outcome.error}: {dict(outcome.parameters)}"

    holds()


@pytest.mark.parametrize("name", ["load-on-box", "momentum", "collapse", "cradle-with-gaps"])
def test_seeded_draws_hold_the_law(name: str) -> None:
    """One family of some themes in the quick tier, too."""
    for seed in range(tiers.share(3)):
        assert run_draw(family_by_name(name), OURS, seed).held


def test_pair_forces_of_a_step_in_parts_sums_the_impulses_of_all_parts() -> None:
    """The load of seed 520026 has an impact in its last step; F = m (g + dv/dt) over both parts.

    What rounding leaves of a velocity of the load, 5e8 kg, is taken from it without a force.
    """
    scene = loads.loaded(Draw(seeded("forces-under-load", 520026)))
    run = Trial(OURS).run(scene, 1.0, sample=None)
    masses = [float(body.mass or 0.0) for body in scene.bodies[1:]]
    forces = pair_forces(run)
    change = (run.velocities[-1] - run.velocities[-2])[1:, 1] / DT
    assert forces[0, 1] == pytest.approx(
        sum(m * (10.0 + a) for m, a in zip(masses, change, strict=True)), rel=1e-6
    )


def test_corner_that_turns_by_above_the_floor_is_not_held_off() -> None:
    """At that seed a step looks at the corner four times, at gaps down to 9e-5 m, without a hit."""
    assert run_draw(family_by_name("polygon-over-floor"), OURS, 3100099).held


# The catalogue


def test_catalogue_has_as_many_families_as_it_promises_each_once() -> None:
    """Names and titles are unique."""
    assert len(FAMILIES) >= FEWEST
    for names in ([known.name for known in FAMILIES], [known.title for known in FAMILIES]):
        assert max(Counter(names).values()) == 1


@pytest.mark.parametrize("known", FAMILIES, ids=lambda known: known.name)
def test_every_family_says_what_it_is(known: Family) -> None:
    """A bound is finite, and everything that is to be read is a sentence or a formula."""
    assert 0.0 <= known.bound < math.inf
    for text in (known.theme, known.title, known.why, known.law, known.reason):
        assert len(text) > 3
    assert known.why.endswith(".")


def test_unknown_family_is_refused_with_the_known_ones() -> None:
    """A mistyped name is answered with all of them."""
    with pytest.raises(ValueError, match=r"name must be one of load-on-box, .*, got 'heavy'"):
        family_by_name("heavy")


# Draws


def test_draw_is_the_same_for_one_seed_and_another_for_the_next() -> None:
    """Seed and family name decide."""

    def values(name: str, seed: int) -> dict[str, Any]:
        draw = Draw(seeded(name, seed))
        draw.log_uniform("ratio", 1e-9, 1e9)
        draw.uniform("x", -1.0, 1.0)
        draw.integer("count", 2, 64)
        draw.choice("way", ("left", "right"))
        return draw.values

    assert values("a", 3) == values("a", 3)
    assert values("a", 3) != values("a", 4)
    assert values("a", 3) != values("b", 3)


@given(share=st.floats(0.0, 1.0))
def test_draws_stay_in_their_ranges(share: float) -> None:
    """Both ends included."""
    draw = Draw(lambda: share)
    assert -1.5 <= draw.uniform("x", -1.5, 0.1) <= 0.1
    assert 1e-9 <= draw.log_uniform("ratio", 1e-9, 1e9) <= 1e9
    assert draw.integer("count", 2, 4) in (2, 3, 4)
    assert draw.choice("way", ("left", "right")) in ("left", "right")


@pytest.mark.parametrize(("share", "expected"), [(0.0, (1e-9, 2, "a")), (1.0, (1e9, 4, "b"))])
def test_draws_reach_both_ends(share: float, expected: tuple[float, int, str]) -> None:
    """What stands on a border is drawn where the source says so."""
    draw = Draw(lambda: share)
    found = (
        draw.log_uniform("ratio", 1e-9, 1e9),
        draw.integer("count", 2, 4),
        draw.choice("which", ("a", "b")),
    )
    assert found[0] == pytest.approx(expected[0], rel=1e-14)
    assert found[1:] == expected[1:]


def test_draw_refuses_what_it_cannot_draw() -> None:
    """A name twice, an empty range, no logarithm, a negative seed."""
    draw = Draw(lambda: 0.5)
    draw.uniform("x", 0.0, 1.0)
    with pytest.raises(ValueError, match="name must be drawn once, got 'x' again"):
        draw.uniform("x", 0.0, 1.0)
    with pytest.raises(ValueError, match=r"low must be <= high for y, got 2.0 and 1.0"):
        draw.uniform("y", 2.0, 1.0)
    with pytest.raises(ValueError, match=r"low must be > 0 for y, got 0.0"):
        draw.log_uniform("y", 0.0, 1.0)
    with pytest.raises(ValueError, match="seed must be >= 0, got -1"):
        seeded("a", -1)


# A check that can fail


@family(
    "Tests",
    why="It is wrong on purpose.",
    law="A ball that flies freely for a second comes to rest.",
    unit="m/s",
    bound=1.5,
    reason="a test",
)
def broken_law(draw: Draw, trial: Trial) -> float:
    """Ball that flies on."""
    speed = draw.uniform("speed", 1.0, 2.0)
    ball = Scene([Body(Circle(1.0), mass=1.0, velocity=(speed, 0))])
    return float(trial.run(ball, 1.0).velocities[-1, 0, 0])


def test_broken_law_is_reported_with_its_draws() -> None:
    """Share, worst draw, and where it begins to fail: the mildest failing one."""
    outcomes = [run_draw(broken_law, OURS, seed) for seed in range(12)]
    speeds = {o.seed: float(o.parameters["speed"]) for o in outcomes}
    over = [speed for speed in speeds.values() if speed > 1.5]
    result = summed_up(outcomes)
    assert (result.draws, result.held) == (12, 12 - len(over))
    assert speeds[result.worst_seed] == result.worst == max(over)
    assert result.fails_from == {"speed": min(over)}
    assert result.fails_seed is not None
    assert speeds[result.fails_seed] == min(over)


@pytest.mark.parametrize(
    ("value", "held"),
    [(0.0, True), (1.5, True), (1.6, False), (math.inf, False), (math.nan, False)],
)
def test_bound_is_held_up_to_itself_and_never_by_nan(value: float, held: bool) -> None:
    """A number that is none holds nothing."""
    outcome = run_draw(replace(broken_law, measure=lambda _draw, _trial: value), OURS, 0)
    assert outcome.held is held
    assert outcome.error == ("" if math.isfinite(value) else "no finite number")


def test_exception_of_an_engine_is_an_outcome() -> None:
    """No value, its words, and what had been drawn by then."""

    def refuses(draw: Draw, _trial: Trial) -> float:
        draw.integer("count", 1, 1)
        raise RuntimeError("no end")

    outcome = run_draw(replace(broken_law, measure=refuses), OURS, 0)
    assert math.isnan(outcome.value)
    assert outcome.error == "RuntimeError: no end"
    assert outcome.parameters == {"count": 1}
    assert summed_up([outcome]).fails_from == {"count": 1}


@pytest.mark.parametrize("name", ["oblique-discs", "load-on-box", "box-on-slope"])
def test_naive_is_found_out(name: str) -> None:
    """The lesson's first attempt has neither friction nor a second look."""
    assert not run_draw(family_by_name(name), "naive", 0).held


@pytest.mark.parametrize("engine", ENGINES)
def test_trial_gives_an_engine_no_settings_but_the_step(
    engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ours is the default call; a peer is that with its name."""
    asked: list[dict[str, Any]] = []
    monkeypatch.setattr(
        "lesson_code.evidence.hard_cases.trial.simulate",
        lambda _scene, _duration, **options: asked.append(options),
    )
    Trial(engine).run(Scene(), 1.0)
    Trial(engine).run(Scene(), 1.0, sample=None, dt=0.5)
    named = {} if engine == OURS else {"solver": engine}
    assert asked == [{"sample": "end", **named}, {"sample": None, "dt": 0.5, **named}]


def test_trial_refuses_unknown_engines() -> None:
    """Before anything is run."""
    with pytest.raises(ValueError, match=r"engine must be one of ours, .*, got 'mine'"):
        Trial("mine")


# All of them together


def test_comparison_is_the_same_for_one_worker_and_for_two() -> None:
    """Only the seconds differ."""
    names = ["collapse", "infinite-inertia"]
    one, two = (measure_hard_cases(names, workers=n).as_dict() for n in (1, 2))
    for known in one["families"] + two["families"]:
        for result in known["results"].values():
            result.pop("seconds")
    assert one == two
    assert [known["name"] for known in one["families"]] == names
    assert one["engines"] == list(installed_engines())
    assert {r["draws"] for known in one["families"] for r in known["results"].values()} == {3}


def test_measuring_refuses_what_it_does_not_know() -> None:
    """Before anything is run."""
    with pytest.raises(ValueError, match=r"engine must be one of ours, .*, got 'rapier'"):
        measure_hard_cases(["collapse"], engines=["rapier"])
    with pytest.raises(ValueError, match="draws must be >= 1, got 0"):
        measure_hard_cases(["collapse"], draws=0)
    with pytest.raises(ValueError, match="seed must be >= 0, got -2"):
        measure_hard_cases(["collapse"], seed=-2)


def test_replay_gives_back_the_draw_of_the_comparison() -> None:
    """The same figure, and the parameters by name."""
    result = measure_hard_cases(["load-on-box"], engines=[OURS], workers=1).results[0]
    again = replay("load-on-box", result.worst_seed, engines=[OURS, "naive"])
    assert again.outcomes[0].value == result.worst
    assert {"ratio", "friction", "start"} <= set(again.parameters)
    told = again.as_dict()
    assert (told["family"], told["seed"]) == ("load-on-box", result.worst_seed)
    assert list(told["engines"]) == [OURS, "naive"]
    assert "ratio" in again.as_text(WIDTH)


def one_dies(function: Any, tasks: Any, **_options: Any) -> Any:
    """Do the tasks here; pymunk takes its worker with it."""
    for n, task in enumerate(tasks):
        future: Future[Any] = Future()
        if task[1] == "pymunk":
            future.set_exception(WorkerDiedError("signal 6"))
        else:
            future.set_result(function(task))
        yield n, future


def test_dead_process_is_no_result_in_that_draw(monkeypatch: pytest.MonkeyPatch) -> None:
    """The others go on."""
    monkeypatch.setattr(measure, "iter_tasks", one_dies)
    both = measure_hard_cases(["collapse"], draws=2, engines=[OURS, "pymunk"])
    assert (both.not_held(), both.not_held("pymunk")) == ([], ["collapse"])
    written = both.as_dict()["families"][0]["results"]["pymunk"]
    assert (written["worst"], written["held"], written["draws"]) == (None, 0, 2)
    assert written["error"] == "the process died: signal 6"
    assert "0/2x      -" in both.as_text(WIDTH)


def some_results() -> Comparison:
    """Return a comparison of two engines in one family."""
    return Comparison(
        (
            Result("zeno", OURS, 3, 3, 0.25, 1, seconds=3.0),
            Result("zeno", "naive", 3, 1, math.nan, 2, "x", 0, {"height": 1.5, "n": 2}, 1.0),
        )
    )


def test_stored_file_gives_back_what_was_stored(tmp_path: Path) -> None:
    """Figures, seeds, parameters and errors."""
    kept = some_results()
    kept.store(tmp_path / "kept.json")
    assert repr(Comparison.stored(tmp_path / "kept.json")) == repr(kept)
    assert '"worst": null' in (tmp_path / "kept.json").read_text()


def test_what_is_measured_anew_stands_in_the_place_of_the_old() -> None:
    """A family or an engine alone, in the order of the catalogue."""
    anew = Result("zeno", "naive", 5, 5, 0.0, 0), Result("crowd", OURS, 4, 4, 0.0, 0)
    merged = some_results().merged(Comparison(anew))
    told = [(result.family, result.engine, result.draws) for result in merged.results]
    assert told == [("crowd", OURS, 4), ("zeno", OURS, 3), ("zeno", "naive", 5)]


def test_stored_file_of_another_version_is_refused(tmp_path: Path) -> None:
    """Its keys may mean something else."""
    (tmp_path / "old.json").write_text(json.dumps({"version": 1}))
    with pytest.raises(ValueError, match=r"version must be 2, got 1"):
        stored(tmp_path / "old.json")


def test_comparison_counts_families_and_draws() -> None:
    """Held in every draw, and the share of all draws."""
    kept = some_results()
    assert (kept.holds(OURS), kept.holds("naive")) == (1, 0)
    assert kept.share("naive") == pytest.approx(1 / 3)
    assert kept.not_held("naive") == ["zeno"]


def test_stored_results_are_of_this_catalogue() -> None:
    """Every family, in its order, by every engine. Regenerate it with --store."""
    kept = stored()
    assert kept.names == tuple(known.name for known in FAMILIES)
    assert {OURS, "naive", "pymunk"} <= set(kept.engines)
    assert len(kept.results) == len(FAMILIES) * len(kept.engines)
    bounds = {known["name"]: known["bound"] for known in json.loads(_stored_text())["families"]}
    assert bounds == {known.name: known.bound for known in FAMILIES}


def _stored_text() -> str:
    return Comparison.file.read_text(encoding="utf-8")


def test_families_tell_other_engines_from_the_law() -> None:
    """A catalogue that everybody holds would show nothing."""
    assert len(stored().not_held("pymunk")) > len(FAMILIES) / 3


def test_table_fits_a_page_and_names_every_family() -> None:
    """100 columns, no line broken."""
    text = stored().as_text(WIDTH)
    assert max(map(len, text.splitlines())) <= WIDTH
    for known in FAMILIES:
        assert f"\n {known.name} " in text


def test_themes_stand_together() -> None:
    """In the order of the catalogue, none twice."""
    assert list(catalogue.by_theme()) == list(dict.fromkeys(known.theme for known in FAMILIES))
    assert [f for theme in catalogue.by_theme().values() for f in theme] == list(FAMILIES)


def test_outcome_of_no_seed_is_a_draw_by_other_means() -> None:
    """Hypothesis has no seeds of ours."""
    outcome: Outcome = run_drawn(broken_law, OURS, Draw(lambda: 1.0))
    assert (outcome.seed, outcome.value, outcome.parameters) == (-1, 2.0, {"speed": 2.0})
