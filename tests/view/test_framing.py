"""Which part of the world is shown: what moves, and what leaves it large enough to see."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.view import framing
from lesson_code.view.framing import View, view_of
from lesson_code.view.matplotlib import style
from lesson_code.view.palette import ON_WHITE

SAME: Any = {"rel": 1e-12, "abs": 1e-12}
"""The edges are a few sums and products of doubles."""


def ball(x: float = 0.0, y: float = 1.0, radius: float = 1.0) -> Body:
    """Return a disc of 1 kg."""
    return Body(Circle(radius), position=(x, y), mass=1.0)


def floor(half_length: float) -> Body:
    """Return a level floor at height 0."""
    return Body(Segment((-half_length, 0), (half_length, 0)))


def seen(scene: Scene, around: Any = None) -> View:
    """Return what is shown of a scene as it starts."""
    places = [[body.position for body in scene.bodies]]
    angles = [[body.angle for body in scene.bodies]]
    return view_of(scene, np.reshape(places, (1, -1, 2)), np.reshape(angles, (1, -1)), around)


def test_view_of_a_ball_on_an_endless_floor_is_three_diameters_wide() -> None:
    """2 km of floor are cut off: 6 m around the ball, and 6 % of that at either side."""
    assert seen(Scene([ball(), floor(1000)])) == pytest.approx((-3.36, 3.36, -2.36, 4.36), **SAME)


def test_view_holds_a_floor_of_ten_diameters_whole() -> None:
    """The ball is still a tenth of the picture; 20 m, 6 % of it, a third of that as height."""
    expected = (-11.2, 11.2, 1 - 22.4 / 6, 1 + 22.4 / 6)
    assert seen(Scene([ball(), floor(10)])) == pytest.approx(expected, **SAME)


def test_view_is_the_same_in_every_unit_of_length() -> None:
    """A scene a thousand times smaller is shown a thousand times larger."""
    large = seen(Scene([ball(), floor(10)]))
    small = seen(Scene([ball(0, 1e-3, 1e-3), floor(10e-3)]))
    assert small == pytest.approx([1e-3 * edge for edge in large], **SAME)


def test_view_comes_down_to_a_floor_far_below() -> None:
    """A ball nine diameters above an endless floor is shown together with it."""
    view = seen(Scene([ball(0, 18.0), floor(1000)]))
    assert view.bottom < 0 < 19 < view.top


def test_view_does_not_reach_for_what_is_out_of_reach() -> None:
    """A floor eleven diameters below the view is left out."""
    assert seen(Scene([ball(0, 24.0), floor(1000)])).bottom > 0


@pytest.mark.parametrize(("half_length", "whole"), [(14.0, True), (16.0, False)])
def test_floor_of_many_small_bodies_is_whole_up_to_half_as_much_again(
    half_length: float, whole: bool
) -> None:
    """Small balls over 20 m: 28 m of floor make the picture a little smaller, 32 m too much."""
    balls = [ball(x, 0.1, 0.1) for x in np.linspace(-9.9, 9.9, 30)]
    view = seen(Scene([*balls, floor(half_length)]))
    assert (view.left < -half_length) is whole


def test_small_static_bodies_come_before_large_ones() -> None:
    """Beside a ball a small wall is shown whole, and a long one that leaves no room is cut."""
    wall, long = Body(Segment((-8, 0), (-3, 0))), Body(Segment((0, 0), (24.5, 0)))
    view = seen(Scene([ball(), long, wall]))
    assert view.left < -8
    assert view.right < 24.5


def test_view_of_a_slim_stack_is_widened() -> None:
    """Its width is seven tenths of its height, so that the axes do not become a strip."""
    stack = [Body(Polygon.box(1, 1), position=(0, 0.5 + n), mass=1.0) for n in range(10)]
    view = seen(Scene([*stack, floor(100)]))
    assert view.height == pytest.approx(10 * 1.12, **SAME)
    assert view.width == pytest.approx(0.7 * view.height, **SAME)


def test_view_holds_all_places_of_a_run() -> None:
    """The view is that of all states together."""
    scene = Scene([ball()])
    view = view_of(scene, [[(0, 0)], [(30, 5)]], [[0], [0]])
    assert view.holds(View(-1, 31, -1, 6))


def test_view_around_all_holds_every_body_whole() -> None:
    """So the floor of 2 km is shown to its ends."""
    view = seen(Scene([ball(), floor(1000)]), "all")
    assert (view.left, view.right) == pytest.approx((-1120, 1120), **SAME)


def test_view_of_static_bodies_alone_shows_them_whole() -> None:
    """There is nothing else to look at."""
    view = seen(Scene([floor(1000)]))
    assert (view.left, view.right) == pytest.approx((-1120, 1120), **SAME)


def test_view_of_nothing_is_a_square_around_the_origin() -> None:
    """An empty scene has a picture too."""
    assert seen(Scene()) == View(-1, 1, -1, 1)


def test_view_that_is_asked_for_is_taken_as_it_is() -> None:
    """Without any margin."""
    assert seen(Scene([ball()]), (-1, 2, -3, 4)) == View(-1, 2, -3, 4)


@pytest.mark.parametrize("around", [(1, -1, 0, 1), (0, 1, 1, 1), (0, 1, 2), "everything"])
def test_view_out_of_order_is_refused(around: Any) -> None:
    """The message says what is right."""
    with pytest.raises(ValueError, match="around must"):
        seen(Scene([ball()]), around)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (Body(Circle(2.0), position=(1, 1)), (-1, 3, -1, 3)),
        (Body(Polygon.box(4, 2), position=(1, 0), angle=np.pi / 2), (0, 2, -2, 2)),
        (Body(Segment((0, 0), (2, 0), 0.5), angle=np.pi), (-2.5, 0.5, -0.5, 0.5)),
        (Body(Segment((1, 1), (3, 4)), position=(1, -1)), (2, 4, 0, 3)),
    ],
    ids=["circle", "turned box", "thick segment", "line"],
)
def test_box_of_a_body_touches_it_on_all_sides(body: Body, expected: Any) -> None:
    """Turned bodies included; a segment's thickness counts."""
    [box] = framing.boxes_of(Scene([body]), np.array([[body.position]]), np.array([[body.angle]]))
    assert box == pytest.approx(expected, **SAME)


def test_static_bodies_are_grey_and_the_others_take_turns_at_the_palette() -> None:
    """The seventh body that can be pushed has the first one's colour again."""
    scene = Scene([floor(1), *(ball() for _ in range(4)), floor(2), *(ball() for _ in range(3))])
    colors = framing.body_colors(scene)
    assert (colors[0], colors[5]) == (style.GREY, style.GREY)
    assert colors[1:4] == [ON_WHITE.blue, ON_WHITE.vermilion, ON_WHITE.green]
    assert len(set(colors[1:5] + colors[6:8])) == 6
    assert colors[8] == colors[1]


@pytest.mark.parametrize(
    ("length", "expected"),
    [
        (1.0, 1.0),
        (1.99, 1.0),
        (2.0, 2.0),
        (0.0051, 0.005),
        (99.0, 50.0),
        (0.1 + 0.2, 0.2),
        (0.1 * 5 - 1e-12, 0.5),
    ],
)
def test_round_length_is_1_2_or_5_times_a_power_of_ten(length: float, expected: float) -> None:
    """The largest such length that fits."""
    assert framing.round_length(length) == expected


@pytest.mark.parametrize(
    ("length", "expected"),
    [(1000, "1 km"), (500, "500 m"), (1, "1 m"), (0.5, "50 cm"), (0.01, "1 cm"), (2e-5, "0.02 mm")],
)
def test_length_is_written_in_the_unit_that_suits_it(length: float, expected: str) -> None:
    """Nobody has to count zeros."""
    assert framing.in_unit(length) == expected
