"""Values that another engine's rule turns into our pairs' coefficients, to the last bit."""

from __future__ import annotations

from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule, Segment
from lesson_code.engine.core.mixing import MIXING_RULES, RULES, mixed
from lesson_code.reference.scene_mapping import coefficients, own_values

COEFFICIENTS = st.one_of(st.none(), st.sampled_from([0.0, 0.25, 0.3, 0.5625, 1.0]))


def bodies_of(materials: list[Material], static: int = 1) -> list[Body]:
    """Return a body for each material; the first ones cannot be pushed."""
    return [
        Body(Segment((-1, 0), (1, 0)) if n < static else Circle(1.0),
        mass=None if n < static else 1.0,
        material=material,
    ) for n, material in enumerate(materials)]  # fmt: skip


@given(
    st.lists(st.builds(Material, COEFFICIENTS, COEFFICIENTS), min_size=2, max_size=5),
    st.integers(0, 2),
    st.sampled_from(list(MIXING_RULES.values())),
    st.sampled_from([MIXING_RULES["pymunk"], MIXING_RULES["box2d"]]),
)
def test_values_that_are_given_make_every_pair_ours(
    materials: list[Material], static: int, ours: MixingRule, theirs: MixingRule
) -> None:
    """Whatever the materials: where values are found, their rule makes of them what ours does."""
    bodies = bodies_of(materials, static)
    values = own_values(bodies, ours, theirs)
    if values is None:
        return
    for (a, given_a), (b, given_b) in combinations(zip(bodies, values, strict=True), 2):
        if not (a.is_static and b.is_static):
            made = (
                mixed(RULES[theirs.restitution], given_a[0], given_b[0]),
                mixed(RULES[theirs.friction], given_a[1], given_b[1]),
            )
            assert made == coefficients(ours, a.material, b.material)


@pytest.mark.parametrize(
    ("materials", "engine", "expected"),
    [
        ([Material(), Material(1.0)], "pymunk", [(1, 0), (1, 0)]),
        ([Material(), Material(0, 0.5625)] * 2, "pymunk", None),
        ([Material(), *[Material(0, 0.5625)] * 2], "pymunk", [(1, 0.75), (0, 0.75), (0, 0.75)]),
        ([Material(), *[Material(0, 0.6)] * 2], "box2d", [(0, 0.6), (0, 0.6), (0, 0.6)]),
        ([*[Material(0.4)] * 2, Material(0.8)], "box2d", None),
    ],
    ids=["one ball", "two that say nothing", "boxes on a floor", "the same", "smaller and larger"],
)
def test_values_of_common_scenes(
    materials: list[Material], engine: str, expected: list[tuple[float, float]] | None
) -> None:
    """Of our rule, the smaller and the geometric mean, worked by hand."""
    assert own_values(bodies_of(materials), MixingRule(), MIXING_RULES[engine]) == expected
