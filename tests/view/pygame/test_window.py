"""The pygame window that the programs share: drivers, installations, drawing, PNG."""

from __future__ import annotations

import importlib.metadata
import math
import os
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest

from lesson_code.view.pygame.window import (
    BACKGROUND,
    BLUE,
    GREEN,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    VERMILION,
    YELLOW,
    Colour,
    Window,
    blend,
    draw_capsule,
    open_window,
    pygame,
    pygame_distributions,
    smooth_disc,
    warn_if_both_installed,
)

from ..colours import contrast

LEAST_CONTRAST = 3.0
"""Of what is drawn to what it is drawn on, as WCAG 2.2 asks of graphics."""


@pytest.fixture
def window(monkeypatch: pytest.MonkeyPatch) -> Iterator[Window]:
    """Return an open headless window of 200 x 100 px."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    with open_window((200, 100), "test", headless=True) as opened:
        yield opened


def run_python(program: str, **environment: str | None) -> subprocess.CompletedProcess[str]:
    """Run a program in a fresh Python; a None takes a variable out of the environment."""
    variables = {**os.environ, **environment}
    return subprocess.run(
        [sys.executable, "-W", "ignore", "-c", program],
        env={name: value for name, value in variables.items() if value is not None},
        capture_output=True,
        text=True,
        check=False,
    )


def pretend_installed(monkeypatch: pytest.MonkeyPatch, found: dict[str, str]) -> None:
    """Make these distributions, and no other pygame, look installed."""

    def version(name: str) -> str:
        if name not in found:
            raise importlib.metadata.PackageNotFoundError(name)
        return found[name]

    monkeypatch.setattr(importlib.metadata, "version", version)


# Opening


def test_open_window_headless_leaves_the_environment_as_it_was(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The dummy drivers hold for the block only: a window can be opened afterwards."""
    monkeypatch.delenv("SDL_VIDEODRIVER", raising=False)
    monkeypatch.setenv("SDL_AUDIODRIVER", "disk")
    with open_window((20, 10), "test", headless=True):
        assert os.environ["SDL_VIDEODRIVER"] == os.environ["SDL_AUDIODRIVER"] == "dummy"
        assert pygame.display.get_driver() == "dummy"
    assert "SDL_VIDEODRIVER" not in os.environ
    assert os.environ["SDL_AUDIODRIVER"] == "disk"
    assert not pygame.display.get_init()


def test_open_window_error_inside_closes_it(monkeypatch: pytest.MonkeyPatch) -> None:
    """An error in the program closes the window, and comes through."""
    monkeypatch.delenv("SDL_VIDEODRIVER", raising=False)
    with pytest.raises(KeyError), open_window((20, 10), "test", headless=True):
        raise KeyError
    assert not pygame.display.get_init()
    assert "SDL_VIDEODRIVER" not in os.environ


def test_open_window_unknown_driver_says_there_is_no_screen() -> None:
    """Where SDL finds no screen the error says what to do instead."""
    program = (
        "from lesson_code.view.pygame.window import open_window\n"
        "with open_window((20, 10), 'test'): pass"
    )
    result = run_python(program, SDL_VIDEODRIVER="no_such_driver")
    assert "RuntimeError: no screen to open a window on; run the program headless" in result.stderr


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there always is a screen")
def test_open_window_without_display_does_not_draw_unseen() -> None:
    """SDL falls back on an invisible screen; a program nobody can close must not start on it."""
    program = (
        "from lesson_code.view.pygame.window import open_window\n"
        "with open_window((20, 10), 'test'): pass"
    )
    unset = dict.fromkeys(("SDL_VIDEODRIVER", "DISPLAY", "WAYLAND_DISPLAY"))
    result = run_python(program, **unset)
    if result.returncode == 0:
        pytest.skip("this machine has a screen without X11 or Wayland")
    assert "RuntimeError: no screen to open a window on" in result.stderr


def test_import_prints_nothing() -> None:
    """Pygame's greeting would spoil a program's JSON."""
    result = run_python("import lesson_code.view.pygame.window", PYGAME_HIDE_SUPPORT_PROMPT=None)
    assert (result.returncode, result.stdout) == (0, "")


# Which pygame


def test_import_without_pygame_says_what_to_install() -> None:
    """Without any pygame the error names the package to install."""
    program = "import sys; sys.modules['pygame'] = None; import lesson_code.view.pygame.window"
    result = run_python(program)
    assert "pygame, which is not installed: pip install pygame-ce" in result.stderr


def test_import_of_an_empty_pygame_says_how_to_repair(tmp_path: Path) -> None:
    """Removing pygame from beside pygame-ce leaves an empty folder, which imports all the same."""
    (tmp_path / "pygame").mkdir()
    (tmp_path / "pygame" / "__init__.py").touch()
    program = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r}); import lesson_code.view.pygame.window"
    )
    assert "empty: pip install --force-reinstall pygame-ce" in run_python(program).stderr


def test_both_installed_warns(monkeypatch: pytest.MonkeyPatch) -> None:
    """Pygame and pygame-ce overwrite each other; the warning names both."""
    pretend_installed(monkeypatch, {"pygame": "2.6.1", "pygame-ce": "2.5.8"})
    with pytest.warns(RuntimeWarning, match=r"pygame 2\.6\.1 and pygame-ce 2\.5\.8 are both"):
        warn_if_both_installed()


@pytest.mark.parametrize("found", [{"pygame": "2.6.1"}, {"pygame-ce": "2.5.8"}, {}])
def test_one_installed_is_silent(monkeypatch: pytest.MonkeyPatch, found: dict[str, str]) -> None:
    """One of the two is what we want; which one does not matter."""
    pretend_installed(monkeypatch, found)
    assert pygame_distributions() == found
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warn_if_both_installed()


# Drawing


def test_palette_is_okabe_and_itos() -> None:
    """The colours are the seven of the Color Universal Design palette."""
    palette = (ORANGE, SKY, GREEN, YELLOW, BLUE, VERMILION, PURPLE)
    written = [bytes(colour).hex() for colour in palette]
    assert written == ["e69f00", "56b4e9", "009e73", "f0e442", "0072b2", "d55e00", "cc79a7"]


def test_text_lies_where_its_anchor_says(window: Window) -> None:
    """The named point of the text's rectangle is the place that was given."""
    assert window.text("hello", (10, 20)).topleft == (10, 20)
    assert window.text("hello", (100, 50), anchor="midright", size=30).midright == (100, 50)


def test_arrow_points_from_tail_to_tip(window: Window) -> None:
    """The arrow's pixels reach from its tail to its tip, and its head is wider than its shaft."""
    window.arrow((20, 50), (100, 0), INK, width=4 / window.unit)
    painted = pygame.mask.from_threshold(window.surface, INK, (9, 9, 9, 255)).get_bounding_rects()
    assert len(painted) == 1
    assert painted[0].left == pytest.approx(20, abs=1)
    assert painted[0].right == pytest.approx(120, abs=2)
    assert painted[0].height >= 14


@pytest.mark.parametrize("ground", [(255, 255, 255), INK, YELLOW, SKY, ORANGE, BLUE, BACKGROUND])
@pytest.mark.parametrize("colour", [INK, YELLOW, SKY, ORANGE, BLUE])
def test_arrow_stands_out_from_whatever_it_is_drawn_on(
    window: Window, ground: Colour, colour: Colour
) -> None:
    """Shaft or rim has three times the ground's luminance or a third, and so has rim to shaft."""
    window.surface.fill(ground)
    window.arrow((20, 50), (100, 0), colour, width=4 / window.unit)
    across = [tuple(window.surface.get_at((60, y)))[:3] for y in range(40, 60)]
    assert colour in across
    assert max(contrast(one, ground) for one in across) >= LEAST_CONTRAST
    assert contrast(colour, BACKGROUND) >= LEAST_CONTRAST


def test_arrow_of_no_length_draws_nothing(window: Window) -> None:
    """A velocity of zero has no direction and no arrow."""
    window.arrow((20, 50), (0, 0), INK)
    assert pygame.mask.from_threshold(window.surface, INK, (9, 9, 9, 255)).count() == 0


def test_capsule_covers_its_area(window: Window) -> None:
    """A capsule's area is that of a rectangle and a disc: 2 h L + pi h^2."""
    draw_capsule(window.surface, (50, 50), (130, 50), 20, INK)
    count = pygame.mask.from_threshold(window.surface, INK, (1, 1, 1, 255)).count()
    assert count == pytest.approx(2 * 20 * 80 + math.pi * 400, rel=0.03)


def test_smooth_disc_covers_its_area() -> None:
    """The disc's opacity adds up to its area, and its corners are clear."""
    disc = smooth_disc(12, INK)
    side = disc.get_width()
    alpha = sum(disc.get_at((x, y)).a for x in range(side) for y in range(side)) / 255
    assert alpha == pytest.approx(math.pi * 144, rel=0.02)
    assert disc.get_at((0, 0)).a == 0


def test_blend_ends_are_the_colours() -> None:
    """Part 0 is the first colour, part 1 the other."""
    assert (blend(INK, BLUE, 0), blend(INK, BLUE, 1)) == (INK, BLUE)


def test_wait_measures_seconds(window: Window) -> None:
    """The frame's time is in seconds: at 60 frames/s far less than one."""
    window.wait()
    assert 0 < window.wait() < 1


def test_save_writes_the_picture(window: Window, tmp_path: Path) -> None:
    """What was drawn comes back from the PNG."""
    window.surface.fill(BLUE)
    window.show()
    window.save(tmp_path / "blue.png")
    assert tuple(pygame.image.load(tmp_path / "blue.png").get_at((5, 5)))[:3] == BLUE


def test_save_other_formats_are_refused(window: Window, tmp_path: Path) -> None:
    """Only PNG keeps the pixels as they are."""
    with pytest.raises(ValueError, match=r"path must end in \.png, got '.*blue\.jpg'"):
        window.save(tmp_path / "blue.jpg")
