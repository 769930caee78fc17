"""Wrong models of chapter 04, task 4.1: whether two circles overlap, and how."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch04_circles.right_answers import from_2_to_1_and_turned
from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any


@wrong_model("4.1", "Circle 1 pushes circle 2 along the normal. Which way does yours push it?")
@edited(
    from_2_to_1_and_turned,
    {"(-x / distance, -y / distance)": "(x / distance, y / distance)", "(1.0, 0.0)": "(-1.0, 0.0)"},
)
def normal_from_2_to_1() -> None:
    """The normal points from circle 2 to circle 1."""


@wrong_model("4.1", "How long is your normal when the centres are 3 m apart?")
@edited(from_2_to_1_and_turned, {"(-x / distance, -y / distance)": "(-x, -y)"})
def not_normalised() -> None:
    """The normal is the way from one centre to the other."""


@wrong_model("4.1", "Two circles overlap by 0.2 m. Is your depth +0.2 or -0.2?")
@edited(
    from_2_to_1_and_turned,
    {"(1.0, 0.0), r2 + r1": "(1.0, 0.0), -r2 - r1", "r2 + r1 - distance": "distance - r1 - r2"},
)
def gap_as_depth() -> None:
    """The depth is the distance of the rims: negative while the circles overlap."""


@wrong_model("4.1", "Put a coin into each corner of a box. Do coins touch whenever their boxes do?")
def boxes_for_circles(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles overlap if they do so along x and along y."""
    if np.any(np.abs(p2 - p1) >= r1 + r2):
        return None
    distance = np.hypot(*(p2 - p1))
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, r1 + r2 - distance


@wrong_model("4.1", "Two circles touch at a slant. Which way does each push the other there?")
def out_along_an_axis(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Circles are moved apart as their boxes are: along x or y, whichever is shorter."""
    way, reach = p2 - p1, r1 + r2
    if np.hypot(*way) >= reach:
        return None
    axis = int(np.argmax(np.abs(way)))
    normal = np.zeros(2)
    normal[axis] = 1.0 if way[axis] >= 0 else -1.0
    return normal, reach - abs(way[axis])


@wrong_model("4.1", "You squared the distance. What else has to be squared in the comparison?")
@edited(from_2_to_1_and_turned, {"(r2 + r1) * (r2 + r1)": "r2 + r1"})
def only_one_side_squared() -> None:
    """Circles overlap if the squared distance is less than the sum of the radii."""


@wrong_model("4.1", "Two circles just touch. How deep do they overlap, and is that an overlap?")
@edited(from_2_to_1_and_turned, {"y * y >=": "y * y >"})
def touching_counts() -> None:
    """Circles that touch in a point are in contact already, with depth 0."""


@wrong_model("4.1", "Two circles lie on the same centre. How deep do they overlap?")
@edited(from_2_to_1_and_turned, {"(1.0, 0.0), r2 + r1": "None"})
def same_centre_is_no_contact() -> None:
    """Without a direction between the centres there is no contact."""


@wrong_model("4.1", "Two circles of 1 m almost touch. How deep is the overlap by your formula?")
def root_of_the_squares(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """The depth is the root of the difference of the squares, as in a right triangle."""
    distance = np.hypot(*(p2 - p1))
    if distance >= r1 + r2:
        return None
    normal = (p2 - p1) / distance if distance > 0 else np.array([1.0, 0.0])
    return normal, np.sqrt((r1 + r2) ** 2 - distance**2)


@wrong_model("4.1", "Two circles overlap deeply. How long is the way between their centres then?")
@edited(
    from_2_to_1_and_turned,
    {"return (-x / distance, -y / distance)": "return (-x / (r1 + r2), -y / (r1 + r2))"},
)
def divided_by_the_reach() -> None:
    """The centres of circles in contact are r1 + r2 apart, so that makes the normal a unit."""


@wrong_model("4.1", "A coin lies half on another one. Is its middle inside of the other?")
@edited(from_2_to_1_and_turned, {"(r2 + r1) * (r2 + r1)": "max(r1, r2) ** 2"})
def centre_in_the_other() -> None:
    """Circles overlap when the centre of one lies inside the other."""


@wrong_model("4.1", "How far is it from the centre to the rim: r, or half of it?")
def radii_for_diameters(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Half of r1 and r2 reaches from the centre to the rim."""
    distance, reach = np.hypot(*(p2 - p1)), (r1 + r2) / 2
    if distance >= reach:
        return None
    return (p2 - p1) / distance if distance else np.array([1.0, 0.0]), reach - distance


@wrong_model(
    "4.1", "Two circles of 1 m just overlap. Which unit has your depth, and how large is it?"
)
@edited(
    from_2_to_1_and_turned,
    {
        "(1.0, 0.0), r2 + r1": "(1.0, 0.0), (r2 + r1) ** 2",
        "r2 + r1 - distance": "(r2 + r1) ** 2 - distance**2",
    },
)
def depth_by_the_squares() -> None:
    """The depth is the difference of the squares that were compared."""


@wrong_model("4.1", "Two circles lie on the same centre. How long is your normal then?")
@edited(from_2_to_1_and_turned, {"(1.0, 0.0)": "(0.0, 0.0)"})
def no_direction_at_all() -> None:
    """Where the centres are the same, the normal is (0, 0)."""


@wrong_model("4.1", "The centres are a hair apart. Is there no direction between them?")
@edited(from_2_to_1_and_turned, {"distance == 0": "distance < 1e-4"})
def nearly_the_same_centre() -> None:
    """Centres that are nearly the same have no direction between them."""


@wrong_model("4.1", "The centres are a hair apart. Does that say which way circle 2 lies?")
@edited(
    from_2_to_1_and_turned,
    {
        "if distance == 0": "if distance < 1e-4",
        "return (1.0, 0.0), r2 + r1": "return (1.0, 0.0), r2 + r1 - distance",
    },
)
def too_near_for_a_direction() -> None:
    """Centres that are nearly the same have no direction, though they have a distance."""


@wrong_model("4.1", "Two circles of 1 m touch. What is r1^2 + r2^2, and what the distance squared?")
@edited(from_2_to_1_and_turned, {"(r2 + r1) * (r2 + r1)": "r1**2 + r2**2"})
def radii_squared_apart() -> None:
    """The square of r1 + r2 is r1^2 + r2^2."""


@wrong_model("4.1", "`==` compares each coordinate. Must one of them be equal, or both?")
def one_equal_coordinate_is_enough(p1: Vector, r1: float, p2: Vector, r2: float) -> Any:
    """Centres coincide if any of their coordinates do."""
    distance = np.linalg.norm(p2 - p1)
    if distance >= r1 + r2:
        return None
    normal = np.array([1.0, 0.0]) if (p1 == p2).any() else (p2 - p1) / distance
    return normal, r1 + r2 - distance
