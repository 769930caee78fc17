"""Coefficients for Box2D: whatever it is given, each pair gets ours, once. No test needs Box2D."""

from __future__ import annotations

import math
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule
from lesson_code.engine.core.mixing import MIXING_RULES
from lesson_code.reference.box2d_reference.surfaces import Surface, surfaces
from lesson_code.reference.scene_mapping import coefficients

COEFFICIENTS = st.one_of(st.none(), st.sampled_from([0.0, 0.25, 0.3, 0.5625, 1.0]))


def bodies_of(materials: list[Material]) -> list[Body]:
    """Return a disc of each material."""
    return [Body(Circle(1.0), mass=1.0, material=material) for material in materials]


def meet(one: Surface, other: Surface) -> bool:
    """Return whether two shapes collide, by Box2D's rule of filters."""
    return bool(one.category & other.mask and other.category & one.mask)


@given(
    st.lists(st.builds(Material, COEFFICIENTS, COEFFICIENTS), min_size=2, max_size=8),
    st.sampled_from([*MIXING_RULES.values(), MixingRule("mean", "min")]),
)
def test_each_pair_meets_once_with_our_coefficients(
    materials: list[Material], combine: MixingRule
) -> None:
    """One shape of the one meets one of the other; Box2D's rule makes of their values our pair's.

    The square root of a square may be off by a rounding.
    """
    bodies = bodies_of(materials)
    for (a, own), (b, others) in combinations(
        zip(bodies, surfaces(bodies, combine), strict=True), 2
    ):
        ((one, other),) = [(s, t) for s in own for t in others if meet(s, t)]
        made = max(one.restitution, other.restitution), math.sqrt(one.friction * other.friction)
        assert made == pytest.approx(coefficients(combine, a.material, b.material), rel=1e-15)


def test_more_materials_than_bits_are_refused() -> None:
    """Nine kinds need 81 bits of 64; by Box2D's own rule they need none."""
    bodies = bodies_of([Material(n / 10) for n in range(9)])
    with pytest.raises(ValueError, match=r"materials must be of at most 8 kinds for .* got 9$"):
        surfaces(bodies, MixingRule("min"))
    assert all(len(own) == 1 for own in surfaces(bodies, MIXING_RULES["box2d"]))
