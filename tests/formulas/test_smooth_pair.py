"""Two smooth bodies that meet: the impulse and the push between them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.formulas import collide_1d, momentum
from lesson_code.formulas.smooth_pair import separating_push, smooth_impulse

ROUNDING = 1e-12
"""Of the larger speed, or of the depth: a dozen operations, each right to 1e-16."""

angles = st.floats(-math.pi, math.pi)
masses = st.floats(1e-3, 1e3)
restitutions = st.floats(0, 1)
components = st.floats(-1e3, 1e3, allow_subnormal=False)
velocities = st.tuples(components, components)
depths = st.floats(0, 10)


def direction(angle: float) -> Any:
    """Return the unit vector at an angle."""
    return np.array([math.cos(angle), math.sin(angle)])


def after(v1: Any, m1: float, v2: Any, m2: float, normal: Any, e: float) -> tuple[Any, Any]:
    """Return both velocities after the impulse."""
    impulse = smooth_impulse(v1, m1, v2, m2, normal, e)
    return v1 - impulse / m1, v2 + impulse / m2


def speed_scale(*velocities: Any) -> float:
    """Return the largest component of some velocities, by which errors are measured."""
    return float(max(np.max(np.abs(v)) for v in velocities)) or 1.0


# Impulse

HAND = {
    "equal masses head on, elastic: they exchange": (
        ((2, 0), 1, (-2, 0), 1, (1, 0), 1.0), ((-2, 0), (2, 0)),
    ),
    "1 and 3 kg, e = 0.7, along 3-4-5": (
        # 2 n + 5 t and -n - 7 t with n = (0.6, 0.8), t = (-0.8, 0.6); V = -1/4 along n
        ((-2.8, 4.6), 1, (5.0, -5.0), 3, (0.6, 0.8), 0.7),
        ((-4 - 1.825 * 0.6, 3 - 1.825 * 0.8), (5.6 + 0.275 * 0.6, -4.2 + 0.275 * 0.8)),
    ),
    "sticking along the normal alone": (
        ((4, 1), 1, (0, 0), 3, (1, 0), 0.0), ((1, 1), (1, 0)),
    ),
    "grazing": (((3, 1), 2, (0, 1), 5, (0, 1), 0.5), ((3, 1), (0, 1))),
    "already separating": (((-1, 2), 2, (3, 0), 5, (1, 0), 0.5), ((-1, 2), (3, 0))),
    "against a wall": (((3, -4), 2, (0, 0), math.inf, (0, -1), 0.5), ((3, 2), (0, 0))),
    "a moving wall": (((0, 0), 2, (-1, 5), math.inf, (1, 0), 1.0), ((-2, 0), (-1, 5))),
}  # fmt: skip


@pytest.mark.parametrize(("given_", "expected"), HAND.values(), ids=HAND)
def test_velocities_worked_by_hand_are_found(given_: Any, expected: Any) -> None:
    """v1' = v1 - J / m1, v2' = v2 + J / m2."""
    arguments: Any = [np.array(x) if isinstance(x, tuple) else x for x in given_]
    np.testing.assert_allclose(after(*arguments), expected, atol=10 * ROUNDING)


@given(velocities, masses, velocities, masses, angles, restitutions)
def test_velocities_along_the_normal_are_those_of_one_dimension(
    v1: Any, m1: float, v2: Any, m2: float, angle: float, e: float
) -> None:
    """Along n chapter 01 holds; across n nothing changes."""
    v1, v2, n = np.array(v1), np.array(v2), direction(angle)
    t, scale = np.array([-n[1], n[0]]), speed_scale(v1, v2)
    w1, w2 = after(v1, m1, v2, m2, n, e)
    before = (v1 @ n, v2 @ n)
    expected = collide_1d(m1, before[0], m2, before[1], e) if before[0] > before[1] else before
    assert (w1 @ n, w2 @ n) == pytest.approx(expected, abs=8 * ROUNDING * scale)
    assert (w1 @ t, w2 @ t) == pytest.approx((v1 @ t, v2 @ t), abs=8 * ROUNDING * scale)


@given(velocities, masses, velocities, masses, angles, restitutions)
def test_momentum_is_kept(v1: Any, m1: float, v2: Any, m2: float, angle: float, e: float) -> None:
    """What one body loses the other gains."""
    v1, v2 = np.array(v1), np.array(v2)
    w1, w2 = after(v1, m1, v2, m2, direction(angle), e)
    error = momentum([m1, m2], [w1, w2]) - momentum([m1, m2], [v1, v2])
    assert np.max(np.abs(error)) <= ROUNDING * (m1 + m2) * speed_scale(v1, v2)


@given(velocities, masses, velocities, masses, angles, restitutions)
def test_impulse_with_the_bodies_exchanged_is_the_opposite(
    v1: Any, m1: float, v2: Any, m2: float, angle: float, e: float
) -> None:
    """Who is called 1 makes no difference, not even to the last bit."""
    n = direction(angle)
    impulse = smooth_impulse(v1, m1, v2, m2, n, e)
    assert (-smooth_impulse(v2, m2, v1, m1, -n, e)).tolist() == impulse.tolist()


def test_impulses_of_many_pairs_are_those_of_each() -> None:
    """Pairs in an array are computed as one by one."""
    rng = np.random.default_rng(4)
    v1, v2, ways = rng.uniform(-5, 5, (3, 20, 2))
    m1, m2 = rng.uniform(1, 5, (2, 20))
    normals, e = ways / np.hypot(*ways.T)[:, np.newaxis], rng.uniform(0, 1, 20)
    each = [smooth_impulse(*pair) for pair in zip(v1, m1, v2, m2, normals, e, strict=True)]
    assert smooth_impulse(v1, m1, v2, m2, normals, e).tolist() == np.array(each).tolist()


# Push


@pytest.mark.parametrize(
    ("m1", "m2", "way_1", "way_2"),
    [(1, 1, 2.5, 2.5), (1, 999, 4.995, 0.005), (math.inf, 2, 0, 5), (3, math.inf, 5, 0)],
)
def test_ways_apart_worked_by_hand_are_found(
    m1: float, m2: float, way_1: float, way_2: float
) -> None:
    """5 m are shared in inverse proportion to the masses; what is immovable stays."""
    push = separating_push(m1, m2, (0.6, 0.8), 5)
    assert push / m1 == pytest.approx([0.6 * way_1, 0.8 * way_1], abs=5 * ROUNDING)
    assert push / m2 == pytest.approx([0.6 * way_2, 0.8 * way_2], abs=5 * ROUNDING)


@given(masses, masses, angles, depths)
def test_ways_apart_add_up_to_the_depth(m1: float, m2: float, angle: float, depth: float) -> None:
    """Afterwards the bodies just touch."""
    n = direction(angle)
    push = separating_push(m1, m2, n, depth)
    assert (push / m1 + push / m2) @ n == pytest.approx(depth, abs=ROUNDING * max(depth, 1))


# What is refused

GOOD: dict[str, Any] = {
    "v1": (1, 0), "m1": 1, "v2": (0, 0), "m2": 2, "normal": (1, 0), "restitution": 0.5, "depth": 1,
}  # fmt: skip
IMPULSE, PUSH = ("v1", "m1", "v2", "m2", "normal", "restitution"), ("m1", "m2", "normal", "depth")


@pytest.mark.parametrize(
    ("formula", "names", "wrong", "message"),
    [
        (smooth_impulse, IMPULSE, {"v1": (math.nan, 0)}, "v1 must be finite, got nan"),
        (smooth_impulse, IMPULSE, {"v2": (1, 2, 3)}, r"v2 must have shape \(\.\.\., 2\)"),
        (smooth_impulse, IMPULSE, {"m1": 0}, "m1 must be > 0 kg, got 0"),
        (smooth_impulse, IMPULSE, {"m1": math.inf, "m2": math.inf}, "m1 and m2 must not both"),
        (smooth_impulse, IMPULSE, {"normal": (1, 1)}, "normal must be a unit vector"),
        (smooth_impulse, IMPULSE, {"restitution": 1.1}, "restitution must be between 0 and 1"),
        (separating_push, PUSH, {"m2": -1}, "m2 must be > 0 kg, got -1"),
        (separating_push, PUSH, {"m1": math.inf, "m2": math.inf}, "m1 and m2 must not both"),
        (separating_push, PUSH, {"normal": (0, 0)}, "normal must be a unit vector"),
        (separating_push, PUSH, {"depth": -0.1}, "depth must be >= 0 and finite, got -0.1"),
    ],
)
def test_bad_argument_is_refused_by_name(
    formula: Any, names: tuple[str, ...], wrong: dict[str, Any], message: str
) -> None:
    """The error names the argument, the rule and the value."""
    arguments = {name: GOOD[name] for name in names} | wrong
    with pytest.raises(ValueError, match=message):
        formula(**arguments)


@pytest.mark.parametrize("formula", [smooth_impulse, separating_push])
def test_arguments_are_not_changed(formula: Any) -> None:
    """A formula looks, and does not touch."""
    names = IMPULSE if formula is smooth_impulse else PUSH
    arguments = {name: np.array(GOOD[name], dtype=float) for name in names}
    before = {name: value.tolist() for name, value in arguments.items()}
    formula(**arguments)
    assert {name: value.tolist() for name, value in arguments.items()} == before
