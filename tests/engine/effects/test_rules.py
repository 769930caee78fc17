"""Which effects a scene calls for: every rule at its border.

That leaving them out changes nothing is shown in ``test_effect_bits.py``.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest

from lesson_code import Body, Callbacks, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine.core.constants import FEWEST_FOR_GRID, QUIET_TIME, SPEED_DOUBT
from lesson_code.engine.core.mixing import MIXING_RULES, MixingRule
from lesson_code.engine.effects.choice import EFFECTS, find
from lesson_code.engine.effects.question import Question

TINY = 1e-300
"""As little as one likes: a rule asks for more than 0, and not for more than something."""

SURELY = 1 + 1e-9
"""Just past a border that is computed in another order of the same few operations."""


def disc(x: float = 0.0, *surface: float | None, **rest: Any) -> Body:
    """Return a disc of 1 kg and 1 m across, whose surface is e, mu."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, 0.0), "material": Material(*surface)}
    return Body(Circle(0.5), **(given | rest))


def block(x: float = 0.0, **rest: Any) -> Body:
    """Return a square of 1 m and 1 kg."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, 0.0)}
    return Body(Polygon.box(1, 1), **(given | rest))


def floor(*surface: float | None, **rest: Any) -> Body:
    """Return a line that nothing can push."""
    return Body(Segment((-9, -1), (9, -1)), material=Material(*surface), **rest)


def calls_for(name: str, *bodies: Body, **rest: Any) -> bool:
    """Return whether the sequential solver needs an effect for some bodies."""
    asks = {key: rest.pop(key) for key in ("duration", "dt", "combine", "solver") if key in rest}
    return find(Question(Scene(bodies, **rest), **asks), name).called_for


# Coefficients


@pytest.mark.parametrize(("name", "place"), [("restitution", 0), ("friction", 1)])
@pytest.mark.parametrize(
    ("first", "second", "rule", "expected"),
    [
        (0.0, 0.0, "min", False),
        (0.0, 0.8, "min", False),
        (0.0, 0.8, "geometric_mean", False),
        (0.0, 0.8, "product", False),
        (0.0, 0.8, "max", True),
        (0.0, 0.8, "mean", True),
        (TINY, 0.8, "min", True),
        (TINY, 0.8, "geometric_mean", True),
        (None, None, "max", False),
        (None, 0.0, "max", False),
        (None, 0.8, "min", True),
        (None, 0.8, "product", True),
    ],
)
def test_coefficient_of_a_pair_decides_not_that_of_a_body(
    name: str,
    place: int,
    first: float | None,
    second: float | None,
    rule: str,
    expected: bool,
) -> None:
    """Exactly 0 on one body is enough for a minimum, a mean of roots and a product alone."""
    surfaces: list[list[float | None]] = [[None, None], [None, None]]
    surfaces[0][place], surfaces[1][place] = first, second
    bodies = [disc(0.0, *surfaces[0]), disc(1.0, *surfaces[1])]
    assert calls_for(name, *bodies, combine=MixingRule(rule, rule)) is expected


def test_product_that_is_too_small_for_a_number_calls_for_nothing() -> None:
    """1e-300 squared is 0.0, and so is what the pair is given."""
    bodies = [disc(0.0, TINY, TINY), disc(1.0, TINY, TINY)]
    asked = {"combine": MIXING_RULES["pymunk"]}
    assert not calls_for("friction", *bodies, **asked)
    assert not calls_for("restitution", *bodies, **asked)


@pytest.mark.parametrize("name", ["restitution", "friction"])
def test_coefficient_of_a_single_body_of_its_sort_makes_no_pair_with_itself(name: str) -> None:
    """A rough ball and a smooth floor; with a second rough ball there is a pair that rubs."""
    ball, smooth = disc(0.0, 0.5, 0.5), floor(0.0, 0.0)
    assert not calls_for(name, ball, smooth)
    assert calls_for(name, ball, smooth, replace(ball, position=(3, 0)))


@pytest.mark.parametrize("name", ["restitution", "friction"])
def test_coefficients_of_static_bodies_make_no_pair_of_two_of_them(name: str) -> None:
    """Two rough walls never push each other."""
    rough = floor(0.9, 0.9)
    assert not calls_for(name, rough, rough, disc(0.0, 0.0, 0.0))
    assert calls_for(name, rough, rough, disc(0.0, None, None))


@pytest.mark.parametrize("name", ["restitution", "friction"])
@pytest.mark.parametrize(
    ("callback", "expected"),
    [("begin", True), ("pre_solve", True), ("post_solve", False), ("separate", False)],
)
def test_callback_that_may_set_coefficients_calls_for_them(
    name: str, callback: str, expected: bool
) -> None:
    """Those that come after the impulses can change nothing."""
    heard = Callbacks(**{callback: print})
    assert calls_for(name, disc(0.0, 0.0, 0.0), disc(0.9, 0.0, 0.0), callbacks=heard) is expected


# Rotation


@pytest.mark.parametrize(
    ("bodies", "expected"),
    [
        ([disc(0, 1.0, 0.0), disc(1, 1.0, 0.0)], False),
        ([disc(0, 1.0, 0.1), disc(1, 1.0, 0.1)], True),
        ([disc(0, 1.0, 0.1, inertia=math.inf), disc(1, 1.0, 0.1, inertia=math.inf)], False),
        ([disc(0, 1.0, 0.1, inertia=math.inf), disc(1, 1.0, 0.1)], True),
        ([disc(0, 1.0, 0.0, angular_velocity=TINY), disc(1)], True),
        ([disc(0, 1.0, 0.0, angular_velocity=TINY, inertia=math.inf), disc(1)], True),
        ([disc(0), block(1)], True),
        ([disc(0), block(1, inertia=math.inf)], False),
        ([disc(0), Body(Polygon.box(1, 1), position=(1, 0))], False),
        ([disc(0), Body(Polygon.box(1, 1), position=(1, 0), angular_velocity=1.0)], True),
        ([disc(0), floor()], False),
    ],
)
def test_rotation_is_called_for_where_something_turns_or_may_be_turned(
    bodies: list[Body], expected: bool
) -> None:
    """By friction, by an impulse off the centre of what has corners, or from the start."""
    assert calls_for("rotation", *bodies) is expected


# Shapes


def test_outlines_manifolds_and_seams_are_called_for_by_what_has_corners() -> None:
    """The table of the three, as bodies are added."""
    slab = Body(Polygon.box(9, 1), position=(0, -1))
    rows = [
        ([disc(0), disc(1)], (False, False, False)),
        ([disc(0), disc(1), slab], (True, False, False)),
        ([disc(0), disc(1), slab, slab], (True, False, True)),
        ([disc(0), block(1)], (True, False, False)),
        ([block(0), block(1)], (True, True, False)),
        ([block(0), slab], (True, True, False)),
        ([disc(0), Body(Circle(1)), Body(Circle(1))], (False, False, True)),
    ]
    for bodies, expected in rows:
        found = tuple(
            calls_for(name, *bodies) for name in ("outlines", "manifolds", "internal_edges")
        )
        assert found == expected, bodies


def test_broad_phase_is_called_for_from_its_number_of_bodies_on() -> None:
    """Static bodies count too."""
    few = [disc(2.0 * n) for n in range(FEWEST_FOR_GRID - 1)]
    assert not calls_for("broad_phase", *few)
    assert calls_for("broad_phase", *few, floor())


# Gravity, damping


@pytest.mark.parametrize(
    ("gravity", "expected"), [((0, 0), False), ((0.0, -0.0), False), ((TINY, 0), True)]
)
def test_gravity_is_called_for_unless_it_is_zero(gravity: Any, expected: bool) -> None:
    """However weak; -0.0 is 0."""
    assert calls_for("gravity", disc(0), disc(1), gravity=gravity) is expected


@pytest.mark.parametrize(("rate", "expected"), [(0.0, False), (TINY, True)])
def test_damping_is_called_for_unless_it_is_zero(rate: float, expected: bool) -> None:
    """However weak."""
    assert calls_for("damping", disc(0), disc(1), damping=rate) is expected


# Continuous detection


def speed_at_the_border(dt: float) -> float:
    """Return the speed of one of two equal discs, 1 m wide, from which on it is watched, m/s.

    It has all the energy: sqrt(2 E / m) is its own speed. SPEED_DOUBT v dt = 1/2 m.
    """
    return 0.5 / (SPEED_DOUBT * dt)


@pytest.mark.parametrize(("times", "expected"), [(1 / SURELY, False), (SURELY, True)])
def test_continuous_is_called_for_from_a_speed_on(times: float, expected: bool) -> None:
    """Half a width in a step, with a margin."""
    v = times * speed_at_the_border(0.01)
    bodies = disc(0.0, 1.0, velocity=(v, 0)), disc(3.0, 1.0)
    assert calls_for("continuous", *bodies, dt=0.01) is expected


def test_continuous_reckons_with_all_energy_in_the_lightest_body() -> None:
    """A heavy body at a hundredth of the speed has it, and may give it to a light one."""
    v = speed_at_the_border(0.01)
    heavy = disc(0.0, 1.0, mass=1e4, velocity=(v / 100 * SURELY, 0))
    assert calls_for("continuous", heavy, disc(3.0, 1.0), dt=0.01)
    assert not calls_for("continuous", heavy, disc(3.0, 1.0, mass=1e4), dt=0.01)


def test_continuous_reckons_with_the_energy_of_spin() -> None:
    """A disc that only turns, I = m r^2 / 2, has the energy of v = w r / sqrt 2."""
    w = speed_at_the_border(0.01) * math.sqrt(2) / 0.5
    for times, expected in [(1 / SURELY, False), (SURELY, True)]:
        spins = disc(0.0, 0.0, 0.5, angular_velocity=times * w)
        assert calls_for("continuous", spins, disc(3.0, 0.0, 0.5), dt=0.01) is expected


@pytest.mark.parametrize(
    ("bodies", "rest"),
    [
        ([disc(0), disc(3)], {"gravity": (0, -1e-9)}),
        ([disc(0), disc(3)], {"callbacks": Callbacks(begin=print)}),
        ([disc(0), floor(velocity=(0, 1e-9))], {}),
        ([disc(0), floor(angular_velocity=1e-9)], {}),
        ([disc(0, 0.5, 0.5), block(3, material=Material(0.5, 0.5))], {}),
    ],
    ids=["gravity", "callbacks", "moving wall", "turning wall", "bounce and rub at a corner"],
)
def test_continuous_is_called_for_where_energy_may_come_from_somewhere(
    bodies: list[Body], rest: dict[str, Any]
) -> None:
    """No bound on the speeds is known then, however slow all is at the start."""
    assert calls_for("continuous", *bodies, **rest)


@pytest.mark.parametrize(
    ("bodies", "rest"),
    [
        ([disc(0, 0.5, 0.5), disc(3, 0.5, 0.5)], {}),
        ([disc(0, 0.0, 0.5), block(3, material=Material(0.0, 0.5))], {}),
        ([disc(0, 0.5, 0.0), block(3, material=Material(0.5, 0.0))], {}),
        ([disc(0), disc(3)], {"damping": 1.0}),
        ([disc(0), disc(3)], {"callbacks": Callbacks(separate=print)}),
    ],
    ids=["discs", "no bounce", "no friction", "damping", "a callback afterwards"],
)
def test_continuous_is_left_out_where_energy_bounds_the_speeds(
    bodies: list[Body], rest: dict[str, Any]
) -> None:
    """Nothing moves at the start here, and so nothing ever does."""
    assert not calls_for("continuous", *bodies, **rest)


# Sleep


def sleepers(**rest: Any) -> dict[str, Any]:
    """Return what is called for sleep with, but for what is said."""
    return {"gravity": (0, -10), "duration": 2 * QUIET_TIME} | rest


@pytest.mark.parametrize(
    ("rest", "expected"),
    [
        ({}, True),
        ({"gravity": (0, 0)}, False),
        ({"duration": QUIET_TIME}, False),
        ({"duration": QUIET_TIME * SURELY}, True),
        ({"duration": math.inf}, False),
        ({"callbacks": Callbacks(post_solve=print)}, False),
    ],
    ids=["usual", "weightless", "too short", "just long enough", "unknown", "callbacks"],
)
def test_sleep_is_called_for_in_long_runs_with_gravity(
    rest: dict[str, Any], expected: bool
) -> None:
    """And without anybody who has to hear of every contact."""
    assert calls_for("sleeping", disc(0), floor(), **sleepers(**rest)) is expected


def test_sleep_is_left_out_where_nothing_takes_energy() -> None:
    """E = 1 for every pair, mu = 0, no damping; any of them otherwise, and it is called for."""
    ground = floor(1.0, 0.0)
    assert not calls_for("sleeping", disc(0, 1.0, 0.0), ground, **sleepers())
    assert calls_for("sleeping", disc(0, 1.0, 0.0), ground, **sleepers(damping=0.1))
    assert calls_for("sleeping", disc(0, 0.99, 0.0), ground, **sleepers())
    assert calls_for("sleeping", disc(0, 1.0, 0.3), floor(1.0, 0.3), **sleepers())


# Collisions


def test_scene_in_which_nothing_meets_calls_for_no_effect_of_collisions() -> None:
    """Whatever its bodies are made of."""
    apart = [block(0, material=Material(0.5, 0.5)), block(9, material=Material(0.5, 0.5))]
    for name in [name for name, effect in EFFECTS.items() if effect.needs_collisions]:
        assert not calls_for(name, *apart, duration=1.0), name
    assert not calls_for("collisions", *apart, duration=1.0)
    assert calls_for("rotation", *apart, duration=1.0)  # what turns does so without them


def test_lone_bodies_call_for_no_collisions_even_if_nobody_knows_how_long_they_run() -> None:
    """One body, or static ones alone, or none."""
    for bodies in ([], [disc(0)], [floor(), floor()]):
        assert not calls_for("collisions", *bodies)
