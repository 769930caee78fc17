"""The picture: metres to pixels and back, and what is drawn where."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Segment
from lesson_code.chapters.asteroids.game import rock_colour
from lesson_code.chapters.billiards.game import CLOTH as TABLE_CLOTH
from lesson_code.chapters.pool.game import CLOTH, ball_colour
from lesson_code.view.pygame.picture import COLOURS, FAR, WALL, Camera, Picture, is_upright, moved
from lesson_code.view.pygame.window import (
    BACKGROUND,
    FADED_INK,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    YELLOW,
    open_window,
    pygame,
)

from ..colours import CONES, LEAST_DIFFERENCE, contrast, difference

CAMERA = Camera(left=-4.0, bottom=1.0, scale=100.0)

LEAST_CONTRAST = 3.0
"""Of a body's colour to the background, as WCAG 2.2 asks of graphics."""


@pytest.fixture
def picture() -> Iterator[Picture]:
    """Return a picture in a headless window."""
    with open_window((1080, 600), "test", headless=True) as window:
        one = Picture(window, CAMERA)
        one.clear()
        yield one


def colour_at(picture: Picture, point: tuple[float, float]) -> tuple[int, ...]:
    """Return the colour of the pixel that shows a point."""
    x, y = picture.camera.world_to_screen(point)
    return tuple(picture.window.surface.get_at((round(x), round(y))))[:3]


def test_camera_y_points_up_and_back_again() -> None:
    """The lower left corner is at the bottom; a place and its point belong together."""
    assert CAMERA.world_to_screen((-4.0, 1.0)) == (0.0, 600.0)
    assert CAMERA.screen_to_world(CAMERA.world_to_screen((1.25, 3.5))) == pytest.approx((1.25, 3.5))


def test_camera_keeps_places_that_can_be_drawn() -> None:
    """A body that flies away stays within what pygame can draw."""
    assert CAMERA.world_to_screen((1e300, -1e300)) == (FAR, FAR)


@pytest.mark.parametrize(
    "shape", [Circle(0.5), Circle(2.0), Polygon.box(1, 1), Segment((-1, 0), (1, 0), 0.2)]
)
def test_body_is_drawn_where_it_is(picture: Picture, shape: Circle | Polygon | Segment) -> None:
    """Its middle has its colour, far from it there is nothing."""
    picture.body(Body(shape, mass=1.0), (0.0, 4.0), 0.3, ORANGE)
    assert colour_at(picture, (0.0, 4.0)) == ORANGE
    assert colour_at(picture, (-3.5, 6.5)) == BACKGROUND


def test_many_lines_at_once_are_each_alone(picture: Picture) -> None:
    """The same pixels, also with y pointing down, and far outside."""
    starts = [(-3.0, 2.0), (0.0, 3.0), (1.0, 4.0)]
    ends = [(3.0, 5.0), (0.5, 3.0), (1e9, 6.0)]
    for camera in (CAMERA, Camera(left=-4.0, bottom=7.0, scale=100.0, up=-1)):
        pixels = []
        for together in (True, False):
            picture.camera = camera
            picture.clear()
            if together:
                picture.lines(starts, ends, ORANGE)
            else:
                for start, end in zip(starts, ends, strict=True):
                    picture.line(start, end, ORANGE)
            pixels.append(pygame.surfarray.array2d(picture.window.surface))
        assert (pixels[0] == pixels[1]).all()


def test_camera_may_have_y_pointing_down() -> None:
    """Its lower edge is then the largest y; places and discs follow."""
    camera = Camera(left=0.0, bottom=500.0, scale=1.0, up=-1)
    assert camera.world_to_screen((10.0, 0.0)) == (10.0, 100.0)
    assert camera.screen_to_world((10.0, 100.0)) == (10.0, 0.0)


@pytest.mark.parametrize("up", [1, -1])
def test_places_of_many_points_are_those_of_each(up: int) -> None:
    """The same formula, to the rounding of one operation; far away both stop at the limit."""
    camera = Camera(left=-4.0, bottom=1.0, scale=87.0, up=up)
    points = [*np.random.default_rng(1).uniform(-9, 9, (100, 2)).tolist(), [1e300, -1e300]]
    one_by_one = [camera.world_to_screen((x, y)) for x, y in points]
    assert camera.places_of(points) == pytest.approx(np.array(one_by_one), rel=1e-12, abs=1e-9)
    assert np.abs(camera.places_of(points)).max() == FAR


@pytest.mark.parametrize("up", [1, -1])
def test_disc_is_drawn_at_its_centre_either_way_up(picture: Picture, up: int) -> None:
    """One by one and many at once."""
    picture.camera = Camera(left=-4.0, bottom=4.0 - 3.0 * up, scale=100.0, up=up)
    picture.disc((1.0, 5.0), 0.2, ORANGE)
    assert colour_at(picture, (1.0, 5.0)) == ORANGE
    assert colour_at(picture, (1.0, 3.0)) == BACKGROUND


def test_upright_rectangle_has_sharp_edges(picture: Picture) -> None:
    """Between two pixels too: no pixel is a mixture, in the whole picture."""
    picture.polygon([(-3.004, 2.003), (1.007, 2.003), (1.007, 4.001), (-3.004, 4.001)], ORANGE)
    pixels = pygame.surfarray.array3d(picture.window.surface)[:800].reshape(-1, 3)
    assert {tuple(pixel) for pixel in np.unique(pixels, axis=0).tolist()} == {ORANGE, BACKGROUND}


@pytest.mark.parametrize(
    "corners",
    [[(0, 0), (2, 1), (0, 2), (-2, 1)], [(0, 0), (2, 0), (2, 1)], [(0, 0), (2, 0), (0, 1), (0, 0)]],
)
def test_other_shapes_are_no_upright_rectangles(corners: list[tuple[float, float]]) -> None:
    """A rhombus, a triangle, a corner that is there twice."""
    assert not is_upright(corners)


def test_nothing_is_drawn_over_the_panel(picture: Picture) -> None:
    """A body at the right edge ends there."""
    picture.disc((4.0, 4.0), 1.0, ORANGE)
    picture.polygon([(3, 3), (6, 3), (6, 5), (3, 5)], ORANGE)
    assert tuple(picture.window.surface.get_at((810, 300)))[:3] == (0, 0, 0)


def test_moved_turns_and_shifts() -> None:
    """A quarter turn takes x to y."""
    assert moved((2.0, 0.0), (1.0, 1.0), 1.5707963267948966) == pytest.approx((1.0, 3.0))


def test_colours_stand_out_from_the_background() -> None:
    """Each of them has three times its luminance, and no two are alike."""
    assert len(set(COLOURS)) == len(COLOURS)
    for colour in COLOURS:
        assert contrast(colour, BACKGROUND) >= LEAST_CONTRAST


GROUPS = {
    "bodies": [*COLOURS, BACKGROUND],
    "dominoes": [SKY, ORANGE, GREEN, WALL, BACKGROUND],
    "ship and light rocks": [YELLOW, rock_colour(2.0)],
    "ship and rocks": [YELLOW, rock_colour(13.0)],
    "ship and heavy rocks": [YELLOW, rock_colour(26.0)],
    **{f"ball {k} on the cloth": [ball_colour(k), CLOTH] for k in range(8)},
    "bumper on the cloth": [PURPLE, TABLE_CLOTH, INK],
    "plan": [SKY, ORANGE, FADED_INK, BACKGROUND],
}
"""Colours that have to be told apart."""


@pytest.mark.parametrize("cones", CONES)
@pytest.mark.parametrize("group", GROUPS)
def test_colours_are_told_apart_by_the_colour_blind(group: str, cones: str) -> None:
    """Any two that stand side by side; numbers, words or shapes say the same once more."""
    for a, b in combinations(GROUPS[group], 2):
        assert difference(a, b, cones) >= LEAST_DIFFERENCE, (a, b)
