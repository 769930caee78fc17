"""How two bodies' coefficients become their pair's."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule, Scene, simulate
from lesson_code.engine.core.mixing import RULES, UNSPECIFIED, mixed, mixing_rule

ROUNDING = 1e-15
"""A product and a square root, each right to 1e-16."""

coefficients = st.floats(0, 1, allow_subnormal=False)
rules = st.sampled_from(sorted(RULES))

# Of 0.25 and 0.64, and the other way round
BY_HAND = {"min": 0.25, "max": 0.64, "product": 0.16, "geometric_mean": 0.4, "mean": 0.445}


@pytest.mark.parametrize(("rule", "expected"), BY_HAND.items(), ids=BY_HAND)
def test_coefficient_worked_by_hand_is_found(rule: str, expected: float) -> None:
    """0.5 x 0.8 = 0.4 is the geometric mean of 0.25 and 0.64."""
    assert mixed(RULES[rule], 0.25, 0.64) == pytest.approx(expected, rel=ROUNDING)
    assert mixed(RULES[rule], 0.64, 0.25) == pytest.approx(expected, rel=ROUNDING)


@given(rules, coefficients, coefficients)
def test_coefficient_of_a_pair_does_not_depend_on_its_order(rule: str, a: float, b: float) -> None:
    """A and B are names: the same bits."""
    assert mixed(RULES[rule], a, b) == mixed(RULES[rule], b, a)


@given(rules.filter(lambda rule: rule != "product"), coefficients)
def test_coefficient_of_equal_bodies_is_theirs(rule: str, a: float) -> None:
    """Every rule but the product gives two equal bodies what they have."""
    assert mixed(RULES[rule], a, a) == pytest.approx(a, rel=ROUNDING, abs=1e-150)


@given(rules, coefficients)
def test_coefficient_left_open_is_the_other_bodys(rule: str, a: float) -> None:
    """A wall without a material takes no part."""
    assert mixed(RULES[rule], a, UNSPECIFIED) == mixed(RULES[rule], UNSPECIFIED, a) == a


@given(rules)
def test_coefficient_left_open_by_both_is_zero(rule: str) -> None:
    """Where nobody says anything there is no bounce and no friction."""
    assert mixed(RULES[rule], UNSPECIFIED, UNSPECIFIED) == 0.0


@pytest.mark.parametrize(
    ("name", "restitution", "friction"),
    [
        ("workbook", "min", "geometric_mean"),
        ("pymunk", "product", "product"),
        ("box2d", "max", "geometric_mean"),
    ],
)
def test_combination_of_an_engine_is_found_by_name(
    name: str, restitution: str, friction: str
) -> None:
    """The table in the module, and the default is the workbook's."""
    assert mixing_rule(name) == MixingRule(restitution, friction)
    assert mixing_rule("workbook") == MixingRule()


def test_combination_that_is_one_is_returned() -> None:
    """Any two rules may be put together."""
    own = MixingRule("mean", "min")
    assert mixing_rule(own) is own


@pytest.mark.parametrize("wrong", ["bullet", "", "min", None, 0.5, [], {}])
def test_combination_of_an_unknown_name_is_refused(wrong: Any) -> None:
    """The error says which there are."""
    with pytest.raises(ValueError, match="combine must be one of workbook, pymunk, box2d or a"):
        mixing_rule(wrong)


@pytest.mark.parametrize("wrong", ["average", "", None, 1, []])
@pytest.mark.parametrize("name", ["restitution", "friction"])
def test_combination_of_an_unknown_rule_is_refused_by_name(name: str, wrong: Any) -> None:
    """The error says which of the two, and which rules there are."""
    with pytest.raises(ValueError, match=f"{name} must be one of min, max, product, geometric_"):
        MixingRule(**{name: wrong})


@pytest.mark.parametrize(
    ("combine", "after"),
    [("workbook", 0.5), ("pymunk", 0.4), ("box2d", 0.8), (MixingRule("mean"), 0.65)],
)
def test_combination_decides_how_a_pair_bounces(combine: Any, after: float) -> None:
    """Equal discs of e = 0.5 and 0.8 meet at 1 m/s each: each leaves at the pair's e."""
    bodies = [
        Body(Circle(0.5), mass=1, position=(x, 0), velocity=(-x, 0), material=Material(e))
        for x, e in ((-1, 0.5), (1, 0.8))
    ]
    run = simulate(Scene(bodies), 1.0, combine=combine, solver="sequential")
    assert run.velocities[-1, :, 0] == pytest.approx([-after, after], rel=ROUNDING)
