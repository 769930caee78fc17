"""Pairs of scenes: one needs the effect, the other does not, and they differ in little else."""

from __future__ import annotations

import pytest

from lesson_code import simulate
from lesson_code.engine.core.constants import QUIET_TIME
from lesson_code.engine.effects.choice import EFFECTS, find
from lesson_code.engine.effects.question import Question
from lesson_code.evidence.effect_costs.runners import ours
from lesson_code.evidence.scenes import effects as effect_scenes
from lesson_code.evidence.scenes.effects import EffectPair, pairs

PAIRS = [pytest.param(pair, id=pair.effect) for pair in pairs()]

CHANGED_FOR_IT = {
    "collisions": {"outlines", "restitution", "warm_starting", "position_correction"},
    "outlines": {"internal_edges"},
    "manifolds": {"rotation"},
    "friction": {"rotation"},
}
"""Effects that one of the scenes needs besides, because of the one in question."""


def called_for(pair: EffectPair, which: str) -> set[str]:
    """Return the effects that a scene of a pair calls for."""
    question = Question(getattr(pair, which), duration=pair.duration)
    return {name for name in EFFECTS if find(question, name).called_for}


def test_there_is_a_pair_for_every_effect() -> None:
    """In the order of the rules."""
    assert [pair.effect for pair in pairs()] == list(EFFECTS)


@pytest.mark.parametrize("pair", PAIRS)
def test_one_scene_needs_the_effect_and_the_other_does_not(pair: EffectPair) -> None:
    """But for the record of impulses, which every scene calls for."""
    needs, spared = (called_for(pair, which) for which in ("needs", "spared"))
    assert pair.effect in needs
    assert pair.effect not in spared or pair.effect == "impulse_record"


ALIKE = [
    "internal_edges",
    "continuous",
    "restitution",
    "rotation",
    "gravity",
    "damping",
    "callbacks",
]


@pytest.mark.parametrize("pair", [pair for pair in pairs() if pair.effect in ALIKE],
                         ids=lambda pair: pair.effect)  # fmt: skip
def test_scenes_differ_in_the_effect_alone(pair: EffectPair) -> None:
    """Gravity brings with it that nobody knows how fast bodies become."""
    brought = {"continuous"} if pair.effect == "gravity" else set()
    assert called_for(pair, "needs") - called_for(pair, "spared") == {pair.effect} | brought


def test_stacks_sleep_after_their_warm_up() -> None:
    """All of their boxes."""
    (pair,) = (pair for pair in pairs() if pair.effect == "sleeping")
    engine = ours(pair.needs, {}, compiled=False, duration=pair.duration)
    engine.advance(pair.warm_up)
    state = engine.world.state
    assert state.asleep_count == state.free_count == effect_scenes.STACKS * effect_scenes.HIGH
    assert pair.warm_up / 60 > QUIET_TIME


def test_discs_abreast_meet_or_do_not() -> None:
    """Though the run is told that collisions are to be reckoned with."""
    for meet in (True, False):
        scene = effect_scenes.abreast(meet=meet)
        run = simulate(scene, 1.0, solver="sequential", effects={"collisions": True})
        assert (len(run.contacts) > 0) is meet


def test_walls_of_circles_keep_the_gas() -> None:
    """No disc gets out in 10 s."""
    scene = effect_scenes.between_circles()
    run = simulate(scene, 2.0, solver="sequential", sample="end")
    length = max(abs(v) for body in scene.bodies[4:] for v in body.position) + 1
    assert float(abs(run.positions[-1, 4:] - length / 2).max()) < length / 2


def test_billiard_balls_hit_each_other_and_the_cushions() -> None:
    """All four are hit, two of them at once: so that the direct solver takes them."""
    run = simulate(effect_scenes.billiards(), 2.0)
    assert run.plan.solver == "direct"
    assert {int(b) for b in run.contacts.body_b} == {5, 6, 7, 8}
