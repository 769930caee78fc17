"""What tests share: the tier, compiled programs, texts of a figure, windows without a screen."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from itertools import combinations
from typing import Any

import numpy as np
import pytest
import tiers
from hypothesis import settings
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from lesson_code import Run, Scene
from lesson_code.engine.compiled.library import FOLDER_VARIABLE
from lesson_code.engine.core.impulse_table import EVENT_NUMBERS, ImpulseTable
from lesson_code.engine.core.plan import Plan
from lesson_code.view.pygame.panel import PROGRAM_SIZE
from lesson_code.view.pygame.window import Window, open_window, pygame


def load_examples() -> None:
    """Draw the same examples on every run and every machine: a red test is red for everybody."""
    settings.register_profile(
        "repeatable",
        derandomize=True,
        deadline=None,
        print_blob=True,
        max_examples=tiers.share(100),
    )
    settings.load_profile("repeatable")


TOUCH = 1.0
"""px by which the boxes of two texts may run into each other: no letter fills its box."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the word that asks for the full tier."""
    parser.addoption("--full", action="store_true", help="run the full tier (see tests/tiers.py)")


def pytest_configure(config: pytest.Config) -> None:
    """Choose the tier; keep compiled programs from run to run, for all processes of a run."""
    tiers.choose(full=config.getoption("--full", default=False))
    load_examples()
    os.environ.setdefault(FOLDER_VARIABLE, str(config.rootpath / ".pytest_cache" / "programs"))
    # Files keep their order. Doctests and notebooks come last: they are short, and no worker waits.
    config.option.loadscopereorder = False


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave to the full tier what is its own."""
    left_out = set(tiers.left_out(items))
    if left_out:
        config.hook.pytest_deselected(items=list(left_out))
        items[:] = [item for item in items if item not in left_out]


@pytest.fixture
def texts_of(monkeypatch: pytest.MonkeyPatch) -> Callable[[Figure], dict[Text, Bbox]]:
    """Return a function that draws a figure and returns its texts and the boxes they fill, px."""

    def look(figure: Figure) -> dict[Text, Bbox]:
        drawn: list[Text] = []
        draw = Text.draw

        def remember(text: Text, renderer: object) -> None:
            if text.get_visible() and text.get_text().strip():
                drawn.append(text)
            draw(text, renderer)

        canvas = FigureCanvasAgg(figure)
        canvas.draw()  # the first time, the layout finds its room
        with monkeypatch.context() as patch:
            patch.setattr(Text, "draw", remember)
            canvas.draw()
        return {text: Text.get_window_extent(text, canvas.get_renderer()) for text in drawn}

    return look


@pytest.fixture
def assert_texts_are_clear(
    texts_of: Callable[[Figure], dict[Text, Bbox]],
) -> Callable[[Figure], None]:
    """Return a function that fails if a text is cut off by the figure or overlaps another one."""

    def look(figure: Figure) -> None:
        boxes = texts_of(figure)
        page = figure.bbox.padded(TOUCH)
        cut = [text.get_text() for text, box in boxes.items() if not inside(box, page)]
        overlapping = [
            (a.get_text(), b.get_text())
            for (a, box_a), (b, box_b) in combinations(boxes.items(), 2)
            if box_a.padded(-TOUCH).overlaps(box_b)
        ]
        assert boxes, "nothing is written"
        assert (cut, overlapping) == ([], [])

    return look


def inside(box: Bbox, page: Bbox) -> bool:
    """Return whether a box lies on a page."""
    return bool(page.x0 <= box.x0 and box.x1 <= page.x1 and page.y0 <= box.y0 and box.y1 <= page.y1)


def run_made_by_hand(
    scene: Scene,
    times: Any,
    positions: Any,
    *,
    angles: Any = None,
    velocities: Any = None,
    spins: Any = None,
    contacts: Any = (),
) -> Run:
    """Return a run that nobody simulated.

    A contact is (time, body a, body b, point, normal, normal impulse, tangent impulse).
    """
    shape = (len(times), len(scene.bodies))
    table = [(t, a, b, *point, *normal, jn, jt) for t, a, b, point, normal, jn, jt in contacts]
    impulses = ImpulseTable()
    impulses.add(np.array([(*row, 0.01) for row in table]).reshape(-1, EVENT_NUMBERS))
    return Run(
        scene=scene,
        times=np.array(times, dtype=float),
        positions=np.array(positions, dtype=float).reshape(*shape, 2),
        velocities=np.zeros((*shape, 2)) if velocities is None else np.array(velocities, float),
        angles=np.zeros(shape) if angles is None else np.array(angles, dtype=float),
        angular_velocities=np.zeros(shape) if spins is None else np.array(spins, dtype=float),
        impulses=impulses,
        plan=Plan("by hand", "a test"),
    )


@pytest.fixture
def run_of() -> Callable[..., Run]:
    """Return what makes a run from the states and impulses that a test names."""
    return run_made_by_hand


@pytest.fixture(autouse=True)
def _no_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run on SDL's dummy drivers."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")


@pytest.fixture
def program_window() -> Iterator[Window]:
    """Return an open headless window of the size that programs have."""
    with open_window(PROGRAM_SIZE, "test", headless=True) as opened:
        yield opened


@pytest.fixture
def text_boxes(monkeypatch: pytest.MonkeyPatch) -> list[pygame.Rect]:
    """Return where each text stands that is drawn in a window from now on, px."""
    boxes: list[pygame.Rect] = []
    real_text = Window.text

    def noted(self: Window, words: str, *args: Any, **kwargs: Any) -> pygame.Rect:
        boxes.append(real_text(self, words, *args, **kwargs))
        return boxes[-1]

    monkeypatch.setattr(Window, "text", noted)
    return boxes
