"""Effects one sees: how long they last, and that they are bounded."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from lesson_code.engine.core.callbacks import Touch
from lesson_code.view.pygame.effects import (
    FLASH_SECONDS,
    MOST_SPARKS,
    SPARK_SECONDS,
    TRAIL_STEPS,
    Flashes,
    Sparks,
    Trails,
)
from lesson_code.view.pygame.picture import FLASH, Camera, Picture
from lesson_code.view.pygame.window import SKY, Window, open_window, pygame


@pytest.fixture
def window() -> Iterator[Window]:
    """Return an open headless window."""
    with open_window((1080, 600), "test", headless=True) as opened:
        yield opened


def touch(impulse: float) -> Touch:
    """Return a touch of bodies 1 and 2 with an impulse."""
    return Touch(0.0, 1, 2, (0.0, 1.0), ((4.0, 3.0),), 0.01, 1.0, 0.0, False, impulse, 0.0)


def test_flash_is_white_at_first_and_then_over() -> None:
    """Both bodies light up, fade, and have their own colour again."""
    flashes = Flashes()
    flashes.hit(touch(1.0))
    assert [flashes.colour(number, SKY) for number in (1, 2, 3)] == [FLASH, FLASH, SKY]
    flashes.step(0.6 * FLASH_SECONDS)
    assert FLASH != flashes.colour(1, SKY) != SKY
    flashes.step(0.6 * FLASH_SECONDS)
    assert flashes.colour(1, SKY) == SKY


def test_soft_impacts_make_no_flash_and_no_sparks() -> None:
    """What is below the least impulse is not shown."""
    flashes, sparks = Flashes(least_impulse=2.0), Sparks(least_impulse=2.0)
    for effect in (flashes, sparks):
        effect.hit(touch(1.9))
    assert (len(flashes.lit), len(sparks.sparks)) == (0, 0)


def test_sparks_fly_from_the_point_and_go_out() -> None:
    """They begin where the bodies touch; after their time none is left."""
    sparks = Sparks()
    sparks.hit(touch(1.0))
    assert {(spark.x, spark.y) for spark in sparks.sparks} == {(4.0, 3.0)}
    for _ in range(60):
        sparks.step(SPARK_SECONDS / 50)
    assert len(sparks.sparks) == 0


def test_sparks_are_bounded() -> None:
    """A thousand impacts at once cost no more than thirty."""
    sparks = Sparks()
    for _ in range(1000):
        sparks.hit(touch(1.0))
    assert len(sparks.sparks) == MOST_SPARKS


def test_sparks_are_the_same_in_each_run() -> None:
    """They are drawn by lot from a seed of their own."""
    runs = [Sparks(), Sparks()]
    for one in runs:
        one.hit(touch(1.0))
    assert runs[0].sparks == runs[1].sparks


def test_trail_keeps_the_last_places_of_those_that_are_named() -> None:
    """It is as long as half a second, and ends when its body does."""
    trails = Trails()
    for k in range(100):
        trails.step({1: (float(k), 0.0), 2: (0.0, 0.0)})
    assert len(trails.places[1]) == TRAIL_STEPS
    assert trails.places[1][-1] == (99.0, 0.0)
    trails.step({2: (0.0, 0.0)})
    assert list(trails.places) == [2]


def test_effects_are_drawn(window: Window) -> None:
    """Sparks and trails leave their marks in the field."""
    picture = Picture(window, Camera(0.0, 0.0, 100.0))
    sparks, trails = Sparks(), Trails()
    sparks.hit(touch(1.0))
    for k in range(10):
        trails.step({1: (0.2 * k, 1.0)})
    for draw in (lambda: sparks.draw(picture), lambda: trails.draw(picture, SKY)):
        picture.clear()
        before = pygame.surfarray.array2d(window.surface)
        draw()
        assert (pygame.surfarray.array2d(window.surface) != before).any()


def test_trail_stays_while_nothing_moves() -> None:
    """A picture that is drawn again while the game is paused keeps its trails."""
    trails = Trails()
    for k in range(5):
        trails.step({1: (0.1 * k, 0.0)})
    before = list(trails.places[1])
    for _ in range(100):
        trails.step({1: before[-1]})
    assert list(trails.places[1]) == before
