"""The page of a plan: everything stands in the field, and nothing over something else."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from lesson_code.chapters.simulator.game import FORCED, Simulator
from lesson_code.chapters.simulator.plan_page import draw_plan
from lesson_code.engine.core.plan import EffectChoice, Plan
from lesson_code.engine.effects.choice import EFFECTS
from lesson_code.view.pygame.picture import FIELD_SIZE
from lesson_code.view.pygame.window import Window, open_window, pygame


@pytest.fixture
def window() -> Iterator[Window]:
    """Return an open headless window."""
    with open_window((1080, 600), "test", headless=True) as opened:
        yield opened


def written(window: Window, plan: Plan, monkeypatch: pytest.MonkeyPatch) -> dict[str, pygame.Rect]:
    """Return what a page holds, and where."""
    boxes: dict[str, pygame.Rect] = {}
    real_text = Window.text

    def noted(self: Window, words: str, place: Any, **kwargs: Any) -> pygame.Rect:
        boxes[f"{words} {place}"] = real_text(self, words, place, **kwargs)
        return boxes[f"{words} {place}"]

    monkeypatch.setattr(Window, "text", noted)
    draw_plan(window, plan, "Plan for the scene as it was at 1234.5 s (F closes it)", FORCED)
    return boxes


def assert_readable(boxes: dict[str, pygame.Rect]) -> None:
    """All stand in the field and apart."""
    field, places = pygame.Rect((0, 0), FIELD_SIZE), list(boxes.values())
    assert all(field.contains(box) for box in places)
    for k, box in enumerate(places):
        assert box.inflate(6, 0).collidelist(places[:k]) == -1


@pytest.mark.parametrize("keys", ["", "g", "g2", "3", "c", "bbb", "gbb3"])
def test_page_of_the_simulator_is_readable(
    window: Window, monkeypatch: pytest.MonkeyPatch, keys: str
) -> None:
    """In all modes, with and without gravity, with no ball and with many."""
    game = Simulator(0)
    for key in (*keys, "f"):
        game.press(key)
    assert game.plan is not None
    boxes = written(window, game.plan[1], monkeypatch)
    assert_readable(boxes)
    assert len(boxes) >= 2 + 3 * len(EFFECTS)


def test_long_reasons_are_wrapped(window: Window, monkeypatch: pytest.MonkeyPatch) -> None:
    """No word is lost; there is room for three reasons that take two lines."""
    long = "a reason that goes on for so many words that it takes more than one line of the page"
    reasons = [long if k % 6 == 1 else "short" for k in range(len(EFFECTS))]
    effects = [
        EffectChoice(name, True, True, words) for name, words in zip(EFFECTS, reasons, strict=True)
    ]
    plan = Plan("sequential", "a test", effects=tuple(effects))
    boxes = written(window, plan, monkeypatch)
    assert_readable(boxes)
    assert " ".join(key.rsplit(" (", 1)[0] for key in boxes).count(long) == reasons.count(long)


def test_wrapped_lines_hold_all_words_and_are_no_wider(window: Window) -> None:
    """A word that is too long alone has a line of its own."""
    words = "each of these words and one-that-is-very-much-longer-than-all-the-others too"
    lines = window.wrapped(words, 120.0)
    assert " ".join(lines) == words
    for line in lines:
        assert " " not in line or pygame.font.Font(None, 22).size(line)[0] <= 120
    assert window.wrapped("", 120.0) == []
