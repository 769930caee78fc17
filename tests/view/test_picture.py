"""The picture: metres to pixels and back, and what is drawn where."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from lesson_code import Body, Circle, Polygon, Segment
from lesson_code.view.picture import COLOURS, FAR, Camera, Picture, moved
from lesson_code.view.pygame_view import BACKGROUND, ORANGE, open_window

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


def contrast(a: tuple[int, int, int], b: tuple[int, int, int]) -> float:
    """Return the contrast ratio of two colours, 1 to 21."""
    light, dark = sorted((luminance(a), luminance(b)), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def luminance(colour: tuple[int, int, int]) -> float:
    """Return the relative luminance of a colour, 0 to 1."""
    parts = [c / 255 for c in colour]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
