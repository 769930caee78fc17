"""How long figures take to answer: what is counted. The times themselves are no test."""

from __future__ import annotations

import pytest

from lesson_code.view.browser.answer_times import Answer, Answers, measure_answers
from lesson_code.view.browser.chromium import NoBrowserError


def test_every_move_of_a_figure_is_timed() -> None:
    """Five moves with each of its points and sliders; moves within one frame count once."""
    try:
        [found] = measure_answers(["ch03_reflection/mirror"], moves=5).answers
    except NoBrowserError as error:
        pytest.skip(str(error))
    assert found.figure == "ch03_reflection/mirror"
    assert 5 <= found.moves <= 50
    assert 0 < found.median_ms <= found.most_ms
    assert found.way_ms > 0
    assert 0 < found.cpu_ms <= found.most_cpu_ms


def test_figure_that_does_not_exist_is_named() -> None:
    """Before Chromium starts."""
    with pytest.raises(ValueError, match=r"begin a figure's name, such as ch03, got .'ch99'"):
        measure_answers(["ch99"])


def test_table_says_which_figure_is_too_slow() -> None:
    """By its 95th percentile."""
    quick, slow = Answer("a", 9, 4.0, 15.9, 9.0, 2.0, 3.0), Answer("b", 9, 4.0, 16.1, 9.0, 2.0, 3.0)
    rows = Answers(16.0, (quick, slow)).as_text().splitlines()
    assert "yes" in next(row for row in rows if row.strip().startswith("a"))
    assert "NO" in next(row for row in rows if row.strip().startswith("b"))
