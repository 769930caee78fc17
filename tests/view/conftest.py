"""What the tests of figures share: a look at where the texts of a drawn figure stand."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

TOUCH = 1.0
"""px by which the boxes of two texts may run into each other: no letter fills its box."""


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
