"""What a scene is made of: what is filled in, what is refused, and that nothing can be changed."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Callbacks, Circle, Material, Polygon, Scene, Segment

ROUNDING = 1e-15
"""A moment of inertia is a dozen operations on numbers of about 1."""

DISC = Circle(0.5)
ROD = Segment((-3, 0), (3, 0))

# Material


def test_material_that_says_nothing_leaves_both_open() -> None:
    """None is not 0: the other body decides."""
    assert (Material().restitution, Material().friction) == (None, None)


def test_material_of_whole_numbers_holds_floats() -> None:
    """A coefficient of 1 is stored as 1.0."""
    material = Material(restitution=1, friction=2)
    assert (type(material.restitution), type(material.friction)) == (float, float)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"restitution": -0.1}, "restitution must be between 0 and 1, got -0.1"),
        ({"restitution": 1.5}, "restitution must be between 0 and 1, got 1.5"),
        ({"restitution": math.nan}, "restitution must be between 0 and 1, got nan"),
        ({"friction": -0.1}, "friction must be >= 0 and finite, got -0.1"),
        ({"friction": math.inf}, "friction must be >= 0 and finite, got inf"),
        ({"friction": math.nan}, "friction must be >= 0 and finite, got nan"),
        ({"friction": [0.1, 0.2]}, "friction must be one number"),
    ],
)
def test_material_out_of_range_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """The error names the argument, the rule and the value."""
    with pytest.raises(ValueError, match=message):
        Material(**wrong)


# Body

INERTIAS = {
    "disc: m r^2 / 2": (DISC, 4, 0.5),
    "plate: m (w^2 + h^2) / 12": (Polygon.box(2, 4), 3, 5),
    "rod: m L^2 / 12": (ROD, 2, 6),
    "triangle, from its centroid": (Polygon([(0, 0), (0, 3), (3, 0)]), 1, 1),  # (a^2 + b^2) / 18
}


@pytest.mark.parametrize(("shape", "mass", "inertia"), INERTIAS.values(), ids=INERTIAS)
def test_inertia_left_out_is_that_of_the_filled_shape(
    shape: Any, mass: float, inertia: float
) -> None:
    """Textbook moments about the centre of mass."""
    assert Body(shape, mass=mass).inertia == pytest.approx(inertia, rel=ROUNDING)


def test_inertia_that_is_given_is_kept() -> None:
    """A hoop has m r^2, twice the disc's; infinite: the body never turns."""
    assert Body(DISC, mass=4, inertia=1).inertia == 1.0
    assert Body(DISC, mass=4, inertia=math.inf).inertia == math.inf


@pytest.mark.parametrize("mass", [None, math.inf], ids=["none", "infinite"])
def test_body_without_a_finite_mass_is_static(mass: float | None) -> None:
    """Both ways of writing it mean the same, and it has no inertia either."""
    wall = Body(DISC, mass=mass)
    assert (wall.is_static, wall.mass, wall.inertia) == (True, None, None)
    assert not Body(DISC, mass=1).is_static


def test_static_body_may_move() -> None:
    """A moving wall: nothing can push it, but it has a velocity."""
    wall = Body(ROD, velocity=(1, 0), angular_velocity=2)
    assert (wall.velocity, wall.angular_velocity, wall.is_static) == ((1.0, 0.0), 2.0, True)


def test_static_segment_need_not_be_centred_on_its_body() -> None:
    """A floor is drawn in the world's own coordinates; only what turns freely needs a centre."""
    assert Body(Segment((5, 1), (9, 1))).position == (0.0, 0.0)


def test_body_of_arrays_holds_plain_floats() -> None:
    """An array that changes later cannot change the body."""
    place = np.array([1, 2])
    body = Body(DISC, position=place, velocity=place, mass=1)
    place += 5
    assert (body.position, body.velocity) == ((1.0, 2.0), (1.0, 2.0))
    assert {type(x) for x in body.position + body.velocity} == {float}


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"mass": 0}, "mass must be > 0 kg, got 0"),
        ({"mass": -1}, "mass must be > 0 kg, got -1"),
        ({"mass": math.nan}, "mass must be > 0 kg, got nan"),
        ({"mass": 1, "inertia": 0}, r"inertia must be > 0 kg m\^2, got 0"),
        ({"mass": 1, "inertia": -2}, r"inertia must be > 0 kg m\^2, got -2"),
        ({"mass": 1, "inertia": math.nan}, r"inertia must be > 0 kg m\^2, got nan"),
        ({"mass": 5e-324}, r"inertia must be > 0 kg m\^2, got 0.0"),  # too small for a number
        ({"inertia": 2.0}, "inertia must be left out of a body without a mass, got 2.0"),
        ({"mass": math.inf, "inertia": 2.0}, "inertia must be left out of a body without a mass"),
        ({"position": (math.nan, 0)}, "position must be finite, got nan"),
        ({"position": (1, 2, 3)}, r"position must have shape \(\.\.\., 2\), got shape \(3,\)"),
        ({"position": [(1, 2), (3, 4)]}, r"position must have shape \(2,\), got shape \(2, 2\)"),
        ({"velocity": (0, math.inf)}, "velocity must be finite, got inf"),
        ({"angle": math.nan}, "angle must be finite, got nan"),
        ({"angular_velocity": -math.inf}, "angular_velocity must be finite, got -inf"),
    ],
)
def test_body_out_of_range_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """The error names the argument, the rule and the value."""
    with pytest.raises(ValueError, match=message):
        Body(DISC, **wrong)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"shape": "disc"}, "shape must be a Circle or Polygon or Segment, got 'disc'"),
        ({"material": None}, "material must be a Material, got None"),
        ({"material": 0.5}, "material must be a Material, got 0.5"),
        ({"mass": "heavy"}, "mass must be a real number or an array of them, got 'heavy'"),
        ({"position": ("here", "there")}, "position must be a real number or an array"),
    ],
)
def test_body_of_another_kind_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """What is not of the right kind is a TypeError."""
    with pytest.raises(TypeError, match=message):
        Body(**{"shape": DISC, "mass": 1} | wrong)


@pytest.mark.parametrize("bodies", [None, Body(DISC, mass=1)])
def test_scene_of_no_list_is_refused_by_name(bodies: Any) -> None:
    """A single body is no list of bodies."""
    with pytest.raises(TypeError, match=r"bodies must be a list or tuple, got (None|Body)"):
        Scene(bodies)


def test_body_takes_all_but_its_shape_by_name() -> None:
    """Nobody has to remember the order of six numbers."""
    with pytest.raises(TypeError, match="positional"):
        Body(DISC, (0, 0))  # type: ignore[misc]


@pytest.mark.parametrize("shift", [1.0, 1e-6])
def test_rod_off_its_centre_of_mass_is_refused(shift: float) -> None:
    """A rod turns about its body's position, so that has to be its middle."""
    with pytest.raises(ValueError, match=r"a segment with a mass must be centred .*end = -start"):
        Body(Segment((-3 + shift, 0), (3 + shift, 0)), mass=1)


def test_rod_centred_but_for_rounding_is_accepted() -> None:
    """0.1 + 0.2 is not 0.3, and means it."""
    assert Body(Segment((-0.3, 0), (0.1 + 0.2, 0)), mass=1).mass == 1.0


@pytest.mark.parametrize(
    ("vertices", "message"),
    [
        ([(0, 0), (2, 0), (0.5, 0.5), (0, 2)], "vertices must be convex"),
        ([(0, 0), (1, 0), (2, 0)], "vertices must have an area > 0"),
        ([(0, 0), (1, math.nan), (0, 1)], "vertices must be finite, got nan"),
        ([(0, 0), (1, 0)], r"vertices must have shape \(N, 2\)"),
    ],
    ids=["concave", "flat", "nan", "two corners"],
)
def test_body_of_a_bad_polygon_is_refused(vertices: Any, message: str) -> None:
    """The shape is checked before there is a body."""
    with pytest.raises(ValueError, match=message):
        Body(Polygon(vertices), mass=1)


# Scene


def test_scene_without_bodies_is_a_scene() -> None:
    """Nothing happens in it, without an error."""
    scene = Scene()
    assert (scene.bodies, scene.gravity, scene.damping) == ((), (0.0, 0.0), 0.0)
    assert not scene.callbacks.wanted


def test_scene_takes_its_bodies_from_anything_that_yields_them() -> None:
    """A generator is read once, and a list may change afterwards."""
    bodies = [Body(DISC, mass=1)]
    scenes = Scene(bodies), Scene(body for body in bodies)
    bodies.clear()
    assert [len(scene.bodies) for scene in scenes] == [1, 1]


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"gravity": (0, math.nan)}, "gravity must be finite, got nan"),
        ({"gravity": -9.81}, r"gravity must have shape \(\.\.\., 2\), got shape \(\)"),
        ({"damping": -1}, "damping must be >= 0 and finite, got -1"),
        ({"damping": math.nan}, "damping must be >= 0 and finite, got nan"),
    ],
)
def test_scene_out_of_range_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """The error names the argument, the rule and the value."""
    with pytest.raises(ValueError, match=message):
        Scene(**wrong)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"bodies": [Body(DISC), DISC]}, r"bodies\[1\] must be a Body, got Circle"),
        ({"callbacks": print}, "callbacks must be a Callbacks, got <built-in function print>"),
    ],
)
def test_scene_of_another_kind_is_refused_by_name(wrong: dict[str, Any], message: str) -> None:
    """The body that is none is named by its place."""
    with pytest.raises(TypeError, match=message):
        Scene(**wrong)


@pytest.mark.parametrize(
    ("made", "name"),
    [(Material(), "friction"), (Body(DISC), "mass"), (Scene(), "gravity"), (Callbacks(), "begin")],
)
def test_scene_and_its_parts_cannot_be_changed(made: Any, name: str) -> None:
    """A run can be trusted to belong to the scene that is written beside it."""
    with pytest.raises(dataclasses.FrozenInstanceError):
        setattr(made, name, None)
