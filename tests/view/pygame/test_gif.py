"""Films: how many pictures, how long each is seen, and whether they show what was seen."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from lesson_code.view.pygame import gif
from lesson_code.view.pygame.gif import MOST_PICTURES, PICTURES_PER_SECOND, Gif
from lesson_code.view.pygame.window import ORANGE, SKY, pygame

SIZE = (60, 40)
PICTURE = 1 / PICTURES_PER_SECOND
MILLISECONDS = 1000 // PICTURES_PER_SECOND


def surface(step: int = 0) -> pygame.Surface:
    """Return a picture of a square that moves."""
    one = pygame.Surface(SIZE)
    one.fill(SKY)
    one.fill(ORANGE, (step % 40, 10, 12, 12))
    return one


def film(path: Path, times: list[float], steps: list[int] | None = None) -> Gif:
    """Write a film of pictures with these times between them, s."""
    with closing(Gif(path, SIZE)) as one:
        for k, elapsed in enumerate(times):
            one.see(surface(k if steps is None else steps[k]), elapsed)
    return one


def durations(path: Path) -> list[int]:
    """Return how long each picture of a file is seen, ms."""
    with Image.open(path) as image:
        told = []
        for k in range(image.n_frames):  # type: ignore[attr-defined]
            image.seek(k)
            told.append(image.info["duration"])
        return told


def pictures(path: Path) -> list[np.ndarray]:
    """Return all pictures of a file, as a viewer shows them."""
    with Image.open(path) as image:
        shown = []
        for k in range(image.n_frames):  # type: ignore[attr-defined]
            image.seek(k)
            shown.append(np.asarray(image.convert("RGB")))
        return shown


def test_film_has_a_picture_for_each_twentieth_of_a_second(tmp_path: Path) -> None:
    """The first at once; each is seen for 50 ms."""
    path = tmp_path / "film.gif"
    one = film(path, [0.0] + 10 * [PICTURE])
    assert durations(path) == 11 * [MILLISECONDS]
    assert (one.pictures, one.seconds) == (11, pytest.approx(0.55))


def test_film_of_sixty_frames_a_second_takes_each_third(tmp_path: Path) -> None:
    """At 1/60 s a second has twenty pictures, and those are the frames 0, 3, 6, ..."""
    path = tmp_path / "film.gif"
    film(path, [0.0] + 60 * [1 / 60])
    first = [int(np.argmax((p == ORANGE).all(axis=2)[15])) for p in pictures(path)]
    assert first == [3 * k % 40 for k in range(21)]


def test_picture_that_stays_is_written_once_and_seen_for_longer(tmp_path: Path) -> None:
    """What does not change costs nothing."""
    path = tmp_path / "film.gif"
    film(path, [0.0] + 3 * [PICTURE], steps=[0, 5, 5, 9])
    assert durations(path) == [MILLISECONDS, 2 * MILLISECONDS, MILLISECONDS]


def test_slow_frame_holds_the_picture_before_it(tmp_path: Path) -> None:
    """A frame of 0.2 s leaves the last picture on the screen for so long, as it was in fact."""
    path = tmp_path / "film.gif"
    film(path, [0.0, PICTURE, 4 * PICTURE])
    assert durations(path) == [MILLISECONDS, 4 * MILLISECONDS, MILLISECONDS]


def test_pictures_show_what_was_seen(tmp_path: Path) -> None:
    """Few colours come through as they are, also where only a part of a picture is written."""
    path = tmp_path / "film.gif"
    film(path, [0.0] + 5 * [PICTURE])
    for k, shown in enumerate(pictures(path)):
        expected = pygame.surfarray.array3d(surface(k)).swapaxes(0, 1)
        assert (shown == expected).all()


def test_picture_of_many_colours_is_near_to_what_was_seen(tmp_path: Path) -> None:
    """Of 2,400 colours 255 are left: on average no pixel is off by more than four levels."""
    path = tmp_path / "film.gif"
    wheel = np.indices(SIZE).sum(axis=0)[..., None] * np.array([2.5, 1.0, 0.5])
    wheel[..., 2] += np.arange(SIZE[1]) * 3
    seen = pygame.surfarray.make_surface(wheel.astype(np.uint8))
    with closing(Gif(path, SIZE)) as one:
        one.see(seen, 0.0)
    [shown] = pictures(path)
    off = np.abs(shown.astype(int) - pygame.surfarray.array3d(seen).swapaxes(0, 1))
    assert 0.0 < off.mean() <= 4.0


def test_film_is_scaled_to_its_size(tmp_path: Path) -> None:
    """A larger window makes no larger film."""
    path = tmp_path / "film.gif"
    with closing(Gif(path, SIZE)) as one:
        one.see(pygame.Surface((300, 200)), 0.0)
    with Image.open(path) as image:
        assert image.size == SIZE


def test_film_that_is_full_takes_no_more(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """At the limit it ends, also in the midst of a slow frame; half a minute is the limit."""
    assert MOST_PICTURES / PICTURES_PER_SECOND == 30
    monkeypatch.setattr(gif, "MOST_PICTURES", 4)
    path = tmp_path / "film.gif"
    one = film(path, [0.0, PICTURE, 20 * PICTURE, PICTURE])
    assert one.is_full
    assert sum(durations(path)) == 4 * MILLISECONDS


def test_film_of_a_run_that_failed_can_be_seen(tmp_path: Path) -> None:
    """Whatever ends the run, the file is finished."""
    path = tmp_path / "film.gif"

    def fail() -> None:
        with closing(Gif(path, SIZE)) as one:
            one.see(surface(), 0.0)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert len(pictures(path)) == 1


def test_film_plays_for_ever(tmp_path: Path) -> None:
    """A viewer begins again after the last picture."""
    path = tmp_path / "film.gif"
    film(path, [0.0, PICTURE])
    with Image.open(path) as image:
        assert image.info["loop"] == 0
