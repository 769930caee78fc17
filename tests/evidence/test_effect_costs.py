"""What effects cost: calls, statistics, the stored result, and what is refused; but no time."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path

import pytest

from lesson_code.engine.effects.choice import EFFECTS, OPTIONAL
from lesson_code.evidence.effect_costs import EffectCost, EffectCosts, measure, stored
from lesson_code.evidence.effect_costs.calls import calls_for, calls_of
from lesson_code.evidence.effect_costs.result import (
    ALL,
    COMPILED,
    PLAIN,
    PYMUNK,
    FewBalls,
)
from lesson_code.evidence.effect_costs.runners import ours, pymunk_for, settings_of
from lesson_code.evidence.scenes.effects import EffectPair, pairs

PAIRS = [pytest.param(pair, id=pair.effect) for pair in pairs()]


def made_up(**times: float) -> EffectCost:
    """Return a row for friction."""
    return EffectCost("friction", PLAIN, "a | b", **times)


def result_of(*costs: EffectCost, billiards: FewBalls | None = None) -> EffectCosts:
    """Return a made-up result."""
    return EffectCosts(repeats=7, machine={"python": "3"}, billiards=billiards, costs=costs)


# Calls


@pytest.mark.one_in(9)
@pytest.mark.parametrize("pair", PAIRS)
def test_functions_of_an_effect_are_called_where_it_is_in_and_nowhere_else(
    pair: EffectPair,
) -> None:
    """Not once where it is left out; forced on, and needed, in every few steps."""
    counts = {}
    for name, (scene, asked) in settings_of(pair).items():
        engine = ours(scene, asked, compiled=False, duration=pair.duration)
        engine.advance(30)
        counts[name] = calls_for(pair.effect, engine, 12)
    assert counts["left_out"] == 0
    assert counts["needed"] > 0
    assert counts["forced"] > 0
    if pair.effect in OPTIONAL:
        assert counts["switched_off"] == 0


def test_calls_are_those_of_the_steps() -> None:
    """One fall, one look at the contacts and no damping in a step with gravity."""
    (pair,) = (pair for pair in pairs() if pair.effect == "gravity")
    counted = calls_of(ours(pair.needs, {}, compiled=False), 7)
    assert (counted["fall"], counted["find_contacts"], counted["damp"]) == (7, 7, 0)


def test_every_effect_has_functions_of_its_own() -> None:
    """Else nobody could see that it is left out."""
    assert all(effect.functions for effect in EFFECTS.values())


# Runs


@pytest.mark.parametrize("pair", PAIRS)
def test_runs_of_a_pair_are_what_the_result_calls_them(pair: EffectPair) -> None:
    """The effect is used, or not, as the fields of the row say."""
    used = {}
    for name, (scene, asked) in settings_of(pair).items():
        engine = ours(scene, asked, compiled=False, duration=pair.duration)
        used[name] = engine.plan("").effect(pair.effect).used
    expected = {"needed": True, "left_out": False, "forced": True}
    assert used == expected | ({"switched_off": False} if pair.effect in OPTIONAL else {})


def test_pymunk_is_told_what_no_scene_can_say() -> None:
    """Sleep, in the scene that needs it alone."""
    (pair,) = (pair for pair in pairs() if pair.effect == "sleeping")
    spaces = {name: engine.space for name, engine in pymunk_for(pair).items()}
    asleep = {name: math.isfinite(space.sleep_time_threshold) for name, space in spaces.items()}
    assert asleep == {"needed": True, "left_out": False, "switched_off": False}


# The result


def test_savings_are_shares_of_time() -> None:
    """By hand."""
    row = made_up(needed=4.0, left_out=3.0, forced=5.0)
    assert (row.saved, row.cheaper) == (0.4, 0.25)
    assert math.isnan(replace(row, switched_off=8.0).cheaper)
    assert math.isnan(made_up(needed=4.0).saved)


def test_limits_are_ratios_and_say_whether_they_are_reached() -> None:
    """Forced over planned, awake over asleep, and the time of the billiard balls."""
    gas = EffectCost(ALL, PLAIN, "a gas", left_out=2.0, forced=3.0)
    sleep = EffectCost("sleeping", COMPILED, "", needed=1.0, switched_off=49.0)
    pymunk = EffectCost("sleeping", PYMUNK, "", needed=1.0, switched_off=90.0)
    result = result_of(gas, sleep, pymunk, billiards=FewBalls("exact", 0.001, 0.019))
    found = [(limit.value, limit.reached) for limit in result.limits]
    assert found == [(1.5, True), (49.0, False), (0.019, True)]


def test_result_is_the_same_after_it_was_written_and_read(tmp_path: Path) -> None:
    """What is not known is null in between; the object is versioned."""
    row = made_up(needed=1.5e-5, left_out=1e-5, calls_left_out=0.0)
    result = result_of(row, billiards=FewBalls("exact", 1e-3, 2e-3))
    path = tmp_path / "stored.json"
    result.store(path)
    data = json.loads(path.read_text())
    assert (data["version"], data["command"]) == (1, "measure effects")
    assert data["costs"][0]["forced"] is None
    assert repr(EffectCosts.stored(path)) == repr(result)
    path.write_text(json.dumps(data | {"version": 2}))
    with pytest.raises(ValueError, match="version must be 1, got 2"):
        EffectCosts.stored(path)


def test_result_is_asked_by_effect_and_code() -> None:
    """A code in which nothing was measured is refused."""
    result = result_of(made_up(needed=1.0))
    assert result.of("friction", PLAIN) is result.costs[0]
    assert result.of("friction", COMPILED) is None
    with pytest.raises(ValueError, match="code must be one of plain Python, got 'compiled'"):
        result.in_code(COMPILED)


def test_tables_fit_into_100_columns_and_leave_nothing_out() -> None:
    """Every effect stands in them."""
    text = stored().as_text(100)
    for effect in EFFECTS:
        assert effect in text
    assert "..." not in text.replace("\u2026", "...")


# What is stored


def test_stored_result_has_every_effect() -> None:
    """In plain Python; compiled all but callbacks can be; in pymunk, what it has two scenes for."""
    result = stored()
    assert {row.effect for row in result.in_code(PLAIN)} == {*EFFECTS, ALL}
    compiled = {row.effect for row in result.in_code(COMPILED)}
    assert {"sleeping", "friction", "rotation", ALL} <= compiled <= {*EFFECTS, ALL} - {"callbacks"}
    in_pymunk = {pair.effect for pair in pairs() if pair.in_pymunk}
    assert {row.effect for row in result.in_code(PYMUNK)} == in_pymunk


def test_stored_result_counts_no_call_where_an_effect_is_left_out() -> None:
    """And some where it is forced on."""
    for row in stored().in_code(PLAIN):
        if row.effect != ALL:
            assert row.calls_left_out == 0.0 < row.calls_forced


def test_stored_result_reaches_what_is_wanted() -> None:
    """But for the gases where they are compiled, which is said: they save a fifth to a third."""
    missed = {limit.what for limit in stored().limits if not limit.reached}
    walls = ("discs in a box", "discs in a box of circles")
    assert missed <= {f"{wall}, compiled: all effects over those called for" for wall in walls}


# The measurement


@pytest.mark.full
def test_measurement_of_one_effect_has_its_rows() -> None:
    """In plain Python and in pymunk, with the calls beside the first."""
    result = measure.measure_effects(["damping"], quick=True, repeats=1)
    assert [(row.effect, row.code) for row in result.costs] == [
        ("damping", PLAIN),
        ("damping", PYMUNK),
    ]
    assert result.costs[0].calls_left_out == 0.0
    assert min(result.costs[0].needed, result.costs[1].left_out) > 0.0


def test_measurement_of_billiards_plans_and_runs_them() -> None:
    """By the solver that ends the run, in plain Python; planning is a part of the whole."""
    result = measure.measure_effects(["billiards"], quick=True, repeats=1)
    assert result.billiards is not None
    assert result.billiards.solver == "direct"
    assert 0.0 < result.billiards.planning < result.billiards.whole


@pytest.mark.parametrize(
    ("only", "repeats", "words"),
    [
        (["frictoin"], 1, "only must name some of collisions, .*, billiards, got 'frictoin'"),
        ([], 0, "repeats must be >= 1, got 0"),
    ],
)
def test_measurement_refuses_what_makes_no_sense(only: list[str], repeats: int, words: str) -> None:
    """Before anything is measured."""
    with pytest.raises(ValueError, match=words):
        measure.measure_effects(only, repeats=repeats)
