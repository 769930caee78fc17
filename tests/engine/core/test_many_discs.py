"""Many discs made at once are those made one by one, and are refused as those are."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code import Body, Circle, Material, MixingRule, Scene, Segment, simulate
from lesson_code.engine.core.tables import arrays_of

FLOOR = Body(Segment((-9, 0), (9, 0)), material=Material(0.5, 0.5))
PLACES = [(0.0, 1.0), (3.0, 1.0), (6.0, 1.0)]

NUMBERS = st.floats(-1e6, 1e6)
DISCS = st.lists(
    st.fixed_dictionaries(
        {
            "position": st.tuples(NUMBERS, NUMBERS),
            "velocity": st.tuples(NUMBERS, NUMBERS),
            "radius": st.floats(1e-3, 1e3),
            "mass": st.floats(1e-3, 1e3) | st.just(math.inf),
            "angle": NUMBERS,
            "angular_velocity": NUMBERS,
            "material": st.builds(Material, st.none() | st.floats(0, 1), st.none() | st.just(0.3)),
        }
    ),
    min_size=1,
    max_size=5,
)


@given(DISCS)
def test_scene_of_many_discs_is_that_of_the_same_bodies(discs: list[dict[str, Any]]) -> None:
    """Every field of every body, and every bit of the tables."""
    given = {name: [disc[name] for disc in discs] for name in discs[0]}
    positions, velocities = given.pop("position"), given.pop("velocity")
    made = Scene.of_discs(positions, velocities, obstacles=[FLOOR], gravity=(0, -1), **given)
    bodies = [Body(Circle(disc.pop("radius")), **disc) for disc in discs]
    one_by_one = Scene([FLOOR, *bodies], gravity=(0, -1))
    assert made == one_by_one
    tables, others = (arrays_of(scene, 0.01, 1, MixingRule()) for scene in (made, one_by_one))
    assert all(
        np.asarray(table).tobytes() == np.asarray(other).tobytes()
        for table, other in zip(tables, others, strict=True)
        if isinstance(table, np.ndarray)
    )


def test_one_value_counts_for_all_discs() -> None:
    """And equal discs share a shape."""
    scene = Scene.of_discs(PLACES, (1, 0), radius=0.5, mass=2.0, inertia=math.inf)
    assert [body.velocity for body in scene.bodies] == [(1.0, 0.0)] * 3
    assert [body.inertia for body in scene.bodies] == [math.inf] * 3
    assert len({id(body.shape) for body in scene.bodies}) == 1


def test_discs_without_a_mass_are_static() -> None:
    """As a body without one."""
    scene = Scene.of_discs(PLACES, radius=0.5, mass=None)
    assert scene == Scene([Body(Circle(0.5), position=place) for place in PLACES])


def test_scene_of_no_disc_is_empty() -> None:
    """An array of shape (0, 2)."""
    assert Scene.of_discs(np.empty((0, 2)), radius=1.0, mass=1.0) == Scene()


def test_discs_made_at_once_move_as_those_made_one_by_one() -> None:
    """To the last bit."""
    surface = Material(0.5, 0.5)
    made = Scene.of_discs(
        PLACES, radius=0.5, mass=1.0, material=surface, obstacles=[FLOOR], gravity=(0, -9)
    )
    bodies = [Body(Circle(0.5), position=p, mass=1.0, material=surface) for p in PLACES]
    runs = [simulate(scene, 1.0) for scene in (made, Scene([FLOOR, *bodies], gravity=(0, -9)))]
    assert runs[0].positions.tobytes() == runs[1].positions.tobytes()


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"radius": [1, 0, 1]}, r"radius must be > 0 and finite, got 0.0 at index \(1,\)"),
        ({"mass": [1, 1, -1]}, r"mass must be > 0 kg, got -1.0 at index \(2,\)"),
        ({"mass": math.nan}, "mass must be > 0 kg, got nan"),
        ({"positions": [(0, 0), (0, math.nan), (1, 1)]}, r"positions must be .* at index \(1, 1\)"),
        ({"velocities": [(0, 0), (math.inf, 0), (1, 1)]}, r"velocities must be .* index \(1, 0\)"),
        ({"angle": [0, math.nan, 0]}, r"angle must be finite, got nan at index \(1,\)"),
        ({"angular_velocity": math.inf}, "angular_velocity must be finite, got inf"),
        ({"inertia": [1, 1, 0]}, r"inertia must be > 0 kg m\^2, got 0.0 at index \(2,\)"),
        ({"mass": [1, math.inf, 1], "inertia": 1.0}, "inertia must be left out .* at index 1"),
        ({"mass": 5e-324, "radius": 1e-9}, r"inertia must be > 0 kg m\^2, got 0.0"),
        ({"radius": [1, 2]}, r"radius must have shape \(\) or, .* \(3,\), got shape \(2,\)"),
        ({"velocities": [(1, 0)] * 2}, r"velocities must have shape \(2,\) or, .* \(3, 2\), got"),
        ({"positions": (0, 0)}, r"positions must have shape \(N, 2\), got shape \(2,\)"),
        ({"material": [Material()]}, "material must be one, or one for each of 3 discs, got 1"),
        ({"damping": -1.0}, "damping must be >= 0"),
    ],
)
def test_discs_out_of_range_are_refused_by_name_and_place(
    wrong: dict[str, Any], message: str
) -> None:
    """The error says which argument, which disc, the rule and the value."""
    arguments = {"positions": PLACES, "radius": 1.0, "mass": 1.0} | wrong
    with pytest.raises(ValueError, match=message):
        Scene.of_discs(**arguments)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"radius": "wide"}, "radius must be a real number"),
        ({"material": [Material(), Material(), 0.5]}, r"material\[2\] must be a Material, got 0.5"),
        ({"obstacles": [Circle(1)]}, r"bodies\[0\] must be a Body"),
    ],
)
def test_discs_of_another_kind_are_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """As for one body."""
    arguments = {"positions": PLACES, "radius": 1.0, "mass": 1.0} | wrong
    with pytest.raises(TypeError, match=message):
        Scene.of_discs(**arguments)
