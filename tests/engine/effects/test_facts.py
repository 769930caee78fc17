"""The facts of a scene that the rules ask for."""

from __future__ import annotations

from itertools import combinations
from random import Random

import pytest

from lesson_code import Body, Circle, Material, Scene
from lesson_code.engine.core.mixing import RULES, MixingRule, mixed
from lesson_code.engine.effects.question import Question


@pytest.mark.parametrize("rule", RULES)
def test_extremes_of_pairs_are_those_of_all_pairs_compared(rule: str) -> None:
    """500 scenes of up to six bodies, some fixed, some that leave a coefficient to the other."""
    random = Random(1)  # noqa: S311 - no secret
    for _ in range(500):
        values = [random.choice([None, 0.0, 0.3, 1.0, random.random()]) for _ in range(6)]
        bodies = [
            Body(Circle(1), mass=random.choice([None, 1.0]), material=Material(value, value))
            for value in values[: random.randrange(7)]
        ]
        pairs = [
            mixed(RULES[rule], *(-1.0 if v is None else v for v in (a, b)))
            for (a, one), (b, other) in combinations(zip(values, bodies, strict=False), 2)
            if not (one.is_static and other.is_static)
        ]
        facts = Question(Scene(bodies), combine=MixingRule(rule, rule)).facts
        assert facts.most_restitution == facts.most_friction == max(pairs, default=0.0)
        assert facts.least_restitution == min(pairs, default=0.0)
